//! Why the journals of a shaft are not led on over the cycle.

use super::stage::NoStage;
use super::step::Drive;
use crate::GREATEST_ECCENTRICITY;
use crate::coordinates::Vector;

/// Why a shaft has no orbit.
#[derive(Debug, thiserror::Error)]
pub enum NoShaftOrbit {
    /// A journal has no film.
    #[error("no film at {angle:.2} deg of cycle {cycle}: {reason}")]
    Film {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// The bearing, by its number from 0.
        bearing: usize,
        /// Why.
        reason: oilwedge_reynolds::NoFilm,
    },
    /// No step, however short, leads on.
    #[error(
        "not converged: no step leads on from {angle:.2} deg of cycle {cycle}, where the least film is {gap:.3e} of the clearance"
    )]
    Stuck {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// The bearing with the least film, by its number from 0.
        bearing: usize,
        /// That film over the clearance [1].
        gap: f64,
    },
    /// No step leads on, for a film is squeezed out.
    #[error(
        "the loads squeeze the film out: at {angle:.2} deg of cycle {cycle} its thinnest place has {gap:.1e} of the clearance, where the journal is {eccentricity:.3} of the clearance off the middle \
         and its slope takes {tilt:.3} at the ends, and no step leads on"
    )]
    SqueezedOut {
        /// Crank angle [deg].
        angle: f64,
        /// Number of the cycle, from 1.
        cycle: usize,
        /// The bearing, by its number from 0.
        bearing: usize,
        /// Its least film over the clearance [1].
        gap: f64,
        /// Offset of its journal at mid-length over the clearance [1].
        eccentricity: f64,
        /// Slope of its journal times half of its length over the clearance [1].
        tilt: f64,
    },
    /// The time was over before the first cycle was complete.
    #[error("not converged: the shaft was followed to {angle:.1} deg of the first cycle only")]
    Ended {
        /// Crank angle [deg].
        angle: f64,
    },
}

impl Drive<'_> {
    /// What a stage without a solution means for the shaft, which has come to these places [m].
    pub(super) fn told(&self, reason: NoStage, time: f64, cycle: usize, at: &[Vector]) -> NoShaftOrbit {
        let angle = (self.speed * time).to_degrees();
        match reason {
            NoStage::Film(at) => NoShaftOrbit::Film { angle, cycle, bearing: at.bearing, reason: at.reason },
            NoStage::Diverged(..) => self.stuck((angle, cycle), at),
        }
    }

    /// Why no step leads on from these places.
    fn stuck(&self, (angle, cycle): (f64, usize), at: &[Vector]) -> NoShaftOrbit {
        let (bearing, gap) = self.films.thinnest(at);
        if gap >= 1.0 - GREATEST_ECCENTRICITY {
            return NoShaftOrbit::Stuck { angle, cycle, bearing, gap };
        }
        let clearance = self.films.films[bearing].problem.bearing.clearance;
        let [x, y, z_x, z_y] = at[bearing].map(|part| part / clearance);
        NoShaftOrbit::SqueezedOut { angle, cycle, bearing, gap, eccentricity: x.hypot(y), tilt: z_x.hypot(z_y) }
    }
}
