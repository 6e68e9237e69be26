//! `[support]`: what holds the shaft against its tilt, where the tilt is found.

use crate::journal::tilt;
use crate::reader::TableReader;
use crate::wording::millimetres;
use crate::{Complaints, Scene};

keys! {
    "support" = Table; "", "nothing holds the shaft against its tilt", "",
        "what holds the shaft against its tilt, which is found then where the film carries the moment";
    "support.tilt_stiffness" = Quantity(RotationalStiffness); "20 kN.m/rad", "required", "> 0",
        "stiffness k of the support against the tilt: it puts the moment k (g_0 - g) on the journal";
    "support.tilt" = Table; "", "0", "",
        "slope g_0 that the shaft would give the journal's axis without a film";
    "support.tilt.x" = Quantity(Angle); "0.1 mrad", "0", "any",
        "its part towards x (angle 0)";
    "support.tilt.y" = Quantity(Angle); "0.1 mrad", "0", "any",
        "its part towards y (angle 90 deg)";
}

/// What holds the shaft against its tilt.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Support {
    /// Stiffness k [N m/rad], positive.
    pub tilt_stiffness: f64,
    /// Slope that the shaft would have without the film [rad].
    pub tilt: [f64; 2],
}

/// What tilts a journal whose tilt is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TiltingTable {
    /// Axial position at which the load acts [m].
    pub at: f64,
    /// Moment beside that of the load at its position [N m].
    pub moment: [f64; 2],
    /// What holds the shaft; `None`: nothing.
    pub support: Option<Support>,
}

impl Scene {
    /// What tilts the journal, where its tilt is found.
    pub fn tilting(&self) -> Option<TiltingTable> {
        if !self.is_loaded() {
            return None;
        }
        let is_asked = self.load_at.is_some() || self.load_moment.is_some() || self.support.is_some();
        is_asked.then(|| TiltingTable {
            at: self.load_at.unwrap_or(0.0),
            moment: self.load_moment.unwrap_or_default(),
            support: self.support,
        })
    }

    /// True if the journal is where a load leads it, at rest or on an orbit.
    pub fn is_loaded(&self) -> bool {
        self.journal.load().is_some() || self.load_cycle.is_some()
    }

    /// True if the journal has, or may find, a slope of its axis.
    pub fn can_tilt(&self) -> bool {
        self.journal.is_tilted() || self.tilting().is_some()
    }
}

pub(crate) fn read(mut table: TableReader<'_>) -> Support {
    Support {
        tilt_stiffness: table.required("tilt_stiffness"),
        tilt: (table.table_if_given("tilt")).map(tilt::read).unwrap_or_default(),
    }
}

/// A tilt is found under a load only, and not where it is given; nothing but a support or a moment holds a load beyond
/// an end.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    complaints.refuse_if(
        scene.support.is_some() && !scene.is_loaded(),
        "support",
        "stands without [load], but at a given position the tilt is not found",
        "give [load] with force and angle in place of journal.eccentricity, or remove [support] and give journal.tilt",
    );
    let Some(tilting) = scene.tilting() else { return };
    let key = ["load.at", "load.moment", "support"].into_iter().find(|key| complaints.has(key));
    complaints.refuse_if(
        scene.journal.tilt.is_some(),
        "journal.tilt",
        format!("stands beside {}, by which the tilt is found", key.unwrap_or("support")),
        "remove journal.tilt, or remove load.at, load.moment and [support]",
    );
    let half = 0.5 * scene.bearing.length;
    let is_free = tilting.support.is_none() && tilting.moment == [0.0; 2];
    complaints.refuse_if(
        is_free && tilting.at.abs() >= half,
        "load.at",
        format!(
            "lies beyond the ends, which are at {} from the middle: no film carries a load there",
            millimetres(half)
        ),
        "give a place inside the bearing, or [support] with tilt_stiffness that holds the shaft",
    );
}

#[cfg(test)]
mod tests {
    use crate::journal::tests::{LOAD, POSITION};
    use crate::scene::tests::{STUDY, read};
    use crate::{Scene, Support};

    /// The study under its load, with further keys of it and further tables.
    fn loaded(journal: &str, load: &str, tables: &str) -> Result<Scene, String> {
        let load = LOAD.replacen(" }", &format!("{load} }}"), 1);
        let text = load + tables + &STUDY.replacen(POSITION, journal, 1);
        read(&text).map_err(|error| error.to_string())
    }

    #[test]
    fn what_tilts_the_journal_is_read() {
        let plain = loaded("", "", "").expect("a scene");
        assert_eq!((plain.tilting(), plain.can_tilt()), (None, false));
        let off = loaded("", ", at = \"4 mm\"", "").expect("a scene");
        let tilting = off.tilting().expect("it tilts");
        assert_eq!((tilting.at, tilting.moment, tilting.support), (4.0 * 1e-3, [0.0; 2], None));
        let held = "support = { tilt_stiffness = \"2 kN.m/rad\", tilt = { y = \"-0.1 mrad\" } }\n";
        let both = loaded("", ", moment = { x = \"3 N.m\" }", held).expect("a scene");
        let tilting = both.tilting().expect("it tilts");
        assert_eq!((tilting.at, tilting.moment), (0.0, [3.0, 0.0]));
        let (tilt_stiffness, tilt) = (2.0 * 1e3, [0.0, -0.1 * 1e-3]);
        assert_eq!(tilting.support, Some(Support { tilt_stiffness, tilt }));
    }

    #[test]
    fn what_cannot_be_found_is_refused() {
        let refused = |journal: &str, load: &str, tables: &str, wanted: &str| {
            let error = loaded(journal, load, tables).expect_err(wanted);
            assert!(error.contains(wanted) && error.lines().count() == 2, "{error}");
        };
        let support = "support.tilt_stiffness = \"2 kN.m/rad\"\n";
        refused("tilt = { x = \"1e-5 rad\" }", ", at = \"4 mm\"", "", "journal.tilt: stands beside load.at");
        refused("tilt = { x = \"1e-5 rad\" }", "", support, "journal.tilt: stands beside support");
        refused("", ", at = \"40 mm\"", "", "load.at: lies beyond the ends, which are at 37.5 mm");
        refused("", "", "support = {}\n", "support.tilt_stiffness: is missing");
        refused("", ", moment = 5", "", "load.moment: a table is wanted, not a bare number");
        assert!(loaded("", ", at = \"40 mm\"", support).is_ok());
        let text = support.to_owned() + STUDY;
        let error = read(&text).expect_err("no load").to_string();
        assert!(error.contains("support: stands without [load]"), "{error}");
    }
}
