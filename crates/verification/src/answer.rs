//! The solver's answer to a case.

use std::path::Path;

use oilwedge_scene::{Scene, SceneError};
use oilwedge_study::effects::Sockets;
use oilwedge_study::result::Status;
use oilwedge_study::{Run, RunOptions, run};
use toml::{Table, Value};

use crate::cases::{Case, put};
use crate::family::{Expect, LawForm, LimitedLaw};
use crate::made_mesh;

/// How a run of a case ended.
#[derive(Debug)]
pub enum CaseAnswer {
    /// A run with a result.
    Run(Box<Run>),
    /// The scene or its mesh was refused, with this message.
    Refused(String),
}

impl CaseAnswer {
    /// How it ended, in one word.
    pub fn end(&self) -> Expect {
        match self {
            Self::Refused(_) => Expect::Refused,
            Self::Run(run) => match run.result.head.status {
                Status::Converged => Expect::Converged,
                Status::NoSolution => Expect::NoSolution,
                Status::NotConverged => Expect::NotConverged,
            },
        }
    }

    /// Value of a quantity, of a film that was found.
    pub fn value(&self, name: &str) -> Option<f64> {
        match self {
            Self::Run(run) => run.result.by_name(name).map(|quantity| quantity.value),
            Self::Refused(_) => None,
        }
    }

    /// Why there is no answer.
    pub fn reason(&self) -> Option<&str> {
        match self {
            Self::Refused(message) => Some(message),
            Self::Run(run) => run.result.head.reason.as_deref(),
        }
    }
}

/// Unknowns of a case whose mesh is refined at most.
const MOST_UNKNOWNS: usize = 60_000;

/// Solves the scene of a table.
pub fn solve(table: &Table) -> CaseAnswer {
    solve_within(table, MOST_UNKNOWNS)
}

/// Solves the scene of a table on meshes of at most so many unknowns; where they do not reach its tolerance, the best
/// of them is the answer.
pub fn solve_within(table: &Table, max_unknowns: usize) -> CaseAnswer {
    let scene = match read(table) {
        Ok(scene) => scene,
        Err(message) => return CaseAnswer::Refused(message),
    };
    let options = RunOptions { max_unknowns, ..RunOptions::default() };
    match run(&scene, &options) {
        Ok(run) => CaseAnswer::Run(Box::new(run)),
        Err(error) => CaseAnswer::Refused(with_causes(&error)),
    }
}

/// What the effects of the scene of a table put into the sockets of its film; `None` where it is refused.
pub fn sockets(table: &Table) -> Option<Sockets> {
    read(table).ok().map(|scene| Sockets::of(&scene))
}

fn read(table: &Table) -> Result<Scene, String> {
    let text = toml::to_string(table).map_err(|error| error.to_string())?;
    oilwedge_study::parse(&text, Path::new("case.toml")).map_err(|error| match error {
        SceneError::Complaints { complaints, .. } | SceneError::Syntax { complaints, .. } => {
            complaints.iter().map(|complaint| format!("{complaint}; {}", complaint.help)).collect::<Vec<_>>().join("\n")
        }
        other => other.to_string(),
    })
}

/// A message with its causes.
fn with_causes(error: &dyn std::error::Error) -> String {
    let mut words = error.to_string();
    let mut cause = error.source();
    while let Some(inner) = cause {
        words += &format!(": {inner}");
        cause = inner.source();
    }
    words
}

/// The scene of a case as it is solved: its mesh file is made in the folder `dir`, and the coefficient of its viscosity
/// law is found.
///
/// # Errors
/// Why it cannot be made, in words.
pub fn prepare(case: &Case, dir: &Path, number: usize) -> Result<Table, String> {
    let mut scene = case.scene.clone();
    if let Some(recipe) = &case.mesh {
        let path = dir.join(format!("{number}.msh"));
        made_mesh::write(recipe, &read(&scene)?, &path)?;
        let path = path.to_str().ok_or("the folder for meshes has a name that is no text")?;
        put(&mut scene, "mesh.file", Value::String(path.to_owned()));
        put(&mut scene, "mesh.unit", Value::String(recipe.unit.clone()));
    }
    if let Some((part, law)) = &case.of_limit {
        let alpha = part * limit(&scene, law)?;
        scene = with_law(&scene, alpha, law);
    }
    Ok(scene)
}

/// A scene with a viscosity law of this coefficient [1/Pa].
pub fn with_law(scene: &Table, alpha: f64, law: &LimitedLaw) -> Table {
    let mut scene = scene.clone();
    let table = [
        ("alpha".to_owned(), Value::String(format!("{alpha} 1/Pa"))),
        ("form".to_owned(), Value::String(law.form.name().to_owned())),
    ];
    put(&mut scene, &law.law, Value::Table(table.into_iter().collect()));
    scene
}

/// Halvings of the interval in which a fold lies.
const HALVINGS: usize = 16;

/// The greatest coefficient [1/Pa] of a viscosity law with a film: the reciprocal of the greatest pressure of the oil
/// without it, or the fold of the as-printed equation, which lies below that.
///
/// # Errors
/// There is no film without it.
pub fn limit(scene: &Table, law: &LimitedLaw) -> Result<f64, String> {
    let plain = solve(scene);
    let pressure = plain.value(oilwedge_study::quantities::PRESSURE_MAX.name).filter(|pressure| *pressure > 0.0);
    let conservative = match pressure {
        Some(pressure) => 1.0 / pressure,
        None => return Err(format!("no film of constant viscosity: {:?}", plain.reason())),
    };
    if law.form == LawForm::Conservative {
        return Ok(conservative);
    }
    let (low, high) = (0..HALVINGS).fold((0.0, conservative), |(low, high), _| {
        let middle = 0.5 * (low + high);
        match solve(&with_law(scene, middle, law)).end() {
            Expect::Converged => (middle, high),
            _ => (low, middle),
        }
    });
    Ok(0.5 * (low + high))
}
