//! The pictures of a sweep: curves with error bars over one axis, and maps over two.

use oilwedge_drawing::{
    Axis, Cell, CellGrid, Chart, Colour, ColourMap, Figure, Label, Mark, SERIES, Scale, Series, charts_figure,
    draw_colour_bar, least_and_greatest, linear_steps, number,
};
use oilwedge_study::quantities::{CATALOGUE, Headline, row};
use serde_json::Value;

use crate::readable::{axis_label, printed_unit, readable_unit_of};

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

/// An axis of the sweep.
struct Input<'a> {
    name: &'a str,
    unit: &'a str,
    values: &'a [Value],
}

impl Input<'_> {
    fn label(&self) -> Label {
        let unit = printed_unit(if self.unit == "1" { "" } else { self.unit });
        let comma = if unit.is_empty() { "" } else { ", " };
        Label::plain(&format!("{}{comma}{unit}", self.name.replace('_', " ")))
    }

    fn is_numeric(&self) -> bool {
        self.values.len() > 1 && self.values.iter().all(Value::is_number)
    }

    fn word(&self, k: usize) -> String {
        match &self.values[k] {
            Value::String(word) => word.clone(),
            value => value.as_f64().map_or_else(|| value.to_string(), short),
        }
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

/// A sweep as `sweep.json` has it.
pub(crate) struct Cases<'a> {
    title: &'a str,
    inputs: Vec<Input<'a>>,
    /// The columns that the scene asks for: name, and the quantity that it is.
    asked: Vec<(&'a str, &'a str)>,
    rows: &'a [Value],
}

impl<'a> Cases<'a> {
    pub(crate) fn of(sweep: &'a Value) -> Option<Self> {
        let list = |value: &'a Value| value.as_array().map(Vec::as_slice);
        let inputs = list(&sweep["axes"])?.iter().map(|axis| {
            Some(Input {
                name: axis["name"].as_str()?,
                unit: axis["unit"].as_str().unwrap_or_default(),
                values: list(&axis["values"])?,
            })
        });
        Some(Self {
            title: sweep["title"].as_str().unwrap_or_default(),
            inputs: inputs.collect::<Option<_>>()?,
            asked: (list(&sweep["columns"]).into_iter().flatten())
                .filter_map(|column| Some((column["name"].as_str()?, column["quantity"].as_str()?)))
                .collect(),
            rows: list(&sweep["rows"])?,
        })
    }

    /// Name, unit and values of each axis.
    pub(crate) fn inputs(&self) -> impl Iterator<Item = (&str, &str, &[Value])> {
        self.inputs.iter().map(|input| (input.name, input.unit, input.values))
    }

    /// The rows of the cases that are there.
    pub(crate) fn rows(&self) -> &'a [Value] {
        self.rows
    }

    /// The rows of all cases, also of those that are not there; the last axis runs fastest.
    pub(crate) fn all(&self) -> impl Iterator<Item = Option<&'a Value>> {
        let count = self.inputs.iter().map(|input| input.values.len()).product();
        (0..count).map(|place| self.at(place))
    }

    /// The row of the case at a place; rows are in the order of their cases, which count from one.
    fn at(&self, place: usize) -> Option<&'a Value> {
        let case = |row: &Value| row["case"].as_u64().unwrap_or_default();
        let found = self.rows.binary_search_by_key(&(place as u64 + 1), case).ok()?;
        self.rows.get(found)
    }

    /// The row of the case with these indices.
    fn row(&self, indices: &[usize]) -> Option<&'a Value> {
        let each = self.inputs.iter().zip(indices);
        self.at(each.fold(0, |place, (input, index)| place * input.values.len() + index))
    }

    /// Value and error of a quantity.
    fn quantity(&self, indices: &[usize], name: &str) -> Option<[f64; 2]> {
        let quantity = &self.row(indices)?["quantities"][name];
        Some([quantity["value"].as_f64()?, quantity["error"].as_f64().unwrap_or(f64::NAN)])
    }

    /// Whether a quantity is not the same in all cases.
    fn varies(&self, name: &str) -> bool {
        let values = self.rows.iter().filter_map(|row| row["quantities"][name]["value"].as_f64());
        let [low, high] = least_and_greatest(values);
        high - low > ROUND_OFF * low.abs().max(high.abs())
    }

    /// Greatest size of a quantity and its SI unit.
    pub(crate) fn size(&self, name: &str) -> Option<(f64, &'a str)> {
        let quantities = || self.rows.iter().map(|row| &row["quantities"][name]);
        let unit = quantities().find_map(|quantity| quantity["unit"].as_str())?;
        let most = quantities()
            .filter_map(|quantity| quantity["value"].as_f64())
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        Some((most, unit))
    }

    /// Whether the scene asks for columns.
    pub(crate) fn are_asked(&self) -> bool {
        !self.asked.is_empty()
    }

    /// How tables call a column: as the scene writes it, else the name of the quantity in words.
    pub(crate) fn heading(&self, column: &str) -> String {
        match self.asked.iter().any(|(name, _)| *name == column) {
            true => column.to_owned(),
            false => column.replace('.', ", ").replace('_', " "),
        }
    }

    /// The quantity that a column is.
    pub(crate) fn quantity_of<'b>(&'b self, column: &'b str) -> &'b str {
        let asked = self.asked.iter().find(|(name, _)| *name == column);
        asked.map_or(column, |(_, quantity)| quantity)
    }

    /// The unit in which a quantity is shown, with its size: that which the scene asks for, else a readable one.
    pub(crate) fn unit_of(&self, name: &str) -> Option<(&'a str, f64)> {
        let (most, unit) = self.size(name)?;
        Some(if self.are_asked() { (unit, 1.0) } else { readable_unit_of(most, unit) })
    }

    /// The quantities that are drawn: those of the selection, else those that the scene asks for, else the headlines.
    pub(crate) fn names(&self, selected: &[String]) -> Vec<String> {
        let is_input = |name: &str| self.inputs.iter().any(|input| input.name == name);
        let headlines = CATALOGUE.iter().filter(|row| row.headline != Headline::Never).map(|row| row.name.to_owned());
        let asked = self.asked.iter().map(|(name, _)| (*name).to_owned());
        let names: Vec<String> = match (selected.is_empty(), self.asked.is_empty()) {
            (false, _) => selected.to_vec(),
            (true, false) => asked.collect(),
            (true, true) => headlines.collect(),
        };
        let is_round_off = |name: &str| {
            let is_small = |(most, unit): (f64, &str)| most < ROUND_OFF * readable_unit_of(most, unit).1;
            selected.is_empty() && self.asked.is_empty() && self.size(name).is_none_or(is_small)
        };
        let says_something = |name: &String| !is_input(name) && self.size(name).is_some() && !is_round_off(name);
        names.into_iter().filter(says_something).collect()
    }
}

/// The names of quantities that a sweep has, for messages.
pub(crate) fn quantity_names(sweep: &Value) -> Vec<String> {
    let rows = sweep["rows"].as_array().map(Vec::as_slice).unwrap_or_default();
    let first = rows.iter().find_map(|row| row["quantities"].as_object().filter(|quantities| !quantities.is_empty()));
    first.map_or(Vec::new(), |quantities| quantities.keys().cloned().collect())
}

/// The pictures of the object of `sweep.json` by name, of the quantities selected or the headlines.
pub(super) fn sweep_figures(sweep: &Value, selected: &[String], width: f64) -> Vec<(String, Figure)> {
    let Some(cases) = Cases::of(sweep) else {
        return Vec::new();
    };
    let names = cases.names(selected);
    let numeric: Vec<usize> = (0..cases.inputs.len()).filter(|k| cases.inputs[*k].is_numeric()).collect();
    let Some(&across) = numeric.last() else {
        return Vec::new();
    };
    let upwards = (0..cases.inputs.len()).rev().find(|k| *k != across && cases.inputs[*k].values.len() > 1);
    let charts: Vec<Chart> =
        names.iter().take(CHARTS).filter_map(|name| chart(&cases, name, across, upwards)).collect();
    let mut figures = Vec::new();
    if !charts.is_empty() {
        let columns = if width > 120.0 { 2 } else { 1 };
        figures.push(("sweep".to_owned(), charts_figure(cases.title, &charts, columns, width)));
    }
    if let Some(upwards) = upwards {
        let maps = names
            .iter()
            .filter(|name| !selected.is_empty() || cases.varies(name))
            .filter_map(|name| Some((format!("map_{name}"), map(&cases, name, [across, upwards], width)?)))
            .take(MAPS);
        figures.extend(maps);
    }
    figures
}

/// The readable label of a quantity, its unit's size, and whether it is known.
fn about(cases: &Cases, name: &str) -> Option<(Label, f64)> {
    let (unit, size) = cases.unit_of(name)?;
    let quantity = cases.quantity_of(name);
    let symbol = row(quantity).map_or("", |row| row.symbol);
    let words = quantity.replace(['_', '.'], " ");
    Some((Label::marked(&axis_label(&words, symbol, unit)), size))
}

/// One quantity over one axis, a curve for each value of another.
fn chart(cases: &Cases, name: &str, across: usize, upwards: Option<usize>) -> Option<Chart> {
    let (label, size) = about(cases, name)?;
    let input = &cases.inputs[across];
    let mut chart = Chart::new("", input.label(), label);
    let families: Vec<Option<usize>> = match upwards {
        None => vec![None],
        Some(axis) => {
            let count = cases.inputs[axis].values.len();
            let shown = count.min(CURVES);
            (0..shown).map(|k| Some(if shown > 1 { k * (count - 1) / (shown - 1) } else { 0 })).collect()
        }
    };
    for (family, colour) in families.into_iter().zip(SERIES) {
        let mut indices = vec![0; cases.inputs.len()];
        let series_name = match (upwards, family) {
            (Some(axis), Some(index)) => {
                indices[axis] = index;
                let other = &cases.inputs[axis];
                let unit = printed_unit(if other.unit == "1" { "" } else { other.unit });
                format!("{} = {} {unit}", other.name.replace('_', " "), other.word(index)).trim_end().to_owned()
            }
            _ => String::new(),
        };
        let points = (0..input.values.len()).map(|k| {
            indices[across] = k;
            let [value, error] = cases.quantity(&indices, name).unwrap_or([f64::NAN; 2]);
            ([input.values[k].as_f64().unwrap_or(f64::NAN), value / size], error / size)
        });
        let (points, bars): (Vec<[f64; 2]>, Vec<f64>) = points.unzip();
        let line = Series::line(&series_name, colour, points).marked(Mark::Disc);
        chart.series.push(Series { bars, ..line });
    }
    Some(chart)
}

/// One quantity over two axes.
fn map(cases: &Cases, name: &str, [across, upwards]: [usize; 2], width: f64) -> Option<Figure> {
    let (label, size) = about(cases, name)?;
    let [x, y] = [across, upwards].map(|axis| &cases.inputs[axis]);
    let mut indices = vec![0; cases.inputs.len()];
    let mut value = |j: usize, k: usize| {
        (indices[upwards], indices[across]) = (j, k);
        cases.quantity(&indices, name).map(|[value, _]| value / size)
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
        Some(value) => Cell { fill: map.colour((value - low) / (high - low)), word: number(*value, step) },
        None => Cell { fill: ABSENT, word: Label::plain("\u{2013}") },
    };
    let others: Vec<String> = (0..cases.inputs.len())
        .filter(|k| ![across, upwards].contains(k))
        .map(|k| format!("{} = {}", cases.inputs[k].name, cases.inputs[k].word(0)))
        .collect();
    let words = |input: &Input| (0..input.values.len()).map(|k| Label::plain(&input.word(k))).collect();
    let at = if others.is_empty() { String::new() } else { format!(" at {}", others.join(", ")) };
    let grid = CellGrid {
        title: label.clone(),
        legend: Label::plain(&format!("{}{at}; grey: no film", cases.title)),
        x: x.label(),
        columns: words(x),
        y: y.label(),
        rows: words(y),
        cells: values.iter().map(|row| row.iter().map(cell).collect()).collect(),
    };
    let title = format!("{}: {}", cases.title, label.text());
    let description = format!("{} over {} and {}", label.text(), x.name, y.name);
    let mut figure = Figure::new([width, grid.height() + 1.0], &title, &description);
    let inner = grid.draw(&mut figure, [1.0, 1.0], width - 1.0 - BAR);
    let axis = Axis::between(low, high, Scale::Linear, Label::default());
    draw_colour_bar(&mut figure, inner, &axis, map, &[]);
    Some(figure)
}
