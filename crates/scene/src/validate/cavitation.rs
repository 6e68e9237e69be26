//! Which cavities can be computed: pressures that leave oil at the supply, and what each model needs.

use super::Checks;
use crate::scene::{BarusForm, Cavitation, CavitationModel, PressureLaw, Scene};
use crate::wording::bars;

/// Equal pressures in other units differ by this part at most.
const SAME: f64 = 1e-12;

impl Checks<'_> {
    pub(super) fn cavitation(&mut self, scene: &Scene) {
        let Some(cavitation) = scene.cavitation else { return };
        if cavitation.model == CavitationModel::None {
            return;
        }
        self.supply_above_cavity(&cavitation, scene.ends.pressure, "ends.pressure", "");
        for (index, feed) in scene.feeds.iter().enumerate() {
            if let Some(pressure) = feed.pressure {
                let (key, group) = (format!("feed[{index}].pressure"), format!(" (\"{}\")", feed.group));
                self.supply_above_cavity(&cavitation, pressure, &key, &group);
            }
        }
        if cavitation.model == CavitationModel::Jfo {
            self.conserving_cavity(scene);
        }
    }

    /// How full the film is where it begins: only a cavity that conserves oil knows of it.
    pub(super) fn inlet(&mut self, scene: &Scene) {
        let Some(fraction) = scene.bearing.inlet_fraction else {
            return;
        };
        let key = "bearing.arc.inlet_fraction";
        self.refuse_if(
            fraction <= 0.0 || fraction > 1.0,
            key,
            format!("is {fraction}, outside 0 < inlet_fraction <= 1"),
            "give the part of the gap that the oil brought in fills, or remove it: the edge is flooded then",
        );
        let conserves = scene.cavitation.is_some_and(|it| it.model == CavitationModel::Jfo);
        self.refuse_if(
            !conserves,
            key,
            "has a meaning with cavitation.model = \"jfo\" only: other films are full where they begin",
            "take cavitation.model = \"jfo\", or remove inlet_fraction: the edge is flooded then",
        );
    }

    /// Oil that is supplied below the pressure of the cavity would not be liquid.
    fn supply_above_cavity(&mut self, cavitation: &Cavitation, given: f64, key: &str, group: &str) {
        let cavity = cavitation.pressure;
        let message = format!(
            "is {}, above the {} of {key}{group}: the oil there would be vapour",
            bars(cavity),
            bars(given)
        );
        let help = format!("give the gauge pressure of the cavity, at most that of ends and feeds, or raise {key}");
        let above = cavity - given > SAME * cavity.abs();
        self.refuse_if(above, "cavitation.pressure", message, help);
    }

    /// A balance of mass in the cavity needs a balance of mass in the film, and a journal that carries the oil on.
    fn conserving_cavity(&mut self, scene: &Scene) {
        let as_printed = match scene.oil.pressure_law {
            PressureLaw::Barus { form, .. } => form == BarusForm::AsPrinted,
            PressureLaw::Constant | PressureLaw::Roelands { .. } => false,
        };
        self.refuse_if(
            as_printed,
            "oil.barus.form",
            "is the as-printed equation, which is no balance of mass, and cavitation.model = \"jfo\" needs one",
            "remove form (the equation is conservative then), or take cavitation.model = \"reynolds\"",
        );
        self.refuse_if(
            scene.journal.speed == 0.0,
            "cavitation.model",
            "is \"jfo\", but journal.speed is 0: without rotation nothing carries the oil in the cavity, and its film fraction is undetermined",
            "take cavitation.model = \"reynolds\", or give the journal a speed",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::validate::tests::{GOOD, told, told_one};
    use crate::{Scene, SceneError};
    use std::path::Path;

    fn with_model(edits: &[(&str, &str)]) -> Result<Scene, SceneError> {
        let text = edits.iter().fold(GOOD.to_owned(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replacen(from, to, 1)
        });
        Scene::parse(&text, Path::new("good.toml"))
    }

    #[test]
    fn supply_below_the_cavity_is_refused_with_both_values() {
        for model in ["guembel", "reynolds", "jfo"] {
            let cavity = format!("\"{model}\"\npressure = \"1.5 bar\"");
            let ends =
                "cavitation.pressure: is 1.5 bar, above the 0.98 bar of ends.pressure: the oil there would be vapour";
            told_one("\"guembel\"", &cavity, ends);
            let cavity = format!("\"{model}\"\npressure = \"2 bar\"");
            let told = told("\"guembel\"", &cavity);
            let feed = "cavitation.pressure: is 2 bar, above the 1.96 bar of feed[0].pressure (\"feed_hole\")";
            assert!(told.len() == 2 && told[1].starts_with(feed), "{told:?}");
        }
        told_one(
            "\"0.98 bar\"",
            "\"-0.5 bar\"",
            "cavitation.pressure: is 0 bar, above the -0.5 bar of ends.pressure",
        );
        assert!(told("\"guembel\"", "\"none\"\npressure = \"2 bar\"").is_empty());
    }

    #[test]
    fn supply_at_the_pressure_of_the_cavity_is_fine() {
        let pairs = [("0.98 bar", "0.98 bar"), ("7 kPa", "0.07 bar"), ("-7 kPa", "-0.07 bar")];
        for (ends, cavity) in pairs {
            let cavity = format!("\"jfo\"\npressure = \"{cavity}\"");
            let scene = with_model(&[("0.98 bar", ends), ("1.96 bar", ends), ("\"guembel\"", &cavity)]);
            assert!(scene.is_ok(), "{ends}: {scene:?}");
        }
    }

    #[test]
    fn a_cavity_that_conserves_oil_needs_an_equation_that_does() {
        let printed = ("1/Pa\"", "1/Pa\", form = \"as-printed\"");
        for model in ["none", "guembel", "reynolds"] {
            let scene = with_model(&[printed, ("guembel", model)]);
            assert!(scene.is_ok(), "{model}: {scene:?}");
        }
        let error = with_model(&[printed, ("guembel", "jfo")])
            .expect_err("no balance")
            .to_string();
        let message = "oil.barus.form: is the as-printed equation, which is no balance of mass, and cavitation.model = \"jfo\" needs one";
        assert!(
            error.contains(message) && error.contains("(remove form (the equation is conservative then), or take"),
            "{error}"
        );
    }

    #[test]
    fn a_cavity_that_conserves_oil_needs_a_journal_that_turns() {
        assert!(with_model(&[("10 rad/s", "0 rad/s"), ("guembel", "reynolds")]).is_ok());
        assert!(with_model(&[("10 rad/s", "-1 rpm"), ("guembel", "jfo")]).is_ok());
        for squeeze in ["", "squeeze = { radial = \"-2 mm/s\" }\n"] {
            let journal = format!("{squeeze}eccentricity");
            let at_rest = [("10 rad/s", "0 rpm"), ("guembel", "jfo"), ("eccentricity", &journal)];
            let error = with_model(&at_rest).expect_err("nothing moves").to_string();
            let message =
                "cavitation.model: is \"jfo\", but journal.speed is 0: without rotation nothing carries the oil";
            assert!(
                error.contains(message) && error.contains("(take cavitation.model = \"reynolds\","),
                "{error}"
            );
        }
    }

    #[test]
    fn a_starved_inlet_needs_a_cavity_that_conserves_oil() {
        let starved = |fraction: &str| format!("to = \"220 deg\", inlet_fraction = {fraction} }}");
        let to = "to = \"220 deg\" }";
        for model in ["none", "guembel", "reynolds"] {
            let error = with_model(&[(to, &starved("0.6")), ("guembel", model)])
                .expect_err("no film fraction")
                .to_string();
            let wanted = "bearing.arc.inlet_fraction: has a meaning with cavitation.model = \"jfo\" only";
            assert!(error.contains(wanted) && !error.contains("outside"), "{error}");
        }
        for good in ["0.6", "1", "1e-3"] {
            let scene = with_model(&[(to, &starved(good)), ("guembel", "jfo")]);
            assert_eq!(
                scene.map(|scene| scene.bearing.inlet_fraction).ok(),
                Some(good.parse().ok())
            );
        }
        for bad in ["0", "-0.1", "1.01"] {
            let error = with_model(&[(to, &starved(bad)), ("guembel", "jfo")])
                .expect_err("out of range")
                .to_string();
            let wanted = format!("bearing.arc.inlet_fraction: is {bad}, outside 0 < inlet_fraction <= 1");
            assert!(error.contains(&wanted), "{error}");
        }
        let at_rest = [(to, &starved("0.6")[..]), ("guembel", "jfo"), ("10 rad/s", "0 rad/s")];
        let error = with_model(&at_rest).expect_err("nothing brings oil in").to_string();
        assert!(error.contains("is \"jfo\", but journal.speed is 0"), "{error}");
    }
}
