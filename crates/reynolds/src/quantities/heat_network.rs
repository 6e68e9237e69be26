//! # A mass-conserving film as a network of heat
//!
//! **Equation.** The cell of each node exchanges with its neighbours what its balance of oil has:
//! `-B_ij theta_j` is dragged from node j to node i, `K_ij (q_j - q_i)` is driven from i to j
//! ([`crate::cavitation`]). What the flows of the film leave over in a cell comes through its part of the boundary. The
//! heat of the cells adds up to that of [`super::power`]: half of what the flow along a side works, and for shear the
//! share of the node in that of its triangle by `theta/(h F0)`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | B, K | m3/s, m3/(Pa s) | `transport`, `stiffness` |
//!
//! **Source.** `docs/theory/thermal_film.md`. **Range.** Steady films that conserve oil, without squeeze. Triangles
//! that a feed covers are none of it. **Verified by** `tests/tests/thermal_film.rs`: the cells conserve oil, and their
//! heat is the power of the film.

use oilwedge_fem::Error;
use oilwedge_heat::{FilmCell, FilmLink, FilmPort, PortKind};

use super::power::{excess, shear_of_triangles, shear_viscosity};
use crate::SolvedFilm;
use crate::cavitation::{FilmSides, film_sides};
use crate::film_law::FilmLaw;
use crate::supply::BoundaryKind;

/// Film fraction of a cell that no oil reaches: its little oil is as warm as the walls.
const EMPTY: f64 = 1e-9;

/// A film as a network of cells between which oil carries heat.
#[derive(Debug, Clone, Default)]
pub struct NodeNetwork {
    /// Dof of each cell.
    pub dofs: Vec<usize>,
    /// The cells.
    pub cells: Vec<FilmCell>,
    /// Flows between cells.
    pub links: Vec<FilmLink>,
    /// Flows through the boundary; those of feeds name the feed by its place in `feeds`.
    pub ports: Vec<FilmPort>,
    /// Number of each feed among the regions of the supply.
    pub feeds: Vec<usize>,
    /// What makes the eddies of a turbulent film; none of a laminar one.
    pub eddies: Option<EddySources>,
}

/// What makes the eddies of a turbulent film.
#[derive(Debug, Clone, PartialEq)]
pub struct EddySources {
    /// Film thickness at every dof [m].
    pub gaps: Vec<f64>,
    /// Speed of the journal's surface [m/s].
    pub speed: f64,
    /// Density of the oil [kg/m3].
    pub density: f64,
}

impl EddySources {
    /// What makes the eddies of this film; none where it is laminar.
    pub fn of(film: &SolvedFilm) -> Option<Self> {
        let SolvedFilm { problem, system, .. } = film;
        if problem.is_laminar() {
            return None;
        }
        let (space, mesh) = (system.space(), system.space().mesh());
        let mut gaps = vec![0.0; space.dofs()];
        for t in 0..mesh.triangles().len() {
            let places = mesh.nodes(t);
            for (&dof, place) in space.element_dofs(t).iter().zip(&places) {
                gaps[dof] = problem.thickness_at(t, &[*place])[0];
            }
        }
        let [x, z] = problem.surface_velocity();
        Some(Self { gaps, speed: x.hypot(z), density: problem.lubricant.density })
    }
}

/// What the triangles of a film make of its cells.
#[derive(Debug, Clone, Copy, Default)]
struct CellSums {
    area: f64,
    volume: f64,
    shear: f64,
    driven: f64,
    cross: f64,
    /// Flow that all links take away [m3/s].
    leaving: f64,
    /// Integral of the gradient of the node's linear function: its part of the boundary, turned inwards [m].
    inward: [f64; 2],
}

/// The network of a film; oil that comes in at the ends has the temperature `inlet` [K]. `None` where the film does not
/// conserve oil.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub fn heat_network(film: &SolvedFilm, inlet: f64) -> Result<Option<NodeNetwork>, Error> {
    let SolvedFilm { problem, system, solution } = film;
    let Some(fraction) = &solution.film_fraction else {
        return Ok(None);
    };
    let sides = film_sides(film)?;
    let mut sums = vec![CellSums::default(); system.space().dofs()];
    add_shear(film, &shear_of_triangles(film), &mut sums);
    add_geometry(film, &sides, &mut sums);
    for side in &sides.sides {
        sums[side.from].leaving += side.dragged + side.driven;
        sums[side.to].leaving -= side.dragged + side.driven;
        let half = 0.5 * side.driven_power;
        sums[side.from].driven += half;
        sums[side.to].driven += half;
    }
    let dofs: Vec<usize> = (0..sums.len()).filter(|&dof| sums[dof].area > 0.0).collect();
    let mut cell_of = vec![usize::MAX; sums.len()];
    dofs.iter().enumerate().for_each(|(cell, &dof)| cell_of[dof] = cell);
    let positions = system.space().positions();
    let cell = |&dof: &usize| {
        let (sum, [x, z]) = (&sums[dof], positions[dof]);
        FilmCell {
            thickness: sum.volume / sum.area,
            film_fraction: fraction.values[dof].clamp(EMPTY, 1.0),
            wall_area: sum.area,
            shear_power: sum.shear,
            driven_power: sum.driven,
            cross_power: sum.cross,
            angle: x / problem.bearing.radius,
            along: z / problem.bearing.length,
        }
    };
    let cells: Vec<FilmCell> = dofs.iter().map(cell).collect();
    let regions = system.supply.regions();
    let feeds: Vec<usize> = (0..regions.len()).filter(|&k| regions[k].kind == BoundaryKind::Feed).collect();
    let velocity = problem.surface_velocity();
    let ports = cells.iter().zip(&dofs).enumerate().filter_map(|(cell, (at, &dof))| {
        let owner = system.supply.owner(dof)?;
        let sum = &sums[dof];
        let drag = problem.viscosity_across.as_ref().map_or(0.5, |across| across.drag(dof));
        let through = velocity[0] * sum.inward[0] + velocity[1] * sum.inward[1];
        let dragged = at.film_fraction * drag * at.thickness * through;
        let kind = match feeds.iter().position(|&feed| feed == owner) {
            Some(feed) => PortKind::Feed(feed),
            None => PortKind::Opening { temperature: inlet },
        };
        Some(FilmPort { cell, kind, dragged, driven: sum.leaving - dragged })
    });
    let ports = ports.collect();
    let links = sides.sides.iter().map(|side| FilmLink {
        from: cell_of[side.from],
        to: cell_of[side.to],
        dragged: side.dragged,
        driven: side.driven,
    });
    let links = links.collect();
    Ok(Some(NodeNetwork { dofs, cells, links, ports, feeds, eddies: EddySources::of(film) }))
}

/// Adds to the nodes what shear makes of heat: that of each triangle by `theta/(h F0)` at its nodes.
fn add_shear(film: &SolvedFilm, of_triangles: &[f64], sums: &mut [CellSums]) {
    let SolvedFilm { problem, system, solution } = film;
    let (space, mesh) = (system.space(), system.space().mesh());
    let law = FilmLaw::new(problem, 1.0);
    let theta = |dof: usize| solution.film_fraction.as_ref().map_or(1.0, |fraction| fraction.values[dof].max(0.0));
    for (t, &shear) in of_triangles.iter().enumerate().filter(|(_, shear)| **shear > 0.0) {
        let dofs = space.element_dofs(t);
        let number = space.shapes();
        let points = law.film(t, &mesh.nodes(t)[..number]);
        // Corners belong to one of the four sub-triangles, middles of sides to three.
        let share = |k: usize| {
            let p = excess(problem, solution.unknown[dofs[k]]);
            let pieces = if k < 3 { 1.0 } else { 3.0 };
            pieces * theta(dofs[k]) * shear_viscosity(problem, &points[k], p) / points[k].thickness
        };
        let shares: Vec<f64> = (0..number).map(share).collect();
        let all: f64 = shares.iter().sum();
        for (k, share) in shares.iter().enumerate().filter(|_| all > 0.0) {
            sums[dofs[k]].shear += shear * share / all;
        }
    }
}

/// Adds areas, volumes, pieces of the boundary, and what shear and driven flow together move between layers.
fn add_geometry(film: &SolvedFilm, sides: &FilmSides, sums: &mut [CellSums]) {
    let velocity = film.problem.surface_velocity();
    for piece in &sides.pieces {
        let slope = [0, 1].map(|d| {
            (0..3)
                .map(|k| piece.gradients[k][d] * excess(&film.problem, film.solution.unknown[piece.dofs[k]]))
                .sum::<f64>()
        });
        let along = velocity[0] * slope[0] + velocity[1] * slope[1];
        for k in 0..3 {
            let sum = &mut sums[piece.dofs[k]];
            sum.area += piece.area / 3.0;
            sum.volume += piece.volume[k];
            sum.cross += 2.0 * along * piece.volume[k];
            (0..2).for_each(|d| sum.inward[d] -= piece.area * piece.gradients[k][d]);
        }
    }
}
