//! # Wall that gives way to the pressure
//!
//! **Equation.** `h` grows by the deflection `d(phi, z)` of the wall, outwards; `d = C f`, `f = T p`, is a balance around the film. Motions of the wall are
//! slow: `dd/dt` is left out of a film at rest.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `coefficients`, of quadratic splines on [`crate::wall::Grid`] |
//! | C, T | m/N, m2 | [`crate::wall::Compliance`], [`crate::wall::Grid::forces`] |
//!
//! **Source.** Higginson, Proc. Inst. Mech. Eng. 180 (3B) (1965) 31 (elastic journal bearings); Dowson, Higginson, Elasto-hydrodynamic Lubrication (1966).
//! **Range.** Slopes of the wall far below one. **Verified by** `slopes_and_variations_match_differences` and `tests/tests/liner`.

use std::sync::Arc;

use super::FilmContribution;
use crate::journal_state::JournalState;
use crate::wall::Wall;
use crate::{FilmPoint, FilmProblem};

/// How a deflection was found.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Closing {
    /// What is left of `d - C f`, over d.
    pub residual: f64,
    /// Films solved with a deflection held.
    pub outer: usize,
    /// Products with the tangent.
    pub inner: usize,
}

/// The deflection of a wall.
#[derive(Debug, Clone)]
pub struct Deflection {
    /// The wall.
    pub wall: Arc<Wall>,
    /// Coefficients of the splines of its grid [m].
    pub coefficients: Arc<[f64]>,
    /// How it was found.
    pub closing: Closing,
}

impl Deflection {
    /// That of a wall without pressure.
    pub fn none(wall: Arc<Wall>) -> Self {
        Self {
            coefficients: vec![0.0; wall.grid.number()].into(),
            wall,
            closing: Closing::default(),
        }
    }

    /// Another deflection of this wall.
    #[must_use]
    pub fn with(&self, coefficients: Vec<f64>) -> Self {
        Self {
            wall: self.wall.clone(),
            coefficients: coefficients.into(),
            closing: self.closing,
        }
    }

    /// Its value [m] at positions [m] of the developed surface.
    pub fn at(&self, position: [f64; 2]) -> f64 {
        self.wall.grid.value(&self.coefficients, position)
    }
}

impl FilmContribution for Deflection {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        self.wall.grid.add(&self.coefficients, positions, film);
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(self.clone())
    }

    /// While the wall is not bent.
    fn keeps_circles(&self) -> bool {
        self.coefficients.iter().all(|&coefficient| coefficient == 0.0)
    }

    fn as_deflection(&self) -> Option<&Deflection> {
        Some(self)
    }
}

impl FilmProblem {
    /// The deflection of the wall; none where the wall is rigid.
    pub fn deflection(&self) -> Option<&Deflection> {
        self.film_thickness
            .iter()
            .find_map(|contribution| contribution.as_deflection())
    }

    /// This problem with its wall not bent.
    #[must_use]
    pub fn with_wall_at_rest(self) -> Self {
        let at_rest = self
            .deflection()
            .map(|deflection| Deflection::none(deflection.wall.clone()));
        self.deflected(at_rest.as_ref())
    }

    /// This problem with a deflection that was found so.
    #[must_use]
    pub fn closed_by(self, closing: Closing) -> Self {
        let deflection = self.deflection().map(|deflection| Deflection {
            closing,
            ..deflection.clone()
        });
        self.deflected(deflection.as_ref())
    }

    /// This problem with another deflection of its wall; unchanged where the wall is rigid.
    #[must_use]
    pub fn deflected(mut self, deflection: Option<&Deflection>) -> Self {
        let places = self
            .film_thickness
            .iter_mut()
            .filter(|contribution| contribution.as_deflection().is_some());
        if let Some(deflection) = deflection {
            places.for_each(|place| *place = Arc::new(deflection.clone()));
        }
        self
    }
}
