//! Which balance each node has, and whether oil reaches every part of the film.
//!
//! | node | pressure | film fraction | its balance gives |
//! |---|---|---|---|
//! | interior | unknown while full | unknown in the cavity | the unknown |
//! | given | given | one | its inflow |
//! | edge, full | given | one | what pressure drives out |
//! | edge, in the cavity | given | unknown | the unknown |
//!
//! Given nodes are those of feeds, of flooded lines, and of ends above the cavitation pressure. Edges are ends at the
//! cavitation pressure, where no oil comes in, and lines by which oil leaves.

use oilwedge_fem::ControlVolumes;

use crate::existence::NoFilm;
use crate::film_law::FilmLaw;
use crate::supply::BoundaryKind;
use crate::{FilmProblem, FilmSystem};

/// Condition of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Condition {
    /// Neither pressure nor film fraction is given.
    Interior,
    /// The pressure is given, and the film is full.
    Given,
    /// The pressure is that of the cavity, and no oil comes in.
    Edge,
}

/// Conditions of all nodes.
#[derive(Debug)]
pub(super) struct NodeConditions {
    pub(super) condition: Vec<Condition>,
    /// Given unknown (reduced pressure) [Pa]; that of the cavity elsewhere.
    pub(super) value: Vec<f64>,
    /// Flow that a starved inlet brings in [m3/s].
    pub(super) inflow: Vec<f64>,
    /// Flow that the journal carries out through the boundary at an edge node while the film is full [m3/s]; pressure
    /// may drive out more.
    pub(super) outflow: Vec<f64>,
}

impl NodeConditions {
    /// Conditions of `problem` where the cavity has the reduced pressure `floor`.
    pub(super) fn new(
        problem: &FilmProblem,
        system: &FilmSystem,
        volumes: &ControlVolumes,
        law: &FilmLaw,
        floor: f64,
    ) -> Self {
        let dofs = system.space().dofs();
        let mut rows = Self {
            condition: vec![Condition::Interior; dofs],
            value: vec![floor; dofs],
            inflow: vec![0.0; dofs],
            outflow: vec![0.0; dofs],
        };
        // Couette flow out through the boundary near each node.
        let mut carried = vec![0.0; dofs];
        for face in &volumes.faces {
            let flux = law.film_and_flows(face.cell, &[face.middle]).1[0].flux;
            carried[face.dof] += flux[0] * face.normal[0] + flux[1] * face.normal[1];
        }
        let mut on_end = vec![false; dofs];
        for region in system.supply.regions().iter().filter(|region| region.kind == BoundaryKind::End) {
            for dof in region.edges.iter().flat_map(|&edge| system.space().dofs_on_edge(edge)) {
                on_end[dof] = true;
            }
        }
        for dof in 0..dofs {
            let Some(owner) = system.supply.owner(dof) else {
                continue;
            };
            let region = &system.supply.regions()[owner];
            let starved = region.film_fraction.filter(|_| carried[dof] < 0.0);
            rows.inflow[dof] = starved.map_or(0.0, |fraction| -fraction * carried[dof]);
            // The pressure at a starved inlet is found, but at its corners the end holds it.
            let pressure = match (starved, on_end[dof]) {
                (Some(_), false) => continue,
                (Some(_), true) => problem.bearing.end_pressure,
                (None, _) => region.pressure,
            };
            rows.value[dof] = problem.unknown_at(pressure);
            let open = match region.kind {
                BoundaryKind::Feed | BoundaryKind::Sealed => false,
                BoundaryKind::End => true,
                BoundaryKind::Line => carried[dof] > 0.0 || starved.is_some(),
            };
            rows.condition[dof] = match open && rows.value[dof] <= floor {
                true => Condition::Edge,
                false => Condition::Given,
            };
            if rows.condition[dof] == Condition::Edge {
                rows.outflow[dof] = carried[dof].max(0.0);
            }
        }
        rows
    }

    /// Volume flow [m3/s] into the film through the boundary near each node, given the residual of its balance: what
    /// starved inlets bring and the journal carries out at edges are in the balance already.
    pub(super) fn boundary_inflow(&self, residual: &[f64], theta: &[f64]) -> Vec<f64> {
        (0..residual.len()).map(|dof| residual[dof] + self.inflow[dof] - self.outflow[dof] * theta[dof]).collect()
    }

    /// The part of a full film that is carried through the boundary near a node, where that is in its balance.
    pub(super) fn share(&self, system: &FilmSystem, dof: usize, theta: f64) -> f64 {
        let owner = system.supply.owner(dof).map(|owner| &system.supply.regions()[owner]);
        match owner.and_then(|region| region.film_fraction) {
            Some(fraction) if self.inflow[dof] > 0.0 => fraction,
            _ if self.outflow[dof] > 0.0 => theta,
            _ => 0.0,
        }
    }

    /// Each connected part of the film must touch a given node or a starved inlet: nothing else settles how much
    /// oil it holds.
    pub(super) fn check_supply(
        &self,
        problem: &FilmProblem,
        system: &FilmSystem,
        volumes: &ControlVolumes,
    ) -> Result<(), NoFilm> {
        let given = |node: u32| self.condition[node as usize] == Condition::Given;
        let mut parts = DisjointSets::new(self.condition.len());
        let mut supplied: Vec<bool> = self.inflow.iter().map(|&inflow| inflow > 0.0).collect();
        for nodes in &volumes.triangles {
            let mut open = nodes.iter().copied().filter(|&node| !given(node));
            if let Some(first) = open.next() {
                open.for_each(|node| parts.join(first, node));
            }
        }
        for nodes in volumes.triangles.iter().filter(|nodes| nodes.iter().any(|&node| given(node))) {
            nodes.iter().for_each(|&node| supplied[node as usize] = true);
        }
        let mut reached = vec![false; supplied.len()];
        for node in 0..supplied.len() as u32 {
            reached[parts.root(node) as usize] |= supplied[node as usize];
        }
        let dry = (0..supplied.len() as u32).find(|&node| !given(node) && !reached[parts.root(node) as usize]);
        match dry {
            None => Ok(()),
            Some(node) => {
                let [x, z] = system.space().positions()[node as usize];
                let angle = (x / problem.bearing.radius).rem_euclid(std::f64::consts::TAU);
                Err(NoFilm::NoSupply { angle, z })
            }
        }
    }
}

/// Disjoint sets of nodes.
pub(super) struct DisjointSets(Vec<u32>);

impl DisjointSets {
    pub(super) fn new(nodes: usize) -> Self {
        Self((0..nodes as u32).collect())
    }

    fn root(&mut self, mut node: u32) -> u32 {
        while self.0[node as usize] != node {
            let above = self.0[self.0[node as usize] as usize];
            self.0[node as usize] = above;
            node = above;
        }
        node
    }

    /// The set of a node, as [`Self::root`], without shortening the way to it.
    pub(super) fn find(&self, mut node: u32) -> u32 {
        while self.0[node as usize] != node {
            node = self.0[node as usize];
        }
        node
    }

    pub(super) fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a as usize] = b;
    }
}
