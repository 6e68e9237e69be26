//! `accuracy [each] [unknowns]`: measures how often error bars hold, and writes the tables of
//! `docs/validation/accuracy.md` anew.

use std::time::Instant;

use oilwedge_full::coverage::bearings::{Bearing, Family, bearings};
use oilwedge_full::coverage::page::{Numbers, page};
use oilwedge_full::coverage::reference::reference;
use oilwedge_full::coverage::tally::{each, tally};
use oilwedge_full::coverage::tolerances::met;
use oilwedge_tests::program::repository;

/// The list of bearings on which no rule was chosen.
const SEED: u64 = 4;
/// Bearings of a family.
const EACH: u64 = 5;
/// Bearings of a family that are asked for tolerances.
const ASKED: u64 = 2;
/// Most unknowns of a reference.
const MOST: usize = 20_000;

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> std::io::Result<()> {
    let number = |k: usize| arguments.get(k).and_then(|text| text.parse::<u64>().ok());
    let count = number(0).unwrap_or(EACH);
    let most = number(1).map_or(MOST, |most| most as usize);
    let clock = Instant::now();
    let list = bearings(SEED, count);
    let tally = tally(&list, SEED, most, |done, bearing| {
        let seconds = clock.elapsed().as_secs_f64();
        eprintln!("{done}/{} {seconds:.0} s: {} {}", list.len(), bearing.name, bearing.model);
    });
    for reason in &tally.without {
        eprintln!("{reason}");
    }
    let asked: Vec<Bearing> = (bearings(SEED, count.min(ASKED)).into_iter())
        .filter(|bearing| bearing.is_drawn() && !matches!(bearing.family, Family::Loaded | Family::Conserving))
        .collect();
    let met = each(&asked, |bearing| {
        eprintln!("tolerances: {}", bearing.name);
        reference(bearing, most).map_or(Vec::new(), |reference| met(bearing, &reference))
    });
    let numbers = Numbers { tally, met: met.into_iter().flatten().collect(), most };
    let path = repository().join("docs/validation/accuracy.md");
    let written = std::fs::read_to_string(&path)?;
    std::fs::write(&path, page(&written, &numbers))
}
