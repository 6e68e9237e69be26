//! The number of one key: its dimension, an example, its range, and what counts where it is not written.

use std::f64::consts::TAU;

use toml::de::DeValue;

use super::{TableReader, kind};
use crate::keys::Form;
use crate::unit::{self, Dimension};

/// A number without a unit is zero, or at least this.
const LEAST: f64 = 1e-25;
/// A number without a unit is at most this, so that products and powers of such numbers are numbers.
const MOST: f64 = 1e15;
/// Angles beyond so many turns have lost their digits.
const MOST_TURNS: f64 = 1e6;

/// The number of a key: in SI, NaN where it was refused, none where it is not written.
#[must_use]
pub(crate) struct Number<'t, 'a> {
    table: &'t mut TableReader<'a>,
    key: &'a str,
    /// A value as one would write it.
    example: String,
    value: Option<f64>,
}

impl<'a> TableReader<'a> {
    /// A number with a unit of this dimension; `example` is one.
    pub(crate) fn quantity(&mut self, key: &'a str, dimension: Dimension, example: &str) -> Number<'_, 'a> {
        self.note(key, Form::Quantity(dimension), example);
        let value = self.take(key).map(|value| self.in_si(key, value, dimension, example));
        Number { key, example: format!("\"{example}\""), value, table: self }
    }

    /// A number with a unit that must be written.
    pub(crate) fn required(&mut self, key: &'a str, dimension: Dimension, example: &str) -> f64 {
        self.quantity(key, dimension, example).required()
    }

    /// A number with a unit, if it is written.
    pub(crate) fn given(&mut self, key: &'a str, dimension: Dimension, example: &str) -> Option<f64> {
        self.quantity(key, dimension, example).given()
    }

    /// A number with a unit and above zero that must be written.
    pub(crate) fn positive(&mut self, key: &'a str, dimension: Dimension, example: &str) -> f64 {
        self.quantity(key, dimension, example).positive().required()
    }

    /// A number with a unit and above zero, if it is written.
    pub(crate) fn positive_if_given(&mut self, key: &'a str, dimension: Dimension, example: &str) -> Option<f64> {
        self.quantity(key, dimension, example).positive().given()
    }

    /// A number without a unit; `example` is one.
    pub(crate) fn number(&mut self, key: &'a str, example: &str) -> Number<'_, 'a> {
        self.note(key, Form::Number, example);
        let value = self.take(key).map(|value| {
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
        });
        Number { key, example: example.to_owned(), value, table: self }
    }

    /// A number without a unit, or several in a list, if there are any; `example` is one of them.
    pub(crate) fn numbers(&mut self, key: &'a str, example: &str) -> Option<Vec<f64>> {
        self.note(key, Form::Number, example);
        self.note(key, Form::Numbers, example);
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
    /// The number if it is above zero; else a complaint.
    pub(crate) fn positive(self) -> Self {
        self.within(|value| value > 0.0, "is not positive", "give a value above zero")
    }

    /// The number if `holds`; else a complaint.
    pub(crate) fn within(self, holds: impl Fn(f64) -> bool, message: &str, help: &str) -> Self {
        self.within_or(holds, |_| message.to_owned(), help)
    }

    /// The number if `holds`; else a complaint with a `message` about the value.
    pub(crate) fn within_or(
        mut self,
        holds: impl Fn(f64) -> bool,
        message: impl FnOnce(f64) -> String,
        help: &str,
    ) -> Self {
        if let Some(value) = self.value.filter(|value| !value.is_nan() && !holds(*value)) {
            self.table.complain(self.key, message(value), help);
            self.value = Some(f64::NAN);
        }
        self
    }

    /// The number, which must be written.
    pub(crate) fn required(self) -> f64 {
        self.table.require(self.key, &self.example);
        self.or(f64::NAN)
    }

    /// The number, or this one where it is not written.
    pub(crate) fn or(self, default: f64) -> f64 {
        self.value.unwrap_or(default)
    }

    /// The number, if it is written.
    pub(crate) fn given(self) -> Option<f64> {
        self.value
    }
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
