//! Pockets: the film is deeper there, and its pressure is found.

use super::{BLANK, Contribution, Effect, Socket, changed};

pub(super) const ROW: Effect = Effect {
    name: "groove depth",
    sentence: "the film is deeper there, its pressure is found",
    socket: Socket::FilmThickness,
    is_in: |scene| scene.feeds.iter().any(|feed| feed.depth.is_some()),
    install: |scene, sockets| {
        let pockets = scene.feeds.iter().filter_map(|feed| Some(Contribution::Deeper(feed.group.clone(), feed.depth?)));
        sockets.film_thickness.extend(pockets);
    },
    instead: "pockets without depth",
    remove: |scene| {
        changed(scene, |scene| {
            let pockets = scene.feeds.iter_mut().filter_map(|feed| feed.depth.as_mut());
            pockets.for_each(|depth| *depth = 0.0);
        })
    },
    ..BLANK
};
