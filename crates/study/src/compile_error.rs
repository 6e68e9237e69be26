//! Why a scene does not become a film.

use oilwedge_mesh::error::some_of;
use oilwedge_mesh::generate::DrawingError;
use oilwedge_reynolds::supply::SupplyError;
use oilwedge_scene::wording::{degrees, micrometres, millimetres};

use crate::reasons::flags::MORE_SECONDS;
use crate::reasons::way_out_of_supply;

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
        mesh.display(), some_of(asked), some_of(present)
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
    /// The load changes over a cycle.
    #[error(
        "the load changes over a cycle, so no steady film carries it; add [orbit] to follow the journal, give [load] with force and angle for a steady film, or see the load alone with oilwedge load SCENE"
    )]
    NoSteadyFilm,
    /// The load has a moment, but the tilt is not free.
    #[error(
        "load.file: the columns Mx and My give a moment, but the tilt of the journal is not found; add load.at = \"0 mm\" to find it where the film carries the moment, or remove both columns"
    )]
    UnusedMoment,
    /// The load over a cycle cannot be made.
    #[error("{0}")]
    Duty(String),
    /// The table of a measured surface cannot be used.
    #[error(transparent)]
    Surface(#[from] oilwedge_scene::periodic_table::TableError),
    /// The journal touches the bore where the scene places it.
    #[error(
        "the journal touches the bore: at {}, z = {} the film would be {} thick; give a smaller journal.eccentricity or journal.tilt, or another shape of bore or shaft", degrees(*angle), millimetres(*z), micrometres(*thickness)
    )]
    Touching {
        /// Angle of the least gap [rad].
        angle: f64,
        /// Axial position of the place [m].
        z: f64,
        /// The gap there [m].
        thickness: f64,
    },
    /// Shapes of bore and shaft leave no room for the journal.
    #[error(
        "no position of the journal leaves a film: its surface and the bore overlap by {} at least; give shallower shapes ([[bore]], [shaft]; are their depths in um?) or a larger bearing.clearance", micrometres(*overlap)
    )]
    NoRoom {
        /// Least overlap [m] of journal and bore, over all positions.
        overlap: f64,
    },
    /// A pocket with a depth is cut out of the mesh.
    #[error(
        "feed group \"{group}\" has a depth, but the mesh has no triangles there; mesh it as a physical surface, or give its pressure"
    )]
    NoPocket {
        /// Group of the pocket.
        group: String,
    },
    /// The wall of the liner cannot be made.
    #[error("{0}")]
    Wall(String),
    /// The first mesh is larger than a run may have.
    #[error(
        "the coarsest mesh of the liner, {} around and {} long with its feeds, has some {unknowns:.0} unknowns, more than --max-unknowns {most}; give --max-unknowns a higher limit, or a liner whose length, lands and grooves are not so small beside its circumference", millimetres(*around), millimetres(*length)
    )]
    BeyondLimit {
        /// Circumference of the liner [m].
        around: f64,
        /// Length of the piece [m].
        length: f64,
        /// Unknowns of the mesh, about.
        unknowns: f64,
        /// Most unknowns.
        most: usize,
    },
    /// A limit of time came before the first mesh.
    #[error("the first mesh of the liner was not made in time, by {cause}; {MORE_SECONDS}, or [mesh] a size")]
    Late {
        /// The limit in words.
        cause: String,
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
