//! The page `docs/validation/prices.md`: predicted prices of the next digit against what it then costs, and how long
//! the shipped scenes take for an answer of 0.1 %.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use oilwedge_campaign::convergence::cost_model::{CostModel, LevelCost};
use oilwedge_campaign::convergence::{Budget, Strategy, StrategyLevels, converge};
use oilwedge_scene::{MeshSource, Scene};

use crate::tables::{replace, row};
use oilwedge_tests::program::repository;

/// The digit whose price is predicted.
const DIGIT: f64 = 10.0;
/// The accuracy of a quick answer.
const QUICK: f64 = 1e-3;
/// Runs of the whole process; the quickest counts.
const RUNS: usize = 5;

/// A price as it was predicted, and as it was.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// The bar from which it was predicted, relative to the value.
    pub from: f64,
    /// Unknowns: predicted, then needed.
    pub unknowns: [f64; 2],
    /// Seconds: predicted, then needed.
    pub seconds: [f64; 2],
}

/// What the levels of a strategy up to each one predict for a bar ten times smaller, where later levels reach it.
pub fn predictions(course: &StrategyLevels) -> Vec<Prediction> {
    let level_cost = |level: &oilwedge_campaign::convergence::LevelReport| {
        Some(LevelCost { unknowns: level.unknowns as f64, seconds: level.seconds.total, error: level.relative_bar? })
    };
    let levels: Vec<LevelCost> = course.levels.iter().filter_map(level_cost).collect();
    let predict = |k: usize| {
        let model = CostModel { strategy: course.strategy, order: course.order, levels: levels[..=k].to_vec() };
        let (from, wanted) = (levels[k], levels[k].error / DIGIT);
        let fine = (k + 1..levels.len()).find(|&j| levels[j].error <= wanted)?;
        let (coarse, fine) = (levels[fine - 1], levels[fine]);
        let part = (coarse.error / wanted).ln() / (coarse.error / fine.error).ln();
        let between = |a: f64, b: f64| a * (b / a).powf(part);
        let growth = DIGIT.powf(1.0 / model.order());
        Some(Prediction {
            from: from.error,
            unknowns: [from.unknowns * growth, between(coarse.unknowns, fine.unknowns)],
            seconds: [from.seconds * growth.powf(model.exponent()), between(coarse.seconds, fine.seconds)],
        })
    };
    (0..levels.len()).filter_map(predict).collect()
}

/// Names of the shipped scenes without the sweeps.
fn scenes() -> Vec<String> {
    let entries = std::fs::read_dir(repository().join("scenes")).expect("scenes");
    let files = entries.filter_map(|entry| Some(entry.ok()?.file_name().to_str()?.to_owned()));
    let names = files.filter_map(|file| Some(file.strip_suffix(".toml")?.to_owned()));
    let mut names: Vec<String> = names.filter(|name| !name.contains("_sweep_")).collect();
    names.sort();
    names
}

/// The page `written` with its tables made anew; `seconds` for the study of each scene.
///
/// # Panics
/// If a shipped scene cannot be read or solved.
pub fn page(written: &str, program: &Path, seconds: f64) -> String {
    let mut prices =
        vec![row(["scene", "bar", "unknowns predicted", "needed", "ratio", "seconds predicted", "needed", "ratio"])];
    let mut quick = vec![row(["scene", "status", "unknowns", "meshes", "whole process [ms]"])];
    for name in scenes() {
        eprintln!("{name}");
        let path = oilwedge_tests::scenes::path(&name);
        let scene = oilwedge_study::read(&path).expect("shipped scene");
        // An orbit has steps in time, and no study of meshes.
        if scene.orbit.is_some() {
            continue;
        }
        let study = converge(&scene, &Budget::seconds(seconds), &mut ()).expect("shipped scene");
        let adaptive = study.report.strategies.iter().find(|course| course.strategy == Strategy::P2Adaptive);
        // The last that can be judged: from where a user would ask.
        if let Some(last) = adaptive.and_then(|course| predictions(course).last().copied()) {
            let [n, m] = last.unknowns;
            let [s, t] = last.seconds;
            prices.push(vec![
                name.clone(),
                format!("{:.1e}", last.from),
                format!("{n:.0}"),
                format!("{m:.0}"),
                format!("{:.2}", n / m),
                format!("{s:.2}"),
                format!("{t:.2}"),
                format!("{:.2}", s / t),
            ]);
        }
        quick.push(quick_answer(&name, &scene, program));
    }
    let written = replace(written, "prices", &prices);
    replace(&written, "quick answers", &quick)
}

/// The whole process for 0.1 %, on a mesh of the program where the scene's can be drawn.
fn quick_answer(name: &str, scene: &Scene, program: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(oilwedge_tests::scenes::path(name)).expect("shipped scene");
    let mut table: toml::Table = text.parse().expect("shipped scene is TOML");
    let mesh = oilwedge_tests::scenes::table(&mut table, "mesh");
    mesh.remove("size");
    if let MeshSource::File { path, .. } = &scene.mesh {
        mesh.insert("file".into(), path.display().to_string().into());
    }
    mesh.insert("tolerance".into(), format!("{} %", 100.0 * QUICK).into());
    let folder = std::env::temp_dir().join(format!("oilwedge-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join(format!("{name}.toml"));
    std::fs::write(&path, table.to_string()).expect("a scene");
    let mut best = f64::INFINITY;
    let mut told = serde_json::Value::Null;
    for _ in 0..RUNS {
        let clock = Instant::now();
        let output = Command::new(program)
            .args(["solve", "--json", "--out"])
            .arg(folder.join("out"))
            .arg(&path)
            .output()
            .expect("the program runs");
        best = best.min(clock.elapsed().as_secs_f64());
        told = serde_json::from_slice(&output.stdout).expect("a result");
    }
    std::fs::remove_dir_all(&folder).expect("the folder is ours");
    let levels = told["levels"].as_array().map_or(0, Vec::len);
    vec![
        name.to_owned(),
        told["status"].as_str().unwrap_or("none").to_owned(),
        told["levels"][levels.saturating_sub(1)]["unknowns"].to_string(),
        levels.to_string(),
        format!("{:.0}", 1e3 * best),
    ]
}
