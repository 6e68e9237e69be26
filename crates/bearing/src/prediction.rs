//! Where a journal will be, predicted from where it was at neighbouring operating points.
//!
//! Parabolas through the last positions: in the logarithmic eccentricity and the angle of the line of centres, in which
//! they are nearly straight over the load.

use oilwedge_reynolds::angles::wrapped;

use crate::log_eccentricity::{eccentricity_at, log_eccentricity};

/// Points that a prediction goes through, at most.
const MOST_POINTS: usize = 3;
/// Values that differ by less than this part are the same.
const APART: f64 = 1e-9;
/// A centred journal has no line of centres.
const CENTRED: f64 = 1e-6;
/// A predicted film is no thinner than this part of the last one, and no thicker than its inverse.
const LEAST_SHRINK: f64 = 0.3;

/// An operating point: what a prediction knows of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// What distinguishes it from its neighbours, in even steps.
    pub coordinate: f64,
    /// Logarithm of the load over that of drag through the clearance.
    pub duty: f64,
}

/// A position in balance at one operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Visited {
    /// The operating point.
    pub point: OperatingPoint,
    /// Eccentricity ratio.
    pub eccentricity: f64,
    /// Angle of the thinnest film [rad].
    pub angle: f64,
    /// Slope of the journal's axis [rad].
    pub tilt: [f64; 2],
}

/// A position predicted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Predicted {
    /// Eccentricity ratio.
    pub eccentricity: f64,
    /// Angle of the thinnest film [rad].
    pub angle: f64,
    /// Slope of the journal's axis [rad].
    pub tilt: [f64; 2],
}

/// The position at `point`, predicted from the positions visited last; the last one itself
/// where they predict nothing better. `None` where none was visited.
///
/// Over the duty where that changes: the logarithm of the load is nearly linear in the logarithmic eccentricity, with a
/// slope of one.
pub fn predicted(visited: &[Visited], point: OperatingPoint) -> Option<Predicted> {
    let last = visited.last()?;
    let points = &visited[visited.len().saturating_sub(MOST_POINTS)..];
    let duties: Vec<f64> = points.iter().map(|it| it.point.duty).collect();
    let coordinates: Vec<f64> = points.iter().map(|it| it.point.coordinate).collect();
    let by_duty = are_apart(&duties, point.duty);
    let weights = match by_duty {
        true => weights(&duties, point.duty),
        false if are_apart(&coordinates, point.coordinate) => weights(&coordinates, point.coordinate),
        false => Vec::new(),
    };
    let here = Some(Predicted { eccentricity: last.eccentricity, angle: last.angle, tilt: last.tilt });
    if weights.is_empty() || points.iter().any(|it| it.eccentricity < CENTRED) {
        return here;
    }
    let (mut s, mut turn, mut tilt) = (0.0, 0.0, [0.0; 2]);
    for (weight, visited) in weights.iter().zip(points) {
        tilt = [0, 1].map(|d| tilt[d] + weight * visited.tilt[d]);
        s += weight * log_eccentricity(visited.eccentricity);
        turn += weight * wrapped(visited.angle - last.angle);
    }
    if by_duty && points.len() == 1 {
        s += point.duty - last.point.duty;
    }
    let eccentricity = eccentricity_at(s);
    let shrink = (1.0 - eccentricity) / (1.0 - last.eccentricity);
    let is_near = shrink > LEAST_SHRINK && shrink < 1.0 / LEAST_SHRINK && turn.abs() < 1.0;
    if is_near { Some(Predicted { eccentricity, angle: last.angle + turn, tilt }) } else { here }
}

/// Whether all values differ, also from the one asked for.
fn are_apart(values: &[f64], asked: f64) -> bool {
    let differ = |a: f64, b: f64| (a - b).abs() > APART * a.abs().max(b.abs());
    (0..values.len()).all(|i| differ(values[i], asked) && values[..i].iter().all(|&other| differ(values[i], other)))
}

/// Lagrange's weights of the values at `asked`.
fn weights(values: &[f64], asked: f64) -> Vec<f64> {
    let weight = |i: usize| {
        let others = (0..values.len()).filter(|&j| j != i);
        others.map(|j| (asked - values[j]) / (values[i] - values[j])).product()
    };
    (0..values.len()).map(weight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(t: f64, duty: f64) -> Visited {
        Visited {
            point: OperatingPoint { coordinate: t, duty },
            eccentricity: eccentricity_at(0.3 * t + 0.02 * t * t),
            angle: 6.2 + 0.1 * t,
            tilt: [1e-4 * t, 0.0],
        }
    }

    fn close(told: Option<Predicted>, wanted: Visited) -> bool {
        let told = told.expect("a position");
        (told.eccentricity / wanted.eccentricity - 1.0).abs() < 1e-12
            && (told.angle - wanted.angle).abs() < 1e-12
            && (told.tilt[0] - wanted.tilt[0]).abs() < 1e-15
    }

    fn here(visited: Visited) -> Option<Predicted> {
        let Visited { eccentricity, angle, tilt, .. } = visited;
        Some(Predicted { eccentricity, angle, tilt })
    }

    #[test]
    fn parabolas_are_followed_and_leaps_are_not() {
        let visited = [at(0.5, 1.0), at(1.0, 1.0), at(2.0, 1.0)];
        assert!(close(predicted(&visited, at(3.0, 1.0).point), at(3.0, 1.0)));
        // Over the duty, where that runs.
        let visited = [at(0.5, 0.5), at(1.0, 1.0), at(2.0, 2.0)]
            .map(|it| Visited { point: OperatingPoint { coordinate: it.point.duty.exp(), ..it.point }, ..it });
        assert!(close(predicted(&visited, at(3.0, 3.0).point), at(3.0, 3.0)));
        assert_eq!(predicted(&visited, at(60.0, 60.0).point), here(at(2.0, 2.0)));
        assert_eq!(predicted(&[at(2.0, 1.0), at(2.0, 1.0)], at(2.0, 1.0).point), here(at(2.0, 1.0)));
        assert_eq!(predicted(&[], at(3.0, 3.0).point), None);
    }

    #[test]
    fn one_position_tells_the_next_by_its_duty() {
        let Predicted { eccentricity, angle, .. } = predicted(&[at(1.0, 1.0)], at(2.0, 1.1).point).expect("a position");
        assert!((log_eccentricity(eccentricity) - log_eccentricity(at(1.0, 1.0).eccentricity) - 0.1).abs() < 1e-12);
        assert_eq!(angle, at(1.0, 1.0).angle);
    }
}
