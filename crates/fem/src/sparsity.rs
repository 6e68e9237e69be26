//! The pattern of the tangent matrix, laid out by topology: every address is arithmetic, none is searched.
//!
//! | row of | columns, in this order |
//! |---|---|
//! | vertex | itself, neighbours, dofs of incident edges, dofs of opposite edges, dofs of incident triangles |
//! | edge | lesser end, greater end, own dofs; by triangle: opposite vertex, dofs of the next two edges, its dofs |
//! | triangle | corners, dofs of its edges, its dofs |
//!
//! Columns are not sorted. Where an edge stands among those of its ends, and a triangle among
//! those of its corners, is stored once. Verified by `every_address_holds_its_column`.

use std::sync::Arc;

use crate::lagrange::MOST_SHAPES;
use crate::{Pattern, Space};

/// Rows, columns and the ordinals from which addresses follow.
#[derive(Debug)]
pub struct Sparsity {
    /// Rows and columns.
    pub pattern: Arc<Pattern>,
    /// Place of each edge among the edges at its lesser and at its greater end.
    edge_places: Vec<[u32; 2]>,
    /// Place of each triangle among the triangles at its three corners.
    triangle_places: Vec<[u32; 3]>,
    /// Number of edges and of triangles at each vertex.
    valence: Vec<[u32; 2]>,
}

/// Addresses of an element matrix: `[row][column]` in local order.
pub type Addresses = [[u32; MOST_SHAPES]; MOST_SHAPES];

impl Sparsity {
    /// The pattern of a space.
    pub fn new(space: &Space) -> Self {
        let mesh = space.mesh();
        let topology = mesh.topology();
        let mut valence = vec![[0u32; 2]; mesh.points().len()];
        let mut place = |v: u32, kind: usize| {
            let count = &mut valence[v as usize][kind];
            *count += 1;
            *count - 1
        };
        let edge_places = topology.edges.iter().map(|ends| ends.map(|v| place(v, 0))).collect();
        let triangle_places = mesh.triangles().iter().map(|corners| corners.map(|v| place(v, 1))).collect();
        let mut sparsity = Self {
            pattern: Arc::new(Pattern { row_start: Vec::new(), columns: Vec::new() }),
            edge_places,
            triangle_places,
            valence,
        };
        let row_start = sparsity.rows(space);
        let mut columns = vec![0u32; row_start[row_start.len() - 1] as usize];
        sparsity.fill_columns(space, &row_start, &mut columns);
        sparsity.pattern = Arc::new(Pattern { row_start, columns });
        sparsity
    }

    fn rows(&self, space: &Space) -> Vec<u32> {
        let topology = space.mesh().topology();
        let (ne, nt) = (space.per_edge(), space.per_triangle());
        let mut row_start = Vec::with_capacity(space.dofs() + 1);
        let mut end = 0u32;
        row_start.push(end);
        for v in 0..space.mesh().points().len() {
            let [edges, triangles] = self.valence[v].map(|n| n as usize);
            end += (1 + edges + ne * (edges + triangles) + nt * triangles) as u32;
            row_start.push(end);
            for e in topology.edge_start[v]..topology.edge_start[v + 1] {
                let sides = if topology.is_boundary(e) { 1 } else { 2 };
                for _ in 0..ne {
                    end += (2 + ne + sides * (1 + 2 * ne + nt)) as u32;
                    row_start.push(end);
                }
            }
            for _ in topology.triangle_start[v]..topology.triangle_start[v + 1] {
                for _ in 0..nt {
                    end += (3 + 3 * ne + nt) as u32;
                    row_start.push(end);
                }
            }
        }
        row_start
    }

    /// Visits every element once; shared entries are written again with the same column.
    fn fill_columns(&self, space: &Space, row_start: &[u32], columns: &mut [u32]) {
        match space.degree() {
            1 => self.fill_columns_of::<0, 0>(space, row_start, columns),
            2 => self.fill_columns_of::<1, 0>(space, row_start, columns),
            _ => self.fill_columns_of::<2, 1>(space, row_start, columns),
        }
    }

    fn fill_columns_of<const NE: usize, const NT: usize>(&self, space: &Space, row_start: &[u32], columns: &mut [u32]) {
        let n = 3 + 3 * NE + NT;
        for t in 0..space.mesh().triangles().len() {
            let dofs = space.element_dofs(t);
            let addresses = self.addresses_in::<NE, NT>(row_start, space, t, &dofs);
            for i in 0..n {
                for j in 0..n {
                    columns[addresses[i][j] as usize] = dofs[j] as u32;
                }
            }
        }
    }

    /// Addresses of the element matrix of triangle `t` with the dofs `dofs`.
    pub fn addresses(&self, space: &Space, t: usize, dofs: &[usize; MOST_SHAPES]) -> Addresses {
        let row_start = &self.pattern.row_start;
        match space.degree() {
            1 => self.addresses_in::<0, 0>(row_start, space, t, dofs),
            2 => self.addresses_in::<1, 0>(row_start, space, t, dofs),
            _ => self.addresses_in::<2, 1>(row_start, space, t, dofs),
        }
    }

    /// With `NE` dofs inside an edge and `NT` inside a triangle: known when compiled, all loops are straight code.
    // Long: one address for each pair of vertex, edge and triangle; they share the starts of the rows.
    fn addresses_in<const NE: usize, const NT: usize>(
        &self,
        row_start: &[u32],
        space: &Space,
        t: usize,
        dofs: &[usize; MOST_SHAPES],
    ) -> Addresses {
        let topology = space.mesh().topology();
        let triangle = space.mesh().triangles()[t];
        let edges = topology.triangle_edges[t];
        let (ne, nt) = (NE, NT);
        let is_ascending = |k: usize| triangle[k] < triangle[(k + 1) % 3];
        // Where the m-th interior dof along local edge k stands in a block of them.
        let along = |k: usize, m: usize| if is_ascending(k) { m as u32 } else { (NE - 1 - m) as u32 };
        let mut out = [[0u32; MOST_SHAPES]; MOST_SHAPES];
        for k in 0..3 {
            let (next, previous) = ((k + 1) % 3, (k + 2) % 3);
            let row = row_start[dofs[k]];
            let [edges_here, triangles_here] = self.valence[triangle[k] as usize];
            // The vertex is the greater end of an edge that does not rise from it.
            let to_next = self.edge_places[edges[k] as usize][usize::from(!is_ascending(k))];
            let to_previous = self.edge_places[edges[previous] as usize][usize::from(is_ascending(previous))];
            let place = self.triangle_places[t][k];
            let incident = row + 1 + edges_here;
            let opposite = incident + ne as u32 * edges_here;
            let interior = opposite + ne as u32 * triangles_here;
            out[k][k] = row;
            out[k][next] = row + 1 + to_next;
            out[k][previous] = row + 1 + to_previous;
            for m in 0..ne {
                out[k][3 + ne * k + m] = incident + ne as u32 * to_next + along(k, m);
                out[k][3 + ne * previous + m] = incident + ne as u32 * to_previous + along(previous, m);
                out[k][3 + ne * next + m] = opposite + ne as u32 * place + along(next, m);
            }
            for m in 0..nt {
                out[k][3 + 3 * ne + m] = interior + nt as u32 * place + m as u32;
            }
        }
        for k in 0..3 {
            let (next, previous) = ((k + 1) % 3, (k + 2) % 3);
            let side = u32::from(topology.edge_triangles[edges[k] as usize][0] != t as u32);
            let base = (2 + ne) as u32 + side * (1 + 2 * ne + nt) as u32;
            let lesser_first = is_ascending(k);
            for i in 0..ne {
                let row = row_start[dofs[3 + ne * k + i]];
                let target = &mut out[3 + ne * k + i];
                target[k] = row + u32::from(!lesser_first);
                target[next] = row + u32::from(lesser_first);
                target[previous] = row + base;
                for m in 0..ne {
                    target[3 + ne * k + m] = row + 2 + along(k, m);
                    target[3 + ne * next + m] = row + base + 1 + along(next, m);
                    target[3 + ne * previous + m] = row + base + 1 + ne as u32 + along(previous, m);
                }
                for m in 0..nt {
                    target[3 + 3 * ne + m] = row + base + 1 + (2 * ne + m) as u32;
                }
            }
        }
        for i in 0..nt {
            let row = row_start[dofs[3 + 3 * ne + i]];
            let target = &mut out[3 + 3 * ne + i];
            for j in 0..3 + 3 * ne + nt {
                target[j] = row + j as u32;
            }
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::wavy_ring;

    #[test]
    fn every_address_holds_its_column() {
        for degree in 1..=3 {
            let space = Space::new(wavy_ring(7, 3), degree);
            let sparsity = Sparsity::new(&space);
            let Pattern { row_start, columns } = &*sparsity.pattern;
            let mut seen = vec![false; columns.len()];
            for t in 0..space.mesh().triangles().len() {
                let dofs = space.element_dofs(t);
                let addresses = sparsity.addresses(&space, t, &dofs);
                for i in 0..space.shapes() {
                    for j in 0..space.shapes() {
                        let address = addresses[i][j];
                        let row = row_start[dofs[i]]..row_start[dofs[i] + 1];
                        assert!(row.contains(&address));
                        assert_eq!(columns[address as usize], dofs[j] as u32);
                        seen[address as usize] = true;
                    }
                }
            }
            assert!(seen.iter().all(|&s| s), "P{degree}: an entry that no element uses");
            for i in 0..sparsity.pattern.dimension() {
                let mut row = columns[row_start[i] as usize..row_start[i + 1] as usize].to_vec();
                row.sort_unstable();
                assert!(row.windows(2).all(|pair| pair[0] < pair[1]), "P{degree}: column twice in row {i}");
            }
        }
    }
}
