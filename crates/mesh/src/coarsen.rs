//! A coarser mesh of the same liner, without its features, graded as the finer one is.
//!
//! Nested iteration solves a film on coarser meshes first, to learn where it breaks. Such a mesh need not know
//! holes and grooves: it fills the whole developed rectangle. The edge length there is that of the finer mesh at
//! the same place, times a ratio.

use crate::developed::LinerDomain;
use crate::generate::{Blueprint, DrawingError, Sense, generate, generate_in_rows_like};
use crate::size_tree::SizeTree;
use crate::{Locator, Mesh};

/// Fewer triangles than this make no mesh to start from.
const FEWEST: usize = 60;
/// Edge length asked of the generator over that which it makes of it, by the areas of the triangles: measured, so
/// that twice the edge length leaves a quarter of the unknowns.
const ASKED: f64 = 1.1;

/// A coarser mesh and where its triangles lie in the finer one.
#[derive(Debug, Clone)]
pub struct Coarser {
    /// The coarser mesh: regions `film`, `end_low`, `end_high`, and of an arc `arc_from`, `arc_to`.
    pub mesh: Mesh,
    /// Triangle of the finer mesh for each triangle of the coarser one: it holds its centroid, or is the nearest where
    /// that lies in a cut-out.
    pub parents: Vec<u32>,
}

/// The plain mesh of `liner` whose edges are `ratio` times as long as those of `mesh` at the same place.
///
/// `mesh` is a mesh of `liner`, with or without features; `line` is the angle [rad] of an axial line that must be
/// a line of edges, as in [`Blueprint::line`]. None if `mesh` is of another kind of liner (ring, arc), if so few
/// triangles are left that the mesh would be of no use, or if it cannot be made.
pub fn coarser(mesh: &Mesh, liner: &LinerDomain, line: Option<f64>, ratio: f64) -> Option<Coarser> {
    let sizes = SizeTree::new(mesh);
    let size = |point| ASKED * ratio * sizes.at(point);
    made(mesh, liner, line, |blueprint| generate(blueprint, &size))
}

/// The mesh of [`coarser`] in rows along a flow in this sense, with columns and rows as unlike as those of `mesh`: oil
/// is not spread across the flow.
pub fn coarser_in_rows(
    mesh: &Mesh,
    liner: &LinerDomain,
    line: Option<f64>,
    ratio: f64,
    sense: Sense,
) -> Option<Coarser> {
    made(mesh, liner, line, |blueprint| generate_in_rows_like(blueprint, mesh, ratio, sense))
}

/// The mesh that `generate` makes of the liner without features.
fn made(
    mesh: &Mesh,
    liner: &LinerDomain,
    line: Option<f64>,
    generate: impl Fn(&Blueprint) -> Result<Mesh, Vec<DrawingError>>,
) -> Option<Coarser> {
    if liner.arc.is_none() != mesh.period().is_some() {
        return None;
    }
    let blueprint = Blueprint { liner: *liner, features: Vec::new(), line };
    let coarse = generate(&blueprint).ok()?;
    if coarse.triangles().len() < FEWEST {
        return None;
    }
    let locator = Locator::new(mesh);
    let parents: Option<Vec<u32>> =
        (0..coarse.triangles().len()).map(|t| Some(locator.nearest(centroid(&coarse, t))?.0 as u32)).collect();
    Some(Coarser { mesh: coarse, parents: parents? })
}

fn centroid(mesh: &Mesh, t: usize) -> [f64; 2] {
    let corners = mesh.corners(t);
    [0, 1].map(|d| (corners[0][d] + corners[1][d] + corners[2][d]) / 3.0)
}
