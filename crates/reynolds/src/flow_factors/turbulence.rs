//! # Turbulent flow: resistance and shear that grow with the Reynolds number of the film
//!
//! **Equation.** With `Re = rho U h/mu` of the film at a place
//!
//! ```text
//! J_d = s U_d h - h^3/(k_d mu) dp/dx_d,   k_d = 12 + a_d Re^n_d       tau = mu U/h (1 + a Re^n)
//! ```
//!
//! | model | a_x, n_x | a_z, n_z | a, n |
//! |---|---|---|---|
//! | Ng and Pan | 0.0136, 0.90 | 0.0043, 0.96 | 0.0012, 0.94 |
//! | Constantinescu | 0.0260, 0.8265 | 0.0198, 0.741 | 0.0023, 0.855 |
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Re | 1 | `reynolds_number` |
//! | rho | kg/m3 | `density` |
//! | U, h, mu | m/s, m, Pa s | `velocity`, `thickness`, `viscosity` of the film |
//! | k_x, k_z | 1 | `resistance` |
//! | tau over mu U/h | 1 | `shear` |
//!
//! **Reichardt**'s eddies are found across the film, with its temperatures there; their factors stand at each place of
//! the film ([`crate::EddyFactors`]) as powers of its gap. A film of one temperature has Ng and Pan's laws, which fit
//! them.
//!
//! **Source.** Ng, Pan, Trans. ASME J. Basic Eng. 87 (1965) 675, by the usual fits to their integrals; Constantinescu,
//! Trans. ASME J. Basic Eng. 84 (1962) 139, whose mixing length of `k = 0.125 Re^0.07` makes
//! `k_x = 12 + 0.53 (k^2 Re)^0.725` and `k_z = 12 + 0.296 (k^2 Re)^0.65` these. **Range.** The shear of the journal
//! makes the turbulence: pressure flow is small beside it. Re up to some 3e4; the film becomes laminar without a
//! threshold as Re falls. The journal's surface moves along x, and viscosity does not depend on pressure. **Verified
//! by** the tests below and `tests/tests/turbulence`.

use super::{ConductanceFactor, FlowFactor};
use crate::{EddyFactors, FilmPoint};

/// A law `a Re^n` of what turbulence adds.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PowerLaw {
    coefficient: f64,
    exponent: f64,
}

impl PowerLaw {
    fn at(self, reynolds_number: f64) -> f64 {
        self.coefficient * reynolds_number.powf(self.exponent)
    }
}

/// How much more a turbulent film resists.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TurbulenceModel {
    /// Ng and Pan's linearised theory of eddy viscosity.
    NgPan,
    /// Constantinescu's theory of a mixing length.
    Constantinescu,
    /// Reichardt's eddy viscosity at each place across the film.
    Reichardt,
}

impl TurbulenceModel {
    /// Laws of k_x - 12, k_z - 12, and the shear over that of a laminar film less one.
    fn laws(self) -> [PowerLaw; 3] {
        let law = |coefficient: f64, exponent: f64| PowerLaw { coefficient, exponent };
        match self {
            Self::NgPan | Self::Reichardt => [law(0.0136, 0.90), law(0.0043, 0.96), law(0.0012, 0.94)],
            Self::Constantinescu => [law(0.0260, 0.8265), law(0.0198, 0.741), law(0.0023, 0.855)],
        }
    }

    /// Resistances k_x and k_z [1] at a Reynolds number: 12 of a laminar film.
    pub fn resistance(self, reynolds_number: f64) -> [f64; 2] {
        let [x, z, _] = self.laws();
        [x, z].map(|law| 12.0 + law.at(reynolds_number))
    }

    /// Shear stress over that of a laminar film [1] at a Reynolds number.
    pub fn shear_at(self, reynolds_number: f64) -> f64 {
        1.0 + self.laws()[2].at(reynolds_number)
    }
}

/// Reynolds number [1] of oil of this `density` [kg/m3] at a point of a film.
pub fn reynolds_number(film: &FilmPoint, density: f64) -> f64 {
    density * film.velocity[0].hypot(film.velocity[1]) * film.thickness / film.viscosity
}

impl FlowFactor for TurbulenceModel {
    fn name(&self) -> &'static str {
        match self {
            Self::NgPan => "ng-pan",
            Self::Constantinescu => "constantinescu",
            Self::Reichardt => "reichardt",
        }
    }

    fn is_laminar(&self) -> bool {
        false
    }

    /// Re is in proportion to `h/mu`: a law `r = a Re^n` changes by `n r` with the logarithm of either.
    fn conductance(&self, film: &FilmPoint, density: f64) -> [ConductanceFactor; 2] {
        if let Some(eddies) = &film.eddies {
            return [0, 1].map(|axis| eddies.conductance_in(film, axis));
        }
        let reynolds_number = reynolds_number(film, density);
        let [x, z, _] = self.laws();
        [x, z].map(|law| {
            let more = law.at(reynolds_number);
            let value = 12.0 / (12.0 + more);
            let by_logarithm = -value * law.exponent * more / (12.0 + more);
            ConductanceFactor {
                value,
                by_gap: by_logarithm / film.thickness,
                by_viscosity: -by_logarithm / film.viscosity,
            }
        })
    }

    fn shear(&self, film: &FilmPoint, density: f64) -> f64 {
        match &film.eddies {
            Some(eddies) => eddies.shear * (film.thickness / eddies.gap).powf(eddies.shear_growth),
            None => self.shear_at(reynolds_number(film, density)),
        }
    }
}

impl EddyFactors {
    fn conductance_in(&self, film: &FilmPoint, axis: usize) -> ConductanceFactor {
        let power = self.conductance_growth[axis];
        let value = self.conductance[axis] * (film.thickness / self.gap).powf(power);
        // The viscosities of the film for which the factors were found stand in them.
        ConductanceFactor { value, by_gap: power * value / film.thickness, by_viscosity: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODELS: [TurbulenceModel; 2] = [TurbulenceModel::NgPan, TurbulenceModel::Constantinescu];

    /// A laminar film has no factor.
    #[test]
    fn a_film_at_rest_is_laminar() {
        let film = FilmPoint { thickness: 1e-4, viscosity: 0.01, ..FilmPoint::default() };
        for model in MODELS {
            let still = ConductanceFactor { value: 1.0, by_gap: 0.0, by_viscosity: 0.0 };
            assert_eq!(model.conductance(&film, 850.0), [still; 2]);
            assert_eq!(model.shear(&film, 850.0), 1.0);
        }
    }

    /// Constantinescu's formula by the mixing length, without the fits of `k = 0.125 Re^0.07` in it.
    #[test]
    fn constantinescu_follows_from_his_mixing_length() {
        for reynolds_number in [1e3, 1e4, 3e4] {
            let mixed = 0.125f64.powi(2) * f64::powf(reynolds_number, 1.14);
            let wanted = [12.0 + 0.53 * mixed.powf(0.725), 12.0 + 0.296 * mixed.powf(0.65)];
            for (value, wanted) in TurbulenceModel::Constantinescu.resistance(reynolds_number).into_iter().zip(wanted) {
                assert!((value / wanted - 1.0).abs() < 2e-3, "{reynolds_number}: {value} {wanted}");
            }
        }
    }

    /// Robertson's law of measured Couette flow (1959), `C = (Re/4) (0.19/log10(Re/4))^2`.
    #[test]
    fn the_shear_is_that_of_measured_couette_flow() {
        for reynolds_number in [1e4, 3e4] {
            let quarter: f64 = 0.25 * reynolds_number;
            let measured = quarter * (0.19 / quarter.log10()).powi(2);
            for model in MODELS {
                let shear = model.shear_at(reynolds_number);
                assert!((shear / measured - 1.0).abs() < 0.14, "{model:?} {reynolds_number}: {shear} {measured}");
            }
        }
    }

    /// Ng and Pan's integrals, by the midpoint rule on points that are dense at the wall.
    fn integrals(wall_gap: f64) -> [f64; 4] {
        const POINTS: u32 = 4000;
        let (mut shear, mut along, mut across) = (0.0, 0.0, 0.0);
        for point in 0..POINTS {
            let s = (f64::from(point) + 0.5) / f64::from(POINTS);
            let (eta, weight) = (0.5 * s.powi(3), 3.0 * s * s / f64::from(POINTS));
            let (y, t) = (eta * wall_gap, (eta * wall_gap / 10.7).tanh());
            let eddy = 1.0 + 0.4 * (y - 10.7 * t);
            // The eddy viscosity grows with the root of the stress, and so does its change along the flow.
            let by_stress = 0.5 * 0.4 * y * t * t / eddy;
            let pressed = weight * (0.5 - eta).powi(2) / eddy;
            shear += weight / eddy;
            along += pressed * (1.0 - by_stress);
            across += pressed;
        }
        [wall_gap * wall_gap * shear, 1.0 / along, 1.0 / across, 1.0 / shear]
    }

    /// The fits against the theory that they fit: Reichardt's eddy viscosity linearised about Couette flow.
    #[test]
    fn ng_and_pan_follow_from_the_eddy_viscosity() {
        for (reynolds_number, tolerance) in [(1e3, 0.08), (3e3, 0.06), (1e4, 0.05), (3e4, 0.12)] {
            let (mut low, mut high) = (1.0f64, 1e5f64);
            for _ in 0..60 {
                let middle = (low * high).sqrt();
                let is_below = integrals(middle)[0] < reynolds_number;
                if is_below { low = middle } else { high = middle }
            }
            let [_, along, across, shear] = integrals(low);
            let [k_x, k_z] = TurbulenceModel::NgPan.resistance(reynolds_number);
            let fits = [(k_x, along), (k_z, across), (TurbulenceModel::NgPan.shear_at(reynolds_number), shear)];
            for (fit, wanted) in fits {
                assert!((fit / wanted - 1.0).abs() < tolerance, "{reynolds_number}: {fit} {wanted}");
            }
        }
    }
}
