//! Capabilities beside each other: what the rows cover, what is refused, and the rows with rigid walls at rest; the
//! full tier solves the others.

use oilwedge_tests::capabilities::{COLUMNS, REFUSED, ROWS, has, is_refused, pairs, solves_as_its_twin};

#[test]
fn each_pair_is_met_by_a_row_or_refused() {
    for row in ROWS {
        let is_row = row.iter().zip(COLUMNS).all(|(value, column)| column.contains(value));
        assert!(is_row && ROWS.iter().filter(|other| **other == row).count() == 1, "{row:?}");
    }
    for pair in pairs() {
        let is_met = ROWS.iter().any(|row| has(row, &pair));
        let is_refused = REFUSED.iter().any(|([one, other], _)| pair == [*other, *one] || pair == [*one, *other]);
        assert!(is_met != is_refused, "{pair:?}: by a row {is_met}, refused {is_refused}");
    }
}

#[test]
fn refused_pairs_have_one_message_with_a_way_out() {
    for (pair, words) in REFUSED {
        is_refused(pair, words).unwrap_or_else(|told| panic!("{pair:?}: {told}"));
    }
}

#[test]
fn rigid_bearings_at_rest_are_solved_as_their_twins() {
    let rows = ROWS.iter().filter(|row| row[2] == "rigid" && !["orbit", "crankshaft"].contains(&row[1]));
    rows.for_each(solves_as_its_twin);
}
