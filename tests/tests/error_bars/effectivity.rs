//! What smooth films tell of their errors is true: the estimate against the error itself, known from a far finer mesh.

use oilwedge_scene::Scene;
use oilwedge_study::RunOptions;
use oilwedge_tests::{SPEED, order, plain_film, ring_system};

use super::films::{Judged, answer, bar, constant, drawn, quantity, set};

/// A film on a mesh of this size [mm].
type BySize<'a> = &'a dyn Fn(f64) -> Scene;

/// A smooth film.
fn ring(eccentricity: f64) -> impl Fn(f64) -> Scene {
    move |size| drawn("09_drawn_ring", size, |scene| set(scene, "journal", "eccentricity", eccentricity))
}

fn hole_fed(eccentricity: f64) -> impl Fn(f64) -> Scene {
    move |size| {
        drawn("04_flexpde_ring", size, |scene| {
            constant(scene);
            set(scene, "journal", "eccentricity", eccentricity);
        })
    }
}

/// `J(p3) - J(p2)` over the true error of `J(p2)`, along the load.
#[test]
fn the_estimate_is_the_error_of_the_quadratic_load() {
    let films: [(&str, BySize); 3] =
        [("ring, eps 0.6", &ring(0.6)), ("ring, eps 0.8", &ring(0.8)), ("hole-fed ring, eps 0.8", &hole_fed(0.8))];
    for (name, scene) in films {
        let exact = Judged::of_scene(&scene(1.5)).cubic_load().magnitude();
        for size in [8.0, 6.0, 4.0] {
            let judged = Judged::of_scene(&scene(size));
            let eta = judged.cubic_load().magnitude() - judged.quadratic_load().magnitude();
            let effectivity = eta / (exact - judged.quadratic_load().magnitude());
            assert!(judged.unknowns() > 500);
            assert!((0.8..1.2).contains(&effectivity), "{name}: {effectivity}");
            // The sum of the shares is that difference but for the rules of quadrature.
            let [along, _] = judged.error.eta();
            assert!((along / eta - 1.0).abs() < 0.01, "{along:e} {eta:e}");
        }
    }
}

/// The cubic load gains six orders; five leave room for levels that are not yet asymptotic.
#[test]
fn the_reported_load_of_a_smooth_film_converges_at_order_five_at_least() {
    let problem = plain_film(0.1, 0.5, 1.0, SPEED);
    let load = |rows| Judged::of(problem.clone(), &ring_system(3 * rows, rows, 0.1, None)).cubic_load();
    let exact = load(48).magnitude();
    let errors: Vec<f64> = [4, 8, 16].map(|rows| (load(rows).magnitude() - exact).abs()).into();
    assert!(order(&errors) > 5.0, "{errors:?}");
}

#[test]
fn a_hole_fed_ring_is_known_to_a_millionth_on_less_than_3000_unknowns() {
    let scene = hole_fed(0.6);
    let exact = Judged::of_scene(&scene(1.2)).cubic_load().magnitude();
    let judged = Judged::of_scene(&scene(6.5));
    assert!(judged.unknowns() < 3000, "{}", judged.unknowns());
    let error = judged.cubic_load().magnitude() / exact - 1.0;
    assert!(error.abs() < 1e-6, "{error:e}");
}

/// Every bar of the report holds, against a mesh with a tenth of the size: smooth films, and one that breaks.
#[test]
fn the_bars_of_a_report_hold() {
    let cavitated = |size| drawn("12_flexpde_shell_cavitated", size, |_| ());
    let films: [(BySize, [f64; 2]); 3] =
        [(&ring(0.8), [6.0, 1.5]), (&hole_fed(0.6), [6.0, 1.5]), (&cavitated, [5.0, 0.9])];
    for (scene, [coarse, fine]) in films {
        let [coarse, fine] = [coarse, fine].map(|size| answer(&scene(size), &RunOptions::default()));
        for found in &coarse.quantities {
            let (value, error) = bar(&coarse, &found.name);
            let exact = quantity(&fine, &found.name);
            let own = exact.error().unwrap_or_else(|| panic!("{} has no bar", found.name));
            let off = (value - exact.value).abs();
            // Rounding of numbers that are given.
            let rounding = 1e-9 * value.abs();
            assert!(off <= error + own + rounding, "{}: {off:e}, bar {error:e}", found.name);
        }
    }
}
