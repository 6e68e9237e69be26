//! The cap of a connecting rod: what its bolts must hold, and what the film's load makes of that.

use oilwedge_bearing::{BoltForces, CapBolts};
use oilwedge_scene::Cap;

use crate::scope::Scope;

use super::row::{Measure::One, Table};
use super::rule::ErrorRule;
use super::view::View;
use crate::cap_joint::cap_joint;

rows! {
    /// `P_c = omega^2 r (m_j (1 + r/l) + m_r - m_c)`: pull of inertia at the cap, the piston at the top dead centre
    /// before intake; m_j, m_r, m_c the reciprocating and rotating masses and that of the cap, r the crank radius, l
    /// the length of the rod
    CAP_FORCE = "cap_force", "P_c", Newton, "inertia that pulls at the cap":
        One(|film| Some(joint(film)?.forces.cap_force)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `P_o = nu P_c`: pull at the cap at which the joint opens, nu the safety to which it is tightened
    CAP_OPENING_FORCE = "cap_opening_force", "P_o", Newton, "pull at the cap that opens the joint":
        One(|film| Some(joint(film)?.forces.opening)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `W_c/P_o`, W_c the part of the film's load that points to the cap; 1 opens the joint, below 0 nothing pulls at
    /// it. The cap's own inertia is left out, which takes some of it; none at rest
    CAP_FILM_SHARE = "cap_film_share", "W_c/P_o", One, "pull of this film at the cap / P_o (< 0: none)":
        One(film_share),
        ErrorRule::Component(share_per_force),
        in_table(Table::Cap) only(opens);

    /// `R_s = Delta E F/(pi rho)`: force that presses one side of the shell to the length of its seat; Delta its
    /// protrusion, E modulus, F section, rho mean radius; none without `shell`
    SHELL_FORCE = "shell_force", "R_s", Newton, "presses one side of the shell into its seat":
        One(|film| joint(film).filter(|it| it.cap.shell.is_some()).map(|it| it.forces.shell_force)),
        ErrorRule::Exact, only(|scope| scope.cap.is_some_and(|cap| cap.shell.is_some())) in_table(Table::Cap);

    /// `P_b = P_c/i`, i the number of bolts
    BOLT_FORCE = "bolt_force", "P_b", Newton, "pull on one bolt":
        One(|film| Some(joint(film)?.forces.bolt_force)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `Q = nu (1 - chi) P_b + 2 R_s/i`: preload, the least force that a bolt bears in use; chi the share of a pull at
    /// the joint that its bolts take
    BOLT_PRELOAD = "bolt_preload", "Q", Newton, "preload of a bolt, its least force":
        One(|film| Some(joint(film)?.forces.preload)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `M = k Q d`, d the diameter of the thread
    BOLT_TORQUE = "bolt_torque", "M", NewtonMetre, "tightening torque of a bolt":
        One(|film| Some(joint(film)?.forces.torque)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `Q_max = Q + chi P_b`
    BOLT_FORCE_MAX = "bolt_force_max", "Q_max", Newton, "greatest force of a bolt":
        One(|film| Some(joint(film)?.forces.greatest)), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `sigma_max = Q_max/F_1`, F_1 the stress area of the thread
    BOLT_STRESS_MAX = "bolt_stress_max", "sigma_max", PascalOfStress, "greatest stress of a bolt":
        One(|film| Some(joint(film)?.stresses()[1])), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `sigma_min = Q/F_1`
    BOLT_STRESS_MIN = "bolt_stress_min", "sigma_min", PascalOfStress, "least stress of a bolt":
        One(|film| Some(joint(film)?.stresses()[0])), ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `sigma_m = (sigma_max + sigma_min)/2`
    BOLT_STRESS_MEAN = "bolt_stress_mean", "sigma_m", PascalOfStress, "their mean":
        One(|film| joint(film).map(|joint| joint.stresses()).map(|[least, greatest]| 0.5 * (greatest + least))),
        ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());

    /// `sigma_a = (sigma_max - sigma_min)/2`
    BOLT_STRESS_AMPLITUDE = "bolt_stress_amplitude", "sigma_a", PascalOfStress, "half their difference":
        One(|film| joint(film).map(|joint| joint.stresses()).map(|[least, greatest]| 0.5 * (greatest - least))),
        ErrorRule::Exact, in_table(Table::Cap) only(|scope| scope.cap.is_some());
}

/// The joint of a cap at the speed of the crank.
struct CapJoint {
    cap: Cap,
    joint: CapBolts,
    forces: BoltForces,
}

impl CapJoint {
    fn new(cap: &Cap, speed: f64) -> Self {
        let joint = cap_joint(cap);
        Self { cap: *cap, forces: joint.forces(joint.inertia_force(speed)), joint }
    }

    /// Least and greatest stress [Pa] of a bolt.
    fn stresses(&self) -> [f64; 2] {
        [self.forces.preload, self.forces.greatest].map(|force| self.joint.stress(force))
    }
}

fn opens(scope: &Scope) -> bool {
    let cap = scope.cap.map(|cap| CapJoint::new(&cap, scope.speed));
    cap.is_some_and(|joint| joint.forces.opening > 0.0)
}

fn joint(film: &View) -> Option<CapJoint> {
    Some(CapJoint::new(&film.base.model.scope.cap?, film.journal().speed))
}

/// The vector [1/N] whose product with the load of the film is its share of the force that opens the joint; none at
/// rest, where the joint is tightened for no force.
fn share_per_force(film: &View) -> Option<[f64; 2]> {
    let CapJoint { cap, forces, .. } = joint(film)?;
    (forces.opening > 0.0).then(|| [cap.angle.cos(), cap.angle.sin()].map(|part| part / forces.opening))
}

fn film_share(film: &View) -> Option<f64> {
    let ([x, y], force) = (share_per_force(film)?, film.measured.load.total.force);
    Some(x * force[0] + y * force[1])
}
