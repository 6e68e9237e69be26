//! How much of a run a report shows.

/// Which quantities a report shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shown {
    /// Headlines, and the joint of a cap.
    Headlines,
    /// All.
    All,
}
