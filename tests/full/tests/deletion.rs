//! The deletion test: an effect goes away by deleting its files and its rows, and following at most five compile
//! errors.
//!
//! First a toy effect is added to a copy of the tree by the steps of `CONTRIBUTING.md`, solved with, and removed. Then
//! the copy loses the files and the rows of four effects. Their sockets stay, empty, with what computes of any entry:
//! the quadrature of contact and its numbers, the balance of film and wall. The lines at which the compiler then
//! reports errors are deleted too, and counted for the effect that they name, until the program compiles; it must solve
//! the plain scene to the same number.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::toy_effect;
use oilwedge_tests::program::{cargo, oilwedge, repository};
use serde_json::Value;

/// Compile errors that may be left when an effect is deleted.
const MOST_ERRORS: usize = 5;
/// Rounds of compilation: an error in one crate hides those in the crates above it.
const MOST_ROUNDS: usize = 8;
/// What is copied.
const TREE: [&str; 6] = ["Cargo.toml", "Cargo.lock", "crates", "meshes", "scenes", "tests"];
/// Name of the program of the copy: that of the tree stays where it is.
const PROGRAM: &str = "oilwedge-without";

/// An effect as it stands in the tree.
struct Effect {
    name: &'static str,
    /// Files of the effect.
    files: &'static [&'static str],
    /// Rows of the effect: the file of the list, and what the line holds.
    rows: &'static [(&'static str, &'static str)],
}

const EFFECTS: [Effect; 4] = [
    Effect {
        name: "squeeze",
        files: &[
            "crates/reynolds/src/terms/squeeze.rs",
            "crates/scene/src/journal/squeeze.rs",
            "crates/study/src/effects/squeeze.rs",
        ],
        rows: &[
            ("crates/reynolds/src/terms/mod.rs", "mod squeeze;"),
            ("crates/study/src/effects/mod.rs", "mod squeeze;"),
            ("crates/study/src/effects/mod.rs", "&squeeze::"),
            ("crates/study/src/effects/mod.rs", "squeeze::KIND,"),
            ("crates/scene/src/journal.rs", "mod squeeze;"),
            ("crates/scene/src/catalogue.rs", "squeeze::KEYS"),
        ],
    },
    Effect {
        name: "Barus",
        files: &[
            "crates/reynolds/src/lubricant/barus.rs",
            "crates/scene/src/oil/barus.rs",
            "crates/study/src/effects/barus.rs",
        ],
        rows: &[
            ("crates/reynolds/src/lubricant/mod.rs", "mod barus;"),
            ("crates/study/src/effects/mod.rs", "mod barus;"),
            ("crates/study/src/effects/mod.rs", "&barus::"),
            ("crates/scene/src/oil.rs", "mod barus;"),
            ("crates/scene/src/oil.rs", "barus::read"),
            ("crates/scene/src/catalogue.rs", "barus::KEYS"),
        ],
    },
    Effect {
        name: "contact",
        files: &[
            "crates/reynolds/src/contact/greenwood_tripp.rs",
            "crates/reynolds/src/contact/bearing_curve.rs",
            "crates/reynolds/src/analytical/bearing_curve.rs",
            "crates/scene/src/contact.rs",
            "crates/study/src/effects/contact.rs",
        ],
        rows: &[
            ("crates/reynolds/src/contact/mod.rs", "greenwood_tripp"),
            ("crates/reynolds/src/contact/mod.rs", "bearing_curve"),
            ("crates/reynolds/src/analytical/mod.rs", "mod bearing_curve;"),
            ("crates/scene/src/lib.rs", "mod contact;"),
            ("crates/scene/src/lib.rs", "pub use contact::"),
            ("crates/scene/src/catalogue.rs", "contact::KEYS"),
            ("crates/scene/src/scene.rs", "\"contact\","),
            ("crates/scene/src/scene.rs", "contact::check"),
            ("crates/study/src/effects/mod.rs", "mod contact;"),
            ("crates/study/src/effects/mod.rs", "&contact::"),
        ],
    },
    Effect {
        name: "liner",
        files: &[
            "crates/reynolds/src/analytical/elastic_ring.rs",
            "crates/scene/src/compliance_table.rs",
            "crates/scene/src/liner.rs",
            "crates/study/src/effects/elastic_liner.rs",
            "crates/study/src/quantities/liner.rs",
        ],
        rows: &[
            ("crates/reynolds/src/analytical/mod.rs", "mod elastic_ring;"),
            ("crates/scene/src/lib.rs", "mod compliance_table;"),
            ("crates/scene/src/lib.rs", "mod liner;"),
            ("crates/scene/src/lib.rs", "pub use liner::"),
            ("crates/scene/src/catalogue.rs", "liner::KEYS"),
            ("crates/scene/src/scene.rs", "\"liner\","),
            ("crates/scene/src/scene.rs", "liner::check"),
            ("crates/study/src/effects/mod.rs", "mod elastic_liner;"),
            ("crates/study/src/effects/mod.rs", "&elastic_liner::"),
            ("crates/study/src/effects/mod.rs", "elastic_liner::KIND,"),
            ("crates/study/src/quantities/mod.rs", "mod liner;"),
            ("crates/study/src/quantities/mod.rs", "pub use liner::"),
            ("crates/study/src/quantities/mod.rs", "DEFLECTION_MAX,"),
        ],
    },
];

#[test]
fn an_effect_comes_by_steps_and_effects_go_away_with_their_files_and_rows() {
    // Always the same: what is compiled for it stays in the target folder.
    let tree = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("deletion");
    let _ = std::fs::remove_dir_all(tree);
    std::fs::create_dir_all(tree).expect("a folder");
    for entry in TREE {
        copy(&repository().join(entry), &tree.join(entry));
    }
    let manifest = tree.join("crates/cli/Cargo.toml");
    let text = std::fs::read_to_string(&manifest).expect("a manifest")
        + &format!("\n[[bin]]\nname = \"{PROGRAM}\"\npath = \"src/main.rs\"\n");
    std::fs::write(&manifest, text).expect("a manifest");
    let plain = load(&oilwedge(tree, &["solve", "scenes/01_plain_ring.toml", "--json"]).stdout);
    let before = toy_effect::add(tree);
    assert_eq!(errors(tree), BTreeSet::new(), "the steps of CONTRIBUTING.md");
    let loads = toy_effect::scenes().map(|scene| {
        std::fs::write(tree.join("toy.toml"), scene).expect("a scene");
        load_by_copy(tree, "toy.toml")
    });
    assert!(loads[1] < 0.9 * loads[0] && (loads[1] / loads[2] - 1.0).abs() < 1e-9, "{loads:?}");
    assert_eq!(load_by_copy(tree, "scenes/01_plain_ring.toml"), plain);
    toy_effect::remove(tree, &before);
    for effect in &EFFECTS {
        delete(tree, effect);
    }
    mend(tree);
    assert_eq!(load_by_copy(tree, "scenes/01_plain_ring.toml"), plain);
}

/// The load that the program of the copy computes.
fn load_by_copy(tree: &Path, scene: &str) -> f64 {
    let program = own_folder().join(format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX));
    let output = Command::new(program).args(["solve", scene, "--json"]).current_dir(tree).output();
    load(&output.expect("the program starts").stdout)
}

/// The value of the load in a result.
fn load(json: &[u8]) -> f64 {
    let result: Value = serde_json::from_slice(json).unwrap_or_else(|error| panic!("{error}"));
    result["quantities"]["load"]["value"].as_f64().expect("a load")
}

fn copy(from: &Path, to: &Path) {
    if from.is_file() {
        std::fs::copy(from, to).unwrap_or_else(|error| panic!("{}: {error}", from.display()));
        return;
    }
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder").flatten() {
        copy(&entry.path(), &to.join(entry.file_name()));
    }
}

fn delete(tree: &Path, effect: &Effect) {
    for file in effect.files {
        std::fs::remove_file(tree.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
    }
    for (file, row) in effect.rows {
        let path = tree.join(file);
        let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{file}: {error}"));
        let kept: Vec<&str> = text.lines().filter(|line| !line.contains(row)).collect();
        assert!(kept.len() < text.lines().count(), "{file} has no row {row}");
        std::fs::write(&path, kept.join("\n") + "\n").expect("a file");
    }
}

/// Deletes the lines with compile errors until there are none. No effect may have more than [`MOST_ERRORS`].
fn mend(tree: &Path) {
    let mut deleted = EFFECTS.each_ref().map(|effect| (effect.name, Vec::new()));
    for _ in 0..MOST_ROUNDS {
        let errors = errors(tree);
        if errors.is_empty() {
            return;
        }
        // Errors of other lines follow from those of lines that name the effect.
        let (mut others, mut is_mended) = (Vec::new(), false);
        for (file, line) in errors.into_iter().rev() {
            let text = std::fs::read_to_string(&file).expect("a source file");
            let (faulty, place) = (text.lines().nth(line - 1).unwrap_or_default(), file.display());
            let is_named = |(effect, _): &&mut (&str, _)| faulty.to_lowercase().contains(&effect.to_lowercase());
            let Some((_, of_effect)) = deleted.iter_mut().find(is_named) else {
                others.push(format!("{place}: {faulty}"));
                continue;
            };
            of_effect.push(format!("{place}: {faulty}"));
            is_mended = true;
            let mut kept: Vec<&str> = text.lines().collect();
            // The line, and the comment on what it defines.
            let comment = kept[..line - 1].iter().rev().take_while(|line| line.trim_start().starts_with("///"));
            kept.drain(line - 1 - comment.count()..line);
            std::fs::write(&file, kept.join("\n") + "\n").expect("a source file");
        }
        assert!(deleted.iter().all(|(_, lines)| lines.len() <= MOST_ERRORS), "{deleted:#?}");
        assert!(is_mended, "lines that name no effect: {others:#?}");
    }
    panic!("the program does not compile after {MOST_ROUNDS} rounds")
}

/// Files and lines of the errors of the compiler.
fn errors(tree: &Path) -> BTreeSet<(PathBuf, usize)> {
    let output = build(tree).arg("--message-format=json").output().expect("cargo starts");
    let messages = output.stdout.split(|byte| *byte == b'\n');
    let messages = messages.filter_map(|line| serde_json::from_slice::<Value>(line).ok());
    let errors = messages.filter(|message| message["message"]["level"] == "error");
    errors
        .flat_map(|message| message["message"]["spans"].as_array().cloned().unwrap_or_default())
        .filter(|span| span["is_primary"] == true)
        .filter_map(|span| Some((tree.join(span["file_name"].as_str()?), span["line_start"].as_u64()? as usize)))
        .collect()
}

/// Builds the program of the copy with the dependencies of this test's profile; the crates of the copy are not
/// optimised, and in each build what the one before it compiled is kept.
fn build(tree: &Path) -> Command {
    let mut cargo = cargo();
    let profile = if cfg!(debug_assertions) { "dev" } else { "release" };
    cargo.args([
        "build",
        "--quiet",
        "--offline",
        // With the features that the whole workspace asks of dependencies: they are not compiled again.
        "--workspace",
        "--bin",
        PROGRAM,
        "--profile",
        profile,
        "--config",
        &format!("profile.{profile}.incremental=true"),
    ]);
    for package in std::fs::read_dir(tree.join("crates")).expect("crates").flatten() {
        let package = match package.file_name().to_string_lossy().as_ref() {
            "cli" => "oilwedge".to_owned(),
            other => format!("oilwedge-{other}"),
        };
        for setting in ["opt-level=0", "codegen-units=256"] {
            cargo.args(["--config", &format!("profile.{profile}.package.{package}.{setting}")]);
        }
    }
    let target = own_folder();
    cargo.env("CARGO_TARGET_DIR", target.parent().expect("target")).current_dir(tree);
    cargo
}

/// The folder of the programs of this test's profile.
fn own_folder() -> PathBuf {
    let own = std::env::current_exe().expect("path of this test");
    own.ancestors().nth(2).expect("target/PROFILE/deps").to_owned()
}
