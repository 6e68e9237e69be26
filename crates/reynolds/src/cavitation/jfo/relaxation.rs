//! Relaxation near nodes that changed sides, to foresee which of their neighbours will.
//!
//! A solve of all balances shows which nodes are on the wrong side, but the edge of a streak of oil then walks by one
//! node a solve. So between solves each node near a change is given the pressure, or the film fraction, that balances
//! it while its neighbours stay; where that changes, its neighbours follow (projected Gauss-Seidel relaxation). They
//! are visited downstream, so that neither their numbers nor a mirror change the answer. Only the sides of the nodes
//! are kept: the next solve is of all balances again, and has the last word.
//!
//! Cryer, SIAM J. Control 9 (1971) 385 (the relaxation); Brandt, Cryer, SIAM J. Sci. Stat. Comput. 4 (1983) 655.

use oilwedge_fem::Space;

use super::DiscreteFilm;
use super::balance::CellBalance;
use super::rows::Condition;

/// Greatest number of visits of one node.
const SWEEPS: usize = 40;
/// Changes below this value, in natural units, do not spread from their node.
const STILL: f64 = 1e-6;

/// Pressure, film fraction and side of every node.
#[derive(Debug, Clone)]
pub(super) struct NodeStates {
    /// Reduced pressure [Pa].
    pub(super) p: Vec<f64>,
    pub(super) theta: Vec<f64>,
    /// True in the cavity.
    pub(super) cavity: Vec<bool>,
}

impl NodeStates {
    /// A film that is full but for the nodes of `cavity`.
    pub(super) fn new(p: Vec<f64>, cavity: Vec<bool>) -> Self {
        let theta = vec![1.0; p.len()];
        Self { p, theta, cavity }
    }

    /// Moves nodes to the other side.
    pub(super) fn turn(&mut self, film: &DiscreteFilm<'_>, nodes: &[usize]) {
        for &dof in nodes {
            self.cavity[dof] = !self.cavity[dof];
            self.theta[dof] = 1.0;
            self.p[dof] = film.rows.value[dof];
        }
    }

    /// Relaxes the surroundings of nodes that have turned.
    pub(super) fn relax(&mut self, film: &DiscreteFilm<'_>, balance: &CellBalance, turned: &[usize]) {
        let mut front = VisitFront::new(film, self.p.len());
        turned.iter().for_each(|&dof| front.reach(dof));
        for _ in 0..SWEEPS {
            for dof in front.advance() {
                let (p, theta, cavity) = self.balanced(film, balance, dof);
                let change = (p - self.p[dof]).abs() / film.scale + (theta - self.theta[dof]).abs();
                if change > STILL || cavity != self.cavity[dof] {
                    front.reach(dof);
                }
                (self.p[dof], self.theta[dof], self.cavity[dof]) = (p, theta, cavity);
            }
        }
    }

    /// State of one node that balances it while its neighbours stay.
    fn balanced(&self, film: &DiscreteFilm<'_>, balance: &CellBalance, dof: usize) -> (f64, f64, bool) {
        let floor = film.rows.value[dof];
        let pattern = &balance.pressure.pattern;
        let (mut left, mut driven, mut carried) = (balance.constant[dof], 0.0, 0.0);
        for k in pattern.row(dof) {
            let (by_pressure, by_theta) = (balance.pressure.values[k], balance.transport.values[k]);
            match pattern.columns[k] as usize {
                other if other == dof => (driven, carried) = (by_pressure, by_theta),
                other => left += by_pressure * self.p[other] + by_theta * self.theta[other],
            }
        }
        left += driven * floor;
        // Flow that the node loses while it is full and without pressure.
        let loss = left + carried;
        match film.rows.condition[dof] {
            Condition::Given => (self.p[dof], 1.0, false),
            // The fraction is not negative: overdrawn nodes of the LDA scheme would draw on each other without end.
            _ if loss > 0.0 && carried > 0.0 => (floor, (-left / carried).max(0.0), true),
            Condition::Interior if driven > 0.0 => (floor + (-loss / driven).max(0.0), 1.0, false),
            _ => (floor, 1.0, false),
        }
    }
}

/// The order in which the journal passes the nodes.
#[derive(Debug)]
pub(super) struct Downstream {
    order: Vec<u32>,
    /// Place of each node in the order.
    places: Vec<u32>,
}

impl Downstream {
    /// A journal that moves at `velocity` [m/s]; a ring is cut at the narrowest film, `cut` [m].
    pub(super) fn new(space: &Space, velocity: [f64; 2], cut: f64) -> Self {
        /// Places are distinguished by so much of the extent of the film.
        const APART: f64 = 1e-9;
        let mesh = space.mesh();
        let speed = velocity[0].hypot(velocity[1]).max(f64::MIN_POSITIVE);
        let direction = velocity.map(|v| v / speed);
        let along = |x: f64| match mesh.period() {
            // On the way from the cut; its end is its start.
            Some(period) => {
                let way = ((x - cut) * direction[0].signum()).rem_euclid(period);
                direction[0].abs() * if way > period * (1.0 - APART) { 0.0 } else { way }
            }
            None => x * direction[0],
        };
        let way: Vec<[f64; 2]> =
            (space.positions().into_iter()).map(|[x, z]| [along(x) + z * direction[1], z]).collect();
        let extent = way.iter().fold(f64::MIN_POSITIVE, |most, [s, z]| most.max(s.abs()).max(z.abs()));
        // Between -1/APART and 1/APART: 32 bits each, the way first.
        let steps = |length: f64| ((length / extent + 1.0) / APART).round() as u64;
        let mut keys: Vec<(u64, u32)> =
            (way.iter().zip(0..)).map(|([s, z], dof)| ((steps(*s) << 32) | steps(*z), dof)).collect();
        keys.sort_unstable();
        let order: Vec<u32> = keys.into_iter().map(|(_, dof)| dof).collect();
        let mut places = vec![0; order.len()];
        for (place, &dof) in (0..).zip(&order) {
            places[dof as usize] = place;
        }
        Self { order, places }
    }
}

/// Nodes to be visited next.
struct VisitFront<'a> {
    film: &'a DiscreteFilm<'a>,
    /// The nodes by their places downstream.
    next: Vec<u32>,
    waits: Vec<bool>,
}

impl<'a> VisitFront<'a> {
    fn new(film: &'a DiscreteFilm<'a>, nodes: usize) -> Self {
        let (next, waits) = (Vec::new(), vec![false; nodes]);
        Self { film, next, waits }
    }

    /// Adds a node and its neighbours.
    fn reach(&mut self, dof: usize) {
        let pattern = &self.film.volumes.pattern;
        for k in pattern.row(dof) {
            let neighbour = pattern.columns[k] as usize;
            if !std::mem::replace(&mut self.waits[neighbour], true) {
                self.next.push(self.film.downstream.places[neighbour]);
            }
        }
    }

    /// Visits the nodes that wait, from upstream to downstream.
    fn advance(&mut self) -> Vec<usize> {
        let mut now = std::mem::take(&mut self.next);
        now.sort_unstable();
        let nodes = now.iter().map(|&place| self.film.downstream.order[place as usize] as usize);
        let nodes: Vec<usize> = nodes.collect();
        nodes.iter().for_each(|&dof| self.waits[dof] = false);
        nodes
    }
}
