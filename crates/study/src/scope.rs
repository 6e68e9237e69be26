//! What the answer to a scene may contain, on whatever mesh.

use oilwedge_scene::{Cap, CavitationModel, DynamicsTable, OrbitTable};

use crate::thermal_model::ThermalModel;

/// What a scene asks for, and what its film has.
#[derive(Debug, Clone)]
pub struct Scope {
    /// How the path of the journal is followed over a cycle; `None`: one film is asked for.
    pub orbit: Option<OrbitTable>,
    /// Whether the position follows from a load that does not change.
    pub is_loaded: bool,
    /// Angular speed of the journal [rad/s].
    pub speed: f64,
    /// Whether centre or axis of the journal move at a given rate.
    pub moves: bool,
    /// Whether the journal may be inclined.
    pub can_tilt: bool,
    /// Whether bore and journal are circles.
    pub is_circular: bool,
    /// Whether the shapes of bore and journal change along the axis.
    pub has_shape_along_the_axis: bool,
    /// Groups of feeds and pockets, in the order of the scene.
    pub groups: Vec<String>,
    /// Whether a feed has a pressure.
    pub is_fed: bool,
    /// What happens where the film would break.
    pub cavitation: CavitationModel,
    /// Whether rough surfaces may touch.
    pub touches: bool,
    /// Whether the film is turbulent.
    pub is_turbulent: bool,
    /// Whether the wall gives way.
    pub gives_way: bool,
    /// Whether the viscosity is that at a temperature.
    pub is_by_temperature: bool,
    /// How the temperature of the film is found; `None`: it is given, or has no effect.
    pub thermal: Option<ThermalModel>,
    /// Whether temperatures are found across the film.
    pub has_heat_field: bool,
    /// Whether a bush around the film conducts heat.
    pub has_heat_bush: bool,
    /// What is asked about small motions of the journal.
    pub dynamics: Option<DynamicsTable>,
    /// The length [m] by which the film is judged at its ends; `None` where it is not.
    pub deviation_scale: Option<f64>,
    /// The cap of the connecting rod whose bearing this is.
    pub cap: Option<Cap>,
}
