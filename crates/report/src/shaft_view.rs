//! A shaft as pictures and pages show it: its numbers and the course of each journal over a cycle, from a run or from
//! the files of its folder.

use std::path::Path;

use oilwedge_scene::ShaftScene;
use oilwedge_study::quantities::Row;
use oilwedge_study::shaft::{SHAFT_FORMAT, ShaftRun, Variant};
use serde_json::Value;

use crate::Error;
use crate::orbit_course::OrbitCourse;
use crate::shaft::{ShaftBeside, path_file, result_file};

/// One shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct ShaftView {
    /// The object of `result.json`.
    pub result: Value,
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

/// Whether an object of `result.json` is that of a crankshaft.
pub fn is_of_shaft(result: &Value) -> bool {
    result["format"] == SHAFT_FORMAT
}

impl ShaftViews {
    /// The views of runs.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn of_runs(run: &ShaftRun, beside: &[ShaftBeside]) -> Result<Self, Error> {
        let others = beside.iter().map(|(variant, run)| Ok((*variant, ShaftView::of_run(run)?)));
        Ok(Self { own: ShaftView::of_run(run)?, beside: others.collect::<Result<_, Error>>()? })
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
    fn of_run(run: &ShaftRun) -> Result<Self, Error> {
        Ok(Self {
            result: serde_json::to_value(&run.result).map_err(Error::format("JSON"))?,
            courses: run.paths.iter().map(|path| OrbitCourse::of_path(&path.path)).collect(),
        })
    }

    fn read(dir: &Path, variant: Option<Variant>) -> Result<Self, Error> {
        let bytes = |name: String| {
            let path = dir.join(name);
            std::fs::read(&path).map_err(|source| Error::System { path, source })
        };
        let result: Value = serde_json::from_slice(&bytes(result_file(variant))?).map_err(Error::format("JSON"))?;
        let is_of_cycle = result["bearings"][0]["energy"].is_number();
        let count = result["bearings"].as_array().map_or(0, Vec::len);
        let courses = (0..count).filter(|_| is_of_cycle);
        let courses = courses.map(|number| OrbitCourse::from_csv(&bytes(path_file(variant, number))?));
        Ok(Self { courses: courses.collect::<Result<_, Error>>()?, result })
    }

    /// The scene; nothing where its text is none of a crankshaft.
    pub fn scene(&self) -> Option<ShaftScene> {
        ShaftScene::parse(self.result["scene"].as_str()?, Path::new("scene.toml")).ok()
    }

    /// Title of the shaft.
    pub fn title(&self) -> &str {
        self.result["title"].as_str().unwrap_or_default()
    }

    /// Bearings of the shaft along the axis, as objects.
    pub fn bearings(&self) -> &[Value] {
        self.result["bearings"].as_array().map_or(&[], Vec::as_slice)
    }

    /// The journals over the cycle, with the names of their bearings.
    pub fn journals(&self) -> impl Iterator<Item = (&str, &OrbitCourse)> {
        let names = self.bearings().iter().map(|bearing| bearing["name"].as_str().unwrap_or_default());
        names.zip(&self.courses)
    }
}

/// A number of a bearing and its error bar.
pub fn number_of(bearing: &Value, row: &Row) -> Option<(f64, Option<f64>)> {
    let it = &bearing["quantities"][row.name];
    Some((it["value"].as_f64()?, it["error"].as_f64()))
}
