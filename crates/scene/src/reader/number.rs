//! The number of one key, with dimension, example and range of its row, and what counts where it is not written.

use std::f64::consts::TAU;

use toml::de::DeValue;

use super::{TableReader, kind};
use crate::KeyTolerance;
use crate::bounds::{Bounds, usual};
use crate::key_tolerance::WrittenTolerance;
use crate::keys::Key;
use crate::unit::{self, Dimension};

/// A number without a unit is zero, or at least this.
const LEAST: f64 = 1e-25;
/// A number without a unit is at most this, so that products and powers of such numbers are numbers.
const MOST: f64 = 1e15;
/// Angles beyond so many turns have lost their digits.
const MOST_TURNS: f64 = 1e6;

/// The number of a key: in SI, NaN where it was refused, none where it is not written.
///
/// Its range is that of the row of the key. Where nothing else is said about it, a number that must be positive and is
/// not is refused.
#[must_use]
pub(crate) struct Number<'t, 'a> {
    table: &'t mut TableReader<'a>,
    key: &'a str,
    value: Option<f64>,
    /// The number with its tolerance, of width zero where it is written without one; none of keys that may have none.
    input: Option<KeyTolerance>,
    is_checked: bool,
}

impl<'a> TableReader<'a> {
    /// The number of a key, with a unit where its row has a dimension.
    pub(crate) fn number(&mut self, key: &'a str) -> Number<'_, 'a> {
        let row = self.row(key);
        let is_bare = self.peek(key).is_some_and(|it| matches!(it.get_ref(), DeValue::Integer(_) | DeValue::Float(_)));
        let dimension = row.and_then(Key::dimension).filter(|_| !(is_bare && row.is_some_and(Key::is_plain)));
        let mut input = None;
        let value = self.take(key).map(|value| match (written_tolerance(value).zip(row), dimension) {
            (Some((written, row)), _) => {
                input = self.toleranced(key, written, row, dimension);
                input.as_ref().map_or(f64::NAN, |tolerance| tolerance.nominal)
            }
            (None, dimension) => {
                let number = match dimension {
                    Some(dimension) => self.in_si(key, value, dimension, self.example(key)),
                    None => self.plain(key, value, &row.map(Key::written_example).unwrap_or_default()),
                };
                let (span, written) = (self.peek(key).map_or(0..0, |value| value.span()), value.as_str());
                let exact = row.and_then(|row| KeyTolerance::exact(row, (number, written), dimension));
                input = exact.map(|input| KeyTolerance { key: self.key(key), span, ..input });
                number
            }
        });
        Number { key, value, input, table: self, is_checked: false }
    }

    /// The number of a key with its tolerance; `None` where it was refused.
    fn toleranced(
        &self,
        key: &str,
        written: WrittenTolerance<'_>,
        row: &Key,
        dimension: Option<Dimension>,
    ) -> Option<KeyTolerance> {
        match written.read(row, dimension) {
            Ok(tolerance) => {
                let span = self.peek(key).map_or(0..0, |value| value.span());
                Some(KeyTolerance { key: self.key(key), span, ..tolerance })
            }
            Err([message, help]) => {
                self.complain(key, message, help);
                None
            }
        }
    }

    /// The numbers that the row of a key accepts.
    pub(crate) fn bounds(&self, key: &str) -> Bounds {
        self.row(key).map_or(Bounds::ALL, Bounds::of)
    }

    /// A number that must be written.
    pub(crate) fn required(&mut self, key: &'a str) -> f64 {
        self.number(key).required()
    }

    /// A number, if it is written.
    pub(crate) fn given(&mut self, key: &'a str) -> Option<f64> {
        self.number(key).given()
    }

    fn plain(&self, key: &str, value: &DeValue<'_>, example: &str) -> f64 {
        let number = plain_number(value);
        if !matches!(value, DeValue::Integer(_) | DeValue::Float(_)) {
            let message = format!("a plain number is wanted, not {}", kind(value));
            let help = format!("write {key} = {example}, without quotes and unit");
            self.complain(key, message, help);
        } else if number.is_none() {
            let help = format!("write for example {key} = {example}");
            self.complain(key, "is not a finite number", help);
        } else if number.is_some_and(is_out_of_range) {
            let help = format!("check the exponent, and write for example {key} = {example}");
            let message = format!("is out of range: zero, or from {LEAST:.0e} to {MOST:.0e}, is wanted");
            self.complain(key, message, help);
        }
        number.filter(|number| !is_out_of_range(*number)).unwrap_or(f64::NAN)
    }

    /// A number without a unit, or several in a list, if there are any.
    pub(crate) fn numbers(&mut self, key: &'a str) -> Option<Vec<f64>> {
        let example = self.example(key);
        let value = self.take(key)?;
        let numbers: Option<Vec<f64>> = match value {
            DeValue::Array(list) => list.iter().map(|item| plain_number(item.get_ref())).collect(),
            single => plain_number(single).map(|number| vec![number]),
        };
        let numbers = numbers.filter(|numbers| !numbers.is_empty());
        if numbers.is_none() {
            let wanted = "a plain number or a list of them is wanted";
            let message = match value {
                DeValue::Array(_) => wanted.to_owned(),
                other => format!("{wanted}, not {}", kind(other)),
            };
            let help = format!("write {key} = {example} or {key} = [{example}], without quotes and units");
            self.complain(key, message, help);
        }
        numbers
    }

    fn in_si(&self, key: &str, value: &DeValue<'_>, dimension: Dimension, example: &str) -> f64 {
        let write = format!("write {key} = \"{example}\"");
        let (message, help) = match value {
            DeValue::String(text) => match unit::parse(text, dimension) {
                Ok(value) if dimension == Dimension::Angle && value.abs() > MOST_TURNS * TAU => (
                    format!("is more than {MOST_TURNS} turns, too many to resolve the angle"),
                    "give an angle from 0 to 360 deg".to_owned(),
                ),
                Ok(value) => return value,
                Err(error) => (error.to_string(), error.help(example)),
            },
            DeValue::Integer(_) | DeValue::Float(_) => (
                format!("a bare number has no unit; {} is wanted", dimension.name()),
                format!("{write} (a text with a unit: {})", dimension.unit_names()),
            ),
            other => (format!("{} is wanted, not {}", dimension.name(), kind(other)), write),
        };
        self.complain(key, message, help);
        f64::NAN
    }
}

impl Number<'_, '_> {
    /// The number if the row of its key accepts it; else a complaint.
    pub(crate) fn within(self, message: &str, help: &str) -> Self {
        self.within_or(|_, _| message.to_owned(), help)
    }

    /// The number if the row of its key accepts it; else a complaint with a `message` about the value and the least and
    /// the greatest that are accepted.
    pub(crate) fn within_or(self, message: impl FnOnce(f64, [f64; 2]) -> String, help: &str) -> Self {
        let bounds = self.table.bounds(self.key);
        self.which_or(|value| bounds.hold(value), |value| message(value, bounds.ends), help)
    }

    /// The number if it is above zero; else a complaint.
    pub(crate) fn positive(self) -> Self {
        self.which(|value| value > 0.0, "is not positive", "give a value above zero")
    }

    /// The number if `holds`; else a complaint.
    pub(crate) fn which(self, holds: impl Fn(f64) -> bool, message: &str, help: &str) -> Self {
        self.which_or(holds, |_| message.to_owned(), help)
    }

    /// The number if `holds`; else a complaint with a `message` about the value.
    pub(crate) fn which_or(
        mut self,
        holds: impl Fn(f64) -> bool,
        message: impl FnOnce(f64) -> String,
        help: &str,
    ) -> Self {
        self.is_checked = true;
        let ends = self.input.as_ref().map(KeyTolerance::ends);
        if let Some(value) = self.value.filter(|value| !value.is_nan() && !holds(*value)) {
            self.table.complain(self.key, message(value), help);
            self.value = Some(f64::NAN);
        } else if let Some(end) = ends.into_iter().flatten().find(|end| !holds(*end)) {
            self.table.complain(self.key, format!("at an end of its tolerance {}", message(end)), help);
            self.value = Some(f64::NAN);
        }
        self
    }

    /// The number, which must be written.
    pub(crate) fn required(self) -> f64 {
        self.table.require(self.key);
        self.or(f64::NAN)
    }

    /// The number, or that which counts by its row where it is not written.
    pub(crate) fn or_usual(self) -> f64 {
        let usual = self.table.row(self.key).and_then(usual);
        self.or(usual.unwrap_or(f64::NAN))
    }

    /// The number, or this one where it is not written.
    pub(crate) fn or(self, default: f64) -> f64 {
        self.given().unwrap_or(default)
    }

    /// The number, if it is written.
    pub(crate) fn given(self) -> Option<f64> {
        if !self.is_checked && self.table.bounds(self.key).are_positive() {
            return self.positive().given();
        }
        if let Some(input) = self.input.filter(|_| self.value.is_some_and(|value| !value.is_nan())) {
            self.table.complaints.borrow_mut().inputs.push(input);
        }
        self.value
    }
}

/// The tolerance that a value is, if it is one.
pub(crate) fn written_tolerance<'t>(value: &'t DeValue<'_>) -> Option<WrittenTolerance<'t>> {
    WrittenTolerance::of(value.as_str()?)
}

fn is_out_of_range(number: f64) -> bool {
    number != 0.0 && !(LEAST..=MOST).contains(&number.abs())
}

/// The finite number that a value without quotes is.
pub(crate) fn plain_number(value: &DeValue<'_>) -> Option<f64> {
    let number: Option<f64> = match value {
        DeValue::Integer(digits) if digits.radix() == 10 => digits.as_str().parse().ok(),
        DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix()).ok().map(|value| value as f64),
        DeValue::Float(digits) => digits.as_str().parse().ok(),
        _ => None,
    };
    number.filter(|number| number.is_finite())
}
