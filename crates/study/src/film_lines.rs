//! Lines on a solved film: where it breaks and where it forms again, and the rims of its feeds and pockets.
//!
//! The edge of a cavity is that of the solver's own set of nodes at the cavity pressure: in a sub-triangle with nodes
//! of both kinds it joins the middles of the sides between them, and is smoothed within the triangles. Only where the
//! pressure is cut off after the solve (Guembel) it follows the pressure. Oil flows into the cavity at a rupture and
//! out of it at a reformation.

use std::collections::HashMap;

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::supply::BoundaryKind;

use crate::cavity_line::{CavityPiece, LineSegment, place, smoothed};
use crate::film::Film;

/// Name of the line where the film breaks.
pub const RUPTURE: &str = "rupture";
/// Name of the line where it forms again.
pub const REFORMATION: &str = "reformation";
/// How the names of rims begin; the name of the feed or pocket follows.
pub const RIM: &str = "rim.";

/// How often the directions of neighbouring pieces are averaged.
const ROUNDS: usize = 12;

/// The lines of a film by name; those without a piece are left out.
pub(crate) fn film_lines(film: &Film, solved: &SolvedFilm) -> Vec<(String, Vec<LineSegment>)> {
    let [rupture, reformation] = cavity_edges(solved);
    let edges = [(RUPTURE.to_owned(), rupture), (REFORMATION.to_owned(), reformation)];
    let lines = edges.into_iter().chain(rims(film));
    lines.filter(|(_, pieces)| !pieces.is_empty()).collect()
}

/// The state of a node of the cavity.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Node {
    Full,
    Cavity,
    /// A node whose pressure is given and is no higher than that of the cavity: both meet there.
    Either,
}

/// Rupture and reformation.
fn cavity_edges(film: &SolvedFilm) -> [Vec<LineSegment>; 2] {
    let SolvedFilm { problem, system, solution } = film;
    let Some(floor) = problem.cavitation.pressure() else {
        return [Vec::new(), Vec::new()];
    };
    let mut pieces: Vec<CavityPiece> = Vec::new();
    let nodes = nodes(film, floor);
    let space = system.space();
    let excess = |dof: usize| problem.equation_pressure(solution.unknown[dof]) - floor;
    for t in 0..space.mesh().triangles().len() {
        let (dofs, positions) = (space.element_dofs(t), space.mesh().nodes(t));
        let extent = [0, 1].map(|d| {
            let places = || positions.iter().map(|node| node[d]);
            places().fold(f64::NEG_INFINITY, f64::max) - places().fold(f64::INFINITY, f64::min)
        });
        for corners in sub_triangles(space, t) {
            let of = |k: usize| nodes[dofs[corners[k % 3]]];
            let at = |k: usize| positions[corners[k % 3]];
            let crossing = |full: usize, broken: usize| {
                // Pressures of an active set are zero in the cavity; the edge is amid the side.
                let [high, low] = [full, broken].map(|k| excess(dofs[corners[k % 3]]));
                let part = if problem.cavitation.kink().is_some() { high / (high - low) } else { 0.5 };
                [0, 1].map(|d| at(full)[d] + part * (at(broken)[d] - at(full)[d]))
            };
            let sides = |k: usize| match (of(k), of(k + 1)) {
                (Node::Full, Node::Cavity) => Some(crossing(k, k + 1)),
                (Node::Cavity, Node::Full) => Some(crossing(k + 1, k)),
                _ => None,
            };
            let mut ends: Vec<[f64; 2]> = (0..3).filter_map(sides).collect();
            if ends.len() == 1 {
                ends.extend((0..3).find(|k| of(*k) == Node::Either).map(at));
            }
            let ([from, to], Some(broken)) = (ends.as_slice(), (0..3).find(|k| of(*k) == Node::Cavity)) else {
                continue;
            };
            // The normal towards the cavity.
            let mut normal = [from[1] - to[1], to[0] - from[0]];
            if (0..2).map(|d| normal[d] * (at(broken)[d] - from[d])).sum::<f64>() < 0.0 {
                normal = normal.map(|part| -part);
            }
            pieces.push(CavityPiece { piece: [*from, *to], normal, extent });
        }
    }
    let velocity = problem.surface_velocity();
    let mut edges = [Vec::new(), Vec::new()];
    let bearing = &problem.bearing;
    let pieces = match problem.cavitation.kink() {
        Some(_) => pieces,
        None => smoothed(pieces, bearing.radius, 0.5 * bearing.length),
    };
    for CavityPiece { piece, normal, .. } in with_even_normals(pieces, bearing.radius) {
        let enters = velocity[0] * normal[0] + velocity[1] * normal[1] >= 0.0;
        edges[usize::from(!enters)].push(piece);
    }
    edges
}

/// The normals averaged with those of pieces that meet: an edge that runs along the flow in steps is one or the other
/// as a whole.
fn with_even_normals(mut pieces: Vec<CavityPiece>, radius: f64) -> Vec<CavityPiece> {
    let mut at: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
    for (k, it) in pieces.iter().enumerate() {
        let places = it.piece.map(|end| place(end, radius));
        places.into_iter().for_each(|end| at.entry(end).or_default().push(k));
    }
    for _ in 0..ROUNDS {
        let normals: Vec<[f64; 2]> = (pieces.iter())
            .map(|it| {
                let around = it.piece.iter().flat_map(|end| &at[&place(*end, radius)]);
                around.fold([0.0; 2], |sum, k| [0, 1].map(|d| sum[d] + 0.25 * pieces[*k].normal[d]))
            })
            .collect();
        pieces.iter_mut().zip(normals).for_each(|(it, normal)| it.normal = normal);
    }
    pieces
}

fn nodes(film: &SolvedFilm, floor: f64) -> Vec<Node> {
    let SolvedFilm { problem, system, solution } = film;
    let space = system.space();
    let mut is_broken = solution.cavity.clone();
    if problem.cavitation.kink().is_some() {
        for (dof, is_broken) in is_broken.iter_mut().enumerate() {
            *is_broken = problem.equation_pressure(solution.unknown[dof]) <= floor;
        }
    } else if !problem.cavitation.conserves_oil() && space.degree() == 2 {
        // The obstacle holds the middles of sides; a vertex belongs to the cavity where all sides at it do.
        let edges = &space.mesh().topology().edges;
        let mut is_surrounded = vec![true; space.mesh().points().len()];
        for (edge, ends) in (0..).zip(edges) {
            if !solution.cavity[space.edge_dof(edge)] {
                ends.iter().for_each(|&end| is_surrounded[end as usize] = false);
            }
        }
        for (vertex, is_surrounded) in (0..).zip(is_surrounded) {
            is_broken[space.vertex_dof(vertex)] |= is_surrounded;
        }
    }
    let given = system.supply.regions();
    let node = |(dof, is_broken): (usize, bool)| match system.supply.owner(dof) {
        Some(region) if given[region].pressure <= floor => Node::Either,
        Some(_) => Node::Full,
        None if is_broken => Node::Cavity,
        None => Node::Full,
    };
    is_broken.into_iter().enumerate().map(node).collect()
}

/// Rims of feeds and pockets.
fn rims(film: &Film) -> Vec<(String, Vec<LineSegment>)> {
    let mesh = film.system.space().mesh();
    let feeds = film.system.supply.regions().iter().filter(|region| region.kind == BoundaryKind::Feed);
    let feeds = feeds.map(|region| (region.name.as_str(), &region.edges, &region.cells));
    let pockets = film.pockets().filter_map(|name| mesh.region(name));
    let pockets = pockets.map(|region| (region.name.as_str(), &region.edges, &region.cells));
    feeds
        .chain(pockets)
        .map(|(name, edges, cells)| {
            let own = match cells.is_empty() {
                true => edges.clone(),
                false => around(mesh, cells),
            };
            let halves = own.into_iter().flat_map(|edge| {
                let [a, b, middle] = mesh.edge_nodes(edge);
                [[a, middle], [middle, b]]
            });
            (format!("{RIM}{name}"), halves.collect())
        })
        .collect()
}

/// Edges with one of these triangles, which ascend, on one side only.
fn around(mesh: &Mesh, cells: &[u32]) -> Vec<u32> {
    let topology = mesh.topology();
    let is_own = |triangle: u32| cells.binary_search(&triangle).is_ok();
    let edges = cells.iter().flat_map(|&cell| topology.triangle_edges[cell as usize]);
    let is_rim = |edge: &u32| topology.edge_triangles[*edge as usize].iter().filter(|t| is_own(**t)).count() == 1;
    edges.filter(is_rim).collect()
}
