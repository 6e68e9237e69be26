//! Elimination order for the sparse Cholesky factorisation: nested dissection by coordinates.
//!
//! The vertices are halved at the median of x or of z, whichever leaves the smaller separator;
//! the separator (vertices of the first half that touch the second) is eliminated last. Dofs
//! inside an edge or a triangle follow right after its first-eliminated vertex, so separators of
//! vertices separate all dofs. The seam of a ring needs no special case: touching is topology.
//! On film meshes this fills less than minimum degree (George 1973 for the idea).

use oilwedge_mesh::Mesh;

use crate::Space;

/// Parts of at most this many vertices are not halved again.
const LEAF: usize = 16;

/// `order[k]` is the dof that is eliminated `k`-th.
pub fn elimination_order(space: &Space) -> Vec<u32> {
    let mesh = space.mesh();
    let neighbours = Neighbours::of(mesh);
    let mut vertices: Vec<Vertex> = (0..).zip(mesh.points()).map(|(number, &point)| Vertex { point, number }).collect();
    let mut dissection = Dissection {
        neighbours: &neighbours,
        stamps: vec![0; vertices.len()],
        stamp: 0,
        order: Vec::with_capacity(vertices.len()),
    };
    dissection.dissect(&mut vertices);
    let order = dissection.order;
    interleave(space, &order)
}

/// Dofs of edges and triangles after their first-eliminated vertex.
fn interleave(space: &Space, vertices: &[u32]) -> Vec<u32> {
    let topology = space.mesh().topology();
    let mut rank = vec![0u32; vertices.len()];
    for (k, &v) in vertices.iter().enumerate() {
        rank[v as usize] = k as u32;
    }
    let first = |ends: &[u32]| ends.iter().map(|&v| rank[v as usize]).min().unwrap_or(0) as usize;
    // Counting sort of all dofs by the rank of the vertex that they follow.
    let (ne, nt) = (space.per_edge(), space.per_triangle());
    let mut start = vec![0u32; vertices.len() + 1];
    for k in 0..vertices.len() {
        start[k + 1] += 1;
    }
    for ends in &topology.edges {
        start[first(ends) + 1] += ne as u32;
    }
    for corners in space.mesh().triangles() {
        start[first(corners) + 1] += nt as u32;
    }
    for k in 0..vertices.len() {
        start[k + 1] += start[k];
    }
    let mut order = vec![0u32; space.dofs()];
    let mut put = |group: usize, dof: usize| {
        order[start[group] as usize] = dof as u32;
        start[group] += 1;
    };
    for (k, &v) in vertices.iter().enumerate() {
        put(k, space.vertex_dof(v));
    }
    if ne > 0 {
        for (e, ends) in (0u32..).zip(&topology.edges) {
            let dof = space.edge_dof(e);
            (0..ne).for_each(|m| put(first(ends), dof + m));
        }
    }
    if nt > 0 {
        for (t, corners) in (0u32..).zip(space.mesh().triangles()) {
            let dof = space.triangle_dof(t);
            (0..nt).for_each(|m| put(first(corners), dof + m));
        }
    }
    order
}

/// Neighbours of every vertex.
struct Neighbours {
    start: Vec<u32>,
    list: Vec<u32>,
}

impl Neighbours {
    fn of(mesh: &Mesh) -> Self {
        let edges = &mesh.topology().edges;
        let mut start = vec![0u32; mesh.points().len() + 1];
        for &v in edges.iter().flatten() {
            start[v as usize + 1] += 1;
        }
        for v in 0..mesh.points().len() {
            start[v + 1] += start[v];
        }
        let mut next = start.clone();
        let mut list = vec![0u32; 2 * edges.len()];
        for &[a, b] in edges {
            for (from, to) in [(a, b), (b, a)] {
                list[next[from as usize] as usize] = to;
                next[from as usize] += 1;
            }
        }
        Self { start, list }
    }

    fn of_vertex(&self, v: u32) -> &[u32] {
        &self.list[self.start[v as usize] as usize..self.start[v as usize + 1] as usize]
    }
}

/// A vertex with its place at hand: halving looks at little else.
#[derive(Debug, Clone, Copy)]
struct Vertex {
    point: [f64; 2],
    number: u32,
}

impl Vertex {
    /// Order of the vertices by coordinate `axis`, then by the other coordinate, then by number: a strict order.
    fn compare(&self, other: &Self, axis: usize) -> std::cmp::Ordering {
        self.point[axis]
            .total_cmp(&other.point[axis])
            .then(self.point[1 - axis].total_cmp(&other.point[1 - axis]))
            .then(self.number.cmp(&other.number))
    }
}

struct Dissection<'a> {
    neighbours: &'a Neighbours,
    /// Marks the second half of the split that is looked at.
    stamps: Vec<u32>,
    stamp: u32,
    order: Vec<u32>,
}

impl Dissection<'_> {
    fn dissect(&mut self, part: &mut [Vertex]) {
        if part.len() <= LEAF {
            self.eliminate(part);
            return;
        }
        let half = part.len() / 2;
        part.select_nth_unstable_by(half, |a, b| a.compare(b, 0));
        let by_x = self.separator_size(&part[..half], &part[half..]);
        let halved_by_x = part.to_vec();
        part.select_nth_unstable_by(half, |a, b| a.compare(b, 1));
        let by_z = self.separator_size(&part[..half], &part[half..]);
        if by_x <= by_z {
            part.copy_from_slice(&halved_by_x);
            self.separator_size(&part[..half], &part[half..]);
        }
        drop(halved_by_x);
        let (first, second) = part.split_at_mut(half);
        // Separator to the end of the first half, in coordinate order.
        let (inner, mut separator): (Vec<Vertex>, Vec<Vertex>) = first.iter().partition(|v| !self.touches(v));
        separator.sort_unstable_by(|a, b| a.compare(b, 0));
        let kept = inner.len();
        first[..kept].copy_from_slice(&inner);
        drop(inner);
        if kept == 0 {
            // Everything touches: no split is left to gain.
            self.eliminate(second);
        } else {
            self.dissect(&mut first[..kept]);
            self.dissect(second);
        }
        self.eliminate(&separator);
    }

    fn eliminate(&mut self, part: &[Vertex]) {
        self.order.extend(part.iter().map(|v| v.number));
    }

    /// Stamps the second half and counts the vertices of the first that touch it.
    fn separator_size(&mut self, first: &[Vertex], second: &[Vertex]) -> usize {
        self.stamp += 1;
        for v in second {
            self.stamps[v.number as usize] = self.stamp;
        }
        first.iter().filter(|v| self.touches(v)).count()
    }

    /// Whether a vertex touches the half that was stamped last.
    fn touches(&self, v: &Vertex) -> bool {
        let neighbours = self.neighbours.of_vertex(v.number);
        neighbours.iter().any(|&n| self.stamps[n as usize] == self.stamp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assembly::tests::wavy_ring;

    #[test]
    fn order_is_a_permutation() {
        for degree in 1..=3 {
            let space = Space::new(wavy_ring(40, 9), degree);
            let mut order = elimination_order(&space);
            order.sort_unstable();
            assert!(order.iter().enumerate().all(|(k, &dof)| dof == k as u32));
            assert_eq!(order.len(), space.dofs());
        }
    }
}
