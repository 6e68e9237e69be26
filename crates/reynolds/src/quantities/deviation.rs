//! # Film of a journal whose axis deviates from that of the bearing: criteria of a crankshaft's bearings
//!
//! **Equation.** `Delta_gamma = h_0 - min(h_1, h_2)`, `h* = h_0/(1 + k Delta_gamma^2)`, `k = 1/s^2`; where the film is
//! thicker at both ends, Delta_gamma < 0, `h* = h_0`. For several bearings of one shaft the crown that keeps the
//! thinnest ends as far off as the thinnest middle is `E = min h_0 - min(h_1, h_2)`, both over all bearings; for one
//! bearing that is its Delta_gamma.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h_0 | m | `middle`: least film at mid-length, over a cycle the least of the cycle |
//! | h_1, h_2 | m | `ends`: least films at both ends, likewise |
//! | s | m | `scale`: the deviation that halves h* |
//!
//! **Source.** Zharov, Modelling of the tribosystem crankshaft - bearings - supports (dissertation, VNIIZhT Moscow,
//! 1996), criteria of serviceability and table 2: k = 0.01/um^2, found from the wear of main bearings. **Range.**
//! Comparison of bearings of one kind; h* is no thickness anywhere. **Verified by**
//! `tests/tests/literature/zharov_1996.rs`.

use crate::{FilmProblem, FilmSystem, Gap, JournalState};

/// Least films at mid-length and at both ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sections {
    /// Least film at mid-length [m].
    pub middle: f64,
    /// Least film at the ends [m].
    pub ends: [f64; 2],
}

impl Sections {
    /// The sections of a film on its mesh.
    pub fn of_film(problem: &FilmProblem, system: &FilmSystem) -> Self {
        let gap = Gap::of(problem, system);
        let [low, high] = problem.bearing.ends();
        let [middle, low, high] = [0.0, low, high].map(|z| gap.thinnest_film_at(problem, system, z).thickness);
        Self { middle, ends: [low, high] }
    }

    /// The sections of a gap with the journal in a state.
    pub fn of_journal(gap: &Gap, journal: &JournalState) -> Self {
        let [low, high] = gap.bearing().ends();
        let [middle, low, high] = [0.0, low, high].map(|z| gap.thinnest_at(journal, z).thickness);
        Self { middle, ends: [low, high] }
    }

    /// The thinner one of the ends [m].
    pub fn thinner_end(&self) -> f64 {
        self.ends[0].min(self.ends[1])
    }

    /// `Delta_gamma` [m].
    pub fn deviation(&self) -> f64 {
        self.middle - self.thinner_end()
    }

    /// `h*` [m], `scale` [m] being the deviation that halves it.
    pub fn equivalent_film(&self, scale: f64) -> f64 {
        self.middle / (1.0 + (self.deviation().max(0.0) / scale).powi(2))
    }
}

/// The crown [m] for all bearings of a shaft; none without bearings.
pub fn common_crown(bearings: &[Sections]) -> Option<f64> {
    let middle = bearings.iter().map(|sections| sections.middle).reduce(f64::min)?;
    let end = bearings.iter().map(Sections::thinner_end).reduce(f64::min)?;
    Some(middle - end)
}
