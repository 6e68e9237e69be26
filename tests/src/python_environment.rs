//! The virtual environment of `tests/crosscheck`: scikit-fem, gmsh, pyvista and the Python package of this repository.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::program::{build, repository};

fn run(command: &mut Command) {
    let status = command.status().unwrap_or_else(|error| panic!("{command:?}: {error}"));
    assert!(status.success(), "{command:?} failed");
}

/// The Python of an environment that holds exactly what `requirements` asks for.
fn environment(folder: &Path, requirements: &Path) -> PathBuf {
    let python = folder.join("bin/python");
    let stamp = folder.join("requirements.txt");
    let wanted = std::fs::read_to_string(requirements).expect("requirements");
    if std::fs::read_to_string(&stamp).is_ok_and(|had| had == wanted) {
        return python;
    }
    run(Command::new("python3").args(["-m", "venv", "--clear"]).arg(folder));
    run(Command::new(&python)
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-compile", "-r"])
        .arg(requirements));
    std::fs::write(&stamp, wanted).expect("stamp of the environment");
    python
}

/// Builds the Python package in the profile of this test and installs it.
fn install(python: &Path, target: &Path) {
    let mut pip = Command::new(python);
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"])
        .args(["--no-deps", "--no-build-isolation", "--force-reinstall"])
        .arg(repository().join("crates/python"))
        .env("CARGO_TARGET_DIR", target)
        .env_remove("RUSTC_BOOTSTRAP");
    if cfg!(debug_assertions) {
        pip.env("MATURIN_PEP517_ARGS", "--profile dev");
    }
    // maturin is a program beside pip.
    let programs = python.parent().map(Path::to_path_buf);
    let paths = std::env::var_os("PATH").unwrap_or_default();
    let paths = programs.into_iter().chain(std::env::split_paths(&paths));
    run(pip.env("PATH", std::env::join_paths(paths).expect("folders of programs")));
}

/// The Python of the environment of `tests/crosscheck`, with the Python package in it, made once.
pub fn python() -> PathBuf {
    static PYTHON: OnceLock<PathBuf> = OnceLock::new();
    let make = || {
        let oilwedge = build("oilwedge");
        let target = oilwedge.ancestors().nth(2).expect("target folder");
        let requirements = repository().join("tests/crosscheck/requirements.txt");
        let python = environment(&target.join("crosscheck-venv"), &requirements);
        install(&python, target);
        python
    };
    PYTHON.get_or_init(make).clone()
}

/// The tests of `tests/crosscheck` that are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tier {
    /// Tests without the mark `full`.
    Quick,
    /// Tests with the mark `full`.
    Full,
}

/// Runs the tests of `tests/crosscheck` with pytest.
///
/// # Panics
/// If one fails, or the environment cannot be made.
pub fn crosscheck(tier: Tier) {
    let tests = match tier {
        Tier::Quick => "not full",
        Tier::Full => "full",
    };
    run(Command::new(python())
        .args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--durations=8", "-m", tests])
        .current_dir(repository().join("tests/crosscheck"))
        .env("OILWEDGE_BIN", build("oilwedge"))
        .env("OILWEDGE_CROSSCHECK_DATA", build("crosscheck_data"))
        .env("PYTHONDONTWRITEBYTECODE", "1"));
}
