//! `[journal]`: how the journal turns, and where it is unless `[load]` has its position found.

pub(crate) mod squeeze;
pub(crate) mod tilt;

use crate::reader::TableReader;
use crate::{Complaints, Scene};

keys! {
    "journal" = Table; "", "required", "",
        "how the journal turns, and where it is";
    "journal.speed" = Quantity(Speed); "3000 rpm", "required", "any; 0 is at rest",
        "speed omega, positive towards growing angles";
    "journal.eccentricity" = Number; "0.6", "required unless `[load]`", "0 <= eps < 1; beyond 1 where the shapes of bore and shaft leave a film",
        "offset of the journal over the radial clearance";
    "journal.min_film_angle" = Quantity(Angle); "180 deg", "required unless eps = 0 or `[load]`", "",
        "angle phi_min of the journal's offset, at which the film between circles is thinnest";
}

/// What is wanted where neither a position nor a load is written.
const POSITION: &str = "0.6 and min_film_angle = \"180 deg\", or [load] with force = \"5 kN\" and angle = \"270 deg\": the position is found then";

/// The journal.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Journal {
    /// Angular speed omega [rad/s]; positive towards growing angles.
    pub speed: f64,
    /// Position of the journal.
    pub position: PositionTable,
    /// Velocity of its centre; `None`: the centre rests.
    pub squeeze: Option<squeeze::SqueezeTable>,
    /// Slope of its axis against that of the bearing, towards x and y [rad]; `None`: the axes are parallel.
    pub tilt: Option<[f64; 2]>,
    /// Rate of that slope [rad/s]; `None`: it does not change.
    pub tilt_rate: Option<[f64; 2]>,
}

/// How the position of the journal is known.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum PositionTable {
    /// A fixed position.
    Given {
        /// Eccentricity ratio eps = |e|/c, 0 <= eps < 1.
        eccentricity: f64,
        /// Angle of the journal's offset [rad], of the thinnest film between circles; 0 where the journal is centred
        /// and the scene gives none.
        min_film_angle: f64,
    },
    /// The position at which the film carries this load: it is found.
    Load {
        /// Force F on the journal [N], not negative.
        force: f64,
        /// Direction of the force [rad], from +x towards +y.
        angle: f64,
    },
    /// An orbit, under a load that changes over a cycle.
    #[default]
    Cycle,
}

impl Journal {
    /// A journal that turns at `speed` [rad/s] under no load, without tilt or motion of its own.
    pub fn without_load(speed: f64) -> Self {
        Self { speed, position: PositionTable::Load { force: 0.0, angle: 0.0 }, ..Self::default() }
    }

    /// The force on the journal `(F cos, F sin)` [N]; `None` at a given position and under a load that changes.
    pub fn load(&self) -> Option<[f64; 2]> {
        match self.position {
            PositionTable::Given { .. } | PositionTable::Cycle => None,
            PositionTable::Load { force, angle } => Some([force * angle.cos(), force * angle.sin()]),
        }
    }
}

/// Reads the table; `load` is the position under a load, if the scene has one.
pub(crate) fn read(mut table: TableReader<'_>, load: Option<PositionTable>) -> Journal {
    Journal {
        speed: table.required("speed"),
        squeeze: table.table_if_given("squeeze").map(squeeze::read),
        tilt: (table.table_if_given("tilt")).map(tilt::read),
        tilt_rate: (table.table_if_given("tilt_rate")).map(tilt::read),
        position: position(&mut table, load),
    }
}

/// Keys that must fit each other.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    let touches = matches!(scene.journal.position, PositionTable::Given { eccentricity, .. } if eccentricity >= 1.0);
    complaints.refuse_if(
        touches && scene.is_circular(),
        "journal.eccentricity",
        "means that the journal touches the liner: there is no film",
        "give 0 <= eccentricity < 1, the offset of the journal over the radial clearance",
    );
    squeeze::check(scene, complaints);
    tilt::check(scene, complaints);
}

/// A velocity that the key gives stands beside no load over a cycle and no orbit, by which the journal moves.
fn refuse_beside_a_cycle(key: &str, scene: &Scene, complaints: &mut Complaints) {
    complaints.refuse_if(
        complaints.has(key) && scene.load_cycle.is_some(),
        key,
        "stands beside a load over a cycle, by which the journal moves",
        format!("remove {key}, or give [load] with force and angle"),
    );
    complaints.refuse_if(
        complaints.has(key) && scene.orbit.is_some() && scene.load_cycle.is_none(),
        key,
        "stands beside [orbit], by which the journal moves",
        format!("remove {key}, or remove [orbit]"),
    );
}

fn position(table: &mut TableReader<'_>, load: Option<PositionTable>) -> PositionTable {
    let eccentricity = table.number("eccentricity").which(
        |eccentricity| eccentricity >= 0.0,
        "is negative",
        "give 0 <= eccentricity < 1, and turn min_film_angle by 180 deg",
    );
    let eccentricity = eccentricity.given();
    let angle = table.given("min_film_angle");
    if let Some(load) = load {
        let (key, keys) = match (eccentricity, angle) {
            (None, None) => return load,
            (Some(_), None) => ("eccentricity", "eccentricity"),
            (None, Some(_)) => ("min_film_angle", "min_film_angle"),
            (Some(_), Some(_)) => ("eccentricity", "eccentricity and min_film_angle"),
        };
        let message = "stands beside [load], but under a load the position is found";
        table.complain(key, message, format!("remove {keys} from [journal], or remove [load]"));
        return load;
    }
    table.require_as("eccentricity", if angle.is_some() { "0.6" } else { POSITION });
    if eccentricity.is_some_and(|eccentricity| eccentricity != 0.0) {
        table.require("min_film_angle");
    }
    PositionTable::Given { eccentricity: eccentricity.unwrap_or(f64::NAN), min_film_angle: angle.unwrap_or(0.0) }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, good, read, told, told_one};

    pub(crate) const POSITION: &str = "eccentricity = 0.6, min_film_angle = \"180 deg\"";
    pub(crate) const LOAD: &str = "load = { force = \"5 kN\", angle = \"270 deg\" }\n";

    /// The journal of the study with another end of its table and further tables.
    pub(crate) fn journal(position: &str, tables: &str) -> Journal {
        let text = tables.to_owned() + &STUDY.replacen(POSITION, position, 1);
        let scene = read(&text).unwrap_or_else(|error| panic!("{error}"));
        scene.journal
    }

    #[test]
    fn a_load_stands_in_place_of_the_position() {
        let (force, angle) = (5e3, 270f64 * (std::f64::consts::PI / 180.0));
        let found = journal("", LOAD).position;
        assert_eq!(found, PositionTable::Load { force, angle });
        journal("", "load = { force = \"0 N\", angle = \"0 deg\" }\n");
        let one = |position: &str, load: &str, wanted: &str| {
            let text = STUDY.replacen(POSITION, position, 1).replace("\njournal", &format!("\n{load}journal"));
            let error = read(&text).expect_err(wanted).to_string();
            assert!(error.contains(wanted) && error.lines().count() == 2, "{error}");
        };
        one("", "load.force = \"5 kN\"\n", "load.angle: is missing");
        one("", "load.angle = \"5 deg\"\n", "load.force: is missing");
        one("", "load = 5\n", "load: a table is wanted, not a bare number");
        one(
            "",
            "load = { force = 5, angle = \"0 deg\" }\n",
            "load.force: a bare number has no unit; a force is wanted",
        );
        one(
            "",
            "load = { force = \"inf N\", angle = \"0 deg\" }\n",
            "load.force: \"inf N\" does not begin with a number",
        );
    }

    #[test]
    fn the_position_is_given_or_found() {
        let beside = "stands beside [load], but under a load the position is found";
        for (position, keys) in [
            (POSITION, "eccentricity and min_film_angle"),
            ("eccentricity = 0.6", "eccentricity"),
            ("min_film_angle = \"180 deg\"", "min_film_angle"),
        ] {
            let text = LOAD.to_owned() + &STUDY.replacen(POSITION, position, 1);
            let error = read(&text).expect_err("both").to_string();
            let help = format!("{beside} (remove {keys} from [journal], or remove [load])");
            assert!(error.contains(&help) && error.lines().count() == 2, "{error}");
        }
        told_one(&format!(", {POSITION}"), "", "journal.eccentricity: is missing");
        let help = &told(&format!(", {POSITION}"), "")[0].help;
        assert!(help.contains("eccentricity = 0.6 and min_film_angle = \"180 deg\", or [load] with force"), "{help}");
        told_one("eccentricity = 0.6, ", "", "journal.eccentricity: is missing");
        told_one("eccentricity =", "eccentrcity =", "journal.eccentrcity: this key is not known");
    }

    #[test]
    fn positions_are_checked() {
        good::told_one("0.6", "1.0", "journal.eccentricity: means that the journal touches");
        good::told_one("0.6", "-0.1", "journal.eccentricity: is negative");
    }

    #[test]
    fn loads_are_checked() {
        let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"\n";
        let load = |force: &str| format!("[load]\nforce = \"{force}\"\nangle = \"270 deg\"\n");
        good::told_one(position, &load("-5 kN"), "load.force: is negative");
        for force in ["0 N", "5 kN", "1e12 MN"] {
            assert!(good::told(position, &load(force)).is_empty(), "{force}");
        }
    }
}
