//! # Oil at a temperature: its viscosity by one law, its density by another
//!
//! **Equation.** `mu(T)` by [`Vogel`] or [`ExponentialLaw`], or `nu(T)` by [`Walther`], by several such lines between
//! the points of a table; `mu = rho nu`. At each temperature viscosity may grow with pressure by a
//! [`super::PressureLaw`], whose coefficients do not depend on temperature here.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | mu | Pa s | `viscosity` |
//! | nu | m2/s | `kinematic_viscosity` |
//! | rho | kg/m3 | `density` |
//! | T | K | `temperature` |
//!
//! **Source.** As of the laws. **Range.** As of the laws; beyond the ends of a table its last line goes on.
//! **Verified by** `a_table_of_two_points_is_a_line` and `tables_are_monotone` below.

use super::{Density, ExponentialLaw, Vogel, Walther};

/// How viscosity falls with temperature.
#[derive(Debug, Clone, PartialEq)]
pub enum TemperatureLaw {
    /// Three constants for the dynamic viscosity.
    Vogel(Vogel),
    /// One constant for the fall of the dynamic viscosity.
    Exponential(ExponentialLaw),
    /// A line on the chart of ASTM D341 for the kinematic one.
    Walther(Walther),
    /// Lines between points.
    Table(ViscosityTable),
}

/// An oil by temperature.
#[derive(Debug, Clone, PartialEq)]
pub struct ThermalOil {
    /// How viscosity falls with temperature.
    pub law: TemperatureLaw,
    /// Density of the oil.
    pub density: Density,
    /// What the shear rate of the film leaves of the viscosity [1], the same at all temperatures; 1 at low shear.
    pub sheared: f64,
}

impl ThermalOil {
    /// Dynamic viscosity mu [Pa s] at the temperature T [K]; not a number where the law has no meaning.
    pub fn viscosity(&self, temperature: f64) -> f64 {
        self.sheared * self.unsheared(temperature)
    }

    /// Dynamic viscosity [Pa s] at low shear.
    pub fn unsheared(&self, temperature: f64) -> f64 {
        match &self.law {
            TemperatureLaw::Vogel(law) => law.viscosity(temperature),
            TemperatureLaw::Exponential(law) => law.viscosity(temperature),
            TemperatureLaw::Walther(law) => law.kinematic_viscosity(temperature) * self.density.at(temperature),
            TemperatureLaw::Table(table) => table.kinematic_viscosity(temperature) * self.density.at(temperature),
        }
    }

    /// Kinematic viscosity nu [m2/s] at the temperature T [K].
    pub fn kinematic_viscosity(&self, temperature: f64) -> f64 {
        self.viscosity(temperature) / self.density.at(temperature)
    }
}

/// Kinematic viscosity by points, on the chart of ASTM D341 straight from one to the next: as monotone as they are.
#[derive(Debug, Clone, PartialEq)]
pub struct ViscosityTable {
    /// Temperatures [K], ascending.
    temperatures: Vec<f64>,
    /// Lines between them.
    lines: Vec<Walther>,
}

impl ViscosityTable {
    /// The law through points `(T [K], nu [m2/s])` in any order; none where they are fewer than two, or where between
    /// two of them viscosity does not fall with temperature.
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        let mut points = points.to_vec();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let lines: Option<Vec<Walther>> = points.windows(2).map(|pair| Walther::through(pair[0], pair[1])).collect();
        let lines = lines.filter(|lines| !lines.is_empty())?;
        Some(Self { temperatures: points.into_iter().map(|(temperature, _)| temperature).collect(), lines })
    }

    /// Kinematic viscosity nu [m2/s] at the temperature T [K].
    pub fn kinematic_viscosity(&self, temperature: f64) -> f64 {
        let behind = self.temperatures.partition_point(|&point| point <= temperature);
        self.lines[behind.saturating_sub(1).min(self.lines.len() - 1)].kinematic_viscosity(temperature)
    }

    /// The temperatures [K] of its first and last point.
    pub fn range(&self) -> [f64; 2] {
        [self.temperatures[0], self.temperatures[self.temperatures.len() - 1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: [(f64, f64); 4] = [(373.15, 11e-6), (313.15, 66e-6), (293.15, 170e-6), (423.15, 4.4e-6)];

    #[test]
    fn a_table_of_two_points_is_a_line() {
        let table = ViscosityTable::through(&POINTS[..2]).expect("a table");
        let line = Walther::through(POINTS[0], POINTS[1]).expect("a line");
        for temperature in [250.0, 313.15, 350.0, 373.15, 450.0] {
            let (by_table, by_line) = (table.kinematic_viscosity(temperature), line.kinematic_viscosity(temperature));
            assert!((by_table / by_line - 1.0).abs() < 1e-12);
        }
        let oil = ThermalOil { law: TemperatureLaw::Table(table), density: Density::default(), sheared: 1.0 };
        let mu = oil.viscosity(313.15);
        assert!((mu / (66e-6 * 870.0 * (1.0 - 68.8e-5 * 20.0)) - 1.0).abs() < 1e-12);
        assert!((oil.kinematic_viscosity(313.15) / 66e-6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn tables_are_monotone() {
        let table = ViscosityTable::through(&POINTS).expect("a table");
        assert_eq!(table.range(), [293.15, 423.15]);
        for (temperature, viscosity) in POINTS {
            assert!((table.kinematic_viscosity(temperature) / viscosity - 1.0).abs() < 1e-12);
        }
        let at = |step: u32| table.kinematic_viscosity(270.0 + 0.5 * f64::from(step));
        assert!((0..400).all(|step| at(step + 1) < at(step)));
        let rising = [(300.0, 1e-5), (310.0, 1e-5), (320.0, 1.1e-5)];
        assert_eq!(ViscosityTable::through(&rising), None);
        assert!(ViscosityTable::through(&rising[..2]).is_some());
        assert_eq!(ViscosityTable::through(&POINTS[..1]), None);
        assert_eq!(ViscosityTable::through(&[POINTS[0], POINTS[0]]), None);
    }
}
