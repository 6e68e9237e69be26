//! Why an orbit does not lead on.

use std::f64::consts::PI;

use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::existence::readable;

use super::motion::Motion;
use super::stage::NoStage;
use crate::GREATEST_ECCENTRICITY;
use crate::coordinates::Vector;
use crate::reason::opening;

/// A load has left the shell this part of the cycle after no step led on.
const SHORTLY: f64 = 1e-3;
/// Angle [rad] between nodes on both sides of the opening of an arc; those of a ring are nearer to each other.
const OPENING: f64 = 0.5 * PI;
/// Rounding of the ends of a half shell [rad].
const ROUNDING: f64 = 1e-9;
/// Angle to the edge of an arc [rad] within which a film that begins away from the shell has no force.
const NEAR: f64 = PI / 12.0;

/// Why there is no orbit.
#[derive(Debug, thiserror::Error)]
pub enum NoOrbit {
    /// There is no film.
    #[error("no film at {angle:.2} deg of cycle {cycle}: {reason}")]
    Film {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Why.
        reason: NoFilm,
    },
    /// No step, however short, leads on.
    #[error(
        "not converged: no step leads on from {angle:.2} deg of cycle {cycle}, where the least film is {:.3e} of the clearance",
        gap
    )]
    Stuck {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Least gap over the clearance [1].
        gap: f64,
    },
    /// No step leads on, for films that conserve their oil need pressures at which the viscosity law ends. Whether a
    /// finer mesh has a film is not known: what the film held before is known on its own mesh alone.
    #[error(
        "not converged: no step leads on from {angle:.2} deg of cycle {cycle}: the load squeezes the film until its reduced pressure is {} of that at which the viscosity law makes the pressure infinite",
        readable(*ratio)
    )]
    AtLimit {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Greatest reduced pressure over the limit of the law [1].
        ratio: f64,
    },
    /// No step leads on, for the film is squeezed out.
    #[error(
        "the load squeezes the film out: at {angle:.2} deg of cycle {cycle} its thinnest place has {gap:.1e} of the clearance, and no step leads on"
    )]
    SqueezedOut {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Least gap over the clearance [1].
        gap: f64,
    },
    /// No step leads on, for the film of a journal on a shaft is squeezed out.
    #[error(
        "the loads squeeze the film out: at {angle:.2} deg of cycle {cycle} its thinnest place has {gap:.1e} of the clearance, where the journal is {eccentricity:.3} of the clearance off the middle \
         and its slope takes {tilt:.3} at the ends, and no step leads on"
    )]
    SqueezedOutOnShaft {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Least gap over the clearance [1].
        gap: f64,
        /// Offset of the journal at mid-length over the clearance [1].
        eccentricity: f64,
        /// Slope of the journal times half of its length over the clearance [1].
        tilt: f64,
    },
    /// No step leads on, for the load of a journal without mass points out of the shell of an arc.
    #[error(
        "no film carries the load at {angle:.2} deg of cycle {cycle}: it points to {direction:.1} deg, beyond the shell"
    )]
    OffShell {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Direction of the load [deg].
        direction: f64,
    },
    /// No step leads on, and the load points to the opening of an arc, or near to its edge.
    #[error(
        "not converged: no step leads on from {angle:.2} deg of cycle {cycle}, where the load points to {direction:.1} deg, into the opening of the shell or near to its edge"
    )]
    AtOpening {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// Direction of the load [deg].
        direction: f64,
    },
    /// Between two steps there is no film on the path.
    #[error(
        "not converged: no film is found between two steps of the last cycle, at {angle:.2} deg, where the path between them leaves a gap of {gap:.1e} of the clearance"
    )]
    Between {
        /// Crank angle [deg].
        angle: f64,
        /// Least gap over the clearance [1]; not positive where the path, a cubic, runs into the wall.
        gap: f64,
    },
    /// The time was over before the first cycle was complete.
    #[error("not converged: the orbit was ended at {angle:.1} deg of the first cycle")]
    Ended {
        /// Crank angle [deg].
        angle: f64,
    },
}

/// Why journals that move at the same time have no orbits, and the bearing, by its number from 0, that is meant.
#[derive(Debug, thiserror::Error)]
#[error("{reason}")]
pub struct NoOrbitAt {
    /// The bearing.
    pub bearing: usize,
    /// Why.
    pub reason: NoOrbit,
}

impl NoOrbit {
    /// True if there may be an orbit that was not found.
    pub fn is_unreached(&self) -> bool {
        match self {
            Self::Film { reason, .. } => reason.is_unreached(),
            Self::Stuck { .. }
            | Self::AtLimit { .. }
            | Self::AtOpening { .. }
            | Self::Between { .. }
            | Self::Ended { .. } => true,
            Self::SqueezedOut { .. } | Self::SqueezedOutOnShaft { .. } | Self::OffShell { .. } => false,
        }
    }
}

impl Motion<'_> {
    /// What a stage without a solution means for the orbit, from a film with this least gap [m] on; a journal on a
    /// shaft has come to a place [m].
    pub(super) fn told(
        &self,
        reason: NoStage,
        (time, angle): (f64, f64),
        cycle: usize,
        (gap, on_shaft): (f64, Option<Vector>),
    ) -> NoOrbit {
        match reason {
            NoStage::Film(_, NoFilm::AboveLimit { ratio, .. }) if self.problem.cavitation.conserves_oil() => {
                NoOrbit::AtLimit { angle, cycle, ratio }
            }
            NoStage::Film(_, reason) => NoOrbit::Film { angle, cycle, reason },
            NoStage::Diverged => match on_shaft {
                None => self.stuck((angle, cycle), time, gap),
                Some(at) => self.stuck_on_shaft((angle, cycle), at, gap),
            },
        }
    }

    /// What it means for a film between two steps, at a place on the path.
    pub(super) fn told_between(&self, reason: NoStage, time: f64, at: Vector) -> NoOrbit {
        let angle = (self.cycle.angular_speed() * time).to_degrees();
        match reason {
            NoStage::Film(..) if self.least_gap(at) > 0.0 => {
                self.told(reason, (time, angle), 1, (self.least_gap(at), None))
            }
            NoStage::Film(..) | NoStage::Diverged => {
                NoOrbit::Between { angle, gap: self.least_gap(at) / self.problem.bearing.clearance }
            }
        }
    }

    /// Why no step leads a journal on a shaft on from a place [m] with this least gap [m].
    fn stuck_on_shaft(&self, (angle, cycle): (f64, usize), at: Vector, gap: f64) -> NoOrbit {
        let clearance = self.problem.bearing.clearance;
        let gap = gap / clearance;
        if gap >= 1.0 - GREATEST_ECCENTRICITY {
            return NoOrbit::Stuck { angle, cycle, gap };
        }
        let [x, y, z_x, z_y] = at.map(|part| part / clearance);
        NoOrbit::SqueezedOutOnShaft { angle, cycle, gap, eccentricity: x.hypot(y), tilt: z_x.hypot(z_y) }
    }

    /// Why no step leads on from a film with this least gap [m].
    fn stuck(&self, (angle, cycle): (f64, usize), time: f64, gap: f64) -> NoOrbit {
        let gap = gap / self.problem.bearing.clearance;
        if gap < 1.0 - GREATEST_ECCENTRICITY {
            return NoOrbit::SqueezedOut { angle, cycle, gap };
        }
        let Some(towards) = self.towards_opening(time) else {
            return NoOrbit::Stuck { angle, cycle, gap };
        };
        let direction = towards.to_degrees().rem_euclid(360.0);
        match self.mass == 0.0 && self.opening(towards) > PI - ROUNDING {
            true => NoOrbit::OffShell { angle, cycle, direction },
            false => NoOrbit::AtOpening { angle, cycle, direction },
        }
    }

    /// Direction [rad] of the load at a time or shortly after, if it points into the opening of an arc or near to it.
    fn towards_opening(&self, time: f64) -> Option<f64> {
        let period = self.cycle.period() / self.cycle.angular_speed();
        let directions = [time, time + SHORTLY * period].map(|time| {
            let [x, y, ..] = self.asked(time);
            y.atan2(x)
        });
        let is_near = |direction: &f64| [-NEAR, 0.0, NEAR].iter().any(|by| self.opening(direction + by) > OPENING);
        directions.into_iter().find(is_near)
    }

    /// Angle [rad] between the nodes on both sides of this one [rad]: from pi on a film, which pushes, has no force
    /// that way.
    fn opening(&self, angle: f64) -> f64 {
        opening(self.system, self.problem.bearing.radius, angle)
    }
}
