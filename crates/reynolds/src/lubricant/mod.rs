//! The oil: viscosity as a function of pressure, and of temperature.
//!
//! A film has one temperature: [`ThermalOil`] gives its viscosity mu0, which enters the equation, and its density.
//!
//! The isothermal equation with any law `mu(p)` under the divergence is linear in the **reduced
//! pressure** `q = Int_0^p mu0/mu(s) ds`: `grad q = (mu0/mu) grad p`. So each law gives `q(p)` and
//! its inverse, and a limit of `q` above which no film exists.

pub mod barus;
pub mod density;
mod exponential;
pub mod grades;
pub mod roelands;
mod saturating;
mod temperature;
mod vogel;
pub mod walther;

pub use density::Density;
pub use exponential::ExponentialLaw;
pub use grades::Grade;
pub use saturating::Saturating;
pub use temperature::{TemperatureLaw, ThermalOil, ViscosityTable};
pub use vogel::Vogel;
pub use walther::Walther;

/// Growth of viscosity with pressure.
pub trait PressureViscosity: std::fmt::Debug {
    /// `mu(p)/mu0` at the gauge pressure `p` [Pa].
    fn viscosity_ratio(&self, p: f64) -> f64;

    /// Derivative [1/Pa] of [`PressureViscosity::viscosity_ratio`].
    fn viscosity_slope(&self, p: f64) -> f64;

    /// Reduced pressure `q(p)` [Pa].
    fn reduced_pressure(&self, p: f64) -> f64;

    /// Pressure `p` [Pa] at the reduced pressure `q`; infinite at and above [`PressureViscosity::limit`].
    fn pressure(&self, q: f64) -> f64;

    /// Pressure [Pa] at which `mu(p)/mu0` is this; infinite where it is reached nowhere.
    fn pressure_of_ratio(&self, ratio: f64) -> f64;

    /// Reduced pressure [Pa] of an infinite pressure: no film reaches it.
    fn limit(&self) -> f64 {
        f64::INFINITY
    }

    /// Reduced pressure [Pa] below which the law has no meaning.
    fn floor(&self) -> f64 {
        f64::NEG_INFINITY
    }
}

/// An oil at one temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct Lubricant {
    /// Viscosity mu0 at zero gauge pressure [Pa s].
    pub viscosity: f64,
    /// How it grows with pressure.
    pub pressure_law: PressureLaw,
    /// Density [kg/m3], of which turbulence asks alone.
    pub density: f64,
    /// Temperature [K] at which it has all of them; `None` where nothing depends on it.
    pub temperature: Option<f64>,
}

/// Law of viscosity against pressure.
#[derive(Debug, Clone, PartialEq)]
pub enum PressureLaw {
    /// `mu = mu0`.
    Constant,
    /// `mu = mu0 exp(alpha p)`.
    Barus(barus::Barus),
    /// Roelands' law, which grows slower than an exponential.
    Roelands(roelands::Roelands),
    /// One of these up to a great viscosity, for films that are tried.
    Saturating(Saturating),
}

/// How viscosity grows with pressure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LawKind {
    /// Roelands' law, the slowest of those there are.
    Roelands,
    /// Any other law, or none.
    Other,
}

impl PressureLaw {
    /// Kind of the law.
    pub fn kind(&self) -> LawKind {
        match self {
            Self::Roelands(_) => LawKind::Roelands,
            _ => LawKind::Other,
        }
    }

    /// This law, under which films that are tried have a pressure beyond its limit.
    pub(crate) fn saturating(&self) -> Self {
        Saturating::of(self).map_or_else(|| self.clone(), Self::Saturating)
    }
}

impl std::ops::Deref for PressureLaw {
    type Target = dyn PressureViscosity;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Constant => &Constant,
            Self::Barus(law) => law,
            Self::Roelands(law) => law,
            Self::Saturating(law) => law,
        }
    }
}

/// `mu = mu0`.
#[derive(Debug)]
struct Constant;

impl PressureViscosity for Constant {
    fn viscosity_ratio(&self, _p: f64) -> f64 {
        1.0
    }

    fn viscosity_slope(&self, _p: f64) -> f64 {
        0.0
    }

    fn reduced_pressure(&self, p: f64) -> f64 {
        p
    }

    fn pressure(&self, q: f64) -> f64 {
        q
    }

    fn pressure_of_ratio(&self, _ratio: f64) -> f64 {
        f64::INFINITY
    }
}

/// What holds of every law.
#[cfg(test)]
fn check(law: &dyn PressureViscosity) {
    for p in [-5e7, -1e5, 0.0, 1e3, 1e6, 3e7, 2e8, 5e8] {
        let back = law.pressure(law.reduced_pressure(p));
        // Near the limit q no longer resolves p: one rounding of q moves p by eps q mu/mu0.
        let resolved = 4.0 * f64::EPSILON * law.reduced_pressure(p).abs() * law.viscosity_ratio(p);
        assert!((back - p).abs() <= 1e-12 * p.abs() + 1e-6 + resolved, "{law:?} at {p}: {back}");
    }
    for p in [-3e7, 1e5, 2e7, 1e8] {
        let step = 1e2;
        let difference = |of: &dyn Fn(f64) -> f64| (of(p + step) - of(p - step)) / (2.0 * step);
        let slope = difference(&|p| law.reduced_pressure(p));
        assert!((slope * law.viscosity_ratio(p) - 1.0).abs() < 1e-6, "{law:?} at {p}");
        let off = difference(&|p| law.viscosity_ratio(p)) - law.viscosity_slope(p);
        assert!(off.abs() <= 1e-6 * law.viscosity_slope(p) + 1e-16, "{law:?} at {p}: {off}");
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn constant_viscosity_is_a_law() {
        super::check(&super::Constant);
    }
}
