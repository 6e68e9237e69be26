//! A shaft as pictures and pages show it: its numbers and the course of each journal over a cycle, from a run or from
//! the files of its folder.

use std::path::Path;

use oilwedge_scene::ShaftScene;
use oilwedge_study::shaft::{BearingReport, ShaftResult, ShaftRun, Variant};

use crate::Error;
use crate::orbit_course::OrbitCourse;
use crate::shaft::{ShaftBeside, path_file, result_file};

/// One shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftView {
    /// Everything in `result.json`.
    pub result: ShaftResult,
    /// The journals over the last cycle; none at rest.
    pub courses: Vec<OrbitCourse>,
}

/// The shaft of a scene, and those beside it.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftViews {
    /// The shaft of the scene itself.
    pub own: ShaftView,
    /// The others.
    pub beside: Vec<(Variant, ShaftView)>,
}

impl ShaftViews {
    /// The views of runs.
    pub fn of_runs(run: &ShaftRun, beside: &[ShaftBeside]) -> Self {
        let others = beside.iter().map(|(variant, run)| (*variant, ShaftView::of_run(run)));
        Self { own: ShaftView::of_run(run), beside: others.collect() }
    }

    /// The views in a folder of results.
    ///
    /// # Errors
    /// [`Error`]: a file cannot be read.
    pub fn read(dir: &Path) -> Result<Self, Error> {
        let is_there = |variant: &Variant| dir.join(result_file(Some(*variant))).is_file();
        let there = Variant::ALL.into_iter().filter(is_there);
        let beside = there.map(|variant| Ok((variant, ShaftView::read(dir, Some(variant))?)));
        Ok(Self { own: ShaftView::read(dir, None)?, beside: beside.collect::<Result<_, Error>>()? })
    }
}

impl ShaftView {
    fn of_run(run: &ShaftRun) -> Self {
        let courses = run.paths.iter().map(|path| OrbitCourse::of_path(&path.path));
        Self { result: run.result.clone(), courses: courses.collect() }
    }

    fn read(dir: &Path, variant: Option<Variant>) -> Result<Self, Error> {
        let bytes = |name: String| {
            let path = dir.join(name);
            std::fs::read(&path).map_err(|source| Error::System { path, source })
        };
        let result: ShaftResult =
            serde_json::from_slice(&bytes(result_file(variant))?).map_err(Error::format("JSON"))?;
        let is_of_cycle = result.bearings.first().is_some_and(|bearing| bearing.energy.is_some());
        let courses = (0..result.bearings.len()).filter(|_| is_of_cycle);
        let courses = courses.map(|number| OrbitCourse::from_csv(&bytes(path_file(variant, number))?));
        Ok(Self { courses: courses.collect::<Result<_, Error>>()?, result })
    }

    /// The scene; nothing where its text is none of a crankshaft.
    pub fn scene(&self) -> Option<ShaftScene> {
        ShaftScene::parse(&self.result.head.scene, Path::new("scene.toml")).ok()
    }

    /// Bearings of the shaft along the axis.
    pub fn bearings(&self) -> &[BearingReport] {
        &self.result.bearings
    }

    /// The journals over the cycle, with the names of their bearings.
    pub fn journals(&self) -> impl Iterator<Item = (&str, &OrbitCourse)> {
        self.bearings().iter().map(|bearing| bearing.name.as_str()).zip(&self.courses)
    }
}
