//! # Journal whose axis is inclined to that of the bearing
//!
//! **Equation.** `h` changes by `-z g.n`, `n = (cos phi, sin phi)`, so that
//! `dh/dx = z (g_x sin phi - g_y cos phi) / R`, `dh/dz = -g.n`, `dh/dt = -z g'.n`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | g_x, g_y | rad | `journal.tilt` |
//! | g_x', g_y' | rad/s | `journal.tilt_rate` |
//! | z | m | `positions[k][1]`, 0 at mid-length |
//!
//! **Source.** Pinkus, Bupara, Trans. ASME J. Lubr. Tech. 101 (1979) 432. **Range.** |g| B << R: slopes of the surfaces
//! far below one, as Reynolds' equation has them; no contact, `|e + z g| < c` at both ends. **Verified by**
//! `slopes_and_variations_match_differences` and `tests/tests/tilt`.

use std::sync::Arc;

use oilwedge_fem::quadrature::MOST_POINTS;

use super::{FilmContribution, Follows};
use crate::angles::sines_and_cosines;
use crate::journal_state::JournalChange;
use crate::{FilmPoint, JournalState};

/// What the slope of the journal's axis adds to the gap of the parallel journal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tilt {
    /// Radius R [m].
    pub radius: f64,
}

impl FilmContribution for Tilt {
    fn add(&self, journal: &JournalState, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let change = JournalChange { tilt: journal.tilt, tilt_rate: journal.tilt_rate, ..JournalChange::default() };
        self.vary(&change, cell, positions, film);
    }

    /// Linear in the slope and its rate.
    fn vary(&self, change: &JournalChange, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let ([g_x, g_y], [w_x, w_y]) = (change.tilt, change.tilt_rate);
        if [g_x, g_y, w_x, w_y] == [0.0; 4] {
            return;
        }
        // As many points as their sines are made for at once.
        for (positions, film) in positions.chunks(MOST_POINTS).zip(film.chunks_mut(MOST_POINTS)) {
            let [sines, cosines] = sines_and_cosines(positions, self.radius);
            let angles = sines.iter().zip(&cosines);
            for (((sin, cos), [_, z]), point) in angles.zip(positions).zip(film) {
                let along = g_x * cos + g_y * sin;
                point.thickness -= z * along;
                point.slope[0] += z * (g_x * sin - g_y * cos) / self.radius;
                point.slope[1] -= along;
                point.rate -= z * (w_x * cos + w_y * sin);
            }
        }
    }

    fn keeps_circles(&self) -> bool {
        true
    }

    fn follows(&self) -> Follows {
        Follows::Tilt
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}
