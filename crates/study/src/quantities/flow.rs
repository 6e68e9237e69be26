//! Where the oil goes.

use oilwedge_reynolds::error_bar::{Bar, FlowGoal};
use oilwedge_reynolds::supply::BoundaryKind;

use super::load::is_fed;
use super::row::{Measure::Each, Measure::One, Row};
use super::rule::{ErrorRule, Subject};
use super::unit::Unit::{CubicMetrePerSecond, One as Ratio};
use super::view::View;
use crate::estimate::Estimate;

/// Flow out at both ends.
pub static SIDE_FLOW: Row = Row::new("side_flow", "Q_s", CubicMetrePerSecond, One(|film| film.side_flow()), OF_ENDS)
    .means(
        "oil that leaves at the ends (< 0: enters)",
        "`Q_s`: oil that leaves at both ends, less what enters there; with `guembel` where its pressure was not dropped; none with sealed ends",
    )
    .tolerance()
    .headline();

/// Flow out at the end z = -B/2.
pub static SIDE_FLOW_LOW: Row = Row::new(
    "side_flow_low",
    "Q_s",
    CubicMetrePerSecond,
    One(|film| out_of(film, LOW)),
    ErrorRule::Of(DUAL, |estimate, at| of_end(estimate, at, LOW)),
)
.means("the part at the end z = -B/2", "its part at the end z = -B/2");

/// Flow out at the end z = +B/2.
pub static SIDE_FLOW_HIGH: Row = Row::new(
    "side_flow_high",
    "Q_s",
    CubicMetrePerSecond,
    One(|film| out_of(film, HIGH)),
    ErrorRule::Of(DUAL, |estimate, at| of_end(estimate, at, HIGH)),
)
.means("the part at the end z = +B/2", "its part at the end z = +B/2");

/// Flow into the loaded film.
pub static INLET_FLOW: Row = Row::new(
    "inlet_flow",
    "Q",
    CubicMetrePerSecond,
    One(|film| film.measured.inlet_flow),
    OF_INLET,
)
.means(
    "oil carried into the loaded film",
    "`Q = Int (theta U h/2 - h^3/(12 mu) dp/dx) dz` along the line where the loaded film begins: just behind the film start or the leading edge of an arc, in a ring without them where the film is thickest. What feeds on that line carry does not count. Of it Q_s leaves at the ends, the rest goes round; none at rest",
)
.tolerance();

/// Side flow without dimension.
pub static SIDE_FLOW_NUMBER: Row = Row::new(
    "side_flow_number",
    "Q_s*",
    Ratio,
    One(|film| film.flow_unit().and_then(|unit| Some(film.side_flow()? / unit))),
    ErrorRule::Of("that of `side_flow`, in proportion", |estimate, at| {
        estimate.flow(&FlowGoal::Ends, at.per(at.view.flow_unit()?))
    }),
)
.means(
    "Q_s / (D^3 (c/R) omega)",
    "`Q_s* = Q_s/(D^3 (c/R) omega)` as in ISO 7902; none at rest",
);

/// Inlet flow without dimension.
pub static INLET_FLOW_NUMBER: Row = Row::new(
    "inlet_flow_number",
    "Q*",
    Ratio,
    One(|film| film.flow_unit().and_then(|unit| Some(film.measured.inlet_flow? / unit))),
    ErrorRule::Of("that of `inlet_flow`, in proportion", |estimate, at| {
        Some(Bar::of(estimate.inlet_flow(at.per(at.view.flow_unit()?))))
    }),
)
.means(
    "Q / (D^3 (c/R) omega)",
    "`Q* = Q/(D^3 (c/R) omega)` as in ISO 7902; none at rest",
);

/// Flow in through a feed.
pub static FEED_FLOW: Row = Row::new(
    "feed_flow.",
    "Q_f",
    CubicMetrePerSecond,
    Each(|film| {
        film.regions(BoundaryKind::Feed)
            .map(|(region, flow)| (region.name.clone(), flow.net))
            .collect()
    }),
    ErrorRule::Of(DUAL, |estimate, at| {
        estimate.flow(&FlowGoal::Feed(at.region.to_owned()), at.per(1.0))
    }),
)
.means(
    "oil that enters there (< 0: leaves)",
    "`Q_f`: oil that enters through the feed of that name; below 0 the hole drains the film; none without feeds",
)
.tolerance()
.only(is_fed);

const LOW: &str = "end_low";
const HIGH: &str = "end_high";
const DUAL: &str = "dual-weighted, and the difference of the two films";
const OF_ENDS: ErrorRule = ErrorRule::Of(DUAL, |estimate, at| estimate.flow(&FlowGoal::Ends, at.per(1.0)));
const OF_INLET: ErrorRule = ErrorRule::Of("difference of the two films", |estimate, at| {
    Some(Bar::of(estimate.inlet_flow(at.per(1.0))))
});

fn out_of(film: &View, end: &str) -> Option<f64> {
    let mut ends = film.regions(BoundaryKind::End);
    ends.find(|(region, _)| region.name == end).map(|(_, flow)| -flow.net)
}

fn of_end(estimate: &dyn Estimate, at: &Subject, end: &str) -> Option<Bar> {
    estimate.flow(&FlowGoal::End(end.to_owned()), at.per(1.0))
}
