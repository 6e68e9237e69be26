//! Flow dragged along by the journal.

use std::sync::Arc;

use oilwedge_reynolds::terms::Couette;
use oilwedge_scene::Scene;

use super::{BLANK, Effect, changed, present};
use crate::quantities::SOMMERFELD_NUMBER;

pub(super) const KIND: &str = "couette";

pub(super) const ROW: Effect = Effect {
    name: KIND,
    sentence: "oil dragged along by the journal",
    kind: KIND,
    is_in: |scene| scene.journal.speed != 0.0,
    install: |_, sockets| sockets.terms.push(Arc::new(Couette)),
    instead: "a journal at rest",
    remove: at_rest,
    ..BLANK
};

/// The scene with a journal at rest, where feeds drive the oil too. Nothing heats the oil then, and there is no
/// Sommerfeld number, and so no tolerance of it.
fn at_rest(scene: &Scene) -> Option<Scene> {
    scene.feeds.iter().find(|feed| feed.pressure.is_some())?;
    let balances = present(scene).filter(|effect| effect.socket.is_balance());
    let scene = balances.fold(scene.clone(), |scene, effect| (effect.remove)(&scene).unwrap_or(scene));
    changed(&scene, |scene| {
        scene.journal.speed = 0.0;
        scene.remove_tolerance(SOMMERFELD_NUMBER.name);
    })
}
