//! # Infinitely short bearing
//!
//! **Equation.** With `H = 1 + eps cos(theta)`, theta from the widest film in the sense of rotation,
//! `p = 3 mu U eps sin(theta) / (R c^2 H^3) (B^2/4 - z^2)` above the end pressure. Full film: the load
//! stands at right angles to the line of centres, `So = pi eps / (1 - eps^2)^{3/2} (B/D)^2`; with
//! the half film of Guembel `So = eps/(2 (1 - eps^2)^2) sqrt(pi^2 (1 - eps^2) + 16 eps^2) (B/D)^2`,
//! attitude `atan(pi sqrt(1 - eps^2) / (4 eps))`.
//! **Source.** Ocvirk, NACA TN 2808 (1952); DuBois & Ocvirk, NACA Rep. 1157 (1953).
//! **Range.** B/D small, 0 <= eps < 1. **Verified by** `loads_are_integrals_of_the_pressure`.

use std::f64::consts::PI;

/// Dimensionless pressure `p psi^2/(mu omega)` at `theta` [rad] and the axial position
/// `zeta = 2 z/B` in [-1, 1], over `(B/D)^2`.
pub fn pressure(eccentricity: f64, theta: f64, zeta: f64) -> f64 {
    let film = 1.0 + eccentricity * theta.cos();
    3.0 * eccentricity * theta.sin() / film.powi(3) * (1.0 - zeta * zeta)
}

/// Sommerfeld number over `(B/D)^2` of the full film.
pub fn full_film(eccentricity: f64) -> f64 {
    PI * eccentricity / (1.0 - eccentricity * eccentricity).powf(1.5)
}

/// Sommerfeld number over `(B/D)^2` and attitude angle [rad] of the half film.
pub fn half_film(eccentricity: f64) -> (f64, f64) {
    let rest = 1.0 - eccentricity * eccentricity;
    let load = eccentricity / (2.0 * rest * rest) * (PI * PI * rest + 16.0 * eccentricity * eccentricity).sqrt();
    (load, (PI * rest.sqrt() / (4.0 * eccentricity)).atan())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_are_integrals_of_the_pressure() {
        // So = 1/4 Int Int P (cos, sin) dzeta dtheta; Int (1 - zeta^2) dzeta = 4/3.
        let n = 20_000;
        let eccentricity = 0.6;
        let mut half = [0.0; 2];
        for k in 0..n {
            let theta = PI * (f64::from(k) + 0.5) / f64::from(n);
            let line = 0.25 * 4.0 / 3.0 * pressure(eccentricity, theta, 0.0) * PI / f64::from(n);
            half[0] += line * theta.cos();
            half[1] += line * theta.sin();
        }
        let (load, attitude) = half_film(eccentricity);
        assert!((half[0].hypot(half[1]) - load).abs() < 1e-7 * load);
        // From the minimum film (theta = pi) the load lies at the attitude angle.
        assert!((half[1].atan2(-half[0]) - attitude).abs() < 1e-7);
        assert!((2.0 * half[1] - full_film(eccentricity)).abs() < 1e-7 * load);
    }
}
