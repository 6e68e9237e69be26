//! `groove` of a feed: a rectangle with round corners on the developed surface.

use std::f64::consts::TAU;

use crate::reader::TableReader;
use crate::wording::millimetres;
use crate::{Arc, BearingTable, Complaints};

keys! {
    "feed.groove" = Table; "", "no groove: the region of the mesh file is as it is", "",
        "says that the region is a groove, a rectangle on the unrolled liner";
    "feed.groove.from" = Quantity(Angle); "80 deg", "all around, as `to`", "",
        "angle at which the groove begins";
    "feed.groove.to" = Quantity(Angle); "100 deg", "all around, as `from`", "> `from`",
        "angle at which the groove ends";
    "feed.groove.width" = Quantity(Length); "20 mm", "required", "> 0, at most the length",
        "extent of the groove along the axis";
    "feed.groove.z" = Quantity(Length); "0 mm", "0", "inside the liner",
        "axial position of the middle of the groove";
    "feed.groove.corner" = Quantity(Length); "2 mm", "0", "at most half its lesser side",
        "radius of the corners of the groove";
}

/// A rectangle with round corners on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    /// Angles between which the groove lies [rad]; `None`: all around.
    pub arc: Option<Arc>,
    /// Extent along the axis [m].
    pub width: f64,
    /// Axial position of its middle [m].
    pub z: f64,
    /// Radius of its corners on the developed surface [m].
    pub corner: f64,
}

/// A groove from 0 to 360 degrees is one all around.
pub(super) fn read(mut table: TableReader<'_>) -> Groove {
    let from = table.given("from");
    let to = table.given("to");
    if from.is_some() != to.is_some() {
        let (has, lacks) = if from.is_some() { ("from", "to") } else { ("to", "from") };
        let help = format!("give {lacks} too, or remove {has} for a groove all around");
        table.complain(has, format!("stands without {lacks}"), help);
    }
    let arc =
        (from.is_some() || to.is_some()).then(|| Arc { from: from.unwrap_or(f64::NAN), to: to.unwrap_or(f64::NAN) });
    let arc = arc.filter(|arc| (arc.to - arc.from - TAU).abs() >= 1e-9 || arc.to.is_nan() || arc.from.is_nan());
    if let Some(Arc { from, to }) = arc {
        table.refuse_if(
            to <= from,
            "to",
            "is not behind the beginning of the groove",
            "count up from one to the other: from = \"350 deg\", to = \"370 deg\" crosses zero",
        );
        table.refuse_if(
            to - from > TAU,
            "to",
            "makes the groove more than a full turn",
            "give 360 deg at most, or remove from and to for a groove all around",
        );
    }
    Groove {
        arc,
        width: table.required("width"),
        z: table.number("z").or_usual(),
        corner: table.number("corner").or_usual(),
    }
}

impl Groove {
    /// The groove lies on the liner.
    pub(super) fn check(&self, bearing: &BearingTable, key: &str, complaints: &mut Complaints) {
        complaints.refuse_if(
            self.width > bearing.length,
            &format!("{key}.width"),
            format!("is more than the length of the liner, {}", millimetres(bearing.length)),
            "the width counts along the axis; give less than the length",
        );
        complaints.refuse_if(
            self.arc.is_none() && bearing.arc.is_some(),
            &format!("{key}.width"),
            "belongs to a groove all around, and this bearing is an arc",
            "give from and to",
        );
        let around = (self.arc.filter(|arc| arc.to > arc.from))
            .map_or(f64::INFINITY, |arc| (arc.to - arc.from) * bearing.radius());
        complaints.refuse_if(
            self.corner < 0.0 || self.corner > 0.5 * self.width.min(around) * (1.0 + 1e-12),
            &format!("{key}.corner"),
            "is not between zero and half the lesser side of the groove",
            "give a smaller radius, or none for sharp corners",
        );
    }
}
