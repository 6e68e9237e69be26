//! What matters among the tolerances of a scene, for people.

use oilwedge_campaign::main_of;
use oilwedge_study::quantities::{FILM_THICKNESS_MIN, Quantity, QuantitySpread};
use oilwedge_study::result::RunResult;

use crate::digits::significant;
use crate::readable::readable_unit;
use crate::sheet::{Sheet, number_as, text};

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
    let name = quantity.name.replace(['_', '.'], " ");
    let heading = format!("{name} at the upper end, {unit}");
    let mut notes = vec![format!(
        "{name} {} {unit}: +- {} by the root of the squares, +- {} at worst",
        told(quantity.value),
        told(own.rss),
        told(own.worst_case)
    )];
    notes.extend(main_of(result).and_then(linearity));
    Some(Sheet {
        title: "What matters among the tolerances".to_owned(),
        header: vec!["key".to_owned(), "share, %".to_owned(), heading.trim_end_matches(", ").to_owned()],
        rows: rows.collect(),
        notes,
        ..Sheet::default()
    })
}

/// Whether the effects add up at the worst corners of a quantity, in words.
fn linearity(quantity: &Quantity) -> Option<String> {
    let QuantitySpread { nonlinearity, corners, .. } = quantity.spread.as_ref()?;
    let (name, percent) = (quantity.name.replace(['_', '.'], " "), significant(100.0 * (*nonlinearity)?, 2));
    Some(match corners {
        None => format!("at its worst corners {name} is linear to {percent} %"),
        Some([low, high]) => {
            let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
            let [low, high] = [low, high].map(|value| significant(value / size, DIGITS));
            format!(
                "{name} is not linear: at its worst corners it is {low} and {high} {unit}, {percent} % from the sum"
            )
        }
    })
}
