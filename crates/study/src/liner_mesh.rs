//! The mesh of a scene's liner: from its file, or drawn from what the scene says.

use oilwedge_mesh::developed;
use oilwedge_mesh::generate::{
    Blueprint, DrawingError, Feature, Grading, RoundedRectangle, RowLengths, Sense, generate_graded, generate_in_rows,
    generate_in_rows_like, triangles_graded, triangles_in_rows,
};
use oilwedge_mesh::quality::lies_in_rows;
use oilwedge_mesh::{Circle, Mesh, flip, gmsh, rim};
use oilwedge_reynolds::supply::line_at_angle;
use sha2::{Digest, Sha256};

use crate::compile_error::CompileError;
use crate::effects::Sockets;
use crate::feed_region::{FeedRegion, feed_regions, liner, shape};
use crate::film_scale::{FilmScale, LONGEST, needed_size};
use crate::position::Position;
use crate::row_distances::{RowDistances, column};
use oilwedge_scene::{Layout, MeshSource, Scene};

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

/// The mesh of the liner. A mesh made here is graded for the film at `position`. Where oil is conserved the triangles
/// lie in rows along the flow; those of a file that do not are laid anew, as long as the edges are there, unless the
/// scene keeps them or its features are none that can be drawn.
///
/// # Errors
/// The file is unreadable, defective or not that of the scene; the liner described cannot be meshed.
pub fn liner_mesh(scene: &Scene, position: Position) -> Result<LinerMesh, CompileError> {
    let scale = FilmScale::of(scene, position)?;
    match &scene.mesh {
        MeshSource::File { path, unit, size, layout } => {
            let bytes = gmsh::read_bytes(path)?;
            let mesh = from_file(scene, &bytes, *unit).map_err(|error| error.in_file(path))?;
            check_grooves(scene, &mesh)?;
            let in_rows = match (size, layout) {
                (None, Layout::Rows) if conserves_oil(scene) && !lies_in_rows(&mesh) => {
                    let blueprint = blueprint_of(scene, &mesh);
                    blueprint
                        .and_then(|blueprint| {
                            generate_in_rows_like(&blueprint, &mesh, 1.0, Sense::of(scene.journal.speed))
                        })
                        .ok()
                }
                _ => None,
            };
            let is_laid_anew = in_rows.is_some();
            let mesh = match (size, in_rows) {
                (Some(size), _) => meshed_anew(scene, &mesh, *size, &scale).map_err(CompileError::Drawing)?,
                (None, in_rows) => in_rows.unwrap_or(mesh),
            };
            Ok(LinerMesh { mesh, sha256: hexadecimal(Sha256::digest(&bytes)), is_laid_anew })
        }
        MeshSource::Drawing { size } => {
            let mesh = drawn(scene, *size, &scale).map_err(CompileError::Drawing)?;
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

/// Whether the film carries its oil through the cavity.
fn conserves_oil(scene: &Scene) -> bool {
    Sockets::of(scene).cavitation.conserves_oil()
}

/// The mesh as the model of cavitation needs it, and how many edges were flipped for it: a film that conserves its oil
/// is computed on Delaunay meshes. The line of the film start stays.
pub fn suited(scene: &Scene, mesh: Mesh) -> (Mesh, usize) {
    if !conserves_oil(scene) {
        return (mesh, 0);
    }
    let bearing = &scene.bearing;
    let line = (bearing.film_start)
        .and_then(|angle| line_at_angle(&mesh, bearing.radius(), bearing.length, angle).ok())
        .unwrap_or_default();
    match flip::to_delaunay(&mesh, &line) {
        Some(flipped) => (flipped.mesh, flipped.flips),
        None => (mesh, 0),
    }
}

fn hexadecimal(digest: impl IntoIterator<Item = u8>) -> String {
    digest.into_iter().map(|byte| format!("{byte:02x}")).collect()
}

fn from_file(scene: &Scene, bytes: &[u8], unit: f64) -> Result<Mesh, oilwedge_mesh::Error> {
    let file = gmsh::parse(bytes)?;
    let mut mesh = Mesh::build(developed::unroll(&file, &liner(scene), unit)?)?;
    for feed in &scene.feeds {
        let hole = shape(scene, feed).filter(|_| feed.hole.is_some() && mesh.region(&feed.group).is_some());
        if let Some(hole) = hole {
            let circle = Circle { centre: hole.centre, radius: hole.corner };
            mesh = rim::curve_rim(&mesh, &feed.group, &circle)?;
        }
    }
    Ok(mesh)
}

/// A groove that the scene describes must be that of the mesh.
fn check_grooves(scene: &Scene, mesh: &Mesh) -> Result<(), CompileError> {
    for feed in scene.feeds.iter().filter(|feed| feed.groove.is_some()) {
        let (Some(shape), Some(region)) = (shape(scene, feed), mesh.region(&feed.group)) else {
            continue;
        };
        let distance = |v: u32| shape.distance(mesh.points()[v as usize], mesh.period());
        let rim = region.edges.iter().flat_map(|&edge| mesh.topology().edges[edge as usize]);
        let inside = region.cells.iter().flat_map(|&cell| mesh.triangles()[cell as usize]);
        let off = rim.map(|v| distance(v).abs()).chain(inside.map(distance)).fold(0.0, f64::max);
        if off > ON_RIM * scene.bearing.radius() {
            return Err(CompileError::GrooveElsewhere { group: feed.group.clone(), off });
        }
    }
    Ok(())
}

fn drawn(scene: &Scene, size: Option<f64>, scale: &FilmScale) -> Result<Mesh, Vec<DrawingError>> {
    graded(scene, &blueprint_of_scene(scene), size.unwrap_or(needed_size(scene)), scale)
}

/// The drawing of the liner that a scene describes.
fn blueprint_of_scene(scene: &Scene) -> Blueprint {
    Blueprint { liner: liner(scene), features: features(scene), line: scene.bearing.film_start }
}

/// About how many unknowns at least a film has on the drawn liner of a scene, its mesh graded for the film at
/// `position`.
///
/// # Errors
/// The liner cannot be meshed, or a table of a measured surface cannot be used.
pub fn least_unknowns(scene: &Scene, position: Position) -> Result<f64, CompileError> {
    // A strip of single cells, the shape with the fewest, has one node across in each column and one at each of two
    // edges.
    const PER_TRIANGLE: f64 = 1.5;
    let scale = FilmScale::of(scene, position)?;
    let longest = scene.mesh.size().unwrap_or(needed_size(scene));
    let triangles =
        by_grading(scene, &blueprint_of_scene(scene), (longest, &scale), triangles_in_rows, triangles_graded);
    triangles.map(|triangles| PER_TRIANGLE * triangles).map_err(CompileError::Drawing)
}

/// The scene with the longest edges of its mesh `factor` times as long; `None` where its mesh is that of a file.
pub fn resized(scene: &Scene, factor: f64) -> Option<Scene> {
    let mut resized = scene.clone();
    match &mut resized.mesh {
        MeshSource::File { size, .. } => *size = Some(factor * (*size)?),
        MeshSource::Drawing { size } => *size = Some(factor * size.unwrap_or(needed_size(scene))),
    }
    Some(resized)
}

/// The feeds that the scene describes, as they are drawn.
fn features(scene: &Scene) -> Vec<Feature> {
    let of_region = |region: FeedRegion<'_>| {
        let shapes: Vec<RoundedRectangle> = region.feeds.iter().filter_map(|feed| shape(scene, feed)).collect();
        // A groove all around would leave two films; a deeper film is still a film.
        let meshed = region.pressure().is_none() || shapes.iter().any(RoundedRectangle::is_full_turn);
        let feature = |shape| Feature { name: region.name.clone(), shape, meshed };
        shapes.into_iter().map(feature).collect::<Vec<Feature>>()
    };
    feed_regions(scene).into_iter().flat_map(of_region).collect()
}

/// The geometry of a file, meshed as the film needs it.
fn meshed_anew(scene: &Scene, mesh: &Mesh, size: f64, scale: &FilmScale) -> Result<Mesh, Vec<DrawingError>> {
    graded(scene, &blueprint_of(scene, mesh)?, size, scale)
}

/// The drawing of a mesh file's geometry.
fn blueprint_of(scene: &Scene, mesh: &Mesh) -> Result<Blueprint, Vec<DrawingError>> {
    let shown = scene.feeds.iter().filter(|feed| shape(scene, feed).is_none());
    let names: Vec<&str> = shown.map(|feed| feed.group.as_str()).collect();
    let mut blueprint = Blueprint { line: scene.bearing.film_start, ..Blueprint::of_mesh(mesh, liner(scene), &names)? };
    blueprint.features.extend(features(scene));
    Ok(blueprint)
}

/// Edges of at most `longest` [m], shorter where the film is thin.
fn graded(scene: &Scene, blueprint: &Blueprint, longest: f64, scale: &FilmScale) -> Result<Mesh, Vec<DrawingError>> {
    by_grading(scene, blueprint, (longest, scale), generate_in_rows, generate_graded)
}

/// What is made of a drawing in rows or, of a film that needs none, with free triangles, with edges of at most
/// `longest` [m].
fn by_grading<T>(
    scene: &Scene,
    blueprint: &Blueprint,
    (longest, scale): (f64, &FilmScale),
    in_rows: impl FnOnce(&Blueprint, &RowLengths) -> Result<T, Vec<DrawingError>>,
    free: impl FnOnce(&Blueprint, &dyn Fn([f64; 2]) -> f64, Grading) -> Result<T, Vec<DrawingError>>,
) -> Result<T, Vec<DrawingError>> {
    // The films of an orbit are many, and each groove and hole is beside the thinnest film for a moment only.
    let grading = match scene.orbit {
        Some(_) => Grading::BY_SIZE,
        None => Grading::RESOLVED,
    };
    match RowDistances::of(scene, &blueprint.liner, longest, scale) {
        Some(distances) => {
            // Columns are as dense as the thinnest film along the axis needs.
            let (along, across) = (&|x: f64| column(longest, scale, x), &|z: f64| distances.at(z));
            let sense = Sense::of(scene.journal.speed);
            let rows = RowLengths { along, across, sense, grading };
            in_rows(blueprint, &rows)
        }
        None => free(blueprint, &|at| longest * scale.at(at) / LONGEST, grading),
    }
}

/// How many triangles the drawn mesh of a scene will have for the film at `position`, without those that holes and
/// grooves ask for.
///
/// # Errors
/// A table of a measured surface cannot be used.
pub fn expected_triangles(scene: &Scene, position: Position) -> Result<f64, CompileError> {
    const AROUND: u32 = 360;
    const ALONG: u32 = 60;
    let scale = FilmScale::of(scene, position)?;
    let liner = liner(scene);
    let longest = scene.mesh.size().unwrap_or(needed_size(scene));
    let ((from, to), half) = (liner.arc.unwrap_or((0.0, std::f64::consts::TAU)), 0.5 * liner.length);
    let places = |samples: u32| (0..samples).map(move |k| (f64::from(k) + 0.5) / f64::from(samples));
    let around = || places(AROUND).map(|part| liner.radius * (from + (to - from) * part));
    let along = || places(ALONG).map(|part| half * (2.0 * part - 1.0));
    let [width, height] = [liner.radius * (to - from) / f64::from(AROUND), 2.0 * half / f64::from(ALONG)];
    Ok(match RowDistances::of(scene, &liner, longest, &scale) {
        Some(distances) => {
            let columns: f64 = around().map(|x| width / column(longest, &scale, x)).sum();
            2.0 * columns * along().map(|z| height / distances.at(z)).sum::<f64>()
        }
        None => {
            let equilateral = |x: f64, z: f64| 0.75f64.sqrt() / 2.0 * (longest * scale.at([x, z]) / LONGEST).powi(2);
            around().flat_map(|x| along().map(move |z| (x, z))).map(|(x, z)| width * height / equilateral(x, z)).sum()
        }
    })
}

/// Meshes or reads the liner of a scene.
///
/// # Errors
/// [`CompileError`] where the mesh cannot be read or made.
pub fn mesh_scene(scene: &Scene) -> Result<Mesh, CompileError> {
    Ok(liner_mesh(scene, Position::start(scene))?.mesh)
}
