//! A sweep: one scene solved for many values of its keys.
//!
//! Cases are cut into chains of neighbours (`chain.rs`), which are walked along (`walk.rs`): the mesh, its numbering and analysis stay as
//! long as they fit, films and positions begin where those before lead.

mod chain;
mod walk;

use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};

use oilwedge_scene::sweep::Plan;
use oilwedge_scene::{Scene, SceneError};
use oilwedge_study::CHECKS;
use oilwedge_study::CompileError;
use oilwedge_study::compile::compile;
use oilwedge_study::effects::Effects;
use oilwedge_study::refinement::at_first;
use oilwedge_study::run_options::RunOptions;

use crate::Error;
use chain::chains;
use walk::Walker;
pub use walk::{CaseStatus, Found};

/// A sweep that can be run: every case is a good scene.
pub struct Sweep {
    /// The axes.
    pub plan: Plan,
    /// The scene of each case.
    pub scenes: Vec<Scene>,
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
        let Some(plan) = &scene.sweep else { return Ok(None) };
        Ok(Some(Self {
            scenes: plan.scenes(&CHECKS)?,
            plan: plan.clone(),
            title: scene.title.clone(),
            scene_sha256: scene.sha256.clone(),
        }))
    }

    /// What is simulated in the first case, and what is not.
    ///
    /// # Errors
    /// The first case does not become a film.
    pub fn effects(&self) -> Result<Effects, CompileError> {
        let first = self.scenes.first().map(|first| compile(&at_first(first))).transpose()?;
        Ok(first.map_or_else(Effects::default, |film| Effects::of(&film.scene)))
    }

    /// Runs all cases but those that `is_kept`, on all threads, and hands on each when it ends.
    ///
    /// # Errors
    /// Threads cannot be started, or the first error of `ended`.
    pub fn run<E: From<Error>>(
        &self,
        options: &RunOptions,
        is_kept: &dyn Fn(usize) -> bool,
        ended: &mut dyn FnMut(usize, Found) -> Result<(), E>,
    ) -> Result<(), E> {
        // A case starts from its neighbours, so a chain that was not finished is walked along from its beginning.
        let chains: Vec<Range<usize>> = (chains(&self.plan).into_iter())
            .filter(|chain| !chain.clone().all(is_kept))
            .collect();
        let threads = rayon::current_num_threads();
        let workers = threads.min(chains.len());
        let next = AtomicUsize::new(0);
        let (sender, receiver) = channel();
        std::thread::scope(|scope| {
            for _ in 0..workers {
                // Threads of its own: a worker that waits for a part of its film does not take up another chain meanwhile.
                let pool = rayon::ThreadPoolBuilder::new()
                    .num_threads(threads / workers)
                    .build()
                    .map_err(|error| Error::Threads(error.to_string()))?;
                let (sender, next, chains) = (sender.clone(), &next, &chains);
                scope.spawn(move || pool.install(|| self.work(chains, next, options, &sender)));
            }
            drop(sender);
            // Where a row cannot be written the receiver goes away, and the workers end.
            let receiver = receiver;
            receiver.iter().try_for_each(|(case, found)| match is_kept(case) {
                true => Ok(()),
                false => ended(case, found),
            })
        })
    }

    fn work(&self, chains: &[Range<usize>], next: &AtomicUsize, options: &RunOptions, sender: &Sender<(usize, Found)>) {
        let mut walker = Walker::new(options);
        while let Some(chain) = chains.get(next.fetch_add(1, Ordering::Relaxed)) {
            walker.begin();
            for case in chain.clone() {
                let coordinate = self.coordinate(case);
                let found = walker.case(&self.scenes[case], coordinate);
                // A case that was ended is none.
                if options.interrupt.is_asked() || sender.send((case, found)).is_err() {
                    return;
                }
            }
        }
    }

    /// Place of a case on the axis along which chains run.
    fn coordinate(&self, case: usize) -> f64 {
        let indices = self.plan.indices(case);
        match (self.plan.axes.last(), indices.last()) {
            (Some(axis), Some(&index)) => axis.coordinate(index),
            _ => 0.0,
        }
    }
}
