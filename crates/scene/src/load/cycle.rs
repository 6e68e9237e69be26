//! `[load]` over a cycle: from a table, by harmonics, or from a crank.

use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

use crate::journal::tilt;
use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "load.file" = Text; "loads/big_end.csv", "the load does not change, or see `harmonics`, `bearing`", "a table with units in its header: `angle [deg], Fx [kN], Fy [kN]`, and if wanted `Mx [N.m], My [N.m]`",
        "path of a table of the load by crank angle, counted from the folder of the scene: the force on the journal, which the film carries";
    "load.harmonics" = Tables; "", "the load does not change, or see `file`, `bearing`", "",
        "the load by its harmonics: the sum of `cos` times cos(order theta) and `sin` times sin(order theta) over all tables";
    "load.harmonics.order" = Number; "0.5", "required", ">= 0, whole periods",
        "cycles in a turn of the crank; 0 is a constant";
    "load.harmonics.cos" = Table; "", "0", "",
        "amplitude of the cosine";
    "load.harmonics.cos.x" = Quantity(Force); "40 kN", "0", "any",
        "its part towards x";
    "load.harmonics.cos.y" = Quantity(Force); "40 kN", "0", "any",
        "its part towards y";
    "load.harmonics.sin" = Table; "", "0", "",
        "amplitude of the sine";
    "load.harmonics.sin.x" = Quantity(Force); "40 kN", "0", "any",
        "its part towards x";
    "load.harmonics.sin.y" = Quantity(Force); "40 kN", "0", "any",
        "its part towards y";
    "load.bearing" = Choice(&["big-end", "main"]); "big-end", "see `file`, `harmonics`", "",
        "the bearing of `[crank]` whose load is computed from masses and gas pressure: the big end, x along the rod towards the small end; or a main bearing at rest, x towards the cylinders";
    "load.frame" = Choice(&["shell", "cylinder", "pin"]); "shell", "required with `file` and `harmonics`", "`\"cylinder\"` needs `[crank]`",
        "axes of the forces: those of the bearing's shell; x from the centre of the crank to the cylinder; or x along the throw, turning with the crank angle";
    "load.period" = Quantity(Angle); "720 deg", "required with `file`, `harmonics` and `bearing`, but see `frequency`", "360 deg or 720 deg",
        "crank angle after which the load repeats";
    "load.frequency" = Quantity(Speed); "50 Hz", "the load goes by the crank angle: see `period`", "> 0",
        "how often a load by `file` or `harmonics` repeats, however the journal turns or if it stands still; 360 deg are then one period of the load";
}

/// A load that changes over a cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadCycle {
    /// Source of the load.
    pub source: LoadSource,
    /// Angle after which it repeats [rad]: one turn of the crank or two, or one turn of its own.
    pub period: f64,
    /// Rate at which its angle grows [rad/s]; `None`: that of the crank, which turns with the journal.
    pub frequency: Option<f64>,
}

/// Source of a load over a cycle.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadSource {
    /// A table.
    File {
        /// The file.
        path: PathBuf,
        /// Axes of its forces.
        frame: LoadFrame,
    },
    /// Harmonics.
    Harmonics {
        /// The orders.
        orders: Vec<HarmonicTable>,
        /// Axes of the forces.
        frame: LoadFrame,
    },
    /// Masses and gas pressure of a crank: the load of this bearing.
    Crank(CrankBearing),
}

/// A bearing whose load is computed from a crank.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CrankBearing {
    /// The bearing of the pin.
    BigEnd,
    /// A main bearing beside throws.
    Main,
}

/// Axes of the forces of a load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LoadFrame {
    /// The axes of the bearing's shell.
    Shell,
    /// Axes with x from the centre of the crank to the cylinder.
    Cylinder,
    /// Axes with x along the throw of the crank; they turn with the crank angle.
    Pin,
}

/// One order of a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HarmonicTable {
    /// Cycles in a turn of the crank.
    pub order: f64,
    /// Amplitude of the cosine [N].
    pub cos: [f64; 2],
    /// Amplitude of the sine [N].
    pub sin: [f64; 2],
}

/// Keys that make a load one over a cycle.
const SOURCES: [&str; 3] = ["file", "harmonics", "bearing"];
/// How far a number of periods may be from a whole one.
const WHOLE: f64 = 1e-9;

/// The key that makes the load of this table one over a cycle.
pub(super) fn source_key(table: &TableReader<'_>) -> Option<&'static str> {
    SOURCES.into_iter().find(|key| table.has(key))
}

/// Reads the keys of a load over a cycle, if there are any.
pub(super) fn read(table: &mut TableReader<'_>, scene: &Path) -> Option<LoadCycle> {
    let file = table.text_if_given("file");
    let orders = table.tables("harmonics").into_iter().map(harmonic).collect();
    let bearing = table.word("bearing", &[("big-end", CrankBearing::BigEnd), ("main", CrankBearing::Main)]);
    let frames = [("shell", LoadFrame::Shell), ("cylinder", LoadFrame::Cylinder), ("pin", LoadFrame::Pin)];
    let frame = table.word("frame", &frames);
    let period = table.number("period").which(
        |period| [1.0, 2.0].iter().any(|turns| (period / TAU - turns).abs() < WHOLE),
        "is neither one turn of the crank nor two",
        "write period = \"720 deg\" for a four-stroke engine, or \"360 deg\"",
    );
    let period = period.given();
    let frequency =
        table.number("frequency").within("is not positive", "give how often the load repeats, such as 50 Hz");
    let frequency = frequency.given();
    let Some(key) = source_key(table) else {
        for key in ["frame", "period", "frequency"].into_iter().filter(|key| table.has(key)) {
            let help = format!("remove {key}, or give the load as file, harmonics or bearing");
            table.complain(key, "has a meaning for a load over a cycle only", help);
        }
        return None;
    };
    for other in SOURCES.into_iter().filter(|other| *other != key && table.has(other)) {
        let help = format!("remove {other} or {key}: the load is given in one way");
        table.complain(other, format!("stands beside {key}"), help);
    }
    table.refuse_if(
        key != "bearing" && table.has("frequency") && table.has("period"),
        "frequency",
        "stands beside period, the crank angle after which the load repeats",
        "remove frequency, or remove period: a load with a frequency repeats after 360 deg of its own",
    );
    table.refuse_if(
        key == "bearing" && table.has("frequency"),
        "frequency",
        "stands beside bearing, whose load goes by the crank angle",
        "remove frequency",
    );
    if !table.has("frequency") {
        table.require("period");
    }
    table.refuse_if(
        key == "bearing" && table.has("frame"),
        "frame",
        "stands beside bearing, whose load is not given but computed",
        "remove frame",
    );
    if key != "bearing" {
        table.require("frame");
    }
    let frame = frame.unwrap_or(LoadFrame::Shell);
    let source = match key {
        "file" => {
            LoadSource::File { path: scene.parent().unwrap_or(Path::new("")).join(file.unwrap_or_default()), frame }
        }
        "harmonics" => LoadSource::Harmonics { orders, frame },
        _ => LoadSource::Crank(bearing.unwrap_or(CrankBearing::BigEnd)),
    };
    Some(LoadCycle {
        source,
        period: match frequency {
            Some(_) => TAU,
            None => period.unwrap_or(f64::NAN),
        },
        frequency,
    })
}

fn harmonic(mut table: TableReader<'_>) -> HarmonicTable {
    let order = table.number("order").within("is negative", "give order >= 0: cycles in a turn of the crank");
    let order = order.required();
    let [cos, sin] = ["cos", "sin"].map(|key| {
        let parts = table.table_if_given(key);
        parts.map_or([0.0; 2], tilt::read)
    });
    HarmonicTable { order, cos, sin }
}

/// A crank where its axes are used, a journal that turns or a frequency, and whole periods of harmonics.
pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let Some(cycle) = &scene.load_cycle else {
        complaints.refuse_if(
            scene.crank.is_some(),
            "crank",
            "has a meaning for a load over a cycle only",
            "give [load] bearing = \"big-end\" and period = \"720 deg\", or remove [crank]",
        );
        return;
    };
    complaints.refuse_if(
        scene.journal.speed == 0.0 && cycle.frequency.is_none(),
        "journal.speed",
        "is zero, but a load over a cycle goes by the angle of the crank, which turns with the journal",
        "give the speed of the crank; or, if the load repeats by itself, load.frequency = \"50 Hz\" in place of load.period",
    );
    complaints.refuse_if(
        cycle.frequency.is_some() && scene.crank.is_some() && !matches!(cycle.source, LoadSource::Crank(_)),
        "load.frequency",
        "stands beside [crank], whose angle turns with the journal",
        "remove [crank]; or give load.period in place of load.frequency",
    );
    let frame = match &cycle.source {
        LoadSource::File { frame, .. } | LoadSource::Harmonics { frame, .. } => Some(*frame),
        LoadSource::Crank(_) => None,
    };
    complaints.refuse_if(
        frame == Some(LoadFrame::Cylinder) && scene.crank.is_none() && cycle.frequency.is_none(),
        "load.frame",
        "is \"cylinder\", but without [crank] it is not known how the shell turns",
        "give [crank] with radius and rod_length; or, if the shell is at rest, frame = \"shell\" with x towards the cylinder",
    );
    complaints.refuse_if(
        cycle.frequency.is_some() && frame.is_some_and(|frame| frame != LoadFrame::Shell),
        "load.frame",
        "is that of a crank, but the load repeats by itself, at load.frequency",
        "give the load in frame = \"shell\"; or load.period in place of load.frequency",
    );
    complaints.refuse_if(
        frame.is_none() && scene.crank.is_none(),
        "load.bearing",
        "is computed from [crank], which is missing",
        "give [crank] with radius, rod_length, reciprocating_mass, rotating_mass, bore and gas",
    );
    let LoadSource::Harmonics { orders, .. } = &cycle.source else {
        return;
    };
    for (index, harmonic) in orders.iter().enumerate() {
        let periods = harmonic.order * cycle.period / TAU;
        complaints.refuse_if(
            (periods - periods.round()).abs() > WHOLE,
            &format!("load.harmonics[{index}].order"),
            "makes no whole number of cycles in the period of the load",
            "give whole orders, or halves with period = \"720 deg\"; for a load with a frequency, whole ones",
        );
    }
}

#[cfg(test)]
mod tests;
