//! Sines and cosines of angles that lie close together, as those in one triangle do: of one by the library, of the others by the
//! theorems of addition, to rounding.

/// Turns up to this one [rad] are summed as series.
const SHORT: f64 = 0.2;

/// An angle [rad] whose neighbours are asked for.
#[derive(Debug, Clone, Copy)]
pub(crate) struct NearbyAngles {
    angle: f64,
    sin: f64,
    cos: f64,
}

impl NearbyAngles {
    /// The neighbours of `angle` [rad].
    pub(crate) fn of(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { angle, sin, cos }
    }

    /// Sine and cosine of `angle` [rad], in this order.
    pub(crate) fn sin_cos(&self, angle: f64) -> (f64, f64) {
        let turn = angle - self.angle;
        if turn.abs() > SHORT {
            return angle.sin_cos();
        }
        let t = turn * turn;
        const fn over(n: f64) -> f64 {
            1.0 / n
        }
        let sin =
            turn * (1.0 - t * over(6.0) * (1.0 - t * over(20.0) * (1.0 - t * over(42.0) * (1.0 - t * over(72.0)))));
        let fourth = 1.0 - t * over(30.0) * (1.0 - t * over(56.0) * (1.0 - t * over(90.0)));
        // One less the cosine, so that its rounding is that of a small number.
        let versine = 0.5 * t * (1.0 - t * over(12.0) * fourth);
        (
            self.sin + (self.cos * sin - self.sin * versine),
            self.cos - (self.sin * sin + self.cos * versine),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_those_of_the_library() {
        for k in 0..200 {
            let angle = 0.05 * f64::from(k) - 3.0;
            let near = NearbyAngles::of(angle);
            for turn in [-0.5, -0.2, -0.11, -1e-3, 0.0, 1e-9, 0.04, 0.17, 0.2, 0.21] {
                let (sin, cos) = near.sin_cos(angle + turn);
                let (right_sin, right_cos) = (angle + turn).sin_cos();
                assert!(
                    (sin - right_sin).abs() < 4e-16 && (cos - right_cos).abs() < 4e-16,
                    "{angle} {turn}"
                );
            }
        }
    }
}
