//! Text as a scene: it is refused with complaints that point into it, or it is a scene without a number that is none.

#![no_main]

use std::alloc::System;
use std::path::Path;

use cap::Cap;
use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use oilwedge_fuzz::{bounded, mutate_words};
use oilwedge_campaign::sweep::Sweep;
use oilwedge_scene::{MeshSource, Scene, SceneError, TemperatureLaw, Tolerance, Viscosity};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that reading may take for each byte of a scene, most of them in the tree of its TOML.
const BYTES_PER_BYTE: usize = 256;
/// Sweeps of more cases are not read case by case.
const MOST_CASES: usize = 16;

fuzz_target!(|text: &str| {
    bounded(&ALLOCATOR, BYTES_PER_BYTE * text.len(), || {
        match oilwedge_study::parse(text, Path::new("scenes/fuzz.toml")) {
            Ok(scene) => check(&scene),
            Err(error) => refused(&error, text),
        }
    });
});

fn refused(error: &SceneError, text: &str) {
    assert!(!error.to_string().is_empty());
    let (SceneError::Complaints { complaints, .. } | SceneError::Syntax { complaints, .. }) = error else {
        panic!("{error}");
    };
    assert!(!complaints.is_empty());
    for complaint in complaints {
        assert!(!complaint.message.is_empty() && !complaint.help.is_empty());
        if let Some(span) = &complaint.span {
            assert!(text.get(span.clone()).is_some(), "{span:?} of {}", text.len());
        }
    }
}

fn check(scene: &Scene) {
    let mut told = scene.clone();
    told.title.clear();
    told.text.clear();
    told.mesh = MeshSource::Drawing { size: None };
    told.feeds.iter_mut().for_each(|feed| feed.group.clear());
    told.sweep = None;
    if let Some(Tolerance::ByName(targets)) = &mut told.tolerance {
        targets.iter_mut().for_each(|target| target.quantity.clear());
    }
    if let Viscosity::ByTemperature(TemperatureLaw::Grade(name)) = &mut told.oil.viscosity {
        name.clear();
    }
    let told = format!("{told:?}");
    assert!(!told.contains("NaN") && !told.contains("inf"), "{told}");
    let few = scene.sweep.as_ref().is_some_and(|plan| plan.cases() <= MOST_CASES);
    if few && let Err(error) = Sweep::of(scene) {
        assert!(!error.to_string().is_empty());
    }
}

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    match seed.is_multiple_of(2) {
        true => mutate_words(data, size, max_size, seed / 2),
        false => None,
    }
    .unwrap_or_else(|| fuzzer_mutate(data, size, max_size))
});
