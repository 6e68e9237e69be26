//! Shafts that are solved beside that of a scene, to be compared with it.

use oilwedge_scene::{ShaftScene, Statics};

use super::error::ShaftError;
use super::result::ShaftRun;
use super::run_shaft;
use super::weights::{Movable, NoWeights};
use crate::run_options::RunOptions;

/// What differs in a shaft beside that of the scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variant {
    /// The shaft is cut at its bearings.
    Cut,
    /// The counterweights are those that serve the bearings best.
    Counterweights,
}

impl Variant {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Cut, Self::Counterweights];

    /// Name of the variant in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Cut => "cut",
            Self::Counterweights => "counterweights",
        }
    }

    /// What it is, for headings.
    pub fn words(self) -> &'static str {
        match self {
            Self::Cut => "the shaft cut at its bearings",
            Self::Counterweights => "the counterweights moved",
        }
    }

    /// Refuses what cannot stand beside the shaft of a scene, before any film is solved.
    ///
    /// # Errors
    /// [`NoWeights`]: the shaft is cut already, or its counterweights cannot move.
    pub fn check(self, scene: &ShaftScene) -> Result<(), NoWeights> {
        match (self, scene.crankshaft.statics) {
            (Self::Cut, Statics::Elastic) => Ok(()),
            (Self::Cut, Statics::Cut) => Err(ShaftError::CutAlready.into()),
            (Self::Counterweights, _) => Movable::of(scene).map(drop),
        }
    }
}

/// Solves the shaft of a scene cut at its bearings.
///
/// # Errors
/// [`ShaftError`]: the scene is cut already, or does not become a shaft on films.
pub fn run_cut(scene: &ShaftScene, options: &RunOptions) -> Result<ShaftRun, ShaftError> {
    match scene.crankshaft.statics {
        Statics::Cut => Err(ShaftError::CutAlready),
        Statics::Elastic => run_shaft(&scene.cut(), options),
    }
}
