//! The shares of the film in the difference of two degrees.
//!
//! With `e = p3 - p2`, the goal's vector j and the quadratic dual z, for any z, split exactly:
//! `j . e = z . K e + (j - K z) . e`. The first term is local because z stands before a residual, the second because e
//! is small where j - K z is not. In the hierarchical basis each product belongs to a function, and is shared equally
//! among the triangles that it lives on.

use oilwedge_fem::integrate::Nodal;
use oilwedge_fem::matrix::AT_ONCE;
use oilwedge_fem::prolongation::Hierarchical;
use oilwedge_fem::{Error, Field, KinkRule, Matrix};

use super::drag::DragGoals;
use super::following::{FollowingWall, GOALS};
use super::{FilmError, FlowGoal, GoalError, drag, geometry};
use crate::angles::sines_and_cosines;
use crate::quantities::load::{Share, possible_load};
use crate::supply::{BoundaryKind, SupplyRegion};
use crate::{FilmPoint, FilmProblem, FilmSystem, Form, SolvedFilm};

/// Angles of the film [rad] from which on a corner spoils the order: 225 degrees. The sides of a round hole turn by
/// less.
const REENTRANT: f64 = 1.25 * std::f64::consts::PI;
/// All around a vertex inside the film [rad], but for rounding.
const WHOLE: f64 = 1.99 * std::f64::consts::PI;
/// An edge of the film that turns by less [rad] is straight.
const STRAIGHT: f64 = 0.02;
/// The thickness of a film jumps where those of two triangles at a vertex differ by more than this part.
const JUMP: f64 = 1e-9;

pub(super) fn film_error(
    film: &SolvedFilm,
    cubic: &SolvedFilm,
    carried: &Share,
    following: Option<&FollowingWall>,
) -> Result<FilmError, Error> {
    let SolvedFilm { problem, system, solution } = film;
    let raised = system.cubic().prolongation.prolong(&solution.unknown);
    let split = Split::new(film, cubic, &raised);
    let vectors = GoalVectors { cubic, raised: &raised, following };
    let [x, y, thrust] = vectors.of(|WeighingPoint { cos, sin, mu, .. }| [cos + mu[0], sin + mu[1], 1.0]);
    let tilting =
        problem.can_tilt().then(|| vectors.of(|WeighingPoint { cos, sin, z, mu }| [z * cos + mu[2], z * sin + mu[3]]));
    let DragGoals { vectors: of_drag, shear_rules } = drag::goals(system, cubic, &raised);
    let loads = [x, y, thrust].into_iter().chain(tilting.into_iter().flatten());
    let mut judged = split.errors(of_drag.into_iter().chain(loads).collect())?.into_iter();
    let mut next = |given: geometry::RimWeight| {
        let (dual, error) = judged.next().expect("as many errors as goals");
        GoalError { geometry: geometry::rims(film, &dual, given), ..error }
    };
    let drag = [
        next(&|region, _, film| drag::shear(problem, film, region.pressure)),
        // Pressure is even along a rim: the film that is too large and the drag on its edge cancel.
        next(&|_, _, _| 0.0),
    ];
    // What is cut out counts with its circle if it has one, else with the element edges; it presses on no wall.
    let mut load = |part: Option<usize>, weight: &dyn Fn(&SupplyRegion, [f64; 2]) -> f64| {
        next(&|region: &SupplyRegion, [x, z]: [f64; 2], _: &FilmPoint| {
            let carried = match region.disc {
                None => 0.0,
                Some(_) => weight(region, [x / problem.bearing.radius, z]),
            };
            let following = following.zip(part).map_or(0.0, |(wall, part)| wall.at([x, z])[part]);
            carried + following * region.pressure
        })
    };
    let excess = |region: &SupplyRegion| region.pressure - problem.bearing.end_pressure;
    let goals = [
        load(Some(0), &|region, [angle, _]| excess(region) * angle.cos()),
        load(Some(1), &|region, [angle, _]| excess(region) * angle.sin()),
        load(None, &|region, _| region.pressure),
    ];
    let moments = problem.can_tilt().then(|| {
        [
            load(Some(2), &|region, [angle, z]| excess(region) * z * angle.cos()),
            load(Some(3), &|region, [angle, z]| excess(region) * z * angle.sin()),
        ]
    });
    let flows = split.flows()?;
    let (front, deep) = front(cubic);
    let [corner, bend] = corners(problem, system);
    Ok(FilmError {
        possible: possible_load(problem, carried),
        force: carried.force,
        moment: carried.moment,
        goals,
        moments,
        drag,
        shear_rules,
        flows,
        is_smooth: problem.has_linear_pressure() && !front.contains(&true),
        front,
        deep,
        corner,
        bend,
        nonlinear: problem.form == Form::AsPrinted,
    })
}

/// The difference of the two films, ready to be weighed by duals.
struct Split<'a> {
    film: &'a SolvedFilm,
    stiffness: &'a Matrix,
    /// `K e`, tested with quadratic functions.
    reaction: Vec<f64>,
    /// `e`.
    difference: Hierarchical,
    /// What the equation of the cubic film leaves at free dofs.
    residual: Vec<f64>,
}

impl<'a> Split<'a> {
    /// The shares of the difference between the film and the `cubic` one; `raised` is the film in cubic functions.
    fn new(film: &'a SolvedFilm, cubic: &'a SolvedFilm, raised: &[f64]) -> Self {
        let cubic = &cubic.solution;
        let between = &film.system.cubic().prolongation;
        let e: Vec<f64> = cubic.unknown.iter().zip(raised).map(|(p3, p2)| p3 - p2).collect();
        let stiffness = cubic.linearisation.matrix();
        let residuals = cubic.inflow.iter().zip(&cubic.linearisation.constraints().fixed);
        Self {
            film,
            stiffness,
            reaction: between.restrict(&stiffness.multiply(&e)),
            difference: between.split(&e),
            residual: residuals.map(|(&r, &fixed)| if fixed { 0.0 } else { r }).collect(),
        }
    }

    /// The errors of the flows through both ends together, and through each region that gives a pressure.
    fn flows(&self) -> Result<Vec<(FlowGoal, GoalError)>, Error> {
        let supply = &self.film.system.supply;
        let giving = supply.regions().iter().enumerate().filter(|(_, region)| region.kind != BoundaryKind::Sealed);
        // Both films weigh their residuals with this one function, up to one that is orthogonal to that of the cubic
        // film.
        let goal = |(k, _): (usize, _)| {
            let chi: Vec<f64> = (0..self.film.solution.unknown.len())
                .map(|dof| f64::from(u8::from(supply.owner(dof) == Some(k))))
                .collect();
            // Symmetric: by the few rows at the region rather than by all columns.
            self.stiffness.multiply_transposed(&self.film.system.cubic().prolongation.prolong(&chi))
        };
        let errors = self.errors(giving.clone().map(goal).collect())?;
        let mut both = GoalError::default();
        let mut flows = Vec::new();
        for ((_, region), (_, error)) in giving.zip(errors) {
            if region.kind == BoundaryKind::End {
                both = both.plus(1.0, &error);
            }
            flows.push((FlowGoal::Region(region.name.clone()), error));
        }
        flows.push((FlowGoal::Ends, both));
        Ok(flows)
    }

    /// The duals of goals with these vectors, and their errors but for the geometry.
    fn errors(&self, goals: Vec<Vec<f64>>) -> Result<Vec<(Vec<f64>, GoalError)>, Error> {
        let SolvedFilm { system, solution, .. } = self.film;
        let between = &system.cubic().prolongation;
        let mut errors: Vec<Option<(Vec<f64>, GoalError)>> = vec![None; goals.len()];
        let goals = errors.iter_mut().zip(goals).filter(|(_, goal)| goal.iter().any(|&entry| entry != 0.0));
        for some in goals.collect::<Vec<_>>().chunks_mut(AT_ONCE) {
            let dual = |(_, goal): &(_, Vec<f64>)| solution.linearisation.apply_factor(between.restrict(goal), true);
            let duals = some.iter().map(dual).collect::<Result<Vec<_>, Error>>()?;
            let mut raised = vec![[0.0; AT_ONCE]; self.residual.len()];
            for (k, dual) in duals.iter().enumerate() {
                raised.iter_mut().zip(between.prolong(dual)).for_each(|(raised, z)| raised[k] = z);
            }
            let images = self.stiffness.multiply_at_once(&raised);
            for (k, ((error, goal), dual)) in some.iter_mut().zip(duals).enumerate() {
                goal.iter_mut().zip(&images).for_each(|(j, kz)| *j -= kz[k]);
                let of_goal = self.error(&dual, raised.iter().map(|z| z[k]), goal);
                **error = Some((dual, of_goal));
            }
        }
        let of_nothing = || {
            let shares = vec![0.0; system.space().mesh().triangles().len()];
            (vec![0.0; system.space().dofs()], GoalError { shares, ..GoalError::default() })
        };
        Ok(errors.into_iter().map(|error| error.unwrap_or_else(of_nothing)).collect())
    }

    /// The error of a goal with this `dual`, `raised` to cubic functions, of whose vector j this is `left`: j - K z.
    fn error(&self, dual: &[f64], raised: impl Iterator<Item = f64>, left: &[f64]) -> GoalError {
        let between = &self.film.system.cubic().prolongation;
        let mut products = self.difference.times(&between.test(left));
        for (product, (z, reaction)) in products.quadratic.iter_mut().zip(dual.iter().zip(&self.reaction)) {
            *product += z * reaction;
        }
        let parts = self.residual.iter().zip(raised).map(|(r, z)| -r * z);
        let (algebra, squares) = parts.fold((0.0, 0.0), |(sum, squares), part| (sum + part, squares + part * part));
        GoalError { shares: between.shared(&products), geometry: 0.0, algebra, scatter: squares.sqrt() }
    }
}

/// What the vectors of goals in cubic functions are made of.
struct GoalVectors<'a> {
    cubic: &'a SolvedFilm,
    /// The unknown of the film, in cubic functions.
    raised: &'a [f64],
    /// The wall, if it gives way.
    following: Option<&'a FollowingWall>,
}

/// Point at which a goal is weighed.
struct WeighingPoint {
    cos: f64,
    sin: f64,
    /// Axial position [m].
    z: f64,
    /// What the wall adds to the weights of force and moment.
    mu: [f64; GOALS],
}

impl GoalVectors<'_> {
    /// `Int s phi_i w dA` for each cubic function, with the secant s of the pressure between the two films, for weights
    /// w.
    fn of<const N: usize>(&self, weights: impl Fn(WeighingPoint) -> [f64; N]) -> [Vec<f64>; N] {
        let (SolvedFilm { problem, system, solution }, following) = (self.cubic, self.following);
        let (space, mesh) = (system.space(), system.space().mesh());
        let rule = KinkRule::for_degree(space.degree());
        let is_linear = problem.has_linear_pressure();
        let mut goals = [(); N].map(|()| vec![0.0; space.dofs()]);
        for t in 0..mesh.triangles().len() {
            let dofs = &space.element_dofs(t)[..space.shapes()];
            let [p3, p2] = [&solution.unknown, self.raised].map(|values| Field { space, values }.element_values(t));
            let mut element = [Nodal::default(); N];
            rule.visit(mesh, t, problem.kink([&p3, &p2]), |points| {
                let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
                for q in 0..points.positions.len() {
                    let slope = match is_linear {
                        true => 1.0,
                        false => secant(problem, points.value(q, &p3), points.value(q, &p2)),
                    };
                    let area = points.area(q) * slope;
                    let position = points.positions[q];
                    let weights = weights(WeighingPoint {
                        cos: cosines[q],
                        sin: sines[q],
                        z: position[1],
                        mu: following.map_or([0.0; GOALS], |wall| wall.at(position)),
                    });
                    for (goal, weight) in element.iter_mut().zip(weights) {
                        let weight = area * weight;
                        for (entry, shape) in goal.iter_mut().zip(points.shapes(q)) {
                            *entry += weight * shape;
                        }
                    }
                }
            });
            for (goal, element) in goals.iter_mut().zip(&element) {
                for (&dof, entry) in dofs.iter().zip(element) {
                    goal[dof] += entry;
                }
            }
        }
        goals
    }
}

/// Slope of the pressure that the film exerts, between two values of the unknown.
fn secant(problem: &FilmProblem, a: f64, b: f64) -> f64 {
    let step = a - b;
    match step.abs() > 1e-6 * a.abs().max(b.abs()) {
        true => (problem.pressure_at(a) - problem.pressure_at(b)) / step,
        false => problem.pressure_slope_at(a),
    }
}

/// Triangles in the cavity of the cubic film with those that share a vertex with one at its edge, and those in the
/// cavity that do not.
fn front(cubic: &SolvedFilm) -> (Vec<bool>, Vec<bool>) {
    let SolvedFilm { system, solution, .. } = cubic;
    let space = system.space();
    let mesh = space.mesh();
    let mut near = vec![false; mesh.points().len()];
    let mut inside = vec![false; mesh.triangles().len()];
    for (t, inside) in inside.iter_mut().enumerate() {
        let dofs = &space.element_dofs(t)[..space.shapes()];
        *inside = dofs.iter().any(|&dof| solution.cavity[dof]);
        let outside = |&dof: &usize| !solution.cavity[dof] && system.supply.owner(dof).is_none();
        if *inside && dofs.iter().any(outside) {
            for v in mesh.triangles()[t] {
                near[v as usize] = true;
            }
        }
    }
    let at_edge = |t: usize| mesh.triangles()[t].iter().any(|&v| near[v as usize]);
    let places = inside.iter().enumerate();
    places.map(|(t, &inside)| (inside || at_edge(t), inside && !at_edge(t))).unzip()
}

/// Triangles at corners of the film: where it takes up more than [`REENTRANT`] or its thickness jumps, and where its
/// edge bends otherwise, but for rims that are circles.
fn corners(problem: &FilmProblem, system: &FilmSystem) -> [Vec<bool>; 2] {
    let mesh = system.space().mesh();
    let is_film = system.supply.film(mesh);
    let mut angles = vec![0.0; mesh.points().len()];
    let mut thickness = vec![[f64::INFINITY, 0.0]; mesh.points().len()];
    for t in (0..is_film.len()).filter(|&t| is_film[t]) {
        let corners = mesh.corners(t);
        let films = problem.thickness_at(t, &corners);
        for (k, &vertex) in mesh.triangles()[t].iter().enumerate() {
            let to = |other: usize| [0, 1].map(|d| corners[other % 3][d] - corners[k][d]);
            let (a, b) = (to(k + 1), to(k + 2));
            angles[vertex as usize] += (a[0] * b[1] - a[1] * b[0]).atan2(a[0] * b[0] + a[1] * b[1]);
            let [least, most] = &mut thickness[vertex as usize];
            (*least, *most) = (least.min(films[k]), most.max(films[k]));
        }
    }
    let on_circle = |vertex: u32| {
        let owner = system.supply.owner(system.space().vertex_dof(vertex));
        owner.is_some_and(|k| system.supply.regions()[k].disc.is_some())
    };
    let is_sharp = |&vertex: &u32| {
        let (angle, [least, most]) = (angles[vertex as usize], thickness[vertex as usize]);
        (REENTRANT..WHOLE).contains(&angle) || most > (1.0 + JUMP) * least
    };
    let is_bend = |&vertex: &u32| {
        let angle = angles[vertex as usize];
        angle < WHOLE && (angle - std::f64::consts::PI).abs() > STRAIGHT && !on_circle(vertex)
    };
    let at = |is_corner: &dyn Fn(&u32) -> bool| {
        let at = |t: usize| is_film[t] && mesh.triangles()[t].iter().any(is_corner);
        (0..is_film.len()).map(at).collect::<Vec<bool>>()
    };
    let sharp = at(&is_sharp);
    let bends = at(&is_bend);
    let bends = bends.iter().zip(&sharp).map(|(&bend, &sharp)| bend && !sharp).collect();
    [sharp, bends]
}
