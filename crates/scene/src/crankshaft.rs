//! `[crankshaft]`: a scene of its own, with the shaft, the scenes of its bearings, and its loads.

pub(crate) mod bearing;
mod check;
pub(crate) mod piece;
mod scene;
#[cfg(test)]
mod tests;
mod variant;
pub(crate) mod weight;

use std::path::Path;

pub use bearing::{ShaftBearing, ShaftLoad, ShellSupport};
pub use piece::{ShaftPiece, ThrowShape};
pub use scene::ShaftScene;
#[cfg(test)]
pub(crate) use scene::read as read_scene;
pub use weight::Counterweight;

use crate::reader::TableReader;

keys! {
    "crankshaft" = Table; "", "a scene of one bearing", "in a scene without `[bearing]`, beside `title`, `[crank]`, `[orbit]` and `[sweep]` alone",
        "a shaft on the films of all its bearings, each with a scene of its own";
    "crankshaft.speed" = Quantity(Speed); "2000 rpm", "required", "> 0",
        "angular speed of the shaft, from x to y; it takes the place of the speed in the scenes of the bearings, as the loads on the shaft take that of theirs";
    "crankshaft.youngs_modulus" = Quantity(Pressure); "206 GPa", "required", "> 0",
        "Young's modulus of the shaft";
    "crankshaft.shear_modulus" = Quantity(Pressure); "79 GPa", "beams that do not shear (Euler, Bernoulli); required with throws", "> 0",
        "shear modulus of the shaft, with which its pieces are beams of Timoshenko";
    "crankshaft.statics" = Choice(&["elastic", "cut"]); "elastic", "`\"elastic\"`", "",
        "`\"elastic\"`: shaft and films bear the loads together; `\"cut\"`: the shaft is cut at its bearings, which bear what statics gives them, without tilt";
    "crankshaft.tilt" = Choice(&["free", "none"]); "free", "`\"free\"`", "",
        "`\"free\"`: the films resist the slopes of the shaft, too; `\"none\"`: journals stay parallel to their shells, which bear no moment";
    "crankshaft.period" = Quantity(Angle); "720 deg", "720 deg", "360 deg or 720 deg",
        "crank angle after which the gas pressure repeats";
}

/// A shaft, where it rests, and what loads it.
#[derive(Debug, Clone, PartialEq)]
pub struct CrankshaftTable {
    /// Angular speed [rad/s], positive.
    pub speed: f64,
    /// Young's modulus [Pa].
    pub youngs_modulus: f64,
    /// Shear modulus [Pa]; `None`: beams do not shear.
    pub shear_modulus: Option<f64>,
    /// How the loads are borne.
    pub statics: Statics,
    /// Whether films resist tilt.
    pub tilt: ShaftTilt,
    /// Period of the gas pressure [rad].
    pub period: f64,
    /// Pieces of the shaft from z = 0 on.
    pub pieces: Vec<ShaftPiece>,
    /// The shape of its throws; `None`: it has none.
    pub throw: Option<ThrowShape>,
    /// Bearings of the shaft, in the order of the axis.
    pub bearings: Vec<ShaftBearing>,
    /// Loads that do not change.
    pub loads: Vec<ShaftLoad>,
    /// Counterweights on the webs.
    pub counterweights: Vec<Counterweight>,
}

/// How the loads of a shaft are borne.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Statics {
    /// Loads are shared by shaft and films together.
    #[default]
    Elastic,
    /// Loads are shared by bearings at which the shaft is cut.
    Cut,
}

/// Whether the films of a shaft resist its slopes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ShaftTilt {
    /// The journals tilt with the shaft.
    #[default]
    Free,
    /// Journals stay parallel to their shells.
    None,
}

impl CrankshaftTable {
    /// Length of a piece along the axis [m].
    pub fn length_of(&self, piece: &ShaftPiece) -> f64 {
        match (piece, &self.throw) {
            (ShaftPiece::Straight { length, .. }, _) => *length,
            (ShaftPiece::Throw { .. }, Some(throw)) => throw.pin_length + 2.0 * throw.web_thickness,
            (ShaftPiece::Throw { .. }, None) => 0.0,
        }
    }

    /// Length of the shaft [m].
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| self.length_of(piece)).sum()
    }

    /// Crank angles at which the throws fire [rad], in their order along the axis.
    pub fn fires_at(&self) -> Vec<f64> {
        let throws = self.pieces.iter().filter_map(|piece| match piece {
            ShaftPiece::Throw { fires_at } => Some(*fires_at),
            ShaftPiece::Straight { .. } => None,
        });
        throws.collect()
    }

    /// Extent of each straight piece [m].
    pub fn straight_spans(&self) -> Vec<[f64; 2]> {
        let mut z = 0.0;
        let mut spans = Vec::new();
        for piece in &self.pieces {
            let to = z + self.length_of(piece);
            if matches!(piece, ShaftPiece::Straight { .. }) {
                spans.push([z, to]);
            }
            z = to;
        }
        spans
    }
}

/// Reads the table of a scene that stands at `scene`.
pub(crate) fn read(mut table: TableReader<'_>, scene: &Path) -> CrankshaftTable {
    let speed = table.required("speed");
    let youngs_modulus = table.required("youngs_modulus");
    let shear_modulus = table.given("shear_modulus");
    let statics = table.word("statics", &[("elastic", Statics::Elastic), ("cut", Statics::Cut)]);
    let tilt = table.word("tilt", &[("free", ShaftTilt::Free), ("none", ShaftTilt::None)]);
    let period = table.number("period").which(
        |period| (1..=2).any(|turns| (period / (f64::from(turns) * std::f64::consts::TAU) - 1.0).abs() < 1e-9),
        "is neither one turn nor two",
        "give 360 deg for a two-stroke engine, 720 deg for a four-stroke engine",
    );
    let period = period.or_usual();
    for (key, example) in [
        ("piece", "[[crankshaft.piece]] with length and diameter, or with fires_at"),
        ("bearing", "[[crankshaft.bearing]] with scene and at"),
    ] {
        table.refuse_if(!table.has(key) && table.is_readable(), key, "is missing", format!("write {example}"));
    }
    CrankshaftTable {
        speed,
        youngs_modulus,
        shear_modulus,
        statics: statics.unwrap_or_default(),
        tilt: tilt.unwrap_or_default(),
        period,
        pieces: table.tables("piece").into_iter().map(piece::read).collect(),
        throw: table.table_if_given("throw").map(piece::throw),
        bearings: (table.tables("bearing").into_iter().enumerate())
            .map(|(number, table)| bearing::read(table, number, scene))
            .collect(),
        loads: table.tables("load").into_iter().map(bearing::load).collect(),
        counterweights: table.tables("counterweight").into_iter().map(weight::read).collect(),
    }
}
