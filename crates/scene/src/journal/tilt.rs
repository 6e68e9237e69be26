//! `[journal] tilt` and `tilt_rate`: the slope of the journal's axis against that of the bearing, and its rate.

use crate::reader::TableReader;
use crate::wording::{micrometres, millimetres};
use crate::{BearingTable, Complaints, Journal, PositionTable, Scene, TheoryKey};

keys! {
    "journal.tilt" = Table; "", "the axes are parallel", "",
        "slope of the journal's axis against that of the bearing: the offset of the journal grows by it along the axis";
    "journal.tilt.x" = Quantity(Angle); "0.1 mrad", "0", "no contact at the ends",
        "slope towards x (angle 0): part g_x of the slope g, offset e + z g, z = 0 at mid-length";
    "journal.tilt.y" = Quantity(Angle); "0.1 mrad", "0", "no contact at the ends",
        "slope towards y (angle 90 deg)";
    "journal.tilt_rate" = Table; "", "the slope does not change", "",
        "rate at which the slope of the journal's axis changes";
    "journal.tilt_rate.x" = Quantity(Speed); "0.2 rad/s", "0", "any",
        "rate of the slope towards x";
    "journal.tilt_rate.y" = Quantity(Speed); "0.2 rad/s", "0", "any",
        "rate of the slope towards y";
}

impl Journal {
    /// True if the scene gives a slope of the axis or its rate, be they zero.
    pub fn is_tilted(&self) -> bool {
        self.tilt.is_some() || self.tilt_rate.is_some()
    }

    /// True if the slope of the axis changes.
    pub fn tilts(&self) -> bool {
        self.tilt_rate.is_some_and(|rate| rate != [0.0; 2])
    }
}

/// The parts towards x and y of a slope [rad] or its rate [rad/s]; a part that is not written is zero.
pub(crate) fn read(mut table: TableReader<'_>) -> [f64; 2] {
    ["x", "y"].map(|key| table.number(key).or_usual())
}

/// A tilted journal must not touch the liner at an end, and a long bearing knows no axial position.
pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    let Journal { position, tilt, .. } = scene.journal;
    super::refuse_beside_a_cycle("journal.tilt_rate", scene, complaints);
    complaints.refuse_if(
        scene.bearing.theory == TheoryKey::Long && scene.can_tilt(),
        "bearing.theory",
        "is \"long\", but the journal tilts: a long film is the same all along the axis",
        "remove theory, or remove journal.tilt, journal.tilt_rate, load.at, load.moment and [support]",
    );
    // With shapes the film itself shows whether the journal touches.
    let Some(tilt) = tilt.filter(|_| scene.is_circular()) else {
        return;
    };
    let offset = match position {
        PositionTable::Given { eccentricity, min_film_angle } => {
            let e = eccentricity * scene.bearing.clearance;
            [e * min_film_angle.cos(), e * min_film_angle.sin()]
        }
        // The position is found; with a tilt that touches in the middle of the bearing there is none.
        PositionTable::Load { .. } | PositionTable::Cycle => [0.0; 2],
    };
    if let Some((message, help)) = contact(&scene.bearing, offset, tilt) {
        complaints.add("journal.tilt", message, help);
    }
}

/// What is wrong and the way out where a journal with this offset [m] and tilt [rad] touches the liner at an end.
pub(crate) fn contact(bearing: &BearingTable, offset: [f64; 2], tilt: [f64; 2]) -> Option<(String, String)> {
    let half = 0.5 * bearing.length;
    let gap = |z: f64| {
        let [x, y] = [0, 1].map(|d| offset[d] + z * tilt[d]);
        bearing.clearance - x.hypot(y)
    };
    let (low, high) = (gap(-half), gap(half));
    let (least, z) = if high < low { (high, half) } else { (low, -half) };
    // A number that was refused already is NaN.
    if least.is_nan() || least > 0.0 {
        return None;
    }
    let both = if low.max(high) <= 0.0 { ", and at the other end too" } else { "" };
    let message = format!(
        "makes the journal touch the liner at the end z = {}: the gap there would be {}{both}",
        millimetres(z),
        micrometres(least)
    );
    let room = bearing.clearance - offset[0].hypot(offset[1]);
    let help = format!(
        "give a smaller tilt (x and y together below {:.3} mrad at this eccentricity, clearance and length), or a smaller eccentricity",
        1e3 * room / half
    );
    Some((message, help))
}

#[cfg(test)]
mod tests {
    use crate::journal::tests::{LOAD, POSITION, journal};
    use crate::scene::tests::{told, told_one};

    #[test]
    fn the_tilt_is_read() {
        let tilt = |keys: &str| journal(&format!("{POSITION}, {keys}"), "");
        let slope = tilt("tilt = { x = \"0.1 mrad\", y = \"-2e-5 rad\" }");
        assert_eq!((slope.tilt, slope.tilt_rate), (Some([0.1 * 1e-3, -2e-5]), None));
        let rate = tilt("tilt_rate = { x = \"0.2 rad/s\" }");
        assert_eq!((rate.tilt, rate.tilt_rate), (None, Some([0.2, 0.0])));
        assert!(rate.is_tilted() && rate.tilts());
        let zero = tilt("tilt = {}, tilt_rate = {}");
        assert!(zero.is_tilted() && !zero.tilts());
        assert!(!journal(POSITION, "").is_tilted());
        for (keys, wanted) in [
            ("tilt = 5", "journal.tilt: a table is wanted, not a bare number"),
            ("tilt = { x = 5 }", "journal.tilt.x: a bare number has no unit; an angle is wanted"),
            ("tilt_rate = { y = \"1 mrad\" }", "journal.tilt_rate.y: \"mrad\" is a unit of angle"),
            ("tilt = { z = \"1 mrad\" }", "journal.tilt.z: this key is not known"),
        ] {
            told_one("speed =", &format!("{keys}, speed ="), wanted);
        }
    }

    /// The bearing of the study: 75 mm long, clearance 37.5 um, eps 0.6 towards 180 degrees.
    #[test]
    fn contact_at_an_end_is_refused_with_the_end_and_the_gap() {
        let with = |tilt: &str| format!("{POSITION}, tilt = {{ {tilt} }}");
        let complaints = told(POSITION, &with("x = \"-1 mrad\""));
        assert_eq!(complaints.len(), 1, "{complaints:?}");
        let text = format!("{} ({})", complaints[0], complaints[0].help);
        assert!(text.starts_with("journal.tilt: makes the journal touch the liner at the end z = 37.5 mm"), "{text}");
        assert!(text.contains("would be -22.5 um") && text.contains("below 0.400 mrad"), "{text}");
        let refused = |tilt: &str, wanted: &str| {
            let complaint = told(POSITION, &with(tilt))[0].to_string();
            assert!(complaint.contains(wanted), "{complaint}");
        };
        refused("x = \"1 mrad\"", "the end z = -37.5 mm");
        refused("y = \"5 mrad\"", "and at the other end too");
        journal(&with("x = \"-0.39 mrad\""), "");
        // Under a load the position is free: a tilt that touches in the middle is refused.
        journal("tilt = { x = \"0.9 mrad\" }", LOAD);
        let refused =
            LOAD.to_owned() + &crate::scene::tests::STUDY.replacen(POSITION, "tilt = { x = \"1.1 mrad\" }", 1);
        let error = crate::scene::tests::read(&refused).expect_err("it touches").to_string();
        assert!(error.contains("at the other end too"), "{error}");
    }

    #[test]
    fn a_long_bearing_knows_no_tilt() {
        let with = format!("{POSITION}, tilt = {{}}");
        let text = crate::scene::tests::STUDY.replacen(POSITION, &with, 1);
        let long = text.replacen("clearance =", "theory = \"long\", clearance =", 1);
        let error = crate::scene::tests::read(&long).expect_err("long").to_string();
        assert!(error.contains("bearing.theory: is \"long\", but the journal tilts"), "{error}");
    }
}
