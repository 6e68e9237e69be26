//! Results as tables and lines for people, as the command line prints them and Python shows them.
//!
//! Reading order: `pieces.rs` (headings, times), `run.rs` (a whole run), `quantities.rs`, `verdict.rs`,
//! `temperature.rs`, `dynamics.rs`; `sweep.rs`, `shaft.rs`.

mod criteria;
mod dynamics;
mod pieces;
mod quantities;
mod run;
mod shaft;
mod shown;
mod sweep;
mod temperature;
mod verdict;

pub use pieces::{counted, duration, effects, heading, mesh, printable, time, whole_run};
#[cfg(test)]
pub(crate) use run::tests::result as example;
pub use run::{Written, run_report};
pub use shaft::shaft_report;
pub use shown::ShownQuantities;
pub use sweep::sweep_report;
pub(crate) use verdict::first_faults;
