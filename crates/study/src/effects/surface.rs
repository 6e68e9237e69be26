//! The profile of a surface: its numbers, or the table that it is measured by.

use std::sync::Arc;

use oilwedge_reynolds::Bearing;
use oilwedge_reynolds::film_thickness::{Crown, Envelope, MeasuredSurface, Oval, Profile, SurfaceGrid, Wearing, Worn};
use oilwedge_scene::periodic_table::TableError;
use oilwedge_scene::surface_table::{Covered, SurfacePoints, WearingPosition, read_bore, read_positions, read_shaft};
use oilwedge_scene::{Bore, JournalShape};

use super::ShapedSurface;

impl ShapedSurface {
    /// Shape of the surface, that of a measured one read from its file.
    ///
    /// # Errors
    /// The table of a measured surface cannot be used.
    pub(crate) fn profile(&self, bearing: &Bearing, covered: Covered) -> Result<Arc<dyn Profile>, TableError> {
        let radius = bearing.radius;
        let crown = |depth: f64| Crown { depth, half_length: 0.5 * bearing.length };
        let measured = |SurfacePoints { angles, zs, depths }: SurfacePoints| {
            let points = SurfaceGrid { angles, zs, depths };
            MeasuredSurface::new(&points, radius, bearing.length, covered.arc.is_none())
        };
        Ok(match self {
            &Self::Bore(Bore::Crown(depth)) | &Self::Shaft(JournalShape::Crown(depth)) => Arc::new(crown(depth)),
            &Self::Bore(Bore::Oval { depth, angle }) => Arc::new(Oval { radius, depth, angle }),
            &Self::Bore(Bore::Worn { depth, angle, half_width }) => Arc::new(Worn { radius, depth, angle, half_width }),
            Self::Bore(Bore::Envelope { path, film }) => {
                let positions = read_positions(path, bearing.clearance)?.into_iter();
                let positions: Vec<Wearing> =
                    positions.map(|WearingPosition { offset, tilt }| Wearing { offset, tilt }).collect();
                Arc::new(Envelope::new(bearing, *film, &positions))
            }
            Self::Bore(Bore::Measured(path)) => Arc::new(measured(read_bore(path, covered)?)),
            Self::Shaft(JournalShape::Measured(path)) => Arc::new(measured(read_shaft(path, covered)?)),
        })
    }
}
