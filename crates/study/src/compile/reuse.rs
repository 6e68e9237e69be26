//! A film for another operating point of the same bearing: physics is compiled anew, mesh and numbering stay.

use std::mem::discriminant;
use std::sync::Arc;

use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};

use super::problem;
use crate::effects::Sockets;
use crate::feed_region::feed_regions;
use crate::film::{Film, Start};
use crate::oil::Oil;
use crate::position::Position;
use oilwedge_scene::{Feed, Scene};

/// Whether two scenes make the same system of the same mesh, but for given pressures and the film's thickness.
pub fn has_same_system(one: &Scene, other: &Scene) -> bool {
    let bearing = |scene: &Scene| {
        let bearing = &scene.bearing;
        (bearing.diameter, bearing.length, bearing.arc, bearing.film_start)
    };
    let system = |scene: &Scene| {
        let sockets = Sockets::of(scene);
        let closure = (sockets.form, discriminant(&sockets.cavitation));
        (sockets.theory, sockets.inlet_fraction, closure, sockets.load.is_some() || sockets.liner.is_some())
    };
    let is_same_region = |(a, b): (&Feed, &Feed)| {
        (&a.group, a.hole, a.groove, a.pressure.is_some()) == (&b.group, b.hole, b.groove, b.pressure.is_some())
    };
    // Feeds that overlap are one region as long as their pressures are equal.
    let names = |scene| feed_regions(scene).into_iter().map(|region| region.name).collect::<Vec<String>>();
    one.mesh == other.mesh
        // Meshes are graded for the shape of the bore.
        && one.bores == other.bores
        && bearing(one) == bearing(other)
        && system(one) == system(other)
        && one.feeds.len() == other.feeds.len()
        && one.feeds.iter().zip(&other.feeds).all(is_same_region)
        && names(one) == names(other)
}

impl Film {
    /// The film of `scene` at `position` on the system of this one, whose scene [`has_same_system`]; `None` where given
    /// pressures of regions that touch would differ, a measured surface cannot be read, or another film shares the
    /// system.
    pub fn reused(self, scene: &Scene, position: Position) -> Option<Self> {
        let sockets = Sockets::of(scene);
        let (load, thermal, centre_velocity) = (sockets.load(), sockets.thermal, sockets.centre_velocity);
        let dynamics = sockets.dynamics.clone();
        let oil = Oil::of(scene);
        let mut system = self.system;
        let problem = problem(scene, &oil, sockets, system.space().mesh(), position).ok()?;
        let regions = feed_regions(scene);
        let fed = |name: &str| regions.iter().find(|region| region.name == name)?.pressure();
        let pressure = |region: &SupplyRegion| match region.kind {
            BoundaryKind::Feed => fed(&region.name).unwrap_or(region.pressure),
            BoundaryKind::End | BoundaryKind::Line | BoundaryKind::Sealed => scene.ends.pressure,
        };
        let is_renewed = Arc::get_mut(&mut system)?.renew(&pressure, &problem.film_thickness);
        // Every field by name: what another operating point may change must not stay by being forgotten here.
        is_renewed.then(|| Self {
            scene: Arc::new(scene.clone()),
            oil,
            problem,
            system,
            load,
            start: Start::default(),
            thermal,
            dynamics,
            centre_velocity,
            origin: self.origin,
            seconds: self.seconds,
        })
    }
}
