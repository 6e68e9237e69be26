//! The mesh of a scene's liner: from its file, or drawn from what the scene says.

use oilwedge_mesh::developed::{self, Liner};
use oilwedge_mesh::generate::{Blueprint, DrawingError, Feature, Shape, generate};
use oilwedge_mesh::{Circle, Mesh, flip, gmsh, rim};
use oilwedge_reynolds::supply::line_at_angle;
use sha2::{Digest, Sha256};

use crate::compile::CompileError;
use crate::scene::{CavitationModel, Feed, MeshSource, Scene};

/// Longest edges of a mesh without a wanted size, over those that resolve the film's scale: two halvings.
const FINENESS: f64 = 0.25;

/// A groove of a mesh file may be this part of the radius off the groove that the scene describes.
const ON_RIM: f64 = 1e-3;
/// Edges along the axis, at least, of a mesh without a wanted size.
const ACROSS: f64 = 4.0;

/// The mesh of the liner with round rims on their circles, and the SHA-256 of its file or, drawn, of its vertices and
/// triangles. A mesh made here is graded for the film of the position `near`: eccentricity [1], angle of its minimum [rad].
///
/// # Errors
/// The file is unreadable, defective or not that of the scene; the liner described cannot be meshed.
pub fn liner_mesh(scene: &Scene, near: (f64, f64)) -> Result<(Mesh, String), CompileError> {
    match &scene.mesh {
        MeshSource::File { path, unit, size } => {
            let bytes = gmsh::read_bytes(path)?;
            let mesh = from_file(scene, &bytes, *unit).map_err(|error| error.in_file(path))?;
            check_grooves(scene, &mesh)?;
            let mesh = match size {
                Some(size) => meshed_anew(scene, &mesh, *size, near).map_err(CompileError::Drawing)?,
                None => mesh,
            };
            Ok((mesh, hexadecimal(Sha256::digest(&bytes))))
        }
        MeshSource::Drawing { size } => {
            let mesh = drawn(scene, *size, near).map_err(CompileError::Drawing)?;
            let mut hash = Sha256::new();
            for x in mesh.points().iter().flatten() {
                hash.update(x.to_le_bytes());
            }
            for vertex in mesh.triangles().iter().flatten() {
                hash.update(vertex.to_le_bytes());
            }
            Ok((mesh, hexadecimal(hash.finalize())))
        }
    }
}

/// The mesh as the model of cavitation needs it, and how many edges were flipped for it: a film that conserves its oil is
/// computed on Delaunay meshes. The line of the film start stays.
pub(crate) fn suited(scene: &Scene, mesh: Mesh) -> (Mesh, usize) {
    let conserving = scene.cavitation.is_some_and(|it| it.model == CavitationModel::Jfo);
    if !conserving {
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

fn liner(scene: &Scene) -> Liner {
    Liner {
        radius: scene.bearing.radius(),
        length: scene.bearing.length,
        arc: scene.bearing.arc.map(|arc| (arc.from, arc.to)),
    }
}

fn from_file(scene: &Scene, bytes: &[u8], unit: f64) -> Result<Mesh, oilwedge_mesh::Error> {
    let file = gmsh::parse(bytes)?;
    let mut mesh = Mesh::build(developed::unroll(&file, &liner(scene), unit)?)?;
    for feed in &scene.feeds {
        let hole = shape(scene, feed).filter(|_| feed.hole.is_some() && mesh.region(&feed.group).is_some());
        if let Some(hole) = hole {
            let circle = Circle {
                centre: hole.centre,
                radius: hole.corner,
            };
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
        let rim = region
            .edges
            .iter()
            .flat_map(|&edge| mesh.topology().edges[edge as usize]);
        let inside = region.cells.iter().flat_map(|&cell| mesh.triangles()[cell as usize]);
        let off = rim
            .map(|v| distance(v).abs())
            .chain(inside.map(distance))
            .fold(0.0, f64::max);
        if off > ON_RIM * scene.bearing.radius() {
            return Err(CompileError::GrooveElsewhere {
                group: feed.group.clone(),
                off,
            });
        }
    }
    Ok(())
}

fn drawn(scene: &Scene, size: Option<f64>, near: (f64, f64)) -> Result<Mesh, Vec<DrawingError>> {
    let blueprint = Blueprint {
        liner: liner(scene),
        features: (scene.feeds.iter()).filter_map(|feed| feature(scene, feed)).collect(),
        line: scene.bearing.film_start,
    };
    graded(scene, &blueprint, size.unwrap_or(needed_size(scene)), near)
}

/// Longest edges [m] of a mesh without a wanted size.
fn needed_size(scene: &Scene) -> f64 {
    (FINENESS * LONGEST * scene.bearing.radius()).min(scene.bearing.length / ACROSS)
}

/// The scene with the longest edges of its mesh `factor` times as long; `None` where its mesh is that of a file.
pub(crate) fn resized(scene: &Scene, factor: f64) -> Option<Scene> {
    let mut resized = scene.clone();
    match &mut resized.mesh {
        MeshSource::File { size, .. } => *size = Some(factor * (*size)?),
        MeshSource::Drawing { size } => *size = Some(factor * size.unwrap_or(needed_size(scene))),
    }
    Some(resized)
}

/// A feed that the scene describes, as it is drawn.
fn feature(scene: &Scene, feed: &Feed) -> Option<Feature> {
    let shape = shape(scene, feed)?;
    Some(Feature {
        name: feed.group.clone(),
        shape,
        // A groove all around would cut the film in two; a deeper film is still a film.
        meshed: shape.is_full_turn() || feed.pressure.is_none(),
    })
}

/// The geometry of a file, meshed as the film needs it.
fn meshed_anew(scene: &Scene, mesh: &Mesh, size: f64, near: (f64, f64)) -> Result<Mesh, Vec<DrawingError>> {
    let (described, shown): (Vec<&Feed>, Vec<&Feed>) =
        (scene.feeds.iter()).partition(|feed| shape(scene, feed).is_some());
    let names: Vec<&str> = shown.iter().map(|feed| feed.group.as_str()).collect();
    let mut blueprint = Blueprint {
        line: scene.bearing.film_start,
        ..Blueprint::of_mesh(mesh, liner(scene), &names)?
    };
    blueprint
        .features
        .extend(described.into_iter().filter_map(|feed| feature(scene, feed)));
    graded(scene, &blueprint, size, near)
}

/// Edges of at most `longest` [m], shorter where the film is thin.
fn graded(scene: &Scene, blueprint: &Blueprint, longest: f64, near: (f64, f64)) -> Result<Mesh, Vec<DrawingError>> {
    let radius = scene.bearing.radius();
    generate(blueprint, &|[x, _]| longest * film_scale(near, x / radius) / LONGEST)
}

/// Bounds of the size that resolves the film, in radii.
const LONGEST: f64 = 0.6;
const SHORTEST: f64 = 0.01;

/// Size [radii] that resolves the film at the angle `phi` [rad]: 0.65 of the film length `sqrt(2 h/(c eps))`,
/// over which the thickness doubles at its minimum.
fn film_scale((eccentricity, min_film_angle): (f64, f64), phi: f64) -> f64 {
    let thickness = 1.0 - eccentricity * (phi - min_film_angle).cos();
    (0.65 * (2.0 * thickness / eccentricity).sqrt()).clamp(SHORTEST, LONGEST)
}

/// The shape of a feed on the developed surface, where the scene gives it.
pub(crate) fn shape(scene: &Scene, feed: &Feed) -> Option<Shape> {
    let radius = scene.bearing.radius();
    let hole = feed
        .hole
        .map(|hole| Shape::disc([radius * hole.angle, hole.z], 0.5 * hole.diameter));
    let groove = feed.groove.map(|groove| {
        let (middle, half) = match groove.arc {
            Some(arc) => (0.5 * (arc.from + arc.to), 0.5 * radius * (arc.to - arc.from)),
            None => (0.0, f64::INFINITY),
        };
        Shape {
            centre: [radius * middle, groove.z],
            half: [half, 0.5 * groove.width],
            corner: groove.corner,
        }
    });
    hole.or(groove)
}
