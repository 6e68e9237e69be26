//! Where the position under a load is sought first: a closed estimate for a full ring.
//!
//! The infinitely short and the infinitely long bearing both carry more than the finite one; the reciprocals of their
//! Sommerfeld numbers added give that of the finite one to some ten percent (Reason, Narang, ASLE Trans. 25 (1982),
//! 437, who add the reciprocals of pressures).

use std::f64::consts::{FRAC_PI_2, PI};

use oilwedge_reynolds::analytical::ocvirk::ShortFilm;
use oilwedge_reynolds::analytical::sommerfeld;
use oilwedge_reynolds::contact::ContactLaw;
use oilwedge_reynolds::{Bearing, Gap, JournalState};

use crate::log_eccentricity::{eccentricity_at, log_eccentricity};

/// No position is sought nearer to contact: a film of a ten-thousandth of the clearance is some nanometres thick.
pub const GREATEST_ECCENTRICITY: f64 = 0.9999;

/// Whether the film of a journal is thinner somewhere than that of a parallel one at [`GREATEST_ECCENTRICITY`]: no
/// position is sought there.
pub fn is_contact(gap: &Gap, journal: &JournalState) -> bool {
    is_film_of_contact(gap.least(journal), gap.bearing().clearance)
}

/// Whether a film is one of contact ([`is_contact`]), by the least film and the clearance [m].
pub(crate) fn is_film_of_contact(least: f64, clearance: f64) -> bool {
    const ROUNDING: f64 = 1e-9;
    least < (1.0 - ROUNDING) * (1.0 - GREATEST_ECCENTRICITY) * clearance
}

/// Estimated eccentricity [1] and attitude angle [rad] of a ring of slenderness `B/D` under a load of this Sommerfeld
/// number; of the film with tension (`full`), or of one that breaks. At most [`GREATEST_ECCENTRICITY`]; `None` where
/// the number is not one.
pub fn first_position(sommerfeld_number: f64, slenderness: f64, full: bool) -> Option<(f64, f64)> {
    if !(sommerfeld_number.is_finite() && sommerfeld_number >= 0.0) {
        return None;
    }
    let carried = |eps: f64| {
        let (short, long) = match full {
            true => (ShortFilm::steady(eps).full_film(), sommerfeld::sommerfeld_number(eps)),
            false => (ShortFilm::steady(eps).half_film(), half_long(eps)),
        };
        let short = short.magnitude() * slenderness * slenderness;
        short * long / (short + long)
    };
    let (mut low, mut high) = (log_eccentricity(1e-12), log_eccentricity(GREATEST_ECCENTRICITY));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match carried(eccentricity_at(middle)) < sommerfeld_number {
            true => low = middle,
            false => high = middle,
        }
    }
    let eps = eccentricity_at(high).min(GREATEST_ECCENTRICITY);
    let attitude = match full {
        true => FRAC_PI_2,
        false => ShortFilm::steady(eps).half_film().attitude(),
    };
    Some((eps, attitude))
}

/// Eccentricity [1] at which the contact of a parallel journal in a plain ring carries `force` [N] alone; at most
/// [`GREATEST_ECCENTRICITY`].
pub fn first_contact(law: &dyn ContactLaw, bearing: &Bearing, force: f64) -> f64 {
    const HALVINGS: usize = 50;
    const POINTS: u32 = 2000;
    let (radius, clearance) = (bearing.radius, bearing.clearance);
    let carried = |eps: f64| {
        let at = |k: u32| {
            let cos = (PI * (f64::from(k) + 0.5) / f64::from(POINTS)).cos();
            law.at(clearance * (1.0 - eps * cos)).pressure * cos
        };
        2.0 * radius * bearing.length * PI / f64::from(POINTS) * (0..POINTS).map(at).sum::<f64>()
    };
    let (mut low, mut high) = (0.0, GREATEST_ECCENTRICITY);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        match carried(middle) < force {
            true => low = middle,
            false => high = middle,
        }
    }
    high
}

/// Sommerfeld number of the infinitely long bearing with the half film:
/// `3 eps sqrt(pi^2 - eps^2 (pi^2 - 4)) / ((2 + eps^2) (1 - eps^2))` (Hamrock, Schmid, Jacobson (2004), eq. 10.25).
fn half_long(eps: f64) -> f64 {
    let square = eps * eps;
    3.0 * eps * (PI * PI - square * (PI * PI - 4.0)).sqrt() / ((2.0 + square) * (1.0 - square))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_estimate_is_near_finite_bearings() {
        // Swift-Stieber films of B/D = 1/2: eccentricity and So (Raimondi, Boyd 1958: S = 0.0923, 0.0319 at eps 0.7,
        // 0.9 for a journal bearing of L/D = 1/2 rounded).
        for (eps, s) in [(0.6, 0.149), (0.8, 0.0505), (0.9, 0.0210)] {
            let (found, _) = first_position(1.0 / (2.0 * PI * s), 0.5, false).expect("a number");
            let ratio = (1.0 - found) / (1.0 - eps);
            assert!((0.6..1.6).contains(&ratio), "eps {eps}: {found}");
        }
    }

    #[test]
    fn nothing_and_too_much_are_bounded() {
        let at = |so: f64, full: bool| first_position(so, 0.5, full).expect("a number");
        assert!(at(0.0, false).0 < 1e-9);
        assert!((at(1e30, false).0 - GREATEST_ECCENTRICITY).abs() < 1e-12);
        assert_eq!(at(1.0, true).1, FRAC_PI_2);
        assert_eq!(first_position(f64::NAN, 0.5, true), None);
        assert_eq!(first_position(f64::INFINITY, 0.5, true), None);
    }

    #[test]
    fn the_long_half_film_carries_its_pressure() {
        // Int of Sommerfeld's pressure over the converging half: So = 1/2 hypot(Int p cos, Int p sin) with p over mu
        // omega / psi^2.
        let eps = 0.7;
        let n = 20_000;
        let mut force = [0.0; 2];
        for k in 0..n {
            let theta = PI * (f64::from(k) + 0.5) / f64::from(n);
            let part = 0.5 * sommerfeld::pressure(eps, theta) * PI / f64::from(n);
            force[0] += part * theta.cos();
            force[1] += part * theta.sin();
        }
        let load = force[0].hypot(force[1]);
        assert!((half_long(eps) / load - 1.0).abs() < 1e-6, "{} {load}", half_long(eps));
    }
}
