//! Balances of a load: the load that a result reports for a position leads back to that position.

use oilwedge_study::RunOptions;
use oilwedge_tests::scenes::{table, variant};

use super::films::{NO_BARS, answer, quantity, set};

fn scene(model: &str, edit: impl FnOnce(&mut toml::Table)) -> oilwedge_scene::Scene {
    variant("01_plain_ring", |scene| {
        set(scene, "bearing", "film_start", "0 deg");
        set(scene, "cavitation", "model", model);
        edit(scene);
    })
}

#[test]
fn a_reported_load_gives_its_position_back() {
    for options in [RunOptions::default(), NO_BARS] {
        for model in ["none", "guembel", "reynolds", "jfo"] {
            let there = answer(&scene(model, |_| ()), &options);
            let [load, angle] = ["load", "load_angle"].map(|name| quantity(&there, name).value);
            let found = answer(
                &scene(model, |scene| {
                    table(scene, "journal").retain(|key, _| key == "speed");
                    set(scene, "load", "force", format!("{load} N"));
                    set(scene, "load", "angle", format!("{angle} deg"));
                }),
                &options,
            );
            let eccentricity = quantity(&found, "eccentricity");
            let off = (eccentricity.value - 0.6).abs();
            let turned = quantity(&found, "min_film_angle").value - 180.0;
            // A mass-conserving film keeps a trace of the way on which its forms were chosen: a fifth of its bar
            // (4.9e-4) at most.
            let (apart, angle) = if model == "jfo" { (1e-4, 0.03) } else { (1e-8, 1e-6) };
            assert!(off < apart && turned.abs() < angle, "{model}: {off:e}, {turned:e}");
            assert_eq!(eccentricity.error().is_some(), options.bars);
            let [there, found] = [&there, &found].map(|result| quantity(result, "load").error());
            if let (Some(there), Some(found)) = (there, found) {
                assert!(found < 1e-3 * there, "the load is given now: {there:e}, {found:e}");
            }
        }
    }
}

/// The bar of the position is that of the load through the stiffness: as far as the load may be off, the journal may.
#[test]
fn the_bar_of_the_position_is_that_of_the_load() {
    let result = |edit: &dyn Fn(&mut toml::Table)| answer(&scene("reynolds", edit), &RunOptions::default());
    let at = |eccentricity: f64| result(&|scene| set(scene, "journal", "eccentricity", eccentricity));
    let [less, there, more] = [0.599, 0.6, 0.601].map(at);
    let load = |result| quantity(result, "load").value;
    let by_eccentricity = (load(&more) - load(&less)) / 0.002;
    let [force, angle] = ["load", "load_angle"].map(|name| quantity(&there, name).value);
    let found = result(&|scene| {
        table(scene, "journal").retain(|key, _| key == "speed");
        set(scene, "load", "force", format!("{force} N"));
        set(scene, "load", "angle", format!("{angle} deg"));
    });
    let wanted = quantity(&there, "load").error().expect("a bar") / by_eccentricity;
    let parts = quantity(&found, "eccentricity").bar.expect("a bar");
    // The bar across the load counts too.
    assert!(parts.position > 0.9 * wanted && parts.position < 4.0 * wanted);
    assert_eq!(parts.position, parts.total());
}
