//! `hole` of a feed: a round hole on the developed surface.

use std::f64::consts::TAU;

use crate::reader::TableReader;
use crate::wording::{degrees, millimetres};
use crate::{BearingTable, Complaints};

keys! {
    "feed.hole" = Table; "", "no hole: the region of the mesh file is as it is", "",
        "says that the region is a round hole: its rim becomes round (every node lies on the circle), its share of the load exact";
    "feed.hole.diameter" = Quantity(Length); "17 mm", "required", "> 0, inside the liner",
        "diameter of the hole";
    "feed.hole.angle" = Quantity(Angle); "130 deg", "required", "inside the arc",
        "angle of the centre of the hole";
    "feed.hole.z" = Quantity(Length); "0 mm", "0", "inside the liner",
        "axial position of the centre of the hole";
}

/// A round hole on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Diameter [m].
    pub diameter: f64,
    /// Angle of its centre [rad].
    pub angle: f64,
    /// Axial position of its centre [m]; 0 is midway between the ends.
    pub z: f64,
}

pub(super) fn read(mut table: TableReader<'_>) -> Hole {
    Hole { diameter: table.required("diameter"), angle: table.required("angle"), z: table.number("z").or_usual() }
}

impl Hole {
    /// The hole lies on the liner.
    pub(super) fn check(&self, bearing: &BearingTable, key: &str, complaints: &mut Complaints) {
        if self.diameter > bearing.length || self.diameter > bearing.diameter {
            let (around, along) = (millimetres(bearing.diameter), millimetres(bearing.length));
            return complaints.add(
                &format!("{key}.diameter"),
                format!("is wider than the liner, {around} x {along}"),
                "give the diameter of the hole, smaller than the liner's bearing.length and bearing.diameter",
            );
        }
        let (radius, half) = (0.5 * self.diameter, 0.5 * bearing.length);
        complaints.refuse_if(
            self.z.abs() + radius > half * (1.0 + 1e-12),
            &format!("{key}.z"),
            format!("puts the hole's rim beyond the end of the liner, at {} from the middle", millimetres(half)),
            "z counts from midway between the ends; move or shrink the hole",
        );
        if let Some(arc) = bearing.arc.filter(|arc| arc.from < arc.to) {
            let reach = radius / bearing.radius();
            let before = (self.angle - arc.from).rem_euclid(TAU);
            let (from, to) = (degrees(arc.from), degrees(arc.to));
            complaints.refuse_if(
                before < reach - 1e-12 || before > arc.to - arc.from - reach + 1e-12,
                &format!("{key}.angle"),
                format!("puts the hole, {} wide, beyond the arc from {from} to {to}", degrees(2.0 * reach)),
                "give the angle of the hole's centre, inside the arc",
            );
        }
    }
}
