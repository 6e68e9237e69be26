//! The kinds of quantities that a scene holds, and the units of each.

use std::f64::consts::PI;

/// What kind of quantity a key asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Length [m].
    Length,
    /// Angle [rad].
    Angle,
    /// Pressure [Pa].
    Pressure,
    /// Dynamic viscosity [Pa.s].
    Viscosity,
    /// Angular speed [rad/s].
    Speed,
    /// Inverse pressure [1/Pa].
    InversePressure,
    /// Force [N].
    Force,
    /// Velocity [m/s].
    Velocity,
    /// Mass [kg].
    Mass,
    /// Area [m2].
    Area,
    /// Ratio [1].
    Ratio,
    /// Temperature [K].
    Temperature,
    /// Difference of temperatures [K].
    TemperatureDifference,
    /// Inverse temperature [1/K].
    InverseTemperature,
    /// Kinematic viscosity [m2/s].
    KinematicViscosity,
    /// Density [kg/m3].
    Density,
    /// Heat capacity per volume [J/(m3 K)].
    HeatCapacity,
    /// Heat conductance [W/K].
    Conductance,
    /// Heat transfer coefficient [W/(m2 K)].
    HeatTransfer,
    /// Heat conductivity [W/(m K)].
    ThermalConductivity,
    /// Volume flow [m3/s].
    VolumeFlow,
    /// Torque [N.m].
    Torque,
    /// Power [W].
    Power,
    /// Rotational stiffness [N.m/rad].
    RotationalStiffness,
    /// Stiffness [N/m].
    Stiffness,
    /// Stiffness between offset and slope [N/rad].
    CrossStiffness,
    /// Damping [N.s/m].
    Damping,
    /// Damping between offset and slope [N.s/rad].
    CrossDamping,
    /// Rotational damping [N.m.s/rad].
    RotationalDamping,
    /// Displacement of a surface for each pressure [m/Pa].
    LayerCompliance,
    /// Displacement for each force [m/N].
    PointCompliance,
}

/// A quantity is zero, or at least so many times the example of its kind.
const LEAST: f64 = 1e-25;
/// A quantity is at most so many times the example of its kind.
const MOST: f64 = 1e15;
/// Temperature [K] of the ice point.
pub const ZERO_CELSIUS: f64 = 273.15;
pub(crate) const BAR: f64 = 1e5;
pub(crate) const ATMOSPHERE: f64 = 101_325.0;
pub(crate) const TECHNICAL_ATMOSPHERE: f64 = 98_066.5;
pub(crate) const INCH: f64 = 0.0254;
pub(crate) const POUND: f64 = 0.453_592_37;
pub(crate) const POUND_FORCE: f64 = POUND * GRAVITY;
/// Acceleration [m/s2] by which units of force are defined.
pub(crate) const GRAVITY: f64 = 9.806_65;
pub(crate) const PSI: f64 = POUND_FORCE / (INCH * INCH);

use Dimension::*;

/// A kind, its name with an article, a quantity as one would write it, and its units with their size in SI.
type DimensionRow = (Dimension, &'static str, &'static str, &'static [(&'static str, f64)]);

/// All kinds, in the order of [`Dimension`].
#[rustfmt::skip]
const TABLE: [DimensionRow; 31] = [
    (Length, "a length", "25 mm", &[("m", 1.0), ("km", 1e3), ("cm", 1e-2), ("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9), ("in", INCH), ("inch", INCH), ("mil", 1e-3 * INCH), ("thou", 1e-3 * INCH)]),
    (Angle, "an angle", "40 deg", &[("rad", 1.0), ("mrad", 1e-3), ("deg", PI / 180.0)]),
    (Pressure, "a pressure", "0.98 bar", &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9), ("mbar", 1e-3 * BAR), ("bar", BAR), ("atm", ATMOSPHERE), ("psi", PSI), ("ksi", 1e3 * PSI), ("at", TECHNICAL_ATMOSPHERE), ("kgf/cm2", TECHNICAL_ATMOSPHERE), ("N/m2", 1.0), ("N/mm2", 1e6)]),
    (Viscosity, "a dynamic viscosity", "40 mPa.s", &[("Pa.s", 1.0), ("mPa.s", 1e-3), ("uPa.s", 1e-6), ("P", 0.1), ("cP", 1e-3), ("N.s/m2", 1.0), ("kg/m/s", 1.0), ("reyn", PSI)]),
    (Speed, "an angular speed", "3000 rpm", &[("rad/s", 1.0), ("rpm", PI / 30.0), ("RPM", PI / 30.0), ("1/min", PI / 30.0), ("U/min", PI / 30.0), ("Hz", 2.0 * PI), ("rps", 2.0 * PI), ("deg/s", PI / 180.0)]),
    (InversePressure, "an inverse pressure", "2.5e-8 1/Pa", &[("1/Pa", 1.0), ("1/kPa", 1e-3), ("1/MPa", 1e-6), ("1/GPa", 1e-9), ("1/bar", 1.0 / BAR), ("1/psi", 1.0 / PSI), ("m2/N", 1.0), ("mm2/N", 1e-6)]),
    (Force, "a force", "5 kN", &[("N", 1.0), ("mN", 1e-3), ("kN", 1e3), ("MN", 1e6), ("lbf", POUND_FORCE), ("kgf", GRAVITY), ("kp", GRAVITY), ("daN", 10.0)]),
    (Velocity, "a velocity", "2 m/s", &[("m/s", 1.0), ("cm/s", 1e-2), ("mm/s", 1e-3), ("um/s", 1e-6), ("km/h", 1.0 / 3.6), ("in/s", INCH)]),
    (Mass, "a mass", "0.7 kg", &[("kg", 1.0), ("g", 1e-3), ("t", 1e3), ("lb", POUND)]),
    (Area, "an area", "58 mm2", &[("m2", 1.0), ("cm2", 1e-4), ("mm2", 1e-6), ("in2", INCH * INCH)]),
    (Ratio, "a ratio", "0.1 %", &[("%", 1e-2), ("ppm", 1e-6)]),
    (Temperature, "a temperature", "80 C", &[("C", 1.0), ("degC", 1.0), ("K", 1.0), ("F", 5.0 / 9.0), ("degF", 5.0 / 9.0)]),
    (TemperatureDifference, "a temperature difference", "1000 K", &[("K", 1.0)]),
    (InverseTemperature, "an inverse temperature", "68.8e-5 1/K", &[("1/K", 1.0)]),
    (KinematicViscosity, "a kinematic viscosity", "95 mm2/s", &[("m2/s", 1.0), ("cm2/s", 1e-4), ("mm2/s", 1e-6), ("St", 1e-4), ("cSt", 1e-6)]),
    (Density, "a density", "870 kg/m3", &[("kg/m3", 1.0), ("kg/l", 1e3), ("g/cm3", 1e3), ("g/ml", 1e3)]),
    (HeatCapacity, "a heat capacity per volume", "1.8 MJ/(m3.K)", &[("J/(m3.K)", 1.0), ("kJ/(m3.K)", 1e3), ("MJ/(m3.K)", 1e6), ("J/m3/K", 1.0), ("kJ/m3/K", 1e3), ("MJ/m3/K", 1e6)]),
    (Conductance, "a heat conductance", "5 W/K", &[("W/K", 1.0), ("kW/K", 1e3)]),
    (HeatTransfer, "a heat transfer coefficient", "17 W/(m2.K)", &[("W/(m2.K)", 1.0), ("W/m2/K", 1.0)]),
    (ThermalConductivity, "a heat conductivity", "0.13 W/(m.K)", &[("W/(m.K)", 1.0), ("W/m/K", 1.0), ("mW/(m.K)", 1e-3)]),
    (VolumeFlow, "a volume flow", "5 ml/s", &[("m3/s", 1.0), ("l/s", 1e-3), ("l/min", 1e-3 / 60.0), ("ml/s", 1e-6), ("ml/min", 1e-6 / 60.0), ("cm3/s", 1e-6), ("mm3/s", 1e-9)]),
    (Torque, "a torque", "0.5 N.m", &[("N.m", 1.0), ("mN.m", 1e-3), ("kN.m", 1e3), ("N.mm", 1e-3), ("N.cm", 1e-2)]),
    (Power, "a power", "120 W", &[("W", 1.0), ("mW", 1e-3), ("kW", 1e3), ("PS", 735.498_75)]),
    (RotationalStiffness, "a rotational stiffness", "20 kN.m/rad", &[("N.m/rad", 1.0), ("kN.m/rad", 1e3), ("MN.m/rad", 1e6), ("N.m/mrad", 1e3)]),
    (Stiffness, "a stiffness", "200 MN/m", &[("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6), ("N/mm", 1e3), ("kN/mm", 1e6), ("N/um", 1e6)]),
    (CrossStiffness, "a stiffness between offset and slope", "5 MN/rad", &[("N/rad", 1.0), ("kN/rad", 1e3), ("MN/rad", 1e6), ("N/mrad", 1e3)]),
    (Damping, "a damping", "500 kN.s/m", &[("N.s/m", 1.0), ("kN.s/m", 1e3), ("MN.s/m", 1e6), ("N.s/mm", 1e3)]),
    (CrossDamping, "a damping between offset and slope", "20 kN.s/rad", &[("N.s/rad", 1.0), ("kN.s/rad", 1e3), ("MN.s/rad", 1e6)]),
    (RotationalDamping, "a rotational damping", "2 kN.m.s/rad", &[("N.m.s/rad", 1.0), ("kN.m.s/rad", 1e3)]),
    (LayerCompliance, "a deflection by pressure", "0.02 um/MPa", &[("m/Pa", 1.0), ("mm/MPa", 1e-9), ("um/MPa", 1e-12), ("nm/MPa", 1e-15), ("um/bar", 1e-11), ("mm/GPa", 1e-12), ("m3/N", 1.0), ("mm3/N", 1e-9)]),
    (PointCompliance, "a displacement by force", "2 nm/N", &[("m/N", 1.0), ("mm/N", 1e-3), ("um/N", 1e-6), ("nm/N", 1e-9), ("mm/kN", 1e-6), ("um/kN", 1e-9)]),
];

impl Dimension {
    /// All kinds.
    pub fn all() -> impl Iterator<Item = Self> {
        TABLE.into_iter().map(|row| row.0)
    }

    fn row(self) -> &'static DimensionRow {
        &TABLE[self as usize]
    }

    /// The kind in words, with its article: `a length`.
    pub fn name(self) -> &'static str {
        self.row().1
    }

    /// A quantity of this kind as one would write it in a scene.
    pub fn example(self) -> &'static str {
        self.row().2
    }

    /// The units of this kind: their name and their size in SI.
    pub fn units(self) -> &'static [(&'static str, f64)] {
        self.row().3
    }

    /// The least and the greatest size in SI of a quantity of this kind that is not zero: their products, quotients and
    /// cubes are numbers.
    pub fn range(self) -> [f64; 2] {
        let (number, unit) = self.example().split_once(' ').unwrap_or((self.example(), ""));
        let size = self.units().iter().find(|(name, _)| *name == unit).map_or(1.0, |(_, size)| *size);
        let usual = number.parse::<f64>().map_or(size, |number| number * size);
        [LEAST * usual, MOST * usual]
    }

    /// Whether a value in SI lies within the range of this kind.
    pub fn holds(self, value: f64) -> bool {
        let [least, most] = self.range();
        value == 0.0 || (least..=most).contains(&value.abs())
    }

    /// What zero of a unit of this kind is in SI: not zero for temperatures alone.
    pub fn zero(self, unit: &str) -> f64 {
        match (self, unit) {
            (Self::Temperature, "C" | "degC") => ZERO_CELSIUS,
            (Self::Temperature, "F" | "degF") => ZERO_CELSIUS - 32.0 * 5.0 / 9.0,
            _ => 0.0,
        }
    }

    /// The units of this kind in one line: `m, cm, mm, um`.
    pub fn unit_names(self) -> String {
        let names: Vec<_> = self.units().iter().map(|(name, _)| *name).collect();
        names.join(", ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_has_its_row() {
        assert!(TABLE.iter().all(|row| row.0.row() == row));
    }
}
