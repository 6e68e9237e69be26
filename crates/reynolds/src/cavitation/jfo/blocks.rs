//! The contribution of one sub-triangle to the balances of its three cells.
//!
//! ```text
//! R = K p + B theta      outflow through the inner faces of the cells, and what they store
//! K_ab = |T| sum_d k_d dl_a/dx_d dl_b/dx_d                   Poiseuille, linear elements
//! k_i = |T| F.grad l_i,   s = sum k_j^-                      F: flow of a full film in T
//! B_jj = -k_j^-,   B_ij = -k_i^+ k_j^- / s                   from each corner j upstream to each corner i downstream
//! ```
//! `1/k_d` and `F_d/k_d` are the means of `12 mu/h^3` and `(12 mu/h^3) U h/2` over T, which is exact along a flow that
//! does not vary (Scharfetter, Gummel, IEEE Trans. Electron Devices 16 (1969) 64, for the idea). B is the N scheme
//! (narrow) for the transport of theta by F: without the crosswind smearing of upwind faces, positive, and of first
//! order where theta < 1. Where theta = 1 each cell loses `-(k_a + k_b)/2` of its sides, as much as through its inner
//! faces: the full film is that of central finite volumes. What passes T is `theta F` everywhere, nothing in B is
//! chosen by the cavity, and the film follows from its cavity alone. Columns sum to zero, but for what is stored.
//!
//! Roe, Cranfield CoA 8703 (1987); Struijs, Deconinck, Roe, VKI LS 1991-01.

use oilwedge_fem::control_volumes::sub_triangles;
use oilwedge_fem::{ControlVolumes, Space};
use rayon::prelude::*;

use crate::film_law::{AtPoints, FilmAndFlows, FilmLaw};
use crate::film_point::dragged_thickness;
use crate::{FilmChange, FilmFlow, FilmPoint};

/// Sides of a sub-triangle, from corner to corner.
pub(super) const SIDES: [(usize, usize); 3] = [(0, 1), (1, 2), (2, 0)];
/// Triangles that one task visits.
const CELLS_A_TASK: usize = 1024;

/// Coefficients of one sub-triangle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Block {
    /// Coupling `K_ab` of each side.
    pub(super) stiffness: [f64; 3],
    /// Inflow parameters `k_i` of the corners [m3/s].
    pub(super) carried: [f64; 3],
    /// Volume taken up by each cell's piece while full [m3/s].
    pub(super) storage: [f64; 3],
    /// Volume of each cell's piece while full [m3].
    pub(super) volume: [f64; 3],
    /// Thickness [m] that a full film of the flow F has: `2 F.U/U^2`; zero at rest.
    pub(super) dragged: f64,
}

/// Matrix of a sub-triangle, row by row.
pub(super) type CellMatrix = [[f64; 3]; 3];

/// The coefficients of all sub-triangles under `law`.
pub(super) fn blocks(law: &FilmLaw, space: &Space, volumes: &ControlVolumes) -> Vec<Block> {
    let mut blocks = vec![Block::default(); volumes.triangles.len()];
    let tasks = blocks.par_chunks_mut(volumes.per_triangle * CELLS_A_TASK).enumerate();
    tasks.for_each(|(task, chunk)| {
        for (k, blocks) in chunk.chunks_mut(volumes.per_triangle).enumerate() {
            let cell = task * CELLS_A_TASK + k;
            let points = EvaluationPoints::new(space, cell);
            let at = law.oil_and_flows(cell, points.positions());
            for (t, block) in blocks.iter_mut().enumerate() {
                *block = points.block(t, &at, None);
            }
        }
    });
    blocks
}

/// Changes of the balances of the corners of every sub-triangle [m3/s] with each of some `changes` of the law, made of
/// its block and the change of that by `of_block`: change by change for one sub-triangle after the other.
pub(super) fn balance_changes(
    law: &FilmLaw,
    changes: &[FilmChange<'_>],
    (space, volumes): (&Space, &ControlVolumes),
    of_block: impl Fn(usize, &[Block; 2]) -> [f64; 3] + Sync,
) -> Vec<[f64; 3]> {
    let mut balances = vec![[0.0; 3]; volumes.triangles.len() * changes.len()];
    let of_cell = volumes.per_triangle * changes.len();
    balances.par_chunks_mut(of_cell * CELLS_A_TASK).enumerate().for_each(|(task, chunk)| {
        for (k, balances) in chunk.chunks_mut(of_cell).enumerate() {
            let cell = task * CELLS_A_TASK + k;
            let points = EvaluationPoints::new(space, cell);
            let mut upwind: [Option<Block>; 4] = [None; 4];
            let place = (cell, points.positions());
            law.oil_and_flows_with_changes(changes, place, |number, at, change| {
                for (t, upwind) in upwind.iter_mut().enumerate().take(volumes.per_triangle) {
                    let block = *upwind.get_or_insert_with(|| points.block(t, at, None));
                    let moved = points.block(t, at, Some(change));
                    balances[t * changes.len() + number] = of_block(cell * volumes.per_triangle + t, &[block, moved]);
                }
            });
        }
    });
    balances
}

/// Points at which the film of a triangle is evaluated: at its nodes, and in the middle of every side of its
/// sub-triangles.
pub(super) struct EvaluationPoints {
    positions: AtPoints<[f64; 2]>,
    number: usize,
    /// Nodes at the corners of each sub-triangle: the first points.
    pub(super) sub_triangles: &'static [[usize; 3]],
    /// The points in the middles of the sides of each sub-triangle.
    pub(super) middles: [[usize; 3]; 4],
}

impl EvaluationPoints {
    pub(super) fn new(space: &Space, cell: usize) -> Self {
        let nodes = space.mesh().nodes(cell);
        let mut points = Self {
            positions: AtPoints::default(),
            number: space.shapes(),
            sub_triangles: sub_triangles(space, cell),
            middles: [[0; 3]; 4],
        };
        points.positions[..points.number].copy_from_slice(&nodes[..points.number]);
        // A side inside the triangle belongs to two of them.
        let mut ends = AtPoints::<[usize; 2]>::default();
        for (t, corners) in points.sub_triangles.iter().enumerate() {
            for (k, (i, j)) in SIDES.into_iter().enumerate() {
                let (a, b) = (corners[i].min(corners[j]), corners[i].max(corners[j]));
                let known = (space.shapes()..points.number).find(|&point| ends[point] == [a, b]);
                points.middles[t][k] = known.unwrap_or_else(|| {
                    ends[points.number] = [a, b];
                    points.positions[points.number] = [0, 1].map(|d| 0.5 * (nodes[a][d] + nodes[b][d]));
                    points.number += 1;
                    points.number - 1
                });
            }
        }
        points
    }

    pub(super) fn positions(&self) -> &[[f64; 2]] {
        &self.positions[..self.number]
    }

    /// Coefficients of sub-triangle `t`, or their change with a change of film and flows.
    pub(super) fn block(&self, t: usize, at: &FilmAndFlows, change: Option<&FilmAndFlows>) -> Block {
        let (corners, middles) = (self.sub_triangles[t], self.middles[t]);
        let flow = match change {
            None => Flow::mean(&middles.map(|point| at.1[point])),
            Some(change) => Flow::change(&middles.map(|point| at.1[point]), &middles.map(|point| change.1[point])),
        };
        let (film, flows) = change.unwrap_or(at);
        let velocity = at.0[corners[0]].velocity;
        let x = corners.map(|point| self.positions[point]);
        Block::new(velocity, x, corners.map(|point| film[point]), corners.map(|point| flows[point]), flow)
    }
}

/// Flow in a sub-triangle: conductance and flux that are exact for a flow that does not vary along it, however the
/// thickness varies: `J_d = F_d - k_d dp/dx_d` with `1/k_d` and `F_d/k_d` the means of those at the points.
#[derive(Debug, Clone, Copy, Default)]
struct Flow {
    conductance: [f64; 2],
    flux: [f64; 2],
}

impl Flow {
    fn mean(points: &[FilmFlow]) -> Self {
        let resistance = |d: usize| points.iter().map(|flow| 1.0 / flow.conductance[d]).sum::<f64>();
        let drive = |d: usize| points.iter().map(|flow| flow.flux[d] / flow.conductance[d]).sum::<f64>();
        let resistances = [resistance(0), resistance(1)];
        Self {
            conductance: resistances.map(|resistance| points.len() as f64 / resistance),
            flux: [drive(0) / resistances[0], drive(1) / resistances[1]],
        }
    }

    /// First-order change of [`Flow::mean`].
    fn change(points: &[FilmFlow], changes: &[FilmFlow]) -> Self {
        let mean = Self::mean(points);
        let mut change = Self::default();
        for (flow, by) in points.iter().zip(changes) {
            for d in 0..2 {
                let weight = mean.conductance[d] / flow.conductance[d] / points.len() as f64;
                let relative = by.conductance[d] / flow.conductance[d];
                change.conductance[d] += weight * mean.conductance[d] * relative;
                change.flux[d] += weight * (by.flux[d] - relative * (flow.flux[d] - mean.flux[d]));
            }
        }
        change
    }
}

impl Block {
    /// The coefficients for corners at `x` and this flow.
    fn new(velocity: [f64; 2], x: [[f64; 2]; 3], film: [FilmPoint; 3], flows: [FilmFlow; 3], flow: Flow) -> Self {
        let doubled = (x[1][0] - x[0][0]) * (x[2][1] - x[0][1]) - (x[1][1] - x[0][1]) * (x[2][0] - x[0][0]);
        let area = 0.5 * doubled;
        // Gradients of the linear functions: the opposite side turned by 90 degrees.
        let gradient = [0, 1, 2].map(|i| {
            let (b, c) = (x[(i + 1) % 3], x[(i + 2) % 3]);
            [(b[1] - c[1]) / doubled, (c[0] - b[0]) / doubled]
        });
        let mut block = Self {
            carried: gradient.map(|g| area * (flow.flux[0] * g[0] + flow.flux[1] * g[1])),
            // The centroid of a cell's piece lies at (22, 7, 7)/36.
            storage: [0, 1, 2].map(|i| weighted(i, |k| flows[k].storage) * area / 3.0),
            volume: [0, 1, 2].map(|i| weighted(i, |k| film[k].thickness) * area / 3.0),
            dragged: dragged_thickness(velocity, flow.flux),
            ..Self::default()
        };
        let [k_x, k_z] = flow.conductance;
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let (g, h) = (gradient[a], gradient[b]);
            block.stiffness[k] = k_x * area * (g[0] * h[0] + g[1] * h[1]) + (k_z - k_x) * area * g[1] * h[1];
        }
        block
    }

    /// Matrix `K` of the block.
    pub(super) fn pressure(&self) -> CellMatrix {
        let mut square = [[0.0; 3]; 3];
        for (k, (a, b)) in SIDES.into_iter().enumerate() {
            let coupling = self.stiffness[k];
            square[a][b] += coupling;
            square[b][a] += coupling;
            square[a][a] -= coupling;
            square[b][b] -= coupling;
        }
        square
    }

    /// Matrix `B` of the block.
    pub(super) fn transport(&self) -> CellMatrix {
        let (k, s) = (self.carried, self.inflow());
        let mut square = self.taken_up();
        for j in (0..3).filter(|&j| k[j] < 0.0) {
            square[j][j] -= k[j];
            for i in (0..3).filter(|&i| k[i] > 0.0) {
                square[i][j] -= k[i] * k[j] / s;
            }
        }
        square
    }

    /// Change of the `B` of the block `of`, where this is the change of that block; the corners upstream stay.
    pub(super) fn transport_change(&self, of: &Self) -> CellMatrix {
        let (k, s, change) = (of.carried, of.inflow(), self.carried);
        let change_of_s: f64 = (0..3).filter(|&j| k[j] < 0.0).map(|j| change[j]).sum();
        let mut square = self.taken_up();
        for j in (0..3).filter(|&j| k[j] < 0.0) {
            square[j][j] -= change[j];
            for i in (0..3).filter(|&i| k[i] > 0.0) {
                square[i][j] -= (change[i] * k[j] + k[i] * change[j] - k[i] * k[j] * change_of_s / s) / s;
            }
        }
        square
    }

    /// Volume that the cells take up for their own film fraction.
    fn taken_up(&self) -> CellMatrix {
        let mut square = [[0.0; 3]; 3];
        for i in 0..3 {
            square[i][i] = self.storage[i];
        }
        square
    }

    /// Sum of the inflow parameters of the corners upstream, `sum k_j^-`.
    pub(super) fn inflow(&self) -> f64 {
        self.carried.iter().map(|k| k.min(0.0)).sum()
    }

    /// Thickness [m] of the oil that comes in through the corners upstream, which oil of the thickness `u` [m] leaves.
    pub(super) fn inflowing(&self, u: [f64; 3]) -> f64 {
        (0..3).map(|i| self.carried[i].min(0.0) * u[i]).sum::<f64>() / self.inflow()
    }
}

fn weighted(i: usize, value: impl Fn(usize) -> f64) -> f64 {
    (0..3).map(|k| if k == i { 22.0 } else { 7.0 } / 36.0 * value(k)).sum()
}
