//! The one element loop: residual `R_i = Int (s phi_i - F . grad phi_i)` and its tangent.
//!
//! Triangles belong to their least vertex. Vertices are cut in ranges, whose number is that of the mesh; a range
//! owns a contiguous block of rows, writes there directly, and lists what it owes to later blocks.
//! The lists are added in order, so any number of threads gives the same bits.

use std::ops::Range;
use std::sync::Arc;

use oilwedge_mesh::Mesh;
use rayon::prelude::*;

use crate::conservation_law::{ConservationLaw, TangentKind};
use crate::element::{Element, ElementKernel};
use crate::in_order;
use crate::lagrange::MOST_SHAPES;
use crate::sparsity::{Addresses, Sparsity};
use crate::{Matrix, Pattern, Space};

/// Most blocks of rows that are assembled independently.
const MOST_RANGES: usize = 32;
/// Least triangles of a block: fewer take less time than it takes to share them out.
const LEAST_TRIANGLES: usize = 256;

/// Assembles laws on one space.
#[derive(Debug)]
pub struct Assembler {
    space: Space,
    sparsity: Arc<Sparsity>,
    kernel: Arc<ElementKernel>,
    ranges: Vec<VertexRange>,
}

/// What a contiguous range of vertices owns.
#[derive(Debug, Clone)]
struct VertexRange {
    triangles: Range<usize>,
    rows: Range<usize>,
    entries: Range<usize>,
}

/// Contributions `(index, value)` to blocks of other ranges.
#[derive(Default)]
struct Owed {
    residual: Vec<(u32, f64)>,
    entries: Vec<(u32, f64)>,
}

impl Assembler {
    /// An assembler with the quadrature rule that suits the degree of the space ([`crate::Quadrature::for_degree`]).
    pub fn new(space: Space) -> Self {
        let sparsity = Sparsity::new(&space);
        let kernel = Arc::new(ElementKernel::new(space.degree()));
        let ranges = vertex_ranges(&space, &sparsity);
        Self { space, sparsity: Arc::new(sparsity), kernel, ranges }
    }

    /// The assembler on a mesh whose vertices lie elsewhere, with the triangles of this one.
    #[must_use]
    pub fn on_moved(&self, mesh: Arc<Mesh>) -> Self {
        Self {
            space: self.space.on_moved(mesh),
            sparsity: self.sparsity.clone(),
            kernel: self.kernel.clone(),
            ranges: self.ranges.clone(),
        }
    }

    /// The space.
    pub fn space(&self) -> &Space {
        &self.space
    }

    /// The pattern of tangents.
    pub fn pattern(&self) -> &Arc<Pattern> {
        &self.sparsity.pattern
    }

    /// Where the entries of the element matrix of triangle `t`, with the dofs `dofs`, are in a tangent.
    pub fn addresses(&self, t: usize, dofs: &[usize; MOST_SHAPES]) -> Addresses {
        self.sparsity.addresses(&self.space, t, dofs)
    }

    /// Residual of `law` at `u` (one value a dof).
    pub fn residual(&self, law: &dyn ConservationLaw, u: &[f64]) -> Vec<f64> {
        self.assemble(law, u, &mut [])
    }

    /// Tangent and residual of `law` at `u`; `matrix` is overwritten.
    pub fn tangent_and_residual(&self, law: &dyn ConservationLaw, u: &[f64], matrix: &mut Matrix) -> Vec<f64> {
        self.assemble(law, u, &mut matrix.values)
    }

    /// `entries` is empty if only the residual is wanted.
    fn assemble(&self, law: &dyn ConservationLaw, u: &[f64], entries: &mut [f64]) -> Vec<f64> {
        let mut residual = vec![0.0; self.space.dofs()];
        let mut blocks = Vec::with_capacity(self.ranges.len());
        let (mut rest, mut rest_entries) = (&mut residual[..], &mut entries[..]);
        for range in &self.ranges {
            let (block, after) = rest.split_at_mut(range.rows.len());
            let wanted = if rest_entries.is_empty() { 0 } else { range.entries.len() };
            let (block_entries, entries_after) = rest_entries.split_at_mut(wanted);
            (rest, rest_entries) = (after, entries_after);
            blocks.push((range, block, block_entries));
        }
        let owed = blocks
            .into_par_iter()
            .map(|(range, block, block_entries)| self.assemble_range(law, u, range, block, block_entries));
        let owed: Vec<Owed> = in_order(owed);
        for owed in owed {
            for (index, value) in owed.residual {
                residual[index as usize] += value;
            }
            for (index, value) in owed.entries {
                entries[index as usize] += value;
            }
        }
        residual
    }

    fn assemble_range(
        &self,
        law: &dyn ConservationLaw,
        u: &[f64],
        range: &VertexRange,
        residual: &mut [f64],
        entries: &mut [f64],
    ) -> Owed {
        let n = self.space.shapes();
        let tangent = law.tangent();
        // Here rather than all at once: by the thread that needs this block, while it is at hand.
        entries.fill(0.0);
        let mut owed = Owed::default();
        let mut element = Element::default();
        let mut nodal = [0.0; crate::lagrange::MOST_SHAPES];
        for t in range.triangles.clone() {
            let dofs = self.space.element_dofs(t);
            for i in 0..n {
                nodal[i] = u[dofs[i]];
            }
            match tangent {
                TangentKind::Conduction => self.kernel.conduction(law, self.space.mesh(), t, &nodal, &mut element),
                TangentKind::Symmetric => self.kernel.response(law, self.space.mesh(), t, &nodal, &mut element),
            }
            for i in 0..n {
                match dofs[i].checked_sub(range.rows.start).and_then(|row| residual.get_mut(row)) {
                    Some(own) => *own += element.residual[i],
                    None => owed.residual.push((dofs[i] as u32, element.residual[i])),
                }
            }
            if entries.is_empty() {
                continue;
            }
            let addresses = self.sparsity.addresses(&self.space, t, &dofs);
            for i in 0..n {
                let row = addresses[i][..n].iter().zip(&element.tangent[i]);
                if range.rows.contains(&dofs[i]) {
                    for (&address, value) in row {
                        entries[address as usize - range.entries.start] += value;
                    }
                } else {
                    owed.entries.extend(row.map(|(&address, &value)| (address, value)));
                }
            }
        }
        owed
    }
}

fn vertex_ranges(space: &Space, sparsity: &Sparsity) -> Vec<VertexRange> {
    let vertices = space.mesh().points().len();
    let triangle_start = &space.mesh().topology().triangle_start;
    let ranges = (space.mesh().triangles().len() / LEAST_TRIANGLES).clamp(1, MOST_RANGES);
    (0..ranges)
        .map(|k| {
            let (from, to) = (k * vertices / ranges, (k + 1) * vertices / ranges);
            let rows = space.vertex_dof(from as u32)..space.vertex_dof(to as u32);
            VertexRange {
                triangles: triangle_start[from] as usize..triangle_start[to] as usize,
                entries: sparsity.pattern.row_start[rows.start] as usize..sparsity.pattern.row_start[rows.end] as usize,
                rows,
            }
        })
        .collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::conservation_law::{Conduction, Response, State};
    use crate::{Dual, Field};
    use oilwedge_mesh::{Mesh, RawMesh};

    /// A ring of `columns` times `rows` squares with period `columns`, two triangles each, with one bulged edge.
    pub(crate) fn wavy_ring(columns: u32, rows: u32) -> Arc<Mesh> {
        let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
        let points = (0..columns * (rows + 1))
            .map(|k| {
                let (i, j) = (f64::from(k / (rows + 1)), f64::from(k % (rows + 1)));
                let inside = j * (f64::from(rows) - j);
                [i + 0.05 * (1.7 * j).sin(), j + 0.03 * inside.min(1.0) * (2.3 * i).sin()]
            })
            .collect();
        let mut triangles = Vec::new();
        for i in 0..columns {
            for j in 0..rows {
                let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
                triangles.extend([[a, b, c], [a, c, d]]);
            }
        }
        let raw = RawMesh {
            points,
            triangles,
            bulges: vec![(0, 2, [0.03, -0.02])],
            period: Some(f64::from(columns)),
            ..RawMesh::default()
        };
        Arc::new(Mesh::build(raw).unwrap())
    }

    /// `F = (0.3 x, 0.1) - (1 + x^2) D (1, 1 + a z^2) grad u`, `s = 0.7 z` in both forms, with the diagonal D.
    struct Both(TangentKind, [f64; 2], f64);

    impl Both {
        fn conductance(&self, [x, z]: [f64; 2]) -> [f64; 2] {
            let k = 1.0 + x * x;
            [k, k * (1.0 + self.2 * z * z)]
        }
    }

    impl ConservationLaw for Both {
        fn tangent(&self) -> TangentKind {
            self.0
        }
        fn directions(&self) -> [f64; 2] {
            self.1
        }
        fn is_isotropic(&self) -> bool {
            self.2 == 0.0
        }
        fn conduction(&self, _: usize, positions: &[[f64; 2]], out: &mut [Conduction]) {
            for (&[x, z], out) in positions.iter().zip(out) {
                let conductance = self.conductance([x, z]);
                *out = Conduction { conductance, flux: [0.3 * x, 0.1], source: 0.7 * z };
            }
        }
        fn response(&self, _: usize, positions: &[[f64; 2]], states: &[State], out: &mut [Response]) {
            for ((&[x, z], state), out) in positions.iter().zip(states).zip(out) {
                let k = self.conductance([x, z]);
                let driven = |d: usize| state.gradient[d] * (-k[d] * self.1[d]);
                *out = Response { flux: [driven(0) + 0.3 * x, driven(1) + 0.1], source: Dual::constant(0.7 * z) };
            }
        }
    }

    /// `F = -exp(u) grad u`, `s = u^2`.
    struct Nonlinear;

    impl ConservationLaw for Nonlinear {
        fn tangent(&self) -> TangentKind {
            TangentKind::Symmetric
        }
        fn conduction(&self, _: usize, _: &[[f64; 2]], _: &mut [Conduction]) {}
        fn response(&self, _: usize, _: &[[f64; 2]], states: &[State], out: &mut [Response]) {
            for (state, out) in states.iter().zip(out) {
                let k = state.value.exp();
                *out = Response { flux: state.gradient.map(|g| -(k * g)), source: state.value * state.value };
            }
        }
    }

    fn greatest(values: impl IntoIterator<Item = f64>) -> f64 {
        values.into_iter().fold(0.0, |m, v| m.max(v.abs()))
    }

    #[test]
    fn closed_form_and_general_element_agree() {
        let laws = [([1.0; 2], 0.0), ([0.0, 1.0], 0.0), ([1.0; 2], 0.4)];
        for (degree, (along, uneven)) in (1..=3).flat_map(|degree| laws.map(|law| (degree, law))) {
            let assembler = Assembler::new(Space::new(wavy_ring(9, 4), degree));
            let u = assembler.space().interpolate(|x| (0.7 * x[0]).sin() + x[1]);
            let mut closed = Matrix::zero(assembler.pattern().clone());
            let mut general = closed.clone();
            let r = assembler.tangent_and_residual(&Both(TangentKind::Conduction, along, uneven), &u, &mut closed);
            let s = assembler.tangent_and_residual(&Both(TangentKind::Symmetric, along, uneven), &u, &mut general);
            let scale = greatest(general.values.iter().copied());
            assert!(greatest(closed.values.iter().zip(&general.values).map(|(a, b)| a - b)) < 1e-13 * scale);
            assert!(greatest(r.iter().zip(&s).map(|(a, b)| a - b)) < 1e-13 * greatest(s.iter().copied()));
        }
    }

    #[test]
    fn tangent_is_the_derivative_of_the_residual() {
        let assembler = Assembler::new(Space::new(wavy_ring(9, 4), 2));
        let u = assembler.space().interpolate(|x| 0.3 * (0.7 * x[0]).sin() + 0.1 * x[1]);
        let direction = assembler.space().interpolate(|x| (1.1 * x[0]).cos() * x[1]);
        let mut matrix = Matrix::zero(assembler.pattern().clone());
        assembler.tangent_and_residual(&Nonlinear, &u, &mut matrix);
        let exact = matrix.multiply(&direction);
        let step = 1e-6;
        let shifted = |sign: f64| -> Vec<f64> {
            let u: Vec<f64> = u.iter().zip(&direction).map(|(u, d)| u + sign * step * d).collect();
            assembler.residual(&Nonlinear, &u)
        };
        let difference = shifted(1.0).into_iter().zip(shifted(-1.0)).map(|(a, b)| (a - b) / (2.0 * step));
        let error = greatest(difference.zip(&exact).map(|(a, b)| a - b));
        assert!(error < 1e-8 * greatest(exact.iter().copied()), "{error}");
    }

    #[test]
    fn residuals_sum_to_the_integral_of_the_source() {
        let assembler = Assembler::new(Space::new(wavy_ring(9, 4), 2));
        let u = assembler.space().interpolate(|x| x[1] * x[1]);
        let sum: f64 = assembler.residual(&Both(TangentKind::Conduction, [1.0; 2], 0.0), &u).iter().sum();
        // Int 0.7 z over a ring of circumference 9 and height 4.
        assert!((sum - 0.7 * 9.0 * 8.0).abs() < 1e-9, "{sum}");
    }

    #[test]
    fn threads_do_not_change_a_bit() {
        let assembler = Assembler::new(Space::new(wavy_ring(80, 24), 2));
        let u = assembler.space().interpolate(|x| (0.7 * x[0]).sin());
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let mut matrix = Matrix::zero(assembler.pattern().clone());
                let residual = assembler.tangent_and_residual(&Nonlinear, &u, &mut matrix);
                (residual, matrix.values)
            })
        };
        assert!(on(1) == on(3));
        let field = Field { space: assembler.space(), values: &u };
        assert!(field.maximum().value <= 1.01);
    }
}
