//! What is measured on a solved film.

use oilwedge_bearing::Dynamics;
use oilwedge_reynolds::error_bar::sharp::Sharpened;
use oilwedge_reynolds::quantities::cavity::{self, Cavity};
use oilwedge_reynolds::quantities::contact;
use oilwedge_reynolds::quantities::deflection::deflection_max;
use oilwedge_reynolds::quantities::extent::{Extent, extent};
use oilwedge_reynolds::quantities::flow::{self, Flows};
use oilwedge_reynolds::quantities::inlet::inlet_flow;
use oilwedge_reynolds::quantities::load::{self, Load, Share};
use oilwedge_reynolds::quantities::power::{self, Power};
use oilwedge_reynolds::quantities::pressure::{self, Extremes};
use oilwedge_reynolds::quantities::turbulence::{TurbulentFilm, turbulent_film};
use oilwedge_reynolds::sharp::HillNumbers;
use oilwedge_reynolds::{Fallback, FilmProblem, Gap, JournalState, SolvedFilm, Thinnest};

use crate::film::Film;

/// Tension below this fraction of the pressure of drag is rounding.
const NO_TENSION: f64 = 1e-12;

/// Tension below this fraction of the range of pressure may be that of the interpolation.
const TENSION: f64 = 1e-5;

/// What contact carries.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct ContactShare {
    /// Force, moment and `Int p_a dA`.
    pub share: Share,
    /// Error of integration of the force [N].
    pub unsure: f64,
}

/// Everything measured on one film.
#[derive(Debug, Clone)]
pub struct Measured {
    /// Load and its shares.
    pub load: Load,
    /// What contact carries; none where it is not simulated.
    pub contact: Option<ContactShare>,
    /// Extremes of pressure.
    pub extremes: Extremes,
    /// Flows by region.
    pub flows: Flows,
    /// Flow into the loaded film [m3/s]; none at rest.
    pub inlet_flow: Option<f64>,
    /// Powers, put in and turned into heat.
    pub power: Power,
    /// What turbulence makes of the film; none of a laminar one.
    pub turbulence: Option<TurbulentFilm>,
    /// The thinnest film on the liner.
    pub thinnest: Thinnest,
    /// Greatest deflection of the wall [m]; none of a rigid one.
    pub deflection: Option<f64>,
    /// Where the loaded film begins and ends on the mid-plane; none without a cavity.
    pub extent: Option<Extent>,
    /// The cavity, of models that have one while they solve.
    pub cavity: Option<Cavity>,
    /// Share of the meshed area [1] below the pressure of the ends, of a full Sommerfeld film with tension; else zero.
    pub under_tension: f64,
    /// Ways out that the solver had to take.
    pub fallbacks: Vec<Fallback>,
    /// How the film answers to small motions of its journal, or why that could not be computed; none where it is not
    /// asked.
    pub dynamics: Option<Result<Dynamics, oilwedge_fem::Error>>,
}

impl Measured {
    /// How the film answers to small motions of its journal; none where that is not asked, or could not be computed.
    pub fn dynamics(&self) -> Option<&Dynamics> {
        self.dynamics.as_ref()?.as_ref().ok()
    }

    /// What the journal puts in as its centre moves and its axis turns [W].
    pub fn motion_power(&self, journal: &JournalState) -> f64 {
        motion_power(journal, &self.load)
    }

    /// The numbers with what is asked of `film` about small motions of its journal, found on the `solved` one that was
    /// measured: at the frequencies of another film that stands for it too, if there is one.
    pub fn with_dynamics(self, film: &Film, solved: &SolvedFilm, beside: Option<&Self>) -> Self {
        let of = || {
            let asked = film.model.sockets.dynamics.as_ref()?;
            Some(match beside {
                Some(other) => Dynamics::beside(solved, other.dynamics()?),
                None => Dynamics::of(solved, &asked.whirl),
            })
        };
        Self { dynamics: of(), ..self }
    }

    /// The numbers that a hill may sharpen.
    pub(crate) fn as_hill(&self) -> HillNumbers {
        HillNumbers { load: self.load.total, greatest: self.extremes.greatest }
    }

    /// Takes the numbers of the hill that are better than those of the film.
    pub(crate) fn sharpen(&mut self, problem: &FilmProblem, by: &Sharpened) {
        if let Some(load) = by.load {
            self.load.total = load;
            let of_oil = self.load.of_oil().resultant();
            self.power.pressure = self.power.with_moment(problem, of_oil).pressure;
        }
        if let Some(greatest) = by.greatest {
            self.extremes.greatest = greatest;
        }
    }
}

/// Measures a solved film.
pub fn measure(film: &SolvedFilm) -> Measured {
    let SolvedFilm { problem, system, solution } = film;
    let extremes = pressure::extremes(film);
    let load = load::load(film);
    let contact = load.contact.map(|share| ContactShare { unsure: contact::unsure(problem, system, &share), share });
    Measured {
        power: powers(film, &load),
        contact,
        load,
        flows: flow::flows(film),
        inlet_flow: inlet_flow(film),
        turbulence: turbulent_film(film),
        thinnest: Gap::of(problem, system).thinnest_film(problem, system),
        deflection: deflection_max(problem, system),
        extent: extent(film, &extremes),
        cavity: problem.cavitation.has_free_boundary().then(|| cavity::cavity(film)),
        under_tension: match problem.cavitation.bears_tension() && has_tension(problem, &extremes) {
            true => cavity::share_below(film, problem.bearing.end_pressure),
            false => 0.0,
        },
        extremes,
        fallbacks: solution.fallbacks.clone(),
        dynamics: None,
    }
}

/// Powers of a film under its load.
pub(crate) fn powers(film: &SolvedFilm, load: &Load) -> Power {
    let thrust = load.contact.map_or(0.0, |contact| contact.pressure);
    let by_moment = power::power(film).with_moment(&film.problem, load.of_oil().resultant());
    by_moment.with_contact(&film.problem, thrust)
}

/// What a journal puts in as its centre moves and its axis turns under a load [W].
pub(crate) fn motion_power(journal: &JournalState, load: &Load) -> f64 {
    let product = |[x, y]: [f64; 2], [by_x, by_y]: [f64; 2]| x * by_x + y * by_y;
    product(journal.velocity, load.total.force) + product(journal.tilt_rate, load.total.moment)
}

/// True if the pressure falls below that of the ends by more than rounding and interpolation explain.
fn has_tension(problem: &FilmProblem, extremes: &Extremes) -> bool {
    // A centred journal makes no pressure: what is left of its drag then is rounding.
    let tension = problem.bearing.end_pressure - extremes.least;
    tension > (TENSION * (extremes.greatest - extremes.least)).max(NO_TENSION * drag(problem))
}

/// Pressure [Pa] that drag through the clearance makes.
pub(crate) fn drag(problem: &FilmProblem) -> f64 {
    let slenderness = problem.bearing.radius / problem.bearing.clearance;
    problem.lubricant.viscosity * problem.journal.speed.abs() * slenderness.powi(2)
}

/// Load [N] that the pressures of the film could carry, all on one side.
pub fn possible_load(problem: &FilmProblem, measured: &Measured) -> f64 {
    load::possible_load(problem, &measured.load.total)
}
