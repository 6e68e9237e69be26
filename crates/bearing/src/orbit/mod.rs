//! The orbit of the journal under a load that changes with the crank angle.
//!
//! | file | what |
//! |---|---|
//! | `motion.rs` | film, support, mass and load at one time, and their tangents |
//! | `journals.rs` | journals that move at the same time: one, or those of a shaft |
//! | `scheme.rs`, `stage.rs`, `step.rs` | implicit steps in time with an estimate of their error |
//! | `wall.rs` | a wall that gives way along the path |
//! | `oil.rs` | what a film that conserves its oil holds along the way |
//! | `pace.rs`, `march.rs` | steps as long as the tolerance allows, from cycle to cycle |
//! | `no_orbit.rs` | why an orbit does not lead on |
//! | `path.rs`, `between.rs` | the journal between two steps, and its film |
//!
//! **Source.** Booker, Trans. ASME J. Basic Eng. 87 (1965) 537 (journals without mass); Kennedy and Carpenter, Appl.
//! Numer. Math. 44 (2003) 139.

mod between;
mod journals;
mod march;
mod motion;
mod no_orbit;
mod oil;
pub(crate) mod pace;
mod path;
pub mod scheme;
mod stage;
mod step;
mod wall;

pub use journals::{Drive, Journals};
pub use march::{Cycle, CycleOil, Orbit, OrbitEnd, OrbitObserver, OrbitOptions, Orbits};
pub use motion::{Held, Instant, Motion, Moving, TiltSupport};
pub use no_orbit::{NoOrbit, NoOrbitAt};
pub use oil::{Before, StoredOil};
pub use path::{Between, PathStep, Span, StepHistory};
