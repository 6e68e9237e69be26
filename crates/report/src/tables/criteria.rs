//! What a bearing is judged by, for people: the table of criteria, and the verdict in a sentence.

use crate::criteria::criteria_sheet;
use oilwedge_study::result::{Criterion, Reserve, RunResult, Verdict};

/// The criteria and the verdict in words, never without reserve beside broken assumptions; nothing where the scene sets
/// none and nothing is usual.
pub(crate) fn judged(result: &RunResult) -> Option<String> {
    let broken = result.temperature.as_ref().map_or(0, |report| report.broken_assumptions);
    let mut sheet = criteria_sheet(&result.criteria)?;
    sheet.notes.extend(verdict(&result.criteria, broken));
    Some(sheet.terminal())
}

/// Which tolerance decides each criterion whose limit lies inside the spread.
fn decisive(criteria: &[Criterion]) -> Vec<String> {
    let inside = criteria.iter().filter(|it| it.decides && it.reserve == Some(Reserve::InsideSpread));
    let named = |it: &Criterion| Some(format!("{} decides the {}", it.spread.as_ref()?.most_by, it.what));
    inside.filter_map(named).collect()
}

/// The verdict in a sentence; none where nothing decides.
fn verdict(criteria: &[Criterion], broken: usize) -> Option<String> {
    let decide = || criteria.iter().filter(|criterion| criterion.decides);
    let has = |reserve| decide().any(|criterion| criterion.reserve == Some(reserve));
    let without_bars = match has(Reserve::NoBars) {
        true => ", by values without error bars: none were asked for",
        false => "",
    };
    let reserve = match broken {
        0 => String::new(),
        1 => ", but 1 assumption of the film is broken: see the warnings".to_owned(),
        several => format!(", but {several} assumptions of the film are broken: see the warnings"),
    };
    Some(match Verdict::of(criteria)? {
        Verdict::Pass => format!("fit       the bearing meets its design criteria{without_bars}{reserve}"),
        Verdict::Fail => format!("NOT fit   the bearing does not meet its design criteria{without_bars}"),
        Verdict::Undecided if has(Reserve::InsideBar) => {
            "undecided a limit lies inside an error bar: a finer mesh decides".to_owned()
        }
        Verdict::Undecided if has(Reserve::InsideSpread) => {
            format!("undecided a limit lies inside the spread of the tolerances: {}", decisive(criteria).join(", "))
        }
        Verdict::Undecided => "undecided the error of a number that is judged is not resolved".to_owned(),
    })
}
