//! # Extremes of the pressure, between nodes too, and of the film thickness
//!
//! **Equation.** `p_max`, `p_min`: extremes of the quadratic field, but that it undershoots beside a cavity, whose
//! pressure is the least there is; `mu_max = mu(p_max)`; `h_min = c - |e|` where the liner covers the angle of the minimum
//! film, else the least thickness at a node.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | p_max, p_min | Pa | `greatest`, `least` |
//! | mu_max | Pa s | `viscosity` |
//! | h_min | m | `least_thickness` |
//!
//! **Source.** Definition. **Range.** Beside the cavity of a mass-conserving film p_max is that of the nodes. Pressure grows with the unknown, so their extremes lie together.
//! **Verified by** the reference of the FlexPDE study and the closed forms.

use oilwedge_fem::Field;

use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Greatest and least pressure and the greatest viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// Greatest pressure of the field [Pa gauge].
    pub greatest: f64,
    /// Triangle that it lies in.
    pub greatest_in: usize,
    /// Least pressure of the field [Pa gauge].
    pub least: f64,
    /// Triangle that it lies in; none where it is that of a cavity.
    pub least_in: Option<usize>,
    /// Viscosity [Pa s] at the greatest pressure.
    pub viscosity: f64,
}

/// Extremes of the pressure. Pressure grows with the unknown, so they are those of the unknown.
pub fn extremes(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Extremes {
    let top = problem.greatest_unknown(system, film);
    let greatest = problem.pressure_at(top.value);
    let (least, least_in) = least(problem, system, film);
    Extremes {
        greatest,
        greatest_in: top.triangle,
        least,
        least_in,
        viscosity: problem.viscosity_at(greatest),
    }
}

/// Least pressure [Pa]: that of the cavity where there is one, and never below it; else also the triangle.
fn least(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> (f64, Option<usize>) {
    let floor = problem.cavitation.pressure();
    if let Some(pressure) = floor.filter(|_| film.cavity.contains(&true)) {
        return (pressure, None);
    }
    let field = Field {
        space: system.space(),
        values: &film.unknown,
    };
    let bottom = field.minimum();
    let least = problem.pressure_at(bottom.value);
    (floor.map_or(least, |floor| least.max(floor)), Some(bottom.triangle))
}

/// Least film thickness [m] over the mesh and where `phi_min` lies on the liner there.
///
/// The film is least at `phi_min` if the liner covers it, else at an edge: the nodes tell.
pub fn least_thickness(problem: &FilmProblem, system: &FilmSystem) -> f64 {
    let mesh = system.space().mesh();
    let covered = match mesh.period() {
        Some(_) => true,
        None => {
            let xs = mesh.points().iter().map(|point| point[0]);
            let (low, high) = xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            let x = problem.journal.min_film_angle() * problem.bearing.radius;
            let turn = std::f64::consts::TAU * problem.bearing.radius;
            (x - low).rem_euclid(turn) <= high - low
        }
    };
    if covered {
        return problem.bearing.least_gap(&problem.journal);
    }
    (0..mesh.triangles().len())
        .flat_map(|t| problem.thickness_at(t, &mesh.nodes(t)))
        .fold(f64::INFINITY, f64::min)
}
