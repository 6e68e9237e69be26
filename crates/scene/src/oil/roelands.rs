//! `[oil.roelands]`: a viscosity that grows slower with pressure than an exponential.

use super::{PressureLawTable, THINNER};
use crate::reader::TableReader;

keys! {
    "oil.roelands" = Table; "", "constant viscosity", "",
        "viscosity that grows with pressure, mu = mu0 exp{(ln mu0 + 9.67) [(1 + p/p_r)^z - 1]}, mu0 in Pa.s";
    "oil.roelands.z" = Number; "0.6", "required unless `alpha`", ">= 0",
        "exponent z in Roelands' law";
    "oil.roelands.alpha" = Quantity(InversePressure); "2.0e-8 1/Pa", "`z` gives the law", ">= 0",
        "instead of `z`: slope of ln mu at zero pressure";
    "oil.roelands.reference_pressure" = Quantity(Pressure); "196.2 MPa", "196.2 MPa", "> 0",
        "pressure p_r in Roelands' law";
}

/// Roelands' law: mu = mu0 exp((ln mu0 + 9.67) ((1 + p/p_r)^z - 1)), mu0 in Pa.s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoelandsTable {
    /// The exponent, directly or by the slope at zero pressure.
    pub exponent: RoelandsExponent,
    /// Reference pressure p_r [Pa].
    pub reference_pressure: f64,
}

/// How steep Roelands' law is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RoelandsExponent {
    /// Roelands' exponent z [1], not negative.
    Z(f64),
    /// Pressure-viscosity coefficient at zero pressure alpha [1/Pa], not negative: z = alpha p_r/(ln mu0 + 9.67).
    Alpha(f64),
}

pub(super) fn read(mut table: TableReader<'_>) -> PressureLawTable {
    let help = "give z >= 0, about 0.4 to 0.8 for mineral oil";
    let z = table.number("z").within(THINNER, help).given();
    let help = "give a value that is not negative, about 1e-8 to 4e-8 1/Pa for mineral oil";
    let alpha = table.number("alpha");
    let alpha = alpha.within(THINNER, help).given();
    table.refuse_if(
        z.is_some() && alpha.is_some(),
        "alpha",
        "stands beside z, but one of them gives the other",
        "keep one of z and alpha",
    );
    if alpha.is_none() {
        table.require_as("z", "0.6, or alpha = \"2.0e-8 1/Pa\" instead");
    }
    let reference = table.number("reference_pressure");
    PressureLawTable::Roelands(RoelandsTable {
        reference_pressure: reference.or_usual(),
        exponent: match (z, alpha) {
            (None, Some(alpha)) => RoelandsExponent::Alpha(alpha),
            (z, _) => RoelandsExponent::Z(z.unwrap_or(f64::NAN)),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::{STUDY, read, told_one};

    #[test]
    fn the_law_is_read_and_checked() {
        let barus = "barus = { alpha = \"2.5e-8 1/Pa\" }";
        told_one(barus, "roelands = {}", "oil.roelands.z: is missing");
        told_one("barus = { alpha = ", "roelands = { z = 0.6, alpha = ", "oil.roelands.alpha: stands beside z");
        told_one(barus, "roelands = { z = -1 }", "oil.roelands.z: is negative");
        let text = STUDY.replace(barus, "roelands = { alpha = \"20 1/GPa\" }");
        let law = read(&text).map(|scene| scene.oil.pressure_law).ok();
        let wanted = RoelandsTable { exponent: RoelandsExponent::Alpha(20.0 * 1e-9), reference_pressure: 196.2e6 };
        assert_eq!(law, Some(PressureLawTable::Roelands(wanted)));
    }
}
