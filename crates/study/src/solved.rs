//! A solved film, how it was asked for, and how its position and temperature were found.

use std::borrow::Cow;
use std::collections::HashMap;

use oilwedge_bearing::{Balanced, Coordinates, Deadline, FoundWarmth, InitialGuess, Stiffness, WallByPlace, Work};
use oilwedge_reynolds::{ReferenceFilm, SolvedFilm};

use crate::film::Film;
use crate::observer::{RunObserver, Watch};

/// How a film is solved; by default without an error estimate, from a cold start, without a deadline.
#[derive(Debug, Clone, Copy, Default)]
pub struct SolveOptions<'a> {
    /// Whether errors are to be estimated.
    pub errors: Errors,
    /// Deadline of the searches.
    pub deadline: Deadline,
    /// Position at which a search begins.
    pub guess: InitialGuess<'a>,
    /// Difference of force and load over the load at which a position is found; by default near round-off.
    pub accuracy: Option<f64>,
    /// Notified of each position and temperature tried.
    pub observer: Option<&'static dyn RunObserver>,
}

impl SolveOptions<'_> {
    /// The deadline of the searches for a film, and the observer that is notified of them.
    pub(crate) fn watch(&self) -> Watch {
        Watch { observer: self.observer, ..self.deadline.into() }
    }
}

/// Whether errors are to be estimated.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Errors {
    /// No reference film is solved.
    #[default]
    Omitted,
    /// A reference film is solved.
    Estimated,
}

/// A solved film.
#[derive(Debug)]
pub struct Solved {
    /// The film, at the position and temperature found.
    pub film: Film,
    /// The film, solved.
    pub primary: SolvedFilm,
    /// The film by which errors are estimated; none where they are omitted, or where there is no such film.
    pub reference: Option<ReferenceFilm>,
    /// How the load is balanced, where the position was sought.
    pub balance: Option<BalanceFacts>,
    /// How the wall follows where the journal moves along the coordinates of the balance.
    pub wall: WallByPlace,
    /// The heat of the film, where its temperature was found.
    pub warming: Option<FoundWarmth>,
    /// How the temperature was found, where it was sought.
    pub temperature: Option<TemperatureFound>,
    /// What layers and mesh leave open of each number of a film whose temperatures are found across it, by name.
    pub heat_bars: HashMap<Cow<'static, str>, f64>,
    /// Seconds that the reference film took at the position of the film.
    pub reference_seconds: f64,
}

impl Solved {
    /// The film whose numbers are reported: that in cubic elements, if there is one.
    pub fn reported(&self) -> &SolvedFilm {
        match &self.reference {
            Some(ReferenceFilm::Cubic(cubic)) => cubic,
            Some(ReferenceFilm::Coarse { .. }) | None => &self.primary,
        }
    }

    /// True where the film is that of a position or temperature reached, not found: the search was ended.
    pub fn is_ended(&self) -> bool {
        let of_temperature = self.temperature.as_ref().is_some_and(|found| found.is_ended);
        of_temperature || self.balance.is_some_and(|balance| balance.is_ended)
    }
}

/// How well a load is balanced, and what it took.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BalanceFacts {
    /// Load less force of the film [N].
    pub unbalanced: f64,
    /// Load less force of the film, relative to the load.
    pub residual: f64,
    /// Residual of the forces alone, and of the moments alone as forces at half of the bearing's length, both relative
    /// to the load.
    pub parts: [f64; 2],
    /// Moment of the load less that of the film [N m]; `None` where no moment is given, or the support bears a part
    /// that depends on the tilt.
    pub unbalanced_moment: Option<f64>,
    /// What is free.
    pub coordinates: Coordinates,
    /// `dW/de` [N/m] of the film in these coordinates, row: force.
    pub stiffness: Stiffness,
    /// Positions tried on the mesh of the result.
    pub steps: usize,
    /// What the search has cost.
    pub work: Work,
    /// True where the search was ended before the load was balanced.
    pub is_ended: bool,
    /// True where the force of the hill of a mass-conserving film balances the load, false for that of the film.
    pub is_of_hill: bool,
    /// Seconds that the search took, but for the film of the result.
    pub seconds: f64,
}

/// A temperature found.
#[derive(Debug, Clone, PartialEq)]
pub struct TemperatureFound {
    /// The film there.
    pub balanced: Balanced,
    /// True where the search was ended before the heat was balanced.
    pub is_ended: bool,
    /// How each number changes with the temperature [1/K], by name.
    pub(crate) slopes: HashMap<Cow<'static, str>, f64>,
    /// Positions of the journal tried at all temperatures.
    pub positions: usize,
    /// What the searches at all temperatures have cost.
    pub work: Work,
    /// Seconds that the films at other temperatures took.
    pub seconds: f64,
}

impl TemperatureFound {
    /// Heat that is not carried off, over what heats the film.
    pub fn left_over(&self) -> f64 {
        (self.balanced.surplus / self.balanced.film.power).abs()
    }
}
