//! # Plain journal bearings by the fits of ISO 7902 and DIN 31652
//!
//! **Equation.** With `b = B/D`, eps, `psi = c/R`: `So = F psi^2/(B D eta omega)`,
//! ```text
//! So      = b^2 eps/(2 (1 - eps^2)^2) sqrt(pi^2 (1 - eps^2) + 16 eps^2) a_1 (eps - 1)/(a_2 + eps)
//! beta    = [b_0 + b_1 eps + b_2 eps^2 + b_3 eps^3 + b_4 eps^4] arctan(pi sqrt(1 - eps^2)/(2 eps))
//! f/psi   = pi/(So sqrt(1 - eps^2)) + eps/2 sin(beta)                   full film, on the journal
//! Q_3     = D^3 psi omega Q_3*,       Q_3* = (b - 0.223 b^3) eps/4      leaves at the ends
//! Q_p     = D^3 psi^3 p_en/eta Q_p*                                     pressed through by a [`StandardFeed`]
//! ```
//! with polynomials a_1, a_2, b_0 to b_4 in b.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | b, eps | - | `slenderness`, `eccentricity` |
//! | So, f/psi, Q_3*, Q_p* | - | functions of these names |
//! | beta | rad | `attitude` |
//!
//! **Source.** Butenschoen, thesis, Karlsruhe 1976 (fits of So and beta); ISO 7902-1 and -2, DIN 31652. The factors q_H
//! and q_P of feeds stand here from secondary sources. **Range.** b from 0.25 to 1.5, eps from 0.1 to 0.95: So within
//! some 2 %, beta within 2 degrees of films with film start and Swift-Stieber's end. **Verified by**
//! `tests/tests/literature/thermal_balance.rs`, and by the limits below.

use std::f64::consts::PI;

/// Polynomial in b, coefficients from the constant on.
fn polynomial<const N: usize>(coefficients: [f64; N], b: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * b + coefficient)
}

/// Sommerfeld number So.
pub fn sommerfeld_number(eccentricity: f64, slenderness: f64) -> f64 {
    let (eps, b) = (eccentricity, slenderness);
    let a_1 = polynomial([1.1642, -1.9456, 7.1161, -10.1073, 5.0141], b);
    let a_2 = polynomial([-1.000026, -0.023634, -0.4215, -0.038817, -0.090551], b);
    let square = eps * eps;
    let ocvirk = b * b * eps / (2.0 * (1.0 - square).powi(2)) * (PI * PI * (1.0 - square) + 16.0 * square).sqrt();
    ocvirk * a_1 * (eps - 1.0) / (a_2 + eps)
}

/// Attitude angle beta [rad].
pub fn attitude(eccentricity: f64, slenderness: f64) -> f64 {
    let (eps, b) = (eccentricity, slenderness);
    let factor = polynomial(
        [
            1.152624 - 0.104565 * b,
            -2.5905 + 0.798745 * b,
            8.73393 - 2.3291 * b,
            -13.3414 + 3.424337 * b,
            6.6294 - 1.591732 * b,
        ],
        eps,
    );
    factor * (PI * (1.0 - eps * eps).sqrt()).atan2(2.0 * eps)
}

/// Eccentricity at which the film has this Sommerfeld number, at most 0.9999; `None` where the number is negative or
/// none.
pub fn eccentricity(number: f64, slenderness: f64) -> Option<f64> {
    if !(number >= 0.0 && number.is_finite()) {
        return None;
    }
    let (mut low, mut high) = (0.0, 0.9999);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        match sommerfeld_number(middle, slenderness) < number {
            true => low = middle,
            false => high = middle,
        }
    }
    Some(0.5 * (low + high))
}

/// Coefficient of friction over psi, `f/psi`, of the full film at this Sommerfeld number.
pub fn friction(number: f64, eccentricity: f64, slenderness: f64) -> f64 {
    let shear = PI / (number * (1.0 - eccentricity * eccentricity).sqrt());
    shear + 0.5 * eccentricity * attitude(eccentricity, slenderness).sin()
}

/// Flow number Q_3* of what leaves at the ends because the film narrows.
pub fn side_flow_number(eccentricity: f64, slenderness: f64) -> f64 {
    0.25 * (slenderness - 0.223 * slenderness.powi(3)) * eccentricity
}

/// How the oil is fed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StandardFeed {
    /// A hole opposite to the load; its diameter over B.
    HoleOpposite(f64),
    /// A hole at 90 degrees to the load; its diameter over B.
    HoleAcross(f64),
    /// Two holes at 90 degrees to the load; their diameter over B.
    TwoHolesAcross(f64),
    /// A pocket opposite to the load; its width over B, 0.05 to 0.7.
    PocketOpposite(f64),
    /// A pocket at 90 degrees to the load; its width over B.
    PocketAcross(f64),
    /// Two pockets at 90 degrees to the load; their width over B.
    TwoPocketsAcross(f64),
    /// A groove all around; its width over B.
    GrooveAround(f64),
    /// A groove along the half that carries no load; its width over B.
    GrooveHalf(f64),
}

/// Flow number Q_p* of what the pressure of the feed presses through.
pub fn feed_flow_number(feed: StandardFeed, eccentricity: f64, slenderness: f64) -> f64 {
    let eps = eccentricity;
    let wide = (1.0 + eps).powi(3);
    let hole = |x: f64| PI / 48.0 / ((1.0 / x).ln() * polynomial([1.204, 0.368, -1.046, 1.942], x));
    let pocket = |x: f64| PI / 48.0 / ((1.0 / x).ln() * polynomial([1.188, 1.582, -2.585, 5.563], x));
    let film = |x: f64| 1.0 / (slenderness * (1.0 - x));
    match feed {
        StandardFeed::HoleOpposite(x) => wide * hole(x),
        StandardFeed::HoleAcross(x) => hole(x),
        StandardFeed::TwoHolesAcross(x) => 2.0 * hole(x),
        StandardFeed::PocketOpposite(x) => wide * pocket(x),
        StandardFeed::PocketAcross(x) => pocket(x),
        StandardFeed::TwoPocketsAcross(x) => 2.0 * pocket(x),
        StandardFeed::GrooveAround(x) => PI / 24.0 * (1.0 + 1.5 * eps * eps) * film(x),
        StandardFeed::GrooveHalf(x) => {
            let half = PI * (1.0 + 1.5 * eps * eps) + 6.0 * eps + 4.0 / 3.0 * eps.powi(3);
            half / 48.0 * film(x)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Sommerfeld number falls back on Ocvirk's for short bearings, where the last factor of the fit tends to
    /// 1.1642 only: the fit is for b from 0.25 on.
    #[test]
    fn numbers_by_hand() {
        // b = 0.345, eps = 0.8: So 1.040, beta 30.0 deg; a finite-difference film has 1.022 and 31.9 deg.
        assert!((sommerfeld_number(0.8, 0.345) - 1.040).abs() < 5e-4, "{}", sommerfeld_number(0.8, 0.345));
        assert!((attitude(0.8, 0.345).to_degrees() - 30.0).abs() < 0.05);
        for (eps, b) in [(0.1, 0.25), (0.5, 0.5), (0.9, 1.0), (0.95, 1.5)] {
            let number = sommerfeld_number(eps, b);
            assert!((eccentricity(number, b).expect("a number") - eps).abs() < 1e-12);
        }
        assert_eq!(eccentricity(f64::NAN, 0.5), None);
        assert!((eccentricity(1e30, 0.5).expect("a number") - 0.9999).abs() < 1e-9);
    }

    /// A journal at rest in the middle: Petroff's friction, no side flow; oil pressed through the annulus from a groove
    /// all around.
    #[test]
    fn a_centred_journal() {
        let number = sommerfeld_number(1e-9, 0.5);
        assert!((friction(number, 1e-9, 0.5) * number / PI - 1.0).abs() < 1e-6);
        assert_eq!(side_flow_number(0.0, 0.5), 0.0);
        // Two slots of length (B - b_G)/2: 2 pi D c^3 p/(12 eta (B - b_G)/2) with c = psi D/2.
        let annulus = 2.0 * PI / 8.0 / (12.0 * 0.5 * 0.4);
        assert!((feed_flow_number(StandardFeed::GrooveAround(0.2), 0.0, 0.5) / annulus - 1.0).abs() < 1e-12);
        assert!((feed_flow_number(StandardFeed::GrooveHalf(0.2), 0.0, 0.5) / (0.5 * annulus) - 1.0).abs() < 1e-12);
    }

    /// The mean of h^3 along the wide half over that of all of it.
    #[test]
    fn a_groove_feeds_by_the_cube_of_its_film() {
        let n = 100_000;
        let cube = |k: u32| {
            let theta = PI * (f64::from(k) + 0.5) / f64::from(n) - 0.5 * PI;
            (1.0 + 0.7 * theta.cos()).powi(3) / f64::from(n)
        };
        let half: f64 = (0..n).map(cube).sum();
        let fit = feed_flow_number(StandardFeed::GrooveHalf(0.0), 0.7, 0.5)
            / feed_flow_number(StandardFeed::GrooveHalf(0.0), 0.0, 0.5);
        assert!((fit / half - 1.0).abs() < 1e-8, "{fit} {half}");
    }
}
