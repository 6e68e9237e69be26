//! Conductances of a ring.

use oilwedge_heat::{BushRing, BushShape};

const SHAPE: BushShape = BushShape {
    inner_radius: 0.05,
    outer_radius: 0.1,
    length: 0.08,
    conductivity: 250.0,
    transfer: 80.0,
    ambient: 313.15,
};

/// Closed form; differences in r agree to 2e-6. Rows for cos(2 pi m z/L), columns n.
#[test]
fn conductances_of_the_closed_form() {
    let expected = [
        (0, [156.528_095_736_381_12, 21_987.885_171_031_42, 41_698.840_645_549_644]),
        (1, [3_100.470_957_613_815, 22_503.875_479_365_59, 41_982.436_213_139_794]),
        (2, [8_858.468_677_494_198, 23_997.486_743_762_925, 42_823.432_304_607_195]),
        (5, [24_951.839_334_157_467, 32_814.063_380_423_42, 48_347.115_661_482_98]),
    ];
    for (n, row) in expected {
        for (m, expected) in row.into_iter().enumerate() {
            let value = SHAPE.conductances(n, 2 * m)[n];
            assert!((value / expected - 1.0).abs() < 1e-10, "{n} {m}: {value} for {expected}");
        }
    }
}

#[test]
fn conductance_of_a_short_wave_is_that_of_its_length() {
    for n in [0, 3, 60] {
        let wave = std::f64::consts::PI * 200.0 / SHAPE.length;
        let (value, thick) =
            (SHAPE.conductances(n, 200)[n], SHAPE.conductivity * wave.hypot(n as f64 / SHAPE.inner_radius));
        assert!((value / thick - 1.0).abs() < 2e-3, "{n}: {value} for {thick}");
    }
}

#[test]
fn temperature_is_the_sum_of_the_modes() {
    let ring = BushRing::new(SHAPE, 2, 1);
    assert_eq!(ring.modes(), 10);
    let mut modes = vec![0.0; 10];
    (modes[0], modes[3], modes[8]) = (5.0, 2.0, 1.0);
    let (angle, along): (f64, f64) = (0.7, 0.2);
    let axial = (std::f64::consts::PI * (along + 0.5)).cos();
    let expected = 313.15 + 5.0 + 2.0 * angle.cos() * axial + (2.0 * angle).sin();
    assert!((ring.temperature(&modes, angle, along) - expected).abs() < 1e-12);
}

/// Numbers that no scene should have end in a conductance that is none, and do not go on for ever.
#[test]
fn conductances_of_hostile_rings_end() {
    let ring = |length: f64, inner_radius: f64, transfer: f64| BushShape {
        inner_radius,
        outer_radius: 2.0 * inner_radius,
        length,
        conductivity: 45.0,
        transfer,
        ambient: 300.0,
    };
    for (length, radius, transfer) in [
        (f64::NAN, 0.05, 80.0),
        (0.08, f64::NAN, 80.0),
        (0.08, 0.05, f64::NAN),
        (1e-22, 0.05, 80.0),
        (0.08, 1e12, 80.0),
        (1e12, 1e-12, 80.0),
        (0.0, 0.05, 80.0),
    ] {
        for (n, m) in [(0, 0), (3, 0), (0, 1), (24, 4)] {
            let conductance = ring(length, radius, transfer).conductances(n, m)[n];
            assert!(conductance.is_nan() || conductance >= 0.0, "{length} {radius} {transfer}: {conductance}");
        }
    }
}

/// The plate and the ring agree where the one takes over from the other.
#[test]
fn short_waves_see_a_plate() {
    let shape = |length: f64| BushShape {
        inner_radius: 0.05,
        outer_radius: 0.0501,
        length,
        conductivity: 45.0,
        transfer: 80.0,
        ambient: 300.0,
    };
    let [ring, plate] =
        [1.001, 0.999].map(|part| shape(std::f64::consts::PI * 0.05 / 1e4 * part).conductances(3, 1)[3]);
    assert!((ring / plate - 0.999 / 1.001).abs() < 1e-4, "{ring} {plate}");
}
