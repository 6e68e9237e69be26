//! # Stiffness and damping of a film, and the rigid rotor on it
//!
//! **Equation.** `K = d(W, m)/d(e, g)`, `C = d(W, m)/d(e', g')`: the film pushes a journal that is off its state by (e,
//! g) with `-K (e, g) - C (e', g')`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | K | N/m, N/rad, N m/m, N m/rad | [`Coefficients::stiffness`] |
//! | C | the same times s | [`Coefficients::damping`] |
//! | nu | - | `whirl`: frequency of the motion over the speed of the journal |
//!
//! `coefficients.rs` (K and C of a film at one frequency), `edge.rs` (what the edge of a cavity leaves open of them),
//! `rotor.rs` (the rigid rotor), `whirl.rs` (the frequency at which a cavity that conserves oil lets the rotor whirl).
//!
//! **Source.** Lund, Thomsen, Topics in Fluid Film Bearing and Rotor Bearing System Design and Optimization, ASME
//! (1978) 1. **Range.** Small motions; the temperature of the film is held. **Verified by** `tests/tests/dynamics`.

mod coefficients;
mod edge;
mod rotor;
mod whirl;

use oilwedge_fem::Error;
use oilwedge_reynolds::{FilmProblem, SolvedFilm};

pub use coefficients::{Coefficients, Square};
pub use edge::edge_parts;
pub use rotor::{Stability, Threshold, Whirling, stability, whirling};

/// Coefficients at one frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AtWhirl {
    /// Frequency of the motion over the speed of the journal [1].
    pub whirl: f64,
    /// The coefficients.
    pub coefficients: Coefficients,
}

/// How a film answers to small motions of the journal.
#[derive(Debug, Clone, PartialEq)]
pub struct Dynamics {
    /// At each whirl ratio asked for, in their order.
    pub at: Vec<AtWhirl>,
    /// At the whirl ratio at which the rigid rotor was judged: that of its own whirl where the frequency makes a
    /// difference, else the first one asked for.
    pub judged: AtWhirl,
    /// Whether a rigid rotor is stable.
    pub stability: Stability,
}

impl Dynamics {
    /// Answers of a film at these whirl ratios, at least one.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn of(film: &SolvedFilm, whirl: &[f64]) -> Result<Self, Error> {
        let films = Whirled { film };
        let at = films.at_each(whirl)?;
        let judged = match depends_on_frequency(&film.problem) {
            true => whirl::own_whirl(|whirl| films.at(whirl), film.problem.journal.speed)?,
            false => at.first().copied(),
        };
        Ok(match judged {
            Some(judged) => Self { stability: stability(&judged.coefficients), judged, at },
            None => Self { stability: Stability::Undetermined, judged: films.at(0.0)?, at },
        })
    }

    /// Answers of a film at the frequencies of another one beside it: what differs is due to the films.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub fn beside(film: &SolvedFilm, other: &Self) -> Result<Self, Error> {
        let films = Whirled { film };
        let whirl: Vec<f64> = other.at.iter().map(|at| at.whirl).collect();
        let at = films.at_each(&whirl)?;
        let judged = match at.iter().find(|at| at.whirl == other.judged.whirl) {
            Some(judged) => *judged,
            None => films.at(other.judged.whirl)?,
        };
        Ok(Self { stability: stability(&judged.coefficients), judged, at })
    }
}

/// Whether coefficients depend on the frequency of the motion: a cavity that conserves oil fills and empties.
pub fn depends_on_frequency(problem: &FilmProblem) -> bool {
    problem.cavitation.conserves_oil()
}

/// A film that is whirled.
struct Whirled<'a> {
    film: &'a SolvedFilm,
}

impl Whirled<'_> {
    fn at(&self, whirl: f64) -> Result<AtWhirl, Error> {
        let frequency = whirl * self.film.problem.journal.speed.abs();
        let coefficients = Coefficients::of(self.film, frequency)?;
        Ok(AtWhirl { whirl, coefficients })
    }

    fn at_each(&self, whirl: &[f64]) -> Result<Vec<AtWhirl>, Error> {
        match whirl {
            [first, ..] if !depends_on_frequency(&self.film.problem) => {
                let once = self.at(*first)?;
                Ok(whirl.iter().map(|&whirl| AtWhirl { whirl, ..once }).collect())
            }
            _ => whirl.iter().map(|&whirl| self.at(whirl)).collect(),
        }
    }
}
