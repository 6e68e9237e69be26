//! Named sets of edges and cells: ends, arc edges, seams, feeds. And circles with the edges on them.

use crate::defect::MOST_DEFECTS;
use crate::{Circle, Defect, RawMesh, Topology};

/// A named part of the liner. A gmsh physical curve gives `edges`, a physical surface `cells`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region {
    /// Name of the physical group.
    pub name: String,
    /// Edges of the curve of that name, ascending.
    pub edges: Vec<u32>,
    /// Triangles of the surface of that name, ascending.
    pub cells: Vec<u32>,
}

/// The groups of `raw` in the numbers of the mesh.
pub(crate) fn regions(
    raw: &RawMesh,
    new_of_old: &[u32],
    triangle_of_old: &[u32],
    topology: &Topology,
    defects: &mut Vec<Defect>,
) -> Vec<Region> {
    let mut regions: Vec<Region> = Vec::new();
    for (name, pairs) in &raw.curves {
        let edges = edges_of(raw, pairs, new_of_old, topology, defects, || name.clone());
        region_named(&mut regions, name).edges.extend(edges);
    }
    for (name, cells) in &raw.surfaces {
        let cells = cells.iter().map(|&old| triangle_of_old[old as usize]);
        region_named(&mut regions, name).cells.extend(cells);
    }
    for region in &mut regions {
        region.edges.sort_unstable();
        region.edges.dedup();
        region.cells.sort_unstable();
        region.cells.dedup();
    }
    regions
}

/// The circles of `raw`, each with its edges in the numbers of the mesh.
pub(crate) fn circles(
    raw: &RawMesh,
    new_of_old: &[u32],
    topology: &Topology,
    defects: &mut Vec<Defect>,
) -> Vec<(Circle, Vec<u32>)> {
    let mut circles = Vec::with_capacity(raw.circles.len());
    for (circle, pairs) in &raw.circles {
        let [x, z] = circle.centre;
        let name = || format!("circle about ({x:.6}, {z:.6})");
        let mut edges = edges_of(raw, pairs, new_of_old, topology, defects, name);
        edges.sort_unstable();
        edges.dedup();
        circles.push((*circle, edges));
    }
    circles
}

/// The edges between pairs of vertices of `raw`; a defect, with that name, of each that there is not.
fn edges_of(
    raw: &RawMesh,
    pairs: &[[u32; 2]],
    new_of_old: &[u32],
    topology: &Topology,
    defects: &mut Vec<Defect>,
    name: impl Fn() -> String,
) -> Vec<u32> {
    let mut edges = Vec::with_capacity(pairs.len());
    for pair in pairs {
        let [a, b] = pair.map(|v| new_of_old[v as usize]);
        let known = a != u32::MAX && b != u32::MAX;
        match known.then(|| topology.edge_between(a, b)).flatten() {
            Some(edge) => edges.push(edge),
            None if defects.len() >= MOST_DEFECTS => {}
            None => defects.push(Defect::LooseEdge { group: name(), nodes: pair.map(|v| raw.label(v)) }),
        }
    }
    edges
}

fn region_named<'a>(regions: &'a mut Vec<Region>, name: &str) -> &'a mut Region {
    let place = regions.iter().position(|region| region.name == name).unwrap_or_else(|| {
        regions.push(Region { name: name.to_owned(), edges: Vec::new(), cells: Vec::new() });
        regions.len() - 1
    });
    &mut regions[place]
}
