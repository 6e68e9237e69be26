//! The page `docs/validation/random_bearings.md`: how random bearings end.

use oilwedge_study::result::Status;
use serde_json::{Value, json};

use crate::performance::clock::timed;
use crate::random_tilted::{Fault, TiltedBearing, Tilting, left, solved};
use crate::tables::{head, replace};

/// Longest time of a run on one thread, of the processor [s].
pub const LONGEST: f64 = 10.0;

/// How the run of one bearing ended.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// The bearing.
    pub bearing: TiltedBearing,
    /// How it ended.
    pub status: Status,
    /// Why it has no answer.
    pub reason: String,
    /// What a run may not do.
    pub fault: Option<Fault>,
    /// What is left of the balances of force and moment, the greater one.
    pub left: f64,
    /// Processor time [s].
    pub seconds: f64,
}

impl Outcome {
    /// The outcome of a bearing.
    pub fn of(bearing: TiltedBearing) -> Self {
        let ((result, fault), spent) = timed(|| solved(&bearing));
        Self {
            bearing,
            status: result.head.status,
            left: left(&result),
            reason: result.head.reason.unwrap_or_default(),
            fault,
            seconds: spent.cpu,
        }
    }

    /// The outcome as JSON, without the bearing.
    pub fn to_json(&self) -> Value {
        json!({
            "status": self.status.name(),
            "reason": self.reason,
            "fault": self.fault.as_ref().map(|fault| &fault.what),
            "left": self.left,
            "seconds": self.seconds,
        })
    }

    /// The outcome of a bearing in what [`Self::to_json`] wrote; none where it is something else.
    pub fn from_json(bearing: TiltedBearing, written: &Value) -> Option<Self> {
        let statuses = [Status::Converged, Status::NoSolution, Status::NotConverged];
        let number = bearing.number;
        Some(Self {
            status: statuses.into_iter().find(|status| written["status"] == status.name())?,
            reason: written["reason"].as_str()?.to_owned(),
            fault: written["fault"].as_str().map(|what| Fault { number, what: what.to_owned() }),
            left: written["left"].as_f64()?,
            seconds: written["seconds"].as_f64()?,
            bearing,
        })
    }

    /// Whether it took longer than [`LONGEST`].
    pub fn is_slow(&self) -> bool {
        self.seconds > LONGEST
    }

    /// One line for people; nothing where all is well.
    pub fn told(&self) -> Option<String> {
        let Self { bearing, seconds, .. } = self;
        let fault = match &self.fault {
            Some(fault) => format!(" FAULT {}", fault.what),
            None if self.status != Status::Converged => format!(" {}: {}", self.status.name(), self.reason),
            None if self.is_slow() => String::new(),
            None => return None,
        };
        let slow = if self.is_slow() { " SLOW" } else { "" };
        let TiltedBearing { number, tilting, model, .. } = bearing;
        Some(format!("{number} {tilting:?} {model} {seconds:.1} s{slow}{fault}"))
    }
}

/// How the reason of a run without an answer begins, and what a user can do.
const REASONS: [(&str, &str); 4] = [
    ("no position of the journal", "a lower load, a wider or longer bearing, more viscous oil"),
    ("no position and tilt", "the load nearer to the middle, a lower moment, a support"),
    ("limit: ", "`--max-seconds`, or a wider `mesh.tolerance`"),
    ("not converged: ", "another `mesh.size`; the film at a given position shows what hinders it"),
];

/// The page with its tables written anew, of bearings with rigid and with elastic walls.
pub fn page(written: &str, rigid: &[Outcome], elastic: &[Outcome]) -> String {
    let written =
        replace(written, "ends", &ends(&[("rigid, round, smooth", rigid), ("elastic, rough, worn", elastic)]));
    let all: Vec<&Outcome> = rigid.iter().chain(elastic).collect();
    replace(&written, "reasons", &reasons(&all))
}

/// Which tilts are counted together, and their name.
const KINDS: [(&[Tilting], &str); 3] = [
    (&[Tilting::Given], "position and tilt given"),
    (&[Tilting::Held], "position found under a load"),
    (&[Tilting::Free, Tilting::Supported], "position and tilt found"),
];

fn ends(groups: &[(&str, &[Outcome])]) -> Vec<Vec<String>> {
    let mut rows = vec![head(
        "bearings | asked | number | converged | no solution, with the reason | not converged | \
         greatest balance left | seconds: half below | nine of ten below | longest",
    )];
    for (group, outcomes) in groups {
        for (tilts, asked) in KINDS {
            let of = outcomes.iter().filter(|outcome| tilts.contains(&outcome.bearing.tilting));
            rows.push(counted(group, asked, &of.collect::<Vec<_>>()));
        }
    }
    let all = groups.iter().flat_map(|(_, outcomes)| *outcomes);
    rows.push(counted("all", "", &all.collect::<Vec<_>>()));
    rows
}

fn counted(group: &str, asked: &str, of: &[&Outcome]) -> Vec<String> {
    let count = |status| of.iter().filter(|outcome| outcome.status == status).count().to_string();
    let converged = of.iter().filter(|outcome| outcome.status == Status::Converged);
    let left = converged.fold(0.0, |most: f64, outcome| most.max(outcome.left));
    let mut seconds: Vec<f64> = of.iter().map(|outcome| outcome.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    let below = |part: f64| seconds.get((part * (seconds.len() as f64 - 1.0)).round() as usize).copied();
    let mut row = [group, asked].map(str::to_owned).to_vec();
    row.extend([
        of.len().to_string(),
        count(Status::Converged),
        count(Status::NoSolution),
        count(Status::NotConverged),
        format!("{left:.0e}"),
    ]);
    row.extend([0.5, 0.9, 1.0].map(|part| format!("{:.1}", below(part).unwrap_or_default())));
    row
}

/// How often each reason is given; those that are not in the list are written out.
fn reasons(outcomes: &[&Outcome]) -> Vec<Vec<String>> {
    let mut rows = vec![head("the reason begins with | bearings | way out")];
    let without = outcomes.iter().filter(|outcome| outcome.status != Status::Converged);
    let (known, others): (Vec<&Outcome>, Vec<&Outcome>) =
        without.partition(|outcome| REASONS.iter().any(|(begin, _)| outcome.reason.starts_with(begin)));
    for (begin, way_out) in REASONS {
        let number = known.iter().filter(|outcome| outcome.reason.starts_with(begin)).count();
        rows.push(vec![format!("`{}`", begin.trim()), number.to_string(), way_out.to_owned()]);
    }
    rows.extend(others.iter().map(|outcome| vec![outcome.reason.clone(), "1".to_owned(), String::new()]));
    rows
}
