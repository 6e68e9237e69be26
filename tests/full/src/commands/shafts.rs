//! `shafts [FROM] [TO]`: random shafts and firing orders: whether each closes or says why not, with its films inside
//! and its balances kept: a line a shaft. `shafts --scene N` prints the scene of one of them.
//! `shafts --rest [FROM] [TO]`: at which crank angles the films of each have no balance under loads that last.

use std::time::Instant;

use oilwedge_full::random_shafts::{bearing, fault, least_film, scene, solved, without_rest};
use oilwedge_study::result::Status;

/// Most time for one shaft [s].
const MOST_SECONDS: f64 = 600.0;
/// Crank angles of a cycle at which a balance at rest is sought.
const ANGLES: u32 = 72;

/// Runs the command.
pub(crate) fn run(arguments: &[String]) {
    let numbers: Vec<u64> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    let bound = |k: usize, usual: u64| numbers.get(k).copied().unwrap_or(usual);
    let folder = tempfile::tempdir().expect("a folder");
    let bearing = bearing(folder.path());
    if arguments.iter().any(|argument| argument == "--scene") {
        print!("{}", scene(bound(0, 0), &bearing));
        return;
    }
    let (from, to) = (bound(0, 0), bound(1, 50));
    if arguments.iter().any(|argument| argument == "--rest") {
        for number in from..to {
            let [none, ended] = without_rest(&scene(number, &bearing), ANGLES);
            println!("{number} no balance at {none:.0?} deg; not found in time at {ended:.0?} deg");
        }
        return;
    }
    let (mut closed, mut faults) = (0, 0);
    for number in from..to {
        let clock = Instant::now();
        let result = solved(&scene(number, &bearing), MOST_SECONDS);
        let told = match result.head.status {
            Status::Converged => {
                closed += 1;
                let (film, off) = (least_film(&result).unwrap_or(f64::NAN), result.balances);
                format!("least film {:.3} um; force {:.0e}, moment {:.0e}", 1e6 * film, off.force, off.moment)
            }
            _ => result.head.reason.clone().unwrap_or_default(),
        };
        let (bearings, seconds) = (result.bearings.len(), clock.elapsed().as_secs_f64());
        println!("{number} {seconds:.1} s, {bearings} bearings, {}: {told}", result.head.status.name());
        if let Some(fault) = fault(&result) {
            faults += 1;
            println!("{number} FAULT {fault}");
        }
    }
    println!("{closed} of {} closed, {faults} faults", to - from);
}
