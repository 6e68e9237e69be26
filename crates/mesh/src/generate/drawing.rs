//! A liner as it is drawn, and everything that can be wrong with the drawing.

use super::meeting::{Meeting, align, between, distance_between, land_around, lands, outline_points};
use super::shape::Feature;
use super::sheet::LinerRectangle;
use super::union::{SAME, junctions, parts};
use crate::Defect;
use crate::developed::{LinerDomain, shorter_way};

/// Lands and features narrower than this part of the radius cannot be meshed.
const THINNEST: f64 = 1e-3;
/// Least angle [deg] of the film between the rims of two features that meet.
const SHARPEST: f64 = 20.0;
/// Places around a ring that are tried for its seam.
const SEAM_PLACES: u32 = 360;

/// A liner as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Blueprint {
    /// Radius, length and arc.
    pub liner: LinerDomain,
    /// Holes and grooves; those of one name may overlap and are one region, others may touch along straight sides.
    pub features: Vec<Feature>,
    /// Angle [rad] of an axial line that must be a line of edges (film start of a ring).
    pub line: Option<f64>,
}

/// Why a drawing cannot be meshed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// A feature reaches beyond the liner or leaves too little land.
    #[error(
        "\"{name}\" {}, and {least:.1e} m are needed; move or shrink it, or let a straight side of it, without round corners, lie on the edge",
        land_in_words(*land)
    )]
    OffLiner {
        /// Name of the feature.
        name: String,
        /// The land that is left [m]; negative where it reaches beyond.
        land: f64,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// A feature takes all of the liner.
    #[error(
        "\"{name}\" is the whole liner, so no film is left beside it; shrink it, or give bearing.clearance instead"
    )]
    WholeLiner {
        /// Name of the feature.
        name: String,
    },
    /// Two features overlap.
    #[error(
        "\"{first}\" and \"{second}\" overlap; move or shrink one (their straight sides may touch), or let two feeds of one pressure overlap: they are one region then"
    )]
    Overlap {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
    },
    /// Two features leave too little land between them.
    #[error(
        "\"{first}\" and \"{second}\" leave {land:.1e} m of land between them, and {least:.1e} m are needed; move or shrink one, or let their straight sides touch"
    )]
    ThinLand {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
        /// The land between them [m].
        land: f64,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// Two features that are cut out touch, so that no film is between their pressures.
    #[error(
        "\"{first}\" and \"{second}\" touch, and no film is between their pressures; leave land between them, or give both one pressure: they are one region then"
    )]
    NoFilmBetween {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
    },
    /// Rims meet in such a way that the film between them is a sliver.
    #[error(
        "the rims of {names} meet at {degrees:.1} deg, with a part of {side:.1e} m beside this corner; at least {least_degrees} deg and {least:.1e} m can be meshed: let straight sides touch, overlap feeds of one pressure more, or part them"
    )]
    Sliver {
        /// Names of the features, in quotes.
        names: String,
        /// Least angle of the film at a corner where their rims meet [deg].
        degrees: f64,
        /// Shortest part of a rim beside such a corner [m].
        side: f64,
        /// Least angle that can be meshed [deg].
        least_degrees: f64,
        /// Shortest part that can be meshed [m].
        least: f64,
    },
    /// A feature is too thin.
    #[error("\"{name}\" is {width:.3e} m wide, thinner than can be meshed ({least:.1e} m); widen it")]
    TooThin {
        /// Name of the feature.
        name: String,
        /// Least width of the shape [m].
        width: f64,
        /// Least width that can be meshed [m].
        least: f64,
    },
    /// The straight side between two round corners is too short.
    #[error(
        "\"{name}\" has a straight side of {side:.3e} m between its round corners, shorter than can be meshed ({least:.1e} m); make the corners meet or smaller"
    )]
    ShortSide {
        /// Name of the feature.
        name: String,
        /// Shortest side of the shape [m].
        side: f64,
        /// Shortest side that can be meshed [m].
        least: f64,
    },
    /// Corners are round, but hardly.
    #[error(
        "\"{name}\" has corners of radius {corner:.3e} m, smaller than can be meshed ({least:.1e} m); leave the radius out for sharp corners, or give a larger one"
    )]
    SmallCorner {
        /// Name of the feature.
        name: String,
        /// Radius of its corners [m].
        corner: f64,
        /// Smallest radius that can be meshed [m].
        least: f64,
    },
    /// A region of a mesh is no shape that can be drawn.
    #[error(
        "the region \"{name}\" of the mesh is neither a circle nor a rectangle along the axes, so it cannot be meshed anew; remove [mesh] size to take the mesh as it is, or give the feed's hole"
    )]
    Unrecognised {
        /// Name of the region.
        name: String,
    },
    /// The triangulation failed, or would be too large.
    #[error("the liner cannot be meshed with triangles of {size:.3e} m: {reason}")]
    Failed {
        /// Size asked for [m].
        size: f64,
        /// The cause, in words.
        reason: String,
    },
    /// The mesh has defects.
    #[error("the mesh made of the drawing has defects: {0}")]
    Defective(Defect),
}

/// How much land a feature leaves [m].
fn land_in_words(land: f64) -> String {
    match land {
        beyond if beyond < 0.0 => format!("reaches {:.3e} m beyond the edge of the liner", -beyond),
        0.0 => "leaves no land to the edge of the liner".to_owned(),
        land => format!("leaves only {land:.3e} m of land to the edge of the liner"),
    }
}

/// This drawing with each feature on the turn of the liner: an angle may be given as 350 or as -10 degrees. Sides that
/// touch do so to the last digit, and features that others of their name hold are left out.
pub(super) fn placed(blueprint: &Blueprint) -> Blueprint {
    let mut placed = blueprint.clone();
    let turn = blueprint.liner.circumference();
    let sheet = LinerRectangle::of(&blueprint.liner, 0.0);
    let middle = sheet.start + 0.5 * sheet.width;
    for feature in &mut placed.features {
        let x = &mut feature.shape.centre[0];
        *x += turn * ((middle - *x) / turn).round();
    }
    let line = blueprint.line.map(|angle| blueprint.liner.radius * angle);
    align(&mut placed.features, &blueprint.liner, line);
    let all = placed.features.clone();
    let is_held = |index: usize, feature: &Feature| {
        (all.iter().enumerate()).any(|(other, holder)| {
            let is_other = other != index && holder.name == feature.name;
            // Of two that are alike the first one stays.
            is_other && holds(&sheet, holder, feature) && (other < index || !holds(&sheet, feature, holder))
        })
    };
    placed.features = (all.iter().enumerate())
        .filter(|(index, feature)| !is_held(*index, feature))
        .map(|(_, feature)| feature.clone())
        .collect();
    placed
}

/// Whether one feature lies within another of its kind.
fn holds(sheet: &LinerRectangle, outer: &Feature, inner: &Feature) -> bool {
    let near = SAME * sheet.width;
    let mut outline = outline_points(sheet, inner).into_iter();
    outer.meshed == inner.meshed && outline.all(|point| outer.shape.distance(point, sheet.period()) < near)
}

/// Whether two features of one name are one region.
fn are_joined(sheet: &LinerRectangle, one: &Feature, other: &Feature) -> bool {
    between(sheet, one, other, SAME * sheet.width) != Meeting::Apart
}

/// Everything that is wrong with the drawing.
pub(super) fn faults(blueprint: &Blueprint) -> Vec<DrawingError> {
    let sheet = LinerRectangle::of(&blueprint.liner, 0.0);
    let least = THINNEST * blueprint.liner.radius;
    let near = SAME * sheet.width;
    let mut faults = Vec::new();
    for (index, feature) in blueprint.features.iter().enumerate() {
        let name = &feature.name;
        let width = 2.0 * feature.shape.half[0].min(feature.shape.half[1]);
        if width < least {
            faults.push(DrawingError::TooThin { name: name.clone(), width, least });
            continue;
        }
        let corner = feature.shape.corner;
        if corner > 0.0 && corner < 0.5 * least {
            faults.push(DrawingError::SmallCorner { name: name.clone(), corner, least: 0.5 * least });
        }
        let shortest = feature.shape.shortest_side();
        if shortest < least {
            faults.push(DrawingError::ShortSide { name: name.clone(), side: shortest, least });
        }
        faults.extend(land_fault(&sheet, feature, least));
        let line = to_line(blueprint, feature);
        // A pocket may begin or end at the line.
        let is_at_line = feature.meshed && corner == 0.0 && line <= near;
        if line < least && !is_at_line {
            let (first, second) = (name.clone(), LINE.to_owned());
            let land = line;
            faults.push(DrawingError::ThinLand { first, second, land, least });
        }
        for other in &blueprint.features[index + 1..] {
            let is_union = feature.name == other.name && are_joined(&sheet, feature, other);
            faults.extend((!is_union).then(|| fault_between(&sheet, feature, other, least)).flatten());
        }
    }
    if faults.is_empty() {
        faults.extend(slivers(blueprint, least));
    }
    faults
}

/// What is wrong with the land between a feature and the edges of the liner.
fn land_fault(sheet: &LinerRectangle, feature: &Feature, least: f64) -> Option<DrawingError> {
    let near = SAME * sheet.width;
    let lands = lands(sheet, &feature.shape);
    let name = feature.name.clone();
    let at_edges = lands.iter().filter(|land| land.abs() <= near).count();
    if at_edges == lands.len() {
        return Some(DrawingError::WholeLiner { name });
    }
    let is_sharp = feature.shape.corner == 0.0;
    let narrow = lands.into_iter().filter(|land| *land < least && !(is_sharp && land.abs() <= near));
    let land = narrow.min_by(f64::total_cmp)?;
    Some(DrawingError::OffLiner { name, land, least })
}

/// What is wrong with two features that are no union.
fn fault_between(sheet: &LinerRectangle, one: &Feature, other: &Feature, least: f64) -> Option<DrawingError> {
    let near = SAME * sheet.width;
    let (first, second) = (one.name.clone(), other.name.clone());
    let land = match between(sheet, one, other, near) {
        Meeting::Overlapping => return Some(DrawingError::Overlap { first, second }),
        Meeting::Touching if !one.meshed && !other.meshed => {
            return Some(DrawingError::NoFilmBetween { first, second });
        }
        Meeting::Touching => land_around(sheet, one, other, near),
        Meeting::Apart => distance_between(sheet, one, other),
    };
    (land < least).then_some(DrawingError::ThinLand { first, second, land, least })
}

/// Corners at which rims meet that are too sharp for the film, or too near to each other.
fn slivers(blueprint: &Blueprint, least: f64) -> Vec<DrawingError> {
    let sheet = LinerRectangle::of(&blueprint.liner, seam_place(blueprint));
    let mut slivers: Vec<DrawingError> = Vec::new();
    for junction in junctions(&sheet, &parts(&sheet, &blueprint.features)) {
        let (degrees, side) = (junction.angle.to_degrees(), junction.side);
        if degrees < SHARPEST || side < least {
            let mut names: Vec<String> =
                (junction.features.iter()).map(|&index| format!("\"{}\"", blueprint.features[index].name)).collect();
            names.dedup();
            let names = names.join(" and ");
            let is_told = |told: &DrawingError| matches!(told, DrawingError::Sliver { names: of, .. } if *of == names);
            if !slivers.iter().any(is_told) {
                slivers.push(DrawingError::Sliver { names, degrees, side, least_degrees: SHARPEST, least });
            }
        }
    }
    slivers
}

/// What messages call the axial line of a drawing.
const LINE: &str = "the film start";

/// Distance [m] of the sides of a feature from the axial line of the drawing, which may cross it.
fn to_line(blueprint: &Blueprint, feature: &Feature) -> f64 {
    let liner = &blueprint.liner;
    blueprint.line.map_or(f64::INFINITY, |angle| {
        let along = shorter_way(liner.radius * angle - feature.shape.centre[0], liner.circumference());
        (along.abs() - feature.shape.half[0]).abs()
    })
}

/// Free land [m] around each feature, where it touches nothing.
pub(super) fn gaps(blueprint: &Blueprint, sheet: &LinerRectangle) -> Vec<f64> {
    let features = &blueprint.features;
    let near = SAME * sheet.width;
    let land_between = |one: &Feature, other: &Feature| match between(sheet, one, other, near) {
        Meeting::Apart => distance_between(sheet, one, other),
        Meeting::Touching => land_around(sheet, one, other, near),
        Meeting::Overlapping => f64::INFINITY,
    };
    (features.iter().enumerate())
        .map(|(index, feature)| {
            let others = (features.iter().enumerate()).filter(|(other, _)| *other != index);
            let lands = lands(sheet, &feature.shape).into_iter().chain([to_line(blueprint, feature)]);
            let lands = lands.filter(|land| *land > near);
            others.map(|(_, other)| land_between(feature, other)).chain(lands).fold(f64::INFINITY, f64::min)
        })
        .collect()
}

/// Where a ring is cut [m]: at its line if it has one, else where no feature is near, else through the
/// middle of features rather than along their edges.
pub(super) fn seam_place(blueprint: &Blueprint) -> f64 {
    let radius = blueprint.liner.radius;
    if let Some(angle) = blueprint.line {
        return radius * angle;
    }
    let turn = blueprint.liner.circumference();
    let clearance = |x: f64| {
        (blueprint.features.iter())
            .filter(|feature| !feature.shape.is_full_turn())
            .map(|feature| {
                let along = shorter_way(x - feature.shape.centre[0], turn).abs();
                (along - feature.shape.half[0]).abs() / feature.shape.half[0].min(0.1 * turn)
            })
            .fold(f64::INFINITY, f64::min)
    };
    let places = (0..SEAM_PLACES).map(|k| turn * f64::from(k) / f64::from(SEAM_PLACES));
    let crossed = |x: f64| {
        let inside = |feature: &&Feature| {
            let along = shorter_way(x - feature.shape.centre[0], turn).abs();
            along < feature.shape.half[0] && !feature.shape.is_full_turn()
        };
        blueprint.features.iter().filter(inside).count()
    };
    // Fewest crossings, then the greatest clearance (capped: beyond two sizes it does not matter).
    let rank = |x: f64| (crossed(x), -clearance(x).min(1.0));
    let best = places.min_by(|&a, &b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    best.unwrap_or(0.0)
}
