//! Scenes of the tests of all tables, and tests of whole scenes.

use super::*;
use crate::{BarusForm, BarusTable, CavitationModel, Layout, PressureLawTable};

pub(crate) const STUDY: &str = r#"
title = "Hole-fed shell"
bearing = { diameter = "75 mm", length = "75 mm", clearance = "37.5 um", arc = { from = "40 deg", to = "220 deg" } }
mesh = { file = "../meshes/shell.msh", unit = "mm" }
ends = { pressure = "0.98 bar" }
feed = [{ group = "feed_hole", hole = { diameter = "17 mm", angle = "130 deg" }, pressure = "1.96 bar" }]
journal = { speed = "3000 rpm", eccentricity = 0.6, min_film_angle = "180 deg" }
oil = { viscosity = "0.4 Pa.s", barus = { alpha = "2.5e-8 1/Pa" } }
"#;

pub(crate) fn read(text: &str) -> Result<Scene, SceneError> {
    Scene::parse(text, Path::new("scenes/study.toml"), &[])
}

pub(crate) fn told(from: &str, to: &str) -> Vec<Complaint> {
    assert!(STUDY.contains(from), "{from}");
    match read(&STUDY.replacen(from, to, 1)) {
        Err(SceneError::Complaints { complaints, .. }) => complaints,
        other => panic!("{to}: {other:?}"),
    }
}

pub(crate) fn told_one(from: &str, to: &str, wanted: &str) {
    let told = told(from, to);
    assert!(told.len() == 1 && told[0].to_string().starts_with(wanted), "{to}: {told:?}");
}

/// A scene with a table a header.
pub(crate) mod good {
    use crate::{Scene, SceneError};
    use std::path::Path;

    pub(crate) const GOOD: &str = r#"
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

    /// The good scene with some edits.
    pub(crate) fn with(edits: &[(&str, &str)]) -> Result<Scene, SceneError> {
        let text = edits.iter().fold(GOOD.to_owned(), |text, (from, to)| {
            assert!(text.contains(from), "{from}");
            text.replacen(from, to, 1)
        });
        Scene::parse(&text, Path::new("good.toml"), &[])
    }

    /// Keys and messages of what is wrong when `from` is replaced by `to` in the good scene.
    pub(crate) fn told(from: &str, to: &str) -> Vec<String> {
        assert!(GOOD.contains(from), "{from}");
        match Scene::parse(&GOOD.replacen(from, to, 1), Path::new("good.toml"), &[]) {
            Ok(_) => Vec::new(),
            Err(SceneError::Complaints { complaints, .. }) => {
                assert!(complaints.iter().all(|complaint| !complaint.help.is_empty() && complaint.span.is_some()));
                complaints.iter().map(|complaint| complaint.to_string()).collect()
            }
            Err(other) => panic!("{other}"),
        }
    }

    pub(crate) fn told_one(from: &str, to: &str, beginning: &str) {
        let told = told(from, to);
        assert!(told.len() == 1 && told[0].starts_with(beginning), "{to}: {told:?}");
    }
}

#[test]
fn the_study_is_read_in_si() {
    let scene = read(STUDY).expect("the study is a scene");
    assert_eq!(scene.title, "Hole-fed shell");
    assert_eq!((scene.bearing.diameter, scene.bearing.length), (0.075, 0.075));
    let path = Path::new("scenes/../meshes/shell.msh").to_path_buf();
    assert_eq!(scene.mesh, MeshSource::File { path, unit: 1e-3, size: None, layout: Layout::Rows });
    assert_eq!(scene.feeds[0].hole.map(|hole| (hole.diameter, hole.z)), Some((0.017, 0.0)));
    assert!((scene.journal.speed - 100.0 * std::f64::consts::PI).abs() < 1e-12);
    let law = PressureLawTable::Barus(BarusTable { alpha: 2.5e-8, form: BarusForm::Conservative });
    assert_eq!((scene.oil.pressure_law, scene.cavitation), (law, None));
    assert_eq!((scene.sha256.len(), scene.tolerance), (64, None));
    assert_eq!(
        read(&STUDY.replace("title = \"Hole-fed shell\"", "")).map(|scene| scene.title).ok(),
        Some("study".into())
    );
}

#[test]
fn every_complaint_comes_at_once_and_points_into_the_text() {
    let text = STUDY.replace("\"37.5 um\"", "37.5").replace("\"3000 rpm\"", "\"3000 mm\"").replace("title", "titel");
    let Err(SceneError::Complaints { text, complaints, .. }) = read(&text) else { panic!("must be refused") };
    let told: Vec<_> =
        complaints.iter().map(|it| (it.key.as_str(), &text[it.span.clone().unwrap_or_default()])).collect();
    let wanted =
        [("titel", "titel = \"Hole-fed shell\""), ("bearing.clearance", "37.5"), ("journal.speed", "\"3000 mm\"")];
    assert_eq!(told, wanted);
    assert_eq!(complaints[0].help, "did you mean \"title\"?");
    assert!(complaints[1].help.starts_with("write clearance = \"37.5 um\""));
}

#[test]
fn a_misspelt_key_is_not_missing_too() {
    told_one("clearance", "clearence", "bearing.clearence: this key is not known");
    told_one("speed", "sped", "journal.sped: this key is not known");
    let told = told("speed", "colour");
    assert_eq!(told.len(), 2, "{told:?}");
    assert!(told[1].help.ends_with("eccentricity, min_film_angle, speed, squeeze, tilt, tilt_rate"), "{told:?}");
}

#[test]
fn the_example_is_that_of_the_key() {
    for wrong in ["\"37.5 bar\"", "\"37.5\"", "\"37.5 furlong\"", "\"37,5 um\"", "37.5", "true"] {
        let told = told("\"37.5 um\"", wrong);
        assert!(told.len() == 1 && told[0].help.contains("\"37.5 um\""), "{told:?}");
    }
}

#[test]
fn every_model_of_cavitation_is_read() {
    let models = [
        ("none", CavitationModel::None),
        ("guembel", CavitationModel::Guembel),
        ("reynolds", CavitationModel::Reynolds),
        ("jfo", CavitationModel::Jfo),
    ];
    for (name, model) in models {
        let table = format!("cavitation = {{ model = \"{name}\", pressure = \"-0.5 bar\" }}\ntitle = ");
        let scene = read(&STUDY.replacen("title = ", &table, 1)).expect("a scene");
        let pressure = -0.5e5;
        assert_eq!(scene.cavitation, Some(CavitationTable { model, pressure }));
    }
    told_one("title = ", "cavitation.model = \"reynold\"\ntitle = ", "cavitation.model: \"reynold\" is not known");
}

#[test]
fn without_a_file_the_liner_described_is_meshed() {
    let table = "mesh = { file = \"../meshes/shell.msh\", unit = \"mm\" }";
    for (other, size) in [("", None), ("mesh = { size = \"3 mm\" }", Some(0.003))] {
        let scene = read(&STUDY.replacen(table, other, 1)).expect("a scene");
        assert_eq!(scene.mesh, MeshSource::Drawing { size });
    }
    let anew = read(&STUDY.replacen("unit = \"mm\"", "size = \"2 mm\"", 1)).expect("a scene");
    assert!(matches!(anew.mesh, MeshSource::File { size: Some(0.002), .. }));
    told_one(table, "mesh.unit = \"mm\"", "mesh.unit: has a meaning for a mesh file only");
}

#[test]
fn kinds_are_checked() {
    let one = told_one;
    one("0.6", "\"0.6\"", "journal.eccentricity: a plain number is wanted, not a text");
    one("0.6", "nan", "journal.eccentricity: is not a finite number");
    one("0.6", "-inf", "journal.eccentricity: is not a finite number");
    one("\"0.98 bar\"", "true", "ends.pressure: a pressure is wanted, not true or false");
    one("{ pressure = \"0.98 bar\" }", "5", "ends: a table is wanted, not a bare number");
    one(", min_film_angle = \"180 deg\"", "", "journal.min_film_angle: is missing");
    one("unit = \"mm\"", "unit = \"Pa\"", "mesh.unit: \"Pa\" is a unit of pressure");
    one("\"feed_hole\"", "\" \"", "feed[0].group: is empty");
    one("title = ", "cavitation.pressure = \"0 bar\"\ntitle = ", "cavitation.model: is missing");
    let feed = &STUDY[STUDY.find("feed").unwrap_or(0)..STUDY.find("journal").unwrap_or(0)];
    one(feed, "feed.pressure = \"1 bar\"\n", "feed: a list of tables is wanted");
}

#[test]
fn broken_toml_is_told_with_its_place() {
    for text in ["[bearing\ndiameter = 5", "a = 1\na = 2", "a = \"x", "\u{0}", &"a = ".repeat(50), &"[".repeat(100_000)]
    {
        match read(text) {
            Err(SceneError::Syntax { complaints, .. }) => assert!(!complaints.is_empty()),
            other => panic!("{other:?}"),
        }
    }
    let deep = format!("a = {}1{}", "[".repeat(50_000), "]".repeat(50_000));
    assert!(read(&deep).is_err());
    assert!(matches!(read(""), Err(SceneError::Complaints { complaints, .. }) if complaints.len() == 3));
}

#[test]
fn the_good_scene_is_good() {
    assert!(good::told("75 mm", "75 mm").is_empty());
    assert!(good::told("eccentricity = 0.6", "eccentricity = 0").is_empty());
    assert!(good::told("arc = { from = \"40 deg\", to = \"220 deg\" }", "film_start = \"0 deg\"").is_empty());
    assert!(good::told("from = \"40 deg\", to = \"220 deg\"", "from = \"-320 deg\", to = \"-140 deg\"").is_empty());
}

#[test]
fn each_range_is_checked() {
    good::told_one("diameter = \"75 mm\"", "diameter = \"-75 mm\"", "bearing.diameter: is not positive");
    good::told_one("length = \"75 mm\"", "length = \"0 mm\"", "bearing.length: is not positive");
    good::told_one("37.5 um", "37.5 mm", "bearing.clearance: is not smaller than the radius, 37.5 mm");
    good::told_one("from = \"40 deg\"", "from = \"220 deg\"", "bearing.arc.to: ends at 220");
    good::told_one("to = \"220 deg\"", "to = \"400 deg\"", "bearing.arc.to: makes the arc 360");
    good::told_one("[mesh]", "film_start = \"0 deg\"\n[mesh]", "bearing.film_start: has a meaning on a full ring");
    good::told_one("0.4 Pa.s", "0 Pa.s", "oil.viscosity: is not positive");
    good::told_one("\"feed_hole\"", "\"end_low\"", "feed \"end_low\".group: \"end_low\" is a name that meshes use");
    good::told_one("z = \"0 mm\"", "z = \"30 mm\"", "feed \"feed_hole\".hole.z: puts the hole's rim beyond the end");
    good::told_one("130 deg", "50 deg", "feed \"feed_hole\".hole.angle: puts the hole");
    good::told_one("17 mm", "80 mm", "feed \"feed_hole\".hole.diameter: is wider than the liner");
    good::told_one(
        "\"guembel\"",
        "\"guembel\"\npressure = \"1 bar\"",
        "cavitation.pressure: is 1 bar, above the 0.98 bar of ends.pressure",
    );
    let second = "[[feed]]\ngroup = \"feed_hole\"\npressure = \"1 bar\"\n[journal]";
    good::told_one("[journal]", second, "feed[1].group: \"feed_hole\" is fed already");
}

#[test]
fn files_that_are_no_scenes_are_refused_by_name() -> std::io::Result<()> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("scene.toml");
    assert!(matches!(Scene::read(&path, &[]), Err(SceneError::Read { .. })));
    assert!(matches!(Scene::read(folder.path(), &[]), Err(SceneError::NotAFile { .. })));
    assert!(matches!(Scene::read(Path::new("/dev/zero"), &[]), Err(SceneError::NotAFile { .. })));
    std::fs::write(&path, vec![b'#'; SCENE_LIMIT as usize + 1])?;
    assert!(matches!(Scene::read(&path, &[]), Err(SceneError::TooLarge { .. })));
    std::fs::write(&path, "$MeshFormat\n4.1 0 8\n")?;
    assert!(matches!(Scene::read(&path, &[]), Err(SceneError::Mesh { .. })));
    std::fs::write(&path, b"title = \"\xff\"")?;
    assert!(matches!(Scene::read(&path, &[]), Err(SceneError::NotText { offset: 9, .. })));
    std::fs::write(&path, "\u{feff}titel = 5\r\n")?;
    let error = Scene::read(&path, &[]).expect_err("no scene").to_string();
    assert!(error.contains("titel: this key is not known (did you mean \"title\"?)"), "{error}");
    Ok(())
}
