//! Quantities as an object of JSON by their names: a module for `serde(with)`. Names that the catalogue of this version
//! of the program does not have are left out.

use std::collections::BTreeMap;

use oilwedge_reynolds::error_bar::Bar;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::in_order;
use crate::quantities::{Quantity, QuantitySpread, Sensitivity, row};

/// The entry of a quantity.
#[derive(Serialize, Deserialize)]
struct Entry {
    #[serde(skip_deserializing)]
    symbol: &'static str,
    value: f64,
    #[serde(skip_deserializing)]
    unit: &'static str,
    #[serde(default)]
    error: Option<f64>,
    #[serde(default)]
    error_parts: Option<Parts>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spread: Option<QuantitySpread>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    sensitivity: BTreeMap<String, Sensitivity>,
}

/// Parts of a bar by their names.
#[derive(Serialize, Deserialize)]
struct Parts(#[serde(with = "PartsOfBar")] Bar);

/// The fields of [`Bar`].
#[derive(Default, Serialize, Deserialize)]
#[serde(remote = "Bar", default)]
struct PartsOfBar {
    discretisation: f64,
    front: f64,
    transport: f64,
    geometry: f64,
    nonlinear: f64,
    algebra: f64,
    position: f64,
    wall: f64,
    temperature: f64,
    time: f64,
}

pub(crate) fn serialize<S: Serializer>(quantities: &[Quantity], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(quantities.iter().map(|quantity| {
        let entry = Entry {
            symbol: quantity.row.symbol,
            value: quantity.value,
            unit: quantity.unit(),
            error: quantity.error(),
            error_parts: quantity.bar.map(Parts),
            spread: quantity.spread.clone(),
            sensitivity: quantity.sensitivity.clone(),
        };
        (&quantity.name, entry)
    }))
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Quantity>, D::Error> {
    let entries: Vec<(String, Entry)> = in_order::deserialize(deserializer)?;
    let quantity = |(name, entry): (String, Entry)| {
        let bar = entry.error_parts.map(|Parts(bar)| bar).or(entry.error.map(Bar::of));
        let Entry { value, spread, sensitivity, .. } = entry;
        Some(Quantity { row: row(&name)?, name: name.into(), value, bar, spread, sensitivity })
    };
    Ok(entries.into_iter().filter_map(quantity).collect())
}
