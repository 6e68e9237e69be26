//! The kinds of quantities that a scene holds, and the units of each.

use std::f64::consts::PI;

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;

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
}

/// All kinds.
pub(crate) const ALL: [Dimension; 19] = [
    Dimension::Length,
    Dimension::Angle,
    Dimension::Pressure,
    Dimension::Viscosity,
    Dimension::Speed,
    Dimension::InversePressure,
    Dimension::Force,
    Dimension::Velocity,
    Dimension::Mass,
    Dimension::Area,
    Dimension::Ratio,
    Dimension::Temperature,
    Dimension::TemperatureDifference,
    Dimension::InverseTemperature,
    Dimension::KinematicViscosity,
    Dimension::Density,
    Dimension::HeatCapacity,
    Dimension::Conductance,
    Dimension::HeatTransfer,
];

const BAR: f64 = 1e5;
const ATMOSPHERE: f64 = 101_325.0;
const INCH: f64 = 0.0254;
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

impl Dimension {
    /// The kind in words, with its article: `a length`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Length => "a length",
            Self::Angle => "an angle",
            Self::Pressure => "a pressure",
            Self::Viscosity => "a dynamic viscosity",
            Self::Speed => "an angular speed",
            Self::InversePressure => "an inverse pressure",
            Self::Force => "a force",
            Self::Velocity => "a velocity",
            Self::Mass => "a mass",
            Self::Area => "an area",
            Self::Ratio => "a ratio",
            Self::Temperature => "a temperature",
            Self::TemperatureDifference => "a temperature difference",
            Self::InverseTemperature => "an inverse temperature",
            Self::KinematicViscosity => "a kinematic viscosity",
            Self::Density => "a density",
            Self::HeatCapacity => "a heat capacity per volume",
            Self::Conductance => "a heat conductance",
            Self::HeatTransfer => "a heat transfer coefficient",
        }
    }

    /// A quantity of this kind as one would write it in a scene.
    pub fn example(self) -> &'static str {
        match self {
            Self::Length => "25 mm",
            Self::Angle => "40 deg",
            Self::Pressure => "0.98 bar",
            Self::Viscosity => "40 mPa.s",
            Self::Speed => "3000 rpm",
            Self::InversePressure => "2.5e-8 1/Pa",
            Self::Force => "5 kN",
            Self::Velocity => "2 m/s",
            Self::Mass => "0.7 kg",
            Self::Area => "58 mm2",
            Self::Ratio => "0.1 %",
            Self::Temperature => "80 C",
            Self::TemperatureDifference => "1000 K",
            Self::InverseTemperature => "68.8e-5 1/K",
            Self::KinematicViscosity => "95 mm2/s",
            Self::Density => "870 kg/m3",
            Self::HeatCapacity => "1.8 MJ/(m3.K)",
            Self::Conductance => "5 W/K",
            Self::HeatTransfer => "17 W/(m2.K)",
        }
    }

    /// The units of this kind: their name and their size in SI.
    pub fn units(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::Length => &[
                ("m", 1.0),
                ("km", 1e3),
                ("cm", 1e-2),
                ("mm", 1e-3),
                ("um", 1e-6),
                ("nm", 1e-9),
                ("in", INCH),
                ("inch", INCH),
                ("mil", 1e-3 * INCH),
            ],
            Self::Angle => &[("rad", 1.0), ("mrad", 1e-3), ("deg", PI / 180.0)],
            Self::Pressure => &[
                ("Pa", 1.0),
                ("kPa", 1e3),
                ("MPa", 1e6),
                ("GPa", 1e9),
                ("mbar", 1e-3 * BAR),
                ("bar", BAR),
                ("atm", ATMOSPHERE),
                ("psi", PSI),
                ("N/m2", 1.0),
                ("N/mm2", 1e6),
            ],
            Self::Viscosity => &[
                ("Pa.s", 1.0),
                ("mPa.s", 1e-3),
                ("uPa.s", 1e-6),
                ("P", 0.1),
                ("cP", 1e-3),
                ("N.s/m2", 1.0),
                ("kg/m/s", 1.0),
                ("reyn", PSI),
            ],
            Self::Speed => &[
                ("rad/s", 1.0),
                ("1/s", 1.0),
                ("rpm", PI / 30.0),
                ("Hz", 2.0 * PI),
                ("deg/s", PI / 180.0),
            ],
            Self::InversePressure => &[
                ("1/Pa", 1.0),
                ("1/kPa", 1e-3),
                ("1/MPa", 1e-6),
                ("1/GPa", 1e-9),
                ("1/bar", 1.0 / BAR),
                ("1/psi", 1.0 / PSI),
                ("m2/N", 1.0),
                ("mm2/N", 1e-6),
            ],
            Self::Force => &[
                ("N", 1.0),
                ("mN", 1e-3),
                ("kN", 1e3),
                ("MN", 1e6),
                ("lbf", POUND_FORCE),
                ("kgf", 9.806_65),
            ],
            Self::Velocity => &[
                ("m/s", 1.0),
                ("cm/s", 1e-2),
                ("mm/s", 1e-3),
                ("um/s", 1e-6),
                ("km/h", 1.0 / 3.6),
                ("in/s", INCH),
            ],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3), ("t", 1e3), ("lb", POUND)],
            Self::Area => &[("m2", 1.0), ("cm2", 1e-4), ("mm2", 1e-6), ("in2", INCH * INCH)],
            Self::Ratio => &[("%", 1e-2), ("ppm", 1e-6)],
            Self::Temperature => &[
                ("C", 1.0),
                ("degC", 1.0),
                ("K", 1.0),
                ("F", 5.0 / 9.0),
                ("degF", 5.0 / 9.0),
            ],
            Self::TemperatureDifference => &[("K", 1.0)],
            Self::InverseTemperature => &[("1/K", 1.0)],
            Self::KinematicViscosity => &[
                ("m2/s", 1.0),
                ("cm2/s", 1e-4),
                ("mm2/s", 1e-6),
                ("St", 1e-4),
                ("cSt", 1e-6),
            ],
            Self::Density => &[("kg/m3", 1.0), ("kg/l", 1e3), ("g/cm3", 1e3), ("g/ml", 1e3)],
            Self::HeatCapacity => &[
                ("J/(m3.K)", 1.0),
                ("kJ/(m3.K)", 1e3),
                ("MJ/(m3.K)", 1e6),
                ("J/m3/K", 1.0),
                ("kJ/m3/K", 1e3),
                ("MJ/m3/K", 1e6),
            ],
            Self::Conductance => &[("W/K", 1.0), ("kW/K", 1e3)],
            Self::HeatTransfer => &[("W/(m2.K)", 1.0), ("W/m2/K", 1.0)],
        }
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
        self.units()
            .iter()
            .map(|(name, _)| *name)
            .collect::<Vec<_>>()
            .join(", ")
    }
}
