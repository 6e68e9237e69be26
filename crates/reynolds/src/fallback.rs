//! Ways out that had to be taken to solve a film.

/// A way out. The film is solved, but by a step that is less accurate than the usual one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Fallback {
    /// A cavity was found in steps of time instead of Newton's.
    #[error("the cavity was found in pseudo-time, since its set of nodes came back")]
    PseudoTime,
}
