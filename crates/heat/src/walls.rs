//! Which temperatures are unknown, and how those of all points follow from them: `T = P x` with points at walls that
//! are sums of a few modes, or given. The system of the unknowns is `P^T A P`, so no heat is lost between film and
//! walls.

use crate::waves::Waves;
use crate::{BushSide, FilmNetwork, JournalSide};

/// Whether temperatures that are given count, or only changes of the unknowns.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum KnownValues {
    /// Temperatures are wanted.
    Counts,
    /// Changes are wanted.
    Zero,
}

/// Points at the bush.
enum BushRows {
    Own,
    Fixed(f64),
    Modes { conductances: Vec<f64>, waves: Waves, ambient: f64 },
}

/// Points at the journal.
enum JournalRows {
    Own,
    Fixed(f64),
    One { conductance: f64, ambient: f64 },
}

/// The unknowns: points of cell after cell that are free, feeds, modes of the bush, the journal.
pub(crate) struct Walls {
    points: usize,
    cells: usize,
    feeds: usize,
    bush: BushRows,
    journal: JournalRows,
}

impl Walls {
    pub(crate) fn new(network: &FilmNetwork, points: usize, reference: f64) -> Self {
        let bush = match &network.bush {
            BushSide::Adiabatic => BushRows::Own,
            BushSide::Fixed(temperature) => BushRows::Fixed(temperature - reference),
            BushSide::Ring(ring) => {
                let waves = Waves::new(ring, &network.cells);
                let ambient = ring.shape.ambient - reference;
                BushRows::Modes { conductances: ring.conductances.clone(), waves, ambient }
            }
        };
        let journal = match network.journal {
            JournalSide::Adiabatic => JournalRows::Own,
            JournalSide::Fixed(temperature) => JournalRows::Fixed(temperature - reference),
            JournalSide::Turning { conductance, ambient } => {
                JournalRows::One { conductance, ambient: if conductance > 0.0 { ambient - reference } else { 0.0 } }
            }
        };
        Self { points, cells: network.cells.len(), feeds: network.feeds.len(), bush, journal }
    }

    /// First free point of a cell.
    pub(crate) fn first(&self) -> usize {
        usize::from(!matches!(self.bush, BushRows::Own))
    }

    /// Number of free points of a cell.
    pub(crate) fn free(&self) -> usize {
        self.points - self.first() - usize::from(!matches!(self.journal, JournalRows::Own))
    }

    /// Place of the first feed among the unknowns.
    pub(crate) fn feeds_at(&self) -> usize {
        self.cells * self.free()
    }

    /// Place of the first mode among the unknowns.
    pub(crate) fn modes_at(&self) -> usize {
        self.feeds_at() + self.feeds
    }

    /// Place of the journal among the unknowns; the last, where it is one.
    pub(crate) fn journal_at(&self) -> usize {
        self.modes_at() + self.modes()
    }

    /// Number of unknowns.
    pub(crate) fn len(&self) -> usize {
        self.journal_at() + usize::from(self.has_journal())
    }

    /// Number of modes of the bush.
    pub(crate) fn modes(&self) -> usize {
        match &self.bush {
            BushRows::Modes { conductances, .. } => conductances.len(),
            _ => 0,
        }
    }

    pub(crate) fn has_journal(&self) -> bool {
        matches!(self.journal, JournalRows::One { .. })
    }

    /// Temperatures of all points and feeds for the unknowns.
    pub(crate) fn expand(&self, unknowns: &[f64], given: KnownValues, full: &mut [f64]) {
        let (n, first, free) = (self.points, self.first(), self.free());
        let scale = if given == KnownValues::Counts { 1.0 } else { 0.0 };
        for c in 0..self.cells {
            full[c * n + first..c * n + first + free].copy_from_slice(&unknowns[c * free..(c + 1) * free]);
        }
        for feed in 0..self.feeds {
            full[(self.cells + feed) * n..(self.cells + feed + 1) * n].fill(unknowns[self.feeds_at() + feed]);
        }
        match &self.bush {
            BushRows::Own => {}
            BushRows::Fixed(temperature) => (0..self.cells).for_each(|c| full[c * n] = scale * temperature),
            BushRows::Modes { waves, ambient, .. } => {
                let modes = &unknowns[self.modes_at()..self.journal_at()];
                waves.sum(modes, |c, value| full[c * n] = scale * ambient + value);
            }
        }
        let journal = match &self.journal {
            JournalRows::Own => return,
            JournalRows::Fixed(temperature) => scale * temperature,
            JournalRows::One { .. } => unknowns[self.journal_at()],
        };
        (0..self.cells).for_each(|c| full[c * n + n - 1] = journal);
    }

    /// Sums over the cells of `value` times each mode.
    pub(crate) fn project(&self, value: impl Fn(usize) -> f64, modes: &mut [f64]) {
        if let BushRows::Modes { waves, .. } = &self.bush {
            waves.project(value, modes);
        }
    }

    /// Sums over the cells of `value` times the square of each mode, and what the ring conducts [W/K].
    pub(crate) fn stiffness_of_modes(&self, value: impl Fn(usize) -> f64) -> Vec<f64> {
        let BushRows::Modes { conductances, waves, .. } = &self.bush else {
            return Vec::new();
        };
        conductances.iter().zip(waves.squares(value)).map(|(ring, film)| ring + film).collect()
    }

    /// Conductance along the shaft [W/K].
    pub(crate) fn shaft_conductance(&self) -> f64 {
        match self.journal {
            JournalRows::One { conductance, .. } => conductance,
            _ => 0.0,
        }
    }

    /// Heat [W] that the ring conducts away from each mode, and last the shaft from the journal.
    pub(crate) fn conduct(&self, unknowns: &[f64], known: KnownValues, conducted: &mut [f64]) {
        if let BushRows::Modes { conductances, .. } = &self.bush {
            let modes = conductances.iter().zip(&unknowns[self.modes_at()..]);
            conducted.iter_mut().zip(modes).for_each(|(leaves, (conductance, mode))| *leaves = conductance * mode);
        }
        if let JournalRows::One { conductance, ambient } = self.journal {
            let ambient = if known == KnownValues::Counts { ambient } else { 0.0 };
            conducted[self.modes()] = conductance * (unknowns[self.journal_at()] - ambient);
        }
    }
}
