//! `[design]`: numbers that `oilwedge design` may choose, and what they shall make least or greatest. No other command
//! uses it.

use std::ops::Range;
use std::path::Path;

use toml::de::{DeTable, DeValue};

use crate::reader::TableReader;
use crate::sweep::{AxisValue, OF_BEARING, SweepAxis, WantedColumn, of_values, read_table};
use crate::unit;
use crate::{Check, Complaint, Complaints, KeyTolerance, Scene, SceneError};

keys! {
    "design" = Table; "", "nothing is chosen", "",
        "what `oilwedge design` chooses, and for what; the limits are those of `[criteria]`, and all other commands ignore the table";
    "design.free" = Table; "", "required", "",
        "keys whose numbers are chosen, each with two bounds; the search starts from the number in the scene";
    "design.free.KEY" = Values; "20 um", "the number of the scene", "two numbers, a key named as an axis of a sweep",
        "least and greatest number of a key, `[\"20 um\", \"40 um\"]`";
    "design.choose" = Table; "", "nothing is listed", "",
        "keys with a list of values, as words and whole numbers: the free keys are chosen for each combination of them";
    "design.choose.KEY" = Values; "2 bar", "the value of the scene", "a key named as an axis of a sweep",
        "the values of a key, as those of an axis of a sweep";
    "design.minimise" = Text; "friction_power", "required unless `maximise`", "a quantity of the scene",
        "quantity that shall be least";
    "design.maximise" = Text; "load", "required unless `minimise`", "a quantity of the scene",
        "quantity that shall be greatest";
    "design.spread" = Switch; "true", "`false`", "",
        "whether the criteria must be met within all tolerances: by their numbers less the worst case of their spread";
}

/// Most combinations of listed values.
const MOST_COMBINATIONS: usize = 1000;
/// Numbers this much beyond a bound, over its width, lie on it.
const ROUND_OFF: f64 = 1e-9;
/// Digits of numbers that are put into a text.
const DIGITS: usize = 15;

/// What a design makes of its objective.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DesignSense {
    /// Least.
    Minimise,
    /// Greatest.
    Maximise,
}

impl DesignSense {
    /// Name of the key.
    pub fn name(self) -> &'static str {
        match self {
            Self::Minimise => "minimise",
            Self::Maximise => "maximise",
        }
    }
}

/// What is chosen, and for what.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Keys with two bounds each.
    pub free: Vec<SweepAxis>,
    /// Keys with listed values.
    pub choices: Vec<SweepAxis>,
    /// The quantity that is made least or greatest.
    pub objective: WantedColumn,
    /// Which of both.
    pub sense: DesignSense,
    /// Whether the tolerances count in the criteria.
    pub spread: bool,
}

/// A number that is chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct FreeKey {
    /// The key and its number in the scene.
    pub input: KeyTolerance,
    /// Least and greatest number, in SI.
    pub bounds: [f64; 2],
}

pub(crate) fn read(mut table: TableReader<'_>) -> Option<Design> {
    let [free, choices] = ["free", "choose"].map(|key| {
        let mut axes = Vec::new();
        if let Some(table) = table.table_if_given(key) {
            read_table(table, "", &OF_BEARING, &mut axes);
        }
        axes
    });
    let spread = table.switch("spread").unwrap_or(false);
    let senses = [DesignSense::Minimise, DesignSense::Maximise];
    let named = senses.map(|sense| {
        let text = table.text_if_given(sense.name())?;
        let span = table.written(sense.name())?.span();
        Some((WantedColumn { name: text, unit: String::new(), span }, sense))
    });
    if !table.has("free") && table.is_readable() {
        let help = "write free = { \"bearing.clearance\" = [\"20 um\", \"40 um\"] }";
        table.complain_here("has nothing that is free", help);
    }
    match named {
        [Some(_), Some(_)] => {
            table.complain("maximise", "stands beside minimise", "keep one of them");
            None
        }
        [None, None] if !senses.iter().any(|sense| table.has(sense.name())) => {
            table.complain_here("has no objective", "write minimise = \"friction_power\" or maximise = \"load\"");
            None
        }
        [one, other] => one.or(other).map(|(objective, sense)| Design { free, choices, objective, sense, spread }),
    }
}

/// The free keys of a design are numbers of the scene between their bounds, and the listed keys stand in it.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    let Some(design) = &scene.design else { return };
    for axis in &design.free {
        if let Err([message, help]) = free_key(scene, axis) {
            complaints.add(&format!("design.free.{}", axis.name), message, help);
        }
    }
    let combinations = design.choices.iter().fold(1usize, |count, axis| count.saturating_mul(axis.values.len()));
    complaints.refuse_if(
        combinations > MOST_COMBINATIONS,
        "design.choose",
        format!("makes {combinations} combinations, more than {MOST_COMBINATIONS}"),
        "list fewer values",
    );
}

/// The free key that an axis means.
///
/// # Errors
/// What is wrong with it, and the way out.
fn free_key(scene: &Scene, axis: &SweepAxis) -> Result<FreeKey, [String; 2]> {
    let said = |message: &str, help: &str| [message.to_owned(), help.to_owned()];
    let input = scene.inputs.iter().find(|input| input.key == axis.path).ok_or_else(|| {
        let help = match axis.path.starts_with("feed.") {
            true => "give the key its number in the scene, and name the feed by its group, as feed.GROUP.pressure",
            false => {
                "give the key its number in the scene, from which the search starts; whole numbers and words are listed in [design] choose"
            }
        };
        said("is no number that stands in this scene", help)
    })?;
    let [AxisValue::Number(least), AxisValue::Number(most)] = axis.values[..] else {
        return Err(said("has no two bounds", "give the least and the greatest number, as [\"20 um\", \"40 um\"]"));
    };
    if least >= most {
        let help = format!("write [{}, {}] with the lesser number first", axis.told(1), axis.told(0));
        return Err([format!("has its bounds reversed: {} is not below {}", axis.told(0), axis.told(1)), help]);
    }
    let bound = |index: usize| match input.dimension {
        Some(dimension) if !axis.unit.is_empty() => unit::parse(&axis.told(index), dimension)
            .map_err(|error| [error.to_string(), error.help(dimension.example())]),
        Some(dimension) if !input.unit.is_empty() => Err([
            format!("has bounds without a unit; {} is wanted", dimension.name()),
            format!("write [\"{least} {}\", \"{most} {}\"]", input.unit, input.unit),
        ]),
        None if !axis.unit.is_empty() => {
            Err(said("has bounds with a unit, but the key has none", "give plain numbers"))
        }
        _ => Ok([least, most][index]),
    };
    let bounds = [bound(0)?, bound(1)?];
    let room = ROUND_OFF * (bounds[1] - bounds[0]);
    if input.nominal < bounds[0] - room || input.nominal > bounds[1] + room {
        let number = format!("{} {}", input.in_unit(input.nominal), input.unit);
        return Err([
            format!("starts from {}, which lies outside of its bounds", number.trim_end()),
            format!("give {} a number between {} and {}, or other bounds", axis.path, axis.told(0), axis.told(1)),
        ]);
    }
    Ok(FreeKey { input: input.clone(), bounds })
}

/// What is wrong with a scene at the bounds of its free keys and with its listed values, one after the other.
pub(crate) fn complaints_at_bounds(scene: &Scene, text: &str, checks: &[Check]) -> Vec<Complaint> {
    let Some(design) = &scene.design else { return Vec::new() };
    let mut found = Vec::new();
    for (free, axis) in scene.free_keys().iter().zip(&design.free) {
        let refused = free.bounds.iter().filter_map(|bound| {
            let faults = of_values(text, &scene.path, &[(&free.input, *bound)], checks).err()?;
            let first = faults.into_iter().next()?;
            let key = format!("design.free.{}", axis.name);
            Some(Complaint { key, span: Some(axis.span.clone()), ..first })
        });
        found.extend(refused.take(1));
    }
    for axis in &design.choices {
        if written_at(text, &axis.path).is_none() {
            found.push(Complaint {
                key: format!("design.choose.{}", axis.name),
                value: String::new(),
                message: "is no key that stands in this scene".to_owned(),
                help: "give the key one of the values in the scene".to_owned(),
                span: Some(axis.span.clone()),
            });
        }
    }
    found
}

impl Scene {
    /// The keys that a design chooses.
    pub fn free_keys(&self) -> Vec<FreeKey> {
        let axes = self.design.iter().flat_map(|design| &design.free);
        axes.filter_map(|axis| free_key(self, axis).ok()).collect()
    }

    /// The text of this scene with other numbers, in SI, of some of its keys; tolerances and comments stay.
    pub fn text_with(&self, values: &[(&KeyTolerance, f64)]) -> String {
        let written = values.iter().map(|(input, value)| (input.span.clone(), written(input, *value)));
        replaced(&self.text, written.collect())
    }

    /// The scenes of all combinations of the listed values, each with the values in words; this scene where nothing is
    /// listed.
    ///
    /// # Errors
    /// Everything that is wrong with one of them.
    pub fn combinations(&self, checks: &[Check]) -> Result<Vec<(Vec<String>, Self)>, SceneError> {
        let axes = self.design.as_ref().map_or(&[][..], |design| &design.choices);
        let count = axes.iter().map(|axis| axis.values.len()).product();
        let mut all = Vec::with_capacity(count);
        for mut number in 0..count {
            let mut edits = Vec::new();
            for axis in axes.iter().rev() {
                let index = number % axis.values.len();
                number /= axis.values.len();
                let value = match &axis.values[index] {
                    AxisValue::Number(value) if axis.unit.is_empty() => value.to_string(),
                    _ => format!("\"{}\"", axis.told(index)),
                };
                edits.extend(written_at(&self.text, &axis.path).map(|span| (span, value, axis.told(index))));
            }
            edits.reverse();
            let words = edits.iter().map(|(_, _, told)| told.clone()).collect();
            let text = replaced(&self.text, edits.into_iter().map(|(span, value, _)| (span, value)).collect());
            all.push((words, Self::parse(&text, &self.path, checks)?));
        }
        Ok(all)
    }
}

/// A number as it stands behind its key, with its tolerance.
fn written(input: &KeyTolerance, value: f64) -> String {
    let short = |number: f64| -> f64 { format!("{number:.*e}", DIGITS - 1).parse().unwrap_or(number) };
    let number = short(input.in_unit(value));
    let half = short(input.half_width / input.unit_size());
    match (input.half_width > 0.0, input.unit.as_str()) {
        (false, "") => format!("{number:?}"),
        (false, unit) => format!("\"{number} {unit}\""),
        (true, "") => format!("\"{number} +- {half}\""),
        (true, unit) => format!("\"{number} {unit} +- {half} {unit}\""),
    }
}

/// A text with other words in some places.
fn replaced(text: &str, mut edits: Vec<(Range<usize>, String)>) -> String {
    edits.sort_by_key(|(span, _)| std::cmp::Reverse(span.start));
    let mut text = text.to_owned();
    edits.into_iter().for_each(|(span, value)| text.replace_range(span, &value));
    text
}

/// Where the value of a key stands in the text of a scene; a feed is named by its group, a shape of the bore by itself.
fn written_at(text: &str, path: &str) -> Option<Range<usize>> {
    let (document, _) = DeTable::parse_recoverable(text);
    let document = document.get_ref();
    let items = |list: &str| document.get(list).and_then(|list| list.get_ref().as_array()).into_iter().flatten();
    match path.split_once('.')? {
        ("feed", rest) => items("feed").find_map(|feed| {
            let table = feed.get_ref().as_table()?;
            let group = table.get("group")?.get_ref().as_str()?;
            below(table, rest.strip_prefix(group)?.strip_prefix('.')?)
        }),
        ("bore", rest) => items("bore").find_map(|bore| below(bore.get_ref().as_table()?, rest)),
        _ => below(document, path),
    }
}

fn below(table: &DeTable<'_>, path: &str) -> Option<Range<usize>> {
    match path.split_once('.') {
        None => table.get(path).map(toml::Spanned::span),
        Some((head, rest)) => match table.get(head)?.get_ref() {
            DeValue::Table(inner) => below(inner, rest),
            _ => None,
        },
    }
}

/// The refusal of a scene that has no design.
pub fn no_design(path: &Path) -> String {
    format!(
        "the scene {} has no [design]; write for example\n\n[design]\nfree = {{ \"bearing.clearance\" = [\"20 um\", \"40 um\"] }}\nminimise = \"friction_power\"",
        path.display()
    )
}
