//! Draws of the tolerances of a scene: each number of a key with a tolerance is drawn within its width.
//!
//! Draw k of a key depends on the seed, k and the name of the key alone, so that it is the same on any number of
//! threads and machines, and stays when other keys get tolerances. Random bits are those of splitmix64 (Steele, Lea and
//! Flood 2014) of these three.

use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::axis::{AxisValue, SweepAxis};
use crate::KeyTolerance;

/// Name of the axis of draws, which is the last one, and its key.
pub(super) const DRAW: &str = "draw";
/// Half widths are so many standard deviations of a normal distribution.
const DEVIATIONS: f64 = 3.0;
/// Increment of splitmix64: 2^64 over the golden ratio.
const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;
/// Offset basis and prime of the hash FNV-1a of 64 bits.
const FNV: [u64; 2] = [0xcbf2_9ce4_8422_2325, 0x0000_0100_0000_01b3];

/// How numbers are distributed within their tolerances.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum DrawLaw {
    /// Every number within the width is as likely as any other.
    #[default]
    Uniform,
    /// Normal, half of the width being three standard deviations; what lies beyond the width is drawn again.
    Normal,
}

/// How many draws are made, and which.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct DrawOptions {
    /// Number of draws.
    pub count: usize,
    /// Number by which other draws are made.
    pub seed: u64,
    /// Distribution of each number.
    pub law: DrawLaw,
}

/// The draws of a sweep.
#[derive(Debug, Clone, PartialEq)]
pub struct Draws {
    /// How many, and which.
    pub options: DrawOptions,
    /// The keys that are drawn.
    pub inputs: Vec<KeyTolerance>,
}

impl Draws {
    /// The axis of the draws, by their numbers from 1.
    pub(super) fn axis(&self) -> SweepAxis {
        SweepAxis {
            name: DRAW.to_owned(),
            path: DRAW.to_owned(),
            unit: String::new(),
            values: (1..=self.options.count).map(|number| AxisValue::Number(number as f64)).collect(),
            span: 0..0,
        }
    }

    /// The number in SI that a key has in draw `number` (from 0).
    pub fn value(&self, input: &KeyTolerance, number: usize) -> f64 {
        let place = input.key.bytes().fold(FNV[0], |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(FNV[1]));
        let uniform = |trial: u64| {
            let state = [place, number as u64, trial].into_iter().fold(self.options.seed, |state, part| {
                mixed(state.wrapping_add(GAMMA) ^ mixed(part.wrapping_add(GAMMA)))
            });
            // The 53 leading bits, in the middle of their interval: within 0 and 1, and never an end.
            ((state >> 11) as f64 + 0.5) * (0.5f64).powi(53)
        };
        let relative = match self.options.law {
            DrawLaw::Uniform => 2.0 * uniform(0) - 1.0,
            DrawLaw::Normal => {
                // Box and Muller.
                let normal = |trial: u64| {
                    (-2.0 * uniform(2 * trial).ln()).sqrt() * (TAU * uniform(2 * trial + 1)).cos() / DEVIATIONS
                };
                (0..).map(normal).find(|drawn| drawn.abs() <= 1.0).unwrap_or(0.0)
            }
        };
        input.nominal + input.half_width * relative
    }

    /// What draw `number` (from 0) sets: an axis of one value for each key.
    pub(super) fn axes(&self, number: usize) -> Vec<SweepAxis> {
        self.inputs.iter().map(|input| fixed(input, self.value(input, number))).collect()
    }
}

/// An axis on which a key has one value, which is given in SI.
pub(super) fn fixed(input: &KeyTolerance, value: f64) -> SweepAxis {
    SweepAxis {
        name: input.key.clone(),
        path: input.key.clone(),
        unit: input.unit.clone(),
        values: vec![AxisValue::Number(short(input.in_unit(value)))],
        span: input.span.clone(),
    }
}

/// The number to fifteen digits, so that a tenth of a unit is written as one.
fn short(number: f64) -> f64 {
    format!("{number:.14e}").parse().unwrap_or(number)
}

/// The function that spreads the bits of a number in splitmix64.
fn mixed(state: u64) -> u64 {
    let state = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let state = (state ^ (state >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    state ^ (state >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn input(key: &str) -> KeyTolerance {
        KeyTolerance {
            key: key.to_owned(),
            nominal: 10.0,
            half_width: 2.0,
            unit: String::new(),
            dimension: None,
            span: 0..0,
        }
    }

    fn draws(law: DrawLaw, seed: u64) -> Vec<f64> {
        let options = DrawOptions { count: 20_000, seed, law };
        let draws = Draws { options, inputs: vec![input("bearing.clearance")] };
        (0..options.count).map(|number| draws.value(&draws.inputs[0], number)).collect()
    }

    fn moments(values: &[f64]) -> [f64; 2] {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        [mean, (values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count).sqrt()]
    }

    #[test]
    fn draws_have_the_moments_of_their_law() {
        let truncated = 2.0 / 3.0 * 0.986_6;
        for (law, deviation) in [(DrawLaw::Uniform, 2.0 / 3f64.sqrt()), (DrawLaw::Normal, truncated)] {
            let values = draws(law, 1);
            let [mean, own] = moments(&values);
            assert!((mean - 10.0).abs() < 0.03 && (own / deviation - 1.0).abs() < 0.02, "{law:?}: {mean} {own}");
            assert!(values.iter().all(|value| (8.0..=12.0).contains(value)), "{law:?}");
        }
    }

    #[test]
    fn keys_seeds_and_draws_are_independent() {
        let [first, second] = [draws(DrawLaw::Uniform, 1), draws(DrawLaw::Uniform, 2)];
        let shifted = [&first[1..], &first[..1]].concat();
        let options = DrawOptions { count: first.len(), seed: 1, law: DrawLaw::Uniform };
        let other = Draws { options, inputs: vec![input("oil.viscosity")] };
        let other: Vec<f64> = (0..options.count).map(|number| other.value(&other.inputs[0], number)).collect();
        for values in [&second, &shifted, &other] {
            let product = first.iter().zip(values).map(|(a, b)| (a - 10.0) * (b - 10.0)).sum::<f64>();
            let correlation = product / first.len() as f64 / (4.0 / 3.0);
            assert!(correlation.abs() < 0.03, "{correlation}");
        }
    }
}
