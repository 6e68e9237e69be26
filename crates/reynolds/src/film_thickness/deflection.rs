//! # Wall that gives way to the pressure
//!
//! **Equation.** `h` grows by the deflection `d(phi, z)` of the wall, outwards; `d = C f`, `f = T p`, is a balance
//! around the film. In a film at rest `dd/dt` is left out; in an implicit stage of a method in time `dh/dt` grows by
//! `dd/dt = (d - d_0)/(gamma dt)`, d_0 being what earlier stages leave.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `coefficients`, of quadratic splines on [`crate::wall::Grid`] |
//! | 1/(gamma dt), d_0 | 1/s, m | [`WallStage`] |
//! | C, T | m/N, m2 | [`crate::wall::Compliance`], [`crate::wall::Grid::forces`] |
//!
//! **Source.** Higginson, Proc. Inst. Mech. Eng. 180 (3B) (1965) 31 (elastic journal bearings); Dowson, Higginson,
//! Elasto-hydrodynamic Lubrication (1966).
//! **Range.** Slopes of the wall far below one. **Verified by** `slopes_and_variations_match_differences` and
//! `tests/tests/liner`.

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

/// An implicit stage of a method in time, in which a wall moves by `dd/dt = (d - d_0)/(gamma dt)`.
#[derive(Debug, Clone, PartialEq)]
pub struct WallStage {
    /// `1/(gamma dt)` [1/s].
    pub per_time: f64,
    /// Coefficients d_0 that earlier stages leave [m].
    pub known: Arc<[f64]>,
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
    /// The stage in which it moves; none of a wall at rest, and of one whose rate is held.
    stage: Option<WallStage>,
    /// Coefficients of `dd/dt` [m/s]; none of a wall at rest.
    rate: Option<Arc<[f64]>>,
}

/// Two deflections are alike where they are of one shape and move alike, however they were found.
impl PartialEq for Deflection {
    fn eq(&self, other: &Self) -> bool {
        self.coefficients == other.coefficients && self.stage == other.stage && self.rate == other.rate
    }
}

impl Deflection {
    /// The deflection of a wall without pressure.
    pub fn none(wall: Arc<Wall>) -> Self {
        Self {
            coefficients: vec![0.0; wall.grid.number()].into(),
            wall,
            closing: Closing::default(),
            stage: None,
            rate: None,
        }
    }

    /// A deflection of the same wall with other coefficients [m]: in the same stage, or at the same rate.
    #[must_use]
    pub fn with(&self, coefficients: Vec<f64>) -> Self {
        let moving = |stage: &WallStage| {
            let way = coefficients.iter().zip(&*stage.known);
            way.map(|(d, known)| stage.per_time * (d - known)).collect()
        };
        Self {
            wall: self.wall.clone(),
            closing: self.closing,
            rate: self.stage.as_ref().map(moving).or_else(|| self.rate.clone()),
            stage: self.stage.clone(),
            coefficients: coefficients.into(),
        }
    }

    /// The sum of this deflection and these coefficients [m].
    #[must_use]
    pub fn with_more(&self, more: &[f64]) -> Self {
        let mut sum = self.coefficients.to_vec();
        sum.iter_mut().zip(more).for_each(|(d, more)| *d += more);
        self.with(sum)
    }

    /// A change of this deflection by `coefficients` [m]: in a stage its rate changes too.
    #[must_use]
    pub fn change(&self, coefficients: Vec<f64>) -> Self {
        let nothing = |stage: &WallStage| WallStage { known: vec![0.0; coefficients.len()].into(), ..*stage };
        let stage = self.stage.as_ref().map(nothing);
        let rate = None;
        Self { stage, rate, ..self.clone() }.with(coefficients)
    }

    /// The deflection in a stage of a time step.
    #[must_use]
    pub fn in_stage(&self, stage: WallStage) -> Self {
        let stage = Some(stage);
        Self { stage, ..self.clone() }.with(self.coefficients.to_vec())
    }

    /// The stage of a method in time that begins with this deflection: `per_time` is its `1/(gamma dt)` [1/s].
    pub fn resting(&self, per_time: f64) -> WallStage {
        WallStage { per_time, known: self.coefficients.clone() }
    }

    /// This wall at the rate that it has, whatever its deflection: in no stage.
    #[must_use]
    pub fn at_its_rate(&self) -> Self {
        let stage = None;
        Self { stage, ..self.clone() }
    }

    /// The deflection at a rate that is higher by these coefficients [m/s].
    #[must_use]
    pub fn faster(&self, more: &[f64]) -> Self {
        let rate = match &self.rate {
            None => more.into(),
            Some(rate) => rate.iter().zip(more).map(|(rate, more)| rate + more).collect(),
        };
        let rate = Some(rate);
        Self { rate, ..self.clone() }
    }

    /// Growth of the deflection's rate with the deflection [1/s]: zero in no stage.
    pub fn per_time(&self) -> f64 {
        self.stage.as_ref().map_or(0.0, |stage| stage.per_time)
    }

    /// Greatest difference [m] of the coefficients of two deflections of a wall.
    pub fn distance(&self, other: &Self) -> f64 {
        let pairs = self.coefficients.iter().zip(&*other.coefficients);
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// Coefficients of `dd/dt` [m/s]; none of a wall at rest.
    pub fn rate(&self) -> Option<&Arc<[f64]>> {
        self.rate.as_ref()
    }

    /// Deflection [m] at a position [m] of the developed surface.
    pub fn at(&self, position: [f64; 2]) -> f64 {
        self.wall.grid.value(&self.coefficients, position)
    }
}

impl FilmContribution for Deflection {
    fn add(&self, _journal: &JournalState, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        self.wall.grid.add(&self.coefficients, positions, film);
        if let Some(rate) = &self.rate {
            self.wall.grid.add_rate(rate, positions, film);
        }
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(self.clone())
    }

    /// Circles are kept while the wall is not bent.
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
        self.film_thickness.iter().find_map(|contribution| contribution.as_deflection())
    }

    /// Whether its wall gives way, and has done so.
    pub fn has_bent_wall(&self) -> bool {
        let is_bent = |deflection: &Deflection| deflection.coefficients.iter().any(|d| *d != 0.0);
        self.deflection().is_some_and(is_bent)
    }

    /// The problem with its wall not bent.
    #[must_use]
    pub fn with_wall_at_rest(self) -> Self {
        let at_rest = self.deflection().map(|deflection| Deflection::none(deflection.wall.clone()));
        self.deflected(at_rest.as_ref())
    }

    /// This problem with its wall at the rate that it has, whatever its deflection.
    #[must_use]
    pub fn with_wall_at_its_rate(self) -> Self {
        let held = self.deflection().map(Deflection::at_its_rate);
        self.deflected(held.as_ref())
    }

    /// The problem with a deflection that was found so.
    #[must_use]
    pub fn closed_by(self, closing: Closing) -> Self {
        let deflection = self.deflection().map(|deflection| Deflection { closing, ..deflection.clone() });
        self.deflected(deflection.as_ref())
    }

    /// This problem with another deflection of its wall; unchanged where the wall is rigid.
    #[must_use]
    pub fn deflected(mut self, deflection: Option<&Deflection>) -> Self {
        let places = self.film_thickness.iter_mut().filter(|contribution| contribution.as_deflection().is_some());
        if let Some(deflection) = deflection {
            places.for_each(|place| *place = Arc::new(deflection.clone()));
        }
        self
    }
}
