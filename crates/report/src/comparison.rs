//! Answers side by side, as a sheet: quantities in rows, the film's number, and beside it those of each alternative
//! with how far they are from it.

use oilwedge_campaign::{Comparison, QuantityPair};
use oilwedge_study::quantities::{Quantity, Unit};

use crate::digits::{bar, quantity_value, significant};
use crate::readable::readable_unit;
use crate::sheet::{Cell, DIGITS as LIST_DIGITS, Sheet, none, number_as, text};
use crate::tables::time;

/// Digits of a value without an error bar.
const VALUE_DIGITS: usize = 5;
/// Digits of a difference without an error bar.
const DIGITS: usize = 3;
/// Greater multiples of the film's value are no percentage.
const MOST: f64 = 100.0;
/// Smaller differences are zero [%, deg].
const ZERO: f64 = 1e-9;

/// Title, table, lists and notes of a comparison.
pub fn sheet(comparison: &Comparison) -> Sheet {
    let answers = &comparison.alternatives;
    let mut firsts: Vec<&QuantityPair> = Vec::new();
    for it in answers.iter().flat_map(|answer| &answer.pairs) {
        if !firsts.iter().any(|first| first.name == it.name) {
            firsts.push(it);
        }
    }
    let row = |first: &&QuantityPair| {
        let [film, other] = first.values();
        let (unit, size) = readable_unit(film.or(other).unwrap_or(0.0), first.row.unit);
        let film = first.film.as_ref().map_or_else(none, |film| number_as(film.value, shown(film, size)));
        let cells = answers.iter().map(|answer| {
            let found = answer.pairs.iter().find(|it| it.name == first.name);
            found.map_or_else(none, |it| cell(it, size))
        });
        [text(first.name.as_str()), text(unit), film].into_iter().chain(cells).collect()
    };
    let mut rows: Vec<Vec<Cell>> = firsts.iter().map(row).collect();
    let times: Vec<[f64; 2]> = answers.iter().filter_map(|answer| answer.seconds).collect();
    if let (false, Some([film, _])) = (rows.is_empty(), times.first()) {
        let others = times.iter().map(|[_, other]| if *other > 0.0 { text(time(*other)) } else { none() });
        rows.push([text("run time"), text(""), text(time(*film))].into_iter().chain(others).collect());
    }
    let names = answers.iter().map(|answer| answer.name.clone());
    let header = ["quantity", "unit", &comparison.film].map(str::to_owned).into_iter().chain(names).collect();
    let lists = comparison.lists.iter().map(|(title, quantities)| {
        let numbers: Vec<String> = match &quantities[..] {
            [one] => vec![of_list(one)],
            all => all.iter().map(|it| format!("{} {}", it.row.symbol, of_list(it))).collect(),
        };
        format!("{title}: {}", numbers.join(", "))
    });
    let notes = lists.chain(comparison.notes.clone()).collect();
    Sheet { title: comparison.title.clone(), header, rows, notes, ..Sheet::default() }
}

fn of_list(quantity: &Quantity) -> String {
    let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
    format!("{} {unit}", significant(quantity.value / size, LIST_DIGITS)).trim_end().to_owned()
}

fn shown(it: &Quantity, size: f64) -> String {
    quantity_value(it.value / size, it.error().map(|error| error / size), VALUE_DIGITS)
}

/// The other value and, in brackets, how far it is from that of the film.
fn cell(it: &QuantityPair, size: f64) -> Cell {
    let Some(other) = &it.other else { return none() };
    let distance = difference(it).map_or(String::new(), |difference| format!(" ({difference})"));
    number_as(other.value, shown(other, size) + &distance)
}

/// The difference in percent of the film's value; of angles, and where that value is next to nothing, in their unit.
fn difference(it: &QuantityPair) -> Option<String> {
    let (difference, film) = (it.difference()?, it.film.as_ref()?.value);
    let (unit, size) = match it.row.unit {
        Unit::Degree => (it.row.unit.name(), 1.0),
        unit if difference.abs() > MOST * film.abs() => readable_unit(difference, unit),
        _ => ("%", 0.01 * film.abs()),
    };
    let error = it.error().filter(|error| *error > ZERO * size);
    Some(match (difference / size, error) {
        (zero, _) if zero.abs() < ZERO => "0".to_owned(),
        (_, Some(_)) if it.exceeds_bars() == Some(false) => "within bars".to_owned(),
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
    use oilwedge_campaign::Alternative;
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, Bar, LOAD, Row, SIDE_FLOW};

    fn pair(row: &'static Row, [film, other]: [f64; 2], error: Option<f64>) -> QuantityPair {
        let quantity = |value| Quantity { bar: error.map(Bar::of), ..Quantity::new(row, value) };
        QuantityPair::between(Some(&quantity(film)), Some(&quantity(other))).expect("both")
    }

    #[test]
    fn differences_are_in_percent_or_degrees() {
        let percent = |film, other, error| difference(&pair(&LOAD, [film, other], error)).expect("both");
        assert_eq!(percent(200.0, 250.0, None), "+25.0 %");
        assert_eq!(percent(200.0, 150.0, Some(0.2)), "-25.00 ± 0.2 %");
        assert_eq!(percent(200.0, 200.3, Some(0.2)), "within bars");
        assert_eq!(percent(200.0, 200.0, Some(0.2)), "0");
        assert_eq!(percent(0.0, -1500.0, None), "-1.50 kN");
        assert_eq!(cell(&pair(&ATTITUDE_ANGLE, [40.0, 50.0], None), 1.0).text, "50.000 (+10.0 deg)");
    }

    #[test]
    fn the_table_holds_every_quantity_of_every_alternative() {
        let answer = |name: &str, pairs, other| Alternative { name: name.into(), pairs, seconds: Some([0.03, other]) };
        let alone = QuantityPair { film: None, ..pair(&SIDE_FLOW, [1e-6, 2e-6], None) };
        let all = Comparison {
            title: "a title".into(),
            film: "all effects".into(),
            alternatives: vec![
                answer("without barus", vec![pair(&LOAD, [2000.0, 1500.0], None)], 0.012),
                answer("without couette", vec![alone], 0.0),
            ],
            lists: vec![("its flows", vec![Quantity::new(&SIDE_FLOW, 1e-6)])],
            notes: vec!["a note".into()],
        };
        let text = sheet(&all).terminal();
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
