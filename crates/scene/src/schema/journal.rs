//! The keys of `[journal]`, and those of `[load]` that stand in place of its position.

use crate::reader::TableReader;
use crate::scene::{Journal, Position, Squeeze};
use crate::unit::Dimension;

/// What is wanted where neither a position nor a load is written.
const POSITION: &str = "0.6 and min_film_angle = \"180 deg\", or [load] with force = \"5 kN\" and angle = \"270 deg\": the position is found then";
/// What is wanted where a centred journal moves.
const LINE_OF_CENTRES: &str =
    "\"180 deg\": with eccentricity = 0 it says where the line of centres points, which squeeze refers to";

/// Reads `[journal]` and, if it is written, `[load]`.
pub(super) fn read(mut table: TableReader<'_>, load: Option<TableReader<'_>>) -> Journal {
    let speed = table.quantity("speed", Dimension::Speed, "3000 rpm");
    let squeeze = table.table_if_given("squeeze").map(squeeze);
    let position = match load {
        Some(load) => {
            refuse_position(&mut table);
            read_load(load)
        }
        None => given(&mut table, squeeze.is_some_and(|squeeze| squeeze.is_moving())),
    };
    table.finish();
    Journal {
        speed,
        position,
        squeeze,
    }
}

/// Only a centred journal that does not move needs no angle.
fn given(table: &mut TableReader<'_>, moves: bool) -> Position {
    let angle_is_written = table.has("min_film_angle");
    table.require("eccentricity", if angle_is_written { "0.6" } else { POSITION });
    let eccentricity = table.number_if_given("eccentricity", "0.6");
    match eccentricity {
        Some(0.0) if moves => table.require("min_film_angle", LINE_OF_CENTRES),
        Some(0.0) | None => {}
        Some(_) => table.require("min_film_angle", "\"180 deg\""),
    }
    let min_film_angle = table.quantity_if_given("min_film_angle", Dimension::Angle, "180 deg");
    Position::Given {
        eccentricity: eccentricity.unwrap_or(f64::NAN),
        min_film_angle: min_film_angle.unwrap_or(0.0),
    }
}

fn read_load(mut table: TableReader<'_>) -> Position {
    let force = table.quantity("force", Dimension::Force, "5 kN");
    let angle = table.quantity("angle", Dimension::Angle, "270 deg");
    table.finish();
    Position::Load { force, angle }
}

/// A position stands beside a load.
fn refuse_position(table: &mut TableReader<'_>) {
    let written = ["eccentricity", "min_film_angle"].map(|key| table.has(key));
    // They are read so that they count as known, and as wrong where they are.
    table.number_if_given("eccentricity", "0.6");
    table.quantity_if_given("min_film_angle", Dimension::Angle, "180 deg");
    let (key, keys) = match written {
        [false, false] => return,
        [true, false] => ("eccentricity", "eccentricity"),
        [false, true] => ("min_film_angle", "min_film_angle"),
        [true, true] => ("eccentricity", "eccentricity and min_film_angle"),
    };
    table.complain(
        key,
        "stands beside [load], but under a load the position is found",
        format!("remove {keys} from [journal], or remove [load]"),
    );
}

fn squeeze(mut table: TableReader<'_>) -> Squeeze {
    let mut velocity = |key| {
        let velocity = table.quantity_if_given(key, Dimension::Velocity, "2 mm/s");
        velocity.unwrap_or(0.0)
    };
    let squeeze = Squeeze {
        radial: velocity("radial"),
        tangential: velocity("tangential"),
    };
    table.finish();
    squeeze
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::tests::{STUDY, read, told, told_one};

    const POSITION: &str = "eccentricity = 0.6, min_film_angle = \"180 deg\"";
    const LOAD: &str = "load = { force = \"5 kN\", angle = \"270 deg\" }\n";

    /// The journal of the study with another end of its table and further tables.
    fn journal(position: &str, tables: &str) -> Journal {
        let text = tables.to_owned() + &STUDY.replacen(POSITION, position, 1);
        let scene = read(&text).unwrap_or_else(|error| panic!("{error}"));
        scene.journal
    }

    #[test]
    fn squeeze_is_read() {
        let moved = |keys: &str| journal(&format!("{POSITION}, squeeze = {{ {keys} }}"), "").squeeze;
        let (radial, tangential) = (2.0 * 1e-3, -30.0 * 1e-6);
        let both = moved("radial = \"2 mm/s\", tangential = \"-30 um/s\"");
        assert_eq!(both, Some(Squeeze { radial, tangential }));
        let along = moved("radial = \"2 mm/s\"");
        assert_eq!(along.map(|it| (it.radial, it.tangential)), Some((radial, 0.0)));
        assert_eq!(moved("").map(|it| it.is_moving()), Some(false));
        assert_eq!(journal(POSITION, "").squeeze, None);
        for (squeeze, wanted) in [
            ("5", "journal.squeeze: a table is wanted, not a bare number"),
            (
                "{ radial = 5 }",
                "journal.squeeze.radial: a bare number has no unit; a velocity is wanted",
            ),
            (
                "{ radial = \"5 mm\" }",
                "journal.squeeze.radial: \"mm\" is a unit of length",
            ),
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

    #[test]
    fn a_load_stands_in_place_of_the_position() {
        let (force, angle) = (5e3, 270f64 * (std::f64::consts::PI / 180.0));
        let found = journal("", LOAD).position;
        assert_eq!(found, Position::Load { force, angle });
        journal("", "load = { force = \"0 N\", angle = \"0 deg\" }\n");
        let one = |position: &str, load: &str, wanted: &str| {
            let text = STUDY
                .replacen(POSITION, position, 1)
                .replace("\njournal", &format!("\n{load}journal"));
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
        assert!(
            help.contains("eccentricity = 0.6 and min_film_angle = \"180 deg\", or [load] with force"),
            "{help}"
        );
        told_one("eccentricity = 0.6, ", "", "journal.eccentricity: is missing");
        told_one(
            "eccentricity =",
            "eccentrcity =",
            "journal.eccentrcity: this key is not known",
        );
    }
}
