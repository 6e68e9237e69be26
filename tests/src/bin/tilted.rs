//! `tilted [FROM] [TO]`: solves random bearings whose journal tilts, and prints each that has not converged, with its reason and time, and the slowest;
//! `tilted --scene N` prints the scene of one.

use std::time::Instant;

use oilwedge_study::result::Status;
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
