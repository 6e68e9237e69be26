//! The drawing of `docs/architecture.md`: the crates with their lines of code, and the arrows of their manifests.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use oilwedge_tests::house::sources;
use oilwedge_tests::program::repository;

/// The drawing in `docs/images`.
pub const DRAWING: &str = "docs/images/crates.svg";
/// Width and height of a crate, and distances between crates [px].
const BOX: [f64; 2] = [128.0, 44.0];
const STEP: [f64; 2] = [168.0, 88.0];
/// Size of a unit of the drawing on paper [mm].
const MILLIMETRES: f64 = 0.3;
/// Lines of code are shown in steps of this many, so that not every commit changes the drawing.
const LINES: usize = 500;

/// The crates that each crate uses, as the manifests in `crates` have it.
///
/// # Panics
/// If a manifest cannot be read.
pub fn arrows() -> BTreeMap<String, BTreeSet<String>> {
    let folders = std::fs::read_dir(repository().join("crates")).expect("the crates").flatten();
    let manifest = |folder: &std::fs::DirEntry| -> toml::Table {
        let text = std::fs::read_to_string(folder.path().join("Cargo.toml")).expect("a manifest");
        toml::from_str(&text).expect("a manifest")
    };
    let used = |manifest: toml::Table| {
        let names = manifest
            .get("dependencies")
            .and_then(toml::Value::as_table)
            .map_or(Vec::new(), |table| table.keys().cloned().collect());
        names.iter().filter_map(|name| name.strip_prefix("oilwedge-").map(str::to_owned)).collect()
    };
    folders.map(|folder| (folder.file_name().to_string_lossy().into_owned(), used(manifest(&folder)))).collect()
}

/// The arrows that no way over other crates implies.
pub fn drawn(arrows: &BTreeMap<String, BTreeSet<String>>) -> Vec<(&str, &str)> {
    let mut list = Vec::new();
    for (from, all) in arrows {
        let is_direct = |to: &&String| !all.iter().any(|over| over != *to && reaches(arrows, over, to));
        list.extend(all.iter().filter(is_direct).map(|to| (from.as_str(), to.as_str())));
    }
    list
}

fn reaches(arrows: &BTreeMap<String, BTreeSet<String>>, from: &str, to: &str) -> bool {
    arrows[from].iter().any(|next| next == to || reaches(arrows, next, to))
}

/// Crates below a crate on the longest way down.
fn depth(arrows: &BTreeMap<String, BTreeSet<String>>, name: &str) -> usize {
    arrows[name].iter().map(|next| 1 + depth(arrows, next)).max().unwrap_or(0)
}

/// The drawing as SVG.
///
/// # Panics
/// If a source or manifest cannot be read.
pub fn drawing() -> String {
    let arrows = arrows();
    let sources = sources();
    let lines = |name: &str| -> usize {
        sources.iter().filter(|source| source.package == name).map(|source| source.lines_of_code()).sum()
    };
    let mut levels: BTreeMap<usize, Vec<&str>> = BTreeMap::new();
    for name in arrows.keys() {
        levels.entry(depth(&arrows, name)).or_default().push(name);
    }
    let highest = levels.keys().max().copied().unwrap_or(0);
    let widest = levels.values().map(Vec::len).max().unwrap_or(0) as f64;
    let [width, height] = [widest * STEP[0], (highest + 1) as f64 * STEP[1]];
    let centre = |name: &str| {
        let level = depth(&arrows, name);
        let row = &levels[&level];
        let place = row.iter().position(|other| *other == name).unwrap_or(0) as f64;
        let x = 0.5 * width + (place - 0.5 * (row.len() as f64 - 1.0)) * STEP[0];
        [x, ((highest - level) as f64 + 0.5) * STEP[1]]
    };
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}mm\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" text-anchor=\"middle\">\n\
         <title>The crates, their lines of code, and what each uses</title>\n\
         <desc>An arrow leads from a crate to one that it uses; those that follow from others are left out.</desc>\n\
         <marker id=\"tip\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"8\" markerHeight=\"8\" orient=\"auto\"><path d=\"M0 0L8 4L0 8z\" fill=\"#667\"/></marker>\n",
        MILLIMETRES * width
    );
    for (from, to) in drawn(&arrows) {
        let ([x, y], [to_x, to_y]) = (centre(from), centre(to));
        let (begin, end) = (y + 0.5 * BOX[1], to_y - 0.5 * BOX[1]);
        // Writing to a String cannot fail.
        let _ = writeln!(
            svg,
            "<path d=\"M{x} {begin}C{x} {} {to_x} {} {to_x} {end}\" fill=\"none\" stroke=\"#667\" marker-end=\"url(#tip)\"/>",
            begin + 0.4 * STEP[1],
            end - 0.4 * STEP[1]
        );
    }
    for name in arrows.keys() {
        let [x, y] = centre(name);
        let thousands = ((lines(name) + LINES / 2) / LINES * LINES) as f64 / 1e3;
        let _ = writeln!(
            svg,
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"6\" fill=\"#eef3f8\" stroke=\"#667\"/>\n\
             <text x=\"{x}\" y=\"{}\" font-size=\"15\">{name}</text><text x=\"{x}\" y=\"{}\" font-size=\"11\" fill=\"#556\">{thousands} k lines</text>",
            x - 0.5 * BOX[0],
            y - 0.5 * BOX[1],
            BOX[0],
            BOX[1],
            y - 2.0,
            y + 14.0
        );
    }
    svg + "</svg>\n"
}
