//! # Poiseuille flow: oil driven by the pressure gradient
//!
//! **Equation.** `J = -h^3/(12 mu) grad p` [m2/s].
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h | m | `film.thickness` |
//! | mu | Pa s | `film.viscosity` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157.
//! **Range.** Laminar, inertialess, h much smaller than its scale of change; [`crate::flow_factors::TurbulenceModel`]
//! scales it.
//! **Verified by** the closed forms in `tests/tests/literature` and the manufactured solutions.

use super::Term;
use crate::{FilmFlow, FilmPoint};

/// Flow down the pressure gradient.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Poiseuille;

impl Term for Poiseuille {
    fn name(&self) -> &'static str {
        "poiseuille"
    }

    fn add(&self, film: &FilmPoint, flow: &mut FilmFlow) {
        let conductance = film.thickness.powi(3) / (12.0 * film.viscosity);
        flow.conductance.iter_mut().for_each(|along| *along += conductance);
    }

    fn vary(&self, film: &FilmPoint, change: &FilmPoint, flow: &mut FilmFlow) {
        let conductance = film.thickness.powi(3) / (12.0 * film.viscosity);
        let by = conductance * (3.0 * change.thickness / film.thickness - change.viscosity / film.viscosity);
        flow.conductance.iter_mut().for_each(|along| *along += by);
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn variation_matches_differences() {
        super::super::check(&super::Poiseuille);
    }
}
