//! What matters among the tolerances of a scene, and how numbers change with those of the scene, for people.

use oilwedge_campaign::main_of;
use oilwedge_study::quantities::{FILM_THICKNESS_MIN, Quantity, QuantitySpread, Sensitivity};
use oilwedge_study::result::{RunResult, headlines};

use crate::digits::significant;
use crate::readable::{plain_words, readable_unit};
use crate::sheet::{Cell, Sheet, none, number_as, text};

/// Most keys that are shown.
const SHOWN: usize = 5;
/// Digits of effects and shares.
const DIGITS: usize = 3;

/// The tolerances that spread a film most; `None` where the scene has none. The quantity is the least film or, where
/// that is not spread, the first one of short tables.
pub(crate) fn spread_sheet(result: &RunResult) -> Option<Sheet> {
    let candidates = [result.quantity(&FILM_THICKNESS_MIN), main_of(result)];
    let spread =
        |quantity: Option<&'_ Quantity>| quantity.and_then(|it| it.spread.as_ref()).is_some_and(|it| it.rss > 0.0);
    let others = result.quantities.iter().map(Some);
    let quantity = candidates.into_iter().chain(others).find(|it| spread(*it))??;
    let own = quantity.spread.as_ref()?;
    let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
    let told = |value: f64| significant(value / size, DIGITS);
    let mut shares: Vec<(&String, f64)> = own.shares.iter().map(|(key, share)| (key, *share)).collect();
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    let rows = shares.iter().take(SHOWN).map(|&(key, share)| {
        let slope = quantity.sensitivity.get(key).map_or(1.0, |it| it.value);
        let effect = share.sqrt() * own.rss * slope.signum();
        let cell = number_as(effect, format!("{}{}", if effect > 0.0 { "+" } else { "" }, told(effect)));
        vec![text(key.as_str()), number_as(share, significant(100.0 * share, DIGITS)), cell]
    });
    let name = plain_words(&quantity.name);
    let heading = format!("{name} at the upper end, {unit}");
    let mut notes = vec![format!(
        "{name} {} {unit}: +- {} by the root of the squares, +- {} at worst",
        told(quantity.value),
        told(own.rss),
        told(own.worst_case)
    )];
    notes.extend(linearity(result));
    Some(Sheet {
        title: "What matters among the tolerances".to_owned(),
        header: vec!["key".to_owned(), "share, %".to_owned(), heading.trim_end_matches(", ").to_owned()],
        rows: rows.collect(),
        notes,
        ..Sheet::default()
    })
}

/// How the main numbers of a film change with each number of its scene; `None` where no more was asked than for its
/// tolerances.
pub(crate) fn sensitivity_sheet(result: &RunResult) -> Option<Sheet> {
    let main = main_of(result)?;
    let spread = main.spread.as_ref().map_or(0, |spread| spread.shares.len());
    if main.sensitivity.len() <= spread {
        return None;
    }
    let moves = |quantity: &&&Quantity| quantity.sensitivity.values().any(|it| it.value != 0.0);
    let all = headlines(&result.quantities, |quantity| quantity.row, &result.effects);
    let shown: Vec<&&Quantity> = all.iter().filter(moves).take(SHOWN).collect();
    let name = |quantity: &Quantity| plain_words(&quantity.name);
    let rows = main.sensitivity.keys().map(|key| {
        let cells = shown.iter().map(|quantity| quantity.sensitivity.get(key).map_or_else(none, cell));
        std::iter::once(text(key.as_str())).chain(cells).collect()
    });
    let mut notes =
        vec!["numbers without a unit are exponents: by how many per cent 1 % more of the key changes it".to_owned()];
    if main.sensitivity.values().any(|it| it.is_by_films) {
        notes.push(
            "* by two films solved again, which loses digits: the tangent of the film does not reach that key"
                .to_owned(),
        );
    }
    if shown.iter().flat_map(|quantity| quantity.sensitivity.values()).any(|it| it.has_kink) {
        notes.push(
            "^ at a kink: a node of the mesh goes over to the cavity there; a finer mesh has smaller ones".to_owned(),
        );
    }
    Some(Sheet {
        title: "What changes with each number of the scene".to_owned(),
        header: std::iter::once("key".to_owned()).chain(shown.iter().map(|quantity| name(quantity))).collect(),
        rows: rows.collect(),
        notes,
        ..Sheet::default()
    })
}

/// An exponent or, where there is none, a derivative with its unit.
fn cell(sensitivity: &Sensitivity) -> Cell {
    let Sensitivity { value, unit, log, is_by_films, has_kink } = sensitivity;
    let (number, unit) = log.map_or((*value, unit.as_str()), |log| (log, ""));
    let sign = if number > 0.0 { "+" } else { "" };
    let marks = [(" *", *is_by_films), (" ^", *has_kink)];
    let marks: String = marks.into_iter().filter(|(_, is_so)| *is_so).map(|(mark, _)| mark).collect();
    let told = if number == 0.0 { "0".to_owned() } else { significant(number, DIGITS) };
    number_as(number, format!("{sign}{told} {unit}").trim_end().to_owned() + &marks)
}

/// Whether the effects add up at the worst corners of the main numbers, in sentences.
fn linearity(result: &RunResult) -> Vec<String> {
    let departure = |it: &Quantity| Some((plain_words(&it.name), it.spread.as_ref()?.nonlinearity?));
    let all = result.quantities.iter().filter(|it| it.spread.as_ref().is_some_and(|own| own.corners.is_none()));
    let worst = all.filter_map(departure).max_by(|a, b| a.1.total_cmp(&b.1));
    let linear = worst.map(|(name, departure)| {
        let percent = significant(100.0 * departure, 2);
        format!(
            "at their worst corners the main numbers are linear to {percent} %, that of {name}, but for those below"
        )
    });
    let bent = result.quantities.iter().filter_map(|quantity| {
        let QuantitySpread { corners, nonlinearity, .. } = quantity.spread.as_ref()?;
        let ([low, high], percent) = ((*corners)?, significant(100.0 * (*nonlinearity)?, 2));
        let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
        let [low, high] = [low, high].map(|value| significant(value / size, DIGITS));
        let name = plain_words(&quantity.name);
        let told = format!("{low} to {high} {unit}");
        Some(format!("{name} is not linear: its worst corners are {}, {percent} % from the sum", told.trim_end()))
    });
    let bent: Vec<String> = bent.collect();
    let linear = linear.map(|told| if bent.is_empty() { told.replace(", but for those below", "") } else { told });
    linear.into_iter().chain(bent).collect()
}
