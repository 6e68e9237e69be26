//! The liner, unrolled, with its feeds.
//!
//! Feeds that overlap or touch at one pressure are one region of the film: a hole drilled in a groove.
//! The oil reaches the film through the rim of their union. How much of it came through the hole has no meaning there,
//! so the union has one name, that of its feeds joined by `+` in the order of the scene.

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{Blueprint, Feature, Meeting, RoundedRectangle, meeting};
use oilwedge_scene::Feed;

/// The liner and its feeds.
#[derive(Debug, Clone, PartialEq)]
pub struct LinerOutline {
    /// The liner, unrolled.
    pub liner: LinerDomain,
    /// Feeds and pockets, in the order of the scene.
    pub feeds: Vec<Feed>,
    /// Angle [rad] at which the film of a ring is cut; `None` where it is not.
    pub film_start: Option<f64>,
    /// True where a mesh is made here; in a mesh file that is used as it is each group is a region.
    pub is_drawn: bool,
}

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

impl LinerOutline {
    /// The regions that the feeds are, in the order of their first feeds.
    pub fn regions(&self) -> Vec<FeedRegion<'_>> {
        let meet = |one: &Feed, other: &Feed| match (self.shape(one), self.shape(other)) {
            (Some(a), Some(b)) => {
                let is_one_pressure = one.pressure.is_some() && one.pressure == other.pressure;
                self.is_drawn && is_one_pressure && meeting(&self.liner, &a, &b) != Meeting::Apart
            }
            _ => false,
        };
        let mut unions: Vec<Vec<usize>> = Vec::new();
        for (index, feed) in self.feeds.iter().enumerate() {
            let meets = |union: &Vec<usize>| union.iter().any(|&other| meet(feed, &self.feeds[other]));
            let (met, apart): (Vec<_>, Vec<_>) = unions.into_iter().partition(meets);
            let mut joined: Vec<usize> = met.into_iter().flatten().chain([index]).collect();
            joined.sort_unstable();
            unions = apart;
            unions.push(joined);
        }
        unions.sort_unstable();
        let region = |union: Vec<usize>| {
            let feeds: Vec<&Feed> = union.into_iter().map(|index| &self.feeds[index]).collect();
            let names: Vec<&str> = feeds.iter().map(|feed| feed.group.as_str()).collect();
            let name = names.join("+");
            FeedRegion { name, feeds }
        };
        unions.into_iter().map(region).collect()
    }

    /// The drawing of the liner with the feeds that are described.
    pub(crate) fn blueprint(&self) -> Blueprint {
        Blueprint { liner: self.liner, features: self.features(), line: self.film_start }
    }

    /// The feeds that are described, as they are drawn.
    pub(crate) fn features(&self) -> Vec<Feature> {
        let of_region = |region: FeedRegion<'_>| {
            let shapes: Vec<RoundedRectangle> = region.feeds.iter().filter_map(|feed| self.shape(feed)).collect();
            // A groove all around would leave two films; a deeper film is still a film.
            let meshed = region.pressure().is_none() || shapes.iter().any(RoundedRectangle::is_full_turn);
            let feature = |shape| Feature { name: region.name.clone(), shape, meshed };
            shapes.into_iter().map(feature).collect::<Vec<Feature>>()
        };
        self.regions().into_iter().flat_map(of_region).collect()
    }

    /// The shape of a feed on the developed surface, where it is described.
    pub fn shape(&self, feed: &Feed) -> Option<RoundedRectangle> {
        let radius = self.liner.radius;
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
}
