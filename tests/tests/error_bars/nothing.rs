//! No bars where none are asked for, and no nonsense where there is nothing to be uncertain of.

use oilwedge_study::RunOptions;
use oilwedge_tests::scenes::variant;

use super::films::{NO_BARS, answer, bar, set};

#[test]
fn without_bars_nothing_is_estimated_and_nothing_is_done() {
    for name in ["01_plain_ring", "09_drawn_ring", "12_flexpde_shell_cavitated", "14_starved_pad", "16_loaded_shell"] {
        let result = answer(&variant(name, |_| ()), &NO_BARS);
        assert!(!result.bars && result.levels.is_empty() && result.counts.bars == 0);
        assert!(result.tail.timing_s.iter().all(|(part, _)| part != "bars"));
        for quantity in &result.quantities {
            assert!(quantity.bar.is_none(), "{}", quantity.name);
        }
    }
}

/// With bars each quantity of a film that the mesh resolves has one.
#[test]
fn every_quantity_has_a_bar() {
    for name in [
        "01_plain_ring",
        "02_flexpde_shell",
        "06_flexpde_as_printed",
        "07_grooved_liner",
        "12_flexpde_shell_cavitated",
        "14_starved_pad",
        "15_squeezed_ring",
        "16_loaded_shell",
    ] {
        let result = answer(&variant(name, |_| ()), &RunOptions::default());
        assert!(result.bars && result.counts.bars > 0);
        for quantity in &result.quantities {
            let bar = quantity.bar.unwrap_or_else(|| panic!("{name}: {}", quantity.name));
            assert!(bar.total() >= 0.0);
        }
    }
}

/// A centred journal without a feed makes no pressure: nothing is uncertain, and nothing is refined for.
#[test]
fn a_film_of_nothing_is_certain() {
    for scene in ["01_plain_ring", "09_drawn_ring"] {
        for model in [None, Some("guembel"), Some("reynolds")] {
            let result = answer(
                &variant(scene, |scene| {
                    set(scene, "journal", "eccentricity", 0.0);
                    if let Some(model) = model {
                        set(scene, "cavitation", "model", model);
                    }
                }),
                &RunOptions::default(),
            );
            assert!(result.levels.len() <= 1, "{scene} {model:?}: {:?}", result.levels);
            // Where nothing presses and nothing sucks, full film and cavity are the same.
            let undetermined = ["cavity_share", "film_fraction_min", "friction_cavity_power"];
            let asked = result.quantities.iter();
            for quantity in asked.filter(|quantity| !undetermined.contains(&&*quantity.name)) {
                let error = quantity.error().unwrap_or_else(|| panic!("{scene} {model:?}: {}", quantity.name));
                let scale = match quantity.unit() {
                    "N" => 1e4,
                    "Pa" => 1e6,
                    "m3/s" => 1e-6,
                    _ => 1.0,
                };
                assert!(error < 1e-9 * scale, "{scene} {model:?}: {} ± {error:e}", quantity.name);
            }
        }
    }
}

/// Two holes face each other: what they carry cancels, but for what the mesh is not symmetric.
#[test]
fn a_load_that_cancels_is_no_reason_to_refine_for_ever() {
    let result = answer(
        &variant("10_drawn_liner", |scene| {
            scene.remove("mesh");
            set(scene, "journal", "eccentricity", 0.0);
            let feeds: toml::Table = "[[feed]]\ngroup = \"a\"\npressure = \"3 bar\"\n\
                hole = { diameter = \"10 mm\", angle = \"30 deg\" }\n[[feed]]\ngroup = \"b\"\npressure = \"3 bar\"\n\
                hole = { diameter = \"10 mm\", angle = \"210 deg\" }"
                .parse()
                .expect("TOML");
            scene.extend(feeds);
        }),
        &RunOptions::default(),
    );
    let (load, error) = bar(&result, "load");
    assert!(load <= error && error < 0.01, "{load:e} ± {error:e}");
    assert!(result.levels.len() <= 3, "{:?}", result.levels);
    let (_, error) = bar(&result, "pressure_max");
    assert!(error < 1e3);
}

/// No load: the journal of a plain ring stands in the middle, and that is no reason to refine for ever.
#[test]
fn no_load_is_certain() {
    for scene in ["01_plain_ring", "09_drawn_ring"] {
        let result = answer(
            &variant(scene, |scene| {
                oilwedge_tests::scenes::table(scene, "journal").retain(|key, _| key == "speed");
                set(scene, "load", "force", "0 N");
                set(scene, "load", "angle", "270 deg");
            }),
            &RunOptions::default(),
        );
        let eccentricity = result.by_name("eccentricity").expect("an eccentricity");
        assert!(eccentricity.value < 1e-9, "{scene}: {:e}", eccentricity.value);
        assert!(result.levels.len() <= 1, "{scene}: {:?}", result.levels);
    }
}
