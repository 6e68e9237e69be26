//! What `oilwedge check` reports of a scene or mesh that can be used.

use oilwedge_mesh::Quality;
use serde::Serialize;

use std::path::Path;

use oilwedge_mesh::{Mesh, developed, gmsh};
use oilwedge_scene::{Design, Scene};
use oilwedge_study::CompileError;
use oilwedge_study::compile::compile;
use oilwedge_study::effects::Effects;
use oilwedge_study::orbit::{expected_seconds, film_of_orbit};
use oilwedge_study::refinement::first_film;
use oilwedge_study::regime::unusual_clearance;
use oilwedge_study::result::{MeshFacts, in_order};
use oilwedge_study::run::facts;
use oilwedge_study::warnings::mesh_warnings;

use crate::Error;
use crate::folder::replace;
use crate::sketch::{sketch, words};
use crate::sweep::ToleranceRecord;

/// What stands for a file name where the liner described is meshed.
const DRAWN: &str = "made of the liner described";
/// What stands there where finer meshes may follow.
const FIRST_DRAWN: &str = "made of the liner described, the first towards the tolerance";
/// Diameter and length [m] beyond which a unit is suspected.
const LARGEST: f64 = 5.0;
/// Angles below this [deg] are worth a warning.
const SHARP: f64 = 15.0;

/// Name and version of the form of what `oilwedge check --json` prints.
pub const CHECK_FORMAT: &str = "oilwedge-check/1";

/// What was found in a scene or mesh that can be used.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckReport {
    /// [`CHECK_FORMAT`].
    pub format: String,
    /// Title of the scene; `None` where a mesh was checked.
    pub title: Option<String>,
    /// The mesh file.
    pub mesh_file: String,
    /// What would be computed; `None` where a mesh was checked.
    pub effects: Option<Effects>,
    /// The mesh.
    pub mesh: MeshFacts,
    /// How small error bars would be made by refinement, relative, by name of quantity; empty without a tolerance.
    #[serde(serialize_with = "in_order::serialize")]
    pub tolerance: Vec<(String, f64)>,
    /// Tolerances of numbers of the scene; absent in JSON where it has none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub key_tolerances: Vec<ToleranceRecord>,
    /// The axes of the sweep and their numbers of values; empty without one.
    #[serde(serialize_with = "in_order::serialize")]
    pub sweep: Vec<(String, usize)>,
    /// What a design chooses, a line each; absent in JSON without one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub design: Vec<String>,
    /// The liner in words, a line each; empty where a mesh was checked.
    pub liner: Vec<String>,
    /// The unrolled liner drawn in letters; empty where a mesh was checked.
    pub sketch: String,
    /// How good the mesh is.
    pub quality: Quality,
    /// The named regions of the mesh.
    pub regions: Vec<RegionFacts>,
    /// Unknowns and the entries of the Cholesky factor (8 bytes each): the cost of a solve; `None` where a mesh was
    /// checked.
    pub cost: Option<Cost>,
    /// Doubts, in sentences.
    pub warnings: Vec<String>,
}

/// What a solve costs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Cost {
    /// Nodes whose pressure is not given.
    pub unknowns: usize,
    /// Entries of the Cholesky factor.
    pub factor_entries: usize,
    /// Processor time of an orbit, estimated [s]; `None` where the scene asks for none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub orbit_seconds: Option<f64>,
}

/// Facts about a named region of a mesh.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RegionFacts {
    /// Name of the physical group.
    pub name: String,
    /// `curve` or `surface`.
    pub kind: String,
    /// Number of its edges or cells.
    pub parts: usize,
}

/// Reads the mesh of a scene and reports what would be computed.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or does not fit the scene.
pub fn check_scene(scene: &Scene) -> Result<CheckReport, Error> {
    let model = compile(scene)?;
    let film = match model.scope.orbit {
        Some(_) => film_of_orbit(&model)?,
        None => first_film(&model)?,
    };
    let mesh = film.system.space().mesh();
    let drawn = if scene.tolerance.is_some() { FIRST_DRAWN } else { DRAWN };
    let name = scene.mesh.path().unwrap_or(Path::new(drawn));
    let mut report = check_report(name, mesh);
    let pockets: Vec<_> = film.pockets().filter_map(|name| mesh.region(name)).collect();
    report.sketch = sketch(mesh, &film.system.supply, &pockets, scene.bearing.radius());
    report.liner = words(scene);
    report.tolerance = (model.targets.iter().flat_map(|targets| &targets.required))
        .map(|target| (target.quantity.clone(), target.relative))
        .collect();
    report.key_tolerances = scene.tolerances.iter().map(ToleranceRecord::from).collect();
    report.title = Some(scene.title.clone());
    report.sweep =
        (scene.sweep.iter()).flat_map(|plan| &plan.axes).map(|axis| (axis.heading(), axis.values.len())).collect();
    report.design = scene.design.as_ref().map_or_else(Vec::new, chosen);
    report.effects = Some(Effects::of(&model.effects));
    report.warnings.extend(huge(mesh).map(|size| {
        format!("the liner is {size}, larger than any bearing: are bearing.diameter and bearing.length in millimetres, as in diameter = \"60 mm\"?")
    }));
    report.warnings.extend(
        (mesh_warnings(&film).into_iter()).chain(unusual_clearance(&film.problem.bearing)).map(|warning| warning.text),
    );
    report.cost = Some(Cost {
        unknowns: film.unknowns(),
        factor_entries: film.system.analysis().map_err(CompileError::from)?.factor_entries(),
        orbit_seconds: expected_seconds(&film),
    });
    Ok(report)
}

/// What a design chooses, in words.
fn chosen(design: &Design) -> Vec<String> {
    let free = design.free.iter().map(|axis| format!("{} from {} to {}", axis.path, axis.told(0), axis.told(1)));
    let listed = design.choices.iter().map(|axis| {
        let values: Vec<String> = (0..axis.values.len()).map(|index| axis.told(index)).collect();
        format!("{} of {}", axis.path, values.join(", "))
    });
    let objective = format!("{} {}", design.sense.name(), design.objective.name);
    std::iter::once(objective).chain(free).chain(listed).collect()
}

/// Reads a mesh file by itself, its lengths in metres; the liner is the one its nodes lie on.
///
/// # Errors
/// [`Error::Compile`] where the mesh cannot be read or is defective.
pub fn check_mesh(path: &Path) -> Result<CheckReport, Error> {
    let mesh = developed::read_alone(path).map_err(CompileError::from)?;
    let mut report = check_report(path, &mesh);
    report.warnings.extend(huge(&mesh).map(|size| {
        format!("its lengths were read as metres, and it is {size}: where they are millimetres, the scene says so by [mesh] unit = \"mm\"")
    }));
    Ok(report)
}

/// The size of a liner larger than any bearing, in words.
fn huge(mesh: &Mesh) -> Option<String> {
    let extent = |axis: usize| {
        let places = mesh.points().iter().map(|point| point[axis]);
        places.clone().fold(f64::NEG_INFINITY, f64::max) - places.fold(f64::INFINITY, f64::min)
    };
    let [around, along] = [mesh.period().unwrap_or(extent(0)), extent(1)];
    let is_huge = around > std::f64::consts::PI * LARGEST || along > LARGEST;
    is_huge.then(|| format!("{around:.4} m around and {along:.4} m long"))
}

/// Writes a mesh as a gmsh 4.1 file, whole or not at all. Through a link the file is replaced that it leads to; what is
/// no plain file (`/dev/stdout`) is written into.
///
/// # Errors
/// [`Error::Compile`] where the file cannot be written.
pub fn write_mesh(mesh: &Mesh, path: &Path) -> Result<(), Error> {
    let text = gmsh::to_text(mesh);
    let failed = |source| {
        let error = oilwedge_mesh::Error::Io { action: "write", path: path.to_owned(), error: source };
        Error::from(CompileError::from(error))
    };
    let place = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let folder = match place.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let (true, Some(name)) = (place.is_file() || !place.exists(), place.file_name()) else {
        return std::fs::write(path, text).map_err(failed);
    };
    if !folder.is_dir() {
        return Err(failed(std::io::ErrorKind::NotFound.into()));
    }
    match replace(folder, &[(name, Some(text.as_bytes()))]) {
        Err(Error::System { source, .. }) => Err(failed(source)),
        other => other,
    }
}

fn check_report(path: &Path, mesh: &Mesh) -> CheckReport {
    let quality = Quality::of(mesh);
    let mut warnings = Vec::new();
    if quality.least_angle < SHARP {
        warnings.push(format!(
            "the least angle is {:.1} deg; triangles below {SHARP} deg cost accuracy",
            quality.least_angle
        ));
    }
    if quality.unnamed_boundary_edges > 0 {
        warnings.push(format!(
            "{} boundary edges belong to no named curve; a film needs a condition there",
            quality.unnamed_boundary_edges
        ));
    }
    let parts = |name: &str, kind: &str, parts: usize| {
        (parts > 0).then(|| RegionFacts { name: name.to_owned(), kind: kind.to_owned(), parts })
    };
    CheckReport {
        format: CHECK_FORMAT.to_owned(),
        title: None,
        mesh_file: path.display().to_string(),
        effects: None,
        mesh: facts(mesh),
        regions: (mesh.regions().iter())
            .flat_map(|region| {
                let curve = parts(&region.name, "curve", region.edges.len());
                let surface = parts(&region.name, "surface", region.cells.len());
                [curve, surface].into_iter().flatten()
            })
            .collect(),
        quality,
        tolerance: Vec::new(),
        key_tolerances: Vec::new(),
        sweep: Vec::new(),
        design: Vec::new(),
        liner: Vec::new(),
        sketch: String::new(),
        cost: None,
        warnings,
    }
}
