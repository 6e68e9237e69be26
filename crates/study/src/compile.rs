//! A scene becomes a film: its liner is meshed, its effects fill the sockets ([`crate::effects`]), and pressures are given.

mod reuse;

pub use reuse::{has_same_system, reused};

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use oilwedge_mesh::Mesh;
use oilwedge_mesh::error::some_of;
use oilwedge_mesh::generate::DrawingError;
use oilwedge_reynolds::film_thickness::{Eccentricity, FilmContribution};
use oilwedge_reynolds::lubricant::{Lubricant, PressureLaw};
use oilwedge_reynolds::supply::{self as given, BoundaryKind, Disc, SupplyError, SupplyRegion};
use oilwedge_reynolds::{Bearing, CentreVelocity, FilmProblem, FilmSystem, JournalState, Theory};

use crate::effects::{Effects, Sockets};
use crate::liner_mesh::{LinerMesh, liner_mesh, suited};
use crate::oil::{Oil, at_temperature};
use crate::run::DEGREE;
use crate::start::start;
use crate::words::way_out_of_supply;
use oilwedge_scene::{self as scene, Scene};

/// A scene, ready to be solved.
pub struct Study {
    /// The scene.
    pub scene: Scene,
    /// The film: physics.
    pub problem: FilmProblem,
    /// The film: mesh, unknowns, given pressures.
    pub system: FilmSystem,
    /// Force `(F cos, F sin)` on the journal [N] under which its position is found, from that of the problem;
    /// `None` at a given position.
    pub load: Option<[f64; 2]>,
    /// Velocity of the journal's centre under a load.
    pub centre_velocity: CentreVelocity,
    /// The cap that this bearing is in.
    pub cap: Option<scene::Cap>,
    /// The oil, at the temperature of the film.
    pub oil: Oil,
    /// What finds that temperature.
    pub heat: Option<scene::Heat>,
    /// What is simulated and what is not.
    pub effects: Effects,
    /// Groups of the pockets that deepen the film.
    pub pockets: Vec<String>,
    /// The common pressure [Pa] of all feeds, if they have one.
    pub supply_pressure: Option<f64>,
    /// SHA-256 of the mesh file or, drawn, of its vertices and triangles; 64 hexadecimal digits, empty for a mesh that was at hand.
    pub mesh_sha256: String,
    /// Edge flips that made the mesh one for a mass-conserving film.
    pub flips: usize,
    /// True if the triangles are not those of the mesh file: they were laid anew in rows along the flow.
    pub is_laid_anew: bool,
    /// Seconds by part: reading or drawing the mesh, if that was done; numbering, pattern and analysis.
    pub seconds: Vec<(&'static str, f64)>,
}

impl Study {
    /// Brings the film to this temperature [K].
    pub fn heat_to(&mut self, temperature: f64) {
        self.oil = self.oil.at(temperature);
        self.scene = at_temperature(&self.scene, temperature);
        self.problem.lubricant = lubricant(&self.scene, Sockets::of(&self.scene).pressure_law);
    }
}

/// Why a scene does not become a film, though it is well written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompileError {
    /// The mesh cannot be used.
    #[error(transparent)]
    Mesh(#[from] oilwedge_mesh::Error),
    /// The mesh lacks groups of feeds.
    #[error(
        "the mesh {} has no group for {}; its groups are {}; correct the name in the scene, or give the region that name in gmsh (Physical Curve for a hole that is cut out, Physical Surface for one that is meshed)",
        mesh.display(), asked.join(" and "), some_of(present)
    )]
    NoFeedGroup {
        /// Key and name of each group asked for.
        asked: Vec<String>,
        /// Mesh file.
        mesh: std::path::PathBuf,
        /// Groups there are.
        present: Vec<String>,
    },
    /// No line of the mesh runs where the film is to start.
    #[error("the mesh {} does not fit the key bearing.film_start: {fault}; {}, or remove film_start: the film is periodic then", mesh.display(), way_out_of_supply(fault))]
    FilmStart {
        /// Mesh file.
        mesh: std::path::PathBuf,
        /// What does not fit.
        fault: SupplyError,
    },
    /// Given pressures do not fit the mesh.
    #[error("the mesh {} does not fit the scene:{}", mesh.display(), list(&unfit_supply(faults)))]
    Supply {
        /// Mesh file.
        mesh: std::path::PathBuf,
        /// Everything that does not fit.
        faults: Vec<SupplyError>,
    },
    /// A groove of the scene is not where that of the mesh is.
    #[error(
        "the groove of feed group \"{group}\" is not that of the mesh file: their rims are {off:.3e} m apart; correct its from, to, width, z or corner, or remove groove to take the region as it is"
    )]
    GrooveElsewhere {
        /// Group of the groove.
        group: String,
        /// Greatest distance [m] of a node of the region from the groove described.
        off: f64,
    },
    /// The liner described cannot be meshed.
    #[error("the liner described cannot be meshed:{}", list(.0))]
    Drawing(Vec<DrawingError>),
    /// A pocket with a depth is cut out of the mesh.
    #[error(
        "feed group \"{group}\" has a depth, but the mesh has no triangles there; mesh it as a physical surface, or give its pressure"
    )]
    NoPocket {
        /// Group of the pocket.
        group: String,
    },
    /// The film is too large for this machine.
    #[error(transparent)]
    Fem(#[from] oilwedge_fem::Error),
}

fn unfit_supply(faults: &[SupplyError]) -> Vec<String> {
    let line = |fault| format!("{fault}; {}", way_out_of_supply(fault));
    faults.iter().map(line).collect()
}

fn list(faults: &[impl std::fmt::Display]) -> String {
    faults.iter().map(|fault| format!("\n  {fault}")).collect()
}

/// Compiles `scene`: reads its mesh and chooses one entry a socket.
///
/// # Errors
/// [`CompileError`]: the mesh is unreadable, defective, or not that of the scene.
pub fn compile(scene: &Scene) -> Result<Study, CompileError> {
    compile_near(scene, start(scene))
}

/// The same with the journal, and the mesh graded for it, at the position `near` (eccentricity [1], angle of the minimum
/// film [rad]): where the search for the position under a load begins.
///
/// # Errors
/// As [`compile`].
pub fn compile_near(scene: &Scene, near: (f64, f64)) -> Result<Study, CompileError> {
    let clock = Instant::now();
    let LinerMesh {
        mesh,
        sha256: mesh_sha256,
        is_laid_anew,
    } = liner_mesh(scene, near)?;
    let read = clock.elapsed().as_secs_f64();
    let mut study = compile_on(scene, mesh, near, DEGREE)?;
    let part = if scene.mesh.path().is_some() { "read" } else { "mesh" };
    study.seconds.insert(0, (part, read));
    Ok(Study {
        mesh_sha256,
        is_laid_anew,
        ..study
    })
}

/// The same on a mesh that is at hand, with a pressure of the given degree (1 or 2) and the journal at the position `near`.
///
/// # Errors
/// As [`compile`].
pub fn compile_on(scene: &Scene, mesh: Mesh, near: (f64, f64), degree: usize) -> Result<Study, CompileError> {
    let clock = Instant::now();
    let (mesh, flips) = suited(scene, mesh);
    check_feed_groups(scene, &mesh)?;
    let sockets = Sockets::of(scene);
    let regions = supply(scene, &sockets, &mesh)?;
    let (load, centre_velocity) = (sockets.load, sockets.centre_velocity);
    let problem = problem(scene, sockets, &mesh, near);
    let system = FilmSystem::new(Arc::new(mesh), degree, regions).map_err(|faults| unfit(scene, faults))?;
    // A position is sought on coarser meshes first, and by many films.
    let is_sought = load.is_some();
    let system = match is_sought {
        true => system.for_many_solves(),
        false => system,
    };
    problem.prepare(&system)?;
    let system = match problem.needs_start() || is_sought {
        true => system.with_coarser(&problem.bearing, &problem.film_thickness),
        false => system,
    };
    Ok(Study {
        load,
        centre_velocity,
        cap: scene.cap,
        oil: Oil::of(scene),
        heat: scene.heat,
        effects: Effects::of(scene),
        scene: scene.clone(),
        problem,
        system,
        pockets: (scene.feeds.iter())
            .filter(|feed| feed.pressure.is_none())
            .map(|feed| feed.group.clone())
            .collect(),
        supply_pressure: supply_pressure(scene),
        mesh_sha256: String::new(),
        flips,
        is_laid_anew: false,
        seconds: vec![("order", clock.elapsed().as_secs_f64())],
    })
}

/// The film of a scene, with the journal at the position `near` or, under a load, where the search for its position begins.
fn problem(scene: &Scene, sockets: Sockets, mesh: &Mesh, (eccentricity, angle): (f64, f64)) -> FilmProblem {
    let clearance = scene.bearing.clearance;
    let journal = JournalState::at_eccentricity(eccentricity, angle, clearance, scene.journal.speed);
    let eccentric: Arc<dyn FilmContribution> = Arc::new(Eccentricity {
        radius: scene.bearing.radius(),
        clearance,
    });
    let deeper = sockets.film_thickness.iter().map(|contribution| contribution(mesh));
    FilmProblem {
        theory: sockets.theory,
        bearing: Bearing {
            radius: scene.bearing.radius(),
            length: scene.bearing.length,
            clearance,
            end_pressure: scene.ends.pressure,
        },
        journal: journal.with_centre_velocity(sockets.centre_velocity, angle),
        film_thickness: std::iter::once(eccentric).chain(deeper).collect(),
        lubricant: lubricant(scene, sockets.pressure_law),
        form: sockets.form,
        terms: sockets.terms,
        cavitation: sockets.cavitation,
    }
}

fn lubricant(scene: &Scene, pressure_law: PressureLaw) -> Lubricant {
    Lubricant {
        viscosity: Oil::of(scene).viscosity,
        pressure_law,
    }
}

/// What messages call the mesh.
fn mesh_name(scene: &Scene) -> PathBuf {
    scene
        .mesh
        .path()
        .unwrap_or(Path::new("of the liner described"))
        .to_owned()
}

fn disc(scene: &Scene, feed: &scene::Feed) -> Option<Disc> {
    feed.hole.map(|hole| Disc {
        centre: [scene.bearing.radius() * hole.angle, hole.z],
        radius: 0.5 * hole.diameter,
    })
}

/// Every feed must be a group of the mesh.
fn check_feed_groups(scene: &Scene, mesh: &Mesh) -> Result<(), CompileError> {
    let asked: Vec<String> = (scene.feeds.iter().enumerate())
        .filter(|(_, feed)| mesh.region(&feed.group).is_none())
        .map(|(index, feed)| format!("feed[{index}].group = \"{}\"", feed.group))
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
        Some(feed) => Err(CompileError::NoPocket {
            group: feed.group.clone(),
        }),
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
        let edges =
            given::line_at_angle(mesh, scene.bearing.radius(), scene.bearing.length, angle).map_err(|fault| {
                CompileError::FilmStart {
                    mesh: mesh_name(scene),
                    fault,
                }
            })?;
        regions.push(SupplyRegion {
            edges,
            ..region("film_start", BoundaryKind::Line, p_e)
        });
    }
    regions.extend(scene.feeds.iter().filter_map(|feed| {
        Some(SupplyRegion {
            disc: disc(scene, feed),
            ..region(&feed.group, BoundaryKind::Feed, feed.pressure?)
        })
    }));
    Ok(regions)
}

fn unfit(scene: &Scene, faults: Vec<SupplyError>) -> CompileError {
    CompileError::Supply {
        mesh: mesh_name(scene),
        faults,
    }
}

fn supply_pressure(scene: &Scene) -> Option<f64> {
    let mut pressures = scene.feeds.iter().filter_map(|feed| feed.pressure);
    let first = pressures.next()?;
    pressures.all(|pressure| pressure == first).then_some(first)
}

#[cfg(test)]
mod tests;
