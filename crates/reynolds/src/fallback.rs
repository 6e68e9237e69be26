//! Ways out that had to be taken to solve a film.

/// A way out. The film is solved, but by a step that is less accurate than the usual one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Fallback {
    /// A cavity was found in steps of time instead of Newton's.
    #[error("the cavity was found in pseudo-time, since its set of nodes came back")]
    PseudoTime,
    /// Oil is carried by the scheme that spreads it most.
    #[error(
        "the N scheme carries the oil all round the cavity, since a set of nodes of the cavity came back, oil goes round in it, or nodes would hold less than none"
    )]
    NScheme,
    /// The advection schemes are those of a position nearby.
    #[error("the advection schemes did not settle at the balanced position: those chosen near it are kept")]
    SchemesNearPosition,
    /// The advection schemes are those of a temperature nearby.
    #[error("the advection schemes did not come to rest at the balanced temperature: those chosen near it are kept")]
    SchemesNearTemperature,
}
