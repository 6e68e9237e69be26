//! How much oil a mesh may spread across the flow.
//!
//! In a sub-triangle without an edge along the flow the N and the LDA scheme send oil to different corners. What they disagree about, at corners
//! in the cavity, is oil that may be carried across the flow:
//! ```text
//! s_T = 1/2 sum_i | N_i - LDA_i |   [m3/s]          spread = sum s_T
//! times = sum s_T / (U c w_T / 2)                   w_T: extent of the sub-triangle across the flow
//! ```
//! Both are zero on rows along the flow, and where no edge of a streak passes. `times` says how often the oil of a strip as wide as a sub-triangle
//! is spread on its way: below one where rows change their distance behind a hole, growing like 1/w along a layer on triangles that lie
//! anyhow. There the film converges to a wrong one, and both films that are compared for an error bar do so alike.
//!
//! **Verified by** `cavitation/along_flow`; measured in `docs/theory/cavitation.md`.

use super::FilmFraction;
use super::blocks::{Block, Square, blocks};
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Oil that triangles of a mass-conserving film may carry across the flow.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Spread {
    /// Of each triangle, over what the journal drags through the clearance [1].
    pub(crate) shares: Vec<f64>,
    /// How often the oil of a strip as wide as a triangle is spread [1].
    pub(crate) times: f64,
}

/// What the triangles of a film may carry across the flow.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn spread(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    fraction: &FilmFraction,
) -> Result<Spread, oilwedge_fem::Error> {
    let volumes = system.volumes()?;
    let law = FilmLaw::new(problem, 1.0);
    let velocity = law.velocity();
    let speed = velocity[0].hypot(velocity[1]);
    // Dragged through the clearance, in a strip of unit width [m2/s].
    let drag = 0.5 * speed * problem.bearing.clearance;
    let blocks = blocks(&law, system.space(), volumes);
    let of = |(block, corners): (&Block, &[u32; 3])| {
        let corners = corners.map(|node| node as usize);
        if !block.is_starved(corners.map(|node| film.cavity[node])) {
            return 0.0;
        }
        let theta = corners.map(|node| fraction.values[node]);
        let sent = |square: &Square, i: usize| (0..3).map(|j| square[i][j] * theta[j]).sum::<f64>();
        let [n, lda] = [block.n_scheme(), block.low_diffusion()];
        let to_cavity = (0..3).filter(|&i| film.cavity[corners[i]]);
        0.5 * to_cavity.map(|i| (sent(&n, i) - sent(&lda, i)).abs()).sum::<f64>() / drag
    };
    // 2 |k| of a corner is the extent of the side across from it, times the speed over two.
    let width = |block: &Block| block.weight.iter().map(|k| k.abs()).sum::<f64>() * 2.0 / speed;
    let pieces: Vec<f64> = blocks.iter().zip(&volumes.triangles).map(of).collect();
    let times = (pieces.iter().zip(&blocks).filter(|(piece, _)| **piece > 0.0))
        .map(|(piece, block)| piece / width(block))
        .sum();
    let shares = pieces
        .chunks(volumes.per_triangle)
        .map(|pieces| pieces.iter().sum::<f64>() / problem.bearing.length);
    Ok(Spread {
        shares: shares.collect(),
        times,
    })
}
