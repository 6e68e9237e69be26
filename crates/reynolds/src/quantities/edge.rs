//! # Oil that a cavity makes beside an end
//!
//! **Equation.** `Int (div(U h/2) + dh/dt) phi_i dA` over a Swift-Stieber cavity, for the nodes i where pressure is
//! given: the reaction there counts it, but nothing flows through an end beside a cavity. Where the edge of the cavity
//! runs through a triangle the integral goes over the part where the pressure is that of the cavity. Where Guembel
//! drops the pressure the reaction also counts `Int h^3/(12 mu) grad p . grad phi_i dA`, a flow that the pressure
//! dropped would drive. What is left is the oil that the journal drags. Where the pressure of the place is above that
//! of the cavity a film thinner than the triangle lies between them, and what is made there is a matter of the mesh:
//! all of it counts as unsure.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | made beside node i | m3/s | `made` |
//!
//! **Source.** Definition. **Range.** Swift-Stieber and Guembel films; zero for others. Without it the side flow would
//! be off by the oil made in a strip of half a triangle along the ends: some hundredths on common meshes.
//! **Verified by** the convergence of side flows in `docs/validation/accuracy.md`.

use oilwedge_fem::field::evaluate;
use oilwedge_fem::integrate::{Nodal, Rule};
use oilwedge_fem::{Field, Quadrature};

use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// Cells through which the edge of a cavity runs are quartered this many times.
const QUARTERINGS: usize = 3;

/// Oil made beside a node of given pressure.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct EdgeSource {
    /// Volume [m3/s].
    pub made: f64,
    /// The magnitude of what comes from triangles through which the edge of the cavity runs [m3/s].
    pub unsure: f64,
}

/// What the cavity makes beside each dof; zero at dofs whose pressure is not given.
pub(super) fn made_beside(film: &SolvedFilm) -> Vec<EdgeSource> {
    let SolvedFilm { problem, system, solution } = film;
    let space = system.space();
    let mut beside = vec![EdgeSource::default(); space.dofs()];
    let dropped = problem.cavitation.kink();
    let Some(pressure) = problem.cavitation.obstacle().or(dropped) else {
        return beside;
    };
    let floor = problem.unknown_at(pressure);
    let law = FilmLaw::new(problem, 1.0);
    let along = problem.theory.directions();
    let (mesh, degree) = (space.mesh(), space.degree());
    let plain = Rule::for_degree(degree);
    let fine = Quadrature::for_degree(degree).quartered(QUARTERINGS);
    for t in 0..mesh.triangles().len() {
        let dofs = space.element_dofs(t);
        let dofs = &dofs[..space.shapes()];
        let is_given = |dof: usize| system.supply.owner(dof).is_some();
        let is_low = |dof: usize| solution.cavity[dof] || dropped.is_some() && solution.unknown[dof] < floor;
        if !dofs.iter().any(|&dof| is_given(dof)) || !dofs.iter().any(|&dof| is_low(dof)) {
            continue;
        }
        let nodal = (Field { space, values: &solution.unknown }).element_values(t);
        // Quadratics are held amid edges only, and stay a little off the cavity pressure at vertices.
        let nodes = if degree == 2 { 3..6 } else { 0..dofs.len() };
        let broken = nodes.into_iter().all(|i| solution.cavity[dofs[i]] || nodal[i] <= floor);
        let inside =
            (!broken).then(|| Rule::new(fine.clone().only(|at| evaluate(degree, &nodal, at) <= floor), degree));
        let rule = inside.as_ref().unwrap_or(&plain);
        let made = rule.integrate(mesh, t, |points, made: &mut Nodal| {
            let flows = law.film_and_flows(t, points.positions).1;
            for (q, flow) in flows[..points.positions.len()].iter().enumerate() {
                let (conductance, along) = flow.parts(along);
                // In the cavity quadratics waver about its pressure; what that drives is none of the end's.
                let slope = if broken || dropped.is_some() { points.gradient(q, &nodal) } else { [0.0; 2] };
                let area = points.area(q);
                for (i, made) in made[..dofs.len()].iter_mut().enumerate() {
                    let [x, z] = points.shape_gradient(q, i);
                    let driven = conductance * (along[0] * slope[0] * x + along[1] * slope[1] * z);
                    *made += area * ((flow.storage + flow.divergence) * points.shapes(q)[i] + driven);
                }
            }
        });
        for (&dof, made) in dofs.iter().zip(made).filter(|(dof, _)| is_given(**dof)) {
            beside[dof].made += made;
            beside[dof].unsure += match dropped {
                // Between the place and what is dropped there is film, thinner than the triangle: how much of it is
                // dropped is a matter of the mesh.
                Some(_) if solution.unknown[dof] > floor => made.abs(),
                // Guembel's edge is a level of the pressure, known as well as that.
                Some(_) => 0.0,
                None if broken => 0.0,
                None => made.abs(),
            };
        }
    }
    beside
}
