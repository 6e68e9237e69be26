//! A liner as it is drawn, and everything that can be wrong with the drawing.

use super::shape::{Feature, Piece, Shape};
use super::sheet::{Sheet, on_sheet};
use super::union::{SAME, narrowest, parts};
use crate::Defect;
use crate::developed::{Liner, shorter_way};

/// Lands and features narrower than this part of the radius cannot be meshed.
const THINNEST: f64 = 1e-3;
/// Least angle [deg] of the film between the rims of two features that are one region.
const SHARPEST: f64 = 20.0;
/// Places around a ring that are tried for its seam.
const SEAM_PLACES: u32 = 360;

/// A liner as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Blueprint {
    /// Radius, length and arc.
    pub liner: Liner,
    /// Holes and grooves; those of one name may overlap and are one region.
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
        "\"{name}\" {}, and {least:.1e} m are needed; move or shrink it{}",
        land_in_words(*land),
        if *spans { ", or give a groove of given pressure the length of the bearing, without corners: it divides the film then" } else { "" }
    )]
    OffLiner {
        /// Name of the feature.
        name: String,
        /// The land that is left [m]; negative where it reaches beyond.
        land: f64,
        /// Whether it is a groove that reaches an end of the bearing, or almost.
        spans: bool,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// Two features overlap or leave too little land between them.
    #[error(
        "\"{first}\" and \"{second}\" overlap or leave less than {least:.1e} m of land between them; move or shrink one, or let two feeds of one pressure overlap: they are one region then"
    )]
    Overlap {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// Features of one name overlap by so little that the film between their rims is a sliver.
    #[error(
        "the rims of \"{name}\" meet at an angle of {degrees:.1} deg of the film, with a part of {side:.1e} m between two corners; at least {least_degrees} deg and {least:.1e} m can be meshed: let the feeds overlap more, or part them"
    )]
    Sliver {
        /// Name of the features.
        name: String,
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
        /// Its least width [m].
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
        /// Its shortest side [m].
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
        /// Why.
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

/// This drawing with each feature on the turn of the liner: an angle may be given as 350 or as -10 degrees. A groove that spans the liner does so
/// to the last digit, and features that others of their name hold are left out.
pub(super) fn placed(blueprint: &Blueprint) -> Blueprint {
    let mut placed = blueprint.clone();
    let turn = blueprint.liner.circumference();
    let sheet = Sheet::of(&blueprint.liner, 0.0);
    let middle = sheet.start + 0.5 * sheet.width;
    for feature in &mut placed.features {
        let x = &mut feature.shape.centre[0];
        *x += turn * ((middle - *x) / turn).round();
        if sheet.is_spanned_by(&feature.shape) {
            (feature.shape.centre[1], feature.shape.half[1]) = (0.0, 0.5 * sheet.length);
        }
    }
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
fn holds(sheet: &Sheet, outer: &Feature, inner: &Feature) -> bool {
    let near = SAME * sheet.width;
    let mut outline = outline_points(sheet, inner).into_iter();
    outer.meshed == inner.meshed && outline.all(|point| outer.shape.distance(point, sheet.period()) < near)
}

/// Whether two shapes on a liner overlap or touch.
pub fn overlap(liner: &Liner, one: &Shape, other: &Shape) -> bool {
    let sheet = Sheet::of(liner, 0.0);
    let between = [0, 1].map(|axis| one.centre[axis] - other.centre[axis]);
    let apart = [shorter_way(between[0], liner.circumference()), between[1]];
    let is_far = |axis: usize| apart[axis].abs() > (1.0 + 1e-9) * (one.half[axis] + other.half[axis]);
    if is_far(0) || is_far(1) {
        return false;
    }
    let [one, other] = [one, other].map(|shape| Feature {
        name: String::new(),
        shape: *shape,
        meshed: false,
    });
    are_joined(&sheet, &one, &other)
}

fn are_joined(sheet: &Sheet, one: &Feature, other: &Feature) -> bool {
    distance_between(sheet, one, other) <= SAME * sheet.width
}

/// Everything that is wrong with the drawing.
pub(super) fn faults(blueprint: &Blueprint) -> Vec<DrawingError> {
    let sheet = Sheet::of(&blueprint.liner, 0.0);
    let least = THINNEST * blueprint.liner.radius;
    let mut faults = Vec::new();
    for (index, feature) in blueprint.features.iter().enumerate() {
        let name = &feature.name;
        let width = 2.0 * feature.shape.half[0].min(feature.shape.half[1]);
        if width < least {
            faults.push(DrawingError::TooThin {
                name: name.clone(),
                width,
                least,
            });
            continue;
        }
        let corner = feature.shape.corner;
        if corner > 0.0 && corner < 0.5 * least {
            faults.push(DrawingError::SmallCorner {
                name: name.clone(),
                corner,
                least: 0.5 * least,
            });
        }
        let shortest = feature.shape.shortest_side();
        if shortest < least {
            faults.push(DrawingError::ShortSide {
                name: name.clone(),
                side: shortest,
                least,
            });
        }
        let land = land(&sheet, feature);
        if land < least {
            let is_groove = !feature.shape.is_full_turn() && !feature.shape.is_disc();
            faults.push(DrawingError::OffLiner {
                name: name.clone(),
                land,
                spans: is_groove && land_at_ends(&sheet, &feature.shape) < least,
                least,
            });
        }
        if to_line(blueprint, feature) < least {
            let (first, second) = (name.clone(), LINE.to_owned());
            faults.push(DrawingError::Overlap { first, second, least });
        }
        for other in &blueprint.features[index + 1..] {
            let is_union = feature.name == other.name && are_joined(&sheet, feature, other);
            if !is_union && distance_between(&sheet, feature, other) < least {
                let (first, second) = (name.clone(), other.name.clone());
                faults.push(DrawingError::Overlap { first, second, least });
            }
        }
    }
    if faults.is_empty() {
        faults.extend(slivers(blueprint, least));
    }
    faults
}

/// Unions whose corners are too sharp for the film, or too near to each other.
fn slivers(blueprint: &Blueprint, least: f64) -> Vec<DrawingError> {
    let sheet = Sheet::of(&blueprint.liner, seam_place(blueprint));
    let parts = parts(&sheet, &blueprint.features);
    let mut names: Vec<&str> = blueprint.features.iter().map(|feature| feature.name.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    let sliver = |name: &str| {
        let own = parts
            .iter()
            .filter(|(index, _)| blueprint.features[*index].name == name);
        let [angle, side] = narrowest(&sheet, &own.copied().collect::<Vec<_>>());
        let degrees = angle.to_degrees();
        (degrees < SHARPEST || side < least).then(|| DrawingError::Sliver {
            name: name.to_owned(),
            degrees,
            side,
            least_degrees: SHARPEST,
            least,
        })
    };
    names.into_iter().filter_map(sliver).collect()
}

/// Points along the outline of a feature, on its own turn of the ring.
fn outline_points(sheet: &Sheet, feature: &Feature) -> Vec<[f64; 2]> {
    const A_PIECE: u32 = 64;
    let pieces = feature.shape.outline(sheet.start, sheet.width);
    pieces
        .iter()
        .flat_map(|piece| (0..A_PIECE).map(|k| piece.at(f64::from(k) / f64::from(A_PIECE))))
        .collect()
}

/// Least land [m] between a feature and the edge of the liner; negative where it reaches out.
fn land(sheet: &Sheet, feature: &Feature) -> f64 {
    let shape = &feature.shape;
    let ends = land_at_ends(sheet, shape);
    let [x, half] = [shape.centre[0], shape.half[0]];
    let around = match (sheet.ring, shape.is_full_turn()) {
        (true, true) => f64::INFINITY,
        (true, false) => sheet.width - 2.0 * half,
        (false, true) => -sheet.width,
        (false, false) => (x - half - sheet.start).min(sheet.end() - x - half),
    };
    ends.min(around)
}

/// Least land [m] between a shape and the ends; infinite where it spans the liner.
fn land_at_ends(sheet: &Sheet, shape: &Shape) -> f64 {
    match sheet.is_spanned_by(shape) {
        true => f64::INFINITY,
        false => 0.5 * sheet.length - shape.centre[1].abs() - shape.half[1],
    }
}

/// Distance [m] between the outlines of two features; zero or less where they overlap.
fn distance_between(sheet: &Sheet, a: &Feature, b: &Feature) -> f64 {
    let to = |from: &Feature, to: &Feature| {
        outline_points(sheet, from)
            .into_iter()
            .map(|point| to.shape.distance(point, sheet.period()))
            .fold(f64::INFINITY, f64::min)
    };
    let near = SAME * sheet.width;
    let outlines = [a, b].map(|feature| on_sheet(sheet, feature));
    let meet = |piece: &Piece| outlines[1].iter().any(|other| !piece.meets(other, near).is_empty());
    let met = if outlines[0].iter().any(meet) {
        0.0
    } else {
        f64::INFINITY
    };
    to(a, b).min(to(b, a)).min(met)
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

/// Free land [m] around each feature.
pub(super) fn gaps(blueprint: &Blueprint, sheet: &Sheet) -> Vec<f64> {
    let features = &blueprint.features;
    (features.iter().enumerate())
        .map(|(index, feature)| {
            let is_apart = |other: &Feature| other.name != feature.name || !are_joined(sheet, feature, other);
            let others = (features.iter().enumerate()).filter(|(other, it)| *other != index && is_apart(it));
            let nearest = others.map(|(_, other)| distance_between(sheet, feature, other));
            nearest.fold(land(sheet, feature).min(to_line(blueprint, feature)), f64::min)
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
