//! `[load]`: the force that the journal carries, where its position is found.

use crate::Position;
use crate::reader::TableReader;
use crate::unit::Dimension;

pub(crate) fn read(mut table: TableReader<'_>) -> Position {
    let force = table.quantity("force", Dimension::Force, "5 kN").within(
        |force| force >= 0.0,
        "is negative",
        "give force >= 0, and turn angle by 180 deg",
    );
    let force = force.required();
    let angle = table.required("angle", Dimension::Angle, "270 deg");
    Position::Load { force, angle }
}
