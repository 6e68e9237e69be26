//! A scene: everything a user says about one bearing, in SI. `Scene::read` is the only way to get one from a file.

mod heat;
mod journal;
mod oil;
mod start;
mod tolerance;

pub use heat::{Engine, Heat, Mixing};
pub use journal::{Journal, Position, Squeeze};
pub use oil::{BarusForm, Oil, PressureLaw, RoelandsExponent};
pub use tolerance::{Target, Tolerance};

pub use oilwedge_reynolds::Theory;

use crate::complaint::{Complaint, SceneError};
use crate::sweep::Plan;
use crate::{schema, validate};
use oilwedge_bearing::CapJoint;
use sha2::{Digest, Sha256};
use std::io::Read;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

/// The largest scene file that is read [bytes].
pub const SCENE_LIMIT: u64 = 1 << 20;

/// How many faults of the TOML are told; more follow from the first ones.
const FAULT_LIMIT: usize = 5;

/// How many complaints about a scene are told.
const COMPLAINT_LIMIT: usize = 100;

/// How a gmsh file begins.
const MESH_OPENING: &[u8] = b"$MeshFormat";

/// One bearing, as its scene describes it, in SI. Whatever is `None` is not simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Title of the study; the name of the file where the scene gives none.
    pub title: String,
    /// The liner.
    pub bearing: Bearing,
    /// Where the mesh comes from.
    pub mesh: MeshSource,
    /// How small error bars must become by refinement of that mesh; `None`: it is used as it is.
    pub tolerance: Option<Tolerance>,
    /// The open ends.
    pub ends: Ends,
    /// Regions of given pressure, in the order of the scene.
    pub feeds: Vec<Feed>,
    /// The journal and where it is.
    pub journal: Journal,
    /// The oil.
    pub oil: Oil,
    /// The balance that finds the temperature of the film; `None`: it is given, or plays no part.
    pub heat: Option<Heat>,
    /// What happens where the film would break; `None`: a full film, whatever its pressure.
    pub cavitation: Option<Cavitation>,
    /// The cap of the connecting rod whose bearing this is; nothing of the film depends on it.
    pub cap: Option<Cap>,
    /// The cases that `oilwedge sweep` makes of it; nothing else looks at them.
    pub sweep: Option<Plan>,
    /// SHA-256 of the scene's text, 64 hexadecimal digits.
    pub sha256: String,
}

/// The liner.
#[derive(Debug, Clone, PartialEq)]
pub struct Bearing {
    /// Bore D [m].
    pub diameter: f64,
    /// Full length B [m].
    pub length: f64,
    /// Radial clearance c [m].
    pub clearance: f64,
    /// The part of the circumference that is liner; `None`: a full ring, periodic.
    pub arc: Option<Arc>,
    /// Arc only: film fraction of the oil that the journal brings in at its leading edge; `None`: that edge is flooded.
    pub inlet_fraction: Option<f64>,
    /// Ring only: angle of an axial line held at the pressure of the ends [rad].
    pub film_start: Option<f64>,
    /// Combined roughness of journal and liner (root mean square) [m], to tell whether they touch; nothing is computed with it.
    pub roughness: Option<f64>,
    /// Which pressure flows there are.
    pub theory: Theory,
}

impl Bearing {
    /// Journal radius R = D/2 [m].
    pub fn radius(&self) -> f64 {
        0.5 * self.diameter
    }
}

/// A part of the circumference, counted from +x towards +y; `from < to < from + 2 pi`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// Where it begins [rad].
    pub from: f64,
    /// Where it ends [rad].
    pub to: f64,
}

/// Where the mesh comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum MeshSource {
    /// A gmsh file.
    File {
        /// The file; a relative path of the scene has been put behind the folder of the scene.
        path: PathBuf,
        /// Length of one unit of the file's coordinates [m].
        unit: f64,
        /// Longest edges wanted [m] where its geometry is meshed anew; `None`: the mesh is used as it is.
        size: Option<f64>,
        /// Where the triangles of a mass-conserving film lie.
        layout: Layout,
    },
    /// The liner that the scene describes is meshed.
    Drawing {
        /// Longest edges wanted [m]; `None`: as the film needs.
        size: Option<f64>,
    },
}

/// Where the triangles of a mesh file lie if the film conserves oil, which is carried along the flow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Layout {
    /// In rows along the flow: laid anew where those of the file are not.
    #[default]
    Rows,
    /// Where they lie in the file.
    File,
}

impl MeshSource {
    /// Whether its size follows the thickness of the film, and so the position of the journal.
    pub fn is_graded(&self) -> bool {
        match self {
            Self::File { size, .. } => size.is_some(),
            Self::Drawing { .. } => true,
        }
    }

    /// The mesh file, if there is one.
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::File { path, .. } => Some(path),
            Self::Drawing { .. } => None,
        }
    }
}

/// The cap of a connecting rod.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cap {
    /// The cap and its bolts.
    pub joint: CapJoint,
    /// Angle [rad] of the middle of the cap.
    pub angle: f64,
}

/// The two open ends of the bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ends {
    /// Gauge pressure p_e at both ends [Pa].
    pub pressure: f64,
}

/// A hole, groove or pocket: a region of given pressure, or one where the film is deeper.
#[derive(Debug, Clone, PartialEq)]
pub struct Feed {
    /// Physical group of the mesh that is the region: a curve (cut out) or a surface (meshed).
    pub group: String,
    /// The round hole that the region is, where the scene says so.
    pub hole: Option<Hole>,
    /// The groove that the region is, where the scene says so.
    pub groove: Option<Groove>,
    /// Gauge pressure p_s [Pa]; `None` in a pocket.
    pub pressure: Option<f64>,
    /// How much deeper the film is in a pocket [m], whose pressure is found; `None` where pressure is given.
    pub depth: Option<f64>,
}

/// A rectangle with round corners on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    /// Where it begins and ends [rad]; `None`: all around.
    pub arc: Option<Arc>,
    /// Extent along the axis [m].
    pub width: f64,
    /// Axial position of its middle [m].
    pub z: f64,
    /// Radius of its corners on the developed surface [m].
    pub corner: f64,
}

/// A round hole on the developed surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hole {
    /// Diameter [m].
    pub diameter: f64,
    /// Angle of its centre [rad].
    pub angle: f64,
    /// Axial position of its centre [m]; 0 is midway between the ends.
    pub z: f64,
}

/// What happens where the film would break.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cavitation {
    /// The closure.
    pub model: CavitationModel,
    /// Gauge pressure in the cavity p_c [Pa].
    pub pressure: f64,
}

/// The closures that are served.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CavitationModel {
    /// Full Sommerfeld film: the oil bears any tension.
    None,
    /// Pressures below the cavity pressure are dropped after the solve.
    Guembel,
    /// Swift-Stieber: the pressure is nowhere below that of the cavity, and meets it without a kink.
    Reynolds,
    /// Jakobsson-Floberg-Olsson: oil is conserved; the cavity holds a film fraction that is carried along.
    Jfo,
}

impl CavitationModel {
    /// True where it leaves the pressure of a cavity, but no film fraction.
    pub fn drops_pressures(self) -> bool {
        matches!(self, Self::Guembel | Self::Reynolds)
    }

    /// True where the edge of the cavity is found with the pressure.
    pub fn has_free_boundary(self) -> bool {
        matches!(self, Self::Reynolds | Self::Jfo)
    }

    /// True where the cavity holds the oil that is carried into it.
    pub fn conserves_oil(self) -> bool {
        self == Self::Jfo
    }

    /// Name in scenes and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Guembel => "guembel",
            Self::Reynolds => "reynolds",
            Self::Jfo => "jfo",
        }
    }
}

impl Scene {
    /// Reads and checks the scene in the file `path`.
    ///
    /// # Errors
    /// [`SceneError`]: the file cannot be read, is no TOML, or is no scene that can be computed; in the last two
    /// cases everything that is wrong is told at once.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let fail = |source| SceneError::Read {
            path: path.to_path_buf(),
            source,
        };
        let metadata = std::fs::metadata(path).map_err(fail)?;
        if !metadata.is_file() {
            return Err(SceneError::NotAFile {
                path: path.to_path_buf(),
            });
        }
        let mut bytes = Vec::new();
        let file = std::fs::File::open(path).map_err(fail)?;
        file.take(SCENE_LIMIT + 1).read_to_end(&mut bytes).map_err(fail)?;
        if bytes.len() as u64 > SCENE_LIMIT {
            return Err(SceneError::TooLarge {
                path: path.to_path_buf(),
                limit: SCENE_LIMIT,
            });
        }
        if bytes.starts_with(MESH_OPENING) {
            return Err(SceneError::Mesh {
                path: path.to_path_buf(),
            });
        }
        let text = String::from_utf8(bytes).map_err(|error| SceneError::NotText {
            path: path.to_path_buf(),
            offset: error.utf8_error().valid_up_to(),
        })?;
        Self::from_text(&text, path, no_file)
    }

    /// Checks the scene `text`; `path` is where it stands: its folder is where a relative mesh file is looked for,
    /// its name is the title where the scene gives none. Nothing is read from the disk, and the mesh need not exist.
    ///
    /// # Errors
    /// [`SceneError::Syntax`] and [`SceneError::Complaints`], with everything that is wrong.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        Self::from_text(text, path, |_| None)
    }

    /// `no_mesh` tells why the mesh cannot be read.
    fn from_text(text: &str, path: &Path, no_mesh: impl Fn(&Path) -> Option<String>) -> Result<Self, SceneError> {
        let (document, faults) = toml::de::DeTable::parse_recoverable(text);
        if !faults.is_empty() {
            let complaints = in_order(faults.iter().take(FAULT_LIMIT).map(fault).collect());
            return Err(SceneError::Syntax {
                path: path.to_path_buf(),
                text: text.to_string(),
                complaints,
            });
        }
        match Self::of_document(document.get_ref(), text, path, no_mesh) {
            Ok(mut scene) => {
                scene.sha256 = Sha256::digest(text.as_bytes())
                    .iter()
                    .map(|byte| format!("{byte:02x}"))
                    .collect();
                Ok(scene)
            }
            Err(complaints) => Err(SceneError::Complaints {
                path: path.to_path_buf(),
                text: text.to_string(),
                complaints,
            }),
        }
    }

    /// The scene that a document makes, whose values stand in `text`; or everything that is wrong with it.
    pub fn of_document(
        document: &DeTable<'_>,
        text: &str,
        path: &Path,
        no_mesh: impl Fn(&Path) -> Option<String>,
    ) -> Result<Self, Vec<Complaint>> {
        let (scene, marks, mut complaints) = schema::read_scene(document, text, path);
        complaints.extend(validate::complaints(&scene, &marks));
        let named = marks.has("mesh.file") && complaints.iter().all(|complaint| complaint.key != "mesh.file");
        if let Some(message) = scene.mesh.path().and_then(no_mesh).filter(|_| named) {
            let help = "give the path of a gmsh 4.1 file, counted from the folder of the scene";
            complaints.push(marks.complaint("mesh.file", message, help));
        }
        match complaints.is_empty() {
            true => Ok(scene),
            false => Err(first_ones(complaints)),
        }
    }
}

/// Why there is no plain file `path`, as the end of a sentence.
pub fn no_file(path: &Path) -> Option<String> {
    let path_text = path.display();
    match std::fs::metadata(path) {
        Ok(metadata) if metadata.is_file() => None,
        Ok(metadata) if metadata.is_dir() => Some(format!("{path_text} is a folder, not a mesh file")),
        Ok(_) => Some(format!("{path_text} is not a plain file")),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Some(format!("there is no file {path_text}")),
        Err(error) => Some(format!("cannot read {path_text}: {error}")),
    }
}

fn fault(error: &toml::de::Error) -> Complaint {
    Complaint {
        key: String::new(),
        value: String::new(),
        message: error.message().to_string(),
        help: "a scene is TOML: [table] lines, and key = \"value with unit\" lines below them".to_string(),
        span: error.span(),
    }
}

/// The first complaints in the order of the text; of many, the last one says that there are more.
fn first_ones(complaints: Vec<Complaint>) -> Vec<Complaint> {
    let mut complaints = in_order(complaints);
    if complaints.len() > COMPLAINT_LIMIT {
        complaints.truncate(COMPLAINT_LIMIT);
        complaints.push(Complaint {
            key: String::new(),
            value: String::new(),
            message: format!("there are more complaints; these are the first {COMPLAINT_LIMIT}"),
            help: "put these right first".to_string(),
            span: None,
        });
    }
    complaints
}

/// In the order of the text; complaints without a place come last.
pub fn in_order(mut complaints: Vec<Complaint>) -> Vec<Complaint> {
    complaints.sort_by_key(|complaint| complaint.span.as_ref().map_or(usize::MAX, |span| span.start));
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_that_are_no_scenes_are_refused_by_name() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("scene.toml");
        assert!(matches!(Scene::read(&path), Err(SceneError::Read { .. })));
        assert!(matches!(Scene::read(folder.path()), Err(SceneError::NotAFile { .. })));
        assert!(matches!(
            Scene::read(Path::new("/dev/zero")),
            Err(SceneError::NotAFile { .. })
        ));
        std::fs::write(&path, vec![b'#'; SCENE_LIMIT as usize + 1])?;
        assert!(matches!(Scene::read(&path), Err(SceneError::TooLarge { .. })));
        std::fs::write(&path, "$MeshFormat\n4.1 0 8\n")?;
        assert!(matches!(Scene::read(&path), Err(SceneError::Mesh { .. })));
        std::fs::write(&path, b"title = \"\xff\"")?;
        assert!(matches!(Scene::read(&path), Err(SceneError::NotText { offset: 9, .. })));
        std::fs::write(&path, "\u{feff}titel = 5\r\n")?;
        let error = Scene::read(&path).expect_err("no scene").to_string();
        assert!(
            error.contains("titel: this key is not known (did you mean \"title\"?)"),
            "{error}"
        );
        Ok(())
    }
}
