//! The scene of a crankshaft.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use toml::de::DeTable;

use super::variant::sum_of;
use super::{CrankshaftTable, check};
use crate::catalogue;
use crate::reader::TableReader;
use crate::scene::{parsed, text_of};
use crate::sweep::{self, Plan};
use crate::wording;
use crate::{
    Complaint, Complaints, CrankBearing, CrankTable, LoadCycle, LoadSource, OrbitTable, SceneError, crank,
    key_tolerance, mesh, orbit,
};

/// A shaft on the films of its bearings, as its scene describes it, in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftScene {
    /// Title of the study; the name of the file where the scene gives none.
    pub title: String,
    /// The shaft.
    pub crankshaft: CrankshaftTable,
    /// The crank drive of each throw; `None`: the loads do not change.
    pub crank: Option<CrankTable>,
    /// How the paths of the journals are followed; `None`: the loads do not change.
    pub orbit: Option<OrbitTable>,
    /// The operating points at which it is to be solved.
    pub sweep: Option<Plan>,
    /// The text that was read.
    pub text: String,
    /// SHA-256 of that text, 64 hexadecimal digits.
    pub sha256: String,
}

impl ShaftScene {
    /// Whether a document is the scene of a crankshaft.
    pub(crate) fn is_meant(document: &DeTable<'_>) -> bool {
        document.contains_key("crankshaft")
    }

    /// Reads the scene in the file `path`; those of its bearings are not read.
    ///
    /// # Errors
    /// [`SceneError`]: the file cannot be read, is no TOML, or is no scene of a crankshaft that can be computed.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let text = text_of(path)?;
        Self::of_text(&text, path, mesh::no_file)
    }

    /// Reads the scene `text`, as if it stood at `path`. Nothing is read from the disk.
    ///
    /// # Errors
    /// [`SceneError::Syntax`] and [`SceneError::Complaints`], with everything that is wrong.
    pub fn parse(text: &str, path: &Path) -> Result<Self, SceneError> {
        Self::of_text(text, path, |_| None)
    }

    /// The files that it names: key, path, and what to give where there is none.
    pub fn files(&self) -> Vec<(String, PathBuf, &'static str)> {
        let bearings = self.crankshaft.bearings.iter().enumerate().map(|(number, bearing)| {
            let key = format!("crankshaft.bearing[{number}].scene");
            let help = "give the path of the scene of a bearing, counted from the folder of this scene";
            (key, bearing.scene.clone(), help)
        });
        let gas = self.crank.as_ref().and_then(CrankTable::gas_file).map(|path| {
            let help = "give the path of a table with a header of units, counted from the folder of the scene";
            ("crank.gas.file".to_owned(), path.to_owned(), help)
        });
        bearings.chain(gas).collect()
    }

    fn of_text(text: &str, path: &Path, no_file: impl Fn(&Path) -> Option<String>) -> Result<Self, SceneError> {
        let document = parsed(text, path)?;
        Self::of_document(document.get_ref(), text, path, no_file).map_err(|complaints| SceneError::Complaints {
            path: path.to_path_buf(),
            text: text.to_owned(),
            complaints,
        })
    }

    /// The scene that a document makes, whose values stand in `text`; or everything that is wrong with it.
    pub(crate) fn of_document(
        document: &DeTable<'_>,
        text: &str,
        path: &Path,
        no_file: impl Fn(&Path) -> Option<String>,
    ) -> Result<Self, Vec<Complaint>> {
        let complaints = RefCell::new(Complaints::new(text));
        let scene = read(TableReader::root(&complaints, document, catalogue::row), text, path);
        let mut complaints = complaints.into_inner();
        let inputs = std::mem::take(&mut complaints.inputs);
        key_tolerance::refuse_all(&inputs, &mut complaints);
        check::check(&scene, &mut complaints);
        for (key, path, help) in scene.files() {
            let is_named = complaints.has(&key) && !complaints.concern(&key);
            if let Some(message) = no_file(&path).filter(|_| is_named) {
                complaints.add(&key, message, help);
            }
        }
        match complaints.into_list() {
            complaints if complaints.is_empty() => Ok(Self { text: text.to_owned(), sha256: sum_of(text), ..scene }),
            complaints => Err(complaints),
        }
    }
}

/// The scene as far as it can be read.
pub(crate) fn read(mut root: TableReader<'_>, text: &str, path: &Path) -> ShaftScene {
    let stem = || path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let title = root.text_if_given("title").unwrap_or_else(stem);
    let title = wording::title(&title);
    let crankshaft = super::read(root.table("crankshaft", "[crankshaft] with speed and youngs_modulus"), path);
    let of_pins =
        LoadCycle { source: LoadSource::Crank(CrankBearing::BigEnd), period: crankshaft.period, frequency: None };
    ShaftScene {
        title,
        crank: (root.table_if_given("crank")).map(|table| crank::read(table, path, Some(&of_pins))),
        orbit: root.table_if_given("orbit").map(orbit::read),
        sweep: (root.table_if_given("sweep")).map(|table| sweep::plan(table, &sweep::OF_SHAFT, text, path)),
        crankshaft,
        text: String::new(),
        sha256: String::new(),
    }
}
