//! A model becomes a film on a mesh: its sockets meet the triangles, and pressures are given.

use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::JournalLoad;
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::film_thickness::{Deflection, Eccentricity, FilmContribution, Shape};
use oilwedge_reynolds::levels::LevelLayout;
use oilwedge_reynolds::supply::{self as given, BoundaryKind, Disc, SupplyRegion};
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap, JournalState, Theory, Thinnest};
use oilwedge_scene::{Feed, PositionTable as Placed};

use super::{DEGREE, Film, MeshOrigin, Start};
use crate::compile_error::CompileError;
use crate::liner_mesh::{LinerMesh, liner_mesh, suited};
use crate::mesh_plan::MeshPlan;
use crate::model::Model;
use crate::outline::{FeedRegion, LinerOutline};
use crate::position::{FilmState, Position};

impl Model {
    /// The mesh with which a computation begins, without a film.
    ///
    /// # Errors
    /// [`CompileError`]: the mesh is unreadable, defective, or not that of the model.
    pub fn first_mesh(&self) -> Result<LinerMesh, CompileError> {
        liner_mesh(&self.mesh, self.mesh.longest, &self.start())
    }

    /// The film in the state in which a computation begins, and on the mesh for it.
    ///
    /// # Errors
    /// [`CompileError`]: the mesh is unreadable, defective, or not that of the model.
    pub fn film(self: &Arc<Self>) -> Result<Film, CompileError> {
        self.film_near(self.mesh.longest, &self.start())
    }

    /// The film in a state, and on a mesh for it with edges of at most `longest` [m]: where the search for the position
    /// under a load begins.
    ///
    /// # Errors
    /// [`CompileError`]: the mesh cannot be read or made, or is none of this liner.
    pub fn film_near(self: &Arc<Self>, longest: f64, state: &FilmState) -> Result<Film, CompileError> {
        let clock = Instant::now();
        let LinerMesh { mesh, sha256, is_laid_anew } = liner_mesh(&self.mesh, longest, state)?;
        let read = clock.elapsed().as_secs_f64();
        let mut film = self.film_on(mesh, state, DEGREE)?;
        let part = if self.mesh.source.path().is_some() { "read" } else { "mesh" };
        film.seconds.insert(0, (part, read));
        (film.origin.sha256, film.origin.is_laid_anew) = (sha256, is_laid_anew);
        Ok(film)
    }

    /// The film in a state on a mesh that is at hand, with a pressure of the given degree (1 or 2).
    ///
    /// # Errors
    /// [`CompileError`]: the mesh is none of this liner, or no steady film carries a load that changes.
    pub fn film_on(self: &Arc<Self>, mesh: Mesh, state: &FilmState, degree: usize) -> Result<Film, CompileError> {
        if matches!(self.placed, Placed::Cycle) && self.scope.orbit.is_none() {
            return Err(CompileError::NoSteadyFilm);
        }
        let clock = Instant::now();
        let (mesh, flips) = suited(&self.mesh, mesh);
        check_feed_groups(&self.mesh, &mesh)?;
        let (load, is_of_orbit) = (self.sockets.load(), self.mesh.is_of_orbit);
        let regions = supply(self, &mesh)?;
        let problem = problem(self, &mesh, state);
        let system = FilmSystem::new(Arc::new(mesh), degree, regions)
            .map_err(|faults| CompileError::Supply { mesh: self.mesh.name(), faults })?;
        check_gap(self, &problem, &system, load)?;
        // A position is sought on coarser meshes first, and by many films; so are a deflection and a temperature.
        let is_sought =
            load.is_some() || self.sockets.finds_temperature() || is_of_orbit || problem.deflection().is_some();
        let system = match is_sought {
            true => system.for_many_solves(),
            false => system,
        };
        problem.prepare(&system)?;
        let system = match problem.needs_start() || is_sought {
            true => system.with_coarser(&problem, coarser_layout(is_of_orbit)),
            false => system,
        };
        let mut film = Film::made(self, state, problem, Arc::new(system));
        film.origin.flips = flips;
        film.seconds.push(("order", clock.elapsed().as_secs_f64()));
        Ok(film)
    }
}

impl Film {
    /// The film of a model in a state, whose position is an estimate.
    pub(super) fn made(model: &Arc<Model>, state: &FilmState, problem: FilmProblem, system: Arc<FilmSystem>) -> Self {
        Self {
            model: model.clone(),
            oil: state.oil.clone(),
            problem,
            system,
            heat: None,
            start: Start::default(),
            origin: MeshOrigin::default(),
            seconds: Vec::new(),
        }
    }
}

/// The film of a model in a state or, under a load, where the search for its position begins.
pub(super) fn problem(model: &Model, mesh: &Mesh, state: &FilmState) -> FilmProblem {
    let (bearing, sockets) = (model.mesh.bearing, &model.sockets);
    let Position { eccentricity, min_film_angle, tilt } = state.position;
    let journal = JournalState {
        tilt,
        tilt_rate: sockets.tilt_rate,
        ..JournalState::at_eccentricity(eccentricity, min_film_angle, bearing.clearance, model.scope.speed)
    };
    let eccentric: Arc<dyn FilmContribution> =
        Arc::new(Eccentricity { radius: bearing.radius, clearance: bearing.clearance });
    let deeper = sockets.film_thickness.iter().map(|contribution| contribution.on(mesh));
    let shapes = model.mesh.profiles.iter().map(|profile| Arc::new(Shape(profile.clone())) as _);
    let deflection = model.wall.as_ref().map(|wall| Arc::new(Deflection::none(wall.clone())) as _);
    FilmProblem {
        theory: sockets.theory,
        bearing,
        journal: journal.with_centre_velocity(sockets.centre_velocity, min_film_angle),
        film_thickness: std::iter::once(eccentric).chain(deeper).chain(shapes).chain(deflection).collect(),
        lubricant: model.lubricant(&state.oil),
        form: sockets.form,
        terms: sockets.terms.clone(),
        cavitation: sockets.cavitation,
        flow_factors: sockets.flow_factors.clone(),
        storage: None,
        viscosity_across: None,
        contact: sockets.contact.clone(),
    }
}

/// How coarser meshes lie. Rows keep triangles from feeding a film that should starve. An orbit only begins on a
/// coarser mesh, with a film that is full, so that free triangles serve it as well: the numbers of three starved arcs,
/// whose inlets are 0.3 to 0.5 full, agree to all digits shown, on whichever layout their orbits began.
fn coarser_layout(is_of_orbit: bool) -> LevelLayout {
    if is_of_orbit { LevelLayout::Free } else { LevelLayout::Rows }
}

/// A journal whose position is given leaves a film between surfaces of any shape, and one whose position is found has
/// room for one; circles were checked with the scene.
fn check_gap(
    model: &Model,
    problem: &FilmProblem,
    system: &FilmSystem,
    load: Option<JournalLoad>,
) -> Result<(), CompileError> {
    if model.scope.is_circular {
        return Ok(());
    }
    if !matches!(model.placed, Placed::Given { .. }) {
        // A journal that tilts, or a wall that gives way, may make room.
        let is_stiff = problem.deflection().is_none() && load.is_none_or(|load| load.tilting.is_none());
        let lack = is_stiff.then(|| Gap::of(problem, system).lack_of_room(&problem.journal)).flatten();
        return lack.map_or(Ok(()), |gap| Err(CompileError::NoRoom { overlap: -gap }));
    }
    let Thinnest { thickness, angle, z } = Gap::of(problem, system).thinnest_film(problem, system);
    match thickness > 0.0 {
        true => Ok(()),
        false => Err(CompileError::Touching { angle, z, thickness }),
    }
}

/// The exact shape of a region that is one hole.
pub(super) fn disc(radius: f64, region: &FeedRegion<'_>) -> Option<Disc> {
    let [feed] = region.feeds[..] else { return None };
    feed.hole.map(|hole| Disc { centre: [radius * hole.angle, hole.z], radius: 0.5 * hole.diameter })
}

/// Every feed must be a group of the mesh.
fn check_feed_groups(plan: &MeshPlan, mesh: &Mesh) -> Result<(), CompileError> {
    let asked: Vec<String> = (plan.outline.regions().into_iter())
        .filter(|region| mesh.region(&region.name).is_none())
        .map(|region| format!("feed \"{}\"", region.name))
        .collect();
    if !asked.is_empty() {
        return Err(CompileError::NoFeedGroup {
            asked,
            mesh: plan.name(),
            present: mesh.regions().iter().map(|region| region.name.clone()).collect(),
        });
    }
    let is_cut_out = |feed: &&Feed| {
        let cells = mesh.region(&feed.group).map_or(0, |region| region.cells.len());
        feed.pressure.is_none() && cells == 0
    };
    match plan.outline.feeds.iter().find(is_cut_out) {
        Some(feed) => Err(CompileError::NoPocket { group: feed.group.clone() }),
        None => Ok(()),
    }
}

/// Ends, edges of the arc, film start and feeds of given pressure.
fn supply(model: &Model, mesh: &Mesh) -> Result<Vec<SupplyRegion>, CompileError> {
    let (sockets, plan) = (&model.sockets, &model.mesh);
    let LinerOutline { liner, film_start, .. } = &plan.outline;
    let region = |name: &str, kind, pressure| {
        let region = mesh.region(name);
        SupplyRegion {
            name: name.to_owned(),
            kind,
            pressure,
            edges: region.map_or(Vec::new(), |region| region.edges.clone()),
            cells: region.map_or(Vec::new(), |region| region.cells.clone()),
            disc: None,
            film_fraction: None,
        }
    };
    let p_e = model.mesh.bearing.end_pressure;
    let end = match sockets.theory {
        Theory::Long => BoundaryKind::Sealed,
        Theory::Full | Theory::Short => BoundaryKind::End,
    };
    let mut regions = vec![region("end_low", end, p_e), region("end_high", end, p_e)];
    if liner.arc.is_some() {
        // The journal brings oil in at one of them; the other ignores its film fraction.
        regions.extend(["arc_from", "arc_to"].map(|name| SupplyRegion {
            film_fraction: sockets.inlet_fraction,
            ..region(name, BoundaryKind::Line, p_e)
        }));
    }
    // The lines of a short film stand by themselves: none can be held at another pressure.
    if let Some(angle) = film_start.filter(|_| sockets.theory != Theory::Short) {
        let edges = given::line_at_angle(mesh, liner.radius, liner.length, angle)
            .map_err(|fault| CompileError::FilmStart { mesh: plan.name(), fault })?;
        regions.push(SupplyRegion { edges, ..region("film_start", BoundaryKind::Line, p_e) });
    }
    regions.extend(plan.outline.regions().iter().filter_map(|feed| {
        Some(SupplyRegion {
            disc: disc(liner.radius, feed),
            ..region(&feed.name, BoundaryKind::Feed, feed.pressure()?)
        })
    }));
    Ok(regions)
}
