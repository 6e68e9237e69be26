//! The hill on one space: Newton steps and contact together, and what more oil would change.

use std::sync::Arc;

use oilwedge_fem::newton::{NewtonFailure, NewtonStep};
use oilwedge_fem::{Constraints, Error, Field, Linearisation, Space, UnsymmetricAnalysis};

use super::balance::HillBalance;

/// A step that leaves this part of the residual or more is followed by one with a new factor.
const SLOW: f64 = 0.1;
/// Most steps of one solve.
const MOST_STEPS: usize = 40;
/// Part of the greatest residual, and of the greatest pressure, that is round-off.
const ROUNDING: f64 = 1e-10;
/// Oil may be off by this part at most.
const MOST_OFF: f64 = 0.5;
/// The least n_x.
const LEAST_ALONG: f64 = 0.15;

/// Kinds of the nodes.
#[derive(Debug, Clone)]
pub(super) struct NodeKinds {
    /// Given pressures above that of the cavity [Pa].
    pub(super) given: Constraints,
    /// Nodes in the middle of a cavity: v = 0, and the oil that is let in there.
    pub(super) pinned: Vec<bool>,
    /// Whether each node is on the side of rupture: v >= 0.
    pub(super) may_touch: Vec<bool>,
    /// Nodes of given pressure at which a cavity meets an end: nothing flows there.
    pub(super) closed: Vec<bool>,
}

/// What a hill leaves for the next one.
#[derive(Debug, Default)]
pub(super) struct Kept {
    /// Pressure above that of the cavity [Pa].
    pub(super) v: Vec<f64>,
    /// Whether each node is in contact.
    pub(super) held: Vec<bool>,
    /// Alignment n_x of the pressure's gradient with the flow, at vertices; empty where it is not known.
    pub(super) along: Vec<f64>,
    /// Tangent of the hill.
    pub(super) linearisation: Option<Linearisation>,
}

/// A hill on its way.
pub(super) struct Hill<'a> {
    pub(super) balance: HillBalance<'a>,
    pub(super) nodes: NodeKinds,
    pub(super) analysis: Arc<UnsymmetricAnalysis>,
    /// Pressure above that of the cavity [Pa].
    pub(super) v: Vec<f64>,
    pub(super) held: Vec<bool>,
    /// Tangent of a step before.
    pub(super) linearisation: Option<Linearisation>,
    /// True where that is of no more use.
    pub(super) is_stale: bool,
    pub(super) history: Vec<NewtonStep>,
}

impl Hill<'_> {
    /// Finds rupture and reformation for the oil that arrives, until the residual is this part of the greatest share of
    /// a node.
    pub(super) fn solve(&mut self, enough: f64) -> Result<(), NewtonFailure> {
        let mut fixed = self.fixed();
        fixed.impose(&mut self.v);
        let mut residual = self.balance.residual(&self.v);
        let mut left = f64::INFINITY;
        for _ in 0..MOST_STEPS {
            if !self.serves(&fixed) {
                self.linearise(fixed.clone())?;
            }
            self.step(&residual)?;
            residual = self.balance.residual(&self.v);
            let greatest = residual.iter().fold(0.0f64, |most, r| most.max(r.abs()));
            let wrong = self.wrong_signs(&residual, greatest);
            let before = std::mem::replace(&mut left, fixed.free_norm(&residual) / greatest);
            self.history.push(NewtonStep::active(left, wrong.len()));
            if wrong.is_empty() && left < enough {
                return Ok(());
            }
            if !wrong.is_empty() {
                for dof in &wrong {
                    self.held[*dof] = !self.held[*dof];
                }
                fixed = self.fixed();
                fixed.impose(&mut self.v);
                residual = self.balance.residual(&self.v);
            }
            self.is_stale = left > SLOW * before;
        }
        Err(NewtonFailure::TooManySteps { history: std::mem::take(&mut self.history) })
    }

    /// Whether the factor there is serves steps with these dofs given.
    fn serves(&self, fixed: &Constraints) -> bool {
        let there = self.linearisation.as_ref().map(Linearisation::constraints);
        !self.is_stale && there.is_some_and(|there| there.fixed == fixed.fixed)
    }

    /// Factorises the tangent at v.
    fn linearise(&mut self, fixed: Constraints) -> Result<(), Error> {
        let (spare, factor) = self.linearisation.take().and_then(Linearisation::into_unsymmetric).unzip();
        let mut tangent = spare.unwrap_or_else(|| self.balance.conduction.clone());
        self.balance.tangent(&self.v, &mut tangent);
        let factor = self.analysis.factorise(&tangent, &fixed.fixed, factor)?;
        self.linearisation = Some(Linearisation::unsymmetric(tangent, factor, fixed));
        Ok(())
    }

    /// Moves v by the factor there is.
    fn step(&mut self, residual: &[f64]) -> Result<(), Error> {
        let Some(linearisation) = &self.linearisation else {
            return Ok(());
        };
        let step = linearisation.apply_factor(residual.to_vec(), false)?;
        self.v.iter_mut().zip(&step).for_each(|(v, step)| *v -= step);
        Ok(())
    }

    /// Nodes with tension, and held ones that would take oil away.
    fn wrong_signs(&self, residual: &[f64], greatest: f64) -> Vec<usize> {
        let most = self.v.iter().fold(0.0f64, |most, v| most.max(v.abs()));
        let is_wrong = |&dof: &usize| match self.held[dof] {
            true => residual[dof] < -ROUNDING * greatest,
            false => self.nodes.may_touch[dof] && self.v[dof] < -ROUNDING * most,
        };
        (0..self.v.len()).filter(is_wrong).collect()
    }

    /// All nodes whose pressure is not sought now.
    fn fixed(&self) -> Constraints {
        let mut fixed = self.nodes.given.clone();
        for dof in 0..self.v.len() {
            if !fixed.fixed[dof] && (self.nodes.pinned[dof] || self.held[dof]) {
                fixed.fix(dof, 0.0);
            }
        }
        fixed
    }

    /// Oil [m3/s] made in the cavities where the balances are `residual`: none is where the oil that arrives is that
    /// which left.
    fn made(&self, residual: &[f64]) -> f64 {
        let is_cavity = |&dof: &usize| self.nodes.pinned[dof] || self.held[dof] || self.nodes.closed[dof];
        (0..residual.len()).filter(is_cavity).map(|dof| residual[dof]).sum()
    }

    /// The hill, to first order, for as much oil as makes up for what is lost, and how much more that is as a part;
    /// none where more oil makes no difference.
    pub(super) fn replenished(&self) -> Result<(Vec<f64>, f64), Error> {
        let Some(linearisation) = &self.linearisation else {
            return Ok((self.v.clone(), 0.0));
        };
        let by_oil = self.balance.by_oil(&self.v);
        let minus: Vec<f64> = by_oil.iter().map(|r| -r).collect();
        let change = linearisation.solve(&minus)?;
        let through = linearisation.matrix().multiply(&change);
        let total: Vec<f64> = by_oil.iter().zip(through).map(|(a, b)| a + b).collect();
        let (made, more) = (self.made(&self.balance.residual(&self.v)), self.made(&total));
        let part = if more > 0.0 { (-made / more).clamp(-MOST_OFF, MOST_OFF) } else { 0.0 };
        Ok((self.v.iter().zip(change).map(|(v, change)| v + part * change).collect(), part))
    }

    /// The nodes of cubic elements on the same mesh that are in contact where this quadratic hill is.
    pub(super) fn contact_in(&self, cubic: &Space) -> Vec<bool> {
        let space = self.balance.space;
        let mut held = vec![false; cubic.dofs()];
        for t in 0..space.mesh().triangles().len() {
            let is_held = |&dof: &usize| self.held[dof] || self.nodes.pinned[dof];
            if space.element_dofs(t)[3..6].iter().all(is_held) {
                let dofs = &cubic.element_dofs(t)[..cubic.shapes()];
                dofs.iter().for_each(|&dof| held[dof] = true);
            }
        }
        held
    }

    /// What the next hill starts from.
    pub(super) fn kept(self) -> (Kept, NodeKinds) {
        let kept = Kept { v: self.v, held: self.held, along: self.balance.along, linearisation: self.linearisation };
        (kept, self.nodes)
    }

    /// Takes n_x from the pressure that is there.
    pub(super) fn renew_direction(&mut self) {
        let (space, mesh) = (self.balance.space, self.balance.space.mesh());
        let field = Field { space, values: &self.v };
        let mut sums = vec![[0.0; 2]; mesh.points().len()];
        for (t, corners) in mesh.triangles().iter().enumerate() {
            let [a, b, c] = mesh.corners(t);
            let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            let [x, z] = field.value_and_gradient(t, [1.0 / 3.0; 2]).1;
            for &v in corners {
                sums[v as usize][0] += area * x.abs();
                sums[v as usize][1] += area * x.hypot(z);
            }
        }
        for (along, [x, all]) in self.balance.along.iter_mut().zip(sums) {
            *along = if all > 0.0 { (x / all).max(LEAST_ALONG) } else { 1.0 };
        }
    }
}
