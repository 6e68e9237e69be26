//! How often bars hold, and how much wider than the errors they are.

use std::num::NonZeroUsize;
use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_reynolds::ReferenceFilm;
use oilwedge_study::estimate::quadratic_errors;
use oilwedge_study::measure::measure;
use oilwedge_study::quantities::{Quantity, View, measured};

use super::bearings::{Bearing, Family};
use super::meshes::{Kind, Solve, solves};
use super::reference::{Reference, reference};

/// Quantities whose bars are counted; `feed_flow` stands for all feeds.
pub const COUNTED: [&str; 28] = [
    "load",
    "attitude_angle",
    "pressure_max",
    "eccentricity",
    "side_flow",
    "feed_flow",
    "min_film_angle",
    "pressure_integral",
    "cavity_share",
    "cavity_flow",
    "pressure_min",
    "friction_power",
    "friction_pressure_power",
    "friction_torque_bearing",
    "stiffness_xx",
    "stiffness_xy",
    "stiffness_yx",
    "stiffness_yy",
    "damping_xx",
    "damping_xy",
    "damping_yx",
    "damping_yy",
    "critical_mass",
    "whirl_ratio",
    "moment_x",
    "moment_y",
    "tilt_x",
    "tilt_y",
];
/// Errors below this part of the size of a quantity are rounding.
const ROUNDING: f64 = 1e-9;
/// Unknowns from which on a difference of two degrees should tell the error of a smooth film's load.
const FINE: usize = 500;

/// Value that a bar belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Of {
    /// The value that is reported.
    Reported,
    /// The value of the quadratic film.
    Quadratic,
}

/// A bar and the error that it should cover.
#[derive(Debug, Clone)]
pub struct Pair {
    /// Name of the bearing.
    pub bearing: String,
    /// Family of the bearing.
    pub family: Family,
    /// Cavitation model of the bearing.
    pub model: &'static str,
    /// One of [`COUNTED`].
    pub quantity: &'static str,
    /// Value that the bar belongs to.
    pub of: Of,
    /// How the mesh was made.
    pub kind: Kind,
    /// Unknowns of the mesh.
    pub unknowns: usize,
    /// True error, relative to the size of the quantity.
    pub error: f64,
    /// Bar over error.
    pub ratio: f64,
}

/// What bars did.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    /// All bars whose error is known.
    pub pairs: Vec<Pair>,
    /// Solves.
    pub solves: usize,
    /// Errors smaller than what the reference is unsure of.
    pub unknown: usize,
    /// Values without a bar: the mesh does not resolve them.
    pub unresolved: usize,
    /// Meshes without an answer, and bearings without a reference, in words.
    pub without: Vec<String>,
    /// `(J(p3) - J(p2))` over the true error of `J(p2)`: loads of smooth films on fine meshes, with family and
    /// unknowns.
    pub effectivity: Vec<(Family, usize, f64)>,
}

impl Tally {
    /// Adds another.
    pub fn append(&mut self, mut other: Self) {
        self.pairs.append(&mut other.pairs);
        self.solves += other.solves;
        self.unknown += other.unknown;
        self.unresolved += other.unresolved;
        self.without.append(&mut other.without);
        self.effectivity.append(&mut other.effectivity);
    }

    /// Ratios of the pairs chosen, the least first.
    pub fn ratios(&self, chosen: impl Fn(&Pair) -> bool) -> Vec<f64> {
        let mut ratios: Vec<f64> = (self.pairs.iter().filter(|pair| chosen(pair))).map(|pair| pair.ratio).collect();
        ratios.sort_by(f64::total_cmp);
        ratios
    }

    /// Adds what is told of one solve by the better numbers.
    pub fn add(&mut self, bearing: &Bearing, solve: &Solve, reference: &Reference) {
        self.solves += 1;
        self.add_list(bearing, solve, reference, Of::Reported, &solve.judged.quantities);
        if let Some(quadratic) = quadratic_errors(&solve.solved) {
            self.add_list(bearing, solve, reference, Of::Quadratic, &quadratic);
        }
        self.add_effectivity(bearing, solve, reference);
    }

    fn add_list(&mut self, bearing: &Bearing, solve: &Solve, reference: &Reference, of: Of, list: &[Quantity]) {
        for quantity in list {
            let name = quantity.name.split('.').next().unwrap_or_default();
            let Some(counted) = COUNTED.into_iter().find(|counted| *counted == name) else {
                continue;
            };
            let is_given = match bearing.family {
                Family::Loaded => name == "load",
                _ => matches!(name, "eccentricity" | "min_film_angle"),
            };
            let known = reference.known.iter().find(|known| known.name == quantity.name);
            let Some(known) = known.filter(|_| !is_given) else {
                continue;
            };
            let Some(bar) = quantity.error() else {
                self.unresolved += 1;
                continue;
            };
            let size = size(quantity, list, solve);
            let error = quantity.row.difference(quantity.value, known.value).abs();
            if error <= known.bar.max(ROUNDING * size) || !known.bar.is_finite() {
                self.unknown += 1;
                continue;
            }
            self.pairs.push(Pair {
                bearing: bearing.name.clone(),
                family: bearing.family,
                model: bearing.model,
                quantity: counted,
                of,
                kind: solve.kind,
                unknowns: solve.unknowns,
                error: error / size,
                ratio: bar / error,
            });
        }
    }

    fn add_effectivity(&mut self, bearing: &Bearing, solve: &Solve, reference: &Reference) {
        let Some(ReferenceFilm::Cubic(_)) = &solve.solved.reference else {
            return;
        };
        let known = reference.known.iter().find(|known| known.name == "load");
        let smooth = bearing.model == "none" && bearing.family != Family::Loaded && solve.unknowns >= FINE;
        let Some(known) = known.filter(|_| smooth) else {
            return;
        };
        let study = &solve.solved.film;
        let film = measure(&solve.solved.primary);
        let quadratic = measured(&View::new(study, &study.problem, &film));
        let load = |list: &[Quantity]| list.iter().find(|quantity| quantity.name == "load").map(|load| load.value);
        if let (Some(better), Some(worse)) = (load(&solve.judged.quantities), load(&quadratic)) {
            let error = known.value - worse;
            if error.abs() > 10.0 * known.bar {
                self.effectivity.push((bearing.family, solve.unknowns, (better - worse) / error));
            }
        }
    }
}

/// What an error of the quantity is compared with: its value, a radian, the greatest pressure, all oil that passes.
fn size(quantity: &Quantity, list: &[Quantity], solve: &Solve) -> f64 {
    let named = |name: &str| list.iter().find(|other| other.name == name).map_or(0.0, |other| other.value.abs());
    match quantity.unit() {
        "deg" => 1f64.to_degrees(),
        "Pa" => named("pressure_max"),
        "N" => named("load"),
        "W" => named("friction_power"),
        "m3/s" => solve.judged.measured.flows.throughput,
        _ => quantity.value.abs(),
    }
}

/// Share [1] of sorted ratios that cover; one of none.
pub fn coverage(ratios: &[f64]) -> f64 {
    match ratios.len() {
        0 => 1.0,
        all => ratios.iter().filter(|ratio| **ratio >= 1.0).count() as f64 / all as f64,
    }
}

/// The value below which this share of sorted values lies; not a number of none.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = (share * sorted.len().saturating_sub(1) as f64).round() as usize;
    sorted.get(place).copied().unwrap_or(f64::NAN)
}

/// Solves all bearings on their meshes, on all processors, and counts; references have at most some `most` unknowns.
/// `told` hears of each bearing done.
pub fn tally(bearings: &[Bearing], seed: u64, most: usize, told: impl Fn(usize, &Bearing) + Sync) -> Tally {
    let done = AtomicUsize::new(0);
    let parts = each(bearings, |bearing| {
        let mut tally = Tally::default();
        match reference(bearing, most) {
            Err(reason) => tally.without.push(format!("{}: no reference: {reason}", bearing.name)),
            Ok(reference) => {
                let mut sizes = Vec::new();
                for solve in solves(bearing, seed) {
                    match solve {
                        Err(reason) => tally.without.push(format!("{}: {reason}", bearing.name)),
                        // Openings may bound the size of the triangles: the same mesh again.
                        Ok(solve) if sizes.contains(&solve.unknowns) => {}
                        Ok(solve) => {
                            sizes.push(solve.unknowns);
                            tally.add(bearing, &solve, &reference);
                        }
                    }
                }
            }
        }
        told(done.fetch_add(1, Ordering::Relaxed) + 1, bearing);
        tally
    });
    let mut all = Tally::default();
    parts.into_iter().for_each(|part| all.append(part));
    all
}

/// Works on all entries, one thread a processor, and returns what comes of them in their order.
///
/// # Panics
/// If the work does.
pub fn each<T: Sync, R: Send>(entries: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, NonZeroUsize::get);
    let run = || {
        let mut found = Vec::new();
        loop {
            let k = next.fetch_add(1, Ordering::Relaxed);
            match entries.get(k) {
                Some(entry) => found.push((k, work(entry))),
                None => return found,
            }
        }
    };
    let mut found: Vec<(usize, R)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(run)).collect();
        let joined = workers.into_iter().flat_map(|worker| worker.join().expect("no panic"));
        joined.collect()
    });
    found.sort_by_key(|(k, _)| *k);
    found.into_iter().map(|(_, result)| result).collect()
}
