//! What can be compared with a film on request, each by a name: the film without each effect, the standard, other
//! theories, maps of the film.

use std::sync::Arc;

use oilwedge_scene::Scene;
use oilwedge_study::CompileError;
use oilwedge_study::model::Model;
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_LOAD_MAX, CYCLE_PRESSURE_MAX, FILM_THICKNESS_MIN, LOAD, PRESSURE_MAX, Row,
};
use oilwedge_study::result::RunResult;
use oilwedge_study::run::Run;
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::shaft::{BearingReport, ShaftResult, Variant};

use crate::comparison::{Alternative, Comparison, QuantityPair, pairs};
use crate::records::Records;
use crate::{cost, mobility, standard, theories};

/// One kind of comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compare {
    /// The film without each of its effects.
    Cost,
    /// The bearing by ISO 7902.
    Standard,
    /// The film of a short and of a long bearing.
    Theories,
    /// The orbit by maps of the film.
    Mobility,
}

impl Compare {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Cost, Self::Standard, Self::Theories, Self::Mobility];

    /// Name of the kind, as arguments have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cost => "cost",
            Self::Standard => "standard",
            Self::Theories => "theories",
            Self::Mobility => "mobility",
        }
    }

    /// What is solved for it.
    pub fn task(self) -> &'static str {
        match self {
            Self::Cost => "the film without each effect",
            Self::Standard => "the bearing by the standard",
            Self::Theories => "the film of a short and of a long bearing",
            Self::Mobility => "the orbit by maps of the film",
        }
    }

    /// Solves what is compared with the `run` of a scene and its model with these options, and adds it to the records.
    ///
    /// # Errors
    /// The scene does not become a film. That there is no film to compare with is no error.
    pub fn solve(
        self,
        (scene, model): (&Scene, &Arc<Model>),
        options: &RunOptions,
        run: &Run,
        records: &mut Records,
    ) -> Result<(), CompileError> {
        let result = &run.result;
        match self {
            Self::Cost => records.cost = Some(cost::records(scene, options, result)?),
            Self::Standard => records.standard = Some(standard::record(scene, result)),
            Self::Theories => records.theories = Some(theories::record(scene, options, result)),
            Self::Mobility => {
                if let Some(path) = &run.orbit {
                    let (maps, missing) = mobility::records(model, result, path)?;
                    (records.mobility, records.missing_maps) = (Some(maps), missing);
                }
            }
        }
        Ok(())
    }
}

/// The tables of all records beside the film of the `result`.
pub fn comparisons(records: &Records, result: &RunResult) -> Vec<Comparison> {
    let maps = records.mobility.as_ref().map(|maps| mobility::comparison(maps, &records.missing_maps, result));
    let tables = [
        records.cost.as_ref().map(|costs| cost::comparison(costs, result)),
        records.standard.as_ref().map(standard::comparison),
        records.theories.as_ref().map(theories::comparison),
        maps,
    ];
    tables.into_iter().flatten().collect()
}

/// Quantities of the bearings of two shafts that are compared, at rest or over a cycle.
const OF_BEARINGS: [&Row; 6] =
    [&LOAD, &FILM_THICKNESS_MIN, &PRESSURE_MAX, &CYCLE_LOAD_MAX, &CYCLE_FILM_THICKNESS_MIN, &CYCLE_PRESSURE_MAX];

/// The table of a shaft beside that of the scene, bearing by bearing.
pub fn shafts(own: &ShaftResult, variant: Variant, other: &ShaftResult) -> Comparison {
    let of_bearing = |(own, other): (&BearingReport, &BearingReport)| {
        let named = |it: QuantityPair| QuantityPair { name: format!("{}: {}", own.name, it.name), ..it };
        pairs(&OF_BEARINGS, &own.quantities, &other.quantities).into_iter().map(named).collect::<Vec<_>>()
    };
    let pairs = own.bearings.iter().zip(&other.bearings).flat_map(of_bearing).collect();
    let reason = other.head.reason.iter().map(|reason| format!("Of {}: {reason}", variant.words()));
    let note = "A shaft cut at its bearings gives each of them what statics gives, and no tilt.";
    let note = (variant == Variant::Cut).then(|| note.to_owned());
    Comparison {
        title: format!("beside {}", variant.words()),
        film: "this shaft".to_owned(),
        alternatives: vec![Alternative { name: variant.name().to_owned(), pairs, seconds: None }],
        lists: Vec::new(),
        notes: reason.chain(note).collect(),
    }
}
