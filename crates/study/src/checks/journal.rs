//! A journal that moves, where its motion is all that warms the oil.

use oilwedge_scene::{Complaints, Scene};

use crate::effects::Sockets;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    if complaints.concern_temperature() || complaints.concern("journal") {
        return;
    }
    let sockets = Sockets::of(scene);
    let is_at_rest =
        scene.journal.speed == 0.0 && sockets.centre_velocity == Default::default() && sockets.tilt_rate == [0.0; 2];
    complaints.refuse_if(
        sockets.thermal.is_some() && is_at_rest,
        "journal.speed",
        "is zero and the centre does not move, so that nothing heats the oil",
        "give a speed or journal.squeeze, or remove [heat] and give oil.temperature",
    );
}
