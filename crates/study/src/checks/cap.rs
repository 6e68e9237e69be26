//! Bolts whose forces are numbers.

use oilwedge_scene::{Complaints, Scene};

use crate::cap_joint::cap_joint;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let Some(cap) = scene.cap.filter(|_| !complaints.concern("cap")) else {
        return;
    };
    let joint = cap_joint(&cap);
    let forces = joint.forces(joint.inertia_force(scene.journal.speed));
    let shares = [
        forces.opening,
        forces.torque,
        joint.stress(forces.greatest),
        1.0 / forces.opening,
    ];
    complaints.refuse_if(
        scene.journal.speed != 0.0 && shares.into_iter().any(f64::is_infinite),
        "cap",
        "leads to forces or stresses that are beyond all numbers",
        "check the exponents of its values and of journal.speed",
    );
}
