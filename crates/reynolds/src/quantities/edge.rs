//! # Oil that a cavity makes beside an end
//!
//! **Equation.** `Int (div(U h/2) + dh/dt) phi_i dA` over a Swift-Stieber cavity, for the nodes i where pressure is given: the
//! reaction there counts it, but nothing flows through an end beside a cavity. Where the edge of the cavity runs through a triangle
//! the integral goes over the part where the pressure is that of the cavity.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | made beside node i | m3/s | `made` |
//!
//! **Source.** Definition. **Range.** Swift-Stieber films; zero for others. Without it the side flow would be off by the
//! oil made in a strip of half a triangle along the ends: some hundredths on common meshes. **Verified by** the convergence of side flows in
//! `docs/validation/accuracy.md`.

use oilwedge_fem::field::evaluate;
use oilwedge_fem::lagrange::{self, MOST_SHAPES};
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{Field, Quadrature};

use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Cells through which the edge of a cavity runs are quartered this many times.
const QUARTERINGS: usize = 3;

/// Oil made beside a node of given pressure.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Beside {
    /// Volume [m3/s].
    pub made: f64,
    /// The magnitude of what comes from triangles through which the edge of the cavity runs [m3/s].
    pub unsure: f64,
}

/// What the cavity makes beside each dof; zero at dofs whose pressure is not given.
pub(super) fn made_beside(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Vec<Beside> {
    let space = system.space();
    let mut beside = vec![Beside::default(); space.dofs()];
    let Some(pressure) = problem.cavitation.obstacle() else {
        return beside;
    };
    let floor = problem.unknown_at(pressure);
    let law = FilmLaw::new(problem, 1.0);
    let along = problem.theory.directions();
    let rule = Quadrature::for_degree(space.degree());
    let fine = rule.quartered(QUARTERINGS);
    let (mut values, mut gradients) = ([0.0; MOST_SHAPES], [[0.0; 2]; MOST_SHAPES]);
    for t in 0..space.mesh().triangles().len() {
        let dofs = space.element_dofs(t);
        let dofs = &dofs[..space.shapes()];
        let is_given = |dof: usize| system.supply.owner(dof).is_some();
        if !dofs.iter().any(|&dof| is_given(dof)) || !dofs.iter().any(|&dof| film.cavity[dof]) {
            continue;
        }
        let nodal = (Field {
            space,
            values: &film.unknown,
        })
        .element_values(t);
        // Quadratics are held amid edges only, and stay a little off the cavity pressure at vertices.
        let asked = if space.degree() == 2 { 3..6 } else { 0..dofs.len() };
        let broken = asked.into_iter().all(|i| film.cavity[dofs[i]] || nodal[i] <= floor);
        let mapping = Mapping::of(space.mesh(), t);
        let mut made = [0.0; MOST_SHAPES];
        let rule = if broken { &rule } else { &fine };
        let points = rule.points.iter().zip(&rule.weights);
        let inside: Vec<_> = points
            .filter(|(point, _)| broken || evaluate(space.degree(), &nodal, **point) <= floor)
            .collect();
        for inside in inside.chunks(MOST_POINTS) {
            let places: Vec<_> = inside.iter().map(|(point, _)| mapping.at(**point)).collect();
            let positions: Vec<_> = places.iter().map(|place| place.position).collect();
            let flows = law.film_and_flows(t, &positions).1;
            for (((point, weight), place), flow) in inside.iter().zip(&places).zip(&flows) {
                lagrange::values(space.degree(), **point, &mut values[..dofs.len()]);
                lagrange::gradients(space.degree(), **point, &mut gradients[..dofs.len()]);
                // In the cavity quadratics waver about its pressure; what that drives is none of the end's.
                let slope = if broken { slope(&nodal, &gradients) } else { [0.0; 2] };
                let slope = place.gradient(slope);
                let area = *weight * place.determinant;
                for (i, made) in made[..dofs.len()].iter_mut().enumerate() {
                    let [x, z] = place.gradient(gradients[i]);
                    let driven = flow.conductance * (along[0] * slope[0] * x + along[1] * slope[1] * z);
                    *made += area * ((flow.storage + flow.divergence) * values[i] + driven);
                }
            }
        }
        for (&dof, made) in dofs.iter().zip(made).filter(|(dof, _)| is_given(**dof)) {
            beside[dof].made += made;
            beside[dof].unsure += if broken { 0.0 } else { made.abs() };
        }
    }
    beside
}

/// Gradient in reference coordinates.
fn slope(nodal: &[f64; MOST_SHAPES], gradients: &[[f64; 2]; MOST_SHAPES]) -> [f64; 2] {
    let along = |d: usize| nodal.iter().zip(gradients).map(|(u, gradient)| u * gradient[d]).sum();
    [along(0), along(1)]
}
