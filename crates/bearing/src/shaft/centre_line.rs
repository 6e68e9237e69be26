//! # The bent centre line of a shaft
//!
//! **Equation.** With the motions q_r of the journals and the forces f_i on all other nodes,
//! ```text
//! q_i = K_ii^-1 (f_i - K_ir q_r)
//! ```
//! and between its nodes each beam bends as its ends make it (`shaft/beam.rs`), for loads act on nodes. A pin lies
//! beside the axis: its sections are shown by the points of the axis that would move with them, so that the twist of
//! the shaft, which carries a pin round, is not taken for bending.
//!
//! **Source.** Elimination of inner nodes: R. J. Guyan, AIAA J. 3 (1965) 380. **Range.** As for the frame.
//! **Verified by** `frame/tests.rs` and `tests/tests/shaft/deflection.rs`.

use super::beam::{NodeMotion, carried};
use super::frame::{BetweenJournals, Eliminated, NodeForce, OF_NODE, Shaft, across, turned};
use super::matrix::product;
use crate::coordinates::Vector;

/// Each beam along the axis is shown by so many chords.
const PARTS: u32 = 12;

/// A point of the centre line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinePoint {
    /// Axial position [m].
    pub z: f64,
    /// Displacement towards x and y [m].
    pub by: [f64; 2],
}

impl Shaft {
    /// The centre line of the shaft where its journals are displaced so [m] under these loads, turned by an angle
    /// [rad]; `None` where the shaft is cut.
    pub fn bent(&self, journals: &[Vector], loads: &[NodeForce], angle: f64) -> Option<Vec<LinePoint>> {
        self.between.as_ref().map(|between| between.bent(journals, loads, angle))
    }
}

impl BetweenJournals {
    /// The line from beam to beam.
    fn bent(&self, journals: &[Vector], loads: &[NodeForce], angle: f64) -> Vec<LinePoint> {
        let motions = self.motions(&turned(journals, -angle), loads, angle);
        let nodes = &self.frame.nodes;
        let mut line = Vec::new();
        for (number, beam) in self.frame.beams.iter().enumerate() {
            let parts = if beam.ends[0][2] < beam.ends[1][2] { PARTS } else { 1 };
            // The next beam begins where this one ends.
            let chords = if number + 1 == self.frame.beams.len() { parts + 1 } else { parts };
            for k in 0..chords {
                let part = f64::from(k) / f64::from(parts);
                let (at, motion) =
                    beam.section_at(part, beam.nodes.map(|node| nodes[node]), beam.nodes.map(|node| motions[node]));
                let [x, y, ..] = carried(motion, [-at[0], -at[1], 0.0]);
                line.push(LinePoint { z: at[2], by: across([x, y], angle) });
            }
        }
        line
    }

    /// The motions of all nodes in the axes of the shaft, by those of its journals in the same axes.
    fn motions(&self, journals: &[Vector], loads: &[NodeForce], angle: f64) -> Vec<NodeMotion> {
        let Eliminated { stiffness, retained, others, inner } = &self.eliminated;
        let mut all = vec![0.0; stiffness.order()];
        for load in loads {
            let first = OF_NODE * self.loaded[load.place];
            (all[first..].iter_mut().zip(across(load.force, -angle))).for_each(|(sum, force)| *sum += force);
        }
        let moved: Vec<f64> = retained.iter().map(|row| row.factor * journals[row.journal][row.coordinate]).collect();
        let numbers: Vec<usize> = retained.iter().map(|row| row.number).collect();
        let left = (others.iter().zip(stiffness.part(others, &numbers)))
            .map(|(&other, coupled)| all[other] - product(&coupled, &moved))
            .collect::<Vec<_>>();
        all.fill(0.0);
        (numbers.into_iter().zip(moved)).for_each(|(number, motion)| all[number] = motion);
        (others.iter().zip(inner.solve(&left))).for_each(|(&other, motion)| all[other] = motion);
        all.chunks_exact(OF_NODE).map(|of_node| std::array::from_fn(|k| of_node[k])).collect()
    }
}
