//! Capabilities beside each other: what the rows cover, and the rows with rigid walls at rest; the
//! full tier solves the others.

use oilwedge_tests::capabilities::{COLUMNS, ROWS, has, pairs, solves_as_its_twin};

#[test]
fn each_pair_is_met_by_a_row() {
    for row in ROWS {
        let is_row = row.iter().zip(COLUMNS).all(|(value, column)| column.contains(value));
        assert!(is_row && ROWS.iter().filter(|other| **other == row).count() == 1, "{row:?}");
    }
    for pair in pairs() {
        let is_met = ROWS.iter().any(|row| has(row, &pair));
        assert!(is_met, "{pair:?}");
    }
}

#[test]
fn rigid_bearings_at_rest_are_solved_as_their_twins() {
    let rows = ROWS.iter().filter(|row| row[2] == "rigid" && !["orbit", "crankshaft"].contains(&row[1]));
    rows.for_each(solves_as_its_twin);
}
