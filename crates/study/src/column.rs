//! A column of a table: a quantity, and the unit in which it is written.

use std::borrow::Cow;

use oilwedge_scene::Scene;
use oilwedge_scene::spelling::nearest;
use oilwedge_scene::sweep::WantedColumn;
use oilwedge_scene::unit::{Dimension, unit_size};

use crate::quantities::{CATALOGUE, Row, Unit, row};
use crate::scope::Scope;

/// A quantity and its unit.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Name of the quantity, as `feed_flow.hole`.
    pub quantity: Cow<'static, str>,
    /// Row of the column in the catalogue.
    pub row: &'static Row,
    /// How the column is called.
    pub name: Cow<'static, str>,
    /// Unit of the column, as it is written.
    pub unit: String,
    /// Size of that unit and its zero, both in the unit of the row.
    scale: [f64; 2],
}

/// Why there is no such column, and what to write instead.
pub type Fault = (String, String);

impl Column {
    /// The quantity in its own unit.
    pub fn of(quantity: Cow<'static, str>, row: &'static Row) -> Self {
        Self { name: quantity.clone(), quantity, row, unit: row.unit.name().to_owned(), scale: [1.0, 0.0] }
    }

    /// The column that is asked for.
    ///
    /// # Errors
    /// There is no such quantity, or it has no such unit.
    pub fn wanted(wanted: &WantedColumn, scope: &Scope) -> Result<Self, Fault> {
        let (quantity, row) = named(&wanted.name, scope)?;
        let own = match &*wanted.unit {
            "" => Self::of(quantity, row),
            unit => Self::in_unit(quantity, row, unit)?,
        };
        Ok(Self { name: wanted.name.clone().into(), ..own })
    }

    /// The column that a sweep asks for: that of the first scene that has it, else why the first one has not. `None`
    /// without a scene.
    pub fn wanted_in(scenes: &[Scene], wanted: &WantedColumn) -> Option<Result<Self, Fault>> {
        let found = scenes.iter().find_map(|scene| Self::wanted(wanted, &Scope::of(scene)).ok());
        let first = || Some(Self::wanted(wanted, &Scope::of(scenes.first()?)));
        found.map(Ok).or_else(first)
    }

    /// The quantity in another unit.
    ///
    /// # Errors
    /// It has no such unit.
    pub fn in_unit(quantity: Cow<'static, str>, row: &'static Row, unit: &str) -> Result<Self, Fault> {
        Ok(Self { scale: scale(unit, row.unit)?, unit: unit.to_owned(), ..Self::of(quantity, row) })
    }

    /// A value of the quantity in the unit of the column.
    pub fn value(&self, value: f64) -> f64 {
        let [size, zero] = self.scale;
        (value - zero) / size
    }

    /// A value in the unit of the column in that of the quantity.
    pub fn own(&self, value: f64) -> f64 {
        let [size, zero] = self.scale;
        value * size + zero
    }

    /// The half width of an error bar in the unit of the column.
    pub fn error(&self, error: f64) -> f64 {
        error / self.scale[0]
    }

    /// Heading of the column: `h_min [um]`.
    pub fn heading(&self) -> String {
        format!("{} [{}]", self.name, self.unit)
    }

    /// Heading of the column of its error.
    pub fn error_heading(&self) -> String {
        format!("{} error [{}]", self.name, self.unit)
    }
}

/// The quantity of this name or symbol.
fn named(name: &str, scope: &Scope) -> Result<(Cow<'static, str>, &'static Row), Fault> {
    let single =
        || CATALOGUE.iter().copied().filter(|row| !row.is_family() && row.is_of_cycle() == scope.orbit.is_some());
    if let Some(row) = row(name) {
        let region = &name[row.name.len()..];
        if !row.is_family() || scope.groups.iter().any(|group| group == region) {
            return Ok((name.to_owned().into(), row));
        }
        let help = match scope.groups.is_empty() {
            true => "leave it out, or give a [[feed]] of this group".to_owned(),
            false => format!("groups of feeds: {}", scope.groups.join(", ")),
        };
        return Err((format!("\"{name}\" names no feed of the scene"), help));
    }
    if let Some(row) = single().find(|row| row.symbol == name) {
        return Ok((row.name.into(), row));
    }
    let names: Vec<&str> = single().flat_map(|row| [row.name, row.symbol]).collect();
    let help = match nearest(name, names) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => {
            let known: Vec<&str> = single().map(|row| row.name).collect();
            format!("known here: {}, feed_flow.GROUP, or their symbols", known.join(", "))
        }
    };
    Err((format!("\"{name}\" is no quantity"), help))
}

/// Size and zero of a unit, in that of the quantity.
fn scale(unit: &str, own: Unit) -> Result<[f64; 2], Fault> {
    let dimension = own.scene_dimension();
    let refused = |error: oilwedge_scene::unit::UnitError| (error.to_string(), error.help(dimension.example()));
    let size = unit_size(unit, dimension).map_err(refused)?;
    let of_own = unit_size(own.name(), dimension).unwrap_or(1.0);
    let zero = |unit: &str| Dimension::zero(dimension, unit);
    Ok([size / of_own, (zero(unit) - zero(own.name())) / of_own])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::{FILM_THICKNESS_MIN, MIN_FILM_ANGLE, TEMPERATURE_EFFECTIVE};

    #[test]
    fn values_are_converted() {
        let column = |row: &'static Row, unit: &str| Column::in_unit(row.name.into(), row, unit).expect("a unit");
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-9 * b.abs(), "{a} {b}");
        close(column(&FILM_THICKNESS_MIN, "um").value(3.5e-6), 3.5);
        close(column(&FILM_THICKNESS_MIN, "um").error(1e-7), 0.1);
        close(column(&FILM_THICKNESS_MIN, "um").own(3.5), 3.5e-6);
        close(column(&TEMPERATURE_EFFECTIVE, "F").own(212.0), 100.0);
        close(column(&TEMPERATURE_EFFECTIVE, "F").value(100.0), 212.0);
        close(column(&TEMPERATURE_EFFECTIVE, "F").error(10.0), 18.0);
        close(column(&TEMPERATURE_EFFECTIVE, "K").value(100.0), 373.15);
        close(column(&MIN_FILM_ANGLE, "rad").value(180.0), std::f64::consts::PI);
        assert!(scale("bar", FILM_THICKNESS_MIN.unit).is_err());
    }
}
