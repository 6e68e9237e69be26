//! # The load of a journal over a cycle, by crank angle
//!
//! **Frames.** The film sees the frame of the bearing's shell. Loads are also given in two others:
//!
//! | frame | axes | to the shell |
//! |---|---|---|
//! | [`ForceAxes::Shell`] | of the bearing, x at angle 0 | - |
//! | [`ForceAxes::Cylinder`] | x from the crank's centre to the cylinder | turned by beta in a rod, else the same |
//! | [`ForceAxes::Pin`] | x from the crank's centre to the pin | by the crank angle, then as the cylinder's |
//!
//! Angles grow from x to y in all of them. A shell in a rod turns with it: x lies along the rod from the big end to the
//! small end, and the journal turns against it with `omega (1 + d beta/d theta)`. The film has no inertia, so nothing
//! else changes.
//!
//! **Angle.** A load goes by the angle of the crank, which turns with the journal, or by an angle of its own: one turn
//! of it is then one period ([`DutyCycle::at_frequency`]).
//!
//! **Signs.** A force F is that of [`crate::JournalLoad`]: external, on the journal; the film pushes the journal with
//! -F and the shell with F. The crank angle grows with time. Where the journal turns towards falling angles of its
//! bearing, the mechanism is mirrored in the x axis.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | theta, its period | rad | `angle`, `period` |
//! | F, M | N, N m | [`Duty::force`], [`Duty::moment`] |
//! | omega; against the shell | rad/s | [`Turning::speed`]; [`Duty::speed`] |
//!
//! **Source.** Mechanics of the slider crank ([`crank`]); periodic cubic spline: C. de Boor, A Practical Guide to
//! Splines, 1978, ch. IV ([`spline`]). **Range.** Constant speed of the crank. **Verified by** `duty_cycle/tests.rs`
//! and `tests/tests/duty_cycle.rs`.

pub mod crank;
mod frame;
mod harmonics;
pub mod spline;
mod summary;
mod table;
#[cfg(test)]
mod tests;

pub use crank::{Crank, GasPressure, Linkage, PressureCurve, Throw};
pub use frame::{ForceAxes, Turning};
pub use harmonics::Harmonic;
pub use spline::{NoSpline, PeriodicSpline};
pub use summary::{RowsSummary, Summary};
pub use table::LoadPoint;

use frame::Acting;

/// What acts on a journal at one crank angle, in the frame of the bearing's shell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duty {
    /// External force on the journal [N], which the film carries.
    pub force: [f64; 2],
    /// Moment on the journal [N m], which does work on the tilt: `Int z dF`.
    pub moment: [f64; 2],
    /// Angular speed [rad/s] of the journal against the bearing's shell.
    pub speed: f64,
}

/// The load of a journal over a cycle. It is defined at any angle, and periodic.
#[derive(Debug, Clone, PartialEq)]
pub struct DutyCycle {
    period: f64,
    angular_speed: f64,
    at: f64,
    unbalance: Option<[f64; 2]>,
    source: CycleSource,
}

/// Where a load comes from.
#[derive(Debug, Clone, PartialEq)]
enum CycleSource {
    /// The duty does not change.
    Constant(Duty),
    /// A curve through the points of a table and within them, in the frame of the shell.
    Table(Turning, PeriodicSpline<4>),
    /// Harmonics in a frame.
    Harmonics(Turning, ForceAxes, Vec<Harmonic>),
    /// The big end of a crank.
    BigEnd(Turning, Crank),
    /// A main bearing between throws that have this crank drive each.
    Main(Turning, Crank, Vec<Throw>),
}

impl DutyCycle {
    /// A load that does not change, with a nominal period [rad] of the crank angle and an angular speed [rad/s] of the
    /// crank.
    pub fn constant(duty: Duty, period: f64, angular_speed: f64) -> Self {
        Self { period, angular_speed, at: 0.0, unbalance: None, source: CycleSource::Constant(duty) }
    }

    /// The load through points of a table in a frame, at growing angles less than `period` [rad] apart; the first is
    /// not repeated at the end. The points are turned to the frame of the shell, and joined there by a periodic cubic
    /// within them ([`PeriodicSpline::within_points`]), so that tables of the same forces in several frames are the
    /// same load.
    ///
    /// # Errors
    /// [`NoSpline`]: the angles do not grow, or there are too few points.
    pub fn of_table(points: &[LoadPoint], period: f64, frame: ForceAxes, turning: Turning) -> Result<Self, NoSpline> {
        let spline = table::spline(points, period, frame, &turning)?;
        Ok(Self::of(period, turning, CycleSource::Table(turning, spline)))
    }

    /// The load that is a sum of harmonics in a frame; `period` [rad] is one of all of them.
    pub fn of_harmonics(harmonics: Vec<Harmonic>, period: f64, frame: ForceAxes, turning: Turning) -> Self {
        Self::of(period, turning, CycleSource::Harmonics(turning, frame, harmonics))
    }

    /// The load of the big end of a crank that turns with `speed` [rad/s], positive towards growing angles of the
    /// bearing.
    pub fn of_big_end(crank: Crank, speed: f64) -> Self {
        let rod = Some(crank.linkage);
        let turning = Turning { speed, rod };
        Self::of(crank.gas.period(), turning, CycleSource::BigEnd(turning, crank))
    }

    /// The load of a main bearing of a crankshaft that turns with `speed` [rad/s], positive towards growing angles of
    /// the bearing: shares of the loads of the throws beside it, each with this crank drive. The axis x of the bearing
    /// points to the cylinders, which are in line.
    pub fn of_main(crank: Crank, throws: Vec<Throw>, speed: f64) -> Self {
        let turning = Turning { speed, rod: None };
        Self::of(crank.gas.period(), turning, CycleSource::Main(turning, crank, throws))
    }

    fn of(period: f64, turning: Turning, source: CycleSource) -> Self {
        Self { period, angular_speed: turning.speed.abs(), at: 0.0, unbalance: None, source }
    }

    /// This load with its force at the axial position `at` [m], 0 midway between the ends: the moment grows by that of
    /// the force.
    #[must_use]
    pub fn acting_at(self, at: f64) -> Self {
        Self { at, ..self }
    }

    /// This load with the pull of what is out of balance on the shaft: mass times radius [kg m] along the axes of the
    /// shaft, which are those of the shell at crank angle 0 and turn with the journal.
    #[must_use]
    pub fn with_unbalance(self, unbalance: [f64; 2]) -> Self {
        Self { unbalance: Some(unbalance), ..self }
    }

    /// This load with an angle of its own, which grows at this rate [rad/s] however the journal turns. Its frame is
    /// that of the shell, which is at rest.
    #[must_use]
    pub fn at_frequency(self, angular_speed: f64) -> Self {
        Self { angular_speed, ..self }
    }

    /// Period of the crank angle [rad].
    pub fn period(&self) -> f64 {
        self.period
    }

    /// Rate of the angle [rad/s]: the speed of the crank, or that of the load's own angle.
    pub fn angular_speed(&self) -> f64 {
        self.angular_speed
    }

    /// What acts on the journal at a crank angle [rad].
    pub fn at(&self, angle: f64) -> Duty {
        let angle = angle.rem_euclid(self.period);
        let mut duty = match &self.source {
            CycleSource::Constant(duty) => *duty,
            CycleSource::Table(turning, spline) => {
                turning.duty(Acting::of_parts(spline.at(angle)), ForceAxes::Shell, angle)
            }
            CycleSource::Harmonics(turning, frame, harmonics) => {
                turning.duty(Acting::of_parts(harmonics::sum(harmonics, angle)), *frame, angle)
            }
            CycleSource::BigEnd(turning, crank) => {
                let [x, y] = crank.force_on_pin(angle, turning.speed);
                let acting = Acting::of_parts([-x, -turning.sense() * y, 0.0, 0.0]);
                turning.duty(acting, ForceAxes::Cylinder, angle)
            }
            CycleSource::Main(turning, crank, throws) => {
                let [x, y] = crank.force_on_main(throws, angle, turning.speed);
                let acting = Acting::of_parts([x, turning.sense() * y, 0.0, 0.0]);
                turning.duty(acting, ForceAxes::Cylinder, angle)
            }
        };
        if let Some([along, across]) = self.unbalance {
            let (sin, cos) = angle.sin_cos();
            let square = self.angular_speed * self.angular_speed;
            let sense = 1f64.copysign(duty.speed);
            duty.force[0] += square * (along * cos - across * sin);
            duty.force[1] += sense * square * (along * sin + across * cos);
        }
        for (moment, force) in duty.moment.iter_mut().zip(duty.force) {
            *moment += self.at * force;
        }
        duty
    }

    /// How the journal and the shell turn; `None`: the load is constant, and no crank is known.
    pub fn turning(&self) -> Option<Turning> {
        match &self.source {
            CycleSource::Constant(_) => None,
            CycleSource::Table(turning, _)
            | CycleSource::Harmonics(turning, ..)
            | CycleSource::BigEnd(turning, _)
            | CycleSource::Main(turning, ..) => Some(*turning),
        }
    }

    /// The crank whose big end has this load, where it is one.
    pub fn crank(&self) -> Option<&Crank> {
        match &self.source {
            CycleSource::BigEnd(_, crank) => Some(crank),
            _ => None,
        }
    }
}
