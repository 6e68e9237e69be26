//! The balances of all nodes, linear in pressure and film fraction.

use oilwedge_fem::{Matrix, in_order};
use rayon::prelude::*;

use super::DiscreteFilm;
use super::blocks::CellMatrix;

/// Least number of nodes whose balances are computed as one task.
const NODES_A_TASK: usize = 4096;

/// Outflow of every cell, `K p + B theta + constant`.
pub(super) struct CellBalance {
    /// Matrix K of the flow that pressure drives.
    pub(super) pressure: Matrix,
    /// Matrix B of the oil that the journal carries.
    pub(super) transport: Matrix,
    /// Flow that depends on neither pressure nor film fraction [m3/s].
    pub(super) constant: Vec<f64>,
}

impl CellBalance {
    /// The balance of the flow that pressure drives, without transport.
    pub(super) fn of_pressure(film: &DiscreteFilm<'_>) -> Self {
        let mut pressure = Matrix::zero(film.volumes.pattern.clone());
        for (block, addresses) in film.blocks.iter().zip(&film.volumes.addresses) {
            add(&mut pressure, addresses, &block.pressure());
        }
        Self {
            transport: Matrix::zero(pressure.pattern.clone()),
            constant: vec![0.0; pressure.pattern.dimension()],
            pressure,
        }
    }

    /// The balance of every node. The flow that pressure drives between two nodes is their coupling times the
    /// difference of their pressures, and is the same for both to the last bit: no oil is lost by rounding at high
    /// pressures.
    pub(super) fn residual(&self, p: &[f64], theta: &[f64]) -> Vec<f64> {
        let carried = self.transport.multiply(theta);
        let pattern = &self.pressure.pattern;
        let balance = |(i, carried): (usize, &f64)| {
            let driven = |k: usize| self.pressure.values[k] * (p[pattern.columns[k] as usize] - p[i]);
            pattern.row(i).map(driven).sum::<f64>() + carried + self.constant[i]
        };
        let rows = carried.par_iter().with_min_len(NODES_A_TASK);
        in_order(rows.enumerate().map(balance))
    }

    /// Tangent of the balance: its change with the unknown of each node, the film fraction in the cavity and the
    /// pressure elsewhere. It is written into `spare` memory, if there is any.
    pub(super) fn tangent(&self, cavity: &[bool], spare: Option<Matrix>) -> Matrix {
        let mut matrix = spare.unwrap_or_else(|| Matrix::zero(self.pressure.pattern.clone()));
        let entries = self.pressure.values.iter().zip(&self.transport.values);
        let columns = &self.pressure.pattern.columns;
        for (value, ((pressure, transport), &column)) in matrix.values.iter_mut().zip(entries.zip(columns)) {
            *value = if cavity[column as usize] { *transport } else { *pressure };
        }
        matrix
    }
}

/// Adds what a sub-triangle contributes.
pub(super) fn add(matrix: &mut Matrix, addresses: &[[u32; 3]; 3], square: &CellMatrix) {
    for (addresses, row) in addresses.iter().zip(square) {
        for (&address, value) in addresses.iter().zip(row) {
            matrix.values[address as usize] += value;
        }
    }
}
