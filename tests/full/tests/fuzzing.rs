//! Half a minute of coverage-guided fuzzing from the corpus of the repository. The targets are a workspace of their
//! own, `fuzz/`, which shares the target folder of this test; they are built here with libFuzzer, which needs a C++
//! compiler; without one this is left out, and named.

use std::path::{Path, PathBuf};
use std::process::Command;

use oilwedge_tests::left_out::{is_left_out, missing_for_fuzzing};
use oilwedge_tests::program::repository;

/// Targets and for how long each is run [s].
const TARGETS: [(&str, u32); 4] = [("msh", 9), ("scene", 9), ("liner", 9), ("unit", 3)];
/// No input may take longer [s]. The counters make the programs some times slower, and machines of CI are busy.
const LONGEST: u32 = 180;
/// No target may hold more memory [MB]. What one input may take is bounded by the targets themselves.
const MOST_MEMORY: u32 = 512;

/// A test of this package is built for its own workspace; cargo tells it things that would lead another build astray.
fn in_fuzz(program: &str) -> Command {
    let mut command = Command::new(program);
    // To name the functions of a backtrace takes more memory than a target may have.
    command.current_dir(repository().join("fuzz")).env("RUST_BACKTRACE", "0");
    // Another wrapper of the user would leave out the counters.
    command.env("RUSTC_WRAPPER", repository().join("fuzz/counted"));
    for (name, _) in std::env::vars_os() {
        let cargo =
            name.to_string_lossy().starts_with("CARGO_PKG_") || name == "RUSTFLAGS" || name == "RUSTC_BOOTSTRAP";
        if cargo {
            command.env_remove(name);
        }
    }
    command
}

/// The target folder of this test.
fn target_folder() -> PathBuf {
    let own = std::env::current_exe().expect("path of this test");
    own.ancestors().nth(3).expect("target/PROFILE/deps").to_owned()
}

/// Builds all targets and returns the folder they are in.
fn build() -> PathBuf {
    let mut cargo = in_fuzz(env!("CARGO"));
    cargo.args(["build", "--release", "--locked", "--bins"]).env("CARGO_TARGET_DIR", target_folder());
    let built = cargo.output().expect("cargo starts");
    let told = String::from_utf8_lossy(&built.stderr);
    assert!(built.status.success(), "the targets do not build:\n{told}");
    target_folder().join("release")
}

/// Runs a target; what it says if it ends otherwise than well.
fn fuzz(programs: &Path, target: &str, seconds: u32) -> Option<String> {
    let found = target_folder().join("fuzz/artifacts");
    std::fs::create_dir_all(&found).expect("a folder for what is found");
    let new = tempfile::tempdir().expect("a folder for new inputs");
    // A program takes over the peak of memory of the process that starts it, and libFuzzer counts that. A shell has
    // little.
    let mut command = in_fuzz("sh");
    command
        .args(["-c", "\"$0\" \"$@\"; exit $?"])
        .arg(programs.join(target))
        .arg(format!("-max_total_time={seconds}"))
        .arg(format!("-timeout={LONGEST}"))
        .arg(format!("-rss_limit_mb={MOST_MEMORY}"))
        .arg(format!("-artifact_prefix={}/{target}-", found.display()))
        .arg("-print_final_stats=1");
    let words = format!("{target}.dict");
    if repository().join("fuzz").join(&words).is_file() {
        command.arg(format!("-dict={words}"));
    }
    let output = command.arg(new.path()).arg(format!("corpus/{target}")).output().expect("a target starts");
    let told = String::from_utf8_lossy(&output.stderr);
    assert!(told.contains("inline 8-bit counters"), "{target} has no counters:\n{told}");
    let runs = told.lines().find_map(|line| line.strip_prefix("stat::number_of_executed_units:"));
    println!("{target}: {} executions", runs.unwrap_or("no").trim());
    if output.status.success() {
        return None;
    }
    let last: Vec<&str> = told.lines().rev().take(40).collect();
    let last: Vec<&str> = last.into_iter().rev().collect();
    Some(format!(
        "{target} fails. The input is the file named last below; once more: cd fuzz && cargo run --release --bin {target} FILE\n{}",
        last.join("\n")
    ))
}

#[test]
fn half_a_minute_finds_nothing() {
    if is_left_out("fuzzing", &missing_for_fuzzing()) {
        return;
    }
    let programs = build();
    let failures: Vec<String> =
        TARGETS.iter().filter_map(|&(target, seconds)| fuzz(&programs, target, seconds)).collect();
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}
