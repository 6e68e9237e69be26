//! Shafts on the films of all their bearings.

mod bearings;
mod cycle;
mod random;
mod report;
mod statics;

use std::path::PathBuf;

use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::Row;
use oilwedge_study::shaft::{ShaftRun, run_shaft};
use oilwedge_tests::program::repository;

/// Path of a file in `scenes/engines/`.
fn engines(name: &str) -> PathBuf {
    repository().join("scenes/engines").join(name)
}

/// The text of a shipped scene.
fn text(name: &str) -> String {
    std::fs::read_to_string(engines(name)).expect("a shipped scene")
}

/// A text with one part of it changed.
fn changed(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

/// What a run of a scene finds, without error bars.
fn run(text: &str) -> ShaftRun {
    let options = RunOptions {
        bars: false,
        max_seconds: f64::INFINITY,
        ..RunOptions::default()
    };
    run_with(text, &options)
}

/// What a run of a scene finds.
fn run_with(text: &str, options: &RunOptions) -> ShaftRun {
    let scene = ShaftScene::parse(text, &engines("scene.toml")).unwrap_or_else(|error| panic!("{error}"));
    run_shaft(&scene, options).unwrap_or_else(|error| panic!("{error}"))
}

/// A number of each bearing.
fn numbers(run: &ShaftRun, row: &Row) -> Vec<f64> {
    let number = |bearing: &oilwedge_study::shaft::BearingReport| {
        let quantity = bearing.quantity(row);
        quantity
            .unwrap_or_else(|| panic!("no {} of {}", row.name, bearing.name))
            .value
    };
    run.result.bearings.iter().map(number).collect()
}
