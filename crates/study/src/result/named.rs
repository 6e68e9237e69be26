//! Quantities as an object of JSON by their names: a module for `serde(with)`. Names that the catalogue of this version
//! of the program does not have are left out.

use oilwedge_reynolds::error_bar::Bar;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::in_order;
use crate::quantities::{Quantity, row};

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
        let (error, error_parts) = (quantity.error(), quantity.bar.map(Parts));
        let entry =
            Entry { symbol: quantity.row.symbol, value: quantity.value, unit: quantity.unit(), error, error_parts };
        (&quantity.name, entry)
    }))
}

pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Quantity>, D::Error> {
    let entries: Vec<(String, Entry)> = in_order::deserialize(deserializer)?;
    let quantity = |(name, entry): (String, Entry)| {
        let bar = entry.error_parts.map(|Parts(bar)| bar).or(entry.error.map(Bar::of));
        Some(Quantity { row: row(&name)?, name: name.into(), value: entry.value, bar })
    };
    Ok(entries.into_iter().filter_map(quantity).collect())
}
