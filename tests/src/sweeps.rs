//! Small sweeps of scene 08 and what they leave.

pub use serde_json::Value;

pub use crate::bench::{Bench, Told, edited, object};

/// A sweep of scene 08, a small one, with these axes.
pub fn sweep(bench: &Bench, axes: &str, edits: &[(&str, &str)]) {
    let text = edited("08_flexpde_study_size", edits);
    bench.write("scene.toml", format!("{text}\n[sweep]\n{axes}\n"));
}

/// Scene 09 with this key below `[mesh]`.
pub fn drawn(mesh: &str) -> String {
    edited("09_drawn_ring", &[]) + &format!("\n[mesh]\n{mesh}\n")
}

/// Scene 08 under a load, with a film that breaks.
pub const LOADED: [(&str, &str); 2] =
    [("min_film_angle = \"180 deg\"", "[load]\nforce = \"20 kN\"\nangle = \"130 deg\""), ("eccentricity   = 0.6", "")];

/// A film that breaks.
pub const BREAKS: &str = "[cavitation]\nmodel = \"reynolds\"\n";

/// A sweep of a load on that bearing: `count` forces at two speeds.
pub fn loaded(bench: &Bench, count: usize) {
    let axes =
        format!("speed = [\"8 rad/s\", \"10 rad/s\"]\nforce = {{ from = \"5 kN\", to = \"20 kN\", steps = {count} }}");
    let text = edited("08_flexpde_study_size", &LOADED);
    bench.write("scene.toml", format!("{text}\n{BREAKS}\n[sweep]\n{axes}\n"));
}

/// The table in a folder of results.
///
/// # Panics
/// If there is none.
pub fn table(bench: &Bench, folder: &str) -> String {
    std::fs::read_to_string(bench.path().join(folder).join("sweep.csv")).expect("a table")
}

/// The rows of a table without their seconds. No text of these tables has a comma within.
///
/// # Panics
/// If a row has no columns.
pub fn timeless(table: &str) -> Vec<String> {
    let cut = |line: &str| line.rsplit_once(',').map(|(row, _)| row.to_owned());
    table.lines().map(|line| cut(line).expect("columns")).collect()
}

/// The object that a sweep without a complaint printed.
///
/// # Panics
/// If it failed, or complained.
pub fn done(told: &Told) -> Value {
    let others: Vec<&str> = told.stderr.lines().filter(|line| !line.contains(", about ")).collect();
    assert!(told.status == 0 && others.is_empty(), "{}: {}\n{}", told.status, told.stderr, told.stdout);
    object(&told.stdout)
}

/// A quantity of a row.
///
/// # Panics
/// If the row has none of this name.
pub fn value(row: &Value, name: &str) -> f64 {
    let value = row["quantities"][name]["value"].as_f64();
    value.unwrap_or_else(|| panic!("no {name} in {row}"))
}
