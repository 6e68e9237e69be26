//! `[journal.squeeze]`: the velocity of the journal's centre.

use crate::reader::TableReader;
use crate::{Complaints, Journal, PositionTable, Scene};

keys! {
    "journal.squeeze" = Table; "", "the centre is at rest", "",
        "velocity of the journal's centre";
    "journal.squeeze.radial" = Quantity(Velocity); "2 mm/s", "0", "any",
        "velocity of the journal's centre along the line of centres; positive: the eccentricity grows";
    "journal.squeeze.tangential" = Quantity(Velocity); "2 mm/s", "0", "any",
        "velocity of the journal's centre across the line of centres; positive: towards growing angles";
}

/// Velocity of the journal's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SqueezeTable {
    /// Velocity along the line of centres [m/s]; positive: the eccentricity grows.
    pub radial: f64,
    /// Velocity across the line of centres [m/s]; positive: towards growing angles.
    pub tangential: f64,
}

impl Journal {
    /// The velocity of the centre, if it moves.
    pub fn motion(&self) -> Option<SqueezeTable> {
        self.squeeze.filter(|it| it.radial != 0.0 || it.tangential != 0.0)
    }

    /// Has the centre move along the line of centres, at this velocity [m/s], and not otherwise.
    pub fn squeeze_along(&mut self, radial: f64) {
        self.squeeze = Some(SqueezeTable { radial, tangential: 0.0 });
    }
}

pub(super) fn read(mut table: TableReader<'_>) -> SqueezeTable {
    let mut velocity = |key| table.number(key).or_usual();
    SqueezeTable { radial: velocity("radial"), tangential: velocity("tangential") }
}

/// A centred journal has a line of centres only where the scene gives its angle; under a load over a cycle the velocity
/// is found.
pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let is_centred = matches!(scene.journal.position, PositionTable::Given { eccentricity: 0.0, .. });
    super::refuse_beside_a_cycle("journal.squeeze", scene, complaints);
    complaints.refuse_if(
        scene.journal.motion().is_some() && scene.heat.is_some_and(|heat| heat.field.is_some()),
        "journal.squeeze",
        "moves the journal, but heat.field finds the temperature of a film at rest",
        "remove it, or remove heat.field",
    );
    let key = "journal.min_film_angle";
    complaints.refuse_if(
        is_centred && scene.journal.motion().is_some() && complaints.has("journal") && !complaints.has(key),
        key,
        "is missing",
        "write for example min_film_angle = \"180 deg\": with eccentricity = 0 it says where the line of centres points, which squeeze refers to",
    );
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::journal::tests::{LOAD, POSITION, journal};
    use crate::scene::tests::{STUDY, read, told, told_one};

    #[test]
    fn a_journal_under_a_load_over_a_cycle_moves_by_itself() {
        let load = "load = { file = \"a.csv\", frame = \"shell\", period = \"720 deg\" }\n";
        let text = load.to_owned() + &STUDY.replacen(POSITION, "squeeze = { radial = \"1 mm/s\" }", 1);
        let error = read(&text).expect_err("moved").to_string();
        assert!(
            error.contains("journal.squeeze: stands beside a load over a cycle") && error.lines().count() == 2,
            "{error}"
        );
    }

    #[test]
    fn squeeze_is_read() {
        let moved = |keys: &str| journal(&format!("{POSITION}, squeeze = {{ {keys} }}"), "").squeeze;
        let (radial, tangential) = (2.0 * 1e-3, -30.0 * 1e-6);
        let both = moved("radial = \"2 mm/s\", tangential = \"-30 um/s\"");
        assert_eq!(both, Some(SqueezeTable { radial, tangential }));
        let along = moved("radial = \"2 mm/s\"");
        assert_eq!(along.map(|it| (it.radial, it.tangential)), Some((radial, 0.0)));
        assert_eq!((moved("").is_some(), journal(&format!("{POSITION}, squeeze = {{}}"), "").motion()), (true, None));
        assert_eq!(journal(POSITION, "").squeeze, None);
        for (squeeze, wanted) in [
            ("5", "journal.squeeze: a table is wanted, not a bare number"),
            ("{ radial = 5 }", "journal.squeeze.radial: a bare number has no unit; a velocity is wanted"),
            ("{ radial = \"5 mm\" }", "journal.squeeze.radial: \"mm\" is a unit of length"),
            ("{ radal = \"5 mm/s\" }", "journal.squeeze.radal: this key is not known"),
        ] {
            told_one("speed =", &format!("squeeze = {squeeze}, speed ="), wanted);
        }
    }

    #[test]
    fn a_centred_journal_that_moves_needs_its_line_of_centres() {
        let moved = "eccentricity = 0, squeeze = { tangential = \"1 m/s\" }";
        told_one(POSITION, moved, "journal.min_film_angle: is missing");
        let help = &told(POSITION, moved)[0].help;
        assert!(
            help.ends_with(
                "= \"180 deg\": with eccentricity = 0 it says where the line of centres points, which squeeze refers to"
            ),
            "{help}"
        );
        journal(&format!("{moved}, min_film_angle = \"90 deg\""), "");
        journal("eccentricity = 0, squeeze = { radial = \"0 m/s\" }", "");
        journal("squeeze = { radial = \"1 m/s\" }", LOAD);
    }
}
