//! An orbit by maps of its film: the short-film map and that of the finite film, beside the orbit of the film itself.

use std::sync::Arc;

use oilwedge_study::CompileError;
use oilwedge_study::model::Model;
use oilwedge_study::orbit::{OrbitPath, by_maps};
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_ANGLE, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, Row,
};
use oilwedge_study::result::RunResult;

use crate::comparison::{Alternative, Comparison, pairs};
use crate::records::{MapRecord, read_back, recorded};

/// The numbers that are compared.
const COMPARED: [&Row; 3] =
    [&CYCLE_FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, &CYCLE_FILM_THICKNESS_MIN_ANGLE];
/// Part of the time that following the orbit took.
const ORBIT: &str = "orbit";

/// The orbit of a model by maps, beside that of its film, whose `result` and `path` are given, and the reasons of the
/// maps that lead to no orbit.
pub(crate) fn records(
    model: &Arc<Model>,
    result: &RunResult,
    path: &OrbitPath,
) -> Result<(Vec<MapRecord>, Vec<String>), CompileError> {
    let (mut maps, mut missing) = (Vec::new(), Vec::new());
    for orbit in by_maps(model, path)? {
        match orbit {
            Ok(orbit) => maps.push(MapRecord {
                quantities: recorded(&pairs(&COMPARED, &result.quantities, &orbit.quantities)),
                orbit,
            }),
            Err(reason) => missing.push(reason),
        }
    }
    Ok((maps, missing))
}

/// The table of the orbits by maps.
pub(crate) fn comparison(maps: &[MapRecord], missing: &[String], result: &RunResult) -> Comparison {
    let direct = result.tail.seconds(ORBIT);
    let alternative = |it: &MapRecord| Alternative {
        name: format!("{} map", it.orbit.map),
        pairs: pairs(&COMPARED, &result.quantities, &read_back(&it.quantities, &result.quantities)),
        seconds: Some([direct, it.orbit.orbit_seconds]),
    };
    let reasons = missing.iter().map(|reason| format!("no map: {reason}"));
    Comparison {
        title: "the orbit by maps of the film (mobility), and in brackets the difference from that of the film"
            .to_owned(),
        film: "film".to_owned(),
        alternatives: maps.iter().map(alternative).collect(),
        lists: Vec::new(),
        notes: maps.iter().map(note).chain(reasons).collect(),
    }
}

fn note(MapRecord { orbit, .. }: &MapRecord) -> String {
    let map = match orbit.films {
        0 => "closed form".to_owned(),
        films => format!("{films} films in {:.1} s", orbit.map_seconds),
    };
    format!(
        "{} map: {map}; its orbit is at most {:.1e} of the clearance away, its film differs by at most {:.1e}",
        orbit.map, orbit.distance, orbit.film_difference
    )
}
