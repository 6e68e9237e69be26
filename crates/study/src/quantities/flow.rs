//! Flows of the oil.

use oilwedge_reynolds::error_bar::{Bar, FlowGoal};
use oilwedge_reynolds::supply::BoundaryKind;

use super::row::{Headline, Measure::Each, Measure::One};
use super::rule::{ErrorRule, Subject};
use super::view::View;
use crate::estimate::Estimate;

rows! {
    /// `Q_s`: oil that leaves at both ends, less what enters there; with `guembel` where its pressure was not dropped;
    /// none with sealed ends
    SIDE_FLOW = "side_flow", "Q_s", CubicMetrePerSecond, "oil that leaves at the ends (< 0: enters)":
        One(|film| film.side_flow()), OF_ENDS, tolerance headline(Headline::Always(12));

    /// Its part at the end z = -B/2
    SIDE_FLOW_LOW = "side_flow_low", "Q_s", CubicMetrePerSecond, "the part at the end z = -B/2":
        One(|film| out_of(film, LOW)), ErrorRule::Of(DUAL, |estimate, at| of_end(estimate, at, LOW));

    /// Its part at the end z = +B/2
    SIDE_FLOW_HIGH = "side_flow_high", "Q_s", CubicMetrePerSecond, "the part at the end z = +B/2":
        One(|film| out_of(film, HIGH)), ErrorRule::Of(DUAL, |estimate, at| of_end(estimate, at, HIGH));

    /// `Q = Int (theta U h/2 - h^3/(12 mu) dp/dx) dz` along the line where the loaded film begins: just behind the film
    /// start or the leading edge of an arc, in a ring without them where the film is thickest; behind the feed where
    /// one lies there, so that its oil counts. Of it Q_s leaves at the ends, the rest goes round; none at rest. With
    /// `[roughness]` h_T stands for h in the first term, and phi_p before the second
    INLET_FLOW = "inlet_flow", "Q", CubicMetrePerSecond, "oil carried into the loaded film":
        One(|film| film.measured.inlet_flow), OF_INLET, tolerance;

    /// `Q_s* = Q_s/(D^3 (c/R) omega)` as in ISO 7902; none at rest
    SIDE_FLOW_NUMBER = "side_flow_number", "Q_s*", One, "Q_s / (D^3 (c/R) omega)":
        One(|film| film.flow_unit().and_then(|unit| Some(film.side_flow()? / unit))),
        ErrorRule::Of("that of `side_flow`, in proportion",
            |estimate, at| estimate.flow(&FlowGoal::Ends, at.per(at.view.flow_unit()?)));

    /// `Q* = Q/(D^3 (c/R) omega)` as in ISO 7902; none at rest
    INLET_FLOW_NUMBER = "inlet_flow_number", "Q*", One, "Q / (D^3 (c/R) omega)":
        One(|film| film.flow_unit().and_then(|unit| Some(film.measured.inlet_flow? / unit))),
        ErrorRule::Of("that of `inlet_flow`, in proportion",
            |estimate, at| Some(Bar::of(estimate.inlet_flow(at.per(at.view.flow_unit()?)))));

    /// `Q_f`: oil that enters the film across the rim of the feed of that name; below 0 the feed drains the film. Feeds
    /// that overlap are one region, `feed_flow.A+B`. Under squeeze the gap over a feed that is cut out changes too, and
    /// is not counted: the supply gives `Int dh/dt dA` over the feed more; over a meshed feed (a groove all around, a
    /// surface of a mesh file) this is counted. None without feeds
    FEED_FLOW = "feed_flow.", "Q_f", CubicMetrePerSecond, "oil that enters there (< 0: leaves)":
        Each(|film| film.regions(BoundaryKind::Feed).map(|(region, flow)| (region.name.clone(), flow.net)).collect()),
        ErrorRule::Of(DUAL, |estimate, at| estimate.flow(&FlowGoal::Region(at.region.to_owned()), at.per(1.0))),
        tolerance only(|scope| scope.is_fed) headline(Headline::Always(13));
}

const LOW: &str = "end_low";
const HIGH: &str = "end_high";
const DUAL: &str = "dual-weighted, and the difference of the two films";
const OF_ENDS: ErrorRule = ErrorRule::Of(DUAL, |estimate, at| estimate.flow(&FlowGoal::Ends, at.per(1.0)));
const OF_INLET: ErrorRule =
    ErrorRule::Of("difference of the two films", |estimate, at| Some(Bar::of(estimate.inlet_flow(at.per(1.0)))));

fn out_of(film: &View, end: &str) -> Option<f64> {
    let mut ends = film.regions(BoundaryKind::End);
    ends.find(|(region, _)| region.name == end).map(|(_, flow)| -flow.net)
}

fn of_end(estimate: &dyn Estimate, at: &Subject, end: &str) -> Option<Bar> {
    estimate.flow(&FlowGoal::Region(end.to_owned()), at.per(1.0))
}
