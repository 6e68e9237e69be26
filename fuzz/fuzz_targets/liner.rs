//! Text as a scene whose liner is drawn: it is meshed, coarsely.

#![no_main]

use std::f64::consts::TAU;
use std::path::Path;

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use oilwedge_fuzz::mutate_words;
use oilwedge_mesh::Quality;
use oilwedge_scene::MeshSource;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;

/// Edges along the axis; more would take too long.
const ACROSS: f64 = 4.0;
/// Scenes with more features are not meshed.
const MOST_FEEDS: usize = 3;
/// Liners and grooves that are longer than this many times their width are not meshed: their rims alone have 1e5 edges.
const SLENDEREST: f64 = 50.0;

fn is_slender(scene: &Scene) -> bool {
    let ratio = |a: f64, b: f64| a.max(b) / a.min(b);
    let radius = scene.bearing.radius();
    let grooves = scene.feeds.iter().filter_map(|feed| feed.groove);
    let mut ratios = grooves.map(|groove| {
        let arc = groove.arc.map_or(TAU, |arc| arc.to - arc.from);
        ratio(radius * arc, groove.width)
    });
    ratio(radius, scene.bearing.length) > SLENDEREST || ratios.any(|ratio| ratio > SLENDEREST)
}

fuzz_target!(|text: &str| {
    let Ok(mut scene) = oilwedge_study::parse(text, Path::new("fuzz.toml")) else {
        return;
    };
    let MeshSource::Drawing { size } = scene.mesh else {
        return;
    };
    if scene.feeds.len() > MOST_FEEDS || is_slender(&scene) {
        return;
    }
    let coarse = (scene.bearing.length / ACROSS).max(scene.bearing.radius() / ACROSS);
    scene.mesh = MeshSource::Drawing {
        size: Some(size.unwrap_or(coarse).max(coarse)),
    };
    scene.tolerance = None;
    match compile(&scene).and_then(|model| model.first_mesh()) {
        Ok(made) => assert!(Quality::of(&made.mesh).area.is_finite()),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed.is_multiple_of(2) {
        true => mutate_words(data, size, max_size, seed / 2),
        false => None,
    }
    .unwrap_or_else(|| fuzzer_mutate(data, size, max_size))
});
