//! Power in a mass-conserving film: how full it is between the nodes, and what the flows between cells work against the
//! pressure.
//!
//! **Film fraction.** Oil of the thickness `u = theta h_F` leaves a node, where `h_F` is that of a full film which
//! carries away as much: the balances conserve `theta F`, not `theta h`. A sub-triangle whose upstream corners are in
//! the cavity holds the oil that they send into it, so that `theta(x) = min(1, u/h(x))`; all others are full.
//!
//! **Work.** Each balance times the pressure of its node, summed.
//!
//! `sum of P_i (K q + B theta)_i` falls into what pressure drives, what the journal drags and what the film takes up.
//! Inside a cavity P is even and the columns of B sum to zero, so that nothing is worked there.

use oilwedge_fem::ControlVolumes;

use super::blocks::{Block, SIDES, blocks};
use super::volumes_of;
use crate::cavitation::FilmFraction;
use crate::film_law::FilmLaw;
use crate::quantities::power::PowerIntegrals;
use crate::{FilmProblem, FilmSolution, FilmSystem};

/// The discrete film whose power is asked for.
pub(crate) struct Carriage<'a> {
    volumes: &'a ControlVolumes,
    blocks: Vec<Block>,
    fraction: &'a FilmFraction,
    /// Thickness u [m] of the oil that leaves each node; zero where nothing does.
    oil: Vec<f64>,
    /// What the cell of each node takes up [m3/s] in a film with a history; else empty.
    taken_up: Vec<f64>,
}

impl<'a> Carriage<'a> {
    /// The sub-triangles of a film that was solved on `system`.
    ///
    /// # Errors
    /// The sub-mesh does not fit in memory.
    pub(crate) fn new(
        problem: &FilmProblem,
        system: &'a FilmSystem,
        fraction: &'a FilmFraction,
    ) -> Result<Self, oilwedge_fem::Error> {
        let volumes = system.volumes()?;
        let law = FilmLaw::new(problem, 1.0);
        let mut blocks = blocks(&law, system.space(), volumes);
        let taken_up = problem.storage.as_deref().map_or(Vec::new(), |before| {
            let volume = volumes_of(volumes, &blocks, fraction.values.len());
            let held: Vec<f64> = volume.iter().zip(&fraction.values).map(|(v, theta)| v * theta).collect();
            blocks.iter_mut().for_each(|block| block.storage = [0.0; 3]);
            before.taken_up(&held)
        });
        let oil = oil_of(volumes, &blocks, fraction);
        Ok(Self { blocks, taken_up, volumes, fraction, oil })
    }

    /// Thickness u [m] of the oil carried into each sub-triangle of triangle `t`; infinite where it is full.
    pub(crate) fn carried(&self, t: usize, cavity: &[bool]) -> [f64; 4] {
        let mut carried = [f64::INFINITY; 4];
        let first = t * self.volumes.per_triangle;
        for (carried, s) in carried.iter_mut().zip(first..first + self.volumes.per_triangle) {
            let (block, nodes) = (&self.blocks[s], self.volumes.triangles[s].map(|node| node as usize));
            if (0..3).any(|i| block.carried[i] < 0.0 && cavity[nodes[i]]) {
                *carried = block.inflowing(nodes.map(|node| self.oil[node]));
            }
        }
        carried
    }

    /// Thickness u [m] of the oil carried to a point of sub-triangle `sub` of triangle `t` that has these barycentric
    /// `coordinates` in it: what passes the side where the flow to the point comes in. Infinite where it is full there.
    pub(crate) fn carried_to(&self, t: usize, sub: usize, coordinates: [f64; 3]) -> f64 {
        // Full corners have one; weights add up to it but for rounding.
        const FULL: f64 = 1.0 - 1e-12;
        let s = t * self.volumes.per_triangle + sub;
        let (block, nodes) = (&self.blocks[s], self.volumes.triangles[s]);
        let downstream = (0..3).filter(|&i| block.carried[i] > 0.0);
        let way = downstream.map(|i| coordinates[i] / block.carried[i]).fold(f64::INFINITY, f64::min);
        let entry = |i: usize| coordinates[i] - way * block.carried[i];
        let mean = |values: &[f64]| (0..3).map(|i| entry(i) * values[nodes[i] as usize]).sum::<f64>();
        if mean(&self.fraction.values) < FULL { mean(&self.oil) } else { f64::INFINITY }
    }
}

/// Thickness u [m] of the oil that leaves each node of a film; zero where nothing does.
///
/// # Errors
/// The sub-mesh does not fit in memory.
pub(crate) fn oil_carried(
    problem: &FilmProblem,
    system: &FilmSystem,
    fraction: &FilmFraction,
) -> Result<Vec<f64>, oilwedge_fem::Error> {
    let volumes = system.volumes()?;
    Ok(oil_of(volumes, &blocks(&FilmLaw::new(problem, 1.0), system.space(), volumes), fraction))
}

fn oil_of(volumes: &ControlVolumes, blocks: &[Block], fraction: &FilmFraction) -> Vec<f64> {
    // What a full film carries away from each node, over what one of unit thickness does.
    let mut leaving = vec![[0.0; 2]; fraction.values.len()];
    for (block, nodes) in blocks.iter().zip(&volumes.triangles) {
        for (node, k) in nodes.iter().zip(block.carried).filter(|(_, k)| *k < 0.0) {
            let [full, of_unit] = &mut leaving[*node as usize];
            *full += k;
            *of_unit += k / block.dragged;
        }
    }
    let oil = |(theta, [full, of_unit]): (&f64, &[f64; 2])| if *of_unit < 0.0 { theta * full / of_unit } else { 0.0 };
    fraction.values.iter().zip(&leaving).map(oil).collect()
}

/// Powers [W] of a mass-conserving film with the pressures `excess` [Pa] above that of the ends; that of shear,
/// `shear`, is given.
pub(crate) fn work(carriage: &Carriage, film: &FilmSolution, excess: &[f64], shear: f64) -> PowerIntegrals {
    let mut sum = PowerIntegrals { shear, ..PowerIntegrals::default() };
    for (excess, taken_up) in excess.iter().zip(&carriage.taken_up) {
        sum.motion -= excess * taken_up;
    }
    for (t, nodes) in carriage.volumes.triangles.iter().enumerate() {
        let at = |values: &[f64]| nodes.map(|node| values[node as usize]);
        let (p, q, theta) = (at(excess), at(&film.unknown), at(&carriage.fraction.values));
        let block = &carriage.blocks[t];
        let (pressure, motion) = carried(block, p, theta);
        sum += PowerIntegrals {
            cavity_shear: 0.0,
            shear: 0.0,
            pressure,
            dragged: pressure,
            uneven: 0.0,
            motion,
            driven: driven(block, p, q),
        };
    }
    sum
}

/// What dragging oil along and taking it up works, in one sub-triangle.
fn carried(block: &Block, p: [f64; 3], theta: [f64; 3]) -> (f64, f64) {
    let transport = block.transport();
    let outflow: f64 = (0..3).map(|i| p[i] * (0..3).map(|j| transport[i][j] * theta[j]).sum::<f64>()).sum();
    let stored: f64 = (0..3).map(|i| p[i] * block.storage[i] * theta[i]).sum();
    (stored - outflow, -stored)
}

fn driven(block: &Block, p: [f64; 3], q: [f64; 3]) -> f64 {
    let along = |(k, (a, b)): (usize, (usize, usize))| -block.stiffness[k] * (p[a] - p[b]) * (q[a] - q[b]);
    SIDES.into_iter().enumerate().map(along).sum()
}
