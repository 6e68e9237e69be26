//! # Error bars of a mass-conserving film: its distance from the film on the vertices alone
//!
//! **Equation.** With d = |p - p_2h| at the vertices, p_2h the pressure of the coarse comparison, and s = the integral
//! of p by quadratic less that by linear functions over a triangle at the edge of the cavity:
//! ```text
//! bar of Int p w dA = (1 + chi/chi_1) (c Int d |w| dA + Sum |w s|)
//! ```
//! Where a wall gives way, w of a force or moment has the part mu of [`super::following`] added. Both films carry oil
//! by the same scheme, and what it spreads across the flow shows in neither: sigma and n (`jfo/spread.rs`) say. Every
//! bar has the part `min(0.1 + 0.3 n, 0.8) sigma` of its number added. Of second order the error at a node is a third
//! of d, here without its sign, since signs change from mesh to mesh: c is a little more than a third. Where the two
//! films do not agree on which nodes are in the cavity the mesh is not yet fine enough for that: chi. Flows are judged
//! by their own differences `Q - Q_2h` and by that of what the cavity carries, the extent of the cavity by how much of
//! the mesh its edge takes up.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | Pa | `difference` |
//! | chi: share of the mesh at vertices that are in the cavity of one film only | 1 | `doubt` |
//! | beta: share of the mesh in sub-triangles at the edge of the cavity | 1 | `front` |
//! | sigma: oil that may be carried across the flow, over what the journal drags through the clearance | 1 | `spread` |
//! | n: how often oil may be carried across the flow | 1 | `spread` |
//! | delta: mean difference of the film fraction at the vertices | 1 | `carried` |
//!
//! **Source.** Constants: measured on random bearings, held against others, `docs/theory/error_estimation_jfo.md`.
//! **Range.** Mass-conserving films of quadratic elements. No bar can be trusted where that of the load exceeds a
//! twentieth of it.
//! **Verified by** `cavitation/bars`: finer meshes.

mod directions;

pub use self::directions::ErrorDirection;

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_mesh::triangle_area;

use super::following::{FollowingWall, GOALS};
use super::places::{Places, places};
use super::{Bar, CANCELLING, UNRESOLVED, drag, geometry};
use crate::cavitation;
use crate::quantities::flow::{self, Flows};
use crate::quantities::inlet::inlet_flow;
use crate::quantities::load::{self, Share};
use crate::quantities::power::power;
use crate::supply::{BoundaryKind, SupplyRegion};
use crate::{FilmPoint, FilmProblem, FilmSystem, SolvedFilm};

/// Coefficient c of the difference of pressures, under an integral.
const OF_PRESSURE: f64 = 0.36;
/// Doubt chi_1 at which bars of the load double.
const DOUBTFUL: f64 = 0.015;
/// Weights in the bar of a pressure: of the difference where the pressure is greatest, and of the greatest difference.
const AT_TOP: f64 = 0.42;
const ANYWHERE: f64 = 0.13;
/// Weight in the bar of a flow of its difference.
const OF_FLOW: f64 = 0.6;
/// Weights in the bar of a flow of delta times what passes through a region, at ends and elsewhere.
const CARRIED_TO_ENDS: f64 = 0.5;
const CARRIED_ELSEWHERE: f64 = 0.2;
/// Weights in the bar of the inlet flow of its difference, and of delta times that flow.
const OF_INLET: f64 = 1.6;
const CARRIED_TO_INLET: f64 = 0.7;
/// Weight in the bar of the shear power of delta times that power.
const CARRIED_IN_SHEAR: f64 = 0.1;
/// Weights in the bar of the cavity's share of beta, delta and chi.
const OF_FRONT: f64 = 0.2;
const OF_CARRIED: f64 = 0.3;
const OF_DOUBT: f64 = 0.3;
/// Weights in the bar of the least film fraction: of the greatest difference where there is least oil, in that part of
/// the cavity, and of beta; the bar ends at zero oil, but is no less than the last, by which the transport over- and
/// undershoots at edges of streaks.
const LEAST_OIL: f64 = 0.9;
const LEAST_PART: f64 = 0.1;
const LEAST_FRONT: f64 = 0.3;
const LEAST_BAR: f64 = 0.005;

/// Weights in every bar of sigma and of sigma n, and the most of sigma that they may be.
const OF_SPREAD: f64 = 0.1;
const OF_SPREAD_AGAIN: f64 = 0.3;
const MOST_OF_SPREAD: f64 = 0.8;

/// What is known of the errors of a mass-conserving film; each number is half the width of a bar.
#[derive(Debug, Clone, PartialEq)]
pub struct ConservingError {
    /// Bar of the magnitude of the load [N].
    pub load: Bar,
    /// Bar of the load across its direction [N]: over the magnitude, that of its angle [rad].
    pub across: Bar,
    /// Bars of the load towards 0 and towards 90 degrees [N].
    pub force: [Bar; 2],
    /// Bars of the moment towards 0 and towards 90 degrees [N m]; none where the journal cannot tilt.
    pub moment: Option<[Bar; 2]>,
    /// Directions of force and moment together; none where the journal cannot tilt.
    pub directions: Vec<ErrorDirection>,
    /// Bar of `Int p dA` [N].
    pub pressure_integral: Bar,
    /// Bar of the greatest pressure [Pa]; not finite where the limit of the viscosity law lies within it.
    pub greatest_pressure: f64,
    /// Bar of the pressure of the film anywhere [Pa]; not finite where the limit of the viscosity law lies within it.
    pub pressure: f64,
    /// Bars of the net flow of each region of the supply [m3/s].
    pub flows: Vec<f64>,
    /// Bar of the flow through all ends together [m3/s].
    pub side_flow: f64,
    /// Bar of the flow into the loaded film [m3/s].
    pub inlet_flow: f64,
    /// Differences of the powers [W] that the turning journal puts in against shear, and against pressure, from those
    /// of the coarse comparison.
    pub power: [f64; 2],
    /// Power [W] of shear that is in doubt because the film fraction is.
    pub power_carried: f64,
    /// Bar of the share of the cavity [1].
    pub cavity_share: f64,
    /// Bar of the least film fraction [1].
    pub least_fraction: f64,
    /// Part of every bar, over its number, for oil that triangles spread across the flow [1]; zero on rows along it.
    pub spread: f64,
    /// Bars of places.
    pub places: Places,
    /// False where the mesh does not resolve the film, and no bar can be trusted.
    pub is_resolved: bool,
    /// Share of each triangle in the bars of the load and its angle [N]: what refinement should look at.
    pub indicator: Vec<f64>,
}

/// How far a film and its coarse comparison differ in the cavity.
struct Disagreement {
    /// Share chi of the mesh at vertices that are in the cavity of one film only [1].
    doubt: f64,
    /// Mean difference delta of the film fraction at the vertices [1].
    carried: f64,
    /// Film fractions of both at vertices that are in the cavity of both.
    in_both: Vec<[f64; 2]>,
}

/// Weights of the pressure in force and moment, a wall that gives way following.
struct Weights {
    /// Weights of the force towards x and y [1].
    force: [f64; 2],
    /// Weights of the moments of that force [m].
    moment: [f64; 2],
}

/// A film and its coarse comparison.
struct FilmPair<'a> {
    film: &'a SolvedFilm,
    /// The wall, if it gives way.
    following: Option<&'a FollowingWall>,
    /// Pressure [Pa] at each dof of the film.
    pressure: Vec<f64>,
    /// |p - p_2h| [Pa] at each vertex.
    difference: Vec<f64>,
}

/// Estimates the errors of a mass-conserving `film` of quadratic elements by its `coarse` comparison
/// ([`SolvedFilm::coarse_comparison`]), where a wall that gives way is `following`, or held where there is none; none
/// for other films.
pub fn conserving_error(
    film: &SolvedFilm,
    coarse: &SolvedFilm,
    following: Option<&FollowingWall>,
) -> Option<ConservingError> {
    let SolvedFilm { problem, system, solution } = film;
    let (fraction, other) = (solution.film_fraction.as_ref()?, coarse.solution.film_fraction.as_ref()?);
    (system.space().degree() == 2).then_some(())?;
    let pair = FilmPair::new(film, coarse, following);
    let total = load::load(film);
    let (sin, cos) = total.angle().sin_cos();
    let [along, across] = [[cos, sin], [-sin, cos]].map(|[x, y]| pair.shares(|at| x * at.force[0] + y * at.force[1]));
    let front = pair.front();
    let Disagreement { doubt, carried, in_both } = pair.disagreement(coarse, [&fraction.values, &other.values]);
    let widened = 1.0 + doubt / DOUBTFUL;
    let least = fraction.values.iter().copied().fold(1.0, f64::min);
    let films = [film, coarse];
    let [through, other_through] = films.map(flow::flows);
    let (flows, side_flow) = flow_bars(system, &through, &other_through, carried);
    let [power, other_power] = films.map(|film| {
        let carries = load::load(film).total.resultant();
        power(film).with_moment(problem, carries)
    });
    let [inlet, other_inlet] = films.map(|film| inlet_flow(film).unwrap_or(0.0));
    let bar = |shares: &[Bar]| (shares.iter().fold(Bar::default(), |sum, &share| sum + share)).scaled(widened);
    let spread = cavitation::spread(film, fraction).ok()?;
    let per_share = (OF_SPREAD + OF_SPREAD_AGAIN * spread.times).min(MOST_OF_SPREAD);
    let part = per_share * spread.shares.iter().sum::<f64>();
    let around = 0.5 * problem.surface_velocity()[0].abs() * problem.bearing.clearance * problem.bearing.length;
    let with_spread = |bar: Bar, of: f64| Bar { transport: part * of.abs(), ..bar };
    let force = total.magnitude();
    let load = with_spread(bar(&along), force);
    let arm = 0.5 * problem.bearing.length;
    let directions = match problem.can_tilt() {
        true => directions::directions(&pair, arm, |shares| with_spread(bar(shares), force)),
        false => Vec::new(),
    };
    let greatest = pair.pressure.iter().fold(0.0, |most: f64, p| most.max(p.abs()));
    let pressure = pair.greatest_pressure(coarse) + part * greatest;
    Some(ConservingError {
        is_resolved: load.total() <= UNRESOLVED * least_resolved(problem, &total.total),
        spread: part,
        places: places(films, part),
        load,
        across: with_spread(bar(&across), force),
        force: [0, 1].map(|towards| with_spread(bar(&pair.shares(|at| at.force[towards])), force)),
        moment: problem
            .can_tilt()
            .then(|| [0, 1].map(|towards| with_spread(bar(&pair.shares(|at| at.moment[towards])), arm * force))),
        directions,
        pressure_integral: with_spread(bar(&pair.shares(|_| 1.0)), total.of_oil().pressure),
        greatest_pressure: pressure,
        pressure,
        flows: flows.into_iter().map(|flow| flow + part * around).collect(),
        side_flow: side_flow + part * around,
        inlet_flow: OF_INLET * (inlet - other_inlet).abs() + (CARRIED_TO_INLET * carried + part) * inlet.abs(),
        power: [power.shear - other_power.shear, power.pressure - other_power.pressure],
        power_carried: (CARRIED_IN_SHEAR * carried + part) * power.shear + at_rims(film),
        cavity_share: OF_FRONT * front + OF_CARRIED * carried + OF_DOUBT * doubt + part,
        least_fraction: LEAST_BAR.max(least.min(LEAST_OIL * where_least(in_both) + LEAST_FRONT * front)),
        indicator: (along.iter().zip(&across).zip(&spread.shares))
            .map(|((along, across), spread)| widened * along.total().max(across.total()) + per_share * force * spread)
            .collect(),
    })
}

impl ConservingError {
    /// Bar of `shear` times the power of shear and `pressure` times that of pressure [W].
    pub fn power(&self, [shear, pressure]: [f64; 2]) -> f64 {
        (shear * self.power[0] + pressure * self.power[1]).abs() + shear.abs() * self.power_carried
    }
}

impl<'a> FilmPair<'a> {
    fn new(film: &'a SolvedFilm, coarse: &SolvedFilm, following: Option<&'a FollowingWall>) -> Self {
        let pressure: Vec<f64> = film.solution.unknown.iter().map(|&u| film.problem.pressure_at(u)).collect();
        let mut pair = Self { film, following, pressure, difference: Vec::new() };
        let differences = (pair.vertices().zip(&coarse.solution.unknown))
            .map(|(dof, &unknown)| (film.problem.pressure_at(unknown) - pair.pressure[dof]).abs());
        pair.difference = differences.collect();
        pair
    }

    /// The dof of each vertex.
    fn vertices(&self) -> impl Iterator<Item = usize> {
        let space = self.film.system.space();
        (0..space.mesh().points().len() as u32).map(|vertex| space.vertex_dof(vertex))
    }

    /// How far the two films differ in what is in the cavity, and how full it is: `fractions` are those of the dofs and
    /// of the vertices.
    fn disagreement(&self, coarse: &SolvedFilm, fractions: [&[f64]; 2]) -> Disagreement {
        let fractions: Vec<[f64; 2]> =
            (self.vertices().enumerate()).map(|(vertex, dof)| [fractions[0][dof], fractions[1][vertex]]).collect();
        let in_doubt: Vec<bool> = (self.vertices().zip(&coarse.solution.cavity))
            .map(|(dof, &other)| self.film.solution.cavity[dof] != other)
            .collect();
        let in_both = (self.vertices().enumerate())
            .filter(|&(vertex, dof)| self.film.solution.cavity[dof] && coarse.solution.cavity[vertex])
            .map(|(vertex, _)| fractions[vertex]);
        Disagreement {
            doubt: self.mean(|vertex| f64::from(u8::from(in_doubt[vertex]))),
            carried: self.mean(|vertex| (fractions[vertex][0] - fractions[vertex][1]).abs()),
            in_both: in_both.collect(),
        }
    }

    /// `c Int d |w| dA` and `|w s|` of each triangle, w made of the weights of force and moment.
    fn shares(&self, weight: impl Fn(Weights) -> f64) -> Vec<Bar> {
        let weight = |position: [f64; 2]| weight(self.weights(position)).abs();
        let cells = 0..self.film.system.space().mesh().triangles().len();
        cells.map(|t| self.share(t, &weight)).collect()
    }

    /// Weights at a position [m].
    fn weights(&self, [x, z]: [f64; 2]) -> Weights {
        let (sin, cos) = (x / self.film.problem.bearing.radius).sin_cos();
        let [x, y, m_x, m_y] = self.following.map_or([0.0; GOALS], |wall| wall.at([x, z]));
        Weights { force: [cos + x, sin + y], moment: [z * cos + m_x, z * sin + m_y] }
    }

    fn share(&self, t: usize, weight: &dyn Fn([f64; 2]) -> f64) -> Bar {
        let mesh = self.film.system.space().mesh();
        let (corners, area) = (mesh.corners(t), self.area(t));
        let at_vertices = (0..3).map(|k| weight(corners[k]) * self.difference[mesh.triangles()[t][k] as usize]);
        let discretisation = OF_PRESSURE * area / 3.0 * at_vertices.sum::<f64>();
        let mut front = 0.0;
        if self.is_front(t, &[0, 1, 2, 3, 4, 5]) {
            let dofs = self.film.system.space().element_dofs(t);
            let sum = |nodes: [usize; 3]| nodes.iter().map(|&node| self.pressure[dofs[node]]).sum::<f64>();
            let surplus = area / 12.0 * (sum([3, 4, 5]) - sum([0, 1, 2]));
            front = surplus.abs() * weight([0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0));
        }
        Bar { discretisation, front, ..Bar::default() }
    }

    /// Bar from the difference at the vertex of the greatest pressure. In the unknown: where the viscosity law nears
    /// its limit pressures are far more uncertain than it; not finite where the limit lies within the bar.
    fn greatest_pressure(&self, coarse: &SolvedFilm) -> f64 {
        let problem = &self.film.problem;
        let unknown = |dof: usize| self.film.solution.unknown[dof];
        let difference = |(dof, other): (usize, &f64)| (dof, (other - unknown(dof)).abs());
        let pairs = || self.vertices().zip(&coarse.solution.unknown).map(difference);
        let Some((top, at_top)) = pairs().max_by(|a, b| unknown(a.0).total_cmp(&unknown(b.0))) else {
            return 0.0;
        };
        let anywhere = pairs().map(|(_, difference)| difference).fold(0.0, f64::max);
        let bar = AT_TOP * at_top + ANYWHERE * anywhere;
        match unknown(top) + bar < problem.lubricant.pressure_law.limit() {
            true => problem.pressure_at(unknown(top) + bar) - self.pressure[top],
            false => f64::INFINITY,
        }
    }

    /// Area [m2] of a triangle, its sides taken straight.
    fn area(&self, t: usize) -> f64 {
        triangle_area(self.film.system.space().mesh().corners(t))
    }

    /// True if some of these nodes of a triangle are in the cavity and some are not.
    fn is_front(&self, t: usize, nodes: &[usize]) -> bool {
        let dofs = self.film.system.space().element_dofs(t);
        let broken = nodes.iter().filter(|&&node| self.film.solution.cavity[dofs[node]]).count();
        broken > 0 && broken < nodes.len()
    }

    /// Share beta of the mesh in sub-triangles at the edge of the cavity [1].
    fn front(&self) -> f64 {
        let space = self.film.system.space();
        let (mut front, mut whole) = (0.0, 0.0);
        for t in 0..space.mesh().triangles().len() {
            let subs = sub_triangles(space, t);
            let at_front = subs.iter().filter(|&sub| self.is_front(t, sub)).count();
            front += self.area(t) * at_front as f64 / subs.len() as f64;
            whole += self.area(t);
        }
        front / whole
    }

    /// Mean over the mesh of a function of the vertex.
    fn mean(&self, of: impl Fn(usize) -> f64) -> f64 {
        let mesh = self.film.system.space().mesh();
        let (mut sum, mut whole) = (0.0, 0.0);
        for (t, corners) in mesh.triangles().iter().enumerate() {
            sum += self.area(t) / 3.0 * corners.iter().map(|&vertex| of(vertex as usize)).sum::<f64>();
            whole += self.area(t);
        }
        sum / whole
    }
}

/// What bars of a load are small against [N]: a tilted journal may bear a moment and next to no force, and parts of a
/// load may cancel.
fn least_resolved(problem: &FilmProblem, total: &Share) -> f64 {
    let [x, y] = total.force;
    let borne = match problem.can_tilt() {
        true => total.resultant().at_ends(0.5 * problem.bearing.length),
        false => x.hypot(y),
    };
    borne.max(CANCELLING * load::possible_load(problem, total))
}

/// Power of shear [W] of the film between element edges and the circles that they stand for: both films have the same
/// edges.
fn at_rims(film: &SolvedFilm) -> f64 {
    let still = vec![0.0; film.solution.unknown.len()];
    let shear = |region: &SupplyRegion, _: [f64; 2], at: &FilmPoint| drag::shear(&film.problem, at, region.pressure);
    geometry::rims(film, &still, &shear).abs()
}

/// The greatest difference of pairs of film fractions where there is least oil.
fn where_least(mut pairs: Vec<[f64; 2]>) -> f64 {
    pairs.sort_by(|[a, b], [c, d]| a.min(*b).total_cmp(&c.min(*d)));
    let part = (pairs.len() as f64 * LEAST_PART).ceil() as usize;
    pairs.iter().take(part).fold(0.0, |most, [a, b]| most.max((a - b).abs()))
}

/// Bars of the flow of each region and of all ends together.
fn flow_bars(system: &FilmSystem, flows: &Flows, others: &Flows, carried: f64) -> (Vec<f64>, f64) {
    let pairs = || system.supply.regions().iter().zip(flows.regions.iter().zip(&others.regions));
    let bar = |difference: f64, passing: f64, kind: BoundaryKind| {
        let by_carried = match kind {
            BoundaryKind::End => CARRIED_TO_ENDS,
            BoundaryKind::Line | BoundaryKind::Feed | BoundaryKind::Sealed => CARRIED_ELSEWHERE,
        };
        OF_FLOW * difference.abs() + by_carried * carried * passing
    };
    let each =
        pairs().map(|(region, (flow, other))| bar(flow.net - other.net, flow.inward + flow.outward, region.kind));
    let ends = || pairs().filter(|(region, _)| region.kind == BoundaryKind::End);
    let difference = ends().map(|(_, (flow, other))| flow.net - other.net).sum();
    let passing = ends().map(|(_, (flow, _))| flow.inward + flow.outward).sum();
    (each.collect(), bar(difference, passing, BoundaryKind::End))
}
