//! # How turbulent a film is
//!
//! **Equation.** `Re = rho U h/mu` at each place; the shear of the whole film over that of a laminar one,
//! `Int theta C mu U^2/h dA / Int theta mu U^2/h dA`, C that of [`crate::flow_factors::TurbulenceModel`].
//!
//! **Source.** Ng, Pan, Trans. ASME J. Basic Eng. 87 (1965) 675. **Range.** Turbulent films; a laminar one has neither.
//! **Verified by** `tests/tests/turbulence`.

use super::power::power;
use crate::film_law::{AtPoints, FilmLaw};
use crate::flow_factors::reynolds_number;
use crate::{FilmProblem, SolvedFilm};

/// Numbers of a turbulent film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurbulentFilm {
    /// Greatest Reynolds number [1] at the nodes of the film.
    pub greatest: f64,
    /// How far above that it may be between nodes [1].
    pub unsure: f64,
    /// Shear over that of a laminar film [1]; none at rest.
    pub shear: Option<f64>,
}

/// Reynolds numbers [1] at positions [m] in triangle `cell`.
pub fn reynolds_numbers(problem: &FilmProblem, cell: usize, positions: &[[f64; 2]]) -> AtPoints<f64> {
    let film = FilmLaw::new(problem, 1.0).film(cell, positions);
    film.map(|point| if point.viscosity > 0.0 { reynolds_number(&point, problem.lubricant.density) } else { 0.0 })
}

/// The numbers of a film; none of a laminar one.
pub fn turbulent_film(film: &SolvedFilm) -> Option<TurbulentFilm> {
    if film.problem.is_laminar() {
        return None;
    }
    let mesh = film.system.space().mesh();
    let is_film = film.system.supply.film(mesh);
    let (mut greatest, mut unsure) = (0.0, 0.0);
    for t in (0..is_film.len()).filter(|&t| is_film[t]) {
        let at = reynolds_numbers(&film.problem, t, &mesh.nodes(t));
        let highest = at[..6].iter().copied().fold(0.0, f64::max);
        if highest > greatest {
            // A parabola through three points rises above all of them by a quarter of its bend amid them at most.
            let bend = |k: usize| (0.5 * (at[k] + at[(k + 1) % 3]) - at[3 + k]).abs();
            (greatest, unsure) = (highest, 0.25 * (bend(0) + bend(1) + bend(2)));
        }
    }
    let laminar = FilmProblem { flow_factors: Vec::new(), ..film.problem.clone() };
    let of_laminar = power(&SolvedFilm { problem: laminar, ..film.clone() }).shear;
    let shear = (of_laminar > 0.0).then(|| power(film).shear / of_laminar);
    Some(TurbulentFilm { greatest, unsure, shear })
}
