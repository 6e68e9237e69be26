//! The gate: what the plain scene costs may not grow when effects are added to the program.
//!
//! Counted are instructions (callgrind), for they are the same on a busy machine. They depend on the compiler and on
//! the libraries of the system, so the number recorded in the page holds for those that it names; on another machine
//! two programs are compared.

use std::path::Path;
use std::process::Command;

use oilwedge_tests::program::repository;

/// Part by which the count may differ: that of addresses, of hash seeds and of the length of paths.
pub const NOISE: f64 = 0.01;
/// Column of the page's table that holds the count.
const COUNT: usize = 2;

/// Instructions of the plain scene without error bars, on one thread; none without valgrind.
///
/// # Panics
/// If the program fails.
pub fn instructions(program: &Path) -> Option<f64> {
    let folder = tempfile::TempDir::new().expect("a folder");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["solve", "--bars", "none", "--threads", "1", "--out"])
        .arg(folder.path().join("out"))
        .arg(repository().join("scenes/01_plain_ring.toml"))
        .output()
        .ok()?;
    assert!(output.status.success(), "{} fails", program.display());
    let told = String::from_utf8_lossy(&output.stderr);
    let count = told.lines().find_map(|line| line.split("Collected :").nth(1));
    count.and_then(|count| count.trim().parse().ok())
}

/// The compiler, as it names itself.
pub fn compiler() -> String {
    let output = Command::new("rustc").arg("--version").output();
    output.map_or("unknown".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// The count that the page records.
pub fn recorded(page: &str) -> Option<f64> {
    let table = page.split("<!-- table: gate -->").nth(1)?.split("<!-- end -->").next()?;
    let row = table.lines().rfind(|line| line.starts_with("| 01"))?;
    row.split('|').nth(COUNT)?.trim().parse().ok()
}

/// Compares the program with a count: what to say, and whether the gate is open.
pub fn judged(count: f64, before: f64) -> (String, bool) {
    let change = count / before - 1.0;
    let open = change <= NOISE;
    let verdict = if open { "the gate is open" } else { "the plain scene pays for something" };
    let told = format!("plain scene: {count:.0} instructions, before {before:.0}: {:+.2} %; {verdict}", 100.0 * change);
    (told, open)
}
