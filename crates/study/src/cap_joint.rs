//! The joint of a cap, made of the description in the scene.

use oilwedge_bearing::{CapBolts, Shell};
use oilwedge_scene::Cap;

/// The joint of a cap.
pub(crate) fn cap_joint(cap: &Cap) -> CapBolts {
    CapBolts {
        reciprocating_mass: cap.reciprocating_mass,
        rotating_mass: cap.rotating_mass,
        cap_mass: cap.cap_mass,
        crank_radius: cap.crank_radius,
        rod_length: cap.rod_length,
        bolts: cap.bolts.count,
        diameter: cap.bolts.diameter,
        stress_area: cap.bolts.stress_area,
        load_share: cap.bolts.load_share,
        tightness: cap.bolts.tightness,
        torque_coefficient: cap.bolts.torque_coefficient,
        shell: cap.shell.map(|shell| Shell {
            protrusion: shell.protrusion,
            modulus: shell.modulus,
            section: shell.section,
            radius: shell.radius,
        }),
    }
}
