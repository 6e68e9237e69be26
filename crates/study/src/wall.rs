//! The wall of a bearing: that of its scene.

use oilwedge_reynolds::Bearing;
use oilwedge_reynolds::analytical::elastic_ring::{self, ElasticRing};
use oilwedge_reynolds::wall::{Dense, Wall};
use oilwedge_scene::compliance_table::{TableError, read_compliance};
use oilwedge_scene::{Layer, Liner, OuterSurface, WallMaterial};

/// Why a wall cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum NoWall {
    /// The file of the wall is no table of compliances.
    #[error("liner.compliance.file: {0}")]
    Table(#[from] TableError),
    /// The points of its matrix do not interpolate.
    #[error(
        "liner.compliance.file: between points along the axis that are so unevenly spaced nothing is interpolated; space them by about equal steps from end to end"
    )]
    Points,
}

/// The wall of a liner.
///
/// # Errors
/// [`NoWall`]: a matrix cannot be read, or is none of a wall.
pub(crate) fn wall(liner: &Liner, bearing: &Bearing) -> Result<Wall, NoWall> {
    let wall = match liner {
        Liner::Winkler(layer) => {
            let per_pressure = match layer {
                Layer::Given(per_pressure) => *per_pressure,
                Layer::Of(material) => ring(material, OuterSurface::Clamped, bearing).thin_layer(),
            };
            Wall::of_slices(bearing, |_| per_pressure)
        }
        Liner::Wall { of, outer } => {
            let ring = ring(of, *outer, bearing);
            Wall::of_slices(bearing, |n| ring.compliance(n))
        }
        Liner::Compliance { file } => {
            let table = read_compliance(file, bearing.length)?;
            let points = table.angles * table.axial.len();
            let displacements = Dense::from_row_slice(points, points, &table.displacements);
            Wall::of_matrix(bearing, (table.first_angle, table.angles), &table.axial, displacements)
        }
    };
    wall.ok_or(NoWall::Points)
}

/// A ring of a material around the bore of a bearing.
pub(crate) fn ring(of: &WallMaterial, outer: OuterSurface, bearing: &Bearing) -> ElasticRing {
    ElasticRing {
        radius: bearing.radius,
        thickness: of.thickness,
        modulus: of.modulus,
        poisson: of.poisson,
        outer: match outer {
            OuterSurface::Clamped => elastic_ring::RingSupport::Clamped,
            OuterSurface::Free => elastic_ring::RingSupport::Free,
        },
    }
}
