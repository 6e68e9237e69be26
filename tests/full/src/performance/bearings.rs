//! Bearings as engineers ask for them: a crankshaft main bearing that conserves its oil, under load, at a given
//! temperature and at its own.

use std::path::Path;

use super::clock::median_of;
use super::films::{Films, scene};
use super::process::apart;
use crate::tables::row;
use oilwedge_study::{RunOptions, run};

/// Half groove, grade of a multigrade oil, film that conserves its oil.
const MAIN_BEARING: &str = r#"
title = "Main bearing of a crankshaft"
[bearing]
diameter = "60 mm"
length = "25 mm"
clearance = "30 um"
[[feed]]
group = "groove"
groove = { from = "0 deg", to = "180 deg", width = "4 mm" }
pressure = "4 bar"
[journal]
speed = "5000 rpm"
[load]
force = "12 kN"
angle = "270 deg"
[cavitation]
model = "jfo"
pressure = "0 bar"
"#;
/// Oil near the temperature that its heat balance finds.
const GIVEN: &str = "[oil]\ngrade = \"SAE 5W-30\"\ntemperature = \"94 C\"\n";
/// Petrol engine: oil fed at 75 C.
const SOUGHT: &str = "[oil]\ngrade = \"SAE 5W-30\"\n[heat]\npreset = \"petrol\"\n";
/// Runs of each.
const RUNS: usize = 5;
/// Unknowns of the meshes that are not refined.
const UNKNOWNS: usize = 6000;

/// The table: the whole process, output included.
///
/// # Panics
/// If the program fails.
pub fn rows(films: &Films, program: &Path) -> Vec<Vec<String>> {
    let mut rows =
        vec![row(["temperature", "mesh", "error bars", "nodes", "processor, 1 thread [s]", "wall, 2 threads [s]"])];
    for (temperature, oil) in [("given", GIVEN), ("sought", SOUGHT)] {
        let text = format!("{MAIN_BEARING}{oil}");
        let refined = films.written(&format!("bearing_{temperature}"), &text);
        let sized = films.drawn(&format!("bearing_{temperature}_"), &text, UNKNOWNS);
        for (mesh, path, bars) in
            [("by the program", &refined, true), ("given", &sized, true), ("given", &sized, false)]
        {
            eprintln!("bearings: temperature {temperature}, mesh {mesh}");
            let answer = run(&scene(path), &RunOptions::default()).expect("our own scene");
            let [one, two] =
                [1, 2].map(|threads| median_of((0..RUNS).map(|_| apart(program, path, threads, bars).spent).collect()));
            rows.push(vec![
                temperature.to_owned(),
                mesh.to_owned(),
                if bars { "auto" } else { "none" }.to_owned(),
                answer.result.mesh.nodes.to_string(),
                format!("{:.2}", one.cpu),
                format!("{:.2}", two.wall),
            ]);
        }
    }
    rows
}
