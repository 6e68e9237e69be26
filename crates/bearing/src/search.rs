//! One position of the journal tried: its film, its force, and the tangent of the force.

use std::cell::{Cell, RefCell};

use oilwedge_reynolds::quantities::load::{load, load_change};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{CentreVelocity, FilmProblem, FilmSolution, FilmSystem, JournalState, NoFilm};

use crate::equilibrium::{NEAR, Stiffness};
use crate::{NoEquilibrium, SearchOptions};

/// A load that was not balanced and is less than this part of the reference force is below round-off.
const LOST: f64 = 1e-7;
/// A force within this factor of the load
const NEARLY: f64 = 2.0;
/// and this angle [rad] leaves open whether there is a position.
const ASTRAY: f64 = 0.5;
/// A film whose force is nowhere this part of the load carries none.
const AT_REST: f64 = 1e-3;

/// A search for the position that balances a load on one mesh.
pub(crate) struct Search<'a> {
    pub(crate) system: &'a FilmSystem,
    pub(crate) load: [f64; 2],
    pub(crate) options: SearchOptions<'a>,
    /// Residuals are relative to this force [N].
    pub(crate) scale: f64,
    /// Round-off of the film's force is relative to this one [N].
    pub(crate) reference_force: f64,
    /// The trial whose force was nearest to the load.
    pub(crate) nearest: Cell<Option<Nearest>>,
    /// True of a full Sommerfeld film.
    pub(crate) bears_tension: bool,
    /// Load less force of each trial, relative to the load.
    pub(crate) tried: RefCell<Vec<f64>>,
}

/// The distance of a trial from the load, its force [N] and its journal.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Nearest {
    pub(crate) distance: f64,
    pub(crate) force: [f64; 2],
    pub(crate) journal: JournalState,
}

/// A position, its film and its force.
pub(crate) struct Trial {
    pub(crate) problem: FilmProblem,
    pub(crate) film: FilmSolution,
    /// The film in cubic elements, where the force is that of it.
    pub(crate) cubic: Option<FilmSolution>,
    pub(crate) force: [f64; 2],
    /// Residual of the position at which the advection schemes of a mass-conserving film were chosen; infinite where a
    /// neighbouring film had a part in the choice.
    pub(crate) schemes_chosen_at: f64,
    /// True where the force has changed smoothly from that of the trial before: it is that of a mass-conserving film with the same schemes.
    pub(crate) is_continued: bool,
}

impl<'a> Search<'a> {
    /// A search for `load` [N] on `system`.
    pub(crate) fn new(
        problem: &FilmProblem,
        system: &'a FilmSystem,
        load: [f64; 2],
        options: SearchOptions<'a>,
    ) -> Self {
        let reference_force = reference_force(problem, system, options.centre_velocity);
        Self {
            system,
            load,
            options,
            reference_force,
            scale: match load[0].hypot(load[1]) {
                0.0 => reference_force.max(f64::MIN_POSITIVE),
                load => load,
            },
            nearest: Cell::new(None),
            bears_tension: problem.cavitation.bears_tension(),
            tried: RefCell::default(),
        }
    }

    /// Positions all over the bearing, those with the force nearest to the load first.
    pub(crate) fn starts(&self, problem: &FilmProblem) -> Vec<JournalState> {
        const ANGLES: u32 = 12;
        let mut starts: Vec<(f64, JournalState)> = Vec::new();
        for eps in [0.3, 0.7, 0.95, 0.99] {
            for k in 0..ANGLES {
                if self.options.deadline.is_over() {
                    break;
                }
                let angle = std::f64::consts::TAU * f64::from(k) / f64::from(ANGLES);
                let e = eps * problem.bearing.reach(&problem.journal, angle);
                if let Ok(trial) = self.trial(problem, [e * angle.cos(), e * angle.sin()], Neighbour::None) {
                    starts.push((self.distance(&trial), trial.problem.journal));
                }
            }
        }
        starts.sort_by(|a, b| a.0.total_cmp(&b.0));
        starts.into_iter().map(|(_, start)| start).collect()
    }

    /// The film at the start or, where there is none, nearer to the middle.
    pub(crate) fn first(&self, problem: &FilmProblem, mut start: JournalState) -> Result<Trial, NoFilm> {
        const RETREATS: usize = 12;
        for _ in 0..RETREATS {
            match self.trial(problem, start.offset, Neighbour::None) {
                // Without a supply there is no film anywhere.
                Err(reason) if !matches!(reason, NoFilm::NoSupply { .. }) => {
                    start.offset = start.offset.map(|e| 0.5 * e)
                }
                other => return other,
            }
        }
        self.trial(problem, start.offset, Neighbour::None)
    }

    /// The trial at `offset` [m] by the force of the film in quadratic elements.
    pub(crate) fn trial(&self, problem: &FilmProblem, offset: [f64; 2], near: Neighbour) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, offset);
        let film = problem.solve_from(self.system, near)?;
        let force = load(&problem, self.system, &film).total.force;
        let trial = self.recorded(Trial {
            problem,
            film,
            cubic: None,
            force,
            schemes_chosen_at: f64::INFINITY,
            is_continued: false,
        });
        Ok(match near {
            Neighbour::None => Trial {
                schemes_chosen_at: self.residual(&trial),
                ..trial
            },
            Neighbour::Start(_) | Neighbour::Kept(_) => trial,
        })
    }

    /// The trial at `offset` [m] by the force of the film in cubic elements, started from that of a neighbouring position, if there is one.
    pub(crate) fn cubic_trial(
        &self,
        problem: &FilmProblem,
        offset: [f64; 2],
        near: Neighbour,
        cubic: Option<&FilmSolution>,
    ) -> Result<Trial, NoFilm> {
        let problem = self.placed(problem, offset);
        let film = problem.solve_from(self.system, near)?;
        let cubic = problem.cubic_film(self.system, &film, cubic)?;
        let force = load(&problem, &self.system.cubic().system, &cubic).total.force;
        Ok(self.recorded(Trial {
            problem,
            film,
            cubic: Some(cubic),
            force,
            schemes_chosen_at: f64::INFINITY,
            is_continued: false,
        }))
    }

    /// The problem with the journal at `offset` [m].
    fn placed(&self, problem: &FilmProblem, offset: [f64; 2]) -> FilmProblem {
        let angle = match offset {
            [0.0, 0.0] => problem.journal.min_film_angle(),
            [x, y] => y.atan2(x),
        };
        let journal = JournalState {
            offset,
            ..problem.journal
        };
        FilmProblem {
            journal: journal.with_centre_velocity(self.options.centre_velocity, angle),
            ..problem.clone()
        }
    }

    fn recorded(&self, trial: Trial) -> Trial {
        let distance = self.distance(&trial);
        let residual = self.residual(&trial);
        self.tried.borrow_mut().push(residual);
        if let Some(observer) = self.options.observer {
            observer.position(self.tried.borrow().len(), residual);
        }
        if self.nearest.get().is_none_or(|nearest| distance < nearest.distance) {
            self.nearest.set(Some(Nearest {
                distance,
                force: trial.force,
                journal: trial.problem.journal,
            }));
        }
        trial
    }

    /// Difference of force and load over the load.
    pub(crate) fn residual(&self, trial: &Trial) -> f64 {
        let [x, y] = self.excess(trial);
        x.hypot(y) / self.scale
    }

    /// Force of the film less the load [N].
    pub(crate) fn excess(&self, trial: &Trial) -> [f64; 2] {
        [trial.force[0] - self.load[0], trial.force[1] - self.load[1]]
    }

    /// `dW/de`.
    pub(crate) fn stiffness(&self, trial: &Trial) -> Result<Stiffness, NoFilm> {
        let mut stiffness = [[0.0; 2]; 2];
        for k in 0..2 {
            let mut unit = [0.0; 2];
            unit[k] = 1.0;
            let change = self.options.centre_velocity.change(&trial.problem.journal, unit);
            let unknown = (trial.problem)
                .unknown_change(self.system, &trial.film, &change)
                .map_err(oilwedge_fem::newton::Failure::from)?;
            let by_offset = load_change(&trial.problem, self.system, &trial.film, &unknown);
            stiffness[0][k] = by_offset[0];
            stiffness[1][k] = by_offset[1];
        }
        Ok(stiffness)
    }

    /// The tangent `dW/de` corrected by the change of the force from one trial to the next (Broyden, Math. Comp. 19 (1965) 577).
    pub(crate) fn corrected(tangent: Stiffness, from: &Trial, to: &Trial) -> Stiffness {
        let step = [0, 1].map(|k| to.problem.journal.offset[k] - from.problem.journal.offset[k]);
        let square = step[0] * step[0] + step[1] * step[1];
        let mut corrected = tangent;
        for d in 0..2 {
            let predicted = tangent[d][0] * step[0] + tangent[d][1] * step[1];
            let missed = (to.force[d] - from.force[d] - predicted) / square;
            for k in 0..2 {
                corrected[d][k] += if square > 0.0 { missed * step[k] } else { 0.0 };
            }
        }
        corrected
    }

    /// How far the force is from the load: by logarithm and angle, so that forces much too large and much too small
    /// count alike; by the residual where that is small.
    pub(crate) fn distance(&self, trial: &Trial) -> f64 {
        let residual = self.residual(trial);
        let (force, load) = (trial.force[0].hypot(trial.force[1]), self.load[0].hypot(self.load[1]));
        if residual < NEAR || load == 0.0 {
            return residual;
        }
        if force == 0.0 {
            return f64::MAX;
        }
        let along = trial.force[0] * self.load[0] + trial.force[1] * self.load[1];
        let across = trial.force[0] * self.load[1] - trial.force[1] * self.load[0];
        (load / force).ln().hypot(across.atan2(along))
    }

    /// The reason as far as it is known: a search that was ended, or came near to the load, does not prove that there is no position;
    /// a load near round-off is reported as one.
    pub(crate) fn confirmed(&self, reason: NoEquilibrium) -> NoEquilibrium {
        let least = LOST * self.reference_force;
        match reason {
            NoEquilibrium::Unreachable { asked, .. } | NoEquilibrium::NotConverged { asked, .. } if asked < least => {
                NoEquilibrium::BelowRounding { asked, least }
            }
            NoEquilibrium::Unreachable {
                asked,
                nearest,
                journal,
                ..
            } if self.options.deadline.is_over() => NoEquilibrium::Ended {
                asked,
                nearest,
                journal,
                history: self.tried.take(),
            },
            NoEquilibrium::Unreachable { asked, journal, .. } if self.came_near() => {
                let history = self.tried.take();
                NoEquilibrium::NotConverged {
                    asked,
                    residual: history.iter().copied().fold(f64::INFINITY, f64::min),
                    journal,
                    history,
                }
            }
            reason => reason,
        }
    }

    /// Whether a force was found that is as large as the load by [`NEARLY`] and points its way by [`ASTRAY`].
    fn came_near(&self) -> bool {
        self.nearest.get().is_some_and(|Nearest { force: [x, y], .. }| {
            let [load_x, load_y] = self.load;
            let ratio = x.hypot(y) / load_x.hypot(load_y);
            let turn = (x * load_y - y * load_x).atan2(x * load_x + y * load_y);
            // A film that bears tension has forces to all sides, of any size.
            let is_any = self.bears_tension && ratio > AT_REST;
            is_any || (1.0 / NEARLY..NEARLY).contains(&ratio) && turn.abs() < ASTRAY
        })
    }

    /// The reason with the nearest of all trials.
    pub(crate) fn unreachable(&self, trial: &Trial, why: &'static str) -> NoEquilibrium {
        let degrees = |[x, y]: [f64; 2]| y.atan2(x).to_degrees().rem_euclid(360.0);
        let last = Nearest {
            distance: self.distance(trial),
            force: trial.force,
            journal: trial.problem.journal,
        };
        let nearest = self.nearest.get().filter(|nearest| nearest.distance < last.distance);
        let nearest = nearest.unwrap_or(last);
        NoEquilibrium::Unreachable {
            asked: self.load[0].hypot(self.load[1]),
            towards: degrees(self.load),
            nearest: nearest.force[0].hypot(nearest.force[1]),
            nearest_towards: degrees(nearest.force),
            eccentricity: nearest.journal.eccentricity() / trial.problem.bearing.clearance,
            journal: Box::new(trial.problem.journal),
            why,
        }
    }
}

/// The force [N] of drag through the clearance, or that of the greatest pressure given on the projected area.
fn reference_force(problem: &FilmProblem, system: &FilmSystem, centre_velocity: CentreVelocity) -> f64 {
    let bearing = &problem.bearing;
    let tilting = JournalState { velocity: [0.0; 2], ..problem.journal }.squeeze_speed(0.5 * bearing.length);
    let rate = problem.journal.speed.abs() + (centre_velocity.speed() + tilting) / bearing.clearance;
    let drag = problem.lubricant.viscosity * rate * (bearing.radius / bearing.clearance).powi(2);
    let given = system.supply.regions().iter().map(|region| region.pressure.abs());
    given.fold(drag, f64::max) * 2.0 * bearing.radius * bearing.length
}
