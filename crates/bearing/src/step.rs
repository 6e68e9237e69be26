//! The step from one trial position to the next: Newton's, in logarithmic coordinates far from the balance, damped.

use oilwedge_reynolds::JournalState;
use oilwedge_reynolds::solve::Neighbour;

use crate::equilibrium::{NEAR, Stiffness};
use crate::log_eccentricity::{eccentricity_at, log_eccentricity};
use crate::search::{Search, Trial};

/// Most halvings of one step.
const MOST_HALVINGS: usize = 8;
/// Least film thickness after a step, over the one before.
const LEAST_SHRINK: f64 = 0.1;
/// Longest turn of the line of centres in one step [rad].
const LONGEST_TURN: f64 = 1.0;
/// Least eccentricity at which steps are taken in logarithmic coordinates.
const CENTRED: f64 = 1e-3;
/// Below this part of the load a film that conserves oil keeps its advection schemes from step to step.
const SMOOTH: f64 = 1e-2;
/// Moves by less than this part of the least film thickness start from the film before.
pub const SHORT_MOVE: f64 = 0.2;

impl Search<'_> {
    /// Newton's step [m].
    pub(crate) fn step(&self, trial: &Trial, stiffness: Stiffness) -> [f64; 2] {
        let logarithmic = (self.residual(trial) > NEAR)
            .then(|| self.logarithmic_step(trial, stiffness))
            .flatten();
        logarithmic.unwrap_or_else(|| newton_step(stiffness, self.excess(trial)))
    }

    /// The step in `s` and the angle of the line of centres that brings `ln |W|` and the angle of W to those of the load.
    /// None for a centred journal, without a load, and where the force points away from the load.
    fn logarithmic_step(&self, trial: &Trial, stiffness: Stiffness) -> Option<[f64; 2]> {
        let [e_x, e_y] = trial.problem.journal.offset;
        let e = e_x.hypot(e_y);
        let reach = |angle: f64| trial.problem.bearing.reach(&trial.problem.journal, angle);
        let eps = e / reach(e_y.atan2(e_x));
        let (force, load) = (trial.force[0].hypot(trial.force[1]), self.load[0].hypot(self.load[1]));
        let along = trial.force[0] * self.load[0] + trial.force[1] * self.load[1];
        if eps < CENTRED || along <= 0.0 {
            return None;
        }
        let across = trial.force[0] * self.load[1] - trial.force[1] * self.load[0];
        let wanted = [(load / force).ln(), across.atan2(along)];
        // Columns: change of (ln |W|, angle of W) by s and by the angle of the line of centres.
        let radial = [e_x / e, e_y / e];
        let by_s = 1.0 / (1.0 / eps + 1.5 / (1.0 - eps)) * reach(e_y.atan2(e_x));
        let moves = [radial.map(|x| x * by_s), [-e_y, e_x]];
        let mut tangent = [[0.0; 2]; 2];
        for (k, step) in moves.iter().enumerate() {
            let change = [0, 1].map(|d| stiffness[d][0] * step[0] + stiffness[d][1] * step[1]);
            tangent[0][k] = (change[0] * trial.force[0] + change[1] * trial.force[1]) / force.powi(2);
            tangent[1][k] = (change[1] * trial.force[0] - change[0] * trial.force[1]) / force.powi(2);
        }
        let [by_s, turn] = solve(tangent, wanted);
        if !(by_s.is_finite() && turn.is_finite() && turn.abs() < LONGEST_TURN) {
            return None;
        }
        let angle = e_y.atan2(e_x) + turn;
        let e_next = reach(angle) * eccentricity_at(log_eccentricity(eps) + by_s);
        Some([e_next * angle.cos() - e_x, e_next * angle.sin() - e_y])
    }

    /// The longest of the halved steps that brings the force nearer to the load, the film thickness kept positive.
    pub(crate) fn damped(&self, from: &Trial, step: [f64; 2], tried: &mut usize) -> Option<Trial> {
        let (bearing, journal) = (&from.problem.bearing, from.problem.journal);
        let gap = bearing.least_gap(&journal);
        let at = |part: f64| [0, 1].map(|d| journal.offset[d] + part * step[d]);
        let thin = |part: f64| {
            let offset = at(part);
            bearing.least_gap(&JournalState { offset, ..journal }) < LEAST_SHRINK * gap
        };
        let length = step[0].hypot(step[1]);
        if !length.is_finite() {
            return None;
        }
        let mut part = 1.0;
        while thin(part) {
            part *= 0.8;
        }
        for _ in 0..MOST_HALVINGS {
            let near = match part * length < SHORT_MOVE * gap {
                true if self.options.keeps_schemes() || self.residual(from) < SMOOTH => Neighbour::Kept(&from.film),
                true => Neighbour::Start(&from.film),
                false => Neighbour::None,
            };
            *tried += 1;
            if let Ok(trial) = self.trial(&from.problem, at(part), near)
                && self.distance(&trial) < self.distance(from)
            {
                return Some(match near {
                    Neighbour::Kept(_) => Trial {
                        schemes_chosen_at: from.schemes_chosen_at,
                        is_continued: true,
                        ..trial
                    },
                    Neighbour::None | Neighbour::Start(_) => trial,
                });
            }
            part *= 0.5;
        }
        None
    }
}

/// The step [m] that takes away the `excess` of force [N] to first order; not finite for a singular stiffness.
pub fn newton_step(stiffness: Stiffness, excess: [f64; 2]) -> [f64; 2] {
    solve(stiffness, excess.map(|x| -x))
}

/// Solves two equations by Cramer's rule; not finite if they are singular.
fn solve(a: Stiffness, b: [f64; 2]) -> [f64; 2] {
    let determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
    [
        (a[1][1] * b[0] - a[0][1] * b[1]) / determinant,
        (a[0][0] * b[1] - a[1][0] * b[0]) / determinant,
    ]
}
