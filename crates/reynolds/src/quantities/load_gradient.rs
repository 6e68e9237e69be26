//! # Change of the load as a linear form: of the unknown at each dof, and of the wall
//!
//! **Equation.** `dW = Int p'(u) du (cos phi, sin phi) dA + Int p_a'(h) dd (cos phi, sin phi) dA`, with z under the
//! integrals for the moment: a sum over dofs and over the splines of the wall. An iteration that asks for many changes
//! at one film integrates once.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | dW, dm | N, N m | [`LoadGradient::change`] |
//! | du | Pa | `unknown` |
//! | dd | m | `wall` |
//!
//! **Source.** The first-order change of [`super::load`]. **Range.** Any film; small changes. **Verified by**
//! `the_gradient_of_the_load_is_its_change`: it is [`super::load::load_change`].

use std::ops::AddAssign;

use oilwedge_fem::lagrange::MOST_SHAPES;
use oilwedge_fem::{Field, KinkRule, integrate};

use super::contact_points::ContactPoints;
use super::load::Resultant;
use crate::SolvedFilm;
use crate::angles::sines_and_cosines;

/// Force towards x and y, and its moments: for a unit of a change.
type ForceParts = [f64; 4];

/// How force and moment on the journal change with a film and its wall, to first order.
#[derive(Debug, Clone)]
pub struct LoadGradient {
    /// Derivatives by the unknown at each dof [m2, m3].
    by_unknown: Vec<ForceParts>,
    /// Derivatives by the coefficient of each spline of the wall, by contact [N/m, N]; empty where there is none.
    by_wall: Vec<ForceParts>,
}

/// Derivatives by the unknown at the nodes of some triangles.
#[derive(Debug, Default)]
struct ByNodes(Vec<(usize, [ForceParts; MOST_SHAPES])>);

impl AddAssign for ByNodes {
    fn add_assign(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

impl LoadGradient {
    /// The gradient at a film, with its points of contact where surfaces touch.
    pub fn of(film: &SolvedFilm, contact: Option<&ContactPoints>) -> Self {
        Self { by_unknown: by_unknown(film), by_wall: contact.map_or_else(Vec::new, ContactPoints::load_by_wall) }
    }

    /// The gradient of one part, force towards x or y or its moment: by the unknown at each dof, and by the coefficient
    /// of each spline of the wall; the latter is empty where surfaces do not touch.
    pub fn of_part(&self, part: usize) -> [Vec<f64>; 2] {
        [&self.by_unknown, &self.by_wall].map(|by| by.iter().map(|parts| parts[part]).collect())
    }

    /// Where the unknown changes by `unknown` at each dof, and the deflection by coefficients `wall` [m].
    pub fn change(&self, unknown: &[f64], wall: &[f64]) -> Resultant {
        let mut sum = ForceParts::default();
        for (parts, change) in [(&self.by_unknown, unknown), (&self.by_wall, wall)] {
            for (parts, change) in parts.iter().zip(change) {
                sum.iter_mut().zip(parts).for_each(|(sum, part)| *sum += change * part);
            }
        }
        let [x, y, m_x, m_y] = sum;
        Resultant { force: [x, y], moment: [m_x, m_y] }
    }
}

fn by_unknown(film: &SolvedFilm) -> Vec<ForceParts> {
    let SolvedFilm { problem, system, solution } = film;
    let (space, mesh) = (system.space(), system.space().mesh());
    let rule = KinkRule::for_degree(space.degree());
    let unknown = Field { space, values: &solution.unknown };
    let by_nodes = integrate(mesh, |t| {
        let nodal = unknown.element_values(t);
        let mut parts = [ForceParts::default(); MOST_SHAPES];
        rule.visit(mesh, t, problem.kink([&nodal]), |points| {
            let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
            for q in 0..points.positions.len() {
                let thrust = points.area(q) * problem.pressure_slope_at(points.value(q, &nodal));
                let [x, y] = [thrust * cosines[q], thrust * sines[q]];
                let arm = points.positions[q][1];
                for (parts, shape) in parts.iter_mut().zip(points.shapes(q)) {
                    let here = [x, y, arm * x, arm * y];
                    parts.iter_mut().zip(here).for_each(|(sum, part)| *sum += shape * part);
                }
            }
        });
        ByNodes(vec![(t, parts)])
    });
    let mut by_unknown = vec![ForceParts::default(); space.dofs()];
    for (t, parts) in by_nodes.0 {
        for (dof, parts) in space.element_dofs(t).into_iter().zip(parts).take(space.shapes()) {
            let sums = &mut by_unknown[dof];
            sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
    }
    by_unknown
}
