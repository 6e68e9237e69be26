//! The keys of a scene: which there are, and what each means.

mod cap;
mod feed;
mod heat;
mod journal;
mod oil;
mod oil_law;
mod sweep;
mod tolerance;

pub use oil::ROELANDS_REFERENCE_PRESSURE;

use crate::complaint::Complaint;
use crate::reader::{Collector, Marks, TableReader};
use crate::scene::{
    Arc, Bearing, Cavitation, CavitationModel, Ends, Engine, Layout, MeshSource, Scene, Theory, Tolerance,
};
use crate::sweep::Plan;
use crate::unit::{self, Dimension};
use std::path::Path;
use toml::de::DeTable;

/// The scene in SI, where its values stand, and all complaints about keys and units. With a complaint, numbers of
/// the scene may be NaN and texts empty.
pub(crate) fn read_scene<'a>(table: &'a DeTable<'a>, text: &str, path: &Path) -> (Scene, Marks, Vec<Complaint>) {
    let collector = Collector::new(text);
    let scene = scene(TableReader::root(&collector, table), text, path);
    let (marks, complaints) = collector.finish();
    (scene, marks, complaints)
}

fn scene(mut root: TableReader<'_>, text: &str, path: &Path) -> Scene {
    let stem = || {
        path.file_stem()
            .map_or(String::new(), |stem| stem.to_string_lossy().into_owned())
    };
    let journal_keys = match root.has("load") {
        true => "[journal] with speed",
        false => "[journal] with speed, eccentricity and min_film_angle",
    };
    let load = root.table_if_given("load");
    let under_load = load.is_some();
    let (source, tolerance) = match root.table_if_given("mesh") {
        Some(table) => mesh(table, path, under_load),
        None => (
            MeshSource::Drawing { size: None },
            Some(Tolerance::where_nothing_is_given(under_load)),
        ),
    };
    let heat = root.table_if_given("heat").map(heat::read);
    let engine = heat.and_then(|heat| heat.engine);
    let mut scene = Scene {
        title: root
            .text_if_given("title", "Plain journal bearing")
            .unwrap_or_else(stem),
        bearing: bearing(
            root.table("bearing", "[bearing] with diameter, length and clearance"),
            engine,
        ),
        mesh: source,
        tolerance,
        // Open to the zero of all pressures unless said.
        ends: root.table_if_given("ends").map_or(Ends { pressure: 0.0 }, ends),
        feeds: root
            .tables("feed")
            .into_iter()
            .map(|feed| feed::read(feed, engine))
            .collect(),
        journal: journal::read(root.table("journal", journal_keys), load),
        oil: oil::read(root.table("oil", "[oil] with viscosity = \"40 mPa.s\""), heat.as_ref()),
        heat,
        cavitation: root.table_if_given("cavitation").and_then(cavitation),
        cap: root.table_if_given("cap").map(cap::read),
        sweep: root.table_if_given("sweep").map(|table| Plan {
            axes: sweep::read(table),
            text: text.to_owned(),
            path: path.to_owned(),
        }),
        sha256: String::new(),
    };
    root.finish();
    let theory = scene.bearing.theory;
    scene.tolerance = scene.tolerance.map(|tolerance| tolerance.suited(theory));
    scene
}

const MESH_FILE: &str = "../meshes/liner.msh";

/// An engine has a usual clearance, where none is written.
fn bearing(mut table: TableReader<'_>, engine: Option<Engine>) -> Bearing {
    let mut inlet_fraction = None;
    let theories = [Theory::Full, Theory::Short, Theory::Long].map(|theory| (theory.name(), theory));
    let diameter = table.quantity("diameter", Dimension::Length, "75 mm");
    let usual = engine.filter(|_| !table.has("clearance"));
    let bearing = Bearing {
        diameter,
        length: table.quantity("length", Dimension::Length, "75 mm"),
        clearance: match usual {
            Some(engine) => 0.5 * diameter * Engine::middle(engine.clearance_ratio()),
            None => table.quantity("clearance", Dimension::Length, "37.5 um"),
        },
        arc: table.table_if_given("arc").map(|mut arc| {
            let from = arc.quantity("from", Dimension::Angle, "40 deg");
            let to = arc.quantity("to", Dimension::Angle, "220 deg");
            inlet_fraction = arc.number_if_given("inlet_fraction", "0.6");
            arc.finish();
            Arc { from, to }
        }),
        inlet_fraction,
        film_start: table.quantity_if_given("film_start", Dimension::Angle, "180 deg"),
        roughness: table.quantity_if_given("roughness", Dimension::Length, "0.4 um"),
        theory: table.word_if_given("theory", &theories).unwrap_or_default(),
    };
    table.finish();
    bearing
}

/// Without a table, a file or a size the liner is meshed as the film needs, also if no tolerance says how well; a file
/// with a size is meshed anew.
fn mesh(mut table: TableReader<'_>, scene: &Path, under_load: bool) -> (MeshSource, Option<Tolerance>) {
    let file = table.text_if_given("file", MESH_FILE);
    let size = table.quantity_if_given("size", Dimension::Length, "3 mm");
    let unit = table
        .text_if_given("unit", "mm")
        .map(|name| match unit::unit_size(&name, Dimension::Length) {
            Ok(size) => size,
            Err(error) => {
                table.complain("unit", error.to_string(), error.help("mm"));
                f64::NAN
            }
        });
    if unit.is_some() && !table.has("file") {
        table.complain(
            "unit",
            "has a meaning for a mesh file only",
            "remove unit, or give the file",
        );
    }
    let layout = table.word_if_given("layout", &[("rows", Layout::Rows), ("file", Layout::File)]);
    if layout.is_some() && (!table.has("file") || size.is_some()) {
        table.complain(
            "layout",
            "has a meaning for a mesh file that is used as it is",
            "remove layout, or give the file without size",
        );
    }
    let tolerance = tolerance::read(&mut table, under_load);
    let described = !table.has("file");
    let is_bare = described && !table.has("size") && !table.has("tolerance");
    table.finish();
    let tolerance = match is_bare {
        true => Some(Tolerance::where_nothing_is_given(under_load)),
        false => tolerance,
    };
    let source = match file {
        None if described => MeshSource::Drawing { size },
        file => MeshSource::File {
            path: scene.parent().unwrap_or(Path::new("")).join(file.unwrap_or_default()),
            unit: unit.unwrap_or(1.0),
            size,
            layout: layout.unwrap_or_default(),
        },
    };
    (source, tolerance)
}

fn ends(mut table: TableReader<'_>) -> Ends {
    let pressure = table.quantity("pressure", Dimension::Pressure, "0 bar");
    table.finish();
    Ends { pressure }
}

fn cavitation(mut table: TableReader<'_>) -> Option<Cavitation> {
    let models = [
        CavitationModel::None,
        CavitationModel::Guembel,
        CavitationModel::Reynolds,
        CavitationModel::Jfo,
    ]
    .map(|model| (model.name(), model));
    if !table.has("model") && table.is_readable() {
        let help = "write model = \"none\", \"guembel\", \"reynolds\" or \"jfo\"";
        table.complain("model", "is missing", help);
    }
    let model = table.word_if_given("model", &models);
    let pressure = table
        .quantity_if_given("pressure", Dimension::Pressure, "0 bar")
        .unwrap_or(0.0);
    table.finish();
    model.map(|model| Cavitation { model, pressure })
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::SceneError;
    use crate::scene::{BarusForm, PressureLaw};

    pub(in crate::schema) const STUDY: &str = r#"
title = "Hole-fed shell"
bearing = { diameter = "75 mm", length = "75 mm", clearance = "37.5 um", arc = { from = "40 deg", to = "220 deg" } }
mesh = { file = "../meshes/shell.msh", unit = "mm" }
ends = { pressure = "0.98 bar" }
feed = [{ group = "feed_hole", hole = { diameter = "17 mm", angle = "130 deg" }, pressure = "1.96 bar" }]
journal = { speed = "3000 rpm", eccentricity = 0.6, min_film_angle = "180 deg" }
oil = { viscosity = "0.4 Pa.s", barus = { alpha = "2.5e-8 1/Pa" } }
"#;

    pub(in crate::schema) fn read(text: &str) -> Result<Scene, SceneError> {
        Scene::parse(text, Path::new("scenes/study.toml"))
    }

    pub(in crate::schema) fn told(from: &str, to: &str) -> Vec<Complaint> {
        assert!(STUDY.contains(from), "{from}");
        match read(&STUDY.replacen(from, to, 1)) {
            Err(SceneError::Complaints { complaints, .. }) => complaints,
            other => panic!("{to}: {other:?}"),
        }
    }

    pub(in crate::schema) fn told_one(from: &str, to: &str, wanted: &str) {
        let told = told(from, to);
        assert!(
            told.len() == 1 && told[0].to_string().starts_with(wanted),
            "{to}: {told:?}"
        );
    }

    #[test]
    fn the_study_is_read_in_si() {
        let scene = read(STUDY).expect("the study is a scene");
        assert_eq!(scene.title, "Hole-fed shell");
        assert_eq!((scene.bearing.diameter, scene.bearing.length), (0.075, 0.075));
        let path = Path::new("scenes/../meshes/shell.msh").to_path_buf();
        assert_eq!(
            scene.mesh,
            MeshSource::File {
                path,
                unit: 1e-3,
                size: None,
                layout: Layout::Rows,
            }
        );
        assert_eq!(
            scene.feeds[0].hole.map(|hole| (hole.diameter, hole.z)),
            Some((0.017, 0.0))
        );
        assert!((scene.journal.speed - 100.0 * std::f64::consts::PI).abs() < 1e-12);
        let law = PressureLaw::Barus {
            alpha: 2.5e-8,
            form: BarusForm::Conservative,
        };
        assert_eq!((scene.oil.pressure_law, scene.cavitation), (law, None));
        assert_eq!((scene.sha256.len(), scene.tolerance), (64, None));
        assert_eq!(
            read(&STUDY.replace("title = \"Hole-fed shell\"", ""))
                .map(|scene| scene.title)
                .ok(),
            Some("study".into())
        );
    }

    #[test]
    fn every_complaint_comes_at_once_and_points_into_the_text() {
        let text = STUDY
            .replace("\"37.5 um\"", "37.5")
            .replace("\"3000 rpm\"", "\"3000 mm\"")
            .replace("title", "titel");
        let Err(SceneError::Complaints { text, complaints, .. }) = read(&text) else {
            panic!("must be refused")
        };
        let told: Vec<_> = complaints
            .iter()
            .map(|it| (it.key.as_str(), &text[it.span.clone().unwrap_or_default()]))
            .collect();
        let wanted = [
            ("titel", "titel = \"Hole-fed shell\""),
            ("bearing.clearance", "37.5"),
            ("journal.speed", "\"3000 mm\""),
        ];
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
        assert!(
            told[1].help.ends_with("eccentricity, min_film_angle, speed, squeeze"),
            "{told:?}"
        );
    }

    #[test]
    fn the_example_is_that_of_the_key() {
        for wrong in [
            "\"37.5 bar\"",
            "\"37.5\"",
            "\"37.5 furlong\"",
            "\"37,5 um\"",
            "37.5",
            "true",
        ] {
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
            assert_eq!(scene.cavitation, Some(Cavitation { model, pressure }));
        }
        told_one(
            "title = ",
            "cavitation.model = \"reynold\"\ntitle = ",
            "cavitation.model: \"reynold\" is not known",
        );
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
        told_one(
            table,
            "mesh.unit = \"mm\"",
            "mesh.unit: has a meaning for a mesh file only",
        );
    }

    #[test]
    fn kinds_are_checked() {
        let one = told_one;
        one(
            "0.6",
            "\"0.6\"",
            "journal.eccentricity: a plain number is wanted, not a text",
        );
        one("0.6", "nan", "journal.eccentricity: is not a finite number");
        one("0.6", "-inf", "journal.eccentricity: is not a finite number");
        one(
            "\"0.98 bar\"",
            "true",
            "ends.pressure: a pressure is wanted, not true or false",
        );
        one(
            "{ pressure = \"0.98 bar\" }",
            "5",
            "ends: a table is wanted, not a bare number",
        );
        one(
            ", min_film_angle = \"180 deg\"",
            "",
            "journal.min_film_angle: is missing",
        );
        one(
            "unit = \"mm\"",
            "unit = \"Pa\"",
            "mesh.unit: \"Pa\" is a unit of pressure",
        );
        one("\"feed_hole\"", "\" \"", "feed[0].group: is empty");
        one(
            "title = ",
            "cavitation.pressure = \"0 bar\"\ntitle = ",
            "cavitation.model: is missing",
        );
        let feed = &STUDY[STUDY.find("feed").unwrap_or(0)..STUDY.find("journal").unwrap_or(0)];
        one(feed, "feed.pressure = \"1 bar\"\n", "feed: a list of tables is wanted");
    }

    #[test]
    fn broken_toml_is_told_with_its_place() {
        for text in [
            "[bearing\ndiameter = 5",
            "a = 1\na = 2",
            "a = \"x",
            "\u{0}",
            &"a = ".repeat(50),
            &"[".repeat(100_000),
        ] {
            match read(text) {
                Err(SceneError::Syntax { complaints, .. }) => assert!(!complaints.is_empty()),
                other => panic!("{other:?}"),
            }
        }
        let deep = format!("a = {}1{}", "[".repeat(50_000), "]".repeat(50_000));
        assert!(read(&deep).is_err());
        assert!(matches!(read(""), Err(SceneError::Complaints { complaints, .. }) if complaints.len() == 3));
    }
}
