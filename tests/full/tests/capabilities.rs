//! Capabilities beside each other: the rows that take seconds.

use oilwedge_tests::capabilities::{ROWS, solves_as_its_twin};

#[test]
fn walls_at_rest_are_solved_as_their_twins() {
    let rows = ROWS.iter().filter(|row| row[2] != "rigid" && !["orbit", "crankshaft"].contains(&row[1]));
    rows.for_each(solves_as_its_twin);
}

#[test]
fn orbits_are_solved_as_their_twins() {
    ROWS.iter().filter(|row| row[1] == "orbit").for_each(solves_as_its_twin);
}

#[test]
fn crankshafts_are_solved_as_their_twins() {
    ROWS.iter().filter(|row| row[1] == "crankshaft").for_each(solves_as_its_twin);
}
