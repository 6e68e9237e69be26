//! One film, compiled: what is simulated, chosen once; and its solution.

use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::factorization::LazyAnalysis;
use oilwedge_fem::integrate::Nodal;
use oilwedge_fem::kink_rule::Kink;
use oilwedge_fem::linear_solver::MultigridSolver;
use oilwedge_fem::newton::{self, NewtonStep, Seconds};
use oilwedge_fem::ordering::elimination_order;
use oilwedge_fem::{
    Analysis, Assembler, ControlVolumes, LinearProlongation, LinearSolver, Linearisation, Prolongation, Space,
    UnsymmetricAnalysis,
};
use oilwedge_mesh::Mesh;
use oilwedge_mesh::quality::needle_share;

use crate::cavitation::FilmFraction;
use crate::contact::{Contact, Fineness};
use crate::film_thickness::{FilmContribution, Follows};
use crate::flow_factors::{FlowFactor, FlowScales};
use crate::levels::CoarseLevel;
use crate::lubricant::{Lubricant, PressureLaw};
use crate::supply::{Supply, SupplyError, SupplyRegion};
use crate::terms::Term;
use crate::wall::{GapTangent, Grid, Pressing};
use crate::{Bearing, Cavitation, Fallback, JournalState, Storage, Theory, ViscosityAcross};

/// Unknowns from which on systems are solved by multigrid: half the memory and both cores from there on. On one core a
/// factor is as quick at ten thousand unknowns; a film of a hundred thousand takes it 1.1 times as long, one with a
/// cavity 1.3 times (docs/performance.md).
const WORTH_MULTIGRID: usize = 8_000;
/// Unknowns from which on multigrid replaces a factor that serves many right-hand sides.
const WORTH_MULTIGRID_OFTEN: usize = 150_000;
/// A triangle with a longer edge than this many times the height on it is a needle.
const NEEDLE: f64 = 5.0;
/// A mesh with this share of needles slows multigrid down.
const MANY_NEEDLES: f64 = 0.02;

/// How viscosity that depends on pressure enters the equation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Viscosity under the divergence, as mass balance has it; the unknown is the reduced pressure q.
    Conservative,
    /// Viscosity on the right-hand side, `div(h^3/(12 mu0) grad p) = mu(p)/mu0 div(U h/2)`, as the FlexPDE study prints
    /// it; the unknown is p. No mass balance; it has a fold and no solution past it.
    AsPrinted,
}

/// A film for a given journal state: one entry a socket, lists where contributions add up.
#[derive(Debug, Clone)]
pub struct FilmProblem {
    /// Dimensions and end pressure.
    pub bearing: Bearing,
    /// The directions in which pressure drives oil.
    pub theory: Theory,
    /// Position and rotation of the journal.
    pub journal: JournalState,
    /// Film thickness: a sum.
    pub film_thickness: Vec<Arc<dyn FilmContribution>>,
    /// The oil.
    pub lubricant: Lubricant,
    /// How its viscosity varies across the film; `None`: it does not.
    pub viscosity_across: Option<Arc<ViscosityAcross>>,
    /// How its viscosity enters.
    pub form: Form,
    /// Fluxes: a sum.
    pub terms: Vec<Arc<dyn Term>>,
    /// What scales them, where surfaces are not smooth or the flow is turbulent: a product.
    pub flow_factors: Vec<Arc<dyn FlowFactor>>,
    /// What closes the law where the film breaks.
    pub cavitation: Cavitation,
    /// What a film that conserves oil held before; `None`: it is steady, or its thickness alone changes.
    pub storage: Option<Arc<Storage>>,
    /// Contact of rough surfaces; `None`: they do not touch.
    pub contact: Option<Contact>,
}

/// Everything that depends on mesh and supply only: numbered, analysed once, used for every solve.
#[derive(Debug)]
pub struct FilmSystem {
    /// Assembles on the space of the unknown.
    pub assembler: Arc<Assembler>,
    /// Regions where pressure is given.
    pub supply: Supply,
    /// The next coarser mesh, to start from; none where a solve needs no start.
    pub coarser: Option<Box<CoarseLevel>>,
    /// The analysed pattern of the Cholesky factor.
    pub(crate) analysis: Arc<LazyAnalysis>,
    /// Unknowns from which on multigrid is worth while.
    pub(crate) worth_multigrid: usize,
    /// Prolongation that is made when a film is first solved; none where multigrid does not serve.
    pub(crate) between: OnceLock<Option<Arc<LinearProlongation>>>,
    /// Control volumes that are made when a mass-conserving film is first solved.
    pub(crate) volumes: OnceLock<Result<Arc<ControlVolumes>, oilwedge_fem::Error>>,
    /// The analysed pattern of the LU factor of a hill, made when one is first solved.
    pub(crate) unsymmetric: OnceLock<Result<Arc<UnsymmetricAnalysis>, oilwedge_fem::Error>>,
    /// What presses on the grids of a wall, made when it first gives way.
    pub(crate) pressing: Mutex<Vec<Arc<Pressing>>>,
    /// Cubic elements, made when an error bar is first estimated.
    pub(crate) cubic: OnceLock<Box<CubicSystem>>,
    /// System of the vertices alone, made when the error of a mass-conserving film is first judged.
    pub(crate) vertices: OnceLock<Arc<FilmSystem>>,
}

/// The mesh and supply of this system with cubic elements.
#[derive(Debug)]
pub struct CubicSystem {
    /// Assembles cubic elements; never factorised.
    pub system: Arc<FilmSystem>,
    /// Prolongation from quadratic elements.
    pub prolongation: Arc<Prolongation>,
}

impl FilmSystem {
    /// Elements of degree `degree` on `mesh`, with pressures given on `regions`.
    ///
    /// # Errors
    /// Every misfit of mesh and regions.
    pub fn new(mesh: Arc<Mesh>, degree: usize, regions: Vec<SupplyRegion>) -> Result<Self, Vec<SupplyError>> {
        let space = Space::new(mesh, degree);
        let supply = Supply::new(&space, regions)?;
        Ok(Self::with_supply(space, supply))
    }

    /// The system of `space` with given pressures.
    pub(crate) fn with_supply(space: Space, supply: Supply) -> Self {
        let assembler = Assembler::new(space);
        let analysis = LazyAnalysis::new(assembler.space().clone(), assembler.pattern().clone());
        Self {
            assembler: Arc::new(assembler),
            supply,
            coarser: None,
            analysis: Arc::new(analysis),
            worth_multigrid: WORTH_MULTIGRID,
            between: OnceLock::new(),
            volumes: OnceLock::new(),
            unsymmetric: OnceLock::new(),
            pressing: Mutex::default(),
            cubic: OnceLock::new(),
            vertices: OnceLock::new(),
        }
    }

    /// The analysed pattern of the Cholesky factor.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn analysis(&self) -> Result<&Arc<Analysis>, oilwedge_fem::Error> {
        self.analysis.get()
    }

    /// The system for many solves of neighbouring films, as the search for a position makes them.
    pub fn for_many_solves(mut self) -> Self {
        self.worth_multigrid = WORTH_MULTIGRID_OFTEN;
        self
    }

    /// How linear systems are solved that come without another one: by a factor where there are few unknowns, and on
    /// meshes of needles, which multigrid does not serve; else by multigrid.
    pub(crate) fn solver(&self) -> Result<LinearSolver, oilwedge_fem::Error> {
        let between = self.between.get_or_init(|| {
            let serves = self.space().degree() == 2
                && self.space().dofs() >= self.worth_multigrid
                && needle_share(self.space().mesh(), NEEDLE) < MANY_NEEDLES;
            serves.then(|| Arc::new(LinearProlongation::new(self.space(), self.assembler.pattern().clone())))
        });
        Ok(match between {
            None => LinearSolver::Direct(self.analysis()?.clone()),
            Some(between) => {
                LinearSolver::Multigrid(MultigridSolver { between: between.clone(), direct: self.analysis.clone() })
            }
        })
    }

    /// The mesh and supply of this system with cubic elements.
    pub fn cubic(&self) -> &CubicSystem {
        self.cubic.get_or_init(|| {
            let prolongation = Prolongation::new(self.space());
            let cubic = prolongation.cubic().clone();
            let supply = self.supply.on_space(&cubic);
            let system = Arc::new(Self::with_supply(cubic, supply));
            Box::new(CubicSystem { system, prolongation: Arc::new(prolongation) })
        })
    }

    /// Cells of the schemes of finite volumes.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn volumes(&self) -> Result<&ControlVolumes, oilwedge_fem::Error> {
        let volumes = self.volumes.get_or_init(|| ControlVolumes::new(self.space()).map(Arc::new));
        volumes.as_deref().map_err(Clone::clone)
    }

    /// The analysed pattern of the LU factor of a hill.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn unsymmetric(&self) -> Result<Arc<UnsymmetricAnalysis>, oilwedge_fem::Error> {
        let analysed = || UnsymmetricAnalysis::new(self.assembler.pattern().clone(), elimination_order(self.space()));
        let analysis = self.unsymmetric.get_or_init(|| analysed().map(Arc::new));
        analysis.clone()
    }

    /// What a pressure at the dofs exerts on the grid of a wall.
    pub(crate) fn pressing(&self, grid: &Grid) -> Arc<Pressing> {
        let mut made = self.pressing.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = made.iter().find(|pressing| pressing.is_on(grid)) {
            return known.clone();
        }
        let pressing = Arc::new(Pressing::new(self.space(), grid));
        // A wall has two grids; those of walls before are not needed again.
        if made.len() > 1 {
            made.remove(0);
        }
        made.push(pressing.clone());
        pressing
    }

    /// The space of the unknown.
    pub fn space(&self) -> &Space {
        self.assembler.space()
    }
}

/// What a solve has found; with its problem and system it is a [`SolvedFilm`](crate::SolvedFilm).
#[derive(Debug, Clone)]
pub struct FilmSolution {
    /// The unknown at each dof [Pa]: reduced pressure q, or p of an as-printed film.
    pub unknown: Vec<f64>,
    /// Volume flow [m3/s] into the film near each dof where pressure is given, and what a Swift-Stieber cavity makes
    /// near its dofs; rounding elsewhere.
    pub inflow: Vec<f64>,
    /// True for each dof held at the cavitation pressure; false everywhere where nothing cavitates.
    pub cavity: Vec<bool>,
    /// How full a mass-conserving film is; none for other models.
    pub film_fraction: Option<FilmFraction>,
    /// The factorised tangent.
    pub linearisation: Arc<Linearisation>,
    /// How its residual changes with a wall that gives way, once that was asked for.
    pub gap_tangent: OnceLock<Arc<GapTangent>>,
    /// Dofs on the wrong side of the edge of the cavity: none of a film that is settled, and not only solved with the
    /// cavity of a step.
    pub wrong: Vec<usize>,
    /// One entry a linear solve on the way.
    pub history: Vec<NewtonStep>,
    /// Time of each part of the solution.
    pub seconds: Seconds,
    /// Films solved on coarser levels to start from.
    pub levels: usize,
    /// Ways out that had to be taken.
    pub fallbacks: Vec<Fallback>,
}

/// What of a solved film is kept to solve it again: it is small beside its factor.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmTrace {
    /// The unknown at each dof [Pa].
    pub unknown: Vec<f64>,
    /// True for each dof held at the cavitation pressure.
    pub cavity: Vec<bool>,
    /// How full a mass-conserving film is; none for other models.
    pub film_fraction: Option<FilmFraction>,
}

impl FilmTrace {
    /// What a solve starts from.
    pub(crate) fn as_start(&self) -> WarmStart {
        WarmStart { u: self.unknown.clone(), held: self.cavity.clone() }
    }
}

impl FilmSolution {
    /// What is kept to solve it again.
    pub fn trace(&self) -> FilmTrace {
        FilmTrace {
            unknown: self.unknown.clone(),
            cavity: self.cavity.clone(),
            film_fraction: self.film_fraction.clone(),
        }
    }

    /// What a solve of a neighbouring film starts from.
    pub(crate) fn as_start(&self) -> WarmStart {
        WarmStart { u: self.unknown.clone(), held: self.cavity.clone() }
    }

    /// A film without a cavity.
    pub(crate) fn full(solution: newton::Solution) -> Self {
        Self {
            cavity: vec![false; solution.u.len()],
            unknown: solution.u,
            inflow: solution.reactions,
            film_fraction: None,
            linearisation: Arc::new(solution.linearisation),
            gap_tangent: OnceLock::new(),
            wrong: Vec::new(),
            history: solution.history,
            seconds: solution.seconds,
            levels: 0,
            fallbacks: Vec::new(),
        }
    }
}

impl FilmProblem {
    /// Velocity `(U_x, U_z)` [m/s] of the journal's surface.
    pub fn surface_velocity(&self) -> [f64; 2] {
        [self.journal.speed * self.bearing.radius, self.journal.axial_velocity]
    }

    /// The factors of its flows.
    pub(crate) fn factors(&self) -> FlowScales<'_> {
        FlowScales { factors: &self.flow_factors, density: self.lubricant.density }
    }

    /// True if the film is laminar, so that its conductance is the same along x and along z.
    pub fn is_laminar(&self) -> bool {
        self.flow_factors.iter().all(|factor| factor.is_laminar())
    }

    /// True if the oil has another gap than its shear: between rough surfaces.
    pub fn is_rough(&self) -> bool {
        self.flow_factors.iter().any(|factor| factor.mean_gap(self.bearing.clearance).is_some())
    }

    /// True if the film follows a slope of the journal's axis, be it zero: moments are of interest then.
    pub fn can_tilt(&self) -> bool {
        (self.film_thickness.iter()).any(|contribution| contribution.follows() == Follows::Tilt)
    }

    /// The unknown at a point where the pressure is `p` [Pa].
    pub fn unknown_at(&self, p: f64) -> f64 {
        match self.form {
            Form::Conservative => self.lubricant.pressure_law.reduced_pressure(p),
            Form::AsPrinted => p,
        }
    }

    /// The kink of the effective pressure in a triangle where the unknown of one or several films has these values at
    /// the nodes.
    pub(crate) fn kink<'a, const N: usize>(&self, functions: [&'a Nodal; N]) -> Kink<'a, N> {
        Kink { level: self.cavitation.kink().map(|p| self.unknown_at(p)), functions }
    }

    /// This problem with its contact, if there is one, integrated so finely.
    pub fn with_contact(self, fineness: Fineness) -> Self {
        Self { contact: self.contact.map(|contact| Contact { fineness, ..contact }), ..self }
    }

    /// Whether the pressure that the film exerts is its unknown: viscosity is constant, and no pressure is dropped.
    pub(crate) fn has_linear_pressure(&self) -> bool {
        self.lubricant.pressure_law == PressureLaw::Constant && self.cavitation.kink().is_none()
    }

    /// The pressure [Pa] that the film exerts where the unknown is `u`.
    pub fn pressure_at(&self, u: f64) -> f64 {
        self.cavitation.effective_pressure(self.equation_pressure(u))
    }

    /// Derivative of [`FilmProblem::pressure_at`] by the unknown [-].
    pub fn pressure_slope_at(&self, u: f64) -> f64 {
        let p = self.equation_pressure(u);
        match self.form {
            _ if self.cavitation.effective_pressure(p) != p => 0.0,
            Form::Conservative => self.lubricant.pressure_law.viscosity_ratio(p),
            Form::AsPrinted => 1.0,
        }
    }

    /// The pressure [Pa] that the equation gives where the unknown is `u`.
    pub fn equation_pressure(&self, u: f64) -> f64 {
        match self.form {
            Form::Conservative => self.lubricant.pressure_law.pressure(u),
            Form::AsPrinted => u,
        }
    }

    /// Viscosity [Pa s] at the pressure `p` [Pa].
    pub fn viscosity_at(&self, p: f64) -> f64 {
        self.lubricant.viscosity * self.lubricant.pressure_law.viscosity_ratio(p)
    }

    /// Viscosity [Pa s] of the film at a dof and the pressure `p` [Pa]: where it varies across the film, that by which
    /// pressure drives oil.
    pub fn viscosity_at_dof(&self, p: f64, dof: usize) -> f64 {
        match &self.viscosity_across {
            None => self.viscosity_at(p),
            Some(across) => across.viscosity(dof) * self.lubricant.pressure_law.viscosity_ratio(p),
        }
    }

    /// The film on the vertices of the mesh alone ([`crate::FilmSystem::on_vertices`]).
    pub fn on_vertices(&self) -> Self {
        let viscosity_across = self.viscosity_across.as_ref().map(|across| Arc::new(across.on_vertices()));
        Self { viscosity_across, ..self.clone() }
    }
}
