//! A crankshaft on the films of all its bearings: its scene and those of its bearings compiled, solved, and measured
//! bearing by bearing.
//!
//! | file | what |
//! |---|---|
//! | `shaft/compile.rs` | the scenes become films, a shaft and its loads |
//! | `shaft/statics.rs` | the shaft at rest under loads that do not change |
//! | `shaft/cycle.rs` | the shaft over a cycle of its throws |
//! | `shaft/temperatures.rs` | the temperatures of its films |
//! | `shaft/balances.rs` | force, moment and power at each of its steps |
//! | `shaft/deflection.rs` | the shaft as it is bent |
//! | `shaft/variant.rs` | the same shaft cut, or with other counterweights, beside it |
//! | `shaft/weights.rs` | where counterweights serve the bearings best |
//! | `shaft/result.rs` | what was found, as scripts read it |
//! | `shaft/error.rs` | why a scene does not become a shaft |
//!
//! **Source.** `docs/theory/crankshaft.md`.

mod balances;
mod compile;
mod cycle;
mod deflection;
mod error;
mod result;
mod statics;
mod temperatures;
mod variant;
mod weights;

pub use compile::{Compiled, CompiledBearing, bearing_scenes, compile_shaft, engine};
pub use deflection::ShaftDeflection;
pub use error::ShaftError;
pub use result::{BearingPath, BearingReport, SHAFT_FORMAT, ShaftBalances, ShaftResult, ShaftRun};
pub use variant::{Variant, run_cut};
pub use weights::{CounterweightReport, NoWeights, WebReport, best_counterweights};

use std::time::Instant;

use oilwedge_scene::ShaftScene;
use weights::part_of_way;

use crate::orbit::USUAL;
use crate::run_options::RunOptions;

/// Solves the films of a shaft. A balance that is not found is a result, with its reason.
///
/// # Errors
/// [`ShaftError`]: the scenes do not become a shaft on films.
pub fn run_shaft(scene: &ShaftScene, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    let clock = Instant::now();
    let mut run = match compile::engine(scene)? {
        Some(engine) => cycle::followed(scene, &engine, options)?,
        None => statics::solved(scene, options)?,
    };
    run.result.tail.took("total", clock.elapsed().as_secs_f64());
    Ok(run)
}

/// Parts of the way to the counterweights that serve the cut shaft best, tried one after the other on the shaft of the
/// scene.
const PARTS: [f64; 4] = [1.0, 0.5, 0.25, 0.125];

/// The shaft with counterweights by which its least film grows, beside a run with those of its scene: its own numbers,
/// with what has changed; the run of the scene where the search finds none.
///
/// # Errors
/// [`NoWeights`]: why they cannot be sought.
pub fn run_with_best_counterweights(
    scene: &ShaftScene,
    before: &ShaftRun,
    options: &RunOptions,
) -> Result<(ShaftRun, CounterweightReport), NoWeights> {
    let (best, found) = best_counterweights(scene)?;
    let was = before.least_film();
    for part in PARTS {
        let (moved, report) = part_of_way([scene, &best], part, &found);
        let after = run_shaft(&moved, options)?;
        let film = was.zip(after.least_film()).map(<[f64; 2]>::from);
        if let (Some(observer), Some(film)) = (options.observer, film) {
            observer.counterweights(part, film);
        }
        if film.map_or(was.is_none(), |[was, is]| is > was) {
            return Ok((after, CounterweightReport { film, ..report }));
        }
    }
    let (_, report) = part_of_way([scene, &best], 0.0, &found);
    let film = was.map(|film| [film; 2]);
    Ok((before.clone(), CounterweightReport { film, ..report }))
}

/// Checks that a scene and those of its bearings become a shaft on films.
///
/// # Errors
/// [`ShaftError`]: they do not.
pub fn check_shaft(scene: &ShaftScene) -> Result<Compiled, ShaftError> {
    compile::engine(scene)?;
    compile_shaft(scene, USUAL)
}
