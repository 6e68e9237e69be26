//! The equation of one film as a pointwise conservation law.

use oilwedge_fem::conservation_law::{Conduction, Response, State};
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{ConservationLaw, Tangent};

use crate::film_problem::{FilmProblem, Form};
use crate::lubricant::Barus;
use crate::{FilmFlow, FilmPoint};

/// The law of a [`FilmProblem`] with all motion of its journal scaled by a factor (continuation).
pub(crate) struct FilmLaw<'a> {
    problem: &'a FilmProblem,
    /// Scales all motion of the journal.
    motion: f64,
}

impl<'a> FilmLaw<'a> {
    pub(crate) fn new(problem: &'a FilmProblem, motion: f64) -> Self {
        Self { problem, motion }
    }

    fn flows(&self, cell: usize, positions: &[[f64; 2]]) -> [FilmFlow; MOST_POINTS] {
        let mut film = [FilmPoint::default(); MOST_POINTS];
        let film = &mut film[..positions.len()];
        for contribution in &self.problem.film_thickness {
            contribution.add(&self.problem.journal, cell, positions, film);
        }
        let velocity = self.problem.surface_velocity().map(|velocity| self.motion * velocity);
        for point in film.iter_mut() {
            point.viscosity = self.problem.lubricant.viscosity;
            point.velocity = velocity;
            point.rate *= self.motion;
        }
        let mut flows = [FilmFlow::default(); MOST_POINTS];
        for term in &self.problem.terms {
            for (point, flow) in film.iter().zip(&mut flows) {
                term.add(point, flow);
            }
        }
        flows
    }
}

impl ConservationLaw for FilmLaw<'_> {
    fn tangent(&self) -> Tangent {
        match self.problem.form {
            Form::Conservative => Tangent::Conduction,
            Form::AsPrinted(_) => Tangent::Symmetric,
        }
    }

    /// `div(flux - conductance grad q) + storage = 0` in the reduced pressure q.
    fn conduction(&self, cell: usize, positions: &[[f64; 2]], out: &mut [Conduction]) {
        for (flow, out) in self.flows(cell, positions).iter().zip(out) {
            *out = Conduction {
                conductance: flow.conductance,
                flux: flow.flux,
                source: flow.storage,
            };
        }
    }

    /// As printed: `div(flux - conductance grad p) + storage + (mu(p)/mu0 - 1) (div(flux) + storage) = 0` in the pressure p: the
    /// balance of an oil of constant viscosity, with a source of oil that grows with the pressure.
    fn response(&self, cell: usize, positions: &[[f64; 2]], states: &[State], out: &mut [Response]) {
        // In the conservative form the viscosity stands in q, and nothing is made.
        let barus = match self.problem.form {
            Form::AsPrinted(barus) => barus,
            Form::Conservative => Barus { alpha: 0.0 },
        };
        for ((flow, state), out) in self.flows(cell, positions).iter().zip(states).zip(out) {
            *out = Response {
                flux: [0, 1].map(|k| state.gradient[k] * -flow.conductance + flow.flux[k]),
                source: (barus.viscosity_ratio(state.value) + -1.0) * (flow.divergence + flow.storage) + flow.storage,
            };
        }
    }
}
