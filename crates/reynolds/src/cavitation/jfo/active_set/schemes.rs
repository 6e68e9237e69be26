//! The choice of the advection scheme in each sub-triangle, as the cavity is found.

use super::super::ROUNDING;
use super::super::blocks::{AdvectionScheme, Block};
use super::super::positivity::{UNDERSHOOT, least_carried};
use super::{MOST_RETURNS, Pass, RESTLESS, Search};

impl Search<'_> {
    /// The N scheme in every sub-triangle with a node in the cavity, and where the cavity comes and goes.
    pub(super) fn choose_first_schemes(&mut self) {
        for t in 0..self.schemes.len() {
            if self.corners(t, |node| self.state.cavity[node]).contains(&true) {
                self.schemes[t] = AdvectionScheme::Positive;
            } else if self.schemes[t] == AdvectionScheme::Positive && self.left[t] < MOST_RETURNS {
                self.left[t] += 1;
                self.schemes[t] = AdvectionScheme::Faces;
            }
        }
    }

    /// LDA where the inflow side is starved.
    pub(super) fn second_schemes(&self) -> Vec<AdvectionScheme> {
        let scheme =
            |(t, block): (usize, &Block)| match block.is_starved(self.corners(t, |node| self.state.cavity[node])) {
                true => AdvectionScheme::LowDiffusion,
                false => AdvectionScheme::Faces,
            };
        self.film.blocks.iter().enumerate().map(scheme).collect()
    }

    /// Nodes that have turned so often.
    pub(super) fn restless(&mut self, turned: &[(usize, f64)]) -> Vec<usize> {
        let mut restless = Vec::new();
        for &(dof, _) in turned {
            if let Some(turns) = self.turns.get_mut(dof) {
                *turns = turns.saturating_add(1);
                restless.extend((*turns == RESTLESS).then_some(dof));
            }
        }
        restless
    }

    /// Carries the oil round these nodes by the N scheme where that is by one of `others`. True if that is new.
    pub(super) fn calm(&mut self, nodes: &[usize], others: &[AdvectionScheme]) -> bool {
        if nodes.is_empty() {
            return false;
        }
        let mut marked = vec![false; self.state.p.len()];
        nodes.iter().for_each(|&dof| marked[dof] = true);
        let mut new = false;
        for t in 0..self.schemes.len() {
            if others.contains(&self.schemes[t]) && self.corners(t, |node| marked[node]).contains(&true) {
                self.schemes[t] = AdvectionScheme::Positive;
                new = true;
            }
        }
        new
    }

    /// Carries the oil round nodes that hold less than is carried to them by the N scheme, which is positive; where schemes are kept, round those
    /// that hold less than none. True if that is new.
    pub(super) fn calm_overdrawn(&mut self, pass: Pass) -> bool {
        let least = match pass {
            Pass::Kept => vec![0.0; self.state.p.len()],
            Pass::First | Pass::Second => least_carried(self.film, &self.state.theta),
        };
        let overdrawn: Vec<usize> = (0..self.state.p.len())
            .filter(|&dof| {
                self.state.cavity[dof] && self.state.theta[dof] < least[dof] - UNDERSHOOT * least[dof].abs() - ROUNDING
            })
            .collect();
        self.calm(&overdrawn, &[AdvectionScheme::LowDiffusion, AdvectionScheme::Faces])
    }

    /// The schemes of the second pass for the present cavity. Each sub-triangle changes once: some along the rupture line
    /// would chatter. True if any changed.
    pub(super) fn choose_second_schemes(&mut self) -> bool {
        let chosen = self.second_schemes();
        let mut new = false;
        for ((scheme, chosen), changed) in self.schemes.iter_mut().zip(chosen).zip(&mut self.changed) {
            if *scheme != AdvectionScheme::Positive && *scheme != chosen && !*changed {
                (*scheme, *changed, new) = (chosen, true, true);
            }
        }
        new
    }
}
