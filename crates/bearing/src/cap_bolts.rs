//! # Cap bolts: the forces in the bolted joint of a connecting rod's cap
//!
//! **Equation.** At the top dead centre before intake nothing but the cap holds what lies beyond the parting plane:
//! `P = omega^2 r [m_j (1 + r/l) + (m_r - m_c)]`, on each of i bolts `P/i`. The joint stays closed with a safety nu,
//! and the halves of the shell, which stand out by Delta before they are clamped, are pressed to the length of their
//! seat by `2 R` in all: `R = Delta E F/(pi rho)`, `Q = nu (1 - chi) P/i + 2 R/i`, `M = k Q d`. In use a bolt bears
//! between `Q` and `Q + chi P/i`, the joint opens where the cap is pulled with `nu P`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | m_j, m_r, m_c | kg | `reciprocating_mass`, `rotating_mass`, `cap_mass` |
//! | r, l | m | `crank_radius`, `rod_length` |
//! | i, d, F_1 | -, m, m2 | `bolts`, `diameter`, `stress_area` |
//! | chi, nu, k | - | `load_share`, `tightness`, `torque_coefficient` |
//! | Delta, E, F, rho | m, Pa, m2, m | `protrusion`, `modulus`, `section`, `radius` |
//! | P, R, Q, M | N, N, N, N m | `cap_force`, `shell_force`, `preload`, `torque` |
//!
//! **Source.** Design of a tractor engine (in Ukrainian), section 6.4 "Connecting-rod bolts", as in textbooks on engine
//! design.
//! **Range.** A stiff cap whose joint does not open; the crank at steady speed; the first two orders of the piston's
//! acceleration.
//! **Verified by** `tests/tests/literature/connecting_rod_bolts.rs`, and
//! `the_joint_opens_where_its_clamping_is_used_up` below.

use std::f64::consts::PI;

/// A cap, its bolts and the masses that pull at it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CapBolts {
    /// Mass m_j [kg] of the piston with what belongs to it, and of the rod at its small end.
    pub reciprocating_mass: f64,
    /// Mass m_r [kg] of the rod at its big end, the cap included.
    pub rotating_mass: f64,
    /// Mass m_c [kg] of the cap.
    pub cap_mass: f64,
    /// Crank radius r [m].
    pub crank_radius: f64,
    /// Length l [m] of the rod from eye to eye.
    pub rod_length: f64,
    /// Number i of bolts, half of them on each side.
    pub bolts: u32,
    /// Outer diameter d [m] of their thread.
    pub diameter: f64,
    /// Section F_1 [m2] that counts for their stress.
    pub stress_area: f64,
    /// Share chi in (0, 1) of a pull at the joint that stretches its bolts; the rest relieves what they clamp.
    pub load_share: f64,
    /// Safety nu > 1 of the closed joint.
    pub tightness: f64,
    /// Coefficient k of the tightening torque `k Q d`.
    pub torque_coefficient: f64,
    /// The shell, if its halves stand out.
    pub shell: Option<Shell>,
}

/// A half of the bearing shell before it is clamped.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shell {
    /// How far Delta [m] it stands out of its seat.
    pub protrusion: f64,
    /// Modulus of elasticity E [Pa] of its back.
    pub modulus: f64,
    /// Section F [m2] across its wall.
    pub section: f64,
    /// Mean radius rho [m].
    pub radius: f64,
}

/// Forces in a joint that is pulled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoltForces {
    /// Pull P [N] at the cap.
    pub cap_force: f64,
    /// Part of the force on one bolt [N].
    pub bolt_force: f64,
    /// Force R [N] that presses one side of the shell to the length of its seat.
    pub shell_force: f64,
    /// Preload Q [N] of a bolt, the least force that it bears in use.
    pub preload: f64,
    /// Greatest force [N] that it bears.
    pub greatest: f64,
    /// Tightening torque M [N m].
    pub torque: f64,
    /// Pull [N] at the cap at which the joint opens.
    pub opening: f64,
}

impl CapBolts {
    /// Force [N] that pulls at the cap at the speed omega [rad/s] of the crank.
    pub fn inertia_force(&self, speed: f64) -> f64 {
        let reciprocating = self.reciprocating_mass * (1.0 + self.crank_radius / self.rod_length);
        speed * speed * self.crank_radius * (reciprocating + self.rotating_mass - self.cap_mass)
    }

    /// Force R [N] that presses one side of the shell to the length of its seat.
    pub fn shell_force(&self) -> f64 {
        self.shell.map_or(0.0, |shell| shell.protrusion * shell.modulus * shell.section / (PI * shell.radius))
    }

    /// The forces in a joint tightened for a pull of `cap_force` [N].
    pub fn forces(&self, cap_force: f64) -> BoltForces {
        let bolts = f64::from(self.bolts);
        let (bolt_force, shell_force) = (cap_force / bolts, self.shell_force());
        let clamping = self.tightness * (1.0 - self.load_share) * bolt_force;
        let preload = clamping + 2.0 * shell_force / bolts;
        BoltForces {
            cap_force,
            bolt_force,
            shell_force,
            preload,
            greatest: preload + self.load_share * bolt_force,
            torque: self.torque_coefficient * preload * self.diameter,
            opening: self.tightness * cap_force,
        }
    }

    /// Stress [Pa] of a bolt that bears `force` [N].
    pub fn stress(&self, force: f64) -> f64 {
        force / self.stress_area
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn joint() -> CapBolts {
        CapBolts {
            reciprocating_mass: 0.7,
            rotating_mass: 0.5,
            cap_mass: 0.15,
            crank_radius: 0.045,
            rod_length: 0.145,
            bolts: 4,
            diameter: 8e-3,
            stress_area: 36.6e-6,
            load_share: 0.2,
            tightness: 2.5,
            torque_coefficient: 0.14,
            shell: Some(Shell { protrusion: 20e-6, modulus: 2.1e11, section: 40e-6, radius: 0.025 }),
        }
    }

    /// The bolts take the share chi of a pull, and the rest relieves the faces that they clamp: those of the joint bear
    /// what the shell leaves of the preload.
    #[test]
    fn the_joint_opens_where_its_clamping_is_used_up() {
        let joint = joint();
        let forces = joint.forces(joint.inertia_force(600.0));
        let on_the_joint = 4.0 * forces.preload - 2.0 * forces.shell_force;
        let left = on_the_joint - (1.0 - joint.load_share) * forces.opening;
        assert!(left.abs() < 1e-12 * on_the_joint, "{left}");
        let stretched = 4.0 * (forces.greatest - forces.preload);
        assert!((stretched / (joint.load_share * forces.cap_force) - 1.0).abs() < 1e-12);
    }

    /// The piston's acceleration at the top dead centre, from its path.
    #[test]
    fn inertia_is_mass_times_acceleration() {
        let joint = CapBolts { rotating_mass: 0.0, cap_mass: 0.0, ..joint() };
        let (r, l, speed) = (joint.crank_radius, joint.rod_length, 600.0f64);
        let height = |t: f64| r * (speed * t).cos() + (l * l - (r * (speed * t).sin()).powi(2)).sqrt();
        let step = 1e-6;
        let acceleration = (height(step) - 2.0 * height(0.0) + height(-step)) / (step * step);
        let force = joint.inertia_force(speed);
        assert!((-acceleration * joint.reciprocating_mass / force - 1.0).abs() < 1e-5);
    }

    #[test]
    fn without_protrusion_or_speed_there_is_nothing_to_hold() {
        let joint = CapBolts { shell: None, ..joint() };
        assert_eq!(joint.shell_force(), 0.0);
        let forces = joint.forces(joint.inertia_force(0.0));
        assert_eq!((forces.preload, forces.torque, forces.opening), (0.0, 0.0, 0.0));
    }
}
