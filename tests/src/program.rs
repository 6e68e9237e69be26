//! The program as its user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The root of the repository.
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_path_buf).unwrap_or_default()
}

/// Cargo, as the user calls it: without the variable by which CI lets test programs print times, for it would compile
/// everything again.
pub fn cargo() -> Command {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.env_remove("RUSTC_BOOTSTRAP");
    cargo
}

/// Builds a program of the workspace in the profile of this test and returns its path.
///
/// `cargo test` builds the programs of a package for that package's own tests only.
pub fn build(name: &str) -> PathBuf {
    let mut cargo = cargo();
    // With the features that the whole workspace asks of dependencies, as the tests have them: nothing is compiled
    // twice.
    cargo.args(["build", "--quiet", "--workspace", "--bin", name]);
    if !cfg!(debug_assertions) {
        cargo.arg("--release");
    }
    let status = cargo.current_dir(repository()).status().expect("cargo starts");
    assert!(status.success(), "{name} does not build");
    // This test is target/PROFILE/deps/NAME: the programs are two levels up.
    let own = std::env::current_exe().expect("path of this test");
    own.ancestors().nth(2).expect("target/PROFILE/deps").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

/// The command `oilwedge`, built once a test program.
pub fn oilwedge_command() -> Command {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    Command::new(PROGRAM.get_or_init(|| build("oilwedge")))
}

/// Runs `oilwedge` with `arguments` in `folder`.
pub fn oilwedge(folder: &Path, arguments: &[&str]) -> Output {
    oilwedge_command().args(arguments).current_dir(folder).output().expect("oilwedge starts")
}
