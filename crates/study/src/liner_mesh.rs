//! The mesh of a scene's liner: from its file, or drawn from what the scene says.

use oilwedge_mesh::developed::{self, Liner};
use oilwedge_mesh::generate::{
    Blueprint, DrawingError, Feature, Rows, Sense, Shape, generate, generate_in_rows, generate_in_rows_like,
};
use oilwedge_mesh::quality::share_across_flow;
use oilwedge_mesh::{Circle, Mesh, flip, gmsh, rim};
use oilwedge_reynolds::supply::line_at_angle;
use sha2::{Digest, Sha256};

use crate::compile_error::CompileError;
use crate::effects::Sockets;
use crate::feed_region::{FeedRegion, feed_regions, liner, shape};
use crate::film_scale::{FilmScale, LONGEST};
use crate::oil::Oil;
use crate::position::Position;
use oilwedge_scene::{Layout, MeshSource, Scene};

/// Longest edges of a mesh without a wanted size, over those that resolve the film's scale: two halvings.
const FINENESS: f64 = 0.25;

/// A groove of a mesh file may be this part of the radius off the groove that the scene describes.
const ON_RIM: f64 = 1e-3;
/// Edges along the axis, at least, of a mesh without a wanted size.
const ACROSS: f64 = 4.0;

/// The mesh of a liner, and where it comes from.
pub struct LinerMesh {
    /// The mesh, with round rims on their circles.
    pub mesh: Mesh,
    /// SHA-256 of its file or, drawn, of its vertices and triangles.
    pub sha256: String,
    /// True if the triangles are not those of the file: they were laid anew in rows along the flow.
    pub is_laid_anew: bool,
}

/// A mesh of which so much of the area lies in triangles without an edge along the flow carries oil across it.
const ACROSS_FLOW: f64 = 0.5;

/// The mesh of the liner. A mesh made here is graded for the film at `position`. Where oil is conserved the triangles lie in rows along the flow; those of a file that do not are laid anew, as long as the edges
/// are there, unless the scene keeps them or its features are none that can be drawn.
///
/// # Errors
/// The file is unreadable, defective or not that of the scene; the liner described cannot be meshed.
pub fn liner_mesh(scene: &Scene, position: Position) -> Result<LinerMesh, CompileError> {
    let scale = FilmScale::of(scene, position)?;
    match &scene.mesh {
        MeshSource::File {
            path,
            unit,
            size,
            layout,
        } => {
            let bytes = gmsh::read_bytes(path)?;
            let mesh = from_file(scene, &bytes, *unit).map_err(|error| error.in_file(path))?;
            check_grooves(scene, &mesh)?;
            let in_rows = match (size, layout) {
                (None, Layout::Rows) if conserves_oil(scene) && share_across_flow(&mesh) > ACROSS_FLOW => {
                    let blueprint = blueprint_of(scene, &mesh);
                    blueprint
                        .and_then(|blueprint| generate_in_rows_like(&blueprint, &mesh, sense(scene)))
                        .ok()
                }
                _ => None,
            };
            let is_laid_anew = in_rows.is_some();
            let mesh = match (size, in_rows) {
                (Some(size), _) => meshed_anew(scene, &mesh, *size, &scale).map_err(CompileError::Drawing)?,
                (None, in_rows) => in_rows.unwrap_or(mesh),
            };
            Ok(LinerMesh {
                mesh,
                sha256: hexadecimal(Sha256::digest(&bytes)),
                is_laid_anew,
            })
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
            Ok(LinerMesh {
                mesh,
                sha256: hexadecimal(hash.finalize()),
                is_laid_anew: false,
            })
        }
    }
}

/// In which sense the journal carries the oil.
fn sense(scene: &Scene) -> Sense {
    match scene.journal.speed < 0.0 {
        true => Sense::Backwards,
        false => Sense::Forwards,
    }
}

/// Whether the film carries its oil through the cavity.
fn conserves_oil(scene: &Scene) -> bool {
    Sockets::of(scene).cavitation.conserves_oil()
}

/// The mesh as the model of cavitation needs it, and how many edges were flipped for it: a film that conserves its oil is
/// computed on Delaunay meshes. The line of the film start stays.
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

fn drawn(scene: &Scene, size: Option<f64>, scale: &FilmScale) -> Result<Mesh, Vec<DrawingError>> {
    let blueprint = Blueprint {
        liner: liner(scene),
        features: features(scene),
        line: scene.bearing.film_start,
    };
    graded(scene, &blueprint, size.unwrap_or(needed_size(scene)), scale)
}

/// Longest edges [m] of a mesh without a wanted size.
fn needed_size(scene: &Scene) -> f64 {
    (FINENESS * LONGEST * scene.bearing.radius()).min(scene.bearing.length / ACROSS)
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
        let shapes: Vec<Shape> = region.feeds.iter().filter_map(|feed| shape(scene, feed)).collect();
        // A groove all around would leave two films; a deeper film is still a film.
        let meshed = region.pressure().is_none() || shapes.iter().any(Shape::is_full_turn);
        let feature = |shape| Feature {
            name: region.name.clone(),
            shape,
            meshed,
        };
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
    let mut blueprint = Blueprint {
        line: scene.bearing.film_start,
        ..Blueprint::of_mesh(mesh, liner(scene), &names)?
    };
    blueprint.features.extend(features(scene));
    Ok(blueprint)
}

/// Edges of at most `longest` [m], shorter where the film is thin.
fn graded(scene: &Scene, blueprint: &Blueprint, longest: f64, scale: &FilmScale) -> Result<Mesh, Vec<DrawingError>> {
    match RowDistances::of(scene, &blueprint.liner, longest, scale) {
        Some(distances) => {
            // Columns are as dense as the thinnest film along the axis needs.
            let (along, across) = (&|x: f64| column(longest, scale, x), &|z: f64| distances.at(z));
            let sense = sense(scene);
            generate_in_rows(blueprint, &Rows { along, across, sense })
        }
        None => generate(blueprint, &|at| longest * scale.at(at) / LONGEST),
    }
}

/// Distance [m] of columns of a mesh in rows.
fn column(longest: f64, scale: &FilmScale, x: f64) -> f64 {
    longest * scale.around_all_along(x) / LONGEST
}

/// How many triangles the drawn mesh of a scene will have for the film at `position`, without those that holes and grooves ask for.
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
    let [width, height] = [
        liner.radius * (to - from) / f64::from(AROUND),
        2.0 * half / f64::from(ALONG),
    ];
    Ok(match RowDistances::of(scene, &liner, longest, &scale) {
        Some(distances) => {
            let columns: f64 = around().map(|x| width / column(longest, &scale, x)).sum();
            2.0 * columns * along().map(|z| height / distances.at(z)).sum::<f64>()
        }
        None => {
            let equilateral = |x: f64, z: f64| 0.75f64.sqrt() / 2.0 * (longest * scale.at([x, z]) / LONGEST).powi(2);
            around()
                .flat_map(|x| along().map(move |z| (x, z)))
                .map(|(x, z)| width * height / equilateral(x, z))
                .sum()
        }
    })
}

/// How far rows along the flow are apart.
struct RowDistances {
    /// Far from all layers [m].
    far: f64,
    /// That of a mesh without a wanted size [m].
    usual: f64,
    /// Places along the axis [m] near which the film changes within a length [m].
    layers: Vec<(f64, f64)>,
    /// What the film of a tilted journal needs at even distances from one end to the other [m]; empty for other films.
    by_tilt: Vec<f64>,
    /// Half of the bearing's length [m].
    half: f64,
    /// True of an orbit.
    is_orbit: bool,
}

impl RowDistances {
    /// Those of a film that conserves its oil, none for other films.
    fn of(scene: &Scene, liner: &Liner, longest: f64, scale: &FilmScale) -> Option<Self> {
        let cavity = (Sockets::of(scene).cavitation.pressure()).filter(|_| conserves_oil(scene))?;
        let usual = |x: f64| needed_size(scene) / longest * column(longest, scale, x);
        Some(Self {
            far: spacing(liner, &|x| column(longest, scale, x)),
            usual: spacing(liner, &usual),
            layers: layers(scene, cavity),
            by_tilt: by_tilt(liner, longest, scale),
            half: 0.5 * liner.length,
            is_orbit: scene.orbit.is_some(),
        })
    }

    /// At the axial position `z` [m].
    fn at(&self, z: f64) -> f64 {
        if self.is_orbit {
            return ROWS_ON_ORBIT * self.far;
        }
        // Cells keep their shape where the mesh is drawn finer.
        let towards = |(edge, thickness): &(f64, f64)| {
            let at_edge = self.far * (IN_LAYER * thickness / self.usual).clamp(FINEST, 1.0);
            at_edge + TOWARDS_EDGE * (z - edge).abs()
        };
        self.layers
            .iter()
            .map(towards)
            .fold(self.far, f64::min)
            .min(self.by_tilt(z))
    }

    /// What the film of a tilted journal needs at the axial position `z` [m].
    fn by_tilt(&self, z: f64) -> f64 {
        let Some(last) = self.by_tilt.len().checked_sub(1) else {
            return f64::INFINITY;
        };
        let place = 0.5 * (1.0 + z / self.half).clamp(0.0, 2.0) * last as f64;
        let k = (place as usize).min(last - 1);
        let part = place - k as f64;
        (1.0 - part) * self.by_tilt[k] + part * self.by_tilt[k + 1]
    }
}

/// What the film of a tilted journal needs along the axis, where it changes fastest around: distances of rows [m] at even places from end to end.
fn by_tilt(liner: &Liner, longest: f64, scale: &FilmScale) -> Vec<f64> {
    const AROUND: u32 = 360;
    const ALONG: u32 = 64;
    let (from, to) = liner.arc.unwrap_or((0.0, std::f64::consts::TAU));
    let at = |z: f64| {
        let angles = (0..AROUND).map(|k| from + (to - from) * (f64::from(k) + 0.5) / f64::from(AROUND));
        let scales = angles.map(|angle| scale.along_by_tilt([liner.radius * angle, z]));
        longest * scales.fold(LONGEST, f64::min) / LONGEST
    };
    let places = (0..=ALONG).map(|k| liner.length * (f64::from(k) / f64::from(ALONG) - 0.5));
    match scale.has_two_scales() {
        true => places.map(at).collect(),
        false => Vec::new(),
    }
}

/// Distance [m] of rows along the flow that have as many nodes as equilateral triangles of `size` [m] at x.
fn spacing(liner: &Liner, size: &dyn Fn(f64) -> f64) -> f64 {
    const SAMPLES: u32 = 720;
    let (from, to) = liner.arc.unwrap_or((0.0, std::f64::consts::TAU));
    let (mut columns, mut triangles) = (0.0, 0.0);
    for k in 0..SAMPLES {
        let angle = from + (to - from) * (f64::from(k) + 0.5) / f64::from(SAMPLES);
        let edge = size(liner.radius * angle);
        columns += 1.0 / edge;
        triangles += 1.0 / (edge * edge);
    }
    0.75f64.sqrt() * columns / triangles
}

/// Rows beside an edge through which oil enters a cavity, over the thickness of the layer that it makes, and over rows far from it at
/// least; how fast they grow with the distance.
const IN_LAYER: f64 = 0.25;
const FINEST: f64 = 0.1;
const TOWARDS_EDGE: f64 = 0.2;

/// Edges [m] all around through which oil enters the cavity, and the thickness [m] of the layer that the excess of pressure `P` presses
/// in while the journal turns by one radian: `c sqrt(P R/(3 mu U))`, from `U h/2 d(thickness)/dx = h^3/(12 mu) P/thickness`.
fn layers(scene: &Scene, cavity: f64) -> Vec<(f64, f64)> {
    let drag = 3.0 * Oil::of(scene).viscosity * scene.journal.speed.abs();
    let thickness = |pressure: f64| scene.bearing.clearance * ((pressure - cavity) / drag).sqrt();
    let half = 0.5 * scene.bearing.length;
    let at_ends = [-half, half].map(|z| (z, scene.ends.pressure));
    let at_grooves = scene.feeds.iter().flat_map(|feed| {
        let shape = shape(scene, feed).filter(|shape| shape.is_full_turn());
        let edges = shape.map(|shape| [-1.0, 1.0].map(|side| shape.centre[1] + side * shape.half[1]));
        edges.into_iter().flatten().filter_map(|z| Some((z, feed.pressure?)))
    });
    let all = at_ends.into_iter().chain(at_grooves);
    all.filter(|(_, pressure)| *pressure > cavity && drag > 0.0)
        .map(|(z, pressure)| (z, thickness(pressure)))
        .collect()
}

/// Distance of the rows of an orbit's mesh, over that of as many equal cells: the peak of pressure that runs around is steep along the flow. One land of the big end of scene
/// 28 on 48 x 4, 48 x 8, 64 x 4 and 96 x 4 cells, whose rows are 1.1, 0.5, 1.4 and 2.1 times as far apart as the columns: least film 1.4, 1.4, 0.9 and 0.2 % off. Layers of oil that
/// enters beside a groove come and go with the cavity, and finer rows there do not show in it.
const ROWS_ON_ORBIT: f64 = 1.7;

/// Meshes or reads the liner of a scene.
///
/// # Errors
/// [`CompileError`] where the mesh cannot be read or made.
pub fn mesh_scene(scene: &Scene) -> Result<Mesh, CompileError> {
    Ok(liner_mesh(scene, Position::start(scene))?.mesh)
}
