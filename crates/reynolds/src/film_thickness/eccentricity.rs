//! # Clearance of a circular journal in a circular bore
//!
//! **Equation.** `h = c - e_x cos phi - e_y sin phi`, `dh/dx = (e_x sin phi - e_y cos phi) / R`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | c | m | `clearance` |
//! | e_x, e_y | m | `offset` |
//! | phi = x / R | rad | `x / radius` |
//!
//! **Source.** Hamrock, Schmid, Jacobson, Fundamentals of Fluid Film Lubrication (2004), ch. 10.
//! **Range.** |e| < c << R. **Verified by** `slope_is_the_derivative` and every bearing solved.

use super::FilmContribution;
use crate::FilmPoint;

/// Radial clearance less the journal's offset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eccentricity {
    /// Radius R [m].
    pub radius: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// Offset `(e_x, e_y)` of the journal [m].
    pub offset: [f64; 2],
}

impl FilmContribution for Eccentricity {
    fn add(&self, _cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        let [e_x, e_y] = self.offset;
        for (&[x, _], point) in positions.iter().zip(film) {
            let (sin, cos) = (x / self.radius).sin_cos();
            point.thickness += self.clearance - e_x * cos - e_y * sin;
            point.slope += (e_x * sin - e_y * cos) / self.radius;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slope_is_the_derivative() {
        let film = Eccentricity {
            radius: 0.04,
            clearance: 4e-5,
            offset: [1e-5, -2e-5],
        };
        let at = |x: f64| {
            let mut point = [FilmPoint::default()];
            film.add(0, &[[x, 0.0]], &mut point);
            point[0]
        };
        for x in [0.0, 0.02, 0.07] {
            let difference = (at(x + 1e-6).thickness - at(x - 1e-6).thickness) / 2e-6;
            assert!((at(x).slope - difference).abs() < 1e-12);
        }
    }

    #[test]
    fn minimum_film_lies_at_the_offset() {
        let film = Eccentricity {
            radius: 1.0,
            clearance: 1e-3,
            offset: [0.0, 6e-4],
        };
        let mut point = [FilmPoint::default()];
        film.add(0, &[[std::f64::consts::FRAC_PI_2, 0.0]], &mut point);
        assert!((point[0].thickness - 4e-4).abs() < 1e-18);
    }
}
