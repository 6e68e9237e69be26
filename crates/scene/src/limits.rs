//! `[limits]`: older names of limits of `[criteria]`.

use crate::criteria::{Criteria, read_pressure, read_shared};
use crate::reader::TableReader;

keys! {
    "limits" = Table; "", "no limits", "",
        "limits of `[criteria]` under an older name";
    "limits.film_min" = Quantity(Length); "2 um", "`criteria.film_min`", "> 0",
        "an older name of `criteria.film_min`";
    "limits.temperature_max" = Quantity(Temperature); "115 C", "`criteria.temperature_max`", "-60 to 350 C, where the film has a temperature",
        "an older name of `criteria.temperature_max`";
    "limits.outlet_max" = Quantity(Temperature); "125 C", "`criteria.outlet_max`", "-60 to 350 C, with `[heat]`",
        "an older name of `criteria.outlet_max`";
    "limits.pressure_max" = Quantity(Pressure); "600 bar", "`criteria.pressure_max`", "> 0",
        "an older name of `criteria.pressure_max`";
}

pub(crate) fn read(mut table: TableReader<'_>) -> Criteria {
    Criteria { pressure_max: read_pressure(&mut table), ..read_shared(&mut table) }
}
