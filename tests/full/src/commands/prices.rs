//! `prices [seconds]`: studies the convergence of each shipped scene for so long, and writes the tables of
//! `docs/validation/prices.md` anew. Build the program first (`cargo build --release`).

use oilwedge_full::prices_page::page;
use oilwedge_tests::program::repository;

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> std::io::Result<()> {
    let seconds = arguments.first().and_then(|text| text.parse().ok()).unwrap_or(20.0);
    let program = std::env::current_exe()?.with_file_name("oilwedge");
    let path = repository().join("docs/validation/prices.md");
    let written = std::fs::read_to_string(&path)?;
    std::fs::write(&path, page(&written, &program, seconds))
}
