//! Holes, grooves and pockets: shapes on the liner, and what is given there.

use std::f64::consts::{PI, TAU};

use super::{Checks, RESERVED_GROUPS};
use crate::scene::{Bearing, Feed, Groove, Hole, MeshSource, Scene};
use crate::wording::{degrees, millimetres};

impl Checks<'_> {
    pub(super) fn feeds(&mut self, scene: &Scene) {
        for (index, feed) in scene.feeds.iter().enumerate() {
            let key = format!("feed[{index}].group");
            let reserved = RESERVED_GROUPS.contains(&feed.group.as_str());
            let message = format!("\"{}\" is a name that meshes use for a part of the liner", feed.group);
            let help = format!("name the feed region otherwise; taken: {}", RESERVED_GROUPS.join(", "));
            self.refuse_if(reserved, &key, message, help);
            let twice = !feed.group.is_empty() && scene.feeds[..index].iter().any(|other| other.group == feed.group);
            let message = format!("\"{}\" is fed already by a [[feed]] above", feed.group);
            self.refuse_if(twice, &key, message, "give each region one [[feed]] and one pressure");
            self.region(index, feed, &scene.mesh);
            if let Some(groove) = feed.groove {
                self.groove(index, &groove, &scene.bearing);
            }
            if let Some(hole) = feed.hole {
                self.hole(index, &hole, &scene.bearing);
                let radius = scene.bearing.radius();
                let meets = |other: &&Feed| other.hole.is_some_and(|rim| overlap(&hole, &rim, radius));
                if let Some(other) = scene.feeds[..index].iter().find(meets) {
                    let message = format!("overlaps the hole of \"{}\"", other.group);
                    let key = format!("feed[{index}].hole");
                    self.refuse_if(true, &key, message, "move one of the two holes");
                }
            }
        }
    }

    /// A feed has one shape at most, one where the liner is drawn, and either a pressure or a depth.
    fn region(&mut self, index: usize, feed: &Feed, mesh: &MeshSource) {
        let key = |name: &str| format!("feed[{index}].{name}");
        self.refuse_if(
            feed.hole.is_some() && feed.groove.is_some(),
            &key("groove"),
            "stands beside a hole",
            "give each region a [[feed]] of its own",
        );
        self.refuse_if(
            matches!(mesh, MeshSource::Drawing { .. }) && feed.hole.is_none() && feed.groove.is_none(),
            &key("group"),
            "has no shape, and there is no mesh file to show it",
            "give hole = { diameter = \"17 mm\", angle = \"130 deg\" } or groove = { from = \"80 deg\", to = \"100 deg\", width = \"20 mm\" }, or [mesh] file",
        );
        self.refuse_if(
            feed.pressure.is_none() && feed.depth.is_none(),
            &key("group"),
            "has neither a pressure nor a depth",
            "give pressure = \"1.96 bar\", or depth = \"20 um\" for a pocket whose pressure is found",
        );
        self.refuse_if(
            feed.pressure.is_some() && feed.depth.is_some(),
            &key("depth"),
            "stands beside a pressure",
            "remove the depth (where the pressure is given it has no effect) or the pressure (it is found)",
        );
        self.refuse_if(
            feed.depth.is_some_and(|depth| depth < 0.0),
            &key("depth"),
            "is negative",
            "give how much deeper the film is",
        );
    }

    fn groove(&mut self, index: usize, groove: &Groove, bearing: &Bearing) {
        let key = |name: &str| format!("feed[{index}].groove.{name}");
        self.positive(groove.width, &key("width"));
        self.refuse_if(
            groove.width > bearing.length,
            &key("width"),
            format!("is more than the length of the liner, {}", millimetres(bearing.length)),
            "the width counts along the axis; give less than the length",
        );
        if let Some(arc) = groove.arc {
            self.refuse_if(
                arc.to <= arc.from,
                &key("to"),
                "is not behind the beginning of the groove",
                "count up from one to the other: from = \"350 deg\", to = \"370 deg\" crosses zero",
            );
            self.refuse_if(
                arc.to - arc.from > TAU,
                &key("to"),
                "makes the groove more than a full turn",
                "give 360 deg at most, or remove from and to for a groove all around",
            );
        }
        self.refuse_if(
            groove.arc.is_none() && bearing.arc.is_some(),
            &key("width"),
            "belongs to a groove all around, and this bearing is an arc",
            "give from and to",
        );
        let around = (groove.arc.filter(|arc| arc.to > arc.from))
            .map_or(f64::INFINITY, |arc| (arc.to - arc.from) * bearing.radius());
        self.refuse_if(
            groove.corner < 0.0 || groove.corner > 0.5 * groove.width.min(around) * (1.0 + 1e-12),
            &key("corner"),
            "is not between zero and half the lesser side of the groove",
            "give a smaller radius, or none for sharp corners",
        );
    }

    fn hole(&mut self, index: usize, hole: &Hole, bearing: &Bearing) {
        let key = |name: &str| format!("feed[{index}].hole.{name}");
        self.positive(hole.diameter, &key("diameter"));
        if !(bearing.diameter > 0.0 && bearing.length > 0.0 && hole.diameter > 0.0) {
            return;
        }
        let (radius, half) = (0.5 * hole.diameter, 0.5 * bearing.length);
        let too_wide = hole.diameter > bearing.length || hole.diameter > bearing.diameter;
        let message = format!(
            "is wider than the liner, {} x {}",
            millimetres(bearing.diameter),
            millimetres(bearing.length)
        );
        self.refuse_if(
            too_wide,
            &key("diameter"),
            message,
            "give the diameter of the hole, smaller than the liner's bearing.length and bearing.diameter",
        );
        if too_wide {
            return;
        }
        let message = format!(
            "puts the hole's rim beyond the end of the liner, at {} from the middle",
            millimetres(half)
        );
        let outside = hole.z.abs() + radius > half * (1.0 + 1e-12);
        self.refuse_if(
            outside,
            &key("z"),
            message,
            "z counts from midway between the ends; move or shrink the hole",
        );
        if let Some(arc) = bearing.arc.filter(|arc| arc.from < arc.to) {
            let reach = radius / bearing.radius();
            let before = (hole.angle - arc.from).rem_euclid(TAU);
            let leaves = before < reach - 1e-12 || before > arc.to - arc.from - reach + 1e-12;
            let message = format!(
                "puts the hole, {} wide, beyond the arc from {} to {}",
                degrees(2.0 * reach),
                degrees(arc.from),
                degrees(arc.to)
            );
            self.refuse_if(
                leaves,
                &key("angle"),
                message,
                "give the angle of the hole's centre, inside the arc",
            );
        }
    }
}

/// Whether two holes on the developed surface of a liner of this radius overlap.
fn overlap(one: &Hole, other: &Hole, radius: f64) -> bool {
    let turn = (one.angle - other.angle + PI).rem_euclid(TAU) - PI;
    (radius * turn).hypot(one.z - other.z) < 0.5 * (one.diameter + other.diameter)
}
