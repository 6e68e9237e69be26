//! A mesh without a scene: the liner is the one that its nodes lie on.

use std::path::Path;

use super::{LinerDomain, cylinder, place, unroll};
use crate::gmsh::{self, MshFile};
use crate::{Error, Mesh};

/// Reads a gmsh file, its lengths in metres, as the liner that its nodes show: to be looked at, not solved.
///
/// An unrolled arc does not show its radius; one radian is taken for its width.
///
/// # Errors
/// Those of [`gmsh::read`], of [`unroll`] and of [`Mesh::build`], with the path.
pub fn read_alone(path: impl AsRef<Path>) -> Result<Mesh, Error> {
    let path = path.as_ref();
    alone(&gmsh::read(path)?).map_err(|error| error.in_file(path))
}

/// The mesh of a gmsh file, as [`read_alone`] makes it.
///
/// # Errors
/// Those of [`unroll`] and of [`Mesh::build`].
pub fn alone(file: &MshFile) -> Result<Mesh, Error> {
    Ok(Mesh::build(unroll(file, &liner_of(file)?, 1.0)?)?)
}

fn liner_of(file: &MshFile) -> Result<LinerDomain, Error> {
    let mut used = vec![false; file.nodes.len()];
    for &vertex in file.triangles.iter().flatten() {
        used[vertex as usize] = true;
    }
    let is_ring = file.curve("arc_from").is_none();
    let along = |coordinate: &dyn Fn([f64; 3]) -> f64| {
        let values = used.iter().zip(&file.nodes).filter(|(used, _)| **used);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (_, &node)| {
            (low.min(coordinate(node)), high.max(coordinate(node)))
        })
    };
    let size = along(&|node| node[0].abs().max(node[1].abs())).1;
    Ok(match cylinder::FileSurface::find(file, &used, size)? {
        cylinder::FileSurface::Plane => {
            let (low, high) = along(&|node| node[0]);
            let (bottom, top) = along(&|node| node[1]);
            let width = high - low;
            let radius = if is_ring { width / std::f64::consts::TAU } else { width };
            LinerDomain { radius, length: top - bottom, arc: (!is_ring).then(|| (low / radius, high / radius)) }
        }
        cylinder::FileSurface::Cylinder { axis, section } => {
            let (bottom, top) = along(&|node| node[axis]);
            let [a, b] = section.centre;
            let around = |&node: &[f64; 3]| {
                let [x, y] = cylinder::across(node, axis);
                [(y - b).atan2(x - a), 0.0]
            };
            let angles: Vec<[f64; 2]> = file.nodes.iter().map(around).collect();
            let arc = place::film_interval(&angles, &used, std::f64::consts::TAU);
            LinerDomain { radius: section.radius, length: top - bottom, arc: (!is_ring).then_some(arc) }
        }
    })
}
