//! The orbit of the journal under a load that changes with the crank angle.
//!
//! | file | what |
//! |---|---|
//! | `motion.rs` | film, support, mass and load at one time, and their tangents |
//! | `scheme.rs`, `stage.rs`, `step.rs` | implicit steps in time with an estimate of their error |
//! | `march.rs` | steps as long as the tolerance allows, from cycle to cycle |
//! | `path.rs` | the journal between two steps |
//!
//! **Source.** Booker, Trans. ASME J. Basic Eng. 87 (1965) 537 (journals without mass); Kennedy and Carpenter, Appl. Numer. Math. 44 (2003) 139.

mod march;
mod motion;
mod path;
mod scheme;
mod stage;
mod step;

pub use march::{Cycle, NoOrbit, Orbit, OrbitEnd, OrbitObserver, OrbitOptions};
pub use motion::{Instant, Motion, TiltSupport};
pub use path::{Span, Step};
pub(crate) use scheme::{COEFFICIENTS, DIAGONAL, EMBEDDED, ERROR_POWER, NODES, STAGES};
