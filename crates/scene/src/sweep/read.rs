//! Reads `[sweep]`: axes, each a list or a range of values of one key of the scene.

use toml::Spanned;
use toml::de::DeValue;

use std::path::Path;

use super::{AxisValue, Plan, SHAFT_SHORT_NAMES, SHORT_NAMES, SweepAxis, WantedColumn, column};
use crate::reader::{TableReader, kind, plain_number, written_tolerance};
use crate::scene::{SWEPT, SWEPT_OF_SHAFT};
use crate::spelling::nearest;
use crate::unit;

keys! {
    "sweep" = Table; "", "one case", "",
        "the values of keys for which `oilwedge sweep` solves the scene, in all combinations";
    "sweep.columns" = Texts; "\"h_min um\", \"p_max bar\"", "the main quantities", "",
        "the quantities of the table, each with its unit";
    "sweep.KEY" = Values, Table; "", "the value of the scene", "a short name, or a key with its table",
        "an axis: a key of the scene, and its values in a list or by a range";
    "sweep.KEY.from" = Value; "0.1", "required", "",
        "first value of a range";
    "sweep.KEY.to" = Value; "0.95", "required", "",
        "last value of a range";
    "sweep.KEY.steps" = Number; "18", "required", "2 to 100 000",
        "number of values, both ends included";
    "sweep.KEY.spacing" = Choice(&["linear", "log"]); "linear", "`\"linear\"`", "",
        "constant differences, or constant ratios, between the values";
}

/// Most cases of one sweep.
pub const MOST_CASES: usize = 100_000;
/// Most axes of one sweep.
const MOST_AXES: usize = 32;
/// How an axis is written.
const EXAMPLE: &str = "eccentricity = { from = 0.1, to = 0.95, steps = 18 } or speed = [\"1000 rpm\", \"3000 rpm\"]";

/// Which keys a kind of scenes has, by which an axis may be named.
#[derive(Debug)]
pub(crate) struct Swept {
    /// Short names, and the keys that they stand for.
    short_names: &'static [(&'static str, &'static str)],
    /// Tables whose keys can be swept.
    tables: &'static [&'static str],
    /// A key with its table.
    example: &'static str,
    /// Whether values may have tolerances.
    has_tolerances: bool,
}

/// Keys of the scene of one bearing.
pub(crate) static OF_BEARING: Swept = Swept {
    short_names: &SHORT_NAMES,
    tables: SWEPT,
    example: "\"ends.pressure\" or \"feed.GROUP.pressure\"",
    has_tolerances: false,
};
/// Keys that are set to other values, tolerances included.
pub(super) static OF_CHANGES: Swept = Swept { has_tolerances: true, ..OF_BEARING };
/// Keys of the scene of a crankshaft.
pub(crate) static OF_SHAFT: Swept = Swept {
    short_names: &SHAFT_SHORT_NAMES,
    tables: &SWEPT_OF_SHAFT,
    example: "\"crankshaft.youngs_modulus\" or \"crank.reciprocating_mass\"",
    has_tolerances: false,
};

/// The sweep of a scene `text` that stands at `path`, which the table describes.
pub(crate) fn plan(table: TableReader<'_>, swept: &Swept, text: &str, path: &Path) -> Plan {
    let (axes, columns) = read(table, swept);
    Plan { axes, columns, draws: None, text: text.to_owned(), path: path.to_owned() }
}

/// Reads the table: its axes in the order of the text, and the columns that it asks for, if any.
pub(super) fn read(mut table: TableReader<'_>, swept: &Swept) -> (Vec<SweepAxis>, Option<Vec<WantedColumn>>) {
    let mut axes = Vec::new();
    if table.is_readable() && table.keys().iter().all(|key| *key == column::KEY) {
        table.complain_here("names no axis", format!("write for example {EXAMPLE}"));
    }
    let columns = column::read(&mut table);
    read_table(table, "", swept, &mut axes);
    (axes, columns)
}

/// Reads a table of axes whose names begin with `prefix`.
pub(crate) fn read_table(mut table: TableReader<'_>, prefix: &str, swept: &Swept, axes: &mut Vec<SweepAxis>) {
    for key in table.keys() {
        let name = format!("{prefix}{key}");
        if name == column::KEY {
            continue;
        }
        let Some(written) = table.written(key) else { continue };
        if axes.len() > MOST_AXES || cases(axes) > MOST_CASES {
            continue;
        }
        let values = match written.get_ref() {
            DeValue::Table(inner) if !is_range(inner) => {
                if let Some(inner) = table.table_if_given(key) {
                    read_table(inner, &format!("{name}."), swept, axes);
                }
                continue;
            }
            DeValue::Table(_) => table.table_if_given(key).and_then(|range| read_range(range, key)),
            DeValue::Array(list) => read_list(&table, key, list, swept),
            other => {
                let message = format!("a list or a range of values is wanted, not {}", kind(other));
                table.complain(key, message, format!("write for example {EXAMPLE}"));
                None
            }
        };
        if let (Some(path), Some((unit, values))) = (path(&table, key, &name, swept), values) {
            let span = written.span();
            let axis = SweepAxis { name, path, unit, values, span };
            add(&table, key, axes, axis);
        }
    }
}

/// Number of cases of all combinations.
fn cases(axes: &[SweepAxis]) -> usize {
    (axes.iter()).fold(1, |cases, axis| cases.saturating_mul(axis.values.len()))
}

/// Adds an axis, unless its key of the scene has one already; a sweep has limits.
fn add(table: &TableReader<'_>, key: &str, axes: &mut Vec<SweepAxis>, axis: SweepAxis) {
    if let Some(other) = axes.iter().find(|other| other.path == axis.path) {
        let message = format!("is the same key of the scene as {}", other.name);
        return table.complain(key, message, "remove one of the two");
    }
    axes.push(axis);
    table.refuse_if(
        axes.len() > MOST_AXES,
        key,
        format!("is the axis after the {MOST_AXES}th, and no sweep has more"),
        "split the sweep into several scenes",
    );
    table.refuse_if(
        cases(axes) > MOST_CASES,
        key,
        format!("makes {} cases, more than {MOST_CASES}", cases(axes)),
        "give fewer values, or split the sweep into several scenes",
    );
}

/// A table is a range unless all in it are lists and tables: these are axes whose names go on.
fn is_range(table: &toml::de::DeTable<'_>) -> bool {
    let mut values = table.iter().map(|(_, value)| value.get_ref());
    table.is_empty() || values.any(|value| !(value.is_array() || value.is_table()))
}

/// Place of the key in the scene.
fn path(table: &TableReader<'_>, key: &str, name: &str, swept: &Swept) -> Option<String> {
    let head = name.split('.').next().unwrap_or_default();
    if name.contains('.') {
        if swept.tables.contains(&head) {
            return Some(name.to_owned());
        }
        let near = nearest(head, swept.tables.iter().copied())
            .map_or(String::new(), |near| format!("did you mean \"{near}\"? "));
        let message = format!("begins with \"{head}\", which is no table of a scene");
        table.complain(key, message, format!("{near}Tables: {}", swept.tables.join(", ")));
        return None;
    }
    if let Some((_, path)) = swept.short_names.iter().find(|(short, _)| *short == name) {
        return Some((*path).to_owned());
    }
    let names: Vec<&str> = swept.short_names.iter().map(|(short, _)| *short).collect();
    let help = match nearest(name, names.iter().copied()) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("short names: {}; any other key with its table, as {}", names.join(", "), swept.example),
    };
    table.complain(key, "this key is not known as an axis", help);
    None
}

type ReadValues = (String, Vec<AxisValue>);

/// Values that are listed; all in one unit.
fn read_list(table: &TableReader<'_>, key: &str, list: &[Spanned<DeValue<'_>>], swept: &Swept) -> Option<ReadValues> {
    let mut unit: Option<String> = None;
    let mut values = Vec::new();
    for item in list {
        if !swept.has_tolerances && written_tolerance(item.get_ref()).is_some() {
            refuse_tolerance(table, key);
            return None;
        }
        let Some((own, value)) = read_value(item.get_ref()) else {
            let message = format!("{} is no value of an axis", kind(item.get_ref()));
            table.complain(key, message, format!("write for example {EXAMPLE}"));
            return None;
        };
        if unit.as_ref().is_some_and(|unit| *unit != own) {
            let message = format!("has values in {} and in {}", of_unit(unit.as_deref()), of_unit(Some(&own)));
            table.complain(key, message, "write all values of an axis in one unit");
            return None;
        }
        unit = Some(own);
        values.push(value);
    }
    if values.is_empty() {
        table.complain(key, "has no values", format!("write for example {EXAMPLE}"));
        return None;
    }
    Some((unit.unwrap_or_default(), values))
}

fn of_unit(unit: Option<&str>) -> String {
    match unit {
        None | Some("") => "no unit".to_owned(),
        Some(unit) => unit.to_owned(),
    }
}

/// Complains about a value of an axis that has a tolerance.
fn refuse_tolerance(table: &TableReader<'_>, key: &str) {
    let help = "give one number; the tolerance stands at the key itself, and draws are made by --draws";
    table.complain(key, "has a value with a tolerance, but an axis takes its values as they are", help);
}

/// A value and its unit.
fn read_value(value: &DeValue<'_>) -> Option<(String, AxisValue)> {
    if let Some(number) = plain_number(value) {
        return Some((String::new(), AxisValue::Number(number)));
    }
    let text = value.as_str()?;
    Some(match unit::split(text) {
        Some((number, unit)) => (unit.to_owned(), AxisValue::Number(number)),
        None => (String::new(), AxisValue::Word(text.to_owned())),
    })
}

/// How the values of a range are spaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Spacing {
    Linear,
    Log,
}

/// `steps` values from one to the other, both included.
fn read_range(mut range: TableReader<'_>, name: &str) -> Option<ReadValues> {
    ["from", "to", "steps"].into_iter().for_each(|key| range.require(key));
    let [from, to] = ["from", "to"].map(|end| {
        let written = range.written(end)?;
        if written_tolerance(written.get_ref()).is_some() {
            refuse_tolerance(&range, end);
            return None;
        }
        match read_value(written.get_ref()) {
            Some((unit, AxisValue::Number(number))) => Some((unit, number)),
            _ => {
                let help = format!("write for example {name} = {{ from = \"1 kN\", to = \"5 kN\", steps = 9 }}");
                range.complain(end, "is no number, with its unit where it has one", help);
                None
            }
        }
    });
    let steps = range.number("steps").given();
    let spacings = [("linear", Spacing::Linear), ("log", Spacing::Log)];
    let spacing = range.word("spacing", &spacings).unwrap_or(Spacing::Linear);
    values(&range, from, to, steps, spacing)
}

fn values(
    range: &TableReader<'_>,
    from: Option<(String, f64)>,
    to: Option<(String, f64)>,
    steps: Option<f64>,
    spacing: Spacing,
) -> Option<ReadValues> {
    let ((unit, from), (other, to), steps) = (from?, to?, steps.filter(|steps| steps.is_finite())?);
    if unit != other {
        let message = format!("is in {}, but from in {}", of_unit(Some(&other)), of_unit(Some(&unit)));
        range.complain("to", message, "write both in one unit");
        return None;
    }
    if steps.fract() != 0.0 || !(2.0..=MOST_CASES as f64).contains(&steps) {
        let message = format!("is not a whole number from 2 to {MOST_CASES}");
        range.complain("steps", message, "it is the number of values, both ends included");
        return None;
    }
    if spacing == Spacing::Log && from * to <= 0.0 {
        let help = "give both ends the same sign and none zero, or remove spacing";
        range.complain("spacing", "goes through zero", help);
        return None;
    }
    let last = steps as usize - 1;
    let at = |k: usize| {
        let part = k as f64 / last as f64;
        match (k, spacing) {
            (0, _) => from,
            (k, _) if k == last => to,
            (_, Spacing::Linear) => decimal(from + part * (to - from)),
            (_, Spacing::Log) => decimal(from * (to / from).powf(part)),
        }
    };
    Some((unit, (0..=last).map(|k| AxisValue::Number(at(k))).collect()))
}

/// The number to twelve digits, so that a range of tenths has tenths.
fn decimal(number: f64) -> f64 {
    format!("{number:.11e}").parse().unwrap_or(number)
}
