//! Edge lengths of a mesh by place: a tree of halved boxes over its vertices, as deep as its triangles are small. Where
//! there are none, in cut-outs, edges grow with the box.

use crate::Mesh;
use crate::raw::doubled_area;

/// Edge of an equilateral triangle over the root of its doubled area.
const EQUILATERAL_EDGE: f64 = 1.074_569_931_823_542;
/// Edge length in a box without vertices, over the longer side of the box.
const IN_EMPTY_BOX: f64 = 0.5;
/// Boxes are halved no more often than this.
const DEEPEST: u32 = 60;

/// Edge lengths of a mesh by place: boxes that are halved across their longer side until they are no larger than
/// the triangles in them.
pub(crate) struct SizeTree {
    low: [f64; 2],
    /// Width and height of the outermost box [m].
    extent: [f64; 2],
    period: Option<f64>,
    boxes: Vec<SizeBox>,
}

/// A box of the tree.
#[derive(Clone, Copy)]
struct SizeBox {
    /// The lower half; the upper half follows it. Zero if the box is whole.
    halves: u32,
    /// Mean edge length [m] of its triangles.
    size: f64,
}

/// Vertices in a box, before it is halved.
struct Task {
    index: usize,
    from: usize,
    to: usize,
    low: [f64; 2],
    extent: [f64; 2],
    depth: u32,
}

impl SizeTree {
    /// The tree over the vertices of `mesh`.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let period = mesh.period();
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in mesh.points() {
            for k in 0..2 {
                low[k] = low[k].min(point[k]);
                high[k] = high[k].max(point[k]);
            }
        }
        let mut tree =
            Self { low, extent: [period.unwrap_or(high[0] - low[0]), high[1] - low[1]], period, boxes: Vec::new() };
        let sizes = vertex_sizes(mesh);
        let mut vertices: Vec<([f64; 2], f64)> =
            mesh.points().iter().zip(sizes).map(|(&point, size)| (tree.offset(point), size)).collect();
        tree.fill(&mut vertices);
        tree
    }

    /// Position from the lower corner of the outermost box [m].
    fn offset(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, z] = [0, 1].map(|k| point[k] - self.low[k]);
        [self.period.map_or(x, |period| x.rem_euclid(period)), z]
    }

    fn fill(&mut self, vertices: &mut [([f64; 2], f64)]) {
        let whole = SizeBox { halves: 0, size: 0.0 };
        self.boxes = vec![whole];
        let mut tasks =
            vec![Task { index: 0, from: 0, to: vertices.len(), low: [0.0; 2], extent: self.extent, depth: 0 }];
        while let Some(task) = tasks.pop() {
            let members = &mut vertices[task.from..task.to];
            let longer = task.extent[0].max(task.extent[1]);
            if members.is_empty() {
                // So far the box has the size of that of which it is a half.
                let size = &mut self.boxes[task.index].size;
                *size = size.max(IN_EMPTY_BOX * longer);
                continue;
            }
            let size = members.iter().map(|(_, size)| size).sum::<f64>() / members.len() as f64;
            self.boxes[task.index].size = size;
            if longer <= size || task.depth == DEEPEST {
                continue;
            }
            let halves = self.boxes.len();
            self.boxes[task.index].halves = halves as u32;
            self.boxes.extend([SizeBox { halves: 0, size }; 2]);
            let axis = usize::from(task.extent[1] > task.extent[0]);
            let mut extent = task.extent;
            extent[axis] *= 0.5;
            let mut upper = task.low;
            upper[axis] += extent[axis];
            let middle = task.from + partition(members, |(point, _)| point[axis] < upper[axis]);
            for (half, low, from, to) in [(0, task.low, task.from, middle), (1, upper, middle, task.to)] {
                tasks.push(Task { index: halves + half, from, to, low, extent, depth: task.depth + 1 });
            }
        }
    }

    /// Edge length [m] at a point.
    pub(crate) fn at(&self, point: [f64; 2]) -> f64 {
        let mut from_low = self.offset(point);
        let mut extent = self.extent;
        let mut place = self.boxes[0];
        while place.halves > 0 {
            let axis = usize::from(extent[1] > extent[0]);
            extent[axis] *= 0.5;
            let upper = from_low[axis] >= extent[axis];
            if upper {
                from_low[axis] -= extent[axis];
            }
            place = self.boxes[place.halves as usize + usize::from(upper)];
        }
        place.size
    }
}

/// Moves the items that are `first` to the front; returns how many there are.
fn partition<T>(items: &mut [T], first: impl Fn(&T) -> bool) -> usize {
    let mut count = 0;
    for k in 0..items.len() {
        if first(&items[k]) {
            items.swap(k, count);
            count += 1;
        }
    }
    count
}

/// Edge [m] of the equilateral triangle that has the mean area of the triangles around each vertex.
fn vertex_sizes(mesh: &Mesh) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); mesh.points().len()];
    for (t, triangle) in mesh.triangles().iter().enumerate() {
        let doubled = doubled_area(mesh.corners(t));
        for &v in triangle {
            let (area, count) = &mut sums[v as usize];
            *area += doubled;
            *count += 1.0;
        }
    }
    sums.into_iter().map(|(area, count)| EQUILATERAL_EDGE * (area / count).sqrt()).collect()
}
