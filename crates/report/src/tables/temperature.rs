//! The balance of heat for people: two curves as a table, and the design criteria.

use super::pieces::table;
use super::quantities::quantities;
use super::shown::Shown;
use crate::digits::significant;
use crate::plot::TEMPERATURE_FILES;
use oilwedge_study::quantities::{ECCENTRICITY, Quantity, TEMPERATURE_EFFECTIVE, Table};
use oilwedge_study::result::{Balances, Criterion, RunResult, TemperatureReport};

/// Criteria and, where all is shown and the film is one, temperatures, heats and curves; nothing where no temperature was sought.
pub(crate) fn balance(result: &RunResult, shown: Shown) -> Option<String> {
    let report = result.temperature.as_ref()?;
    // Over a cycle there is no curve.
    if shown == Shown::Headlines || report.curve.is_empty() {
        return Some(format!("design criteria\n{}", criteria(report)));
    }
    let is_shown =
        |quantity: &&Quantity| quantity.row.table == Table::Temperature || quantity.row == &TEMPERATURE_EFFECTIVE;
    let list = quantities(result.quantities.iter().filter(is_shown), result.bars);
    let parts = [format!("balance of heat\n{list}"), curve(report), criteria(report)];
    Some(parts.join("\n"))
}

/// How far the balance of heat is open, where it is solved for.
pub(crate) fn imbalance(balances: Balances) -> String {
    match balances.thermal {
        0.0 => String::new(),
        open => format!(
            ", friction and heat carried off by {} of the friction",
            significant(open, 2)
        ),
    }
}

/// The files of the curves.
pub(crate) fn files(result: &RunResult) -> &'static [&'static str] {
    match &result.temperature {
        Some(report) if !report.curve.is_empty() => &TEMPERATURE_FILES,
        _ => &[],
    }
}

/// Friction and heat carried off at temperatures around that found.
fn curve(report: &TemperatureReport) -> String {
    let header = [
        "film [C]",
        "mu0 [mPa.s]",
        "friction [W]",
        "carried off [W]",
        ECCENTRICITY.name,
    ];
    let mut rows = table(header, 0..5);
    for point in &report.curve {
        rows.add_row([
            format!("{:.2}", point.temperature),
            significant(1e3 * point.viscosity, 4),
            significant(point.friction_power, 4),
            significant(point.carried + point.given_off, 4),
            significant(point.eccentricity, 4),
        ]);
    }
    rows.to_string()
}

fn criteria(report: &TemperatureReport) -> String {
    let lines = report.criteria.iter().map(|criterion| {
        let verdict = match (criterion.is_met, criterion.decides) {
            (true, _) => "met",
            (false, true) => "NOT met",
            (false, false) => "unusual",
        };
        format!(
            "{verdict:9} {}: {} {}",
            criterion.what,
            value(criterion),
            criterion.unit
        )
    });
    lines.chain([verdict(report)]).collect::<Vec<_>>().join("\n")
}

/// Never without reserve where an assumption is broken.
fn verdict(report: &TemperatureReport) -> String {
    let reserve = match report.broken_assumptions {
        0 => String::new(),
        1 => ", but 1 assumption of the film is broken: see the warnings".to_owned(),
        several => format!(", but {several} assumptions of the film are broken: see the warnings"),
    };
    match report.is_fit {
        true => format!("fit       the bearing meets its design criteria{reserve}"),
        false => "NOT fit   the bearing does not meet its design criteria".to_owned(),
    }
}

fn value(criterion: &Criterion) -> String {
    let value = significant(criterion.value, 4);
    let bound = |bound: f64| {
        significant(bound, 6)
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_owned()
    };
    match (criterion.least, criterion.most) {
        (Some(least), Some(most)) => format!("{value}, usual {} to {}", bound(least), bound(most)),
        (Some(least), None) => format!("{value}, wanted above {}", bound(least)),
        (None, Some(most)) => format!("{value}, wanted below {}", bound(most)),
        (None, None) => value,
    }
}
