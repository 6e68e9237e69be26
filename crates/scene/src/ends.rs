//! `[ends]`: the two open ends of the bearing.

use crate::reader::TableReader;

keys! {
    "ends" = Table; "", "pressure 0", "",
        "the two open ends of the bearing";
    "ends.pressure" = Quantity(Pressure); "0 bar", "required", "",
        "pressure p_e at both ends, at the edges of an arc and at the film start";
}

/// The two open ends of the bearing.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Ends {
    /// Gauge pressure p_e at both ends [Pa]; the zero of all pressures where the scene does not give it.
    pub pressure: f64,
}

pub(crate) fn read(mut table: TableReader<'_>) -> Ends {
    Ends { pressure: table.required("pressure") }
}
