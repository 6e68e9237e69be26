//! Why a run ended short of an answer, a balance or a tolerance: as data, and in words with the way out.
//!
//! Physics errors carry data and name no key and no flag; keys of scenes and flags of the command line stand here
//! alone.

use std::fmt;

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::supply::SupplyError;
use oilwedge_scene::wording::{factor, percent};

/// Ways out that are flags of the command line.
pub mod flags {
    /// Way out of searches and refinements that end with the time.
    pub const MORE_SECONDS: &str = "give --max-seconds a higher limit";
    /// Way out of refinements that end with the size.
    pub const MORE_UNKNOWNS: &str = "give --max-unknowns a higher limit";
}
use flags::{MORE_SECONDS, MORE_UNKNOWNS};

/// Force and load that differ by less than this part of the load are balanced.
const BALANCED: f64 = 1e-10;

/// Why a run ended short of its tolerance or of a balance.
#[derive(Debug, Clone, PartialEq)]
pub enum Limit {
    /// The film jumps as its temperature changes: this part of the friction is not carried off.
    Jump(f64),
    /// The search for the temperature was ended where this part of the friction was not carried off.
    Temperature(f64, Cause),
    /// The search for the position was ended where force and load differed by this part of the load.
    Position(f64, Cause),
    /// The last of this many cycles ended this far from where it began, over the clearance.
    NotClosed(usize, f64),
    /// The last of this many cycles of a rotor of this mass [kg], which do not end nearer to where they began, closed
    /// to this part of the clearance.
    Whirl(usize, f64, f64),
    /// The last of this many cycles closed to this part of the clearance, and this part of the load turns at half the
    /// speed of the journal.
    Collapse(usize, f64, f64),
    /// The last of this many cycles of a journal that does not turn closed to this part of the clearance, and this part
    /// of the load keeps its direction, over the mean magnitude.
    Sinking(usize, f64, f64),
    /// The orbit was ended at this crank angle [deg] of its first cycle.
    FirstCycle(f64, Cause),
    /// The search for a first position was ended, where the nearest force and the load are these [N].
    FirstPosition([f64; 2], Cause),
    /// The search for a temperature was ended before a first one was solved.
    FirstTemperature(Cause),
    /// The run was ended before the film on its first mesh, of so many unknowns.
    FirstMesh(usize, Cause),
    /// The orbit was ended after so many complete cycles, the last of which closed to this part of the clearance.
    Orbit(usize, f64, Cause),
    /// The next mesh was not finished after so many seconds.
    Unfinished(Distance, f64, Cause),
    /// The next mesh would need too many unknowns.
    Unknowns {
        /// How far the tolerance is.
        distance: Distance,
        /// Unknowns wanted.
        wanted: f64,
        /// Unknowns allowed.
        most: usize,
    },
    /// The next mesh would take too long.
    Seconds {
        /// How far the tolerance is.
        distance: Distance,
        /// Seconds so far, and seconds of the next mesh [s].
        seconds: [f64; 2],
        /// What does not allow them.
        cause: Cause,
    },
    /// This number of meshes was refined, the most there may be.
    Meshes(Distance, usize),
    /// A round rim of the mesh is too coarse to be divided.
    CoarseRim,
    /// The next mesh has no answer, for this reason.
    NoAnswer(String),
    /// The limit was met on a mesh whose bars are wider than those of the mesh before, which is reported.
    Before(Box<Limit>, Distance),
}

/// What ended a search or a refinement.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Cause {
    /// An interrupt.
    Interrupt,
    /// A limit of so many seconds [s] that the caller gave.
    GivenLimit(f64),
    /// The usual limit of so many seconds [s], which nobody gave.
    UsualLimit(f64),
}

impl Cause {
    /// The sentence of a search that was ended, with its cause and the way out.
    pub(crate) fn ends(self, search: &str) -> String {
        match self {
            Self::Interrupt => format!("interrupted: {search}"),
            Self::GivenLimit(_) | Self::UsualLimit(_) => format!("limit: {search}, by {self}; {MORE_SECONDS}"),
        }
    }
}

impl fmt::Display for Cause {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Interrupt => write!(out, "an interrupt"),
            Self::GivenLimit(seconds) => write!(out, "--max-seconds {seconds}"),
            Self::UsualLimit(seconds) => write!(out, "the usual limit of {seconds} s of processor time"),
        }
    }
}

/// How far a tolerance is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Distance {
    /// Greatest bar over what it may be; infinite where the mesh does not resolve the film.
    pub worst: f64,
    /// Unknowns of the mesh.
    pub unknowns: usize,
    /// Whether the scene gives no tolerance, so that the usual one holds.
    pub is_usual: bool,
}

impl Distance {
    /// What a user may give in place of a higher limit.
    fn way_out(&self) -> &'static str {
        match self.is_usual {
            true => "mesh.tolerance or mesh.size",
            false => "a wider tolerance",
        }
    }
}

impl fmt::Display for Distance {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.worst.is_finite() {
            return write!(out, "the mesh does not resolve the film yet");
        }
        let asked = match self.is_usual {
            true => "the usual tolerance",
            false => "asked for",
        };
        write!(out, "the bars are {} times as wide as {asked}", factor(self.worst))
    }
}

impl fmt::Display for Limit {
    // Long: a sentence for each limit.
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ended = |out: &mut fmt::Formatter<'_>, search: String, cause: Cause| out.write_str(&cause.ends(&search));
        match self {
            Self::Jump(left_over) => write!(
                out,
                "not converged: the film jumps as its temperature changes, and friction and heat carried off still differ by {left_over:.1e} of the friction; give another mesh ([mesh] size)"
            ),
            Self::Temperature(left_over, cause) => ended(
                out,
                format!(
                    "the search for the temperature was ended where friction and heat carried off differ by {left_over:.1e} of the friction"
                ),
                *cause,
            ),
            Self::Position(residual, cause) if *residual < BALANCED => ended(
                out,
                "the search for the position was ended where force and load are balanced, but the film has not settled there yet".to_owned(),
                *cause,
            ),
            Self::Position(residual, cause) => ended(
                out,
                format!(
                    "the search for the position was ended where force and load differ by {residual:.1e} of the load"
                ),
                *cause,
            ),
            Self::NotClosed(cycles, closure) => write!(
                out,
                "not closed after {cycles} {}: the last one ended {closure:.1e} of the clearance from where it began; the same command goes on from there, or give orbit.cycles a higher limit, or a greater orbit.closure",
                if *cycles == 1 { "cycle" } else { "cycles" }
            ),
            Self::Whirl(cycles, closure, mass) => write!(
                out,
                "whirl: cycles do not close, and come no nearer to it: the last of {cycles} ended {closure:.1e} of the clearance from where it began; the rotor of {mass} kg whirls, for it is heavier than that with which its equilibrium is stable ([dynamics] of the mean load gives the critical mass); give a smaller orbit.mass, a greater load or thinner oil"
            ),
            Self::Collapse(cycles, closure, share) => write!(
                out,
                "collapse: {} of the load turns at half the speed of the journal, where a film carries nothing at rest with the load, and the journal nears the liner from cycle to cycle: the last of {cycles} ended {closure:.1e} of the clearance from where it began; change [load] or journal.speed",
                percent(*share)
            ),
            Self::Sinking(cycles, closure, share) => write!(
                out,
                "sinking: the journal does not turn, {} of the load keeps its direction, and the journal nears the liner from cycle to cycle: the last of {cycles} ended {closure:.1e} of the clearance from where it began; change [load], or give journal.speed",
                percent(*share)
            ),
            Self::FirstCycle(angle, cause) => ended(
                out,
                format!("the orbit was ended at {angle:.1} deg of the first cycle"),
                *cause,
            ),
            Self::FirstPosition([nearest, load], cause) => ended(
                out,
                format!(
                    "the search for the position was ended before it was complete; the nearest force found is {} N, the load is {} N",
                    readable(*nearest),
                    readable(*load)
                ),
                *cause,
            ),
            Self::FirstTemperature(cause) => ended(
                out,
                "the search for the temperature was ended before a first one was solved".to_owned(),
                *cause,
            ),
            Self::FirstMesh(unknowns, cause) => ended(
                out,
                format!("the first mesh, of {unknowns} unknowns, was made, and its film was not begun"),
                *cause,
            ),
            Self::Orbit(cycles, closure, cause) => ended(
                out,
                format!(
                    "the orbit was ended after {cycles} complete {}, the last of which closed to {closure:.1e} of the clearance",
                    if *cycles == 1 { "cycle" } else { "cycles" }
                ),
                *cause,
            ),
            Self::Unfinished(distance, seconds, cause) => {
                let unknowns = distance.unknowns;
                match cause {
                    Cause::Interrupt => write!(out, "interrupted: {distance} on {unknowns} unknowns"),
                    Cause::GivenLimit(_) | Cause::UsualLimit(_) => write!(
                        out,
                        "limit: {distance} on {unknowns} unknowns, and the next mesh was not finished after {seconds:.1} s, by {cause}; {MORE_SECONDS}, or {}",
                        distance.way_out()
                    ),
                }
            }
            Self::Unknowns { distance, wanted, most } => write!(
                out,
                "limit: {distance} on {} unknowns, and the next mesh would need some {wanted:.0}, more than {most}; {MORE_UNKNOWNS}, or {}",
                distance.unknowns,
                distance.way_out()
            ),
            Self::Seconds {
                distance,
                seconds: [elapsed, next],
                cause,
            } => write!(
                out,
                "limit: {distance} after {elapsed:.1} s, and the next mesh would take some {next:.1} s, beyond {cause}; {MORE_SECONDS}, or {}",
                distance.way_out()
            ),
            Self::Meshes(distance, meshes) => {
                let way_out = distance.way_out();
                write!(out, "limit: {distance} after {meshes} meshes; give {way_out}")
            }
            Self::CoarseRim => {
                write!(
                    out,
                    "limit: the mesh cannot be divided, for a round rim of it is too coarse; give a finer mesh"
                )
            }
            Self::NoAnswer(reason) => write!(
                out,
                "limit: the bars are wider than asked for, and the next mesh has no answer: {reason}"
            ),
            Self::Before(limit, distance) => write!(out, "{limit}; the result is that of the mesh before: {distance}"),
        }
    }
}

/// What a user can do about regions of given pressure that do not fit the mesh.
pub fn way_out_of_supply(fault: &SupplyError) -> &'static str {
    match fault {
        SupplyError::Unassigned { .. } => {
            "put them in end_low, end_high, arc_from, arc_to or in the group of a [[feed]]"
        }
        SupplyError::Conflict { .. } => "separate them or give them one pressure",
        SupplyError::OpenRim { .. } => "complete the group, or mesh the region as a surface",
        SupplyError::NoLine { .. } => "mesh the liner with its seam there",
        _ => "correct the groups of the mesh",
    }
}
