//! Scenes whose keys are in range, but that cannot be computed.

use std::path::Path;

use oilwedge_scene::{Complaint, Scene, SceneError};

use crate::oil::Oil;

const GOOD: &str = r#"
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

const OIL: &str = "viscosity = \"0.4 Pa.s\"\nbarus = { alpha = \"2.5e-8 1/Pa\" }";
const FILE: &str = "file = \"liner.msh\"";

fn read(text: &str) -> Result<Scene, SceneError> {
    super::parse(text, Path::new("good.toml"))
}

/// What is wrong when `from` is replaced by `to` in the good scene.
fn complaints(from: &str, to: &str) -> Vec<Complaint> {
    assert!(GOOD.contains(from), "{from}");
    match read(&GOOD.replacen(from, to, 1)) {
        Ok(_) => Vec::new(),
        Err(SceneError::Complaints { complaints, .. }) => complaints,
        Err(other) => panic!("{other}"),
    }
}

/// The one thing that is wrong begins with `beginning`, and its help has `help`.
fn one(from: &str, to: &str, [beginning, help]: [&str; 2]) {
    let found = complaints(from, to);
    let is_meant =
        |it: &Complaint| it.to_string().starts_with(beginning) && it.help.contains(help) && it.span.is_some();
    assert!(found.len() == 1 && is_meant(&found[0]), "{to}: {found:?}");
}

#[test]
fn every_law_is_read() {
    for (oil, temperature, viscosity) in [
        ("grade = \"SAE 10W-40\"", "40 C", 95e-6 * 855.09),
        ("grade = \"sae10w40\", density = \"900 kg/m3\"", "40 C", 95e-6 * 887.6),
        ("walther = { nu40 = \"55 mm2/s\", nu100 = \"8.19 cSt\" }, density = \"885 kg/m3\"", "100 C", 8.19e-6 * 836.3),
        (
            "walther = { t1 = \"313.15 K\", nu1 = \"55 mm2/s\", t2 = \"100 C\", nu2 = \"8.19 mm2/s\" }",
            "373.15 K",
            8.19e-6 * 822.1,
        ),
        ("vogel = { a = \"0.05 mPa.s\", b = \"1000 K\", c = \"95 K\" }", "80 C", 5e-5 * (1000.0f64 / 175.0).exp()),
        ("table = [{ t = \"40 C\", mu = \"80 mPa.s\" }, { t = \"100 C\", mu = \"12 mPa.s\" }]", "100 C", 0.012),
        (
            "density = { value = \"868 kg/m3\", at = \"15 C\", expansion = \"70e-5 1/K\" }, table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14 mm2/s\" }]",
            "40 C",
            95e-6 * 868.0 * (1.0 - 70e-5 * 20.0) / (1.0 + 70e-5 * 5.0),
        ),
    ] {
        let table = format!("oil = {{ {oil}, temperature = \"{temperature}\" }}\n[bearing]");
        let text = GOOD.replacen(&format!("[oil]\n{OIL}\n"), "", 1).replacen("[bearing]", &table, 1);
        let found = Oil::of(&read(&text).expect(oil));
        assert!(found.thermal.is_some() && found.temperature.is_some());
        let found = found.viscosity;
        assert!((found / viscosity - 1.0).abs() < 1e-4, "{oil}: {found} is not {viscosity}");
    }
}

#[test]
fn laws_need_known_grades_and_falling_viscosities() {
    let at = ", temperature = \"80 C\"";
    let without = GOOD.replacen(&format!("[oil]\n{OIL}\n"), "", 1);
    for (oil, wanted, help) in [
        (
            &format!("oil = {{ grade = \"SAE 10W-41\"{at} }}"),
            "oil.grade: \"SAE 10W-41\" is no grade",
            "did you mean \"SAE 10W-40\"",
        ),
        (&format!("oil = {{ grade = \"oil\"{at} }}"), "oil.grade: \"oil\" is no grade", "oilwedge oil lists all"),
        (
            &format!("oil = {{ walther = {{ nu40 = \"8 mm2/s\", nu100 = \"55 mm2/s\" }}{at} }}"),
            "oil.walther: needs two points or more, each hotter one",
            "nu40 = \"95 mm2/s\"",
        ),
        (
            &format!("oil = {{ walther = {{ nu40 = \"8 mm2/s\", nu100 = \"0.3 mm2/s\" }}{at} }}"),
            "oil.walther: has a viscosity of 0.3 mm2/s",
            "nu100",
        ),
        (&format!("oil = {{ table = []{at} }}"), "oil.table: needs two points", "table = ["),
        (
            &format!("oil = {{ table = [{{ t = \"40 C\", nu = \"95 mm2/s\" }}]{at} }}"),
            "oil.table: needs two points",
            "table = [",
        ),
        // A fault in a value is reported once.
        (&format!("oil = {{ grade = 5{at} }}"), "oil.grade: a text in quotes is wanted", "SAE 10W-40"),
        (&format!("oil = {{ walther = {{ nu40 = \"55 mm2/s\" }}{at} }}"), "oil.walther.nu100: is missing", "nu100 = "),
    ] {
        let Err(SceneError::Complaints { complaints, .. }) = read(&format!("{oil}\n{without}")) else {
            panic!("{oil} is refused")
        };
        let (message, way_out) = (complaints[0].to_string(), &complaints[0].help);
        assert!(complaints.len() == 1 && message.starts_with(wanted) && way_out.contains(help), "{complaints:?}");
    }
}

const VISCOSITY: &str = "viscosity = \"0.4 Pa.s\"";

#[test]
fn laws_of_temperature_are_checked() {
    let vogel = |numbers: &str| format!("vogel = {{ {numbers} }}");
    let table = "table = [{ t = \"40 C\", nu = \"95 mm2/s\" }, { t = \"100 C\", nu = \"14 mm2/s\" }]";
    for (oil, temperature, wanted) in [
        (
            "grade = \"VG 46\"",
            "80 K",
            "oil.temperature: is -193.15 C, but oil films are liquid between -60 C and 350 C",
        ),
        ("grade = \"VG 46\"", "500 C", "oil.temperature: is 500 C, but"),
        (&vogel("a = \"0 Pa.s\", b = \"900 K\", c = \"95 K\""), "80 C", "oil.vogel.a: is not positive"),
        (&vogel("a = \"1 mPa.s\", b = \"-900 K\", c = \"95 K\""), "80 C", "oil.vogel.b: is negative"),
        (
            &vogel("a = \"1 mPa.s\", b = \"900 K\", c = \"-90 K\""),
            "80 C",
            "oil.temperature: is not above 90 C, below which Vogel's law",
        ),
        (
            &vogel("a = \"1 mPa.s\", b = \"90000000 K\", c = \"95 K\""),
            "80 C",
            "oil.temperature: leaves the oil a viscosity of inf Pa.s",
        ),
        (table, "39 C", "oil.temperature: lies outside oil.table, which reaches from 40 C to 100 C"),
        (table, "101 C", "oil.temperature: lies outside oil.table"),
        ("density = \"0.9 kg/m3\"\ngrade = \"VG 46\"", "80 C", "oil.density: is not the density of an oil"),
        (
            "density = { value = \"9 kg/m3\" }\ngrade = \"VG 46\"",
            "80 C",
            "oil.density.value: is not the density of an oil",
        ),
        (
            "density = { value = \"900 kg/m3\", expansion = \"1 1/K\" }\ngrade = \"VG 46\"",
            "80 C",
            "oil.density.expansion: is not the expansion",
        ),
    ] {
        one(VISCOSITY, &format!("{oil}\ntemperature = \"{temperature}\""), [wanted, ""]);
    }
    assert!(complaints(VISCOSITY, &format!("{table}\ntemperature = \"40 C\"")).is_empty());
    assert!(complaints(VISCOSITY, "grade = \"SAE 5W-30\"\ntemperature = \"120 C\"").is_empty());
    assert!(complaints(VISCOSITY, &format!("{VISCOSITY}\ndensity = \"900 kg/m3\"")).is_empty());
}

/// The ends have 0.98 bar, the feed 1.96 bar.
#[test]
fn pressures_that_make_oil_solid_are_refused() {
    let alpha = "2.5e-8 1/Pa";
    assert!(complaints(alpha, "1e-4 1/Pa").is_empty());
    one(alpha, "2e-4 1/Pa", ["feed \"feed_hole\".pressure: makes the oil 1.1e17 times as viscous", "lower pressure"]);
}

#[test]
fn a_thin_oil_is_no_roelands_oil() {
    let thin = "viscosity = \"0.04 mPa.s\"\nroelands = { z = 0.6 }";
    one(OIL, thin, ["oil.viscosity: is below the range of Roelands", "0.0632 mPa.s"]);
}

#[test]
fn a_wall_carries_the_load() {
    let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"";
    let wall = |modulus: &str| {
        let wall = format!("wall = {{ thickness = \"2 mm\", modulus = \"{modulus}\", poisson = 0.3 }}");
        format!("[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n[liner]\n{wall}")
    };
    let wanted = "liner.wall.modulus: is too soft: the mean pressure of the load, 8.8";
    one(position, &wall("210 kPa"), [wanted, "is its unit right?"]);
    assert!(complaints(position, &wall("210 GPa")).is_empty());
}

fn with(tolerance: &str) -> String {
    format!("{FILE}\ntolerance = {tolerance}")
}

#[test]
fn only_numbers_with_errors_have_tolerances() {
    for good in ["feed_flow.feed_hole", "load_coefficient", "sommerfeld_number", "attitude_angle", "load_angle"] {
        assert!(complaints(FILE, &with(&format!("{{ {good} = \"1 %\" }}"))).is_empty(), "{good}");
    }
    for given in ["eccentricity", "min_film_angle", "film_thickness_min"] {
        let wanted = format!("mesh.tolerance.{given}: follows from the position");
        one(FILE, &with(&format!("{{ {given} = \"1 %\" }}")), [&wanted, "[load]"]);
    }
    let wanted = "mesh.tolerance.feed_flow.fed_hole: belongs to no [[feed]] of this scene";
    one(FILE, &with("{ feed_flow.fed_hole = \"1 %\" }"), [wanted, "feed_flow.feed_hole"]);
}

#[test]
fn a_number_that_the_scene_lacks_has_no_tolerance() {
    let lacks = |edit: (&str, &str), name: &str, wanted: &str| {
        let text = GOOD.replacen(FILE, &with(&format!("{{ {name} = \"1 %\" }}")), 1);
        let text = text.replacen(edit.0, edit.1, 1);
        let error = read(&text).expect_err(name).to_string();
        assert!(error.contains(&format!("mesh.tolerance.{name}: {wanted}")), "{error}");
    };
    let pocket = ("pressure = \"1.96 bar\"", "depth = \"20 um\"");
    lacks(pocket, "feed_flow.feed_hole", "belongs to the pocket \"feed_hole\", which lets no oil in");
    lacks(pocket, "load_coefficient", "has a meaning only where there are feeds");
    lacks(("10 rad/s", "0 rpm"), "sommerfeld_number", "has no meaning for a journal that does not turn");
    lacks(("= 0.6", "= 0"), "attitude_angle", "has no meaning for a centred journal");
}

#[test]
fn only_known_quantities_have_tolerances() {
    for (name, wanted, help) in [
        ("laod", "laod: this key is not known", "did you mean \"load\"?"),
        (
            "friction",
            "friction: this key is not known",
            "known here: attitude_angle, contact_share, deflection_max, eccentricity, feed_flow, film_",
        ),
        ("pressure_min", "pressure_min: this key is not known", "pressure_max"),
        ("feed_flow", "feed_flow: a table is wanted", "feed_flow.GROUP"),
    ] {
        let wanted = format!("mesh.tolerance.{wanted}");
        one(FILE, &with(&format!("{{ {name} = \"1 %\" }}")), [&wanted, help]);
    }
}

#[test]
fn targets_stand_in_the_order_of_the_result() {
    let targets = |text: &str| {
        let scene = read(text).unwrap_or_else(|error| panic!("{error}"));
        let targets = super::targets(&scene)?.required.into_iter();
        Some(targets.map(|target| (target.quantity, target.relative)).collect::<Vec<_>>())
    };
    let mesh = |keys: &str| targets(&GOOD.replacen(FILE, keys, 1));
    let main = |name: &str, relative: f64| Some(vec![(name.to_owned(), relative)]);
    assert_eq!(mesh(&with("\"0.1 %\"")), main("load", 0.1 * 0.01));
    assert_eq!((mesh(FILE), mesh("")), (None, main("load", 0.005)));
    let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"";
    let loaded = GOOD.replacen(position, "[load]\nforce = \"5 kN\"\nangle = \"270 deg\"", 1);
    assert_eq!(targets(&loaded.replacen(FILE, "", 1)), main("eccentricity", 0.005));
    let ring = GOOD.replacen("arc = { from = \"40 deg\", to = \"220 deg\" }", "theory = \"short\"", 1);
    let (feed, journal) = (ring.find("[[feed]]").unwrap_or(0), ring.find("[journal]").unwrap_or(0));
    let short = [&ring[..feed], &ring[journal..]].concat();
    assert_eq!(targets(&short.replacen(FILE, "", 1)), main("load", 0.001));
    let names = "pressure_integral = \"1 %\", feed_flow.feed_hole = \"1 %\", friction_power = \"1 %\", load = \"1 %\"";
    let several = mesh(&with(&format!("{{ {names} }}"))).into_iter().flatten();
    let wanted = ["load", "friction_power", "feed_flow.feed_hole", "pressure_integral"];
    assert_eq!(several.map(|(name, _)| name).collect::<Vec<_>>(), wanted);
}
