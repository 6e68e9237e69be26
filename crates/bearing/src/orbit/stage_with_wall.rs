//! One implicit stage of a journal in a wall that gives way: place and deflection are found together, by Newton's
//! method, so that each step solves one film.
//!
//! ```text
//! W(x, v, d, d') + m (v - v_0)/(gamma dt) = F        C f(p(x, v, d, d')) = d
//! v = (x - x_0)/(gamma dt)        d' = (d - d_0)/(gamma dt)
//! ```

use std::sync::Arc;

use oilwedge_fem::Error;
use oilwedge_fem::newton::Failure;
use oilwedge_reynolds::CentreVelocity;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::quantities::contact_points::ContactPoints;
use oilwedge_reynolds::solve::Neighbour;

use super::motion::{Held, Instant, Motion, Moving};
use super::stage::{Accuracy, Known, LEAST_SHRINK, MOST_FILMS, NEARLY_BALANCED, NoStage, SETTLED, SHORTEST};
use crate::coordinates::{Vector, length, moved};
use crate::deflection::{Follower, Joint, Left, Moves, contact_points};

/// Accuracy of the linear system of a step: each step leaves about this part of what is left.
const FOLLOWED: f64 = 1e-3;

/// A film of the iteration, and what it leaves of both equations.
struct Trial {
    instant: Instant,
    /// Of the equation of motion [N].
    force: Vector,
    /// Of the wall.
    wall: Left,
    /// Of the motion, over the greatest load, and of the wall, over the deflection [1].
    parts: [f64; 2],
}

impl Trial {
    /// Both together [1].
    fn left(&self) -> f64 {
        self.parts[0].hypot(self.parts[1])
    }
}

impl Motion<'_> {
    /// Solves a stage from a `start`, a wall expected there, and a film nearby; `films` counts those solved.
    pub(super) fn stage_with_wall(
        &self,
        (known, wall): (&Known, Deflection),
        start: Vector,
        near: &Instant,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Instant, NoStage> {
        let scale = accuracy.scale;
        let (at, wall) = self.begun(near, start, wall)?;
        let mut here = self.tried((known, scale), at, &wall, Neighbour::Start(&near.film), films)?;
        // Newton's method reduces the changes as it reduces what is left.
        let mut change = f64::INFINITY;
        for _ in 1..MOST_FILMS {
            let left = here.left();
            if left < accuracy.balanced() && change < SETTLED * accuracy.tolerance {
                return self.found(known, here.instant);
            }
            let joint = self.joint(known.per_time, &here.instant, here.wall.contact.clone())?;
            let moves = joint.solve(here.force.map(|part| -part), Some(&here.wall.wall))?;
            let bent = here.instant.wall().ok_or(NoStage::Diverged)?;
            let (gap, mut part) = self.longest(bent, here.instant.at, &moves);
            let size = length(moves.place) / gap;
            if !size.is_finite() || gap <= 0.0 {
                return Err(NoStage::Diverged);
            }
            let next = loop {
                let (at, bent) = moves.made(here.instant.at, bent, part);
                let next = self.tried((known, scale), at, &bent, Neighbour::Start(&here.instant.film), films);
                match next {
                    Ok(next) if next.left() < left => break Some(next),
                    Ok(_) if left < NEARLY_BALANCED => break None,
                    Err(reason) if part < SHORTEST => return Err(reason),
                    _ if part < SHORTEST => return Err(NoStage::Diverged),
                    _ => part *= 0.5,
                }
            };
            let Some(next) = next else {
                return self.found(known, here.instant);
            };
            change = size * (1.0 - part + next.left() / left);
            here = next;
        }
        Err(NoStage::Diverged)
    }

    /// Where a stage begins from a film nearby: at a start and under a wall expected there, or on the way to both.
    fn begun(&self, near: &Instant, start: Vector, wall: Deflection) -> Result<(Vector, Deflection), NoStage> {
        let here = near.wall().ok_or(NoStage::Diverged)?;
        let apart = wall.coefficients.iter().zip(&*here.coefficients);
        let moves = Moves {
            place: moved(start, -1.0, near.at),
            wall: apart.map(|(there, here)| there - here).collect(),
            contact: Vec::new(),
        };
        let (_, part) = self.longest(here, near.at, &moves);
        let (at, bent) = moves.made(near.at, here, part);
        Ok((at, wall.with(bent.coefficients.to_vec())))
    }

    /// The least gap [m] at a place under a wall, and the longest part of moves that leaves enough of it.
    fn longest(&self, wall: &Deflection, at: Vector, moves: &Moves) -> (f64, f64) {
        let gap = self.least_gap_under(Some(wall), at);
        let leaves = |part: f64| {
            let (at, bent) = moves.made(at, wall, part);
            self.least_gap_under(Some(&bent), at) >= LEAST_SHRINK * gap
        };
        let mut part = 1.0;
        // A gap that is none leaves no step.
        while gap > 0.0 && !leaves(part) && part > SHORTEST {
            part *= 0.8;
        }
        (gap, part)
    }

    /// The film at a place of the stage under a wall.
    fn tried(
        &self,
        (known, scale): (&Known, f64),
        at: Vector,
        wall: &Deflection,
        near: Neighbour,
        films: &mut usize,
    ) -> Result<Trial, NoStage> {
        *films += 1;
        let moving = Moving { time: known.time, at, velocity: known.velocity(at) };
        let held = Held { storage: known.before.as_ref().map(|before| &before.storage), wall: Some(wall) };
        let (instant, contact) = self.trial_under(moving, held, near)?;
        let wall = Left::of(&instant.film, contact);
        let force = self.residual(known, &instant);
        Ok(Trial { parts: [length(force) / scale, wall.residual], force, wall, instant })
    }

    /// What stiffness of film and wall leaves of an error of the place and of one of the wall, in the place: both push
    /// the film as rates in the stage do.
    pub(super) fn damped_with_wall(
        &self,
        end: &Instant,
        error: Vector,
        of_wall: &[f64],
        per_time: f64,
    ) -> Result<Vector, NoStage> {
        let joint = self.joint(per_time, end, contact_points(&end.film.problem, self.system))?;
        let along = (self.coordinates()).change(&end.film.problem.journal, &CentreVelocity::default(), error);
        let (by_film, bent) = joint.pushed(&along.as_rate(), of_wall)?;
        let masses = self.masses();
        let force = [0, 1, 2, 3].map(|k| per_time * (by_film[k] + masses[k] * per_time * error[k]));
        let bent: Vec<f64> = bent.iter().map(|bent| -per_time * bent).collect();
        Ok(joint.solve(force, Some(&bent))?.place)
    }

    /// The tangent of journal and wall in a stage, by its points of contact; `per_time` is its `1/(gamma dt)` [1/s].
    fn joint<'a>(
        &'a self,
        per_time: f64,
        here: &'a Instant,
        contact: Option<Arc<ContactPoints>>,
    ) -> Result<Joint<'a>, NoStage> {
        let follower = Follower::touching(&here.film, contact)?;
        let follower = follower.ok_or(NoStage::Diverged)?;
        let masses = self.masses();
        let held = [0, 1, 2, 3].map(|k| {
            let support = if k >= 2 { self.support_stiffness() } else { 0.0 };
            support + masses[k] * per_time.powi(2)
        });
        let change = |k: usize| self.change(&here.film.problem.journal, k, [1.0, per_time]);
        Ok(Joint::of(follower, self.coordinates(), change, held, FOLLOWED)?)
    }
}

impl From<Error> for NoStage {
    fn from(reason: Error) -> Self {
        Self::Film(Failure::from(reason).into())
    }
}

impl Known {
    /// The wall with which the stage begins: where it is expected, or that of a film nearby; none where it is rigid.
    pub(super) fn wall_from(&self, near: &Instant) -> Option<Deflection> {
        let deflection = near.film.problem.deflection()?;
        Some(match &self.wall {
            Some((stage, expected)) => deflection.with(expected.clone()).in_stage(stage.clone()),
            None => deflection.clone(),
        })
    }
}
