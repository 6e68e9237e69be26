//! The search for the cavity, the set of nodes that are not full.

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Instant;

use oilwedge_fem::complementarity::WarmStart;
use oilwedge_fem::newton::{NewtonFailure, NewtonStep, Seconds};
use oilwedge_fem::{Constraints, Error, Linearisation, Matrix, UnsymmetricFactorization};

use super::balance::{CellBalance, add};
use super::loops;
use super::relaxation::NodeStates;
use super::rows::Condition;
use super::{DiscreteFilm, History, volumes_of};
use crate::Fallback;

/// Greatest number of steps of one search.
const MOST_STEPS: usize = 300;
/// A film fraction above one, or a pressure below that of the cavity (in natural units), that changes a node's side.
const SIGN_TOLERANCE: f64 = 1e-12;
/// Steps of pseudo-time: the first one over the time in which the journal moves by a radius, their growth, their
/// number.
const FIRST_TIME_STEP: f64 = 0.01;
const TIME_GROWTH: f64 = 3.0;
const TIME_STEPS: usize = 24;

/// The nodes in the cavity, and the steps that led there.
pub(super) struct ActiveSetSearch<'a> {
    film: &'a DiscreteFilm<'a>,
    state: NodeStates,
    first: Option<f64>,
    balance: CellBalance,
    /// True while the transport without pseudo-time is in the balance.
    is_carried: bool,
    /// Nodes that leak in the balance, with the diagonals of their transport without the leak.
    leaks: Vec<(usize, f64)>,
    /// Tangent and factor of the previous step, which the next one renews.
    renewed: Option<(Matrix, UnsymmetricFactorization)>,
    history: Vec<NewtonStep>,
    pub(super) seconds: Seconds,
    fallbacks: Vec<Fallback>,
}

/// A film in which the signs of all nodes are right.
pub(super) struct Found {
    pub(super) state: NodeStates,
    /// Inflow near each node where pressure is given; rounding elsewhere.
    pub(super) residual: Vec<f64>,
    pub(super) linearisation: Linearisation,
    /// Nodes on the wrong side after one step; none of a film that is settled.
    pub(super) wrong: Vec<usize>,
    pub(super) history: Vec<NewtonStep>,
    pub(super) seconds: Seconds,
    pub(super) fallbacks: Vec<Fallback>,
}

/// A step of pseudo-time: what the cells take up as they fill.
struct TimeStep {
    /// Reciprocal of the length of the step [1/s].
    rate: f64,
    before: Vec<f64>,
    /// Volume of each cell [m3].
    volume: Vec<f64>,
}

/// How an iteration over sets ended.
enum SetEnd {
    Settled(Box<Linearisation>),
    Repeated,
}

impl<'a> ActiveSetSearch<'a> {
    pub(super) fn new(film: &'a DiscreteFilm<'a>, start: WarmStart) -> Self {
        let WarmStart { u: p, mut held } = start;
        for (dof, held) in held.iter_mut().enumerate() {
            *held &= film.may_cavitate(dof);
        }
        Self {
            film,
            state: NodeStates::new(p, held),
            first: None,
            balance: CellBalance::of_pressure(film),
            is_carried: false,
            leaks: Vec::new(),
            renewed: None,
            history: Vec::new(),
            seconds: Seconds::default(),
            fallbacks: Vec::new(),
        }
    }

    /// Iterates over sets of nodes until every sign is right, and goes over to pseudo-time where a set comes back.
    pub(super) fn run(mut self) -> Result<Found, NewtonFailure> {
        let mut end = self.iterate(None)?;
        if let SetEnd::Repeated = end {
            self.fallbacks.push(Fallback::PseudoTime);
            end = self.after_pseudo_time()?;
        }
        self.found(end)
    }

    /// The balance of all nodes for the cavity of the start.
    pub(super) fn step(mut self) -> Result<Found, NewtonFailure> {
        let (linearisation, residual) = self.solve(None)?;
        let wrong = self.wrong_signs(&residual);
        self.record(&wrong);
        let turned = wrong.into_iter().map(|(dof, _)| dof).collect();
        Ok(Found { wrong: turned, ..self.found(SetEnd::Settled(Box::new(linearisation)))? })
    }

    /// The nodes after one step from the film fraction `theta` with the `tangent` of another film, and what is left of
    /// their balances.
    pub(super) fn chord(
        mut self,
        theta: &[f64],
        tangent: &Linearisation,
    ) -> Result<(NodeStates, Vec<f64>), NewtonFailure> {
        self.state.theta.copy_from_slice(theta);
        self.impose();
        self.carry(None);
        let before = self.balance.residual(&self.state.p, &self.state.theta);
        self.advance(tangent, &before)?;
        let left = self.balance.residual(&self.state.p, &self.state.theta);
        Ok((self.state, left))
    }

    /// Searches from the film at which pseudo-time arrives.
    fn after_pseudo_time(&mut self) -> Result<SetEnd, NewtonFailure> {
        self.pseudo_time()?;
        self.iterate(None)
    }

    /// Goes in pseudo-time from the start.
    #[cfg(test)]
    pub(super) fn run_in_time(mut self) -> Result<Found, NewtonFailure> {
        let end = self.after_pseudo_time()?;
        self.found(end)
    }

    fn found(mut self, end: SetEnd) -> Result<Found, NewtonFailure> {
        let SetEnd::Settled(solved) = end else {
            return Err(NewtonFailure::Cycling { history: self.history });
        };
        // What rounding has left in the balances is solved for once more: their sum is the balance of the oil.
        let linearisation = *solved;
        let left = self.balance.residual(&self.state.p, &self.state.theta);
        self.advance(&linearisation, &left)?;
        Ok(Found {
            residual: self.balance.residual(&self.state.p, &self.state.theta),
            state: self.state,
            linearisation,
            wrong: Vec::new(),
            history: self.history,
            seconds: self.seconds,
            fallbacks: self.fallbacks,
        })
    }

    /// Makes the step that removes the residual `before`.
    fn advance(&mut self, linearisation: &Linearisation, before: &[f64]) -> Result<Vec<f64>, NewtonFailure> {
        let minus: Vec<f64> = before.iter().map(|r| -r).collect();
        let step = linearisation.solve(&minus)?;
        for (dof, step) in step.iter().enumerate() {
            match self.state.cavity[dof] {
                true => self.state.theta[dof] += step,
                false => self.state.p[dof] += step,
            }
        }
        Ok(step)
    }

    /// Solves the balances and exchanges nodes until every sign is right.
    fn iterate(&mut self, time: Option<&TimeStep>) -> Result<SetEnd, NewtonFailure> {
        let mut seen = HashSet::new();
        while self.history.len() < MOST_STEPS {
            let (linearisation, residual) = self.solve(time)?;
            let wrong = self.wrong_signs(&residual);
            self.record(&wrong);
            if wrong.is_empty() {
                return Ok(SetEnd::Settled(Box::new(linearisation)));
            }
            let mut hasher = DefaultHasher::new();
            self.state.cavity.hash(&mut hasher);
            if !seen.insert(hasher.finish()) {
                return Ok(SetEnd::Repeated);
            }
            self.renewed = linearisation.into_unsymmetric();
            let turned: Vec<usize> = wrong.into_iter().map(|(dof, _)| dof).collect();
            self.state.turn(self.film, &turned);
            self.state.relax(self.film, &self.balance, &turned);
        }
        Err(NewtonFailure::TooManySteps { history: std::mem::take(&mut self.history) })
    }

    /// Entry of a step in the history.
    fn record(&mut self, wrong: &[(usize, f64)]) {
        let violation = wrong.iter().map(|(_, size)| size * size).sum::<f64>().sqrt();
        let first = *self.first.get_or_insert(if violation > 0.0 { violation } else { 1.0 });
        let active = self.state.cavity.iter().filter(|cavity| **cavity).count();
        self.history.push(NewtonStep { residual: violation / first, damping: 1.0, active });
    }

    /// The balance of all nodes for the present cavity, which is linear.
    fn solve(&mut self, time: Option<&TimeStep>) -> Result<(Linearisation, Vec<f64>), NewtonFailure> {
        let clock = Instant::now();
        let film = self.film;
        let constraints = self.impose();
        self.carry(time);
        let before = self.balance.residual(&self.state.p, &self.state.theta);
        let (spare, renewed) = self.renewed.take().unzip();
        let matrix = self.balance.tangent(&self.state.cavity, spare);
        let assembled = Instant::now();
        let factor = film.volumes.analysis.factorise(&matrix, &constraints.fixed, renewed)?;
        let factorised = Instant::now();
        let linearisation = Linearisation::unsymmetric(matrix, factor, constraints);
        let step = self.advance(&linearisation, &before)?;
        let change = linearisation.matrix().multiply(&step);
        let residual = before.iter().zip(change).map(|(r, c)| r + c).collect();
        self.seconds.assemble += (assembled - clock).as_secs_f64();
        self.seconds.factorise += (factorised - assembled).as_secs_f64();
        self.seconds.solve += factorised.elapsed().as_secs_f64();
        Ok((linearisation, residual))
    }

    /// Gives all nodes what is not unknown with the present cavity, and says which these are among the full ones.
    fn impose(&mut self) -> Constraints {
        let rows = &self.film.rows;
        let mut constraints = Constraints::none(self.state.p.len());
        for dof in 0..self.state.p.len() {
            if self.state.cavity[dof] || rows.condition[dof] != Condition::Interior {
                self.state.p[dof] = rows.value[dof];
            }
            if !self.state.cavity[dof] {
                self.state.theta[dof] = 1.0;
                constraints.fixed[dof] = rows.condition[dof] != Condition::Interior;
            }
        }
        constraints
    }

    /// Adds the transport of oil with the flows through the boundary, and the leaks of the present cavity.
    fn carry(&mut self, time: Option<&TimeStep>) {
        if !self.is_carried || time.is_some() {
            self.assemble_transport(time);
        }
        self.is_carried = time.is_none();
        // What a film with a history held says how much oil goes round.
        if self.film.history.is_some() || time.is_some() {
            return;
        }
        let transport = &mut self.balance.transport;
        for (dof, before) in self.leaks.drain(..) {
            transport.add_to_diagonal(dof, before - transport.diagonal(dof));
        }
        for dof in loops::without_source(transport, &self.state.cavity, &self.film.rows.inflow) {
            self.leaks.push((dof, transport.diagonal(dof)));
            transport.add_to_diagonal(dof, loops::LEAK * transport.diagonal(dof));
        }
    }

    fn assemble_transport(&mut self, time: Option<&TimeStep>) {
        let (volumes, rows) = (self.film.volumes, &self.film.rows);
        let CellBalance { transport, constant, .. } = &mut self.balance;
        self.leaks.clear();
        transport.values.fill(0.0);
        for (block, addresses) in self.film.blocks.iter().zip(&volumes.addresses) {
            add(transport, addresses, &block.transport());
        }
        for (dof, &outflow) in rows.outflow.iter().enumerate().filter(|(_, outflow)| **outflow > 0.0) {
            transport.add_to_diagonal(dof, outflow);
        }
        for (constant, inflow) in constant.iter_mut().zip(&rows.inflow) {
            *constant = -inflow;
        }
        if let Some(History { before, volume }) = &self.film.history {
            for (dof, (known, volume)) in before.known.iter().zip(volume).enumerate() {
                constant[dof] -= before.per_time * known;
                transport.add_to_diagonal(dof, before.per_time * volume);
            }
        }
        if let Some(time) = time {
            for dof in (0..self.state.p.len()).filter(|&dof| self.film.may_cavitate(dof)) {
                let capacity = time.rate * time.volume[dof];
                constant[dof] -= capacity * time.before[dof];
                transport.add_to_diagonal(dof, capacity);
            }
        }
    }

    /// Nodes on the wrong side, and their distance from the right one in natural units: full nodes with tension or at
    /// an edge through which pressure would drive oil in, and nodes of the cavity with more oil than there is room for.
    fn wrong_signs(&self, residual: &[f64]) -> Vec<(usize, f64)> {
        let largest = residual.iter().fold(0.0f64, |m, r| m.max(r.abs()));
        let size = |dof: usize| match (self.state.cavity[dof], self.film.rows.condition[dof]) {
            (true, _) => self.state.theta[dof] - 1.0,
            (false, Condition::Interior) => {
                (self.film.floor - self.film.rounding - self.state.p[dof]) / self.film.scale
            }
            (false, Condition::Edge) => residual[dof] / largest.max(f64::MIN_POSITIVE),
            (false, Condition::Given) => 0.0,
        };
        let sizes = (0..self.state.p.len()).map(|dof| (dof, size(dof)));
        sizes.filter(|(_, size)| *size > SIGN_TOLERANCE || size.is_nan()).collect()
    }

    /// Goes towards the steady film by the backward Euler method in the film fraction, with growing steps.
    fn pseudo_time(&mut self) -> Result<(), NewtonFailure> {
        let volume = volumes_of(self.film.volumes, &self.film.blocks, self.state.p.len());
        let mut time = TimeStep {
            rate: 1.0 / (FIRST_TIME_STEP * self.film.time),
            before: self.state.theta.iter().map(|theta| theta.clamp(0.0, 1.0)).collect(),
            volume,
        };
        if !time.rate.is_finite() {
            return Err(Error::NotFinite { what: "time step" }.into());
        }
        for _ in 0..TIME_STEPS {
            self.iterate(Some(&time))?;
            time.before.clone_from(&self.state.theta);
            time.rate /= TIME_GROWTH;
        }
        Ok(())
    }
}
