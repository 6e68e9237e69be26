//! The second, independent answer: scikit-fem solves the same meshes, pyvista reads our fields.
//!
//! Runs `tests/crosscheck` with pytest in a virtual environment of its own under `target/`, made
//! from `requirements.txt` the first time, with the Python package `crates/python` in it, built in the folder of this test. Left out, and named, on machines without Python's venv or the libraries of gmsh and VTK.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use oilwedge_tests::left_out::{is_left_out, missing_for_python};
use oilwedge_tests::program::{build, repository};

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
        .args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"])
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
        .env("CARGO_TARGET_DIR", target);
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
pub(crate) fn crosscheck_python() -> PathBuf {
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

#[test]
fn scikit_fem_and_pyvista_agree() {
    if is_left_out("cross-check by scikit-fem, gmsh and pyvista", &missing_for_python()) {
        return;
    }
    let oilwedge = build("oilwedge");
    let crosscheck_data = build("crosscheck_data");
    let scripts = repository().join("tests/crosscheck");
    run(Command::new(crosscheck_python())
        .args(["-m", "pytest", "-q", "-p", "no:cacheprovider"])
        .current_dir(&scripts)
        .env("OILWEDGE_BIN", oilwedge)
        .env("OILWEDGE_CROSSCHECK_DATA", crosscheck_data)
        .env("PYTHONDONTWRITEBYTECODE", "1"));
}
