//! A walk along a chain of neighbouring cases: each begins where the ones before it lead.
//!
//! What a case finds depends on its chain alone: not on the threads, nor on what was computed before the chain.

use std::time::Instant;

use oilwedge_bearing::{Deadline, InitialGuess, Point, SHORT_MOVE, Visited, predicted};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, FilmSolution, JournalState};

use oilwedge_scene::Scene;
use oilwedge_study::analysis::{NoAnswer, Solved, graded, is_near, solve, solve_from};
use oilwedge_study::compile::{CompileError, Study, compile_near, has_same_system, reused};
use oilwedge_study::estimate::estimate_errors;
use oilwedge_study::oil::Oil;
use oilwedge_study::quantities::Quantity;
use oilwedge_study::refinement::{answer, ended, unknowns};
use oilwedge_study::result::Status;
use oilwedge_study::run::RunOptions;
use oilwedge_study::start::start;

/// How a case ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CaseStatus {
    /// As a run ends.
    Run(Status),
    /// The scene of the case does not fit its mesh, or cannot be meshed.
    BadScene,
}

/// What a case gives.
#[derive(Debug, Clone)]
pub struct Found {
    /// How it ended.
    pub status: CaseStatus,
    /// Why it ended without an answer, or short of its tolerance.
    pub reason: Option<String>,
    /// Its quantities; none without a film.
    pub quantities: Vec<Quantity>,
    /// Nodes whose pressure was not given, on the last mesh.
    pub unknowns: Option<usize>,
    /// Wall time [s].
    pub seconds: f64,
}

/// A study of the case before, and where its mesh was graded for.
struct Held {
    scene: Scene,
    study: Study,
    graded_for: JournalState,
    /// The film of the case before, on this system.
    film: Option<FilmSolution>,
}

/// Walks along chains.
pub(super) struct Walker<'a> {
    options: &'a RunOptions,
    /// That of the case that is computed.
    deadline: Deadline,
    held: Option<Held>,
    visited: Vec<Visited>,
}

impl<'a> Walker<'a> {
    pub(super) fn new(options: &'a RunOptions) -> Self {
        Self {
            options,
            deadline: Deadline::default(),
            held: None,
            visited: Vec::new(),
        }
    }

    /// Forgets all that a new chain must not know: a mesh that no position has shaped may stay.
    pub(super) fn begin(&mut self) {
        self.visited.clear();
        self.held = self.held.take().filter(|held| !held.scene.mesh.is_graded());
        if let Some(held) = &mut self.held {
            held.film = None;
        }
    }

    /// Computes the next case of the chain; `coordinate` is its value on the axis along which the chain runs.
    pub(super) fn case(&mut self, scene: &Scene, coordinate: f64) -> Found {
        let clock = Instant::now();
        self.deadline = self.options.deadline();
        let found = match scene.tolerance.is_some() && self.options.bars {
            true => self.refined(scene),
            false => self.walked(scene, coordinate),
        };
        let mut found = found.unwrap_or_else(|error| Found {
            status: CaseStatus::BadScene,
            reason: Some(error.to_string()),
            quantities: Vec::new(),
            unknowns: None,
            seconds: 0.0,
        });
        found.seconds = clock.elapsed().as_secs_f64();
        found
    }

    /// With a tolerance each case has meshes of its own, as when it is solved by itself.
    fn refined(&mut self, scene: &Scene) -> Result<Found, CompileError> {
        let answer = answer(scene, self.options)?;
        let size = unknowns(&answer.study);
        Ok(match answer.outcome {
            Ok((_, judged)) => Found {
                status: CaseStatus::Run(match answer.limit {
                    Some(_) => Status::NotConverged,
                    None => Status::Converged,
                }),
                reason: answer.limit,
                quantities: judged.quantities,
                unknowns: Some(size),
                seconds: 0.0,
            },
            Err(reason) => failed(&reason, size),
        })
    }

    /// On one mesh, from the case before if there is one.
    fn walked(&mut self, scene: &Scene, coordinate: f64) -> Result<Found, CompileError> {
        let (mut held, outcome) = match self.following(scene, coordinate)? {
            Some((held, solved)) => (held, Ok(solved)),
            None => self.by_itself(scene)?,
        };
        let size = unknowns(&held.study);
        let found = match outcome {
            Ok(solved) => {
                let judged = estimate_errors(&held.study, &solved);
                let limit = ended(&solved, self.options);
                let journal = &held.study.problem.journal;
                if limit.is_some() {
                    self.visited.clear();
                } else {
                    self.visited.push(Visited {
                        point: point(scene, coordinate),
                        eccentricity: journal.eccentricity() / scene.bearing.clearance,
                        angle: journal.min_film_angle(),
                    });
                    held.film = Some(solved.film);
                }
                Found {
                    status: CaseStatus::Run(match limit {
                        Some(_) => Status::NotConverged,
                        None => Status::Converged,
                    }),
                    reason: limit,
                    quantities: judged.quantities,
                    unknowns: Some(size),
                    seconds: 0.0,
                }
            }
            Err(reason) => {
                self.visited.clear();
                held.film = None;
                failed(&reason, size)
            }
        };
        self.held = Some(held);
        Ok(found)
    }

    /// As the case is solved by itself.
    fn by_itself(&mut self, scene: &Scene) -> Result<(Held, Result<Solved, NoAnswer>), CompileError> {
        let ungraded = self
            .held
            .take()
            .filter(|held| !scene.mesh.is_graded() && has_same_system(&held.scene, scene));
        let mut study = match ungraded {
            Some(held) => reused(held.study, scene, start(scene)),
            None => graded(scene, self.deadline)?,
        };
        let graded_for = study.problem.journal;
        let outcome = solve(&mut study, self.options.bars, self.deadline);
        let held = Held {
            scene: scene.clone(),
            study,
            graded_for,
            film: None,
        };
        Ok((held, outcome))
    }

    /// From the case before, if there is one and it leads to an answer.
    fn following(&mut self, scene: &Scene, coordinate: f64) -> Result<Option<(Held, Solved)>, CompileError> {
        let told = match scene.journal.load() {
            None => Some(start(scene)),
            Some(_) => predicted(&self.visited, point(scene, coordinate)),
        };
        let is_neighbour = |held: &Held| held.film.is_some() && has_same_system(&held.scene, scene);
        let (Some(near), true) = (told, self.held.as_ref().is_some_and(is_neighbour)) else {
            return Ok(None);
        };
        let Some(held) = self.held.take() else { return Ok(None) };
        let before = relative(&held.study);
        let study = reused(held.study, scene, near);
        let film = held.film.filter(|_| is_short(before, relative(&study)));
        let mut held = Held {
            scene: scene.clone(),
            study,
            graded_for: held.graded_for,
            film,
        };
        let suits = |held: &Held| {
            let FilmProblem { bearing, journal, .. } = &held.study.problem;
            !held.scene.mesh.is_graded() || is_near(bearing, &held.graded_for, journal)
        };
        if !suits(&held) {
            held = redrawn(scene, near)?;
        }
        for _ in 0..2 {
            let start = InitialGuess::Near(held.film.as_ref().map_or(Neighbour::None, Neighbour::Start));
            let Ok(solved) = solve_from(&mut held.study, self.options.bars, self.deadline, start) else {
                // A mesh that a film has not shaped is good for another start.
                self.held = Some(held);
                return Ok(None);
            };
            if suits(&held) {
                return Ok(Some((held, solved)));
            }
            let journal = &held.study.problem.journal;
            held = redrawn(
                scene,
                (
                    journal.eccentricity() / scene.bearing.clearance,
                    journal.min_film_angle(),
                ),
            )?;
        }
        Ok(None)
    }
}

/// The case on a mesh drawn for the position `near`.
fn redrawn(scene: &Scene, near: (f64, f64)) -> Result<Held, CompileError> {
    let study = compile_near(scene, near)?;
    Ok(Held {
        scene: scene.clone(),
        graded_for: study.problem.journal,
        study,
        film: None,
    })
}

/// What tells the position of a case from those of its neighbours.
fn point(scene: &Scene, coordinate: f64) -> Point {
    let (bearing, journal) = (&scene.bearing, &scene.journal);
    let [x, y] = journal.load().unwrap_or_default();
    let slenderness = bearing.radius() / bearing.clearance;
    let drag = Oil::of(scene).viscosity * journal.speed.abs() * slenderness.powi(2) * bearing.diameter * bearing.length;
    let duty = (x.hypot(y) / drag).ln();
    Point {
        coordinate,
        duty: if duty.is_finite() { duty } else { 0.0 },
    }
}

/// Offset of the journal over the clearance.
fn relative(study: &Study) -> [f64; 2] {
    study
        .problem
        .journal
        .offset
        .map(|e| e / study.problem.bearing.clearance)
}

/// Whether a film is a good start after the journal has moved so far.
fn is_short(before: [f64; 2], after: [f64; 2]) -> bool {
    let gap = 1.0 - before[0].hypot(before[1]);
    (after[0] - before[0]).hypot(after[1] - before[1]) < SHORT_MOVE * gap
}

fn failed(reason: &NoAnswer, size: usize) -> Found {
    Found {
        status: CaseStatus::Run(reason.status()),
        reason: Some(reason.to_string()),
        quantities: Vec::new(),
        unknowns: Some(size),
        seconds: 0.0,
    }
}
