//! The reference pages say what the program does: their examples run, and no key, unit or quantity is left out.
//! (`tests/crosscheck/test_reference_pages.py` runs the snippets for gmsh and pyvista.)

use std::path::Path;

use oilwedge_full::book::Page;
use oilwedge_full::book::blocks::blocks;
use oilwedge_full::{quantities_page, scene_page};
use oilwedge_report::load_sheet::LoadSheet;
use oilwedge_scene::catalogue::keys;
use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{Scene, SceneError};
use oilwedge_study::duty::duty_cycle;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::{path, table, variant};
use serde_json::Value;

fn page(name: &str) -> String {
    std::fs::read_to_string(repository().join("docs/reference").join(name)).expect("a reference page")
}

fn table_of<'a>(scene: &'a mut toml::Table, name: &str) -> Option<&'a mut toml::Table> {
    scene.get_mut(name).and_then(toml::Value::as_table_mut)
}

/// Scene 01 with the keys of a fragment; a load takes the place of its position, a law of temperature that of its
/// viscosity.
fn plain_ring_with(fragment: &str) -> toml::Table {
    let text = std::fs::read_to_string(path("01_plain_ring")).expect("scene 01");
    let mut scene: toml::Table = text.parse().expect("scene 01 is TOML");
    let fragment: toml::Table = fragment.parse().unwrap_or_else(|error| panic!("{error}:\n{fragment}"));
    if let Some(journal) = table_of(&mut scene, "journal")
        && fragment.contains_key("load")
    {
        journal.retain(|key, _| key == "speed");
    }
    let is_law = |oil: &toml::Table| {
        ["grade", "walther", "vogel", "exponential", "table"].iter().any(|law| oil.contains_key(*law))
    };
    if let (Some(own), Some(oil)) = (table_of(&mut scene, "oil"), fragment.get("oil").and_then(toml::Value::as_table))
        && is_law(oil)
    {
        own.remove("viscosity");
    }
    for (name, value) in fragment {
        match (scene.get_mut(&name).and_then(toml::Value::as_table_mut), value) {
            (Some(table), toml::Value::Table(keys)) => table.extend(keys),
            (_, value) => drop(scene.insert(name, value)),
        }
    }
    scene
}

fn parse(scene: &toml::Table) -> Result<Scene, SceneError> {
    oilwedge_study::parse(&scene.to_string(), Path::new("scenes/example.toml"))
}

/// The scene that a fragment makes of scene 01.
pub(crate) fn parse_fragment(fragment: &str) -> Result<Scene, SceneError> {
    parse(&plain_ring_with(fragment))
}

/// Each table of the catalogue has a section, and each key its row or, where it has no table of its own, its place in
/// the text.
#[test]
fn every_key_of_a_scene_is_explained() {
    let page = page("scene.md");
    for key in keys() {
        let (table, name) = key.path.split_once('.').unwrap_or(("", key.path));
        let spellings = match table {
            "" => vec![format!("\n## `[{name}]`"), format!("\n## `[[{name}]]`"), format!("\n{name} = ")],
            // An axis is explained by examples.
            "sweep" => continue,
            _ => vec![format!("\n| `{name}` | ")],
        };
        assert!(spellings.iter().any(|it| page.contains(it)), "{}", key.path);
    }
}

#[test]
fn every_unit_is_listed() {
    let page = page("scene.md");
    for dimension in Dimension::all() {
        let row = format!(
            "| {} | `{}` |",
            dimension.name().trim_start_matches("an ").trim_start_matches("a "),
            dimension.unit_names()
        );
        assert!(page.contains(&row), "{row}");
    }
}

/// The page on error estimation and the code have the same rules.
#[test]
fn the_rules_of_error_bars_are_those_of_the_code() {
    let read = |path: &str| std::fs::read_to_string(repository().join(path)).expect(path);
    let page = read("docs/theory/error_estimation.md");
    let code = read("crates/reynolds/src/error_bar/mod.rs");
    let rules: Vec<&str> = (code.lines())
        .filter_map(|line| line.strip_prefix("//! "))
        .filter(|line| line.starts_with("bar of J("))
        .collect();
    assert_eq!(rules.len(), 3);
    for rule in rules {
        assert!(page.contains(&format!("\n{rule}\n")), "{rule}");
    }
    let unsure = code.split("const PER_UNSURE: f64 = ").nth(1).and_then(|rest| rest.split(';').next());
    let unsure: f64 = unsure.and_then(|number| number.parse().ok()).expect("a factor");
    assert!(page.contains(&format!("+ {unsure} (what is booked by chance)")), "{unsure}");
}

/// The result of a shipped scene as its reader meets it.
fn result(name: &str) -> Value {
    result_of(&oilwedge_study::read(&path(name)).unwrap_or_else(|error| panic!("{error}")))
}

fn result_of(scene: &Scene) -> Value {
    let run = run(scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    serde_json::from_str(&oilwedge_report::json(&run.result).expect("finite numbers")).expect("JSON")
}

/// The page of loads has each key of `load.json`.
#[test]
fn every_key_of_a_load_is_explained() {
    let page = page("load.md");
    let scene = oilwedge_study::read(&path("loads/crank_big_end")).unwrap_or_else(|error| panic!("{error}"));
    let cycle = duty_cycle(&scene).unwrap_or_else(|error| panic!("{error}"));
    let sheet = LoadSheet::of(&scene, &cycle.expect("a load over a cycle"));
    let sheet: Value = serde_json::from_str(&oilwedge_report::json(&sheet).expect("finite numbers")).expect("JSON");
    let keys = |value: &Value| -> Vec<String> { value.as_object().expect("an object").keys().cloned().collect() };
    for key in [keys(&sheet), keys(&sheet["peak"]), keys(&sheet["rows"][0])].concat() {
        assert!(page.contains(&format!("`{key}`")), "{key}");
    }
}

#[test]
fn the_result_shown_is_that_of_scene_02() {
    let examples = blocks(&Page::read("docs/reference/result.md")).into_iter();
    let example = examples.filter(|block| block.language == "json").map(|block| block.text);
    let [example] = &example.collect::<Vec<_>>()[..] else { panic!("one example") };
    let example: Value = serde_json::from_str(example).expect("the example is JSON");
    let result = result("02_flexpde_shell");
    let keys = |value: &Value| -> Vec<String> {
        let keys = value.as_object().expect("an object").keys();
        keys.cloned().collect()
    };
    assert_eq!(keys(&example), keys(&result));
    for key in ["timing_s", "counts", "balances"] {
        assert_eq!(keys(&example[key]), keys(&result[key]), "{key}");
    }
    for key in ["title", "version", "scene_sha256", "mesh_sha256", "status", "reason", "counts"] {
        assert_eq!(example[key], result[key], "{key}");
    }
    assert_eq!(example["effects"]["simulated"], result["effects"]["simulated"]);
    let numbers = [("mesh", "cells"), ("mesh", "nodes"), ("mesh", "order"), ("mesh", "min_angle_deg")];
    let pairs = numbers.map(|(table, key)| (&example[table][key], &result[table][key]));
    let shown = example["quantities"].as_object().expect("quantities");
    let shown = shown.iter().map(|(name, it)| (&it["value"], &result["quantities"][name]["value"]));
    for (shown, found) in pairs.into_iter().chain(shown) {
        let [shown, found] = [shown, found].map(|value| value.as_f64().expect("a number"));
        assert!((shown / found - 1.0).abs() < 1e-6, "{shown} {found}");
    }
}

#[test]
fn the_page_of_the_scene_is_that_of_the_catalogue_of_keys() {
    let page = page("scene.md");
    assert_eq!(scene_page::page(&page), page, "run validation");
}

#[test]
fn the_page_of_quantities_is_that_of_the_catalogue() {
    let page = page("quantities.md");
    assert_eq!(quantities_page::page(&page), page, "run validation");
}

#[test]
fn every_quantity_is_explained() {
    let page = page("quantities.md");
    let with_model = |model: &str| {
        result_of(&variant("10_drawn_liner", |scene| {
            table(scene, "cavitation").insert("model".into(), model.into());
        }))
    };
    let results = [
        result("02_flexpde_shell"),
        result("07_grooved_liner"),
        result("19_connecting_rod_cap"),
        result_of(&variant("20_heat_balance", |scene| {
            scene.insert("mesh".into(), toml::toml! { size = "5 mm" }.into());
            let heat: toml::Table = toml::toml! {
                inlet = "75 C"
                mixing = { ratio = 0.05 }
                housing = { conductance = "2 W/K", ambient = "40 C" }
            };
            scene.insert("heat".into(), heat.into());
        })),
        with_model("reynolds"),
        with_model("jfo"),
    ];
    let has = |index: usize, name: &str| results[index]["quantities"].get(name).is_some();
    assert!(has(4, "cavity_flow") && has(4, "cavity_share") && !has(4, "film_fraction_min"));
    assert!(!has(5, "cavity_flow") && has(5, "cavity_share") && has(5, "film_fraction_min"));
    for result in &results {
        for name in result["quantities"].as_object().expect("quantities").keys() {
            let shown = name.split_once('.').map_or(name.clone(), |(name, _)| format!("{name}.GROUP"));
            assert!(page.contains(&format!("`{shown}`")), "{shown}");
        }
    }
}
