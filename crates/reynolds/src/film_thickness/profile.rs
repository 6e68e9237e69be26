//! # Surfaces that are not circles
//!
//! **Equation.** `h` grows by `d(phi, z)`, the depth of the bore below its circle or of an axisymmetric shaft below its
//! own; `dh/dx` and `dh/dz` by its slopes.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `depth` |
//! | dd/dx, dd/dz | - | `slope` |
//! | d2d/dx2, d2d/dz2 | 1/m | `bends` |
//!
//! **Source.** Definition. **Range.** Slopes far below one, as Reynolds' equation has them; a shaft turns, so that its
//! shape must not depend on the angle.
//! **Verified by** `slopes_and_variations_match_differences` and `tests/tests/shapes`.

use std::sync::Arc;

use super::FilmContribution;
use crate::{FilmPoint, JournalState};

/// A profile at one place.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Relief {
    /// How much deeper the surface is than its circle [m].
    pub depth: f64,
    /// Slopes of the depth around and along the axis [1].
    pub slope: [f64; 2],
}

/// How far a surface lies below its circle.
pub trait Profile: Send + Sync + std::fmt::Debug {
    /// The profile at `(x, z)` [m] of the developed surface.
    fn at(&self, position: [f64; 2]) -> Relief;

    /// Calls `visit` with the number of each of some positions [m] near to each other, and the profile there.
    fn each(&self, positions: &[[f64; 2]], visit: &mut dyn FnMut(usize, Relief)) {
        for (q, &position) in positions.iter().enumerate() {
            visit(q, self.at(position));
        }
    }

    /// Second derivatives of its depth around and along the axis [1/m], by which a mesh is graded.
    fn bends(&self, position: [f64; 2]) -> [f64; 2];

    /// Longest edges [m] of triangles near a place that show where its slope jumps; infinite for a profile without such
    /// places.
    fn finest(&self, _position: [f64; 2]) -> f64 {
        f64::INFINITY
    }
}

/// A profile as a part of the film thickness.
#[derive(Debug, Clone)]
pub struct Shape(pub Arc<dyn Profile>);

impl FilmContribution for Shape {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        self.0.each(positions, &mut |q, Relief { depth, slope }| {
            film[q].thickness += depth;
            film[q].slope[0] += slope[0];
            film[q].slope[1] += slope[1];
        });
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(self.clone())
    }
}
