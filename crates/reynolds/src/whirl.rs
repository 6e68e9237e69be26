//! # Whirl: how a solved film answers to small harmonic motions of the journal
//!
//! **Equation.** The journal moves by `Re(de exp(i a t))` about its state; to first order the unknown changes by
//! `Re((u + i a w) de exp(i a t))`, so that u is its change with the place of the journal and w that with its rate.
//!
//! Where the film holds no oil but what its thickness holds, the frequency makes no difference: `A u = -dR/de`,
//! `A w = -dR/de'`, A the tangent at the film. A cavity that conserves oil fills and empties: with the volume S that
//! each of its nodes holds when it is full, `A u - a^2 S w = -dR/de`, `A w + S u = -dR/de'`. The set of the cavity
//! stays.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | a | rad/s | `frequency` |
//! | u, w | Pa/m, Pa s/m (of slopes: for each radian) | [`Whirl::response`] |
//!
//! **Source.** Lund, Thomsen, Topics in Fluid Film Bearing and Rotor Bearing System Design and Optimization, ASME
//! (1978) 1 (perturbed films); the cavity that stays is exact to first order, since pressure is level at its edge.
//! **Range.** Motions far below the film thickness, films without inertia.
//! **Verified by** `tests/tests/dynamics`: differences of films, and a second code for mass-conserving films.

use oilwedge_fem::{Error, HarmonicSystem};

use crate::cavitation;
use crate::film_thickness::FilmContribution;
use crate::terms;
use crate::{FilmChange, FilmProblem, JournalChange, SolvedFilm};

/// A solved film, ready to be moved at one frequency.
pub struct Whirl<'a> {
    film: &'a SolvedFilm,
    /// The film whose law changes with the rates of the journal by what it takes up.
    taking_up: SolvedFilm,
    cavity: CavityContent,
}

/// What a cavity holds.
enum CavityContent {
    /// The cavity holds nothing.
    Empty,
    /// Oil, in the limit of slow motions: the volume [m3] of each node of the cavity when it is full.
    Slow(Vec<f64>),
    /// Oil that fills and empties it: the frequency [rad/s], and the factorised system.
    Filling(f64, Box<HarmonicSystem>),
}

impl<'a> Whirl<'a> {
    /// The response at a frequency [rad/s]; zero stands for the limit of slow motions.
    ///
    /// # Errors
    /// The linear systems do not fit in memory.
    pub fn new(film: &'a SolvedFilm, frequency: f64) -> Result<Self, Error> {
        let SolvedFilm { problem, system, solution } = film;
        let cavity = match &solution.film_fraction {
            None => CavityContent::Empty,
            Some(_) => {
                let held = cavitation::held_volume(film)?;
                match frequency == 0.0 {
                    true => CavityContent::Slow(held),
                    false => {
                        let analysis = system.volumes()?.harmonic()?;
                        let capacity: Vec<f64> = held.iter().map(|volume| frequency * volume).collect();
                        let fixed = &solution.linearisation.constraints().fixed;
                        let system = analysis.factorise(solution.linearisation.matrix(), &capacity, fixed)?;
                        CavityContent::Filling(frequency, Box::new(system))
                    }
                }
            }
        };
        let problem = FilmProblem { terms: terms::of_rates(), ..problem.clone() };
        let taking_up = SolvedFilm { problem, ..film.clone() };
        Ok(Self { film, taking_up, cavity })
    }

    /// First-order change of the unknown at each dof with the place of the journal, `place`, and with the same motion
    /// as a rate [1/s].
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn response(&self, offset: [f64; 2], tilt: [f64; 2]) -> Result<[Vec<f64>; 2], Error> {
        let place = JournalChange { offset, tilt, ..JournalChange::default() };
        let rate = place.as_rate();
        self.response_to(FilmChange::Journal(place), FilmChange::Journal(rate))
    }

    /// First-order change of the unknown at each dof where the gap grows by a `shape`, and with the same growth as a
    /// rate [1/s].
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn response_to_gap(&self, shape: &dyn FilmContribution) -> Result<[Vec<f64>; 2], Error> {
        self.response_to(FilmChange::Gap(shape), FilmChange::GapRate(shape))
    }

    fn response_to(&self, place: FilmChange<'_>, rate: FilmChange<'_>) -> Result<[Vec<f64>; 2], Error> {
        let minus = |film: &SolvedFilm, change: FilmChange<'_>| -> Result<Vec<f64>, Error> {
            let residual = film.residual_change(change)?;
            Ok(residual.iter().map(|r| -r).collect())
        };
        let (by_place, mut by_rate) = (minus(self.film, place)?, minus(&self.taking_up, rate)?);
        let tangent = &self.film.solution.linearisation;
        let mut response = match &self.cavity {
            CavityContent::Empty => [tangent.solve(&by_place)?, tangent.solve(&by_rate)?],
            CavityContent::Slow(held) => {
                let by_place = tangent.solve(&by_place)?;
                for ((rate, held), change) in by_rate.iter_mut().zip(held).zip(&by_place) {
                    *rate -= held * change;
                }
                let by_rate = tangent.solve(&by_rate)?;
                [by_place, by_rate]
            }
            CavityContent::Filling(frequency, system) => {
                by_rate.iter_mut().for_each(|rate| *rate *= frequency);
                let [by_place, across] = system.solve([&by_place, &by_rate])?;
                [by_place, across.iter().map(|part| part / frequency).collect()]
            }
        };
        if self.film.solution.film_fraction.is_some() {
            // In the cavity it is the film fraction that changes.
            for change in &mut response {
                let in_cavity = change.iter_mut().zip(&self.film.solution.cavity).filter(|(_, cavity)| **cavity);
                in_cavity.for_each(|(change, _)| *change = 0.0);
            }
        }
        Ok(response)
    }
}
