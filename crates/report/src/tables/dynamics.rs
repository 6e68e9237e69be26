//! Stiffness and damping for people: small tables of two frames, and the stability of a rigid rotor.

use super::quantities::quantities;
use super::shown::ShownQuantities;
use crate::digits::significant;
use crate::readable::readable_unit;
use crate::sheet::{Sheet, numeral, text};
use oilwedge_study::quantities::{CRITICAL_MASS, LOGARITHMIC_DECREMENT, Quantity, Table, WHIRL_RATIO};
use oilwedge_study::result::{CoefficientReport, DynamicsReport, Pair, RunResult, Stable};

/// Digits of a coefficient: bars are some thousandths.
const DIGITS: usize = 4;

/// The tables of the coefficients, the stability of the rotor and, where all is shown, the coefficients with their
/// bars; nothing where they were not asked for.
pub(crate) fn dynamics(result: &RunResult, shown: ShownQuantities) -> Option<String> {
    let report = result.dynamics.as_ref()?;
    let mut parts = vec!["stiffness and damping at the temperature of the film".to_owned()];
    let distinct = match report.depends_on_whirl {
        true => &report.coefficients[..],
        false => &report.coefficients[..report.coefficients.len().min(1)],
    };
    for coefficients in distinct {
        parts.push(at_whirl(report, coefficients));
    }
    if shown == ShownQuantities::All {
        let list = result.quantities.iter().filter(|quantity| quantity.row.table == Table::Dynamics);
        parts.push(quantities(list, result.bars));
    }
    parts.push(rotor(result, report));
    Some(parts.join("\n"))
}

/// The tables at one frequency.
fn at_whirl(report: &DynamicsReport, at: &CoefficientReport) -> String {
    let frequency = match (report.depends_on_whirl, at.whirl) {
        (false, _) => String::new(),
        (true, 0.0) => ", for slow motions".to_owned(),
        (true, whirl) => format!(", for motions at {} of the speed", significant(whirl, 3)),
    };
    let units = match at.in_bearing.stiffness.len() {
        2 => "K in N/m, C in N.s/m",
        _ => "K in N/m, N/rad and N.m/rad, C in these times s",
    };
    let mut parts = vec![format!(
        "in bearing axes{frequency}: {units}\n{}",
        pair(&at.in_bearing, ["W_x", "W_y", "m_x", "m_y"], ["x", "y"])
    )];
    if let (Some(scaled), Some(angle)) = (&at.without_dimension, report.load_angle) {
        let arms = match at.in_bearing.stiffness.len() {
            2 => "",
            _ => "; slopes and moments by half of the length",
        };
        parts.push(format!(
            "along the load ({} deg) and across it in the sense of rotation{frequency}: K c/W, C c omega/W{arms}\n{}",
            significant(angle, 5),
            pair(scaled, ["W_1", "W_2", "m_1", "m_2"], ["1", "2"])
        ));
    }
    parts.join("\n")
}

/// Stiffness and damping side by side.
fn pair(pair: &Pair, forces: [&str; 4], [first, second]: [&str; 2]) -> String {
    let motions = [format!("e_{first}"), format!("e_{second}"), format!("g_{first}"), format!("g_{second}")];
    let order = pair.stiffness.len();
    let of = |matrix: &str, prime: &str| {
        let headings = motions[..order].iter().map(|motion| format!("{matrix} by {motion}{prime}"));
        headings.collect::<Vec<_>>()
    };
    let headings = std::iter::once(String::new()).chain(of("K", "")).chain(of("C", "'"));
    let rows = forces.iter().zip(&pair.stiffness).zip(&pair.damping).map(|((force, stiffness), damping)| {
        let numbers = stiffness.iter().chain(damping).map(|&entry| numeral(coefficient(entry)));
        std::iter::once(text(*force)).chain(numbers).collect()
    });
    Sheet { header: headings.collect(), rows: rows.collect(), ..Sheet::default() }.terminal()
}

/// A coefficient, with a power of ten where it has many places.
fn coefficient(value: f64) -> String {
    match value.abs() {
        plain if (1e-3..1e5).contains(&plain) || plain == 0.0 => significant(value, DIGITS),
        _ => format!("{value:.digits$e}", digits = DIGITS - 1),
    }
}

/// Whether a rigid rotor is stable, in a sentence.
fn rotor(result: &RunResult, report: &DynamicsReport) -> String {
    let shown = |quantity: &Quantity| {
        let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
        format!("{} {unit}", significant(quantity.value / size, DIGITS)).trim_end().to_owned()
    };
    let mut line = match report.rotor.stable {
        Stable::WithAnyMass => "rotor     a rigid rotor is stable with any mass".to_owned(),
        Stable::WithNoMass => "rotor     a rigid rotor is stable with no mass".to_owned(),
        Stable::Undetermined => "rotor     the stability of a rigid rotor could not be determined".to_owned(),
        Stable::BelowCriticalMass => {
            let [mass, ratio] = [&CRITICAL_MASS, &WHIRL_RATIO].map(|row| result.quantity(row).map(shown));
            let mass = mass.unwrap_or_default();
            let whirls = ratio.map_or(String::new(), |ratio| format!(", and whirls with more at {ratio} of the speed"));
            format!("rotor     a rigid rotor is stable with up to {mass} for this bearing{whirls}")
        }
    };
    if let Some(mass) = report.rotor.mass {
        let mass = significant(mass, DIGITS);
        line += &match result.quantity(&LOGARITHMIC_DECREMENT) {
            Some(decrement) if decrement.value < 0.0 => {
                format!("; with {mass} kg its whirl grows: logarithmic decrement {}", shown(decrement))
            }
            Some(decrement) => format!("; with {mass} kg its logarithmic decrement is {}", shown(decrement)),
            None => format!("; with {mass} kg it does not whirl"),
        };
    }
    line
}
