//! A sweep: one scene solved for many values of its keys.
//!
//! Cases are cut into chains of neighbours (`chain.rs`), which are walked along (`walk.rs`): the mesh, its numbering
//! and analysis stay as long as they fit, films and positions begin where those before lead. Chains do not depend on
//! each other: machines that share a sweep compute whole ones ([`Sweep::chains`], [`Sweep::cases_of`]).
//!
//! Of crankshafts each bearing is a case: the bearings of one shaft are a chain, and are solved together.

mod chain;
mod forecast;
mod part;
mod walk;

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use oilwedge_scene::sweep::{DrawOptions, Plan};
use oilwedge_scene::{Scene, SceneError, ShaftScene};
use oilwedge_study::CompileError;
use oilwedge_study::compile::compile;
use oilwedge_study::effects::{Effects, present};
use oilwedge_study::refinement::first_film;
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::shaft::{ShaftError, bearing_scenes, check_shaft};
use oilwedge_study::{CHECKS, check_columns, pool};

use crate::Error;
use chain::chains;
pub use forecast::Forecast;
use forecast::{SAMPLED, samples_first};
pub use part::Part;
pub(crate) use walk::Walker;
pub use walk::{CaseOutcome, CaseStatus};

/// What happens in a sweep.
#[derive(Debug)]
pub enum Event {
    /// Enough cases were computed to say how long it will take.
    Forecast(Forecast),
    /// The case of this number (from 0) ended.
    Ended(usize, Box<CaseOutcome>),
}

/// A chain that is walked along, and may be left and taken up again.
struct Walk<'a> {
    /// The walker along the chain; none before its first case.
    walker: Option<Walker<'a>>,
    /// Cases left.
    cases: Range<usize>,
}

impl Walk<'_> {
    fn new(cases: Range<usize>) -> Self {
        Self { walker: None, cases }
    }
}

/// What is found of scenes that are solved one after the other, each from the film before; on the mesh of the first one
/// as far as it suits.
pub fn chain_of(scenes: &[Scene], options: &RunOptions) -> Vec<CaseOutcome> {
    let mut walker = Walker::new(options);
    walker.begin();
    scenes.iter().map(|scene| walker.case(scene, 0.0)).collect()
}

/// A sweep that can be run: every case is a good scene.
pub struct Sweep {
    /// The axes.
    pub plan: Plan,
    /// The scene of each case; of crankshafts that of a bearing on its shaft.
    pub scenes: Vec<Scene>,
    /// The crankshafts of a sweep of them, each of which has a case for each of its bearings; else none.
    pub shafts: Vec<ShaftScene>,
    /// Title of the scene.
    pub title: String,
    /// SHA-256 of the scene's text, hexadecimal.
    pub scene_sha256: String,
}

impl Sweep {
    /// The sweep of a scene; `None` where it has none.
    ///
    /// # Errors
    /// Everything that is wrong with a case.
    pub fn of(scene: &Scene) -> Result<Option<Self>, SceneError> {
        scene.sweep.clone().map(|plan| Self::planned(scene, plan)).transpose()
    }

    /// The sweep of a scene, with or without axes, in which its tolerances are drawn; `None` where nothing is left to
    /// draw.
    ///
    /// # Errors
    /// Everything that is wrong with a case.
    pub fn drawn(scene: &Scene, options: DrawOptions) -> Result<Option<Self>, SceneError> {
        Plan::drawn(scene, options).map(|plan| Self::planned(scene, plan)).transpose()
    }

    fn planned(scene: &Scene, plan: Plan) -> Result<Self, SceneError> {
        Ok(Self {
            scenes: plan.scenes(&CHECKS)?,
            shafts: Vec::new(),
            plan,
            title: scene.title.clone(),
            scene_sha256: scene.sha256.clone(),
        })
    }

    /// The sweep of a crankshaft; `None` where its scene has none. The bearings are its last axis.
    ///
    /// # Errors
    /// Everything that is wrong with a case, or why the first one does not become a shaft on films.
    pub fn of_shaft(scene: &ShaftScene) -> Result<Option<Self>, ShaftError> {
        let Some(plan) = &scene.sweep else { return Ok(None) };
        let shafts = plan.shafts()?;
        let scenes: Result<Vec<_>, _> = shafts.iter().map(bearing_scenes).collect();
        let scenes = scenes?.concat();
        check_columns(plan, &scenes)?;
        if let Some(first) = shafts.first() {
            check_shaft(first)?;
        }
        let bearings = scene.crankshaft.bearings.iter();
        Ok(Some(Self {
            plan: plan.with_bearings(bearings.map(|bearing| bearing.name.clone()).collect()),
            scenes,
            shafts,
            title: scene.title.clone(),
            scene_sha256: scene.sha256.clone(),
        }))
    }

    /// What is simulated in the first case, and what is not.
    ///
    /// # Errors
    /// The first case does not become a film.
    pub fn effects(&self) -> Result<Effects, CompileError> {
        if !self.shafts.is_empty() {
            // They were compiled on their shaft.
            let names = |scene| present(scene).map(|effect| effect.name).collect::<Vec<_>>();
            return Ok(self.scenes.first().map_or_else(Effects::default, |first| Effects::of(&names(first))));
        }
        let first = self.scenes.first().map(|first| first_film(&compile(first)?)).transpose()?;
        Ok(first.map_or_else(Effects::default, |film| Effects::of(&film.model.effects)))
    }

    /// The cases of each chain, in the order of the cases; all of them together are all cases.
    pub fn chains(&self) -> Vec<Range<usize>> {
        match self.bearings() {
            None => chains(&self.plan),
            Some(bearings) => (0..self.shafts.len()).map(|shaft| shaft * bearings..(shaft + 1) * bearings).collect(),
        }
    }

    /// Number of bearings of each crankshaft; `None` where the cases are none of crankshafts.
    fn bearings(&self) -> Option<usize> {
        self.scenes.len().checked_div(self.shafts.len())
    }

    /// The cases of a part of the sweep: whole chains, or none where there are more parts than chains.
    pub fn cases_of(&self, part: Part) -> Range<usize> {
        part.cases(&self.chains())
    }

    /// The `of` parts of the sweep and their cases; parts without a case are left out.
    pub fn parts(&self, of: u32) -> Vec<(Part, Range<usize>)> {
        let chains = self.chains();
        let parts = (1..=of).filter_map(|number| Part::new(number, of));
        let parts = parts.map(|part| (part, part.cases(&chains)));
        parts.filter(|(_, cases)| !cases.is_empty()).collect()
    }

    /// Runs all cases but those that `is_kept`, on all threads, and hands on each when it ends. The first cases of some
    /// chains come first; from them the time of the sweep is forecast, and nothing is computed twice for that. A chain
    /// of which every case is kept is not touched: with all others kept, one chain is computed by itself.
    ///
    /// # Errors
    /// Threads cannot be started, or the first error of `event`.
    pub fn run<E: From<Error>>(
        &self,
        options: &RunOptions,
        is_kept: &dyn Fn(usize) -> bool,
        event: &mut dyn FnMut(Event) -> Result<(), E>,
    ) -> Result<(), E> {
        let clock = Instant::now();
        // A case starts from its neighbours, so a chain that was not finished is walked along from its beginning.
        let chains: Vec<Range<usize>> =
            (self.chains().into_iter()).filter(|chain| !chain.clone().all(is_kept)).collect();
        let workers = rayon::current_num_threads().min(chains.len());
        let (chains, samples) = samples_first(chains, workers);
        let mut seconds = vec![Vec::new(); samples];
        let left: usize = chains.iter().cloned().flatten().filter(|case| !is_kept(*case)).count();
        let walks: Vec<Mutex<Walk>> = chains.iter().cloned().map(Walk::new).map(Mutex::new).collect();
        let ended = |event: &mut dyn FnMut(Event) -> Result<(), E>, case: usize, found: CaseOutcome| match is_kept(case)
        {
            true => Ok(()),
            false => event(Event::Ended(case, Box::new(found))),
        };
        self.walk(&walks[..samples], workers, options, SAMPLED, &mut |case, found| {
            let sampled = chains[..samples].iter().position(|chain| chain.contains(&case));
            if let Some(sample) = sampled {
                seconds[sample].push(found.seconds);
            }
            ended(event, case, found)
        })?;
        if let Some(rest) = forecast::rest(&chains, &seconds, workers).filter(|_| !options.interrupt.is_asked()) {
            event(Event::Forecast(Forecast {
                cases: left,
                seconds: clock.elapsed().as_secs_f64() + rest,
                threads: workers * (rayon::current_num_threads() / workers.max(1)),
            }))?;
        }
        self.walk(&walks, workers, options, usize::MAX, &mut |case, found| ended(event, case, found))
    }

    /// Walks on along each chain, by `most` cases.
    fn walk<'a, E: From<Error>>(
        &self,
        walks: &[Mutex<Walk<'a>>],
        workers: usize,
        options: &'a RunOptions,
        most: usize,
        ended: &mut dyn FnMut(usize, CaseOutcome) -> Result<(), E>,
    ) -> Result<(), E> {
        let next = AtomicUsize::new(0);
        let (sender, receiver) = channel();
        std::thread::scope(|scope| {
            for _ in 0..workers.min(walks.len()) {
                // Threads of its own: a worker that waits for a part of its film does not take up another chain
                // meanwhile.
                let pool =
                    pool(rayon::current_num_threads() / workers).map_err(|error| Error::Threads(error.to_string()))?;
                let (sender, next) = (sender.clone(), &next);
                scope.spawn(move || pool.install(|| self.work(walks, next, options, most, &sender)));
            }
            drop(sender);
            // Where a row cannot be written the receiver goes away, and the workers end.
            let receiver = receiver;
            receiver.iter().try_for_each(|(case, found)| ended(case, found))
        })
    }

    fn work<'a>(
        &self,
        walks: &[Mutex<Walk<'a>>],
        next: &AtomicUsize,
        options: &'a RunOptions,
        most: usize,
        sender: &Sender<(usize, CaseOutcome)>,
    ) {
        let mut spare: Option<Walker> = None;
        while let Some(walk) = walks.get(next.fetch_add(1, Ordering::Relaxed)) {
            let mut walk = walk.lock().unwrap_or_else(PoisonError::into_inner);
            let mut walker = walk.walker.take().unwrap_or_else(|| {
                let mut walker = spare.take().unwrap_or_else(|| Walker::new(options));
                walker.begin();
                walker
            });
            for case in walk.cases.by_ref().take(most) {
                let found = match self.bearings() {
                    None => walker.case(&self.scenes[case], self.coordinate(case)),
                    Some(bearings) => walker.bearing(&self.shafts[case / bearings]),
                };
                // A case that was ended is none.
                if options.interrupt.is_asked() || sender.send((case, found)).is_err() {
                    return;
                }
            }
            match walk.cases.is_empty() {
                true => spare = Some(walker),
                false => walk.walker = Some(walker),
            }
        }
    }

    /// Place of a case on the axis along which chains run; draws have no order, and all have the same.
    fn coordinate(&self, case: usize) -> f64 {
        if self.plan.draws.is_some() {
            return 0.0;
        }
        let indices = self.plan.indices(case);
        match (self.plan.axes.last(), indices.last()) {
            (Some(axis), Some(&index)) => axis.coordinate(index),
            _ => 0.0,
        }
    }
}
