//! # Couette flow: oil dragged along by the journal
//!
//! **Equation.** `J = s U h` [m2/s], `div J = s U . grad h`, s = 1/2 where the viscosity does not vary across the film;
//! U = (omega R, 0) unless the journal slides along its axis.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | U | m/s | `film.velocity` |
//! | s | 1 | `film.drag` |
//! | h | m | `film.thickness` |
//! | grad h | - | `film.slope` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157; bearing at rest, journal turning.
//! **Range.** No slip at the walls. **Verified by** `divergence_matches_the_flux` and the closed forms.

use super::Term;
use crate::{FilmFlow, FilmPoint};

/// A part of the film, half of it where its viscosity is even, moves with the journal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Couette;

impl Term for Couette {
    fn name(&self) -> &'static str {
        "couette"
    }

    fn add(&self, film: &FilmPoint, flow: &mut FilmFlow) {
        for k in 0..2 {
            flow.flux[k] += film.drag * film.velocity[k] * film.thickness;
            flow.divergence += film.drag * film.velocity[k] * film.slope[k];
        }
    }

    /// Linear in the film.
    fn vary(&self, film: &FilmPoint, change: &FilmPoint, flow: &mut FilmFlow) {
        let FilmPoint { velocity, drag, .. } = *film;
        self.add(&FilmPoint { velocity, drag, ..*change }, flow);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn variation_matches_differences() {
        super::super::check(&Couette);
    }

    #[test]
    fn divergence_matches_the_flux() {
        let at = |x: f64| {
            let film = FilmPoint {
                thickness: 2.0 + 3.0 * x,
                slope: [3.0, 0.0],
                viscosity: 1.0,
                drag: 0.5,
                velocity: [0.7, 0.0],
                ..FilmPoint::default()
            };
            let mut flow = FilmFlow::default();
            Couette.add(&film, &mut flow);
            flow
        };
        assert!((at(0.4).divergence - (at(1.4).flux[0] - at(0.4).flux[0])).abs() < 1e-15);
    }
}
