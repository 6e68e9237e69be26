//! What the answer to a scene may contain.

use oilwedge_scene::{CavitationModel, Scene, Viscosity};

use crate::effects::Sockets;
use crate::scope::Scope;

impl Scope {
    /// The scope of a scene.
    pub fn of(scene: &Scene) -> Self {
        let sockets = Sockets::of(scene);
        Self {
            orbit: scene.orbit,
            is_loaded: scene.journal.load().is_some(),
            speed: scene.journal.speed,
            moves: sockets.centre_velocity.speed() > 0.0 || sockets.tilt_rate != [0.0; 2],
            can_tilt: scene.can_tilt(),
            is_circular: scene.is_circular(),
            has_shape_along_the_axis: scene.has_shape_along_the_axis(),
            groups: scene.feeds.iter().map(|feed| feed.group.clone()).collect(),
            is_fed: scene.feeds.iter().any(|feed| feed.pressure.is_some()),
            cavitation: scene.cavitation.map_or(CavitationModel::None, |cavitation| cavitation.model),
            touches: sockets.contact.is_some(),
            is_turbulent: scene.turbulence.is_some(),
            gives_way: sockets.wall.is_some(),
            is_by_temperature: matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)),
            thermal: sockets.thermal,
            has_heat_field: sockets.heat_field.is_some(),
            has_heat_bush: scene.heat.and_then(|heat| heat.field?.bush).is_some(),
            dynamics: sockets.dynamics,
            deviation_scale: scene.deviation_scale(),
            cap: scene.cap,
        }
    }
}
