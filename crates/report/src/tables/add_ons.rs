//! What stands beside a result, for people: one table for every add-on.

use super::pieces::{printable, table, time};
use crate::digits::{bar, quantity_value, significant};
use crate::readable::readable_unit;
use oilwedge_campaign::{AddOn, Comparison, Estimate};
use oilwedge_study::quantities::{Quantity, Unit};

/// Digits of a difference without an error bar.
const DIGITS: usize = 3;
/// Smaller differences are zero [%, deg].
const ZERO: f64 = 1e-9;

/// Title, table, lists and notes of an add-on.
pub(crate) fn add_on(add_on: &AddOn) -> String {
    let mut lines = vec![printable(&add_on.title)];
    lines.extend(comparisons(add_on));
    lines.extend(add_on.lists.iter().map(|(title, quantities)| {
        let numbers: Vec<String> = match &quantities[..] {
            [one] => vec![number(one)],
            all => all.iter().map(|it| format!("{} {}", it.row.symbol, number(it))).collect(),
        };
        format!("{title}: {}", numbers.join(", "))
    }));
    lines.extend(add_on.notes.iter().map(|note| printable(note)));
    lines.join("\n")
}

fn number(quantity: &Quantity) -> String {
    let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
    let value = significant(quantity.value / size, 4);
    format!("{value} {unit}").trim_end().to_owned()
}

/// Quantities in rows: the film's number, and beside it those of each alternative. Nothing where there is nothing to
/// compare.
fn comparisons(add_on: &AddOn) -> Option<String> {
    let answers = &add_on.alternatives;
    let mut rows: Vec<&Comparison> = Vec::new();
    for it in answers.iter().flat_map(|answer| &answer.comparisons) {
        if !rows.iter().any(|row| row.row == it.row) {
            rows.push(it);
        }
    }
    (!rows.is_empty()).then(|| {
        let names = answers.iter().map(|answer| printable(&answer.name));
        let header = ["quantity", "unit", add_on.film].map(str::to_owned);
        let mut table = table(header.into_iter().chain(names), 2..usize::MAX);
        for first in rows {
            let (unit, size) = readable_unit(first.film.or(first.other).map_or(0.0, |it| it.value), first.row.unit);
            let film = first.film.map_or("-".to_owned(), |film| shown(film, size));
            let cells = answers.iter().map(|answer| {
                let found = Comparison::of(first.row, &answer.comparisons);
                found.map_or("-".to_owned(), |it| cell(it, size))
            });
            let row = [first.row.name.to_owned(), unit.to_owned(), film];
            table.add_row(row.into_iter().chain(cells));
        }
        let times: Vec<[f64; 2]> = answers.iter().filter_map(|answer| answer.seconds).collect();
        if let Some([film, _]) = times.first() {
            let others = times.iter().map(|[_, other]| if *other > 0.0 { time(*other) } else { "-".to_owned() });
            table.add_row(["run time".to_owned(), String::new(), time(*film)].into_iter().chain(others));
        }
        table.to_string()
    })
}

fn shown(it: Estimate, size: f64) -> String {
    quantity_value(it.value / size, it.error.map(|error| error / size), 5)
}

/// The other value and, in brackets, how far it is from that of the film.
fn cell(it: &Comparison, size: f64) -> String {
    match (it.other, difference(it)) {
        (None, _) => "-".to_owned(),
        (Some(other), None) => shown(other, size),
        (Some(other), Some(difference)) => format!("{} ({difference})", shown(other, size)),
    }
}

/// The difference in percent of the film's value; of angles, and where that value is zero, in their unit.
fn difference(it: &Comparison) -> Option<String> {
    let (difference, film) = (it.difference()?, it.film?.value);
    let (unit, size) = match it.row.unit {
        Unit::Degree => (it.row.unit.name(), 1.0),
        unit if film == 0.0 => readable_unit(difference, unit),
        _ => ("%", 0.01 * film.abs()),
    };
    let error = it.error().filter(|error| *error > ZERO * size);
    Some(match (difference / size, error) {
        (zero, _) if zero.abs() < ZERO => "0".to_owned(),
        (_, Some(error)) if difference.abs() <= error => "within bars".to_owned(),
        (number, Some(error)) => {
            let number = quantity_value(number, Some(error / size), DIGITS);
            format!("{} ± {} {unit}", signed(number), bar(error / size))
        }
        (number, None) => format!("{} {unit}", signed(significant(number, DIGITS))),
    })
}

fn signed(number: String) -> String {
    match number.starts_with('-') {
        true => number,
        false => format!("+{number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_campaign::{Alternative, Records};
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, LOAD, Row, SIDE_FLOW};

    fn comparison(row: &'static Row, [film, other]: [f64; 2], error: Option<f64>) -> Comparison {
        Comparison { row, film: Some(Estimate { value: film, error }), other: Some(Estimate { value: other, error }) }
    }

    #[test]
    fn differences_are_in_percent_or_degrees() {
        let percent = |film, other, error| difference(&comparison(&LOAD, [film, other], error)).expect("both");
        assert_eq!(percent(200.0, 250.0, None), "+25.0 %");
        assert_eq!(percent(200.0, 150.0, Some(0.2)), "-25.00 ± 0.2 %");
        assert_eq!(percent(200.0, 200.3, Some(0.2)), "within bars");
        assert_eq!(percent(200.0, 200.0, Some(0.2)), "0");
        assert_eq!(percent(0.0, -1500.0, None), "-1.50 kN");
        let angle = comparison(&ATTITUDE_ANGLE, [40.0, 50.0], None);
        assert_eq!(cell(&angle, 1.0), "50.000 (+10.0 deg)");
    }

    #[test]
    fn the_table_holds_every_quantity_of_every_alternative() {
        let answer = |name: &str, comparisons, other| Alternative {
            name: name.into(),
            comparisons,
            seconds: Some([0.03, other]),
        };
        let mut alone = comparison(&SIDE_FLOW, [1e-6, 2e-6], None);
        alone.film = None;
        let all = AddOn {
            title: "a title".into(),
            film: "all effects",
            alternatives: vec![
                answer("without barus", vec![comparison(&LOAD, [2000.0, 1500.0], None)], 0.012),
                answer("without couette", vec![alone], 0.0),
            ],
            lists: vec![("its flows", vec![Quantity::new(&SIDE_FLOW, 1e-6)])],
            notes: vec!["a note".into()],
            record: Records::default(),
        };
        let text = add_on(&all);
        for part in [
            "a title\n",
            "│ load      ┆ kN   ┆      2.0000 ┆ 1.5000 (-25.0 %) ┆",
            "12.0 ms",
            "its flows: 1.000 ml/s\na note",
        ] {
            assert!(text.contains(part), "no {part} in\n{text}");
        }
    }
}
