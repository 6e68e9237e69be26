//! A sweep is run: chains of cases on all threads, rows written as they end.

use std::ffi::OsStr;
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::time::Instant;

use sha2::{Digest, Sha256};

use super::Plan;
use super::chain::chains;
use super::files::{REPORT_FILE, TABLE_FILE, Table, finish};
use super::report::{Identity, SWEEP_FORMAT, SweepReport};
use super::table::Columns;
use super::walk::{Found, Walker};
use crate::compile::{CompileError, compile};
use crate::refinement::at_first;
use crate::run::{Error, RunOptions};
use crate::scene::Scene;
use crate::{SceneError, folder};

/// How a sweep is run.
#[derive(Debug, Clone, Copy, Default)]
pub struct SweepOptions {
    /// How each case is run; limits are those of one case.
    pub case: RunOptions,
    /// Replace a sweep that stands in the folder, whatever it is.
    pub fresh: bool,
}

/// How far a sweep has got.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Cases that earlier runs had computed.
    pub kept: usize,
    /// Cases that are computed, those included.
    pub done: usize,
    /// All cases.
    pub cases: usize,
}

/// A sweep that can be run: every case is a good scene.
pub struct Sweep {
    plan: Plan,
    scenes: Vec<Scene>,
    title: String,
    scene_sha256: String,
}

impl Sweep {
    /// The sweep of a scene; `None` where it has none.
    ///
    /// # Errors
    /// Everything that is wrong with a case.
    pub fn of(scene: &Scene) -> Result<Option<Self>, SceneError> {
        let Some(plan) = &scene.sweep else { return Ok(None) };
        Ok(Some(Self {
            scenes: plan.scenes()?,
            plan: plan.clone(),
            title: scene.title.clone(),
            scene_sha256: scene.sha256.clone(),
        }))
    }

    /// Runs all cases and writes them to the folder `dir`. Rows that stand there from an earlier run of the same sweep are kept.
    ///
    /// # Errors
    /// The first case does not become a film, another sweep stands in the folder, or it cannot be written; or the sweep was
    /// interrupted, with its rows kept: [`Error::Interrupted`].
    pub fn run(
        &self,
        options: &SweepOptions,
        dir: &Path,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<SweepReport, Error> {
        let clock = Instant::now();
        let Some(first) = self.scenes.first() else {
            return Err(Error::NoCases);
        };
        folder::check(dir, [TABLE_FILE, REPORT_FILE].iter().map(OsStr::new))?;
        let effects = compile(&at_first(first))?.effects;
        let identity = Identity {
            format: SWEEP_FORMAT.to_owned(),
            title: self.title.clone(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            scene_sha256: self.scene_sha256.clone(),
            mesh_sha256: meshes_sha256(&self.scenes)?,
            bars: options.case.bars,
            cases: self.scenes.len(),
        };
        let columns = Columns::new(&self.plan, &self.scenes, options.case.bars);
        let chains = chains(&self.plan);
        let (mut table, mut rows) = Table::open(dir, &identity, &columns, options.fresh)?;
        let mut told = Progress {
            kept: rows.len(),
            done: rows.len(),
            cases: self.scenes.len(),
        };
        progress(told);
        // A case starts from its neighbours, so a chain that was not finished is walked along from its beginning.
        let left: Vec<Range<usize>> = (chains.into_iter())
            .filter(|chain| !chain.clone().all(|case| rows.contains_key(&case)))
            .collect();
        self.walk(&left, &options.case, &mut |case, found| {
            if rows.contains_key(&case) {
                return Ok(());
            }
            let row = columns.row(&self.plan, case, &found)?;
            table.add(&row)?;
            rows.insert(case, row);
            told.done += 1;
            progress(told);
            Ok(())
        })?;
        if told.done < told.cases {
            return Err(Error::Interrupted {
                done: told.done,
                cases: told.cases,
                table: dir.join(TABLE_FILE),
            });
        }
        let report = SweepReport {
            identity,
            effects,
            plan: self.plan.clone(),
            columns,
            rows: rows.into_values().collect(),
            kept: told.kept,
            seconds: clock.elapsed().as_secs_f64(),
        };
        finish(dir, &report)?;
        Ok(report)
    }

    /// Walks along the chains, as many at once as there are threads, and hands on each case when it ends.
    fn walk(
        &self,
        chains: &[Range<usize>],
        options: &RunOptions,
        ended: &mut dyn FnMut(usize, Found) -> Result<(), Error>,
    ) -> Result<(), Error> {
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
                let (sender, next) = (sender.clone(), &next);
                scope.spawn(move || pool.install(|| self.work(chains, next, options, &sender)));
            }
            drop(sender);
            // Where a row cannot be written the receiver goes away, and the workers end.
            let receiver = receiver;
            receiver.iter().try_for_each(|(case, found)| ended(case, found))
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

/// SHA-256 of all mesh files, each once; `None` where there are none.
fn meshes_sha256(scenes: &[Scene]) -> Result<Option<String>, Error> {
    let mut paths: Vec<&Path> = scenes.iter().filter_map(|scene| scene.mesh.path()).collect();
    paths.dedup();
    paths.sort_unstable();
    paths.dedup();
    let mut hash = Sha256::new();
    for path in &paths {
        let bytes = oilwedge_mesh::gmsh::read_bytes(path).map_err(CompileError::from)?;
        hash.update(Sha256::digest(&bytes));
    }
    let digest = hash.finalize();
    Ok((!paths.is_empty()).then(|| digest.iter().map(|byte| format!("{byte:02x}")).collect()))
}
