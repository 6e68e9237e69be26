//! What is measured on a hill: integrals of `chi p`, whose area is that of the sharp front, and of the polynomial
//! itself.

use std::collections::HashMap;

use oilwedge_fem::field::Extremum;
use oilwedge_fem::integrate::Rule;
use oilwedge_fem::{Field, Space, integrate};

use crate::angles::sines_and_cosines;
use crate::quantities::contact;
use crate::quantities::load::{Share, cut_out_shares};
use crate::{FilmProblem, FilmSystem};

/// Numbers of a hill.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HillNumbers {
    /// Load, regions that are cut out and contact included.
    pub load: Share,
    /// The greatest pressure of the polynomial [Pa].
    pub greatest: f64,
}

impl HillNumbers {
    /// The numbers less others.
    pub(super) fn less(&self, other: &Self) -> Self {
        Self { load: self.load.less(&other.load), greatest: self.greatest - other.greatest }
    }
}

/// Measures the reduced pressure v [Pa] above that of the cavity, of which a part is `filled` at the quadrature points
/// of some triangles.
pub(super) fn measure(
    problem: &FilmProblem,
    system: &FilmSystem,
    v: &[f64],
    filled: &HashMap<usize, Vec<f64>>,
) -> HillNumbers {
    let (space, mesh): (&Space, _) = (system.space(), system.space().mesh());
    let floor = problem.cavity_unknown();
    let (p_e, radius) = (problem.bearing.end_pressure, problem.bearing.radius);
    let (rule, field) = (Rule::for_degree(space.degree()), Field { space, values: v });
    let mut load: Share = integrate(mesh, |t| {
        let (nodal, filled) = (field.element_values(t), filled.get(&t));
        let mut count = 0;
        rule.integrate(mesh, t, |points, sum: &mut Share| {
            let [sines, cosines] = sines_and_cosines(points.positions, radius);
            for q in 0..points.positions.len() {
                let area = points.area(q);
                let part = filled.map_or(1.0, |filled| filled[count]);
                count += 1;
                let p = problem.pressure_at(floor + part * points.value(q, &nodal));
                let thrust = area * (p - p_e);
                let force = [thrust * cosines[q], thrust * sines[q]];
                *sum += Share {
                    force,
                    moment: force.map(|part| points.positions[q][1] * part),
                    pressure: area * p,
                    possible: thrust.abs(),
                };
            }
        })
    });
    let cut_out = cut_out_shares(problem, system).into_iter().map(|(_, share)| share);
    for share in cut_out.chain(contact::share(problem, system)) {
        load += share;
    }
    let Extremum { value, .. } = field.maximum();
    HillNumbers { load, greatest: problem.pressure_at(floor + value) }
}
