//! Capabilities beside each other: every pair of values of two columns of [`COLUMNS`] is met by a row of [`ROWS`]. Each
//! row is one small bearing, or a shaft on two of them.
//!
//! A row is solved twice. The twin is twice the size and turned by a quarter; both are the same problem, so that each
//! number of the twin follows from that of the row by its unit. The mesh of the rows is its own image under quarter
//! turns.

mod row;
mod scene;
mod twin;

use row::solved;
use scene::Frame;
use twin::differences;

/// One value of each of [`COLUMNS`].
pub type Row = [&'static str; 5];

/// Cavitation, by the words of a scene; analysis; wall; surfaces; temperature. The first of each is the plainest.
pub const COLUMNS: [&[&str]; 5] = [
    &["none", "guembel", "reynolds", "jfo"],
    &["position", "load", "moment", "orbit", "shaft", "crankshaft"],
    &["rigid", "layer", "ring"],
    &["smooth", "contact"],
    &["temperature", "heat"],
];

/// The rows that are solved.
pub const ROWS: [Row; 24] = [
    ["none", "position", "layer", "contact", "temperature"],
    ["guembel", "position", "ring", "smooth", "heat"],
    ["reynolds", "position", "rigid", "contact", "heat"],
    ["jfo", "position", "layer", "smooth", "temperature"],
    ["none", "load", "ring", "contact", "heat"],
    ["guembel", "load", "rigid", "smooth", "temperature"],
    ["reynolds", "load", "layer", "smooth", "heat"],
    ["jfo", "load", "ring", "contact", "temperature"],
    ["none", "moment", "rigid", "smooth", "heat"],
    ["guembel", "moment", "layer", "contact", "temperature"],
    ["reynolds", "moment", "ring", "smooth", "temperature"],
    ["jfo", "moment", "rigid", "contact", "heat"],
    ["none", "orbit", "rigid", "smooth", "temperature"],
    ["guembel", "orbit", "layer", "smooth", "temperature"],
    ["reynolds", "orbit", "ring", "smooth", "temperature"],
    ["jfo", "orbit", "rigid", "contact", "heat"],
    ["none", "shaft", "rigid", "contact", "temperature"],
    ["guembel", "shaft", "rigid", "smooth", "heat"],
    ["reynolds", "shaft", "ring", "contact", "temperature"],
    ["jfo", "shaft", "layer", "smooth", "heat"],
    ["none", "crankshaft", "rigid", "contact", "temperature"],
    ["reynolds", "crankshaft", "layer", "smooth", "temperature"],
    ["jfo", "crankshaft", "rigid", "smooth", "heat"],
    ["guembel", "crankshaft", "ring", "smooth", "temperature"],
];

/// All pairs of values of two columns.
pub fn pairs() -> impl Iterator<Item = [&'static str; 2]> {
    let columns = (0..COLUMNS.len()).flat_map(|one| (one + 1..COLUMNS.len()).map(move |other| [one, other]));
    columns.flat_map(|[one, other]| {
        COLUMNS[one].iter().flat_map(move |&first| COLUMNS[other].iter().map(move |&second| [first, second]))
    })
}

/// Whether a row has both values.
pub fn has(row: &Row, pair: &[&str; 2]) -> bool {
    pair.iter().all(|value| row.contains(value))
}

/// Whether the twin of a row is turned: the cylinders of a crankshaft lie where they do, and on a shaft the films add
/// what round-off halves differently under elastic walls.
fn is_turned(row: &Row) -> bool {
    row[1] != "crankshaft" && (row[1] != "shaft" || row[2] == "rigid")
}

/// Checks that a row is solved, its balances closed, and its numbers those of its twin.
///
/// # Panics
/// They are not.
pub fn solves_as_its_twin(row: &Row) {
    let clock = std::time::Instant::now();
    let [own, twin] = [Frame::OWN, Frame::TWIN]
        .map(|frame| solved(row, frame).unwrap_or_else(|told| panic!("{row:?}, {frame:?}: {told}")));
    // A triangle that is wider than the cells of an elastic wall is halved at its longest edge, of which it may have
    // two: round-off decides.
    let tolerance = if row[2] == "rigid" { 1e-9 } else { 1e-4 };
    let turn = if is_turned(row) { Frame::TWIN.turn } else { 0.0 };
    for (own, twin) in own.iter().zip(&twin) {
        let differences = differences(own, twin, Frame { turn, ..Frame::TWIN }, tolerance);
        assert!(differences.is_empty() && own.len() == twin.len(), "{row:?}: {differences:?}");
    }
    println!("{row:?}: {:.1} s", clock.elapsed().as_secs_f64());
}
