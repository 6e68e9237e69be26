//! Journals that move at the same time: one under the load of its cycle, or all of a shaft.

use oilwedge_reynolds::film_thickness::Deflection;

use super::motion::{Instant, Motion, SAMPLES};
use super::scheme::{FOURTH_ORDER, SECOND_ORDER, Scheme};
use crate::coordinates::{Vector, length};
use crate::shaft::frame::Shaft;
use crate::shaft::joined::{ShaftBalance, magnitude};

/// Residual over the load to which the steps of a shaft are balanced at the roughest.
const BALANCED: f64 = 1e-9;

/// Journals that move at the same time.
#[derive(Clone, Copy)]
pub struct Journals<'a> {
    /// The equation of motion of each; on a shaft those of journals without a load.
    pub motions: &'a [Motion<'a>],
    /// The shaft that joins them; `None`: one journal under the load of its cycle.
    pub shaft: Option<Drive<'a>>,
}

/// A shaft, and what drives it over a cycle.
#[derive(Clone, Copy)]
pub struct Drive<'a> {
    /// The shaft.
    pub shaft: &'a Shaft,
    /// How much what holds each shell gives way in each coordinate [m/N].
    pub compliance: &'a [Vector],
    /// Loads as forces on the journals [N] at a crank angle [rad].
    pub loads: &'a (dyn Fn(f64) -> Vec<Vector> + Sync),
    /// Period of the crank angle [rad].
    pub period: f64,
    /// Angular speed of the crank [rad/s].
    pub speed: f64,
}

impl<'a> Drive<'a> {
    /// The balance of the shaft at a time [s].
    pub fn balance(&self, time: f64) -> ShaftBalance<'a> {
        let angle = self.speed * time;
        ShaftBalance { shaft: self.shaft, compliance: self.compliance, angle, asked: (self.loads)(angle) }
    }
}

impl<'a> Journals<'a> {
    /// One journal under the load of its cycle.
    pub fn alone(motion: &'a Motion<'a>) -> Self {
        Self { motions: std::slice::from_ref(motion), shaft: None }
    }

    /// Length of the cycle [s].
    pub fn duration(&self) -> f64 {
        match &self.shaft {
            Some(drive) => drive.period / drive.speed,
            None => self.motions[0].cycle.period() / self.motions[0].cycle.angular_speed(),
        }
    }

    /// Crank angle at a time [deg].
    pub(super) fn crank_angle(&self, time: f64) -> f64 {
        let speed = self.shaft.as_ref().map_or_else(|| self.motions[0].cycle.angular_speed(), |drive| drive.speed);
        (speed * time).to_degrees()
    }

    /// The method by which steps are made: one that suits all films.
    pub(super) fn scheme(&self) -> &'static Scheme {
        match self.motions.iter().any(|motion| motion.problem.cavitation.conserves_oil()) {
            true => &SECOND_ORDER,
            false => &FOURTH_ORDER,
        }
    }

    /// Residual over the load to which the ends of steps are balanced at the roughest [1]: those of a shaft are
    /// reported.
    pub(super) fn balanced_at_steps(&self) -> f64 {
        if self.shaft.is_some() { BALANCED } else { f64::INFINITY }
    }

    /// Greatest load over the cycle [N].
    pub(super) fn peak_load(&self) -> f64 {
        let Some(drive) = &self.shaft else {
            return self.motions[0].peak_load();
        };
        let angle = |k: u32| drive.period * f64::from(k) / f64::from(SAMPLES);
        (0..SAMPLES).map(|k| magnitude(&(drive.loads)(angle(k)))).fold(f64::MIN_POSITIVE, f64::max)
    }

    /// What is left of the equations of motion of journals that are accelerated so [m/s2], over the force `scale` [N].
    pub(super) fn residual(&self, here: &[Instant], accelerations: &[Vector], scale: f64) -> f64 {
        let left = match &self.shaft {
            Some(drive) => {
                let [at, carried]: [Vec<Vector>; 2] =
                    [|here: &Instant| here.at, |here: &Instant| here.excess].map(|of| here.iter().map(of).collect());
                drive.balance(here[0].time).left(&at, &carried)
            }
            None => {
                let masses = self.motions[0].masses();
                vec![[0, 1, 2, 3].map(|k| here[0].excess[k] + masses[k] * accelerations[0][k])]
            }
        };
        magnitude(&left) / scale
    }

    /// Least gaps [m] of journals at these places [m] under these walls.
    pub fn gaps<'w>(&self, at: impl IntoIterator<Item = (Vector, Option<&'w Deflection>)>) -> Vec<f64> {
        let journals = self.motions.iter().zip(at);
        journals.map(|(motion, (at, wall))| motion.least_gap_under(wall, at)).collect()
    }

    /// The number of the journal that is nearest to its shell at these places [m] under these walls, and its least gap
    /// over the clearance [1].
    pub fn thinnest<'w>(&self, at: impl IntoIterator<Item = (Vector, Option<&'w Deflection>)>) -> (usize, f64) {
        let films = self.motions.iter().zip(self.gaps(at));
        let parts = films.map(|(motion, gap)| gap / motion.problem.bearing.clearance);
        parts.enumerate().fold((0, f64::INFINITY), |best, it| if it.1 < best.1 { it } else { best })
    }

    /// The greatest of the ways [m] over least gaps [m].
    pub(super) fn greatest_part(ways: impl IntoIterator<Item = Vector>, gaps: &[f64]) -> f64 {
        ways.into_iter().zip(gaps).map(|(way, gap)| length(way) / gap).fold(0.0, f64::max)
    }
}
