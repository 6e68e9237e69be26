//! Text as a scene, of a bearing or of a crankshaft: it is refused with complaints that point into it, or it is a scene
//! without a number that is none.

#![no_main]

use std::alloc::System;
use std::path::Path;

use cap::Cap;
use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use oilwedge_campaign::sweep::Sweep;
use oilwedge_fuzz::{bounded, mutate_words};
use oilwedge_scene::{Scene, SceneError, ShaftScene};

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that reading may take for each byte of a scene, most of them in the tree of its TOML.
const BYTES_PER_BYTE: usize = 256;
/// Sweeps of more cases are not read case by case.
const MOST_CASES: usize = 16;

fuzz_target!(|text: &str| {
    bounded(&ALLOCATOR, BYTES_PER_BYTE * text.len(), || {
        let path = Path::new("scenes/fuzz.toml");
        match oilwedge_study::parse(text, path) {
            Ok(scene) => check(&scene),
            Err(SceneError::Crankshaft { .. }) => match ShaftScene::parse(text, path) {
                Ok(scene) => finite(&ShaftScene { sweep: None, ..scene }),
                Err(error) => refused(&error, text),
            },
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

/// No number of a scene is none; the stiffness of a rigid support alone is infinite. What stands in quotes is the
/// user's text. Axes of a sweep may have more numbers than can be told in bounded memory.
fn finite(scene: &impl std::fmt::Debug) {
    let told = format!("{scene:?}").replace("stiffness: inf", "stiffness: rigid");
    let told = told.replace(r"\\", "").replace(r#"\""#, "");
    for numbers in told.split('"').step_by(2) {
        let mut words = numbers.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
        assert!(!words.any(|word| word == "NaN" || word == "inf"), "{numbers}");
    }
}

fn check(scene: &Scene) {
    finite(&Scene {
        sweep: None,
        ..scene.clone()
    });
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
