//! Which of the standard's feeds the holes and grooves of a scene are.

use std::f64::consts::{FRAC_PI_4, PI};

use oilwedge_scene::Scene;

use super::twin::{Fed, StandardFeed};

/// Width over B of pockets for which their flow was fitted.
const POCKET: [f64; 2] = [0.05, 0.7];
/// Extent [rad] of a pocket at most.
const SHORT: f64 = 0.5 * PI;
/// Extent [rad] of a groove along half of the liner, at least and at most.
const HALF: [f64; 2] = [0.8 * PI, 1.2 * PI];

/// The feed in the terms of the standard with its pressure [Pa] above that of the ends; nothing where oil comes from
/// the ends only, or why the standard has none like that.
pub(super) fn fed(scene: &Scene, load_angle: f64) -> Fed {
    let feeds: Vec<_> =
        (scene.feeds.iter()).filter_map(|feed| Some((feed, feed.pressure? - scene.ends.pressure))).collect();
    let pressure = match feeds[..] {
        [] => return Ok(None),
        [(_, a), (_, b)] if a != b => return unknown("feeds of different pressures"),
        [(_, pressure)] | [(_, pressure), _] => pressure,
        _ => return unknown("more than two feeds"),
    };
    let feeds: Vec<&oilwedge_scene::Feed> = feeds.into_iter().map(|(feed, _)| feed).collect();
    Ok(Some((kind(&feeds, scene.bearing.length, load_angle)?, pressure)))
}

fn unknown<T>(what: &str) -> Result<T, String> {
    Err(format!("the standard has no flow through {what}: side_flow is left out"))
}

/// What one feed, or two, are to the standard.
fn kind(feeds: &[&oilwedge_scene::Feed], length: f64, load_angle: f64) -> Result<StandardFeed, String> {
    let feed = feeds[0];
    let places: Vec<Option<LoadSide>> = feeds
        .iter()
        .map(|feed| {
            let middle = feed.groove.and_then(|groove| groove.arc).map(|arc| 0.5 * (arc.from + arc.to));
            let angle = feed.hole.map(|hole| hole.angle).or(middle);
            angle.map(|angle| side(angle - load_angle.to_radians()))
        })
        .collect();
    Ok(match (feed.hole, feed.groove, &places[..]) {
        (Some(hole), _, [Some(LoadSide::Opposite)]) => StandardFeed::HoleOpposite(hole.diameter / length),
        (Some(hole), _, [Some(LoadSide::Across)]) => StandardFeed::HoleAcross(hole.diameter / length),
        (Some(hole), _, [Some(LoadSide::Across), Some(LoadSide::Across)])
            if feeds.iter().all(|it| it.hole.map(|it| it.diameter) == Some(hole.diameter)) =>
        {
            StandardFeed::TwoHolesAcross(hole.diameter / length)
        }
        (_, Some(groove), [None]) => StandardFeed::GrooveAround(groove.width / length),
        (_, Some(groove), [Some(place)]) => {
            let extent = groove.arc.map_or(0.0, |arc| arc.to - arc.from);
            let width = groove.width / length;
            let is_pocket = (POCKET[0]..=POCKET[1]).contains(&width) && extent <= SHORT;
            match place {
                LoadSide::Opposite if (HALF[0]..=HALF[1]).contains(&extent) => StandardFeed::GrooveHalf(width),
                LoadSide::Opposite if is_pocket => StandardFeed::PocketOpposite(width),
                LoadSide::Across if is_pocket => StandardFeed::PocketAcross(width),
                _ => return unknown("a groove like this"),
            }
        }
        (_, Some(groove), [Some(LoadSide::Across), Some(LoadSide::Across)])
            if feeds.iter().all(|it| it.groove.map(|it| it.width) == Some(groove.width)) =>
        {
            StandardFeed::TwoPocketsAcross(groove.width / length)
        }
        _ => return unknown("feeds that lie like these"),
    })
}

/// Side of the load on which a feed lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum LoadSide {
    Loaded,
    Across,
    Opposite,
}

/// The side of a feed at this angle [rad] from the load: the nearest of the standard's places.
fn side(angle: f64) -> LoadSide {
    match angle.cos() {
        cos if cos < -FRAC_PI_4.cos() => LoadSide::Opposite,
        cos if cos > FRAC_PI_4.cos() => LoadSide::Loaded,
        _ => LoadSide::Across,
    }
}

/// The feed in words.
pub(super) fn words(feed: StandardFeed) -> &'static str {
    match feed {
        StandardFeed::HoleOpposite(_) => "a hole opposite to the load",
        StandardFeed::HoleAcross(_) => "a hole at 90 degrees to the load",
        StandardFeed::TwoHolesAcross(_) => "two holes at 90 degrees to the load",
        StandardFeed::PocketOpposite(_) => "a pocket opposite to the load",
        StandardFeed::PocketAcross(_) => "a pocket at 90 degrees to the load",
        StandardFeed::TwoPocketsAcross(_) => "two pockets at 90 degrees to the load",
        StandardFeed::GrooveAround(_) => "a groove all around",
        StandardFeed::GrooveHalf(_) => "a groove along the half opposite to the load",
    }
}
