//! Times of other programs on the same meshes: `tests/crosscheck/compare_speed.py`.

use std::path::Path;
use std::process::Command;

use oilwedge_tests::program::repository;
use oilwedge_tests::python_environment::python;

/// Sizes at which they are compared.
const SIZES: [usize; 2] = [10_000, 100_000];

/// The table that the script prints; where what the script needs is missing, a row that says so.
pub fn rows(program: &Path, most: usize) -> Vec<Vec<String>> {
    let sizes = SIZES.into_iter().filter(|&size| size <= most).map(|size| size.to_string());
    eprintln!("peers");
    let output = Command::new(python())
        .arg("compare_speed.py")
        .args(sizes)
        .current_dir(repository().join("tests/crosscheck"))
        .env("OILWEDGE_BIN", program)
        .output();
    let missing = |reason: String| vec![vec!["not measured".to_owned()], vec![reason]];
    match output {
        Ok(output) if output.status.success() => table(&String::from_utf8_lossy(&output.stdout)),
        Ok(output) => {
            let told = String::from_utf8_lossy(&output.stderr);
            missing(told.lines().last().unwrap_or_default().to_owned())
        }
        Err(error) => missing(format!("python: {error}")),
    }
}

/// The cells of a Markdown table.
fn table(text: &str) -> Vec<Vec<String>> {
    let lines = text.lines().filter(|line| line.starts_with('|') && !line.starts_with("|-"));
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    lines.map(cells).collect()
}
