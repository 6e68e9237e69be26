//! The mesh of a liner: from its file, or drawn as it is described.

use oilwedge_mesh::developed;
use oilwedge_mesh::generate::{
    Blueprint, DrawingError, Grading, RowLengths, Sense, generate_graded, generate_in_rows, generate_in_rows_like,
    triangles_graded, triangles_in_rows,
};
use oilwedge_mesh::quality::lies_in_rows;
use oilwedge_mesh::{Circle, Mesh, flip, gmsh, rim};
use oilwedge_reynolds::supply::line_at_angle;
use sha2::{Digest, Sha256};

use crate::compile_error::CompileError;
use crate::film_scale::{FilmScale, LONGEST};
use crate::mesh_plan::MeshPlan;
use crate::outline::LinerOutline;
use crate::position::FilmState;
use crate::row_distances::{RowDistances, column};
use oilwedge_scene::{Layout, MeshSource};

/// A groove of a mesh file may be this part of the radius off the groove that the scene describes.
const ON_RIM: f64 = 1e-3;

/// The mesh of a liner, and where it comes from.
pub struct LinerMesh {
    /// The mesh, with round rims on their circles.
    pub mesh: Mesh,
    /// SHA-256 of its file or, drawn, of its vertices and triangles.
    pub sha256: String,
    /// True if the triangles are not those of the file: they were laid anew in rows along the flow.
    pub is_laid_anew: bool,
}

/// The mesh of the liner. A mesh made here has edges of at most `longest` [m], shorter where the film is thin in this
/// state. Where oil is conserved the triangles lie in rows along the flow; those of a file that do not are laid anew,
/// as long as the edges are there, unless the scene keeps them or its features are none that can be drawn.
///
/// # Errors
/// The file is unreadable, defective or not that of the scene; the liner described cannot be meshed.
pub fn liner_mesh(plan: &MeshPlan, longest: f64, state: &FilmState) -> Result<LinerMesh, CompileError> {
    match &plan.source {
        MeshSource::File { path, unit, size, layout } => {
            let bytes = gmsh::read_bytes(path)?;
            let mesh = from_file(&plan.outline, &bytes, *unit).map_err(|error| error.in_file(path))?;
            check_grooves(&plan.outline, &mesh)?;
            let in_rows = match (size, layout) {
                (None, Layout::Rows) if plan.carrying.is_some() && !lies_in_rows(&mesh) => {
                    let blueprint = blueprint_of(&plan.outline, &mesh);
                    let sense = Sense::of(plan.speed);
                    blueprint.and_then(|blueprint| generate_in_rows_like(&blueprint, &mesh, 1.0, sense)).ok()
                }
                _ => None,
            };
            let is_laid_anew = in_rows.is_some();
            let mesh = match (size, in_rows) {
                (Some(_), _) => blueprint_of(&plan.outline, &mesh)
                    .and_then(|blueprint| graded(plan, &blueprint, longest, state))
                    .map_err(CompileError::Drawing)?,
                (None, in_rows) => in_rows.unwrap_or(mesh),
            };
            Ok(LinerMesh { mesh, sha256: hexadecimal(Sha256::digest(&bytes)), is_laid_anew })
        }
        MeshSource::Drawing { .. } => {
            let mesh = graded(plan, &plan.outline.blueprint(), longest, state).map_err(CompileError::Drawing)?;
            let mut hash = Sha256::new();
            for x in mesh.points().iter().flatten() {
                hash.update(x.to_le_bytes());
            }
            for vertex in mesh.triangles().iter().flatten() {
                hash.update(vertex.to_le_bytes());
            }
            Ok(LinerMesh { mesh, sha256: hexadecimal(hash.finalize()), is_laid_anew: false })
        }
    }
}

/// The mesh as the model of cavitation needs it, and how many edges were flipped for it: a film that conserves its oil
/// is computed on Delaunay meshes. The line of the film start stays.
pub fn suited(plan: &MeshPlan, mesh: Mesh) -> (Mesh, usize) {
    if plan.carrying.is_none() {
        return (mesh, 0);
    }
    let LinerOutline { liner, film_start, .. } = &plan.outline;
    let line =
        film_start.and_then(|angle| line_at_angle(&mesh, liner.radius, liner.length, angle).ok()).unwrap_or_default();
    match flip::to_delaunay(&mesh, &line) {
        Some(flipped) => (flipped.mesh, flipped.flips),
        None => (mesh, 0),
    }
}

fn hexadecimal(digest: impl IntoIterator<Item = u8>) -> String {
    digest.into_iter().map(|byte| format!("{byte:02x}")).collect()
}

fn from_file(outline: &LinerOutline, bytes: &[u8], unit: f64) -> Result<Mesh, oilwedge_mesh::Error> {
    let file = gmsh::parse(bytes)?;
    let mut mesh = Mesh::build(developed::unroll(&file, &outline.liner, unit)?)?;
    for feed in &outline.feeds {
        let hole = outline.shape(feed).filter(|_| feed.hole.is_some() && mesh.region(&feed.group).is_some());
        if let Some(hole) = hole {
            let circle = Circle { centre: hole.centre, radius: hole.corner };
            mesh = rim::curve_rim(&mesh, &feed.group, &circle)?;
        }
    }
    Ok(mesh)
}

/// A groove that the scene describes must be that of the mesh.
fn check_grooves(outline: &LinerOutline, mesh: &Mesh) -> Result<(), CompileError> {
    for feed in outline.feeds.iter().filter(|feed| feed.groove.is_some()) {
        let (Some(shape), Some(region)) = (outline.shape(feed), mesh.region(&feed.group)) else {
            continue;
        };
        let distance = |v: u32| shape.distance(mesh.points()[v as usize], mesh.period());
        let rim = region.edges.iter().flat_map(|&edge| mesh.topology().edges[edge as usize]);
        let inside = region.cells.iter().flat_map(|&cell| mesh.triangles()[cell as usize]);
        let off = rim.map(|v| distance(v).abs()).chain(inside.map(distance)).fold(0.0, f64::max);
        if off > ON_RIM * outline.liner.radius {
            return Err(CompileError::GrooveElsewhere { group: feed.group.clone(), off });
        }
    }
    Ok(())
}

/// About how many unknowns at least a film has on a drawn liner with edges of at most `longest` [m], its mesh graded
/// for the film in this state.
///
/// # Errors
/// The liner cannot be meshed.
pub fn least_unknowns(plan: &MeshPlan, longest: f64, state: &FilmState) -> Result<f64, CompileError> {
    // A strip of single cells, the shape with the fewest, has one node across in each column and one at each of two
    // edges.
    const PER_TRIANGLE: f64 = 1.5;
    let triangles = by_grading(plan, &plan.outline.blueprint(), (longest, state), triangles_in_rows, triangles_graded);
    triangles.map(|triangles| PER_TRIANGLE * triangles).map_err(CompileError::Drawing)
}

/// The drawing of a mesh file's geometry.
fn blueprint_of(outline: &LinerOutline, mesh: &Mesh) -> Result<Blueprint, Vec<DrawingError>> {
    let shown = outline.feeds.iter().filter(|feed| outline.shape(feed).is_none());
    let names: Vec<&str> = shown.map(|feed| feed.group.as_str()).collect();
    let mut blueprint = Blueprint { line: outline.film_start, ..Blueprint::of_mesh(mesh, outline.liner, &names)? };
    blueprint.features.extend(outline.features());
    Ok(blueprint)
}

/// Edges of at most `longest` [m], shorter where the film is thin.
fn graded(plan: &MeshPlan, blueprint: &Blueprint, longest: f64, state: &FilmState) -> Result<Mesh, Vec<DrawingError>> {
    by_grading(plan, blueprint, (longest, state), generate_in_rows, generate_graded)
}

/// What is made of a drawing in rows or, of a film that needs none, with free triangles, with edges of at most
/// `longest` [m].
fn by_grading<T>(
    plan: &MeshPlan,
    blueprint: &Blueprint,
    (longest, state): (f64, &FilmState),
    in_rows: impl FnOnce(&Blueprint, &RowLengths) -> Result<T, Vec<DrawingError>>,
    free: impl FnOnce(&Blueprint, &dyn Fn([f64; 2]) -> f64, Grading) -> Result<T, Vec<DrawingError>>,
) -> Result<T, Vec<DrawingError>> {
    let scale = FilmScale::of(plan, state.position);
    // The films of an orbit are many, and each groove and hole is beside the thinnest film for a moment only.
    let grading = if plan.is_of_orbit { Grading::BY_SIZE } else { Grading::RESOLVED };
    match RowDistances::of(plan, state, longest, &scale) {
        Some(distances) => {
            // Columns are as dense as the thinnest film along the axis needs.
            let (along, across) = (&|x: f64| column(longest, &scale, x), &|z: f64| distances.at(z));
            let sense = Sense::of(plan.speed);
            let rows = RowLengths { along, across, sense, grading };
            in_rows(blueprint, &rows)
        }
        None => free(blueprint, &|at| longest * scale.at(at) / LONGEST, grading),
    }
}

/// How many triangles a drawn mesh with edges of at most `longest` [m] will have for the film in this state, without
/// those that holes and grooves ask for.
pub fn expected_triangles(plan: &MeshPlan, longest: f64, state: &FilmState) -> f64 {
    const AROUND: u32 = 360;
    const ALONG: u32 = 60;
    let scale = FilmScale::of(plan, state.position);
    let liner = &plan.outline.liner;
    let ((from, to), half) = (liner.arc.unwrap_or((0.0, std::f64::consts::TAU)), 0.5 * liner.length);
    let places = |samples: u32| (0..samples).map(move |k| (f64::from(k) + 0.5) / f64::from(samples));
    let around = || places(AROUND).map(|part| liner.radius * (from + (to - from) * part));
    let along = || places(ALONG).map(|part| half * (2.0 * part - 1.0));
    let [width, height] = [liner.radius * (to - from) / f64::from(AROUND), 2.0 * half / f64::from(ALONG)];
    match RowDistances::of(plan, state, longest, &scale) {
        Some(distances) => {
            let columns: f64 = around().map(|x| width / column(longest, &scale, x)).sum();
            2.0 * columns * along().map(|z| height / distances.at(z)).sum::<f64>()
        }
        None => {
            let equilateral = |x: f64, z: f64| 0.75f64.sqrt() / 2.0 * (longest * scale.at([x, z]) / LONGEST).powi(2);
            around().flat_map(|x| along().map(move |z| (x, z))).map(|(x, z)| width * height / equilateral(x, z)).sum()
        }
    }
}
