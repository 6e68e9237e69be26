//! `crates`: draws `docs/images/crates.svg` anew, the crates and what each uses.

use oilwedge_full::crate_arrows::{DRAWING, drawing};
use oilwedge_tests::program::repository;

/// Runs the command.
pub(crate) fn run() -> std::io::Result<()> {
    std::fs::write(repository().join(DRAWING), drawing())
}
