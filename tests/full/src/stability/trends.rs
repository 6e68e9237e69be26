//! What must hold from case to case of a series of hard cases.

use oilwedge_study::quantities::Quantity;
use oilwedge_verification::CaseVerdict;
use oilwedge_verification::cases::families;
use oilwedge_verification::family::{CaseSeries, Trend, Vary};

/// Values this part of their error bars apart are the same: a trend that has come to its end.
const SAME: f64 = 0.01;

/// Adds to verdicts in the order of the files what does not hold within their series.
///
/// # Panics
/// If a family cannot be read.
pub fn judge_trends(verdicts: &mut [CaseVerdict]) {
    for (name, family) in families().expect("the families") {
        for series in &family.series {
            let is_of = |verdict: &CaseVerdict| verdict.case.family == name && verdict.case.series == series.name;
            let places: Vec<usize> = (0..verdicts.len()).filter(|&place| is_of(&verdicts[place])).collect();
            let answers: Vec<&CaseVerdict> = places.iter().map(|&place| &verdicts[place]).collect();
            for (place, faults) in places.into_iter().zip(across(series, &answers)) {
                verdicts[place].faults.extend(faults);
            }
        }
    }
}

/// What does not hold, case by case. Where values and variants are given, the values of one variant are compared.
fn across(series: &CaseSeries, answers: &[&CaseVerdict]) -> Vec<Vec<String>> {
    let together = match &series.vary {
        Some(Vary::Key { values, .. }) => values.len(),
        Some(Vary::OfLimit { of_limit, .. }) => of_limit.len(),
        None => answers.len(),
    };
    answers.chunks(together.max(1)).flat_map(|answers| compared(series, answers)).collect()
}

fn quantity<'a>(verdict: &'a CaseVerdict, name: &str) -> Option<&'a Quantity> {
    verdict.result.as_ref()?.by_name(name)
}

fn compared(series: &CaseSeries, answers: &[&CaseVerdict]) -> Vec<Vec<String>> {
    let mut faults = vec![Vec::new(); answers.len()];
    for (name, trend) in &series.trend {
        for (place, pair) in answers.windows(2).enumerate() {
            let [Some(before), Some(after)] = [pair[0], pair[1]].map(|answer| quantity(answer, name)) else {
                continue;
            };
            let bars = [before, after].map(|it| it.error().unwrap_or(0.0)).iter().sum::<f64>();
            let (before, after) = (before.value, after.value);
            let holds = match trend {
                Trend::Rises => after > before,
                Trend::Falls => after < before,
            };
            if !holds && (after - before).abs() > SAME * bars {
                faults[place + 1]
                    .push(format!("{name} goes from {before:.6e} to {after:.6e}, but {trend:?} was known"));
            }
        }
    }
    for (name, tolerance) in &series.same {
        let Some(first) = answers.first().and_then(|answer| quantity(answer, name)) else {
            continue;
        };
        let first = first.value;
        for (faults, answer) in faults.iter_mut().zip(answers) {
            match quantity(answer, name).map(|it| it.value) {
                Some(value) if (value - first).abs() <= tolerance * first.abs() => {}
                Some(value) => faults.push(format!(
                    "{name} is {value:.12e}, that of the first case {first:.12e}: they differ by {:.1e}, allowed {tolerance:.0e}",
                    ((value - first) / first).abs()
                )),
                None => faults.push(format!("{name} is not there, but in the first case")),
            }
        }
    }
    faults
}
