//! The page `docs/performance.md`.

use std::path::Path;
use std::process::Command;

use super::bearings;
use super::films::Films;
use super::gate::{compiler, record};
use super::machine::{Machine, busy, processor};
use super::phase_table::{column, exponent, rows};
use super::{figures, peers};
use crate::tables::{replace, row};
use oilwedge_tests::program::repository;

/// Sizes of the tables.
pub const SIZES: [usize; 4] = [1000, 10_000, 100_000, 1_000_000];

/// The page `written` with its tables measured anew, on at most so many unknowns.
///
/// # Panics
/// If a film has no solution.
pub fn page(written: &str, program: &Path, most: usize) -> String {
    let machine = Machine::measured();
    let films = Films::new();
    let sizes: Vec<usize> = SIZES.into_iter().filter(|&size| size <= most).collect();
    let columns = [1, 2].map(|threads| {
        let timed = sizes.iter().map(|&unknowns| {
            eprintln!("paths, {unknowns} unknowns, {threads} threads");
            column(&films, unknowns, threads, &machine)
        });
        timed.collect::<Vec<_>>()
    });
    let [one, two] = &columns;
    let mut page = replace(written, "machine", &facts(&machine));
    page = replace(&page, "one thread", &rows(one, 1));
    page = replace(&page, "two threads", &rows(two, 2));
    let mut growth = vec![row(["threads", "exponent"])];
    for (threads, columns) in [(1, one), (2, two)] {
        if let Some(exponent) = exponent(columns, threads) {
            growth.push(vec![threads.to_string(), format!("{exponent:.2}")]);
        }
    }
    page = replace(&page, "growth", &growth);
    page = replace(&page, "processes", &figures::processes(&films, program, &sizes));
    page = replace(&page, "bearings", &bearings::rows(&films, program));
    page = replace(&page, "figures", &figures::rows(&films, program, &machine, [one, two], most));
    page = replace(&page, "peers", &peers::rows(program, most));
    record(&page, program).expect("counts of functions can be written").unwrap_or(page)
}

fn facts(machine: &Machine) -> Vec<Vec<String>> {
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    let revision = Command::new("git").args(["rev-parse", "--short", "HEAD"]).current_dir(repository()).output();
    let revision = revision.map_or(String::new(), |it| String::from_utf8_lossy(&it.stdout).trim().to_owned());
    vec![
        row([
            "processor",
            "cores",
            "copy, 1 thread",
            "copy, 2 threads",
            "dense product, 1 thread",
            "busy",
            "compiler",
            "revision",
        ]),
        vec![
            processor(),
            cores.to_string(),
            format!("{:.1} GB/s", 1e-9 * machine.bandwidth),
            format!("{:.1} GB/s", 1e-9 * machine.bandwidth_of_two),
            format!("{:.1} Gflop/s", 1e-9 * machine.flops),
            busy(),
            compiler(),
            revision,
        ],
    ]
}
