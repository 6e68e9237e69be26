//! # Roelands: viscosity grows with a power of pressure in the exponent
//!
//! **Equation.** `mu = mu0 exp{A [(1 + p/p_r)^z - 1]}`, `A = ln(mu0) + 9.67` (mu0 in Pa s);
//! `q = Int_0^p mu0/mu ds` has no elementary form: it is tabulated once, panel by panel.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | A | - | `exponent` |
//! | p_r = 196.2 MPa | Pa | `reference_pressure` |
//! | z | - | `index` |
//! | alpha = A z / p_r (slope at p = 0) | 1/Pa | [`Roelands::index_of`] |
//!
//! **Source.** Roelands, thesis, Delft 1966; in this form Hamrock et al. (2004), eq. 4.23.
//! **Range.** `p > -p_r`, `mu0 > 6.3e-5 Pa s`. **Verified by** `limit_matches_the_literature` and
//! the tests of `lubricant`.

use super::PressureViscosity;

/// Panels of the table per reference pressure.
const PANELS_PER_REFERENCE: f64 = 32.0;
/// The table ends where viscosity has grown by this factor: what is left of `q` is below rounding.
const GREATEST_RATIO: f64 = 1e18;
/// Most reference pressures at which the law ends in any case.
const GREATEST_PRESSURE: f64 = 1e9;

/// Roelands' law with its table of reduced pressures.
#[derive(Debug, Clone, PartialEq)]
pub struct Roelands {
    exponent: f64,
    index: f64,
    reference_pressure: f64,
    /// Pressures [Pa] that bound the panels, ascending from near `-p_r`.
    pressures: Vec<f64>,
    /// Reduced pressure [Pa] at each.
    reduced: Vec<f64>,
}

impl Roelands {
    /// The law from the viscosity mu0 [Pa s] (above 6.3e-5), the index z in (0, 1.2] or so, and p_r [Pa].
    pub fn new(viscosity: f64, index: f64, reference_pressure: f64) -> Self {
        let mut law = Self {
            exponent: viscosity.ln() + 9.67,
            index,
            reference_pressure,
            pressures: vec![0.0],
            reduced: vec![0.0],
        };
        // Upwards the panels are even in ln(1 + p/p_r), so their number does not grow with small z.
        loop {
            let (p, q) = (law.pressures[law.pressures.len() - 1], law.reduced[law.reduced.len() - 1]);
            if law.viscosity_ratio(p) > GREATEST_RATIO || p > GREATEST_PRESSURE * reference_pressure {
                break;
            }
            let next = p + (p + reference_pressure) / PANELS_PER_REFERENCE;
            law.reduced.push(q + law.panel_integral(p, next));
            law.pressures.push(next);
        }
        // Down to p_r below zero the power has a kink: stop one panel short of it.
        let width = reference_pressure / PANELS_PER_REFERENCE;
        let (mut pressures, mut reduced) = (Vec::new(), Vec::new());
        let mut q = 0.0;
        for k in 1..PANELS_PER_REFERENCE as usize {
            let p = -(k as f64) * width;
            q -= law.panel_integral(p, p + width);
            pressures.push(p);
            reduced.push(q);
        }
        pressures.reverse();
        reduced.reverse();
        pressures.append(&mut law.pressures);
        reduced.append(&mut law.reduced);
        Self { pressures, reduced, ..law }
    }

    /// Index z that gives the pressure-viscosity coefficient `alpha` [1/Pa] at zero pressure.
    pub fn index_of(alpha: f64, viscosity: f64, reference_pressure: f64) -> f64 {
        alpha * reference_pressure / (viscosity.ln() + 9.67)
    }

    /// `Int mu0/mu ds` over at most one panel: Gauss-Legendre with eight points.
    fn panel_integral(&self, from: f64, to: f64) -> f64 {
        const POINTS: [(f64, f64); 4] = [
            (0.183_434_642_495_649_8, 0.362_683_783_378_362),
            (0.525_532_409_916_329, 0.313_706_645_877_887_27),
            (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
            (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
        ];
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let sum: f64 = POINTS
            .iter()
            .map(|&(x, w)| {
                let (low, high) = (middle - half * x, middle + half * x);
                w * (1.0 / self.viscosity_ratio(low) + 1.0 / self.viscosity_ratio(high))
            })
            .sum();
        half * sum
    }
}

impl PressureViscosity for Roelands {
    fn viscosity_ratio(&self, p: f64) -> f64 {
        (self.exponent * ((1.0 + p / self.reference_pressure).powf(self.index) - 1.0)).exp()
    }

    fn viscosity_slope(&self, p: f64) -> f64 {
        let power = (1.0 + p / self.reference_pressure).powf(self.index - 1.0);
        self.exponent * self.index / self.reference_pressure * power * self.viscosity_ratio(p)
    }

    fn reduced_pressure(&self, p: f64) -> f64 {
        let panel = self.pressures.partition_point(|&bound| bound <= p).saturating_sub(1);
        if panel + 1 == self.pressures.len() {
            return self.limit();
        }
        self.reduced[panel] + self.panel_integral(self.pressures[panel], p)
    }

    fn pressure(&self, q: f64) -> f64 {
        if q >= self.limit() {
            return f64::INFINITY;
        }
        let panel = self.reduced.partition_point(|&bound| bound <= q).saturating_sub(1);
        let panel = panel.min(self.pressures.len() - 2);
        let (p, p_next) = (self.pressures[panel], self.pressures[panel + 1]);
        let (q_here, q_next) = (self.reduced[panel], self.reduced[panel + 1]);
        // q(p) is increasing and concave: Newton from the left end of its panel rises to the root.
        let mut root = p + (q - q_here) * (p_next - p) / (q_next - q_here) * 0.5;
        for _ in 0..30 {
            let step = (q - q_here - self.panel_integral(p, root)) * self.viscosity_ratio(root);
            root = (root + step).min(p_next);
            if step.abs() <= 1e-14 * (root.abs() + self.reference_pressure * 1e-3) {
                break;
            }
        }
        root
    }

    fn pressure_of_ratio(&self, ratio: f64) -> f64 {
        self.reference_pressure * ((1.0 + ratio.ln() / self.exponent).powf(1.0 / self.index) - 1.0)
    }

    fn limit(&self) -> f64 {
        self.reduced[self.reduced.len() - 1]
    }

    fn floor(&self) -> f64 {
        self.reduced[0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn index_zero_is_constant_viscosity_and_small_ones_end() {
        let constant = Roelands::new(0.04, 0.0, 196.2e6);
        for p in [-1e8, 0.0, 1e6, 1e9] {
            assert_eq!(constant.viscosity_ratio(p), 1.0);
            assert!((constant.reduced_pressure(p) - p).abs() <= 1e-12 * p.abs());
            assert!((constant.pressure(p) - p).abs() <= 1e-12 * p.abs());
        }
        for index in [1e-6, 1e-3, 0.05, 1.0] {
            let law = Roelands::new(0.001, index, 196.2e6);
            assert!(law.pressures.len() < 1000);
            assert!((law.pressure(law.reduced_pressure(3e8)) / 3e8 - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn reduced_pressure_inverts_and_slopes_match() {
        super::super::check(&Roelands::new(0.04, 0.6, 196.2e6));
    }

    /// `q(infinity)` of `barus_exact_transform` in the reference collection (four digits).
    #[test]
    fn limit_matches_the_literature() {
        for (mu0, alpha, limit) in [(0.04, 1.973e-8, 55.70e6), (0.0061, 1.398e-8, 81.37e6), (0.4, 2.677e-8, 40.11e6)] {
            let law = Roelands::new(mu0, 0.6, 196.2e6);
            assert!((law.limit() / limit - 1.0).abs() < 2e-4, "{mu0}: {}", law.limit());
            assert!((Roelands::index_of(alpha, mu0, 196.2e6) - 0.6).abs() < 1e-3);
        }
    }
}
