//! Feeds that overlap: at one pressure they are one region, else one of them is wrong.

use oilwedge_mesh::generate::overlap;
use oilwedge_scene::wording::bars;
use oilwedge_scene::{Complaints, Feed, Scene};

use crate::feed_region::{feed_regions, liner, shape};

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    if complaints.concern("feed") || complaints.concern("bearing") {
        return;
    }
    let liner = liner(scene);
    for (index, feed) in scene.feeds.iter().enumerate() {
        let key = format!("feed[{index}].{}", if feed.hole.is_some() { "hole" } else { "groove" });
        let meets = |other: &&Feed| match (shape(scene, feed), shape(scene, other)) {
            (Some(a), Some(b)) => other.pressure != feed.pressure && overlap(&liner, &a, &b),
            _ => false,
        };
        if let Some(other) = scene.feeds[..index].iter().find(meets) {
            let given = |feed: &Feed| {
                feed.pressure
                    .map_or("a pocket".to_owned(), |pressure| format!("at {}", bars(pressure)))
            };
            let message = format!(
                "overlaps \"{}\", but is {} and the other {}",
                other.group,
                given(feed),
                given(other)
            );
            let help = "give both one pressure (they are one region then), or move one of the two: by diameter, angle and z of a hole, by from, to, width and z of a groove";
            complaints.add(&key, message, help);
        }
    }
    for region in feed_regions(scene).iter().filter(|region| region.feeds.len() > 1) {
        if let Some(index) = scene.feeds.iter().position(|feed| feed.group == region.name) {
            let message = format!(
                "\"{}\" is the name of the region that other feeds are together",
                region.name
            );
            complaints.add(&format!("feed[{index}].group"), message, "name it otherwise");
        }
    }
}
