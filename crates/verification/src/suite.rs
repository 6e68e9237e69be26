//! The suite: every case solved, judged by itself and by a second method.

use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::time::Instant;

use oilwedge_campaign::QuantityPair;
use oilwedge_study::result::RunResult;

use crate::answer::{self, CaseAnswer};
use crate::cases::{BadFamily, Case, cases, families};
use crate::family::{CaseSeries, Expect, Family};
use crate::faults::faults;
use crate::reference_film::{Second, against};

/// What was found of one case.
#[derive(Debug, Clone)]
pub struct CaseVerdict {
    /// The case.
    pub case: Case,
    /// Name of its family in words.
    pub title: String,
    /// Why the family is there.
    pub reason_of_family: String,
    /// Why the case is there.
    pub why: String,
    /// How it ended.
    pub end: Expect,
    /// Seconds that it took.
    pub seconds: f64,
    /// The numbers; `None`: the scene or its mesh was refused.
    pub result: Option<RunResult>,
    /// Why there is no answer.
    pub reason: Option<String>,
    /// What stood against the answer, in words; empty where there is none.
    pub against: String,
    /// Known values, and the numbers beside them.
    pub known: Vec<QuantityPair>,
    /// What does not hold; nothing where all is well.
    pub faults: Vec<String>,
}

/// Why the suite was not run.
#[derive(Debug, thiserror::Error)]
pub enum SuiteError {
    /// A family of cases cannot be read.
    #[error(transparent)]
    Family(#[from] BadFamily),
    /// The suite has no such family.
    #[error("there is no family of hard cases {asked}; there are {}", known.join(", "))]
    Unknown {
        /// The name given.
        asked: String,
        /// The names that there are.
        known: Vec<&'static str>,
    },
    /// No folder for the meshes of cases.
    #[error("cannot make a folder for meshes: {0}")]
    Folder(#[from] std::io::Error),
    /// Threads cannot be started.
    #[error("cannot start the threads of the suite: {0}")]
    Threads(String),
}

/// The cases of one series, which are judged together.
struct SeriesCases {
    family: Family,
    series: CaseSeries,
    cases: Vec<Case>,
}

/// The families named, all if none is named; with the series that take long or without.
fn work(names: &[String], long: bool) -> Result<Vec<SeriesCases>, SuiteError> {
    let families = families()?;
    let known: Vec<&'static str> = families.iter().map(|(name, _)| *name).collect();
    if let Some(asked) = names.iter().find(|name| !known.contains(&name.as_str())) {
        let asked = asked.clone();
        return Err(SuiteError::Unknown { asked, known });
    }
    let wanted = |name: &str| names.is_empty() || names.iter().any(|wanted| wanted == name);
    let series = (families.iter().filter(|(name, _)| wanted(name))).flat_map(|(name, family)| {
        (family.series.iter().filter(|series| long || !series.long)).map(|series| SeriesCases {
            family: family.clone(),
            series: series.clone(),
            cases: cases(name, family, series),
        })
    });
    Ok(series.collect())
}

/// Cases of the families named, all if none is named; those that take `long` among them or not.
///
/// # Errors
/// [`SuiteError::Family`], [`SuiteError::Unknown`].
pub fn count(names: &[String], long: bool) -> Result<usize, SuiteError> {
    Ok(work(names, long)?.iter().map(|work| work.cases.len()).sum())
}

/// Runs the cases of the families named (all if none is named), those that take `long` among them or not, and reports
/// each series as it ends: as many series at once as there are threads, then those that take long, each on all threads.
/// The verdicts come in the order of the files.
///
/// # Errors
/// [`SuiteError`].
pub fn run_suite(
    names: &[String],
    long: bool,
    ended: &mut dyn FnMut(&[CaseVerdict]),
) -> Result<Vec<CaseVerdict>, SuiteError> {
    let all = work(names, long)?;
    let folder = tempfile::tempdir()?;
    let (long, short): (Vec<usize>, Vec<usize>) = (0..all.len()).partition(|&place| all[place].series.long);
    let piece = |place: usize| (place, judged(&all[place], folder.path(), place));
    let others =
        in_threads(short.len(), |k| piece(short[k]), &mut |(_, verdicts): &(usize, Vec<CaseVerdict>)| ended(verdicts))?;
    let mut found: Vec<(usize, Vec<CaseVerdict>)> = others.into_iter().map(|(_, found)| found).collect();
    for place in long {
        let (place, verdicts) = piece(place);
        ended(&verdicts);
        found.push((place, verdicts));
    }
    found.sort_by_key(|(place, _)| *place);
    Ok(found.into_iter().flat_map(|(_, verdicts)| verdicts).collect())
}

/// Does `count` pieces of work on threads of their own, each with one thread for its parts, and hands on what ends.
///
/// # Errors
/// [`SuiteError::Threads`].
pub fn in_threads<T: Send>(
    count: usize,
    piece: impl Fn(usize) -> T + Sync,
    ended: &mut dyn FnMut(&T),
) -> Result<Vec<(usize, T)>, SuiteError> {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = channel();
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(count) {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
            let pool = pool.map_err(|error| SuiteError::Threads(error.to_string()))?;
            let (sender, next, piece) = (sender.clone(), &next, &piece);
            scope.spawn(move || {
                pool.install(|| {
                    loop {
                        let place = next.fetch_add(1, Ordering::Relaxed);
                        if place >= count || sender.send((place, piece(place))).is_err() {
                            return;
                        }
                    }
                });
            });
        }
        drop(sender);
        Ok(receiver.iter().inspect(|(_, found)| ended(found)).collect())
    })
}

/// All cases of a series.
fn judged(work: &SeriesCases, folder: &Path, place: usize) -> Vec<CaseVerdict> {
    let cases = work.cases.iter().enumerate();
    cases.map(|(number, case)| one(work, case, folder, 1000 * place + number)).collect()
}

fn one(work: &SeriesCases, case: &Case, folder: &Path, number: usize) -> CaseVerdict {
    let scene = answer::prepare(case, folder, number);
    let clock = Instant::now();
    let answer = match &scene {
        Ok(scene) => answer::solve(scene),
        Err(message) => CaseAnswer::Refused(message.clone()),
    };
    let seconds = clock.elapsed().as_secs_f64();
    // Judged by the scene that was solved: a law found for the case is part of it.
    let scene_solved = scene.clone().unwrap_or_else(|_| case.scene.clone());
    let solved = Case { scene: scene_solved, ..case.clone() };
    let mut faults = faults(&solved, &answer);
    let mut second = Second::default();
    if let (Ok(scene), CaseAnswer::Run(run), true) = (&scene, &answer, faults.is_empty()) {
        second = against(&work.series, scene, run, &mut faults);
    }
    CaseVerdict {
        case: case.clone(),
        title: work.family.title.clone(),
        reason_of_family: work.family.reason.clone(),
        why: work.series.why.clone(),
        end: answer.end(),
        seconds,
        reason: answer.reason().map(str::to_owned),
        result: match answer {
            CaseAnswer::Run(run) => Some(run.result),
            CaseAnswer::Refused(_) => None,
        },
        against: second.methods,
        known: second.known,
        faults,
    }
}
