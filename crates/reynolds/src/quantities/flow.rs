//! # Oil flow through the places of given pressure
//!
//! **Equation.** `Q_i = -Int J . grad phi_i + Int dh/dt phi_i` [m3/s]: the residual of the discrete equation at a
//! given node is the volume that enters the film there (nothing is differentiated). So, up to rounding,
//! `sum of Q_i + what a Swift-Stieber cavity makes = Int theta dh/dt dA`: what comes in, the film takes up.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Q of a region | m3/s | `net`, `inward`, `outward` |
//! | Int theta dh/dt dA | m3/s | `taken_up` |
//! | Q_c | m3/s | `cavity` |
//!
//! Guembel's film is that of the equation with its low pressures dropped. What those would drive through a place of
//! given pressure does not count, and is made by the cavity; what the journal drags there does.
//!
//! **Source.** Hughes, Engel, Mazzei, Larson, J. Comput. Phys. 163 (2000) 467.
//! **Range.** A balance for the conservative form only: the as-printed form makes oil, which the imbalance shows.
//! **Verified by** `flows_balance` in the tests of the scenes and `tests/tests/oil_balance.rs`.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_fem::integrate::Rule;
use oilwedge_mesh::triangle_area;

use crate::cavitation::FilmFraction;
use crate::film_law::FilmLaw;
use crate::quantities::{edge, junction};
use crate::{FilmFlow, FilmPoint, FilmProblem, FilmSystem, SolvedFilm};

/// Volume flow [m3/s] of one region, into the film.
#[derive(Debug, Clone, PartialEq)]
pub struct RegionFlow {
    /// Name of the region.
    pub name: String,
    /// Net flow into the film [m3/s].
    pub net: f64,
    /// The part that enters [m3/s].
    pub inward: f64,
    /// The part that leaves [m3/s].
    pub outward: f64,
    /// What is booked by where the edge of a Swift-Stieber cavity runs within a triangle, and at nodes that another
    /// region has too [m3/s].
    pub unsure: f64,
}

/// All flows.
#[derive(Debug, Clone, PartialEq)]
pub struct Flows {
    /// One entry a region of the supply.
    pub regions: Vec<RegionFlow>,
    /// Sum of all that enters, that a cavity makes and that a shrinking film sets free [m3/s].
    pub throughput: f64,
    /// How well the discrete equations are balanced: what the nodes of all regions and the cavity bring, less what the
    /// film takes up, over the throughput.
    pub imbalance: f64,
    /// Volume that the film takes up as it grows [m3/s]; negative where more is pressed out.
    pub taken_up: f64,
    /// Oil that a cavity makes which conserves none [m3/s], Swift and Stieber's or Guembel's; negative where it loses
    /// some.
    pub cavity: f64,
}

/// A throughput below this part of the flow that the film could have is rounding.
pub(super) const STILL: f64 = 1e-10;
/// The imbalance is relative to this part of that flow at least: where oil only goes round, next to none comes and
/// leaves.
const HARDLY: f64 = 1e-6;

/// Flow [m3/s] that speed, squeeze or given pressures would drive through the clearance.
pub(super) fn reference_flow(problem: &FilmProblem, system: &FilmSystem) -> f64 {
    let (bearing, journal) = (&problem.bearing, &problem.journal);
    // Not their differences: pressures that are alike leave the rounding of each.
    let given = system.supply.regions().iter().map(|region| region.pressure.abs());
    let driven = bearing.clearance.powi(3) / (12.0 * problem.lubricant.viscosity) * given.fold(0.0, f64::max);
    let dragged = 0.5 * (journal.speed * bearing.radius).abs() * bearing.clearance * bearing.length;
    let gap_speed = journal.gap_speed(0.5 * bearing.length);
    dragged + driven + gap_speed * bearing.radius * bearing.length
}

/// Flows of a solved film.
pub fn flows(film: &SolvedFilm) -> Flows {
    let SolvedFilm { problem, system, solution } = film;
    let mut regions: Vec<RegionFlow> = (system.supply.regions().iter())
        .map(|region| RegionFlow { name: region.name.clone(), net: 0.0, inward: 0.0, outward: 0.0, unsure: 0.0 })
        .collect();
    let mut cavity = 0.0_f64;
    let beside = edge::made_beside(film);
    for (dof, (&inflow, beside)) in solution.inflow.iter().zip(&beside).enumerate() {
        match system.supply.owner(dof) {
            Some(region) => {
                regions[region].add(inflow - beside.made);
                regions[region].unsure += beside.unsure;
                cavity += beside.made;
            }
            None if solution.cavity[dof] && solution.film_fraction.is_none() => cavity += inflow,
            None => {}
        }
    }
    for (shared, unsure) in junction::unsure(film, &beside) {
        for region in shared {
            regions[region].unsure += unsure;
        }
    }
    let taken_up = taken_up(film);
    let throughput = regions.iter().map(|region| region.inward).sum::<f64>() + cavity.max(0.0) + (-taken_up).max(0.0);
    let net: f64 = regions.iter().map(|region| region.net).sum();
    let natural = reference_flow(problem, system);
    Flows {
        imbalance: if throughput > STILL * natural {
            ((net + cavity - taken_up) / throughput.max(HARDLY * natural)).abs()
        } else {
            0.0
        },
        regions,
        throughput,
        taken_up,
        cavity,
    }
}

impl Flows {
    /// What a cavity makes over the oil that passes; negative where it loses some.
    pub fn made(&self) -> f64 {
        let sum = |part: fn(&RegionFlow) -> f64| self.regions.iter().map(part).sum::<f64>();
        match f64::max(sum(|region| region.inward), sum(|region| region.outward)) {
            0.0 => 0.0,
            passing => self.cavity / passing,
        }
    }
}

impl RegionFlow {
    fn add(&mut self, inflow: f64) {
        self.net += inflow;
        self.inward += inflow.max(0.0);
        self.outward += (-inflow).max(0.0);
    }
}

/// True if a term takes oil up where the film grows.
fn stores(problem: &FilmProblem) -> bool {
    let growing = FilmPoint { rate: 1.0, ..FilmPoint::default() };
    problem.terms.iter().any(|term| {
        let mut flow = FilmFlow::default();
        term.add(&growing, &mut flow);
        flow.storage != 0.0
    })
}

/// `Int theta dh/dt dA` [m3/s], with a history `Int d(theta h)/dt dA`, as the discrete equations have it.
fn taken_up(film: &SolvedFilm) -> f64 {
    let SolvedFilm { problem, system, solution } = film;
    if let Some(before) = &problem.storage {
        // The film was solved on the sub-mesh that is asked for; without it there is no number.
        let held = film.oil_held().ok().flatten();
        return held.map_or(f64::NAN, |held| before.taken_up(&held).iter().sum());
    }
    if !stores(problem) {
        return 0.0;
    }
    let law = FilmLaw::new(problem, 1.0);
    let mesh = system.space().mesh();
    let cells = 0..mesh.triangles().len();
    match &solution.film_fraction {
        Some(fraction) => cells.map(|t| taken_up_by_volumes(&law, system, fraction, t)).sum(),
        None => {
            let rule = Rule::for_degree(system.space().degree());
            let in_cell = |t: usize| {
                rule.integrate(mesh, t, |points, sum: &mut f64| {
                    let flows = law.film_and_flows(t, points.positions).1;
                    (0..points.positions.len()).for_each(|q| *sum += points.area(q) * flows[q].storage);
                })
            };
            cells.map(in_cell).sum()
        }
    }
}

/// Each piece of a cell as if the rate were linear: the centroid of the piece lies at (22, 7, 7)/36.
fn taken_up_by_volumes(law: &FilmLaw, system: &FilmSystem, fraction: &FilmFraction, t: usize) -> f64 {
    let (nodes, dofs) = (system.space().mesh().nodes(t), system.space().element_dofs(t));
    let flows = law.film_and_flows(t, &nodes).1;
    let sub_triangle = |corners: &[usize; 3]| {
        let area = triangle_area(corners.map(|node| nodes[node]));
        let rates = corners.map(|node| flows[node].storage);
        let all: f64 = rates.iter().sum();
        let pieces = (0..3).map(|i| fraction.values[dofs[corners[i]]] * (7.0 * all + 15.0 * rates[i]));
        area / 108.0 * pieces.sum::<f64>()
    };
    sub_triangles(system.space(), t).iter().map(sub_triangle).sum()
}
