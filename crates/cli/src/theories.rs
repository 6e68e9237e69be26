//! A film as a short, a full and a long bearing, for people.

use crate::complain::printable;
use crate::readable::{readable_unit, significant, supported};
use crate::terminal::{align_right, table};
use oilwedge_campaign::AddOns;
use oilwedge_campaign::theories::{Theories, TheoryFilm, TheoryNumber};
use oilwedge_study::effects::bearing_theory::{LONG_FROM, SHORT_TO};
use oilwedge_study::quantities::{ATTITUDE_ANGLE, ECCENTRICITY, LOAD, PRESSURE_MAX};

/// Digits of a value without a bar, and of a difference.
const DIGITS: [usize; 2] = [5, 3];
/// Smaller differences are nothing [%, deg].
const NOTHING: f64 = 1e-6;
/// A difference that the bars of both numbers hold.
const WITHIN: &str = "within bars";
/// A number below this in its smallest unit is nothing: 1e-9 N, um or ml/s.
const ROUNDING: f64 = 1e-9;

/// The three side by side, and what follows; nothing where that was not asked for.
pub(crate) fn theories(add_ons: &AddOns) -> Option<String> {
    let theories = add_ons.theories.as_ref()?;
    let [short, full, long] = ["short", "full", "long"].map(|name| theories.film(name));
    let films = [short?, full?, long?];
    let mut lines = Vec::new();
    if films.iter().any(|film| !film.quantities.is_empty()) {
        lines.push(
            "one scene, three theories: pressure drives oil along the axis only, in both directions, around only"
                .to_owned(),
        );
        lines.push(side_by_side(films));
    }
    if !theories.without.is_empty() {
        lines.push(format!("all three: without {}", theories.without.join(", without ")));
    }
    for film in films {
        lines.extend(remarks(film));
    }
    lines.push(verdict(theories));
    Some(lines.join("\n"))
}

fn side_by_side(films: [&TheoryFilm; 3]) -> String {
    let mut table = table([
        "quantity",
        "unit",
        "short",
        "full",
        "long",
        "short is off by",
        "long is off by",
    ]);
    let mut names: Vec<&str> = Vec::new();
    for number in films.iter().flat_map(|film| &film.quantities) {
        if !names.contains(&number.quantity.as_str()) {
            names.push(&number.quantity);
        }
    }
    for name in names {
        let numbers = films.map(|film| film.quantity(name));
        let [_, full, _] = numbers;
        let Some(first) = full.or(numbers[0]).or(numbers[2]) else {
            continue;
        };
        let (unit, size) = readable_unit(first.value, &first.unit);
        let values = numbers.map(|number| number.map_or("-".to_owned(), |it| value(it, size)));
        let [short, _, long] = numbers.map(|number| off(number, full).unwrap_or("-".to_owned()));
        let row = [name.to_owned(), unit.to_owned()].into_iter().chain(values);
        table.add_row(row.chain([short, long]));
    }
    (2..7).for_each(|column| align_right(&mut table, column));
    table.to_string()
}

fn value(number: &TheoryNumber, size: f64) -> String {
    match (number.value, number.error) {
        _ if is_nothing(number) => "0".to_owned(),
        (value, Some(error)) if error > 0.0 => supported(value / size, error / size),
        (value, _) => significant(value / size, DIGITS[0]),
    }
}

fn is_nothing(number: &TheoryNumber) -> bool {
    let (_, size) = readable_unit(number.value, &number.unit);
    (number.value / size).abs() < ROUNDING
}

/// How far a number is from that of the full film: in percent of it, angles in degrees.
fn off(number: Option<&TheoryNumber>, full: Option<&TheoryNumber>) -> Option<String> {
    let (number, full) = (number?, full?);
    let difference = number.difference?;
    let (unit, size) = match full.value {
        _ if number.unit == "deg" => ("deg", 1.0),
        _ if is_nothing(full) && !is_nothing(number) => return None,
        value => ("%", 0.01 * value.abs()),
    };
    if (difference / size).abs() < NOTHING || is_nothing(number) && is_nothing(full) {
        return Some("0".to_owned());
    }
    let bars = number.error.zip(full.error).map(|(one, other)| one + other);
    if bars.is_some_and(|bars| difference.abs() <= bars) {
        return Some(WITHIN.to_owned());
    }
    let sign = if difference > 0.0 { "+" } else { "" };
    Some(format!("{sign}{} {unit}", significant(difference / size, DIGITS[1])))
}

/// Why there is no film, and what was added to the scene.
fn remarks(film: &TheoryFilm) -> Vec<String> {
    let reason = film
        .reason
        .iter()
        .map(|reason| format!("no {} film: {}", film.theory, printable(reason)));
    let reason = match film.quantities.is_empty() {
        true => reason.collect(),
        false => film
            .reason
            .iter()
            .map(|reason| format!("{}: {}", film.theory, printable(reason)))
            .collect::<Vec<_>>(),
    };
    let start = film.film_start_deg.map(|start| {
        format!(
            "{}: the ring was given a film start at its widest film, {} deg",
            film.theory,
            significant(start, 4)
        )
    });
    reason.into_iter().chain(start).collect()
}

/// What B/D says of the theories, and how far the short bearing is off here.
fn verdict(theories: &Theories) -> String {
    let slenderness = theories.slenderness;
    let place = match slenderness {
        low if low <= SHORT_TO => format!("a short bearing (B/D up to {SHORT_TO})"),
        high if high >= LONG_FROM => format!("a long bearing (B/D from {LONG_FROM} on)"),
        _ => format!("neither short (B/D up to {SHORT_TO}) nor long (from {LONG_FROM} on)"),
    };
    let told = |theory: &str, name: &str| {
        let number = theories.film(theory).and_then(|film| film.quantity(name));
        let full = theories.film("full").and_then(|film| film.quantity(name));
        let off = off(number, full).filter(|off| off != WITHIN && off != "0")?;
        Some(format!("{} by {off}", name.replace('_', " ")))
    };
    let sentences = ["short", "long"].into_iter().filter_map(|theory| {
        let offs = [&LOAD, &ECCENTRICITY, &PRESSURE_MAX, &ATTITUDE_ANGLE].map(|row| told(theory, row.name));
        let offs: Vec<String> = offs.into_iter().flatten().collect();
        (!offs.is_empty()).then(|| format!("the theory of {theory} bearings is off in {}", offs.join(", ")))
    });
    let mut all = vec![format!("B/D       {}: {place}", significant(slenderness, 3))];
    all.extend(sentences);
    all.join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terminal::run_report;
    use crate::terminal::tests::result;
    use oilwedge_study::result::Status;
    use std::path::Path;

    fn film(theory: &str, numbers: &[(&str, &str, f64)], full: &[f64]) -> TheoryFilm {
        let number = |(&(name, unit, value), full): (&(&str, &str, f64), &f64)| TheoryNumber {
            quantity: name.into(),
            symbol: String::new(),
            unit: unit.into(),
            value,
            error: None,
            difference: Some(value - full),
        };
        TheoryFilm {
            theory: theory.into(),
            status: Status::Converged,
            reason: None,
            film_start_deg: None,
            quantities: numbers.iter().zip(full).map(number).collect(),
        }
    }

    #[test]
    fn the_three_stand_side_by_side() {
        let mut add_ons = AddOns::default();
        assert!(theories(&add_ons).is_none());
        let full = [2000.0, 30.0, 1e-6];
        let with = |numbers: [f64; 3]| {
            let [load, angle, flow] = numbers;
            [
                ("load", "N", load),
                ("attitude_angle", "deg", angle),
                ("side_flow", "m3/s", flow),
            ]
        };
        let mut long = film("long", &with([90_000.0, 60.0, 0.0]), &full);
        long.film_start_deg = Some(0.0);
        let films = vec![
            film("short", &with([3000.0, 28.5, 1.02e-6]), &full),
            film("full", &with(full), &full),
            long,
        ];
        add_ons.theories = Some(Theories {
            slenderness: 0.345,
            without: vec!["feeds", "this"],
            films,
        });
        let text = run_report(&result(), &add_ons, Path::new("out"), true);
        for part in [
            "short is off by",
            "+50.0 %",
            "-1.50 deg",
            "-100 %",
            "all three: without feeds, without this\n",
            "long: the ring was given a film start at its widest film, 0 deg\n",
            "B/D       0.345: neither short (B/D up to 0.25) nor long (from 2 on); the theory of short bearings is off in load by +50.0 %, attitude \
             angle by -1.50 deg; the theory of long",
        ] {
            assert!(text.contains(part), "no {part} in\n{text}");
        }
    }

    #[test]
    fn a_theory_without_a_film_says_why() {
        let mut add_ons = AddOns::default();
        let full = film("full", &[("load", "N", 2000.0)], &[2000.0]);
        let mut short = film("short", &[], &[]);
        short.reason = Some("there is a feed".into());
        let mut long = film("long", &[], &[]);
        long.reason = Some("no line".into());
        let films = vec![short, full, long];
        add_ons.theories = Some(Theories {
            slenderness: 0.2,
            without: Vec::new(),
            films,
        });
        let text = theories(&add_ons).expect("a text");
        for part in [
            "no short film: there is a feed\n",
            "no long film: no line\n",
            "0.200: a short bearing",
        ] {
            assert!(text.contains(part), "no {part} in\n{text}");
        }
        assert!(!text.contains("is off in"), "{text}");
        let with = |value: f64, error: f64| TheoryNumber {
            value,
            error: Some(error),
            difference: Some(value - 2000.0),
            ..add_ons.theories.as_ref().expect("three").films[1].quantities[0].clone()
        };
        let told = |value: f64| off(Some(&with(value, 3.0)), Some(&with(2000.0, 2.0)));
        assert_eq!(told(2004.0).as_deref(), Some("within bars"));
        assert_eq!(told(1990.0).as_deref(), Some("-0.500 %"));
        for film in add_ons.theories.iter_mut().flat_map(|it| &mut it.films) {
            film.quantities.clear();
        }
        assert!(theories(&add_ons).is_some_and(|text| !text.contains("three theories")));
    }
}
