//! # LayerTemperatures across the film, closed around it
//!
//! **Equation.** The temperatures T at the points across the film give its viscosities; the film of those viscosities,
//! in balance with its load, has flows and friction; these give temperatures G(T) ([`oilwedge_heat`], linear). What is
//! sought is `T = G(T)`, T at all points of the film, walls included.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | T, G(T) | K | `temperatures` |
//! | G(T) - T | K | `change` |
//!
//! **Method.** Anderson's mixing: the next T is the combination of the last few G(T) whose residuals, weighed by area,
//! combine to the least one. Without it the temperatures go round for ever: hot oil thins the film there, which then
//! carries its heat elsewhere. A point whose residual goes back and forth takes a part of it: where oil turns back beside a
//! feed, it is caught in a few cells, whose temperature answers to nothing else. The friction of a round falls as its oil
//! warms ([`oilwedge_heat::Thinning`]).
//!
//! **Source.** Anderson, J. ACM 12 (1965) 547; Walker, Ni, SIAM J. Numer. Anal. 49 (2011) 1715. **Range.** Steady films
//! that conserve oil. **Verified by** `tests/tests/thermal_film.rs`.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use oilwedge_fem::{Space, in_order};
use oilwedge_heat::{
    BushSide, FeedSupply, FilmCell, FilmNetwork, JournalSide, LayerProfile, LayerTemperatures, Layers, MOST_POINTS,
    NetworkFailure, NetworkOptions, OilProperties, PowerSheet, Thinning, solve as solve_network,
};
use oilwedge_reynolds::quantities::heat_network::{NodeNetwork, heat_network};
use oilwedge_reynolds::{AcrossFilm, SolvedFilm, ViscosityAcross};
use rayon::prelude::*;

/// Films whose temperatures are combined.
const DEPTH: usize = 4;
/// The temperatures are found where the next ones differ by no more than this [K] in the mean of squares over the film.
const CLOSED: f64 = 2e-4;
/// Temperatures of single points differ by no more than this then [K].
const CLOSED_ANYWHERE: f64 = 5e-3;
/// Most films.
const MOST_ROUNDS: usize = 60;
/// Residuals of a point that change their sign, and keep this part of their size, go back and forth.
const BACK_AND_FORTH: f64 = 0.5;
/// Part of its residual that a point which goes back and forth takes, over that of the step before.
const SHORTER: f64 = 0.5;
/// Growth of that part of a point which comes to rest.
const LONGER: f64 = 1.2;
/// Least part.
const SHORTEST: f64 = 0.05;
/// Singular values of the differences of residuals below this part of the greatest are rounding.
const ROUNDING: f64 = 1e-10;
/// Temperatures [K] whose difference shows how the viscosity falls.
const APART: f64 = 0.01;
/// Tolerance of the linear system of a round over the change of the round before [1/K].
const OF_CHANGE: f64 = 1e-5;
/// Tolerance of the linear system of the last round.
const SOLVED: f64 = 1e-10;
/// Tolerance of that of the first round.
const ROUGHLY_SOLVED: f64 = 1e-5;
/// The clearance is found where its growth differs by no more than this part of it.
const CLOSED_GROWTH: f64 = 1e-6;

/// What surrounds a film whose temperatures are found.
#[derive(Debug, Clone)]
pub struct HeatSurroundings {
    /// Heat capacity and conductivity of the oil.
    pub oil: OilProperties,
    /// Temperature of the oil that is fed [K].
    pub inlet: f64,
    /// The wall at rest.
    pub bush: BushSide,
    /// The wall that turns.
    pub journal: JournalSide,
    /// Change of the clearance with the temperatures of the walls; `None`: it does not change.
    pub expansion: Option<WallExpansion>,
}

/// Expansion of journal and bush by their mean temperatures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallExpansion {
    /// Coefficient of the journal [1/K].
    pub journal: f64,
    /// Coefficient of the bush [1/K].
    pub bush: f64,
    /// Temperature at which the clearance is known [K].
    pub at: f64,
}

/// The film that a round asks for.
#[derive(Debug, Clone)]
pub struct HeatRound {
    /// Its viscosity.
    pub across: Arc<ViscosityAcross>,
    /// What its clearance grows by [m].
    pub growth: f64,
    /// How far the temperatures were from balanced in the round before [K]; infinite in the first one.
    pub change: f64,
}

/// A film with its temperatures.
#[derive(Debug, Clone)]
pub struct FilmHeat {
    /// Points across the film.
    pub layers: Layers,
    /// The film as it carries heat.
    pub network: FilmNetwork,
    /// Dof of each cell of the network.
    pub dofs: Vec<usize>,
    /// Number of each feed among the regions of the supply.
    pub feeds: Vec<usize>,
    /// LayerTemperatures of film, walls and feeds.
    pub temperatures: LayerTemperatures,
    /// Where the heat goes.
    pub sheet: PowerSheet,
    /// What the clearance has grown by [m].
    pub growth: f64,
    /// How far the temperatures of each round were from balanced [K].
    pub changes: Vec<f64>,
}

/// Why the temperatures of a film were not found.
#[derive(Debug, Clone, PartialEq)]
pub enum NoHeat<E> {
    /// There is no film in one of the rounds.
    NoFilm(E),
    /// The system of the temperatures could not be solved.
    NotSolved(NetworkFailure),
    /// The film does not conserve oil.
    MakesOil,
    /// The control volumes do not fit in memory.
    TooLarge(oilwedge_fem::Error),
    /// Rounds do not come nearer.
    NotClosed {
        /// Change of the last round [K].
        change: f64,
        /// Films solved.
        rounds: usize,
    },
}

/// Finds the temperatures at the points of `layers` across a film, from one temperature `start` [K] for all of it. `solve`
/// gives the film of a round in balance with its load; `viscosity` is that of the oil at a temperature [K], in Pa s.
///
/// # Errors
/// [`NoHeat`]: the reason why none were found.
pub fn balance_heat<E>(
    surroundings: &HeatSurroundings,
    (space, layers): (&Space, &Layers),
    start: f64,
    viscosity: impl Fn(f64) -> f64 + Sync,
    mut solve: impl FnMut(&HeatRound) -> Result<SolvedFilm, E>,
) -> Result<FilmHeat, NoHeat<E>> {
    let points = layers.points.len();
    let mut temperatures = vec![start; space.dofs() * points];
    let mut mixing = Mixing::default();
    let (mut changes, mut last, mut growth): (Vec<f64>, Option<LayerTemperatures>, f64) = (Vec::new(), None, 0.0);
    loop {
        let profiles = profiles(layers, &temperatures, &viscosity);
        let across = Arc::new(ViscosityAcross::new(space, profiles.iter().map(across_film).collect()));
        let before = changes.last().copied().unwrap_or(f64::INFINITY);
        let film = solve(&HeatRound { across, growth, change: before }).map_err(NoHeat::NoFilm)?;
        let NodeNetwork { dofs, cells, links, ports, feeds } =
            heat_network(&film, surroundings.inlet).map_err(NoHeat::TooLarge)?.ok_or(NoHeat::MakesOil)?;
        let network = FilmNetwork {
            oil: surroundings.oil,
            cells,
            links,
            ports,
            feeds: vec![FeedSupply { temperature: surroundings.inlet }; feeds.len()],
            bush: surroundings.bush.clone(),
            journal: surroundings.journal,
        };
        let profiles: Vec<LayerProfile> = dofs.iter().map(|&dof| profiles[dof]).collect();
        let tolerance = (OF_CHANGE * before).clamp(SOLVED, ROUGHLY_SOLVED);
        let here: Vec<f64> = dofs.iter().flat_map(|dof| &temperatures[dof * points..][..points]).copied().collect();
        let rates: Vec<f64> = here.iter().map(|&t| -((viscosity(t + APART) / viscosity(t)).ln() / APART)).collect();
        let thinning = Some(Thinning { temperatures: &here, rates: &rates });
        let options = NetworkOptions { tolerance, thinning, ..NetworkOptions::default() };
        let solved = solve_network(&network, layers, &profiles, last.as_ref(), &options).map_err(NoHeat::NotSolved)?;
        let found = solved.temperatures;
        let [change, greatest] = differences(&network, &here, &found.layers);
        changes.push(change);
        let grown = surroundings.growth(&film, (layers, &network), &found);
        if change < CLOSED
            && greatest < CLOSED_ANYWHERE
            && (grown - growth).abs() < CLOSED_GROWTH * film.problem.bearing.clearance
        {
            let options = NetworkOptions { tolerance: SOLVED, ..NetworkOptions::default() };
            let solved =
                solve_network(&network, layers, &profiles, Some(&found), &options).map_err(NoHeat::NotSolved)?;
            let (found, sheet) = (solved.temperatures, solved.sheet);
            let layers = layers.clone();
            return Ok(FilmHeat { layers, network, dofs, feeds, temperatures: found, sheet, growth, changes });
        }
        if changes.len() >= MOST_ROUNDS || !change.is_finite() {
            return Err(NoHeat::NotClosed { change, rounds: changes.len() });
        }
        let next = mixing.next(here, &found.layers, |k| network.cells[k / points].wall_area);
        for (next, &dof) in next.chunks_exact(points).zip(&dofs) {
            temperatures[dof * points..][..points].copy_from_slice(next);
        }
        (growth, last) = (grown, Some(found));
    }
}

/// Root of the mean of squares over the film, and greatest one, of the differences of temperatures [K].
fn differences(network: &FilmNetwork, here: &[f64], next: &[f64]) -> [f64; 2] {
    let points = here.len() / network.cells.len();
    let (mut area, mut squares, mut greatest) = (0.0, 0.0, 0.0f64);
    for (c, cell) in network.cells.iter().enumerate() {
        area += cell.wall_area;
        for k in c * points..(c + 1) * points {
            let off = (next[k] - here[k]).abs();
            squares += cell.wall_area * off * off / points as f64;
            greatest = if off.is_nan() { f64::INFINITY } else { greatest.max(off) };
        }
    }
    [(squares / area).sqrt(), greatest]
}

/// Profiles of flow and heat at all dofs.
fn profiles(layers: &Layers, temperatures: &[f64], viscosity: &(impl Fn(f64) -> f64 + Sync)) -> Vec<LayerProfile> {
    let profile = |at: &[f64]| {
        let mut viscosities = [0.0; MOST_POINTS];
        viscosities.iter_mut().zip(at).for_each(|(mu, &temperature)| *mu = viscosity(temperature));
        LayerProfile::of(layers, &viscosities[..at.len()])
    };
    in_order(temperatures.par_chunks(layers.points.len()).map(profile))
}

/// What stands for the viscosity of a film with a profile.
fn across_film(profile: &LayerProfile) -> AcrossFilm {
    AcrossFilm { viscosity: 1.0 / (12.0 * profile.f2), shear_viscosity: 1.0 / profile.f0, drag: profile.drag_share() }
}

impl HeatSurroundings {
    /// What the clearance grows by [m] at these temperatures of the walls: that of the bush is the mean over its bore.
    fn growth(&self, film: &SolvedFilm, (layers, network): (&Layers, &FilmNetwork), found: &LayerTemperatures) -> f64 {
        let Some(WallExpansion { journal, bush, at }) = self.expansion else {
            return 0.0;
        };
        let points = layers.points.len();
        let area: f64 = network.cells.iter().map(|cell| cell.wall_area).sum();
        let mean = |point: usize| {
            let of = |(cell, t): (&FilmCell, &[f64])| cell.wall_area * t[point];
            network.cells.iter().zip(found.layers.chunks_exact(points)).map(of).sum::<f64>() / area
        };
        let of_bush = match &network.bush {
            BushSide::Ring(ring) => ring.shape.ambient + found.bush[0],
            BushSide::Adiabatic | BushSide::Fixed(_) => mean(0),
        };
        let of_journal = found.journal.unwrap_or_else(|| mean(points - 1));
        film.problem.bearing.radius * (bush * (of_bush - at) - journal * (of_journal - at))
    }
}

/// Anderson's mixing: iterates, and what they lead to.
#[derive(Debug, Default)]
struct Mixing {
    /// Pairs of an iterate and its residual, the last one last.
    kept: Vec<[Vec<f64>; 2]>,
    /// Part of the residual of each point that a step takes: less where that goes back and forth.
    parts: Vec<f64>,
}

impl Mixing {
    /// The next iterate, where the last one leads to `image`; residuals are weighed by `weight`.
    fn next(&mut self, here: Vec<f64>, image: &[f64], weight: impl Fn(usize) -> f64) -> Vec<f64> {
        let residual: Vec<f64> = image.iter().zip(&here).map(|(image, here)| image - here).collect();
        self.parts.resize(residual.len(), 1.0);
        if let Some([_, before]) = self.kept.last() {
            for ((part, before), now) in self.parts.iter_mut().zip(before).zip(&residual) {
                let goes_back = before * now < 0.0 && now.abs() > BACK_AND_FORTH * before.abs();
                *part = if goes_back { (SHORTER * *part).max(SHORTEST) } else { (LONGER * *part).min(1.0) };
            }
        }
        self.kept.push([here, residual]);
        if self.kept.len() > DEPTH + 1 {
            self.kept.remove(0);
        }
        let (last, before) = self.kept.split_last().expect("an iterate");
        let step = |k: usize, residual: f64| self.parts[k] * residual;
        let mut next: Vec<f64> = (0..image.len()).map(|k| last[0][k] + step(k, last[1][k])).collect();
        if before.is_empty() {
            return next;
        }
        let roots: Vec<f64> = (0..image.len()).map(|k| weight(k).sqrt()).collect();
        let differences = DMatrix::from_fn(image.len(), before.len(), |k, j| roots[k] * (last[1][k] - before[j][1][k]));
        let wanted = DVector::from_fn(image.len(), |k, _| roots[k] * last[1][k]);
        // The normal equations are small; rounding is cut off where directions are nearly the same.
        let normal = (differences.tr_mul(&differences)).svd(true, true);
        let cut = ROUNDING * normal.singular_values.iter().copied().fold(0.0, f64::max);
        let shares = normal.solve(&differences.tr_mul(&wanted), cut).unwrap_or_else(|_| DVector::zeros(before.len()));
        for (share, [x, r]) in shares.iter().zip(before) {
            for (k, next) in next.iter_mut().enumerate() {
                *next -= share * (last[0][k] - x[k] + step(k, last[1][k] - r[k]));
            }
        }
        next
    }
}
