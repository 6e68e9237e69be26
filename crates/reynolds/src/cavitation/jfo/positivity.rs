//! The least film fraction that a positive scheme leaves at a node: no less oil than the corners upstream send.
//!
//! The N scheme at node i says `sum_T k_i^+ (u_i - u_in) + theta_i storage_i = what pressure presses in >= 0`, with `u = h theta` and `u_in` a mean of the
//! corners upstream in T. So `theta_i >= sum_T k_i^+ min u_j / (sum_T k_i^+ h_i + storage_i)`; what a history leaves to the node comes in too. LDA may leave less at the edge of a streak.

use super::{Film, History};

/// A film fraction below the least that is carried by this part of it comes of a scheme that is not positive.
pub(super) const UNDERSHOOT: f64 = 1e-3;

/// That film fraction at each node, between zero and one.
pub(super) fn least_carried(film: &Film<'_>, theta: &[f64]) -> Vec<f64> {
    // What comes to a node, and what leaves it, or is stored there, while it is full.
    let (mut coming, mut leaving) = (vec![0.0; theta.len()], vec![0.0; theta.len()]);
    if let Some(History { before, volume }) = &film.history {
        for (dof, (known, volume)) in before.known.iter().zip(volume).enumerate() {
            (coming[dof], leaving[dof]) = (before.per_time * known, before.per_time * volume);
        }
    }
    for (block, corners) in film.blocks.iter().zip(&film.volumes.triangles) {
        let corners = corners.map(|node| node as usize);
        let sent = (0..3)
            .filter(|&j| block.weight[j] < 0.0)
            .map(|j| block.thickness[j] * theta[corners[j]])
            .fold(f64::INFINITY, f64::min);
        for i in 0..3 {
            leaving[corners[i]] += block.storage[i];
            if block.weight[i] > 0.0 {
                coming[corners[i]] += block.weight[i] * sent;
                leaving[corners[i]] += block.weight[i] * block.thickness[i];
            }
        }
    }
    let least = |(coming, leaving): (&f64, &f64)| match *leaving > 0.0 {
        true => (coming / leaving).clamp(0.0, 1.0),
        false => 0.0,
    };
    coming.iter().zip(&leaving).map(least).collect()
}
