//! A film with its temperatures, and what is read from them.

use oilwedge_heat::{BushSide, FilmNetwork, LayerProfile, LayerTemperatures, Layers, PowerSheet};
use oilwedge_reynolds::quantities::heat_network::EddySources;

/// A film with the temperatures that balance its heat.
#[derive(Debug, Clone)]
pub struct FilmHeat {
    /// Points across the film.
    pub layers: Layers,
    /// The film as it carries heat.
    pub network: FilmNetwork,
    /// Dof of each cell of the network.
    pub dofs: Vec<usize>,
    /// Profile of flow and friction of each cell.
    pub profiles: Vec<LayerProfile>,
    /// What makes the eddies of a turbulent film; none of a laminar one.
    pub eddies: Option<EddySources>,
    /// Temperatures at the points across the film of every dof [K], those of the oil fed where a feed covers the film.
    pub at_dofs: Vec<f64>,
    /// Number of each feed among the regions of the supply.
    pub feeds: Vec<usize>,
    /// Temperatures of film, walls and feeds.
    pub temperatures: LayerTemperatures,
    /// Where the heat goes.
    pub sheet: PowerSheet,
    /// Growth of the clearance by the expansion of the walls [m].
    pub growth: f64,
    /// Change of the temperatures in each round [K], as the mean of squares over the film.
    pub changes: Vec<f64>,
}

/// A temperature and its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HotSpot {
    /// Cell of the network.
    pub cell: usize,
    /// Temperature [K].
    pub temperature: f64,
    /// Angle on the bearing [rad].
    pub angle: f64,
    /// Place along the bearing over its length, from -1/2 to 1/2.
    pub along: f64,
}

impl FilmHeat {
    /// The hottest point of the film, walls included.
    pub fn hottest(&self) -> HotSpot {
        self.hottest_of(0..self.layers.points.len())
    }

    /// The hottest place of the bore; none of a bush that has no temperature of its own.
    pub fn hottest_of_bush(&self) -> Option<HotSpot> {
        matches!(self.network.bush, BushSide::Ring(_)).then(|| self.hottest_of(0..1))
    }

    /// The hottest of some points across all cells.
    fn hottest_of(&self, points: std::ops::Range<usize>) -> HotSpot {
        let spot = |(cell, at): (usize, &[f64])| HotSpot {
            cell,
            temperature: at[points.clone()].iter().copied().fold(f64::NEG_INFINITY, f64::max),
            angle: self.network.cells[cell].angle,
            along: self.network.cells[cell].along,
        };
        let spots = self.temperatures.layers.chunks_exact(self.layers.points.len()).enumerate().map(spot);
        let coldest = HotSpot { cell: 0, temperature: f64::NEG_INFINITY, angle: 0.0, along: 0.0 };
        spots.fold(coldest, |hottest, spot| if spot.temperature > hottest.temperature { spot } else { hottest })
    }

    /// Mean temperature of the bore [K]; none of a bush that has no temperature of its own.
    pub fn mean_of_bush(&self) -> Option<f64> {
        match &self.network.bush {
            BushSide::Ring(ring) => Some(ring.shape.ambient + self.temperatures.bush[0]),
            BushSide::Adiabatic | BushSide::Fixed(_) => None,
        }
    }

    /// Heat of the film [W], of shear and of the flow that pressure drives.
    pub fn heating(&self) -> f64 {
        self.network.cells.iter().map(|cell| cell.shear_power + cell.driven_power).sum()
    }

    /// Mean temperature of the oil in the film [K].
    pub fn mean(&self) -> f64 {
        let (mut volume, mut sum) = (0.0, 0.0);
        for (cell, at) in self.network.cells.iter().enumerate() {
            let part = at.wall_area * at.thickness * at.film_fraction;
            volume += part;
            sum += part * self.profiles[cell].mean(self.temperatures.of_cell(&self.layers, cell));
        }
        sum / volume
    }

    /// Temperature [K] of the feed that is the region of this number.
    pub fn of_feed(&self, region: usize) -> Option<f64> {
        let feed = self.feeds.iter().position(|&feed| feed == region)?;
        Some(self.temperatures.feeds[feed])
    }
}
