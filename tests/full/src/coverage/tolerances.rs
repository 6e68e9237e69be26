//! Tolerances asked for, what the bar became, how wrong the load is, and how many unknowns it would have taken.

use std::time::Instant;

use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::refinement::{Answer, answer};
use oilwedge_study::run_options::RunOptions;

use super::bearings::Bearing;
use super::meshes::{Kind, Solve, graded_film, sized};
use super::reference::Reference;
use oilwedge_tests::scenes::{path, table};

/// Tolerances of the load [1].
pub const TOLERANCES: [f64; 3] = [5e-3, 1e-3, 1e-4];
/// Unknowns of the coarsest mesh, and their growth from mesh to mesh, where the unknowns needed are sought.
const LEAST: f64 = 80.0;
const GROWTH: f64 = 1.35;
/// Most meshes sought.
const MOST: i32 = 16;

/// An answer to a tolerance.
#[derive(Debug, Clone)]
pub struct Met {
    /// Name of the bearing.
    pub bearing: String,
    /// Model of cavitation.
    pub model: &'static str,
    /// Tolerance asked for [1].
    pub asked: f64,
    /// Bar of the load relative to it; none where it is missing.
    pub bar: Option<f64>,
    /// True error of the load relative to it.
    pub error: f64,
    /// True if the program says that the tolerance is met.
    pub claimed: bool,
    /// Unknowns of the last mesh.
    pub unknowns: usize,
    /// Least unknowns of a uniform sequence of drawn meshes from which on the true error stays below the tolerance.
    pub needed: Option<usize>,
    /// Seconds it took.
    pub seconds: f64,
}

/// The answers to all [`TOLERANCES`].
pub fn met(bearing: &Bearing, reference: &Reference) -> Vec<Met> {
    let Some(known) = reference.known.iter().find(|known| known.name == "load") else {
        return Vec::new();
    };
    let relative = |load: f64| (load / known.value - 1.0).abs();
    let errors: Vec<(usize, f64)> = (0..MOST)
        .filter_map(|k| {
            let study = graded_film(&sized(bearing, LEAST * GROWTH.powi(k))).ok()?;
            let solve = Solve::new(&study, Kind::Drawn).ok()?;
            let load = solve.judged.quantities.iter().find(|quantity| quantity.name == "load")?;
            Some((solve.unknowns, relative(load.value)))
        })
        .collect();
    let one = |asked: f64| {
        let last_bad = errors.iter().rposition(|(_, error)| *error > asked);
        let needed = errors.get(last_bad.map_or(0, |k| k + 1)).map(|(unknowns, _)| *unknowns);
        let clock = Instant::now();
        let Answer { film, outcome, limit, .. } =
            answer(&compile(&tolerant(bearing, asked)).ok()?, &RunOptions::default()).ok()?;
        let (_, judged) = outcome.ok()?;
        let load = judged.quantities.iter().find(|quantity| quantity.name == "load")?;
        Some(Met {
            bearing: bearing.name.clone(),
            model: bearing.model,
            asked,
            bar: load.error().map(|bar| bar / load.value),
            error: relative(load.value),
            claimed: limit.is_none(),
            unknowns: film.unknowns(),
            needed,
            seconds: clock.elapsed().as_secs_f64(),
        })
    };
    TOLERANCES.into_iter().filter_map(one).collect()
}

/// The scene of a bearing with a tolerance and no size.
fn tolerant(bearing: &Bearing, asked: f64) -> Scene {
    let mut scene = bearing.table.clone();
    let mesh = table(&mut scene, "mesh");
    mesh.remove("size");
    mesh.insert("tolerance".into(), format!("{} %", 100.0 * asked).into());
    oilwedge_study::parse(&scene.to_string(), &path("written"))
        .unwrap_or_else(|error| panic!("{}: {error}", bearing.name))
}
