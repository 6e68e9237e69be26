//! What a run of a shaft found, as scripts read it: `result.json` of a crankshaft.

use oilwedge_scene::ShaftScene;
use serde::{Deserialize, Serialize};

use super::compile::CompiledBearing;
use super::deflection::ShaftDeflection;
use super::weights::CounterweightReport;
use crate::limits::design_criteria;
use crate::orbit::{CycleFacts, OrbitPath};
use crate::quantities::{CYCLE_FILM_THICKNESS_MIN, Quantity, Row, TILT_X, TILT_Y};
use crate::result::{Criterion, Geometry, ResultHead, ResultTail, RunResult, named};
use crate::warning::Warning;
use oilwedge_bearing::duty_cycle::DutyCycle;

/// Name and version of the form of `result.json` of a crankshaft.
pub const SHAFT_FORMAT: &str = "oilwedge-crankshaft/1";

/// What a run of a shaft found.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftRun {
    /// The numbers.
    pub result: ShaftResult,
    /// The paths of the journals over the last cycle; none where the loads do not change.
    pub paths: Vec<BearingPath>,
}

/// One journal over the last cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingPath {
    /// Name of its bearing.
    pub name: String,
    /// What its film carries.
    pub load: DutyCycle,
    /// Path of the journal, and its films.
    pub path: OrbitPath,
}

impl ShaftRun {
    /// Least film of all bearings over the cycle [m]; `None` where none was found.
    pub fn least_film(&self) -> Option<f64> {
        let films = self.result.bearings.iter().filter_map(|bearing| bearing.quantity(&CYCLE_FILM_THICKNESS_MIN));
        films.map(|quantity| quantity.value).reduce(f64::min)
    }

    pub(super) fn of(scene: &ShaftScene, bars: bool) -> Self {
        Self { result: ShaftResult::of(scene, bars), paths: Vec::new() }
    }
}

/// Everything that a run of a shaft reports in numbers and words.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ShaftResult {
    /// Scene, program and end of the run.
    #[serde(flatten)]
    pub head: ResultHead,
    /// Whether error bars were asked for.
    pub bars: bool,
    /// The bearings along the axis.
    pub bearings: Vec<BearingReport>,
    /// What is left of the balances of the whole shaft; zero where it is cut.
    pub balances: ShaftBalances,
    /// The shaft as it is bent; `null` where it is cut, or has no answer.
    pub deflection: Option<ShaftDeflection>,
    /// The cycles that were followed; none for a shaft at rest or cut.
    pub cycles: Vec<CycleFacts>,
    /// Counterweights that would serve the bearings better; `null` where they were not sought.
    pub counterweights: Option<CounterweightReport>,
    /// Films solved to find the balance, on the meshes of the result.
    pub films: usize,
    /// Times and warnings.
    #[serde(flatten)]
    pub tail: ResultTail,
}

/// What is left of the balances of a shaft, greatest over a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ShaftBalances {
    /// Loads less forces of all films, over the loads [1].
    pub force: f64,
    /// Sum of the moments of all forces about z = 0, over the moments of the magnitudes of the loads [1].
    pub moment: f64,
    /// What is left of the equations of all journals, over the loads [1].
    pub journals: f64,
    /// Balance of power over a cycle: power of the loads and of what turns the journals, less what the films dissipate
    /// and the shaft stores, over the greatest dissipation [1]; zero at rest. `null` where a film keeps its oil or a
    /// wall gives way: they take up power, too.
    pub power: Option<f64>,
    /// Heat of a film that is not carried off, over its power, greatest of all bearings [1]; zero where temperatures
    /// are given.
    pub thermal: f64,
}

impl Default for ShaftBalances {
    /// Nothing is left.
    fn default() -> Self {
        Self { force: 0.0, moment: 0.0, journals: 0.0, power: Some(0.0), thermal: 0.0 }
    }
}

/// One bearing.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct BearingReport {
    /// How the scene calls it.
    pub name: String,
    /// The file of its scene.
    pub scene: String,
    /// SHA-256 of the text of that scene.
    pub scene_sha256: String,
    /// SHA-256 of its mesh.
    pub mesh_sha256: String,
    /// Axial position of its middle [m].
    pub at: f64,
    /// Unknown pressures on its mesh.
    pub unknowns: usize,
    /// Shape of the bearing, and speed of its journal.
    pub geometry: Geometry,
    /// Greatest displacement of its shell [m], and greatest slope [rad].
    pub shell: [f64; 2],
    /// Greatest slope of the journal against the shell [rad].
    pub tilt_max: f64,
    /// Error bar of the greatest tilt [rad], of a shaft at rest with bars; `null` where there is none.
    pub tilt_max_error: Option<f64>,
    /// Balance of energy over a cycle: what turns the journal and the work of the load, less the heat, over that [1];
    /// `null` for a shaft at rest.
    pub energy: Option<f64>,
    /// What it is judged by, with verdicts: `[criteria]` of its scene.
    pub criteria: Vec<Criterion>,
    /// Quantities of the bearing. At rest their error bars hold the errors of all films of the shaft, over a cycle they
    /// are those of its orbit under the load that it carries; what only the shaft decides has none there.
    #[serde(with = "named")]
    pub quantities: Vec<Quantity>,
}

impl BearingReport {
    /// The report of a bearing at rest, parallel to a shell that does not give way.
    pub(super) fn of(bearing: &CompiledBearing, quantities: Vec<Quantity>, bars: bool) -> Self {
        Self {
            name: bearing.name.clone(),
            scene: bearing.path.display().to_string(),
            scene_sha256: bearing.film.model.description.sha256.clone(),
            mesh_sha256: bearing.film.origin.sha256.clone(),
            at: bearing.at,
            unknowns: bearing.film.unknowns(),
            geometry: Geometry::of(&bearing.film.model),
            criteria: design_criteria(&bearing.film, None, &quantities, bars),
            quantities,
            ..Self::default()
        }
    }

    /// What its warnings begin with, among those of the whole shaft.
    fn part(name: &str) -> String {
        format!("bearing {name}")
    }

    /// The error bar [rad] of the magnitude of the tilt, by those of its parts.
    pub(super) fn tilt_error(&self) -> Option<f64> {
        let [x, y] = [&TILT_X, &TILT_Y].map(|row| self.quantity(row).and_then(Quantity::error));
        Some(x?.hypot(y?))
    }

    /// A quantity.
    pub fn quantity(&self, row: &Row) -> Option<&Quantity> {
        self.quantities.iter().find(|quantity| quantity.name == row.name)
    }
}

/// The numbers of a film whose place and load are found with the shaft. A bar of zero is that of a number that the
/// scene of a single bearing gives, as its position or its load; over a cycle of a shaft both have errors, which are
/// not estimated.
pub(super) fn found_with_shaft(quantities: Vec<Quantity>) -> Vec<Quantity> {
    let bar = |quantity: &Quantity| quantity.bar.filter(|_| quantity.error() != Some(0.0));
    quantities.into_iter().map(|quantity| Quantity { bar: bar(&quantity), ..quantity }).collect()
}

impl ShaftResult {
    /// The warnings about a bearing.
    pub fn warnings_of<'a>(&'a self, bearing: &'a BearingReport) -> impl Iterator<Item = &'a Warning> {
        let part = format!("{}: ", BearingReport::part(&bearing.name));
        self.tail.warnings.iter().filter(move |warning| warning.starts_with(&part))
    }

    /// The shaft as one result, as a film has it: numbers and criteria of all bearings, each with the name of its
    /// bearing.
    pub fn as_one(&self) -> RunResult {
        let numbers = self.bearings.iter().flat_map(|bearing| {
            let named =
                |it: &Quantity| Quantity { name: format!("{}: {}", bearing.name, it.name).into(), ..it.clone() };
            bearing.quantities.iter().map(named)
        });
        let criteria = self.bearings.iter().flat_map(|bearing| {
            let named = |it: &Criterion| Criterion { what: format!("{}: {}", bearing.name, it.what), ..it.clone() };
            bearing.criteria.iter().map(named)
        });
        RunResult {
            head: self.head.clone(),
            quantities: numbers.collect(),
            bars: self.bars,
            criteria: criteria.collect(),
            tail: self.tail.clone(),
            ..RunResult::default()
        }
    }

    /// Adds a bearing and the warnings about it.
    pub(super) fn add(&mut self, bearing: BearingReport, warnings: Vec<Warning>) {
        let part = BearingReport::part(&bearing.name);
        self.tail.warnings.extend(warnings.into_iter().map(|warning| warning.of(&part)));
        self.bearings.push(bearing);
    }

    /// What is known of a run whatever its outcome.
    pub(super) fn of(scene: &ShaftScene, bars: bool) -> Self {
        Self { head: ResultHead::of(SHAFT_FORMAT, [&scene.title, &scene.text, &scene.sha256]), bars, ..Self::default() }
    }
}
