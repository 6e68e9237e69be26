//! `[bearing]`: the liner, its clearance, and which pressure flows are computed.

use std::f64::consts::TAU;

use crate::reader::TableReader;
use crate::wording::{degrees, millimetres};
use crate::{Complaints, Feed, Scene};

keys! {
    "bearing" = Table; "", "required", "",
        "the liner, its clearance, and which pressure flows are computed";
    "bearing.diameter" = Quantity(Length); "75 mm", "required", "> 0",
        "bore D = 2 R";
    "bearing.length" = Quantity(Length); "75 mm", "required", "> 0",
        "full length B, end to end";
    "bearing.clearance" = Quantity(Length); "37.5 um", "required unless `diametral_clearance` or a `heat.preset`", "> 0, < R",
        "radial clearance c, about R/1000";
    "bearing.diametral_clearance" = Quantity(Length); "75 um", "`clearance` gives it", "> 0, < D",
        "instead of `clearance`: bore minus journal diameter, 2 c";
    "bearing.arc" = Table; "", "full ring, periodic", "",
        "the part of the circle that is liner; its two edges are held at the pressure of the ends";
    "bearing.arc.from" = Quantity(Angle); "40 deg", "required", "",
        "angle at which the liner begins";
    "bearing.arc.to" = Quantity(Angle); "220 deg", "required", "from < to < from + 360 deg",
        "angle at which the liner ends";
    "bearing.arc.inlet_fraction" = Number; "0.6", "flooded: the pressure of the ends holds there", "0 < fraction <= 1, with `jfo`",
        "how full the gap is with the oil that the journal carries in at the leading edge; the pressure there is found";
    "bearing.roughness" = Quantity(Length); "0.4 um", "no check", "> 0",
        "combined roughness of journal and liner (root mean square): a run without `[contact]` warns where the least film is below three times as much. `[contact]` and `[roughness]` are computed with it, nothing else";
    "bearing.elastic_modulus" = Quantity(Pressure); "210 GPa", "that of steel, 210 GPa", "> 0",
        "Young's modulus of journal and liner: a run warns where their elastic deflection under the load exceeds the least film. Nothing is computed with it";
    "bearing.film_start" = Quantity(Angle); "180 deg", "no such line", "ring only",
        "a line across the ring, held at the pressure of the ends. The mesh needs a line of element edges there, as at its seam";
    "bearing.theory" = Choice(&["full", "short", "long"]); "full", "`\"full\"`", "",
        "which flow pressure drives: in both directions, along the axis only, around only";
}

/// The liner.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingTable {
    /// Bore D [m].
    pub diameter: f64,
    /// Full length B [m].
    pub length: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// The part of the circumference that is liner; `None`: a full ring, periodic.
    pub arc: Option<Arc>,
    /// Arc only: film fraction of the oil that the journal brings in at its leading edge; `None`: that edge is flooded.
    pub inlet_fraction: Option<f64>,
    /// Ring only: angle of an axial line held at the pressure of the ends [rad].
    pub film_start: Option<f64>,
    /// Combined roughness of journal and liner (root mean square) [m], for contact and flow factors, and for a warning
    /// where no contact is simulated.
    pub roughness: Option<f64>,
    /// Young's modulus of journal and liner [Pa], for a warning where they deflect; `None`: that of steel. Nothing is
    /// computed with it.
    pub elastic_modulus: Option<f64>,
    /// The directions in which pressure drives oil.
    pub theory: TheoryKey,
}

impl BearingTable {
    /// Journal radius R = D/2 [m].
    pub fn radius(&self) -> f64 {
        0.5 * self.diameter
    }
}

/// A part of the circumference, counted from +x towards +y; `from < to < from + 2 pi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Angle at which the arc begins [rad].
    pub from: f64,
    /// Angle at which the arc ends [rad].
    pub to: f64,
}

/// The directions in which pressure drives oil.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum TheoryKey {
    /// Pressure drives oil around and along the axis.
    #[default]
    Full,
    /// Pressure drives oil along the axis only.
    Short,
    /// Pressure drives oil around only: the ends are sealed.
    Long,
}

impl TheoryKey {
    /// Name in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Short => "short",
            Self::Long => "long",
        }
    }
}

/// Reads the table; `usual_ratio` is the clearance over the radius where none is written.
pub(crate) fn read(mut table: TableReader<'_>, usual_ratio: Option<f64>) -> BearingTable {
    let diameter = table.required("diameter");
    let length = table.required("length");
    let diametral = table.given("diametral_clearance");
    table.refuse_if(
        diametral.is_some() && table.has("clearance"),
        "diametral_clearance",
        "stands beside clearance, which is half of it",
        "keep one: clearance is radial, diametral_clearance is D - d of bore and journal",
    );
    let clearance = table.number("clearance");
    let clearance = match (diametral, usual_ratio) {
        (Some(diametral), _) => clearance.or(0.5 * diametral),
        (None, Some(ratio)) => clearance.or(0.5 * diameter * ratio),
        (None, None) => clearance.required(),
    };
    let radius = 0.5 * diameter;
    table.refuse_if(
        clearance >= radius,
        if diametral.is_some() { "diametral_clearance" } else { "clearance" },
        format!("is not smaller than the radius, {}", millimetres(radius)),
        "give the radial clearance, about a thousandth of half the bearing.diameter; is it in um?",
    );
    let (arc, inlet_fraction) = table.table_if_given("arc").map_or((None, None), arc);
    let film_start = table.given("film_start");
    table.refuse_if(
        arc.is_some() && film_start.is_some(),
        "film_start",
        "has a meaning on a full ring only, and this bearing has an arc",
        "remove film_start (the film starts at the edge of the arc), or remove arc",
    );
    let theories = [TheoryKey::Full, TheoryKey::Short, TheoryKey::Long].map(|theory| (theory.name(), theory));
    BearingTable {
        diameter,
        length,
        clearance,
        arc,
        inlet_fraction,
        film_start,
        roughness: table.given("roughness"),
        elastic_modulus: table.given("elastic_modulus"),
        theory: table.word("theory", &theories).unwrap_or_default(),
    }
}

fn arc(mut table: TableReader<'_>) -> (Option<Arc>, Option<f64>) {
    let from = table.required("from");
    let to = table.required("to");
    table.refuse_if(
        to <= from,
        "to",
        format!("ends at {}, which is not behind its beginning, {}", degrees(to), degrees(from)),
        "count up from one to the other: from = \"320 deg\", to = \"400 deg\" crosses zero",
    );
    table.refuse_if(
        to - from >= TAU * (1.0 - 1e-12),
        "to",
        format!("makes the arc {} wide from {} on, but an arc is less than 360 deg", degrees(to - from), degrees(from)),
        "for a full ring remove arc; bearing.film_start then holds a line at the end pressure",
    );
    let fraction = table.number("inlet_fraction").within_or(
        |fraction, _| format!("is {fraction}, outside 0 < inlet_fraction <= 1"),
        "give the part of the gap that the oil brought in fills, or remove it: the edge is flooded then",
    );
    let inlet_fraction = fraction.given();
    (Some(Arc { from, to }), inlet_fraction)
}

/// Scenes that a short or long bearing has no meaning for. A short film is a set of independent lines along the axis;
/// the pressure of a long one is known up to a constant unless a line fixes it.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    let bearing = &scene.bearing;
    let mut refuse_if = |wrong: bool, message: &str, help: &str| {
        let message = format!("is \"{}\", but {message}", bearing.theory.name());
        complaints.refuse_if(wrong, "bearing.theory", message, help);
    };
    match bearing.theory {
        TheoryKey::Full => {}
        TheoryKey::Short => {
            refuse_if(
                bearing.arc.is_some(),
                "bearing.arc is given: a short film has pressures at the ends only, and cannot meet those at the edges of an arc",
                "remove theory, or remove arc: the load of a full ring stands for that of an arc which covers the loaded half",
            );
            refuse_if(
                !scene.feeds.is_empty(),
                "there is a feed: at its edges a short film would jump to another pressure",
                "remove theory, or remove the feed",
            );
        }
        TheoryKey::Long => {
            refuse_if(
                bearing.arc.is_none() && bearing.film_start.is_none(),
                "no line of the bearing has a pressure: its ends are sealed, and the pressure of a long ring is known up to a constant only",
                "give bearing.film_start = \"180 deg\" (the angle of the widest film is common), or an arc",
            );
            refuse_if(
                !scene.feeds.iter().all(|feed| spans_length(feed, bearing)),
                "there is a feed: around a hole or a groove the pressure changes along the axis",
                "remove theory, or remove the feed; a groove as wide as the bearing is long may stay",
            );
        }
    }
}

/// Whether a feed is the same all along the axis.
fn spans_length(feed: &Feed, bearing: &BearingTable) -> bool {
    feed.groove.is_some_and(|groove| groove.width == bearing.length && groove.z == 0.0 && groove.corner == 0.0)
}

#[cfg(test)]
mod tests {
    use crate::{Scene, SceneError};
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
        match Scene::parse(text, Path::new("ring.toml"), &[]) {
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
            (theory("short", "") + jfo, "is \"short\", but cavitation.model is \"jfo\""),
            (theory("long", ""), "is \"long\", but no line of the bearing has a pressure"),
            (theory("long", start) + FEED, "is \"long\", but there is a feed"),
        ] {
            let told = told(&bad);
            assert!(told.len() == 1 && told[0].contains(&format!("bearing.theory: {wanted}")), "{told:?}");
        }
        assert!(told(&theory("middling", ""))[0].contains("bearing.theory"));
    }
}
