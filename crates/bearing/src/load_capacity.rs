//! Load capacity: whether a load exceeds what the film carries at the greatest eccentricity, or is below round-off.

use std::f64::consts::{PI, TAU};

use oilwedge_reynolds::angles::wrapped;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, JournalState, SolvedFilm};

use crate::coordinates::{Vector, moved};
use crate::estimate::GREATEST_ECCENTRICITY;
use crate::no_equilibrium::{DISTINCT, FAR_BELOW, SearchEnd};
use crate::search::{Search, Trial};
use crate::{NoEquilibrium, Purpose};

/// Most turns of the line of centres until the film's force points in the direction of the load.
const TURNS: usize = 12;
/// Angle [rad] within which it does.
const ALIGNED: f64 = 1e-3;
/// Turns of the line of centres over those of the force that are followed.
const SLOPES: std::ops::RangeInclusive<f64> = 0.1..=3.0;
/// Places all around the bearing at which the direction of the force is computed.
const AROUND: u32 = 24;
/// Most halvings between two of these places.
const HALVINGS: usize = 12;
/// Contact presses a wall no further out where one more solve of it moves the end of the journal's way by less than
/// this part of the clearance,
const YIELDED: f64 = 1e-4;
/// Most of these solves of the wall.
const MOST_YIELDS: usize = 6;
/// A wall yields far where the end of the search lies so many clearances further out.
const FAR_OUT: f64 = 0.1;
/// An eccentricity at which less should be carried.
const BEFORE: f64 = 0.99;
/// Loads below this part of the reference force are below the round-off of the film's force.
pub(crate) const ROUNDING: f64 = 1e-10;

impl Search<'_> {
    /// The reason if the film carries less than the load at the greatest eccentricity, in the direction of the load;
    /// the line of centres is turned to that from that of `start`.
    pub(crate) fn beyond_capacity(&self, problem: &FilmProblem, start: &JournalState) -> Option<NoEquilibrium> {
        let trial = self.contact_towards_load(problem, start.min_film_angle())?;
        // A film under tension may point there from its wide side too, with next to no force.
        let is_thin = !self.bears_tension || size(&trial) > self.reference_force;
        is_thin.then(|| self.beyond(&trial)).flatten()
    }

    /// The reason as on a coarser mesh, if it is one on this mesh too: `start` is the contact that it names.
    pub(crate) fn still_beyond(&self, problem: &FilmProblem, start: &JournalState) -> Option<NoEquilibrium> {
        match problem.journal.tilt {
            [0.0, 0.0] => self.beyond_capacity(problem, start),
            // It is the best of all contacts: how much that is in all does not count.
            _ => self.beyond(&self.contact_towards_load(problem, start.min_film_angle())?),
        }
    }

    /// The film at the greatest eccentricity whose force points towards the load; the line of centres is turned to that
    /// from `angle` [rad].
    fn contact_towards_load(&self, problem: &FilmProblem, mut angle: f64) -> Option<Trial> {
        let towards = self.load.force[1].atan2(self.load.force[0]);
        let mut before: Option<[f64; 2]> = None;
        for _ in 0..TURNS {
            let trial = self.at_contact(problem, angle)?;
            let [x, y] = trial.carried.force;
            let turn = wrapped(towards - y.atan2(x));
            if turn.abs() < ALIGNED {
                return Some(trial);
            }
            // With a tilt the force turns faster or slower than the line of centres.
            let slope = before.map_or(1.0, |[last, off]| -wrapped(angle - last) / (turn - off));
            before = Some([angle, turn]);
            angle += turn * if SLOPES.contains(&slope) { slope } else { 1.0 };
        }
        None
    }

    /// The reason if the film of a journal in contact, whose force points towards the load, carries less than that, and
    /// more than before contact.
    fn beyond(&self, trial: &Trial) -> Option<NoEquilibrium> {
        let (asked, greatest) = (self.load.magnitude(), size(trial));
        let FilmProblem { bearing, journal, .. } = &trial.film.problem;
        let is_beyond = greatest + DISTINCT * self.error(trial)? < asked
            && self.grows(&trial.film.problem, journal.min_film_angle(), greatest);
        let towards = self.load.force[1].atan2(self.load.force[0]);
        is_beyond.then(|| NoEquilibrium::BeyondCapacity {
            asked,
            towards: towards.to_degrees().rem_euclid(360.0),
            greatest,
            ratio: asked / greatest,
            eccentricity: journal.eccentricity() / bearing.clearance,
            thickness: self.least_film(trial),
            journal: Box::new(*journal),
        })
    }

    /// How much the force of a film differs from that of the film in cubic elements [N]; one far from the load is not
    /// asked, nor one of a search whose answer is a start at most.
    fn error(&self, trial: &Trial) -> Option<f64> {
        if size(trial) < FAR_BELOW * self.load.magnitude() || self.options.purpose == Purpose::Start {
            return Some(0.0);
        }
        let [x, y, ..] = self.missed(&trial.film)?;
        Some(x.hypot(y))
    }

    /// By how much forces [N] of another film under the same wall differ from those of a film: the one in cubic
    /// elements or, of a film that conserves oil, the one on the coarser mesh, which is further from the limit of fine
    /// meshes. None where there is no such film.
    pub(crate) fn missed(&self, film: &SolvedFilm) -> Option<Vector> {
        let other = match film.problem.cavitation.conserves_oil() {
            false => film.cubic_film(None).ok()?,
            true => {
                let coarser = self.system.coarser.as_ref()?;
                coarser.problem(&film.problem).solve(&coarser.system).ok()?
            }
        };
        let [other, of_film] = [&other, film].map(|film| self.coordinates.forces(&load(film).total.resultant()));
        Some(moved(other, -1.0, of_film))
    }

    /// The film at the greatest eccentricity towards an angle [rad]. A wall that gives way to contact lets the journal
    /// go on until contact presses it out no further; none where that is far: it carries more the further it is pressed
    /// out. The pressure of a film alone leaves the ends of the wall where they are.
    fn at_contact(&self, problem: &FilmProblem, angle: f64) -> Option<Trial> {
        if self.options.deadline.is_over() {
            return None;
        }
        let place = |reach: f64| {
            let e = GREATEST_ECCENTRICITY * reach;
            self.at_offset(problem, [e * angle.cos(), e * angle.sin()])
        };
        let (clearance, first) = (problem.bearing.clearance, self.gap.reach(&problem.journal, angle));
        let mut trial = self.trial(problem, place(first), Neighbour::None).ok()?;
        if !yields_to_contact(problem) {
            return Some(trial);
        }
        let mut reach = first;
        for _ in 0..MOST_YIELDS {
            let further = self.gap_under(&trial.film.problem).reach(&problem.journal, angle);
            if further - reach < YIELDED * clearance {
                return Some(trial);
            }
            if further - first > FAR_OUT * clearance {
                return None;
            }
            reach = further;
            trial = (self.trial(&trial.film.problem, place(reach), Neighbour::Start(&trial.film))).ok()?;
        }
        None
    }

    /// The reason if a journal whose tilt is given carries less than the load wherever it is in contact; it is asked
    /// all around the bearing, where the wall gives way in a rigid one, and at the best place there in the wall itself.
    pub(crate) fn beyond_contact(&self, problem: &FilmProblem) -> Option<NoEquilibrium> {
        let towards = self.load.force[1].atan2(self.load.force[0]);
        let guide = problem.deflection().map(|_| self.in_rigid_wall(problem));
        let (asked, search) = guide.as_ref().map_or((problem, self), |(rigid, search)| (rigid, search));
        let off = |angle: f64| {
            let trial = search.at_contact(asked, angle)?;
            let [x, y] = trial.carried.force;
            Some((wrapped(towards - y.atan2(x)), x.hypot(y), trial.film.problem.journal))
        };
        let angles = (0..AROUND).map(|k| TAU * f64::from(k) / f64::from(AROUND));
        let mut around: Vec<_> = angles.map(|angle| (angle, off(angle))).collect();
        around.push((TAU, around[0].1));
        let known: Option<Vec<f64>> = around.iter().map(|(_, off)| off.map(|(_, force, _)| force)).collect();
        let greatest = known?.into_iter().fold(0.0, f64::max);
        // A wall that is pressed out may carry many times what a rigid one does.
        if guide.is_none() && greatest < FAR_BELOW * self.load.magnitude() {
            let nearest = self.record().nearest;
            return nearest.map(|nearest| self.unreachable_from(nearest, SearchEnd::FarBelow));
        }
        let mut best: Option<(f64, JournalState)> = None;
        for pair in around.windows(2) {
            let [(mut low, Some((first, ..))), (mut high, Some((last, ..)))] = [&pair[0], &pair[1]].map(|it| *it)
            else {
                continue;
            };
            if first * last > 0.0 || (first - last).abs() > PI {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                let Some((turn, force, journal)) = off(middle) else {
                    break;
                };
                if turn.abs() < ALIGNED {
                    if best.is_none_or(|(most, _)| force > most) {
                        best = Some((force, journal));
                    }
                    break;
                }
                match turn * first > 0.0 {
                    true => low = middle,
                    false => high = middle,
                }
            }
        }
        best.and_then(|(_, journal)| self.still_beyond(problem, &journal))
    }

    /// The problem in a rigid wall, and this search there; what it finds is no force of the film asked for, and kept
    /// apart.
    pub(crate) fn in_rigid_wall(&self, problem: &FilmProblem) -> (FilmProblem, Self) {
        let rigid = problem.clone().with_rigid_wall();
        let search = Self::new(&rigid, self.system, self.load, self.options);
        (rigid, search)
    }

    /// Whether the film carries less than `greatest` [N] at a smaller eccentricity; with tension on one side of an arc
    /// it need not.
    fn grows(&self, problem: &FilmProblem, angle: f64, greatest: f64) -> bool {
        let e = BEFORE * self.gap.reach(&problem.journal, angle);
        let at = self.at_offset(problem, [e * angle.cos(), e * angle.sin()]);
        let before = self.trial(problem, at, Neighbour::None);
        before.is_ok_and(|trial| size(&trial) < greatest)
    }

    /// The reason if the load is below the round-off of the film's force.
    pub(crate) fn below_rounding(&self) -> Option<NoEquilibrium> {
        let asked = self.load.magnitude();
        let least = ROUNDING * self.reference_force;
        (asked > 0.0 && asked < least).then_some(NoEquilibrium::BelowRounding { asked, least })
    }
}

/// Whether contact presses the wall out.
pub(crate) fn yields_to_contact(problem: &FilmProblem) -> bool {
    problem.deflection().is_some() && problem.contact.is_some()
}

/// Magnitude of the force that a film carries [N].
fn size(trial: &Trial) -> f64 {
    trial.carried.force[0].hypot(trial.carried.force[1])
}
