//! # Groove or pocket that deepens the film
//!
//! **Equation.** `h` grows by `d` in the cells of the groove; `h` jumps at its edge, which is a line
//! of element edges, and the flux is continuous there by the weak form.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `depth` |
//!
//! **Source.** Rayleigh, Phil. Mag. 35 (1918) 1 (the step); Fowell et al., Trib. Int. 40 (2007) 638.
//! **Range.** d of the order of h: in a much deeper groove the pressure is nearly even and inertia counts.
//! **Verified by** `literature/rayleigh_1918`.

use std::sync::Arc;

use super::FilmContribution;
use crate::{FilmPoint, JournalState};

/// A step of the film thickness.
#[derive(Debug, Clone, PartialEq)]
pub struct GrooveDepth {
    /// Depth d [m].
    pub depth: f64,
    /// True for the cells of the groove.
    pub inside: Vec<bool>,
}

impl FilmContribution for GrooveDepth {
    fn add(&self, _journal: &JournalState, cell: usize, _positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        if self.inside[cell] {
            for point in film {
                point.thickness += self.depth;
            }
        }
    }

    /// A groove only deepens the film.
    fn keeps_circles(&self) -> bool {
        true
    }

    fn carried(&self, parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(Self {
            depth: self.depth,
            inside: parents.iter().map(|&parent| self.inside[parent as usize]).collect(),
        })
    }
}
