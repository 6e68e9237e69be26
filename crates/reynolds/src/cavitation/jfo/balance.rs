//! The balances of all nodes, linear in pressure and film fraction.

use oilwedge_fem::Matrix;

/// `K p + B theta + constant`: outflow of every cell.
pub(super) struct Balance {
    /// K.
    pub(super) pressure: Matrix,
    /// B.
    pub(super) transport: Matrix,
    /// What neither changes [m3/s].
    pub(super) constant: Vec<f64>,
}

impl Balance {
    /// The balance of every node.
    pub(super) fn residual(&self, p: &[f64], theta: &[f64]) -> Vec<f64> {
        let (driven, carried) = (self.pressure.multiply(p), self.transport.multiply(theta));
        let parts = driven.iter().zip(&carried).zip(&self.constant);
        parts
            .map(|((driven, carried), constant)| driven + carried + constant)
            .collect()
    }

    /// Its change with the unknown of each node: the film fraction in the cavity, the pressure elsewhere.
    pub(super) fn tangent(&self, cavity: &[bool]) -> Matrix {
        let mut matrix = self.pressure.clone();
        let entries = matrix
            .values
            .iter_mut()
            .zip(&self.transport.values)
            .zip(&matrix.pattern.columns);
        for ((value, transport), &column) in entries {
            if cavity[column as usize] {
                *value = *transport;
            }
        }
        matrix
    }
}
