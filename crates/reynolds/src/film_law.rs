//! The equation of one film as a pointwise conservation law.

use oilwedge_fem::conservation_law::{Conduction, Response, State};
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{ConservationLaw, Dual, TangentKind};

use crate::film_problem::{FilmProblem, Form};
use crate::film_thickness::FilmContribution;
use crate::{FilmChange, FilmFlow, FilmPoint, flow_factors};

/// The law of a [`FilmProblem`], or how it changes, to first order, where the journal moves or the gap grows.
pub(crate) struct FilmLaw<'a> {
    problem: &'a FilmProblem,
    /// Scales all motion of the journal (continuation).
    motion: f64,
    change: Option<FilmChange<'a>>,
}

impl FilmProblem {
    /// The law whose flux balances in this film.
    pub fn law(&self) -> impl ConservationLaw + '_ {
        FilmLaw::new(self, 1.0)
    }

    /// Film thickness [m] without the deflection of a wall that gives way, at as many positions [m] in triangle `cell`
    /// as a quadrature rule has at once.
    pub(crate) fn unbent_at(&self, cell: usize, positions: &[[f64; 2]]) -> AtPoints<f64> {
        self.thickness_of(|contribution| contribution.as_deflection().is_none(), (cell, positions))
    }

    /// Film thickness [m] at positions [m] in triangle `cell`, at most as many as a quadrature rule has at once; what
    /// stands behind them is zero.
    pub fn thickness_at(&self, cell: usize, positions: &[[f64; 2]]) -> AtPoints<f64> {
        self.thickness_of(|_| true, (cell, positions))
    }

    fn thickness_of(
        &self,
        counts: impl Fn(&dyn FilmContribution) -> bool,
        (cell, positions): (usize, &[[f64; 2]]),
    ) -> AtPoints<f64> {
        let mut film = [FilmPoint::default(); MOST_POINTS];
        for contribution in self.film_thickness.iter().filter(|contribution| counts(&***contribution)) {
            contribution.add(&self.journal, cell, positions, &mut film[..positions.len()]);
        }
        film.map(|point| point.thickness)
    }
}

/// Values at as many points as a law is asked for at once.
pub(crate) type AtPoints<T> = [T; MOST_POINTS];

/// Film and flows, or their changes, at some points.
pub(crate) type FilmAndFlows = (AtPoints<FilmPoint>, AtPoints<FilmFlow>);

impl<'a> FilmLaw<'a> {
    pub(crate) fn new(problem: &'a FilmProblem, motion: f64) -> Self {
        Self { problem, motion, change: None }
    }

    /// The first-order change of the law: a law itself, whose residual at a field is the change of the residual.
    pub(crate) fn changed(problem: &'a FilmProblem, change: FilmChange<'a>) -> Self {
        Self { problem, motion: 1.0, change: Some(change) }
    }

    /// Velocity [m/s] of the journal's surface.
    pub(crate) fn velocity(&self) -> [f64; 2] {
        self.problem.surface_velocity().map(|velocity| self.motion * velocity)
    }

    /// Film at `positions` in triangle `cell`.
    pub(crate) fn film(&self, cell: usize, positions: &[[f64; 2]]) -> AtPoints<FilmPoint> {
        let mut film = [FilmPoint::default(); MOST_POINTS];
        self.set_film(cell, positions, &mut film[..positions.len()]);
        film
    }

    /// Sets the film at `positions` in triangle `cell`, where `film` is zero so far.
    fn set_film(&self, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for contribution in &self.problem.film_thickness {
            contribution.add(&self.problem.journal, cell, positions, film);
        }
        let velocity = self.velocity();
        for point in &mut *film {
            point.viscosity = self.problem.lubricant.viscosity;
            point.shear_viscosity = self.problem.lubricant.viscosity;
            point.drag = 0.5;
            point.velocity = velocity;
            point.rate *= self.motion;
        }
        if let Some(across) = &self.problem.viscosity_across {
            across.set(cell, positions, film);
        }
        if !self.problem.flow_factors.is_empty() {
            let factors = self.problem.factors();
            film.iter_mut().for_each(|point| point.shear_viscosity *= factors.shear(point));
        }
    }

    /// Film (or its change) and what flows (or the change of that) at `positions` in triangle `cell`.
    pub(crate) fn film_and_flows(&self, cell: usize, positions: &[[f64; 2]]) -> FilmAndFlows {
        if let Some(change) = &self.change {
            return self.moved(change, &self.film(cell, positions), (cell, positions));
        }
        // Both are set where they are returned: copies of them would take as long as the film.
        let mut of_film = ([FilmPoint::default(); MOST_POINTS], [FilmFlow::default(); MOST_POINTS]);
        let (film, flows) = &mut of_film;
        self.set_film(cell, positions, &mut film[..positions.len()]);
        self.set_flows(&film[..positions.len()], flows);
        of_film
    }

    /// Sets what flows in a film, where `flows` are zero so far.
    fn set_flows(&self, film: &[FilmPoint], flows: &mut AtPoints<FilmFlow>) {
        for term in &self.problem.terms {
            term.add_all(film, flows);
        }
        if !self.problem.flow_factors.is_empty() {
            self.scale(film, flows);
        }
    }

    /// The change of a film, and of what flows in it.
    fn moved(
        &self,
        change: &FilmChange<'_>,
        film: &AtPoints<FilmPoint>,
        (cell, positions): (usize, &[[f64; 2]]),
    ) -> FilmAndFlows {
        let (mut moved, mut flows) = ([FilmPoint::default(); MOST_POINTS], [FilmFlow::default(); MOST_POINTS]);
        self.vary(change, cell, positions, &mut moved[..positions.len()]);
        for term in &self.problem.terms {
            for ((point, change), flow) in film[..positions.len()].iter().zip(&moved).zip(&mut flows) {
                term.vary(point, change, flow);
            }
        }
        if !self.problem.flow_factors.is_empty() {
            self.vary_factors(&film[..positions.len()], &moved, &mut flows);
        }
        (moved, flows)
    }

    /// Scales the flows of a film without factors.
    fn scale(&self, film: &[FilmPoint], flows: &mut [FilmFlow]) {
        let factors = self.problem.factors();
        film.iter().zip(flows).for_each(|(point, flow)| factors.scale(point, flow));
    }

    /// Scales the change of the flows of a film without factors where the film has `moved`.
    fn vary_factors(&self, film: &[FilmPoint], moved: &[FilmPoint], changes: &mut [FilmFlow]) {
        let factors = self.problem.factors();
        for ((point, moved), change) in film.iter().zip(moved).zip(changes) {
            let mut flow = FilmFlow::default();
            for term in &self.problem.terms {
                term.add(point, &mut flow);
            }
            factors.vary(point, moved, &flow, change);
        }
    }

    /// Film and what flows at `positions` in triangle `cell`, the thickness that which holds and carries the oil: of
    /// rough surfaces the mean gap.
    pub(crate) fn oil_and_flows(&self, cell: usize, positions: &[[f64; 2]]) -> FilmAndFlows {
        let film = self.film(cell, positions);
        self.of_oil(&film, positions.len())
    }

    fn of_oil(&self, film: &AtPoints<FilmPoint>, number: usize) -> FilmAndFlows {
        let (mut oil, mut flows) = (*film, [FilmFlow::default(); MOST_POINTS]);
        for (point, [mean, _]) in oil.iter_mut().zip(self.mean_gaps(&film[..number])) {
            point.thickness = mean;
        }
        self.set_flows(&film[..number], &mut flows);
        (oil, flows)
    }

    /// [`FilmLaw::oil_and_flows`], and its first-order change with each of some `changes` of the journal or the gap, by
    /// one film; `changed` is given the number of the change, the film and its change.
    pub(crate) fn oil_and_flows_with_changes(
        &self,
        changes: &[FilmChange<'_>],
        (cell, positions): (usize, &[[f64; 2]]),
        mut changed: impl FnMut(usize, &FilmAndFlows, &FilmAndFlows),
    ) {
        let film = self.film(cell, positions);
        let of_oil = self.of_oil(&film, positions.len());
        for (number, change) in changes.iter().enumerate() {
            let mut moved = self.moved(change, &film, (cell, positions));
            for (point, [_, slope]) in moved.0.iter_mut().zip(self.mean_gaps(&film[..positions.len()])) {
                point.thickness *= slope;
            }
            changed(number, &of_oil, &moved);
        }
    }

    /// Mean gap [m] between rough surfaces at each point of a film, and its derivative by the thickness [1]; none
    /// between smooth ones.
    fn mean_gaps(&self, film: &[FilmPoint]) -> impl Iterator<Item = [f64; 2]> {
        let film = if self.problem.flow_factors.is_empty() { &[] } else { film };
        (film.iter()).map(|point| flow_factors::mean_gap(&self.problem.flow_factors, point.thickness))
    }

    /// Adds what a change adds to the film.
    fn vary(&self, change: &FilmChange<'_>, cell: usize, positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        match change {
            FilmChange::Journal(change) => {
                for contribution in &self.problem.film_thickness {
                    contribution.vary(change, cell, positions, film);
                }
            }
            FilmChange::Gap(shape) => shape.add(&self.problem.journal, cell, positions, film),
            FilmChange::GapRate(shape) => {
                shape.add(&self.problem.journal, cell, positions, film);
                for point in film {
                    *point = FilmPoint { rate: point.thickness, ..FilmPoint::default() };
                }
            }
            FilmChange::Viscosity(part) => {
                film.iter_mut().for_each(|point| point.viscosity = part * self.problem.lubricant.viscosity);
            }
        }
    }
}

impl ConservationLaw for FilmLaw<'_> {
    fn tangent(&self) -> TangentKind {
        match self.problem.form {
            Form::Conservative => TangentKind::Conduction,
            Form::AsPrinted => TangentKind::Symmetric,
        }
    }

    fn directions(&self) -> [f64; 2] {
        self.problem.theory.directions()
    }

    fn is_isotropic(&self) -> bool {
        self.problem.is_laminar()
    }

    /// `div(flux - conductance grad q) + storage = 0` in the reduced pressure q.
    fn conduction(&self, cell: usize, positions: &[[f64; 2]], out: &mut [Conduction]) {
        for (flow, out) in self.film_and_flows(cell, positions).1.iter().zip(out) {
            *out = Conduction { conductance: flow.conductance, flux: flow.flux, source: flow.storage };
        }
    }

    /// Response of the law as printed: `div(flux - conductance grad p) + storage + (mu(p)/mu0 - 1) (div(flux) +
    /// storage) = 0` in the pressure p: the balance of an oil of constant viscosity, with a source of oil that grows
    /// with the pressure.
    fn response(&self, cell: usize, positions: &[[f64; 2]], states: &[State], out: &mut [Response]) {
        // In the conservative form the viscosity stands in q, and nothing is made.
        let law = (self.problem.form == Form::AsPrinted).then_some(&self.problem.lubricant.pressure_law);
        let thickening = |p: Dual| match law {
            Some(law) => p.chain(law.viscosity_ratio(p.v), law.viscosity_slope(p.v)) + -1.0,
            None => Dual::default(),
        };
        let along = self.directions();
        let flows = self.film_and_flows(cell, positions).1;
        for ((flow, state), out) in flows.iter().zip(states).zip(out) {
            *out = Response {
                flux: [0, 1].map(|k| state.gradient[k] * (-flow.conductance[k] * along[k]) + flow.flux[k]),
                source: thickening(state.value) * (flow.divergence + flow.storage) + flow.storage,
            };
        }
    }
}
