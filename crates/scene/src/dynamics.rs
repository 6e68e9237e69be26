//! `[dynamics]`: stiffness and damping of the film, and the stability of a rotor on it.

use crate::reader::TableReader;

keys! {
    "dynamics" = Table; "", "stiffness and damping are not computed", "",
        "how the film answers to small motions of the journal: stiffness, damping, and the stability of a rigid rotor";
    "dynamics.whirl" = Number, Numbers; "0.5", "0: slow motions", "0 to 10, at most 16 in a list",
        "frequency of the motion over the speed of the journal, or several in a list: quantities are those of the first one; it makes a difference with `jfo` alone";
    "dynamics.mass" = Quantity(Mass); "200 kg", "no decrement", "> 0",
        "mass of a rigid rotor that this bearing carries, whose logarithmic decrement is found";
}

/// Most whirl ratios of a list.
const MOST: usize = 16;

/// What is asked about small motions of the journal.
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicsTable {
    /// Frequencies of the motion over the speed of the journal [1]; at least one.
    pub whirl: Vec<f64>,
    /// Mass of the rotor for this bearing [kg]; `None`: none is given.
    pub mass: Option<f64>,
}

pub(crate) fn read(mut table: TableReader<'_>) -> DynamicsTable {
    let ratios = table.numbers("whirl");
    let bounds = table.bounds("whirl");
    if let Some(wrong) = ratios.iter().flatten().find(|ratio| !bounds.hold(**ratio)) {
        let [least, most] = bounds.ends;
        table.complain(
            "whirl",
            format!("{wrong} lies outside of {least} to {most}"),
            "write frequencies over the speed of the journal, for example whirl = [0, 0.5, 1]",
        );
    }
    let number = ratios.as_ref().map_or(1, Vec::len);
    table.refuse_if(number > MOST, "whirl", format!("has {number} ratios, more than {MOST}"), "give fewer");
    DynamicsTable { whirl: ratios.unwrap_or_else(|| vec![0.0]), mass: table.given("mass") }
}

#[cfg(test)]
mod tests {
    use crate::DynamicsTable;
    use crate::scene::tests::{STUDY, read};

    fn asked(keys: &str) -> Result<DynamicsTable, String> {
        let text = format!("{STUDY}\n[dynamics]\n{keys}\n");
        let scene = read(&text).map_err(|error| error.to_string())?;
        Ok(scene.dynamics.expect("the table is there"))
    }

    #[test]
    fn what_is_asked_is_read() {
        let of = |whirl: &[f64], mass| DynamicsTable { whirl: whirl.to_vec(), mass };
        assert_eq!(asked(""), Ok(of(&[0.0], None)));
        assert_eq!(asked("whirl = 1"), Ok(of(&[1.0], None)));
        assert_eq!(asked("whirl = [0, 0.5, 1]\nmass = \"0.2 t\""), Ok(of(&[0.0, 0.5, 1.0], Some(0.2 * 1e3))));
        assert_eq!(read(STUDY).expect("a scene").dynamics, None);
    }

    #[test]
    fn what_cannot_be_asked_is_refused() {
        let refused = |keys: &str, wanted: &str| {
            let error = asked(keys).expect_err(wanted);
            assert!(error.contains(wanted), "{error}");
        };
        refused("whirl = [0.5, -1]", "dynamics.whirl: -1 lies outside of 0 to 10");
        refused("whirl = \"0.5\"", "dynamics.whirl: a plain number or a list of them is wanted, not a text in quotes");
        refused("whirl = [0, \"1\"]", "dynamics.whirl: a plain number or a list of them is wanted");
        refused("whirl = []", "dynamics.whirl: a plain number or a list of them is wanted");
        refused(&format!("whirl = {:?}", [0.5; 17]), "dynamics.whirl: has 17 ratios, more than 16");
        refused("mass = \"0 kg\"", "dynamics.mass: is not positive");
        refused("mass = 200", "dynamics.mass: a bare number has no unit");
        refused("speed = 3", "dynamics.speed: this key is not known");
    }
}
