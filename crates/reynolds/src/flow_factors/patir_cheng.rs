//! # Flow between rough surfaces
//!
//! **Equation.** `J = (U/2) h_T - phi_p h^3/(12 mu) grad p`, storage `dh_T/dt`; isotropic heights:
//! `phi_p = 1 - 0.9 exp(-0.56 h/sigma)`; Gaussian heights: `h_T = h Phi(h/sigma) + sigma phi(h/sigma)`, the mean of the
//! gap where the surfaces do not overlap, Phi and phi the normal distribution and its density. Both surfaces are
//! equally rough, so that what one drags along more in its valleys the other drags along less: no shear flow factor.
//! The void fraction of a cavity multiplies all oil that is carried.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h (gap of the mean planes) | m | `gap` |
//! | sigma (root mean square roughness of both surfaces together) | m | `roughness` |
//! | phi_p | 1 | `conductance` |
//! | h_T | m | `mean_gap` |
//!
//! **Source.** Patir, Cheng, Trans. ASME J. Lubr. Technol. 100 (1978) 12 (phi_p); 101 (1979) 220 (h_T, equal
//! roughness); Harp, Salant, Trans. ASME J. Tribol. 123 (2001) 134 (cavities). **Range.** h/sigma above some 0.5, where
//! phi_p was found; it tends to 0.1 where the mean planes meet. **Verified by** `the_mean_gap_is_the_mean_of_the_gap`,
//! `variations_match_differences` and the second code of `tests/full/tests/contact/mixed.rs`.

use std::f64::consts::PI;
use std::sync::LazyLock;

use super::{ConductanceFactor, FlowFactor, Jet};
use crate::FilmPoint;
use crate::chebyshev::Piecewise;

/// `h/sigma` from which on the surfaces do not overlap: the density is below 1e-18 there.
const APART: f64 = 9.0;

/// The normal distribution from zero on.
static NORMAL: LazyLock<Piecewise> = LazyLock::new(|| Piecewise::new(0.0, APART, 72, normal));

/// FlowScales of two surfaces that are equally rough in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatirCheng {
    /// Combined roughness sigma [m].
    pub roughness: f64,
}

impl FlowFactor for PatirCheng {
    fn name(&self) -> &'static str {
        "patir-cheng"
    }

    fn conductance(&self, film: &FilmPoint, _density: f64) -> [ConductanceFactor; 2] {
        const AMPLITUDE: f64 = 0.9;
        const DECAY: f64 = 0.56;
        let less = AMPLITUDE * (-DECAY * (film.thickness / self.roughness)).exp();
        [ConductanceFactor { value: 1.0 - less, by_gap: DECAY * less / self.roughness, by_viscosity: 0.0 }; 2]
    }

    fn mean_gap(&self, gap: f64) -> Option<Jet> {
        let sigma = self.roughness;
        let l = gap / sigma;
        Some(match l < APART {
            false => [gap, 1.0, 0.0],
            true => {
                // Phi(-l) = 1 - Phi(l).
                let above = NORMAL.at(l.abs())[0];
                let distribution = if l < 0.0 { 1.0 - above } else { above };
                let density = density(l);
                [gap * distribution + sigma * density, distribution, density / sigma]
            }
        })
    }
}

fn density(l: f64) -> f64 {
    (-0.5 * l * l).exp() / (2.0 * PI).sqrt()
}

/// The normal distribution at `l >= 0`, by its series of positive terms (Abramowitz, Stegun (1964), 26.2.11).
fn normal(l: f64) -> f64 {
    let (mut term, mut sum, mut k) = (l, 0.0, 1.0);
    while term > f64::EPSILON * sum {
        sum += term;
        k += 2.0;
        term *= l * l / k;
    }
    0.5 + density(l) * sum
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The mean of `max(h + delta, 0)` over Gaussian delta, by the trapezoidal rule.
    #[test]
    fn the_mean_gap_is_the_mean_of_the_gap() {
        let factor = PatirCheng { roughness: 2.0 };
        for gap in [0.2, 1.0, 3.0, 10.0, 17.0, 30.0] {
            let step = 1e-4;
            // From where the surfaces touch on: the integrand begins there with a slope, which Euler and Maclaurin's
            // term corrects.
            let from = -gap / 2.0;
            let at = |k: i32| {
                let delta = from + step * f64::from(k);
                (gap + 2.0 * delta) * density(delta)
            };
            let sum: f64 = step * (0..400_000).map(at).sum::<f64>() + step * step / 12.0 * 2.0 * density(from);
            let mean_gap = factor.mean_gap(gap).expect("rough surfaces");
            assert!((mean_gap[0] - sum).abs() < 1e-11, "{gap}: {} {sum}", mean_gap[0]);
        }
    }

    /// Patir and Cheng's factor at `h/sigma` 0.5, 3 and 6 by its formula, to its printed digits; far apart the surfaces
    /// are smooth.
    #[test]
    fn the_factor_is_that_of_isotropic_surfaces() {
        let factor = PatirCheng { roughness: 1e-6 };
        for (l, wanted) in [(0.5, 0.3198), (3.0, 0.8323), (6.0, 0.9687), (100.0, 1.0)] {
            let film = FilmPoint { thickness: 1e-6 * l, ..FilmPoint::default() };
            assert!((factor.conductance(&film, 0.0)[0].value - wanted).abs() < 1e-4, "{l}");
        }
        assert_eq!(factor.mean_gap(1e-5), Some([1e-5, 1.0, 0.0]));
    }
}
