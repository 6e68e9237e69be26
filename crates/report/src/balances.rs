//! What must vanish in a solution, and what was left of it, as sheets.

use oilwedge_study::result::{Balances, RunResult};
use oilwedge_study::shaft::{ShaftBalances, ShaftResult};

use crate::digits::significant;
use crate::sheet::{Sheet, number, text};

/// Digits of what was left in lines.
const DIGITS: usize = 2;

/// The balances of a film or an orbit.
pub(crate) fn of_film(result: &RunResult) -> Sheet {
    let Balances { mass, power, moment, force, tilt, deflection, thermal, energy } = result.balances;
    sheet(&[
        (Some(mass), "oil that enters less oil that leaves, over the oil that passes"),
        (Some(power), "power put in less dissipation, over all powers"),
        (Some(moment), "moments of friction less that of the load, over the friction"),
        (Some(force), "load less force of the film, over the load"),
        (Some(tilt), "moment of load and support less that of the film, over the load times half of the length"),
        (deflection, "deflection less that by the pressure, over the deflection"),
        (energy, "energy put in over the cycle less what is dissipated, over the latter"),
        (result.temperature.as_ref().map(|_| thermal), "power of friction less what is carried off, over the friction"),
    ])
}

/// The balances of a shaft.
pub(crate) fn of_shaft(result: &ShaftResult) -> Sheet {
    let energies = result.bearings.iter().filter_map(|bearing| bearing.energy);
    let ShaftBalances { force, moment, journals, power, thermal } = result.balances;
    sheet(&[
        (Some(force), "loads less forces of all films, over the loads, at the worst step"),
        (Some(moment), "their moments, over those of the loads, at the worst step"),
        (Some(journals), "what is left of the equations of all journals, over the loads"),
        (
            power,
            "power of the loads and of what turns the shaft, less what films dissipate and the shaft stores, over the dissipation, at the worst step",
        ),
        (Some(thermal), "power of a film that neither its oil nor its housing takes, over that power"),
        (energies.reduce(f64::max), "energy of a bearing over the cycle, over its dissipation: the error of the steps"),
    ])
}

fn sheet(left: &[(Option<f64>, &str)]) -> Sheet {
    let rows = left.iter().filter_map(|(left, what)| Some(vec![text(*what), number((*left)?)]));
    Sheet::new("", ["balance", "left over"], rows.collect())
}

/// The balances in lines for the terminal; those that hold by themselves are left out.
pub(crate) fn lines(balances: &Sheet) -> Vec<String> {
    let open = balances.rows.iter().filter_map(|row| Some((row[1].value.filter(|left| *left != 0.0)?, &row[0].text)));
    let line = |(place, (left, what)): (usize, (f64, &String))| {
        let label = if place == 0 { "balance" } else { "" };
        format!("{label:10}{:9} {what}", significant(left, DIGITS))
    };
    open.enumerate().map(line).collect()
}
