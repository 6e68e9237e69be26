//! `thermal [FROM] [TO]`: solves random bearings with temperatures across their films, and prints the rounds, range of
//! temperatures and faults of each; `thermal --scene N` prints the scene of one, `thermal --bars [FROM] [TO]` compares
//! those under a load with eight layers and edges of half the length.

use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Instant;

use oilwedge_full::random_thermal::{ThermalBearing, ThermalOutcome};
use oilwedge_study::result::Status;

/// Bearings that are solved at a time.
const AT_A_TIME: usize = 2;
/// Bearings of a list.
const BEARINGS: u64 = 200;
/// Rounds that are few.
const FEW: usize = 12;
/// Numbers whose bars are judged.
const JUDGED: [&str; 3] = ["film_thickness_min", "temperature_max", "heat_power"];

/// Runs the command.
pub(crate) fn run(arguments: &[String]) {
    let has = |flag: &str| arguments.iter().any(|it| it == flag);
    let mut numbers = arguments.iter().filter_map(|argument| argument.parse::<u64>().ok());
    let (first, second) = (numbers.next(), numbers.next());
    if let Some(number) = first.filter(|_| has("--scene")) {
        return print!("{}", ThermalBearing::new(number).text);
    }
    let range = first.unwrap_or(0)..second.unwrap_or(BEARINGS);
    match has("--bars") {
        true => bars(range.filter(|number| number % 2 == 1).collect()),
        false => list(range.collect()),
    }
}

/// What `of` makes of each number, a few at a time.
fn each<T: Send>(numbers: &[u64], of: impl Fn(u64) -> T + Sync) -> Vec<T> {
    let (next, found) = (AtomicU64::new(0), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..AT_A_TIME {
            scope.spawn(|| {
                while let Some(&number) = numbers.get(next.fetch_add(1, Ordering::Relaxed) as usize) {
                    let made = of(number);
                    found.lock().expect("a list").push(made);
                }
            });
        }
    });
    found.into_inner().expect("a list")
}

fn list(numbers: Vec<u64>) {
    let outcomes = each(&numbers, |number| {
        let clock = Instant::now();
        let outcome = ThermalBearing::new(number).solved(false);
        let [low, high] = outcome.range.unwrap_or([f64::NAN; 2]);
        let value = |name: &str| outcome.result.by_name(name).map_or(f64::NAN, |it| it.value);
        println!(
            "{number:4} {:?} {} rounds, e {:.3}, {low:.1} to {high:.1} C, {:.1} s {} {}",
            outcome.result.head.status,
            outcome.result.counts.temperature_steps,
            value("eccentricity"),
            clock.elapsed().as_secs_f64(),
            outcome.fault.as_deref().unwrap_or_default(),
            outcome.result.head.reason.as_deref().unwrap_or_default(),
        );
        outcome
    });
    let converged = |it: &&ThermalOutcome| it.result.head.status == Status::Converged;
    let mut rounds: Vec<usize> =
        outcomes.iter().filter(converged).map(|it| it.result.counts.temperature_steps).collect();
    rounds.sort_unstable();
    println!(
        "{} of {} converged, {} in at most {FEW} rounds, median {}, most {}; {} of them at fault",
        rounds.len(),
        outcomes.len(),
        rounds.iter().filter(|rounds| **rounds <= FEW).count(),
        rounds.get(rounds.len() / 2).copied().unwrap_or_default(),
        rounds.last().copied().unwrap_or_default(),
        outcomes.iter().filter(converged).filter(|it| it.fault.is_some()).count(),
    );
}

fn bars(numbers: Vec<u64>) {
    let found = each(&numbers, |number| {
        let bearing = ThermalBearing::new(number);
        let [with, finer] = [bearing.solved(true), bearing.finer().solved(false)].map(|it| it.result);
        let pair = |name: &str| {
            let [here, there] = [&with, &finer].map(|result| result.by_name(name));
            Some([here?.error()?, (here?.value - there?.value).abs(), here?.value.abs()])
        };
        let pairs = JUDGED.map(pair);
        println!("{number:4} {:?} {:?} {pairs:?}", with.head.status, finer.head.status);
        pairs
    });
    for (k, name) in JUDGED.into_iter().enumerate() {
        let pairs: Vec<[f64; 3]> = found.iter().filter_map(|pairs| pairs[k]).collect();
        let hold = pairs.iter().filter(|[bar, error, _]| error <= bar).count();
        let mut widths: Vec<f64> = pairs.iter().map(|[bar, error, _]| bar / error.max(f64::MIN_POSITIVE)).collect();
        widths.sort_by(f64::total_cmp);
        let middle = widths.get(widths.len() / 2).copied().unwrap_or(f64::NAN);
        println!("{name}: {hold} of {} bars hold, median width {middle:.2} errors", pairs.len());
    }
}
