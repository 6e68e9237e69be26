//! Which scenes have characteristics: films whose pressures grow in proportion to the rates, and that nothing but
//! motion makes.

use oilwedge_scene::{Complaints, PositionTable, Scene};
use oilwedge_study::effects::{Sockets, present};

/// Complains about all that gives a film a pressure of its own, or a pressure that does not grow in proportion to the
/// rate of a motion.
pub fn check(scene: &Scene, complaints: &mut Complaints) {
    for [key, message, help] in present(scene).filter_map(|effect| effect.no_proportion) {
        complaints.add(key, message, help);
    }
    complaints.refuse_if(
        scene.journal.position == PositionTable::Cycle,
        "journal.eccentricity",
        "is missing: the load changes over a cycle, but characteristics are those of one position",
        "give journal.eccentricity and journal.min_film_angle in place of [load], or the force and angle of one moment",
    );
    pressures(scene, complaints);
    turning(scene, complaints);
}

/// The pressure of ends, feeds and cavity is one.
fn pressures(scene: &Scene, complaints: &mut Complaints) {
    let ends = scene.ends.pressure;
    let why =
        "makes a pressure of its own: characteristics are those of a film that only the motion of the journal makes";
    for (index, feed) in scene.feeds.iter().enumerate() {
        complaints.refuse_if(
            feed.pressure.is_some_and(|pressure| pressure != ends),
            &format!("feed[{index}].pressure"),
            why,
            "give the feed the pressure of the ends, as pressure = \"0 bar\"",
        );
    }
    let cavity = scene.cavitation.filter(|it| it.model.drops_pressures());
    complaints.refuse_if(
        cavity.is_some_and(|cavity| cavity.pressure != ends),
        "cavitation.pressure",
        "is not the pressure of the ends, so that forces are not in proportion to rates",
        "give cavity and ends one pressure, as both have where neither is written",
    );
}

/// A line of centres that turns is there, and makes the film of a rotation.
fn turning(scene: &Scene, complaints: &mut Complaints) {
    let is_turning = Sockets::of(scene).centre_velocity.tangential != 0.0;
    complaints.refuse_if(
        is_turning && has_pockets(scene),
        "journal",
        "moves across its line of centres (squeeze.tangential), which is a rotation only where no pocket turns against it",
        "remove squeeze.tangential, or the pockets (feeds with a depth)",
    );
    let is_centred = matches!(scene.journal.position, PositionTable::Given { eccentricity: 0.0, .. });
    complaints.refuse_if(
        is_turning && is_centred,
        "journal",
        "moves across its line of centres (squeeze.tangential), but it is centred and has none",
        "write the velocity as squeeze.radial, with min_film_angle in its direction",
    );
}

/// True if the film is deeper in a part of the liner.
pub(super) fn has_pockets(scene: &Scene) -> bool {
    scene.feeds.iter().any(|feed| feed.pressure.is_none())
}
