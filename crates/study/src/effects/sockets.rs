//! The sockets of a film: what the effects of a scene put there.

use std::fmt::Debug;
use std::sync::Arc;

use oilwedge_bearing::{JournalLoad, Tilting};
use oilwedge_mesh::Mesh;
use oilwedge_reynolds::contact::Contact;
use oilwedge_reynolds::film_thickness::{Deflection, FilmContribution, GrooveDepth};
use oilwedge_reynolds::flow_factors::FlowFactor;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::terms::Term;
use oilwedge_reynolds::wall::Wall;
use oilwedge_reynolds::{Bearing, Cavitation, CentreVelocity, Form, Theory};
use oilwedge_scene::{Bore, DynamicsTable, JournalShape, RoelandsTable};

use crate::compile_error::CompileError;
use crate::thermal_model::{HeatFieldModel, ThermalModel};
use crate::warning::Warning;

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

/// A contribution to the thickness of a film beside that of the journal's offset.
#[derive(Debug, Clone)]
pub enum Contribution {
    /// The contribution is the same on every mesh.
    Given(Arc<dyn FilmContribution>),
    /// The film is deeper by a length [m] in the region of the mesh with this name.
    Deeper(String, f64),
}

impl Contribution {
    /// The contribution on a mesh.
    pub(crate) fn on(&self, mesh: &Mesh) -> Arc<dyn FilmContribution> {
        match self {
            Self::Given(contribution) => contribution.clone(),
            Self::Deeper(region, depth) => {
                let mut inside = vec![false; mesh.triangles().len()];
                for &cell in mesh.region(region).map_or(&[][..], |region| &region.cells) {
                    inside[cell as usize] = true;
                }
                Arc::new(GrooveDepth { depth: *depth, inside })
            }
        }
    }
}

/// How viscosity grows with pressure, at any temperature.
#[derive(Debug, Clone, PartialEq)]
pub enum PressureRule {
    /// The law does not depend on the viscosity at no pressure.
    Fixed(PressureLaw),
    /// Roelands' law, which does.
    Roelands(RoelandsTable),
}

/// A surface that is no circle.
#[derive(Debug, Clone)]
pub enum ShapedSurface {
    /// The bore.
    Bore(Bore),
    /// The journal.
    Shaft(JournalShape),
}

/// How the wall of a bearing gives way to pressure.
pub trait WallModel: Debug + Send + Sync {
    /// The wall of a bearing.
    ///
    /// # Errors
    /// [`CompileError::Wall`]: a table cannot be used.
    fn wall(&self, bearing: &Bearing) -> Result<Wall, CompileError>;

    /// Whether slices across the axis move by themselves.
    fn has_slices(&self) -> bool {
        true
    }

    /// Why it is no model of the wall of a bearing that bends so.
    fn warning(&self, _bearing: &Bearing, _deflection: &Deflection) -> Option<Warning> {
        None
    }
}

/// The sockets of one film.
#[derive(Debug, Clone)]
pub struct Sockets {
    /// The directions in which pressure drives oil.
    pub theory: Theory,
    /// Fluxes and sources.
    pub terms: Vec<Arc<dyn Term>>,
    /// What scales them.
    pub flow_factors: Vec<Arc<dyn FlowFactor>>,
    /// Growth of viscosity with pressure.
    pub pressure_rule: PressureRule,
    /// Place of the viscosity in the equation.
    pub form: Form,
    /// Contributions to the film thickness beside that of the journal.
    pub film_thickness: Vec<Contribution>,
    /// Surfaces of bore and journal that are no circles.
    pub surfaces: Vec<ShapedSurface>,
    /// How the wall gives way to the pressure; `None`: it is rigid.
    pub wall: Option<Arc<dyn WallModel>>,
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
    /// How temperatures are found across the film; `None`: it has one temperature.
    pub heat_field: Option<HeatFieldModel>,
    /// What is asked about small motions of the journal; `None`: nothing.
    pub dynamics: Option<DynamicsTable>,
}

impl Sockets {
    /// Sockets without an entry.
    pub(super) fn empty() -> Self {
        Self {
            theory: Theory::Full,
            terms: Vec::new(),
            flow_factors: Vec::new(),
            pressure_rule: PressureRule::Fixed(PressureLaw::Constant),
            form: Form::Conservative,
            film_thickness: Vec::new(),
            surfaces: Vec::new(),
            wall: None,
            inlet_fraction: None,
            cavitation: Cavitation::None,
            contact: None,
            centre_velocity: CentreVelocity::default(),
            tilt_rate: [0.0; 2],
            load: None,
            tilting: None,
            thermal: None,
            heat_field: None,
            dynamics: None,
        }
    }

    /// Whether a temperature is found, one for the film or all across it.
    pub fn finds_temperature(&self) -> bool {
        self.thermal.is_some() || self.heat_field.is_some()
    }

    /// Force and moment under which position and tilt are found; `None` at a given position.
    pub fn load(&self) -> Option<JournalLoad> {
        let tilting = self.tilting;
        self.load.map(|force| JournalLoad { force, tilting })
    }
}
