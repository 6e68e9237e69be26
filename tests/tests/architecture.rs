//! The layout that `docs/architecture.md` promises: crate arrows, sockets, headings of physics files, file sizes.

use std::path::{Path, PathBuf};

use oilwedge_study::quantities::CATALOGUE;
use oilwedge_tests::house::{EFFECTS, circles, knowing, sources as sources_of_house};
use oilwedge_tests::program::{cargo, repository};
use serde_json::Value;

/// The crates from top to bottom; a crate uses crates below it only.
const TOP_TO_BOTTOM: [&str; 13] = [
    "oilwedge",
    "oilwedge-python",
    "oilwedge-verification",
    "oilwedge-report",
    "oilwedge-drawing",
    "oilwedge-campaign",
    "oilwedge-study",
    "oilwedge-scene",
    "oilwedge-bearing",
    "oilwedge-reynolds",
    "oilwedge-heat",
    "oilwedge-fem",
    "oilwedge-mesh",
];

/// The sockets whose entries are a list, and the contracts between crates. Another one needs a reason in writing.
const PUBLIC_TRAITS: [&str; 15] = [
    "ConservationLaw",
    "PressureViscosity",
    "FilmContribution",
    "Profile",
    "Term",
    "FlowFactor",
    "ContactLaw",
    "WallModel",
    "Estimate",
    "Observer",
    "SearchObserver",
    "OrbitObserver",
    "RunObserver",
    "FilmMap",
    "Heated",
];

/// Longest source file [lines], tests within it included.
const LONGEST: usize = 420;

/// Folders of `crates/reynolds` whose files are physics, but for `mod.rs`.
const PHYSICS: [&str; 5] = ["terms", "film_thickness", "lubricant", "quantities", "analytical"];
/// Physics that has another place.
const PHYSICS_FILES: [&str; 10] = [
    "crates/reynolds/src/cavitation/jfo/mod.rs",
    "crates/bearing/src/cap_bolts.rs",
    "crates/bearing/src/duty_cycle/crank.rs",
    "crates/bearing/src/equilibrium.rs",
    "crates/bearing/src/shaft/beam.rs",
    "crates/bearing/src/shaft/counterweights.rs",
    "crates/bearing/src/shaft/engine.rs",
    "crates/bearing/src/shaft/joined.rs",
    "crates/bearing/src/thermal_balance.rs",
    "crates/bearing/src/warming.rs",
];

#[test]
fn crates_use_only_crates_below_them() {
    let output = cargo()
        .args(["metadata", "--no-deps", "--offline", "--format-version", "1"])
        .current_dir(repository())
        .output()
        .expect("cargo starts");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("cargo metadata is JSON");
    let packages = metadata["packages"].as_array().expect("packages");
    for (level, name) in TOP_TO_BOTTOM.into_iter().enumerate() {
        let package = packages.iter().find(|package| package["name"] == name);
        let package = package.unwrap_or_else(|| panic!("there is no crate {name}"));
        let used: Vec<&str> = package["dependencies"]
            .as_array()
            .expect("dependencies")
            .iter()
            .filter_map(|dependency| dependency["name"].as_str())
            .filter(|used| used.starts_with("oilwedge"))
            .collect();
        let below = &TOP_TO_BOTTOM[level + 1..];
        assert!(used.iter().all(|used| below.contains(used)), "{name} uses {used:?}");
    }
    let drawing = packages.iter().find(|package| package["name"] == "oilwedge-drawing");
    let drawing = drawing.and_then(|package| package["dependencies"].as_array()).expect("its dependencies");
    let of_house = |used: &&Value| used["name"].as_str().is_some_and(|name| name.starts_with("oilwedge"));
    assert_eq!(drawing.iter().find(of_house), None, "drawing knows no oil");
    let others = packages.iter().filter_map(|package| package["name"].as_str());
    let mut others: Vec<_> = others.filter(|name| !TOP_TO_BOTTOM.contains(name)).collect();
    others.sort_unstable();
    assert_eq!(
        others,
        ["oilwedge-full", "oilwedge-tests"],
        "a new crate needs its place here and in docs/architecture.md"
    );
}

#[test]
fn public_traits_are_those_of_the_sockets() {
    let mut found = Vec::new();
    for path in sources() {
        for line in text(&path).lines().map(str::trim_start) {
            let Some(rest) = line.strip_prefix("pub trait ") else {
                continue;
            };
            let name: String = rest.chars().take_while(|letter| letter.is_alphanumeric()).collect();
            assert!(PUBLIC_TRAITS.contains(&name.as_str()), "{}: pub trait {name}", path.display());
            found.push(name);
        }
    }
    found.sort_unstable();
    let mut named = PUBLIC_TRAITS;
    named.sort_unstable();
    assert_eq!(found, named, "a trait that does not exist");
}

/// Comments name files of the repository by paths that exist.
#[test]
fn paths_in_comments_exist() {
    for path in sources() {
        let text = text(&path);
        for word in text.lines().filter(|line| line.trim_start().starts_with("//")).flat_map(|line| line.split('`')) {
            let top = word.split_once('/').map_or("", |(top, _)| top);
            if ["crates", "docs", "tests", "scenes", "meshes"].contains(&top) && !word.contains([' ', '*']) {
                let named = repository().join(word.trim_end_matches(".rs"));
                let exists = repository().join(word).exists() || named.with_extension("rs").exists();
                assert!(exists, "{} names {word}, which does not exist", path.display());
            }
        }
    }
}

#[test]
fn physics_files_open_with_their_headings() {
    let mut seen = 0;
    for path in sources() {
        let folder = path.parent().and_then(Path::file_name).and_then(|name| name.to_str());
        let in_reynolds = path.starts_with(repository().join("crates/reynolds"));
        let is_physics = folder.is_some_and(|folder| PHYSICS.contains(&folder)) && !path.ends_with("mod.rs");
        let is_listed = PHYSICS_FILES.iter().any(|file| path == repository().join(file));
        if !(in_reynolds && is_physics || is_listed) {
            continue;
        }
        seen += 1;
        let text = text(&path);
        let opening: String = text.lines().take_while(|line| line.starts_with("//!")).collect();
        assert!(opening.starts_with("//! # "), "{} has no title", path.display());
        let places = ["**Equation.**", "**Source.**", "**Range.**", "**Verified by**"].map(|heading| {
            let place = opening.find(heading);
            place.unwrap_or_else(|| panic!("{} does not say {heading}", path.display()))
        });
        assert!(places.is_sorted(), "{}: the headings have another order", path.display());
    }
    assert!(seen >= 16, "only {seen} physics files were found");
}

/// Crates in which files of one idea import each other in a circle, and the most files in it; `docs/architecture.md`
/// says which.
const LARGEST_CIRCLE: [(&str, usize); 2] = [("mesh", 3), ("fem", 2)];

#[test]
fn effects_are_known_to_few_files() {
    let sources = sources_of_house();
    for (effect, most) in EFFECTS {
        let files = knowing(&sources, effect);
        assert!(files.len() <= most, "{effect} is known to {files:#?}, at most {most} may");
    }
}

/// The catalogue alone spells the name of a quantity; scenes and hard cases have keys that read alike.
#[test]
fn quantities_are_named_in_the_catalogue_only() {
    let mut found = Vec::new();
    for source in sources_of_house() {
        let is_of_scenes = ["scene", "verification"].contains(&source.package.as_str());
        if is_of_scenes || source.path.contains("study/src/quantities/") {
            continue;
        }
        for line in &source.code {
            let quoted = line.split('"').skip(1).step_by(2);
            let named = quoted.filter(|text| CATALOGUE.iter().any(|row| row.name == *text));
            found.extend(named.map(|name| format!("{}: {name}", source.path)));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn imports_make_no_circles_above_the_mesh() {
    let sources = sources_of_house();
    let packages: std::collections::BTreeSet<&str> = sources.iter().map(|source| source.package.as_str()).collect();
    for package in packages {
        let most = LARGEST_CIRCLE.iter().find(|(name, _)| *name == package).map_or(1, |(_, most)| *most);
        for circle in circles(&sources, package) {
            assert!(circle.len() <= most, "{package}: {circle:#?}");
        }
    }
}

/// The type of a line of code, in a function or a macro too; associated types, which a trait asks for, and errors of
/// crates are none.
fn type_name(line: &str) -> Option<&str> {
    let is_nested = line.starts_with(' ');
    let words = line.trim_start();
    let words = words.strip_prefix("pub").map_or(words, |rest| {
        let rest = rest.strip_prefix('(').and_then(|rest| rest.split_once(')')).map_or(rest, |(_, rest)| rest);
        rest.trim_start()
    });
    let kinds = ["struct ", "enum ", "trait ", "type "];
    let mut kinds = kinds.into_iter().filter(|kind| !is_nested || *kind != "type ");
    let name = kinds.find_map(|kind| words.strip_prefix(kind))?;
    let name = name.split(|letter: char| !letter.is_alphanumeric()).next()?;
    (name != "Error").then_some(name)
}

#[test]
fn names_of_types_stand_in_one_file() {
    let sources = sources_of_house();
    let mut places: std::collections::BTreeMap<&str, Vec<&str>> = std::collections::BTreeMap::new();
    for source in &sources {
        for name in source.code.iter().filter_map(|line| type_name(line)) {
            places.entry(name).or_default().push(&source.path);
        }
    }
    places.retain(|_, paths| paths.len() > 1);
    assert!(places.is_empty(), "{places:#?}");
}

#[test]
fn no_source_file_is_long() {
    for path in sources() {
        let lines = text(&path).lines().count();
        assert!(lines <= LONGEST, "{} has {lines} lines: one file, one idea", path.display());
    }
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a source file")
}

/// All `.rs` files of `crates/*/src`.
fn sources() -> Vec<PathBuf> {
    let crates = std::fs::read_dir(repository().join("crates")).expect("crates");
    let mut folders: Vec<PathBuf> = crates.map(|entry| entry.expect("an entry").path().join("src")).collect();
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                files.push(path);
            }
        }
    }
    assert!(files.len() > 50, "only {} source files were found", files.len());
    files
}
