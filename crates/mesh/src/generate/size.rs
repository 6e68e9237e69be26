//! How large triangles should be: a base size, finer towards features and sharp corners.

use super::shape::Feature;

/// Edge lengths grow by this much per length away from a feature.
const GROWTH: f64 = 0.2;
/// Edges along a round rim: its radius over this; along others: half the lesser half extent.
const PER_RADIUS: f64 = 4.0;
/// Edges along any rim, over those far from it: with this and the growth above the load of the hole-fed
/// shell has the least error at equal unknowns (0.15 to 0.6 and 0.15 to 0.45 were tried).
const AT_RIM: f64 = 0.3;
/// Edges at a sharp corner: the lesser half extent of its groove, or the size far from it, over this.
const PER_CORNER: f64 = 10.0;

/// Edge length wanted at a point.
pub(super) struct SizeField<'a> {
    base: &'a dyn Fn([f64; 2]) -> f64,
    period: Option<f64>,
    features: &'a [Feature],
    at_feature: Vec<f64>,
    corners: Vec<([f64; 2], f64)>,
}

impl<'a> SizeField<'a> {
    /// `base` is the size [m] far from all features, `gaps` the free distance [m] around each feature.
    pub(super) fn new(
        base: &'a dyn Fn([f64; 2]) -> f64,
        period: Option<f64>,
        features: &'a [Feature],
        gaps: &[f64],
    ) -> Self {
        let mut corners = Vec::new();
        let at_feature = features
            .iter()
            .zip(gaps)
            .map(|(feature, gap)| {
                let half = feature.shape.half[0].min(feature.shape.half[1]);
                let sharp = feature.shape.sharp_corners();
                let far = base(feature.shape.centre);
                corners.extend(sharp.into_iter().map(|corner| (corner, half.min(far) / PER_CORNER)));
                let round = feature.shape.corner > 0.0;
                let own = if round { feature.shape.corner / PER_RADIUS } else { half };
                own.min(AT_RIM * far)
                    .min(0.5 * half)
                    .min(0.5 * gap)
                    .min(feature.shape.shortest_side())
            })
            .collect();
        Self {
            base,
            period,
            features,
            at_feature,
            corners,
        }
    }

    /// Edge length [m] wanted at `point`.
    pub(super) fn at(&self, point: [f64; 2]) -> f64 {
        let mut size = (self.base)(point);
        for (feature, at_feature) in self.features.iter().zip(&self.at_feature) {
            if *at_feature < size {
                let distance = feature.shape.distance(point, self.period).abs();
                size = size.min(at_feature + GROWTH * distance);
            }
        }
        for (corner, at_corner) in &self.corners {
            if *at_corner < size {
                let along = point[0] - corner[0];
                let along = self
                    .period
                    .map_or(along, |period| crate::developed::shorter_way(along, period));
                size = size.min(at_corner + GROWTH * along.hypot(point[1] - corner[1]));
            }
        }
        size
    }
}
