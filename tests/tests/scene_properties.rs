//! Every value of every shipped scene replaced by values that are wrong, huge or none: the scene is refused with a
//! complaint about that key, or it is a scene without a number that is none. Units and cut texts likewise.

use std::ops::Range;
use std::path::Path;

use oilwedge_campaign::{Compare, Records, comparisons};
use oilwedge_scene::unit::{self, Dimension};
use oilwedge_scene::{LoadSource, MeshSource, TemperatureLawTable, Tolerance, Viscosity};
use oilwedge_scene::{Scene, SceneError};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::program::repository;
use proptest::prelude::*;
use toml::de::{DeTable, DeValue};

/// What a value is replaced by.
const VALUES: &str = r#"nan | -nan | inf | -inf | 1e999 | -1e999 | 1e308 | 1e-320 | -1 | 0 | 99999999999999999999 | "" | " " |
"nan mm" | "inf mm" | "1e999 mm" | "1e308 mm" | "-1e308 deg" | "-5 mm" | "5 deg" | "1e300 bar" | "mm" |
true | 1979-05-27 | [] | [nan] | {} | { from = nan } | "\u0000""#;

fn scenes() -> Vec<(String, String)> {
    let files = std::fs::read_dir(repository().join("scenes")).expect("scenes");
    let paths = files.map(|entry| entry.expect("an entry").path());
    let scenes = paths.filter(|path| path.extension().is_some_and(|ending| ending == "toml"));
    let scenes: Vec<_> = scenes
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("a scene");
            (path.display().to_string(), text)
        })
        .collect();
    assert!(scenes.len() >= 18);
    scenes
}

/// Every key below a table with the place of its value; tables and lists count too.
fn values(table: &DeTable<'_>, found: &mut Vec<(String, Range<usize>)>) {
    for (key, value) in table {
        let is_header = value.get_ref().is_table() && value.span().is_empty();
        if !is_header {
            found.push((key.get_ref().to_string(), value.span()));
        }
        below(value.get_ref(), found);
    }
}

fn below(value: &DeValue<'_>, found: &mut Vec<(String, Range<usize>)>) {
    match value {
        DeValue::Table(table) => values(table, found),
        DeValue::Array(items) => items.iter().for_each(|item| below(item.get_ref(), found)),
        _ => {}
    }
}

/// All numbers of a scene are numbers: none of them is told as NaN or infinite.
fn finite(scene: &Scene) -> bool {
    let mut scene = scene.clone();
    scene.title.clear();
    scene.sweep = None;
    scene.feeds.iter_mut().for_each(|feed| feed.group.clear());
    if let MeshSource::File { path, .. } = &mut scene.mesh {
        path.clear();
    }
    if let Some(LoadSource::File { path, .. }) = scene.load_cycle.as_mut().map(|cycle| &mut cycle.source) {
        path.clear();
    }
    if let Some(Tolerance::ByName(targets)) = &mut scene.tolerance {
        targets.iter_mut().for_each(|target| target.quantity.clear());
    }
    if let Viscosity::ByTemperature(TemperatureLawTable::Grade(name)) = &mut scene.oil.viscosity {
        name.clear();
    }
    // A number of a feed has the name of its group.
    scene.tolerances.iter_mut().chain(&mut scene.inputs).for_each(|input| input.key.clear());
    // Words that the user chose may be any.
    scene.text.clear();
    let told = format!("{scene:?}");
    !told.contains("NaN") && !told.contains("inf")
}

fn parse(text: &str) -> Result<Scene, SceneError> {
    oilwedge_study::parse(text, Path::new("scenes/hostile.toml"))
}

#[test]
fn a_wrong_value_of_any_key_is_refused_by_name() {
    let (mut refused, mut accepted) = (0, 0);
    for (name, text) in scenes() {
        let (document, faults) = DeTable::parse_recoverable(&text);
        assert!(faults.is_empty(), "{name}");
        let mut keys = Vec::new();
        values(document.get_ref(), &mut keys);
        assert!(keys.len() > 5, "{name}: {keys:?}");
        for (key, place) in keys {
            // A table with a header of its own has no value to replace.
            if text[place.clone()].starts_with('[') && text[..place.start].trim_end().ends_with(|c: char| c != '=') {
                continue;
            }
            for value in VALUES.split('|').map(str::trim) {
                let spoiled = [&text[..place.start], value, &text[place.end..]].concat();
                match parse(&spoiled) {
                    Ok(scene) => {
                        accepted += 1;
                        assert!(finite(&scene), "{name}: {key} = {value}");
                    }
                    Err(SceneError::Complaints { complaints, .. }) => {
                        refused += 1;
                        // What only the numbers of a cap together lead to is told of the whole table.
                        let named =
                            complaints.iter().any(|it| it.key == "cap" || format!("{it} {}", it.help).contains(&key));
                        assert!(named, "{name}: {key} = {value}: {complaints:?}");
                    }
                    Err(SceneError::Syntax { .. }) => refused += 1,
                    Err(other) => panic!("{name}: {key} = {value}: {other}"),
                }
            }
        }
    }
    assert!(refused > 3000 && accepted > 100);
}

#[test]
fn a_scene_cut_anywhere_is_refused_or_a_scene() {
    for (name, text) in scenes() {
        let ends = text.char_indices().map(|(at, _)| at);
        for end in ends {
            match parse(&text[..end]) {
                Ok(scene) => assert!(finite(&scene), "{name} cut to {end}"),
                Err(error) => assert!(error.to_string().len() > 20, "{name} cut to {end}"),
            }
        }
        for line in 0..text.lines().count() {
            let lines = text.lines().enumerate().filter(|(number, _)| *number != line);
            let left: Vec<&str> = lines.map(|(_, line)| line).collect();
            if let Ok(scene) = parse(&left.join("\n")) {
                assert!(finite(&scene), "{name} without line {line}");
            }
        }
    }
}

const DIMENSIONS: [Dimension; 9] = [
    Dimension::Length,
    Dimension::Angle,
    Dimension::Pressure,
    Dimension::Viscosity,
    Dimension::Speed,
    Dimension::InversePressure,
    Dimension::Force,
    Dimension::Velocity,
    Dimension::Ratio,
];

/// Any legal scene has three theories: each film has numbers or a reason, the report is finite, and nothing panics.
#[test]
fn any_scene_has_three_theories_or_their_reasons() {
    let liners = [
        "",
        ", film_start = \"20 deg\"",
        ", arc = { from = \"60 deg\", to = \"300 deg\" }",
        ", theory = \"short\"",
        ", theory = \"long\", film_start = \"0 deg\"",
    ];
    let feeds = [
        "",
        "feed = [{ group = \"hole\", hole = { diameter = \"8 mm\", angle = \"90 deg\" }, pressure = \"2 bar\" }]\n",
        "feed = [{ group = \"pocket\", groove = { from = \"100 deg\", to = \"130 deg\", width = \"10 mm\" }, depth = \"30 um\" }]\n",
    ];
    let journals = [
        "journal = { speed = \"100 rad/s\", eccentricity = 0.6, min_film_angle = \"200 deg\" }",
        "journal = { speed = \"-100 rad/s\", eccentricity = 0 }",
        "journal = { speed = \"0 rpm\", eccentricity = 0.4, min_film_angle = \"200 deg\", squeeze = { radial = \"1 mm/s\" } }",
        "journal = { speed = \"100 rad/s\" }\nload = { force = \"300 N\", angle = \"270 deg\" }",
    ];
    let models = ["none", "guembel", "reynolds", "jfo"];
    let options = RunOptions { bars: false, ..RunOptions::default() };
    let (mut legal, mut films) = (0, 0);
    // Each liner with each journal and each model; feeds in turn, so that each of them meets all of the others.
    for (i, liner) in liners.iter().enumerate() {
        for (j, journal, k, model) in (journals.iter().enumerate())
            .flat_map(|(j, journal)| models.iter().enumerate().map(move |(k, model)| (j, journal, k, model)))
        {
            let feed = feeds[(i + j + k) % feeds.len()];
            let text = format!(
                "{feed}bearing = {{ diameter = \"60 mm\", length = \"24 mm\", clearance = \"40 um\"{liner} }}\nmesh = {{ size = \"6 mm\" }}\n\
                 ends = {{ pressure = \"1 bar\" }}\n{journal}\noil = {{ viscosity = \"0.02 Pa.s\" }}\ncavitation = {{ model = \"{model}\" }}\n"
            );
            let Ok(scene) = parse(&text) else { continue };
            let solved = run(&scene, &options).unwrap_or_else(|error| panic!("{error}\n{text}"));
            let mut records = Records::default();
            let compared = Compare::Theories.solve(
                (&scene, &oilwedge_study::compile(&scene).expect("a model")),
                &options,
                &solved,
                &mut records,
            );
            compared.unwrap_or_else(|error| panic!("{error}\n{text}"));
            let found = &comparisons(&records, &solved.result)[0];
            for answer in &found.alternatives {
                let has_film = answer.pairs.iter().any(|it| it.other.is_some());
                let has_reason = found.notes.iter().any(|note| note.contains(&format!("{} film: ", answer.name)));
                assert!(has_film || has_reason, "{found:?}\n{text}");
                films += usize::from(has_film);
            }
            oilwedge_report::result_json(&solved.result, &records).unwrap_or_else(|error| panic!("{error}\n{text}"));
            legal += 1;
        }
    }
    assert!(legal > 33 && films > 33, "{legal} scenes, {films} films");
}

proptest! {
    #[test]
    fn every_unit_gives_its_multiple_and_comes_back(digits in 1.0f64..10.0, exponent in -40i32..40, gap in "[ \t]{0,3}") {
        let number = digits * 10f64.powi(exponent);
        for dimension in DIMENSIONS {
            for (name, size) in dimension.units() {
                let value = number * size;
                // A digit of the unit would be one of the number's.
                let gap = if name.starts_with('1') { " " } else { gap.as_str() };
                match unit::parse(&format!("{number:e}{gap}{name}"), dimension) {
                    Ok(read) => {
                        prop_assert_eq!(read, value);
                        let again = unit::parse(&format!("{:e} {name}", read / size), dimension);
                        prop_assert!(again.is_ok_and(|again| (again - read).abs() <= 4e-16 * read.abs() + f64::MIN_POSITIVE));
                    }
                    Err(error) => {
                        prop_assert!(!dimension.holds(value), "{number:e} {name}: {error}");
                        prop_assert!(error.to_string().contains("out of range"));
                    }
                }
            }
        }
    }

    #[test]
    fn any_text_is_a_finite_quantity_or_refused(text in ".{0,40}", front in "[-+]?[0-9.,]{0,8}(e[-+]?[0-9]{0,4})?") {
        for dimension in DIMENSIONS {
            for text in [text.clone(), format!("{front}{text}")] {
                match unit::parse(&text, dimension) {
                    Ok(value) => prop_assert!(value.is_finite()),
                    Err(error) => prop_assert!(!error.help(dimension.example()).is_empty()),
                }
            }
        }
    }

    #[test]
    fn any_text_is_no_panic_as_a_scene(text in "(?s).{0,200}", lines in prop::collection::vec("[a-z.\\[\\]= \"{}0-9,#]{0,30}", 0..12)) {
        for text in [text, lines.join("\n")] {
            if let Ok(scene) = parse(&text) {
                prop_assert!(finite(&scene));
            }
        }
    }
}
