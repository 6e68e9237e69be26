//! Load capacity: whether a load exceeds what the film carries at the greatest eccentricity, or is below round-off.

use oilwedge_reynolds::FilmProblem;
use oilwedge_reynolds::angles::wrapped;
use oilwedge_reynolds::solve::Neighbour;

use crate::NoEquilibrium;
use crate::estimate::GREATEST_ECCENTRICITY;
use crate::search::Search;

/// Most turns of the line of centres until the film's force points in the direction of the load.
const TURNS: usize = 12;
/// Angle [rad] within which it does.
const ALIGNED: f64 = 0.02;
/// An eccentricity at which less should be carried.
const BEFORE: f64 = 0.99;
/// Loads below this part of the reference force are below the round-off of the film's force.
pub(crate) const ROUNDING: f64 = 1e-10;

impl Search<'_> {
    /// The reason if the film carries less than the load at the greatest eccentricity, in the direction of the load.
    pub(crate) fn beyond_capacity(&self, problem: &FilmProblem) -> Option<NoEquilibrium> {
        let asked = self.load.magnitude();
        let towards = self.load.force[1].atan2(self.load.force[0]);
        let mut angle = problem.journal.min_film_angle();
        for _ in 0..TURNS {
            let e = GREATEST_ECCENTRICITY * problem.bearing.reach(&problem.journal, angle);
            let at = self.at_offset(problem, [e * angle.cos(), e * angle.sin()]);
            let trial = self.trial(problem, at, Neighbour::None).ok()?;
            let [x, y] = trial.carried.force;
            let turn = wrapped(towards - y.atan2(x));
            if turn.abs() < ALIGNED {
                let greatest = x.hypot(y);
                // A film under tension may point there from its wide side too, with next to no force.
                let is_thin = !self.bears_tension || greatest > self.reference_force;
                let is_beyond = greatest < asked && is_thin && self.grows(problem, angle, greatest);
                return is_beyond.then(|| NoEquilibrium::BeyondCapacity {
                    asked,
                    towards: towards.to_degrees().rem_euclid(360.0),
                    greatest,
                    ratio: asked / greatest,
                    eccentricity: e / problem.bearing.clearance,
                    thickness: problem.bearing.least_gap(&trial.problem.journal),
                    journal: Box::new(trial.problem.journal),
                });
            }
            angle += turn;
        }
        None
    }

    /// Whether the film carries less than `greatest` [N] at a smaller eccentricity; with tension on one side of an arc it need not.
    fn grows(&self, problem: &FilmProblem, angle: f64, greatest: f64) -> bool {
        let e = BEFORE * problem.bearing.reach(&problem.journal, angle);
        let at = self.at_offset(problem, [e * angle.cos(), e * angle.sin()]);
        let before = self.trial(problem, at, Neighbour::None);
        before.is_ok_and(|trial| trial.carried.force[0].hypot(trial.carried.force[1]) < greatest)
    }

    /// The reason if the load is below the round-off of the film's force.
    pub(crate) fn below_rounding(&self) -> Option<NoEquilibrium> {
        let asked = self.load.magnitude();
        let least = ROUNDING * self.reference_force;
        (asked > 0.0 && asked < least).then_some(NoEquilibrium::BelowRounding { asked, least })
    }
}
