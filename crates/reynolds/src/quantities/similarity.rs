//! # Numbers without dimension
//!
//! **Equation.** `So = F psi^2 / (B D mu0 omega)` with `psi = c/R`; `C_w = W / (4 L R (p_s - p_e))`
//! with `L = B/2`; flows over `D^3 psi omega`; attitude angle `phi_min - phi_load`, times the sign of omega.
//! **Source.** Sommerfeld, Z. Math. Phys. 50 (1904) 97; the FlexPDE study (its last equation); ISO 7902-2 (flows).
//! **Range.** So needs a turning journal, C_w a supply pressure different from p_e.
//! **Verified by** `signs_and_units_by_hand`.

use crate::{Bearing, JournalState};

/// Sommerfeld number of the load `force` [N]; none at rest.
pub fn sommerfeld_number(bearing: &Bearing, viscosity: f64, journal: &JournalState, force: f64) -> Option<f64> {
    let psi = bearing.clearance / bearing.radius;
    let drag = bearing.length * 2.0 * bearing.radius * viscosity * journal.speed.abs();
    (drag > 0.0).then(|| force * psi * psi / drag)
}

/// Load coefficient C_w of the FlexPDE study; none where supply and end pressure are equal.
pub fn load_coefficient(bearing: &Bearing, supply_pressure: f64, force: f64) -> Option<f64> {
    let head = supply_pressure - bearing.end_pressure;
    (head != 0.0).then(|| force / (2.0 * bearing.length * bearing.radius * head))
}

/// Unit `D^3 psi omega` [m3/s] of flows; none at rest.
pub fn flow_unit(bearing: &Bearing, journal: &JournalState) -> Option<f64> {
    let unit = 8.0 * bearing.radius.powi(2) * bearing.clearance * journal.speed.abs();
    (unit > 0.0).then_some(unit)
}

/// Attitude angle [rad] in (-pi, pi]: from the load to the minimum film, against the rotation.
pub fn attitude_angle(journal: &JournalState, load_angle: f64) -> f64 {
    let sense = if journal.speed < 0.0 { -1.0 } else { 1.0 };
    let angle = sense * (journal.min_film_angle() - load_angle);
    let wrapped = angle.rem_euclid(std::f64::consts::TAU);
    if wrapped > std::f64::consts::PI { wrapped - std::f64::consts::TAU } else { wrapped }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn signs_and_units_by_hand() {
        let bearing = Bearing { radius: 0.05, length: 0.1, clearance: 5e-5, end_pressure: 1e5 };
        let journal = JournalState::at_eccentricity(0.5, PI, 5e-5, -100.0);
        // psi = 1e-3; F psi^2 = 1e4 * 1e-6 = 0.01; B D mu omega = 0.1 * 0.1 * 0.02 * 100 = 0.02.
        assert!((sommerfeld_number(&bearing, 0.02, &journal, 1e4).unwrap() - 0.5).abs() < 1e-15);
        // 4 L R (p_s - p_e) = 4 * 0.05 * 0.05 * 1e5 = 1000 N.
        assert!((load_coefficient(&bearing, 2e5, 1e4).unwrap() - 10.0).abs() < 1e-14);
        assert_eq!(load_coefficient(&bearing, 1e5, 1e4), None);
        // Turning backwards the sign flips: phi_min = 180, load at 230 degrees -> +50.
        assert!((attitude_angle(&journal, 230f64.to_radians()).to_degrees() - 50.0).abs() < 1e-12);
        // D^3 psi omega = 1e-3 * 1e-3 * 100.
        assert!((flow_unit(&bearing, &journal).unwrap() - 1e-4).abs() < 1e-18);
        let at_rest = JournalState { speed: 0.0, ..journal };
        assert_eq!(sommerfeld_number(&bearing, 0.02, &at_rest, 1e4), None);
        assert_eq!(flow_unit(&bearing, &at_rest), None);
        assert!((attitude_angle(&at_rest, PI / 2.0).to_degrees() - 90.0).abs() < 1e-12);
    }
}
