//! A shaft at rest on its films under loads that do not change.
//!
//! The journals sink from near the middle of their bearings by implicit steps in time that grow, on the coarsest
//! meshes; from there Newton's method leads on to the balance, from mesh to mesh. The damping of the last step stays in
//! the tangent in proportion to what is unbalanced, so that a film that carries nothing leaves no journal free.

use super::films::{Films, NoFilmAt, magnitude};
use super::stage::{Accuracy, Known, NoStage, Staged};
use crate::Deadline;
use crate::coordinates::{Vector, moved};
use crate::orbit::Instant;

/// The first step in time over 1/omega, and how steps grow.
const FIRST: f64 = 0.5;
const GROWTH: f64 = 2.5;
/// A step without a solution is divided by this,
const RETRY: f64 = 4.0;
/// until it is this much shorter than the first one.
const SHORTEST: f64 = 1e-6;
/// Sinking ends where a step is this long, over 1/omega,
const LONGEST: f64 = 1e6;
/// or where the balance at rest is left by less than this part of the load.
const AT_REST: f64 = 1e-2;
/// Most steps.
const MOST_STEPS: usize = 120;
/// Residual over the load, and change over the least gap, of a step and of the balance.
const ROUGHLY: [f64; 2] = [1e-3, 1e-2];
const BALANCED: [f64; 2] = [1e-11, 1e-8];

/// A shaft in balance.
#[derive(Debug)]
pub struct Balance {
    /// The films.
    pub instants: Vec<Instant>,
    /// What is left of the balance, over the load [1].
    pub residual: f64,
    /// Films solved on the meshes of the bearings.
    pub films: usize,
}

/// Why a shaft has no balance.
#[derive(Debug, thiserror::Error)]
pub enum NoBalance {
    /// A journal has no film.
    #[error("no film: {0}")]
    Film(NoFilmAt),
    /// The search does not converge.
    #[error(
        "not converged: the balance of the shaft is left by {residual:.1e} of the load, where the least film is {gap:.2e} of the clearance"
    )]
    Stuck {
        /// What is left of the balance, over the load [1].
        residual: f64,
        /// The bearing with the least film, by its number from 0.
        bearing: usize,
        /// That film over the clearance [1].
        gap: f64,
    },
    /// The time was over.
    #[error("not converged: the search for the balance of the shaft was ended")]
    Ended,
}

impl Films<'_> {
    /// The balance under loads on the journals [N], the shaft turned by `angle` [rad].
    ///
    /// # Errors
    /// [`NoBalance`]: why there is none.
    pub fn balance(&self, asked: &[Vector], angle: f64, deadline: Deadline) -> Result<Balance, NoBalance> {
        let coarser = self.coarser();
        let start = coarser.and_then(|coarser| coarser.balance(asked, angle, deadline).ok());
        let mut films = 0;
        if let Some(start) = start.map(|start| places(&start.instants))
            && let Ok(found) = self.settled(self.known(asked, angle, 0.0), start, None, &mut films)
        {
            return Ok(of(found, films));
        }
        self.sunk(asked, angle, deadline, &mut films)
    }

    /// The balance near another one, whose films carried somewhat more or less.
    ///
    /// # Errors
    /// [`NoBalance`]: why there is none.
    pub fn rebalanced(&self, asked: &[Vector], angle: f64, near: &Balance) -> Result<Balance, NoBalance> {
        let mut films = near.films;
        let start = places(&near.instants);
        match self.settled(self.known(asked, angle, 0.0), start, Some(&near.instants), &mut films) {
            Ok(found) => Ok(of(found, films)),
            Err(NoStage::Film(reason)) => Err(NoBalance::Film(reason)),
            Err(NoStage::Diverged(residual, place)) => Err(self.stuck(residual, &place)),
        }
    }

    /// How all journals move [m] where one film carries somewhat more [N] in its place, for each such bearing, by its
    /// number, and force; not finite where the tangent is singular.
    ///
    /// # Errors
    /// [`NoFilmAt`]: the linear systems of a film could not be solved.
    pub fn moved_by(
        &self,
        instants: &[Instant],
        angle: f64,
        more: &[(usize, Vector)],
    ) -> Result<Vec<Vec<Vector>>, NoFilmAt> {
        let slopes = self.slopes(instants, (1.0, 0.0))?;
        let moved_by = |&(bearing, force): &(usize, Vector)| {
            let mut displaced = vec![[0.0; 4]; self.films.len()];
            displaced[bearing] = self.films[bearing].yields(force);
            let mut left = self.shaft.forces(&displaced, angle);
            left[bearing] = moved(left[bearing], 1.0, force);
            let step = self.newton_step(&slopes, &left, angle);
            step.unwrap_or_else(|| vec![[f64::NAN; 4]; self.films.len()])
        };
        Ok(more.iter().map(moved_by).collect())
    }

    /// Where a search has got to that does not converge.
    fn stuck(&self, residual: f64, place: &[Vector]) -> NoBalance {
        let (bearing, gap) = self.thinnest(place);
        NoBalance::Stuck { residual, bearing, gap }
    }

    fn scale(&self, asked: &[Vector]) -> f64 {
        match magnitude(asked) {
            0.0 => self.films.iter().map(|film| film.motion().peak_load()).fold(f64::MIN_POSITIVE, f64::max),
            load => load,
        }
    }

    fn known(&self, asked: &[Vector], angle: f64, shift: f64) -> Known {
        Known {
            time: 0.0,
            angle,
            per_time: 0.0,
            offset: vec![[0.0; 4]; self.films.len()],
            asked: asked.to_vec(),
            shift,
            slopes: None,
        }
    }

    /// The balance at rest from a place nearby.
    fn settled(
        &self,
        known: Known,
        start: Vec<Vector>,
        near: Option<&[Instant]>,
        films: &mut usize,
    ) -> Result<Staged, NoStage> {
        let accuracy =
            Accuracy { balanced: BALANCED[0], settled: Some(BALANCED[1]), scale: self.scale(&known.asked), steep: 0.0 };
        self.stage(&known, start, near, accuracy, films)
    }

    /// The balance, by sinking from the middle.
    fn sunk(&self, asked: &[Vector], angle: f64, deadline: Deadline, films: &mut usize) -> Result<Balance, NoBalance> {
        let speed = self.films.iter().map(|film| film.problem.journal.speed.abs()).fold(f64::MIN_POSITIVE, f64::max);
        let accuracy =
            Accuracy { balanced: ROUGHLY[0], settled: Some(ROUGHLY[1]), scale: self.scale(asked), steep: 0.0 };
        let mut at = self.first_places(asked);
        let mut here: Option<Vec<Instant>> = None;
        let mut dt = FIRST;
        let mut stuck = (1.0, at.clone());
        for _ in 0..MOST_STEPS {
            if deadline.is_over() {
                return Err(NoBalance::Ended);
            }
            let known = Known { per_time: speed / dt, offset: at.clone(), ..self.known(asked, angle, 0.0) };
            match self.stage(&known, at.clone(), here.as_deref(), accuracy, films) {
                Ok(found) => {
                    at = places(&found.instants);
                    here = Some(found.instants);
                    let rate = here.iter().flatten().map(|here| here.velocity).collect::<Vec<_>>();
                    // What the motion of the last step still carries, by its share of the gap in a turn.
                    let is_slow = self.change(&at, &rate) / speed < AT_REST;
                    dt *= GROWTH;
                    if is_slow || dt > LONGEST {
                        match self.settled(self.known(asked, angle, speed / dt), at.clone(), here.as_deref(), films) {
                            Ok(found) => return Ok(of(found, *films)),
                            Err(NoStage::Film(reason)) if dt > LONGEST => return Err(NoBalance::Film(reason)),
                            // A slower journal may have one.
                            Err(NoStage::Film(_)) => {}
                            Err(NoStage::Diverged(residual, place)) => stuck = (residual, place),
                        }
                    }
                    if dt > LONGEST {
                        break;
                    }
                }
                Err(NoStage::Film(reason)) if dt < SHORTEST => return Err(NoBalance::Film(reason)),
                Err(NoStage::Diverged(residual, place)) if dt < SHORTEST => {
                    stuck = (residual, place);
                    break;
                }
                Err(_) => dt /= RETRY,
            }
        }
        Err(self.stuck(stuck.0, &stuck.1))
    }
}

fn places(instants: &[Instant]) -> Vec<Vector> {
    instants.iter().map(|here| here.at).collect()
}

fn of(found: Staged, films: usize) -> Balance {
    Balance { instants: found.instants, residual: found.residual, films }
}
