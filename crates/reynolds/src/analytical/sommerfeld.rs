//! # Infinitely long bearing, full film
//!
//! **Equation.** With `H = 1 + eps cos(theta)`, theta from the widest film in the sense of rotation,
//! `P = p psi^2/(mu omega) = 6 eps sin(theta) (2 + eps cos(theta)) / ((2 + eps^2) H^2)` above the
//! pressure at theta = 0; `So = 6 pi eps / ((2 + eps^2) sqrt(1 - eps^2))`, attitude 90 degrees.
//! **Source.** Sommerfeld, Z. Math. Phys. 50 (1904) 97. **Range.** B/D large, 0 <= eps < 1.
//! **Verified by** `load_is_the_integral_of_the_pressure`.

/// Dimensionless pressure P at the angle `theta` [rad] from the widest film.
pub fn pressure(eccentricity: f64, theta: f64) -> f64 {
    let (sin, cos) = theta.sin_cos();
    let film = 1.0 + eccentricity * cos;
    6.0 * eccentricity * sin * (2.0 + eccentricity * cos) / ((2.0 + eccentricity.powi(2)) * film * film)
}

/// Sommerfeld number.
pub fn sommerfeld_number(eccentricity: f64) -> f64 {
    let square = eccentricity * eccentricity;
    6.0 * std::f64::consts::PI * eccentricity / ((2.0 + square) * (1.0 - square).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn load_is_the_integral_of_the_pressure() {
        let n = 400;
        let sum: f64 = (0..n)
            .map(|k| TAU * f64::from(k) / f64::from(n))
            .map(|theta| 0.5 * pressure(0.6, theta) * theta.sin() * TAU / f64::from(n))
            .sum();
        assert!((sum - sommerfeld_number(0.6)).abs() < 1e-12);
    }
}
