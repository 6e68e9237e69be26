//! `tilted [FROM] [TO]`: solves random bearings whose journal tilts, and prints each that has not converged, with its reason and time, and the slowest;
//! `tilted --page` solves 300 and writes `docs/validation/tilted_bearings.md` anew; `tilted --scene N` prints the scene of one;
//! `tilted --walls`, with the same arguments, has rough surfaces that touch, walls that give way, bores out of round, and no page;
//! `tilted --bars [FROM] [TO]` counts how often the bars of moment and tilt hold.

use oilwedge_study::result::Status;
use oilwedge_tests::coverage::bearings::Bearing;
use oilwedge_tests::coverage::tally::{Of, coverage, quantile, tally};
use oilwedge_tests::performance::clock::on_threads;
use oilwedge_tests::program::repository;
use oilwedge_tests::random_tilted::TiltedBearing;
use oilwedge_tests::tilted_page::{LONGEST, Outcome, page};

/// Bearings of the page.
const BEARINGS: u64 = 300;

fn main() -> std::io::Result<()> {
    let has = |flag: &str| std::env::args().any(|it| it == flag);
    let mut numbers = std::env::args()
        .skip(1)
        .filter_map(|argument| argument.parse::<u64>().ok());
    let (first, second) = (numbers.next(), numbers.next());
    let bearing = match has("--walls") {
        true => TiltedBearing::with_walls,
        false => TiltedBearing::new,
    };
    if let Some(number) = first.filter(|_| has("--scene")) {
        print!("{}", bearing(number).text);
        return Ok(());
    }
    let (from, to) = (first.unwrap_or(0), second.unwrap_or(BEARINGS));
    if has("--bars") {
        bars((from..to).map(bearing), from);
        return Ok(());
    }
    // On one thread the time of the processor is that of the bearing.
    let outcomes = on_threads(1, || {
        (from..to).map(|number| solve(bearing(number))).collect::<Vec<_>>()
    });
    let count = |is: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|outcome| is(outcome)).count();
    let longest = outcomes.iter().max_by(|a, b| a.seconds.total_cmp(&b.seconds));
    println!(
        "{} converged, {} without a solution, {} faults, {} slower than {LONGEST} s; the longest {:.1} s ({})",
        count(&|it| it.status == Status::Converged && it.fault.is_none()),
        count(&|it| it.status == Status::NoSolution),
        count(&|it| it.fault.is_some()),
        count(&Outcome::is_slow),
        longest.map_or(0.0, |outcome| outcome.seconds),
        longest.map_or(0, |outcome| outcome.bearing.number),
    );
    if has("--page") && !has("--walls") {
        let path = repository().join("docs/validation/tilted_bearings.md");
        let written = std::fs::read_to_string(&path)?;
        std::fs::write(&path, page(&written, &outcomes))?;
    }
    Ok(())
}

/// Solves a bearing, and prints what is to be said of it.
fn solve(bearing: TiltedBearing) -> Outcome {
    let outcome = Outcome::of(bearing);
    if let Some(told) = outcome.told() {
        println!("{told}");
    }
    outcome
}

/// Most unknowns of a reference.
const MOST: usize = 12_000;

/// How often the bars of load, moment and tilt hold, and how much wider than the errors they are, by model of cavitation.
fn bars(bearings: impl Iterator<Item = TiltedBearing>, from: u64) {
    let list: Vec<Bearing> = bearings.map(|bearing| bearing.counted()).collect();
    let tally = tally(&list, from, MOST, |_, _| {});
    println!(
        "{} solves, {} errors not known, {} numbers without a bar",
        tally.solves, tally.unknown, tally.unresolved
    );
    for without in &tally.without {
        println!("{without}");
    }
    for quantity in ["load", "moment_x", "moment_y", "eccentricity", "tilt_x", "tilt_y"] {
        for model in ["none", "guembel", "reynolds", "jfo", ""] {
            let is_chosen = |of: &str| model.is_empty() || of == model;
            let ratios =
                tally.ratios(|pair| pair.quantity == quantity && pair.of == Of::Reported && is_chosen(pair.model));
            if !ratios.is_empty() {
                let model = if model.is_empty() { "all" } else { model };
                println!(
                    "{quantity:13} {model:9} {:4} bars, {:.1} % hold, least ratio {:.2}, median {:.1}",
                    ratios.len(),
                    100.0 * coverage(&ratios),
                    ratios[0],
                    quantile(&ratios, 0.5)
                );
            }
        }
    }
}
