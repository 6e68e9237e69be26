//! The journal of a scene: how it turns, where it is or what it carries, and how its centre moves.

use std::f64::consts::FRAC_PI_4;

/// Eccentricity ratio at which the search for the position under a load begins where nothing is known.
const START_ECCENTRICITY: f64 = 0.5;
/// Angle [rad] from the load to the thinnest film, against the rotation, at which it begins.
const START_ATTITUDE: f64 = FRAC_PI_4;

/// The journal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Journal {
    /// Angular speed omega [rad/s]; positive towards growing angles.
    pub speed: f64,
    /// Where it is.
    pub position: Position,
    /// Velocity of its centre; `None`: the centre rests.
    pub squeeze: Option<Squeeze>,
}

/// Where the journal is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Position {
    /// At a fixed position.
    Given {
        /// Eccentricity ratio eps = |e|/c, 0 <= eps < 1.
        eccentricity: f64,
        /// Angle of the thinnest film [rad]; 0 where the journal is centred and the scene gives none.
        min_film_angle: f64,
    },
    /// Where the film carries this load: the position is found.
    Load {
        /// Force F on the journal [N], not negative.
        force: f64,
        /// Direction of the force [rad], from +x towards +y.
        angle: f64,
    },
}

/// Velocity of the journal's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Squeeze {
    /// Along the line of centres [m/s]; positive: the eccentricity grows.
    pub radial: f64,
    /// Across the line of centres [m/s]; positive: towards growing angles.
    pub tangential: f64,
}

impl Squeeze {
    /// Whether the centre moves at all.
    pub fn is_moving(&self) -> bool {
        self.radial != 0.0 || self.tangential != 0.0
    }
}

impl Journal {
    /// Eccentricity ratio and angle of the thinnest film [rad] that a computation begins with where nothing else is known: those
    /// given, or for a load eps = 0.5 at 45 degrees from the load in the sense of the rotation.
    pub fn middle(&self) -> (f64, f64) {
        match self.position {
            Position::Given {
                eccentricity,
                min_film_angle,
            } => (eccentricity, min_film_angle),
            Position::Load { angle, .. } => {
                let sense = if self.speed < 0.0 { -1.0 } else { 1.0 };
                (START_ECCENTRICITY, angle + sense * START_ATTITUDE)
            }
        }
    }

    /// The force on the journal `(F cos, F sin)` [N]; `None` at a given position.
    pub fn load(&self) -> Option<[f64; 2]> {
        match self.position {
            Position::Given { .. } => None,
            Position::Load { force, angle } => Some([force * angle.cos(), force * angle.sin()]),
        }
    }

    /// The velocity of the centre, if it moves.
    pub fn motion(&self) -> Option<Squeeze> {
        self.squeeze.filter(Squeeze::is_moving)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn journal(speed: f64, position: Position) -> Journal {
        Journal {
            speed,
            position,
            squeeze: None,
        }
    }

    #[test]
    fn the_middle_is_the_position_or_lies_behind_the_load() {
        let given = Position::Given {
            eccentricity: 0.6,
            min_film_angle: 3.0,
        };
        assert_eq!(journal(10.0, given).middle(), (0.6, 3.0));
        assert_eq!(journal(10.0, given).load(), None);
        let load = Position::Load { force: 5e3, angle: 1.5 };
        for (speed, sense) in [(10.0, 1.0), (-10.0, -1.0), (0.0, 1.0), (-0.0, 1.0)] {
            assert_eq!(journal(speed, load).middle(), (0.5, 1.5 + sense * FRAC_PI_4));
        }
        let [x, y] = journal(10.0, load).load().expect("a load");
        assert!((x.hypot(y) - 5e3).abs() < 1e-9 && (y.atan2(x) - 1.5).abs() < 1e-15);
    }

    #[test]
    fn a_centre_without_velocity_does_not_move() {
        let at = |radial, tangential| {
            let squeeze = Some(Squeeze { radial, tangential });
            let position = Position::Load { force: 0.0, angle: 0.0 };
            Journal {
                squeeze,
                ..journal(1.0, position)
            }
        };
        assert_eq!((at(0.0, -0.0).motion(), at(0.0, 1e-3).motion().is_some()), (None, true));
    }
}
