//! What must hold from case to case of a series.

use crate::answer::Answer;
use crate::family::{Series, Trend, Vary};

/// Values this part of their error bars apart are the same: a trend that has come to its end.
const SAME: f64 = 0.01;

/// What does not hold, case by case. Where values and variants are given, the values of one variant are compared.
pub(crate) fn across(series: &Series, answers: &[Answer]) -> Vec<Vec<String>> {
    let together = match &series.vary {
        Some(Vary::Key { values, .. }) => values.len(),
        Some(Vary::OfLimit { of_limit, .. }) => of_limit.len(),
        None => answers.len(),
    };
    answers.chunks(together.max(1)).flat_map(|answers| compared(series, answers)).collect()
}

fn compared(series: &Series, answers: &[Answer]) -> Vec<Vec<String>> {
    let mut faults = vec![Vec::new(); answers.len()];
    for (name, trend) in &series.trend {
        for (place, pair) in answers.windows(2).enumerate() {
            let [Some(before), Some(after)] = [&pair[0], &pair[1]].map(|answer| answer.value(name)) else {
                continue;
            };
            let holds = match trend {
                Trend::Rises => after > before,
                Trend::Falls => after < before,
            };
            let bars = pair[0].error(name) + pair[1].error(name);
            if !holds && (after - before).abs() > SAME * bars {
                faults[place + 1]
                    .push(format!("{name} goes from {before:.6e} to {after:.6e}, but {trend:?} was known"));
            }
        }
    }
    for (name, tolerance) in &series.same {
        let Some(first) = answers.first().and_then(|answer| answer.value(name)) else {
            continue;
        };
        for (faults, answer) in faults.iter_mut().zip(answers) {
            match answer.value(name) {
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
