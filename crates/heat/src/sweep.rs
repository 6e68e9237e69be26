//! An approximate inverse of the system of heat: one sweep in the order of the flow, then the walls.
//!
//! A cell takes heat from cells upstream, most of which are solved before it: with walls at rest a sweep is exact, but
//! for layers that flow back and for what goes round a cut ring. Walls follow from what the sweep leaves in their rows.
//! Each mode of the bush and the journal are solved by themselves, with the conductance of the film at rest upstream.

use crate::FilmNetwork;
use crate::layers::MOST_POINTS;
use crate::order::in_flow_order;
use crate::small_matrix::invert;
use crate::transport::Transport;
use crate::walls::Walls;

pub(crate) struct FlowSweep<'a> {
    transport: &'a Transport,
    walls: &'a Walls,
    order: Vec<usize>,
    /// Inverse of the block of the free points of each cell.
    inverses: Vec<f64>,
    /// Film and ring for each mode [W/K].
    modes: Vec<f64>,
    /// Film and shaft for the journal [W/K].
    journal: f64,
    /// Changes of all points and feeds.
    changes: Vec<f64>,
    /// Residual of the bush side of each cell with them [W].
    at_bush: Vec<f64>,
}

impl<'a> FlowSweep<'a> {
    /// The sweep of a system; a cell without oil, if there is one.
    pub(crate) fn new(network: &FilmNetwork, transport: &'a Transport, walls: &'a Walls) -> Result<Self, usize> {
        let (n, first, free) = (transport.points, walls.first(), walls.free());
        let mut inverses = vec![0.0; transport.cells * free * free];
        let (mut of_bush, mut journal) = (vec![0.0; transport.cells], walls.shaft_conductance());
        for (c, inverse) in inverses.chunks_exact_mut(free * free).enumerate() {
            let block = &transport.blocks[c * n * n..(c + 1) * n * n];
            for i in 0..free {
                for k in 0..free {
                    inverse[i * free + k] = block[(i + first) * n + k + first];
                }
            }
            if !invert(inverse, free) {
                return Err(c);
            }
            let at_rest = |wall: usize| {
                let mut own = block[wall * n + wall];
                for i in 0..free {
                    let follows: f64 = (0..free).map(|k| inverse[i * free + k] * block[(k + first) * n + wall]).sum();
                    own -= block[wall * n + i + first] * follows;
                }
                own
            };
            if first == 1 {
                of_bush[c] = at_rest(0);
            }
            if walls.has_journal() {
                let beside = transport.inflows(c).filter(|(source, _)| *source < transport.cells);
                journal += at_rest(n - 1) - beside.map(|(_, flow)| flow[n - 1]).sum::<f64>();
            }
        }
        let modes = walls.stiffness_of_modes(|c| of_bush[c]);
        let changes = vec![0.0; transport.len()];
        let at_bush = vec![0.0; transport.cells];
        let order = in_flow_order(network);
        Ok(Self { transport, walls, order, inverses, modes, journal, changes, at_bush })
    }

    /// Changes of the unknowns that remove the residuals [W], nearly: those of all points and feeds in `rows`, and of
    /// what ring and shaft conduct in `conducted`.
    pub(crate) fn apply(&mut self, rows: &[f64], conducted: &[f64], unknowns: &mut [f64]) {
        let (transport, walls) = (self.transport, self.walls);
        let (n, first, free) = (transport.points, walls.first(), walls.free());
        let has_journal = walls.has_journal();
        for feed in 0..transport.feeds {
            let change = rows[(transport.cells + feed) * n] / transport.feed_outflow[feed];
            unknowns[walls.feeds_at() + feed] = change;
            self.changes[(transport.cells + feed) * n..(transport.cells + feed + 1) * n].fill(change);
        }
        // What is not solved yet is at rest, and walls are.
        self.changes[..transport.cells * n].fill(0.0);
        let mut at_journal = 0.0;
        for &c in &self.order {
            let mut comes = [0.0; MOST_POINTS];
            comes[first..first + free].copy_from_slice(&rows[c * n + first..c * n + first + free]);
            for (source, flow) in transport.inflows(c) {
                let above = &self.changes[source * n..(source + 1) * n];
                for j in 0..n {
                    comes[j] += flow[j] * above[j];
                }
            }
            let inverse = &self.inverses[c * free * free..(c + 1) * free * free];
            let own = &mut self.changes[c * n..(c + 1) * n];
            for (i, row) in inverse.chunks_exact(free).enumerate() {
                own[first + i] = row.iter().zip(&comes[first..]).map(|(a, b)| a * b).sum();
            }
            unknowns[c * free..(c + 1) * free].copy_from_slice(&own[first..first + free]);
            let block = &transport.blocks[c * n * n..(c + 1) * n * n];
            let leaves = |row: usize| -> f64 {
                let row = &block[row * n..(row + 1) * n];
                row.iter().zip(own.iter()).map(|(a, b)| a * b).sum()
            };
            self.at_bush[c] = rows[c * n] - leaves(0);
            if has_journal {
                at_journal += rows[(c + 1) * n - 1] + comes[n - 1] - leaves(n - 1);
            }
        }
        if walls.modes() > 0 {
            let modes = walls.modes_at()..walls.journal_at();
            let own = &mut unknowns[modes];
            walls.project(|c| self.at_bush[c], own);
            for ((mode, conducted), stiffness) in own.iter_mut().zip(conducted).zip(&self.modes) {
                *mode = (*mode + conducted) / stiffness;
            }
        }
        if has_journal {
            unknowns[walls.journal_at()] = (conducted[walls.modes()] + at_journal) / self.journal;
        }
    }
}
