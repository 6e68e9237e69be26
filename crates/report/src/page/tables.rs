//! Tables beside the quantities: balances, assumptions, criteria, meshes, work, and the time.

use oilwedge_study::quantities::FILM_THICKNESS_MIN;
use oilwedge_study::regime::{APART, THIN};
use serde_json::Value;

use super::quantities::with_minus;
use super::table::{Cell, DIGITS, Table, number, optional, sized, text, without_zeros};
use crate::digits::significant;
use crate::plot::BALANCE;

/// What must vanish, and what was left of it.
pub(super) fn balances(result: &Value) -> Table {
    let about = [
        ("mass", "oil that enters less oil that leaves, over the oil that passes"),
        ("power", "power put in less dissipation, over all powers"),
        ("moment", "moments of friction less that of the load, over the friction"),
        ("force", "load less force of the film, over the load"),
        ("tilt", "moment of load and support less that of the film, over the load times half of the length"),
        ("deflection", "deflection less that by the pressure, over the deflection"),
        ("energy", "energy put in over the cycle less what is dissipated, over the latter"),
        (BALANCE, "power of friction less what is carried off, over the friction"),
    ];
    let rows = about
        .into_iter()
        .filter(|(key, _)| *key != BALANCE || !result[BALANCE].is_null())
        .filter_map(|(key, what)| Some(vec![text(what), number(result["balances"][key].as_f64()?)]));
    Table::new("", ["balance", "left over"], rows.collect())
}

/// The table of the assumptions that the film meets.
pub(super) fn assumptions(result: &Value) -> Table {
    let regime = &result["regime"];
    let value = |key: &str| regime[key].as_f64();
    let least_film = result["quantities"][FILM_THICKNESS_MIN.name]["value"].as_f64();
    let micrometres = |value: f64| sized(value, 1e-6, "\u{b5}m");
    let below = |limit: f64| format!("below {}", number(limit).text);
    let mut rows = Vec::new();
    let mut add = |what: &str, value: Option<Cell>, limit: String| {
        rows.extend(value.map(|value| vec![text(what), value, text(limit)]));
    };
    add(
        "laminar flow: Reynolds number",
        value("reynolds_number").map(number),
        value("taylor_limit").map(below).unwrap_or_default(),
    );
    add("no inertia: Re c/R", value("inertia").map(number), below(1.0));
    add("thin film: c/R", value("clearance_ratio").map(number), format!("below {THIN}"));
    add("smooth surfaces: least film over roughness", value("roughness_ratio").map(number), format!("above {APART}"));
    add(
        "rigid surfaces: elastic deflection",
        value("deflection").map(micrometres),
        least_film.map_or(String::new(), |film| {
            format!(
                "small against the least film, {} \u{b5}m",
                with_minus(without_zeros(significant(film / 1e-6, DIGITS)))
            )
        }),
    );
    add("viscosity law: pressure exponent alpha p", value("pressure_exponent").map(number), String::new());
    add(
        "one temperature: rise of the oil that leaves",
        value("temperature_rise").map(|rise| sized(rise, 1.0, "K")),
        String::new(),
    );
    add("density taken for these", value("density").map(|density| sized(density, 1.0, "kg/m\u{b3}")), String::new());
    Table::new("", ["assumption", "here", "valid"], rows)
}

/// The meshes on the way to a tolerance.
pub(super) fn levels(result: &Value) -> Option<Table> {
    let levels = result["levels"].as_array()?;
    let rows = levels.iter().map(|level| {
        let refinement = level["refinement"].as_str().unwrap_or_default().replace('_', " ");
        vec![optional(&level["unknowns"]), optional(&level["cells"]), text(refinement)]
    });
    Table::new("Meshes towards the tolerance", ["unknowns", "triangles", "refinement"], rows.collect()).if_any()
}

/// How often expensive operations were done, and the iteration.
pub(super) fn work(result: &Value) -> Table {
    let words = |key: &str| key.replace('_', " ");
    let counts = result["counts"].as_object().into_iter().flatten();
    let rows = counts.map(|(key, count)| vec![text(words(key)), optional(count)]);
    Table::new("Work", ["operation", "count"], rows.collect())
}

/// Steps of the nonlinear iteration.
pub(super) fn history(result: &Value) -> Option<Table> {
    let steps = result["history"].as_array()?.iter();
    let rows = steps.map(|step| ["step", "residual", "active"].map(|key| optional(&step[key])).to_vec());
    Table::new("Nonlinear iteration", ["step", "relative residual", "nodes in the cavity"], rows.collect()).if_any()
}

/// Wall times [ms], also those of meshes and effects; the only numbers that differ from run to run.
pub(super) fn timings(result: &Value) -> Table {
    let milliseconds = |seconds: &Value| seconds.as_f64().map_or_else(Cell::default, |it| sized(it, 1e-3, ""));
    let parts = result["timing_s"].as_object().into_iter().flatten();
    let mut rows: Vec<Vec<Cell>> = parts.map(|(part, it)| vec![text(part.as_str()), milliseconds(it)]).collect();
    let levels = (1..).zip(result["levels"].as_array().into_iter().flatten());
    rows.extend(levels.map(|(number, level)| vec![text(format!("mesh {number}")), milliseconds(&level["seconds"])]));
    for cost in result["cost"].as_array().into_iter().flatten() {
        let name = cost["effect"].as_str().unwrap_or_default();
        rows.push(vec![text(format!("without {name}")), milliseconds(&cost["seconds_without"])]);
    }
    Table::new("", ["part", "ms"], rows)
}
