//! # Squeeze: a film that grows takes oil up
//!
//! **Equation.** `div J + dh/dt = 0`; the storage is `dh/dt` [m/s].
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | dh/dt | m/s | `film.rate` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157, eq. 16. **Range.** Inertialess: c^2 omega rho/mu well
//! below one.
//! **Verified by** the closed form in `tests/tests/literature/ocvirk_1952.rs` and Butenschoen's table of radial motion.

use super::Term;
use crate::{FilmFlow, FilmPoint};

/// The thickness changes with time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Squeeze;

impl Term for Squeeze {
    fn name(&self) -> &'static str {
        "squeeze"
    }

    fn add(&self, film: &FilmPoint, flow: &mut FilmFlow) {
        flow.storage += film.rate;
    }

    fn vary(&self, _film: &FilmPoint, change: &FilmPoint, flow: &mut FilmFlow) {
        flow.storage += change.rate;
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn variation_matches_differences() {
        super::super::check(&super::Squeeze);
    }
}
