//! The drawing of the crates in `docs/architecture.md` is that of their manifests.

use oilwedge_full::crate_arrows::{DRAWING, arrows, drawing, drawn};
use oilwedge_tests::program::repository;

#[test]
fn the_drawing_of_the_crates_is_up_to_date() {
    let kept = std::fs::read_to_string(repository().join(DRAWING)).expect("a drawing");
    assert!(kept == drawing(), "{DRAWING} is old: cargo run --release -p oilwedge-full -- crates");
}

#[test]
fn arrows_that_others_imply_are_not_drawn() {
    let arrows = arrows();
    let drawn = drawn(&arrows);
    assert!(arrows["fem"].contains("mesh") && drawn.contains(&("fem", "mesh")));
    assert!(arrows["reynolds"].contains("mesh") && !drawn.contains(&("reynolds", "mesh")));
}
