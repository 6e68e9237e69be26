//! Pockets: the film is deeper there, and its pressure is found.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::GrooveDepth;

use super::{BLANK, Effect, Socket, changed};

pub(super) const ROW: Effect = Effect {
    name: "groove depth",
    sentence: "the film is deeper there, its pressure is found",
    socket: Socket::FilmThickness,
    is_in: |scene| scene.feeds.iter().any(|feed| feed.depth.is_some()),
    install: |scene, sockets| {
        for feed in &scene.feeds {
            let (Some(depth), group) = (feed.depth, feed.group.clone()) else {
                continue;
            };
            sockets.film_thickness.push(Box::new(move |mesh| {
                let mut inside = vec![false; mesh.triangles().len()];
                for &cell in mesh.region(&group).map_or(&[][..], |region| &region.cells) {
                    inside[cell as usize] = true;
                }
                Arc::new(GrooveDepth { depth, inside })
            }));
        }
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
