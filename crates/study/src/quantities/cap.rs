//! The cap of a connecting rod: what its bolts must hold, and what the film's load makes of that.

use oilwedge_bearing::{BoltForces, CapBolts};
use oilwedge_scene::Cap;

use super::row::{Measure::One, Row, Table};
use super::rule::ErrorRule;
use super::unit::Unit::{self, Newton, NewtonMetre, One as Ratio, Pascal};
use super::view::View;
use crate::cap_joint::cap_joint;

/// Pull of inertia.
pub static CAP_FORCE: Row = given("cap_force", "P_c", Newton, |film| Some(joint(film)?.forces.cap_force)).means(
    "inertia that pulls at the cap",
    "`P_c = omega^2 r (m_j (1 + r/l) + m_r - m_c)`: pull of inertia at the cap, the piston at the top dead centre before intake; m_j, m_r, m_c the reciprocating and rotating masses and that of the cap, r the crank radius, l the length of the rod",
);

/// Pull that opens the joint.
pub static CAP_OPENING_FORCE: Row = given("cap_opening_force", "P_o", Newton, |film| {
    Some(joint(film)?.forces.opening)
})
.means(
    "pull at the cap that opens the joint",
    "`P_o = nu P_c`: pull at the cap at which the joint opens, nu the safety to which it is tightened",
);

/// Share of the film in the pull that opens the joint.
pub static CAP_FILM_SHARE: Row =
    Row::new("cap_film_share", "W_c/P_o", Ratio, One(film_share), ErrorRule::Component(share_per_force))
        .means(
            "pull of this film at the cap / P_o (< 0: none)",
            "`W_c/P_o`, W_c the part of the film's load that points to the cap; 1 opens the joint, below 0 nothing pulls at it. The cap's own inertia is left out, which takes some of it; none at rest",
        )
        .in_table(Table::Cap)
        .only(|scene| scene.cap.is_some_and(|cap| Joint::new(&cap, scene.journal.speed).forces.opening > 0.0));

/// Force that seats the shell.
pub static SHELL_FORCE: Row = given("shell_force", "R_s", Newton, |film| {
    joint(film).filter(|it| it.cap.shell.is_some()).map(|it| it.forces.shell_force)
})
    .means(
        "presses one side of the shell into its seat",
        "`R_s = Delta E F/(pi rho)`: force that presses one side of the shell to the length of its seat; Delta its protrusion, E modulus, F section, rho mean radius; none without `shell`",
    )
    .only(|scene| scene.cap.is_some_and(|cap| cap.shell.is_some()));

/// Pull on a bolt.
pub static BOLT_FORCE: Row = given("bolt_force", "P_b", Newton, |film| Some(joint(film)?.forces.bolt_force))
    .means("pull on one bolt", "`P_b = P_c/i`, i the number of bolts");

/// Preload of a bolt.
pub static BOLT_PRELOAD: Row = given("bolt_preload", "Q", Newton, |film| Some(joint(film)?.forces.preload)).means(
    "preload of a bolt, its least force",
    "`Q = nu (1 - chi) P_b + 2 R_s/i`: preload, the least force that a bolt bears in use; chi the share of a pull at the joint that its bolts take",
);

/// Tightening torque of a bolt.
pub static BOLT_TORQUE: Row = given("bolt_torque", "M", NewtonMetre, |film| Some(joint(film)?.forces.torque)).means(
    "tightening torque of a bolt",
    "`M = k Q d`, d the diameter of the thread",
);

/// Greatest force of a bolt.
pub static BOLT_FORCE_MAX: Row = given("bolt_force_max", "Q_max", Newton, |film| {
    Some(joint(film)?.forces.greatest)
})
.means("greatest force of a bolt", "`Q_max = Q + chi P_b`");

/// Greatest stress of a bolt.
pub static BOLT_STRESS_MAX: Row = given("bolt_stress_max", "sigma_max", Pascal, |film| {
    Some(joint(film)?.stresses()[1])
})
.means(
    "greatest stress of a bolt",
    "`sigma_max = Q_max/F_1`, F_1 the stress area of the thread",
);

/// Least stress of a bolt.
pub static BOLT_STRESS_MIN: Row = given("bolt_stress_min", "sigma_min", Pascal, |film| {
    Some(joint(film)?.stresses()[0])
})
.means("least stress of a bolt", "`sigma_min = Q/F_1`");

/// Mean stress of a bolt.
pub static BOLT_STRESS_MEAN: Row = given("bolt_stress_mean", "sigma_m", Pascal, |film| {
    let [least, greatest] = joint(film)?.stresses();
    Some(0.5 * (greatest + least))
})
.means("their mean", "`sigma_m = (sigma_max + sigma_min)/2`");

/// Amplitude of the stress of a bolt.
pub static BOLT_STRESS_AMPLITUDE: Row = given("bolt_stress_amplitude", "sigma_a", Pascal, |film| {
    let [least, greatest] = joint(film)?.stresses();
    Some(0.5 * (greatest - least))
})
.means("half their difference", "`sigma_a = (sigma_max - sigma_min)/2`");

/// A quantity of the cap that follows from given numbers alone.
const fn given(name: &'static str, symbol: &'static str, unit: Unit, measure: fn(&View) -> Option<f64>) -> Row {
    Row::new(name, symbol, unit, One(measure), ErrorRule::Exact)
        .in_table(Table::Cap)
        .only(|scene| scene.cap.is_some())
}

/// The joint of a cap at the speed of the crank.
struct Joint {
    cap: Cap,
    joint: CapBolts,
    forces: BoltForces,
}

impl Joint {
    fn new(cap: &Cap, speed: f64) -> Self {
        let joint = cap_joint(cap);
        Self {
            cap: *cap,
            forces: joint.forces(joint.inertia_force(speed)),
            joint,
        }
    }

    /// Least and greatest stress [Pa] of a bolt.
    fn stresses(&self) -> [f64; 2] {
        [self.forces.preload, self.forces.greatest].map(|force| self.joint.stress(force))
    }
}

fn joint(film: &View) -> Option<Joint> {
    Some(Joint::new(&film.study.cap?, film.journal().speed))
}

/// The vector [1/N] whose product with the load of the film is its share of the force that opens the joint; none at rest,
/// where the joint is tightened for no force.
fn share_per_force(film: &View) -> Option<[f64; 2]> {
    let Joint { cap, forces, .. } = joint(film)?;
    (forces.opening > 0.0).then(|| [cap.angle.cos(), cap.angle.sin()].map(|part| part / forces.opening))
}

fn film_share(film: &View) -> Option<f64> {
    let ([x, y], force) = (share_per_force(film)?, film.measured.load.total.force);
    Some(x * force[0] + y * force[1])
}
