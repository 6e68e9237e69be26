//! A wall that gives way: how far.

use oilwedge_reynolds::error_bar::Bar;

use super::row::Measure::One;
use super::rule::ErrorRule;

rows! {
    /// `delta_max`: greatest deflection of the wall outwards, where there is film; of elastic liners
    DEFLECTION_MAX = "deflection_max", "delta_max", Metre, "greatest deflection of the elastic liner":
        One(|film| film.measured.deflection),
        ErrorRule::Of("change with the pressure of the other film, and with the grid of the wall, which film and wall answer; the bars of all numbers of elastic liners have this part",
            |_, _| Some(Bar::default())),
        tolerance only(|scene| scene.liner.is_some());
}
