//! What is given: a film as cells, the oil that flows between them, their friction, and what surrounds them.

use crate::BushRing;

/// Oil as a carrier of heat.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OilProperties {
    /// Heat capacity of a volume rho c [J/(m3 K)].
    pub capacity: f64,
    /// Conductivity k [W/(m K)].
    pub conductivity: f64,
}

/// The film around one node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmCell {
    /// Film thickness h [m].
    pub thickness: f64,
    /// Film fraction theta: streaks fill this share of the gap.
    pub film_fraction: f64,
    /// Area of film through which heat goes to the walls [m2].
    pub wall_area: f64,
    /// Heat of the dragged flow Int theta U^2/(h F0) dA [W].
    pub shear_power: f64,
    /// Heat of the driven flow Int h^3 F2 |grad p|^2 dA [W].
    pub driven_power: f64,
    /// Factor Int 2 h p_x U dA [W] of the heat that the two flows together move between layers; it adds none.
    pub cross_power: f64,
    /// Angle of the node [rad].
    pub angle: f64,
    /// Place of the node along the bearing z/L, -1/2 to 1/2.
    pub along: f64,
}

/// Flow of oil between two cells, without regard to the layers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmLink {
    /// Cell that oil leaves where the flows are positive.
    pub from: usize,
    /// Cell that it comes to.
    pub to: usize,
    /// Flow that the journal drags along [m3/s], film fraction included.
    pub dragged: f64,
    /// Flow that pressure drives [m3/s].
    pub driven: f64,
}

/// What lies behind a part of the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PortKind {
    /// The feed of an index: oil in it is mixed.
    Feed(usize),
    /// Open surroundings, from which oil comes with a temperature [K].
    Opening {
        /// Temperature of oil that comes in [K].
        temperature: f64,
    },
}

/// Flow of oil into a cell through its part of the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FilmPort {
    /// Cell at the boundary.
    pub cell: usize,
    /// What lies behind.
    pub kind: PortKind,
    /// Flow into the cell that the journal drags along [m3/s].
    pub dragged: f64,
    /// Flow into the cell that pressure drives [m3/s].
    pub driven: f64,
}

/// A feed in which oil is mixed: the oil that the film brings back, and what it lacks from the supply.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FeedSupply {
    /// Temperature of the oil supplied [K].
    pub temperature: f64,
}

/// The wall at eta = 0.
#[derive(Debug, Clone, PartialEq)]
pub enum BushSide {
    /// No heat goes through it.
    Adiabatic,
    /// The wall has one temperature [K].
    Fixed(f64),
    /// A ring that conducts heat.
    Ring(BushRing),
}

/// The wall at eta = 1, which moves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JournalSide {
    /// No heat goes through it, at any place.
    Adiabatic,
    /// The wall has one temperature [K].
    Fixed(f64),
    /// The journal turns so fast that it has one temperature. At this temperature it gives to the film as much heat as
    /// it takes, but for what leaves along the shaft.
    Turning {
        /// Conductance along the shaft [W/K]; zero where no heat leaves by it.
        conductance: f64,
        /// Temperature at the end of the shaft [K].
        ambient: f64,
    },
}

/// A film as a network of cells. The flows of each cell sum to zero, ports included, to rounding.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmNetwork {
    /// The oil.
    pub oil: OilProperties,
    /// The cells.
    pub cells: Vec<FilmCell>,
    /// Flows between them.
    pub links: Vec<FilmLink>,
    /// Flows through the boundary.
    pub ports: Vec<FilmPort>,
    /// The feeds.
    pub feeds: Vec<FeedSupply>,
    /// The wall at rest.
    pub bush: BushSide,
    /// The wall that moves.
    pub journal: JournalSide,
}

impl FilmNetwork {
    /// A temperature [K] that is given, from which others are counted: that of a feed, an opening or a wall.
    pub(crate) fn reference(&self) -> f64 {
        let openings = self.ports.iter().filter_map(|port| match port.kind {
            PortKind::Opening { temperature } => Some(temperature),
            PortKind::Feed(_) => None,
        });
        let bush = match &self.bush {
            BushSide::Adiabatic => None,
            BushSide::Fixed(temperature) => Some(*temperature),
            BushSide::Ring(ring) => Some(ring.shape.ambient),
        };
        let journal = match self.journal {
            JournalSide::Adiabatic => None,
            JournalSide::Fixed(temperature) => Some(temperature),
            JournalSide::Turning { conductance, ambient } => (conductance > 0.0).then_some(ambient),
        };
        let feeds = self.feeds.iter().map(|feed| feed.temperature);
        feeds.chain(openings).chain(bush).chain(journal).next().unwrap_or(0.0)
    }
}
