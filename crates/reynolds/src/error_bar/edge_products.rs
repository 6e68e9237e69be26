//! # What the edge of a cavity leaves open of a tangent
//!
//! **Equation.** A tangent holds the cavity at its edge, where response u of the film and dual z of what it carries
//! both vanish. Where the edge lies a distance s off, the derivative of what is carried is off by (Hadamard)
//! ```text
//! Int s h^3/(12 mu0) du/dn dz/dn dl
//! ```
//! along the edge. Where it runs within a triangle T is not known, so that each triangle is off by a part of
//! ```text
//! a_T(u, z) = Int_T h^3/(12 mu0) grad u . grad z dA
//! ```
//! of either sign.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | u | unit of the unknown by that of the motion | `responses` |
//! | z | - | `duals` |
//!
//! **Source.** Delfour and Zolesio, Shapes and Geometries (2011), ch. 9. **Range.** Films with a free boundary that
//! hold no oil in their cavity. **Verified by** `tests/tests/dynamics`: how often bars of stiffness and damping hold.

use std::ops::AddAssign;

use oilwedge_fem::integrate::Rule;
use oilwedge_fem::{Field, integrate};

use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// Products of duals (rows) and responses (columns).
type Products = [[f64; 4]; 4];

/// The products of some triangles, one by one.
#[derive(Default)]
struct Listed(Vec<Products>);

impl AddAssign for Listed {
    fn add_assign(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

/// `a_T(u, z)` of each triangle T through which the edge of the cavity of a film runs, of at most four duals (rows) and
/// four responses (columns) that vanish where the film is held.
pub fn edge_products(film: &SolvedFilm, duals: &[Vec<f64>], responses: &[Vec<f64>]) -> Vec<[[f64; 4]; 4]> {
    let SolvedFilm { problem, system, solution } = film;
    let (space, mesh) = (system.space(), system.space().mesh());
    let rule = Rule::for_degree(space.degree());
    let law = FilmLaw::new(problem, 1.0);
    let along = problem.theory.directions();
    let has_edge = |t: usize| {
        let dofs = &space.element_dofs(t)[..space.shapes()];
        let is_free = |&dof: &usize| !solution.cavity[dof] && system.supply.owner(dof).is_none();
        dofs.iter().any(|&dof| solution.cavity[dof]) && dofs.iter().any(is_free)
    };
    integrate(mesh, |t| {
        if !has_edge(t) {
            return Listed::default();
        }
        let nodal = |values: &Vec<f64>| Field { space, values }.element_values(t);
        let duals: Vec<_> = duals.iter().map(nodal).collect();
        let responses: Vec<_> = responses.iter().map(nodal).collect();
        Listed(vec![rule.integrate(mesh, t, |points, products: &mut Products| {
            let flows = law.film_and_flows(points.cell, points.positions).1;
            for q in 0..points.positions.len() {
                let (conductance, along) = flows[q].parts(along);
                let weight = points.area(q) * conductance;
                for (row, dual) in products.iter_mut().zip(&duals) {
                    let [z_x, z_z] = points.gradient(q, dual);
                    for (entry, response) in row.iter_mut().zip(&responses) {
                        let [u_x, u_z] = points.gradient(q, response);
                        *entry += weight * (along[0] * u_x * z_x + along[1] * u_z * z_z);
                    }
                }
            }
        })])
    })
    .0
}
