//! How far the tolerances of a scene spread its quantities: two films beside the nominal one for each tolerance.
//!
//! With the effect `d_j = (Q(x_j + t_j) - Q(x_j - t_j)) / 2` of a tolerance t_j the worst case is `sum |d_j|`, and
//! `rss^2 = sum d_j^2` (ISO 14253-2 calls it the combined uncertainty of independent inputs); the derivative by x_j is
//! `d_j / t_j`. All films are those of a sweep without error bars: on the mesh of the nominal film, which is drawn anew
//! where the film has moved too far for it. Two films at the worst corners of the main quantity show whether effects
//! add up. Tested by `tests/tests/cli/spread.rs` against exponents of the short film and against draws.

use std::collections::BTreeMap;

use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{KeyTolerance, Scene, SceneError};
use oilwedge_study::CHECKS;
use oilwedge_study::quantities::{Quantity, QuantitySpread, Sensitivity, Unit};
use oilwedge_study::result::{RunResult, headlines};
use oilwedge_study::run_options::RunOptions;

use crate::sweep::{CaseOutcome, chain_of};

/// Corners that depart from the sum of effects by more than this are reported by themselves.
const LINEAR: f64 = 0.2;
/// Effects below this part of the quantity are round-off.
const ROUND_OFF: f64 = 1e-12;

/// Why tolerances have no spread.
#[derive(Debug, thiserror::Error)]
pub enum NoSpread {
    /// The numbers at an end make no scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// There is no film at an end of a tolerance.
    #[error("there is no film at an end of the tolerance of {key}: {reason}; give a narrower tolerance")]
    Film {
        /// Key of the tolerance.
        key: String,
        /// Why.
        reason: String,
    },
}

/// The quantities at both ends of each tolerance, a row each: `[number of the tolerance][end]`.
///
/// # Errors
/// A scene at an end is none, or has no film.
fn ends(scene: &Scene, options: &RunOptions) -> Result<Vec<[Vec<Quantity>; 2]>, NoSpread> {
    let inputs = &scene.tolerances;
    let mut scenes = vec![scene.with_values(&[], &CHECKS)?];
    for input in inputs {
        for sign in SIGNS {
            scenes.push(scene.with_values(&[(input, input.nominal + sign * input.half_width)], &CHECKS)?);
        }
    }
    let mut found = chain_of(&scenes, options).into_iter().skip(1);
    let mut rows = Vec::with_capacity(inputs.len());
    for input in inputs {
        let mut end = || quantities(found.next(), &input.key);
        rows.push([end()?, end()?]);
    }
    Ok(rows)
}

/// Signs of the two ends of a tolerance.
const SIGNS: [f64; 2] = [-1.0, 1.0];

fn quantities(found: Option<CaseOutcome>, key: &str) -> Result<Vec<Quantity>, NoSpread> {
    match found {
        Some(found) if !found.quantities.is_empty() => Ok(found.quantities),
        other => Err(NoSpread::Film {
            key: key.to_owned(),
            reason: other.and_then(|found| found.reason).unwrap_or_default(),
        }),
    }
}

/// The value of a quantity of this name.
fn value(of: &[Quantity], name: &str) -> Option<f64> {
    of.iter().find(|other| other.name == name).map(|other| other.value)
}

/// How far a quantity is from one end to the other; angles the shorter way round.
fn difference(quantity: &Quantity, [low, high]: [f64; 2]) -> f64 {
    match quantity.row.unit {
        Unit::Degree => (high - low + 180.0).rem_euclid(360.0) - 180.0,
        _ => high - low,
    }
}

/// Effects of the tolerances on each quantity of a result: half of the difference between their ends. A quantity that
/// a film lacks has none.
///
/// # Errors
/// A scene at an end is none, or has no film.
fn effects(scene: &Scene, of: &RunResult, options: &RunOptions) -> Result<Vec<Option<Vec<f64>>>, NoSpread> {
    let rows = ends(scene, options)?;
    let effect = |quantity: &Quantity, [low, high]: &[Vec<Quantity>; 2]| {
        let ends = [value(low, &quantity.name)?, value(high, &quantity.name)?];
        let effect = 0.5 * difference(quantity, ends);
        Some(if effect.abs() > ROUND_OFF * quantity.value.abs() { effect } else { 0.0 })
    };
    Ok((of.quantities.iter()).map(|quantity| rows.iter().map(|row| effect(quantity, row)).collect()).collect())
}

/// The result of a scene with the spread of its quantities; the same where the scene has no tolerances.
///
/// # Errors
/// A scene at an end is none, or has no film.
pub fn with_spread(scene: &Scene, result: RunResult, options: &RunOptions) -> Result<RunResult, NoSpread> {
    if scene.tolerances.is_empty() || result.quantities.is_empty() {
        return Ok(result);
    }
    let options = RunOptions { bars: false, observer: None, ..*options };
    let effects = effects(scene, &result, &options)?;
    let main = main_of(&result).map(|main| main.name.clone());
    let mut spread = result;
    for (quantity, effects) in spread.quantities.iter_mut().zip(effects) {
        let Some(effects) = effects else { continue };
        let mut own = spread_of(&effects, &scene.tolerances);
        if Some(&quantity.name) == main.as_ref() && own.worst_case > 0.0 {
            let corners = corners(scene, &effects, quantity, &options)?;
            let nonlinearity = difference(quantity, corners) / (2.0 * own.worst_case) - 1.0;
            own.nonlinearity = Some(nonlinearity.abs());
            own.corners = Some(corners).filter(|_| nonlinearity.abs() > LINEAR);
        }
        quantity.sensitivity = sensitivities(quantity, &effects, &scene.tolerances);
        quantity.spread = Some(own);
    }
    Ok(spread)
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
        value(&films, &quantity.name).ok_or_else(|| NoSpread::Film {
            key: "all keys at once".to_owned(),
            reason: format!("it has no {}", quantity.name),
        })
    };
    Ok([end()?, end()?])
}

fn sensitivities(quantity: &Quantity, effects: &[f64], inputs: &[KeyTolerance]) -> BTreeMap<String, Sensitivity> {
    let sensitivity = |(input, effect): (&KeyTolerance, &f64)| {
        let derivative = effect / input.half_width;
        let has_zero_of_choice = matches!(input.dimension, Some(Dimension::Angle | Dimension::Temperature))
            || matches!(quantity.row.unit, Unit::Degree | Unit::Radian | Unit::Celsius);
        let is_relative = quantity.value != 0.0 && input.nominal != 0.0 && !has_zero_of_choice;
        let unit = match input.unit.as_str() {
            "" => quantity.unit().to_owned(),
            unit => format!("{}/{unit}", quantity.unit()),
        };
        let sensitivity = Sensitivity {
            value: derivative * input.unit_size(),
            unit,
            log: is_relative.then(|| derivative * input.nominal / quantity.value),
        };
        (input.key.clone(), sensitivity)
    };
    inputs.iter().zip(effects).map(sensitivity).collect()
}
