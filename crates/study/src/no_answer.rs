//! Why a scene has no film, no position or no temperature, and the way out.

use oilwedge_bearing::heat_round::NoRound;
use oilwedge_bearing::orbit::NoOrbit;
use oilwedge_bearing::{BranchLimit, NoEquilibrium, Waypoint};
use oilwedge_fem::newton::NewtonFailure;
use oilwedge_heat::NetworkFailure;
use oilwedge_reynolds::NoFilm;
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::lubricant::LawKind;
use oilwedge_scene::wording::celsius;

use crate::reasons::flags::MORE_SECONDS;
use crate::reasons::{Cause, Limit};

/// Way out of an orbit whose load needs pressures beyond the viscosity law.
const PAST_LAW: &str = "lower the load, use a viscosity law that grows slower ([oil] roelands, or a smaller alpha), or give a finer mesh ([mesh] size)";

/// Why there is nothing to report.
#[derive(Debug)]
pub enum NoAnswer {
    /// No film at the given position.
    Film(NoFilm),
    /// No position for the load.
    Equilibrium(NoEquilibrium),
    /// No orbit.
    Orbit(NoOrbit),
    /// No temperature at which the balance closes.
    Temperature(NoTemperature),
    /// A limit or an interrupt came before the first film, on a mesh with so many unknowns.
    NotBegun {
        /// Unknowns of the mesh.
        unknowns: usize,
    },
}

impl From<NoFilm> for NoAnswer {
    fn from(reason: NoFilm) -> Self {
        Self::Film(reason)
    }
}

impl From<NoEquilibrium> for NoAnswer {
    fn from(reason: NoEquilibrium) -> Self {
        Self::Equilibrium(reason)
    }
}

impl std::fmt::Display for NoAnswer {
    /// The reason, and what can be done about it.
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Film(reason) => reason.fmt(out),
            Self::Equilibrium(reason) => reason.fmt(out),
            Self::Orbit(reason) => reason.fmt(out),
            Self::Temperature(reason) => reason.fmt(out),
            Self::NotBegun { unknowns } => {
                write!(out, "the film on the first mesh, of {unknowns} unknowns, was not begun")
            }
        }?;
        way_out(self).map_or(Ok(()), |way_out| write!(out, "; {way_out}"))
    }
}

impl std::error::Error for NoAnswer {}

impl NoAnswer {
    /// The reason, with the cause where a limit or an interrupt ended the search.
    pub(crate) fn told(&self, cause: Cause) -> String {
        let limit = match self {
            Self::Orbit(NoOrbit::Ended { angle }) => Limit::FirstCycle(*angle, cause),
            Self::Temperature(NoTemperature::Ended { nearest }) => match nearest {
                Some(powers) => Limit::Temperature(powers.left_over(), cause),
                None => Limit::FirstTemperature(cause),
            },
            Self::NotBegun { unknowns } => Limit::FirstMesh(*unknowns, cause),
            Self::Equilibrium(NoEquilibrium::Ended { asked, nearest, .. }) => {
                Limit::FirstPosition([*nearest, *asked], cause)
            }
            _ => return self.to_string(),
        };
        limit.to_string()
    }

    /// True if an answer may exist but was not reached.
    pub fn is_unreached(&self) -> bool {
        match self {
            Self::Film(reason) => reason.is_unreached(),
            Self::Equilibrium(reason) => reason.is_unreached(),
            Self::Orbit(reason) => reason.is_unreached(),
            Self::Temperature(reason) => reason.is_unreached(),
            Self::NotBegun { .. } => true,
        }
    }

    /// True if a finer mesh would show no more: the load is far beyond what the film carries.
    pub fn is_far_beyond(&self) -> bool {
        matches!(self, Self::Equilibrium(reason) if reason.is_far_beyond())
    }

    /// True if a finer mesh may show a balance where this one shows contact, or a journal that tips over.
    pub fn is_undecided(&self) -> bool {
        matches!(self, Self::Equilibrium(reason) if reason.is_undecided())
    }

    /// True if the journal tips over.
    pub fn is_tilt_limit(&self) -> bool {
        matches!(self, Self::Equilibrium(NoEquilibrium::Branch(end)) if end.limit == BranchLimit::Fold)
    }

    /// Where another mesh takes up the way of a growing moment, if that was followed.
    pub fn way(&self) -> Option<&Waypoint> {
        match self {
            Self::Equilibrium(reason) => reason.way(),
            Self::Film(_) | Self::Orbit(_) | Self::Temperature(_) | Self::NotBegun { .. } => None,
        }
    }

    /// True if the mesh cannot resolve on which side of the limit of the viscosity law the film is.
    pub fn is_near_limit(&self) -> bool {
        let (Self::Film(film) | Self::Equilibrium(NoEquilibrium::Film(film))) = self else {
            return false;
        };
        matches!(film, NoFilm::NearLimit { .. } | NoFilm::AtFold { .. })
    }
}

/// Why there is no temperature at which the heat is balanced.
#[derive(Debug, thiserror::Error)]
pub enum NoTemperature {
    /// The search was ended.
    #[error("the search for the temperature was ended{}", nearest.as_ref().map_or_else(String::new, at_its_temperature))]
    Ended {
        /// The last film found, if there is one.
        nearest: Option<PowersAt>,
    },
    /// Friction heats the film to a temperature beyond which none is found.
    #[error(
        "no temperature balances the heat: at {} {last}, and there is no film beyond: {reason}",
        celsius(last.temperature)
    )]
    NoFilmBeyond {
        /// The last film found.
        last: PowersAt,
        /// Why there is none beyond.
        reason: Box<NoAnswer>,
    },
    /// Runs at one temperature after the other lead to none that balances the heat.
    #[error(
        "not converged: {runs} runs at one temperature after the other have not balanced the heat: at {} {last}; give a finer mesh ([mesh] size), or a smaller orbit.tolerance",
        celsius(last.temperature)
    )]
    NotFound {
        /// How many runs there were.
        runs: usize,
        /// The film of the last one.
        last: PowersAt,
    },
    /// A round of the temperatures across the film has none.
    #[error("{}", told_of_heat(.0))]
    NoRound(NoRound),
    /// Too much heat is carried along for the layers across the film to follow.
    #[error(
        "no temperatures across the film: its Graetz number of {} is beyond what 8 layers follow, 4096; lower the pressure of the feeds or the speed, or leave out heat.field",
        readable(*graetz)
    )]
    Graetz {
        /// Graetz number [1].
        graetz: f64,
    },
    /// Temperatures across the film do not come to rest.
    #[error(
        "not converged: after {rounds} rounds the temperatures across the film still change by {change:.2e} K; give a finer mesh ([mesh] size), or heat.layers = 6"
    )]
    NotClosed {
        /// Change of the last round [K].
        change: f64,
        /// Rounds.
        rounds: usize,
    },
    /// The greatest temperature that is sought balances nothing yet.
    #[error(
        "no temperature balances the heat: at {} still {hottest}; feed more oil, or give [heat] housing",
        celsius(hottest.temperature)
    )]
    TooHot {
        /// The film there.
        hottest: PowersAt,
    },
}

impl NoTemperature {
    /// True if there may be one.
    fn is_unreached(&self) -> bool {
        match self {
            Self::Ended { .. } | Self::NotFound { .. } | Self::NotClosed { .. } => true,
            Self::NoFilmBeyond { reason, .. } => reason.is_unreached(),
            Self::TooHot { .. } | Self::Graetz { .. } => false,
            Self::NoRound(reason) => *reason != NoRound::MakesOil,
        }
    }
}

/// Why a round has no temperatures.
fn told_of_heat(reason: &NoRound) -> String {
    let why = match reason {
        NoRound::MakesOil => {
            return "no temperatures across the film: it makes oil; give [cavitation] the model jfo".to_owned();
        }
        NoRound::TooLarge(error) => error.to_string(),
        NoRound::NotSolved(NetworkFailure::DryCell(_)) => "no oil reaches a part of the film".to_owned(),
        NoRound::NotSolved(NetworkFailure::DryFeed(_)) => {
            "no oil flows through a feed; remove it, or raise its pressure".to_owned()
        }
        NoRound::NotSolved(NetworkFailure::Steps { steps, residual }) => {
            format!("their linear system is left with {residual:.1e} after {steps} steps")
        }
    };
    format!("not converged: the temperatures across the film were not found: {why}")
}

/// Power that warms a film, and what takes it off, at one temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PowersAt {
    /// The temperature [K].
    pub temperature: f64,
    /// Power of friction [W].
    pub friction: f64,
    /// What oil and housing take [W].
    pub carried_off: f64,
}

impl PowersAt {
    /// Part of the friction that is not carried off, or is carried off beyond it [1].
    fn left_over(&self) -> f64 {
        (1.0 - self.carried_off / self.friction).abs()
    }
}

impl std::fmt::Display for PowersAt {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { friction, carried_off, .. } = *self;
        write!(out, "friction makes {} W, and {} W are carried off", readable(friction), readable(carried_off))
    }
}

fn at_its_temperature(powers: &PowersAt) -> String {
    format!(": at {} {powers}", celsius(powers.temperature))
}

/// What a user can do about a missing answer; none where nothing is known to help, or the reason says it itself.
fn way_out(reason: &NoAnswer) -> Option<&'static str> {
    let film = match reason {
        NoAnswer::Film(film) | NoAnswer::Equilibrium(NoEquilibrium::Film(film)) => film,
        NoAnswer::Equilibrium(reason) => return of_position(reason),
        NoAnswer::Orbit(NoOrbit::Ended { .. }) => return Some(MORE_SECONDS),
        NoAnswer::Orbit(NoOrbit::Stuck { .. }) => {
            return Some("give a finer mesh ([mesh] size), or a greater orbit.tolerance");
        }
        NoAnswer::Orbit(NoOrbit::Between { .. }) => {
            return Some("give a smaller orbit.tolerance: steps are shorter then");
        }
        NoAnswer::Orbit(NoOrbit::SqueezedOut { .. } | NoOrbit::SqueezedOutOnShaft { .. }) => {
            return Some(
                "give a finer mesh ([mesh] size), for a coarse one carries less where the film is thin; else lower the load, or raise speed, viscosity or size",
            );
        }
        NoAnswer::Orbit(NoOrbit::OffShell { .. } | NoOrbit::AtOpening { .. }) => {
            return Some("give a wider bearing.arc, or turn it under the load");
        }
        NoAnswer::Orbit(NoOrbit::AtLimit { .. }) => return Some(PAST_LAW),
        NoAnswer::Orbit(NoOrbit::Film { reason: NoFilm::AboveLimit { .. } | NoFilm::NearLimit { .. }, .. }) => {
            return Some(PAST_LAW);
        }
        NoAnswer::Orbit(NoOrbit::Film { reason, .. }) => reason,
        NoAnswer::Temperature(NoTemperature::Ended { .. }) => return Some(MORE_SECONDS),
        NoAnswer::Temperature(_) => return None,
        NoAnswer::NotBegun { .. } => return Some(MORE_SECONDS),
    };
    Some(match film {
        NoFilm::AboveLimit { law: LawKind::Roelands, .. } => {
            "lower speed, eccentricity or viscosity, or give Roelands' law a smaller exponent (oil.roelands.z or alpha)"
        }
        NoFilm::AboveLimit { .. } => {
            "lower speed, eccentricity or viscosity, or use a law that grows slower (Roelands)"
        }
        NoFilm::NearLimit { .. } => "give a finer mesh ([mesh] size or tolerance), or another speed",
        NoFilm::AtFold { .. } => {
            "give a finer mesh ([mesh] size or tolerance), another speed, or form = \"conservative\""
        }
        NoFilm::BelowFloor { .. } => "add [cavitation]",
        NoFilm::Fold { .. } => "lower speed or eccentricity, or use form = \"conservative\"",
        NoFilm::NoSupply { .. } => "add a [[feed]], a film_start, or ends above cavitation.pressure",
        NoFilm::FilmFraction { .. } => {
            "use another mesh, without obtuse angles and finer where the film is thin ([mesh] size draws one)"
        }
        NoFilm::Wall { .. } => {
            "give a stiffer liner or a smaller eccentricity to see the film, or another mesh ([mesh] size)"
        }
        // It says itself what is wrong.
        NoFilm::NotConverged(NewtonFailure::Linear { .. }) => return None,
        NoFilm::NotConverged(_) => "another mesh ([mesh] size) may help",
        _ => return None,
    })
}

fn of_position(reason: &NoEquilibrium) -> Option<&'static str> {
    match reason {
        NoEquilibrium::Unreachable { .. } => {
            Some("change the load, its angle, the tilt where one is given, or the pressure and place of feeds")
        }
        NoEquilibrium::Branch(end) => Some(match (end.is_tilting, reason.is_unreached()) {
            (false, false) => "lower the load, or raise speed, viscosity or size",
            (false, true) => {
                "a finer mesh ([mesh] size) may show that all is carried; or lower the load, or raise speed, viscosity or size"
            }
            (true, true) => {
                "a finer mesh ([mesh] size) may show that all is carried; or move the load towards the middle, lower its moment, or give [support] a greater tilt_stiffness"
            }
            (true, false) => {
                "move the load towards the middle, lower its moment, or give [support] a greater tilt_stiffness"
            }
        }),
        NoEquilibrium::BelowRounding { .. } => Some("give no load (0 N), or a larger one"),
        NoEquilibrium::NotConverged { .. } => {
            Some("give another mesh ([mesh] size), or solve at a given position to see the film")
        }
        NoEquilibrium::Ended { .. } => Some(MORE_SECONDS),
        _ => None,
    }
}
