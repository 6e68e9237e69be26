//! First-order changes of the balances of a solved film with its law, while cavity and film fraction stay.

use oilwedge_fem::integrate::Nodal;
use oilwedge_fem::{ControlVolumes, Error};

use super::blocks::{Block, EvaluationPoints, balance_changes};
use super::rows::NodeConditions;
use super::{FilmFraction, cavity_floor};
use crate::film_law::{AtPoints, FilmAndFlows, FilmLaw};
use crate::{FilmChange, FilmPoint, SolvedFilm};

/// First-order changes of every balance with each of some `changes` of the film.
///
/// # Errors
/// A system that does not fit in memory.
pub(crate) fn residual_changes(
    film: &SolvedFilm,
    fraction: &FilmFraction,
    changes: &[FilmChange<'_>],
) -> Result<Vec<Vec<f64>>, Error> {
    let of_points: Vec<PointChanges> =
        changes.iter().map(|change| PointChanges::new(film, fraction, *change)).collect::<Result<_, _>>()?;
    let Some(first) = of_points.first() else {
        return Ok(Vec::new());
    };
    let volumes = first.volumes;
    let balances =
        balance_changes(&first.law, changes, (film.system.space(), volumes), |t, block| first.of_block(t, block));
    let mut residuals = vec![vec![0.0; film.solution.unknown.len()]; changes.len()];
    for (nodes, balances) in volumes.triangles.iter().zip(balances.chunks(changes.len())) {
        for (residual, balances) in residuals.iter_mut().zip(balances) {
            for (node, balance) in nodes.iter().zip(balances) {
                residual[*node as usize] += balance;
            }
        }
    }
    for (residual, of_points) in residuals.iter_mut().zip(&of_points) {
        for (dof, _, balance) in of_points.of_boundary() {
            residual[dof] += balance;
        }
    }
    Ok(residuals)
}

/// A film and a change of its law, which acts point by point.
pub(crate) struct PointChanges<'a> {
    film: &'a SolvedFilm,
    fraction: &'a FilmFraction,
    volumes: &'a ControlVolumes,
    law: FilmLaw<'a>,
    change: FilmChange<'a>,
}

/// Changes of the balances of the nodes of one triangle with changes at its points.
pub(crate) struct AtPointsOf {
    points: EvaluationPoints,
    /// Changes of all nodes for each point [m3/s].
    pub(crate) balances: AtPoints<Nodal>,
}

impl AtPointsOf {
    /// Places of the points [m].
    pub(crate) fn positions(&self) -> &[[f64; 2]] {
        self.points.positions()
    }
}

impl<'a> PointChanges<'a> {
    /// # Errors
    /// A system that does not fit in memory.
    pub(crate) fn new(film: &'a SolvedFilm, fraction: &'a FilmFraction, change: FilmChange<'a>) -> Result<Self, Error> {
        Ok(Self { film, fraction, volumes: film.system.volumes()?, law: FilmLaw::new(&film.problem, 1.0), change })
    }

    /// Changes of the balances with each point of a triangle, while the other points stay.
    pub(crate) fn of_triangle(&self, cell: usize) -> AtPointsOf {
        let points = EvaluationPoints::new(self.film.system.space(), cell);
        let [mut at, mut change] = <[FilmAndFlows; 2]>::default();
        let place = (cell, points.positions());
        self.law.oil_and_flows_with_changes(&[self.change], place, |_, film, moved| (at, change) = (*film, *moved));
        let mut balances = AtPoints::<Nodal>::default();
        let mut single = FilmAndFlows::default();
        for (k, corners) in points.sub_triangles.iter().enumerate() {
            let t = cell * self.volumes.per_triangle + k;
            let upwind = points.block(k, &at, None);
            for &point in corners.iter().chain(&points.middles[k]) {
                (single.0[point], single.1[point]) = (change.0[point], change.1[point]);
                let moved = points.block(k, &at, Some(&single));
                for (&node, balance) in corners.iter().zip(self.of_block(t, &[upwind, moved])) {
                    balances[point][node] += balance;
                }
                (single.0[point], single.1[point]) = (FilmPoint::default(), Default::default());
            }
        }
        AtPointsOf { points, balances }
    }

    /// Changes of what is carried through pieces of the boundary in the balance of a dof: the dof, the triangle of the
    /// piece and where it is [m], and the change [m3/s].
    pub(crate) fn of_boundary(&self) -> Vec<(usize, (usize, [f64; 2]), f64)> {
        let (SolvedFilm { problem, system, .. }, volumes) = (self.film, self.volumes);
        let rows = NodeConditions::new(problem, system, volumes, &self.law, cavity_floor(problem));
        let changed = FilmLaw::changed(problem, self.change);
        let mut changes = Vec::new();
        for face in &volumes.faces {
            let share = rows.share(system, face.dof, self.fraction.values[face.dof]);
            if share != 0.0 {
                let flux = changed.film_and_flows(face.cell, &[face.middle]).1[0].flux;
                let out = flux[0] * face.normal[0] + flux[1] * face.normal[1];
                changes.push((face.dof, (face.cell, face.middle), share * out));
            }
        }
        changes
    }

    /// Changes of the balances of the corners of sub-triangle `t` with the change of its block.
    fn of_block(&self, t: usize, [upwind, moved]: &[Block; 2]) -> [f64; 3] {
        let (k, b) = (moved.pressure(), moved.transport_change(upwind));
        let nodes = self.volumes.triangles[t].map(|node| node as usize);
        [0, 1, 2].map(|i| {
            let parts = nodes.iter().enumerate();
            parts
                .map(|(j, &node)| k[i][j] * self.film.solution.unknown[node] + b[i][j] * self.fraction.values[node])
                .sum()
        })
    }
}
