//! `cavitation_iterations`: how many iterations find the cavity, on meshes from 1e3 to 1e6 unknowns.

use oilwedge_full::cavitation_counts::{count, drawn, imported};
use oilwedge_reynolds::Cavitation;
use oilwedge_study::film::Film;

/// Most unknowns of a mass-conserving film: its factors are unsymmetric.
const MOST_CONSERVING: usize = 150_000;

/// Runs the command.
pub(crate) fn run(_: &[String]) {
    println!("| model | mesh | unknowns | levels | iterations | seconds | fallbacks |");
    println!("|---|---|---|---|---|---|---|");
    for unknowns in [1e3, 3e3, 1e4, 3e4, 1e5, 3e5, 1e6] {
        rows("drawn", &drawn(unknowns));
    }
    for times in 0..4 {
        rows("imported", &imported(times));
    }
}

fn rows(mesh: &str, study: &Film) {
    for cavitation in [
        Cavitation::Reynolds { pressure: 0.0 },
        Cavitation::Jfo { pressure: 0.0 },
    ] {
        let conserving = matches!(cavitation, Cavitation::Jfo { .. });
        if conserving && study.system.space().dofs() > MOST_CONSERVING {
            continue;
        }
        let row = count(study, cavitation).0;
        println!(
            "| {} | {mesh} | {} | {} | {} | {:.2} | {} |",
            cavitation.name(),
            row.unknowns,
            row.levels,
            row.iterations,
            row.seconds,
            row.fallbacks
        );
    }
}
