//! # Measured surface: depths at the points of a grid
//!
//! **Equation.** `d(x, z)` is the bicubic Hermite interpolant: depth, both slopes and the twist at the points, cubic
//! along each side of a cell. It is continuous with its slopes. Slopes at a point are those of the parabola through it
//! and its neighbours, at an end of the grid of the parabola through the last three points, limited: zero where the
//! point is higher or lower than both neighbours, else of the sign of the two secants and at most three times the
//! flatter one. Twists are the slopes of the slopes, limited so that in each of the four cells at the point
//! ```text
//! d + dx d_x/3 + dz d_z/3 + dx dz d_xz/9
//! ```
//! lies between the least and the greatest depth of the four corners, with dx and dz the signed sides of the cell.
//! Where no twist does both slopes are halved; then a twist of zero does. These numbers are the coefficients of
//! Bernstein polynomials, so the surface of a cell stays between the depths of its corners. Beyond an end that the grid
//! does not reach it goes on straight.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | x = R phi, z | m | `places` of both axes |
//! | d, dd/dx, dd/dz, d2d/dxdz | m, -, -, 1/m | `nodes` |
//!
//! **Source.** de Boor, A Practical Guide to Splines (1978), ch. IV (parabolic slopes, Bessel) and XVII (tensor
//! products); Fritsch and Carlson, SIAM J. Numer. Anal. 17 (1980) 238 (limited slopes).
//! **Range.** Points closer than the lengths over which the film changes; noise of a measurement is not smoothed.
//! **Verified by** `parabolas_are_exact`, `the_surface_is_smooth_across_cells`,
//! `no_place_of_a_cell_is_beyond_its_corners` and `tests/tests/shapes`.

use super::measured_axis::PointAxis;
use super::profile::{Profile, Relief};

/// Second derivatives around are differences over so many radians.
const BEND_OVER: f64 = 0.15;
/// Second derivatives along the axis are differences over this part of the length.
const BEND_ALONG: f64 = 0.125;

/// Part of the range of the corners of a cell by which rounding may leave it.
const ROUNDING: f64 = 1e-12;
/// Depths at the points of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceGrid {
    /// Growing angles [rad] within one turn; one alone for a surface that does not depend on the angle.
    pub angles: Vec<f64>,
    /// Growing axial positions [m].
    pub zs: Vec<f64>,
    /// Depth [m] at each angle, at each position.
    pub depths: Vec<Vec<f64>>,
}

/// A surface through the points of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct MeasuredSurface {
    around: PointAxis,
    along: PointAxis,
    /// Values at the nodes, by angle and position: depth, slopes around and along, twist.
    nodes: Vec<[f64; 4]>,
    /// Steps [m] over which second derivatives are differences.
    steps: [f64; 2],
}

impl MeasuredSurface {
    /// The surface of a bearing with this radius [m] and length [m]; `closed`: its angles go all around.
    pub fn new(points: &SurfaceGrid, radius: f64, length: f64, closed: bool) -> Self {
        let around = PointAxis {
            places: points.angles.iter().map(|angle| radius * angle).collect(),
            period: closed.then_some(std::f64::consts::TAU * radius),
        };
        let along = PointAxis { places: points.zs.clone(), period: None };
        let rows = points.zs.len();
        let by_x = |depths: &dyn Fn(usize) -> f64| {
            let values: Vec<f64> = (0..points.angles.len()).map(depths).collect();
            around.depth_slopes(&values)
        };
        let slopes_around: Vec<Vec<f64>> = (0..rows).map(|j| by_x(&|i| points.depths[i][j])).collect();
        let mut nodes = Vec::with_capacity(points.angles.len() * rows);
        for (i, depths) in points.depths.iter().enumerate() {
            let slopes: Vec<f64> = (0..rows).map(|j| slopes_around[j][i]).collect();
            let (slopes_along, twists) = (along.depth_slopes(depths), along.slopes(&slopes));
            nodes.extend((0..rows).map(|j| [depths[j], slopes[j], slopes_along[j], twists[j]]));
        }
        let steps = [BEND_OVER * radius, BEND_ALONG * length];
        let mut surface = Self { around, along, nodes, steps };
        surface.limit_twists();
        surface
    }

    /// Limits the twists so that the surface of each cell stays between the depths of its corners.
    fn limit_twists(&mut self) {
        let rows = self.along.places.len();
        for k in 0..self.nodes.len() {
            let [depth, by_x, by_z, twist] = self.nodes[k];
            let at = [k / rows, k % rows];
            let [least, most] = self.allowed_twists(at, [by_x, by_z]);
            self.nodes[k] = match least <= most {
                true => [depth, by_x, by_z, twist.clamp(least, most)],
                false => {
                    let halves = [by_x, by_z].map(|slope| 0.5 * slope);
                    // Zero is among the allowed twists, but for rounding.
                    let [least, most] = self.allowed_twists(at, halves);
                    let [least, most] = [least.min(0.0), most.max(0.0)];
                    [depth, halves[0], halves[1], twist.clamp(least, most)]
                }
            };
        }
    }

    /// The least and the greatest twist at a point with these slopes.
    fn allowed_twists(&self, [i, j]: [usize; 2], [by_x, by_z]: [f64; 2]) -> [f64; 2] {
        let depth_at = |[i, j]: [usize; 2]| self.nodes[i * self.along.places.len() + j][0];
        let depth = depth_at([i, j]);
        let [mut least, mut most] = [f64::NEG_INFINITY, f64::INFINITY];
        for (column, width) in self.around.neighbours(i) {
            for (row, height) in self.along.neighbours(j) {
                let depths = [[column, j], [i, row], [column, row]].map(depth_at);
                let [low, high] = [f64::min, f64::max].map(|of| depths.into_iter().fold(depth, of));
                let flat = depth + (width * by_x + height * by_z) / 3.0;
                let of_twist = width * height / 9.0;
                let [a, b] = [low, high].map(|end| (end - flat) / of_twist);
                let slack = ROUNDING * (high - low) / of_twist.abs();
                (least, most) = (least.max(a.min(b) - slack), most.min(a.max(b) + slack));
            }
        }
        [least, most]
    }
}

impl Profile for MeasuredSurface {
    fn at(&self, [x, z]: [f64; 2]) -> Relief {
        let (around, along) = (self.around.parts(x), self.along.parts(z));
        let rows = self.along.places.len();
        let sum = |x: &[[f64; 2]; 2], z: &[[f64; 2]; 2]| {
            let mut sum = 0.0;
            for (i, [by_value, by_slope]) in around.neighbours.iter().zip(x) {
                for (j, [on_value, on_slope]) in along.neighbours.iter().zip(z) {
                    let [depth, around, along, twist] = self.nodes[i * rows + j];
                    sum += by_value * (on_value * depth + on_slope * along)
                        + by_slope * (on_value * around + on_slope * twist);
                }
            }
            sum
        };
        Relief {
            depth: sum(&around.value, &along.value),
            slope: [sum(&around.slope, &along.value), sum(&around.value, &along.slope)],
        }
    }

    /// Differences over lengths that a film feels: noise from point to point is none of them.
    fn bends(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let depth = |x: f64, z: f64| self.at([x, z]).depth;
        let [over, along] = self.steps;
        let middle = 2.0 * depth(x, z);
        [
            (depth(x + over, z) - middle + depth(x - over, z)) / (over * over),
            (depth(x, z + along) - middle + depth(x, z - along)) / (along * along),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    const RADIUS: f64 = 0.05;

    /// Points of a function of angle and position, `columns` around and with uneven distances along the axis.
    fn points(columns: u32, depth: impl Fn(f64, f64) -> f64) -> SurfaceGrid {
        let angles: Vec<f64> = (0..columns).map(|i| TAU * f64::from(i) / f64::from(columns)).collect();
        let zs = vec![-0.02, -0.013, -0.004, 0.003, 0.011, 0.02];
        let row = |&angle: &f64| zs.iter().map(|&z| depth(angle, z)).collect();
        SurfaceGrid { depths: angles.iter().map(row).collect(), angles, zs }
    }

    #[test]
    fn parabolas_are_exact() {
        let depth = |z: f64| 1e-6 + 2e-4 * z - 3e-3 * z * z;
        let measured = MeasuredSurface::new(&points(7, |_, z| depth(z)), RADIUS, 0.04, true);
        for z in [-0.02, -0.017, 0.0, 0.0035, 0.02] {
            let found = measured.at([0.123, z]);
            assert!((found.depth - depth(z)).abs() < 1e-20, "{z}");
            assert!((found.slope[1] - (2e-4 - 6e-3 * z)).abs() < 1e-16, "{z}");
            assert!(found.slope[0].abs() < 1e-18);
        }
        // Beyond the last point it goes on straight.
        let (end, beyond) = (measured.at([0.0, 0.02]), measured.at([0.0, 0.025]));
        assert!((beyond.depth - end.depth - 0.005 * end.slope[1]).abs() < 1e-20 && beyond.slope == end.slope);
    }

    #[test]
    fn the_surface_is_smooth_across_cells() {
        let shape = |phi: f64, z: f64| 1e-6 * (3.0 * phi + 40.0 * z).sin();
        let measured = MeasuredSurface::new(&points(24, shape), RADIUS, 0.04, true);
        let step = 1e-9;
        // Across a column, across the seam, across a row.
        for ([x, z], d) in [([TAU * RADIUS / 24.0, 0.007], 0), ([0.0, -0.001], 0), ([0.02, 0.003], 1)] {
            let at = |way: f64| {
                let mut place = [x, z];
                place[d] += way * step;
                measured.at(place)
            };
            let (before, after) = (at(-1.0), at(1.0));
            assert!((after.depth - before.depth).abs() < 1e-12);
            for d in 0..2 {
                assert!((after.slope[d] - before.slope[d]).abs() < 1e-9, "{x} {z} {d}");
            }
        }
    }

    #[test]
    fn no_place_of_a_cell_is_beyond_its_corners() {
        // Depths of a linear congruential generator with jumps and level stretches, on uneven distances.
        let mut state = 5u64;
        let mut next = || {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (state >> 33) as f64 / (1u64 << 31) as f64
        };
        let mut grow = |count: usize, from: f64, to: f64| {
            let mut places: Vec<f64> = (0..count).map(|_| from + (to - from) * next()).collect();
            places.sort_by(f64::total_cmp);
            places
        };
        let (angles, zs) = (grow(40, 0.0, TAU), grow(15, -0.02, 0.02));
        let depths: Vec<Vec<f64>> = (0..40).map(|_| (0..15).map(|_| 1e-6 * (6.0 * next()).floor()).collect()).collect();
        let points = SurfaceGrid { angles, zs, depths };
        let measured = MeasuredSurface::new(&points, RADIUS, 0.04, true);
        let twists = measured.nodes.iter().filter(|node| node[3] != 0.0).count();
        for i in 0..40 {
            let (left, right) = (points.angles[i], points.angles.get(i + 1).map_or(points.angles[0] + TAU, |at| *at));
            for j in 0..14 {
                let corners = [i, (i + 1) % 40].map(|i| [points.depths[i][j], points.depths[i][j + 1]]);
                let [low, high] = [f64::min, f64::max].map(|of| corners.concat().into_iter().reduce(of).expect("four"));
                for (a, b) in (1..9).flat_map(|a| (1..9).map(move |b| (f64::from(a) / 9.0, f64::from(b) / 9.0))) {
                    let x = RADIUS * (left + a * (right - left));
                    let z = points.zs[j] + b * (points.zs[j + 1] - points.zs[j]);
                    let depth = measured.at([x, z]).depth;
                    assert!((low - 1e-17..=high + 1e-17).contains(&depth), "{i} {j}: {depth:e} of {low:e} to {high:e}");
                }
            }
        }
        assert!(twists > 20, "{twists}: the points are too tame for this test");
    }

    #[test]
    fn the_error_falls_with_the_third_power_of_the_spacing_and_the_second_at_extremes_between_points() {
        let shape = |phi: f64, _: f64| 1e-6 * (2.0 * phi).cos();
        let off = |columns: u32| {
            let measured = MeasuredSurface::new(&points(columns, shape), RADIUS, 0.04, true);
            let off = |k: u32| {
                let phi = 0.001 + 0.01 * f64::from(k);
                (measured.at([RADIUS * phi, 0.0]).depth - shape(phi, 0.0)).abs()
            };
            (0..628).map(off).fold(0.0, f64::max)
        };
        let rate = |coarse: u32, fine: u32| (off(coarse) / off(fine)).ln() / (f64::from(fine) / f64::from(coarse)).ln();
        // Extremes are points where four divides the number of columns.
        let rates = [rate(32, 64), rate(30, 62)];
        assert!((2.8..4.2).contains(&rates[0]), "{rates:?}");
        assert!((1.8..2.5).contains(&rates[1]), "{rates:?}");
    }

    #[test]
    fn one_angle_stands_for_all() {
        let one = SurfaceGrid { angles: vec![0.0], zs: vec![-0.02, 0.0, 0.02], depths: vec![vec![4e-6, 0.0, 4e-6]] };
        let measured = MeasuredSurface::new(&one, RADIUS, 0.04, true);
        for x in [0.0, 0.1, 0.3] {
            let found = measured.at([x, 0.01]);
            assert!((found.depth - 1e-6).abs() < 1e-20 && found.slope[0] == 0.0);
        }
    }
}
