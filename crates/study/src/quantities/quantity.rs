//! A reported number.

use std::borrow::Cow;
use std::collections::BTreeMap;

use oilwedge_reynolds::error_bar::Bar;

use super::row::Row;
use super::spread::{QuantitySpread, Sensitivity};

/// One reported number.
#[derive(Debug, Clone, PartialEq)]
pub struct Quantity {
    /// Row of the quantity in the catalogue.
    pub row: &'static Row,
    /// Name of the quantity, as `load` or `feed_flow.feed_hole`: the key in `quantities`.
    pub name: Cow<'static, str>,
    /// The value in the unit of its row.
    pub value: f64,
    /// Error bar of the quantity; `None` where it is not estimated or not resolved.
    pub bar: Option<Bar>,
    /// What the tolerances of the scene make of it; `None` where it has none.
    pub spread: Option<QuantitySpread>,
    /// Derivatives by the keys that have tolerances.
    pub sensitivity: BTreeMap<String, Sensitivity>,
}

impl Quantity {
    /// A number without an error bar.
    pub fn new(row: &'static Row, value: f64) -> Self {
        Self::named(row, row.name.into(), value)
    }

    /// A member of a family without an error bar.
    pub fn of_region(row: &'static Row, region: &str, value: f64) -> Self {
        Self::named(row, row.region_name(region), value)
    }

    fn named(row: &'static Row, name: Cow<'static, str>, value: f64) -> Self {
        Self { row, name, value, bar: None, spread: None, sensitivity: BTreeMap::new() }
    }

    /// Name of the region of a member of a family; else empty.
    pub fn region(&self) -> &str {
        &self.name[self.row.name.len()..]
    }

    /// Unit, as it is written.
    pub fn unit(&self) -> &'static str {
        self.row.unit.name()
    }

    /// Half width of the error bar in the unit of the value.
    pub fn error(&self) -> Option<f64> {
        self.bar.map(|bar| bar.total())
    }

    /// Gives it a bar, or says that there is none: one that is not finite is none.
    pub fn set_bar(&mut self, bar: Option<Bar>) {
        self.bar = bar.filter(|bar| bar.total().is_finite());
    }
}
