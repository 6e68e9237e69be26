//! Frames in which a load is given, and how it is turned from one to another.

use super::{Duty, Linkage};

/// Axes of the parts of a force; angles grow from x to y.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceAxes {
    /// Axes of the bearing's shell.
    Shell,
    /// Axis x from the centre of the crank to the cylinder.
    Cylinder,
    /// Axis x along the throw of the crank, from its centre to the pin; it turns with the crank angle.
    Pin,
}

/// How journal and shell turn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// Angular speed of the journal [rad/s], positive towards growing angles of the bearing; not zero where the angle
    /// of the load is that of the crank.
    pub speed: f64,
    /// The crank whose rod holds the shell; `None`: the shell is at rest, with the axes of the cylinder's frame.
    pub rod: Option<Linkage>,
}

/// Force [N] and moment [N m].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Acting {
    pub(super) force: [f64; 2],
    pub(super) moment: [f64; 2],
}

impl Acting {
    /// A duty of force and moment in one list.
    pub(super) fn of_parts([x, y, m_x, m_y]: [f64; 4]) -> Self {
        Self { force: [x, y], moment: [m_x, m_y] }
    }

    fn turned(&self, angle: f64) -> Self {
        Self { force: turned(self.force, angle), moment: turned(self.moment, angle) }
    }
}

impl Turning {
    /// 1 where the journal turns towards growing angles, -1 where it turns towards falling ones.
    pub(super) fn sense(&self) -> f64 {
        1f64.copysign(self.speed)
    }

    /// Angle of the axes of a frame against those of the shell [rad], at a crank angle [rad].
    fn angle_of(&self, frame: ForceAxes, angle: f64) -> f64 {
        let of_cylinder = self.rod.map_or(0.0, |rod| rod.inclination(angle));
        self.sense()
            * match frame {
                ForceAxes::Shell => 0.0,
                ForceAxes::Cylinder => of_cylinder,
                ForceAxes::Pin => of_cylinder + angle,
            }
    }

    /// Force [N] in the frame of the shell, of one in another frame at a crank angle [rad].
    pub fn to_shell(&self, force: [f64; 2], frame: ForceAxes, angle: f64) -> [f64; 2] {
        turned(force, self.angle_of(frame, angle))
    }

    /// Force [N] in a frame, of one in the frame of the shell at a crank angle [rad].
    pub fn from_shell(&self, force: [f64; 2], frame: ForceAxes, angle: f64) -> [f64; 2] {
        turned(force, -self.angle_of(frame, angle))
    }

    /// Angular speed of the journal against the shell [rad/s] at a crank angle [rad].
    pub fn speed_at(&self, angle: f64) -> f64 {
        self.speed * (1.0 + self.rod.map_or(0.0, |rod| rod.inclination_rate(angle)))
    }

    pub(super) fn duty(&self, acting: Acting, frame: ForceAxes, angle: f64) -> Duty {
        let acting = acting.turned(self.angle_of(frame, angle));
        Duty { force: acting.force, moment: acting.moment, speed: self.speed_at(angle) }
    }
}

fn turned([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}
