//! How a run gets on, for whoever waits for it.

use oilwedge_bearing::orbit::OrbitObserver;
use oilwedge_bearing::{Deadline, SearchObserver};

use crate::quantities::Unit;

/// The bar that decides whether a mesh is fine enough.
#[derive(Debug, Clone, PartialEq)]
pub struct Reached {
    /// Number of the mesh, from 1.
    pub level: usize,
    /// Unknown pressures of the mesh.
    pub unknowns: usize,
    /// Quantity whose bar is the widest for what is asked.
    pub quantity: String,
    /// Unit of its bar.
    pub unit: Unit,
    /// Bar of the value; `None` where the mesh does not resolve it.
    pub error: Option<f64>,
    /// The bar that is asked for, where there is one.
    pub asked: Option<f64>,
    /// Seconds of the mesh, by the clock of the run [s].
    pub seconds: f64,
}

/// The deadline of the searches of a run, and the observer that is notified of their positions.
#[derive(Debug, Clone, Copy)]
pub struct Watch {
    /// Deadline of the searches.
    pub deadline: Deadline,
    /// Most unknowns of the meshes that are made for them.
    pub most_unknowns: usize,
    /// Notified of each position that is tried, if anyone is.
    pub observer: Option<&'static dyn RunObserver>,
}

impl From<Deadline> for Watch {
    fn from(deadline: Deadline) -> Self {
        Self { deadline, most_unknowns: usize::MAX, observer: None }
    }
}

/// Notified by a run, from any thread.
pub trait RunObserver: SearchObserver + OrbitObserver {
    /// A mesh with so many unknowns is solved next; meshes are counted from 1.
    fn level(&self, number: usize, unknowns: usize);

    /// An orbit is followed on a mesh with so many unknowns, and will take some processor time [s].
    fn expects(&self, _unknowns: usize, _seconds: Option<f64>) {}

    /// The run turns to another task, which these words name.
    fn turns_to(&self, _task: &'static str) {}

    /// A mesh was solved, and its bars are known.
    fn reached(&self, reached: &Reached);

    /// Temperature `number` of this search, from 1, is tried next [degrees C].
    fn temperature(&self, number: usize, celsius: f64);

    /// Counterweights moved a part of the way to those that serve the cut shaft best change the least film [m] of the
    /// shaft of the scene.
    fn counterweights(&self, _part: f64, _film: [f64; 2]) {}
}
