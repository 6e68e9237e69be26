//! Boxes around triangles, on a plane or a ring.

use super::OUTSIDE;
use crate::Mesh;

/// A box with sides along the axes. On a ring its middle lies within the period from zero.
#[derive(Debug, Clone, Copy)]
pub(super) struct BoundingBox {
    /// Middle [m].
    middle: [f64; 2],
    /// Half of its width and of its height [m].
    half: [f64; 2],
}

impl BoundingBox {
    /// The box around triangle `t`, a little larger; a parabola stays in the triangle of its ends and of the point
    /// twice as far out as its middle.
    pub(super) fn of_triangle(mesh: &Mesh, t: usize) -> Self {
        let nodes = mesh.nodes(t);
        let mut low = nodes[0];
        let mut high = nodes[0];
        for k in 0..3 {
            let (a, b, middle) = (nodes[k], nodes[(k + 1) % 3], nodes[3 + k]);
            for d in 0..2 {
                let control = 2.0 * middle[d] - 0.5 * (a[d] + b[d]);
                low[d] = low[d].min(b[d]).min(control);
                high[d] = high[d].max(b[d]).max(control);
            }
        }
        let margin = 10.0 * OUTSIDE * (high[0] - low[0] + high[1] - low[1]);
        let middle = [0, 1].map(|d| 0.5 * (low[d] + high[d]));
        Self { middle: on_turn(middle, mesh.period()), half: [0, 1].map(|d| 0.5 * (high[d] - low[d]) + margin) }
    }

    /// The box around all of them; on a ring each at its shortest way from the first.
    pub(super) fn around(boxes: impl IntoIterator<Item = Self>, period: Option<f64>) -> Self {
        let mut boxes = boxes.into_iter();
        let first = boxes.next().unwrap_or(Self { middle: [0.0; 2], half: [0.0; 2] });
        let (mut low, mut high) = (first.half.map(|half| -half), first.half);
        for other in boxes {
            let off = turned(first.middle, other.middle, period);
            for d in 0..2 {
                low[d] = low[d].min(off[d] - other.half[d]);
                high[d] = high[d].max(off[d] + other.half[d]);
            }
        }
        let middle = [0, 1].map(|d| first.middle[d] + 0.5 * (low[d] + high[d]));
        Self { middle: on_turn(middle, period), half: [0, 1].map(|d| 0.5 * (high[d] - low[d])) }
    }

    /// Distance [m] of a point that lies on the same turn; zero inside.
    pub(super) fn distance(&self, point: [f64; 2], period: Option<f64>) -> f64 {
        let [x, z] = self.off(point, period);
        (x * x + z * z).sqrt()
    }

    /// True if a point that lies on the same turn is inside.
    pub(super) fn holds(&self, point: [f64; 2], period: Option<f64>) -> bool {
        self.off(point, period) == [0.0; 2]
    }

    /// How far [m] a point lies outside along each axis.
    fn off(&self, point: [f64; 2], period: Option<f64>) -> [f64; 2] {
        let way = turned(self.middle, point, period);
        [0, 1].map(|d| (way[d].abs() - self.half[d]).max(0.0))
    }
}

/// The position with `x` from zero to the period.
pub(super) fn on_turn([x, z]: [f64; 2], period: Option<f64>) -> [f64; 2] {
    [period.map_or(x, |period| x.rem_euclid(period)), z]
}

/// The way [m] from one place to another, on a ring the shorter one; both lie on the same turn.
pub(super) fn turned(from: [f64; 2], to: [f64; 2], period: Option<f64>) -> [f64; 2] {
    let along = to[0] - from[0];
    let along = match period {
        Some(period) if along.abs() > 0.5 * period => along - period.copysign(along),
        _ => along,
    };
    [along, to[1] - from[1]]
}
