//! What spreads the main numbers of a film: a tornado of each, the widest tolerance on top, and the first of them along
//! that tolerance, by films and by its derivative.

use oilwedge_campaign::main_of;
use oilwedge_drawing::{
    BLUE, Chart, Figure, FilledBlock, INK, Label, Mark, PAGE_WIDTH, Series, Stroke, VERMILION, charts_figure,
};
use oilwedge_study::quantities::{Quantity, QuantitySpread, ToleranceCurve};
use oilwedge_study::result::{RunResult, headlines};

use crate::readable::{plain_words, printed_unit, readable_unit};

/// Name of the picture.
pub(crate) const TOLERANCES: &str = "tolerances";
/// Most numbers that have a tornado, and most tolerances in each.
const MOST_CHARTS: usize = 5;
const MOST_ROWS: usize = 8;
/// Half of the height of a block, over the distance of the rows.
const HALF: f64 = 0.35;
/// Charts in a row.
const COLUMNS: usize = 2;

/// The picture, at most that wide [mm]; `None` of a film without tolerances.
pub(crate) fn tolerances_figure(result: &RunResult, width: f64) -> Option<Figure> {
    let all = headlines(&result.quantities, |quantity| quantity.row, &result.effects);
    let mut charts: Vec<Chart> = all.into_iter().filter_map(tornado).take(MOST_CHARTS).collect();
    charts.extend(result.tolerance_curve.as_ref().and_then(|curve| along(main_of(result)?, curve)));
    let title = format!("{}: what its tolerances leave open", result.head.title);
    (!charts.is_empty()).then(|| charts_figure(&title, &charts, COLUMNS, width.min(PAGE_WIDTH)))
}

/// The name of a quantity, the unit in which it is shown, and the size of that.
fn shown(quantity: &Quantity) -> (String, String, f64) {
    let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
    let name = plain_words(&quantity.name);
    let heading = if unit.is_empty() { name.clone() } else { format!("{name}, {}", printed_unit(unit)) };
    (name, heading, size)
}

/// How far each tolerance moves a quantity, to first order; `None` where none does.
fn tornado(quantity: &Quantity) -> Option<Chart> {
    let QuantitySpread { rss, shares, .. } = quantity.spread.as_ref().filter(|own| own.rss > 0.0)?;
    let (name, heading, size) = shown(quantity);
    let mut effects: Vec<(&str, f64)> = Vec::new();
    for (key, share) in shares.iter().filter(|(_, share)| **share > 0.0) {
        let slope = quantity.sensitivity.get(key).map_or(1.0, |it| it.value);
        effects.push((key, share.sqrt() * rss * slope.signum() / size));
    }
    effects.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    effects.truncate(MOST_ROWS);
    effects.reverse();
    let middle = quantity.value / size;
    let mut chart = Chart::new(&name, Label::plain(&heading), Label::default());
    chart.rows = effects.iter().map(|(key, _)| Label::plain(key)).collect();
    let (mut lower, mut upper) = (Vec::new(), Vec::new());
    for (row, (_, effect)) in (0..).map(f64::from).zip(&effects) {
        for (sign, colour, ends) in [(-1.0, BLUE, &mut lower), (1.0, VERMILION, &mut upper)] {
            let end = middle + sign * effect;
            chart.blocks.push(FilledBlock { across: [middle, end], upwards: [row - HALF, row + HALF], colour });
            ends.push([end, row]);
        }
    }
    chart.series = vec![
        Series::line("", INK, vec![[middle, -0.5], [middle, effects.len() as f64 - 0.5]]),
        Series::marks("lower end of the tolerance", BLUE, Mark::Disc, lower),
        Series::marks("upper end", VERMILION, Mark::Disc, upper),
    ];
    Some(chart)
}

/// A quantity along the tolerance that matters most: films, and its derivative through the nominal one.
fn along(quantity: &Quantity, curve: &ToleranceCurve) -> Option<Chart> {
    let values = curve.quantities.get(quantity.name.as_ref())?;
    let (name, heading, size) = shown(quantity);
    let unit = printed_unit(&curve.unit);
    let key = if unit.is_empty() { curve.key.clone() } else { format!("{}, {unit}", curve.key) };
    let mut chart =
        Chart::new(&format!("{name} along its widest tolerance"), Label::plain(&key), Label::plain(&heading));
    let films = curve.numbers.iter().zip(values).map(|(x, value)| [*x, value / size]).collect();
    let middle = curve.numbers.len() / 2;
    let slope = quantity.sensitivity.get(&curve.key).map_or(0.0, |it| it.value);
    let tangent = |x: &f64| [*x, (values[middle] + slope * (x - curve.numbers[middle])) / size];
    let ends = [curve.numbers.first()?, curve.numbers.last()?];
    chart.series = vec![
        Series::line("derivative", INK, ends.map(tangent).to_vec()).stroked(Stroke::Dashed),
        Series::line("films", INK, films).marked(Mark::Ring),
    ];
    Some(chart)
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::quantities::{LOAD, Sensitivity};
    use std::collections::BTreeMap;

    #[test]
    fn the_widest_tolerance_is_on_top_and_signs_are_those_of_derivatives() {
        let sensitivity = |value| Sensitivity { value, ..Sensitivity::default() };
        let shares = [("clearance", 0.64), ("speed", 0.36), ("angle", 0.0)].map(|(key, share)| (key.to_owned(), share));
        let spread =
            QuantitySpread { rss: 10.0, worst_case: 14.0, shares: BTreeMap::from(shares), ..QuantitySpread::default() };
        let slopes = [("clearance", -2.0), ("speed", 1.0)].map(|(key, slope)| (key.to_owned(), sensitivity(slope)));
        let load =
            Quantity { spread: Some(spread), sensitivity: BTreeMap::from(slopes), ..Quantity::new(&LOAD, 500.0) };
        let chart = tornado(&load).expect("a chart");
        assert_eq!(chart.rows.iter().map(Label::text).collect::<Vec<_>>(), ["speed", "clearance"]);
        assert_eq!(chart.series[2].points, [[506.0, 0.0], [492.0, 1.0]]);
        let numbers = vec![20.0, 25.0, 30.0];
        let quantities = BTreeMap::from([("load".to_owned(), vec![509.0, 500.0, 492.5])]);
        let curve = ToleranceCurve { key: "clearance".to_owned(), unit: "um".to_owned(), numbers, quantities };
        let chart = along(&load, &curve).expect("a chart");
        assert_eq!(chart.series[0].points, [[20.0, 510.0], [30.0, 490.0]]);
    }
}
