//! The power that the journal puts in, as a goal: its vectors in cubic functions.
//!
//! `j_i = Int h/2 U . grad(phi_i) dA s_i` for pressure, s_i the secant of the pressure at node i between the two films,
//! and `j_i = Int |U|^2/h s phi_i dA` for shear, s the secant of the viscosity: nothing where that is constant. So the
//! difference of the two films times the vector is the change of the power, but for what the rules of integration add.

use oilwedge_fem::Field;
use oilwedge_fem::integrate::{Nodal, Points, Rule};
use oilwedge_fem::quadrature::Quadrature;

use crate::film_law::FilmLaw;
use crate::lubricant::PressureLaw;
use crate::{FilmPoint, FilmProblem, FilmSystem, SolvedFilm};

/// Steps of the unknown below this part of it are too small for a secant.
const SMALL: f64 = 1e-6;

/// Power of shear per area [W/m2] where the film has the pressure `p` [Pa].
pub(super) fn shear(problem: &FilmProblem, film: &FilmPoint, p: f64) -> f64 {
    let [x, z] = film.velocity;
    film.shear_viscosity * problem.lubricant.pressure_law.viscosity_ratio(p) * (x * x + z * z) / film.thickness
}

/// The power that the journal puts in, as goals.
pub(super) struct DragGoals {
    /// Vectors for shear and pressure [W/Pa]; zero for a journal at rest.
    pub(super) vectors: [Vec<f64>; 2],
    /// What the rules of integration for the two degrees differ by in the power of shear [W] of the cubic film: summed
    /// over triangles without sign, since the difference of the two powers is small by chance where it cancels. Zero
    /// for a journal at rest.
    pub(super) shear_rules: f64,
}

/// The goals between a film, whose `system` and unknown `raised` to cubic functions are given, and the `cubic` one.
pub(super) fn goals(film: &FilmSystem, cubic: &SolvedFilm, raised: &[f64]) -> DragGoals {
    let SolvedFilm { problem, system, solution } = cubic;
    let (space, better) = (system.space(), &solution.unknown[..]);
    let mut goals = DragGoals { vectors: [0, 1].map(|_| vec![0.0; space.dofs()]), shear_rules: 0.0 };
    let law = FilmLaw::new(problem, 1.0);
    let velocity = law.velocity();
    if velocity == [0.0; 2] {
        return goals;
    }
    let mesh = space.mesh();
    let is_film = system.supply.film(mesh);
    let [rule, other] =
        [space, film.space()].map(|space| Rule::new(Quadrature::for_degree(space.degree()), system.space().degree()));
    let thickens = !matches!(problem.lubricant.pressure_law, PressureLaw::Constant);
    let sheared = |points: &Points, q: usize, film: &FilmPoint, better: &Nodal| {
        let pressure = if thickens { problem.pressure_at(points.value(q, better)) } else { 0.0 };
        points.area(q) * shear(problem, film, pressure)
    };
    for t in (0..is_film.len()).filter(|&t| is_film[t]) {
        let nodal = [better, raised].map(|values| Field { space, values }.element_values(t));
        let (mut element, mut by_rules) = ([Nodal::default(); 2], [0.0; 2]);
        rule.visit(mesh, t, |points| {
            let film = law.film(t, points.positions);
            for (q, film) in film[..points.positions.len()].iter().enumerate() {
                let area = points.area(q);
                points.add_slopes(q, velocity.map(|u| area * 0.5 * film.thickness * u), &mut element[1]);
                by_rules[0] += sheared(points, q, film, &nodal[0]);
                if thickens {
                    let at_unknown = |u: f64| shear(problem, film, problem.pressure_at(u));
                    let [better, raised] = nodal.each_ref().map(|nodal| points.value(q, nodal));
                    let density = area * secant(&at_unknown, better, raised);
                    for (entry, value) in element[0].iter_mut().zip(points.shapes(q)) {
                        *entry += density * value;
                    }
                }
            }
        });
        other.visit(mesh, t, |points| {
            let film = law.film(t, points.positions);
            for (q, film) in film[..points.positions.len()].iter().enumerate() {
                by_rules[1] += sheared(points, q, film, &nodal[0]);
            }
        });
        goals.shear_rules += (by_rules[1] - by_rules[0]).abs();
        let dofs = &space.element_dofs(t)[..space.shapes()];
        for (goal, element) in goals.vectors.iter_mut().zip(&element) {
            for (&dof, entry) in dofs.iter().zip(element) {
                goal[dof] += entry;
            }
        }
    }
    for (goal, (&a, &b)) in goals.vectors[1].iter_mut().zip(better.iter().zip(raised)) {
        *goal *= secant(&|u| problem.pressure_at(u), a, b);
    }
    goals
}

/// Slope of a function between two values; about them where they are nearly the same.
fn secant(function: &dyn Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let least = SMALL * a.abs().max(b.abs()).max(1.0);
    let (a, b) = match (a - b).abs() > least {
        true => (a, b),
        false => (0.5 * (a + b) + least, 0.5 * (a + b) - least),
    };
    (function(a) - function(b)) / (a - b)
}
