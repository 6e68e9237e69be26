//! How large triangles should be: a base size, finer towards features and sharp corners.

use super::shape::{Feature, RoundedRectangle};
use super::union::Junction;

/// How edges grow from the rims of features towards the edges far from them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grading {
    /// Growth of the edge length per length away from a feature.
    pub growth: f64,
    /// Edges along any rim, over those far from it.
    pub at_rim: f64,
    /// Longest edges along the rim of a groove, over its lesser half extent.
    pub of_half: f64,
    /// Edges along a round rim or corner, over its radius.
    pub of_radius: f64,
    /// The lesser half extent of a groove or, if that is less, the size far from it, over the edges at its sharp
    /// corners.
    pub per_corner: f64,
}

impl Grading {
    /// Rims are resolved. With this growth and these edges at a rim the load of the hole-fed shell has the least error
    /// at equal unknowns (`at_rim` 0.15 to 0.6 and `growth` 0.15 to 0.45 were tried).
    pub const RESOLVED: Self = Self { growth: 0.2, at_rim: 0.3, of_half: 0.5, of_radius: 0.25, per_corner: 10.0 };
    /// The wanted size counts, and rims get few edges of their own: four corners of a narrow groove are given 1900
    /// triangles by [`Self::RESOLVED`], however large the wanted size is, and some 40 here. Round rims are resolved:
    /// with edges of half the radius the least angle of meshed discs was 11 degrees.
    pub const BY_SIZE: Self =
        Self { growth: 0.5, at_rim: 0.5, of_half: f64::INFINITY, of_radius: 0.25, per_corner: 1.0 };
}

/// Edge length wanted at a point.
pub(super) struct SizeField<'a> {
    base: &'a dyn Fn([f64; 2]) -> f64,
    pub(super) grading: Grading,
    period: Option<f64>,
    features: &'a [Feature],
    at_feature: Vec<f64>,
    spots: Vec<Spot>,
}

/// A circle, or a point, along which edges are finer than along the rest of the rim.
struct Spot {
    centre: [f64; 2],
    radius: f64,
    size: f64,
}

impl<'a> SizeField<'a> {
    /// `base` is the size [m] far from all features, `gaps` the free distance [m] around each feature, `junctions` the
    /// corners where rims meet.
    pub(super) fn new(
        base: &'a dyn Fn([f64; 2]) -> f64,
        grading: Grading,
        period: Option<f64>,
        (features, gaps): (&'a [Feature], &[f64]),
        junctions: &[Junction],
    ) -> Self {
        // Parts of rims between corners are as long as their edges, or longer.
        let part =
            |junction: &Junction| Spot { centre: junction.middle, radius: 0.5 * junction.side, size: junction.side };
        let mut spots: Vec<Spot> = junctions.iter().map(part).collect();
        let at_feature = features
            .iter()
            .zip(gaps)
            .map(|(feature, gap)| {
                let shape = &feature.shape;
                let half = shape.half[0].min(shape.half[1]);
                let far = base(shape.centre);
                let own = if shape.is_disc() {
                    grading.of_radius * half
                } else {
                    spots.extend(spots_of(shape, half.min(far), grading));
                    grading.of_half * half
                };
                own.min(grading.at_rim * far).min(0.5 * gap)
            })
            .collect();
        Self { base, grading, period, features, at_feature, spots }
    }

    /// Edge length [m] wanted at `point`.
    pub(super) fn at(&self, point: [f64; 2]) -> f64 {
        self.near_features(point).min(self.far_from_features(point))
    }

    /// Edge length [m] wanted at `point` if there were no features.
    pub(super) fn far_from_features(&self, point: [f64; 2]) -> f64 {
        (self.base)(point)
    }

    /// Edge length [m] that the features want at `point`; infinite where there are none.
    pub(super) fn near_features(&self, point: [f64; 2]) -> f64 {
        let mut size = f64::INFINITY;
        for (feature, at_feature) in self.features.iter().zip(&self.at_feature) {
            if *at_feature < size {
                let distance = feature.shape.distance(point, self.period).abs();
                size = size.min(at_feature + self.grading.growth * distance);
            }
        }
        for spot in &self.spots {
            if spot.size >= size {
                continue;
            }
            let along = point[0] - spot.centre[0];
            let along = self.period.map_or(along, |period| crate::developed::shorter_way(along, period));
            let distance = along.hypot(point[1] - spot.centre[1]) - spot.radius;
            size = size.min(spot.size + self.grading.growth * distance.abs());
        }
        size
    }
}

/// Corners of a shape, sharp or round, and straight sides that are shorter than their neighbours; `wide` [m] is its
/// lesser half extent, or the size far from it.
fn spots_of(shape: &RoundedRectangle, wide: f64, grading: Grading) -> Vec<Spot> {
    let sharp =
        shape.sharp_corners().into_iter().map(|centre| Spot { centre, radius: 0.0, size: wide / grading.per_corner });
    let round = shape.round_corners().into_iter().map(|centre| Spot {
        centre,
        radius: shape.corner,
        size: grading.of_radius * shape.corner,
    });
    let sides =
        shape.short_sides().into_iter().map(|(centre, length)| Spot { centre, radius: 0.5 * length, size: length });
    sharp.chain(round).chain(sides).collect()
}
