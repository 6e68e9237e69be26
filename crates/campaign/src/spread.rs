//! How far the tolerances of a scene spread its quantities, to first order, and two films at the worst corners.
//!
//! With the effect `d_j = t_j dQ/dx_j` of a tolerance t_j the worst case is `sum |d_j|`, and `rss^2 = sum d_j^2` (ISO
//! 14253-2 calls it the combined uncertainty of independent inputs). Derivatives are those of [`crate::sensitivity`].
//! Two films at the worst corners of the main quantity show whether effects add up. Tested by
//! `tests/tests/cli/spread.rs` against exponents of the short film and against draws.

use std::collections::BTreeMap;

use oilwedge_scene::{KeyTolerance, Scene};
use oilwedge_study::CHECKS;
use oilwedge_study::quantities::{Quantity, QuantitySpread};
use oilwedge_study::result::{RunResult, headlines};
use oilwedge_study::run::Run;
use oilwedge_study::run_options::RunOptions;

use crate::sensitivity::{Derivatives, NoSpread, add, derivatives, quantities};
use crate::sweep::chain_of;

/// Corners that depart from the sum of effects by more than this are reported by themselves.
const LINEAR: f64 = 0.2;
/// Signs of the two corners.
const SIGNS: [f64; 2] = [-1.0, 1.0];

/// The result of a run whose quantities have their derivatives by some `inputs` of its scene and, where it has
/// tolerances and these are among the inputs, their spread; and why some have none.
pub fn with_derivatives(
    scene: &Scene,
    run: &Run,
    inputs: &[KeyTolerance],
    options: &RunOptions,
) -> (RunResult, Vec<String>) {
    let (mut result, options) = (run.result.clone(), RunOptions { bars: false, observer: None, ..*options });
    let (mut reasons, mut of_tolerances) = (Vec::new(), Vec::new());
    for (input, found) in inputs.iter().zip(derivatives(scene, run.solved.as_ref(), inputs, &options)) {
        match found {
            Ok(found) => {
                add(&mut result.quantities, input, &found);
                of_tolerances.extend((input.half_width > 0.0).then_some(found));
            }
            Err(reason) => reasons.push(format!("there is no sensitivity to {}: {reason}", input.key)),
        }
    }
    if !of_tolerances.is_empty() && of_tolerances.len() == scene.tolerances.len() {
        match spread(scene, &result, &of_tolerances, &options) {
            Ok(quantities) => result.quantities = quantities,
            Err(reason) => reasons.push(format!("the tolerances have no spread: {reason}")),
        }
    }
    (result, reasons)
}

/// The quantities of a result with their spread; one that a film beside lacks has none.
fn spread(
    scene: &Scene,
    of: &RunResult,
    found: &[Derivatives],
    options: &RunOptions,
) -> Result<Vec<Quantity>, NoSpread> {
    let main = main_of(of).map(|main| main.name.clone());
    let mut list = of.quantities.clone();
    for quantity in &mut list {
        let effect =
            |(input, found): (&KeyTolerance, &Derivatives)| Some(found.of(quantity, input)? * input.half_width);
        let Some(effects) = scene.tolerances.iter().zip(found).map(effect).collect::<Option<Vec<f64>>>() else {
            continue;
        };
        let mut own = spread_of(&effects, &scene.tolerances);
        if Some(&quantity.name) == main.as_ref() && own.worst_case > 0.0 {
            let corners = corners(scene, &effects, quantity, options)?;
            let [low, high] = corners;
            let nonlinearity = quantity.row.difference(high, low) / (2.0 * own.worst_case) - 1.0;
            own.nonlinearity = Some(nonlinearity.abs());
            own.corners = Some(corners).filter(|_| nonlinearity.abs() > LINEAR);
        }
        quantity.spread = Some(own);
    }
    Ok(list)
}

/// The quantity whose corners are solved: the first one of short tables.
pub fn main_of(result: &RunResult) -> Option<&Quantity> {
    headlines(&result.quantities, |quantity| quantity.row, &result.effects).first().copied()
}

fn spread_of(effects: &[f64], inputs: &[KeyTolerance]) -> QuantitySpread {
    let square: f64 = effects.iter().map(|effect| effect * effect).sum();
    let shares = inputs.iter().zip(effects).map(|(input, effect)| (input.key.clone(), effect * effect / square));
    QuantitySpread {
        worst_case: effects.iter().map(|effect| effect.abs()).sum(),
        rss: square.sqrt(),
        shares: if square > 0.0 { shares.collect() } else { BTreeMap::new() },
        ..QuantitySpread::default()
    }
}

/// The quantity at the corners at which it is least and greatest to first order.
fn corners(scene: &Scene, effects: &[f64], quantity: &Quantity, options: &RunOptions) -> Result<[f64; 2], NoSpread> {
    let corner = |sign: f64| {
        let at = |(input, effect): (&KeyTolerance, &f64)| input.nominal + sign * effect.signum() * input.half_width;
        let values: Vec<_> = scene.tolerances.iter().zip(effects).map(|pair| (pair.0, at(pair))).collect();
        scene.with_values(&values, &CHECKS)
    };
    let [low, high] = SIGNS.map(corner);
    let mut found = chain_of(&[low?, high?], options).into_iter();
    let mut end = || -> Result<f64, NoSpread> {
        let films = quantities(found.next(), "all keys at once")?;
        let found = films.iter().find(|other| other.name == quantity.name);
        found.map(|found| found.value).ok_or_else(|| NoSpread::Film {
            key: "all keys at once".to_owned(),
            reason: format!("it has no {}", quantity.name),
        })
    };
    Ok([end()?, end()?])
}
