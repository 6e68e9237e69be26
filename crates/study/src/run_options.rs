//! What a caller asks of a run.

use oilwedge_bearing::{Clock, Deadline, Interrupt};

use oilwedge_scene::Scene;

use crate::observer::{RunObserver, Watch};
use crate::picture::PictureOptions;
use crate::reasons::Cause;
use crate::solved::Errors;

/// How a scene is run.
#[derive(Debug, Clone, Copy)]
pub struct RunOptions {
    /// How the film is drawn.
    pub picture: PictureOptions,
    /// Estimate error bars. Without them a tolerance that the scene does not give itself is dropped.
    pub bars: bool,
    /// The refinement towards a tolerance and the search for a position under a load end after this time [s], infinite
    /// for none.
    pub max_seconds: f64,
    /// What counts these seconds: the processor those of the usual limit, the wall those of a limit that a caller
    /// gives.
    pub clock: Clock,
    /// No mesh of that refinement has more unknowns, but for one that the scene gives.
    pub max_unknowns: usize,
    /// Films of the cycle of an orbit that are drawn, at even crank angles; none where no orbit is followed.
    pub frames: u32,
    /// Solve films at temperatures around the one found, too: the curves of friction and heat.
    pub curve: bool,
    /// An orbit that an earlier run has left, which is continued; `None`: it begins anew.
    pub earlier: Option<EarlierOrbit>,
    /// Ends them as well.
    pub interrupt: Interrupt,
    /// Notified of each mesh, position and temperature.
    pub observer: Option<&'static dyn RunObserver>,
}

/// An orbit that an earlier run has left before it was closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EarlierOrbit {
    /// Complete cycles of the orbit.
    pub cycles: usize,
    /// Where the last of them ended, over the clearance [1], as in [`crate::orbit::OrbitFacts::end`].
    pub end: [f64; 4],
}

impl RunOptions {
    /// The usual ones for a scene. A mesh that is given, and not refined towards a tolerance, takes the time that it
    /// takes.
    pub fn of(scene: &Scene) -> Self {
        let usual = Self::default();
        Self {
            max_seconds: match scene.tolerance {
                Some(_) => usual.max_seconds,
                None => f64::INFINITY,
            },
            ..usual
        }
    }

    /// The options with a limit of the caller [s] in place of the usual one, if there is one.
    pub fn limited(self, seconds: Option<f64>) -> Self {
        seconds.map_or(self, |max_seconds| Self { max_seconds, clock: Clock::Wall, ..self })
    }

    /// How long a run that begins now may search.
    pub fn deadline(&self) -> Deadline {
        Deadline::by(self.clock, self.max_seconds, self.interrupt)
    }

    /// The deadline of a run that begins now, and its observer.
    pub fn watch(&self) -> Watch {
        Watch { deadline: self.deadline(), most_unknowns: self.max_unknowns, observer: self.observer }
    }

    /// Whether errors are estimated: no longer once the run is interrupted.
    pub fn errors(&self) -> Errors {
        match self.bars && !self.interrupt.is_asked() {
            true => Errors::Estimated,
            false => Errors::Omitted,
        }
    }

    /// What ends a search that ends now.
    pub(crate) fn cause(&self) -> Cause {
        match (self.interrupt.is_asked(), self.clock) {
            (true, _) => Cause::Interrupt,
            (false, Clock::Processor) => Cause::UsualLimit(self.max_seconds),
            (false, Clock::Wall | Clock::Showing(_)) => Cause::GivenLimit(self.max_seconds),
        }
    }
}

impl Default for RunOptions {
    fn default() -> Self {
        Self {
            picture: PictureOptions::default(),
            bars: true,
            max_seconds: 60.0,
            clock: Clock::Processor,
            max_unknowns: 1_000_000,
            frames: 0,
            curve: false,
            earlier: None,
            interrupt: Interrupt::default(),
            observer: None,
        }
    }
}
