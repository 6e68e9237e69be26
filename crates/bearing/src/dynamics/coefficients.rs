//! Stiffness and damping of a film at one frequency, and how they look in other frames and units.

use crate::deflection::{Follower, MotionResponse, harmonic_response};
use oilwedge_fem::Error;
use oilwedge_reynolds::quantities::load::{Resultant, load_change, oil_change};
use oilwedge_reynolds::{FilmChange, FilmProblem, JournalChange, SolvedFilm, Whirl};

/// Row: W_x, W_y, m_x, m_y; column: e_x, e_y, g_x, g_y, or their rates.
pub type Square = [[f64; 4]; 4];

/// Stiffness and damping; rows and columns beyond the order are zero.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Coefficients {
    /// `K = d(W, m)/d(e, g)` [N/m, N/rad; N m/m, N m/rad].
    pub stiffness: Square,
    /// `C = d(W, m)/d(e', g')` [N s/m, N s/rad; N m s/m, N m s/rad].
    pub damping: Square,
    /// 2, or 4 where the journal may tilt.
    pub order: usize,
}

impl Coefficients {
    /// Coefficients of a solved film whose journal moves at a frequency [rad/s]; zero: in the limit of slow motions.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn of(film: &SolvedFilm, frequency: f64) -> Result<Self, Error> {
        let whirl = Whirl::new(film, frequency)?;
        let follower = Follower::of(film)?;
        let mut coefficients = Self { order: Self::order_of(&film.problem), ..Self::default() };
        for column in 0..coefficients.order {
            let (offset, tilt) = motion(column);
            let place = JournalChange { offset, tilt, ..JournalChange::default() };
            let response = whirl.response(offset, tilt)?;
            let [by_place, by_rate] = match &follower {
                None => of_film(film, &place, response),
                Some(follower) => {
                    let parts = (&whirl, follower);
                    let pace = film.problem.journal.speed.abs();
                    let MotionResponse { unknown, deflection } =
                        harmonic_response(parts, &place, response, frequency, pace)?;
                    let [placed, moving] = deflection.each_ref().map(|shape| FilmChange::Gap(shape));
                    let place = [(&place).into(), placed];
                    [load_change(film, &place, &unknown[0]), load_change(film, &[moving], &unknown[1])]
                }
            };
            let [by_place, by_rate] = [forces(by_place), forces(by_rate)];
            for row in 0..coefficients.order {
                coefficients.stiffness[row][column] = by_place[row];
                coefficients.damping[row][column] = by_rate[row];
            }
        }
        Ok(coefficients)
    }

    /// How many rows and columns there are of a film.
    pub(super) fn order_of(problem: &FilmProblem) -> usize {
        if problem.can_tilt() { 4 } else { 2 }
    }

    fn each(&self, of: impl Fn(&Square) -> Square) -> Self {
        Self { stiffness: of(&self.stiffness), damping: of(&self.damping), order: self.order }
    }

    /// Times a factor.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        self.each(|of| of.map(|row| row.map(|entry| factor * entry)))
    }

    /// With another one added.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let sum = |a: &Square, b: &Square| [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| a[i][j] + b[i][j]));
        Self {
            stiffness: sum(&self.stiffness, &other.stiffness),
            damping: sum(&self.damping, &other.damping),
            order: self.order,
        }
    }

    /// In the frame whose first axis has this direction [rad], and whose second one is 90 degrees on in the sense of
    /// `speed`.
    pub fn in_frame(&self, direction: f64, speed: f64) -> Self {
        let sense = if speed < 0.0 { -1.0 } else { 1.0 };
        let (sin, cos) = direction.sin_cos();
        let turn = [[cos, sin], [-sense * sin, sense * cos]];
        self.each(|of| {
            let mut turned = [[0.0; 4]; 4];
            for (i, row) in turned.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    let parts = (0..4).map(|part| (part / 2, part % 2));
                    *entry =
                        parts.map(|(a, b)| turn[i % 2][a] * of[i - i % 2 + a][j - j % 2 + b] * turn[j % 2][b]).sum();
                }
            }
            turned
        })
    }

    /// Without dimension: `K c/W` and `C c omega/W`, slopes and moments with the arm l, half of the bearing's length.
    /// `None` without a load or at rest.
    pub fn without_dimension(&self, load: f64, clearance: f64, speed: f64, arm: f64) -> Option<Self> {
        let is_defined = load > 0.0 && speed != 0.0;
        let arm = |place: usize| if place < 2 { 1.0 } else { arm };
        let scaled = |of: &Square, unit: f64| {
            let mut scaled = *of;
            for (i, row) in scaled.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    *entry *= unit / (arm(i) * arm(j));
                }
            }
            scaled
        };
        is_defined.then(|| Self {
            stiffness: scaled(&self.stiffness, clearance / load),
            damping: scaled(&self.damping, clearance * speed.abs() / load),
            order: self.order,
        })
    }

    /// The part of forces and offsets of a matrix.
    pub(super) fn forces(of: &Square) -> [[f64; 2]; 2] {
        [[of[0][0], of[0][1]], [of[1][0], of[1][1]]]
    }
}

/// Offset and slope of a motion by one of the coordinates.
pub(super) fn motion(column: usize) -> ([f64; 2], [f64; 2]) {
    let along = |k: usize| f64::from(u8::from(k == column));
    ([along(0), along(1)], [along(2), along(3)])
}

/// What the journal carries more in a rigid wall with a motion as `place` and as rate: contact answers to the place of
/// the journal, not to its rate.
fn of_film(film: &SolvedFilm, place: &JournalChange, [by_place, by_rate]: [Vec<f64>; 2]) -> [Resultant; 2] {
    [load_change(film, &[place.into()], &by_place), oil_change(film, &by_rate)]
}

/// Forces and moments in the order of the rows.
fn forces(change: Resultant) -> [f64; 4] {
    let ([x, y], [z_x, z_y]) = (change.force, change.moment);
    [x, y, z_x, z_y]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Coefficients {
        let of = |seed: f64| {
            let entry = |i: usize, j: usize| (seed + 3.1 * i as f64 + 7.3 * j as f64).sin();
            [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| entry(i, j)))
        };
        Coefficients { stiffness: of(0.4), damping: of(1.9), order: 4 }
    }

    /// The work of a motion is that in any frame.
    #[test]
    fn a_frame_changes_no_work() {
        let (angle, motion) = (0.7f64, [0.3, -1.2, 0.8, 0.5]);
        let of = sample();
        for speed in [5.0, -5.0] {
            let sense = speed / 5.0;
            let turned = |[x, y]: [f64; 2]| {
                let (sin, cos) = angle.sin_cos();
                [cos * x + sin * y, sense * (cos * y - sin * x)]
            };
            let ([a, b], [c, d]) = (turned([motion[0], motion[1]]), turned([motion[2], motion[3]]));
            let work = |of: &Square, by: [f64; 4]| -> f64 {
                (0..4).map(|i| by[i] * (0..4).map(|j| of[i][j] * by[j]).sum::<f64>()).sum()
            };
            let there = of.in_frame(angle, speed);
            for (here, there) in [(of.stiffness, there.stiffness), (of.damping, there.damping)] {
                assert!((work(&here, motion) - work(&there, [a, b, c, d])).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn numbers_without_dimension_need_a_load_and_a_speed() {
        let of = sample();
        let scaled = of.without_dimension(2.0, 0.1, -5.0, 0.25).expect("numbers");
        assert!((scaled.stiffness[0][1] - 0.05 * of.stiffness[0][1]).abs() < 1e-16);
        assert!((scaled.damping[3][2] - 4.0 * of.damping[3][2]).abs() < 1e-14);
        assert_eq!(of.without_dimension(0.0, 0.1, 5.0, 0.25), None);
        assert_eq!(of.without_dimension(2.0, 0.1, 0.0, 0.25), None);
    }
}
