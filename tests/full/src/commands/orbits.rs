//! `orbits [FROM] [TO]`: bars of random orbits against references with more unknowns and shorter steps: a line an
//! orbit, and the share that holds. `orbits --any [FROM] [TO]`: orbits of bearings of any kind: whether each closes or
//! says why not, with a journal that stays inside. `orbits --scene N` prints the scene of one of them.

use std::collections::BTreeMap;
use std::time::Instant;

use oilwedge_full::random_orbits::{Bars, Followed, JUDGED, RandomOrbit, fault, ratios};
use oilwedge_study::result::Status;

/// Edges in the circumference of the two meshes of each bearing, and the tolerances in turn.
const EDGES: [f64; 2] = [20.0, 30.0];
const TOLERANCES: [f64; 3] = [1e-2, 1e-3, 1e-4];
/// How orbits of any kind are followed.
const ROUGH: Followed = Followed { edges: 18.0, tolerance: 1e-2 };

/// Runs the command.
pub(crate) fn run(arguments: &[String]) {
    let numbers: Vec<u64> = arguments.iter().filter_map(|argument| argument.parse().ok()).collect();
    let bound = |k: usize, usual: u64| numbers.get(k).copied().unwrap_or(usual);
    let is_asked = |flag: &str| arguments.iter().any(|argument| argument == flag);
    if is_asked("--scene") {
        print!("{}", RandomOrbit::of_any_kind(bound(0, 0)).text(ROUGH));
    } else if is_asked("--any") {
        of_any_kind(bound(0, 0), bound(1, 200));
    } else {
        bars(bound(0, 0), bound(1, 20));
    }
}

fn bars(from: u64, to: u64) {
    let mut held = [Vec::new(), Vec::new()];
    for number in from..to {
        let orbit = RandomOrbit::ordinary(number);
        let tolerance = TOLERANCES[(number % 3) as usize];
        let how = |edges: f64| Followed { edges, tolerance };
        let reference = orbit.solved(how(EDGES[0]).reference(), Bars::Omitted);
        for edges in EDGES {
            let found = orbit.solved(how(edges), Bars::Estimated);
            let parts = ratios(&found, &reference);
            let bar = |k: usize| {
                let quantity = found.quantity(JUDGED[k]);
                quantity.and_then(|it| Some(it.error()? / it.value)).unwrap_or(f64::NAN)
            };
            println!(
                "{number} {edges} {tolerance:.0e} {}: {}",
                found.head.status.name(),
                [0, 1]
                    .map(|k| format!("{} error/bar {:.2?}, bar {:.1e}", JUDGED[k].symbol, parts[k], bar(k)))
                    .join("; ")
            );
            for (list, part) in held.iter_mut().zip(parts) {
                list.push(part);
            }
        }
    }
    for (row, list) in JUDGED.iter().zip(held) {
        let judged: Vec<f64> = list.iter().copied().flatten().collect();
        let inside = judged.iter().filter(|part| **part <= 1.0).count();
        let mut sorted = judged.clone();
        sorted.sort_by(f64::total_cmp);
        println!(
            "{}: {inside} of {} inside, {} without a bar, median error/bar {:.2}, greatest {:.2}",
            row.name,
            judged.len(),
            list.len() - judged.len(),
            sorted.get(sorted.len() / 2).copied().unwrap_or(f64::NAN),
            sorted.last().copied().unwrap_or(f64::NAN)
        );
    }
}

fn of_any_kind(from: u64, to: u64) {
    let (mut counts, mut faults) = (BTreeMap::<String, usize>::new(), 0);
    for number in from..to {
        let clock = Instant::now();
        let result = RandomOrbit::of_any_kind(number).solved(ROUGH, Bars::Omitted);
        let reason = result.head.reason.clone().unwrap_or_default();
        let kind: String = reason.chars().take_while(|letter| !letter.is_ascii_digit()).collect();
        *counts.entry(format!("{} {kind}", result.head.status.name())).or_default() += 1;
        if let Some(fault) = fault(&result) {
            faults += 1;
            println!("{number} FAULT {fault}");
        }
        if result.head.status != Status::Converged {
            println!("{number} {:.1} s {}: {reason}", clock.elapsed().as_secs_f64(), result.head.status.name());
        }
    }
    for (kind, count) in counts {
        println!("{count} {kind}");
    }
    println!("{faults} faults of {}", to - from);
}
