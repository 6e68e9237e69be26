//! The balance of heat for people: two curves as a table.

use super::quantities::quantities;
use super::shown::ShownQuantities;
use crate::digits::significant;
use crate::sheet::{Sheet, numeral};
use oilwedge_study::quantities::{ECCENTRICITY, Quantity, TEMPERATURE_EFFECTIVE, Table};
use oilwedge_study::result::{RunResult, TemperatureReport};

/// Temperatures, heats and curves where all is shown and the film is one; nothing where no temperature was sought.
pub(crate) fn balance(result: &RunResult, shown: ShownQuantities) -> Option<String> {
    let report = result.temperature.as_ref()?;
    // Over a cycle there is no curve.
    if shown == ShownQuantities::Headlines || report.curve.is_empty() {
        return None;
    }
    let is_shown =
        |quantity: &&Quantity| quantity.row.table == Table::Temperature || quantity.row == &TEMPERATURE_EFFECTIVE;
    let list = quantities(result.quantities.iter().filter(is_shown), result.bars);
    Some(format!("balance of heat\n{list}\n{}", curve(report)))
}

/// Friction and heat carried off at temperatures around that found.
fn curve(report: &TemperatureReport) -> String {
    let header = ["film [C]", "mu0 [mPa.s]", "friction [W]", "carried off [W]", ECCENTRICITY.name];
    let rows = report.curve.iter().map(|point| {
        let others = [1e3 * point.viscosity, point.friction_power, point.removed(), point.eccentricity];
        let others = others.map(|number| significant(number, 4));
        [format!("{:.2}", point.temperature)].into_iter().chain(others).map(numeral).collect()
    });
    Sheet::new("", header, rows.collect()).terminal()
}
