//! What an error estimate knows of a film: the one interface in whose terms the rules of the quantities speak.
//!
//! | film | estimate | value reported |
//! |---|---|---|
//! | pressure film | `cubic.rs`: by the film in cubic elements on the same mesh | the cubic one |
//! | mass-conserving film | `coarse.rs`: by its coarse comparison on the vertices | its own, or of its sharp hill |
//!
//! `docs/theory/error_estimation.md` has the rules and how often they hold.

mod coarse;
mod coefficients;
mod cubic;
mod displaced;
mod errors;
mod linked;
mod places;
mod position_sensitivity;
mod wall;

pub use coefficients::CoefficientErrors;
pub use displaced::Displacement;
pub use errors::{Estimated, estimate_errors, quadratic_errors};

use oilwedge_reynolds::error_bar::{Bar, FlowGoal};
use oilwedge_reynolds::quantities::extent::{Extent, FilmEnd};

/// How a number is made of one that an estimate knows.
#[derive(Debug, Clone, Copy)]
pub struct Scaled {
    /// The number that the estimate knows, over this one.
    pub unit: f64,
    /// The number less that of the other film of a pair, where there is one.
    pub change: f64,
}

/// An end of the loaded film.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExtentEnd {
    /// The upstream one.
    Begins,
    /// The downstream one.
    Ends,
}

impl ExtentEnd {
    /// The film's end of this kind in an extent.
    pub fn of(self, extent: &Extent) -> FilmEnd {
        match self {
            Self::Begins => extent.begins,
            Self::Ends => extent.ends,
        }
    }
}

/// What is known of the errors of a film at a given position and temperature.
pub trait Estimate {
    /// False where the mesh does not resolve the film, and no bar can be trusted.
    fn is_resolved(&self) -> bool;
    /// Magnitude [N] of the load.
    fn force(&self) -> f64;
    /// Bar of the magnitude of the load [N].
    fn load(&self) -> Bar;
    /// Bar of the load across its direction [N]; none where the load is smaller than its own bar.
    fn across(&self) -> Option<Bar>;
    /// Bar of the product of the load with a vector.
    fn product(&self, vector: [f64; 2]) -> Bar;
    /// Bars of the moment towards x and y [N m]; none where the journal cannot tilt.
    fn moment(&self) -> Option<[Bar; 2]>;
    /// Bar of `Int p dA` [N].
    fn pressure_integral(&self) -> Bar;
    /// Bar of the greatest pressure [Pa]; not finite where it has no bound.
    fn greatest_pressure(&self) -> f64;
    /// Bar of the least pressure [Pa].
    fn least_pressure(&self) -> Bar;
    /// Bar of a flow; none where it is not judged.
    fn flow(&self, goal: &FlowGoal, number: Scaled) -> Option<Bar>;
    /// Bar of the flow into the loaded film.
    fn inlet_flow(&self, number: Scaled) -> f64;
    /// Bar of the oil [m3/s] that a cavity makes, which changes by `change` between two films; none where it makes
    /// none.
    fn cavity_flow(&self, change: f64) -> Option<Bar>;
    /// Bar of `shear` times the power [W] of shear and `pressure` times that of pressure.
    fn power(&self, parts: [f64; 2]) -> Bar;
    /// Bar of the shear in a cavity [W], which changes by `change` between two films; none where it has none.
    fn cavity_power(&self, change: f64) -> Option<Bar>;
    /// Bar of the share of the cavity [1], which changes by `change` between two films.
    fn cavity_share(&self, change: f64) -> f64;
    /// Bar of the least film fraction [1]; none where there is none.
    fn least_fraction(&self) -> Option<f64>;
    /// Bars of the place of the greatest pressure [m], around and along the axis.
    fn summit(&self) -> [f64; 2];
    /// Bar of the place of an end of the loaded film [m]; none where only one of two films has it.
    fn film_end(&self, end: ExtentEnd) -> Option<Bar>;
    /// Bars of stiffness and damping at the first frequency asked for; none where one of two films has none.
    fn coefficients(&self) -> Option<CoefficientErrors>;
    /// Bars of stiffness and damping at the frequency at which a rotor is judged; none where one of two films has none.
    fn judged_coefficients(&self) -> Option<CoefficientErrors>;
}
