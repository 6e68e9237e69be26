//! The pages `docs/validation/tilted_bearings.md` and `elastic_bearings.md`: how random bearings whose journal tilts
//! end.

use oilwedge_study::result::Status;
use serde_json::{Value, json};

use crate::performance::clock::timed;
use crate::random_tilted::{Fault, TiltedBearing, Tilting, left, solved};
use crate::tables::{head, replace, row};

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

/// The page with its tables written anew.
pub fn page(written: &str, outcomes: &[Outcome]) -> String {
    let written = replace(written, "ends", &ends(outcomes));
    let (mut slow, mut answers) = (outcomes.to_vec(), outcomes.to_vec());
    slow.retain(Outcome::is_slow);
    slow.sort_by(|a, b| b.seconds.total_cmp(&a.seconds));
    answers.retain(|outcome| outcome.status != Status::Converged);
    let written = replace(&written, "slow", &listed(&slow));
    replace(&written, "without an answer", &listed(&answers))
}

fn ends(outcomes: &[Outcome]) -> Vec<Vec<String>> {
    let mut rows = vec![head(
        "tilt | bearings | converged | no solution, with the reason | not converged | \
         greatest balance left | seconds, median | longest",
    )];
    let kinds = [
        (Some(Tilting::Given), "position and tilt given"),
        (Some(Tilting::Held), "tilt given, position found"),
        (Some(Tilting::Free), "found under a load off the middle or a moment"),
        (Some(Tilting::Supported), "found against a support"),
        (None, "all"),
    ];
    for (kind, name) in kinds {
        let of: Vec<&Outcome> =
            (outcomes.iter()).filter(|outcome| kind.is_none_or(|kind| outcome.bearing.tilting == kind)).collect();
        let count = |status| of.iter().filter(|outcome| outcome.status == status).count().to_string();
        let converged = of.iter().filter(|outcome| outcome.status == Status::Converged);
        let left = converged.fold(0.0, |most: f64, outcome| most.max(outcome.left));
        let mut seconds: Vec<f64> = of.iter().map(|outcome| outcome.seconds).collect();
        seconds.sort_by(f64::total_cmp);
        rows.push(vec![
            name.to_owned(),
            of.len().to_string(),
            count(Status::Converged),
            count(Status::NoSolution),
            count(Status::NotConverged),
            format!("{left:.0e}"),
            format!("{:.1}", seconds.get(seconds.len() / 2).copied().unwrap_or_default()),
            format!("{:.1}", seconds.last().copied().unwrap_or_default()),
        ]);
    }
    rows
}

/// A row for each bearing.
fn listed(outcomes: &[Outcome]) -> Vec<Vec<String>> {
    let mut rows = vec![row(["bearing", "tilt", "cavitation", "seconds", "end"])];
    for outcome in outcomes {
        let TiltedBearing { number, tilting, model, .. } = &outcome.bearing;
        rows.push(vec![
            number.to_string(),
            format!("{tilting:?}").to_lowercase(),
            (*model).to_owned(),
            format!("{:.1}", outcome.seconds),
            match outcome.status {
                Status::Converged => "converged".to_owned(),
                Status::NoSolution | Status::NotConverged => outcome.reason.clone(),
            },
        ]);
    }
    rows
}
