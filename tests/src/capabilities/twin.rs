//! The numbers of a row against those of its twin.

use oilwedge_study::quantities::{Quantity, Unit};

use super::scene::{FLOW, Frame};

/// Power of the size with which numbers of a unit grow, at the same speed and viscosity.
fn power(unit: Unit) -> i32 {
    match unit {
        Unit::Metre => 1,
        Unit::Newton => 2,
        Unit::NewtonMetre | Unit::Watt | Unit::CubicMetrePerSecond => 3,
        _ => 0,
    }
}

/// Whether it is the place of an extremum, which is known to the root of what its value is known to.
fn is_place(number: &Quantity) -> bool {
    let of_extremum = number.name.contains("_max_") || number.name.contains("_min_");
    of_extremum && (number.row.unit == Unit::Degree || number.name.ends_with("_z"))
}

/// Numbers of the twin that do not follow from those of the row to this part.
pub(super) fn differences(own: &[Quantity], twin: &[Quantity], frame: Frame, tolerance: f64) -> Vec<String> {
    let by_size = |number: &Quantity| frame.size.powi(power(number.row.unit)) * number.value;
    // What vanishes is compared with what does not.
    let greatest = |unit: Unit| {
        let least = if unit == Unit::CubicMetrePerSecond { FLOW } else { f64::MIN_POSITIVE };
        own.iter().filter(|number| number.row.unit == unit).map(|it| by_size(it).abs()).fold(least, f64::max)
    };
    let is_off = |number: &&Quantity| {
        let (wanted, name) = turned(number, by_size(number), frame.turn);
        let off = |found: f64| match number.row.unit {
            Unit::Degree => ((found - wanted + 180.0).rem_euclid(360.0) - 180.0).abs() / 360.0,
            // Either end may have the first of two equal extrema.
            Unit::Metre if number.name.ends_with("_z") => (found.abs() - wanted.abs()).abs() / greatest(Unit::Metre),
            Unit::Metre => (found / wanted - 1.0).abs(),
            unit => (found - wanted).abs() / greatest(unit),
        };
        let most = if is_place(number) { tolerance.sqrt() } else { tolerance };
        let found = twin.iter().find(|other| other.name == name);
        found.is_none_or(|found| off(found.value).is_nan() || off(found.value) > most)
    };
    let told = |number: &Quantity| {
        let other = twin.iter().find(|other| other.name == number.name).map(|other| other.value);
        format!("{} {:e} {other:?}", number.name, number.value)
    };
    own.iter().filter(is_off).map(told).collect()
}

/// The number that a film has which is turned by a quarter or not at all, and its name there: a part towards x is one
/// towards y then, and angles around the liner grow by the turn.
fn turned(number: &Quantity, value: f64, turn: f64) -> (f64, String) {
    let name = number.name.to_string();
    if turn == 0.0 {
        return (value, name);
    }
    let parts = [("_x", "_y", 1.0), ("_y", "_x", -1.0)];
    let part = parts.iter().find_map(|(from, to, sign)| Some((sign * value, name.strip_suffix(from)?.to_owned() + to)));
    let is_around = number.row.unit == Unit::Degree && !name.ends_with("crank_angle") && name != "attitude_angle";
    part.unwrap_or((if is_around { value + turn } else { value }, name))
}
