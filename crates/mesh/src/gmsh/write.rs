//! Writes a mesh as gmsh 4.1 text: 6-node triangles, 3-node lines, named groups.
//!
//! A ring is cut open for gmsh: vertices and edges on the cut are written twice, once on each side,
//! in the groups `seam_low` and `seam_high` and as pairs in `$Periodic`.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

use crate::{Error, Mesh, Region};

const SEAM: [&str; 2] = ["seam_low", "seam_high"];
const NONE: u32 = u32::MAX;

/// Writes `mesh` to a file: developed coordinates [m] with `x = R phi`, `y = z`. The same mesh
/// gives the same bytes, and [`crate::developed::read`] gives the mesh back.
///
/// # Errors
/// The file cannot be written.
pub fn write(mesh: &Mesh, path: impl AsRef<Path>) -> Result<(), Error> {
    let path = path.as_ref();
    std::fs::write(path, to_text(mesh)).map_err(|error| Error::Io { action: "write", path: path.to_owned(), error })
}

/// The text that [`write()`] writes.
pub fn to_text(mesh: &Mesh) -> String {
    let sheet = PlaneLayout::new(mesh);
    let curves = sheet.curves();
    let (surface_names, surfaces) = surfaces(mesh);
    let mut text = String::from("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    // Writing to a String cannot fail.
    let _ = sheet.names_and_entities(&mut text, &curves, &surface_names, &surfaces);
    let _ = sheet.nodes_and_elements(&mut text, &curves, &surfaces);
    let _ = sheet.periodic(&mut text, &curves);
    text
}

/// Triangles that belong to the same groups: the groups, then the triangles.
type GroupedTriangles = (Vec<usize>, Vec<usize>);

/// Names of the surface groups, and the triangles by the groups that they share.
fn surfaces(mesh: &Mesh) -> (Vec<String>, Vec<GroupedTriangles>) {
    let regions: Vec<&Region> = mesh.regions().iter().filter(|region| !region.cells.is_empty()).collect();
    let mut names: Vec<String> = regions.iter().map(|region| region.name.clone()).collect();
    let mut groups_of = vec![Vec::new(); mesh.triangles().len()];
    for (group, region) in regions.iter().enumerate() {
        for &cell in &region.cells {
            groups_of[cell as usize].push(group);
        }
    }
    if !names.iter().any(|name| name == "film") {
        groups_of.iter_mut().for_each(|groups| groups.push(names.len()));
        names.push("film".to_owned());
    }
    let mut surfaces: BTreeMap<Vec<usize>, Vec<usize>> = BTreeMap::new();
    for (t, groups) in groups_of.into_iter().enumerate() {
        surfaces.entry(groups).or_default().push(t);
    }
    (names, surfaces.into_iter().collect())
}

/// The mesh laid out in the plane. Vertices and mid-side nodes that a triangle takes one period
/// further on are nodes of their own.
struct PlaneLayout<'a> {
    mesh: &'a Mesh,
    positions: Vec<[f64; 2]>,
    /// Node of each vertex, then of each edge: where it lies, and one period further on.
    of_thing: Vec<[u32; 2]>,
}

impl<'a> PlaneLayout<'a> {
    fn new(mesh: &'a Mesh) -> Self {
        let things = mesh.points().len() + mesh.topology().edges.len();
        let mut position = vec![[None; 2]; things];
        for t in 0..mesh.triangles().len() {
            for ((thing, side), place) in placed(mesh, t).into_iter().zip(mesh.nodes(t)) {
                position[thing][side].get_or_insert(place);
            }
        }
        let mut positions = Vec::with_capacity(things);
        let mut of_thing = vec![[NONE; 2]; things];
        for (nodes, places) in of_thing.iter_mut().zip(position) {
            for (node, place) in nodes.iter_mut().zip(places) {
                if let Some(place) = place {
                    *node = positions.len() as u32;
                    positions.push(place);
                }
            }
        }
        Self { mesh, positions, of_thing }
    }

    /// The six nodes of triangle `t`.
    fn triangle(&self, t: usize) -> [u32; 6] {
        placed(self.mesh, t).map(|(thing, side)| self.of_thing[thing][side])
    }

    /// Ends and middle of an edge, on the wanted side of the cut if it is there.
    fn line(&self, edge: u32, side: usize) -> [u32; 3] {
        let middle = self.mesh.points().len() + edge as usize;
        let wanted = if self.of_thing[middle][side] == NONE { 1 - side } else { side };
        let node = self.of_thing[middle][wanted];
        let triangles = self.mesh.topology().edge_triangles[edge as usize];
        let lines = triangles.into_iter().filter(|&t| t != NONE).map(|t| {
            let k = self.mesh.local_edge(t as usize, edge);
            let nodes = self.triangle(t as usize);
            [nodes[k], nodes[(k + 1) % 3], nodes[3 + k]]
        });
        lines.into_iter().find(|line| line[2] == node).unwrap_or([node; 3])
    }

    /// Named curves as lines of three nodes, the sides of the cut among them.
    fn curves(&self) -> Vec<(String, Vec<[u32; 3]>)> {
        let first_edge = self.mesh.points().len();
        let cut = self.of_thing[first_edge..].iter();
        let cut: Vec<u32> = (0..).zip(cut).filter(|(_, n)| !n.contains(&NONE)).map(|(edge, _)| edge).collect();
        let side = |side: usize| cut.iter().map(|&edge| self.line(edge, side)).collect::<Vec<_>>();
        let mut curves = Vec::new();
        for region in self.mesh.regions().iter().filter(|region| !region.edges.is_empty()) {
            let lines = match SEAM.iter().position(|name| *name == region.name) {
                Some(which) if !cut.is_empty() => side(which),
                _ => region.edges.iter().map(|&edge| self.line(edge, 0)).collect(),
            };
            curves.push((region.name.clone(), lines));
        }
        if !cut.is_empty() {
            for (which, name) in SEAM.iter().enumerate() {
                if !curves.iter().any(|(group, _)| group == name) {
                    curves.push(((*name).to_owned(), side(which)));
                }
            }
        }
        curves
    }

    /// Least and greatest coordinates of some nodes, as `$Entities` wants them.
    fn extent(&self, nodes: impl Iterator<Item = u32>) -> String {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for node in nodes {
            for k in 0..2 {
                low[k] = low[k].min(self.positions[node as usize][k]);
                high[k] = high[k].max(self.positions[node as usize][k]);
            }
        }
        format!("{} {} 0 {} {} 0", low[0], low[1], high[0], high[1])
    }

    fn names_and_entities(
        &self,
        text: &mut String,
        curves: &[(String, Vec<[u32; 3]>)],
        surface_names: &[String],
        surfaces: &[GroupedTriangles],
    ) -> std::fmt::Result {
        writeln!(text, "$PhysicalNames\n{}", curves.len() + surface_names.len())?;
        for (tag, (name, _)) in (1..).zip(curves) {
            writeln!(text, "1 {tag} \"{name}\"")?;
        }
        for (tag, name) in (1..).zip(surface_names) {
            writeln!(text, "2 {tag} \"{name}\"")?;
        }
        writeln!(text, "$EndPhysicalNames\n$Entities\n0 {} {} 0", curves.len(), surfaces.len())?;
        for (tag, (_, lines)) in (1..).zip(curves) {
            let extent = self.extent(lines.iter().flatten().copied());
            writeln!(text, "{tag} {extent} 1 {tag} 0")?;
        }
        for (tag, (groups, cells)) in (1..).zip(surfaces) {
            let extent = self.extent(cells.iter().flat_map(|&t| self.triangle(t)));
            write!(text, "{tag} {extent} {}", groups.len())?;
            for group in groups {
                write!(text, " {}", group + 1)?;
            }
            writeln!(text, " 0")?;
        }
        writeln!(text, "$EndEntities")
    }

    fn nodes_and_elements(
        &self,
        text: &mut String,
        curves: &[(String, Vec<[u32; 3]>)],
        surfaces: &[GroupedTriangles],
    ) -> std::fmt::Result {
        let count = self.positions.len();
        writeln!(text, "$Nodes\n1 {count} 1 {count}\n2 1 0 {count}")?;
        for tag in 1..=count {
            writeln!(text, "{tag}")?;
        }
        for [x, z] in &self.positions {
            writeln!(text, "{x} {z} 0")?;
        }
        let lines: usize = curves.iter().map(|(_, lines)| lines.len()).sum();
        let count = lines + self.mesh.triangles().len();
        let blocks = curves.len() + surfaces.len();
        writeln!(text, "$EndNodes\n$Elements\n{blocks} {count} 1 {count}")?;
        let mut element = 0;
        let mut write_nodes = |text: &mut String, nodes: &[u32]| {
            element += 1;
            write!(text, "{element}")?;
            nodes.iter().try_for_each(|node| write!(text, " {}", node + 1))?;
            writeln!(text)
        };
        for (tag, (_, lines)) in (1..).zip(curves) {
            writeln!(text, "1 {tag} 8 {}", lines.len())?;
            for line in lines {
                write_nodes(text, line)?;
            }
        }
        for (tag, (_, cells)) in (1..).zip(surfaces) {
            writeln!(text, "2 {tag} 9 {}", cells.len())?;
            for &t in cells {
                write_nodes(text, &self.triangle(t))?;
            }
        }
        writeln!(text, "$EndElements")
    }

    fn periodic(&self, text: &mut String, curves: &[(String, Vec<[u32; 3]>)]) -> std::fmt::Result {
        let Some(period) = self.mesh.period() else {
            return Ok(());
        };
        let entity = |name: &str| curves.iter().position(|(group, _)| group == name).map(|place| place + 1);
        let (Some(low), Some(high)) = (entity(SEAM[0]), entity(SEAM[1])) else {
            return Ok(());
        };
        let pairs: Vec<_> = self.of_thing.iter().filter(|nodes| !nodes.contains(&NONE)).collect();
        writeln!(text, "$Periodic\n1\n1 {high} {low}")?;
        writeln!(text, "16 1 0 0 {period} 0 1 0 0 0 0 1 0 0 0 0 1\n{}", pairs.len())?;
        for [low, high] in pairs {
            writeln!(text, "{} {}", high + 1, low + 1)?;
        }
        writeln!(text, "$EndPeriodic")
    }
}

/// Vertices and edges (counted after the vertices) of triangle `t` in the order of its nodes, and
/// whether it takes them where they lie (0) or one period further on (1).
fn placed(mesh: &Mesh, t: usize) -> [(usize, usize); 6] {
    let triangle = mesh.triangles()[t];
    let corners = mesh.corners(t);
    let moved = |k: usize| corners[k % 3][0] != mesh.points()[triangle[k % 3] as usize][0];
    std::array::from_fn(|node| {
        if node < 3 {
            (triangle[node] as usize, usize::from(moved(node)))
        } else {
            let k = node - 3;
            let edge = mesh.points().len() + mesh.topology().triangle_edges[t][k] as usize;
            // With one end moved the edge lies across the end of the period, for both its triangles.
            (edge, usize::from(moved(k) && moved(k + 1)))
        }
    })
}
