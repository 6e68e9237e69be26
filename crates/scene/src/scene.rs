//! A scene: everything that a user says about one bearing, in SI. It is a description, and never changes.

use std::borrow::Cow;
use std::cell::RefCell;
use std::io::Read;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};
use toml::de::DeTable;

use crate::catalogue;
use crate::complaint::in_order;
use crate::reader::TableReader;
use crate::sweep::{self, Plan};
use crate::wording;
use crate::{
    BearingTable, Bore, Cap, CavitationTable, Check, Complaint, Complaints, CrankTable, Criteria, DynamicsTable, Ends,
    EngineKind, Feed, Heat, Journal, JournalShape, KeyTolerance, LoadCycle, LoadSource, MeshSource, OilTable,
    OrbitTable, Roughness, SceneError, ShaftScene, Support, Tolerance, Turbulence,
};
use crate::{
    bearing, bore, cap, cavitation, crank, criteria, design, dynamics, ends, feed, heat, journal, key_tolerance,
    limits, load, mesh, oil, orbit, roughness, shaft, support, turbulence,
};

/// The largest scene file that is read [bytes].
pub const SCENE_LIMIT: u64 = 1 << 20;
/// How many faults of the TOML are reported; more follow from the first ones.
const FAULT_LIMIT: usize = 5;
/// How a gmsh file begins.
const MESH_OPENING: &[u8] = b"$MeshFormat";

/// Key of the mesh file.
pub const MESH_FILE: &str = "mesh.file";
/// Tables whose keys can be swept.
pub const SWEPT: &[&str] = &[
    "bearing",
    "bore",
    "shaft",
    "mesh",
    "ends",
    "feed",
    "journal",
    "load",
    "crank",
    "orbit",
    "support",
    "oil",
    "heat",
    "limits",
    "criteria",
    "cavitation",
    "contact",
    "roughness",
    "turbulence",
    "liner",
    "dynamics",
];
/// Tables of a crankshaft whose keys can be swept.
pub const SWEPT_OF_SHAFT: [&str; 3] = ["crankshaft", "crank", "orbit"];
/// Checks of keys that must fit each other, table by table.
const CHECKS: &[Check] = &[
    bearing::check,
    bore::check,
    feed::check,
    journal::check,
    load::check,
    orbit::check,
    support::check,
    oil::check,
    heat::check,
    criteria::check,
    cavitation::check,
    crate::contact::check,
    roughness::check,
    turbulence::check,
    crate::liner::check,
    design::check,
];

/// One bearing, as its scene describes it, in SI. Whatever is `None` is not simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Title of the study; the name of the file where the scene gives none.
    pub title: String,
    /// The liner.
    pub bearing: BearingTable,
    /// Shapes of the bore, whose depths add up; none of a circle.
    pub bores: Vec<Bore>,
    /// The shape of the journal; `None`: a cylinder.
    pub shaft: Option<JournalShape>,
    /// Origin of the mesh.
    pub mesh: MeshSource,
    /// How small error bars must become by refinement of that mesh; `None`: it is used as it is.
    pub tolerance: Option<Tolerance>,
    /// The open ends.
    pub ends: Ends,
    /// Regions of given pressure, in the order of the scene.
    pub feeds: Vec<Feed>,
    /// The journal and where it is.
    pub journal: Journal,
    /// Axial position at which the load acts [m]; `None`: the scene gives none.
    pub load_at: Option<f64>,
    /// Moment on the journal beside that of the load at its place [N m]; `None`: the scene gives none.
    pub load_moment: Option<[f64; 2]>,
    /// How the load changes over a cycle; `None`: it does not, or the position is given.
    pub load_cycle: Option<LoadCycle>,
    /// The crank whose rod holds the shell; `None`: the shell is at rest.
    pub crank: Option<CrankTable>,
    /// How the path of the journal is followed over a cycle; `None`: it is not.
    pub orbit: Option<OrbitTable>,
    /// What holds the shaft against its tilt; `None`: nothing.
    pub support: Option<Support>,
    /// The oil.
    pub oil: OilTable,
    /// The balance that finds the temperature of the film; `None`: it is given, or has no effect.
    pub heat: Option<Heat>,
    /// What the bearing is judged by.
    pub criteria: Criteria,
    /// What happens where the film would break; `None`: a full film, whatever its pressure.
    pub cavitation: Option<CavitationTable>,
    /// Contact of rough surfaces; `None`: they do not touch.
    pub contact: Option<crate::ContactTable>,
    /// How roughness changes the flow of oil; `None`: the surfaces are smooth.
    pub roughness: Option<Roughness>,
    /// How a turbulent film resists; `None`: the film is laminar.
    pub turbulence: Option<Turbulence>,
    /// How the wall gives way to the pressure; `None`: it is rigid.
    pub liner: Option<crate::Liner>,
    /// What is asked about small motions of the journal; `None`: nothing.
    pub dynamics: Option<DynamicsTable>,
    /// The cap of the connecting rod whose bearing this is; nothing of the film depends on it.
    pub cap: Option<Cap>,
    /// The cases that `oilwedge sweep` makes of it; nothing else reads them.
    pub sweep: Option<Plan>,
    /// What `oilwedge design` chooses; nothing else reads it.
    pub design: Option<crate::Design>,
    /// Tolerances of its numbers, which are the nominal ones, in the order of the text; empty where it has none.
    pub tolerances: Vec<KeyTolerance>,
    /// All numbers that may have tolerances, in the order of the text; without one the width is zero.
    pub inputs: Vec<KeyTolerance>,
    /// Where it stands, or would stand: relative files count from its folder.
    pub path: PathBuf,
    /// The text that was read; empty in a case of a sweep.
    pub text: String,
    /// SHA-256 of the scene's text, 64 hexadecimal digits; empty in a case of a sweep.
    pub sha256: String,
}

impl Scene {
    /// Reads the scene in the file `path`; `checks` follow those of ranges and of keys that must fit each other.
    ///
    /// # Errors
    /// [`SceneError`]: the file cannot be read, is no TOML, or is no scene that can be computed; in the last two
    /// cases everything that is wrong is reported at once.
    pub fn read(path: &Path, checks: &[Check]) -> Result<Self, SceneError> {
        Self::of_text(&text_of(path)?, path, mesh::no_file, checks)
    }

    /// Numbers by which quantities are differentiated: those with tolerances, and with `all` every one. A number of a
    /// cycle needs two cycles more: those with tolerances have them where `all` asks for that, the others never.
    pub fn differentiated(&self, all: bool) -> &[KeyTolerance] {
        match (self.orbit.is_some(), all) {
            (true, false) => &[],
            (false, true) => &self.inputs,
            _ => &self.tolerances,
        }
    }

    /// Reads the scene `text`; a relative mesh file counts from the folder of `path`, whose name is the title where the
    /// scene gives none. Nothing is read from the disk, and the mesh need not exist.
    ///
    /// # Errors
    /// [`SceneError::Syntax`] and [`SceneError::Complaints`], with everything that is wrong.
    pub fn parse(text: &str, path: &Path, checks: &[Check]) -> Result<Self, SceneError> {
        Self::of_text(text, path, |_| None, checks)
    }

    /// Whether it gives a tolerance, and not only has the usual one.
    pub fn gives_tolerance(&self) -> bool {
        (self.tolerance.as_ref()).is_some_and(|tolerance| *tolerance != Tolerance::Usual)
    }

    /// The files that it names: key, path, and what to give where there is none.
    pub fn files(&self) -> impl Iterator<Item = (Cow<'static, str>, &Path, &'static str)> {
        const TABLE: &str = "give the path of a table with a header of units, counted from the folder of the scene";
        const MATRIX: &str = "give the path of a table of a matrix, counted from the folder of the scene";
        let mesh = "give the path of a gmsh 4.1 file, counted from the folder of the scene";
        let load = match self.load_cycle.as_ref().map(|cycle| &cycle.source) {
            Some(LoadSource::File { path, .. }) => Some(path.as_path()),
            _ => None,
        };
        let gas = self.crank.as_ref().and_then(CrankTable::gas_file);
        let shaft = match &self.shaft {
            Some(JournalShape::Measured(path)) => Some(path.as_path()),
            _ => None,
        };
        let bores = self.bores.iter().enumerate().filter_map(|(index, bore)| {
            let (key, path) = bore.file()?;
            Some((Cow::Owned(format!("bore[{index}].{key}")), path, TABLE))
        });
        let files = [
            (MESH_FILE, self.mesh.path(), mesh),
            ("load.file", load, TABLE),
            ("crank.gas.file", gas, TABLE),
            ("shaft.file", shaft, TABLE),
            ("liner.compliance.file", self.liner.as_ref().and_then(crate::Liner::file), MATRIX),
        ];
        files.into_iter().filter_map(|(key, path, help)| Some((Cow::Borrowed(key), path?, help))).chain(bores)
    }

    /// What is wrong with a scene that was made of another one.
    pub fn complaints(&self, checks: &[Check]) -> Vec<Complaint> {
        let mut complaints = Complaints::default();
        self.check(&mut complaints, checks);
        complaints.into_list()
    }

    fn check(&self, complaints: &mut Complaints, checks: &[Check]) {
        let names = self.feeds.iter().enumerate();
        complaints.name(names.map(|(index, feed)| (format!("feed[{index}]"), feed.group.clone())));
        CHECKS.iter().chain(checks).for_each(|check| check(self, complaints));
    }

    /// `no_file` says why a file that the scene names cannot be read.
    fn of_text(
        text: &str,
        path: &Path,
        no_file: impl Fn(&Path) -> Option<String>,
        checks: &[Check],
    ) -> Result<Self, SceneError> {
        let document = parsed(text, path)?;
        if ShaftScene::is_meant(document.get_ref()) {
            return Err(SceneError::Crankshaft { path: path.to_path_buf() });
        }
        let read = Self::of_document(document.get_ref(), text, path, no_file, checks);
        let at_ends = read.and_then(|scene| {
            let ends = key_tolerance::complaints_at_ends(&scene, text, checks);
            let bounds = design::complaints_at_bounds(&scene, text, checks);
            match [ends, bounds].concat() {
                none if none.is_empty() => Ok(scene),
                complaints => Err(complaints),
            }
        });
        match at_ends {
            Ok(scene) => Ok(Self {
                text: text.to_owned(),
                sha256: Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect(),
                ..scene
            }),
            Err(complaints) => {
                Err(SceneError::Complaints { path: path.to_path_buf(), text: text.to_owned(), complaints })
            }
        }
    }

    /// The scene that a document makes, whose values stand in `text`; or everything that is wrong with it.
    pub(crate) fn of_document(
        document: &DeTable<'_>,
        text: &str,
        path: &Path,
        no_file: impl Fn(&Path) -> Option<String>,
        checks: &[Check],
    ) -> Result<Self, Vec<Complaint>> {
        let complaints = RefCell::new(Complaints::new(text));
        let mut scene = read(TableReader::root(&complaints, document, catalogue::row), text, path);
        let mut complaints = complaints.into_inner();
        let inputs = std::mem::take(&mut complaints.inputs);
        scene.inputs = key_tolerance::named(inputs, &scene, &mut complaints);
        scene.tolerances = scene.inputs.iter().filter(|input| input.half_width > 0.0).cloned().collect();
        scene.check(&mut complaints, checks);
        for (key, path, help) in scene.files() {
            let is_named = complaints.has(&key) && !complaints.concern(&key);
            if let Some(message) = no_file(path).filter(|_| is_named) {
                complaints.add(&key, message, help);
            }
        }
        match complaints.into_list() {
            complaints if complaints.is_empty() => Ok(scene),
            complaints => Err(complaints),
        }
    }
}

/// The text of the scene in the file `path`.
///
/// # Errors
/// [`SceneError`]: the file cannot be read, or is no text.
pub(crate) fn text_of(path: &Path) -> Result<String, SceneError> {
    let path_buf = || path.to_path_buf();
    let fail = |source| SceneError::Read { path: path_buf(), source };
    if !std::fs::metadata(path).map_err(fail)?.is_file() {
        return Err(SceneError::NotAFile { path: path_buf() });
    }
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(fail)?;
    file.take(SCENE_LIMIT + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() as u64 > SCENE_LIMIT {
        return Err(SceneError::TooLarge { path: path_buf(), limit: SCENE_LIMIT });
    }
    if bytes.starts_with(MESH_OPENING) {
        return Err(SceneError::Mesh { path: path_buf() });
    }
    String::from_utf8(bytes)
        .map_err(|error| SceneError::NotText { path: path_buf(), offset: error.utf8_error().valid_up_to() })
}

/// The TOML document that a text is.
///
/// # Errors
/// [`SceneError::Syntax`]: it is none.
pub(crate) fn parsed<'a>(text: &'a str, path: &Path) -> Result<toml::Spanned<DeTable<'a>>, SceneError> {
    let (document, faults) = DeTable::parse_recoverable(text);
    match faults.is_empty() {
        true => Ok(document),
        false => Err(SceneError::Syntax {
            path: path.to_path_buf(),
            text: text.to_owned(),
            complaints: in_order(faults.iter().take(FAULT_LIMIT).map(fault).collect()),
        }),
    }
}

/// The scene as far as it can be read: numbers that were refused are NaN, and texts empty.
pub(crate) fn read(mut root: TableReader<'_>, text: &str, path: &Path) -> Scene {
    let stem = || path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let load = root.table_if_given("load").map(|table| load::read(table, path));
    let journal = match load {
        Some(_) => "[journal] with speed",
        None => "[journal] with speed, eccentricity and min_film_angle",
    };
    let (heat, in_heat) = root.table_if_given("heat").map(heat::read).unzip();
    let limits = root.table_if_given("limits").map(limits::read).unwrap_or_default();
    let criteria = root.table_if_given("criteria").map(criteria::read).unwrap_or_default();
    let temperature = heat.is_none().then_some("\"80 C\", or a table [heat] that finds it");
    let engine = heat.and_then(|heat| heat.engine);
    let usual_ratio = engine.map(|engine| EngineKind::middle(engine.clearance_ratio()));
    let usual_pressure = engine.map(|engine| EngineKind::middle(engine.feed_pressure()));
    let orbit = root.table_if_given("orbit").map(orbit::read);
    let (mesh, tolerance) = mesh::read(root.table_if_given("mesh"), path);
    // The mesh of an orbit is not refined.
    let tolerance = tolerance.filter(|_| orbit.is_none());
    let feeds = root.tables("feed").into_iter();
    let bores = root.tables("bore").into_iter();
    Scene {
        title: wording::title(&root.text_if_given("title").unwrap_or_else(stem)),
        bearing: bearing::read(root.table("bearing", "[bearing] with diameter, length and clearance"), usual_ratio),
        bores: bores.map(|table| bore::read(table, path)).collect(),
        shaft: root.table_if_given("shaft").map(|table| shaft::read(table, path)),
        mesh,
        tolerance,
        ends: root.table_if_given("ends").map_or(Ends::default(), ends::read),
        feeds: feeds.map(|table| feed::read(table, usual_pressure)).collect(),
        journal: journal::read(root.table("journal", journal), load.as_ref().map(|load| load.position)),
        load_at: load.as_ref().and_then(|load| load.at),
        load_moment: load.as_ref().and_then(|load| load.moment),
        crank: root
            .table_if_given("crank")
            .map(|table| crank::read(table, path, load.as_ref().and_then(|load| load.cycle.as_ref()))),
        load_cycle: load.and_then(|load| load.cycle),
        orbit,
        support: root.table_if_given("support").map(support::read),
        oil: oil::read(root.table("oil", "[oil] with viscosity = \"40 mPa.s\""), temperature),
        heat,
        criteria: criteria.or(limits).or(in_heat.unwrap_or_default()),
        cavitation: root.table_if_given("cavitation").and_then(cavitation::read),
        contact: root.table_if_given("contact").and_then(crate::contact::read),
        roughness: root.table_if_given("roughness").and_then(roughness::read),
        turbulence: root.table_if_given("turbulence").and_then(turbulence::read),
        liner: root.table_if_given("liner").and_then(|table| crate::liner::read(table, path)),
        dynamics: root.table_if_given("dynamics").map(dynamics::read),
        cap: root.table_if_given("cap").map(cap::read),
        sweep: root.table_if_given("sweep").map(|table| sweep::plan(table, &sweep::OF_BEARING, text, path)),
        design: root.table_if_given("design").and_then(design::read),
        inputs: Vec::new(),
        tolerances: Vec::new(),
        path: path.to_owned(),
        text: String::new(),
        sha256: String::new(),
    }
}

fn fault(error: &toml::de::Error) -> Complaint {
    Complaint {
        key: String::new(),
        value: String::new(),
        message: error.message().to_owned(),
        help: "a scene is TOML: [table] lines, and key = \"value with unit\" lines below them".to_owned(),
        span: error.span(),
    }
}

#[cfg(test)]
pub(crate) mod tests;
