//! # Power: what the journal puts in, and where it goes
//!
//! **Equation.** With the drag on the journal `tau = mu U/h + h/2 grad p` and the pressure P = p - p_e above that of
//! the ends
//! ```text
//! shear        Int theta mu |U|^2/h dA            pressure   Int h/2 U . grad P dA
//! motion     -Int theta dh/dt P dA               supplied   sum of Q_i P_i where pressure is given,   cavity likewise
//! dissipated   Int theta mu |U|^2/h + h^3/(12 mu) |grad p|^2 dA = shear + pressure + motion + supplied + cavity
//! ```
//! The last line is the energy integral of the film, and an identity of the discrete equation too: tested with the
//! nodal interpolant of P, all residuals vanish but those where pressure is given or held, which are the flows Q_i
//! there. So its two sides come by two ways: as integrals over the film, and as flows times pressures. In a
//! mass-conserving film the scheme's own flows between cells stand for the integrals of grad p.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | shear, pressure, motion | W | `shear` (of which `cavity_shear` in the cavity), `pressure`, `motion` |
//! | Q_i P_i | W | `supplied`, `cavity` |
//! | h^3/(12 mu) grad p . grad P | W | `driven` |
//!
//! **Source.** Reynolds, Phil. Trans. R. Soc. 177 (1886) 157; Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film
//! Lubrication (2004), ch. 7.
//! **Range.** The film, cavities included: full shear there but for a mass-conserving film, whose oil fills theta of
//! the gap. No film, and no shear, where a feed gives the pressure. The as-printed form makes oil, and its power does
//! not balance. **Verified by** `tests/tests/friction.rs`.

use oilwedge_fem::control_volumes::{SubTriangleRules, sub_triangles};
use oilwedge_fem::integrate::{Nodal, Points, Rule};
use oilwedge_fem::{Field, integrate};

use super::cavity::broken_share;
use super::flow::{STILL, reference_flow};
use super::load::Resultant;
use crate::cavitation::{self, Carriage};
use crate::film_law::FilmLaw;
use crate::film_thickness::Follows;
use crate::flow_factors::mean_gap;
use crate::lubricant::PressureLaw;
use crate::{FilmPoint, FilmProblem, FilmSystem, SolvedFilm, Theory};

/// Powers [W] of one film.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Power {
    /// Put in by the turning journal against shear; all of it becomes heat.
    pub shear: f64,
    /// The part of it in the cavity of Swift and Stieber, or where Guembel drops the pressure: these models know no
    /// film fraction, and shear the whole gap there. Zero for others.
    pub cavity_shear: f64,
    /// Put in by the turning journal against the pressure on it.
    pub pressure: f64,
    /// The part `Int (s - 1/2) h U . grad P dA` of `pressure` that a viscosity adds which varies across the film
    /// ([`crate::ViscosityAcross`]); zero for others.
    pub uneven: f64,
    /// Put in by the turning journal against the friction of contact; all of it becomes heat. Zero where no contact is
    /// simulated.
    pub contact: f64,
    /// Put in by the journal's centre as it moves.
    pub motion: f64,
    /// Put in by the oil that comes through places of given pressure, over that of the ends.
    pub supplied: f64,
    /// Put in by the oil that a Swift-Stieber cavity makes, over the pressure of the ends.
    pub cavity: f64,
    /// Heat of the flow that pressure drives; that of shear is `shear`.
    pub driven: f64,
    /// How well this is balanced: what is put in less what becomes heat, over the sum of all magnitudes.
    pub imbalance: f64,
    /// How far `Int h/2 U . grad P dA` is from that of the moment of the load, over what the turning journal puts in;
    /// zero where they need not agree.
    pub moment_imbalance: f64,
}

impl Power {
    /// The power with the friction of contact under a `thrust` Int p_a dA [N].
    pub fn with_contact(self, problem: &FilmProblem, thrust: f64) -> Self {
        let [x, z] = problem.surface_velocity();
        let friction = problem.contact.as_ref().map_or(0.0, |contact| contact.friction);
        Self { contact: friction * x.hypot(z) * thrust, ..self }
    }

    /// Takes the power against the pressure from what the oil `carries`, where it follows from that
    /// ([`PressurePower`]): no gradient is in it, and regions cut out of the mesh count with their true shape.
    pub fn with_moment(self, problem: &FilmProblem, carries: Resultant) -> Self {
        let Some(per) = PressurePower::of(problem) else {
            return self;
        };
        let product = |[a, b]: [f64; 2], [x, y]: [f64; 2]| a * x + b * y;
        let even = product(per.force, carries.force) + product(per.moment, carries.moment);
        let by_moment = even + self.uneven;
        let put_in = self.shear + self.pressure.abs();
        Self {
            pressure: by_moment,
            moment_imbalance: match put_in > 0.0 {
                true => (self.pressure - by_moment).abs() / put_in,
                false => 0.0,
            },
            ..self
        }
    }

    /// What the turning journal puts in [W]: friction.
    pub fn friction(&self) -> f64 {
        self.shear + self.pressure + self.contact
    }
}

/// Integrals over the film [W].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct PowerIntegrals {
    pub(crate) shear: f64,
    pub(crate) cavity_shear: f64,
    pub(crate) pressure: f64,
    /// Part of it for a viscosity that varies across the film.
    pub(crate) uneven: f64,
    /// Power of what is dragged along; equal to that against the pressure, unless the oil has another gap than the
    /// shear.
    pub(crate) dragged: f64,
    pub(crate) motion: f64,
    pub(crate) driven: f64,
}

impl std::ops::AddAssign for PowerIntegrals {
    fn add_assign(&mut self, other: Self) {
        self.shear += other.shear;
        self.cavity_shear += other.cavity_shear;
        self.pressure += other.pressure;
        self.uneven += other.uneven;
        self.dragged += other.dragged;
        self.motion += other.motion;
        self.driven += other.driven;
    }
}

/// Power that the turning journal puts in against the pressure of a film, for each force and moment that the film
/// carries: by parts `Int h/2 U dP/dx dA = -omega R/2 Int P dh/dx dA`, omega times half of the torque of the force, at
/// its place along a tilted axis, about the axis of the bearing: `omega/2 (e_y W_x - e_x W_y + g_y m_x - g_x m_y)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressurePower {
    /// Power for each force towards x and y [W/N].
    pub force: [f64; 2],
    /// Power for each moment towards x and y [W/(N m)].
    pub moment: [f64; 2],
}

impl PressurePower {
    /// `None` where the film has a thickness of its own beside that of the journal, lines that stand by themselves, or
    /// a viscosity that varies across it.
    pub fn of(problem: &FilmProblem) -> Option<Self> {
        let mut contributions = problem.film_thickness.iter();
        let is_of_journal = contributions.all(|contribution| contribution.follows() != Follows::Nothing);
        let arm = |[a_x, a_y]: [f64; 2]| [a_y, -a_x].map(|arm| 0.5 * problem.journal.speed * arm);
        (is_of_journal && problem.theory != Theory::Short)
            .then(|| Self { force: arm(problem.journal.offset), moment: arm(problem.journal.tilt) })
    }
}

/// Powers of a solved film.
pub fn power(film: &SolvedFilm) -> Power {
    let SolvedFilm { problem, system, solution } = film;
    let excess: Vec<f64> = solution.unknown.iter().map(|&u| excess(problem, u)).collect();
    // The film was solved on the sub-mesh that is asked for; without it there is no number.
    let carriage = (solution.film_fraction.as_ref()).and_then(|fraction| Carriage::new(problem, system, fraction).ok());
    let mut work = integrate(system.space().mesh(), of_triangle(film, &excess, carriage.as_ref()));
    match &carriage {
        Some(carriage) => {
            let (nominal, uneven) = (work.pressure, work.uneven);
            work = PowerIntegrals { uneven, ..cavitation::work(carriage, solution, &excess, work.shear) };
            if problem.is_rough() {
                work.pressure = nominal;
            }
        }
        None if solution.film_fraction.is_some() => work.shear = f64::NAN,
        None => {}
    }
    let (mut supplied, mut cavity) = (0.0, 0.0);
    for (dof, (&inflow, &excess)) in solution.inflow.iter().zip(&excess).enumerate() {
        if system.supply.owner(dof).is_some() {
            supplied += inflow * excess;
        } else if solution.cavity[dof] && solution.film_fraction.is_none() {
            cavity += inflow * excess;
        }
    }
    let PowerIntegrals { shear, cavity_shear, pressure, dragged, motion, driven, uneven } = work;
    // Shear stands on both sides.
    let parts = [dragged, motion, supplied, cavity, -driven];
    let scale = shear + parts.iter().map(|part| part.abs()).sum::<f64>();
    let pressures = problem.pressure_scale(&system.supply.constraints(|p| problem.unknown_at(p)));
    Power {
        shear,
        cavity_shear,
        pressure,
        uneven,
        contact: 0.0,
        motion,
        supplied,
        cavity,
        driven,
        imbalance: if scale > STILL * pressures * reference_flow(problem, system) {
            (parts.iter().sum::<f64>() / scale).abs()
        } else {
            0.0
        },
        moment_imbalance: 0.0,
    }
}

/// Pressure [Pa] above that of the ends where the unknown is `u`.
pub(crate) fn excess(problem: &FilmProblem, u: f64) -> f64 {
    problem.pressure_at(u) - problem.bearing.end_pressure
}

/// Power of shear [W] in each triangle of a solved film.
pub(crate) fn shear_of_triangles(film: &SolvedFilm) -> Vec<f64> {
    let SolvedFilm { problem, system, solution } = film;
    let excess: Vec<f64> = solution.unknown.iter().map(|&u| excess(problem, u)).collect();
    let carriage = (solution.film_fraction.as_ref()).and_then(|fraction| Carriage::new(problem, system, fraction).ok());
    let of_triangle = of_triangle(film, &excess, carriage.as_ref());
    (0..system.space().mesh().triangles().len()).map(|t| of_triangle(t).shear).collect()
}

/// Integrals over a triangle of a film.
fn of_triangle<'a>(
    film: &'a SolvedFilm,
    excess: &'a [f64],
    carriage: Option<&'a Carriage<'a>>,
) -> impl Fn(usize) -> PowerIntegrals + Sync + 'a {
    let SolvedFilm { problem, system, solution } = film;
    let (space, mesh) = (system.space(), system.space().mesh());
    let is_film = system.supply.film(mesh);
    let rule = Rule::for_degree(space.degree());
    let parts = SubTriangleRules::new(space.degree(), 1);
    let law = FilmLaw::new(problem, 1.0);
    let drops_pressures = problem.cavitation.drops_pressures();
    move |t| {
        let fields = [&solution.unknown[..], excess].map(|values| Field { space, values }.element_values(t));
        let work = rule.integrate(mesh, t, |points, work| cell_work(problem, &law, points, &fields, work));
        let carried = carriage.map(|carriage| carriage.carried(t, &solution.cavity));
        let shear = match carried {
            _ if !is_film[t] => 0.0,
            Some(carried) if carried.iter().any(|thickness| thickness.is_finite()) => {
                broken_shear(problem, (system, &parts), &law, t, &fields[1], carried)
            }
            _ => work.shear,
        };
        let cavity_shear = if drops_pressures { shear * broken_share(film, t) } else { 0.0 };
        PowerIntegrals { shear, cavity_shear, ..work }
    }
}

/// Adds what is worked at points of a full film.
fn cell_work(
    problem: &FilmProblem,
    law: &FilmLaw,
    points: &Points,
    [unknown, excess]: &[Nodal; 2],
    work: &mut PowerIntegrals,
) {
    // By reference: a copy takes as long as the film.
    let (film, flows) = &law.film_and_flows(points.cell, points.positions);
    let (velocity, along) = (law.velocity(), problem.theory.directions());
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let (is_linear, is_rough) = (problem.has_linear_pressure(), problem.is_rough());
    for q in 0..points.positions.len() {
        let area = points.area(q);
        let of_pressure = points.gradient(q, excess);
        let of_unknown = if is_linear { of_pressure } else { points.gradient(q, unknown) };
        let p = points.value(q, excess);
        let (conductance, along) = flows[q].parts(along);
        let FilmPoint { thickness, drag, .. } = film[q];
        let pressure = area * drag * thickness * dot(velocity, of_pressure);
        *work += PowerIntegrals {
            cavity_shear: 0.0,
            shear: area * shear_viscosity(problem, &film[q], p) / thickness * dot(velocity, velocity),
            pressure,
            uneven: area * (drag - 0.5) * thickness * dot(velocity, of_pressure),
            dragged: match is_rough {
                false => pressure,
                true => area * dot(flows[q].flux, of_pressure),
            },
            motion: -area * flows[q].storage * p,
            driven: area * conductance * dot([0, 1].map(|d| along[d] * of_unknown[d]), of_pressure),
        };
    }
}

/// Viscosity [Pa s] that shear meets at a point of the film, at a pressure [Pa] above that of the ends.
pub(crate) fn shear_viscosity(problem: &FilmProblem, film: &FilmPoint, excess: f64) -> f64 {
    match problem.lubricant.pressure_law {
        PressureLaw::Constant => film.shear_viscosity,
        _ => {
            let pressure = excess + problem.bearing.end_pressure;
            film.shear_viscosity * problem.lubricant.pressure_law.viscosity_ratio(pressure)
        }
    }
}

/// Power of shear [W] in a triangle that is not full: oil of the thickness `carried` [m] comes into each of its
/// sub-triangles.
fn broken_shear(
    problem: &FilmProblem,
    (system, parts): (&FilmSystem, &SubTriangleRules),
    law: &FilmLaw,
    t: usize,
    excess: &Nodal,
    carried: [f64; 4],
) -> f64 {
    let space = system.space();
    let velocity = law.velocity();
    let square = velocity[0] * velocity[0] + velocity[1] * velocity[1];
    let mut shear = 0.0;
    for (corners, carried) in sub_triangles(space, t).iter().zip(carried) {
        parts.of(corners).visit(space.mesh(), t, |points| {
            let film = law.film(t, points.positions);
            for (q, point) in film[..points.positions.len()].iter().enumerate() {
                let FilmPoint { thickness, drag, .. } = point;
                let [gap, _] = mean_gap(&problem.flow_factors, *thickness);
                let fraction = (carried / (2.0 * drag * gap)).min(1.0);
                let viscosity = shear_viscosity(problem, point, points.value(q, excess));
                shear += points.area(q) * fraction * viscosity / thickness * square;
            }
        });
    }
    shear
}
