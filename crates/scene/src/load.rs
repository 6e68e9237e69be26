//! `[load]`: the force that the journal carries, where its position is found, and the moment, where its tilt is found
//! too; `load/cycle.rs` has the keys of a load over a cycle.

pub(crate) mod cycle;

use std::path::Path;

use crate::journal::tilt;
use crate::reader::TableReader;
use crate::{Complaints, LoadCycle, PositionTable, Scene};

keys! {
    "load" = Table; "", "the position is given", "",
        "the load for which the position of the journal is found";
    "load.force" = Quantity(Force); "5 kN", "required unless the load changes over a cycle", ">= 0",
        "external force F on the journal, such as its share of the weight of the rotor; the film holds the journal with -F and pushes the liner with F";
    "load.angle" = Quantity(Angle); "270 deg", "required unless the load changes over a cycle", "",
        "direction in which F pulls the journal";
    "load.at" = Quantity(Length); "4 mm", "0, and the tilt is given", "inside the bearing unless a moment or `[support]` is given",
        "axial position at which F acts, 0 midway between the ends; with this key the tilt of the journal is found where the film carries the moment";
    "load.moment" = Table; "", "0, and the tilt is given", "",
        "moment on the journal beside that of F at its place, M = Int z dF; with this table the tilt of the journal is found";
    "load.moment.x" = Quantity(Torque); "5 N.m", "0", "any",
        "moment of forces towards x (angle 0): force times its axial position";
    "load.moment.y" = Quantity(Torque); "5 N.m", "0", "any",
        "moment of forces towards y (angle 90 deg)";
}

/// The load on a journal.
pub(crate) struct LoadTable {
    /// Force and angle, or that the load changes.
    pub(crate) position: PositionTable,
    /// How it changes over a cycle; `None`: it does not.
    pub(crate) cycle: Option<LoadCycle>,
    /// Axial position at which the force acts [m]; `None`: not written.
    pub(crate) at: Option<f64>,
    /// Moment beside that of the force at its place [N m]; `None`: not written.
    pub(crate) moment: Option<[f64; 2]>,
}

/// Reads the table of a scene that stands at `scene`.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path) -> LoadTable {
    let cycle = cycle::read(&mut table, scene);
    let force = table.number("force").within("is negative", "give force >= 0, and turn angle by 180 deg");
    let force = force.given();
    let angle = table.given("angle");
    match cycle::source_key(&table) {
        None => {
            table.require("force");
            table.require("angle");
        }
        Some(source) => {
            for key in ["force", "angle", "moment"].into_iter().filter(|key| table.has(key)) {
                let message = format!("stands beside {source}, by which the load changes over a cycle");
                let help = match key {
                    "moment" => "remove moment; a table of the load may have columns Mx [N.m] and My [N.m]".to_owned(),
                    _ => format!("remove {key} or {source}"),
                };
                table.complain(key, message, help);
            }
        }
    }
    LoadTable {
        position: match cycle {
            Some(_) => PositionTable::Cycle,
            None => PositionTable::Load { force: force.unwrap_or(f64::NAN), angle: angle.unwrap_or(f64::NAN) },
        },
        cycle,
        at: table.given("at"),
        moment: (table.table_if_given("moment")).map(tilt::read),
    }
}

/// Keys that must fit each other.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    cycle::check(scene, complaints);
}
