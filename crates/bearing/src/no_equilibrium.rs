//! Why a load is not balanced.

use crate::coordinates::Vector;
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::{JournalState, NoFilm};

/// A film that carries less than what is asked by more than so many times its error does not carry it.
pub(crate) const DISTINCT: f64 = 2.0;
/// A film whose force is nowhere this part of the load carries none.
pub(crate) const AT_REST: f64 = 1e-3;

/// What stopped a search that found no balance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum SearchEnd {
    /// No pressure balances the load.
    #[error("the load points out of the shell, and the film only pushes")]
    OutOfShell,
    /// The tangent leads no nearer.
    #[error("no shorter step brings the force nearer to the load")]
    NoStep,
    /// The steps lead into contact.
    #[error("the journal touches the bearing")]
    Touching,
    /// All steps are made.
    #[error("the force does not approach the load")]
    NoProgress,
    /// The time is over.
    #[error("the search was ended")]
    Ended,
}

/// A balance on a branch, at which a search on another mesh begins.
#[derive(Debug, Clone, PartialEq)]
pub struct Waypoint {
    /// The journal.
    pub(crate) journal: JournalState,
    /// The deflection of a wall that gives way.
    pub(crate) deflection: Option<Deflection>,
    /// The part of the branch [1].
    pub(crate) part: f64,
    /// Forces of the film less the load at the beginning of the branch [N], in the coordinates of the search.
    pub(crate) first: Vector,
}

impl Waypoint {
    /// Whether the wall gives way there.
    pub fn is_bent(&self) -> bool {
        self.deflection.is_some()
    }
}

/// What ends a branch before all is balanced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BranchLimit {
    /// The journal touches the liner.
    Contact,
    /// The part that is balanced has a greatest value.
    Fold,
}

/// The end of a branch of balances along which the load or, where the tilt is free, what tilts the journal grows.
#[derive(Debug, Clone)]
pub struct BranchEnd {
    /// What ends it.
    pub limit: BranchLimit,
    /// Whether the tilt is free.
    pub is_tilting: bool,
    /// The load [N], and its direction [deg].
    pub asked: [f64; 2],
    /// Part of the load, or of what tilts the journal, that is balanced there [1].
    pub carried: f64,
    /// Error of `carried` at most [1]. None where it is not known: the branch may lead on, on this mesh or another.
    pub error: Option<f64>,
    /// Axial position of the thinnest film [m].
    pub z: f64,
    /// Where it is around the bearing [deg].
    pub angle: f64,
    /// Thickness of the film there [m].
    pub thickness: f64,
    /// Eccentricity ratio.
    pub eccentricity: f64,
    /// The journal there.
    pub journal: JournalState,
    /// Where another mesh takes up the branch.
    pub way: Option<Waypoint>,
}

/// Why no position was found.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NoEquilibrium {
    /// No film at the first position or near it.
    #[error(transparent)]
    Film(#[from] NoFilm),
    /// No position balances the load.
    #[error(
        "no position of the journal carries {} N towards {towards:.1} deg: the nearest force found is {} N towards {nearest_towards:.1} deg, at eccentricity {eccentricity:.4} ({why})",
        readable(*asked), readable(*nearest)
    )]
    Unreachable {
        /// The load [N].
        asked: f64,
        /// Direction of the load [deg].
        towards: f64,
        /// Nearest force found [N].
        nearest: f64,
        /// Direction of that force [deg].
        nearest_towards: f64,
        /// Eccentricity there.
        eccentricity: f64,
        /// The journal where the search ended.
        journal: Box<JournalState>,
        /// What stopped the search.
        why: SearchEnd,
    },
    /// A branch of balances ends before the film carries the load and what tilts the journal.
    #[error("{0}")]
    Branch(Box<BranchEnd>),
    /// The load is too small for the film's force to be distinguished from round-off.
    #[error(
        "not converged: the load of {} N is below the round-off of the film's force, about {} N",
        readable(*asked), readable(*least)
    )]
    BelowRounding {
        /// The load [N].
        asked: f64,
        /// The least load that can be balanced [N].
        least: f64,
    },
    /// The search did not end.
    #[error(
        "not converged: after {} positions force and load still differ by {residual:.1e} of the load",
        history.len()
    )]
    NotConverged {
        /// The load [N].
        asked: f64,
        /// The least difference of load and force, relative to the load.
        residual: f64,
        /// The journal where the search ended.
        journal: Box<JournalState>,
        /// Load less force of each position tried, relative to the load.
        history: Vec<f64>,
    },
    /// The search was ended before it was complete.
    #[error(
        "not converged: the search for the position was ended before it was complete; the nearest force found is {} N, the load is {} N",
        readable(*nearest), readable(*asked)
    )]
    Ended {
        /// The load [N].
        asked: f64,
        /// Nearest force found [N].
        nearest: f64,
        /// The journal where the search ended.
        journal: Box<JournalState>,
        /// Load less force of each position tried, relative to the load.
        history: Vec<f64>,
    },
}

/// Percent of a whole that a `part` of it [1] is, in steps of one over `steps`; the whole is only what is no less.
fn percent(part: f64, steps: f64) -> f64 {
    let percent = 100.0 * part * steps;
    let rounded = match part < 1.0 {
        true => percent.round().min(100.0 * steps - 1.0),
        false => percent.round(),
    };
    rounded / steps
}

/// A part that is carried, and its error on the mesh where that is known and leaves open whether all is carried.
fn told((carried, error): (f64, Option<f64>), steps: f64) -> String {
    let percent = readable(percent(carried, steps));
    match error.filter(|error| carried + error >= 1.0) {
        // Two digits, rounded up.
        Some(error) if error < 0.1 => format!("{percent} ± {:.1} %", (1e3 * error).ceil() / 10.0),
        Some(error) => format!("{percent} ± {:.0} %", (100.0 * error).ceil()),
        None => format!("{percent} %"),
    }
}

impl std::fmt::Display for BranchEnd {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { asked: [asked, towards], carried, error, thickness, eccentricity, angle, .. } = *self;
        let (load, film) = (readable(asked), readable(thickness));
        let [z, slope] = [self.z, self.journal.tilt[0].hypot(self.journal.tilt[1])].map(|x| readable(1e3 * x));
        match (self.is_tilting, self.limit) {
            (false, _) if carried >= 1.0 => write!(
                f,
                "no position of the journal carries {load} N towards {towards:.1} deg: the film that carries it is {film} m thin, at eccentricity {eccentricity:.4}, and the journal touches the liner"
            ),
            (false, _) => write!(
                f,
                "no position of the journal carries {load} N towards {towards:.1} deg: at eccentricity {eccentricity:.4}, where the film is {film} m thin, it carries {} N that way, and the load is {} times as much",
                readable(carried * asked),
                readable(1.0 / carried)
            ),
            (true, BranchLimit::Contact) => {
                // A branch from which no step leads on ends before contact.
                let met = if error.is_some() || carried >= 1.0 { "comes into contact with" } else { "comes near" };
                let part = told((carried, error), 1.0);
                write!(
                    f,
                    "no position and tilt that a growing moment leads to carry {load} N and its moment: the journal {met} the liner at its end z = {z} mm, at {angle:.1} deg; the last balance found on the way there, with a film of {film} m, carries {part} of the moment"
                )
            }
            (true, BranchLimit::Fold) => {
                let part = told((carried, error), 10.0);
                write!(
                    f,
                    "no position and tilt that a growing moment leads to carry {load} N and its moment: on that way the film carries at most {part} of what tilts the journal, at a slope of {slope} mrad with a least film of {film} m; tilted more it carries less, and the journal tips over"
                )
            }
        }
    }
}

impl BranchEnd {
    /// True where a balance beyond this end is not excluded.
    fn is_unreached(&self) -> bool {
        // What carries all of it in contact has no thicker film.
        self.carried < 1.0 && self.error.is_none_or(|error| self.carried + error >= 1.0)
    }
}

impl NoEquilibrium {
    /// True if there may be a balance that was not found.
    pub fn is_unreached(&self) -> bool {
        match self {
            Self::Film(reason) => reason.is_unreached(),
            Self::Branch(end) => end.is_unreached(),
            Self::Unreachable { asked, nearest, why, .. } => {
                *why != SearchEnd::OutOfShell && *nearest > AT_REST * asked
            }
            Self::BelowRounding { .. } | Self::NotConverged { .. } | Self::Ended { .. } => true,
        }
    }

    /// The end of a branch that was followed.
    pub fn branch_end(&self) -> Option<&BranchEnd> {
        match self {
            Self::Branch(end) => Some(end),
            _ => None,
        }
    }

    /// True where the film carries so much less than the load, or than its moment, that a finer mesh shows no more.
    pub fn is_far_beyond(&self) -> bool {
        let end = self.branch_end();
        end.is_some_and(|end| end.error.is_some_and(|error| end.carried + DISTINCT * error < 1.0))
    }

    /// True where the film of this mesh lacks no more of the load, or of its moment, than its error: a finer mesh may
    /// show a balance.
    pub fn is_undecided(&self) -> bool {
        let end = self.branch_end();
        end.is_some_and(|end| end.error.is_some_and(|error| end.carried + error >= 1.0))
    }

    /// Where another mesh takes up the branch, if one was followed.
    pub fn way(&self) -> Option<&Waypoint> {
        self.branch_end()?.way.as_ref()
    }

    /// Load less force of each position tried, relative to the load; empty where there was no search.
    pub fn history(&self) -> &[f64] {
        match self {
            Self::NotConverged { history, .. } | Self::Ended { history, .. } => history,
            Self::Film(_) | Self::BelowRounding { .. } | Self::Branch(_) | Self::Unreachable { .. } => &[],
        }
    }

    /// The last position of the search, if it had one.
    pub fn last_position(&self) -> Option<JournalState> {
        match self {
            Self::Film(_) | Self::BelowRounding { .. } => None,
            Self::Branch(end) => Some(end.journal),
            Self::Unreachable { journal, .. } | Self::NotConverged { journal, .. } | Self::Ended { journal, .. } => {
                Some(**journal)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BranchEnd, BranchLimit, NoEquilibrium, SearchEnd, percent, told};
    use oilwedge_reynolds::JournalState;

    /// The reason that the film in contact carries this part of a moment, with its error.
    fn edge_contact((carried, error): (f64, Option<f64>)) -> NoEquilibrium {
        NoEquilibrium::Branch(Box::new(BranchEnd {
            limit: BranchLimit::Contact,
            is_tilting: true,
            asked: [1e3, 0.0],
            carried,
            error,
            z: 0.02,
            angle: 90.0,
            thickness: 1e-9,
            eccentricity: 0.9,
            journal: JournalState::default(),
            way: None,
        }))
    }

    /// The reason that a search found no better position than one that carries `nearest` of 1000 N.
    fn unreachable(nearest: f64, why: SearchEnd) -> NoEquilibrium {
        NoEquilibrium::Unreachable {
            asked: 1e3,
            towards: 0.0,
            nearest,
            nearest_towards: 90.0,
            eccentricity: 0.5,
            journal: Box::new(JournalState::default()),
            why,
        }
    }

    #[test]
    fn there_is_no_balance_only_where_something_is_known_of_all_positions() {
        for (known, is_unreached) in [
            ((0.8, Some(0.1)), false),
            ((0.8, Some(0.2)), true),
            ((0.8, None), true),
            // All of it, in contact.
            ((1.0, None), false),
        ] {
            assert_eq!(edge_contact(known).is_unreached(), is_unreached, "{known:?}");
            let is_near = edge_contact(known).to_string().contains("comes near the liner");
            assert_eq!(is_near, known == (0.8, None), "{known:?}");
        }
        for (nearest, why, is_unreached) in
            [(500.0, SearchEnd::NoStep, true), (0.0, SearchEnd::NoStep, false), (500.0, SearchEnd::OutOfShell, false)]
        {
            let reason = unreachable(nearest, why);
            assert_eq!(reason.is_unreached(), is_unreached, "{nearest} {why}");
        }
    }

    #[test]
    fn less_than_the_whole_does_not_read_as_the_whole() {
        assert_eq!([percent(0.997, 1.0), percent(0.9996, 10.0)], [99.0, 99.9]);
        assert_eq!([percent(0.5046, 1.0), percent(0.5046, 10.0)], [50.0, 50.5]);
        assert_eq!([percent(1.0, 1.0), percent(1.02, 10.0)], [100.0, 102.0]);
    }

    #[test]
    fn an_error_is_told_where_it_leaves_open_whether_all_is_carried() {
        assert_eq!(told((0.8, Some(0.1999)), 1.0), "80 %");
        assert_eq!(told((0.98, Some(0.0341)), 1.0), "98 ± 3.5 %");
        assert_eq!(told((0.80, Some(0.248)), 10.0), "80 ± 25 %");
        assert_eq!(told((0.99, None), 1.0), "99 %");
    }
}
