//! The short half film: with v.n the rate at which the film falls,
//! ```text
//! W = Int_(v.n > 0) (v.n) n/(1 - eps cos phi)^3 dphi
//! ```
//! over the half of the ring where it falls. Sommerfeld's angle g, `cos phi = (cos g + eps)/(1 + eps cos g)`, makes the
//! integrals elementary. Where the thick half of the ring carries, differences of primitives cancel: rounding is some
//! `1e-15/(1 - eps^2)^(5/2)` of the force, 1e-8 at eps 0.999.

use std::f64::consts::FRAC_PI_2;

use super::FilmMap;

/// The map of a short half film; it is the same for all bearings.
#[derive(Debug, Clone, Copy, Default)]
pub struct ShortMap;

impl FilmMap for ShortMap {
    fn force(&self, eccentricity: f64, angle: f64) -> [f64; 2] {
        let eps = eccentricity;
        let ends = [angle - FRAC_PI_2, angle + FRAC_PI_2].map(|phi| sommerfeld(eps, phi));
        let over = |primitive: &dyn Fn(f64) -> f64| primitive(ends[1]) - primitive(ends[0]);
        let along = over(&|g| (0.5 + eps * eps) * g + 0.25 * (2.0 * g).sin() + 2.0 * eps * g.sin());
        let mixed = over(&|g| 0.5 * g.sin().powi(2) - eps * g.cos());
        let across = over(&|g| 0.5 * g - 0.25 * (2.0 * g).sin());
        let rest = 1.0 - eps * eps;
        let [xx, xy, yy] = [along / (rest * rest * rest.sqrt()), mixed / (rest * rest), across / (rest * rest.sqrt())];
        let (sin, cos) = angle.sin_cos();
        [xx * cos + xy * sin, xy * cos + yy * sin]
    }
}

/// Sommerfeld's angle of a place `phi` from the thinnest film, between -pi/2 and 3 pi/2.
fn sommerfeld(eps: f64, phi: f64) -> f64 {
    let (sin, cos) = (0.5 * phi).sin_cos();
    2.0 * ((1.0 + eps).sqrt() * sin).atan2((1.0 - eps).sqrt() * cos)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The integral by the midpoint rule.
    #[test]
    fn the_force_is_the_integral() {
        const COUNT: u32 = 200_000;
        for (eps, angle) in [(0.0, 0.7), (0.3, 0.0), (0.6, 1.2), (0.9, 2.5), (0.95, 3.1)] {
            let step = 2.0 * FRAC_PI_2 / f64::from(COUNT);
            let mut sum = [0.0; 2];
            for k in 0..COUNT {
                let phi = angle - FRAC_PI_2 + step * (f64::from(k) + 0.5);
                let weight = step * (phi - angle).cos() / (1.0 - eps * phi.cos()).powi(3);
                sum[0] += weight * phi.cos();
                sum[1] += weight * phi.sin();
            }
            let found = ShortMap.force(eps, angle);
            let size = sum[0].hypot(sum[1]);
            let off = (found[0] - sum[0]).hypot(found[1] - sum[1]) / size;
            assert!(off < 1e-8, "{eps} {angle}: {found:?} {sum:?}");
        }
    }

    #[test]
    fn the_mobility_inverts_the_map() {
        for eps in [0.0, 0.2, 0.7, 0.95, 0.99] {
            for k in 0..=20 {
                let angle = std::f64::consts::PI * f64::from(k) / 20.0;
                let [along, across] = ShortMap.mobility(eps, 2.0, angle);
                let direction = across.atan2(along).max(0.0);
                let force = ShortMap.force(eps, direction).map(|part| part * along.hypot(across));
                let off = (0.5 * force[0] - angle.cos()).hypot(0.5 * force[1] - angle.sin());
                assert!(off < 1e-9, "{eps} {angle}: {force:?}");
            }
        }
    }
}
