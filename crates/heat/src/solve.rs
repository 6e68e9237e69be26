//! The temperatures that balance the heat of a network: one linear system, by GMRES with sweeps in the order of the
//! flow.

use crate::gmres::{gmres, norm};
use crate::power_sheet::PowerSheet;
use crate::sweep::FlowSweep;
use crate::transport::Transport;
use crate::walls::{KnownValues, Walls};
use crate::{FilmNetwork, JournalSide, LayerProfile, LayerTemperatures, Layers};

/// How far the linear system is solved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NetworkOptions<'a> {
    /// Tolerance of the residual as changes of temperatures, relative to that of one temperature everywhere.
    pub tolerance: f64,
    /// Most steps of GMRES between restarts.
    pub vectors: usize,
    /// Most steps of GMRES.
    pub most_steps: usize,
    /// How friction falls where the temperatures differ from those of the profiles; `None`: it does not.
    pub thinning: Option<Thinning<'a>>,
}

impl Default for NetworkOptions<'_> {
    fn default() -> Self {
        Self { tolerance: 1e-9, vectors: 100, most_steps: 400, thinning: None }
    }
}

/// How the shear of each point falls as the oil warms: `Phi_j (1 - b_j (T_j - T'_j))`, to first order. Rounds in which
/// profiles and temperatures follow one another come to rest with it; at rest it changes nothing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thinning<'a> {
    /// Temperatures T' of the profiles at the points of cell after cell [K].
    pub temperatures: &'a [f64],
    /// Relative fall b of the viscosity at each of them [1/K].
    pub rates: &'a [f64],
}

/// Temperatures, and how they were found.
#[derive(Debug, Clone, PartialEq)]
pub struct SolvedNetwork {
    /// The temperatures.
    pub temperatures: LayerTemperatures,
    /// Where the heat goes.
    pub sheet: PowerSheet,
    /// Steps of GMRES.
    pub steps: usize,
    /// Residual, as [`NetworkOptions::tolerance`] counts it.
    pub residual: f64,
}

/// Why there are no temperatures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum NetworkFailure {
    /// Nothing carries or conducts heat from a cell.
    DryCell(usize),
    /// No oil flows through a feed.
    DryFeed(usize),
    /// The tolerance was not met.
    Steps {
        /// Steps of GMRES.
        steps: usize,
        /// Residual, as [`NetworkOptions::tolerance`] counts it.
        residual: f64,
    },
}

/// The temperatures of `network`, whose cells have the `profiles`; GMRES begins at those of `start`.
pub fn solve(
    network: &FilmNetwork,
    layers: &Layers,
    profiles: &[LayerProfile],
    start: Option<&LayerTemperatures>,
    options: &NetworkOptions<'_>,
) -> Result<SolvedNetwork, NetworkFailure> {
    let reference = network.reference();
    let mut transport = Transport::new(network, layers, profiles, reference);
    if let Some(thinning) = &options.thinning {
        transport.thin(network, profiles, thinning, reference);
    }
    if let Some(feed) = transport.feed_outflow.iter().position(|flow| *flow <= 0.0) {
        return Err(NetworkFailure::DryFeed(feed));
    }
    let walls = Walls::new(network, layers.points.len(), reference);
    let sweep = FlowSweep::new(network, &transport, &walls).map_err(NetworkFailure::DryCell)?;
    let mut system = System {
        transport: &transport,
        walls: &walls,
        sweep,
        full: vec![0.0; transport.len()],
        leaves: vec![0.0; transport.len()],
        conducted: vec![0.0; walls.len() - walls.modes_at()],
    };
    let (mut unknowns, mut changes) = (vec![0.0; walls.len()], vec![0.0; walls.len()]);
    let scale = system.residual(&unknowns, &mut changes);
    let mut left = scale;
    if let Some(start) = start {
        unknowns_of(&walls, layers.points.len(), start, reference, &mut unknowns);
        left = system.residual(&unknowns, &mut changes);
        // A start that is worse than one temperature everywhere is none.
        if left > scale {
            unknowns.fill(0.0);
            left = system.residual(&unknowns, &mut changes);
        }
    }
    let mut steps = 0;
    while left > options.tolerance * scale && steps < options.most_steps {
        let most = options.vectors.min(options.most_steps - steps);
        let operator = |direction: &[f64], image: &mut [f64]| system.image(direction, image);
        steps += gmres(operator, &changes, options.tolerance * scale, most, &mut unknowns);
        left = system.residual(&unknowns, &mut changes);
    }
    let relative = if left > 0.0 { left / scale } else { left };
    if left <= options.tolerance * scale {
        let to_walls = system.lacking_at_walls(&unknowns);
        let temperatures = temperatures_of(&walls, network, &unknowns, &system.full, reference);
        let sheet = PowerSheet::new(network, layers, profiles, &temperatures, to_walls);
        Ok(SolvedNetwork { temperatures, sheet, steps, residual: relative })
    } else {
        Err(NetworkFailure::Steps { steps, residual: relative })
    }
}

/// The balances of all unknowns with their approximate inverse, and room for vectors.
struct System<'a> {
    transport: &'a Transport,
    walls: &'a Walls,
    sweep: FlowSweep<'a>,
    /// Temperatures of all points and feeds.
    full: Vec<f64>,
    /// Heat that leaves each of them.
    leaves: Vec<f64>,
    /// Heat that ring and shaft conduct.
    conducted: Vec<f64>,
}

impl System<'_> {
    /// The preconditioned residual of `unknowns`, and its norm.
    fn residual(&mut self, unknowns: &[f64], changes: &mut [f64]) -> f64 {
        let transport = self.transport;
        self.walls.expand(unknowns, KnownValues::Counts, &mut self.full);
        transport.apply(&self.full, &mut self.leaves);
        self.leaves.iter_mut().zip(&transport.power).for_each(|(leaves, power)| *leaves -= power);
        for (feed, supplied) in transport.supplied.iter().enumerate() {
            self.leaves[(transport.cells + feed) * transport.points] -= supplied;
        }
        self.walls.conduct(unknowns, KnownValues::Counts, &mut self.conducted);
        self.leaves.iter_mut().chain(&mut self.conducted).for_each(|row| *row = -*row);
        self.sweep.apply(&self.leaves, &self.conducted, changes);
        norm(changes)
    }

    /// The preconditioned system times a vector.
    fn image(&mut self, direction: &[f64], image: &mut [f64]) {
        self.walls.expand(direction, KnownValues::Zero, &mut self.full);
        self.transport.apply(&self.full, &mut self.leaves);
        self.walls.conduct(direction, KnownValues::Zero, &mut self.conducted);
        self.sweep.apply(&self.leaves, &self.conducted, image);
    }

    /// Heat into bush and journal for `unknowns`, whose temperatures are then in `full`.
    fn lacking_at_walls(&mut self, unknowns: &[f64]) -> [f64; 2] {
        self.walls.expand(unknowns, KnownValues::Counts, &mut self.full);
        self.transport.apply(&self.full, &mut self.leaves);
        self.transport.lacking_at_walls(&self.leaves)
    }
}

/// The unknowns, counted from the reference, at given temperatures.
fn unknowns_of(walls: &Walls, points: usize, start: &LayerTemperatures, reference: f64, unknowns: &mut [f64]) {
    let (first, free) = (walls.first(), walls.free());
    let (cells, borders) = unknowns.split_at_mut(walls.feeds_at());
    for (own, start) in cells.chunks_exact_mut(free).zip(start.layers.chunks_exact(points)) {
        own.iter_mut().zip(&start[first..]).for_each(|(own, start)| *own = start - reference);
    }
    let feeds = walls.modes_at() - walls.feeds_at();
    borders[..feeds].iter_mut().zip(&start.feeds).for_each(|(own, start)| *own = start - reference);
    borders[feeds..feeds + walls.modes()].iter_mut().zip(&start.bush).for_each(|(own, start)| *own = *start);
    if let (true, Some(journal)) = (walls.has_journal(), start.journal) {
        borders[feeds + walls.modes()] = journal - reference;
    }
}

fn temperatures_of(
    walls: &Walls,
    network: &FilmNetwork,
    unknowns: &[f64],
    full: &[f64],
    reference: f64,
) -> LayerTemperatures {
    let points = full.len() / (network.cells.len() + network.feeds.len());
    LayerTemperatures {
        layers: full[..network.cells.len() * points].iter().map(|t| t + reference).collect(),
        journal: match network.journal {
            JournalSide::Adiabatic => None,
            JournalSide::Fixed(temperature) => Some(temperature),
            JournalSide::Turning { .. } => Some(unknowns[walls.journal_at()] + reference),
        },
        bush: unknowns[walls.modes_at()..walls.journal_at()].to_vec(),
        feeds: unknowns[walls.feeds_at()..walls.modes_at()].iter().map(|t| t + reference).collect(),
    }
}
