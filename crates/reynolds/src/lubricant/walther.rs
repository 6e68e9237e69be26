//! # Walther (Ubbelohde): a straight line on the chart of ASTM D341
//!
//! **Equation.** `lg lg(nu + 0.7) = A - B lg T`, nu in mm2/s, T in K; A and B from two points.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | nu | m2/s | `kinematic_viscosity` |
//! | T | K | `temperature` |
//! | A, B | - | `intercept`, `slope` |
//!
//! **Source.** Walther, Erdoel und Teer 7 (1931) 382; Ubbelohde, Zur Viskosimetrie (1935); ASTM D341, without its terms
//! for nu < 2 mm2/s.
//! **Range.** nu from 2 mm2/s up, the oil a liquid: above its pour point and below some 200 degrees C. It needs nu >
//! 0.3 mm2/s.
//! **Verified by** `the_line_runs_through_its_points` and `a_viscosity_between_is_that_of_the_chart` below.

/// A line on the chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Walther {
    intercept: f64,
    slope: f64,
}

/// Viscosities [m2/s] at and below this are not on the chart.
pub const LEAST_ON_CHART: f64 = 0.3e-6;

/// `lg lg(nu + 0.7)`; not a number at and below [`LEAST_ON_CHART`].
fn ordinate(kinematic_viscosity: f64) -> f64 {
    (kinematic_viscosity * 1e6 + 0.7).log10().log10()
}

impl Walther {
    /// The law through two points `(T [K], nu [m2/s])`; none where they do not make a line on which viscosity falls
    /// with temperature.
    pub fn through(one: (f64, f64), other: (f64, f64)) -> Option<Self> {
        let slope = (ordinate(one.1) - ordinate(other.1)) / (other.0.log10() - one.0.log10());
        let line = Self { intercept: ordinate(one.1) + slope * one.0.log10(), slope };
        (line.slope.is_finite() && line.intercept.is_finite() && line.slope >= 0.0).then_some(line)
    }

    /// Kinematic viscosity nu [m2/s] at the temperature T [K].
    pub fn kinematic_viscosity(self, temperature: f64) -> f64 {
        let ordinate = self.intercept - self.slope * temperature.log10();
        1e-6 * (10f64.powf(10f64.powf(ordinate)) - 0.7)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_runs_through_its_points() {
        for points in [[(313.15, 55e-6), (373.15, 8.19e-6)], [(373.15, 37e-6), (313.15, 680e-6)]] {
            let line = Walther::through(points[0], points[1]).expect("a line");
            for (temperature, viscosity) in points {
                assert!((line.kinematic_viscosity(temperature) / viscosity - 1.0).abs() < 1e-12);
            }
        }
        let flat = Walther::through((313.15, 1e-5), (373.15, 1e-5)).expect("a line");
        assert!((flat.kinematic_viscosity(600.0) / 1e-5 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn points_that_make_no_line_are_refused() {
        let at = |t, nu| (t, nu);
        for (one, other) in [
            (at(313.15, 8e-6), at(373.15, 55e-6)),
            (at(313.15, 55e-6), at(313.15, 8e-6)),
            (at(313.15, 55e-6), at(373.15, LEAST_ON_CHART)),
            (at(313.15, f64::NAN), at(373.15, 8e-6)),
        ] {
            assert_eq!(Walther::through(one, other), None, "{one:?} {other:?}");
        }
    }

    /// A calculation by hand for 55 and 8.19 mm2/s: `lg lg 55.7 = 0.242008`, `lg lg 8.89 = -0.022779`, at 70 degrees C
    /// `nu = 17.923 mm2/s`.
    #[test]
    fn a_viscosity_between_is_that_of_the_chart() {
        let line = Walther::through((313.15, 55e-6), (373.15, 8.19e-6)).expect("a line");
        assert!((line.kinematic_viscosity(343.15) * 1e6 - 17.923).abs() < 1e-3);
    }
}
