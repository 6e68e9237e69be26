//! Features of one name are one region: where they overlap, only the outline of their union is one.
//!
//! Each piece of an outline is cut where it meets the outlines of the others; the parts inside another feature go. What stays
//! bounds the union, counter-clockwise about it.

use super::shape::{Feature, Piece};
use super::sheet::{Sheet, on_sheet};

/// Points nearer than this part of the circumference are one.
pub(super) const SAME: f64 = 1e-11;

/// A part of the outline of a feature, by the index of that feature.
pub(super) type Part = (usize, Piece);

/// The outlines of all features on the sheet, but for what lies on the ends of the liner: of features of one name that of their union.
pub(super) fn parts(sheet: &Sheet, features: &[Feature]) -> Vec<Part> {
    let own = |(index, feature): (usize, &Feature)| {
        let pieces = on_sheet(sheet, feature);
        pieces
            .into_iter()
            .map(move |piece| (index, piece))
            .collect::<Vec<Part>>()
    };
    of_outlines(sheet, features, features.iter().enumerate().flat_map(own).collect())
}

/// What of the `parts` of the outlines of `features`, laid on `sheet`, bounds the unions of those of one name.
fn of_outlines(sheet: &Sheet, features: &[Feature], parts: Vec<Part>) -> Vec<Part> {
    let near = SAME * sheet.width;
    let are_joined = |a: usize, b: usize| a != b && features[a].name == features[b].name;
    let is_alone = |index: usize| (0..features.len()).all(|other| !are_joined(index, other));
    let cut = |(index, piece): &Part| {
        let others = parts.iter().filter(|(other, _)| are_joined(*index, *other));
        let mut places: Vec<f64> = others.flat_map(|(_, other)| piece.meets(other, near)).collect();
        places.sort_unstable_by(f64::total_cmp);
        let cuts = piece.divided(&places, near);
        cuts.into_iter().map(|cut| (*index, cut)).collect::<Vec<Part>>()
    };
    let is_outer = |(index, piece): &Part| {
        (0..features.len())
            .filter(|&other| are_joined(*index, other))
            .all(|other| !covers(sheet, features, other, (*index, piece), near))
    };
    (parts.iter())
        .flat_map(|part| if is_alone(part.0) { vec![*part] } else { cut(part) })
        .filter(is_outer)
        .collect()
}

/// Whether a feature holds a part of the outline of another. Of two that run along each other one is kept if both features lie on the same side.
fn covers(sheet: &Sheet, features: &[Feature], other: usize, (index, piece): (usize, &Piece), near: f64) -> bool {
    let shape = &features[other].shape;
    let middle = piece.at(0.5);
    let distance = shape.distance(middle, sheet.period());
    if distance.abs() > near {
        return distance < 0.0;
    }
    let [along, across] = piece.direction(0.5);
    let outside = [middle[0] + 1e3 * near * across, middle[1] - 1e3 * near * along];
    shape.distance(outside, sheet.period()) < 0.0 || other < index
}

/// Least angle [rad] of the film at the corners where the rims of two features of one name meet, and the length [m] of the shortest part of a rim
/// between them; infinite where the rims do not meet.
pub(super) fn narrowest(sheet: &Sheet, parts: &[Part]) -> [f64; 2] {
    let near = 1e2 * SAME * sheet.width;
    let mut narrowest = [f64::INFINITY; 2];
    for (a, before) in parts {
        for (_, after) in parts.iter().filter(|(b, _)| a != b) {
            let (end, start) = (before.at(1.0), after.at(0.0));
            if (end[0] - start[0]).hypot(end[1] - start[1]) > near {
                continue;
            }
            let ([c, s], [u, v]) = (before.direction(1.0), after.direction(0.0));
            let turn = (c * v - s * u).atan2(c * u + s * v);
            narrowest[0] = narrowest[0].min(std::f64::consts::PI + turn);
            narrowest[1] = narrowest[1].min(before.length()).min(after.length());
        }
    }
    narrowest
}

#[cfg(test)]
mod tests {
    use super::super::shape::Shape;
    use super::*;
    use crate::developed::Liner;

    fn sheet() -> Sheet {
        let liner = Liner {
            radius: 0.5,
            length: 2.0,
            arc: None,
        };
        Sheet::of(&liner, 0.0)
    }

    fn feature(shape: Shape) -> Feature {
        Feature {
            name: "one".to_owned(),
            shape,
            meshed: false,
        }
    }

    fn rectangle(centre: [f64; 2], half: [f64; 2]) -> Feature {
        let corner = 0.0;
        feature(Shape { centre, half, corner })
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
        let disc = |x: f64, z: f64| feature(Shape::disc([x, z], 0.2));
        let whole = std::f64::consts::PI * 0.04;
        // A disc amid a narrower groove: two caps stand out.
        let half = (0.5f64).acos();
        let caps = 2.0 * (0.04 * half - 0.1 * 0.2 * half.sin());
        let cases = [
            (vec![groove.clone(), disc(1.5, 0.0)], 0.16 + caps),
            (vec![disc(1.5, 0.0), groove.clone()], 0.16 + caps),
            // A disc half beyond its end.
            (vec![groove.clone(), disc(1.5, 0.1)], 0.16 + 0.5 * whole),
            (
                vec![groove.clone(), rectangle([1.5, 0.0], [0.1, 0.3])],
                0.16 + 0.12 - 0.04,
            ),
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
