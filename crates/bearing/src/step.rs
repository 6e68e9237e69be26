//! The step from one trial position to the next: Newton's, in logarithmic coordinates far from the balance, damped.

use oilwedge_reynolds::solve::Neighbour;

use crate::coordinates::{Vector, length, moved};
use crate::equilibrium::NEAR;
use crate::log_eccentricity::{eccentricity_at, log_eccentricity};
use crate::search::{OF_BALANCE, Search, Trial};
use crate::stiffness::Stiffness;
use crate::tangent::Tangent;

/// Most halvings of one step.
const MOST_HALVINGS: usize = 8;
/// A step far from the balance of a film that conserves oil or bends its wall, each of which takes long, brings it
/// nearer by this part of the distance at least: one driven into contact does not.
const LEAST_GAIN: f64 = 1e-3;
/// and where the tilt is free, as the branch of balances leads on from there: by this part,
const LEAST_GAIN_TILTING: f64 = 1e-2;
/// with a step halved so often.
const MOST_HALVINGS_TILTING: usize = 6;
/// Least film thickness after a step, over the one before.
const LEAST_SHRINK: f64 = 0.1;
/// Least film thickness after a step where the tilt is free: an end comes near the liner before the force shows it.
const LEAST_SHRINK_TILTING: f64 = 0.3;
/// Least film thickness after a step where surfaces touch: contact grows like the exponential of the gap.
const LEAST_SHRINK_TOUCHING: f64 = 0.4;
/// Longest turn of the line of centres in one step [rad].
const LONGEST_TURN: f64 = 1.0;
/// Least eccentricity at which steps are taken in logarithmic coordinates.
const CENTRED: f64 = 1e-3;
/// A small part of the gap.
const LITTLE: f64 = 1e-2;
/// Greatest part of a way by which a wall is taken to follow.
const MOST_FOLLOWED: f64 = 0.99;
/// Moves by less than this part of the least film thickness start from the film before.
pub const SHORT_MOVE: f64 = 0.2;
/// Where the tilt of a film that conserves oil is free, which coarser meshes foretell less well, only moves by less
/// than this part start from it.
const SHORT_MOVE_TILTING: f64 = 0.8;

impl Search<'_> {
    /// The next trial, by the longest step that brings the forces nearer to the load.
    pub(crate) fn next_trial(&self, from: &Trial, tangent: &Tangent, tried: &mut usize) -> Option<Trial> {
        let newton = || tangent.stiffness.solve(self.excess(from).map(|excess| -excess));
        let steps = (self.residual(from) > NEAR).then(|| self.logarithmic_steps(from, tangent)).flatten();
        let [longest, shortest] = steps.unwrap_or_else(|| [newton(); 2]);
        let from_tangent = (from, tangent);
        if self.is_costly(from) || from.film.problem.deflection().is_some() {
            return self.damped(from_tangent, [longest, shortest], tried);
        }
        self.damped(from_tangent, [longest; 2], tried).or_else(|| {
            // Where the tilt is free the branch of balances leads on.
            let may_try = longest != shortest && self.load.tilting.is_none();
            may_try.then(|| self.damped(from_tangent, [shortest; 2], tried)).flatten()
        })
    }

    /// Steps to try one after the other: the step in `s`, the angle of the line of centres and the tilt that brings
    /// `ln |W|`, the angle of W and the arms of the moments to those of the load, and the direction in which it begins:
    /// where the line of centres turns far, or the eccentricity is near its greatest, no part of the straight way to
    /// the first leads nearer to the load. None for a centred journal, without a load, and where the force points away
    /// from the load.
    fn logarithmic_steps(&self, trial: &Trial, tangent: &Tangent) -> Option<[Vector; 2]> {
        let [e_x, e_y] = trial.film.problem.journal.offset;
        let e = e_x.hypot(e_y);
        let (held, follows) = (self.gap_under(&trial.film.problem), self.following(trial, tangent));
        let reach = |angle: f64| {
            let reach = held.reach(&trial.film.problem.journal, angle);
            follows.map_or(reach, |part| e + (reach - e) / (1.0 - part))
        };
        let eps = e / reach(e_y.atan2(e_x));
        let (carried, asked) = (trial.carried.force, self.load.force);
        let (force, load) = (carried[0].hypot(carried[1]), self.load.magnitude());
        let along = carried[0] * asked[0] + carried[1] * asked[1];
        if eps < CENTRED || along <= 0.0 {
            return None;
        }
        let across = carried[0] * asked[1] - carried[1] * asked[0];
        let [arm_x, arm_y] = self.arms_off(trial);
        let wanted = [(load / force).ln(), across.atan2(along), -arm_x, -arm_y];
        // Columns: change of (ln |W|, angle of W, arms of the moments) by s, by the angle of the line of centres, and
        // by the tilt.
        let radial = [e_x / e, e_y / e];
        let by_s = 1.0 / (1.0 / eps + 1.5 / (1.0 - eps)) * reach(e_y.atan2(e_x));
        let by_tilt = trial.film.problem.bearing.clearance;
        let moves = [
            [radial[0] * by_s, radial[1] * by_s, 0.0, 0.0],
            [-e_y, e_x, 0.0, 0.0],
            [0.0, 0.0, by_tilt, 0.0],
            [0.0, 0.0, 0.0, by_tilt],
        ];
        let (film, support) = (self.coordinates.forces(&trial.carried), self.support_stiffness());
        let logarithmic = Stiffness::by_columns(tangent.stiffness.order(), |k| {
            let change = tangent.stiffness.times(moves[k]);
            let size = (change[0] * carried[0] + change[1] * carried[1]) / force.powi(2);
            let turn = (change[1] * carried[0] - change[0] * carried[1]) / force.powi(2);
            // What the support takes over leaves less to the film.
            let [arm_x, arm_y] = [2, 3].map(|d| {
                let taken = support * moves[k][d];
                (change[d] - taken - film[d] * size) / force + taken / load
            });
            Ok::<Vector, std::convert::Infallible>([size, turn, arm_x, arm_y])
        });
        let Ok(logarithmic) = logarithmic;
        let [by_s, turn, tilt_x, tilt_y] = logarithmic.solve(wanted);
        let is_step = by_s.is_finite() && tilt_x.is_finite() && tilt_y.is_finite();
        if !(is_step && turn.is_finite() && turn.abs() < LONGEST_TURN) {
            return None;
        }
        let angle = e_y.atan2(e_x) + turn;
        let e_next = reach(angle) * eccentricity_at(log_eccentricity(eps) + by_s);
        let [x, y] = [e_next * angle.cos() - e_x, e_next * angle.sin() - e_y];
        let first = [0, 1].map(|d| by_s * moves[0][d] + turn * moves[1][d]);
        let tilt = [by_tilt * tilt_x, by_tilt * tilt_y];
        Some([[x, y, tilt[0], tilt[1]], [first[0], first[1], tilt[0], tilt[1]]])
    }

    /// How far the wall follows a journal that moves along the line of centres, as a part of that way [1]; none of a
    /// rigid wall.
    fn following(&self, trial: &Trial, tangent: &Tangent) -> Option<f64> {
        let (problem, journal) = (&trial.film.problem, &trial.film.problem.journal);
        problem.deflection()?;
        let gap = self.least_film(trial);
        let [sin, cos] = [journal.min_film_angle().sin(), journal.min_film_angle().cos()];
        let step = [cos, sin, 0.0, 0.0].map(|part| part * LITTLE * gap);
        let moved = self.coordinates.placed(journal, moved(self.coordinates.at(journal), 1.0, step));
        let before = self.least_under(problem, &moved);
        let gained = self.least_under(&tangent.bent(problem, step), &moved) - before;
        Some((gained / (LITTLE * gap)).clamp(0.0, MOST_FOLLOWED))
    }

    /// Whether the tilt is free in a film that conserves oil: each trial takes long, many lead into contact, and the
    /// branch of balances leads on from there.
    pub(crate) fn is_costly(&self, trial: &Trial) -> bool {
        self.load.tilting.is_some() && trial.film.solution.film_fraction.is_some()
    }

    /// The distance that the next trial must be below, and how often a step is halved.
    fn wanted(&self, from: &Trial) -> (f64, usize) {
        let distance = self.distance(from);
        let takes_long = from.film.solution.film_fraction.is_some() || from.film.problem.deflection().is_some();
        match self.residual(from) > NEAR {
            true if self.is_costly(from) => ((1.0 - LEAST_GAIN_TILTING) * distance, MOST_HALVINGS_TILTING),
            true if takes_long => ((1.0 - LEAST_GAIN) * distance, MOST_HALVINGS),
            _ => (distance, MOST_HALVINGS),
        }
    }

    /// The trial after the longest of the halved parts of a way that brings the forces nearer to the load, the film
    /// thickness kept positive where the wall follows along the tangent. The way is the parabola to its `end` that
    /// begins in the direction of `beginning`, straight where both are the same.
    fn damped(
        &self,
        (from, tangent): (&Trial, &Tangent),
        [end, beginning]: [Vector; 2],
        tried: &mut usize,
    ) -> Option<Trial> {
        let journal = from.film.problem.journal;
        let gap = self.least_film(from);
        let here = self.coordinates.at(&journal);
        let least = gap
            * match self.load.tilting {
                _ if from.film.problem.contact.is_some() => LEAST_SHRINK_TOUCHING,
                None => LEAST_SHRINK,
                Some(_) => LEAST_SHRINK_TILTING,
            };
        let curve = moved(end, -1.0, beginning);
        let step = |part: f64| moved(beginning, part, curve).map(|along| part * along);
        let bent = |part: f64| tangent.bent(&from.film.problem, step(part));
        let there = |part: f64| moved(here, 1.0, step(part));
        let thin = |part: f64| {
            let journal = self.coordinates.placed(&journal, there(part));
            self.least_under(&bent(part), &journal) < least
        };
        let length = length(end);
        // From a journal in contact no part of a step is short enough.
        if !length.is_finite() || gap <= 0.0 {
            return None;
        }
        let mut longest = 1.0;
        while thin(longest) {
            longest *= 0.8;
        }
        let (nearer, halvings) = self.wanted(from);
        let short_move = match self.is_costly(from) {
            true => SHORT_MOVE_TILTING,
            false => SHORT_MOVE,
        };
        // Newton's method squares what is left.
        let may_leave = OF_BALANCE * self.residual(from).min(NEAR).powi(2);
        for part in (0..halvings).map(|times| longest * 0.5f64.powi(times as i32)) {
            // Amid a curved way the film may be thinner than at its end.
            if end != beginning && thin(part) {
                continue;
            }
            let near = match part * length < short_move * gap {
                true => Neighbour::Start(&from.film),
                false => Neighbour::None,
            };
            *tried += 1;
            if let Ok(trial) = self.trial_within(&bent(part), there(part), near, may_leave)
                && self.distance(&trial) < nearer
            {
                return Some(trial);
            }
        }
        None
    }
}
