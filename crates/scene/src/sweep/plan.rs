//! The cases of a sweep: all combinations of the values of its axes, the last axis running fastest.

use std::borrow::Cow;
use std::ops::Range;
use std::path::{Path, PathBuf};

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::axis::{AxisValue, BEARING, SweepAxis};
use super::column::WantedColumn;
use super::draws::{DRAW, DrawOptions, Draws, fixed};
use crate::complaint::in_order;
use crate::mesh::no_file;
use crate::{Check, Complaint, KeyTolerance, Scene, SceneError, ShaftScene};

/// How many complaints about cases are reported.
const MOST_COMPLAINTS: usize = 5;

/// The sweep of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The axes, in the order of the text; that of the draws comes last.
    pub axes: Vec<SweepAxis>,
    /// The columns of its table that are asked for; `None` for the usual ones.
    pub columns: Option<Vec<WantedColumn>>,
    /// What is drawn for each place on the last axis; `None`: nothing is.
    pub draws: Option<Draws>,
    /// Text of the scene.
    pub text: String,
    /// Path of the scene.
    pub path: PathBuf,
}

impl Plan {
    /// Number of cases.
    pub fn cases(&self) -> usize {
        self.axes.iter().map(|axis| axis.values.len()).product()
    }

    /// Values that an axis has more than once, as `speed = 3000 rpm`, with how often.
    pub fn repeated(&self) -> Vec<(String, usize)> {
        let of_axis = |axis: &SweepAxis| {
            let count = |value: &AxisValue| axis.values.iter().filter(|other| *other == value).count();
            let values = axis.values.iter().enumerate();
            let first = values.filter(|(index, value)| !axis.values[..*index].contains(value));
            let repeated = first.filter(|(_, value)| count(value) > 1);
            let told = repeated.map(|(index, value)| (format!("{} = {}", axis.name, axis.told(index)), count(value)));
            told.collect::<Vec<_>>()
        };
        self.axes.iter().flat_map(of_axis).collect()
    }

    /// Place of the value that case `number` (from 0) has on each axis.
    pub fn indices(&self, mut number: usize) -> Vec<usize> {
        let mut indices = vec![0; self.axes.len()];
        for (index, axis) in indices.iter_mut().zip(&self.axes).rev() {
            *index = number % axis.values.len();
            number /= axis.values.len();
        }
        indices
    }

    /// The scene of every case: the text of the scene with the keys of the axes replaced, read and checked as any
    /// other.
    ///
    /// # Errors
    /// Everything that is wrong with a case, with its axis and value.
    pub fn scenes(&self, checks: &[Check]) -> Result<Vec<Scene>, SceneError> {
        self.read(|document| Scene::of_document(document, &self.text, &self.path, no_file, checks))
    }

    /// The scene of every case of a crankshaft, as [`Self::scenes`].
    ///
    /// # Errors
    /// Everything that is wrong with a case, with its axis and value.
    pub fn shafts(&self) -> Result<Vec<ShaftScene>, SceneError> {
        self.read(|document| ShaftScene::of_document(document, &self.text, &self.path, no_file))
    }

    /// This plan with one more axis, the bearings of a crankshaft by their names: each of them is a case.
    #[must_use]
    pub fn with_bearings(&self, names: Vec<String>) -> Self {
        let (name, path) = BEARING;
        let mut plan = self.clone();
        plan.axes.push(SweepAxis {
            name: name.to_owned(),
            path: path.to_owned(),
            unit: String::new(),
            values: names.into_iter().map(AxisValue::Word).collect(),
            span: 0..0,
        });
        plan
    }

    /// The sweep of a scene, with or without axes, in which tolerances are drawn at each of its points. A key that is
    /// an axis is not drawn. `None` where nothing is left to draw.
    pub fn drawn(scene: &Scene, options: DrawOptions) -> Option<Self> {
        let mut plan = scene.sweep.clone().unwrap_or_else(|| Self {
            axes: Vec::new(),
            columns: None,
            draws: None,
            text: scene.text.clone(),
            path: scene.path.clone(),
        });
        let is_axis = |input: &&KeyTolerance| plan.axes.iter().any(|axis| axis.path == input.key);
        let inputs: Vec<_> = scene.tolerances.iter().filter(|input| !is_axis(input)).cloned().collect();
        let draws = Some(Draws { options, inputs }).filter(|draws| !draws.inputs.is_empty())?;
        plan.axes.push(draws.axis());
        plan.draws = Some(draws);
        Some(plan)
    }

    /// What is set in case `number` (from 0), by name: the values of its axes, then what is drawn.
    pub fn inputs(&self, number: usize) -> Vec<(&str, AxisValue)> {
        let indices = self.indices(number);
        let axes = self.axes.iter().zip(&indices);
        let mut inputs: Vec<_> = axes.map(|(axis, &index)| (axis.name.as_str(), axis.values[index].clone())).collect();
        if let (Some(draws), Some(&draw)) = (&self.draws, indices.last()) {
            let drawn = draws.axes(draw).into_iter().flat_map(|axis| axis.values);
            inputs.extend(draws.inputs.iter().map(|input| input.key.as_str()).zip(drawn));
        }
        inputs
    }

    /// Headings of the columns of [`Self::inputs`].
    pub fn input_headings(&self) -> Vec<String> {
        let drawn = self.draws.iter().flat_map(|draws| &draws.inputs).map(|input| fixed(input, input.nominal));
        self.axes.iter().map(SweepAxis::heading).chain(drawn.map(|axis| axis.heading())).collect()
    }

    /// The scene of every case, which `of_case` makes of its document.
    fn read<S>(&self, of_case: impl Fn(&DeTable<'_>) -> Result<S, Vec<Complaint>>) -> Result<Vec<S>, SceneError> {
        let mut complaints: Vec<Complaint> = Vec::new();
        let mut scenes = Vec::with_capacity(self.cases());
        for number in 0..self.cases() {
            match self.case(&self.indices(number), &of_case) {
                Ok(scene) => scenes.push(scene),
                Err(found) => {
                    for complaint in found {
                        let is_new = complaints
                            .iter()
                            .all(|other| (&other.key, &other.message) != (&complaint.key, &complaint.message));
                        if is_new {
                            complaints.push(complaint);
                        }
                    }
                    if complaints.len() >= MOST_COMPLAINTS {
                        complaints.truncate(MOST_COMPLAINTS);
                        break;
                    }
                }
            }
        }
        match complaints.is_empty() {
            true => Ok(scenes),
            false => Err(SceneError::Complaints {
                path: self.path.clone(),
                text: self.text.clone(),
                complaints: in_order(complaints),
            }),
        }
    }

    /// The scene with these values of the axes.
    fn case<S>(
        &self,
        indices: &[usize],
        of_case: impl Fn(&DeTable<'_>) -> Result<S, Vec<Complaint>>,
    ) -> Result<S, Vec<Complaint>> {
        let (mut document, _) = DeTable::parse_recoverable(&self.text);
        let document = document.get_mut();
        document.remove("sweep");
        document.remove("design");
        let draw = indices.last().copied().unwrap_or_default();
        let drawn = self.draws.as_ref().map_or_else(Vec::new, |draws| draws.axes(draw));
        let swept = self.axes.iter().zip(indices.iter().copied()).filter(|(axis, _)| axis.path != DRAW);
        let set: Vec<(&SweepAxis, usize)> = swept.chain(drawn.iter().map(|axis| (axis, 0))).collect();
        let numbers: Vec<String> = (set.iter())
            .map(|(axis, index)| match &axis.values[*index] {
                AxisValue::Number(number) if axis.unit.is_empty() => format!("{number:?}"),
                _ => String::new(),
            })
            .collect();
        for (&(axis, index), number) in set.iter().zip(&numbers) {
            let value = match &axis.values[index] {
                AxisValue::Number(_) if axis.unit.is_empty() => match DeValue::parse(number) {
                    Ok(value) => value.into_inner(),
                    Err(_) => continue,
                },
                _ => DeValue::String(Cow::Owned(axis.told(index))),
            };
            put(document, axis, value).map_err(|complaint| vec![complaint])?;
        }
        of_case(document).map_err(|complaints| complaints.into_iter().map(|it| self.named(it, indices)).collect())
    }

    /// A complaint about a case as one about the axis it comes from, or about all of them where it comes from none
    /// alone.
    fn named(&self, complaint: Complaint, indices: &[usize]) -> Complaint {
        let axis = (self.axes.iter().zip(indices)).find(|(axis, _)| Some(&axis.span) == complaint.span.as_ref());
        let told = |(axis, &index): (&SweepAxis, &usize)| format!("{} = {}", axis.name, axis.told(index));
        let (key, value) = match axis {
            Some((axis, index)) => (format!("sweep.{}", axis.name), told((axis, index))),
            None => {
                let all: Vec<String> = self.axes.iter().zip(indices).map(told).collect();
                ("sweep".to_owned(), all.join(", "))
            }
        };
        Complaint {
            message: format!("with {value}, {complaint}"),
            key,
            value,
            help: complaint.help,
            span: complaint.span,
        }
    }
}

/// The scene of a text with other values, in SI, of keys that have tolerances.
///
/// # Errors
/// Everything that is wrong with it.
pub(crate) fn of_values(
    text: &str,
    path: &Path,
    values: &[(&KeyTolerance, f64)],
    checks: &[Check],
) -> Result<Scene, Vec<Complaint>> {
    let axes = values.iter().map(|(input, value)| fixed(input, *value)).collect::<Vec<_>>();
    let indices = vec![0; axes.len()];
    let plan = Plan { axes, columns: None, draws: None, text: text.to_owned(), path: path.to_owned() };
    // Its files are those of the scene, which were looked for when that was read.
    plan.case(&indices, |document| Scene::of_document(document, text, path, |_| None, checks))
}

/// Sets the key of an axis in a scene's document. Tables that are not there are made.
///
/// # Errors
/// The axis names a feed or a shape of the bore that the scene does not have.
pub(super) fn put<'a>(document: &mut DeTable<'a>, axis: &SweepAxis, value: DeValue<'a>) -> Result<(), Complaint> {
    let value = Spanned::new(axis.span.clone(), value);
    let (table, path) = match axis.path.split_once('.') {
        Some(("feed", rest)) => feed(document, rest).ok_or_else(|| no_feed(axis))?,
        Some(("bore", rest)) => (bore(document, rest).ok_or_else(|| no_bore(axis))?, rest),
        _ => (document, axis.path.as_str()),
    };
    set(table, path, &axis.span, value);
    Ok(())
}

fn set<'a>(table: &mut DeTable<'a>, path: &str, span: &Range<usize>, value: Spanned<DeValue<'a>>) {
    let Some((head, rest)) = path.split_once('.') else {
        table.insert(Spanned::new(span.clone(), Cow::Owned(path.to_owned())), value);
        return;
    };
    let key = Spanned::new(span.clone(), Cow::Owned(head.to_owned()));
    let inner = table.entry(key).or_insert_with(|| Spanned::new(span.clone(), DeValue::Table(DeTable::new())));
    match inner.get_mut() {
        DeValue::Table(inner) => set(inner, rest, span, value),
        // What stands there is no table: its reader says so.
        other => *other = value.into_inner(),
    }
}

/// The feed whose group begins `rest`, and the key behind it.
fn feed<'d, 'a, 'r>(document: &'d mut DeTable<'a>, rest: &'r str) -> Option<(&'d mut DeTable<'a>, &'r str)> {
    let DeValue::Array(feeds) = document.get_mut("feed")?.get_mut() else {
        return None;
    };
    feeds.iter_mut().find_map(|feed| {
        let DeValue::Table(feed) = feed.get_mut() else {
            return None;
        };
        let group = feed.get("group")?.get_ref().as_str()?;
        let key = rest.strip_prefix(group)?.strip_prefix('.')?;
        Some((feed, key))
    })
}

/// The one shape of the bore whose key begins `path`.
fn bore<'d, 'a>(document: &'d mut DeTable<'a>, path: &str) -> Option<&'d mut DeTable<'a>> {
    let shape = path.split('.').next()?;
    let DeValue::Array(bores) = document.get_mut("bore")?.get_mut() else {
        return None;
    };
    let mut of_shape = bores.iter_mut().filter_map(|bore| match bore.get_mut() {
        DeValue::Table(bore) if bore.contains_key(shape) => Some(bore),
        _ => None,
    });
    let bore = of_shape.next()?;
    of_shape.next().is_none().then_some(bore)
}

fn no_bore(axis: &SweepAxis) -> Complaint {
    Complaint {
        key: format!("sweep.{}", axis.name),
        value: String::new(),
        message: "names no shape that exactly one [[bore]] of the scene has".to_owned(),
        help:
            "write the shape and its key, as \"bore.crown\" or \"bore.worn.depth\"; of two shapes alike none is swept"
                .to_owned(),
        span: Some(axis.span.clone()),
    }
}

fn no_feed(axis: &SweepAxis) -> Complaint {
    Complaint {
        key: format!("sweep.{}", axis.name),
        value: String::new(),
        message: "names no [[feed]] of the scene and a key of it".to_owned(),
        help: "write its group and its key, as \"feed.feed_hole.pressure\"".to_owned(),
        span: Some(axis.span.clone()),
    }
}
