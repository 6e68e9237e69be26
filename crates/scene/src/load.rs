//! `[load]`: the force that the journal carries, where its position is found.

use crate::Position;
use crate::reader::TableReader;
use crate::unit::Dimension;

keys! {
    "load" = Table; "", "the position is given", "",
        "the load for which the position of the journal is found";
    "load.force" = Quantity(Force); "5 kN", "required", ">= 0",
        "external force F on the journal, such as its share of the weight of the rotor; the film holds the journal with -F and pushes the liner with F";
    "load.angle" = Quantity(Angle); "270 deg", "required", "",
        "direction in which F pulls the journal";
}

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
