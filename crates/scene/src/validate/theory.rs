//! Which scenes a short or long bearing has a meaning for.

use super::Checks;
use crate::scene::{CavitationModel, Scene, Theory};

const KEY: &str = "bearing.theory";

impl Checks<'_> {
    pub(super) fn theory(&mut self, scene: &Scene) {
        match scene.bearing.theory {
            Theory::Full => {}
            Theory::Short => self.short(scene),
            Theory::Long => self.long(scene),
        }
    }

    /// Each line along the axis stands by itself: nothing is carried from one to the next, and no pressure along a line can be met.
    fn short(&mut self, scene: &Scene) {
        self.refuse_if(
            scene.bearing.arc.is_some(),
            KEY,
            "is \"short\", but bearing.arc is given: a short film has pressures at the ends only, and cannot meet those at the edges of an arc",
            "remove theory, or remove arc: the load of a full ring stands for that of an arc which covers the loaded half",
        );
        self.refuse_if(
            !scene.feeds.is_empty(),
            KEY,
            "is \"short\", but there is a feed: behind and before its edges a short film would jump to another pressure",
            "remove theory, or remove the feed",
        );
        let conserves = scene.cavitation.is_some_and(|it| it.model == CavitationModel::Jfo);
        self.refuse_if(
            conserves,
            KEY,
            "is \"short\", but cavitation.model is \"jfo\": its cells exchange oil in both directions",
            "take cavitation.model = \"guembel\", which the short bearing is known with, or \"reynolds\"; or remove theory",
        );
    }

    /// The pressure depends on the angle alone, up to a constant unless a line fixes it.
    fn long(&mut self, scene: &Scene) {
        let bearing = &scene.bearing;
        self.refuse_if(
            bearing.arc.is_none() && bearing.film_start.is_none(),
            KEY,
            "is \"long\", but no line of the bearing has a pressure: its ends are sealed, and the pressure of a long ring is known but for a constant",
            "give bearing.film_start = \"180 deg\" (the angle of the widest film is common), or an arc",
        );
        self.refuse_if(
            !scene.feeds.is_empty(),
            KEY,
            "is \"long\", but there is a feed: round a hole or a groove the pressure changes along the axis",
            "remove theory, or remove the feed",
        );
    }
}

#[cfg(test)]
mod tests {
    use crate::Scene;
    use crate::complaint::SceneError;
    use std::path::Path;

    const RING: &str = r#"
[bearing]
diameter = "75 mm"
length = "75 mm"
clearance = "37.5 um"
theory = "short"
[journal]
speed = "10 rad/s"
eccentricity = 0.6
min_film_angle = "180 deg"
[oil]
viscosity = "0.4 Pa.s"
"#;
    const FEED: &str =
        "[[feed]]\ngroup = \"hole\"\npressure = \"1 bar\"\nhole = { diameter = \"9 mm\", angle = \"130 deg\" }\n";
    const ARC: &str = "arc = { from = \"40 deg\", to = \"220 deg\" }";

    fn told(text: &str) -> Vec<String> {
        match Scene::parse(text, Path::new("ring.toml")) {
            Ok(_) => Vec::new(),
            Err(SceneError::Complaints { complaints, .. }) => complaints.iter().map(ToString::to_string).collect(),
            Err(other) => panic!("{other}"),
        }
    }

    #[test]
    fn what_a_theory_has_no_meaning_for_is_refused() {
        let theory = |theory: &str, more: &str| {
            RING.replacen("theory = \"short\"", &format!("theory = \"{theory}\"\n{more}"), 1)
        };
        let start = "film_start = \"0 deg\"";
        for good in [
            theory("short", ""),
            theory("short", start),
            theory("long", start),
            theory("long", ARC),
            theory("full", ARC),
        ] {
            assert_eq!(told(&good), Vec::<String>::new(), "{good}");
        }
        let jfo = "[cavitation]\nmodel = \"jfo\"\n";
        for (bad, wanted) in [
            (theory("short", ARC), "is \"short\", but bearing.arc is given"),
            (theory("short", "") + FEED, "is \"short\", but there is a feed"),
            (
                theory("short", "") + jfo,
                "is \"short\", but cavitation.model is \"jfo\"",
            ),
            (
                theory("long", ""),
                "is \"long\", but no line of the bearing has a pressure",
            ),
            (theory("long", start) + FEED, "is \"long\", but there is a feed"),
        ] {
            let told = told(&bad);
            assert!(
                told.len() == 1 && told[0].contains(&format!("bearing.theory: {wanted}")),
                "{told:?}"
            );
        }
        assert!(told(&theory("middling", ""))[0].contains("bearing.theory"));
    }
}
