//! A mass-conserving film around a journal on a structured grid, for tests: finite volumes, and the relaxation of
//! Ausas, Jai and Buscaglia, J. Tribol. 131 (2009) 031702, with conductance and drag share of each cell.

use std::f64::consts::PI;

use oilwedge_heat::{
    BushRing, BushShape, BushSide, FeedSupply, FilmCell, FilmLink, FilmNetwork, FilmPort, JournalSide, LayerProfile,
    Layers, OilProperties, PortKind,
};

/// Rectangular feed around mid-length.
#[derive(Clone, Copy)]
pub(crate) struct Groove {
    /// Where it begins and ends [rad].
    pub(crate) angles: [f64; 2],
    /// Share of the length.
    pub(crate) length: f64,
    /// Pressure [Pa].
    pub(crate) pressure: f64,
}

/// A bearing at a fixed position.
#[derive(Clone)]
pub(crate) struct Bearing {
    pub(crate) radius: f64,
    pub(crate) length: f64,
    pub(crate) clearance: f64,
    pub(crate) speed: f64,
    pub(crate) eccentricity: f64,
    /// Angle of the least film [rad].
    pub(crate) least_at: f64,
    pub(crate) grooves: Vec<Groove>,
    pub(crate) supply: f64,
    pub(crate) oil: OilProperties,
    /// Viscosity at the temperature of the supply [Pa s].
    pub(crate) viscosity: f64,
    /// Fall of the viscosity for each kelvin [1/K].
    pub(crate) thinning: f64,
    pub(crate) bush: BushSide,
    pub(crate) journal: JournalSide,
}

/// Cells around and along.
pub(crate) type Grid = [usize; 2];

/// Bearing like that of Ferron, Frene and Boncompain, J. Lubr. Technol. 105 (1983) 422.
pub(crate) fn ferron(eccentricity: f64, least_at_degrees: f64) -> Bearing {
    let shape = BushShape {
        inner_radius: 0.05,
        outer_radius: 0.1,
        length: 0.08,
        conductivity: 250.0,
        transfer: 80.0,
        ambient: 313.15,
    };
    Bearing {
        radius: 0.05,
        length: 0.08,
        clearance: 145e-6,
        speed: 4000.0 * PI / 30.0,
        eccentricity,
        least_at: least_at_degrees.to_radians(),
        grooves: vec![Groove { angles: [81.0, 99.0].map(f64::to_radians), length: 0.875, pressure: 7e4 }],
        supply: 313.15,
        oil: OilProperties { capacity: 1.72e6, conductivity: 0.13 },
        viscosity: 0.0277,
        thinning: 0.034,
        bush: BushSide::Ring(BushRing::new(shape, BushRing::AROUND, BushRing::ALONG)),
        journal: JournalSide::Turning { conductance: 0.0, ambient: 313.15 },
    }
}

/// A main bearing of an engine.
pub(crate) fn engine() -> Bearing {
    let shape = BushShape {
        inner_radius: 0.025,
        outer_radius: 0.035,
        length: 0.02,
        conductivity: 45.0,
        transfer: 2000.0,
        ambient: 368.15,
    };
    Bearing {
        radius: 0.025,
        length: 0.02,
        clearance: 25e-6,
        eccentricity: 0.839_844_347_8,
        least_at: 299.349_56_f64.to_radians(),
        grooves: vec![Groove { angles: [20.0, 160.0].map(f64::to_radians), length: 0.15, pressure: 4e5 }],
        supply: 363.15,
        oil: OilProperties { capacity: 1_827_500.0, conductivity: 0.13 },
        viscosity: 0.01,
        thinning: 0.027,
        bush: BushSide::Ring(BushRing::new(shape, BushRing::AROUND, BushRing::ALONG)),
        ..ferron(0.0, 0.0)
    }
}

/// A bearing of a turbine with two axial grooves.
pub(crate) fn turbine() -> Bearing {
    let shape = BushShape {
        inner_radius: 0.125,
        outer_radius: 0.19,
        length: 0.2,
        conductivity: 45.0,
        transfer: 50.0,
        ambient: 313.15,
    };
    let groove = |from: f64| Groove { angles: [from, from + 20.0].map(f64::to_radians), length: 0.75, pressure: 1.5e5 };
    Bearing {
        radius: 0.125,
        length: 0.2,
        clearance: 150e-6,
        speed: 100.0 * PI,
        eccentricity: 0.550_458_91,
        least_at: 323.382_13_f64.to_radians(),
        grooves: vec![groove(350.0), groove(170.0)],
        supply: 318.15,
        viscosity: 0.0277 * (-0.034 * 5.0_f64).exp(),
        bush: BushSide::Ring(BushRing::new(shape, BushRing::AROUND, BushRing::ALONG)),
        ..ferron(0.0, 0.0)
    }
}

/// A bearing on a grid: pressures and film fractions of all places of the grid, feeds included.
pub(crate) struct JournalFilm {
    pub(crate) bearing: Bearing,
    pub(crate) grid: Grid,
    pub(crate) pressures: Vec<f64>,
    pub(crate) fractions: Vec<f64>,
    /// Index of each place among the cells; that of the feed, where there is one.
    pub(crate) cells: Vec<Result<usize, usize>>,
}

/// What lies beside a cell.
enum Beside {
    Place(usize),
    End,
}

impl JournalFilm {
    pub(crate) fn new(bearing: &Bearing, grid: Grid) -> Self {
        let [around, along] = grid;
        let mut count = 0;
        let mut cells = Vec::new();
        for i in 0..around {
            for j in 0..along {
                let (angle, z) = (2.0 * PI * (i as f64 + 0.5) / around as f64, (j as f64 + 0.5) / along as f64 - 0.5);
                let is_in = |groove: &Groove| {
                    let middle = 0.5 * (groove.angles[0] + groove.angles[1]);
                    let turn = (angle - middle) / (2.0 * PI);
                    let off = 2.0 * PI * (turn - turn.round()).abs();
                    off < 0.5 * (groove.angles[1] - groove.angles[0]) && z.abs() < 0.5 * groove.length
                };
                let feed = bearing.grooves.iter().position(is_in);
                cells.push(feed.map_or(Ok(count), Err));
                count += usize::from(feed.is_none());
            }
        }
        let pressures = cells.iter().map(|cell| cell.map_or_else(|feed| bearing.grooves[feed].pressure, |_| 0.0));
        let pressures = pressures.collect();
        Self { bearing: bearing.clone(), grid, pressures, fractions: vec![1.0; cells.len()], cells }
    }

    pub(crate) fn cell_count(&self) -> usize {
        self.cells.iter().flatten().count()
    }

    fn widths(&self) -> [f64; 2] {
        [2.0 * PI * self.bearing.radius / self.grid[0] as f64, self.bearing.length / self.grid[1] as f64]
    }

    /// Film thickness at an angle in cells.
    fn thickness(&self, place: f64) -> f64 {
        let angle = 2.0 * PI * place / self.grid[0] as f64;
        self.bearing.clearance * (1.0 - self.bearing.eccentricity * (angle - self.bearing.least_at).cos())
    }

    /// Neighbours of a place with the conductance of the face [m3/(s Pa)]: before, after, and both along.
    fn faces(&self, place: usize, f2: &[f64]) -> [(Beside, f64); 4] {
        let [around, along] = self.grid;
        let [width, depth] = self.widths();
        let (i, j) = (place / along, place % along);
        let between = |other: usize, thickness: f64, shape: f64| {
            let (mean, distance) = match self.cells[other] {
                Ok(_) => (0.5 * (f2[place] + f2[other]), 1.0),
                Err(_) => (f2[place], 0.5),
            };
            (Beside::Place(other), thickness.powi(3) * mean * shape / distance)
        };
        let end = (Beside::End, 2.0 * self.thickness(i as f64 + 0.5).powi(3) * f2[place] * width / depth);
        let own = self.thickness(i as f64 + 0.5);
        let before = between((i + around - 1) % around * along + j, self.thickness(i as f64), depth / width);
        let after = between((i + 1) % around * along + j, self.thickness((i + 1) as f64), depth / width);
        let below = if j == 0 { (Beside::End, end.1) } else { between(place - 1, own, width / depth) };
        let above = if j + 1 == along { end } else { between(place + 1, own, width / depth) };
        [before, after, below, above]
    }

    /// Dragged flow [m3/s] out of a full place through the face after it.
    fn drag(&self, place: usize, shares: &[f64]) -> f64 {
        let after = self.thickness((place / self.grid[1] + 1) as f64);
        self.bearing.speed * self.bearing.radius * after * shares[place] * self.widths()[1]
    }

    /// Pressures and film fractions that conserve oil for the profiles of the cells.
    pub(crate) fn solve(&mut self, profiles: &[LayerProfile]) {
        let places = self.cells.len();
        let of = |of: &dyn Fn(&LayerProfile) -> f64| -> Vec<f64> {
            let nearest = |place: usize| self.cells[place].map_or(0, |cell| cell);
            (0..places).map(|place| of(&profiles[nearest(place)])).collect()
        };
        let (f2, shares) = (of(&|profile| profile.f2), of(&LayerProfile::drag_share));
        let faces: Vec<_> = (0..places).map(|place| self.faces(place, &f2)).collect();
        let drags: Vec<f64> = (0..places).map(|place| self.drag(place, &shares)).collect();
        let [around, along] = self.grid;
        for _ in 0..20_000 {
            let mut change: f64 = 0.0;
            for place in (0..places).filter(|place| self.cells[*place].is_ok()) {
                let (mut sum, mut comes) = (0.0, 0.0);
                for (beside, conductance) in &faces[place] {
                    sum += conductance;
                    if let Beside::Place(other) = beside {
                        comes += conductance * self.pressures[*other];
                    }
                }
                let before = (place + around * along - along) % (around * along);
                comes += drags[before] * self.fractions[before];
                let (old, fraction) = (self.pressures[place], self.fractions[place]);
                let full = (comes - drags[place]) / sum;
                if full >= 0.0 {
                    // Over-relaxed where the film stays full.
                    let next = if old > 0.0 { (old + 1.7 * (full - old)).max(0.0) } else { full };
                    (self.pressures[place], self.fractions[place]) = (next, 1.0);
                } else {
                    (self.pressures[place], self.fractions[place]) = (0.0, comes / drags[place]);
                }
                change = change.max((full.max(0.0) - old).abs() * sum / drags[place]);
                change = change.max((self.fractions[place] - fraction).abs());
            }
            if change < 1e-13 {
                return;
            }
        }
    }

    /// The network of the film for the profiles of the cells.
    pub(crate) fn network(&self, profiles: &[LayerProfile]) -> FilmNetwork {
        let places = self.cells.len();
        let [around, along] = self.grid;
        let [width, depth] = self.widths();
        let nearest = |place: usize| &profiles[self.cells[place].map_or(0, |cell| cell)];
        let f2: Vec<f64> = (0..places).map(|place| nearest(place).f2).collect();
        let shares: Vec<f64> = (0..places).map(|place| nearest(place).drag_share()).collect();
        let speed = self.bearing.speed * self.bearing.radius;
        let (mut cells, mut links, mut ports) = (Vec::new(), Vec::new(), Vec::new());
        for place in 0..places {
            let Ok(cell) = self.cells[place] else {
                continue;
            };
            let (i, j) = (place / along, place % along);
            let (pressure, fraction) = (self.pressures[place], self.fractions[place]);
            let h = self.thickness(i as f64 + 0.5);
            let before = (place + places - along) % places;
            let mut driven_power = 0.0;
            for (face, (beside, conductance)) in self.faces(place, &f2).into_iter().enumerate() {
                let outer = match beside {
                    Beside::Place(other) => self.pressures[other],
                    Beside::End => 0.0,
                };
                let is_shared = matches!(beside, Beside::Place(other) if self.cells[other].is_ok());
                driven_power += conductance * (outer - pressure).powi(2) * if is_shared { 0.5 } else { 1.0 };
                let dragged = match face {
                    0 => self.drag(before, &shares) * self.fractions[before],
                    1 => -self.drag(place, &shares) * fraction,
                    _ => 0.0,
                };
                let driven = conductance * (outer - pressure);
                match beside {
                    Beside::End => ports.push(FilmPort {
                        cell,
                        kind: PortKind::Opening { temperature: self.bearing.supply },
                        dragged,
                        driven,
                    }),
                    Beside::Place(other) => match self.cells[other] {
                        Err(feed) => ports.push(FilmPort { cell, kind: PortKind::Feed(feed), dragged, driven }),
                        // Each pair once.
                        Ok(to) if face % 2 == 1 => {
                            links.push(FilmLink { from: cell, to, dragged: -dragged, driven: -driven });
                        }
                        Ok(_) => {}
                    },
                }
            }
            let after = (place + along) % places;
            let slope = (self.pressures[after] - self.pressures[before]) / (2.0 * width);
            cells.push(FilmCell {
                thickness: h,
                film_fraction: fraction,
                wall_area: width * depth,
                shear_power: speed * speed * fraction / (h * profiles[cell].f0) * width * depth,
                driven_power,
                cross_power: 2.0 * fraction * h * slope * speed * width * depth,
                angle: 2.0 * PI * (i as f64 + 0.5) / around as f64,
                along: (j as f64 + 0.5) / along as f64 - 0.5,
            });
        }
        FilmNetwork {
            oil: self.bearing.oil,
            cells,
            links,
            ports,
            feeds: self.bearing.grooves.iter().map(|_| FeedSupply { temperature: self.bearing.supply }).collect(),
            bush: self.bearing.bush.clone(),
            journal: self.bearing.journal,
        }
    }

    /// Profiles of the cells for their temperatures.
    pub(crate) fn profiles(&self, layers: &Layers, temperatures: &[f64]) -> Vec<LayerProfile> {
        let Bearing { viscosity, thinning, supply, .. } = self.bearing;
        let at = |t: &f64| viscosity * (-thinning * (t - supply)).exp();
        let cells = temperatures.chunks_exact(layers.points.len());
        cells.map(|cell| LayerProfile::of(layers, &cell.iter().map(at).collect::<Vec<f64>>())).collect()
    }
}
