//! `tilted [FROM] [TO]`: solves random bearings whose journal tilts, one on each processor at a time, and prints each
//! that has not converged, with its reason and time, and the slowest; `tilted --scene N` prints the scene of one,
//! `tilted --outcome N` how it ends, as JSON; `tilted --bars [FROM] [TO]` counts how often the bars of moment and tilt
//! hold. With `--walls` surfaces are rough and touch, walls give way, and bores are out of round. `tilted --page`
//! solves every fifth of 300 bearings of both kinds and writes `docs/validation/random_bearings.md` anew.

use std::io;
use std::process::Command;
use std::sync::Mutex;
use std::thread;

use oilwedge_full::coverage::bearings::Bearing;
use oilwedge_full::coverage::tally::{Of, coverage, quantile, tally};
use oilwedge_full::performance::clock::on_threads;
use oilwedge_full::random_page::{LONGEST, Outcome, page};
use oilwedge_full::random_tilted::TiltedBearing;
use oilwedge_study::result::Status;
use oilwedge_tests::program::repository;

/// Bearings of each kind, and how many the page passes over from one to the next.
const BEARINGS: u64 = 300;
const STEP: usize = 5;
/// The page, from the root of the repository.
const PAGE: &str = "docs/validation/random_bearings.md";

/// Kinds of random bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Bearings {
    /// Bearings with rigid, round bores and smooth surfaces.
    Plain,
    /// Bearings with walls that give way, rough surfaces and bores out of round.
    Walls,
}

impl Bearings {
    fn number(self, number: u64) -> TiltedBearing {
        match self {
            Self::Plain => TiltedBearing::new(number),
            Self::Walls => TiltedBearing::with_walls(number),
        }
    }

    /// The argument that asks for them.
    fn argument(self) -> &'static [&'static str] {
        match self {
            Self::Plain => &[],
            Self::Walls => &["--walls"],
        }
    }
}

/// Runs the command.
pub(crate) fn run(arguments: &[String]) -> io::Result<()> {
    let has = |flag: &str| arguments.iter().any(|it| it == flag);
    let mut numbers = arguments.iter().filter_map(|argument| argument.parse::<u64>().ok());
    let (first, second) = (numbers.next(), numbers.next());
    let bearings = if has("--walls") { Bearings::Walls } else { Bearings::Plain };
    if let Some(number) = first.filter(|_| has("--scene")) {
        print!("{}", bearings.number(number).text);
        return Ok(());
    }
    if let Some(number) = first.filter(|_| has("--outcome")) {
        // On one thread the time of the processor is that of the bearing.
        let outcome = on_threads(1, || Outcome::of(bearings.number(number)));
        println!("{}", outcome.to_json());
        return Ok(());
    }
    let (from, to) = (first.unwrap_or(0), second.unwrap_or(BEARINGS));
    if has("--bars") {
        bars((from..to).map(|number| bearings.number(number)), from);
        return Ok(());
    }
    if has("--page") {
        let of = |bearings| outcomes(bearings, (0..BEARINGS).step_by(STEP).collect());
        let (rigid, elastic) = (of(Bearings::Plain)?, of(Bearings::Walls)?);
        let path = repository().join(PAGE);
        let written = std::fs::read_to_string(&path)?;
        return std::fs::write(&path, page(&written, &rigid, &elastic));
    }
    let outcomes = outcomes(bearings, (from..to).collect())?;
    let count = |is: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|outcome| is(outcome)).count();
    let longest = outcomes.iter().max_by(|a, b| a.seconds.total_cmp(&b.seconds));
    println!(
        "{} converged, {} without a solution, {} faults, {} slower than {LONGEST} s; the longest {:.1} s ({})",
        count(&|it| it.status == Status::Converged && it.fault.is_none()),
        count(&|it| it.status == Status::NoSolution),
        count(&|it| it.fault.is_some()),
        count(&Outcome::is_slow),
        longest.map_or(0.0, |outcome| outcome.seconds),
        longest.map_or(0, |outcome| outcome.bearing.number),
    );
    Ok(())
}

/// How bearings end, in order; each is solved by a process of its own, one on each processor at a time.
fn outcomes(bearings: Bearings, numbers: Vec<u64>) -> io::Result<Vec<Outcome>> {
    let (left, found) = (Mutex::new(numbers.into_iter()), Mutex::new(Vec::new()));
    let next = || left.lock().ok()?.next();
    let work = || {
        while let Some(number) = next() {
            let outcome = solved(bearings, number)?;
            if let Some(told) = outcome.told() {
                println!("{told}");
            }
            if let Ok(mut found) = found.lock() {
                found.push(outcome);
            }
        }
        Ok::<(), io::Error>(())
    };
    thread::scope(|scope| {
        let processors = thread::available_parallelism()?.get();
        let threads: Vec<_> = (0..processors).map(|_| scope.spawn(work)).collect();
        let end = |thread: thread::ScopedJoinHandle<io::Result<()>>| {
            thread.join().unwrap_or_else(|_| Err(io::Error::other("a thread has panicked")))
        };
        threads.into_iter().try_for_each(end)
    })?;
    let mut found = found.into_inner().unwrap_or_default();
    found.sort_by_key(|outcome| outcome.bearing.number);
    Ok(found)
}

/// How a bearing ends, by a process of its own.
fn solved(bearings: Bearings, number: u64) -> io::Result<Outcome> {
    let process = Command::new(std::env::current_exe()?)
        .arg("tilted")
        .args(bearings.argument())
        .args(["--outcome", &number.to_string()])
        .output()?;
    let written = serde_json::from_slice(&process.stdout);
    let outcome = written.ok().and_then(|written| Outcome::from_json(bearings.number(number), &written));
    outcome.ok_or_else(|| io::Error::other(format!("bearing {number}: {}", String::from_utf8_lossy(&process.stderr))))
}

/// Most unknowns of a reference.
const MOST: usize = 12_000;

/// How often the bars of load, moment and tilt hold, and how much wider than the errors they are, by model of
/// cavitation.
fn bars(bearings: impl Iterator<Item = TiltedBearing>, from: u64) {
    let list: Vec<Bearing> = bearings.map(|bearing| bearing.counted()).collect();
    let tally = tally(&list, from, MOST, |_, _| {});
    println!("{} solves, {} errors not known, {} numbers without a bar", tally.solves, tally.unknown, tally.unresolved);
    for without in &tally.without {
        println!("{without}");
    }
    for quantity in ["load", "moment_x", "moment_y", "eccentricity", "tilt_x", "tilt_y"] {
        for model in ["none", "guembel", "reynolds", "jfo", ""] {
            let is_chosen = |of: &str| model.is_empty() || of == model;
            let ratios =
                tally.ratios(|pair| pair.quantity == quantity && pair.of == Of::Reported && is_chosen(pair.model));
            if !ratios.is_empty() {
                let model = if model.is_empty() { "all" } else { model };
                println!(
                    "{quantity:13} {model:9} {:4} bars, {:.1} % hold, least ratio {:.2}, median {:.1}",
                    ratios.len(),
                    100.0 * coverage(&ratios),
                    ratios[0],
                    quantile(&ratios, 0.5)
                );
            }
        }
    }
}
