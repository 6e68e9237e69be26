//! `piece` and `throw` of a crankshaft: its shape.

use crate::reader::TableReader;

keys! {
    "crankshaft.piece" = Tables; "", "required", "a straight one first, last, and between throws",
        "the pieces of the shaft along its axis, the first from z = 0 on: straight ones with `length` and `diameter`, throws with `fires_at`";
    "crankshaft.piece.length" = Quantity(Length); "40 mm", "required unless `fires_at`", "> 0",
        "length of a straight piece; that of a throw follows from `[crankshaft.throw]`";
    "crankshaft.piece.diameter" = Quantity(Length); "80 mm", "required unless `fires_at`", "> 0",
        "diameter of a straight piece";
    "crankshaft.piece.bore" = Quantity(Length); "20 mm", "0", ">= 0, < `diameter`",
        "diameter of a bore through a straight piece";
    "crankshaft.piece.fires_at" = Quantity(Angle); "180 deg", "a straight piece", "",
        "makes the piece a throw: the crank angle at which its piston is farthest from the crank and its gas pressure begins, so that the throw lies as far behind the first one";
    "crankshaft.throw" = Table; "", "the shaft has no throws", "required with throws",
        "the shape of all throws";
    "crankshaft.throw.pin_length" = Quantity(Length); "38 mm", "required", "> 0",
        "length of the pin between its webs";
    "crankshaft.throw.pin_diameter" = Quantity(Length); "68 mm", "required", "> 0",
        "diameter of the pin";
    "crankshaft.throw.pin_bore" = Quantity(Length); "20 mm", "0", ">= 0, < `pin_diameter`",
        "diameter of a bore through the pin";
    "crankshaft.throw.web_thickness" = Quantity(Length); "22 mm", "required", "> 0",
        "thickness of a web along the axis";
    "crankshaft.throw.web_width" = Quantity(Length); "110 mm", "rigid webs", "> 0",
        "width of a web across the throw; with it webs are beams of a rectangular section";
    "crankshaft.throw.web_mass" = Quantity(Mass); "1.5 kg", "0", "any",
        "unbalance of both webs of a throw over the radius of the crank, counterweights not counted";
}

/// A piece of a shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShaftPiece {
    /// A round piece about the axis.
    Straight {
        /// Length [m].
        length: f64,
        /// Diameter [m].
        diameter: f64,
        /// Diameter of its bore [m].
        bore: f64,
    },
    /// A throw.
    Throw {
        /// Crank angle at which it fires [rad].
        fires_at: f64,
    },
}

/// The shape of a throw.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThrowShape {
    /// Length of the pin [m].
    pub pin_length: f64,
    /// Diameter of the pin [m].
    pub pin_diameter: f64,
    /// Diameter of its bore [m].
    pub pin_bore: f64,
    /// Thickness of a web [m].
    pub web_thickness: f64,
    /// Width of a web [m]; `None`: webs are rigid.
    pub web_width: Option<f64>,
    /// Unbalance of both webs over the radius of the crank [kg].
    pub web_mass: f64,
}

impl ThrowShape {
    /// A throw without size, where its table is missing.
    pub fn none() -> Self {
        Self { pin_length: 0.0, pin_diameter: 0.0, pin_bore: 0.0, web_thickness: 0.0, web_width: None, web_mass: 0.0 }
    }
}

pub(super) fn read(mut table: TableReader<'_>) -> ShaftPiece {
    let fires_at = table.given("fires_at");
    let length = table.given("length");
    let diameter = table.given("diameter");
    let bore = bore(&mut table, "bore", diameter);
    let straight = ["length", "diameter", "bore"];
    if let Some(fires_at) = fires_at {
        for key in straight.into_iter().filter(|key| table.has(key)) {
            let help = format!("remove {key} (the shape of throws stands in [crankshaft.throw]), or fires_at");
            table.complain(key, "stands beside fires_at, which makes the piece a throw", help);
        }
        return ShaftPiece::Throw { fires_at };
    }
    table.require("length");
    table.require("diameter");
    ShaftPiece::Straight { length: length.unwrap_or(f64::NAN), diameter: diameter.unwrap_or(f64::NAN), bore }
}

/// The bore of a round piece, less than its diameter.
fn bore(table: &mut TableReader<'_>, key: &'static str, diameter: Option<f64>) -> f64 {
    let bore = table.number(key).which(
        |bore| bore >= 0.0 && diameter.is_none_or(|diameter| diameter.is_nan() || bore < diameter),
        "is not between 0 and the diameter",
        "give the diameter of the bore, less than that of the piece",
    );
    bore.or_usual()
}

pub(super) fn throw(mut table: TableReader<'_>) -> ThrowShape {
    let pin_diameter = table.required("pin_diameter");
    ThrowShape {
        pin_length: table.required("pin_length"),
        pin_diameter,
        pin_bore: bore(&mut table, "pin_bore", Some(pin_diameter)),
        web_thickness: table.required("web_thickness"),
        web_width: table.given("web_width"),
        web_mass: table.number("web_mass").or_usual(),
    }
}
