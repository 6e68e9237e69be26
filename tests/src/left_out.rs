//! Parts of the tests that need more than Rust: where a machine lacks it they are left out, and named at the end of
//! `cargo test` by `tests/tests/left_out.rs`, with the line that installs it. With `CI=true` in the environment nothing
//! may be left out.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// System libraries that the Python packages gmsh and VTK load, and the Debian packages that hold them.
const LIBRARIES: [(&str, &str); 7] = [
    ("libGL.so.1", "libgl1"),
    ("libEGL.so.1", "libegl1"),
    ("libXrender.so.1", "libxrender1"),
    ("libGLU.so.1", "libglu1-mesa"),
    ("libXcursor.so.1", "libxcursor1"),
    ("libXft.so.2", "libxft2"),
    ("libXinerama.so.1", "libxinerama1"),
];

/// What is missing, and how to install it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Missing {
    /// Program or library.
    pub what: String,
    /// The Debian package, or a command of several words.
    pub package: String,
}

impl Missing {
    /// `what` from the Debian package `package`, or by that command.
    pub fn new(what: &str, package: &str) -> Self {
        Self { what: what.to_owned(), package: package.to_owned() }
    }
}

fn succeeds(command: &mut Command) -> bool {
    command.output().is_ok_and(|output| output.status.success())
}

fn python(program: &str) -> bool {
    succeeds(Command::new("python3").args(["-c", program]))
}

/// What Python environments need and this machine lacks.
pub fn missing_for_venv() -> Vec<Missing> {
    match (python(""), python("import ensurepip, venv")) {
        (false, _) => vec![Missing::new("python3", "python3")],
        (true, false) => vec![Missing::new("venv of Python", "python3-venv")],
        (true, true) => Vec::new(),
    }
}

/// What Python environments with gmsh and VTK need and this machine lacks.
pub fn missing_for_python() -> Vec<Missing> {
    let mut missing = missing_for_venv();
    // Python itself looks for the libraries.
    let absent = LIBRARIES.iter().filter(|(library, _)| {
        cfg!(target_os = "linux") && python("") && !python(&format!("import ctypes; ctypes.CDLL({library:?})"))
    });
    missing.extend(absent.map(|(library, package)| Missing::new(library, package)));
    missing
}

/// The C++ compiler that libFuzzer is built with, if this machine lacks it.
pub fn missing_for_fuzzing() -> Vec<Missing> {
    let compiler = std::env::var("CXX").unwrap_or_else(|_| "c++".to_owned());
    match succeeds(Command::new(&compiler).arg("--version")) {
        true => Vec::new(),
        false => vec![Missing::new(&format!("the C++ compiler {compiler}"), "g++")],
    }
}

/// What counts instructions, if this machine lacks it.
pub fn missing_for_counting() -> Vec<Missing> {
    match succeeds(Command::new("valgrind").arg("--version")) {
        true => Vec::new(),
        false => vec![Missing::new("valgrind", "valgrind")],
    }
}

/// Where notes are kept until the end of the tests: beside the programs of this profile.
fn folder() -> PathBuf {
    let own = std::env::current_exe().expect("path of this test");
    own.ancestors().nth(2).expect("target/PROFILE").join("left_out")
}

/// Notes that `part` of the tests is left out, and says true, if something is missing.
///
/// # Panics
/// If something is missing under `CI=true`, or the note cannot be written.
pub fn is_left_out(part: &str, missing: &[Missing]) -> bool {
    let is_ci = std::env::var("CI").as_deref() == Ok("true");
    assert!(missing.is_empty() || !is_ci, "CI=true leaves nothing out. {}", note(part, missing));
    is_skipped(part, missing)
}

/// Notes that `part` of the tests is left out, and says true, if something is missing that CI does not install either.
///
/// # Panics
/// If the note cannot be written.
pub fn is_skipped(part: &str, missing: &[Missing]) -> bool {
    let file = folder().join(part);
    if missing.is_empty() {
        // There may be no note of an earlier run.
        let _ = fs::remove_file(file);
        return false;
    }
    fs::create_dir_all(folder()).expect("a folder for notes");
    fs::write(file, note(part, missing)).expect("a note");
    true
}

/// What is missing for a part, and the lines that install it.
fn note(part: &str, missing: &[Missing]) -> String {
    let what: Vec<&str> = missing.iter().map(|missing| missing.what.as_str()).collect();
    let (commands, packages): (Vec<_>, Vec<_>) =
        missing.iter().map(|missing| missing.package.as_str()).partition(|it| it.contains(' '));
    let packages = match packages.is_empty() {
        true => String::new(),
        false => format!("    apt-get install {}\n", packages.join(" ")),
    };
    let commands: String = commands.iter().map(|command| format!("    {command}\n")).collect();
    format!("{part}: this machine lacks {}\n{packages}{commands}", what.join(", "))
}

/// The notes of all parts that were left out.
pub fn notes() -> Vec<String> {
    let entries = fs::read_dir(folder()).into_iter().flatten().flatten();
    let mut notes: Vec<String> = entries.filter_map(|entry| fs::read_to_string(entry.path()).ok()).collect();
    notes.sort();
    notes
}
