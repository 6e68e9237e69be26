//! An orbit by maps of its film: the short-film map and that of the finite film, beside the orbit of the film itself.

use std::sync::Arc;

use oilwedge_study::CompileError;
use oilwedge_study::model::Model;
use oilwedge_study::orbit::{ByMap, OrbitPath, by_maps};
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_ANGLE, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, Row,
};
use oilwedge_study::result::RunResult;

use crate::add_on::{AddOn, Alternative, Comparison, by_name};
use crate::records::{MapNumber, MapRecord, Records};

/// The numbers that are compared.
const COMPARED: [&Row; 3] =
    [&CYCLE_FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, &CYCLE_FILM_THICKNESS_MIN_ANGLE];
/// Part of the time that following the orbit took.
const ORBIT: &str = "orbit";

/// The orbit of a model by maps, beside that of its film, whose `result` and `path` are given. A map that does not
/// exist has its reason.
///
/// # Errors
/// The model does not become a film.
pub fn mobility(model: &Arc<Model>, result: &RunResult, path: &OrbitPath) -> Result<AddOn, CompileError> {
    let orbits = by_maps(model, path)?;
    let direct = (result.timing_s.iter()).find(|(part, _)| part == ORBIT).map_or(0.0, |(_, seconds)| *seconds);
    let found: Vec<&ByMap> = orbits.iter().filter_map(|orbit| orbit.as_ref().ok()).collect();
    let alternatives: Vec<Alternative> = found.iter().map(|orbit| alternative(orbit, result, direct)).collect();
    let records = found.iter().zip(&alternatives).map(|(orbit, it)| record(orbit, it));
    let reasons = orbits.iter().filter_map(|orbit| orbit.as_ref().err());
    Ok(AddOn {
        title: "the orbit by maps of the film (mobility), and in brackets the difference from that of the film"
            .to_owned(),
        film: "film",
        record: Records { mobility: Some(records.collect()), ..Records::default() },
        alternatives,
        lists: Vec::new(),
        notes: found.iter().map(|orbit| note(orbit)).chain(reasons.map(|reason| format!("no map: {reason}"))).collect(),
    })
}

fn alternative(orbit: &ByMap, result: &RunResult, direct: f64) -> Alternative {
    let comparison = |row: &&'static Row| {
        let other = orbit.quantities.iter().find(|quantity| quantity.row == *row);
        Comparison::between(result.quantity(row), other)
    };
    Alternative {
        name: format!("{} map", orbit.map),
        comparisons: COMPARED.iter().filter_map(comparison).collect(),
        seconds: Some([direct, orbit.orbit_seconds]),
    }
}

fn note(orbit: &ByMap) -> String {
    let map = match orbit.films {
        0 => "closed form".to_owned(),
        films => format!("{films} films in {:.1} s", orbit.map_seconds),
    };
    format!(
        "{} map: {map}; its orbit is at most {:.1e} of the clearance away, its film differs by at most {:.1e}",
        orbit.map, orbit.distance, orbit.film_difference
    )
}

fn record(orbit: &ByMap, numbers: &Alternative) -> MapRecord {
    let number = |it: &Comparison| Some(MapNumber { value: it.other?.value, difference: it.difference() });
    MapRecord { orbit: orbit.clone(), quantities: by_name(&numbers.comparisons, number) }
}
