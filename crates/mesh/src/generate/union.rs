//! Features of one name are one region: where they overlap, only the outline of their union is one. Features that touch
//! share a part of their outlines.
//!
//! Each piece of an outline is cut where it meets the outlines of the others; the parts inside another feature of its
//! name go. What stays bounds the union, counter-clockwise about it. A common part stays once, with the feature that is
//! cut out if one of them is.

use super::shape::{Feature, OutlinePiece};
use super::sheet::{LinerRectangle, on_sheet};

/// Points nearer than this part of the circumference are one.
pub(super) const SAME: f64 = 1e-11;

/// A part of the outline of a feature, by the index of that feature.
pub(super) type OutlinePart = (usize, OutlinePiece);

/// The outlines of all features on the sheet, but for what lies on the ends of the liner: of features of one name that
/// of their union.
pub(super) fn parts(sheet: &LinerRectangle, features: &[Feature]) -> Vec<OutlinePart> {
    let own = |(index, feature): (usize, &Feature)| {
        let pieces = on_sheet(sheet, feature);
        pieces.into_iter().map(move |piece| (index, piece)).collect::<Vec<OutlinePart>>()
    };
    of_outlines(sheet, features, features.iter().enumerate().flat_map(own).collect())
}

/// What of the `parts` of the outlines of `features`, laid on `sheet`, bounds the unions of those of one name.
fn of_outlines(sheet: &LinerRectangle, features: &[Feature], parts: Vec<OutlinePart>) -> Vec<OutlinePart> {
    let near = SAME * sheet.width;
    let cut = |(index, piece): &OutlinePart| {
        let others = parts.iter().filter(|(other, _)| other != index);
        let mut places: Vec<f64> = others.flat_map(|(_, other)| piece.meets(other, near)).collect();
        places.sort_unstable_by(f64::total_cmp);
        let cuts = piece.divided(&places, near);
        cuts.into_iter().map(|cut| (*index, cut)).collect::<Vec<OutlinePart>>()
    };
    let is_outer = |(index, piece): &OutlinePart| {
        (0..features.len())
            .filter(|other| other != index)
            .all(|other| !covers(sheet, features, other, (*index, piece), near))
    };
    parts.iter().flat_map(cut).filter(is_outer).collect()
}

/// Whether a part of the outline of a feature lies inside another of its name, or is that of another. Of two that run
/// along each other one is kept if both features lie on the same side, or have two names.
fn covers(
    sheet: &LinerRectangle,
    features: &[Feature],
    other: usize,
    (index, piece): (usize, &OutlinePiece),
    near: f64,
) -> bool {
    let shape = &features[other].shape;
    let middle = piece.at(0.5);
    let distance = shape.distance(middle, sheet.period());
    let is_union = features[other].name == features[index].name;
    if distance.abs() > near {
        return is_union && distance < 0.0;
    }
    if !is_union {
        let rank = |index: usize| (features[index].meshed, index);
        return rank(other) < rank(index);
    }
    let [along, across] = piece.direction(0.5);
    let outside = [middle[0] + 1e3 * near * across, middle[1] - 1e3 * near * along];
    shape.distance(outside, sheet.period()) < 0.0 || other < index
}

/// A corner at which the rims of features meet.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Junction {
    /// The features, by ascending index.
    pub(super) features: Vec<usize>,
    /// Least angle [rad] between two parts of rims.
    pub(super) angle: f64,
    /// Middle of the shortest part of a rim that ends there.
    pub(super) middle: [f64; 2],
    /// Length [m] of this part.
    pub(super) side: f64,
}

/// An end of a part: the part, where it ends, and the direction [rad] in which the part leaves from there.
struct PartEnd<'a> {
    part: &'a OutlinePart,
    at: [f64; 2],
    angle: f64,
}

/// The corners at which the rims of two or more features meet.
pub(super) fn junctions(sheet: &LinerRectangle, parts: &[OutlinePart]) -> Vec<Junction> {
    let near = 1e2 * SAME * sheet.width;
    let ends_of = |part| {
        [(0.0, 1.0), (1.0, -1.0)].map(|(s, sense): (f64, f64)| {
            let (_, piece): &OutlinePart = part;
            let [u, v] = piece.direction(s).map(|x| sense * x);
            let (at, angle) = (piece.at(s), v.atan2(u));
            PartEnd { part, at, angle }
        })
    };
    let mut ends: Vec<PartEnd> = parts.iter().flat_map(ends_of).collect();
    let mut junctions = Vec::new();
    while let Some(first) = ends.pop() {
        let is_here = |end: &PartEnd| (end.at[0] - first.at[0]).hypot(end.at[1] - first.at[1]) <= near;
        let (mut here, elsewhere): (Vec<_>, Vec<_>) = ends.into_iter().partition(is_here);
        ends = elsewhere;
        here.push(first);
        let mut features: Vec<usize> = here.iter().map(|end| end.part.0).collect();
        features.sort_unstable();
        features.dedup();
        if features.len() < 2 {
            continue;
        }
        let mut angles: Vec<f64> = here.iter().map(|end| end.angle).collect();
        angles.sort_unstable_by(f64::total_cmp);
        angles.push(angles[0] + std::f64::consts::TAU);
        let angle = angles.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min);
        let lengths = here.iter().map(|end| (end.part.1.length(), end.part.1.at(0.5)));
        if let Some((side, middle)) = lengths.min_by(|a, b| a.0.total_cmp(&b.0)) {
            junctions.push(Junction { features, angle, middle, side });
        }
    }
    junctions
}

#[cfg(test)]
mod tests {
    use super::super::shape::RoundedRectangle;
    use super::*;
    use crate::developed::LinerDomain;

    fn sheet() -> LinerRectangle {
        let liner = LinerDomain { radius: 0.5, length: 2.0, arc: None };
        LinerRectangle::of(&liner, 0.0)
    }

    fn feature(shape: RoundedRectangle) -> Feature {
        Feature { name: "one".to_owned(), shape, meshed: false }
    }

    fn rectangle(centre: [f64; 2], half: [f64; 2]) -> Feature {
        let corner = 0.0;
        feature(RoundedRectangle { centre, half, corner })
    }

    /// Area inside outer parts, by Green's theorem.
    fn area(features: &[Feature]) -> f64 {
        let sheet = sheet();
        let parts = (features.iter().enumerate())
            .flat_map(|(index, feature)| {
                let pieces = feature.shape.outline(sheet.start, sheet.width);
                pieces.into_iter().map(move |piece| (index, piece))
            })
            .collect();
        let mut twice = 0.0;
        for (_, piece) in of_outlines(&sheet, features, parts) {
            for k in 0..2000 {
                let (p, q) = (piece.at(f64::from(k) / 2000.0), piece.at(f64::from(k + 1) / 2000.0));
                twice += p[0] * q[1] - p[1] * q[0];
            }
        }
        0.5 * twice
    }

    #[test]
    fn areas_of_unions() {
        let groove = rectangle([1.5, 0.0], [0.4, 0.1]);
        let disc = |x: f64, z: f64| feature(RoundedRectangle::disc([x, z], 0.2));
        let whole = std::f64::consts::PI * 0.04;
        // A disc amid a narrower groove: two caps stand out.
        let half = (0.5f64).acos();
        let caps = 2.0 * (0.04 * half - 0.1 * 0.2 * half.sin());
        let cases = [
            (vec![groove.clone(), disc(1.5, 0.0)], 0.16 + caps),
            (vec![disc(1.5, 0.0), groove.clone()], 0.16 + caps),
            // A disc half beyond its end.
            (vec![groove.clone(), disc(1.5, 0.1)], 0.16 + 0.5 * whole),
            (vec![groove.clone(), rectangle([1.5, 0.0], [0.1, 0.3])], 0.16 + 0.12 - 0.04),
            // Side by side, and one inside the other with a common side.
            (vec![groove.clone(), rectangle([2.2, 0.0], [0.3, 0.1])], 0.28),
            (vec![groove.clone(), rectangle([1.5, 0.05], [0.1, 0.05])], 0.16),
            (vec![groove.clone(), groove.clone()], 0.16),
            (vec![groove, rectangle([1.5, 0.2], [0.1, 0.1])], 0.16 + 0.04),
        ];
        for (features, wanted) in cases {
            let area = area(&features);
            assert!((area / wanted - 1.0).abs() < 1e-6, "{features:?}: {area} {wanted}");
        }
    }
}
