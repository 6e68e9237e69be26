//! # A closed form of the seven characteristics of a parallel journal
//!
//! **Equation.** `S = k0 b^n (1 - eps)^-a0 [1 + k1 (1 - eps)^a1] arctan^2(k2 b~)`, `b~ = b sqrt(eps/(1 - eps))`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | b = B/D | 1 | `slenderness` |
//! | eps | 1 | `eccentricity` |
//! | n | 1 | `power`: 1, with one more for each factor z in source and weight |
//! | k0, k1, k2, a0, a1 | 1 | `coefficients` |
//!
//! A short bearing has `S ~ b^(n+2)` and a long one `S ~ b^n`, as the limits of Reynolds' equation have. **Source.**
//! Zharov, dissertation (1996), formula (3) with the requirements on its errors; the formula is damaged in print, and
//! this reading of it is ours. **Range.** Full rings, Swift-Stieber, 0.5 to 0.99 in eps and 0.125 to 1.3 in B/D.
//! **Verified by** `tests/tests/tilt/characteristics.rs`, against the films of a second code.

use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_scene::{CavitationModel, CavitationTable, MeshSource, PositionTable, Scene, TheoryKey, Tolerance};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{CompileError, RunOptions, run};
use rayon::prelude::*;
use serde::Serialize;

use super::SharedFilms;
use super::minimax::{PARAMETERS, errors, minimax};
use super::motion::{PARTS, PartMotion};

/// The formula.
const FORMULA: &str =
    "S = k0 b^n (1 - eps)^-a0 [1 + k1 (1 - eps)^a1] arctan^2(k2 b~), b~ = b sqrt(eps/(1 - eps)), b = B/D";
/// Eccentricities of the films that are fitted.
const ECCENTRICITIES: [f64; 10] = [0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.93, 0.96, 0.98, 0.99];
/// Slendernesses B/D of these films.
const SLENDERNESSES: [f64; 7] = [0.125, 0.25, 0.375, 0.5, 0.75, 1.0, 1.3];
/// Bar of what a motion does work on, in these films [1]: half an order below the error of the fit.
const TOLERANCE: f64 = 0.005;
/// Rate of these films [1/s]; the characteristics do not depend on it.
const RATE: f64 = 1.0;

/// A part of the grid, and the relative error that is allowed there.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Domain {
    /// Least and greatest eccentricity [1].
    pub eccentricity: [f64; 2],
    /// Least and greatest B/D [1].
    pub slenderness: [f64; 2],
    /// Relative error allowed [1].
    pub allowed: f64,
}

/// Domain in which crankshaft bearings work.
pub const CORE: Domain = Domain { eccentricity: [0.8, 0.96], slenderness: [0.25, 0.75], allowed: 0.1 };
/// Domain of the whole fit.
pub const WIDE: Domain = Domain { eccentricity: [0.5, 0.99], slenderness: [0.125, 1.3], allowed: 0.3 };

/// One characteristic of a parallel journal.
struct Fitted {
    name: &'static str,
    /// Exponent of B/D of a long bearing.
    power: i32,
    part: PartMotion,
    /// Place of the characteristic among the four numbers of its part.
    number: usize,
}

/// The seven that are not zero.
const SEVEN: [Fitted; 7] = [
    fitted("S_u", 1, PartMotion::Rotation, 0),
    fitted("S_u^x", 1, PartMotion::Rotation, 1),
    fitted("S_c", 1, PARTS[1], 0),
    fitted("S_gx", 2, PartMotion::TiltAlong, 0),
    fitted("S_gx^z", 3, PartMotion::TiltAlong, 2),
    fitted("S_gy", 2, PartMotion::TiltAcross, 0),
    fitted("S_gy^y", 3, PartMotion::TiltAcross, 3),
];

const fn fitted(name: &'static str, power: i32, part: PartMotion, number: usize) -> Fitted {
    Fitted { name, power, part, number }
}

/// The fit over a grid of straight bearings.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Fit {
    /// The formula.
    pub formula: &'static str,
    /// Domain in which errors are to be small.
    pub core: Domain,
    /// The whole grid.
    pub wide: Domain,
    /// The seven characteristics; none where a film is missing.
    pub rows: Vec<FitRow>,
    /// The films that were fitted, by eccentricity and slenderness.
    pub grid: Vec<GridPoint>,
    /// The film that is missing or has not converged, and the cause.
    pub reason: Option<String>,
}

/// The fit of one characteristic.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct FitRow {
    /// The characteristic, as `S_gx^z`: motion below, weight above (none cos, x sin, z z cos, y z sin).
    pub name: &'static str,
    /// Exponent n of B/D.
    pub power: i32,
    /// Sign of the characteristic.
    pub sign: f64,
    /// The coefficients k0, k1, k2, a0, a1 with four digits.
    pub coefficients: [f64; PARAMETERS],
    /// Greatest relative error in the core.
    pub worst_core: f64,
    /// Greatest relative error on the whole grid.
    pub worst_wide: f64,
}

/// The films of one straight bearing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct GridPoint {
    /// Eccentricity [1].
    pub eccentricity: f64,
    /// B/D [1].
    pub slenderness: f64,
    /// The seven characteristics, in the order of the rows.
    pub values: [f64; 7],
}

impl Domain {
    fn contains(&self, point: &GridPoint) -> bool {
        let within = |[least, most]: [f64; 2], x: f64| least <= x && x <= most;
        within(self.eccentricity, point.eccentricity) && within(self.slenderness, point.slenderness)
    }
}

impl FitRow {
    /// The characteristic that the formula gives.
    pub fn value(&self, eccentricity: f64, slenderness: f64) -> Option<f64> {
        let logarithm = logarithm(self.power, self.coefficients, eccentricity, slenderness)?;
        Some(self.sign * logarithm.exp())
    }
}

/// Solves the grid of straight bearings with the dimensions and the oil of a scene, as full rings after Swift and
/// Stieber, and fits the formula. `progress` is called with the number of films done and of all.
///
/// # Errors
/// A liner cannot be meshed.
pub fn fit(scene: &Scene, options: &RunOptions, progress: &(dyn Fn(usize, usize) + Sync)) -> Result<Fit, CompileError> {
    let places = ECCENTRICITIES.iter().flat_map(|&eps| SLENDERNESSES.map(|b| (eps, b)));
    let places: Vec<(f64, f64)> = places.collect();
    let done = AtomicUsize::new(0);
    let films: Vec<Result<GridPoint, String>> = places
        .par_iter()
        .map(|&(eccentricity, slenderness)| {
            let point = straight(scene, options, eccentricity, slenderness)?;
            progress(1 + done.fetch_add(1, Ordering::Relaxed), places.len());
            Ok(point.map_err(|reason| format!("eccentricity {eccentricity}, B/D {slenderness}: {reason}")))
        })
        .collect::<Result<_, CompileError>>()?;
    let reason = films.iter().find_map(|film| film.as_ref().err().cloned());
    let grid: Vec<GridPoint> = films.into_iter().filter_map(Result::ok).collect();
    Ok(Fit {
        formula: FORMULA,
        core: CORE,
        wide: WIDE,
        rows: match reason {
            None => fitted_rows(&grid),
            Some(_) => Vec::new(),
        },
        grid,
        reason,
    })
}

/// The formula fitted to a grid of films: a row for each characteristic.
pub fn fitted_rows(grid: &[GridPoint]) -> Vec<FitRow> {
    SEVEN.iter().enumerate().filter_map(|(k, it)| row(it, k, grid)).collect()
}

/// The characteristics of a parallel journal at this eccentricity and B/D, in a full ring with the bore, the clearance
/// and the oil of a scene; why a film is missing.
///
/// # Errors
/// The liner cannot be meshed.
pub fn straight(
    scene: &Scene,
    options: &RunOptions,
    eccentricity: f64,
    slenderness: f64,
) -> Result<Result<GridPoint, String>, CompileError> {
    let scene = plain(scene, eccentricity, slenderness);
    let films = SharedFilms::of(&scene, options);
    let mut found = Vec::new();
    for part in PARTS {
        let result: RunResult = run(&films.scene_of(part, RATE), options)?.result;
        let carried = films.carried(&result, &[part]);
        match carried.filter(|_| result.head.status == Status::Converged) {
            Some(carried) => {
                found.push(carried.scaled([films.units.force, films.units.moment].map(|unit| 1.0 / (unit * RATE))))
            }
            None => return Ok(Err(format!("{}: {}", part.name(), result.head.reason.unwrap_or_default()))),
        }
    }
    Ok(Ok(GridPoint {
        eccentricity,
        slenderness,
        values: std::array::from_fn(|k| found[SEVEN[k].part.index()].numbers()[SEVEN[k].number].value),
    }))
}

/// A full ring with the bore, the clearance and the oil of a scene, and a parallel journal.
fn plain(scene: &Scene, eccentricity: f64, slenderness: f64) -> Scene {
    let mut plain = scene.clone();
    let bearing = &mut plain.bearing;
    bearing.length = slenderness * bearing.diameter;
    (bearing.arc, bearing.inlet_fraction, bearing.film_start) = (None, None, None);
    bearing.theory = TheoryKey::Full;
    plain.mesh = MeshSource::Drawing { size: None };
    plain.tolerance = Some(Tolerance::Main(TOLERANCE));
    (plain.load_at, plain.load_moment, plain.support, plain.cap) = (None, None, None, None);
    plain.ends.pressure = 0.0;
    plain.feeds.clear();
    plain.cavitation = Some(CavitationTable { model: CavitationModel::Reynolds, pressure: 0.0 });
    plain.journal.position = PositionTable::Given { eccentricity, min_film_angle: 0.0 };
    plain.journal.tilt = Some([0.0; 2]);
    plain
}

/// The logarithm of the formula; `None` where it is not positive.
fn logarithm(power: i32, [k0, k1, k2, a0, a1]: [f64; PARAMETERS], eccentricity: f64, slenderness: f64) -> Option<f64> {
    let gap = 1.0 - eccentricity;
    let stretched = slenderness * (eccentricity / gap).sqrt();
    let value =
        k0 * slenderness.powi(power) * gap.powf(-a0) * (1.0 + k1 * gap.powf(a1)) * (k2 * stretched).atan().powi(2);
    (value.is_finite() && value > 0.0 && k0 > 0.0 && k2 > 0.0).then(|| value.ln())
}

fn row(it: &Fitted, k: usize, grid: &[GridPoint]) -> Option<FitRow> {
    const STARTS: [[f64; 2]; 4] = [[1.0, 0.5], [1.0, 1.5], [-0.5, 1.0], [3.0, 1.0]];
    let sign = grid.first()?.values[k].signum();
    let data: Vec<f64> = grid.iter().map(|point| point.values[k].abs().ln()).collect();
    let allowed_at = |point: &GridPoint| {
        if CORE.contains(point) { CORE.allowed } else { WIDE.allowed }
    };
    let allowed: Vec<f64> = grid.iter().map(allowed_at).collect();
    let model = |at: [f64; PARAMETERS]| {
        let at = |point: &GridPoint| logarithm(it.power, at, point.eccentricity, point.slenderness);
        grid.iter().map(at).collect::<Option<Vec<f64>>>()
    };
    let starts = STARTS.map(|[k1, a1]| [1.0, k1, 1.0, 1.0, a1]);
    let (found, _) = minimax(&model, &data, &allowed, &starts)?;
    let coefficients = with_positive_exponent(found).map(four_digits);
    let off = errors(&model(coefficients)?, &data, &vec![1.0; data.len()]);
    let worst = |domain: Domain| {
        let pairs = grid.iter().zip(&off).filter(|(point, _)| domain.contains(point));
        pairs.fold(0.0, |most: f64, (_, error)| most.max(error.abs()))
    };
    Some(FitRow {
        name: it.name,
        power: it.power,
        sign,
        coefficients,
        worst_core: worst(CORE),
        worst_wide: worst(WIDE),
    })
}

/// A fit of the form `k0 g^-a0 (1 + k1 g^a1)`, rewritten so that a1 > 0:
/// `k0 g^-a0 (1 + k1 g^a1) = k0 k1 g^(a1 - a0) (1 + g^-a1/k1)`.
fn with_positive_exponent([k0, k1, k2, a0, a1]: [f64; PARAMETERS]) -> [f64; PARAMETERS] {
    match a1 < 0.0 && k1 > 0.0 {
        true => [k0 * k1, 1.0 / k1, k2, a0 - a1, -a1],
        false => [k0, k1, k2, a0, a1],
    }
}

/// A number as it is printed.
fn four_digits(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}
