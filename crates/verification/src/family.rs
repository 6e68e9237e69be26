//! A family of hard cases: one TOML file with a scene, and series of cases that each change something of it.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::{Table, Value};

/// Cases that are hard for one reason.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Family {
    /// What is hard.
    pub title: String,
    /// Why these cases, and where they come from.
    pub reason: String,
    /// What every case begins from.
    pub scene: Table,
    /// The cases.
    pub series: Vec<CaseSeries>,
}

/// Cases that differ in one thing.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseSeries {
    /// What they are.
    pub name: String,
    /// Why they are there, or their source.
    pub why: String,
    /// True for cases that take long: `verify --hard` solves each alone and on all threads, the tests do not.
    #[serde(default)]
    pub long: bool,
    /// Keys of the scene, with dots, and their values here.
    #[serde(default)]
    pub set: Table,
    /// Keys of the scene that are not there.
    #[serde(default)]
    pub without: Vec<String>,
    /// The mesh file of the scene is made so.
    pub mesh: Option<MeshRecipe>,
    /// The series is one case; or the same case for several values.
    pub vary: Option<Vary>,
    /// Cases that are named; they may stand in place of an axis.
    #[serde(default)]
    pub variants: Vec<CaseVariant>,
    /// How each case must end.
    #[serde(default)]
    pub expect: Expect,
    /// Words that the reason of an end without an answer, or a warning, must hold.
    pub says: Option<String>,
    /// Quantities that rise or fall from case to case.
    #[serde(default)]
    pub trend: BTreeMap<String, Trend>,
    /// Quantities that are the same in all cases, and to which relative difference.
    #[serde(default)]
    pub same: BTreeMap<String, f64>,
    /// What stands against each answer.
    #[serde(default)]
    pub against: SecondMethod,
    /// Quantities that a closed form or another source gives, with the relative difference allowed.
    #[serde(default)]
    pub known: BTreeMap<String, KnownValue>,
}

/// One thing that changes in a series.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub enum Vary {
    /// A key takes these values.
    Key {
        /// The key, with dots.
        key: String,
        /// Values of the key.
        values: Vec<Value>,
    },
    /// The coefficient alpha of a viscosity law is this part of the greatest one that has a film.
    OfLimit {
        /// The parts [1].
        of_limit: Vec<f64>,
        /// The law.
        #[serde(flatten)]
        law: LimitedLaw,
    },
}

/// A viscosity law with a coefficient alpha [1/Pa], up to which there is a film.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize)]
pub struct LimitedLaw {
    /// Table of the law in the scene.
    pub law: String,
    /// Form of the equation: `conservative` or `as-printed`.
    pub form: LawForm,
}

/// Form of the equation with a viscosity law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LawForm {
    /// The viscosity under the divergence; its limit is the reciprocal of the greatest pressure of the oil without it.
    Conservative,
    /// The study's own equation; its limit is the fold, found by halving.
    AsPrinted,
}

impl LawForm {
    /// Name of the law as the scene has it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Conservative => "conservative",
            Self::AsPrinted => "as-printed",
        }
    }
}

/// A case with a name of its own.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseVariant {
    /// Name of the variant.
    pub name: String,
    /// Further keys of the scene, with dots.
    #[serde(default)]
    pub set: Table,
    /// Mesh file of the variant, where it is not that of the series.
    pub mesh: Option<MeshRecipe>,
    /// Expected end of the variant, where it is not that of the series.
    pub expect: Option<Expect>,
    /// Words of the variant's message, where they are not those of the series.
    pub says: Option<String>,
}

/// How a mesh file is made: triangles of the liner, and where in space they lie.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MeshRecipe {
    /// Rows of rectangles, each cut into two triangles; absent: the liner of the scene is meshed.
    pub rows: Option<Rows>,
    /// True: the nodes lie on the cylinder; false: in the plane.
    #[serde(default)]
    pub cylinder: bool,
    /// Turns about x, then y, then z [deg], after the shift.
    #[serde(default)]
    pub turn: [f64; 3],
    /// Shift [m].
    #[serde(default)]
    pub shift: [f64; 3],
    /// Unit of its lengths, as `[mesh] unit` has it.
    #[serde(default = "metre")]
    pub unit: String,
}

fn metre() -> String {
    "m".to_owned()
}

/// A liner in rows and columns.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rows {
    /// Rectangles around.
    pub around: u32,
    /// Rectangles along the axis.
    pub along: u32,
    /// Factor by which widths shrink from the rims to the middle of the liner, where the narrowest lie.
    #[serde(default = "one")]
    pub jump: f64,
}

fn one() -> f64 {
    1.0
}

/// How a case must end.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Expect {
    /// The case ends with an answer.
    #[default]
    Converged,
    /// The case has no solution.
    NoSolution,
    /// One was not reached.
    NotConverged,
    /// The scene or its mesh is refused.
    Refused,
}

impl Expect {
    /// Name of the end as results and pages have it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::NoSolution => "no_solution",
            Self::NotConverged => "not_converged",
            Self::Refused => "refused",
        }
    }
}

/// Direction in which a quantity goes from case to case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Trend {
    /// Each value is greater than that before.
    Rises,
    /// Each value is less.
    Falls,
}

/// What stands against an answer.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SecondMethod {
    /// The scene on a finer mesh, to a quarter of the error bar of the load.
    #[default]
    Finer,
    /// The scene with other keys (and without some), and how far both may differ beside their bars.
    Other(Other),
    /// The answers are held against known values alone.
    Known,
}

/// A scene that must give the same answer.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Other {
    /// What it is.
    pub name: String,
    /// Keys of the scene, with dots.
    #[serde(default)]
    pub set: Table,
    /// Keys that are not there.
    #[serde(default)]
    pub without: Vec<String>,
    /// Relative difference allowed beside the bars, by quantity; only these are compared.
    pub quantities: BTreeMap<String, f64>,
}

/// A value that is known.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KnownValue {
    /// The value, SI (angles in degrees).
    pub value: Option<f64>,
    /// The closed form that gives the value, where none is written.
    pub form: Option<ClosedForm>,
    /// Relative difference allowed: how well the value or the form holds here.
    pub to: f64,
}

/// Closed forms of the Sommerfeld number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ClosedForm {
    /// Infinitely long bearing, full film.
    Sommerfeld,
    /// Infinitely short bearing, full film.
    Ocvirk,
    /// Infinitely short bearing, half film.
    OcvirkHalf,
}
