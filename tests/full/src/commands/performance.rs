//! `performance [MAX_UNKNOWNS]`: times the program and writes the tables of `docs/performance.md` anew.
//! `performance bearings`: only the table of bearings under load.
//! `performance gate [PROGRAM]`: do four scenes cost what the page records, or what another program needs for them?
//! `performance record`: counts them, and records that as what they may cost.
//! Build the program first (`cargo build --release`).

use std::path::Path;
use std::process::ExitCode;

use oilwedge_full::performance::bearings;
use oilwedge_full::performance::films::Films;
use oilwedge_full::performance::gate::{counted, judged, record, recorded, scenes};
use oilwedge_full::performance::page::{SIZES, page};
use oilwedge_full::performance::process::{APART, answer};
use oilwedge_full::tables::replace;
use oilwedge_tests::program::repository;

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> std::io::Result<ExitCode> {
    let program = std::env::current_exe()?.with_file_name("oilwedge");
    let path = repository().join("docs/performance.md");
    let written = std::fs::read_to_string(&path)?;
    match arguments.first().map(String::as_str) {
        Some(APART) => answer(&arguments[1..]),
        Some("gate") => {
            let (films, other) = (Films::new(), arguments.get(1).map(Path::new));
            let mut are_open = true;
            for (scene, film) in scenes(&films) {
                let before = match other {
                    Some(other) => counted(other, &film),
                    None => recorded(&written, scene),
                };
                let (Some(before), Some(count)) = (before, counted(&program, &film)) else {
                    eprintln!("the gate needs valgrind, and counts of this compiler or another program");
                    return Ok(ExitCode::from(2));
                };
                let (told, is_open) = judged(scene, &count, &before);
                println!("{told}");
                are_open &= is_open;
            }
            return Ok(if are_open { ExitCode::SUCCESS } else { ExitCode::FAILURE });
        }
        Some("record") => match record(&written, &program)? {
            Some(page) => std::fs::write(&path, page)?,
            None => eprintln!("counts need valgrind"),
        },
        Some("bearings") => {
            let rows = bearings::rows(&Films::new(), &program);
            std::fs::write(&path, replace(&written, "bearings", &rows))?;
        }
        most => {
            let most = most.and_then(|text| text.parse::<f64>().ok());
            let most = most.map_or(SIZES[SIZES.len() - 1], |most| most as usize);
            std::fs::write(&path, page(&written, &program, most))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
