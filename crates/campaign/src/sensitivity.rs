//! Derivatives of the quantities of a film by the numbers of its scene: by the tangent of the film or, where that does
//! not reach, by two films solved again.
//!
//! The tangent ([`oilwedge_study::sensitivity`]) serves all that leaves the mesh as it is or moves its vertices a
//! little. Two films serve the rest: meshes of files, temperatures across the film, and cycles. They lie at both ends
//! of a tolerance or, where there is none, at a small distance from the number, and are those of a sweep without error
//! bars.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{KeyTolerance, Scene, SceneError};
use oilwedge_study::quantities::{Quantity, Sensitivity, Unit};
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::sensitivity::{FilmTangent, NoTangent, Slope};
use oilwedge_study::solved::Solved;
use oilwedge_study::{CHECKS, compile};

use crate::sweep::{CaseOutcome, chain_of};

/// Step of the tangent over a number [1], or over a unit of it where it is zero; of angles in radians. Truncation grows
/// with its square and rounding falls with it: exponents are known to 1e-8.
const STEP: f64 = 3e-5;
/// Distance of two films from the nominal one over the step of the tangent [1]: 0.9 % of the number, far above what
/// meshes of their own change.
const OF_FILMS: f64 = 300.0;
/// Temperatures step by so many kelvin over a unit of [`STEP`], as a viscosity falls by a few per cent a kelvin.
const KELVIN: f64 = 100.0;
/// Relative changes below this part of those of the number are what rounding and steps leave.
const ROUND_OFF: f64 = 1e-7;

/// Where the derivatives on both sides of a number differ by more than this part, over the greater one of the exponent
/// and one, there is a kink: the cavity of a mesh consists of nodes, and changes by steps.
const KINK: f64 = 5e-3;
/// A quantity that changes by more than this part with a step is next to nothing, and has no exponent.
const NOTHING: f64 = 1e-2;

/// Why a number has no derivatives, or tolerances no spread.
#[derive(Debug, thiserror::Error)]
pub enum NoSpread {
    /// The numbers beside make no scene.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// There is no film beside.
    #[error(
        "there is no film with a little more or less of {key}: {reason}; give it a narrower tolerance, or a number farther from that limit"
    )]
    Film {
        /// Key of the number.
        key: String,
        /// Why.
        reason: String,
    },
}

/// Derivatives of quantities by one number.
pub(crate) struct Derivatives {
    /// Slopes by name of the quantity.
    by_name: HashMap<Cow<'static, str>, Slope>,
    /// True where two films have shown them.
    is_by_films: bool,
}

impl Derivatives {
    /// Films that were solved beside for them.
    pub(crate) fn films(&self) -> usize {
        if self.is_by_films { 2 } else { 0 }
    }

    /// How a quantity changes with a unit of a number; none where a film beside lacks it, zero where that is rounding.
    pub(crate) fn of(&self, quantity: &Quantity, input: &KeyTolerance) -> Option<f64> {
        let Slope { value, derivative, .. } = *self.by_name.get(&quantity.name)?;
        let change = derivative * step(input) / STEP;
        Some(if change.abs() > ROUND_OFF * value.abs() { derivative } else { 0.0 })
    }

    /// The derivative of a quantity by an input, as it is reported.
    pub(crate) fn sensitivity(&self, quantity: &Quantity, input: &KeyTolerance) -> Option<Sensitivity> {
        let slope = self.of(quantity, input)?;
        let has_zero_of_choice = matches!(input.dimension, Some(Dimension::Angle | Dimension::Temperature))
            || matches!(quantity.row.unit, Unit::Degree | Unit::Radian | Unit::Celsius);
        // Of the same film as the slope: the one that is reported may be that of cubic elements.
        let Slope { value: own, bend, .. } = *self.by_name.get(&quantity.name)?;
        let step = step(input);
        let is_number = (slope * step).abs() < NOTHING * own.abs();
        let is_relative = is_number && input.nominal != 0.0 && !has_zero_of_choice;
        let size = f64::max((slope * step).abs(), STEP * own.abs());
        let unit = match input.unit.as_str() {
            "" => quantity.unit().to_owned(),
            unit => format!("{}/{unit}", quantity.unit()),
        };
        Some(Sensitivity {
            value: slope * input.unit_size(),
            unit,
            log: is_relative.then(|| slope * input.nominal / own),
            is_by_films: self.is_by_films,
            has_kink: is_number && (bend * step).abs() > KINK * size,
        })
    }
}

/// Step of a number [SI] for the tangent.
fn step(input: &KeyTolerance) -> f64 {
    match input.dimension {
        Some(Dimension::Temperature) => KELVIN * STEP,
        Some(Dimension::Angle) => STEP,
        _ if input.nominal == 0.0 => STEP * input.unit_size(),
        _ => STEP * input.nominal.abs(),
    }
}

/// Distance of two films from the nominal one [SI].
fn distance(input: &KeyTolerance) -> f64 {
    if input.half_width > 0.0 { input.half_width } else { OF_FILMS * step(input) }
}

/// The derivatives of the quantities of a film that is `solved` by each of some numbers of its scene.
pub(crate) fn derivatives(
    scene: &Scene,
    solved: Option<&Solved>,
    inputs: &[KeyTolerance],
    options: &RunOptions,
) -> Vec<Result<Derivatives, NoSpread>> {
    let tangent = solved.and_then(|solved| FilmTangent::of(solved).ok().flatten());
    let by_tangent = |input: &KeyTolerance| by_tangent(tangent.as_ref()?, scene, input).map(Ok);
    let mut found: Vec<Option<_>> = inputs.iter().map(by_tangent).collect();
    let left: Vec<usize> = (0..inputs.len()).filter(|&k| found[k].is_none()).collect();
    let beside: Vec<&KeyTolerance> = left.iter().map(|&k| &inputs[k]).collect();
    for (k, by_films) in left.into_iter().zip(by_films(scene, &beside, options)) {
        found[k] = Some(by_films);
    }
    found.into_iter().flatten().collect()
}

/// Derivatives by the tangent; `None` where two films have to show them.
fn by_tangent(tangent: &FilmTangent, scene: &Scene, input: &KeyTolerance) -> Option<Derivatives> {
    let step = step(input);
    let beside = |more: f64| compile(&scene.with_values(&[(input, input.nominal + more)], &CHECKS).ok()?).ok();
    // A number at the end of its range has one side.
    let end = |more: f64| beside(more).map_or_else(|| Some((beside(0.0)?, 0.0)), |model| Some((model, more)));
    let ((low, less), (high, more)) = (end(-step)?, end(step)?);
    match tangent.derivatives([(&low, less), (&high, more)]) {
        Ok(by_name) => Some(Derivatives { by_name, is_by_films: false }),
        Err(NoTangent::Mesh | NoTangent::Film(_)) => None,
    }
}

/// Derivatives by films on both sides of the nominal one.
fn by_films(scene: &Scene, inputs: &[&KeyTolerance], options: &RunOptions) -> Vec<Result<Derivatives, NoSpread>> {
    if inputs.is_empty() {
        return Vec::new();
    }
    let at = |input: &KeyTolerance, sign: f64| {
        scene.with_values(&[(input, input.nominal + sign * distance(input))], &CHECKS)
    };
    let ends: Vec<Result<[Scene; 2], SceneError>> =
        inputs.iter().map(|input| Ok([at(input, -1.0)?, at(input, 1.0)?])).collect();
    let scenes: Vec<Scene> = std::iter::once(scene.clone()).chain(ends.iter().flatten().flatten().cloned()).collect();
    let mut found = chain_of(&scenes, options).into_iter().skip(1);
    let mut difference = |(input, ends): (&&KeyTolerance, Result<[Scene; 2], SceneError>)| {
        ends?;
        // Both belong to this number, also where one of them was not found.
        let both = [found.next(), found.next()];
        let [low, high] = both.map(|film| quantities(film, &input.key));
        let (low, high) = (low?, high?);
        let slope = |high: &Quantity| Slope::between(&low, high, 2.0 * distance(input));
        Ok(Derivatives { by_name: high.iter().filter_map(slope).collect(), is_by_films: true })
    };
    inputs.iter().zip(ends).map(&mut difference).collect()
}

/// The quantities of a film that was found.
fn quantities(found: Option<CaseOutcome>, key: &str) -> Result<Vec<Quantity>, NoSpread> {
    match found {
        Some(found) if !found.quantities.is_empty() => Ok(found.quantities),
        other => Err(NoSpread::Film {
            key: key.to_owned(),
            reason: other.and_then(|found| found.reason).unwrap_or_default(),
        }),
    }
}

/// Adds the derivatives by an input to those of each quantity.
pub(crate) fn add(quantities: &mut [Quantity], input: &KeyTolerance, found: &Derivatives) {
    for quantity in quantities {
        let more = found.sensitivity(quantity, input).map(|it| (input.key.clone(), it));
        quantity.sensitivity.extend(more);
    }
}
