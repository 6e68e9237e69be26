//! Which tolerances can be met: neither below rounding nor above reason, and of numbers that the scene has.

use super::Checks;
use crate::scene::{Position, Scene, Target};
use crate::spelling::nearest;
use crate::wording::percent;

/// Rounding hides smaller errors [1].
const LEAST: f64 = 1e-10;
/// A bar that is longer tells nothing [1].
const GREATEST: f64 = 0.5;
/// What a feed lets in.
const FEED_FLOW: &str = "feed_flow.";

impl Checks<'_> {
    pub(super) fn tolerance(&mut self, scene: &Scene) {
        let Some(tolerance) = &scene.tolerance else { return };
        for (index, target) in tolerance.targets.iter().enumerate() {
            let by_name = format!("mesh.tolerance.{}", target.quantity);
            let key = match self.marks.has(&by_name) {
                true => by_name,
                false => "mesh.tolerance".to_owned(),
            };
            self.bound(target.relative, &key);
            let twice = tolerance.targets[..index]
                .iter()
                .any(|it| it.quantity == target.quantity);
            self.refuse_if(twice, &key, "is given twice", "give each quantity one tolerance");
            self.meaning(scene, target, &key);
        }
    }

    fn bound(&mut self, relative: f64, key: &str) {
        self.refuse_if(
            relative < LEAST,
            key,
            format!(
                "is {}, but rounding hides errors below {}",
                percent(relative),
                percent(LEAST)
            ),
            "give a tolerance within 1e-8 % and 50 %, for example \"0.1 %\"",
        );
        self.refuse_if(
            relative > GREATEST,
            key,
            format!(
                "is {}, and a number with such an error tells nothing",
                percent(relative)
            ),
            "give a tolerance within 1e-8 % and 50 %, for example \"0.1 %\"",
        );
    }

    /// A quantity that is absent from the result has no bar, and one that the scene gives has none either.
    fn meaning(&mut self, scene: &Scene, target: &Target, key: &str) {
        if let Some(group) = target.quantity.strip_prefix(FEED_FLOW) {
            return self.fed(scene, group, key);
        }
        let journal = &scene.journal;
        let centred = matches!(journal.position, Position::Given { eccentricity: 0.0, .. });
        let mut pressures = scene.feeds.iter().filter_map(|feed| feed.pressure);
        let supply = pressures.next();
        let (message, help) = match target.quantity.as_str() {
            "eccentricity" | "min_film_angle" | "film_thickness_min" if journal.load().is_none() => (
                "follows from the position that the scene gives, so it has no error to make smaller",
                "give a tolerance of the load, or [load] in the place of the position",
            ),
            "attitude_angle" if centred => (
                "has no meaning for a centred journal",
                "remove it, or give an eccentricity above zero",
            ),
            "sommerfeld_number" | "inlet_flow" | "friction_torque" | "friction_coefficient" | "friction_power"
                if journal.speed == 0.0 =>
            {
                (
                    "has no meaning for a journal that does not turn",
                    "remove it, or give a tolerance of the load",
                )
            }
            "load_coefficient" if supply.is_none() || pressures.any(|other| Some(other) != supply) => (
                "has a meaning only where there are feeds, all of one pressure",
                "remove it, or give a tolerance of the load",
            ),
            _ => return,
        };
        self.refuse_if(true, key, message, help);
    }

    fn fed(&mut self, scene: &Scene, group: &str, key: &str) {
        let fed = || scene.feeds.iter().filter(|feed| feed.pressure.is_some());
        let groups = || fed().map(|feed| feed.group.as_str());
        let is_pocket = scene
            .feeds
            .iter()
            .any(|feed| feed.group == group && feed.depth.is_some());
        let message = match is_pocket {
            true => format!("belongs to the pocket \"{group}\", which lets no oil in"),
            false => format!("belongs to no [[feed]] of this scene: there is no group \"{group}\""),
        };
        let help = match (nearest(group, groups()), groups().next()) {
            (Some(near), _) => format!("did you mean \"{FEED_FLOW}{near}\"?"),
            (None, Some(_)) => format!("groups with a pressure: {}", groups().collect::<Vec<_>>().join(", ")),
            (None, None) => "remove it; no [[feed]] has a pressure".to_owned(),
        };
        self.refuse_if(!groups().any(|it| it == group), key, message, help);
    }
}

#[cfg(test)]
mod tests {
    use crate::Scene;
    use crate::validate::tests::{GOOD, told, told_one};
    use std::path::Path;

    const FILE: &str = "file = \"liner.msh\"";

    fn with(tolerance: &str) -> String {
        format!("{FILE}\ntolerance = {tolerance}")
    }

    #[test]
    fn bounds_are_checked() {
        for good in ["\"50 %\"", "\"1e-8 %\"", "{ load = \"0.1 %\", side_flow = \"1 %\" }"] {
            assert!(told(FILE, &with(good)).is_empty(), "{good}");
        }
        told_one(
            FILE,
            &with("\"51 %\""),
            "mesh.tolerance: is 51 %, and a number with such an error",
        );
        told_one(
            FILE,
            &with("\"0 %\""),
            "mesh.tolerance: is 0 %, but rounding hides errors below 1e-8 %",
        );
        told_one(FILE, &with("\"-1 %\""), "mesh.tolerance: is -1 %");
        told_one(
            FILE,
            &with("{ side_flow = \"60 %\" }"),
            "mesh.tolerance.side_flow: is 60 %",
        );
        let twice = "{ feed_flow.feed_hole = \"1 %\", \"feed_flow.feed_hole\" = \"1 %\" }";
        told_one(FILE, &with(twice), "mesh.tolerance.feed_flow.feed_hole: is given twice");
    }

    #[test]
    fn only_numbers_with_errors_have_tolerances() {
        for good in [
            "feed_flow.feed_hole",
            "load_coefficient",
            "sommerfeld_number",
            "attitude_angle",
            "load_angle",
        ] {
            assert!(
                told(FILE, &with(&format!("{{ {good} = \"1 %\" }}"))).is_empty(),
                "{good}"
            );
        }
        for given in ["eccentricity", "min_film_angle", "film_thickness_min"] {
            let wanted = format!("mesh.tolerance.{given}: follows from the position");
            told_one(FILE, &with(&format!("{{ {given} = \"1 %\" }}")), &wanted);
        }
        let wanted = "mesh.tolerance.feed_flow.fed_hole: belongs to no [[feed]] of this scene";
        told_one(FILE, &with("{ feed_flow.fed_hole = \"1 %\" }"), wanted);
    }

    #[test]
    fn a_number_that_the_scene_lacks_has_no_tolerance() {
        let lacks = |edit: (&str, &str), name: &str, wanted: &str| {
            let text = GOOD.replacen(FILE, &with(&format!("{{ {name} = \"1 %\" }}")), 1);
            let text = text.replacen(edit.0, edit.1, 1);
            let error = Scene::parse(&text, Path::new("good.toml")).expect_err(name).to_string();
            assert!(error.contains(&format!("mesh.tolerance.{name}: {wanted}")), "{error}");
        };
        let pocket = ("pressure = \"1.96 bar\"", "depth = \"20 um\"");
        lacks(
            pocket,
            "feed_flow.feed_hole",
            "belongs to the pocket \"feed_hole\", which lets no oil in",
        );
        lacks(pocket, "load_coefficient", "has a meaning only where there are feeds");
        lacks(
            ("10 rad/s", "0 rpm"),
            "sommerfeld_number",
            "has no meaning for a journal that does not turn",
        );
        lacks(
            ("= 0.6", "= 0"),
            "attitude_angle",
            "has no meaning for a centred journal",
        );
    }
}
