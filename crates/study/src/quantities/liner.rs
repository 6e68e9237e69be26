//! A wall that gives way: how far.

use oilwedge_reynolds::error_bar::Bar;

use super::cycle::{ORBIT, greatest};
use super::row::Headline;
use super::row::Measure::{One, OverCycle};
use super::rule::ErrorRule;

rows! {
    /// `delta_max`: greatest deflection of the wall outwards, where there is film; of elastic liners
    DEFLECTION_MAX = "deflection_max", "delta_max", Metre, "greatest deflection of the elastic liner":
        One(|film| film.measured.deflection),
        ErrorRule::Of("change with the pressure of the other film, and with the grid of the wall, which film and wall answer; all numbers of elastic liners have this part in their bars, forces and moments that of the grid alone",
            |_, _| Some(Bar::default())),
        tolerance only(|scope| scope.gives_way);

    /// `delta_max` over the film and the cycle; of elastic liners
    CYCLE_DEFLECTION_MAX = "cycle_deflection_max", "delta_max", Metre, "greatest deflection of the elastic liner over the cycle":
        OverCycle(|cycle| greatest(cycle, &DEFLECTION_MAX)),
        ErrorRule::OverCycle(ORBIT), only(|scope| scope.gives_way) headline(Headline::Always(12));
}
