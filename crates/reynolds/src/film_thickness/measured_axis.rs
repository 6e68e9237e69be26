//! # Points along one axis of a measured surface
//!
//! **Equation.** Hermite's cubic between neighbours at the distance `d`, with `t` the part of the way:
//! `y = (1 + 2 t)(1 - t)^2 y_0 + t (1 - t)^2 d y'_0 + t^2 (3 - 2 t) y_1 + t^2 (t - 1) d y'_1`. Slopes `y'` are those of
//! the parabola through a point and its neighbours, of the sign of both secants and at most [`STEEPEST`] times the
//! flatter one.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | places | m | `places` |
//! | period | m | `period` |
//!
//! **Source.** Fritsch, Carlson, SIAM Journal on Numerical Analysis 17 (1980) 238. **Range.** Growing places.
//! **Verified by** the tests of `measured.rs`.

/// Slopes are at most so many times the flatter secant beside their point.
const STEEPEST: f64 = 3.0;

/// Places along a line.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct PointAxis {
    /// Growing [m].
    pub(super) places: Vec<f64>,
    /// Length [m] after which they repeat, if they do.
    pub(super) period: Option<f64>,
}

/// What two neighbours have to do with a place between them: for the value and its slope the parts of their values and
/// of their slopes.
#[derive(Debug, Clone, Copy)]
pub(super) struct CubicParts {
    pub(super) neighbours: [usize; 2],
    pub(super) value: [[f64; 2]; 2],
    pub(super) slope: [[f64; 2]; 2],
}

impl PointAxis {
    /// The neighbours of a point and the signed distances [m] to them.
    pub(super) fn neighbours(&self, k: usize) -> impl Iterator<Item = (usize, f64)> {
        let n = self.places.len();
        let place = self.places[k];
        let beside = |step: isize| {
            let turn = match self.period {
                Some(period) if n > 1 => period,
                _ => 0.0,
            };
            let next = k.checked_add_signed(step).filter(|next| *next < n);
            match next {
                Some(next) => Some((next, self.places[next] - place)),
                None if turn == 0.0 => None,
                None if step < 0 => Some((n - 1, self.places[n - 1] - turn - place)),
                None => Some((0, self.places[0] + turn - place)),
            }
        };
        [-1, 1].into_iter().filter_map(beside).collect::<Vec<_>>().into_iter()
    }

    /// Slopes of depths, limited so that a cubic stays between two of them.
    pub(super) fn depth_slopes(&self, depths: &[f64]) -> Vec<f64> {
        let limited = |(k, slope): (usize, f64)| {
            let secants: Vec<f64> =
                self.neighbours(k).map(|(next, distance)| (depths[next] - depths[k]) / distance).collect();
            let sign = secants.first().map_or(0.0, |first| first.signum());
            let flattest = secants.iter().map(|secant| sign * secant).fold(f64::INFINITY, f64::min);
            sign * (sign * slope).clamp(0.0, STEEPEST * flattest.max(0.0))
        };
        self.slopes(depths).into_iter().enumerate().map(limited).collect()
    }

    /// Slopes of the parabolas through each of these values and its neighbours.
    pub(super) fn slopes(&self, values: &[f64]) -> Vec<f64> {
        let n = values.len();
        let point = |k: isize| match self.period {
            Some(period) => {
                let turn = k.div_euclid(n as isize);
                let k = k.rem_euclid(n as isize) as usize;
                (self.places[k] + period * turn as f64, values[k])
            }
            None => (self.places[k as usize], values[k as usize]),
        };
        let secant = |a: (f64, f64), b: (f64, f64)| (b.1 - a.1) / (b.0 - a.0);
        let slope = |k: usize| {
            let middle = match self.period {
                Some(_) => k as isize,
                None => (k as isize).clamp(1, n as isize - 2),
            };
            let [a, b, c] = [-1, 0, 1].map(|step| point(middle + step));
            let (before, after) = (secant(a, b), secant(b, c));
            let bend = (after - before) / (c.0 - a.0);
            before + bend * ((point(k as isize).0 - a.0) + (point(k as isize).0 - b.0))
        };
        match (n, self.period) {
            (0 | 1, _) => vec![0.0; n],
            (2, None) => vec![secant(point(0), point(1)); 2],
            _ => (0..n).map(slope).collect(),
        }
    }

    /// The neighbours of a place, and their parts.
    pub(super) fn parts(&self, place: f64) -> CubicParts {
        let (n, first) = (self.places.len(), self.places.first().copied().unwrap_or(0.0));
        if n < 2 {
            return CubicParts::of_one(0, 0.0, 0.0);
        }
        let place = match self.period {
            Some(period) => first + (place - first).rem_euclid(period),
            None => place,
        };
        let next = self.places.partition_point(|&at| at <= place);
        let (before, after, length) = match self.period {
            Some(period) if next == n => (n - 1, 0, first + period - self.places[n - 1]),
            None if next == 0 => return CubicParts::of_one(0, place - first, 1.0),
            None if next == n => return CubicParts::of_one(n - 1, place - self.places[n - 1], 1.0),
            _ => {
                let before = next.max(1) - 1;
                (before, before + 1, self.places[before + 1] - self.places[before])
            }
        };
        CubicParts::between(before, after, (place - self.places[before]) / length, length)
    }
}

impl CubicParts {
    /// Weights beyond an end: straight on from one point, a distance [m] from it.
    fn of_one(point: usize, distance: f64, slope: f64) -> Self {
        Self { neighbours: [point, point], value: [[1.0, distance], [0.0, 0.0]], slope: [[0.0, slope], [0.0, 0.0]] }
    }

    /// Weights between two points `length` [m] apart: Hermite's cubics at the part `t` of the distance.
    fn between(before: usize, after: usize, t: f64, length: f64) -> Self {
        let (s, rise) = (1.0 - t, 6.0 * t * (1.0 - t) / length);
        Self {
            neighbours: [before, after],
            value: [[s * s * (1.0 + 2.0 * t), length * t * s * s], [t * t * (1.0 + 2.0 * s), -length * s * t * t]],
            slope: [[-rise, s * (s - 2.0 * t)], [rise, t * (t - 2.0 * s)]],
        }
    }
}
