//! The dimensions of a scene's bearing, as films know them.

use oilwedge_reynolds::Bearing;
use oilwedge_scene::Scene;

/// Radius, length, clearance and end pressure of the bearing of a scene.
pub(crate) fn bearing(scene: &Scene) -> Bearing {
    Bearing {
        radius: scene.bearing.radius(),
        length: scene.bearing.length,
        clearance: scene.bearing.clearance,
        end_pressure: scene.ends.pressure,
    }
}
