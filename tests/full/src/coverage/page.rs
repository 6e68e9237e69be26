//! The tables of `docs/validation/accuracy.md`.

use std::time::Instant;

use oilwedge_study::compile::compile;
use oilwedge_study::refinement::answer;
use oilwedge_study::run_options::RunOptions;

use super::bearings::{Bearing, Family, shipped};
use super::reference::{Reference, reference};
use super::tally::{COUNTED, Of, Pair, Tally, coverage, each, quantile};
use super::tolerances::{Met, TOLERANCES};
use crate::tables::{replace, row};

/// Fewest bars worth a row.
const WORTH: usize = 5;

/// Everything the page tells.
pub struct Numbers {
    /// Bars and errors.
    pub tally: Tally,
    /// Answers to tolerances.
    pub met: Vec<Met>,
    /// Most unknowns of a reference.
    pub most: usize,
}

/// The page with its tables computed anew.
pub fn page(page: &str, numbers: &Numbers) -> String {
    let Numbers { tally, met, most } = numbers;
    let page = replace(page, "counts", &counts(tally));
    let page = replace(&page, "reported", &by_quantity(tally, Of::Reported));
    let page = replace(&page, "quadratic", &by_quantity(tally, Of::Quadratic));
    let page = replace(&page, "families", &by_family(tally));
    let page = replace(&page, "effectivity", &effectivity(tally));
    let page = replace(&page, "tolerances", &tolerances(met));
    let page = replace(&page, "met", &each_met(met));
    replace(&page, "scenes", &scenes(*most))
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share)
}

fn short(x: f64) -> String {
    match x {
        x if !x.is_finite() => "-".to_owned(),
        x if x.abs() < 10.0 => format!("{x:.2}"),
        x => format!("{x:.0}"),
    }
}

fn counts(tally: &Tally) -> Vec<Vec<String>> {
    let mut rows = vec![row(["what", "number"])];
    let mut add = |what: &str, number: usize| rows.push(vec![what.to_owned(), number.to_string()]);
    add("solves", tally.solves);
    add("bars compared with a true error", tally.pairs.len());
    add("bars whose error is below what the reference is unsure of", tally.unknown);
    add("values that the mesh does not resolve: no bar", tally.unresolved);
    add("meshes without an answer", tally.without.len());
    rows
}

/// The models in rows, by name.
const MODELS: [(&str, &[&str]); 3] =
    [("`none`, `guembel`", &["none", "guembel"]), ("`reynolds`", &["reynolds"]), ("`jfo`", &["jfo"])];

fn statistics(tally: &Tally, chosen: impl Fn(&Pair) -> bool) -> Option<Vec<String>> {
    let ratios = tally.ratios(chosen);
    (ratios.len() >= WORTH).then(|| {
        vec![
            ratios.len().to_string(),
            percent(coverage(&ratios)),
            short(quantile(&ratios, 0.5)),
            format!("{} - {}", short(quantile(&ratios, 0.1)), short(quantile(&ratios, 0.9))),
            short(ratios[0]),
        ]
    })
}

fn by_quantity(tally: &Tally, of: Of) -> Vec<Vec<String>> {
    let mut rows = vec![row(["quantity", "model", "bars", "hold", "bar/error, median", "10 % - 90 %", "worst"])];
    for quantity in COUNTED {
        for (name, models) in MODELS {
            let chosen = |pair: &Pair| pair.quantity == quantity && pair.of == of && models.contains(&pair.model);
            if let Some(cells) = statistics(tally, chosen) {
                rows.push([vec![format!("`{quantity}`"), name.to_owned()], cells].concat());
            }
        }
    }
    rows
}

fn by_family(tally: &Tally) -> Vec<Vec<String>> {
    let mut rows = vec![row(["bearings", "quantity", "bars", "hold", "bar/error, median", "10 % - 90 %", "worst"])];
    for family in Family::ALL {
        for quantity in &COUNTED[..6] {
            let chosen = |pair: &Pair| pair.quantity == *quantity && pair.of == Of::Reported && pair.family == family;
            if let Some(cells) = statistics(tally, chosen) {
                rows.push([vec![family.name().to_owned(), format!("`{quantity}`")], cells].concat());
            }
        }
    }
    rows
}

fn effectivity(tally: &Tally) -> Vec<Vec<String>> {
    let mut rows = vec![row(["bearings", "solves", "within 0.8 - 1.2", "median", "least", "greatest"])];
    let mut add = |name: &str, chosen: &dyn Fn(Family) -> bool| {
        let mut found: Vec<f64> = (tally.effectivity.iter())
            .filter(|(family, ..)| chosen(*family))
            .map(|(.., effectivity)| *effectivity)
            .collect();
        found.sort_by(f64::total_cmp);
        if let (Some(least), Some(greatest)) = (found.first(), found.last()) {
            let within = found.iter().filter(|x| (0.8..=1.2).contains(*x)).count() as f64 / found.len() as f64;
            rows.push(vec![
                name.to_owned(),
                found.len().to_string(),
                percent(within),
                short(quantile(&found, 0.5)),
                short(*least),
                short(*greatest),
            ]);
        }
    };
    for family in Family::ALL {
        add(family.name(), &|other| other == family);
    }
    add("all", &|_| true);
    rows
}

fn tolerances(met: &[Met]) -> Vec<Vec<String>> {
    let mut rows =
        vec![row(["asked", "answers", "bar met", "true error met", "unknowns over needed, median", "greatest"])];
    for asked in TOLERANCES {
        let here: Vec<&Met> = met.iter().filter(|met| met.asked == asked).collect();
        let claimed: Vec<&&Met> = here.iter().filter(|met| met.claimed).collect();
        let kept = claimed.iter().filter(|met| met.error <= asked).count();
        let mut over: Vec<f64> =
            (claimed.iter()).filter_map(|met| Some(met.unknowns as f64 / met.needed? as f64)).collect();
        over.sort_by(f64::total_cmp);
        rows.push(vec![
            format!("{} %", 100.0 * asked),
            here.len().to_string(),
            claimed.len().to_string(),
            kept.to_string(),
            short(quantile(&over, 0.5)),
            short(over.last().copied().unwrap_or(f64::NAN)),
        ]);
    }
    rows
}

fn each_met(met: &[Met]) -> Vec<Vec<String>> {
    let mut rows =
        vec![row(["bearing", "model", "asked", "bar", "true error", "unknowns", "unknowns needed", "seconds"])];
    rows.extend(met.iter().map(|met| {
        vec![
            met.bearing.clone(),
            format!("`{}`", met.model),
            format!("{} %", 100.0 * met.asked),
            met.bar.map_or("-".to_owned(), |bar| format!("{bar:.1e}")),
            format!("{:.1e}", met.error),
            met.unknowns.to_string(),
            met.needed.map_or("more".to_owned(), |needed| needed.to_string()),
            format!("{:.2}", met.seconds),
        ]
    }));
    rows
}

/// The shipped scenes as they are run by default.
fn scenes(most: usize) -> Vec<Vec<String>> {
    let head = row(["scene", "quantity", "value", "bar", "true error", "unknowns", "seconds"]);
    let found = each(&shipped(), |bearing| shipped_rows(bearing, &reference(bearing, most)));
    std::iter::once(head).chain(found.into_iter().flatten()).collect()
}

fn shipped_rows(bearing: &Bearing, reference: &Result<Reference, String>) -> Vec<Vec<String>> {
    let clock = Instant::now();
    let answer = compile(&bearing.scene(None)).and_then(|model| answer(&model, &RunOptions::default()));
    let Ok(answer) = answer else {
        return Vec::new();
    };
    let (seconds, size) = (clock.elapsed().as_secs_f64(), answer.film.unknowns());
    let (Ok((_, judged)), Ok(reference)) = (answer.outcome, reference) else {
        return Vec::new();
    };
    let asked = match answer.film.load() {
        Some(_) => ["eccentricity", "attitude_angle", "pressure_max", "side_flow"],
        None => ["load", "attitude_angle", "pressure_max", "side_flow"],
    };
    let rows = asked.into_iter().filter_map(|name| {
        let quantity = judged.quantities.iter().find(|quantity| quantity.name == name)?;
        let known = reference.known.iter().find(|known| known.name == name)?;
        let error = quantity.row.difference(quantity.value, known.value).abs();
        Some(vec![
            bearing.name.clone(),
            format!("`{name}` [{}]", quantity.unit()),
            format!("{:.6e}", quantity.value),
            quantity.error().map_or("-".to_owned(), |bar| format!("{bar:.1e}")),
            match error > known.bar {
                true => format!("{error:.1e}"),
                false => format!("< {:.1e}", known.bar),
            },
            size.to_string(),
            format!("{seconds:.2}"),
        ])
    });
    rows.collect()
}
