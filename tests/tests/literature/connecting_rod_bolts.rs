//! Design of a tractor engine (in Ukrainian): hot oil that is carried over, the flow of the pump, and, section 6.4, the
//! bolts of a connecting rod whose cap is pulled off by inertia.
//!
//! Printed with omega = 260 rad/s for 2500 rpm, lambda = 0.272 for 0.27174 and pi = 3.14, from number to rounded
//! number; the test takes the same. Every number is met to half a unit of its last digit. k of the torque is not told:
//! 0.15 lies amid the 0.08 to 0.2 named. The stresses are lost in the print; those asked here are its forces over its
//! 56.7 mm2.

use std::f64::consts::PI;

use oilwedge_bearing::{CapBolts, Shell};
use oilwedge_tests::engine_bearings::{tractor, tractor_joint as joint};

#[track_caller]
fn prints(value: f64, printed: f64, digit: f64) {
    assert!((value - printed).abs() <= 0.5 * digit, "{value}, printed {printed}");
}

#[test]
fn the_chain_of_the_print() {
    for link in tractor() {
        assert!(
            (link.value - link.printed).abs() <= 0.5 * link.digit,
            "{}: {}, printed {}",
            link.what,
            link.value,
            link.printed
        );
    }
}

#[test]
fn stresses() {
    let joint = joint();
    let [least, greatest] = [37053.0, 39328.0].map(|force| 1e-6 * joint.stress(force));
    prints(PI / 4.0 * 8.5 * 8.5, 56.7, 0.1);
    prints(least, 653.5, 0.1);
    prints(greatest, 693.6, 0.1);
    prints(0.5 * (least + greatest), 673.6, 0.1);
    prints(0.5 * (greatest - least), 20.1, 0.1);
}

/// The bolts with the exact speed, ratio and pi.
#[test]
fn without_the_roundings_of_the_print() {
    let rounded = joint();
    let joint =
        CapBolts { rod_length: 0.230, shell: rounded.shell.map(|shell| Shell { radius: 0.0335, ..shell }), ..rounded };
    prints(rounded.inertia_force(2500.0 * PI / 30.0), 25629.1, 0.1);
    prints(joint.inertia_force(2500.0 * PI / 30.0), 25625.3, 0.1);
    prints(joint.shell_force(), 5957.62, 0.01);
}
