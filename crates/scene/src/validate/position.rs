//! Where a journal can be, and what it can carry.

use super::Checks;
use crate::scene::{Journal, Position};

impl Checks<'_> {
    pub(super) fn journal(&mut self, journal: &Journal) {
        match journal.position {
            Position::Given { eccentricity, .. } => self.eccentricity(eccentricity),
            Position::Load { force, .. } => self.refuse_if(
                force < 0.0,
                "load.force",
                "is negative",
                "give force >= 0, and turn angle by 180 deg",
            ),
        }
    }

    fn eccentricity(&mut self, eccentricity: f64) {
        self.refuse_if(
            eccentricity < 0.0,
            "journal.eccentricity",
            "is negative",
            "give 0 <= eccentricity < 1, and turn min_film_angle by 180 deg",
        );
        self.refuse_if(
            eccentricity >= 1.0,
            "journal.eccentricity",
            "means that the journal touches the liner: the film is nowhere",
            "give 0 <= eccentricity < 1, the offset of the journal over the radial clearance",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::validate::tests::{told, told_one};

    #[test]
    fn positions_are_checked() {
        told_one("0.6", "1.0", "journal.eccentricity: means that the journal touches");
        told_one("0.6", "-0.1", "journal.eccentricity: is negative");
    }

    #[test]
    fn loads_are_checked() {
        let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"\n";
        let load = |force: &str| format!("[load]\nforce = \"{force}\"\nangle = \"270 deg\"\n");
        told_one(position, &load("-5 kN"), "load.force: is negative");
        for force in ["0 N", "5 kN", "1e300 MN"] {
            assert!(told(position, &load(force)).is_empty(), "{force}");
        }
    }
}
