//! The folder of a run: `result.json`, `film.vtu` and, of a balance of heat, `heat.svg` and `heat.png`, written whole
//! or not at all.
//!
//! `result.json` stands beside the picture of its own run or not at all: an old one is taken away before the new
//! picture comes, and the new one comes last.

use crate::Error;
use crate::folder::replace;
use crate::frames::{COLLECTION_FILE, remove_frames};
use crate::json::result_json;
use crate::page::PAGE_FILE;
use crate::plot::{TEMPERATURE_FILES, temperature_figure, to_png};
use oilwedge_campaign::Records;
use oilwedge_drawing::{Figure, PAGE_WIDTH};
use oilwedge_scene::Scene;
use oilwedge_study::result::RunResult;
use oilwedge_study::run_options::EarlierOrbit;
use std::ffi::OsStr;
use std::path::Path;

/// File of the numbers.
pub const RESULT_FILE: &str = "result.json";
/// File of the fields.
pub const PICTURE_FILE: &str = "film.vtu";

/// File of the path of the journal over a cycle.
pub const ORBIT_FILE: &str = "orbit.csv";

/// What stands beside `result.json`; `None`: there is none.
#[derive(Debug, Clone, Copy, Default)]
pub struct ResultCompanions<'a> {
    /// Content of `film.vtu`.
    pub picture: Option<&'a [u8]>,
    /// Content of `orbit.csv`.
    pub orbit: Option<&'a [u8]>,
}

/// Writes `result.json` and what stands beside it into the folder `dir`, which is made if need be, and the curves of a
/// balance of heat; returns the names of the files. Files of an earlier run are replaced, and its page and animation
/// are removed; without a picture or curves earlier ones are removed, since they show another run.
///
/// # Errors
/// [`Error`]: a number is not finite, or the system refuses; the old files are then left as they were.
pub fn write_results(
    dir: &Path,
    result: &RunResult,
    records: &Records,
    beside: ResultCompanions,
) -> Result<Vec<String>, Error> {
    let json = result_json(result, records)?;
    let figure = temperature_figure(result, PAGE_WIDTH);
    let svg = figure.as_ref().map(Figure::to_svg);
    let png = figure.as_ref().map(to_png).transpose()?;
    let result = OsStr::new(RESULT_FILE);
    let [svg_file, png_file] = TEMPERATURE_FILES.map(OsStr::new);
    let steps = [
        (result, None),
        (PAGE_FILE.as_ref(), None),
        (COLLECTION_FILE.as_ref(), None),
        (PICTURE_FILE.as_ref(), beside.picture),
        (ORBIT_FILE.as_ref(), beside.orbit),
        (svg_file, svg.as_deref().map(str::as_bytes)),
        (png_file, png.as_deref()),
        (result, Some(json.as_bytes())),
    ];
    replace(dir, &steps)?;
    remove_frames(dir);
    let there = steps[1..steps.len() - 1].iter().filter(|(_, content)| content.is_some());
    let names = std::iter::once(result).chain(there.map(|(name, _)| *name));
    Ok(names.map(|name| name.display().to_string()).collect())
}

/// The orbit of this scene that a run has left in the folder `dir` before it was closed; `None` where there is none.
pub fn earlier_orbit(dir: &Path, scene: &Scene) -> Option<EarlierOrbit> {
    // Of a balance of heat the orbits before were those of other temperatures.
    scene.orbit.as_ref().filter(|_| scene.inlet_temperature().is_none())?;
    let text = std::fs::read(dir.join(RESULT_FILE)).ok()?;
    let RunResult { head, orbit, .. } = serde_json::from_slice(&text).ok()?;
    let is_its_own = head.scene_sha256 == scene.sha256 && head.version == env!("CARGO_PKG_VERSION");
    let orbit = orbit.filter(|orbit| is_its_own && !orbit.closed)?;
    Some(EarlierOrbit { cycles: orbit.cycles.len() + orbit.earlier_cycles, end: orbit.end })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::json::tests::example;
    use std::{fs, io};

    fn pictured(picture: &[u8]) -> ResultCompanions<'_> {
        ResultCompanions { picture: Some(picture), ..ResultCompanions::default() }
    }

    fn names(dir: &Path) -> io::Result<Vec<String>> {
        let mut names = fs::read_dir(dir)?
            .map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()))
            .collect::<io::Result<Vec<_>>>()?;
        names.sort();
        Ok(names)
    }

    #[test]
    fn results_replace_those_of_an_earlier_run() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let dir = folder.path().join("out/study");
        write_results(&dir, &example(), &Records::default(), pictured(b"first"))?;
        assert_eq!(names(&dir)?, ["film.vtu", "result.json"]);
        write_results(&dir, &example(), &Records::default(), pictured(b"second"))?;
        assert_eq!(fs::read(dir.join(PICTURE_FILE))?, b"second");
        write_results(&dir, &example(), &Records::default(), ResultCompanions::default())?;
        assert_eq!(names(&dir)?, ["result.json"]);
        Ok(())
    }

    #[test]
    fn a_failure_leaves_what_was_there() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let dir = folder.path().join("out");
        write_results(&dir, &example(), &Records::default(), pictured(b"first"))?;
        let before = fs::read(dir.join(RESULT_FILE))?;
        let mut bad = example();
        bad.head.title = "another".into();
        bad.balances.mass = f64::NAN;
        assert!(matches!(
            write_results(&dir, &bad, &Records::default(), pictured(b"second")),
            Err(Error::NotFinite { .. })
        ));
        assert_eq!(fs::read(dir.join(PICTURE_FILE))?, b"first");
        assert_eq!(fs::read(dir.join(RESULT_FILE))?, before);

        let taken = folder.path().join("taken");
        fs::create_dir_all(taken.join(RESULT_FILE))?;
        assert!(matches!(
            write_results(&taken, &example(), &Records::default(), pictured(b"x")),
            Err(Error::Folder { .. })
        ));
        assert_eq!(names(&taken)?, ["result.json"]);
        fs::write(folder.path().join("file"), "")?;
        let error =
            write_results(&folder.path().join("file"), &example(), &Records::default(), ResultCompanions::default())
                .expect_err("a file is no folder");
        assert!(error.to_string().contains("file"), "{error}");
        Ok(())
    }
}
