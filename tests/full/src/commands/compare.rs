//! `compare BEFORE AFTER`: solves all scenes, engines and 60 random bearings with two builds of the program, one after
//! the other, and lists what differs: ends, and numbers that moved by more than a tenth of their bars.
//! `compare BEFORE AFTER --list tilted|elastic|loads|shafts [FROM TO]` does so for a list of random bearings or shafts;
//! it counts how they end, and prints processor times. `--seconds S` is the limit of each solve.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

use oilwedge_full::performance::process::processor_time;
use oilwedge_full::random_shafts;
use oilwedge_full::random_tilted::TiltedBearing;
use oilwedge_tests::program::repository;
use serde_json::Value;

/// Part of a bar by which numbers may move.
const PART_OF_BAR: f64 = 0.1;
/// Relative difference of numbers without a bar that is listed.
const WITHOUT_BAR: f64 = 1e-6;
/// Relative difference that is round-off, whatever the bar.
const ROUND_OFF: f64 = 1e-9;
/// Random bearings of each of three lists that are solved with the scenes.
const OF_EACH_LIST: u64 = 20;
/// Limit of a solve, where none is given [s].
const SECONDS: f64 = 60.0;
/// A run slower than this is counted [s].
const SLOW: f64 = 10.0;

/// How one solve ended.
struct Run {
    status: String,
    reason: String,
    /// Value and bar of each quantity; that of a bearing of a shaft has its number before its name.
    quantities: BTreeMap<String, (f64, Option<f64>)>,
    /// Processor time [s].
    seconds: f64,
}

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> io::Result<()> {
    let after = |flag: &str| arguments.iter().skip_while(|it| *it != flag).nth(1);
    let [before, now] = [0, 1].map(|k| arguments.get(k).map(PathBuf::from).unwrap_or_default());
    let seconds = after("--seconds").and_then(|text| text.parse().ok()).unwrap_or(SECONDS);
    let folder = tempfile::tempdir()?;
    let scenes = match after("--list") {
        None => shipped()?.into_iter().chain(sample(folder.path())?).collect(),
        Some(list) => {
            let mut bounds = arguments.iter().skip_while(|it| *it != "--list").filter_map(|it| it.parse().ok());
            let usual = match list.as_str() {
                "loads" => 200,
                "shafts" => 50,
                _ => 300,
            };
            let (from, to) = (bounds.next().unwrap_or(0), bounds.next().unwrap_or(usual));
            listed(list, from..to, folder.path())?
        }
    };
    let programs = [before, now];
    let mut runs: [Vec<Run>; 2] = [Vec::new(), Vec::new()];
    for scene in &scenes {
        for (program, runs) in programs.iter().zip(&mut runs) {
            runs.push(solved(program, scene, seconds, folder.path())?);
        }
        if let [Some(before), Some(now)] = [runs[0].last(), runs[1].last()] {
            println!("{}: {}", name(scene), differences(before, now));
        }
    }
    for (runs, what) in runs.iter().zip(["before", "after"]) {
        println!("{what}: {}", counted(runs));
    }
    Ok(())
}

/// All shipped scenes and engines.
fn shipped() -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for folder in ["scenes", "scenes/engines"] {
        for entry in fs::read_dir(repository().join(folder))? {
            let path = entry?.path();
            if path.extension().is_some_and(|ending| ending == "toml") {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// Every fifteenth or tenth bearing of three lists.
fn sample(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let of = |list: &str, step: usize| {
        let numbers = (0..OF_EACH_LIST).map(|k| k * step as u64);
        let written = numbers.map(|number| listed(list, number..number + 1, folder));
        written.collect::<io::Result<Vec<_>>>()
    };
    Ok([of("tilted", 15)?, of("elastic", 15)?, of("loads", 10)?].into_iter().flatten().flatten().collect())
}

/// The scenes of a list, written into a folder.
fn listed(list: &str, numbers: std::ops::Range<u64>, folder: &Path) -> io::Result<Vec<PathBuf>> {
    let bearing = random_shafts::bearing(folder);
    let text = |number: u64| match list {
        "tilted" => Ok(TiltedBearing::new(number).text),
        "elastic" => Ok(TiltedBearing::with_walls(number).text),
        "loads" => Ok(TiltedBearing::under_load(number).text),
        "shafts" => Ok(random_shafts::scene(number, &bearing)),
        _ => Err(io::Error::other(format!("{list}: no list; tilted, elastic, loads, shafts are"))),
    };
    let written = numbers.map(|number| {
        let path = folder.join(format!("{list}_{number}.toml"));
        fs::write(&path, text(number)?)?;
        Ok(path)
    });
    written.collect()
}

fn name(scene: &Path) -> String {
    scene.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

/// How a scene ends by a program.
fn solved(program: &Path, scene: &Path, seconds: f64, folder: &Path) -> io::Result<Run> {
    let out = folder.join("out");
    let mut solve = Command::new(program);
    solve.arg("solve").arg(scene).arg("--out").arg(&out).args(["--max-seconds", &seconds.to_string()]);
    let seconds = processor_time(solve)?;
    let written = fs::read_to_string(out.join("result.json")).unwrap_or_default();
    fs::remove_dir_all(&out).unwrap_or_default();
    let result: Value = serde_json::from_str(&written).unwrap_or_default();
    let mut quantities = BTreeMap::new();
    keep(&mut quantities, "", &result["quantities"]);
    for (k, bearing) in result["bearings"].as_array().into_iter().flatten().enumerate() {
        keep(&mut quantities, &format!("{k}."), &bearing["quantities"]);
    }
    let text = |key: &str| result[key].as_str().unwrap_or("no result").to_owned();
    Ok(Run {
        status: text("status"),
        reason: result["reason"].as_str().unwrap_or_default().to_owned(),
        quantities,
        seconds,
    })
}

/// Keeps value and bar of each quantity.
fn keep(quantities: &mut BTreeMap<String, (f64, Option<f64>)>, before: &str, written: &Value) {
    for (name, quantity) in written.as_object().into_iter().flatten() {
        if let Some(value) = quantity["value"].as_f64() {
            quantities.insert(format!("{before}{name}"), (value, quantity["error"].as_f64()));
        }
    }
}

/// What differs between two runs, in one line.
fn differences(before: &Run, now: &Run) -> String {
    let mut told = format!("{:.2} -> {:.2} s", before.seconds, now.seconds);
    if before.status != now.status {
        told += &format!("; {} {} -> {} {}", before.status, before.reason, now.status, now.reason);
    } else if now.status != "converged" {
        told += &format!("; {}", now.status);
    }
    let mut moved: Vec<(f64, String)> = Vec::new();
    for (name, (value, bar)) in &before.quantities {
        let Some((other, _)) = now.quantities.get(name) else {
            moved.push((f64::INFINITY, format!("{name} is gone")));
            continue;
        };
        let (by, allowed, of) = match bar {
            Some(bar) if *bar > 0.0 => ((other - value).abs() / bar, PART_OF_BAR, "bars"),
            _ => ((other - value).abs() / value.abs().max(f64::MIN_POSITIVE), WITHOUT_BAR, "of it"),
        };
        if by > allowed && (other - value).abs() > ROUND_OFF * value.abs() {
            moved.push((by / allowed, format!("{name} by {by:.2e} {of}")));
        }
    }
    moved.sort_by(|a, b| b.0.total_cmp(&a.0));
    if !moved.is_empty() {
        let worst: Vec<&str> = moved.iter().take(3).map(|(_, text)| text.as_str()).collect();
        told += &format!("; {} of {} numbers moved: {}", moved.len(), before.quantities.len(), worst.join(", "));
    }
    told
}

/// How many runs ended how, and their times.
fn counted(runs: &[Run]) -> String {
    let count = |status: &str| runs.iter().filter(|run| run.status == status).count();
    let mut seconds: Vec<f64> = runs.iter().map(|run| run.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let median = seconds.get(seconds.len() / 2).copied().unwrap_or_default();
    let slow = seconds.iter().filter(|it| **it > SLOW).count();
    format!(
        "{} converged, {} without a solution, {} not converged; {:.1} s in all, half below {median:.2} s, {slow} above {SLOW} s",
        count("converged"),
        count("no_solution"),
        count("not_converged"),
        seconds.iter().sum::<f64>()
    )
}
