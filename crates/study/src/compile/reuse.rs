//! A study for another operating point of the same bearing: physics is compiled anew, mesh and numbering stay.

use std::mem::discriminant;

use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};

use super::{Study, problem, supply_pressure};
use crate::effects::{Effects, Sockets};
use crate::oil::Oil;
use oilwedge_scene::Scene;

/// Whether two scenes make the same system of the same mesh, but for given pressures and the film's thickness.
pub fn has_same_system(one: &Scene, other: &Scene) -> bool {
    let bearing = |scene: &Scene| {
        let bearing = &scene.bearing;
        (bearing.diameter, bearing.length, bearing.arc, bearing.film_start)
    };
    let system = |scene: &Scene| {
        let sockets = Sockets::of(scene);
        let closure = (sockets.form, discriminant(&sockets.cavitation));
        (sockets.theory, sockets.inlet_fraction, closure, sockets.load.is_some())
    };
    one.mesh == other.mesh
        && bearing(one) == bearing(other)
        && system(one) == system(other)
        && have_same_regions(one, other)
}

/// Whether the feeds are the same regions. Of several ones the pressures must be the same too: where they touch, only equal ones fit.
fn have_same_regions(one: &Scene, other: &Scene) -> bool {
    let several = one.feeds.len() > 1;
    one.feeds.len() == other.feeds.len()
        && one.feeds.iter().zip(&other.feeds).all(|(a, b)| {
            let given = match several {
                true => a.pressure == b.pressure,
                false => a.pressure.is_some() == b.pressure.is_some(),
            };
            given && (&a.group, a.hole, a.groove) == (&b.group, b.hole, b.groove)
        })
}

/// The study of `scene` on the system of another one, which [`has_same_system`]; the journal at the position `near`.
pub fn reused(mut study: Study, scene: &Scene, near: (f64, f64)) -> Study {
    let sockets = Sockets::of(scene);
    (study.load, study.centre_velocity) = (sockets.load, sockets.centre_velocity);
    study.problem = problem(scene, sockets, study.system.space().mesh(), near);
    let fed = |name: &str| scene.feeds.iter().find(|feed| feed.group == name)?.pressure;
    let pressure = |region: &SupplyRegion| match region.kind {
        BoundaryKind::Feed => fed(&region.name).unwrap_or(region.pressure),
        BoundaryKind::End | BoundaryKind::Line | BoundaryKind::Sealed => scene.ends.pressure,
    };
    study.system.renew(&pressure, &study.problem.film_thickness);
    study.cap = scene.cap;
    study.oil = Oil::of(scene);
    study.heat = scene.heat;
    study.scene = scene.clone();
    study.effects = Effects::of(scene);
    study.supply_pressure = supply_pressure(scene);
    study
}
