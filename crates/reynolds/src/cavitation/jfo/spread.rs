//! How much oil a mesh may spread across the flow.
//!
//! In a sub-triangle without an edge along the flow the N and the LDA scheme send oil to different corners. What they
//! disagree about, at corners in the cavity, is oil that may be carried across the flow:
//! ```text
//! s_T = 1/2 sum_i | N_i - LDA_i |   [m3/s]       sigma = sum e s_T / (U c B/2)
//! e = sqrt(min(1, E/R))                          n = sum e s_T / (U c w_T/2)
//! ```
//! w_T is the extent of the sub-triangle across the flow, E [m] the length along the flow of the patch of such
//! sub-triangles to which it belongs. Both sums are zero on rows along the flow. At the rim of a hole patches are
//! short, and the rows behind carry on what left them. Along a layer of oil on triangles that lie anyhow, the patch is
//! as long as the layer, n grows like 1/w: the film converges to a wrong one, and so does that on the vertices by which
//! it is judged.
//!
//! **Verified by** `cavitation/along_flow`; measured in `docs/theory/cavitation.md`.

use super::FilmFraction;
use super::blocks::{Block, blocks};
use super::rows::DisjointSets;
use crate::SolvedFilm;
use crate::film_law::FilmLaw;

/// Part of the oil in a sub-triangle below which nothing is spread but rounding.
const ROUNDING: f64 = 1e-9;

/// Oil that triangles of a mass-conserving film may carry across the flow.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Spread {
    /// Shares of the triangles in sigma [1].
    pub(crate) shares: Vec<f64>,
    /// Number n of times that the oil of a strip as wide as a sub-triangle is spread [1].
    pub(crate) times: f64,
}

/// What the triangles of a film may carry across the flow.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn spread(film: &SolvedFilm, fraction: &FilmFraction) -> Result<Spread, oilwedge_fem::Error> {
    let SolvedFilm { problem, system, solution } = film;
    let volumes = system.volumes()?;
    let law = FilmLaw::new(problem, 1.0);
    let velocity = law.velocity();
    let speed = velocity[0].hypot(velocity[1]);
    // Flow dragged through the clearance in a strip of unit width [m2/s].
    let drag = 0.5 * speed * problem.bearing.clearance;
    let blocks = blocks(&law, system.space(), volumes);
    let of = |(block, corners): (&Block, &[u32; 3])| {
        let corners = corners.map(|node| node as usize);
        if !is_starved(block, corners.map(|node| solution.cavity[node])) {
            return 0.0;
        }
        let apart = disagreement(block, corners.map(|node| fraction.values[node]));
        let to_cavity = (0..3).filter(|&i| solution.cavity[corners[i]]);
        let spread = 0.5 * to_cavity.map(|i| apart[i].abs()).sum::<f64>() / drag;
        if spread > ROUNDING * width(block, speed) { spread } else { 0.0 }
    };
    let pieces: Vec<f64> = blocks.iter().zip(&volumes.triangles).map(of).collect();
    let mut patches = Patches::new(solution.unknown.len());
    let spreading = || (0..pieces.len()).filter(|&s| pieces[s] > 0.0);
    spreading().for_each(|s| patches.join(volumes.triangles[s]));
    spreading().for_each(|s| patches.add(volumes.triangles[s], &blocks[s], width(&blocks[s], speed)));
    let weight = |s: usize| (patches.length(volumes.triangles[s]) / problem.bearing.radius).min(1.0).sqrt();
    let mut spread = Spread { shares: vec![0.0; blocks.len() / volumes.per_triangle], times: 0.0 };
    for s in spreading() {
        let piece = weight(s) * pieces[s];
        spread.shares[s / volumes.per_triangle] += piece / problem.bearing.length;
        spread.times += piece / width(&blocks[s], speed);
    }
    Ok(spread)
}

/// `N_i - LDA_i` [m3/s]. N brings each corner downstream what differs from the oil that comes in, LDA the mean of that
/// over these corners: both differ by `k_i^+` times the distance of theta from its mean there,
/// `sum k_j^+ theta_j / sum k_j^+`.
fn disagreement(block: &Block, theta: [f64; 3]) -> [f64; 3] {
    let k = block.carried.map(|k| k.max(0.0));
    let mean = (0..3).map(|j| k[j] * theta[j]).sum::<f64>() / k.iter().sum::<f64>();
    [0, 1, 2].map(|i| k[i] * (theta[i] - mean))
}

/// True if the inflow side is starved: a corner upstream is in the cavity; or one to the side of the flow while
/// none downstream is (the film's edge along a supply; downstream it would be the rupture line).
fn is_starved(block: &Block, cavity: [bool; 3]) -> bool {
    const ROUNDING: f64 = 1e-9;
    const ASIDE: f64 = 0.1;
    let largest = block.carried.iter().fold(0.0f64, |m, k| m.max(k.abs()));
    let any = |from: f64, to: f64| {
        (0..3).any(|i| cavity[i] && block.carried[i] >= from * largest && block.carried[i] < to * largest)
    };
    let (upstream, aside, downstream) = (any(-1.0, -ROUNDING), any(-ROUNDING, ASIDE), any(ASIDE, 2.0));
    upstream || (aside && !downstream)
}

/// Extent [m] of a sub-triangle across a flow of the given speed [m/s]: |k| of a corner is what a full film carries
/// through half the side across from it.
fn width(block: &Block, speed: f64) -> f64 {
    block.carried.iter().map(|k| k.abs()).sum::<f64>() * 2.0 / (block.dragged * speed)
}

/// Patches of sub-triangles that share nodes.
struct Patches {
    parts: DisjointSets,
    /// Area [m2], sum of widths [m] and number of sub-triangles of each patch, by its root.
    sums: Vec<[f64; 3]>,
}

impl Patches {
    fn new(nodes: usize) -> Self {
        let (parts, sums) = (DisjointSets::new(nodes), vec![[0.0; 3]; nodes]);
        Self { parts, sums }
    }

    fn join(&mut self, corners: [u32; 3]) {
        self.parts.join(corners[0], corners[1]);
        self.parts.join(corners[0], corners[2]);
    }

    fn add(&mut self, corners: [u32; 3], block: &Block, width: f64) {
        let area = block.volume.iter().sum::<f64>() / block.dragged;
        let sums = &mut self.sums[self.parts.find(corners[0]) as usize];
        *sums = [sums[0] + area, sums[1] + width, sums[2] + 1.0];
    }

    /// Length [m] of a patch along the flow: its area over the mean width of its sub-triangles.
    fn length(&self, corners: [u32; 3]) -> f64 {
        let [area, widths, number] = self.sums[self.parts.find(corners[0]) as usize];
        area * number / widths
    }
}
