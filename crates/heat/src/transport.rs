//! # Heat of the oil, layer by layer
//!
//! **Equation.** The temperature of a cell is the polynomial through its values at the points across the film. Each
//! layer has its own flow G_j = w_j h u_j to each neighbour, upwind; what a layer receives and does not pass on goes to
//! the next, with the velocity V across the film, by the skew-symmetric form with the Gauss points g:
//! ```text
//! rho c { sum of G_j T over what leaves, less what comes - D_j T_j/2
//!         + sum_g w_g V_g [psi_j(g) T'(g) - psi_j'(g) T(g)]/2 }
//!   + theta k A/h sum_g w_g psi_j'(g) T'(g) = Phi_j            sum_g w_g psi_j'(g) V_g = D_j, net outflow of layer j
//! ```
//! The last are N + 1 equations for N values, one redundant since the oil of a cell balances. So a constant
//! temperature is kept, and the rows sum to the heat that leaves, to rounding. Equations of walls stand in the rows of
//! the first and the last point: their residual is the heat that the wall gives.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | G_j rho c | W/K | `inflows` |
//! | Phi_j | W | `power` |
//! | theta k A/h | W/K | `conductance` |
//!
//! **Source.** Elrod and Brewer, NASA TM 102490 (1990), for Lobatto points across the film.
//! **Range.** Conduction along the film is left out, and the heat of compression.
//! **Verified by** `crates/heat/tests/slider.rs` and `crates/heat/tests/ring.rs`.

use crate::layers::MOST_POINTS;
use crate::profile::PerLayer;
use crate::{FilmNetwork, LayerProfile, Layers, PortKind, Thinning};

/// Flow of the layers of a cell into a feed.
struct Return {
    feed: usize,
    cell: usize,
    /// Flow rho c G_j of each layer [W/K].
    inflow: PerLayer,
}

/// The balances of heat of all points and feeds as a linear system; temperatures are counted from a reference.
/// Vectors hold the points of cell after cell, and then as many copies of the temperature of each feed.
pub(crate) struct Transport {
    /// Points across the film.
    pub(crate) points: usize,
    pub(crate) cells: usize,
    pub(crate) feeds: usize,
    /// One square block for each cell: what leaves it, flow across, conduction.
    pub(crate) blocks: Vec<f64>,
    /// Range of each cell in `sources`.
    starts: Vec<usize>,
    /// Cells and (past them) feeds from which oil comes.
    sources: Vec<usize>,
    /// Flow rho c G_j of each layer [W/K] from each source.
    inflows: Vec<f64>,
    /// Friction and the oil from openings, for each point [W].
    pub(crate) power: Vec<f64>,
    returns: Vec<Return>,
    /// Flow that leaves each feed, times rho c [W/K].
    pub(crate) feed_outflow: Vec<f64>,
    /// Heat of the oil supplied to each feed [W].
    pub(crate) supplied: Vec<f64>,
}

impl Transport {
    pub(crate) fn new(network: &FilmNetwork, layers: &Layers, profiles: &[LayerProfile], reference: f64) -> Self {
        let (points, cells, feeds) = (layers.points.len(), network.cells.len(), network.feeds.len());
        let capacity = network.oil.capacity;
        let mut outflow = vec![[0.0; MOST_POINTS]; cells];
        let mut net_outflow = vec![[0.0; MOST_POINTS]; cells];
        let mut power = vec![0.0; cells * points];
        for (c, (cell, profile)) in network.cells.iter().zip(profiles).enumerate() {
            for j in 0..points {
                power[c * points + j] = cell.shear_power * profile.shear_friction[j]
                    + cell.driven_power * profile.driven_friction[j]
                    + cell.cross_power * profile.cross_friction[j];
            }
        }
        // Source, target and flow of the layers, where any layer flows that way.
        let mut flows: Vec<(usize, usize, PerLayer)> = Vec::with_capacity(2 * network.links.len());
        for link in &network.links {
            let flow = profiles[link.from].flows(&profiles[link.to], link.dragged, link.driven);
            for (from, to, sign) in [(link.from, link.to, 1.0), (link.to, link.from, -1.0)] {
                let leaves = flow.map(|flow| (sign * flow).max(0.0));
                for j in 0..points {
                    outflow[from][j] += leaves[j];
                    net_outflow[from][j] += sign * flow[j];
                }
                if leaves.iter().any(|flow| *flow > 0.0) {
                    flows.push((from, to, leaves));
                }
            }
        }
        let (mut returns, mut feed_outflow) = (Vec::new(), vec![0.0; feeds]);
        let mut from_supply = vec![0.0; feeds];
        for port in &network.ports {
            let profile = &profiles[port.cell];
            let flow = profile.flows(profile, port.dragged, port.driven);
            let (comes, leaves) = (flow.map(|flow| flow.max(0.0)), flow.map(|flow| (-flow).max(0.0)));
            for j in 0..points {
                outflow[port.cell][j] += leaves[j];
                net_outflow[port.cell][j] -= flow[j];
            }
            match port.kind {
                PortKind::Opening { temperature } => {
                    for j in 0..points {
                        power[port.cell * points + j] += capacity * comes[j] * (temperature - reference);
                    }
                }
                PortKind::Feed(feed) => {
                    feed_outflow[feed] += capacity * comes.iter().sum::<f64>();
                    from_supply[feed] += capacity * flow.iter().sum::<f64>();
                    flows.push((cells + feed, port.cell, comes));
                    returns.push(Return { feed, cell: port.cell, inflow: leaves.map(|flow| capacity * flow) });
                }
            }
        }
        let mut supplied = vec![0.0; feeds];
        for (feed, supply) in network.feeds.iter().enumerate() {
            supplied[feed] = from_supply[feed].max(0.0) * (supply.temperature - reference);
            feed_outflow[feed] += (-from_supply[feed]).max(0.0);
        }
        let mut starts = vec![0; cells + 1];
        for (_, to, _) in &flows {
            starts[to + 1] += 1;
        }
        for c in 0..cells {
            starts[c + 1] += starts[c];
        }
        let mut next = starts.clone();
        let mut sources = vec![0; flows.len()];
        let mut inflows = vec![0.0; flows.len() * points];
        for (from, to, flow) in &flows {
            let place = next[*to];
            next[*to] += 1;
            sources[place] = *from;
            for j in 0..points {
                inflows[place * points + j] = capacity * flow[j];
            }
        }
        let mut blocks = vec![0.0; cells * points * points];
        for (c, block) in blocks.chunks_exact_mut(points * points).enumerate() {
            let cell = &network.cells[c];
            let resistance = profiles[c].resistance * cell.thickness;
            let conductance = cell.film_fraction * network.oil.conductivity * cell.wall_area / resistance;
            fill(block, layers, conductance, &net_outflow[c].map(|flow| capacity * flow));
            for j in 0..points {
                block[j * points + j] += capacity * outflow[c][j];
            }
        }
        Self { points, cells, feeds, blocks, starts, sources, inflows, power, returns, feed_outflow, supplied }
    }

    /// Has the friction of shear fall as the oil warms.
    pub(crate) fn thin(
        &mut self,
        network: &FilmNetwork,
        profiles: &[LayerProfile],
        thinning: &Thinning<'_>,
        reference: f64,
    ) {
        let n = self.points;
        for (c, (cell, profile)) in network.cells.iter().zip(profiles).enumerate() {
            for j in 0..n {
                let fall = cell.shear_power * profile.shear_friction[j] * thinning.rates[c * n + j];
                self.blocks[c * n * n + j * n + j] += fall;
                self.power[c * n + j] += fall * (thinning.temperatures[c * n + j] - reference);
            }
        }
    }

    /// Length of a vector with all points and feeds.
    pub(crate) fn len(&self) -> usize {
        (self.cells + self.feeds) * self.points
    }

    /// Cells and feeds from which oil comes to a cell, with rho c G_j of each layer.
    #[inline]
    pub(crate) fn inflows(&self, cell: usize) -> impl Iterator<Item = (usize, &[f64])> {
        let range = self.starts[cell]..self.starts[cell + 1];
        let flows = self.inflows[range.start * self.points..range.end * self.points].chunks_exact(self.points);
        self.sources[range].iter().copied().zip(flows)
    }

    /// Heat [W] that goes into the bush and into the journal: what the points at the walls have, without what `leaves`
    /// them with the oil.
    pub(crate) fn lacking_at_walls(&self, leaves: &[f64]) -> [f64; 2] {
        let lacking = |point: usize| self.power[point] - leaves[point];
        [0, self.points - 1].map(|point| (0..self.cells).map(|c| lacking(c * self.points + point)).sum())
    }

    /// Heat that leaves each point and each feed [W] at `temperatures`.
    pub(crate) fn apply(&self, temperatures: &[f64], out: &mut [f64]) {
        let n = self.points;
        for c in 0..self.cells {
            let own = &temperatures[c * n..(c + 1) * n];
            let block = &self.blocks[c * n * n..(c + 1) * n * n];
            let leaves = &mut out[c * n..(c + 1) * n];
            for (row, leaves) in block.chunks_exact(n).zip(leaves.iter_mut()) {
                *leaves = row.iter().zip(own).map(|(a, b)| a * b).sum();
            }
            for (source, flow) in self.inflows(c) {
                let above = &temperatures[source * n..(source + 1) * n];
                for j in 0..n {
                    leaves[j] -= flow[j] * above[j];
                }
            }
        }
        for feed in 0..self.feeds {
            out[(self.cells + feed) * n] = self.feed_outflow[feed] * temperatures[(self.cells + feed) * n];
        }
        for Return { feed, cell, inflow } in &self.returns {
            let own = &temperatures[cell * n..(cell + 1) * n];
            out[(self.cells + feed) * n] -= own.iter().zip(inflow).map(|(t, flow)| t * flow).sum::<f64>();
        }
    }
}

/// Flow across the film and conduction in one cell, for the net outflow rho c D_j of its layers.
fn fill(block: &mut [f64], layers: &Layers, conductance: f64, outflow: &PerLayer) {
    let (n, count) = (layers.points.len(), layers.count());
    for (row, conduction) in block.chunks_exact_mut(n).zip(&layers.conduction) {
        for l in 0..n {
            row[l] = conductance * conduction[l];
        }
    }
    for g in 0..count {
        let across: f64 = layers.crossing[g].iter().zip(outflow).map(|(row, flow)| row * flow).sum();
        let across = layers.gauss_weights[g] * across;
        let (values, slopes) = (&layers.values[g], &layers.slopes[g]);
        for (j, row) in block.chunks_exact_mut(n).enumerate() {
            for l in 0..n {
                row[l] += 0.5 * across * (values[j] * slopes[l] - slopes[j] * values[l]);
            }
        }
    }
    for (j, row) in block.chunks_exact_mut(n).enumerate() {
        row[j] -= 0.5 * outflow[j];
    }
}
