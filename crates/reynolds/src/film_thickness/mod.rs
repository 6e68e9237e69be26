//! How thick the film is: a sum of contributions, one a file.

mod crown;
mod deflection;
mod eccentricity;
mod envelope;
mod groove_depth;
mod measured;
mod measured_axis;
mod oval;
mod profile;
mod tilt;
mod worn;

pub use crown::Crown;
pub use deflection::{Closing, Deflection, WallStage};
pub use eccentricity::Eccentricity;
pub use envelope::{Envelope, Wearing};
pub use groove_depth::GrooveDepth;
pub use measured::{MeasuredSurface, SurfaceGrid};
pub use oval::Oval;
pub use profile::{Profile, Relief, Shape};
pub use tilt::Tilt;
pub use worn::Worn;

use std::sync::Arc;

use crate::journal_state::JournalChange;
use crate::{FilmPoint, JournalState};

/// What a contribution follows as the journal moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Follows {
    /// Nothing: it is a shape of the liner.
    Nothing,
    /// The offset of the journal; all that is left where the journal is centred is a constant gap.
    Offset,
    /// The slope of the journal's axis.
    Tilt,
}

/// A part of the film thickness.
pub trait FilmContribution: Send + Sync + std::fmt::Debug {
    /// Adds its thickness [m], slope and rate [m/s] at `positions` [m] (developed surface) in triangle `cell`.
    fn add(&self, journal: &JournalState, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]);

    /// Adds what it changes, to first order, where the journal changes by `change`. Nothing unless it knows the
    /// journal.
    fn vary(&self, _change: &JournalChange, _cell: usize, _positions: &[[f64; 2]], _film: &mut [FilmPoint]) {}

    /// True if the film of circular surfaces stays least where the circles are nearest. Else the least film is searched
    /// on the mesh.
    fn keeps_circles(&self) -> bool {
        false
    }

    /// What it follows.
    fn follows(&self) -> Follows {
        Follows::Nothing
    }

    /// Itself, if it is the deflection of the wall, which is found.
    fn as_deflection(&self) -> Option<&Deflection> {
        None
    }

    /// This contribution on another mesh of the liner, whose triangle `t` lies in triangle `parents[t]` of this one.
    fn carried(&self, parents: &[u32]) -> Arc<dyn FilmContribution>;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Bearing;
    use crate::wall::{Along, Around, Compliance, Grid, Wall};

    /// A wall that is bent somehow.
    fn bent() -> Deflection {
        let (around, along) = (Around::centred(9, 0.1), Along::on_breaks(&[-0.02, 0.0, 0.02]));
        let compliance = Compliance::of_slices((0.04, &around, &along), |_| 1e-14).expect("a grid");
        let coarser = None;
        let grid = Grid { radius: 0.04, around, along };
        let coefficients = (0..grid.number()).map(|k| 1e-5 * (1.7 * k as f64).sin()).collect();
        Deflection::none(Arc::new(Wall { grid, compliance, coarser })).with(coefficients)
    }

    /// One of each kind.
    fn shapes() -> [Shape; 5] {
        let angles: Vec<f64> = (0..12).map(|k| std::f64::consts::TAU * f64::from(k) / 12.0).collect();
        let zs = vec![-0.02, -0.005, 0.015, 0.02];
        let depth = |angle: f64, z: f64| 3e-6 * (angle.cos() + 50.0 * z * angle.sin());
        let points = SurfaceGrid {
            depths: angles.iter().map(|&angle| zs.iter().map(|&z| depth(angle, z)).collect()).collect(),
            angles,
            zs,
        };
        [
            Shape(Arc::new(Crown { depth: 7e-6, half_length: 0.02 })),
            Shape(Arc::new(Oval { radius: 0.04, depth: -6e-6, angle: 0.4 })),
            Shape(Arc::new(Worn { radius: 0.04, depth: 9e-6, angle: 0.9, half_width: 0.7 })),
            Shape(Arc::new(Envelope::new(
                &Bearing { radius: 0.04, length: 0.04, clearance: 4e-5, end_pressure: 0.0 },
                1e-5,
                &[
                    Wearing { offset: [2.5e-5, 2e-5], tilt: [1e-4, -2e-4] },
                    Wearing { offset: [-1e-5, -3.8e-5], tilt: [0.0, 3e-4] },
                ],
            ))),
            Shape(Arc::new(MeasuredSurface::new(&points, 0.04, 0.04, true))),
        ]
    }

    /// Every contribution against finite differences: its slope, and what it changes where the journal moves.
    #[test]
    fn slopes_and_variations_match_differences() {
        let eccentricity = Eccentricity { radius: 0.04, clearance: 4e-5 };
        let groove = GrooveDepth { depth: 2e-5, inside: vec![true] };
        let tilt = Tilt { radius: 0.04 };
        let [crown, oval, worn, envelope, measured] = shapes();
        let deflection = bent();
        let journal = JournalState {
            offset: [1e-5, -2e-5],
            velocity: [3e-5, 1e-5],
            tilt: [4e-4, 3e-4],
            tilt_rate: [-2e-3, 5e-3],
            speed: 10.0,
            axial_velocity: 0.0,
        };
        let change = JournalChange {
            offset: [-0.7e-5, 0.4e-5],
            velocity: [0.2e-5, -0.9e-5],
            tilt: [2e-4, -5e-4],
            tilt_rate: [7e-3, 1e-3],
        };
        let contributions: [&dyn FilmContribution; 9] =
            [&eccentricity, &groove, &tilt, &crown, &oval, &worn, &envelope, &measured, &deflection];
        for contribution in contributions {
            let place = |step: f64, x: f64, z: f64| {
                let scaled = |values: [f64; 2]| values.map(|value| step * value);
                let moved = journal.changed(&JournalChange {
                    offset: scaled(change.offset),
                    velocity: scaled(change.velocity),
                    tilt: scaled(change.tilt),
                    tilt_rate: scaled(change.tilt_rate),
                });
                let mut point = [FilmPoint::default()];
                contribution.add(&moved, 0, &[[x, z]], &mut point);
                point[0]
            };
            let at = |step: f64, x: f64| place(step, x, 0.01);
            for x in [0.005, 0.03, 0.11] {
                let slope = (at(0.0, x + 1e-6).thickness - at(0.0, x - 1e-6).thickness) / 2e-6;
                assert!((at(0.0, x).slope[0] - slope).abs() < 1e-11, "{contribution:?}");
                let slope = (place(0.0, x, 0.01 + 1e-6).thickness - place(0.0, x, 0.01 - 1e-6).thickness) / 2e-6;
                assert!((at(0.0, x).slope[1] - slope).abs() < 1e-11, "{contribution:?}");
                let mut varied = [FilmPoint::default()];
                contribution.vary(&change, 0, &[[x, 0.01]], &mut varied);
                let (ahead, behind) = (at(1e-3, x), at(-1e-3, x));
                let pairs = [
                    (ahead.thickness - behind.thickness, varied[0].thickness),
                    (ahead.slope[0] - behind.slope[0], varied[0].slope[0]),
                    (ahead.slope[1] - behind.slope[1], varied[0].slope[1]),
                    (ahead.rate - behind.rate, varied[0].rate),
                ];
                for (difference, variation) in pairs {
                    assert!((difference / 2e-3 - variation).abs() < 1e-12, "{contribution:?}");
                }
            }
        }
    }
}
