//! A frame of beams, and what its journals see of it: stiffness by their coordinates alone, and loads elsewhere as
//! forces on them.
//!
//! **Equation.** With the motions q_r of the journals and q_i of all else, `K q = f` is, without q_i,
//! ```text
//! (K_rr - K_ri K_ii^-1 K_ir) q_r = f_r - K_ri K_ii^-1 f_i
//! ```
//! Rigid motions across the axis cost nothing, and loads are moved to the journals by statics: round-off of the
//! elimination is taken out of both by projection, so that the sums of forces and moments are right to round-off of
//! their own size, however stiff the shaft is.

use super::beam::{Beam, Point};
use super::cut::shares;
use super::matrix::{Factors, SquareMatrix, product};
use crate::coordinates::{Coordinates, Vector};

/// Beams between nodes. The last node is held along and about the axis z, where the shaft is driven.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct BeamFrame {
    /// Where the nodes are [m].
    pub nodes: Vec<Point>,
    /// The beams.
    pub beams: Vec<Beam>,
}

/// A journal of the frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Number of its node, on the axis.
    pub node: usize,
    /// The coordinates that its film sees; with two of them the film resists no tilt.
    pub coordinates: Coordinates,
}

/// Why a frame is no shaft on journals.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NoShaft {
    /// The journals do not hold it.
    #[error(
        "the bearings leave the shaft free to move: two bearings at different places hold it, or one whose film resists tilt"
    )]
    Free,
    /// The stiffness of the shaft cannot be factorised.
    #[error("the stiffness of the shaft is singular: pieces of it have no size, or differ too much")]
    Singular,
}

/// A shaft as its journals see it.
#[derive(Debug, Clone)]
pub struct Shaft {
    /// Stiffness by the coordinates of all journals that are free [N/m], with the crank at angle 0.
    stiffness: SquareMatrix,
    /// Journal and coordinate of each row.
    rows: Vec<(usize, usize)>,
    /// How many journals there are.
    journals: usize,
    /// What a unit force towards x and towards y on each node that is loaded is as forces on the journals.
    transfers: Vec<[Vec<f64>; 2]>,
    /// What is between its journals; none where it is cut.
    pub(super) between: Option<BetweenJournals>,
}

/// The frame between the journals of a shaft, and its nodes that are loaded.
#[derive(Debug, Clone)]
pub(super) struct BetweenJournals {
    pub(super) frame: BeamFrame,
    pub(super) loaded: Vec<usize>,
    pub(super) eliminated: Eliminated,
}

/// A rigid motion: coordinates of the journals, and displacement `at_zero + by_z z` of the axis towards x or y.
#[derive(Debug, Clone)]
struct RigidMotion {
    coordinates: Vec<f64>,
    towards: usize,
    at_zero: f64,
    by_z: f64,
}

/// A force on a node that is loaded, by its number in the list of these.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NodeForce {
    /// Which of the nodes that are loaded.
    pub place: usize,
    /// Force towards x and y [N].
    pub force: [f64; 2],
}

/// Degrees of freedom of a node.
pub(super) const OF_NODE: usize = 6;
/// A rigid motion that is not told from those before it by this part of its size is none.
const DEPENDENT: f64 = 1e-9;

impl BeamFrame {
    /// The shaft on these journals, with loads on the nodes `loaded`.
    ///
    /// # Errors
    /// [`NoShaft`]: why it is none.
    pub fn on(&self, places: &[Place], loaded: &[usize]) -> Result<Shaft, NoShaft> {
        let eliminated = self.eliminated(places)?;
        let Eliminated { stiffness, retained, others, inner } = &eliminated;
        let numbers: Vec<usize> = retained.iter().map(|row| row.number).collect();
        let coupling = stiffness.part(&numbers, others);
        let follow = following(inner, &coupling);
        let mut condensed = stiffness.of_numbers(&numbers);
        for (row, coupled) in coupling.iter().enumerate() {
            for (column, follow) in follow.iter().enumerate() {
                condensed.add(row, column, -product(coupled, follow));
            }
        }
        let rows: Vec<(usize, usize)> = retained.iter().map(|row| (row.journal, row.coordinate)).collect();
        let rigid = rigid_motions(&rows, places, &self.nodes)?;
        let mut scaled = SquareMatrix::zeros(rows.len());
        for (i, a) in retained.iter().enumerate() {
            for (j, b) in retained.iter().enumerate() {
                let both = 0.5 * (condensed.at(i, j) + condensed.at(j, i));
                scaled.add(i, j, a.factor * both * b.factor);
            }
        }
        let transfer = |node: usize, towards: usize| {
            let number = OF_NODE * node + towards;
            let inner = others.iter().position(|other| *other == number);
            let moved: Vec<f64> = retained
                .iter()
                .zip(&follow)
                .map(|(row, follow)| {
                    row.factor * inner.map_or(f64::from(u8::from(row.number == number)), |at| -follow[at])
                })
                .collect();
            by_statics(moved, &rigid, towards, self.nodes[node][2])
        };
        Ok(Shaft {
            stiffness: without_rigid(&scaled, &rigid),
            rows,
            journals: places.len(),
            transfers: (loaded.iter()).map(|&node| [0, 1].map(|towards| transfer(node, towards))).collect(),
            between: Some(BetweenJournals { frame: self.clone(), loaded: loaded.to_vec(), eliminated }),
        })
    }

    fn eliminated(&self, places: &[Place]) -> Result<Eliminated, NoShaft> {
        let stiffness = self.stiffness();
        let retained: Vec<Retained> = (0..).zip(places).flat_map(Retained::of_place).collect();
        let last = OF_NODE * (self.nodes.len() - 1);
        let is_inner =
            |number: &usize| ![last + 2, last + 5].contains(number) && retained.iter().all(|row| row.number != *number);
        let others: Vec<usize> = (0..stiffness.order()).filter(is_inner).collect();
        let inner = stiffness.of_numbers(&others).factors().ok_or(NoShaft::Singular)?;
        Ok(Eliminated { stiffness, retained, others, inner })
    }

    fn stiffness(&self) -> SquareMatrix {
        let mut stiffness = SquareMatrix::zeros(OF_NODE * self.nodes.len());
        for beam in &self.beams {
            let number = |k: usize| OF_NODE * beam.nodes[k / OF_NODE] + k % OF_NODE;
            let of_beam = beam.stiffness(beam.nodes.map(|node| self.nodes[node]));
            for (i, row) in of_beam.iter().enumerate() {
                for (j, entry) in row.iter().enumerate() {
                    stiffness.add(number(i), number(j), *entry);
                }
            }
        }
        stiffness
    }
}

/// The degrees of freedom of a frame: those of its journals, and all others with the factors of their stiffness.
#[derive(Debug, Clone)]
pub(super) struct Eliminated {
    pub(super) stiffness: SquareMatrix,
    pub(super) retained: Vec<Retained>,
    pub(super) others: Vec<usize>,
    pub(super) inner: Factors,
}

/// A coordinate of a journal among the degrees of freedom of the frame.
#[derive(Debug, Clone)]
pub(super) struct Retained {
    pub(super) journal: usize,
    pub(super) coordinate: usize,
    pub(super) number: usize,
    /// The degree of freedom over the coordinate: 1, or that of a slope over its arm.
    pub(super) factor: f64,
}

impl Retained {
    /// Offsets are displacements; the slope towards x is the rotation about y, that towards y the rotation against x.
    fn of_place((journal, place): (usize, &Place)) -> Vec<Self> {
        let per_arm = 1.0 / place.coordinates.arm;
        let of_coordinates = [(0, 1.0), (1, 1.0), (4, per_arm), (3, -per_arm)];
        let retained = |(coordinate, (part, factor)): (usize, (usize, f64))| Self {
            journal,
            coordinate,
            number: OF_NODE * place.node + part,
            factor,
        };
        (0..).zip(of_coordinates).take(place.coordinates.order).map(retained).collect()
    }
}

/// How all else follows a unit of each retained coordinate, but for the sign.
fn following(inner: &Factors, coupling: &[Vec<f64>]) -> Vec<Vec<f64>> {
    coupling.iter().map(|row| inner.solve(row)).collect()
}

/// The rigid motions across the axis as coordinates of the journals, perpendicular to each other.
fn rigid_motions(rows: &[(usize, usize)], places: &[Place], nodes: &[Point]) -> Result<Vec<RigidMotion>, NoShaft> {
    let mut motions: Vec<RigidMotion> = Vec::new();
    for (towards, turns) in [(0, false), (1, false), (0, true), (1, true)] {
        let part = |&(journal, coordinate): &(usize, usize)| {
            let place: &Place = &places[journal];
            let z = nodes[place.node][2];
            match (coordinate % 2 == towards, coordinate < 2) {
                (false, _) => 0.0,
                (true, true) if turns => z,
                (true, true) => 1.0,
                (true, false) if turns => place.coordinates.arm,
                (true, false) => 0.0,
            }
        };
        let mut motion = RigidMotion {
            coordinates: rows.iter().map(part).collect(),
            towards,
            at_zero: f64::from(u8::from(!turns)),
            by_z: f64::from(u8::from(turns)),
        };
        let size = motion.size();
        // Twice, so that it is perpendicular to round-off.
        for _ in 0..2 {
            for other in motions.iter().filter(|other| other.towards == towards) {
                let along = product(&motion.coordinates, &other.coordinates);
                motion = motion.plus(-along, other);
            }
        }
        let left = motion.size();
        if left.is_nan() || left <= DEPENDENT * size {
            return Err(NoShaft::Free);
        }
        motions.push(motion.scaled(1.0 / left));
    }
    Ok(motions)
}

impl RigidMotion {
    fn size(&self) -> f64 {
        product(&self.coordinates, &self.coordinates).sqrt()
    }

    fn plus(mut self, factor: f64, other: &Self) -> Self {
        let both = self.coordinates.iter_mut().zip(&other.coordinates);
        both.for_each(|(own, other)| *own += factor * other);
        self.at_zero += factor * other.at_zero;
        self.by_z += factor * other.by_z;
        self
    }

    fn scaled(mut self, factor: f64) -> Self {
        self.coordinates.iter_mut().for_each(|own| *own *= factor);
        self.at_zero *= factor;
        self.by_z *= factor;
        self
    }
}

/// `P K P` with the projection P that takes rigid motions out.
fn without_rigid(stiffness: &SquareMatrix, rigid: &[RigidMotion]) -> SquareMatrix {
    let n = stiffness.order();
    let project = |mut vector: Vec<f64>| {
        for motion in rigid {
            let along = product(&vector, &motion.coordinates);
            (vector.iter_mut().zip(&motion.coordinates)).for_each(|(entry, part)| *entry -= along * part);
        }
        vector
    };
    let mut projected = SquareMatrix::zeros(n);
    for column in 0..n {
        let mut unit = vec![0.0; n];
        unit[column] = 1.0;
        let forces = project(stiffness.times(&project(unit)));
        (0..).zip(forces).for_each(|(row, force)| projected.add(row, column, force));
    }
    projected
}

/// Forces on the journals with the sum and the moment of a unit force on the axis at z.
fn by_statics(mut forces: Vec<f64>, rigid: &[RigidMotion], towards: usize, z: f64) -> Vec<f64> {
    for motion in rigid {
        let wanted = match motion.towards == towards {
            true => motion.at_zero + motion.by_z * z,
            false => 0.0,
        };
        let missing = wanted - product(&forces, &motion.coordinates);
        (forces.iter_mut().zip(&motion.coordinates)).for_each(|(force, part)| *force += missing * part);
    }
    forces
}

impl Shaft {
    /// A shaft cut at journals that stand at these growing places [m] and resist no tilt, loaded at others: it has no
    /// stiffness, and the two journals beside a load bear it.
    ///
    /// # Errors
    /// [`NoShaft::Free`]: there are fewer than two journals.
    pub fn cut(journals: &[f64], loaded: &[f64]) -> Result<Self, NoShaft> {
        if journals.len() < 2 {
            return Err(NoShaft::Free);
        }
        let rows: Vec<(usize, usize)> = (0..journals.len()).flat_map(|k| [(k, 0), (k, 1)]).collect();
        let transfer = |z: f64| {
            let shares = shares(journals, z);
            [0, 1].map(|towards| {
                let part = |&(journal, coordinate): &(usize, usize)| match coordinate == towards {
                    true => shares[journal],
                    false => 0.0,
                };
                rows.iter().map(part).collect()
            })
        };
        Ok(Self {
            stiffness: SquareMatrix::zeros(rows.len()),
            transfers: loaded.iter().map(|z| transfer(*z)).collect(),
            journals: journals.len(),
            rows,
            between: None,
        })
    }

    /// How many journals it has.
    pub fn journals(&self) -> usize {
        self.journals
    }

    /// Journal and coordinate of each unknown.
    pub fn rows(&self) -> &[(usize, usize)] {
        &self.rows
    }

    /// The forces [N] by which the shaft, turned by an angle [rad], resists these coordinates [m] of its journals.
    pub fn forces(&self, at: &[Vector], angle: f64) -> Vec<Vector> {
        let forces = self.stiffness.times(&self.gathered(&turned(at, -angle)));
        turned(&self.spread(&forces), angle)
    }

    /// The stiffness of the shaft [N/m] by the unknowns, turned by an angle [rad].
    pub fn stiffness(&self, angle: f64) -> SquareMatrix {
        let mut stiffness = SquareMatrix::zeros(self.rows.len());
        for (column, &(journal, coordinate)) in self.rows.iter().enumerate() {
            let mut unit = vec![[0.0; 4]; self.journals];
            unit[journal][coordinate] = 1.0;
            let forces = self.gathered(&self.forces(&unit, angle));
            (0..).zip(forces).for_each(|(row, force)| stiffness.add(row, column, force));
        }
        stiffness
    }

    /// Loads as forces [N] on the journals, the shaft turned by an angle [rad].
    pub fn loads(&self, loads: &[NodeForce], angle: f64) -> Vec<Vector> {
        let mut sum = vec![0.0; self.rows.len()];
        for NodeForce { place, force } in loads {
            for (force, transfer) in across(*force, -angle).iter().zip(&self.transfers[*place]) {
                (sum.iter_mut().zip(transfer)).for_each(|(sum, part)| *sum += force * part);
            }
        }
        turned(&self.spread(&sum), angle)
    }

    /// The entries of the unknowns.
    pub fn gathered(&self, vectors: &[Vector]) -> Vec<f64> {
        (self.rows.iter()).map(|&(journal, coordinate)| vectors[journal][coordinate]).collect()
    }

    /// The vectors of the journals, zero in coordinates that are not free.
    pub fn spread(&self, entries: &[f64]) -> Vec<Vector> {
        let mut vectors = vec![[0.0; 4]; self.journals];
        for (&(journal, coordinate), entry) in self.rows.iter().zip(entries) {
            vectors[journal][coordinate] = *entry;
        }
        vectors
    }
}

/// Vectors turned about the axis.
pub(super) fn turned(vectors: &[Vector], angle: f64) -> Vec<Vector> {
    let turn = |[x, y, z_x, z_y]: &Vector| {
        let ([x, y], [z_x, z_y]) = (across([*x, *y], angle), across([*z_x, *z_y], angle));
        [x, y, z_x, z_y]
    };
    vectors.iter().map(turn).collect()
}

/// A vector across the axis turned about it.
pub(super) fn across([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y]
}

#[cfg(test)]
mod tests;
