//! Which scenes can be computed: ranges, and keys that must fit each other. Everything wrong is told at once.
//!
//! A value that was complained about already is NaN here; no comparison below is true of it.

mod cap;
mod cavitation;
mod feeds;
mod heat;
mod oil;
mod position;
mod theory;
mod tolerance;

use crate::complaint::Complaint;
use crate::reader::Marks;
use crate::scene::{Bearing, MeshSource, Scene};
use crate::wording::{degrees, millimetres};
use std::f64::consts::TAU;

/// Names of a mesh's groups that have a meaning of their own, so that no feed may bear them.
pub const RESERVED_GROUPS: [&str; 8] = [
    "film",
    "film_start",
    "end_low",
    "end_high",
    "arc_from",
    "arc_to",
    "seam_low",
    "seam_high",
];

/// All complaints about the values of a scene.
pub fn complaints(scene: &Scene, marks: &Marks) -> Vec<Complaint> {
    let mut checks = Checks {
        marks,
        complaints: Vec::new(),
    };
    checks.bearing(&scene.bearing);
    if let MeshSource::Drawing { size: Some(size) } | MeshSource::File { size: Some(size), .. } = scene.mesh {
        checks.positive(size, "mesh.size");
    }
    checks.theory(scene);
    checks.tolerance(scene);
    checks.feeds(scene);
    checks.journal(&scene.journal);
    checks.oil(scene);
    if checks.complaints.is_empty() {
        checks.pressures(scene);
    }
    checks.heat(scene);
    checks.cavitation(scene);
    checks.inlet(scene);
    checks.cap(scene);
    checks.complaints
}

struct Checks<'a> {
    marks: &'a Marks,
    complaints: Vec<Complaint>,
}

impl Checks<'_> {
    fn refuse_if(&mut self, wrong: bool, key: &str, message: impl Into<String>, help: impl Into<String>) {
        if wrong {
            self.complaints.push(self.marks.complaint(key, message, help));
        }
    }

    fn positive(&mut self, value: f64, key: &str) {
        self.refuse_if(value <= 0.0, key, "is not positive", "give a value above zero");
    }

    fn bearing(&mut self, bearing: &Bearing) {
        self.positive(bearing.diameter, "bearing.diameter");
        self.positive(bearing.length, "bearing.length");
        self.positive(bearing.clearance, "bearing.clearance");
        if let Some(roughness) = bearing.roughness {
            self.positive(roughness, "bearing.roughness");
        }
        self.refuse_if(
            bearing.diameter > 0.0 && bearing.clearance >= bearing.radius(),
            "bearing.clearance",
            format!("is not smaller than the radius, {}", millimetres(bearing.radius())),
            "give the radial clearance, about a thousandth of half the bearing.diameter; is it in um?",
        );
        if let Some(arc) = bearing.arc {
            let (from, to) = (degrees(arc.from), degrees(arc.to));
            let message = format!("ends at {to}, which is not behind its beginning, {from}");
            let help = "count up from one to the other: from = \"320 deg\", to = \"400 deg\" crosses zero";
            self.refuse_if(arc.to <= arc.from, "bearing.arc.to", message, help);
            let message = format!(
                "makes the arc {} wide from {from} on, but an arc is less than 360 deg",
                degrees(arc.to - arc.from)
            );
            let help = "for a full ring remove arc; bearing.film_start then holds a line at the end pressure";
            self.refuse_if(
                arc.to - arc.from >= TAU * (1.0 - 1e-12),
                "bearing.arc.to",
                message,
                help,
            );
            self.refuse_if(
                bearing.film_start.is_some(),
                "bearing.film_start",
                "has a meaning on a full ring only, and this bearing has an arc",
                "remove film_start (the film starts at the edge of the arc), or remove arc",
            );
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use crate::{Scene, SceneError};
    use std::path::Path;

    pub(in crate::validate) const GOOD: &str = r#"
[bearing]
diameter = "75 mm"
length = "75 mm"
clearance = "37.5 um"
arc = { from = "40 deg", to = "220 deg" }
[mesh]
file = "liner.msh"
[ends]
pressure = "0.98 bar"
[[feed]]
group = "feed_hole"
hole = { diameter = "17 mm", angle = "130 deg", z = "0 mm" }
pressure = "1.96 bar"
[journal]
speed = "10 rad/s"
eccentricity = 0.6
min_film_angle = "180 deg"
[oil]
viscosity = "0.4 Pa.s"
barus = { alpha = "2.5e-8 1/Pa" }
[cavitation]
model = "guembel"
"#;

    /// Keys and messages of what is wrong when `from` is replaced by `to` in the good scene.
    pub(in crate::validate) fn told(from: &str, to: &str) -> Vec<String> {
        assert!(GOOD.contains(from), "{from}");
        match Scene::parse(&GOOD.replacen(from, to, 1), Path::new("good.toml")) {
            Ok(_) => Vec::new(),
            Err(SceneError::Complaints { complaints, .. }) => {
                assert!(
                    complaints
                        .iter()
                        .all(|complaint| !complaint.help.is_empty() && complaint.span.is_some())
                );
                complaints.iter().map(|complaint| complaint.to_string()).collect()
            }
            Err(other) => panic!("{other}"),
        }
    }

    pub(in crate::validate) fn told_one(from: &str, to: &str, beginning: &str) {
        let told = told(from, to);
        assert!(told.len() == 1 && told[0].starts_with(beginning), "{to}: {told:?}");
    }

    #[test]
    fn the_good_scene_is_good() {
        assert!(told("75 mm", "75 mm").is_empty());
        assert!(told("eccentricity = 0.6", "eccentricity = 0").is_empty());
        assert!(
            told(
                "arc = { from = \"40 deg\", to = \"220 deg\" }",
                "film_start = \"0 deg\""
            )
            .is_empty()
        );
        assert!(
            told(
                "from = \"40 deg\", to = \"220 deg\"",
                "from = \"-320 deg\", to = \"-140 deg\""
            )
            .is_empty()
        );
    }

    #[test]
    fn each_range_is_checked() {
        told_one(
            "diameter = \"75 mm\"",
            "diameter = \"-75 mm\"",
            "bearing.diameter: is not positive",
        );
        told_one(
            "length = \"75 mm\"",
            "length = \"0 mm\"",
            "bearing.length: is not positive",
        );
        told_one(
            "37.5 um",
            "37.5 mm",
            "bearing.clearance: is not smaller than the radius, 37.5 mm",
        );
        told_one("from = \"40 deg\"", "from = \"220 deg\"", "bearing.arc.to: ends at 220");
        told_one(
            "to = \"220 deg\"",
            "to = \"400 deg\"",
            "bearing.arc.to: makes the arc 360",
        );
        told_one(
            "[mesh]",
            "film_start = \"0 deg\"\n[mesh]",
            "bearing.film_start: has a meaning on a full ring",
        );
        told_one("0.4 Pa.s", "0 Pa.s", "oil.viscosity: is not positive");
        told_one("2.5e-8", "-2.5e-8", "oil.barus.alpha: is negative");
        told_one(
            "\"feed_hole\"",
            "\"end_low\"",
            "feed[0].group: \"end_low\" is a name that meshes use",
        );
        told_one(
            "z = \"0 mm\"",
            "z = \"30 mm\"",
            "feed[0].hole.z: puts the hole's rim beyond the end",
        );
        told_one("130 deg", "50 deg", "feed[0].hole.angle: puts the hole");
        told_one("17 mm", "80 mm", "feed[0].hole.diameter: is wider than the liner");
        told_one(
            "\"guembel\"",
            "\"guembel\"\npressure = \"1 bar\"",
            "cavitation.pressure: is 1 bar, above the 0.98 bar of ends.pressure",
        );
        told_one(
            "barus = { alpha = \"2.5e-8 1/Pa\" }",
            "roelands = { z = -1 }",
            "oil.roelands.z: is negative",
        );
        let second = "[[feed]]\ngroup = \"feed_hole\"\npressure = \"1 bar\"\n[journal]";
        told_one("[journal]", second, "feed[1].group: \"feed_hole\" is fed already");
        let second = "[[feed]]\ngroup = \"b\"\nhole = { diameter = \"5 mm\", angle = \"135 deg\" }\npressure = \"1 bar\"\n[journal]";
        told_one("[journal]", second, "feed[1].hole: overlaps the hole of \"feed_hole\"");
    }

    #[test]
    fn a_thin_oil_is_no_roelands_oil() {
        let scene = GOOD
            .replace("barus = { alpha = \"2.5e-8 1/Pa\" }", "roelands = { z = 0.6 }")
            .replace("0.4 Pa.s", "0.04 mPa.s");
        let error = Scene::parse(&scene, Path::new("thin.toml"))
            .expect_err("too thin")
            .to_string();
        assert!(
            error.contains("oil.viscosity: is below the range of Roelands"),
            "{error}"
        );
    }
}
