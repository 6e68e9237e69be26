//! `bearing` and `load` of a crankshaft: where it rests, and what pulls it.

use std::path::{Path, PathBuf};

use crate::reader::TableReader;

keys! {
    "crankshaft.bearing" = Tables; "", "required", "along the axis, at straight pieces",
        "the bearings of the shaft";
    "crankshaft.bearing.scene" = Text; "engine/main.toml", "required", "a scene of one bearing",
        "path of the scene of the bearing, counted from the folder of this scene; its position, load, speed and tilt, `mesh.tolerance`, `[dynamics]` and `[sweep]` are not used";
    "crankshaft.bearing.name" = Text; "main 1", "its number, counted from 1", "each once",
        "how results call the bearing";
    "crankshaft.bearing.at" = Quantity(Length); "20 mm", "required", "on a straight piece",
        "axial position of its middle";
    "crankshaft.bearing.support" = Table; "", "the shell does not give way", "",
        "what holds the shell";
    "crankshaft.bearing.support.stiffness" = Quantity(Stiffness); "200 MN/m", "it does not give way to a force", "> 0",
        "force over displacement of the shell, to all sides";
    "crankshaft.bearing.support.tilt_stiffness" = Quantity(RotationalStiffness); "20 kN.m/rad", "it does not give way to a moment", "> 0",
        "moment over slope of the shell, to all sides";
    "crankshaft.load" = Tables; "", "the loads of `[crank]`", "not beside `[crank]`",
        "loads on the shaft that do not change";
    "crankshaft.load.at" = Quantity(Length); "100 mm", "required", "on a straight piece",
        "axial position at which it acts";
    "crankshaft.load.force" = Quantity(Force); "12 kN", "required", ">= 0",
        "external force on the shaft";
    "crankshaft.load.angle" = Quantity(Angle); "270 deg", "required", "",
        "direction in which it pulls the shaft";
}

/// A bearing of a shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftBearing {
    /// The file of its scene.
    pub scene: PathBuf,
    /// How results call it.
    pub name: String,
    /// Axial position of its middle [m].
    pub at: f64,
    /// What holds its shell.
    pub support: ShellSupport,
}

/// What holds the shell of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShellSupport {
    /// Force over displacement [N/m], infinite for a shell that does not give way.
    pub stiffness: f64,
    /// Moment over slope [N m/rad], infinite likewise.
    pub tilt_stiffness: f64,
}

/// A load on a shaft that does not change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftLoad {
    /// Axial position [m].
    pub at: f64,
    /// Force towards x and y [N].
    pub force: [f64; 2],
}

/// Reads the bearing `number`, from 0, of a scene that stands at `scene`.
pub(super) fn read(mut table: TableReader<'_>, number: usize, scene: &Path) -> ShaftBearing {
    let file = table.text("scene");
    let name = table.text_if_given("name");
    let at = table.required("at");
    let support = table.table_if_given("support").map(|mut table| {
        let stiffness = table.given("stiffness");
        let of_tilt = table.given("tilt_stiffness");
        [stiffness, of_tilt].map(|stiffness| stiffness.unwrap_or(f64::INFINITY))
    });
    let [stiffness, tilt_stiffness] = support.unwrap_or([f64::INFINITY; 2]);
    ShaftBearing {
        scene: scene.parent().unwrap_or(Path::new("")).join(file),
        name: name.unwrap_or_else(|| (number + 1).to_string()),
        at,
        support: ShellSupport { stiffness, tilt_stiffness },
    }
}

pub(super) fn load(mut table: TableReader<'_>) -> ShaftLoad {
    let at = table.required("at");
    let force = table.number("force").within("is negative", "give force >= 0, and turn angle by 180 deg");
    let force = force.required();
    let (sin, cos) = table.required("angle").sin_cos();
    ShaftLoad { at, force: [force * cos, force * sin] }
}
