//! Feeds that overlap: at one pressure they are one region, else one of them is wrong. A pocket may touch any other
//! feed.

use oilwedge_mesh::generate::{Meeting, meeting};
use oilwedge_scene::wording::bars;
use oilwedge_scene::{Complaints, Feed, Scene};

use crate::outline::LinerOutline;

pub(super) fn check(scene: &Scene, complaints: &mut Complaints) {
    if complaints.concern("feed") || complaints.concern("bearing") {
        return;
    }
    let outline = LinerOutline::of(scene);
    for (index, feed) in scene.feeds.iter().enumerate() {
        let key = format!("feed[{index}].{}", if feed.hole.is_some() { "hole" } else { "groove" });
        let clash = |other: &Feed| {
            let both_given = feed.pressure.is_some() && other.pressure.is_some();
            match meeting(&outline.liner, &outline.shape(feed)?, &outline.shape(other)?) {
                _ if both_given && feed.pressure == other.pressure => None,
                Meeting::Overlapping => Some("overlaps"),
                Meeting::Touching if both_given => Some("touches"),
                Meeting::Touching | Meeting::Apart => None,
            }
        };
        let mut others = scene.feeds[..index].iter();
        if let Some((other, meets)) = others.find_map(|other| Some((other, clash(other)?))) {
            let given =
                |feed: &Feed| feed.pressure.map_or("a pocket".to_owned(), |pressure| format!("at {}", bars(pressure)));
            let message = format!("{meets} \"{}\", but is {} and the other {}", other.group, given(feed), given(other));
            let help = match feed.pressure.and(other.pressure) {
                Some(_) => {
                    "give both one pressure (they are one region then), or part them: by diameter, angle and z of a hole, by from, to, width and z of a groove"
                }
                None => {
                    "let the pocket end where the other begins: their straight sides may touch (from, to, width and z of a groove)"
                }
            };
            complaints.add(&key, message, help);
        }
    }
    for region in outline.regions().iter().filter(|region| region.feeds.len() > 1) {
        if let Some(index) = scene.feeds.iter().position(|feed| feed.group == region.name) {
            let message = format!("\"{}\" is the name of the region that other feeds are together", region.name);
            complaints.add(&format!("feed[{index}].group"), message, "name it otherwise");
        }
    }
}
