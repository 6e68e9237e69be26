//! A sweep: one scene solved for many values of its keys.
//!
//! An axis is a key of the scene and its values; several make a grid. A case is the text of the scene with those keys
//! replaced, read and checked as any other scene, so that units, ranges and complaints come from one place. Cases are cut into
//! chains of neighbours, which are walked along: the mesh, its numbering and analysis stay as long as they fit, films and positions begin
//! where those before lead.
//!
//! Reading order: `axis.rs`, `plan.rs` (cases), `chain.rs`, `walk.rs` (one chain), `run.rs` (all of them), `table.rs` (rows), `files.rs` (a
//! table that can be taken up again), `report.rs` (for scripts).

pub(crate) mod axis;
mod chain;
mod files;
mod plan;
mod report;
mod run;
mod table;
mod walk;

pub use axis::{Axis, AxisValue};
pub use files::{REPORT_FILE, TABLE_FILE};
pub use plan::Plan;
pub use report::{Identity, SWEEP_FORMAT, SweepReport};
pub use run::{Progress, Sweep, SweepOptions};
pub use table::{Columns, Row};
