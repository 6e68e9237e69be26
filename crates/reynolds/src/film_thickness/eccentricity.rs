//! # Clearance of a circular journal in a circular bore
//!
//! **Equation.** `h = c - e_x cos phi - e_y sin phi`, `dh/dx = (e_x sin phi - e_y cos phi) / R`,
//! `dh/dt = -e_x' cos phi - e_y' sin phi`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | c | m | `clearance` |
//! | e_x, e_y | m | `journal.offset` |
//! | e_x', e_y' | m/s | `journal.velocity` |
//! | phi = x / R | rad | `x / radius` |
//!
//! **Source.** Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film Lubrication (2004), ch. 10.
//! **Range.** |e| < c << R. **Verified by** `slope_and_variation_are_derivatives` and every bearing solved.

use std::sync::Arc;

use oilwedge_fem::quadrature::MOST_POINTS;

use super::{FilmContribution, Follows};
use crate::angles::sines_and_cosines;
use crate::journal_state::JournalChange;
use crate::{FilmPoint, JournalState};

/// Radial clearance less the journal's offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eccentricity {
    /// Radius R [m].
    pub radius: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
}

impl FilmContribution for Eccentricity {
    fn add(&self, journal: &JournalState, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let change = JournalChange { offset: journal.offset, velocity: journal.velocity, ..JournalChange::default() };
        for point in film.iter_mut() {
            point.thickness += self.clearance;
        }
        self.vary(&change, cell, positions, film);
    }

    /// Linear in the offset and its velocity.
    fn vary(&self, change: &JournalChange, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let ([e_x, e_y], [v_x, v_y]) = (change.offset, change.velocity);
        if [e_x, e_y, v_x, v_y] == [0.0; 4] {
            return;
        }
        // As many points as their sines are made for at once.
        for (positions, film) in positions.chunks(MOST_POINTS).zip(film.chunks_mut(MOST_POINTS)) {
            let [sines, cosines] = sines_and_cosines(positions, self.radius);
            for ((sin, cos), point) in sines.iter().zip(&cosines).zip(film) {
                point.thickness -= e_x * cos + e_y * sin;
                point.slope[0] += (e_x * sin - e_y * cos) / self.radius;
                point.rate -= v_x * cos + v_y * sin;
            }
        }
    }

    fn keeps_circles(&self) -> bool {
        true
    }

    fn follows(&self) -> Follows {
        Follows::Offset
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILM: Eccentricity = Eccentricity { radius: 0.04, clearance: 4e-5 };

    fn at(offset: [f64; 2], x: f64) -> FilmPoint {
        let journal = JournalState { offset, velocity: offset.map(|e| 3.0 * e), ..JournalState::default() };
        let mut point = [FilmPoint::default()];
        FILM.add(&journal, 0, &[[x, 0.0]], &mut point);
        point[0]
    }

    #[test]
    fn slope_and_variation_are_derivatives() {
        let offset = [1e-5, -2e-5];
        for x in [0.0, 0.02, 0.07] {
            let difference = (at(offset, x + 1e-6).thickness - at(offset, x - 1e-6).thickness) / 2e-6;
            assert!((at(offset, x).slope[0] - difference).abs() < 1e-12);
            let (here, moved) = (at(offset, x), at([1.1e-5, -2.3e-5], x));
            let change = JournalChange { offset: [1e-6, -3e-6], velocity: [3e-6, -9e-6], ..JournalChange::default() };
            let mut varied = [FilmPoint::default()];
            FILM.vary(&change, 0, &[[x, 0.0]], &mut varied);
            assert!((here.thickness + varied[0].thickness - moved.thickness).abs() < 1e-19);
            assert!((here.slope[0] + varied[0].slope[0] - moved.slope[0]).abs() < 1e-16);
            assert!((here.rate + varied[0].rate - moved.rate).abs() < 1e-19);
        }
    }

    #[test]
    fn minimum_film_lies_at_the_offset() {
        let x = FILM.radius * std::f64::consts::FRAC_PI_2;
        assert!((at([0.0, 1.6e-5], x).thickness - 2.4e-5).abs() < 1e-19);
    }
}
