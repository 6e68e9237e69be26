//! Units of reported numbers: SI, but degrees and degrees Celsius.

use oilwedge_scene::unit::Dimension;

/// Unit of a reported number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// A number without dimension.
    One,
    /// Unit of forces.
    Newton,
    /// Unit of angles.
    Degree,
    /// Unit of small slopes.
    Radian,
    /// Unit of pressures.
    Pascal,
    /// Unit of stresses in metal.
    PascalOfStress,
    /// Unit of lengths.
    Metre,
    /// Unit of dynamic viscosities.
    PascalSecond,
    /// Unit of temperatures.
    Celsius,
    /// Unit of volume flows.
    CubicMetrePerSecond,
    /// Unit of torques.
    NewtonMetre,
    /// Unit of powers.
    Watt,
    /// Unit of masses.
    Kilogram,
    /// Unit of forces by offsets.
    NewtonPerMetre,
    /// Unit of forces by slopes, and of moments by offsets.
    NewtonPerRadian,
    /// Unit of moments by slopes.
    NewtonMetrePerRadian,
    /// Unit of forces by velocities.
    NewtonSecondPerMetre,
    /// Unit of forces by rates of slopes, and of moments by velocities.
    NewtonSecondPerRadian,
    /// Unit of moments by rates of slopes.
    NewtonMetreSecondPerRadian,
}

impl Unit {
    /// Name of the unit as results write it.
    pub fn name(self) -> &'static str {
        self.texts()[0]
    }

    /// The unit that results write so.
    pub fn named(name: &str) -> Option<Self> {
        const ALL: [Unit; 18] = [
            Unit::One,
            Unit::Newton,
            Unit::Degree,
            Unit::Radian,
            Unit::Pascal,
            Unit::Metre,
            Unit::PascalSecond,
            Unit::Celsius,
            Unit::CubicMetrePerSecond,
            Unit::NewtonMetre,
            Unit::Watt,
            Unit::Kilogram,
            Unit::NewtonPerMetre,
            Unit::NewtonPerRadian,
            Unit::NewtonMetrePerRadian,
            Unit::NewtonSecondPerMetre,
            Unit::NewtonSecondPerRadian,
            Unit::NewtonMetreSecondPerRadian,
        ];
        ALL.into_iter().find(|unit| unit.name() == name)
    }

    /// What it measures.
    pub fn dimension(self) -> &'static str {
        self.texts()[1]
    }

    /// The kind of quantity, by which a scene names other units for it.
    pub fn scene_dimension(self) -> Dimension {
        match self {
            Self::One => Dimension::Ratio,
            Self::Newton => Dimension::Force,
            Self::Degree | Self::Radian => Dimension::Angle,
            Self::Pascal | Self::PascalOfStress => Dimension::Pressure,
            Self::Metre => Dimension::Length,
            Self::PascalSecond => Dimension::Viscosity,
            Self::Celsius => Dimension::Temperature,
            Self::CubicMetrePerSecond => Dimension::VolumeFlow,
            Self::NewtonMetre => Dimension::Torque,
            Self::Watt => Dimension::Power,
            Self::Kilogram => Dimension::Mass,
            Self::NewtonPerMetre => Dimension::Stiffness,
            Self::NewtonPerRadian => Dimension::CrossStiffness,
            Self::NewtonMetrePerRadian => Dimension::RotationalStiffness,
            Self::NewtonSecondPerMetre => Dimension::Damping,
            Self::NewtonSecondPerRadian => Dimension::CrossDamping,
            Self::NewtonMetreSecondPerRadian => Dimension::RotationalDamping,
        }
    }

    fn texts(self) -> [&'static str; 2] {
        match self {
            Self::One => ["1", "ratio"],
            Self::Newton => ["N", "force"],
            Self::Degree => ["deg", "angle"],
            Self::Radian => ["rad", "slope"],
            Self::Pascal => ["Pa", "pressure"],
            Self::PascalOfStress => ["Pa", "stress"],
            Self::Metre => ["m", "length"],
            Self::PascalSecond => ["Pa.s", "dynamic viscosity"],
            Self::Celsius => ["degC", "temperature"],
            Self::CubicMetrePerSecond => ["m3/s", "volume flow"],
            Self::NewtonMetre => ["N.m", "torque"],
            Self::Watt => ["W", "power"],
            Self::Kilogram => ["kg", "mass"],
            Self::NewtonPerMetre => ["N/m", "stiffness"],
            Self::NewtonPerRadian => ["N/rad", "stiffness between offset and slope"],
            Self::NewtonMetrePerRadian => ["N.m/rad", "rotational stiffness"],
            Self::NewtonSecondPerMetre => ["N.s/m", "damping"],
            Self::NewtonSecondPerRadian => ["N.s/rad", "damping between offset and slope"],
            Self::NewtonMetreSecondPerRadian => ["N.m.s/rad", "rotational damping"],
        }
    }
}
