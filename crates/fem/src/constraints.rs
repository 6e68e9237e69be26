//! Given values at degrees of freedom.

/// Which dofs are given, and their values. Systems keep all their rows: given ones are masked.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraints {
    /// True where the value is given.
    pub fixed: Vec<bool>,
    /// Given values; zero elsewhere.
    pub values: Vec<f64>,
}

impl Constraints {
    /// No dof given.
    pub fn none(dofs: usize) -> Self {
        Self { fixed: vec![false; dofs], values: vec![0.0; dofs] }
    }

    /// Gives dof `dof` the value `value`, also if it had another.
    pub fn fix(&mut self, dof: usize, value: f64) {
        self.fixed[dof] = true;
        self.values[dof] = value;
    }

    /// Sets the given values in `u`.
    pub fn impose(&self, u: &mut [f64]) {
        for (i, &fixed) in self.fixed.iter().enumerate() {
            if fixed {
                u[i] = self.values[i];
            }
        }
    }

    /// Sum of the sizes of `r` at given dofs.
    pub fn sum_of_reactions(&self, r: &[f64]) -> f64 {
        let given = r.iter().zip(&self.fixed).filter(|(_, fixed)| **fixed);
        given.map(|(r, _)| r.abs()).sum()
    }

    /// Euclidean norm of `r` over the dofs that are not given.
    pub fn free_norm(&self, r: &[f64]) -> f64 {
        let free = r.iter().zip(&self.fixed).filter(|(_, fixed)| !**fixed);
        free.map(|(x, _)| x * x).fold(0.0, |sum: f64, x| sum + x).sqrt()
    }
}
