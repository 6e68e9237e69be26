//! A sparse matrix of the dofs of a mesh and the functions of a gap, the splines of a grid among them, triangle by
//! triangle.

use std::ops::AddAssign;

use oilwedge_fem::Space;
use oilwedge_fem::integrate::Nodal;

/// Functions of each triangle, and for each of these the entries with all of its dofs.
#[derive(Debug, Clone, Default)]
pub(super) struct Blocks {
    /// End of the functions of each triangle.
    ends: Vec<usize>,
    functions: Vec<u32>,
    /// All dofs of one function after those of the one before.
    entries: Vec<f64>,
}

impl Blocks {
    /// Adds, at a point of a triangle, the `value` of a function there times the shares of the point in the first
    /// `shapes` dofs of the triangle.
    #[inline]
    pub(super) fn add(&mut self, function: usize, value: f64, shares: &Nodal, shapes: usize) {
        // A triangle knows few functions.
        let place = self.functions.iter().position(|&other| other == function as u32);
        let place = place.unwrap_or_else(|| {
            self.functions.push(function as u32);
            self.entries.extend(std::iter::repeat_n(0.0, shapes));
            self.functions.len() - 1
        });
        let entries = &mut self.entries[place * shapes..(place + 1) * shapes];
        (entries.iter_mut().zip(shares)).for_each(|(sum, share)| *sum += value * share);
    }

    /// The block of a triangle to which all has been added.
    pub(super) fn ended(mut self) -> Self {
        self.ends.push(self.functions.len());
        self
    }

    /// The product with a number for each function: one for each dof of the space.
    pub(super) fn times(&self, space: &Space, of_functions: &[f64]) -> Vec<f64> {
        let mut of_dofs = vec![0.0; space.dofs()];
        self.each(space, |function, dofs, entries| {
            for (&dof, entry) in dofs.iter().zip(entries) {
                of_dofs[dof] += entry * of_functions[function];
            }
        });
        of_dofs
    }

    /// The transposed product, with a number for each dof: one for each of so many functions.
    pub(super) fn transposed(&self, space: &Space, of_dofs: &[f64], functions: usize) -> Vec<f64> {
        let mut of_functions = vec![0.0; functions];
        self.each(space, |function, dofs, entries| {
            let sum: f64 = entries.iter().zip(dofs).map(|(part, &dof)| part * of_dofs[dof]).sum();
            of_functions[function] += sum;
        });
        of_functions
    }

    /// Calls `visit` with each function of each triangle, the dofs of the triangle and the entries of both.
    fn each(&self, space: &Space, mut visit: impl FnMut(usize, &[usize], &[f64])) {
        let (shapes, mut begin) = (space.shapes(), 0);
        for (t, &end) in self.ends.iter().enumerate() {
            let dofs = &space.element_dofs(t)[..shapes];
            for k in begin..end {
                let entries = &self.entries[k * shapes..(k + 1) * shapes];
                visit(self.functions[k] as usize, dofs, entries);
            }
            begin = end;
        }
    }
}

impl AddAssign for Blocks {
    fn add_assign(&mut self, mut other: Self) {
        let before = self.functions.len();
        self.ends.extend(other.ends.iter().map(|end| before + end));
        self.functions.append(&mut other.functions);
        self.entries.append(&mut other.entries);
    }
}
