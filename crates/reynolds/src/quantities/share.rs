//! # Shares of force and moment
//!
//! **Equation.** Of a density p over a part of the developed surface `Int p (cos phi, sin phi) dA`,
//! `Int p z (cos phi, sin phi) dA` and `Int p dA`; the film, the regions cut out of it and contact each have such a
//! share, and the journal carries their sum.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Int p n dA | N | `force` |
//! | Int p z n dA | N m | `moment` |
//! | Int p dA | N | `pressure` |
//!
//! **Source.** Definition. **Range.** Any density. **Verified by** `disc_and_rim_agree` and
//! `tests/tests/tilt/moment.rs`.

/// Integrals over a part of the developed surface.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Share {
    /// `Int (p - p_e) (cos phi, sin phi) dA` [N].
    pub force: [f64; 2],
    /// `Int (p - p_e) z (cos phi, sin phi) dA` [N m].
    pub moment: [f64; 2],
    /// `Int p dA` [N].
    pub pressure: f64,
    /// `Int |p - p_e| dA` [N]: what these pressures could carry, all on one side.
    pub possible: f64,
}

/// Force and moment about mid-length, or their changes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Resultant {
    /// Force towards x and y [N].
    pub force: [f64; 2],
    /// Force towards x and y times its arm along the axis [N m].
    pub moment: [f64; 2],
}

impl Resultant {
    /// Magnitudes [N] of the two forces at `z = -half` and `z = half` [m] that stand for it, in all: no less than that
    /// of its force, and more where these are against each other.
    pub fn at_ends(&self, half: f64) -> f64 {
        let size = |sign: f64| {
            let [x, y] = [0, 1].map(|d| 0.5 * (self.force[d] + sign * self.moment[d] / half));
            x.hypot(y)
        };
        size(-1.0) + size(1.0)
    }
}

impl std::ops::AddAssign for Resultant {
    fn add_assign(&mut self, other: Self) {
        for d in 0..2 {
            self.force[d] += other.force[d];
            self.moment[d] += other.moment[d];
        }
    }
}

impl Share {
    /// The share less another one.
    pub fn less(&self, other: &Self) -> Self {
        let difference = |a: [f64; 2], b: [f64; 2]| [a[0] - b[0], a[1] - b[1]];
        Self {
            force: difference(self.force, other.force),
            moment: difference(self.moment, other.moment),
            pressure: self.pressure - other.pressure,
            possible: self.possible - other.possible,
        }
    }

    /// Force and moment of the share.
    pub fn resultant(&self) -> Resultant {
        Resultant { force: self.force, moment: self.moment }
    }
}

impl std::ops::AddAssign for Share {
    fn add_assign(&mut self, other: Self) {
        for d in 0..2 {
            self.force[d] += other.force[d];
            self.moment[d] += other.moment[d];
        }
        self.pressure += other.pressure;
        self.possible += other.possible;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_at_the_ends_stand_for_force_and_moment() {
        let of = |force, moment| Resultant { force, moment }.at_ends(0.5);
        assert_eq!(of([3.0, 4.0], [0.0; 2]), 5.0);
        // Between the ends the force is all that there is; beyond them the two are against each other.
        assert_eq!(of([2.0, 0.0], [1.0, 0.0]), 2.0);
        assert_eq!(of([2.0, 0.0], [2.0, 0.0]), 4.0);
        assert_eq!(of([0.0; 2], [0.0, 3.0]), 6.0);
    }
}
