//! A liner as it is drawn, and everything that can be wrong with the drawing.

use super::outline::Sheet;
use super::shape::Feature;
use crate::Defect;
use crate::developed::{Liner, shorter_way};

/// Lands and features narrower than this part of the radius cannot be meshed.
const THINNEST: f64 = 1e-3;
/// Places around a ring that are tried for its seam.
const SEAM_PLACES: u32 = 360;

/// A liner as it is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Blueprint {
    /// Radius, length and arc.
    pub liner: Liner,
    /// Holes and grooves.
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
        "\"{name}\" leaves {land:.3e} m of land to the edge of the liner (less than zero: it reaches beyond), and {least:.1e} m are needed; move or shrink it"
    )]
    OffLiner {
        /// Name of the feature.
        name: String,
        /// The land that is left [m]; negative where it reaches beyond.
        land: f64,
        /// Least land that can be meshed [m].
        least: f64,
    },
    /// Two features overlap or leave too little land between them.
    #[error(
        "\"{first}\" and \"{second}\" overlap or leave less than {least:.1e} m of land between them; move or shrink one"
    )]
    Overlap {
        /// Name of a feature.
        first: String,
        /// Name of the other.
        second: String,
        /// Least land that can be meshed [m].
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

/// This drawing with each feature on the turn of the liner: an angle may be given as 350 or as -10 degrees.
pub(super) fn placed(blueprint: &Blueprint) -> Blueprint {
    let mut placed = blueprint.clone();
    let turn = blueprint.liner.circumference();
    let sheet = Sheet::of(&blueprint.liner, 0.0);
    let middle = sheet.start + 0.5 * sheet.width;
    for feature in &mut placed.features {
        let x = &mut feature.shape.centre[0];
        *x += turn * ((middle - *x) / turn).round();
    }
    placed
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
            faults.push(DrawingError::OffLiner {
                name: name.clone(),
                land,
                least,
            });
        }
        if to_line(blueprint, feature) < least {
            let (first, second) = (name.clone(), LINE.to_owned());
            faults.push(DrawingError::Overlap { first, second, least });
        }
        for other in &blueprint.features[index + 1..] {
            if distance_between(&sheet, feature, other) < least {
                let (first, second) = (name.clone(), other.name.clone());
                faults.push(DrawingError::Overlap { first, second, least });
            }
        }
    }
    faults
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
    let ends = 0.5 * sheet.length - shape.centre[1].abs() - shape.half[1];
    let [x, half] = [shape.centre[0], shape.half[0]];
    let around = match (sheet.ring, shape.is_full_turn()) {
        (true, true) => f64::INFINITY,
        (true, false) => sheet.width - 2.0 * half,
        (false, true) => -sheet.width,
        (false, false) => (x - half - sheet.start).min(sheet.end() - x - half),
    };
    ends.min(around)
}

/// Distance [m] between the outlines of two features; negative where they overlap.
fn distance_between(sheet: &Sheet, a: &Feature, b: &Feature) -> f64 {
    let to = |from: &Feature, to: &Feature| {
        outline_points(sheet, from)
            .into_iter()
            .map(|point| to.shape.distance(point, sheet.period()))
            .fold(f64::INFINITY, f64::min)
    };
    to(a, b).min(to(b, a))
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
            let others = features.iter().enumerate().filter(|(other, _)| *other != index);
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
