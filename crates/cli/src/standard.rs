//! The bearing by ISO 7902 and DIN 31652 beside its film, for people.

use crate::complain::printable;
use crate::readable::{readable_unit, significant, supported};
use crate::terminal::{align_right, table};
use oilwedge_campaign::AddOns;
use oilwedge_campaign::standard::{Beside, Standard, StandardHeat};

/// Digits of what the fits give, and of a difference.
const DIGITS: [usize; 2] = [4, 2];

/// The two side by side, and what keeps them apart; nothing where that was not asked for.
pub(crate) fn standard(add_ons: &AddOns) -> Option<String> {
    let standard = add_ons.standard.as_ref()?;
    let mut lines: Vec<String> = standard.given.iter().map(|given| opening(standard, given)).collect();
    if !standard.numbers.is_empty() {
        lines.push(side_by_side(&standard.numbers));
    }
    lines.extend(flows(standard));
    lines.extend(standard.heat.as_ref().map(own_heat));
    lines.extend(standard.notes.iter().map(|note| printable(note)));
    Some(lines.join("\n"))
}

fn opening(standard: &Standard, given: &str) -> String {
    let (unit, size) = readable_unit(standard.viscosity, "Pa.s");
    let feed = standard
        .feed
        .as_deref()
        .map_or(String::new(), |feed| format!(", fed through {feed}"));
    let viscosity = significant(standard.viscosity / size, DIGITS[0]);
    format!("ISO 7902 (DIN 31652), given the same {given} and a viscosity of {viscosity} {unit}{feed}")
}

/// The parts of its side flow, where a feed adds to it.
fn flows(standard: &Standard) -> Option<String> {
    let told = |flow: f64| {
        let (unit, size) = readable_unit(flow, "m3/s");
        format!("{} {unit}", significant(flow / size, DIGITS[0]))
    };
    let (squeezed, pressed) = (standard.squeezed_flow?, standard.pressed_flow?);
    Some(format!(
        "its side_flow: Q_3 {} pressed out by the narrowing film, Q_p {} pressed through by the feed",
        told(squeezed),
        told(pressed)
    ))
}

/// What it finds where the temperature is its own too.
fn own_heat(heat: &StandardHeat) -> String {
    let told = |value: f64, unit: &str| {
        let (unit, size) = readable_unit(value, unit);
        (significant(value / size, DIGITS[0]), unit.to_owned())
    };
    let (flow, flow_unit) = told(heat.side_flow, "m3/s");
    let (film, film_unit) = told(heat.film_thickness_min, "m");
    let (power, power_unit) = told(heat.friction_power, "W");
    format!(
        "its own balance of heat: film {:.2} degC, outlet {:.2} degC, friction {power} {power_unit}, side_flow {flow} {flow_unit}, eccentricity {}, thinnest film {film} {film_unit}",
        heat.temperature_effective,
        heat.temperature_outlet,
        significant(heat.eccentricity, DIGITS[0])
    )
}

fn side_by_side(numbers: &[Beside]) -> String {
    let mut table = table(["quantity", "unit", "ISO 7902", "this film", "ISO 7902 is off by"]);
    for beside in numbers {
        let (unit, size) = readable_unit(beside.film, &beside.unit);
        let film = match beside.error {
            Some(error) if error > 0.0 => supported(beside.film / size, error / size),
            _ => significant(beside.film / size, DIGITS[0] + 1),
        };
        table.add_row([
            beside.quantity.to_owned(),
            unit.to_owned(),
            significant(beside.standard / size, DIGITS[0]),
            film,
            off(beside),
        ]);
    }
    (2..5).for_each(|column| align_right(&mut table, column));
    table.to_string()
}

/// The difference in percent, of angles in degrees.
fn off(beside: &Beside) -> String {
    let (difference, unit) = match beside.relative() {
        Some(part) => (100.0 * part, "%"),
        None => (beside.difference, beside.unit.as_str()),
    };
    let sign = if difference > 0.0 { "+" } else { "" };
    format!("{sign}{} {unit}", significant(difference, DIGITS[1]))
        .trim_end()
        .to_owned()
}
