//! Points across the film, and the profiles of flow and heat at them.

use oilwedge_heat::{COUNTS, LayerProfile, Layers};

#[test]
fn sums_over_points_are_integrals() {
    for count in COUNTS {
        let layers = Layers::new(count).expect("a count");
        for degree in 0..2 * count {
            let values: Vec<f64> = layers.points.iter().map(|x| x.powi(degree as i32)).collect();
            let mean: f64 = layers.weights.iter().zip(&values).map(|(weight, value)| weight * value).sum();
            let error = mean - 1.0 / (degree + 1) as f64;
            assert!(error.abs() < 1e-15, "{count} {degree}: {error}");
        }
        for degree in 0..=count {
            let values: Vec<f64> = layers.points.iter().map(|x| x.powi(degree as i32)).collect();
            for (row, end) in layers.integrals.iter().zip(&layers.points) {
                let sum: f64 = row.iter().zip(&values).map(|(weight, value)| weight * value).sum();
                assert!((sum - end.powi(degree as i32 + 1) / (degree + 1) as f64).abs() < 1e-14);
            }
            let slopes = layers.slopes.iter().zip(&layers.gauss_weights);
            let slope = |row: &[f64]| row.iter().zip(&values).map(|(slope, value)| slope * value).sum::<f64>();
            let rise: f64 = slopes.map(|(row, weight)| weight * slope(row)).sum();
            assert!((rise - if degree == 0 { 0.0 } else { 1.0 }).abs() < 1e-13);
        }
    }
    assert_eq!(Layers::new(5), None);
}

#[test]
fn profile_of_one_viscosity_is_that_of_couette_and_poiseuille() {
    for count in COUNTS {
        let layers = Layers::new(count).expect("a count");
        let profile = LayerProfile::of(&layers, &vec![0.02; count + 1]);
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-13 * 50.0, "{value} {expected}");
        near(profile.f0, 50.0);
        near(profile.f1, 25.0);
        near(profile.f2, 50.0 / 12.0);
        near(profile.drag_share(), 0.5);
        for (l, (eta, weight)) in layers.points.iter().zip(&layers.weights).enumerate() {
            near(profile.drag[l], weight * 2.0 * eta);
            near(profile.driven[l], weight * 6.0 * eta * (1.0 - eta));
            near(profile.shear_friction[l], *weight);
            near(profile.driven_friction[l], weight * 12.0 * (eta - 0.5).powi(2));
            near(profile.cross_friction[l], weight * (eta - 0.5));
        }
    }
}

/// Viscosity that falls by a factor of e across the film: shares sum to what they distribute, and integrals are near
/// those of the exponential.
#[test]
fn shares_of_layers_sum_to_the_whole() {
    for count in COUNTS {
        let layers = Layers::new(count).expect("a count");
        let viscosities: Vec<f64> = layers.points.iter().map(|eta| 0.02 * (-eta).exp()).collect();
        let profile = LayerProfile::of(&layers, &viscosities);
        for (shares, sum) in [
            (profile.drag, 1.0),
            (profile.driven, 1.0),
            (profile.shear_friction, 1.0),
            (profile.driven_friction, 1.0),
            (profile.cross_friction, 0.0),
        ] {
            assert!((shares.iter().sum::<f64>() - sum).abs() < 1e-15, "{count}: {shares:?}");
        }
        let e = std::f64::consts::E;
        let (f0, f1) = (50.0 * (e - 1.0), 50.0);
        let f2 = 50.0 * (e - 2.0) - f1 * f1 / f0;
        let tolerance = [6e-2, 3e-4, 1e-6, 1e-12, 1e-14][COUNTS.iter().position(|c| *c == count).expect("a count")];
        for (value, exact) in [(profile.f0, f0), (profile.f1, f1), (profile.f2, f2)] {
            assert!((value / exact - 1.0).abs() < tolerance, "{count}: {value} for {exact}");
        }
    }
}
