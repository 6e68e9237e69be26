//! # Extremes of the pressure, between nodes too
//!
//! **Equation.** `p_max`, `p_min`: extremes of the quadratic field, but that it undershoots beside a cavity, whose
//! pressure is the least there is; `mu_max = mu(p_max)`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | p_max, p_min | Pa | `greatest`, `least` |
//! | mu_max | Pa s | [`Extremes::viscosity`] |
//!
//! **Source.** Definition. **Range.** Beside the cavity of a mass-conserving film p_max is that of the nodes. Pressure
//! grows with the unknown, so their extremes lie together.
//! **Verified by** the reference of the FlexPDE study and the closed forms.

use oilwedge_fem::Field;

use super::summit::{Summit, summit};
use crate::film_law::FilmLaw;
use crate::{FilmProblem, SolvedFilm};

/// Greatest and least pressure and the greatest viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// Greatest pressure of the field [Pa gauge].
    pub greatest: f64,
    /// Place and value of the greatest pressure.
    pub summit: Summit,
    /// Least pressure of the field [Pa gauge].
    pub least: f64,
    /// Triangle that it lies in; none where it is that of a cavity.
    pub least_in: Option<usize>,
    /// Viscosity [Pa s] of the oil at the place of the greatest pressure, but without pressure.
    unpressed: f64,
}

impl Extremes {
    /// Viscosity [Pa s] at a pressure [Pa] at the place of the greatest one.
    pub fn viscosity(&self, problem: &FilmProblem, pressure: f64) -> f64 {
        self.unpressed * problem.lubricant.pressure_law.viscosity_ratio(pressure)
    }
}

/// Extremes of the pressure. Pressure grows with the unknown, so they are those of the unknown.
pub fn extremes(film: &SolvedFilm) -> Extremes {
    let top = film.greatest_unknown();
    let greatest = film.problem.pressure_at(top.value);
    let (least, least_in) = least(film);
    let summit = summit(film, &top, least);
    let unpressed = FilmLaw::new(&film.problem, 1.0).film(top.triangle, &[summit.position])[0].viscosity;
    Extremes { greatest, summit, least, least_in, unpressed }
}

/// Least pressure [Pa]: that of the cavity where there is one, and never below it; else also the triangle.
fn least(film: &SolvedFilm) -> (f64, Option<usize>) {
    let floor = film.problem.cavitation.pressure();
    if let Some(pressure) = floor.filter(|_| film.solution.cavity.contains(&true)) {
        return (pressure, None);
    }
    let field = Field { space: film.system.space(), values: &film.solution.unknown };
    let bottom = field.minimum();
    let least = film.problem.pressure_at(bottom.value);
    (floor.map_or(least, |floor| least.max(floor)), Some(bottom.triangle))
}
