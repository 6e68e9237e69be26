//! A film: one model on one mesh. It never changes; at another temperature or position it is made anew and shares the
//! system.

mod made;
mod reuse;

use std::sync::Arc;

use oilwedge_bearing::film_heat::FilmHeat;
use oilwedge_bearing::orbit::Instant;
use oilwedge_bearing::{InitialGuess, JournalLoad, SearchObserver, SearchOptions, Waypoint};
use oilwedge_reynolds::film_thickness::Eccentricity;
use oilwedge_reynolds::lubricant::Lubricant;
use oilwedge_reynolds::{FilmProblem, FilmSolution, FilmSystem, Gap, JournalState, SolvedFilm};

use crate::model::Model;
use crate::observer::Watch;
use crate::oil::Oil;
use crate::position::Position;

/// Degree of the unknown of a film [1].
pub const DEGREE: usize = 2;

/// A film, ready to be solved.
#[derive(Debug, Clone)]
pub struct Film {
    /// The model.
    pub model: Arc<Model>,
    /// The oil at the temperature of the film.
    pub oil: Oil,
    /// The physics.
    pub problem: FilmProblem,
    /// Mesh, unknowns and given pressures.
    pub system: Arc<FilmSystem>,
    /// Temperatures of the film, where they were found across it.
    pub heat: Option<Arc<FilmHeat>>,
    /// What is known of the position under a load.
    pub start: Start,
    /// Origin of the mesh.
    pub origin: MeshOrigin,
    /// Seconds by part: reading or drawing the mesh, if that was done; numbering, pattern and analysis.
    pub seconds: Vec<(&'static str, f64)>,
}

/// What is known of the position at which the search under a load begins.
#[derive(Debug, Clone, Default, PartialEq)]
pub enum Start {
    /// The position is an estimate.
    #[default]
    Estimated,
    /// The position balances the load on a coarser mesh.
    NearlyBalanced,
    /// A growing moment leads into contact, or the journal tips over; another mesh has shown a balance on the way.
    Along(Arc<Waypoint>),
    /// The position is an estimate, from which a rough search on this mesh has found no balance: under a wall that
    /// gives way, where that takes long.
    Failed,
}

/// Origin of the mesh of a film.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct MeshOrigin {
    /// SHA-256 of the mesh file or, drawn, of its vertices and triangles; 64 hexadecimal digits, empty for a mesh that
    /// was at hand.
    pub sha256: String,
    /// Edge flips that made the mesh one for a mass-conserving film.
    pub flips: usize,
    /// True if the triangles are not those of the mesh file: they were laid anew in rows along the flow.
    pub is_laid_anew: bool,
}

impl Film {
    /// Force on the journal, and what tilts it, under which its position is found; `None` at a given position.
    pub fn load(&self) -> Option<JournalLoad> {
        self.model.sockets.load()
    }

    /// The film with the journal elsewhere.
    pub fn with_journal(&self, journal: JournalState) -> Self {
        let mut film = self.clone();
        film.problem.journal = journal;
        film
    }

    /// The film with another clearance [m].
    pub(crate) fn with_clearance(&self, clearance: f64) -> Self {
        let mut film = self.clone();
        let radius = film.problem.bearing.radius;
        film.problem.bearing.clearance = clearance;
        // The journal's own contribution is the first one.
        film.problem.film_thickness[0] = Arc::new(Eccentricity { radius, clearance });
        film
    }

    /// This film with journal, wall and temperature as a search has found them.
    pub(crate) fn as_found(&self, found: &FilmProblem) -> Self {
        let mut film = self.with_journal(found.journal);
        film.problem = film.problem.deflected(found.deflection());
        if let Some(temperature) = found.lubricant.temperature.filter(|found| Some(*found) != self.oil.temperature) {
            film.problem.lubricant = found.lubricant.clone();
            film.oil = self.oil.at(temperature);
        }
        film
    }

    /// The film at another temperature [K].
    pub(crate) fn at_temperature(&self, temperature: f64) -> Self {
        let lubricant = self.lubricant_at(temperature);
        self.as_found(&FilmProblem { lubricant, ..self.problem.clone() })
    }

    /// The oil of the film at another temperature [K].
    pub(crate) fn lubricant_at(&self, temperature: f64) -> Lubricant {
        Lubricant { temperature: Some(temperature), ..self.model.lubricant(&self.oil.at(temperature)) }
    }

    /// The film with the solution of one like it.
    pub fn solved_by(&self, solution: Arc<FilmSolution>) -> SolvedFilm {
        SolvedFilm { problem: self.problem.clone(), system: self.system.clone(), solution }
    }

    /// This film at a time of an orbit: where the journal is, the wall that moves as it does, and what it held before.
    pub(crate) fn at_instant(&self, instant: &Instant) -> Self {
        let mut film = self.as_found(&instant.film.problem);
        film.problem = film.problem.with_wall_at_its_rate();
        film.problem.storage = instant.film.problem.storage.clone();
        film
    }

    /// This film, of whose position so much is known.
    pub(crate) fn begun(self, start: Start) -> Self {
        Self { start, ..self }
    }

    /// The way along which its position is sought, if another mesh has shown one.
    pub(crate) fn way(&self) -> Option<&Arc<Waypoint>> {
        match &self.start {
            Start::Along(way) => Some(way),
            Start::Estimated | Start::NearlyBalanced | Start::Failed => None,
        }
    }

    /// This film on the next coarser mesh, if it has one.
    pub(crate) fn on_coarser(&self) -> Self {
        match &self.system.coarser {
            None => self.clone(),
            Some(coarser) => {
                Self { problem: coarser.problem(&self.problem), system: coarser.system.clone(), ..self.clone() }
            }
        }
    }

    /// The film on the vertices of its mesh alone.
    pub(crate) fn on_vertices(&self) -> Self {
        Self { problem: self.problem.on_vertices(), system: Arc::new(self.system.on_vertices()), ..self.clone() }
    }

    /// Gap of the film, with the journal anywhere.
    pub fn gap(&self) -> Gap {
        Gap::of(&self.problem, &self.system)
    }

    /// Position of the journal.
    pub fn position(&self) -> Position {
        Position::of(&self.problem.journal, self.problem.bearing.clearance)
    }

    /// How its position is sought under a load, without a neighbouring film.
    pub(crate) fn search_options(&self, watch: Watch) -> SearchOptions<'_> {
        SearchOptions {
            centre_velocity: self.model.sockets.centre_velocity,
            deadline: watch.deadline,
            observer: watch.observer.map(|observer| observer as &dyn SearchObserver),
            guess: match &self.start {
                Start::Along(way) => InitialGuess::Along(way),
                Start::Estimated | Start::Failed => InitialGuess::Cold,
                Start::NearlyBalanced => InitialGuess::NearlyBalanced,
            },
            ..SearchOptions::default()
        }
    }

    /// Unknown pressures.
    pub fn unknowns(&self) -> usize {
        let free = |dof: &usize| self.system.supply.owner(*dof).is_none();
        (0..self.system.space().dofs()).filter(free).count()
    }

    /// The common pressure [Pa] of all feeds, if they have one.
    pub fn supply_pressure(&self) -> Option<f64> {
        let mut pressures = self.model.mesh.outline.feeds.iter().filter_map(|feed| feed.pressure);
        let first = pressures.next()?;
        pressures.all(|pressure| pressure == first).then_some(first)
    }

    /// Groups of the pockets that deepen the film.
    pub fn pockets(&self) -> impl Iterator<Item = &str> {
        let pockets = self.model.mesh.outline.feeds.iter().filter(|feed| feed.pressure.is_none());
        pockets.map(|feed| feed.group.as_str())
    }
}
