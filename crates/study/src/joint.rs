//! The cap of a connecting rod in numbers: what its bolts must hold, and what the film's load makes of that.

use crate::cap_joint::cap_joint;
use crate::result::Quantity;
use oilwedge_scene::Cap;

/// The quantity of a cap that depends on the film.
pub const FILM_SHARE: &str = "cap_film_share";
/// How names of its quantities begin.
const BEGINNINGS: [&str; 3] = ["cap_", "shell_", "bolt_"];

/// True of the quantities of a cap.
pub fn is_of_cap(name: &str) -> bool {
    BEGINNINGS.iter().any(|beginning| name.starts_with(beginning))
}

/// True of those that follow from given numbers alone.
pub fn is_given(name: &str) -> bool {
    is_of_cap(name) && name != FILM_SHARE
}

/// The vector [1/N] whose product with the load of the film is its share of the force that opens the joint; none at rest,
/// where the joint is tightened for no force.
pub fn share_per_force(cap: &Cap, speed: f64) -> Option<[f64; 2]> {
    let joint = cap_joint(cap);
    let opening = joint.forces(joint.inertia_force(speed)).opening;
    (opening > 0.0).then(|| [cap.angle.cos() / opening, cap.angle.sin() / opening])
}

/// What is told of a cap at the speed omega [rad/s] of the crank, under a film with the load `force` [N].
pub fn quantities(cap: &Cap, speed: f64, force: [f64; 2]) -> Vec<Quantity> {
    let joint = cap_joint(cap);
    let forces = joint.forces(joint.inertia_force(speed));
    let [least, greatest] = [forces.preload, forces.greatest].map(|force| joint.stress(force));
    let mut list = Vec::new();
    let mut add = |name: &str, symbol: &str, value: f64, unit: &str| {
        list.push(Quantity::new(name, symbol, value, unit));
    };
    add("cap_force", "P_c", forces.cap_force, "N");
    add("cap_opening_force", "P_o", forces.opening, "N");
    if let Some([x, y]) = share_per_force(cap, speed) {
        add(FILM_SHARE, "W_c/P_o", x * force[0] + y * force[1], "1");
    }
    if joint.shell.is_some() {
        add("shell_force", "R_s", forces.shell_force, "N");
    }
    add("bolt_force", "P_b", forces.bolt_force, "N");
    add("bolt_preload", "Q", forces.preload, "N");
    add("bolt_torque", "M", forces.torque, "N.m");
    add("bolt_force_max", "Q_max", forces.greatest, "N");
    add("bolt_stress_max", "sigma_max", greatest, "Pa");
    add("bolt_stress_min", "sigma_min", least, "Pa");
    add("bolt_stress_mean", "sigma_m", 0.5 * (greatest + least), "Pa");
    add("bolt_stress_amplitude", "sigma_a", 0.5 * (greatest - least), "Pa");
    list
}
