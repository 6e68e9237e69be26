//! How small error bars must become.

use oilwedge_scene::Target;

/// The bars that refinement of the mesh must make small.
#[derive(Debug, Clone, PartialEq)]
pub struct Targets {
    /// A run that does not reach them has not converged; in the order of the result.
    pub required: Vec<Target>,
    /// Targets that are wanted besides, as far as they are cheap: a bar that stays wider is a warning.
    pub wanted: Vec<Target>,
    /// True where the scene leaves them to the program.
    pub are_usual: bool,
}
