//! Caps that can be built, and bolts that can hold them.

use std::f64::consts::PI;

use super::Checks;
use crate::scene::Scene;

impl Checks<'_> {
    pub(super) fn cap(&mut self, scene: &Scene) {
        let Some(joint) = scene.cap.map(|cap| cap.joint) else {
            return;
        };
        let mut positive = vec![
            (joint.reciprocating_mass, "cap.reciprocating_mass"),
            (joint.rotating_mass, "cap.rotating_mass"),
            (joint.cap_mass, "cap.cap_mass"),
            (joint.crank_radius, "cap.crank_radius"),
            (joint.rod_length, "cap.rod_length"),
            (joint.diameter, "cap.bolts.diameter"),
            (joint.stress_area, "cap.bolts.stress_area"),
            (joint.torque_coefficient, "cap.bolts.torque_coefficient"),
        ];
        if let Some(shell) = joint.shell {
            positive.extend([
                (shell.protrusion, "cap.shell.protrusion"),
                (shell.modulus, "cap.shell.modulus"),
                (shell.section, "cap.shell.section"),
                (shell.radius, "cap.shell.radius"),
            ]);
        }
        for (value, key) in positive {
            self.positive(value, key);
        }
        self.refuse_if(
            joint.cap_mass >= joint.rotating_mass,
            "cap.cap_mass",
            "is not less than rotating_mass, of which the cap is a part",
            "give the mass of the rod at its big end as rotating_mass, the cap included",
        );
        self.refuse_if(
            joint.crank_radius >= joint.rod_length,
            "cap.crank_radius",
            "is not less than rod_length, so the crank could not turn",
            "give half the stroke as crank_radius, and the distance of the rod's eyes as rod_length",
        );
        let section = 0.25 * PI * joint.diameter * joint.diameter;
        self.refuse_if(
            joint.stress_area > section,
            "cap.bolts.stress_area",
            format!("is more than the whole section of the bolt, {:.4} mm2", 1e6 * section),
            "give the section at the core of the thread, some 0.75 of the whole",
        );
        let share = joint.load_share;
        self.refuse_if(
            share <= 0.0 || share >= 1.0,
            "cap.bolts.load_share",
            "is not between 0 and 1",
            "give the share of a pull at the joint that the bolts bear, about 0.15 to 0.25",
        );
        self.refuse_if(
            joint.tightness < 1.0,
            "cap.bolts.tightness",
            "is below 1, so the joint would open",
            "give the safety against opening, about 2 to 4",
        );
        let forces = joint.forces(joint.inertia_force(scene.journal.speed));
        let stress = joint.stress(forces.greatest);
        let shares = [forces.opening, forces.torque, stress, 1.0 / forces.opening];
        let beyond = joint.bolts > 0 && scene.journal.speed != 0.0 && shares.into_iter().any(f64::is_infinite);
        self.refuse_if(
            beyond && self.complaints.is_empty(),
            "cap",
            "leads to forces or stresses that are beyond all numbers",
            "check the exponents of its values and of journal.speed",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::validate::tests::{told, told_one};

    const CAP: &str = r#"[cap]
reciprocating_mass = "3.43 kg"
rotating_mass = "2.025 kg"
cap_mass = "405 g"
crank_radius = "62.5 mm"
rod_length = "230 mm"
angle = "270 deg"
[cap.bolts]
count = 2
diameter = "10 mm"
stress_area = "56.7 mm2"
load_share = 0.18
tightness = 3
torque_coefficient = 0.15
[cap.shell]
protrusion = "25 um"
modulus = "190 GPa"
section = "132 mm2"
radius = "33.5 mm"
[mesh]"#;

    #[test]
    fn caps_are_checked() {
        assert!(told("[mesh]", CAP).is_empty());
        for (from, to, wanted) in [
            ("\"3.43 kg\"", "\"0 kg\"", "cap.reciprocating_mass: is not positive"),
            (
                "\"405 g\"",
                "\"2.1 kg\"",
                "cap.cap_mass: is not less than rotating_mass",
            ),
            (
                "\"62.5 mm\"",
                "\"230 mm\"",
                "cap.crank_radius: is not less than rod_length",
            ),
            (
                "\"56.7 mm2\"",
                "\"80 mm2\"",
                "cap.bolts.stress_area: is more than the whole section of the bolt, 78.5398 mm2",
            ),
            ("0.18", "0", "cap.bolts.load_share: is not between 0 and 1"),
            ("0.18", "1.0", "cap.bolts.load_share: is not between 0 and 1"),
            ("tightness = 3", "tightness = 0.9", "cap.bolts.tightness: is below 1"),
            ("\"25 um\"", "\"-25 um\"", "cap.shell.protrusion: is not positive"),
            ("\"33.5 mm\"", "\"0 mm\"", "cap.shell.radius: is not positive"),
            (
                "\"3.43 kg\"",
                "\"1e308 kg\"",
                "cap: leads to forces or stresses that are beyond all numbers",
            ),
        ] {
            assert!(CAP.contains(from), "{from}");
            told_one("[mesh]", &CAP.replacen(from, to, 1), wanted);
        }
    }
}
