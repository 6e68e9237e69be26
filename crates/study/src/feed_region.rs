//! Feeds that overlap or touch at one pressure are one region of the film: a hole drilled in a groove.
//!
//! The oil reaches the film through the rim of their union. How much of it came through the hole has no meaning there,
//! so the union has one name, that of its feeds joined by `+` in the order of the scene.

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{Meeting, RoundedRectangle, meeting};
use oilwedge_scene::{Feed, MeshSource, Scene};

/// One or several feeds that are one region of the film.
#[derive(Debug, Clone)]
pub struct FeedRegion<'a> {
    /// Name of the region in the mesh and in `feed_flow.NAME`: the group, or the groups joined by `+`.
    pub name: String,
    /// The feeds, in the order of the scene.
    pub feeds: Vec<&'a Feed>,
}

impl FeedRegion<'_> {
    /// Gauge pressure [Pa]; `None` in a pocket.
    pub fn pressure(&self) -> Option<f64> {
        self.feeds[0].pressure
    }
}

/// The regions that the feeds of a scene are, in the order of their first feeds. In a mesh file that is used as it is
/// each group is a region.
pub fn feed_regions(scene: &Scene) -> Vec<FeedRegion<'_>> {
    let is_drawn = !matches!(scene.mesh, MeshSource::File { size: None, .. });
    let liner = liner(scene);
    let meet = |one: &Feed, other: &Feed| match (shape(scene, one), shape(scene, other)) {
        (Some(a), Some(b)) => {
            let is_one_pressure = one.pressure.is_some() && one.pressure == other.pressure;
            is_drawn && is_one_pressure && meeting(&liner, &a, &b) != Meeting::Apart
        }
        _ => false,
    };
    let mut unions: Vec<Vec<usize>> = Vec::new();
    for (index, feed) in scene.feeds.iter().enumerate() {
        let meets = |union: &Vec<usize>| union.iter().any(|&other| meet(feed, &scene.feeds[other]));
        let (met, apart): (Vec<_>, Vec<_>) = unions.into_iter().partition(meets);
        let mut joined: Vec<usize> = met.into_iter().flatten().chain([index]).collect();
        joined.sort_unstable();
        unions = apart;
        unions.push(joined);
    }
    unions.sort_unstable();
    let region = |union: Vec<usize>| {
        let feeds: Vec<&Feed> = union.into_iter().map(|index| &scene.feeds[index]).collect();
        let names: Vec<&str> = feeds.iter().map(|feed| feed.group.as_str()).collect();
        let name = names.join("+");
        FeedRegion { name, feeds }
    };
    unions.into_iter().map(region).collect()
}

/// The liner on which feeds are drawn.
pub(crate) fn liner(scene: &Scene) -> LinerDomain {
    LinerDomain {
        radius: scene.bearing.radius(),
        length: scene.bearing.length,
        arc: scene.bearing.arc.map(|arc| (arc.from, arc.to)),
    }
}

/// The shape of a feed on the developed surface, where the scene gives it.
pub fn shape(scene: &Scene, feed: &Feed) -> Option<RoundedRectangle> {
    let radius = scene.bearing.radius();
    let hole = feed.hole.map(|hole| RoundedRectangle::disc([radius * hole.angle, hole.z], 0.5 * hole.diameter));
    let groove = feed.groove.map(|groove| {
        let (middle, half) = match groove.arc {
            Some(arc) => (0.5 * (arc.from + arc.to), 0.5 * radius * (arc.to - arc.from)),
            None => (0.0, f64::INFINITY),
        };
        RoundedRectangle {
            centre: [radius * middle, groove.z],
            half: [half, 0.5 * groove.width],
            corner: groove.corner,
        }
    });
    hole.or(groove)
}
