//! The quantities of a run as the page shows them.

use oilwedge_scene::wording::printable;
use oilwedge_study::effects::Effects;
use oilwedge_study::quantities::{
    Bar, CATALOGUE, CYCLE_FILM_THICKNESS_MIN, CYCLE_POWER_LOSS, CYCLE_PRESSURE_MAX, CYCLE_SIDE_FLOW, CYCLE_TEMPERATURE,
    ECCENTRICITY, FILM_THICKNESS_MIN, FRICTION_POWER, MIN_FILM_ANGLE, PRESSURE_MAX, Quantity, Row, SIDE_FLOW,
    TEMPERATURE_EFFECTIVE,
};
use oilwedge_study::result::{RunResult, headlines};
use serde::Serialize;

use crate::digits::bar;
use crate::readable::{printed_symbol, printed_unit, readable_unit, with_minus};
use crate::sheet::{bar_in_words, value_in_words};

/// Cards at the head of the page.
const CARDS: usize = 8;

/// A quantity.
#[derive(Debug, Clone, Serialize)]
pub(super) struct ShownQuantity {
    #[serde(skip)]
    row: &'static Row,
    pub(super) name: String,
    what: &'static str,
    definition: &'static str,
    /// HTML.
    symbol: String,
    value: String,
    unit: String,
    /// The value in SI.
    si: String,
    pub(super) bar: String,
    /// The bar in SI; empty where there is none.
    bar_si: String,
    parts: Vec<BarPart>,
}

/// A part of an error bar.
#[derive(Debug, Clone, Serialize)]
struct BarPart {
    name: String,
    value: String,
    si: String,
}

/// All quantities of a run, in the order of the catalogue.
pub(super) fn quantities(result: &RunResult) -> Vec<ShownQuantity> {
    let mut all: Vec<&Quantity> = result.quantities.iter().collect();
    all.sort_by_key(|it| (CATALOGUE.iter().position(|row| *row == it.row), &it.name));
    all.into_iter().map(|it| ShownQuantity::of(it, result.bars)).collect()
}

impl ShownQuantity {
    /// A quantity with the parts of its bar.
    pub(super) fn of(it: &Quantity, has_bars: bool) -> Self {
        let (_, size) = readable_unit(it.value, it.row.unit);
        let mut parts: Vec<(&str, f64)> =
            it.bar.iter().flat_map(Bar::by_name).filter(|(_, part)| *part > 0.0).collect();
        parts.sort_by_key(|(name, _)| *name);
        let part = |(name, value): (&str, f64)| BarPart {
            name: name.to_owned(),
            value: with_minus(bar(value / size)),
            si: format!("{value}"),
        };
        Self {
            parts: parts.into_iter().map(part).collect(),
            ..Self::number(it.row, &it.name, (it.value, it.error()), has_bars)
        }
    }

    /// A number of this row with its bar.
    pub(super) fn number(row: &'static Row, name: &str, (value, error): (f64, Option<f64>), has_bars: bool) -> Self {
        let (unit, size) = readable_unit(value, row.unit);
        Self {
            row,
            name: in_words(name),
            what: row.what,
            definition: row.definition,
            symbol: html_symbol(row.symbol),
            value: with_minus(value_in_words(value, error, has_bars, size)),
            unit: printed_unit(unit),
            si: format!("{value}"),
            bar: match bar_in_words(error, has_bars, size) {
                number if error.is_some_and(|error| error > 0.0) => format!("\u{b1} {}", with_minus(number)),
                words => words,
            },
            bar_si: error.map(|error| format!("{error}")).unwrap_or_default(),
            parts: Vec::new(),
        }
    }
}

/// A quantity's name in words; what it is of stands behind a comma.
pub(super) fn in_words(name: &str) -> String {
    printable(name).replace('.', ", ").replace('_', " ")
}

/// What an engineer asks first, over a cycle or of a film, and how cards call it.
static ASKED_FIRST: [(&str, [&Row; 2]); 6] = [
    ("least film", [&CYCLE_FILM_THICKNESS_MIN, &FILM_THICKNESS_MIN]),
    ("greatest pressure", [&CYCLE_PRESSURE_MAX, &PRESSURE_MAX]),
    ("power loss", [&CYCLE_POWER_LOSS, &FRICTION_POWER]),
    ("oil flow", [&CYCLE_SIDE_FLOW, &SIDE_FLOW]),
    ("temperature of the film", [&CYCLE_TEMPERATURE, &TEMPERATURE_EFFECTIVE]),
    (ECCENTRICITY.name, [&ECCENTRICITY, &ECCENTRICITY]),
];

/// The quantities at the head of the page: what is asked first, then further headlines.
pub(super) fn cards(all: &[ShownQuantity], effects: &Effects) -> Vec<ShownQuantity> {
    let first = ASKED_FIRST.iter().filter_map(|(name, rows)| {
        let found = rows.iter().find_map(|row| all.iter().find(|it| it.row == *row))?;
        let name = (*name).to_owned();
        Some(ShownQuantity { name, ..found.clone() })
    });
    let mut cards: Vec<ShownQuantity> = first.collect();
    for other in headlines(all, |it| it.row, effects) {
        if cards.iter().all(|card| card.row != other.row) {
            cards.push(other.clone());
        }
    }
    // Of a shaped bore the film is thinnest elsewhere.
    let offset = cards.iter_mut().find(|card| card.row == &MIN_FILM_ANGLE);
    offset.into_iter().for_each(|card| card.name = "direction of the offset".to_owned());
    cards.truncate(CARDS);
    cards
}

/// A symbol as HTML.
pub(super) fn html_symbol(symbol: &str) -> String {
    let escaped = symbol.replace('&', "&amp;").replace('<', "&lt;");
    let marked = printed_symbol(&escaped);
    let mut is_open = false;
    let mut html = String::new();
    for letter in marked.chars() {
        match letter {
            '*' => {
                html += if is_open { "</i>" } else { "<i>" };
                is_open = !is_open;
            }
            letter => html.push(letter),
        }
    }
    html.replace("_{", "<sub>").replace('}', "</sub>")
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::quantities::LOAD;

    #[test]
    fn symbols_have_letters_and_indices() {
        assert_eq!(html_symbol("phi_W"), "<i>\u{3c6}</i><sub>W</sub>");
        assert_eq!(html_symbol("eps"), "<i>\u{3b5}</i>");
        assert_eq!(with_minus("-2.6e-13".to_owned()), "\u{2212}2.6\u{b7}10\u{207b}\u{b9}\u{b3}");
        assert_eq!(with_minus("4.5".to_owned()), "4.5");
    }

    #[test]
    fn a_quantity_is_shown_with_the_digits_of_its_bar() {
        let bar = Bar { front: 0.28, ..Bar::default() };
        let power = Quantity { bar: Some(bar), ..Quantity::new(&FRICTION_POWER, 179.612) };
        let quantities_found = vec![power, Quantity::new(&LOAD, 5000.0)];
        let result = RunResult { bars: true, quantities: quantities_found, ..RunResult::default() };
        let shown = quantities(&result);
        assert_eq!((shown[0].value.as_str(), shown[0].bar.as_str()), ("5.0", "not resolved"));
        assert_eq!((shown[1].value.as_str(), shown[1].bar.as_str()), ("179.61", "\u{b1} 0.28"));
        assert_eq!(shown[1].parts.len(), 1);
    }
}
