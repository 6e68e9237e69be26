//! The pictures of a sweep: curves with error bars over one axis, and maps over two.

use oilwedge_drawing::{
    Axis, CellGrid, Chart, Colour, ColourMap, ColouredCell, Figure, Label, Mark, SERIES, Scale, Series, charts_figure,
    draw_colour_bar, least_and_greatest, linear_steps, number,
};
use oilwedge_scene::sweep::{AxisValue, SweepAxis};
use oilwedge_study::quantities::{CATALOGUE, Headline, row};

use crate::readable::{axis_label, plain_words, printed_unit, readable_unit_of};
use crate::sweep::{CaseQuantity, CaseRecord, SweepResult};

/// Most curves in a chart, charts on a sheet, and maps.
const CURVES: usize = 6;
const CHARTS: usize = 8;
const MAPS: usize = 4;
/// Room of the bar of colours [mm].
const BAR: f64 = 16.0;
/// A quantity that is nowhere greater in its smallest unit is zero.
const ROUND_OFF: f64 = 1e-6;
/// Cells without an answer.
const ABSENT: Colour = Colour([205, 205, 205]);

fn label(axis: &SweepAxis) -> Label {
    let unit = printed_unit(&axis.unit);
    let comma = if unit.is_empty() { "" } else { ", " };
    Label::plain(&format!("{}{comma}{unit}", axis.name.replace('_', " ")))
}

fn word(axis: &SweepAxis, k: usize) -> String {
    match &axis.values[k] {
        AxisValue::Word(word) => word.clone(),
        AxisValue::Number(value) => short(*value),
    }
}

/// A value with six digits at most.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    let text = match value.abs() {
        0.0 => "0".to_owned(),
        1e-4..1e6 => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    };
    text.replace('-', "\u{2212}")
}

impl SweepResult {
    /// The rows of all cases, also of those that are not there; the last axis runs fastest.
    pub(crate) fn all(&self) -> impl Iterator<Item = Option<&CaseRecord>> {
        let count = self.axes.iter().map(|axis| axis.values.len()).product();
        (0..count).map(|place| self.at(place))
    }

    /// The row of the case at a place; rows are in the order of their cases, which count from one.
    fn at(&self, place: usize) -> Option<&CaseRecord> {
        let found = self.rows.binary_search_by_key(&(place + 1), |row| row.case).ok()?;
        self.rows.get(found)
    }

    /// A quantity of the case with these indices.
    fn quantity(&self, indices: &[usize], name: &str) -> Option<&CaseQuantity> {
        let each = self.axes.iter().zip(indices);
        let row = self.at(each.fold(0, |place, (axis, index)| place * axis.values.len() + index))?;
        row.quantities.get(name)
    }

    /// A quantity of all cases that have it.
    fn quantities<'a>(&'a self, name: &str) -> impl Iterator<Item = &'a CaseQuantity> {
        self.rows.iter().filter_map(move |row| row.quantities.get(name))
    }

    /// Whether a quantity is not the same in all cases.
    pub(crate) fn varies(&self, name: &str) -> bool {
        let [low, high] = least_and_greatest(self.quantities(name).map(|it| it.value));
        high - low > ROUND_OFF * low.abs().max(high.abs())
    }

    /// Greatest size of a quantity and its SI unit.
    pub(crate) fn size(&self, name: &str) -> Option<(f64, &str)> {
        let unit = &self.quantities(name).next()?.unit;
        let most = self.quantities(name).fold(0.0, |most: f64, it| most.max(it.value.abs()));
        Some((most, unit))
    }

    /// How tables call a column: as the scene writes it, else the name of the quantity in words.
    pub(crate) fn heading(&self, column: &str) -> String {
        match self.columns.iter().any(|it| it.name == column) {
            true => column.to_owned(),
            false => column.replace('.', ", ").replace('_', " "),
        }
    }

    /// The quantity that a column is.
    pub(crate) fn quantity_of<'a>(&'a self, column: &'a str) -> &'a str {
        let asked = self.columns.iter().find(|it| it.name == column);
        asked.map_or(column, |it| &it.quantity)
    }

    /// The unit in which a quantity is shown, with its size: that which the scene asks for, else a readable one.
    pub(crate) fn unit_of(&self, name: &str) -> Option<(&str, f64)> {
        let (most, unit) = self.size(name)?;
        Some(if self.columns.is_empty() { readable_unit_of(most, unit) } else { (unit, 1.0) })
    }

    /// The quantities that are drawn: those of the selection, else those that the scene asks for, else the headlines.
    pub(crate) fn names(&self, selected: &[String]) -> Vec<String> {
        let asked = &self.columns;
        let is_input = |name: &str| self.axes.iter().any(|axis| axis.name == name);
        let headlines = CATALOGUE.iter().filter(|row| row.headline != Headline::Never).map(|row| row.name.to_owned());
        let names: Vec<String> = match (selected.is_empty(), asked.is_empty()) {
            (false, _) => selected.to_vec(),
            (true, false) => asked.iter().map(|it| it.name.clone()).collect(),
            (true, true) => headlines.collect(),
        };
        let is_round_off = |name: &str| {
            let is_small = |(most, unit): (f64, &str)| most < ROUND_OFF * readable_unit_of(most, unit).1;
            selected.is_empty() && asked.is_empty() && self.size(name).is_none_or(is_small)
        };
        let says_something = |name: &String| !is_input(name) && self.size(name).is_some() && !is_round_off(name);
        names.into_iter().filter(says_something).collect()
    }
}

/// The names of quantities that a sweep has, for messages.
pub(crate) fn quantity_names(sweep: &SweepResult) -> Vec<String> {
    let first = sweep.rows.iter().map(|row| &row.quantities).find(|quantities| !quantities.is_empty());
    first.map_or(Vec::new(), |quantities| quantities.keys().cloned().collect())
}

/// The pictures of a sweep by name, of the quantities selected or the headlines.
pub(super) fn sweep_figures(sweep: &SweepResult, selected: &[String], width: f64) -> Vec<(String, Figure)> {
    // Draws have no order that a curve could follow.
    if sweep.identity.draws.is_some() {
        return Vec::new();
    }
    let axes = &sweep.axes;
    let names = sweep.names(selected);
    let numeric: Vec<usize> = (0..axes.len()).filter(|k| axes[*k].values.len() > 1 && axes[*k].is_numeric()).collect();
    let Some(&across) = numeric.last() else {
        return Vec::new();
    };
    let upwards = (0..axes.len()).rev().find(|k| *k != across && axes[*k].values.len() > 1);
    let charts: Vec<Chart> = names.iter().take(CHARTS).filter_map(|name| chart(sweep, name, across, upwards)).collect();
    let mut figures = Vec::new();
    if !charts.is_empty() {
        let columns = if width > 120.0 { 2 } else { 1 };
        figures.push(("sweep".to_owned(), charts_figure(&sweep.identity.title, &charts, columns, width)));
    }
    if let Some(upwards) = upwards {
        let maps = names
            .iter()
            .filter(|name| !selected.is_empty() || sweep.varies(name))
            .filter_map(|name| Some((format!("map_{name}"), map(sweep, name, [across, upwards], width)?)))
            .take(MAPS);
        figures.extend(maps);
    }
    figures
}

/// The readable label of a quantity, its unit's size, and whether it is known.
fn of_quantity(cases: &SweepResult, name: &str) -> Option<(Label, f64)> {
    let (unit, size) = cases.unit_of(name)?;
    let quantity = cases.quantity_of(name);
    let symbol = row(quantity).map_or("", |row| row.symbol);
    let words = plain_words(quantity);
    Some((Label::marked(&axis_label(&words, symbol, unit)), size))
}

/// One quantity over one axis, a curve for each value of another.
fn chart(cases: &SweepResult, name: &str, across: usize, upwards: Option<usize>) -> Option<Chart> {
    let (about, size) = of_quantity(cases, name)?;
    let input = &cases.axes[across];
    let mut chart = Chart::new("", label(input), about);
    let families: Vec<Option<usize>> = match upwards {
        None => vec![None],
        Some(axis) => {
            let count = cases.axes[axis].values.len();
            let shown = count.min(CURVES);
            (0..shown).map(|k| Some(if shown > 1 { k * (count - 1) / (shown - 1) } else { 0 })).collect()
        }
    };
    for (family, colour) in families.into_iter().zip(SERIES) {
        let mut indices = vec![0; cases.axes.len()];
        let series_name = match (upwards, family) {
            (Some(axis), Some(index)) => {
                indices[axis] = index;
                let other = &cases.axes[axis];
                let unit = printed_unit(&other.unit);
                format!("{} = {} {unit}", other.name.replace('_', " "), word(other, index)).trim_end().to_owned()
            }
            _ => String::new(),
        };
        let points = (0..input.values.len()).map(|k| {
            indices[across] = k;
            let quantity = cases.quantity(&indices, name);
            let place = match input.values[k] {
                AxisValue::Number(place) => place,
                AxisValue::Word(_) => f64::NAN,
            };
            let value = quantity.map_or(f64::NAN, |it| it.value);
            ([place, value / size], quantity.and_then(|it| it.error).unwrap_or(f64::NAN) / size)
        });
        let (points, bars): (Vec<[f64; 2]>, Vec<f64>) = points.unzip();
        let line = Series::line(&series_name, colour, points).marked(Mark::Disc);
        chart.series.push(Series { bars, ..line });
    }
    Some(chart)
}

/// One quantity over two axes.
fn map(cases: &SweepResult, name: &str, [across, upwards]: [usize; 2], width: f64) -> Option<Figure> {
    let (about, size) = of_quantity(cases, name)?;
    let [x, y] = [across, upwards].map(|axis| &cases.axes[axis]);
    let mut indices = vec![0; cases.axes.len()];
    let mut value = |j: usize, k: usize| {
        (indices[upwards], indices[across]) = (j, k);
        cases.quantity(&indices, name).map(|it| it.value / size)
    };
    let values: Vec<Vec<Option<f64>>> =
        (0..y.values.len()).map(|j| (0..x.values.len()).map(|k| value(j, k)).collect()).collect();
    let known = || values.iter().flatten().flatten().copied();
    let (low, high) = (known().fold(f64::INFINITY, f64::min), known().fold(f64::NEG_INFINITY, f64::max));
    let (map, [low, high]) = match low < 0.0 && high > 0.0 {
        true => (ColourMap::Vik, [-low.abs().max(high), low.abs().max(high)]),
        false => (ColourMap::Batlow, [low, if high > low { high } else { low + 1.0 }]),
    };
    let step = linear_steps(high - low, 100.0);
    let cell = |value: &Option<f64>| match value {
        Some(value) => ColouredCell { fill: map.colour((value - low) / (high - low)), word: number(*value, step) },
        None => ColouredCell { fill: ABSENT, word: Label::plain("\u{2013}") },
    };
    let others: Vec<String> = (0..cases.axes.len())
        .filter(|k| ![across, upwards].contains(k))
        .map(|k| format!("{} = {}", cases.axes[k].name, word(&cases.axes[k], 0)))
        .collect();
    let words = |input: &SweepAxis| (0..input.values.len()).map(|k| Label::plain(&word(input, k))).collect();
    let at = if others.is_empty() { String::new() } else { format!(" at {}", others.join(", ")) };
    let grid = CellGrid {
        title: about.clone(),
        legend: Label::plain(&format!("{}{at}; grey: no film", cases.identity.title)),
        x: label(x),
        columns: words(x),
        y: label(y),
        rows: words(y),
        cells: values.iter().map(|row| row.iter().map(cell).collect()).collect(),
    };
    let title = format!("{}: {}", cases.identity.title, about.text());
    let description = format!("{} over {} and {}", about.text(), x.name, y.name);
    let mut figure = Figure::new([width, grid.height() + 1.0], &title, &description);
    let inner = grid.draw(&mut figure, [1.0, 1.0], width - 1.0 - BAR);
    let axis = Axis::between(low, high, Scale::Linear, Label::default());
    draw_colour_bar(&mut figure, inner, &axis, map, &[]);
    Some(figure)
}
