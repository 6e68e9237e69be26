//! The sockets of a film: what the effects of a scene put there.

use std::sync::Arc;

use oilwedge_bearing::{Load, Tilting};
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::film_thickness::{FilmContribution, Profile};
use oilwedge_reynolds::flow_factors::FlowFactor;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::terms::Term;
use oilwedge_reynolds::{Cavitation, CentreVelocity, Form, Theory};
use oilwedge_scene::periodic_table::TableError;
use oilwedge_scene::{Dynamics, Liner, Scene};

use super::present;
use crate::compile_error::CompileError;
use crate::thermal_model::ThermalModel;

/// Socket in which an effect enters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Socket {
    /// A direction in which pressure drives oil, and how easily it flows.
    FlowFactors,
    /// A flux or source of Reynolds' equation.
    Terms,
    /// The position of the journal as an unknown.
    Position,
    /// The deflection of the wall as an unknown.
    Deflection,
    /// The temperature of the film as an unknown.
    Temperature,
    /// The oil.
    Lubricant,
    /// A contribution to the thickness of the film.
    FilmThickness,
    /// Given pressures and film fractions.
    Supply,
    /// What closes the equation where the film breaks.
    Cavitation,
    /// Contact of rough surfaces.
    Contact,
    /// What is asked of the film beside its state.
    Analysis,
}

impl Socket {
    /// Whether it holds a further unknown that closes around the film.
    pub fn is_balance(self) -> bool {
        matches!(self, Self::Position | Self::Deflection | Self::Temperature)
    }
}

/// Makes a contribution to the thickness of a film on a mesh.
pub type Contribution = Box<dyn Fn(&Mesh) -> Arc<dyn FilmContribution>>;

/// Makes the shape of a surface; a measured one is read from its file.
pub(super) type MadeProfile = Box<dyn Fn() -> Result<Arc<dyn Profile>, TableError>>;

/// The sockets of one film.
pub struct Sockets {
    /// The directions in which pressure drives oil.
    pub theory: Theory,
    /// Fluxes and sources.
    pub terms: Vec<Arc<dyn Term>>,
    /// What scales them.
    pub flow_factors: Vec<Arc<dyn FlowFactor>>,
    /// Growth of viscosity with pressure.
    pub pressure_law: PressureLaw,
    /// Place of the viscosity in the equation.
    pub form: Form,
    /// Contributions to the film thickness beside that of the journal.
    pub film_thickness: Vec<Contribution>,
    /// Shapes of bore and journal beside circles.
    pub profiles: Vec<MadeProfile>,
    /// How the wall gives way to the pressure; `None`: it is rigid.
    pub liner: Option<Liner>,
    /// Film fraction of the oil that enters at the edge of an arc; `None`: full.
    pub inlet_fraction: Option<f64>,
    /// What closes the equation where the film breaks.
    pub cavitation: Cavitation,
    /// Contact of rough surfaces; `None`: they do not touch.
    pub contact: Option<Contact>,
    /// Velocity of the journal's centre.
    pub centre_velocity: CentreVelocity,
    /// Rate of the slope of the journal's axis [rad/s].
    pub tilt_rate: [f64; 2],
    /// Force `(F cos, F sin)` on the journal [N] under which its position is found; `None` at a given position.
    pub load: Option<[f64; 2]>,
    /// What tilts the journal under that load; `None`: its tilt is given.
    pub tilting: Option<Tilting>,
    /// How the temperature of the film is found; `None`: it is given, or has no effect.
    pub thermal: Option<ThermalModel>,
    /// What is asked about small motions of the journal; `None`: nothing.
    pub dynamics: Option<Dynamics>,
}

impl Sockets {
    /// The sockets that the effects of a scene fill.
    pub fn of(scene: &Scene) -> Self {
        let mut sockets = Self {
            theory: Theory::Full,
            terms: Vec::new(),
            flow_factors: Vec::new(),
            pressure_law: PressureLaw::Constant,
            form: Form::Conservative,
            film_thickness: Vec::new(),
            profiles: Vec::new(),
            liner: None,
            inlet_fraction: None,
            cavitation: Cavitation::None,
            contact: None,
            centre_velocity: CentreVelocity::default(),
            tilt_rate: [0.0; 2],
            load: None,
            tilting: None,
            thermal: None,
            dynamics: None,
        };
        present(scene).for_each(|effect| (effect.install)(scene, &mut sockets));
        sockets
    }

    /// The shapes of bore and journal.
    ///
    /// # Errors
    /// The table of a measured one cannot be used.
    pub fn profiles(&self) -> Result<Vec<Arc<dyn Profile>>, CompileError> {
        let made = self.profiles.iter().map(|profile| profile());
        made.collect::<Result<_, _>>().map_err(CompileError::Surface)
    }

    /// Force and moment under which position and tilt are found; `None` at a given position.
    pub fn load(&self) -> Option<Load> {
        let tilting = self.tilting;
        self.load.map(|force| Load { force, tilting })
    }
}
