//! The films that are timed: a ring with a feed hole on uniform meshes from a file, and bearings whose liner is drawn.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oilwedge_mesh::developed::LinerDomain;
use oilwedge_mesh::generate::{Blueprint, Feature, RoundedRectangle, generate};
use oilwedge_mesh::{Mesh, gmsh};
use oilwedge_scene::Scene;
use tempfile::TempDir;

use crate::msh_file::{Element, Encoding, Form, Numbers, scattered, to_bytes};
use oilwedge_tests::program::repository;

/// Radius [m] of the ring.
const RADIUS: f64 = 0.0375;
/// Length of the bearing [m].
const LENGTH: f64 = 0.075;
/// Radius of its feed hole [m], and the angle [deg] of that.
const HOLE: (f64, f64) = (0.0085, 130.0);
/// What gmsh writes for a large mesh (`-bin`).
const LARGE: Form =
    Form { encoding: Encoding::Binary, element: Element::Linear, numbers: Numbers::Consecutive, entities: 1 };
/// Most unknowns of the meshes from which the size of another one is found.
const TRIAL: f64 = 40_000.0;

/// A ring with a feed hole, eccentricity 0.8, as long as it is wide.
const RING: &str = r#"
title = "Ring with a feed hole"
[bearing]
diameter = "75 mm"
length = "75 mm"
clearance = "37.5 um"
[ends]
pressure = "0 bar"
[[feed]]
group = "feed_hole"
pressure = "1 bar"
"#;
/// Table of a journal at a given position, in most films.
const AT_REST: &str = r#"
[journal]
speed = "10 rad/s"
eccentricity = 0.8
min_film_angle = "180 deg"
"#;
/// Table of a journal under a load.
const LOADED: &str = r#"
[journal]
speed = "10 rad/s"
[load]
force = "50 kN"
angle = "130 deg"
"#;

/// Operating points of the ring.
const MAP: &str = r#"
[sweep]
speed = { from = "4 rad/s", to = "40 rad/s", steps = 40 }
force = { from = "10 kN", to = "90 kN", steps = 25 }
"#;

/// What is simulated on the ring.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// Constant viscosity, full film: one linear system.
    Linear,
    /// Viscosity after Barus.
    Barus,
    /// A cavity after Swift and Stieber.
    SwiftStieber,
    /// The film under a load whose position is sought.
    Loaded,
}

impl Kind {
    fn text(self) -> String {
        let journal = if self == Self::Loaded { LOADED } else { AT_REST };
        let alpha = if self == Self::Barus { "barus = { alpha = \"1e-9 1/Pa\" }\n" } else { "" };
        let cavitation = match self {
            Self::Linear | Self::Barus => "",
            Self::SwiftStieber | Self::Loaded => "[cavitation]\nmodel = \"reynolds\"\n",
        };
        format!("{RING}{journal}[oil]\nviscosity = \"0.4 Pa.s\"\n{alpha}{cavitation}")
    }
}

/// Meshes and scenes in a folder of their own, that goes when they do.
pub struct Films {
    folder: TempDir,
}

impl Films {
    /// An empty folder.
    ///
    /// # Panics
    /// If there is no folder for temporary files.
    pub fn new() -> Self {
        Self { folder: TempDir::new().expect("a folder") }
    }

    /// Folder of scenes and meshes, in which the program may write.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The ring on about so many `unknowns`, from a binary gmsh file of straight triangles in an order without
    /// locality.
    pub fn ring(&self, kind: Kind, unknowns: usize) -> PathBuf {
        let mesh = self.folder().join(format!("{unknowns}.msh"));
        if !mesh.exists() {
            let text = gmsh::to_text(&ring(unknowns));
            let file = scattered(&gmsh::parse(text.as_bytes()).expect("our own file"));
            std::fs::write(&mesh, to_bytes(&file, LARGE)).expect("a mesh file is written");
        }
        let text = format!("{}[mesh]\nfile = \"{unknowns}.msh\"\n", kind.text());
        self.written(&format!("{kind:?}{unknowns}"), &text)
    }

    /// The ring with its mesh drawn here, about so many `unknowns`, finer where the film is thin.
    pub fn drawn_ring(&self, unknowns: usize) -> PathBuf {
        let hole = format!(
            "[[feed]]\nhole = {{ diameter = \"{} mm\", angle = \"{} deg\", z = \"0 mm\" }}",
            2e3 * HOLE.0,
            HOLE.1
        );
        let text = Kind::Linear.text().replace("[[feed]]", &hole);
        self.drawn("drawn_ring", &text, unknowns)
    }

    /// The shipped ring with an axial groove that conserves its oil, about so many `unknowns`.
    pub fn grooved_ring(&self, unknowns: usize) -> PathBuf {
        let text = shipped("13_grooved_ring").replace("[mesh]\nsize = \"3 mm\"\n", "");
        self.drawn("grooved_ring", &text, unknowns)
    }

    /// The smallest shipped film, a plain ring drawn with about so many `unknowns`.
    pub fn plain_ring(&self, unknowns: usize) -> PathBuf {
        let text = shipped("01_plain_ring").replace("[mesh]\nfile = \"../meshes/ring.msh\"\n", "");
        self.drawn("plain_ring", &text, unknowns)
    }

    /// A map of 40 speeds by 25 loads, on the ring with Swift and Stieber's cavity and about so many `unknowns`.
    pub fn map(&self, unknowns: usize) -> PathBuf {
        let ring = self.ring(Kind::Loaded, unknowns);
        let text = std::fs::read_to_string(&ring).expect("our own scene");
        self.written(&format!("map{unknowns}"), &(text + MAP))
    }

    /// `text` with a size for about so many `unknowns`, found from two coarser meshes.
    pub(super) fn drawn(&self, name: &str, text: &str, unknowns: usize) -> PathBuf {
        let sized = |size: f64| format!("{text}[mesh]\nsize = \"{size:.6e} m\"\n");
        let of = |size: f64| {
            let scene = oilwedge_study::parse(&sized(size), self.folder()).expect("our own scene");
            super::phases::mesh(&scene).quadratic_nodes() as f64
        };
        let size = size_for(unknowns, of);
        self.written(&format!("{name}{unknowns}"), &sized(size))
    }

    /// `text` as a scene in the folder.
    pub(super) fn written(&self, name: &str, text: &str) -> PathBuf {
        let path = self.folder().join(format!("{name}.toml"));
        std::fs::write(&path, text).expect("a scene is written");
        path
    }
}

impl Default for Films {
    fn default() -> Self {
        Self::new()
    }
}

fn shipped(name: &str) -> String {
    let path = repository().join("scenes").join(format!("{name}.toml"));
    std::fs::read_to_string(path).expect("a shipped scene")
}

/// A scene of these films.
///
/// # Panics
/// If it is none.
pub fn scene(path: &Path) -> Arc<Scene> {
    Arc::new(oilwedge_study::read(path).unwrap_or_else(|error| panic!("{error}")))
}

/// The ring with uniform triangles.
fn ring(unknowns: usize) -> Mesh {
    let (radius, angle) = HOLE;
    let hole = Feature {
        name: "feed_hole".into(),
        shape: RoundedRectangle::disc([RADIUS * angle.to_radians(), 0.0], radius),
        meshed: false,
    };
    let blueprint = Blueprint {
        liner: LinerDomain { radius: RADIUS, length: LENGTH, arc: None },
        features: vec![hole],
        line: None,
    };
    let uniform = |size: f64| generate(&blueprint, &|_| size).expect("a ring with a hole");
    uniform(size_for(unknowns, |size| uniform(size).quadratic_nodes() as f64))
}

/// The size [m] of a mesh of so many `unknowns`, where `of` counts those of a mesh of a size: found from coarse meshes.
fn size_for(unknowns: usize, of: impl Fn(f64) -> f64) -> f64 {
    let trial = TRIAL.min(unknowns as f64);
    let mut size = (std::f64::consts::TAU * RADIUS * LENGTH * 2.0 / (0.433 * trial)).sqrt();
    for goal in [trial, trial, unknowns as f64] {
        size *= (of(size) / goal).sqrt();
    }
    size
}
