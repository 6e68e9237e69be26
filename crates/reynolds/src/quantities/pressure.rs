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
//! | h_min | m | `thinnest` |
//!
//! **Source.** Definition. **Range.** Beside the cavity of a mass-conserving film p_max is that of the nodes. Pressure grows with the unknown, so their extremes lie together.
//! **Verified by** the reference of the FlexPDE study and the closed forms.

use oilwedge_fem::Field;

use super::summit::{Summit, summit};
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Greatest and least pressure and the greatest viscosity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extremes {
    /// Greatest pressure of the field [Pa gauge].
    pub greatest: f64,
    /// Where it is.
    pub summit: Summit,
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
        summit: summit(problem, system, film, &top, least),
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

/// The thinnest film on the liner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ThinnestFilm {
    /// Thickness [m].
    pub thickness: f64,
    /// Angle [rad] at which it is.
    pub angle: f64,
}

/// Least film thickness over the mesh, and where it is.
///
/// The film is least at `phi_min` if the liner covers it, else at an edge: that of the nodes is taken.
pub fn thinnest(problem: &FilmProblem, system: &FilmSystem) -> ThinnestFilm {
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
        return ThinnestFilm {
            thickness: problem.bearing.least_gap(&problem.journal),
            angle: problem.journal.min_film_angle(),
        };
    }
    let at_nodes = (0..mesh.triangles().len()).flat_map(|t| {
        let nodes = mesh.nodes(t);
        problem.thickness_at(t, &nodes).into_iter().zip(nodes)
    });
    let thinner = |least: ThinnestFilm, (thickness, [x, _]): (f64, [f64; 2])| match thickness < least.thickness {
        true => ThinnestFilm {
            thickness,
            angle: x / problem.bearing.radius,
        },
        false => least,
    };
    let none = ThinnestFilm {
        thickness: f64::INFINITY,
        angle: 0.0,
    };
    at_nodes.fold(none, thinner)
}
