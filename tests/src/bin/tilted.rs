//! `tilted [FROM] [TO]`: solves random bearings whose journal tilts, and prints each that has not converged, with its reason and time, and the slowest;
//! `tilted --scene N` prints the scene of one; `tilted --bars [FROM] [TO]` counts how often the bars of moment and tilt hold.

use std::time::Instant;

use oilwedge_study::result::Status;
use oilwedge_tests::coverage::bearings::Bearing;
use oilwedge_tests::coverage::tally::{Of, coverage, quantile, tally};
use oilwedge_tests::random_tilted::{TiltedBearing, solved};

/// Longest time of a run [s].
const LONGEST: f64 = 10.0;

fn main() {
    if let Some(number) = std::env::args()
        .skip_while(|it| it != "--scene")
        .nth(1)
        .and_then(|it| it.parse().ok())
    {
        print!("{}", TiltedBearing::new(number).text);
        return;
    }
    let mut numbers = std::env::args()
        .skip(1)
        .filter_map(|argument| argument.parse::<u64>().ok());
    let (from, to) = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(300));
    if std::env::args().any(|it| it == "--bars") {
        return bars(from, to);
    }
    let (mut converged, mut explained, mut faults, mut slow) = (0, 0, 0, 0);
    let mut longest = (0.0, 0);
    for bearing in (from..to).map(TiltedBearing::new) {
        let clock = Instant::now();
        let (result, fault) = solved(&bearing);
        let seconds = clock.elapsed().as_secs_f64();
        if seconds > longest.0 {
            longest = (seconds, bearing.number);
        }
        let TiltedBearing {
            number, tilting, model, ..
        } = bearing;
        match result.status {
            Status::Converged => converged += usize::from(fault.is_none()),
            _ => {
                explained += usize::from(fault.is_none());
                let reason = result.reason.unwrap_or_default();
                println!(
                    "{number} {tilting:?} {model} {seconds:.1} s {}: {reason}",
                    result.status.name()
                );
            }
        }
        if let Some(fault) = fault {
            faults += 1;
            println!("{number} {tilting:?} {model} {seconds:.1} s FAULT {}", fault.what);
        }
        if seconds > LONGEST {
            slow += 1;
            println!("{number} {tilting:?} {model} {seconds:.1} s SLOW");
        }
    }
    println!(
        "{converged} converged, {explained} without a solution, {faults} faults, {slow} slower than {LONGEST} s; the longest {:.1} s ({})",
        longest.0, longest.1
    );
}

/// Most unknowns of a reference.
const MOST: usize = 12_000;

/// How often the bars of load, moment and tilt hold, and how much wider than the errors they are, by model of cavitation.
fn bars(from: u64, to: u64) {
    let list: Vec<Bearing> = (from..to).map(|number| TiltedBearing::new(number).counted()).collect();
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
