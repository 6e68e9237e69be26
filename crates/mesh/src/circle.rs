//! Circles in a plane, and the one that fits a set of points best.

/// A circle: of a round hole in the developed surface `(x = R phi, z)` [m], or of a section
/// through a cylinder.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// Centre [m].
    pub centre: [f64; 2],
    /// Radius [m].
    pub radius: f64,
}

impl Circle {
    /// The circle through three or more points, by least squares of `r^2` (Kasa); none if they lie
    /// on a line. Exact for points on a circle, also on a short arc.
    pub fn fit(points: impl Iterator<Item = [f64; 2]> + Clone) -> Option<Self> {
        let (mut count, mut mean) = (0.0, [0.0; 2]);
        for [u, v] in points.clone() {
            count += 1.0;
            mean = [mean[0] + u, mean[1] + v];
        }
        let mean = [mean[0] / count, mean[1] / count];
        // Moments about the mean.
        let (mut uu, mut uv, mut vv, mut u_rr, mut v_rr) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for point in points {
            let (u, v) = (point[0] - mean[0], point[1] - mean[1]);
            let rr = u * u + v * v;
            uu += u * u;
            uv += u * v;
            vv += v * v;
            u_rr += u * rr;
            v_rr += v * rr;
        }
        let determinant = uu * vv - uv * uv;
        if determinant.is_nan() || determinant <= 1e-14 * (uu + vv) * (uu + vv) {
            return None;
        }
        let a = 0.5 * (u_rr * vv - v_rr * uv) / determinant;
        let b = 0.5 * (v_rr * uu - u_rr * uv) / determinant;
        Some(Self { centre: [mean[0] + a, mean[1] + b], radius: (a * a + b * b + (uu + vv) / count).sqrt() })
    }

    /// Distance [m] of a point from the circle, positive outside.
    pub fn distance(&self, point: [f64; 2]) -> f64 {
        (point[0] - self.centre[0]).hypot(point[1] - self.centre[1]) - self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_arcs_and_lines() {
        let circle = Circle { centre: [3.0, -7.0], radius: 0.0375 };
        for span in [0.2, 1.0, 6.0] {
            let on_arc = (0..20).map(|k| {
                let angle = 0.3 + span * f64::from(k) / 19.0;
                [3.0 + 0.0375 * angle.cos(), -7.0 + 0.0375 * angle.sin()]
            });
            let found = Circle::fit(on_arc).unwrap();
            assert!((found.radius - circle.radius).abs() < 1e-8 * circle.radius);
            assert!(found.distance([3.0375, -7.0]).abs() < 1e-9);
        }
        assert!(Circle::fit((0..20).map(|k| [f64::from(k), 2.0 * f64::from(k)])).is_none());
        assert!(Circle::fit([].into_iter()).is_none());
    }
}
