//! # Extremes of the pressure, between nodes too, and of the film thickness
//!
//! **Equation.** `p_max`, `p_min`: extremes of the quadratic field, but that it undershoots beside a cavity, whose
//! pressure is the least there is; `mu_max = mu(p_max)`; `h_min = c - |e + z g|` at the end z where it is least, if the liner covers the angle of the
//! minimum film, else the least thickness at a node.
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
use crate::{FilmProblem, FilmSolution, FilmSystem, Thinnest};

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

/// Least film thickness over the mesh, and where it is.
///
/// At each end of the bearing the gap is least at one angle. If the liner covers that of the thinner end, the film is least there; else at the other end
/// or at an edge of the liner, where that of the nodes is taken.
pub fn thinnest(problem: &FilmProblem, system: &FilmSystem) -> Thinnest {
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    let mesh = system.space().mesh();
    let is_covered = |angle: f64| match mesh.period() {
        Some(_) => true,
        None => {
            let xs = mesh.points().iter().map(|point| point[0]);
            let (low, high) = xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            let x = angle * bearing.radius;
            let turn = std::f64::consts::TAU * bearing.radius;
            (x - low).rem_euclid(turn) <= high - low
        }
    };
    let thinnest = bearing.thinnest(journal);
    if is_covered(thinnest.angle) {
        return thinnest;
    }
    let at_nodes = (0..mesh.triangles().len()).flat_map(|t| {
        let nodes = mesh.nodes(t);
        problem.thickness_at(t, &nodes).into_iter().zip(nodes)
    });
    let at_nodes = at_nodes.map(|(thickness, [x, z])| Thinnest {
        thickness,
        angle: x / bearing.radius,
        z,
    });
    let other_end = (bearing.ends().into_iter())
        .map(|z| bearing.thinnest_at(journal, z))
        .filter(|place| is_covered(place.angle));
    let none = Thinnest {
        thickness: f64::INFINITY,
        angle: 0.0,
        z: 0.0,
    };
    other_end.chain(at_nodes).fold(none, |least, place| {
        if place.thickness < least.thickness {
            place
        } else {
            least
        }
    })
}
