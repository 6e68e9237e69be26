//! Tables beside the quantities: balances, assumptions, criteria, meshes, work, and the time.

use oilwedge_campaign::Records;
use oilwedge_study::quantities::FILM_THICKNESS_MIN;
use oilwedge_study::regime::{APART, THIN};
use oilwedge_study::result::{Counts, HistoryStep, LevelFacts, ResultTail, RunResult};

use crate::digits::significant;
use crate::sheet::{Cell, DIGITS, Sheet, count, number, sized, text, without_zeros};

/// The table of the assumptions that the film meets.
pub(super) fn assumptions(result: &RunResult) -> Sheet {
    let Some(regime) = &result.regime else { return Sheet::new("", ["assumption", "here", "valid"], Vec::new()) };
    let least_film = result.quantity(&FILM_THICKNESS_MIN).map(|it| it.value);
    let micrometres = |value: f64| sized(value, 1e-6, "\u{b5}m");
    let below = |limit: f64| format!("below {}", number(limit).text);
    let mut rows = Vec::new();
    let mut add = |what: &str, value: Option<Cell>, limit: String| {
        rows.extend(value.map(|value| vec![text(what), value, text(limit)]));
    };
    add("laminar flow: Reynolds number", Some(number(regime.reynolds_number)), below(regime.taylor_limit));
    add("no inertia: Re c/R", Some(number(regime.inertia)), below(1.0));
    add("thin film: c/R", Some(number(regime.clearance_ratio)), format!("below {THIN}"));
    add("smooth surfaces: least film over roughness", regime.roughness_ratio.map(number), format!("above {APART}"));
    add(
        "rigid surfaces: elastic deflection",
        Some(micrometres(regime.deflection)),
        least_film.map_or(String::new(), |film| {
            format!("small against the least film, {} \u{b5}m", without_zeros(significant(film / 1e-6, DIGITS)))
        }),
    );
    add("viscosity law: pressure exponent alpha p", regime.pressure_exponent.map(number), String::new());
    add(
        "one temperature: rise of the oil that leaves",
        regime.temperature_rise.map(|rise| sized(rise, 1.0, "K")),
        String::new(),
    );
    add("density taken for these", Some(sized(regime.density, 1.0, "kg/m\u{b3}")), String::new());
    Sheet::new("", ["assumption", "here", "valid"], rows)
}

/// The meshes on the way to a tolerance.
pub(super) fn levels(levels: &[LevelFacts]) -> Option<Sheet> {
    let rows = levels.iter().map(|it| vec![count(it.unknowns), count(it.cells), text(it.refinement.name())]);
    Sheet::new("Meshes towards the tolerance", ["unknowns", "triangles", "refinement"], rows.collect()).if_any()
}

/// How often expensive operations were done, and the iteration.
pub(super) fn work(counts: &Counts) -> Sheet {
    let rows = [
        ("bars", Some(counts.bars)),
        ("deflection products", counts.deflection_products),
        ("deflection steps", counts.deflection_steps),
        ("factorisations", Some(counts.factorisations)),
        ("levels", Some(counts.levels)),
        ("linear solves", Some(counts.linear_solves)),
        ("nonlinear iterations", Some(counts.nonlinear_iterations)),
        ("position steps", Some(counts.position_steps)),
        ("temperature steps", Some(counts.temperature_steps)),
    ];
    let rows = rows.into_iter().filter_map(|(what, times)| Some(vec![text(what), count(times?)]));
    Sheet::new("Work", ["operation", "count"], rows.collect())
}

/// Steps of the nonlinear iteration.
pub(super) fn history(steps: &[HistoryStep]) -> Option<Sheet> {
    let rows = steps.iter().map(|it| vec![count(it.step), number(it.residual), count(it.active)]);
    Sheet::new("Nonlinear iteration", ["step", "relative residual", "nodes in the cavity"], rows.collect()).if_any()
}

/// Wall times [ms] of parts, by their names; the only numbers that differ from run to run.
pub(super) fn timings(tail: &ResultTail) -> Sheet {
    let mut parts: Vec<_> = tail.timing_s.iter().collect();
    parts.sort_by_key(|(part, _)| part);
    Sheet::new("", ["part", "ms"], parts.into_iter().map(|(part, it)| timing(part.as_str(), *it)).collect())
}

/// Wall times of a film, also those of meshes and of the films without an effect.
pub(super) fn timings_of_film(result: &RunResult, records: &Records) -> Sheet {
    let mut table = timings(&result.tail);
    let levels = (1..).zip(&result.levels).map(|(number, level)| timing(format!("mesh {number}"), level.seconds));
    let costs = records.cost.iter().flatten().map(|it| timing(format!("without {}", it.effect), it.seconds_without));
    table.rows.extend(levels.chain(costs));
    table
}

fn timing(part: impl Into<String>, seconds: f64) -> Vec<Cell> {
    vec![text(part), sized(seconds, 1e-3, "")]
}
