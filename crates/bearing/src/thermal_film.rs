//! # Temperatures across the film, closed around it
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
//! carries its heat elsewhere. A point whose residual goes back and forth takes a part of it: where oil turns back
//! beside a feed, it is caught in a few cells, whose temperature answers to nothing else. The friction of a round falls
//! as its oil warms ([`oilwedge_heat::Thinning`]).
//!
//! **Source.** Anderson, J. ACM 12 (1965) 547; Walker, Ni, SIAM J. Numer. Anal. 49 (2011) 1715. **Range.** Steady films
//! that conserve oil, and cycles of them, over which temperatures do not follow the motion. **Verified by**
//! `tests/tests/thermal_film.rs`.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use oilwedge_fem::Space;
use oilwedge_heat::{FilmNetwork, LayerTemperatures, Layers};
use oilwedge_reynolds::ViscosityAcross;
use oilwedge_reynolds::quantities::heat_network::{EddySources, NodeNetwork};

use crate::film_heat::FilmHeat;
use crate::heat_round::{HeatSurroundings, LayeredFilm, NoRound, RoundHeat};

/// Films whose temperatures are combined.
const DEPTH: usize = 4;
/// Single temperatures differ by no more than so many times what all differ by in the mean of squares.
const ANYWHERE: f64 = 40.0;
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
/// Tolerance of the linear system of a round over the change of the round before [1/K].
const OF_CHANGE: f64 = 1e-5;
/// Tolerance of the linear system of the last round.
const SOLVED: f64 = 1e-10;
/// Tolerance of that of the first round.
const ROUGHLY_SOLVED: f64 = 1e-5;
/// The clearance is found where its growth differs by no more than this part of it.
const CLOSED_GROWTH: f64 = 1e-6;

/// The film that a round asks for.
#[derive(Debug, Clone)]
pub struct HeatRound {
    /// Viscosity of that film.
    pub across: Arc<ViscosityAcross>,
    /// Growth of its clearance [m].
    pub growth: f64,
    /// How far the temperatures were from balanced in the round before [K]; infinite in the first one.
    pub change: f64,
}

/// Why the temperatures of a film were not found.
#[derive(Debug, Clone, PartialEq)]
pub enum NoHeat<E> {
    /// There is no film in one of the rounds.
    NoFilm(E),
    /// A round has no temperatures.
    NoRound(NoRound),
    /// Rounds do not come nearer.
    NotClosed {
        /// Change of the last round [K].
        change: f64,
        /// Films solved.
        rounds: usize,
    },
}

impl<E> From<NoRound> for NoHeat<E> {
    fn from(reason: NoRound) -> Self {
        Self::NoRound(reason)
    }
}

/// Where a search for the temperatures across a film begins, and where it ends.
#[derive(Debug, Clone)]
pub struct HeatSearch<'a> {
    /// Points across the film.
    pub layers: &'a Layers,
    /// Temperatures at these points of every dof with which it begins [K].
    pub start: Vec<f64>,
    /// What makes the eddies of the film with which it begins; none of a laminar one.
    pub eddies: Option<EddySources>,
    /// Growth of the clearance with which it begins [m].
    pub growth: f64,
    /// Temperatures are found where those of the next round differ by no more than this [K], in the mean of squares
    /// over the film.
    pub closed: f64,
    /// Clearance that the growth is compared with [m].
    pub clearance: f64,
}

/// Finds the temperatures at the points across a film. `solve` gives the film of a round in balance with its load, or
/// the mean of those of a cycle, as a network; `viscosity` is that of the oil at a temperature [K], in Pa s.
///
/// # Errors
/// [`NoHeat`]: the reason why none were found.
pub fn balance_heat<E>(
    surroundings: &HeatSurroundings,
    space: &Space,
    HeatSearch { layers, start, eddies, growth, closed, clearance }: HeatSearch<'_>,
    viscosity: &(dyn Fn(f64) -> f64 + Sync),
    mut solve: impl FnMut(&HeatRound) -> Result<NodeNetwork, E>,
) -> Result<FilmHeat, NoHeat<E>> {
    let mut layered = LayeredFilm { layers, temperatures: start, viscosity, oil: surroundings.oil, eddies };
    let mut mixing = AndersonMixing::default();
    let (mut changes, mut last, mut growth): (Vec<f64>, Option<LayerTemperatures>, f64) = (Vec::new(), None, growth);
    loop {
        let before = changes.last().copied().unwrap_or(f64::INFINITY);
        let profiles = layered.profiles();
        let across = layered.across_by(space, &profiles);
        let nodes = solve(&HeatRound { across, growth, change: before }).map_err(NoHeat::NoFilm)?;
        let tolerance = (OF_CHANGE * before).clamp(SOLVED, ROUGHLY_SOLVED);
        let eddies = nodes.eddies.clone();
        let RoundHeat { network, dofs, feeds, profiles, here, solved } =
            layered.round(surroundings, (nodes, &profiles), last.as_ref(), (tolerance, true))?;
        let found = solved.temperatures;
        let [change, greatest] = differences(&network, &here, &found.layers);
        changes.push(change);
        let grown = surroundings.growth((layers, &network), &found);
        let is_grown = (grown - growth).abs() < CLOSED_GROWTH * clearance;
        if change < closed && greatest < ANYWHERE * closed && is_grown {
            layered.set(&dofs, &found.layers);
            return Ok(FilmHeat {
                layers: layers.clone(),
                network,
                dofs,
                profiles,
                eddies,
                at_dofs: layered.temperatures,
                feeds,
                temperatures: found,
                sheet: solved.sheet,
                growth,
                changes,
            });
        }
        if changes.len() >= MOST_ROUNDS || !change.is_finite() {
            return Err(NoHeat::NotClosed { change, rounds: changes.len() });
        }
        let points = layers.points.len();
        let next = mixing.next(here, &found.layers, |k| network.cells[k / points].wall_area);
        layered.set(&dofs, &next);
        layered.eddies = eddies;
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

/// Anderson's mixing: iterates, and what they lead to.
#[derive(Debug, Default)]
struct AndersonMixing {
    /// Pairs of an iterate and its residual, the last one last.
    kept: Vec<[Vec<f64>; 2]>,
    /// Part of the residual of each point that a step takes: less where that goes back and forth.
    parts: Vec<f64>,
}

impl AndersonMixing {
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
