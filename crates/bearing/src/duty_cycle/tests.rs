//! Frames, signs and kinematics; numbers of published and computed cases are in `tests/tests/duty_cycle.rs`.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::*;

const LINKAGE: Linkage = Linkage { radius: 0.0625, rod_length: 0.23 };

fn crank() -> Crank {
    Crank {
        linkage: LINKAGE,
        reciprocating_mass: 3.43,
        rotating_mass: 2.025,
        bore: 0.125,
        gas: GasPressure::Curve(PressureCurve { peak: 8e6, angle: 0.2, sharpness: 14.0, period: 2.0 * TAU }),
    }
}

fn near(a: [f64; 2], b: [f64; 2], tolerance: f64) -> bool {
    (a[0] - b[0]).abs() <= tolerance && (a[1] - b[1]).abs() <= tolerance
}

#[test]
fn a_constant_load_is_the_same_at_all_angles() {
    let duty = Duty { force: [1.0, 2.0], moment: [3.0, 4.0], speed: 5.0 };
    let cycle = DutyCycle::constant(duty, TAU, 7.0);
    assert_eq!((cycle.at(-3.0), cycle.at(100.0)), (duty, duty));
    assert_eq!((cycle.period(), cycle.angular_speed()), (TAU, 7.0));
    assert!(cycle.turning().is_none());
}

#[test]
fn derivatives_of_the_crank_are_those_of_its_place() {
    let place = |angle: f64| LINKAGE.radius * angle.cos() + LINKAGE.rod_length * LINKAGE.inclination(angle).cos();
    let h = 1e-4;
    for k in 0..50 {
        let angle = 0.31 * f64::from(k);
        let first = (place(angle + h) - place(angle - h)) / (2.0 * h);
        let second = (place(angle + h) - 2.0 * place(angle) + place(angle - h)) / (h * h);
        let rate = (LINKAGE.inclination(angle + h) - LINKAGE.inclination(angle - h)) / (2.0 * h);
        assert!((LINKAGE.piston_velocity(angle, 1.0) - first).abs() < 1e-9);
        assert!((LINKAGE.piston_acceleration(angle, 1.0) - second).abs() < 1e-7);
        assert!((LINKAGE.inclination_rate(angle) - rate).abs() < 1e-8);
    }
}

#[test]
fn the_axes_of_frames_are_where_they_should_be() {
    let turning = Turning { speed: 100.0, rod: Some(LINKAGE) };
    let angle: f64 = 1.1;
    // The rod points from the pin to the small end on the axis of the cylinder.
    let (sin, cos) = angle.sin_cos();
    let small_end = LINKAGE.radius * cos + (LINKAGE.rod_length.powi(2) - (LINKAGE.radius * sin).powi(2)).sqrt();
    let rod = [small_end - LINKAGE.radius * cos, -LINKAGE.radius * sin];
    let along = turning.to_shell(rod, ForceAxes::Cylinder, angle);
    assert!(near(along, [LINKAGE.rod_length, 0.0], 1e-14), "{along:?}");
    // The throw lies along x of the pin's frame.
    let throw = turning.to_shell([LINKAGE.radius * cos, LINKAGE.radius * sin], ForceAxes::Cylinder, angle);
    assert!(near(turning.from_shell(throw, ForceAxes::Pin, angle), [LINKAGE.radius, 0.0], 1e-14));
    let at_rest = Turning { speed: -1.0, rod: None };
    assert_eq!(at_rest.to_shell([1.0, 2.0], ForceAxes::Cylinder, angle), [1.0, 2.0]);
    assert!(near(at_rest.to_shell([1.0, 0.0], ForceAxes::Pin, FRAC_PI_2), [0.0, -1.0], 1e-15));
}

#[test]
fn a_load_given_in_three_frames_is_one_load() {
    for rod in [None, Some(LINKAGE)] {
        let turning = Turning { speed: 200.0, rod };
        let angle = |k: usize| 2.0 * TAU * (k as f64 + 0.3 * (k as f64).sin()) / 90.0;
        let cycles = [ForceAxes::Shell, ForceAxes::Cylinder, ForceAxes::Pin].map(|frame| {
            let point = |k: usize| {
                let (force, moment) = ([1e4 * angle(k).cos(), 3e3], [10.0, 20.0 * angle(k).sin()]);
                let [force, moment] = [force, moment].map(|vector| turning.from_shell(vector, frame, angle(k)));
                LoadPoint { angle: angle(k), force, moment }
            };
            let points: Vec<_> = (0..90).map(point).collect();
            DutyCycle::of_table(&points, 2.0 * TAU, frame, turning).expect("a load")
        });
        for k in 0..400 {
            let [shell, cylinder, pin] = [0, 1, 2].map(|n: usize| cycles[n].at(0.05 * f64::from(k)));
            for other in [cylinder, pin] {
                assert!(near(shell.force, other.force, 1e-12 * 1e4), "{shell:?} {other:?}");
                assert!(near(shell.moment, other.moment, 1e-12 * 20.0), "{shell:?} {other:?}");
                assert_eq!(shell.speed, other.speed);
            }
        }
    }
}

#[test]
fn a_journal_that_turns_the_other_way_mirrors_the_load() {
    let [forth, back] = [209.0, -209.0].map(|speed| DutyCycle::of_big_end(crank(), speed));
    assert_eq!(forth.angular_speed(), back.angular_speed());
    for k in 0..100 {
        let angle = 0.13 * f64::from(k);
        let [f, b] = [forth.at(angle), back.at(angle)];
        assert_eq!(f.speed, -b.speed);
        assert!(near(f.force, [b.force[0], -b.force[1]], 1e-9), "{angle}: {f:?} {b:?}");
    }
}

#[test]
fn the_film_of_a_big_end_carries_what_the_rod_exerts() {
    let cycle = DutyCycle::of_big_end(crank(), 209.0);
    let peak = cycle.at(0.2);
    // The gas presses the shell on the pin at the side of the small end: the film pushes the shell towards it.
    assert!(peak.force[0] > 7e4 && peak.force[1].abs() < 0.1 * peak.force[0], "{peak:?}");
    let on_pin = crank().force_on_pin(0.2, 209.0);
    assert!((peak.force[0].hypot(peak.force[1]) - on_pin[0].hypot(on_pin[1])).abs() < 1e-9);
}

fn throw(angle: f64, share: f64) -> Throw {
    Throw { angle, share, web_mass: 0.0 }
}

#[test]
fn main_bearings_carry_what_the_pins_are_pressed_with() {
    let big_end = DutyCycle::of_big_end(crank(), 209.0);
    let turning = big_end.turning().expect("a crank");
    let main = |throws: Vec<Throw>| DutyCycle::of_main(crank(), throws, 209.0);
    let [left, right] = [0.3, 0.7].map(|share| main(vec![throw(0.0, share)]));
    let between = main(vec![throw(0.0, 0.5), throw(TAU, 0.5)]);
    for k in 0..100 {
        let angle = 0.13 * f64::from(k);
        // Both main bearings together are pressed as the pin is.
        let pin = turning.from_shell(big_end.at(angle).force, ForceAxes::Cylinder, angle);
        let [l, r] = [&left, &right].map(|main| main.at(angle));
        let both = [l.force[0] + r.force[0], l.force[1] + r.force[1]];
        assert!(near(both, [-pin[0], -pin[1]], 1e-9), "{angle}: {both:?} {pin:?}");
        assert_eq!((l.speed, l.moment), (209.0, [0.0; 2]));
        // Throws that fire a turn apart make a load that repeats in a turn.
        assert!(near(between.at(angle).force, between.at(angle + TAU).force, 1e-8), "{angle}");
    }
    let back = DutyCycle::of_main(crank(), vec![throw(0.0, 0.3)], -209.0);
    let (forth, back) = (left.at(1.0), back.at(1.0));
    assert!(near(forth.force, [back.force[0], -back.force[1]], 1e-9) && back.speed == -209.0);
}

#[test]
fn counterweights_balance_a_rotating_mass() {
    let rotating = Crank {
        reciprocating_mass: 0.0,
        gas: GasPressure::Curve(PressureCurve { peak: 0.0, angle: 0.0, sharpness: 1.0, period: TAU }),
        ..crank()
    };
    let main = |web_mass: f64| {
        let throws = vec![Throw { web_mass, ..throw(0.4, 0.5) }];
        DutyCycle::of_main(rotating.clone(), throws, 100.0).at(1.0).force
    };
    assert!(near(main(-2.025), [0.0; 2], 1e-9));
    let radius: f64 = 0.5 * 2.025 * 0.0625 * 1e4;
    assert!(near(main(0.0), [radius * 0.6f64.cos(), radius * 0.6f64.sin()], 1e-9));
}

#[test]
fn a_load_with_a_frequency_of_its_own_goes_by_that() {
    let pulsating = Harmonic { order: 1.0, cos: [2.0, 0.0, 0.0, 0.0], sin: [0.0; 4] };
    let constant = Harmonic { order: 0.0, cos: [0.0, 3.0, 0.0, 0.0], sin: [0.0; 4] };
    let share = |harmonic: Harmonic, speed: f64| {
        let turning = Turning { speed, rod: None };
        let cycle = DutyCycle::of_harmonics(vec![harmonic], TAU, ForceAxes::Shell, turning).at_frequency(50.0);
        assert_eq!((cycle.angular_speed(), cycle.at(1.0).speed), (50.0, speed));
        cycle.summary().half_speed_share
    };
    // A constant load on a journal at rest, and half of a pulsation on one that turns twice as often: that half turns
    // with the oil.
    assert!((share(constant, 0.0) - 1.0).abs() < 1e-12);
    let mean_magnitude = 2.0 * 2.0 / std::f64::consts::PI;
    assert!((share(pulsating, 100.0) - 1.0 / mean_magnitude).abs() < 1e-6);
    for (harmonic, speed) in [(pulsating, 0.0), (pulsating, 50.0), (pulsating, 97.3), (constant, 33.0)] {
        assert!(share(harmonic, speed) < 1e-12, "{speed}");
    }
}

#[test]
fn the_load_at_half_the_speed_of_the_journal_is_found() {
    let turns = |order: f64, sense: f64, speed: f64| {
        let rotating = Harmonic { order, cos: [2.0, 0.0, 0.0, 0.0], sin: [0.0, 2.0 * sense, 0.0, 0.0] };
        let turning = Turning { speed, rod: None };
        let cycle = DutyCycle::of_harmonics(vec![rotating], 2.0 * TAU, ForceAxes::Shell, turning);
        cycle.summary().half_speed_share
    };
    assert!((turns(0.5, 1.0, 30.0) - 1.0).abs() < 1e-12);
    assert!((turns(0.5, -1.0, -30.0) - 1.0).abs() < 1e-12);
    for (order, sense) in [(0.0, 1.0), (0.5, -1.0), (1.0, 1.0), (1.5, 1.0)] {
        assert!(turns(order, sense, 30.0) < 1e-12, "{order}");
    }
}
