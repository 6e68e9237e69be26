//! A scene becomes a film: its liner is meshed, its effects fill the sockets ([`crate::effects`]), and pressures are
//! given.

mod reuse;

pub use reuse::has_same_system;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use oilwedge_bearing::Load;
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::film_thickness::{Deflection, Eccentricity, FilmContribution, Shape};
use oilwedge_reynolds::levels::Layout;
use oilwedge_reynolds::lubricant::Lubricant;
use oilwedge_reynolds::supply::{self as given, BoundaryKind, Disc, SupplyError, SupplyRegion};
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap, JournalState, Theory, Thinnest};

use crate::compile_error::CompileError;
use crate::dimensions::bearing;
use crate::duty::refuse_cycle;
use crate::effects::Sockets;
use crate::feed_region::{FeedRegion, feed_regions};
use crate::film::{DEGREE, Film, MeshOrigin, Start};
use crate::liner_mesh::{LinerMesh, liner_mesh, suited};
use crate::oil::{self, Oil};
use crate::position::Position;
use crate::wall::wall;
use oilwedge_scene::{self as scene, Scene};

/// Compiles `scene`: reads its mesh and chooses one entry a socket.
///
/// # Errors
/// [`CompileError`]: the mesh is unreadable, defective, or not that of the scene.
pub fn compile(scene: &Scene) -> Result<Film, CompileError> {
    compile_near(scene, Position::start(scene))
}

/// Compiles `scene` with the journal, and the mesh graded for it, at `position`: where the search for the position
/// under a load begins.
///
/// # Errors
/// As [`compile`].
pub fn compile_near(scene: &Scene, position: Position) -> Result<Film, CompileError> {
    let clock = Instant::now();
    let LinerMesh { mesh, sha256, is_laid_anew } = liner_mesh(scene, position)?;
    let read = clock.elapsed().as_secs_f64();
    let mut film = compile_on(scene, mesh, position, DEGREE)?;
    let part = if scene.mesh.path().is_some() { "read" } else { "mesh" };
    film.seconds.insert(0, (part, read));
    (film.origin.sha256, film.origin.is_laid_anew) = (sha256, is_laid_anew);
    Ok(film)
}

/// Compiles `scene` on a mesh that is at hand, with a pressure of the given degree (1 or 2) and the journal at
/// `position`.
///
/// # Errors
/// As [`compile`].
pub fn compile_on(scene: &Scene, mesh: Mesh, position: Position, degree: usize) -> Result<Film, CompileError> {
    refuse_cycle(scene)?;
    let clock = Instant::now();
    let (mesh, flips) = suited(scene, mesh);
    check_feed_groups(scene, &mesh)?;
    let (sockets, oil) = (Sockets::of(scene), Oil::of(scene));
    let regions = supply(scene, &sockets, &mesh)?;
    let (load, thermal, centre_velocity) = (sockets.load(), sockets.thermal, sockets.centre_velocity);
    let dynamics = sockets.dynamics.clone();
    let problem = problem(scene, &oil, sockets, &mesh, position)?;
    let system = FilmSystem::new(Arc::new(mesh), degree, regions).map_err(|faults| unfit(scene, faults))?;
    check_gap(scene, &problem, &system, load)?;
    // A position is sought on coarser meshes first, and by many films; so are a deflection and a temperature.
    let is_sought = load.is_some() || thermal.is_some() || scene.orbit.is_some() || problem.deflection().is_some();
    let system = match is_sought {
        true => system.for_many_solves(),
        false => system,
    };
    problem.prepare(&system)?;
    let system = match problem.needs_start() || is_sought {
        true => system.with_coarser(&problem, coarser_layout(scene)),
        false => system,
    };
    Ok(Film {
        scene: Arc::new(scene.clone()),
        oil,
        problem,
        system: Arc::new(system),
        load,
        start: Start::default(),
        thermal,
        dynamics,
        centre_velocity,
        origin: MeshOrigin { flips, ..MeshOrigin::default() },
        seconds: vec![("order", clock.elapsed().as_secs_f64())],
    })
}

/// The film of a scene, with the journal at `position` or, under a load, where the search for its position begins.
fn problem(
    scene: &Scene,
    oil: &Oil,
    sockets: Sockets,
    mesh: &Mesh,
    position: Position,
) -> Result<FilmProblem, CompileError> {
    let bearing = bearing(scene);
    let Position { eccentricity, min_film_angle, tilt } = position;
    let journal = JournalState {
        tilt,
        tilt_rate: sockets.tilt_rate,
        ..JournalState::at_eccentricity(eccentricity, min_film_angle, bearing.clearance, scene.journal.speed)
    };
    let eccentric: Arc<dyn FilmContribution> =
        Arc::new(Eccentricity { radius: bearing.radius, clearance: bearing.clearance });
    let deeper = sockets.film_thickness.iter().map(|contribution| contribution(mesh));
    let shapes = sockets.profiles()?.into_iter().map(|profile| Arc::new(Shape(profile)) as _);
    let wall = sockets.liner.as_ref().map(|liner| wall(liner, &bearing)).transpose()?;
    let deflection = wall.map(|wall| Arc::new(Deflection::none(Arc::new(wall))) as Arc<dyn FilmContribution>);
    Ok(FilmProblem {
        theory: sockets.theory,
        bearing,
        journal: journal.with_centre_velocity(sockets.centre_velocity, min_film_angle),
        film_thickness: std::iter::once(eccentric).chain(deeper).chain(shapes).chain(deflection).collect(),
        lubricant: Lubricant {
            viscosity: oil.viscosity,
            pressure_law: sockets.pressure_law,
            temperature: oil.temperature,
        },
        form: sockets.form,
        terms: sockets.terms,
        cavitation: sockets.cavitation,
        flow_factors: sockets.flow_factors,
        storage: None,
        contact: sockets.contact,
    })
}

/// How coarser meshes lie. An orbit only begins on one. With rows the orbit of a starved film on the vertices alone,
/// with which it is compared, was seen not to come to its end, for a reason that is not known; with free triangles it
/// does.
fn coarser_layout(scene: &Scene) -> Layout {
    match scene.orbit {
        Some(_) => Layout::Free,
        None => Layout::Rows,
    }
}

/// A journal whose position is given leaves a film between surfaces of any shape, and one whose position is found has
/// room for one; circles were checked with the scene.
fn check_gap(
    scene: &Scene,
    problem: &FilmProblem,
    system: &FilmSystem,
    load: Option<Load>,
) -> Result<(), CompileError> {
    if scene.is_circular() {
        return Ok(());
    }
    if !matches!(scene.journal.position, scene::Position::Given { .. }) {
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

/// The film at another temperature [K]; it shares the system.
pub fn at_temperature(film: &Film, temperature: f64) -> Film {
    let lubricant = lubricant(film, temperature);
    film.as_found(&FilmProblem { lubricant, ..film.problem.clone() })
}

/// The oil of a film at another temperature [K].
pub(crate) fn lubricant(film: &Film, temperature: f64) -> Lubricant {
    let scene = oil::at_temperature(&film.scene, temperature);
    let viscosity = film.oil.at(temperature).viscosity;
    Lubricant { viscosity, pressure_law: Sockets::of(&scene).pressure_law, temperature: Some(temperature) }
}

/// What messages call the mesh.
fn mesh_name(scene: &Scene) -> PathBuf {
    scene.mesh.path().unwrap_or(Path::new("of the liner described")).to_owned()
}

/// The exact shape of a region that is one hole.
fn disc(scene: &Scene, region: &FeedRegion<'_>) -> Option<Disc> {
    let [feed] = region.feeds[..] else { return None };
    feed.hole.map(|hole| Disc { centre: [scene.bearing.radius() * hole.angle, hole.z], radius: 0.5 * hole.diameter })
}

/// Every feed must be a group of the mesh.
fn check_feed_groups(scene: &Scene, mesh: &Mesh) -> Result<(), CompileError> {
    let asked: Vec<String> = (feed_regions(scene).into_iter())
        .filter(|region| mesh.region(&region.name).is_none())
        .map(|region| format!("feed \"{}\"", region.name))
        .collect();
    if !asked.is_empty() {
        return Err(CompileError::NoFeedGroup {
            asked,
            mesh: mesh_name(scene),
            present: mesh.regions().iter().map(|region| region.name.clone()).collect(),
        });
    }
    let is_cut_out = |feed: &&scene::Feed| {
        let cells = mesh.region(&feed.group).map_or(0, |region| region.cells.len());
        feed.pressure.is_none() && cells == 0
    };
    match scene.feeds.iter().find(is_cut_out) {
        Some(feed) => Err(CompileError::NoPocket { group: feed.group.clone() }),
        None => Ok(()),
    }
}

/// Ends, edges of the arc, film start and feeds of given pressure.
fn supply(scene: &Scene, sockets: &Sockets, mesh: &Mesh) -> Result<Vec<SupplyRegion>, CompileError> {
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
    let p_e = scene.ends.pressure;
    let end = match sockets.theory {
        Theory::Long => BoundaryKind::Sealed,
        Theory::Full | Theory::Short => BoundaryKind::End,
    };
    let mut regions = vec![region("end_low", end, p_e), region("end_high", end, p_e)];
    if scene.bearing.arc.is_some() {
        // The journal brings oil in at one of them; the other ignores its film fraction.
        regions.extend(["arc_from", "arc_to"].map(|name| SupplyRegion {
            film_fraction: sockets.inlet_fraction,
            ..region(name, BoundaryKind::Line, p_e)
        }));
    }
    // The lines of a short film stand by themselves: none can be held at another pressure.
    if let Some(angle) = (scene.bearing.film_start).filter(|_| sockets.theory != Theory::Short) {
        let edges = given::line_at_angle(mesh, scene.bearing.radius(), scene.bearing.length, angle)
            .map_err(|fault| CompileError::FilmStart { mesh: mesh_name(scene), fault })?;
        regions.push(SupplyRegion { edges, ..region("film_start", BoundaryKind::Line, p_e) });
    }
    regions.extend(feed_regions(scene).iter().filter_map(|feed| {
        Some(SupplyRegion { disc: disc(scene, feed), ..region(&feed.name, BoundaryKind::Feed, feed.pressure()?) })
    }));
    Ok(regions)
}

fn unfit(scene: &Scene, faults: Vec<SupplyError>) -> CompileError {
    CompileError::Supply { mesh: mesh_name(scene), faults }
}

#[cfg(test)]
mod tests;
