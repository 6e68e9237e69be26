//! The search for the cavity: which nodes are full, which are not.

mod schemes;

use std::collections::HashSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Instant;

use oilwedge_fem::complementarity::InitialGuess;
use oilwedge_fem::newton::{Failure, HistoryStep, Seconds};
use oilwedge_fem::{Constraints, Error, Linearisation, Matrix, UnsymmetricFactorization};

use super::balance::{Balance, add};
use super::blocks::AdvectionScheme;
use super::loops;
use super::relaxation::State;
use super::rows::Condition;
use super::{Choice, Film, History, ROUNDING, volumes_of};
use crate::Fallback;

/// Most steps of one search.
const MOST_STEPS: usize = 300;
/// A film fraction above one, or a pressure below that of the cavity (in natural units), that changes a node's side.
const SIGN_TOLERANCE: f64 = 1e-12;
/// A node that changes sides so often in the second pass cannot settle with the LDA scheme.
const RESTLESS: u8 = 2;
/// A sub-triangle whose cavity comes back more often in the first pass keeps the N scheme there.
const MOST_RETURNS: u8 = 1;
/// Nodes that hold less than no oil are looked for once fewer signs are wrong than this part of those at first.
const NEARLY: f64 = 0.3;
/// Pseudo-time steps: the first as a part of the time that the journal takes over a radius, growth, number.
const FIRST_TIME_STEP: f64 = 0.01;
const TIME_GROWTH: f64 = 3.0;
const TIME_STEPS: usize = 24;

/// Which nodes are in the cavity, and how the film got there.
pub(super) struct Search<'a> {
    film: &'a Film<'a>,
    state: State,
    /// How the oil of each sub-triangle is carried.
    schemes: Vec<AdvectionScheme>,
    /// How often the cavity has left each sub-triangle in the first pass.
    left: Vec<u8>,
    /// How often each node has changed sides in the second pass.
    turns: Vec<u8>,
    /// Sub-triangles whose scheme has changed in the second pass.
    changed: Vec<bool>,
    first: Option<f64>,
    balance: Balance,
    /// True while the transport of a film with a history is in the balance: its schemes do not change.
    is_carried: bool,
    /// Tangent and factor of the step before, to be renewed.
    renewed: Option<(Matrix, UnsymmetricFactorization)>,
    history: Vec<HistoryStep>,
    pub(super) seconds: Seconds,
    fallbacks: Vec<Fallback>,
}

/// A film whose signs are all right.
pub(super) struct Found {
    pub(super) state: State,
    pub(super) schemes: Vec<AdvectionScheme>,
    /// Inflow near each node where pressure is given; rounding elsewhere.
    pub(super) residual: Vec<f64>,
    pub(super) linearisation: Linearisation,
    pub(super) history: Vec<HistoryStep>,
    pub(super) seconds: Seconds,
    pub(super) fallbacks: Vec<Fallback>,
}

/// A step of pseudo-time: what the cells take up as they fill.
struct TimeStep {
    /// One over its length [1/s].
    rate: f64,
    before: Vec<f64>,
    /// Volume of each cell [m3].
    volume: Vec<f64>,
}

/// How the advection schemes are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// Anew at each step, by the N scheme wherever a node is in the cavity.
    First,
    /// Where the inflow side is starved, by LDA.
    Second,
    /// Not at all.
    Kept,
}

/// How an iteration over sets ended.
enum End {
    Settled(Box<Linearisation>),
    Repeated,
}

impl<'a> Search<'a> {
    pub(super) fn new(film: &'a Film<'a>, start: InitialGuess) -> Self {
        let InitialGuess { u: p, mut held } = start;
        for (dof, held) in held.iter_mut().enumerate() {
            *held &= film.may_cavitate(dof);
        }
        Self {
            film,
            state: State::new(p, held),
            schemes: vec![AdvectionScheme::Faces; film.blocks.len()],
            left: vec![0; film.blocks.len()],
            turns: Vec::new(),
            changed: vec![false; film.blocks.len()],
            first: None,
            balance: Balance::of_pressure(film),
            is_carried: false,
            renewed: None,
            history: Vec::new(),
            seconds: Seconds::default(),
            fallbacks: Vec::new(),
        }
    }

    /// The film with a history, by one advection scheme all along; and pseudo-time where a set of nodes comes back.
    fn run_with_history(mut self) -> Result<Found, Failure> {
        self.schemes.fill(AdvectionScheme::Corrected);
        let mut end = self.iterate(Pass::Kept, None)?;
        if let End::Repeated = end {
            self.fallbacks.push(Fallback::PseudoTime);
            self.pseudo_time()?;
            end = self.iterate(Pass::Kept, None)?;
        }
        self.found(end)
    }

    /// Both passes, and pseudo-time where a set of nodes comes back.
    pub(super) fn run(mut self, choice: Choice) -> Result<Found, Failure> {
        if self.film.history.is_some() {
            return self.run_with_history();
        }
        let mut pass = Pass::Kept;
        if let Choice::Kept(kept) = choice {
            self.schemes = kept.schemes.clone();
        } else {
            let mut end = self.iterate(Pass::First, None)?;
            if let End::Repeated = end {
                end = self.iterate(Pass::Kept, None)?;
            }
            match (choice, end) {
                (Choice::Roughly, settled @ End::Settled(_)) => return self.found(settled),
                (_, End::Settled(solved)) => self.renewed = solved.into_unsymmetric(),
                (_, End::Repeated) => {}
            }
            self.schemes = self.second_schemes();
            pass = Pass::Second;
        }
        self.turns = vec![0; self.state.p.len()];
        let mut end = match self.iterate(pass, None) {
            // Oil that goes round in the cavity for ever, without a supply, is diluted by the N scheme only.
            Err(Failure::Linear { .. }) => End::Repeated,
            other => other?,
        };
        // Overdrawn nodes that calming their surroundings has not helped.
        if self.state.theta.iter().any(|&theta| theta < -ROUNDING) {
            end = End::Repeated;
        }
        if let End::Repeated = end {
            self.fallbacks.push(Fallback::NScheme);
            end = self.iterate(Pass::First, None)?;
        }
        if let End::Repeated = end {
            self.fallbacks.push(Fallback::PseudoTime);
            self.pseudo_time()?;
            end = self.iterate(Pass::Kept, None)?;
        }
        self.found(end)
    }

    /// In pseudo-time from the start, by schemes that are given.
    #[cfg(test)]
    pub(super) fn run_in_time(mut self, schemes: &[AdvectionScheme]) -> Result<Found, Failure> {
        self.schemes = schemes.to_vec();
        self.pseudo_time()?;
        let end = self.iterate(Pass::Kept, None)?;
        self.found(end)
    }

    fn found(mut self, end: End) -> Result<Found, Failure> {
        let End::Settled(solved) = end else {
            return Err(Failure::Cycling { history: self.history });
        };
        // What rounding has left in the balances is solved for once more: their sum is the balance of the oil.
        let linearisation = *solved;
        let left = self.balance.residual(&self.state.p, &self.state.theta);
        self.advance(&linearisation, &left)?;
        Ok(Found {
            residual: self.balance.residual(&self.state.p, &self.state.theta),
            state: self.state,
            schemes: self.schemes,
            linearisation,
            history: self.history,
            seconds: self.seconds,
            fallbacks: self.fallbacks,
        })
    }

    /// The step that takes away the residual `before`, made.
    fn advance(&mut self, linearisation: &Linearisation, before: &[f64]) -> Result<Vec<f64>, Failure> {
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

    fn corners<T>(&self, t: usize, of: impl Fn(usize) -> T) -> [T; 3] {
        self.film.volumes.triangles[t].map(|node| of(node as usize))
    }

    /// Solves and exchanges until every sign is right.
    fn iterate(&mut self, pass: Pass, time: Option<&TimeStep>) -> Result<End, Failure> {
        let mut seen = HashSet::new();
        let mut at_first = None;
        while self.history.len() < MOST_STEPS {
            match pass {
                Pass::First => self.choose_first_schemes(),
                Pass::Second if self.choose_second_schemes() => seen.clear(),
                Pass::Second | Pass::Kept => {}
            }
            let (linearisation, residual) = self.solve(time)?;
            let wrong = self.wrong_signs(&residual);
            self.record(&wrong);
            let at_first = *at_first.get_or_insert(wrong.len());
            let nearly = wrong.is_empty() || (wrong.len() as f64) < NEARLY * at_first as f64;
            let calmed = pass != Pass::First && nearly && self.calm_overdrawn(pass);
            if calmed {
                seen.clear();
            }
            if wrong.is_empty() {
                if calmed {
                    self.renewed = linearisation.into_unsymmetric();
                    continue;
                }
                return Ok(End::Settled(Box::new(linearisation)));
            }
            let mut hasher = DefaultHasher::new();
            self.state.cavity.hash(&mut hasher);
            if !seen.insert(hasher.finish()) {
                return Ok(End::Repeated);
            }
            let restless = self.restless(&wrong);
            if self.calm(&restless, &[AdvectionScheme::LowDiffusion]) {
                seen.clear();
            }
            self.renewed = linearisation.into_unsymmetric();
            let turned: Vec<usize> = wrong.into_iter().map(|(dof, _)| dof).collect();
            self.state.turn(self.film, &turned);
            self.state.relax(self.film, &self.balance, &turned);
        }
        Err(Failure::TooManySteps { history: std::mem::take(&mut self.history) })
    }

    /// A step's entry in the history.
    fn record(&mut self, wrong: &[(usize, f64)]) {
        let violation = wrong.iter().map(|(_, size)| size * size).sum::<f64>().sqrt();
        let first = *self.first.get_or_insert(if violation > 0.0 { violation } else { 1.0 });
        let active = self.state.cavity.iter().filter(|cavity| **cavity).count();
        self.history.push(HistoryStep { residual: violation / first, damping: 1.0, active });
    }

    /// The balance of all nodes for the present cavity: it is linear.
    fn solve(&mut self, time: Option<&TimeStep>) -> Result<(Linearisation, Vec<f64>), Failure> {
        let clock = Instant::now();
        let (film, rows) = (self.film, &self.film.rows);
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

    /// What is carried by the present schemes, with what the boundary brings and takes.
    fn carry(&mut self, time: Option<&TimeStep>) {
        if self.is_carried && time.is_none() {
            return;
        }
        self.is_carried = self.film.history.is_some() && time.is_none();
        let (volumes, rows) = (self.film.volumes, &self.film.rows);
        let Balance { transport, constant, .. } = &mut self.balance;
        transport.values.fill(0.0);
        for (block, (scheme, addresses)) in self.film.blocks.iter().zip(self.schemes.iter().zip(&volumes.addresses)) {
            add(transport, addresses, &block.transport(*scheme, block));
        }
        // What a film with a history held says how much oil goes round.
        if self.film.history.is_none() {
            for dof in loops::without_source(transport, &self.state.cavity, &rows.inflow) {
                transport.add_to_diagonal(dof, loops::LEAK * transport.diagonal(dof));
            }
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

    /// Nodes on the wrong side, and by how much in natural units: full ones with tension, or at an edge through which
    /// pressure would drive oil in; those of the cavity with more oil than there is room for.
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

    /// Backward Euler in the film fraction with growing steps, towards the steady film.
    fn pseudo_time(&mut self) -> Result<(), Failure> {
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
            self.iterate(Pass::Kept, Some(&time))?;
            time.before.clone_from(&self.state.theta);
            time.rate /= TIME_GROWTH;
        }
        Ok(())
    }
}
