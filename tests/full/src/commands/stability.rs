//! `stability`: solves all hard cases and the map of stability, and writes `docs/validation/stability.md` anew with its
//! pictures; some minutes.

use std::error::Error;

use oilwedge_full::stability::{map, map_picture, page, trends};
use oilwedge_report::plot::to_png;
use oilwedge_tests::program::repository;
use oilwedge_verification::run_suite;

/// Runs the command.
pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let mut done = 0;
    let mut verdicts = run_suite(&[], true, &mut |series| {
        done += series.len();
        eprintln!("{done} cases");
    })?;
    trends::judge_trends(&mut verdicts);
    let maps = map::run_map(&mut |_| ())?;
    let figure = map_picture::cells_figure(&maps);
    let folder = repository().join("docs/validation");
    std::fs::write(folder.join("stability.svg"), figure.to_svg())?;
    std::fs::write(folder.join("stability.png"), to_png(&figure)?)?;
    Ok(std::fs::write(folder.join("stability.md"), page::page(&verdicts, &maps, "stability.png"))?)
}
