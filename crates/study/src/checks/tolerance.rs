//! Which quantities a tolerance may name, and what a tolerance without a name means.

use oilwedge_scene::spelling::nearest;
use oilwedge_scene::{Complaints, PositionTable, Scene, Target, TheoryKey, Tolerance};

use crate::column::Fault;
use crate::effects::Sockets;
use crate::outline::LinerOutline;
use crate::quantities::{
    ATTITUDE_ANGLE, CATALOGUE, ECCENTRICITY, FILM_THICKNESS_MIN, FRICTION_COEFFICIENT, FRICTION_POWER, FRICTION_TORQUE,
    INLET_FLOW, LOAD_COEFFICIENT, MIN_FILM_ANGLE, PRESSURE_INTEGRAL, PRESSURE_MAX, Row, SIDE_FLOW, SOMMERFELD_NUMBER,
    main_quantity, row,
};
use crate::scope::Scope;
use crate::targets::Targets;

/// Usual bar of the main quantity [1].
const USUAL: f64 = 0.005;
/// Tolerance of short bearings, whose films take milliseconds [1].
const SHORT: f64 = 0.001;

/// Bar wanted of the other numbers that an engineer reads [1].
const WANTED: f64 = 0.02;

/// The bars that must become small by refinement of the mesh; none where the mesh is used as it is.
pub fn targets(scene: &Scene) -> Option<Targets> {
    let main = |relative: f64| {
        let quantity = main_quantity(&Scope::of(scene)).name.to_owned();
        vec![Target { quantity, relative }]
    };
    let required = match scene.tolerance.as_ref()? {
        Tolerance::Usual if scene.bearing.theory == TheoryKey::Short => main(SHORT),
        Tolerance::Usual => main(USUAL),
        Tolerance::Main(relative) => main(*relative),
        Tolerance::ByName(targets) => {
            let mut targets = targets.clone();
            targets.sort_by_cached_key(|target| {
                let place = CATALOGUE.iter().position(|row| row.has(&target.quantity))?;
                let row = CATALOGUE[place];
                // Flows of feeds stand behind friction.
                Some((row == &PRESSURE_INTEGRAL, row.is_family(), place, target.quantity.clone()))
            });
            targets
        }
    };
    Some(Targets { required, wanted: wanted(scene), are_usual: scene.tolerance == Some(Tolerance::Usual) })
}

/// What an engineer reads beside the main quantity, where the scene leaves mesh and tolerance to the program.
fn wanted(scene: &Scene) -> Vec<Target> {
    let target = |row: &Row| Target { quantity: row.name.to_owned(), relative: WANTED };
    // At the ends of slices that give way no mesh narrows what their grid leaves open of the least film.
    let has_slices = Sockets::of(scene).wall.is_some_and(|wall| wall.has_slices());
    let of_mesh = |row: &&Row| !has_slices || *row != &FILM_THICKNESS_MIN;
    match scene.tolerance {
        Some(Tolerance::Usual) => [&PRESSURE_MAX, &FILM_THICKNESS_MIN, &SIDE_FLOW, &FRICTION_TORQUE]
            .into_iter()
            .filter(of_mesh)
            .map(target)
            .collect(),
        _ => Vec::new(),
    }
}

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let Some(Tolerance::ByName(targets)) = &scene.tolerance else {
        return;
    };
    for name in targets.iter().map(|target| target.quantity.as_str()) {
        let key = format!("mesh.tolerance.{name}");
        let fault = match row(name).filter(|row| row.may_be_tolerance) {
            Some(family) if family.is_family() => no_flow(scene, family, &name[family.name.len()..]),
            Some(row) => no_error(scene, row),
            None => Some(unknown(name)),
        };
        if let Some((message, help)) = fault {
            complaints.add(&key, message, help);
        }
    }
}

fn unknown(name: &str) -> Fault {
    let rows = CATALOGUE.iter().filter(|row| row.may_be_tolerance);
    let mut known: Vec<&str> = rows.map(|row| row.name.trim_end_matches('.')).collect();
    if known.contains(&name) {
        let help = format!("write {name}.GROUP = \"1 %\"");
        return ("a table is wanted, with the groups of feeds".to_owned(), help);
    }
    known.sort_unstable();
    let help = match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("known here: {}", known.join(", ")),
    };
    ("this key is not known".to_owned(), help)
}

/// A quantity that is absent from the result has no bar, and one that the scene gives has none either.
fn no_error(scene: &Scene, row: &Row) -> Option<Fault> {
    let journal = &scene.journal;
    let is_centred = matches!(journal.position, PositionTable::Given { eccentricity: 0.0, .. });
    let mut pressures = scene.feeds.iter().filter_map(|feed| feed.pressure);
    let supply = pressures.next();
    let is_one_of = |rows: &[&Row]| rows.contains(&row);
    let of_position = [&ECCENTRICITY, &MIN_FILM_ANGLE, &FILM_THICKNESS_MIN];
    let of_rotation = [&SOMMERFELD_NUMBER, &INLET_FLOW, &FRICTION_TORQUE, &FRICTION_COEFFICIENT, &FRICTION_POWER];
    let (message, help) = if is_one_of(&of_position) && journal.load().is_none() {
        (
            "follows from the position that the scene gives, so it has no error to make smaller",
            "give a tolerance of the load, or [load] in the place of the position",
        )
    } else if row == &ATTITUDE_ANGLE && is_centred {
        ("has no meaning for a centred journal", "remove it, or give an eccentricity above zero")
    } else if is_one_of(&of_rotation) && journal.speed == 0.0 {
        ("has no meaning for a journal that does not turn", "remove it, or give a tolerance of the load")
    } else if row == &LOAD_COEFFICIENT && (supply.is_none() || pressures.any(|other| Some(other) != supply)) {
        ("has a meaning only where there are feeds, all of one pressure", "remove it, or give a tolerance of the load")
    } else {
        return None;
    };
    Some((message.to_owned(), help.to_owned()))
}

/// A group without a given pressure lets no oil in.
fn no_flow(scene: &Scene, family: &Row, group: &str) -> Option<Fault> {
    let outline = LinerOutline::of(scene);
    let regions = outline.regions();
    let fed = regions.iter().filter(|region| region.pressure().is_some());
    let groups: Vec<&str> = fed.map(|region| region.name.as_str()).collect();
    if groups.contains(&group) {
        return None;
    }
    let is_pocket = (scene.feeds.iter()).any(|feed| feed.group == group && feed.depth.is_some());
    let message = match is_pocket {
        true => format!("belongs to the pocket \"{group}\", which lets no oil in"),
        false => format!("belongs to no [[feed]] of this scene: there is no group \"{group}\""),
    };
    let help = match nearest(group, groups.iter().copied()) {
        Some(near) => format!("did you mean \"{}{near}\"?", family.name),
        None if groups.is_empty() => "remove it; no [[feed]] has a pressure".to_owned(),
        None => format!("groups with a pressure: {}", groups.join(", ")),
    };
    Some((message, help))
}
