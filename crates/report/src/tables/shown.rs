//! How much of a run a report shows.

/// The quantities that a report shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ShownQuantities {
    /// Headlines, and the joint of a cap.
    Headlines,
    /// All.
    All,
}
