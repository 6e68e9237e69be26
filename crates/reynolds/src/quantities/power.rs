//! # Power: what the journal puts in, and where it goes
//!
//! **Equation.** With the drag on the journal `tau = mu U/h + h/2 grad p` and the pressure P = p - p_e above that of the ends
//! ```text
//! shear        Int theta mu |U|^2/h dA            pressure   Int h/2 U . grad P dA
//! motion     -Int theta dh/dt P dA               supplied   sum of Q_i P_i where pressure is given,   cavity likewise
//! dissipated   Int theta mu |U|^2/h + h^3/(12 mu) |grad p|^2 dA = shear + pressure + motion + supplied + cavity
//! ```
//! The last line is the energy integral of the film, and an identity of the discrete equation too: tested with the nodal interpolant of
//! P, all residuals vanish but those where pressure is given or held, which are the flows Q_i there. So its two sides come by two ways: as
//! integrals over the film, and as flows times pressures. In a mass-conserving film the scheme's own flows between cells stand for the
//! integrals of grad p.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | shear, pressure, motion | W | `shear` (of which `cavity_shear` in the cavity), `pressure`, `motion` |
//! | Q_i P_i | W | `supplied`, `cavity` |
//! | h^3/(12 mu) grad p . grad P | W | `driven` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157; Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film Lubrication (2004), ch. 7.
//! **Range.** The film, cavities included: full shear there but for a mass-conserving film, whose oil fills theta of the gap. No film, and no
//! shear, where a feed gives the pressure. The as-printed form makes oil, and its power does not balance. **Verified by** `tests/tests/friction.rs`.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_fem::lagrange::{self, MOST_SHAPES};
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{Field, Quadrature, Space};
use rayon::prelude::*;

use super::cavity::broken_share;
use super::flow::{STILL, natural_flow};
use crate::cavitation::{self, Carriage};
use crate::film_law::FilmLaw;
use crate::lubricant::PressureLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Cells that one task sums; fixed, so that threads do not change a bit.
const CELLS_A_TASK: usize = 2048;

/// Powers [W] of one film.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Power {
    /// Put in by the turning journal against shear; all of it becomes heat.
    pub shear: f64,
    /// The part of it in the cavity of Swift and Stieber, or where Guembel drops the pressure: these models know no film fraction, and
    /// shear the whole gap there. Zero for others.
    pub cavity_shear: f64,
    /// Put in by the turning journal against the pressure on it.
    pub pressure: f64,
    /// Put in by the journal's centre as it moves.
    pub motion: f64,
    /// Put in by the oil that comes through places of given pressure, over that of the ends.
    pub supplied: f64,
    /// The same of the oil that a Swift-Stieber cavity makes.
    pub cavity: f64,
    /// Heat of the flow that pressure drives; that of shear is `shear`.
    pub driven: f64,
    /// How well this is balanced: what is put in less what becomes heat, over the sum of all magnitudes.
    pub imbalance: f64,
}

impl Power {
    /// What the turning journal puts in [W]: friction.
    pub fn friction(&self) -> f64 {
        self.shear + self.pressure
    }
}

/// Integrals over the film [W].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Work {
    pub(crate) shear: f64,
    pub(crate) cavity_shear: f64,
    pub(crate) pressure: f64,
    pub(crate) motion: f64,
    pub(crate) driven: f64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.shear += other.shear;
        self.cavity_shear += other.cavity_shear;
        self.pressure += other.pressure;
        self.motion += other.motion;
        self.driven += other.driven;
    }
}

/// Powers of a solved film.
pub fn power(problem: &FilmProblem, system: &FilmSystem, film: &FilmSolution) -> Power {
    let excess: Vec<f64> = film.unknown.iter().map(|&u| excess(problem, u)).collect();
    // The film was solved on the sub-mesh that is asked for; without it there is no number.
    let carriage = (film.film_fraction.as_ref()).and_then(|fraction| Carriage::new(problem, system, fraction).ok());
    let mut work = integrated(problem, system, film, &excess, carriage.as_ref());
    match &carriage {
        Some(carriage) => work = cavitation::work(carriage, film, &excess, work.shear),
        None if film.film_fraction.is_some() => work.shear = f64::NAN,
        None => {}
    }
    let (mut supplied, mut cavity) = (0.0, 0.0);
    for (dof, (&inflow, &excess)) in film.inflow.iter().zip(&excess).enumerate() {
        if system.supply.owner(dof).is_some() {
            supplied += inflow * excess;
        } else if film.cavity[dof] && film.film_fraction.is_none() {
            cavity += inflow * excess;
        }
    }
    let Work {
        shear,
        cavity_shear,
        pressure,
        motion,
        driven,
    } = work;
    // Shear stands on both sides.
    let parts = [pressure, motion, supplied, cavity, -driven];
    let scale = shear + parts.iter().map(|part| part.abs()).sum::<f64>();
    let pressures = problem.pressure_scale(&system.supply.constraints(|p| problem.unknown_at(p)));
    Power {
        shear,
        cavity_shear,
        pressure,
        motion,
        supplied,
        cavity,
        driven,
        imbalance: if scale > STILL * pressures * natural_flow(problem, system) {
            (parts.iter().sum::<f64>() / scale).abs()
        } else {
            0.0
        },
    }
}

/// Pressure [Pa] above that of the ends where the unknown is `u`.
pub(crate) fn excess(problem: &FilmProblem, u: f64) -> f64 {
    problem.pressure_at(u) - problem.bearing.end_pressure
}

/// Shape functions at the points of the rule.
struct Tabulated {
    rule: Quadrature,
    values: Vec<[f64; MOST_SHAPES]>,
    gradients: Vec<[[f64; 2]; MOST_SHAPES]>,
}

impl Tabulated {
    fn new(degree: usize) -> Self {
        let rule = Quadrature::for_degree(degree);
        let values = lagrange::tabulated(degree, &rule.points);
        let gradients = rule.points.iter().map(|&point| {
            let mut gradients = [[0.0; 2]; MOST_SHAPES];
            lagrange::gradients(degree, point, &mut gradients[..lagrange::shapes(degree)]);
            gradients
        });
        let gradients = gradients.collect();
        Self {
            rule,
            values,
            gradients,
        }
    }
}

/// Values at the nodes of one triangle.
type Nodal = [f64; MOST_SHAPES];

fn integrated(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    excess: &[f64],
    carriage: Option<&Carriage>,
) -> Work {
    let space = system.space();
    let cells = space.mesh().triangles().len();
    let is_film = system.supply.film(space.mesh());
    let tabulated = Tabulated::new(space.degree());
    let broken = Quadrature::for_degree(1);
    let law = FilmLaw::new(problem, 1.0);
    let nodal = |values: &[f64], t: usize| Field { space, values }.element_values(t);
    let tasks: Vec<Work> = (0..cells.div_ceil(CELLS_A_TASK))
        .into_par_iter()
        .map(|task| {
            let mut sum = Work::default();
            for t in task * CELLS_A_TASK..((task + 1) * CELLS_A_TASK).min(cells) {
                let fields = [&film.unknown[..], excess].map(|values| nodal(values, t));
                let mapping = Mapping::of(space.mesh(), t);
                let work = cell_work(problem, &law, t, &mapping, &tabulated, &fields);
                let carried = carriage.map(|carriage| carriage.carried(t, &film.cavity));
                let shear = match carried {
                    _ if !is_film[t] => 0.0,
                    Some(carried) if carried.iter().any(|thickness| thickness.is_finite()) => {
                        let at = Place { space, law: &law, t };
                        broken_shear(problem, &at, &mapping, &broken, &fields[1], carried)
                    }
                    _ => work.shear,
                };
                sum += Work {
                    shear,
                    cavity_shear: shear * broken_share(problem, system, film, t),
                    ..work
                };
            }
            sum
        })
        .collect();
    let mut total = Work::default();
    for task in tasks {
        total += task;
    }
    total
}

fn cell_work(
    problem: &FilmProblem,
    law: &FilmLaw,
    t: usize,
    mapping: &Mapping,
    tabulated: &Tabulated,
    [unknown, excess]: &[Nodal; 2],
) -> Work {
    let points = &tabulated.rule.points;
    let mut positions = [[0.0; 2]; MOST_POINTS];
    let mut places = [mapping.at(points[0]); MOST_POINTS];
    for (q, &point) in points.iter().enumerate() {
        places[q] = mapping.at(point);
        positions[q] = places[q].position;
    }
    let (film, flows) = law.film_and_flows(t, &positions[..points.len()]);
    let (velocity, along) = (law.velocity(), problem.theory.directions());
    let mut work = Work::default();
    for (q, place) in places[..points.len()].iter().enumerate() {
        let area = tabulated.rule.weights[q] * place.determinant;
        let values = &tabulated.values[q];
        let at = |nodal: &Nodal| -> f64 { nodal.iter().zip(values).map(|(u, shape)| u * shape).sum() };
        let slope = |nodal: &Nodal| {
            let by = |d: usize| nodal.iter().zip(&tabulated.gradients[q]).map(|(u, g)| u * g[d]).sum();
            place.gradient([by(0), by(1)])
        };
        let (of_unknown, of_pressure) = (slope(unknown), slope(excess));
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let p = at(excess);
        let viscosity = viscosity(problem, p);
        let thickness = film[q].thickness;
        work += Work {
            cavity_shear: 0.0,
            shear: area * viscosity / thickness * dot(velocity, velocity),
            pressure: area * 0.5 * thickness * dot(velocity, of_pressure),
            motion: -area * flows[q].storage * p,
            driven: area * flows[q].conductance * dot([0, 1].map(|d| along[d] * of_unknown[d]), of_pressure),
        };
    }
    work
}

/// Viscosity [Pa s] at a pressure [Pa] above that of the ends.
fn viscosity(problem: &FilmProblem, excess: f64) -> f64 {
    match problem.lubricant.pressure_law {
        PressureLaw::Constant => problem.lubricant.viscosity,
        _ => problem.viscosity_at(excess + problem.bearing.end_pressure),
    }
}

/// A triangle of a film.
struct Place<'a> {
    space: &'a Space,
    law: &'a FilmLaw<'a>,
    t: usize,
}

/// Power of shear [W] in a triangle that is not full: oil of the thickness `carried` [m] comes into each of its sub-triangles.
fn broken_shear(
    problem: &FilmProblem,
    at: &Place,
    mapping: &Mapping,
    rule: &Quadrature,
    excess: &Nodal,
    carried: [f64; 4],
) -> f64 {
    let degree = at.space.degree();
    let nodes = lagrange::nodes(degree);
    let velocity = at.law.velocity();
    let square = velocity[0] * velocity[0] + velocity[1] * velocity[1];
    let mut shear = 0.0;
    for (corners, carried) in sub_triangles(at.space, at.t).iter().zip(carried) {
        let [a, b, c] = corners.map(|node| nodes[node]);
        let (u, v) = ([b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]);
        let part = u[0] * v[1] - u[1] * v[0];
        let points = rule
            .points
            .iter()
            .map(|&[xi, eta]| [0, 1].map(|d| a[d] + xi * u[d] + eta * v[d]));
        let mut places = [mapping.at(a); MOST_POINTS];
        let mut positions = [[0.0; 2]; MOST_POINTS];
        let mut pressures = [0.0; MOST_POINTS];
        for (q, point) in points.enumerate() {
            places[q] = mapping.at(point);
            positions[q] = places[q].position;
            let mut shapes = [0.0; MOST_SHAPES];
            lagrange::values(degree, point, &mut shapes[..lagrange::shapes(degree)]);
            pressures[q] = excess.iter().zip(&shapes).map(|(p, shape)| p * shape).sum();
        }
        let film = at.law.film_and_flows(at.t, &positions[..rule.points.len()]).0;
        for (q, weight) in rule.weights.iter().enumerate() {
            let thickness = film[q].thickness;
            let fraction = (carried / thickness).min(1.0);
            shear += weight * part * places[q].determinant * fraction * viscosity(problem, pressures[q]) / thickness
                * square;
        }
    }
    shear
}
