//! The cases of a sweep: one scene with keys that take many values.
//!
//! An axis is a key of the scene and its values; several make a grid. A case is the text of the scene with those keys
//! replaced, read and checked as any other scene, so that units, ranges and complaints come from one place.

mod axis;
mod change;
mod column;
mod draws;
mod plan;
mod read;

pub use axis::{AxisValue, BEARING, SHAFT_SHORT_NAMES, SHORT_NAMES, SweepAxis};
pub use change::{changed, with_axes};
pub use column::WantedColumn;
pub use draws::{DrawLaw, DrawOptions, Draws};
pub use plan::Plan;

pub(crate) use plan::of_values;
pub use read::MOST_CASES;

pub(crate) use read::{KEYS, OF_BEARING, OF_SHAFT, plan, read_table};
