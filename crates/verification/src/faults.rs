//! What must hold of an answer, whatever the case.

use oilwedge_campaign::Records;
use oilwedge_report::result_json;
use oilwedge_reynolds::Form;
use oilwedge_study::Run;
use oilwedge_study::effects::Socket;
use oilwedge_study::picture::{FieldValues, FilmPicture};
use oilwedge_study::quantities::{CAVITY_SHARE, PRESSURE_MAX, PRESSURE_MIN, Row};
use oilwedge_study::result::RunResult;
use oilwedge_study::warning;

use crate::answer::{CaseAnswer, sockets};
use crate::cases::Case;
use crate::family::Expect;

/// Relative imbalance of oil or force of a solved film; that of a film of rounding errors apart.
const BALANCED: f64 = 1e-5;
/// Part of the greatest pressure by which quadratics waver below the pressure of a cavity.
const WAVER: f64 = 0.02;
/// Part by which film fractions waver at the edges of streaks.
const STREAK: f64 = 0.15;

/// Rounding of the film fraction where there is no oil.
const EMPTY: f64 = 1e-9;

/// What is wrong with the answer to a case by itself; nothing where all is well.
pub(crate) fn faults(case: &Case, answer: &CaseAnswer) -> Vec<String> {
    let mut faults = Vec::new();
    let end = answer.end();
    if end != case.expect {
        let reason = answer.reason().map_or(String::new(), |reason| format!(": {reason}"));
        faults.push(format!("ended {}, not {}{reason}", end.name(), case.expect.name()));
        return faults;
    }
    let warnings = match answer {
        CaseAnswer::Run(run) => run.result.tail.warnings.join("\n"),
        CaseAnswer::Refused(_) => String::new(),
    };
    let said = format!("{}\n{warnings}", answer.reason().unwrap_or_default());
    if let Some(words) = case.says.as_ref().filter(|words| !said.contains(words.as_str())) {
        faults.push(format!("does not say \"{words}\": {said}"));
    }
    match answer {
        CaseAnswer::Refused(_) => {}
        CaseAnswer::Run(run) => match end {
            Expect::Converged => film(case, run, &mut faults),
            _ => unanswered(&run.result, &mut faults),
        },
    }
    faults
}

/// A run without an answer has a reason, and numbers only where they are the best so far.
fn unanswered(result: &RunResult, faults: &mut Vec<String>) {
    if result.head.reason.as_ref().is_none_or(|reason| reason.len() < 20) {
        faults.push("gives no reason".to_owned());
    }
    // A load below round-off is reported before anything is tried.
    let is_zero = |reason: &String| reason.contains("round-off");
    let tried = !result.head.reason.as_ref().is_some_and(is_zero);
    let silent = tried && result.history.is_empty() && result.levels.is_empty();
    if result.head.status == oilwedge_study::result::Status::NotConverged && silent {
        faults.push("is not converged, but shows no history".to_owned());
    }
    if result.head.status == oilwedge_study::result::Status::NoSolution && !result.quantities.is_empty() {
        faults.push("has no solution, but numbers".to_owned());
    }
}

fn film(case: &Case, run: &Run, faults: &mut Vec<String>) {
    let result = &run.result;
    if let Err(error) = result_json(result, &Records::default()) {
        faults.push(error.to_string());
    }
    let is_balance = sockets(&case.scene).is_none_or(|sockets| sockets.form == Form::Conservative);
    if result.balances.mass > BALANCED && is_balance {
        faults.push(format!("oil is out of balance by {:.1e}", result.balances.mass));
    }
    if result.balances.force > BALANCED {
        faults.push(format!("force is out of balance by {:.1e}", result.balances.force));
    }
    bars(result, faults);
    pressures(result, faults);
    if let Some(picture) = &run.picture {
        fractions(picture, case, faults);
    }
}

/// Each number has a bar, or the result says why not.
fn bars(result: &RunResult, faults: &mut Vec<String>) {
    let bare: Vec<&str> =
        (result.quantities.iter()).filter(|quantity| quantity.bar.is_none()).map(|quantity| &*quantity.name).collect();
    let unresolved = [&warning::NO_BAR, &warning::UNRESOLVED];
    let explained = result.tail.warnings.iter().any(|warning| unresolved.contains(&warning.kind));
    if !bare.is_empty() && !explained {
        faults.push(format!("no bar, and no warning: {}", bare.join(", ")));
    }
    for quantity in &result.quantities {
        if quantity.error().is_some_and(|error| error < 0.0) {
            faults.push(format!("the bar of {} is negative", quantity.name));
        }
    }
}

/// No pressure lies below that of a cavity, beyond how quadratics waver.
fn pressures(result: &RunResult, faults: &mut Vec<String>) {
    let value = |row: &Row| result.quantity(row).map(|quantity| quantity.value);
    let (Some(least), Some(greatest)) = (value(&PRESSURE_MIN), value(&PRESSURE_MAX)) else {
        return;
    };
    if least > greatest {
        faults.push(format!("the least pressure {least:.3e} Pa is above the greatest {greatest:.3e} Pa"));
    }
    let has_cavity = result.effects.fill(Socket::Cavitation);
    // Cases give the pressure of a cavity as zero, but where they are about it.
    if has_cavity && least < -WAVER * greatest.abs() && value(&CAVITY_SHARE).is_none() {
        faults.push(format!("the pressure falls to {least:.3e} Pa, below that of the cavity"));
    }
}

/// Film fractions lie between 0 and 1, and are 1 where there is pressure.
fn fractions(picture: &FilmPicture, case: &Case, faults: &mut Vec<String>) {
    let field = |name: &str| picture.at_points(name).map(FieldValues::numbers);
    let (Some(pressure), Some(fraction)) = (field("pressure"), field("film_fraction")) else {
        return;
    };
    let outside = fraction.iter().filter(|theta| **theta < -EMPTY || **theta > 1.0 + STREAK).count();
    if outside > 0 {
        faults.push(format!("{outside} film fractions of {} lie outside 0 to 1", case.name()));
    }
    let least = pressure.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = pressure.iter().copied().fold(0.0, f64::max);
    let both =
        pressure.iter().zip(fraction).filter(|(p, theta)| **p > least + WAVER * greatest && **theta < 1.0 - STREAK);
    let both = both.count();
    if both > 0 {
        faults.push(format!("{both} nodes have pressure and are not full"));
    }
}
