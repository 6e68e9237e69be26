//! How much oil a mesh may spread across the flow.
//!
//! In a sub-triangle without an edge along the flow the two ways to carry oil, the N and the LDA scheme, send it to different corners. What
//! they disagree about,
//! ```text
//! spread = sum over sub-triangles whose inflow side is starved of  1/2 sum_i | N_i - LDA_i |   [m3/s]
//! ```
//! is zero on rows along the flow, and where no edge of a streak passes. Along the edge of a streak it does not vanish as the mesh is refined: there are more
//! triangles, each of which spreads less. Both films that are compared for an error bar share it.
//!
//! Measured against films on rows: `docs/theory/cavitation.md`.

use super::FilmFraction;
use super::blocks::{Block, Square, blocks};
use crate::film_law::FilmLaw;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// Oil [m3/s] that each triangle of a mass-conserving film may carry across the flow.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn spread(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    fraction: &FilmFraction,
) -> Result<Vec<f64>, oilwedge_fem::Error> {
    let volumes = system.volumes()?;
    let law = FilmLaw::new(problem, 1.0);
    let blocks = blocks(&law, system.space(), volumes);
    let of = |(block, corners): (&Block, &[u32; 3])| {
        let corners = corners.map(|node| node as usize);
        if !block.is_starved(corners.map(|node| film.cavity[node])) {
            return 0.0;
        }
        let theta = corners.map(|node| fraction.values[node]);
        let sent = |square: &Square, i: usize| (0..3).map(|j| square[i][j] * theta[j]).sum::<f64>();
        let [n, lda] = [block.n_scheme(), block.low_diffusion()];
        0.5 * (0..3).map(|i| (sent(&n, i) - sent(&lda, i)).abs()).sum::<f64>()
    };
    let pieces: Vec<f64> = blocks.iter().zip(&volumes.triangles).map(of).collect();
    Ok(pieces.chunks(volumes.per_triangle).map(|pieces| pieces.iter().sum()).collect())
}
