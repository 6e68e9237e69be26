//! How a position is sought.

use oilwedge_reynolds::CentreVelocity;
use oilwedge_reynolds::solve::Neighbour;

use crate::Deadline;
use crate::Heated;
use crate::SearchObserver;
use crate::Waypoint;
use crate::equilibrium::{BALANCED, ROUGHLY_BALANCED};

/// A balance sought from nearby is found at this difference of force and load over the load: another step of Newton's
/// method would leave round-off.
const NEARLY_BALANCED: f64 = 1e-10;

/// Options of [`crate::find`]; by default a centre at rest, no deadline, a cold start and the force of the quadratic
/// film.
#[derive(Debug, Clone, Copy, Default)]
pub struct SearchOptions<'a> {
    /// Velocity of the journal's centre.
    pub centre_velocity: CentreVelocity,
    /// When the search must end; the position reached then is its answer.
    pub deadline: Deadline,
    /// Where the search begins.
    pub guess: InitialGuess<'a>,
    /// The film that carries the load.
    pub carrier: Carrier,
    /// Difference of force and load over the load at which the balance is found; by default near round-off.
    pub accuracy: Option<f64>,
    /// What the balance is for.
    pub purpose: Purpose,
    /// How the temperature of the film is found beside the position; `None`: it is given.
    pub warming: Option<&'a dyn Heated>,
    /// Notified of each position tried.
    pub observer: Option<&'static dyn SearchObserver>,
}

/// Where a search begins.
#[derive(Debug, Clone, Copy, Default)]
pub enum InitialGuess<'a> {
    /// At the position of the problem, improved on coarser meshes, if the system has any.
    #[default]
    Cold,
    /// At the position of the problem, which balances the load roughly, as a coarser mesh has shown; as [`Self::Cold`]
    /// where that leads nowhere.
    NearlyBalanced,
    /// At a balance on the way that a growing moment takes, as another mesh has shown; as [`Self::Cold`] where there is
    /// none near it, or the way from there ends without a reason.
    Along(&'a Waypoint),
    /// At the position of the problem, which a neighbouring operating point suggests; with the film of that point on
    /// the same system, if there is one.
    Near(Neighbour<'a>),
}

/// The film whose force balances the load.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Carrier {
    /// Quadratic elements.
    #[default]
    Quadratic,
    /// Cubic elements; not for models that conserve oil.
    Cubic,
}

/// What a balance is for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Purpose {
    /// The answer on its mesh.
    #[default]
    Answer,
    /// A start on a finer mesh, which shows what a thin film carries: it is not followed into contact under a wall that
    /// gives way.
    Start,
    /// The beginning of a branch of balances, where another one is at hand: the load is not raised to it in parts.
    Branch,
}

impl Purpose {
    /// Purpose of a search on a coarser mesh.
    pub(crate) fn on_coarser(self) -> Self {
        match self {
            Self::Answer | Self::Start => Self::Start,
            Self::Branch => Self::Branch,
        }
    }
}

impl SearchOptions<'_> {
    /// Difference of force and load over the load at which the balance of the quadratic film is found.
    pub(crate) fn balanced(&self) -> f64 {
        self.accuracy.unwrap_or(match (self.carrier, self.guess) {
            (Carrier::Cubic, _) => ROUGHLY_BALANCED,
            (Carrier::Quadratic, InitialGuess::Near(_)) => NEARLY_BALANCED,
            (Carrier::Quadratic, InitialGuess::Cold | InitialGuess::NearlyBalanced | InitialGuess::Along(_)) => {
                BALANCED
            }
        })
    }
}
