//! What can go wrong in a finite-element solve.

/// Errors of assembly, factorisation and linear solves.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A matrix or vector has an entry that is NaN or infinite.
    #[error("the {what} is not finite; look for a film thickness or viscosity that is zero or overflows")]
    NotFinite {
        /// Name of the object.
        what: &'static str,
    },
    /// The Cholesky factorisation met a pivot that is not positive.
    #[error("the tangent is not positive definite: the problem has no unique stable solution here")]
    NotPositiveDefinite,
    /// The linear solve is too inaccurate to use.
    #[error(
        "the linear system is solved to a relative residual of {relative:.1e} only; the mesh or the film is too extreme"
    )]
    Inaccurate {
        /// Residual over right-hand side.
        relative: f64,
    },
    /// The factor does not fit.
    #[error("the factor of a system of {unknowns} unknowns does not fit in memory; use a coarser mesh")]
    TooLarge {
        /// Number of unknowns.
        unknowns: usize,
    },
}
