//! `[cavitation]`: what happens where the film would break.

use crate::reader::TableReader;
use crate::wording::bars;
use crate::{Complaints, Scene, TheoryKey};

keys! {
    "cavitation" = Table; "", "a full film, whatever its pressure", "",
        "what happens where the film would break";
    "cavitation.model" = Choice(&["none", "guembel", "reynolds", "jfo"]); "none", "required", "",
        "what closes the equation where the film breaks";
    "cavitation.pressure" = Quantity(Pressure); "0 bar", "0", "at most that of ends and feeds",
        "pressure of the cavity";
}

/// Equal pressures in other units differ by this part at most.
const SAME: f64 = 1e-12;

/// What happens where the film would break.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CavitationTable {
    /// The closure.
    pub model: CavitationModel,
    /// Gauge pressure in the cavity p_c [Pa].
    pub pressure: f64,
}

/// The closures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CavitationModel {
    /// Full Sommerfeld film: the oil bears any tension.
    None,
    /// Pressures below the cavity pressure are dropped after the solve.
    Guembel,
    /// Swift-Stieber: the pressure is nowhere below that of the cavity, and meets it without a kink.
    Reynolds,
    /// Jakobsson-Floberg-Olsson: oil is conserved; the cavity holds a film fraction that is carried along.
    Jfo,
}

impl CavitationModel {
    /// All closures.
    const ALL: [Self; 4] = [Self::None, Self::Guembel, Self::Reynolds, Self::Jfo];

    /// True where it leaves the pressure of a cavity, but no film fraction.
    pub fn drops_pressures(self) -> bool {
        matches!(self, Self::Guembel | Self::Reynolds)
    }

    /// True where the edge of the cavity is found with the pressure.
    pub fn has_free_boundary(self) -> bool {
        matches!(self, Self::Reynolds | Self::Jfo)
    }

    /// True where the cavity holds a film fraction that is carried along.
    pub fn conserves_oil(self) -> bool {
        self == Self::Jfo
    }

    /// Name in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Guembel => "guembel",
            Self::Reynolds => "reynolds",
            Self::Jfo => "jfo",
        }
    }
}

impl Scene {
    /// Whether the cavity conserves oil.
    pub fn conserves_oil(&self) -> bool {
        self.cavitation.is_some_and(|it| it.model.conserves_oil())
    }
}

pub(crate) fn read(mut table: TableReader<'_>) -> Option<CavitationTable> {
    if !table.has("model") && table.is_readable() {
        let help = "write model = \"none\", \"guembel\", \"reynolds\" or \"jfo\"";
        table.complain("model", "is missing", help);
    }
    let model = table.word("model", &CavitationModel::ALL.map(|model| (model.name(), model)));
    let pressure = table.number("pressure").or_usual();
    model.map(|model| CavitationTable { model, pressure })
}

/// Pressures that leave oil at the supply, and what a cavity that conserves oil needs.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    conservation(scene, complaints);
    let Some(cavitation) = scene.cavitation.filter(|it| it.model != CavitationModel::None) else {
        return;
    };
    let cavity = cavitation.pressure;
    let feeds =
        (scene.feeds.iter()).filter_map(|feed| Some((format!("feed \"{}\".pressure", feed.group), feed.pressure?)));
    let ends = ("ends.pressure".to_owned(), scene.ends.pressure);
    for (key, given) in [ends].into_iter().chain(feeds) {
        complaints.refuse_if(
            cavity - given > SAME * cavity.abs(),
            "cavitation.pressure",
            format!("is {}, above the {} of {key}: the oil there would be vapour", bars(cavity), bars(given)),
            format!("give the gauge pressure of the cavity, at most that of ends and feeds, or raise {key}"),
        );
    }
}

/// The film fraction is carried along by a journal that turns, on a mesh in two dimensions; only a cavity that
/// conserves oil has one.
fn conservation(scene: &Scene, complaints: &mut Complaints) {
    let conserves = scene.conserves_oil();
    complaints.refuse_if(
        conserves && scene.bearing.theory == TheoryKey::Short,
        "bearing.theory",
        "is \"short\", but cavitation.model is \"jfo\": its cells exchange oil in both directions",
        "take cavitation.model = \"guembel\", which is usual for short bearings, or \"reynolds\"; or remove theory",
    );
    complaints.refuse_if(
        conserves && scene.journal.speed == 0.0 && scene.orbit.is_none(),
        "cavitation.model",
        "is \"jfo\", but journal.speed is 0: without rotation nothing carries the oil in the cavity, and its film fraction is undetermined",
        "take cavitation.model = \"reynolds\", or give the journal a speed",
    );
    complaints.refuse_if(
        !conserves && scene.bearing.inlet_fraction.is_some(),
        "bearing.arc.inlet_fraction",
        "has a meaning with cavitation.model = \"jfo\" only: other films are full where they begin",
        "take cavitation.model = \"jfo\", or remove inlet_fraction: the edge is flooded then",
    );
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::good;

    #[test]
    fn supply_below_the_cavity_is_refused_with_both_values() {
        for model in ["guembel", "reynolds", "jfo"] {
            let cavity = format!("\"{model}\"\npressure = \"1.5 bar\"");
            let ends =
                "cavitation.pressure: is 1.5 bar, above the 0.98 bar of ends.pressure: the oil there would be vapour";
            good::told_one("\"guembel\"", &cavity, ends);
            let cavity = format!("\"{model}\"\npressure = \"2 bar\"");
            let told = good::told("\"guembel\"", &cavity);
            let feed = "cavitation.pressure: is 2 bar, above the 1.96 bar of feed \"feed_hole\".pressure";
            assert!(told.len() == 2 && told[1].starts_with(feed), "{told:?}");
        }
        good::told_one(
            "\"0.98 bar\"",
            "\"-0.5 bar\"",
            "cavitation.pressure: is 0 bar, above the -0.5 bar of ends.pressure",
        );
        assert!(good::told("\"guembel\"", "\"none\"\npressure = \"2 bar\"").is_empty());
    }

    #[test]
    fn supply_at_the_pressure_of_the_cavity_is_fine() {
        let pairs = [("0.98 bar", "0.98 bar"), ("7 kPa", "0.07 bar"), ("-7 kPa", "-0.07 bar")];
        for (ends, cavity) in pairs {
            let cavity = format!("\"jfo\"\npressure = \"{cavity}\"");
            let scene = good::with(&[("0.98 bar", ends), ("1.96 bar", ends), ("\"guembel\"", &cavity)]);
            assert!(scene.is_ok(), "{ends}: {scene:?}");
        }
    }

    #[test]
    fn a_cavity_that_conserves_oil_needs_a_journal_that_turns() {
        assert!(good::with(&[("10 rad/s", "0 rad/s"), ("guembel", "reynolds")]).is_ok());
        assert!(good::with(&[("10 rad/s", "-1 rpm"), ("guembel", "jfo")]).is_ok());
        for squeeze in ["", "squeeze = { radial = \"-2 mm/s\" }\n"] {
            let journal = format!("{squeeze}eccentricity");
            let at_rest = [("10 rad/s", "0 rpm"), ("guembel", "jfo"), ("eccentricity", &journal)];
            let error = good::with(&at_rest).expect_err("nothing moves").to_string();
            let message =
                "cavitation.model: is \"jfo\", but journal.speed is 0: without rotation nothing carries the oil";
            assert!(error.contains(message) && error.contains("(take cavitation.model = \"reynolds\","), "{error}");
        }
    }

    #[test]
    fn a_starved_inlet_needs_a_cavity_that_conserves_oil() {
        let starved = |fraction: &str| format!("to = \"220 deg\", inlet_fraction = {fraction} }}");
        let to = "to = \"220 deg\" }";
        for model in ["none", "guembel", "reynolds"] {
            let error =
                good::with(&[(to, &starved("0.6")), ("guembel", model)]).expect_err("no film fraction").to_string();
            let wanted = "bearing.arc.inlet_fraction: has a meaning with cavitation.model = \"jfo\" only";
            assert!(error.contains(wanted) && !error.contains("outside"), "{error}");
        }
        for good in ["0.6", "1", "1e-3"] {
            let scene = good::with(&[(to, &starved(good)), ("guembel", "jfo")]);
            assert_eq!(scene.map(|scene| scene.bearing.inlet_fraction).ok(), Some(good.parse().ok()));
        }
        for bad in ["0", "-0.1", "1.01"] {
            let error = good::with(&[(to, &starved(bad)), ("guembel", "jfo")]).expect_err("out of range").to_string();
            let wanted = format!("bearing.arc.inlet_fraction: is {bad}, outside 0 < inlet_fraction <= 1");
            assert!(error.contains(&wanted), "{error}");
        }
        let at_rest = [(to, &starved("0.6")[..]), ("guembel", "jfo"), ("10 rad/s", "0 rad/s")];
        let error = good::with(&at_rest).expect_err("nothing brings oil in").to_string();
        assert!(error.contains("is \"jfo\", but journal.speed is 0"), "{error}");
    }
}
