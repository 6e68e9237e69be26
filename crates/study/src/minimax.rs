//! # The greatest least of several numbers
//!
//! **Equation.** Over the unknowns a, the level t is made greatest that no number is below:
//! ```text
//! max t,      v_i(a) - t >= 0
//! ```
//! The least of the numbers has corners, and the numbers have none: sequential quadratic steps ([`crate::quadratic`])
//! solve this with derivatives by differences. The box of the unknowns is drawn closer around what was found, and
//! searched again.
//!
//! | symbol | code |
//! |---|---|
//! | a, unknowns | `at` |
//! | v_i(a) | `numbers` |
//!
//! **Source.** Han, Math. Prog. 20 (1981) 1. **Range.** Some ten unknowns, hundreds of numbers. **Verified by**
//! `tests/tests/shaft/weights.rs`: a crank in closed form.

use crate::quadratic::{Valued, least};

/// Parts of the box in which it is searched, one after the other.
const BOXES: [f64; 3] = [1.0, 0.05, 2e-3];
/// Steps of differences, over the first box. Numbers of orbits jump where the count of their steps in time changes; a
/// shorter difference meets fewer jumps.
const STEP: f64 = 3e-6;
/// Most points of each search.
const MOST: usize = 30;

/// The best point found.
#[derive(Debug, Clone, PartialEq)]
pub struct GreatestLeast {
    /// The unknowns.
    pub at: Vec<f64>,
    /// The least number there.
    pub value: f64,
    /// How often the numbers were asked for.
    pub asked: usize,
}

/// Where the least of some `numbers` is greatest within `reach` of a point, for each unknown; `size` is the size of the
/// numbers. `None` where there are none at the point.
pub fn greatest_least(
    numbers: &dyn Fn(&[f64]) -> Option<Vec<f64>>,
    from: &[f64],
    reach: f64,
    size: f64,
) -> Option<GreatestLeast> {
    let mut asked = 0;
    let mut ask = |at: &[f64]| {
        asked += 1;
        numbers(at)
    };
    let lowest = |numbers: &[f64]| numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let (mut best, mut value) = (from.to_vec(), lowest(&ask(from)?));
    for part in BOXES {
        let (middle, level, width) = (best.clone(), value, part * reach);
        let place = |at: &[f64]| -> Vec<f64> {
            middle.iter().zip(at).map(|(middle, part)| middle + (2.0 * part - 1.0) * width).collect()
        };
        let level_at = |at: &[f64]| level + (2.0 * at[middle.len()] - 1.0) * size;
        let mut sample = |at: &[f64]| {
            let found = ask(&place(at))?;
            if lowest(&found) > value {
                (best, value) = (place(at), lowest(&found));
            }
            let mut gradients: Vec<Vec<f64>> = found.iter().map(|_| Vec::with_capacity(at.len())).collect();
            for k in 0..middle.len() {
                let mut beside = at.to_vec();
                // Inwards, so that it stays in the box.
                let step = if at[k] > 0.5 { -STEP / part } else { STEP / part };
                beside[k] += step;
                let other = ask(&place(&beside))?;
                let slopes = other.iter().zip(&found).map(|(other, own)| (other - own) / (step * size));
                gradients.iter_mut().zip(slopes).for_each(|(row, slope)| row.push(slope));
            }
            gradients.iter_mut().for_each(|row| row.push(-2.0));
            let mut gradient = vec![0.0; at.len()];
            gradient[middle.len()] = -2.0;
            Some(Valued {
                objective: -(level_at(at) - level) / size,
                constraints: found.iter().map(|number| (number - level_at(at)) / size).collect(),
                gradient,
                gradients,
            })
        };
        least(&vec![0.5; middle.len() + 1], MOST, &mut sample)?;
    }
    Some(GreatestLeast { at: best, value, asked })
}
