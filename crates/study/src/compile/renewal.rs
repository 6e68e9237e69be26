//! A study for another operating point of the same bearing: physics is compiled anew, mesh and numbering stay.

use std::mem::discriminant;

use oilwedge_reynolds::supply::{Place, SupplyRegion};

use super::{Study, centre_velocity, effects, film_thickness, journal, problem, supply_pressure};
use oilwedge_scene::scene::{PressureLaw, Scene};

/// Whether two scenes make the same system of the same mesh, but for given pressures and the film's thickness.
pub fn has_same_system(one: &Scene, other: &Scene) -> bool {
    let form = |scene: &Scene| match scene.oil.pressure_law {
        PressureLaw::Barus { form, .. } => Some(form),
        _ => None,
    };
    let model = |scene: &Scene| scene.cavitation.map(|cavitation| cavitation.model);
    let bearing = |scene: &Scene| {
        let bearing = scene.bearing.clone();
        (
            bearing.diameter,
            bearing.length,
            bearing.arc,
            bearing.inlet_fraction,
            bearing.film_start,
            bearing.theory,
        )
    };
    one.mesh == other.mesh
        && bearing(one) == bearing(other)
        && (form(one), model(one)) == (form(other), model(other))
        && discriminant(&one.journal.position) == discriminant(&other.journal.position)
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
pub fn renewed(mut study: Study, scene: &Scene, near: (f64, f64)) -> Study {
    let thickness = film_thickness(scene, study.system.space().mesh());
    let fed = |name: &str| scene.feeds.iter().find(|feed| feed.group == name)?.pressure;
    let pressure = |region: &SupplyRegion| match region.place {
        Place::Feed => fed(&region.name).unwrap_or(region.pressure),
        Place::End | Place::Line | Place::Sealed => scene.ends.pressure,
    };
    study.system.renew(&pressure, &thickness);
    study.problem = problem(scene, journal(scene, near), thickness);
    study.load = scene.journal.load();
    study.centre_velocity = centre_velocity(scene);
    study.cap = scene.cap;
    study.oil = scene.oil.clone();
    study.heat = scene.heat;
    study.effects = effects(scene, &study.problem);
    study.supply_pressure = supply_pressure(scene);
    study
}
