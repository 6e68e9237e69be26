//! An orbit by maps of its film: the short-film map and that of the finite film, beside the orbit of the film itself.

use ciborium::Value;
use oilwedge_scene::Scene;
use oilwedge_study::CompileError;
use oilwedge_study::orbit::{ByMap, OrbitPath, by_maps};
use oilwedge_study::quantities::{
    CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_ANGLE, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, Row,
};
use oilwedge_study::result::RunResult;

use crate::add_on::{AddOn, Alternative, Comparison, nullable, object};

/// The numbers that are compared.
const COMPARED: [&Row; 3] =
    [&CYCLE_FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE, &CYCLE_FILM_THICKNESS_MIN_ANGLE];
/// Part of the time that following the orbit took.
const ORBIT: &str = "orbit";

/// The orbit of a scene by maps, beside that of its film, whose `result` and `path` are given. A map that does not
/// exist has its reason.
///
/// # Errors
/// The scene does not become a film.
pub fn mobility(scene: &Scene, result: &RunResult, path: &OrbitPath) -> Result<AddOn, CompileError> {
    let orbits = by_maps(scene, path)?;
    let direct = (result.timing_s.iter()).find(|(part, _)| part == ORBIT).map_or(0.0, |(_, seconds)| *seconds);
    let found: Vec<&ByMap> = orbits.iter().filter_map(|orbit| orbit.as_ref().ok()).collect();
    let alternatives: Vec<Alternative> = found.iter().map(|orbit| alternative(orbit, result, direct)).collect();
    let records = found.iter().zip(&alternatives).map(|(orbit, it)| record(orbit, it));
    let reasons = orbits.iter().filter_map(|orbit| orbit.as_ref().err());
    Ok(AddOn {
        key: "mobility",
        title: "the orbit by maps of the film (mobility), and in brackets the difference from that of the film"
            .to_owned(),
        film: "film",
        record: Value::Array(records.collect()),
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
        name: format!("{} map", orbit.name),
        comparisons: COMPARED.iter().filter_map(comparison).collect(),
        seconds: Some([direct, orbit.seconds[1]]),
    }
}

fn note(orbit: &ByMap) -> String {
    let map = match orbit.films {
        0 => "closed form".to_owned(),
        films => format!("{films} films in {:.1} s", orbit.seconds[0]),
    };
    format!(
        "{} map: {map}; its orbit is at most {:.1e} of the clearance away, its film differs by at most {:.1e}",
        orbit.name, orbit.distance, orbit.film_difference
    )
}

fn record(orbit: &ByMap, numbers: &Alternative) -> Value {
    let quantities = numbers.comparisons.iter().filter_map(|it| {
        let number = object([
            ("symbol", it.row.symbol.into()),
            ("unit", it.row.unit.name().into()),
            ("value", it.other?.value.into()),
            ("difference", nullable(it.difference())),
        ]);
        Some((it.row.name, number))
    });
    object([
        ("map", orbit.name.into()),
        ("distance", orbit.distance.into()),
        ("film_difference", orbit.film_difference.into()),
        ("films", (orbit.films as u64).into()),
        ("map_seconds", orbit.seconds[0].into()),
        ("orbit_seconds", orbit.seconds[1].into()),
        ("closure", orbit.closure.into()),
        ("quantities", object(quantities)),
    ])
}
