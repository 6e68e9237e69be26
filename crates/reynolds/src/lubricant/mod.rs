//! The oil: viscosity as a function of pressure, and of temperature.
//!
//! A film has one temperature: [`ThermalOil`] gives its viscosity mu0, which enters the equation, and its density.
//!
//! The isothermal equation with any law `mu(p)` under the divergence is linear in the **reduced
//! pressure** `q = Int_0^p mu0/mu(s) ds`: `grad q = (mu0/mu) grad p`. So each law gives `q(p)` and
//! its inverse, and a limit of `q` above which no film exists.

mod barus;
pub mod density;
pub mod grades;
mod roelands;
mod temperature;
mod vogel;
pub mod walther;

pub use barus::Barus;
pub use density::Density;
pub use grades::Grade;
pub use roelands::Roelands;
pub use temperature::{TemperatureLaw, ThermalOil, ViscosityTable};
pub use vogel::Vogel;
pub use walther::Walther;

/// An oil at one temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Lubricant {
    /// Viscosity mu0 at zero gauge pressure [Pa s].
    pub viscosity: f64,
    /// How it grows with pressure.
    pub pressure_law: PressureLaw,
}

/// Law of viscosity against pressure.
#[derive(Debug, Clone, PartialEq)]
pub enum PressureLaw {
    /// `mu = mu0`.
    Constant,
    /// `mu = mu0 exp(alpha p)`.
    Barus(Barus),
    /// Roelands' law, which grows slower than an exponential.
    Roelands(Roelands),
}

impl PressureLaw {
    /// `mu(p)/mu0` at the gauge pressure `p` [Pa].
    pub fn viscosity_ratio(&self, p: f64) -> f64 {
        match self {
            Self::Constant => 1.0,
            Self::Barus(law) => law.viscosity_ratio(p.into()).v,
            Self::Roelands(law) => law.viscosity_ratio(p),
        }
    }

    /// Reduced pressure `q(p)` [Pa].
    pub fn reduced_pressure(&self, p: f64) -> f64 {
        match self {
            Self::Constant => p,
            Self::Barus(law) => law.reduced_pressure(p),
            Self::Roelands(law) => law.reduced_pressure(p),
        }
    }

    /// Pressure `p` [Pa] at the reduced pressure `q`; infinite at and above [`PressureLaw::limit`].
    pub fn pressure(&self, q: f64) -> f64 {
        match self {
            Self::Constant => q,
            Self::Barus(law) => law.pressure(q),
            Self::Roelands(law) => law.pressure(q),
        }
    }

    /// Reduced pressure [Pa] of an infinite pressure: no film reaches it. Infinite for constant viscosity.
    pub fn limit(&self) -> f64 {
        match self {
            Self::Constant => f64::INFINITY,
            Self::Barus(law) => law.limit(),
            Self::Roelands(law) => law.limit(),
        }
    }

    /// Reduced pressure [Pa] below which the law has no meaning; minus infinity if it always has.
    pub fn floor(&self) -> f64 {
        match self {
            Self::Constant | Self::Barus(_) => f64::NEG_INFINITY,
            Self::Roelands(law) => law.floor(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn laws() -> [PressureLaw; 3] {
        [
            PressureLaw::Constant,
            PressureLaw::Barus(Barus { alpha: 2.5e-8 }),
            PressureLaw::Roelands(Roelands::new(0.04, 0.6, 196.2e6)),
        ]
    }

    #[test]
    fn pressure_inverts_reduced_pressure() {
        for law in laws() {
            for p in [-5e7, -1e5, 0.0, 1e3, 1e6, 3e7, 2e8, 5e8] {
                let back = law.pressure(law.reduced_pressure(p));
                // Near the limit q no longer resolves p: one rounding of q moves p by eps q mu/mu0.
                let resolved = 4.0 * f64::EPSILON * law.reduced_pressure(p).abs() * law.viscosity_ratio(p);
                assert!(
                    (back - p).abs() <= 1e-12 * p.abs() + 1e-6 + resolved,
                    "{law:?} at {p}: {back}"
                );
            }
        }
    }

    #[test]
    fn reduced_pressure_has_slope_mu0_over_mu() {
        for law in laws() {
            for p in [-3e7, 1e5, 2e7, 1e8] {
                let step = 1e2;
                let slope = (law.reduced_pressure(p + step) - law.reduced_pressure(p - step)) / (2.0 * step);
                assert!((slope * law.viscosity_ratio(p) - 1.0).abs() < 1e-6, "{law:?} at {p}");
            }
        }
    }
}
