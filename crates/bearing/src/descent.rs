//! Towards a position by the distance of force and load alone, where Newton's steps lead nowhere: at the edge of an arc
//! the force turns with the position so sharply that its tangent holds over short steps only.
//!
//! **Source.** Nelder and Mead, Computer Journal 7 (1965) 308, in the logarithmic eccentricity and the angle of the
//! line of centres.

use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, JournalState};

use crate::equilibrium::NEAR;
use crate::log_eccentricity::{eccentricity_at, log_eccentricity};
use crate::search::Search;

/// Most positions tried.
const MOST_TRIALS: usize = 150;
/// Sides of the first triangle, in the logarithmic eccentricity and in the angle [rad].
const SIDES: [f64; 2] = [0.5, 0.2];
/// A triangle that small leads no further.
const LEAST_SIDE: f64 = 1e-3;
/// From this distance on Newton's steps lead to the balance.
const ENOUGH: f64 = 0.3 * NEAR;

/// A corner of the triangle: logarithmic eccentricity, angle [rad].
type Corner = [f64; 2];

impl Search<'_> {
    /// A position nearer to the balance than `start`, by a triangle of positions that moves down the distance.
    pub(crate) fn descended(&self, problem: &FilmProblem, start: &JournalState) -> JournalState {
        let reach = |angle: f64| self.gap.reach(&problem.journal, angle);
        let towards = start.min_film_angle();
        let first = [log_eccentricity(start.eccentricity() / reach(towards)), towards];
        let offset = |[s, angle]: Corner| {
            let e = reach(angle) * eccentricity_at(s);
            [e * angle.cos(), e * angle.sin()]
        };
        let distance = |corner: Corner| {
            let trial = self.trial(problem, self.at_offset(problem, offset(corner)), Neighbour::None);
            trial.map_or(f64::INFINITY, |trial| self.distance(&trial))
        };
        let mut triangle = [first, [first[0] + SIDES[0], first[1]], [first[0], first[1] + SIDES[1]]]
            .map(|corner| (distance(corner), corner));
        let mut left = MOST_TRIALS;
        while left > 0 && !self.options.deadline.is_over() {
            left -= 1;
            triangle.sort_by(|a, b| a.0.total_cmp(&b.0));
            let [best, good, worst] = triangle;
            let side = (0..2).map(|k| (worst.1[k] - best.1[k]).abs() / SIDES[k]).fold(0.0, f64::max);
            if best.0 < ENOUGH || side < LEAST_SIDE {
                break;
            }
            let middle = [0, 1].map(|k| 0.5 * (best.1[k] + good.1[k]));
            let along = |part: f64| {
                let corner = [0, 1].map(|k| middle[k] + part * (middle[k] - worst.1[k]));
                (distance(corner), corner)
            };
            let reflected = along(1.0);
            let moved = if reflected.0 < best.0 {
                let expanded = along(2.0);
                if expanded.0 < reflected.0 { expanded } else { reflected }
            } else if reflected.0 < good.0 {
                reflected
            } else {
                along(if reflected.0 < worst.0 { 0.5 } else { -0.5 })
            };
            if moved.0 < worst.0 {
                triangle[2] = moved;
                continue;
            }
            for corner in &mut triangle[1..] {
                let shrunk = [0, 1].map(|k| 0.5 * (best.1[k] + corner.1[k]));
                *corner = (distance(shrunk), shrunk);
            }
        }
        triangle.sort_by(|a, b| a.0.total_cmp(&b.0));
        JournalState { offset: offset(triangle[0].1), ..*start }
    }
}
