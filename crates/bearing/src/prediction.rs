//! Where a journal will be, told from where it was at neighbouring operating points.
//!
//! Parabolas through the last positions: in the stretched eccentricity and the angle of the line of centres, in which
//! they are nearly straight over the load.

use crate::stretched::{eccentricity_at, stretched};

/// Points that a prediction goes through, at most.
const MOST_POINTS: usize = 3;
/// A centred journal has no line of centres.
const CENTRED: f64 = 1e-6;
/// A predicted film is no thinner than this part of the last one, and no thicker than its inverse.
const LEAST_SHRINK: f64 = 0.3;

/// A position in balance at one operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Visited {
    /// What the operating points are told apart by.
    pub coordinate: f64,
    /// Eccentricity ratio.
    pub eccentricity: f64,
    /// Angle of the thinnest film [rad].
    pub angle: f64,
}

/// Eccentricity ratio and angle of the thinnest film [rad] at `coordinate`, told from the positions visited last; the last one itself
/// where they tell nothing better. `None` where none was visited.
pub fn predicted(visited: &[Visited], coordinate: f64) -> Option<(f64, f64)> {
    let last = visited.last()?;
    let here = (last.eccentricity, last.angle);
    let points = &visited[visited.len().saturating_sub(MOST_POINTS)..];
    let is_told = |point: &Visited| point.eccentricity > CENTRED;
    let apart = |i: usize| {
        let mut others = points[..i].iter().map(|other| other.coordinate);
        others.all(|other| other != points[i].coordinate) && points[i].coordinate != coordinate
    };
    if !points.iter().all(is_told) || !(0..points.len()).all(apart) {
        return Some(here);
    }
    let weights = (0..points.len()).map(|i| {
        let others = points.iter().enumerate().filter(|(j, _)| *j != i);
        let part = |other: &Visited| (coordinate - other.coordinate) / (points[i].coordinate - other.coordinate);
        others.map(|(_, other)| part(other)).product::<f64>()
    });
    let (mut s, mut turn) = (0.0, 0.0);
    for (weight, point) in weights.zip(points) {
        let from_last = point.angle - last.angle;
        s += weight * stretched(point.eccentricity);
        turn += weight * from_last.sin().atan2(from_last.cos());
    }
    let eccentricity = eccentricity_at(s);
    let shrink = (1.0 - eccentricity) / (1.0 - last.eccentricity);
    let is_near = shrink > LEAST_SHRINK && shrink < 1.0 / LEAST_SHRINK && turn.abs() < 1.0;
    Some(if is_near {
        (eccentricity, last.angle + turn)
    } else {
        here
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parabolas_are_followed_and_leaps_are_not() {
        let at = |t: f64| Visited {
            coordinate: t,
            eccentricity: eccentricity_at(0.3 * t + 0.02 * t * t),
            angle: 6.2 + 0.1 * t,
        };
        let visited = [at(0.5), at(1.0), at(2.0)];
        let (eccentricity, angle) = predicted(&visited, 3.0).expect("a position");
        assert!((eccentricity / at(3.0).eccentricity - 1.0).abs() < 1e-12);
        assert!((angle - at(3.0).angle).abs() < 1e-12);
        let last = (at(2.0).eccentricity, at(2.0).angle);
        assert_eq!(predicted(&visited, 60.0), Some(last));
        assert_eq!(
            predicted(&[at(1.0), at(1.0)], 3.0),
            Some((at(1.0).eccentricity, at(1.0).angle))
        );
        assert_eq!(predicted(&[], 3.0), None);
    }
}
