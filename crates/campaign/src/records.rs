//! What is compared with a film, as `result.json` has it.

use oilwedge_study::orbit::ByMap;
use oilwedge_study::quantities::{Bar, Quantity, row};
use oilwedge_study::result::{Status, in_order};
use serde::{Deserialize, Serialize};

use crate::comparison::QuantityPair;
use crate::design::DesignRecord;

/// The records in the result file; what was not asked for is absent.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Records {
    /// The film without each effect.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cost: Option<Vec<CostRecord>>,
    /// The numbers of the standard.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub standard: Option<StandardRecord>,
    /// The films of short and long bearings.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theories: Option<TheoriesRecord>,
    /// The orbits by maps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mobility: Option<Vec<MapRecord>>,
    /// What a design has found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub design: Option<DesignRecord>,
    /// Why maps lead to no orbit; not in JSON.
    #[serde(skip)]
    pub missing_maps: Vec<String>,
}

/// Numbers of one quantity in the result file, in its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecordedPair<T> {
    /// Symbol of the quantity.
    pub symbol: String,
    /// Unit of the number.
    pub unit: String,
    /// The numbers.
    #[serde(flatten)]
    pub numbers: T,
}

/// Numbers of a pair in the result file.
pub(crate) trait PairNumbers: Sized {
    /// The numbers of a pair; `None` where it has none.
    fn of(pair: &QuantityPair) -> Option<Self>;

    /// Value and error of the other answer, beside a film with this error.
    fn other(&self, film: Option<f64>) -> Option<(f64, Option<f64>)>;
}

/// The numbers of pairs by the names of their quantities.
pub(crate) fn recorded<T: PairNumbers>(pairs: &[QuantityPair]) -> Vec<(String, RecordedPair<T>)> {
    let entry = |it: &QuantityPair| {
        let (symbol, unit) = (it.row.symbol.to_owned(), it.row.unit.name().to_owned());
        Some((it.name.clone(), RecordedPair { symbol, unit, numbers: T::of(it)? }))
    };
    pairs.iter().filter_map(entry).collect()
}

/// The quantities of the other answer, beside the film with these `quantities`.
pub(crate) fn read_back<T: PairNumbers>(recorded: &[(String, RecordedPair<T>)], film: &[Quantity]) -> Vec<Quantity> {
    let quantity = |(name, it): &(String, RecordedPair<T>)| {
        let error = film.iter().find(|own| own.name == *name).and_then(Quantity::error);
        let (value, error) = it.numbers.other(error)?;
        Some(Quantity { bar: error.map(Bar::of), ..named(name, value)? })
    };
    recorded.iter().filter_map(quantity).collect()
}

/// A quantity by its name; `None` where this version does not know it.
pub(crate) fn named(name: &str, value: f64) -> Option<Quantity> {
    Some(Quantity { name: name.to_owned().into(), ..Quantity::new(row(name)?, value) })
}

/// What an effect changes, in the result file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CostRecord {
    /// Name of the effect.
    pub effect: String,
    /// What stands in its place.
    pub instead: String,
    /// How the run without it ended.
    pub status: Status,
    /// Why there is no film without it.
    pub reason: Option<String>,
    /// By name of quantity; an object in JSON.
    #[serde(with = "in_order")]
    pub changes: Vec<(String, RecordedPair<Change>)>,
    /// Whether nothing changes beyond the error bars; `null` where that is not known.
    pub could_be_left_out: Option<bool>,
    /// Wall time with all effects [s].
    pub seconds_with: f64,
    /// Wall time without this one [s].
    pub seconds_without: f64,
}

/// A quantity with and without an effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// The value with all effects.
    pub with: Option<f64>,
    /// The value without this one.
    pub without: Option<f64>,
    /// The former less the latter.
    pub change: Option<f64>,
    /// Sum of both bars.
    pub error: Option<f64>,
}

impl PairNumbers for Change {
    fn of(pair: &QuantityPair) -> Option<Self> {
        let [with, without] = pair.values();
        let change = with.zip(without).map(|(with, without)| pair.row.difference(with, without));
        Some(Self { with, without, change, error: pair.error() })
    }

    fn other(&self, film: Option<f64>) -> Option<(f64, Option<f64>)> {
        Some((self.without?, self.error.zip(film).map(|(sum, film)| sum - film)))
    }
}

/// Short, full and long film in the result file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TheoriesRecord {
    /// B/D [1].
    pub slenderness: f64,
    /// What all three films are without.
    pub without: Vec<String>,
    /// The short, the full and the long film.
    pub films: Vec<FilmRecord>,
}

/// The film of one theory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FilmRecord {
    /// `short`, `full` or `long`.
    pub theory: String,
    /// How its run ended.
    pub status: Status,
    /// Why there is no film, or none that has converged.
    pub reason: Option<String>,
    /// Angle [deg] of the film start that a long ring was given, where the scene has none.
    pub film_start_deg: Option<f64>,
    /// By name; an object in JSON.
    #[serde(with = "in_order")]
    pub quantities: Vec<(String, RecordedPair<TheoryNumber>)>,
}

/// A quantity of the film of a theory.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TheoryNumber {
    /// The value.
    pub value: f64,
    /// Error bar of the number.
    pub error: Option<f64>,
    /// The value less that of the full film.
    pub difference: Option<f64>,
}

impl PairNumbers for TheoryNumber {
    fn of(pair: &QuantityPair) -> Option<Self> {
        let other = pair.other.as_ref()?;
        Some(Self { value: other.value, error: other.error(), difference: pair.difference() })
    }

    fn other(&self, _: Option<f64>) -> Option<(f64, Option<f64>)> {
        Some((self.value, self.error))
    }
}

/// The numbers of the standard, in the result file.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct StandardRecord {
    /// What both are given: `load` or `eccentricity`.
    pub given: Option<String>,
    /// Viscosity of both [Pa.s].
    pub viscosity: f64,
    /// The feed as the standard names it.
    pub feed: Option<String>,
    /// Q_3, what the narrowing film squeezes out [m3/s].
    pub squeezed_flow: Option<f64>,
    /// Q_p, what the pressure of the feed presses through [m3/s].
    pub pressed_flow: Option<f64>,
    /// Numbers of the theory beside those of the film.
    pub numbers: Vec<StandardNumber>,
    /// Balance of heat of the standard itself.
    #[serde(rename = "heat")]
    pub balance: Option<OwnBalance>,
    /// Differences of the assumptions, in sentences.
    pub notes: Vec<String>,
}

/// A number of the standard beside that of the film, in its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StandardNumber {
    /// Name of the quantity.
    pub quantity: String,
    /// Unit of the number.
    pub unit: String,
    /// The value of the standard.
    pub standard: f64,
    /// The value of the film.
    pub film: f64,
    /// The bar of the film's value.
    pub error: Option<f64>,
    /// The standard's value less that of the film.
    pub difference: f64,
}

/// Numbers of the standard's own balance of heat by their names; an object in JSON.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct OwnBalance(#[serde(with = "in_order")] pub Vec<(String, f64)>);

/// The orbit by one map, in the result file.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapRecord {
    /// Path of the journal, and the effort that it took.
    #[serde(flatten)]
    pub orbit: ByMap,
    /// By name; an object in JSON.
    #[serde(with = "in_order")]
    pub quantities: Vec<(String, RecordedPair<MapNumber>)>,
}

/// A quantity of an orbit by a map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapNumber {
    /// The value.
    pub value: f64,
    /// The value less that of the film.
    pub difference: Option<f64>,
}

impl PairNumbers for MapNumber {
    fn of(pair: &QuantityPair) -> Option<Self> {
        Some(Self { value: pair.other.as_ref()?.value, difference: pair.difference() })
    }

    fn other(&self, _: Option<f64>) -> Option<(f64, Option<f64>)> {
        Some((self.value, None))
    }
}
