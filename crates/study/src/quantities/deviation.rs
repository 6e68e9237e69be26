//! The film at mid-length against that at the ends: criteria of a crankshaft's bearings.

use crate::scope::Scope;
use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::quantities::deviation::Sections;

use super::cycle_view::{CycleView, ValueWithBar};
use super::row::Measure::{One, OverCycle};
use super::rule::ErrorRule;
use super::view::View;

rows! {
    /// `h_0`: least film thickness at mid-length, z = 0; of scenes whose `[criteria]` ask for it, for the deviation or
    /// the equivalent film
    MIDDLE_FILM_MIN = "middle_film_min", "h_0", Metre, "least film thickness at mid-length":
        One(|film| Some(sections(film)?.middle)), ErrorRule::Position, only(is_asked);

    /// `Delta_gamma = h_0 - min(h_1, h_2)`, h_1 and h_2 the least films at the ends; likewise
    DEVIATION = "deviation", "Delta_gamma", Metre, "film at mid-length less that at the thinner end":
        One(|film| Some(sections(film)?.deviation())), ErrorRule::Position, only(is_asked);

    /// `h* = h_0/(1 + (Delta_gamma/s)^2)`, s being `criteria.deviation_scale`, and h_0 where the film is thicker at
    /// both ends; likewise
    EQUIVALENT_FILM = "equivalent_film", "h*", Metre, "equivalent film: that at mid-length, made less by the deviation":
        One(|film| Some(sections(film)?.equivalent_film(film.base.model.scope.deviation_scale?))), ErrorRule::Position, only(is_asked);

    /// `h_0`: least film thickness at mid-length over the cycle; of orbits whose scenes ask for it
    CYCLE_MIDDLE_FILM_MIN = "cycle_middle_film_min", "h_0", Metre, "least film thickness at mid-length over the cycle":
        OverCycle(|cycle| Some(over_cycle(cycle)?.film(|it| it.middle))), ErrorRule::OverCycle(RULE), only(is_asked_of_orbit);

    /// `Delta_gamma = h_0 - min(h_1, h_2)`, each the least of the cycle
    CYCLE_DEVIATION = "cycle_deviation", "Delta_gamma", Metre, "least film at mid-length less that at the thinner end, over the cycle":
        OverCycle(|cycle| Some(over_cycle(cycle)?.film(Sections::deviation))), ErrorRule::OverCycle(RULE), only(is_asked_of_orbit);

    /// `h* = h_0/(1 + (Delta_gamma/s)^2)` of these
    CYCLE_EQUIVALENT_FILM = "cycle_equivalent_film", "h*", Metre, "equivalent film over the cycle":
        OverCycle(|cycle| {
            let scale = cycle.deviation_scale?;
            Some(over_cycle(cycle)?.film(|it| it.equivalent_film(scale)))
        }), ErrorRule::OverCycle(RULE), only(is_asked_of_orbit);
}

const RULE: &str = "that of the least film at the times of the least sections, carried through the formula";

fn is_asked(scope: &Scope) -> bool {
    scope.deviation_scale.is_some() && scope.orbit.is_none()
}

fn is_asked_of_orbit(scope: &Scope) -> bool {
    scope.deviation_scale.is_some() && scope.orbit.is_some()
}

fn sections(film: &View) -> Option<Sections> {
    let is_asked = is_asked(&film.base.model.scope);
    is_asked.then(|| Sections::of_film(film.problem, &film.base.system))
}

/// Least sections of a cycle, and how far off each may be.
struct OfCycle {
    sections: Sections,
    /// Bars of the middle, and of both ends.
    bars: Option<[Bar; 3]>,
}

fn over_cycle(cycle: &CycleView) -> Option<OfCycle> {
    cycle.deviation_scale?;
    let [low, high] = cycle.gap.bearing().ends();
    let [middle, low, high] = [0.0, low, high].map(|z| cycle.least_along(z));
    let bars = [middle, low, high].map(|(_, time)| cycle.bar_of_thinnest(time));
    Some(OfCycle {
        sections: Sections { middle: middle.0.thickness, ends: [low.0.thickness, high.0.thickness] },
        bars: match bars {
            [Some(a), Some(b), Some(c)] => Some([a, b, c]),
            _ => None,
        },
    })
}

impl OfCycle {
    /// A number of the sections, and its bar: what each section's bar changes it by.
    fn film(&self, number: impl Fn(&Sections) -> f64) -> ValueWithBar {
        let value = number(&self.sections);
        let Sections { middle, ends: [low, high] } = self.sections;
        let bar = self.bars.map(|bars| {
            let moved = |k: usize| {
                let off = |place: usize| if place == k { bars[k].total() } else { 0.0 };
                let moved = Sections { middle: middle + off(0), ends: [low - off(1), high - off(2)] };
                let slope = (number(&moved) - value).abs() / bars[k].total().max(f64::MIN_POSITIVE);
                bars[k].scaled(slope)
            };
            moved(0) + moved(1) + moved(2)
        });
        (value, bar)
    }
}
