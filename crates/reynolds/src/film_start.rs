//! What a solve of a film begins with, and how far it goes.

use oilwedge_fem::complementarity::WarmStart;

/// How many steps a film whose cavity is sought takes, each with one factorisation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum StepBudget {
    /// As many as it needs until no dof is on the wrong side.
    UntilSettled,
    /// One, with the cavity of its start.
    One,
}

/// What one step of a film starts from: the unknown, and the cavity with which it is solved.
#[derive(Debug, Clone)]
pub struct FilmStart(pub(crate) WarmStart);
