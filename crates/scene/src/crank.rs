//! `[crank]`: the slider crank of the big end, its masses and the pressure on its piston.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;
use crate::{CrankBearing, LoadCycle, LoadSource};

keys! {
    "crank" = Table; "", "the shell is at rest", "with a load over a cycle",
        "the crank whose rod holds the bearing, so that its shell turns with the rod, or whose main bearing it is. It turns with the speed of the journal";
    "crank.radius" = Quantity(Length); "62.5 mm", "required", "> 0, < `rod_length`",
        "radius of the crank, half the stroke";
    "crank.rod_length" = Quantity(Length); "230 mm", "required", "> 0",
        "length of the rod between its eyes";
    "crank.reciprocating_mass" = Quantity(Mass); "3.43 kg", "required with `load.bearing`", ">= 0",
        "mass of the piston with ring and pin, and of the rod's share at its small end";
    "crank.rotating_mass" = Quantity(Mass); "2.025 kg", "required with `load.bearing`", ">= 0",
        "mass of the rod's share at its big end, the cap included";
    "crank.bore" = Quantity(Length); "125 mm", "required with `load.bearing`", "> 0",
        "diameter of the cylinder";
    "crank.gas" = Table; "", "required with `load.bearing`", "",
        "pressure on the piston, over that of the crankcase: a table, or one smooth peak p = peak exp(sharpness (cos(2 pi (theta - angle)/period) - 1))";
    "crank.gas.file" = Text; "loads/gas.csv", "see `peak`", "a table with units in its header: `angle [deg], p [bar]`",
        "path of a table of the pressure by crank angle, counted from the folder of the scene";
    "crank.gas.peak" = Quantity(Pressure); "8 MPa", "required without `file`", ">= 0",
        "greatest pressure";
    "crank.gas.angle" = Quantity(Angle); "12 deg", "required without `file`", "",
        "crank angle of the greatest pressure, 0 where the piston is farthest from the crank";
    "crank.gas.sharpness" = Number; "14", "required without `file`", "> 0",
        "how narrow the peak is; with a period of 720 deg, 14 makes it 72 deg wide at half its height";
    "crank.throws" = Tables; "", "required with `bearing = \"main\"`", "",
        "the throws beside the main bearing, cut at their main bearings; each has the same crank, masses and gas pressure";
    "crank.throws.angle" = Quantity(Angle); "360 deg", "0", "",
        "crank angle by which the throw and its gas pressure follow the crank angle of the load";
    "crank.throws.share" = Number; "0.5", "required", "above 0, at most 1",
        "share of the load of the throw that this bearing takes: the distance of its pin from the other main bearing over that of both";
    "crank.throws.web_mass" = Quantity(Mass); "1.5 kg", "0", "any",
        "unbalance of the webs over the radius of the crank; that of counterweights counts as negative";
}

/// The slider crank of a big end or a main bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankTable {
    /// Radius of the crank [m].
    pub radius: f64,
    /// Length of the rod between its eyes [m].
    pub rod_length: f64,
    /// What loads it; `None`: the load is given.
    pub drive: Option<CrankDrive>,
}

/// Masses of a crank and the pressure on its piston.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankDrive {
    /// Mass of the piston with what belongs to it, and of the rod at its small end [kg].
    pub reciprocating_mass: f64,
    /// Mass of the rod at its big end [kg].
    pub rotating_mass: f64,
    /// Diameter of the cylinder [m].
    pub bore: f64,
    /// Pressure on the piston.
    pub gas: Gas,
    /// The throws beside a main bearing; none for a big end.
    pub throws: Vec<ThrowTable>,
}

/// A throw beside a main bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrowTable {
    /// Crank angle by which it follows [rad].
    pub angle: f64,
    /// Share of its load that the bearing takes [1].
    pub share: f64,
    /// Unbalance of its webs over the radius of the crank [kg].
    pub web_mass: f64,
}

/// Pressure on a piston over that of the crankcase.
#[derive(Debug, Clone, PartialEq)]
pub enum Gas {
    /// A table in this file.
    File(PathBuf),
    /// One smooth peak in a period.
    Peak {
        /// Greatest pressure [Pa].
        peak: f64,
        /// Crank angle of the peak [rad].
        angle: f64,
        /// How narrow it is [1].
        sharpness: f64,
    },
}

impl CrankTable {
    /// The file of the gas pressure, if there is one.
    pub fn gas_file(&self) -> Option<&Path> {
        match self.drive.as_ref().map(|drive| &drive.gas) {
            Some(Gas::File(path)) => Some(path),
            _ => None,
        }
    }
}

/// Keys of what loads a crank.
const DRIVE: [&str; 5] = ["reciprocating_mass", "rotating_mass", "bore", "gas", "throws"];

/// Reads the table of a scene that stands at `scene` and has this load.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path, load: Option<&LoadCycle>) -> CrankTable {
    let radius = table.required("radius");
    let rod_length = table.required("rod_length");
    table.refuse_if(
        radius >= rod_length,
        "radius",
        "is not less than rod_length, so the crank could not turn",
        "give half the stroke as radius, and the distance of the rod's eyes as rod_length",
    );
    let mut mass = |key| {
        let mass = table.number(key);
        let mass = mass.within("is negative", "give a mass, or zero");
        mass.given().unwrap_or(f64::NAN)
    };
    let reciprocating_mass = mass("reciprocating_mass");
    let rotating_mass = mass("rotating_mass");
    let bore = table.given("bore");
    let gas = table.table_if_given("gas").map(|table| gas(table, scene));
    let throws: Vec<ThrowTable> = table.tables("throws").into_iter().map(throw).collect();
    let computed = load.and_then(|load| match load.source {
        LoadSource::Crank(bearing) => Some(bearing),
        _ => None,
    });
    if let Some(bearing) = computed {
        check_throws(&mut table, bearing, &throws);
        table.require("reciprocating_mass");
        table.require("rotating_mass");
        table.require("bore");
        table.require_as("gas", "{ peak = \"8 MPa\", angle = \"12 deg\", sharpness = 14 }");
    } else if load.is_some() {
        for key in DRIVE.into_iter().filter(|key| table.has(key)) {
            let help = format!("remove {key}, or give load.bearing = \"big-end\" in place of the load");
            table.complain(key, "has no effect, since the load is given", help);
        }
    }
    let drive = gas.filter(|_| computed.is_some()).map(|gas| CrankDrive {
        reciprocating_mass,
        rotating_mass,
        bore: bore.unwrap_or(f64::NAN),
        gas,
        throws,
    });
    CrankTable { radius, rod_length, drive }
}

/// A main bearing has throws beside it, a big end has none.
fn check_throws(table: &mut TableReader<'_>, bearing: CrankBearing, throws: &[ThrowTable]) {
    match bearing {
        CrankBearing::BigEnd => table.refuse_if(
            table.has("throws"),
            "throws",
            "has a meaning for a main bearing only",
            "remove throws, or write load.bearing = \"main\"",
        ),
        CrankBearing::Main if table.has("throws") => table.refuse_if(
            throws.is_empty(),
            "throws",
            "is empty",
            "give the throws beside the bearing: throws = [{ share = 0.5 }]",
        ),
        CrankBearing::Main => table.require_as("throws", "[{ share = 0.5 }, { angle = \"360 deg\", share = 0.5 }]"),
    }
}

fn throw(mut table: TableReader<'_>) -> ThrowTable {
    let share = table.number("share").within(
        "is not above 0 and at most 1",
        "give the share of the load of the throw that the bearing takes, 0.5 midway between two",
    );
    let share = share.required();
    ThrowTable { angle: table.number("angle").or_usual(), share, web_mass: table.number("web_mass").or_usual() }
}

fn gas(mut table: TableReader<'_>, scene: &Path) -> Gas {
    let file = table.text_if_given("file");
    let peak = table.number("peak").within("is negative", "give the pressure over that of the crankcase");
    let peak = peak.given();
    let angle = table.given("angle");
    let sharpness = table.number("sharpness").given();
    let keys = ["peak", "angle", "sharpness"];
    if table.has("file") {
        for key in keys.into_iter().filter(|key| table.has(key)) {
            table.complain(key, "stands beside file", format!("remove {key} or file"));
        }
        return Gas::File(scene.parent().unwrap_or(Path::new("")).join(file.unwrap_or_default()));
    }
    keys.into_iter().for_each(|key| table.require(key));
    Gas::Peak {
        peak: peak.unwrap_or(f64::NAN),
        angle: angle.unwrap_or(f64::NAN),
        sharpness: sharpness.unwrap_or(f64::NAN),
    }
}
