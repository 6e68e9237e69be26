//! What readers of mesh files do with sound and with damaged files.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// What becomes of a file that a reader is given.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Outcome {
    /// The file is read.
    Read,
    /// The file is refused with a message.
    Refused,
    /// The reader panics.
    Panics,
}

/// What a reader does.
pub fn outcome<T, E>(read: impl FnOnce() -> Result<T, E>) -> Outcome {
    match catch_unwind(AssertUnwindSafe(read)) {
        Ok(Ok(_)) => Outcome::Read,
        Ok(Err(_)) => Outcome::Refused,
        Err(_) => Outcome::Panics,
    }
}
