//! The bore at mid-length as the section draws it, with its shape and the angles that its feeds cover.

use std::f64::consts::TAU;

use oilwedge_drawing::{Polar, least_and_greatest};
use oilwedge_study::fields::FILM_THICKNESS;

use super::film::DrawnFilm;
use super::sample::Finder;

/// The gap at no eccentricity over the bore, where it is deepest.
const GAP: f64 = 0.17;
/// A bore that is off its circle by more than this part of the clearance is drawn so.
const SHAPED: f64 = 0.01;
/// Points of the bore around.
const POINTS: usize = 720;
/// Angles [rad] that are one.
const SLACK: f64 = 1e-6;

/// An angle [rad] between -pi and pi.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

/// The bore at mid-length as it is drawn.
pub(super) struct DrawnBore {
    /// Radius of the circle of the bearing's diameter [mm].
    pub(super) circle: f64,
    /// The clearance [mm].
    pub(super) gap: f64,
    /// Radius of the bore [mm] at even steps from the liner's first angle [rad] on; none of a circle.
    pub(super) radii: Vec<f64>,
    from: f64,
    step: f64,
}

impl DrawnBore {
    /// The bore whose deepest place is drawn at a distance [mm] from the middle: what the film is thicker than between
    /// circles.
    pub(super) fn of(film: &DrawnFilm, deepest: f64) -> Self {
        let [from, to] = film.liner.angles();
        let step = (to - from) / POINTS as f64;
        let angles: Vec<f64> = (0..=POINTS).map(|k| from + step * k as f64).collect();
        let depths = depths(film, &angles).unwrap_or_default();
        let off = depths.iter().map(|depth| depth.abs()).fold(0.0, f64::max);
        let depths = if off > SHAPED { depths } else { Vec::new() };
        let most = depths.iter().copied().fold(0.0, f64::max);
        let gap = GAP * deepest / (1.0 + most);
        let circle = deepest - most * gap;
        Self { circle, gap, radii: depths.into_iter().map(|depth| circle + gap * depth).collect(), from, step }
    }

    /// Radius of the bore [mm] at an angle [rad].
    pub(super) fn at(&self, angle: f64) -> f64 {
        let steps = (angle - self.from).rem_euclid(TAU) / self.step;
        let last = self.radii.len().saturating_sub(1);
        let k = (steps as usize).min(last.saturating_sub(1));
        match self.radii.get(k..k + 2) {
            Some(&[a, b]) => a + (steps - k as f64).min(1.0) * (b - a),
            _ => self.circle,
        }
    }

    /// The bore between two angles [rad], at a distance [mm] from it.
    pub(super) fn arc(&self, axes: Polar, [from, to]: [f64; 2], inwards: f64) -> Vec<[f64; 2]> {
        match self.radii.is_empty() {
            true => axes.arc(self.circle - inwards, from, to),
            false => {
                let count = ((to - from).abs() / self.step).ceil().max(1.0) as usize;
                let angle = |k: usize| from + (to - from) * k as f64 / count as f64;
                (0..=count).map(|k| axes.point(angle(k), self.at(angle(k)) - inwards)).collect()
            }
        }
    }
}

/// How much deeper than its circle the bore is at angles [rad] at mid-length, over the clearance; straight between the
/// ends of holes, grooves and pockets. `None` without a film at mid-length.
fn depths(film: &DrawnFilm, angles: &[f64]) -> Option<Vec<f64>> {
    let [eccentricity, towards] = film.position()?;
    let points: Vec<[f64; 2]> = angles.iter().map(|angle| [angle * film.radius(), 0.0]).collect();
    let values = Finder::new(film).values(&FILM_THICKNESS, &points)?;
    let extents: Vec<[f64; 2]> = film.rims().map(|(_, pieces)| extent(pieces, film.radius())).collect();
    let is_cut = |angle: f64| {
        (extents.iter()).any(|[low, high]| (angle - low + SLACK).rem_euclid(TAU) <= high - low + 2.0 * SLACK)
    };
    let known: Vec<(usize, f64)> = (angles.iter().zip(values).enumerate())
        .filter(|(_, (angle, value))| value.is_finite() && !is_cut(**angle))
        .map(|(k, (angle, value))| {
            (k, value / film.result.geometry.clearance - 1.0 + eccentricity * (angle - towards).cos())
        })
        .collect();
    let (first, last) = (known.first()?, known.last()?);
    let at = |k: usize| {
        let next = known.partition_point(|(at, _)| *at < k);
        let before = next.checked_sub(1).map_or(first, |before| &known[before]);
        let after = known.get(next).unwrap_or(last);
        let length = after.0.saturating_sub(before.0).max(1) as f64;
        let part = (k.saturating_sub(before.0)) as f64 / length;
        before.1 + part.clamp(0.0, 1.0) * (after.1 - before.1)
    };
    Some((0..angles.len()).map(at).collect())
}

/// The angles [rad] that a rim covers, from the lesser on to the greater: all but the widest gap between its pieces.
pub(super) fn extent(pieces: &[[[f64; 2]; 2]], radius: f64) -> [f64; 2] {
    let mut covered: Vec<[f64; 2]> = (pieces.iter())
        .map(|piece| {
            let [low, high] = least_and_greatest(piece.iter().map(|point| point[0] / radius));
            let from = low.rem_euclid(TAU);
            [from, from + high - low]
        })
        .collect();
    covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let Some(first) = covered.first().copied() else {
        return [0.0; 2];
    };
    // The first piece comes again after a turn.
    let again = [first[0] + TAU, first[1] + TAU];
    let (mut end, mut widest, mut found) = (first[1], SLACK, [first[0], first[0] + TAU]);
    for [from, to] in covered.into_iter().skip(1).chain([again]) {
        if from - end > widest {
            widest = from - end;
            found = [from, end + TAU];
        }
        end = end.max(to);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rim of a groove between two angles [deg], 3 mm wide, by pieces of so many degrees, in any turn and order.
    fn groove(from: f64, to: f64, step: f64) -> Vec<[[f64; 2]; 2]> {
        let (radius, count) = (0.027, ((to - from) / step).ceil());
        let x = |k: f64| radius * (from + (to - from) * k / count).to_radians();
        let mut pieces = vec![[[x(0.0), -1.5e-3], [x(0.0), 1.5e-3]], [[x(count), -1.5e-3], [x(count), 1.5e-3]]];
        for k in 0..count as u32 {
            let ends = [f64::from(k), f64::from(k + 1)].map(x);
            let turn = TAU * radius * f64::from(k % 3);
            pieces.push(ends.map(|x| [x + turn, 1.5e-3]));
            pieces.insert(0, ends.map(|x| [x - turn, -1.5e-3]));
        }
        pieces
    }

    #[test]
    fn a_groove_covers_its_angles_and_no_more() {
        for (from, to) in [
            (0.0, 170.0),
            (0.0, 180.0),
            (10.0, 190.0),
            (0.0, 181.0),
            (180.0, 360.0),
            (-15.0, 15.0),
            (300.0, 655.0),
            (90.0, 91.0),
        ] {
            for step in [2.0, 17.0] {
                let [low, high] = extent(&groove(from, to, step), 0.027).map(f64::to_degrees);
                assert!((high - low - (to - from)).abs() < 1e-6, "{from} {to}: {low} {high}");
                assert!(wrapped((low - from).to_radians()).abs() < 1e-6, "{from} {to}: {low}");
            }
        }
        let [low, high] = extent(&groove(0.0, 360.0, 10.0), 0.027);
        assert!((high - low - TAU).abs() < 1e-9);
    }
}
