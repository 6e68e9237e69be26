//! The folder of a run: `result.json` and `film.vtu`, written whole or not at all.

use crate::report::{ReportError, RunResult};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// File of the numbers.
pub const RESULT_FILE: &str = "result.json";
/// File of the fields.
pub const PICTURE_FILE: &str = "film.vtu";

/// Why the results were not written. What stood in the folder before stands there still.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The result holds something that must not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// The system refused.
    #[error("cannot write {}: {source}; choose another folder with --out", path.display())]
    System {
        /// File or folder.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// A folder stands where a file shall go.
    #[error("cannot write {}: a folder stands there; move it away, or choose another folder with --out", path.display())]
    Folder {
        /// The path.
        path: PathBuf,
    },
}

/// Writes `result.json` and, where there is a picture (the bytes of a VTU file), `film.vtu` into the folder `dir`,
/// which is made if need be. Both are written beside their places first and then moved there, the result last. Files
/// of an earlier run are replaced; without a picture an earlier `film.vtu` is removed, since it shows another run.
///
/// # Errors
/// [`WriteError`]: a number is not finite, or the system refuses; the old files are then left as they were.
pub fn write_results(dir: &Path, result: &RunResult, picture: Option<&[u8]>) -> Result<(), WriteError> {
    let json = result.to_json()?;
    let fail = |path: &Path| {
        let path = path.to_path_buf();
        move |source| WriteError::System { path, source }
    };
    let (result_path, picture_path) = (dir.join(RESULT_FILE), dir.join(PICTURE_FILE));
    for path in [&result_path, &picture_path] {
        if path.is_dir() {
            return Err(WriteError::Folder { path: path.clone() });
        }
    }
    fs::create_dir_all(dir).map_err(fail(dir))?;
    let beside = tempfile::Builder::new()
        .prefix(".oilwedge-")
        .tempdir_in(dir)
        .map_err(fail(dir))?;
    let new_result = beside.path().join(RESULT_FILE);
    let new_picture = beside.path().join(PICTURE_FILE);
    write_file(&new_result, json.as_bytes()).map_err(fail(&result_path))?;
    if let Some(bytes) = picture {
        write_file(&new_picture, bytes).map_err(fail(&picture_path))?;
    }

    let old_picture = beside.path().join("old.vtu");
    let had_picture = picture_path.exists();
    if had_picture {
        keep(&picture_path, &old_picture).map_err(fail(&picture_path))?;
    }
    match picture {
        Some(_) => fs::rename(&new_picture, &picture_path).map_err(fail(&picture_path))?,
        None if had_picture => fs::remove_file(&picture_path).map_err(fail(&picture_path))?,
        None => {}
    }
    fs::rename(&new_result, &result_path).map_err(|source| {
        let restored = match had_picture {
            true => fs::rename(&old_picture, &picture_path),
            false if picture.is_some() => fs::remove_file(&picture_path),
            false => Ok(()),
        };
        // Of two refusals the first is told: it is the cause of the second.
        drop(restored);
        WriteError::System {
            path: result_path.clone(),
            source,
        }
    })
}

fn write_file(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = fs::File::create(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

/// A second name for a file; a copy where the file system has no second names.
fn keep(file: &Path, copy: &Path) -> io::Result<()> {
    fs::hard_link(file, copy).or_else(|_| fs::copy(file, copy).map(drop))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::tests::example;

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
        write_results(&dir, &example(), Some(b"first"))?;
        assert_eq!(names(&dir)?, ["film.vtu", "result.json"]);
        write_results(&dir, &example(), Some(b"second"))?;
        assert_eq!(fs::read(dir.join(PICTURE_FILE))?, b"second");
        write_results(&dir, &example(), None)?;
        assert_eq!(names(&dir)?, ["result.json"]);
        Ok(())
    }

    #[test]
    fn a_failure_leaves_what_was_there() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let dir = folder.path().join("out");
        write_results(&dir, &example(), Some(b"first"))?;
        let before = fs::read(dir.join(RESULT_FILE))?;
        let mut bad = example();
        bad.title = "another".into();
        bad.balances.mass = f64::NAN;
        assert!(matches!(
            write_results(&dir, &bad, Some(b"second")),
            Err(WriteError::Report(_))
        ));
        assert_eq!(fs::read(dir.join(PICTURE_FILE))?, b"first");
        assert_eq!(fs::read(dir.join(RESULT_FILE))?, before);

        let taken = folder.path().join("taken");
        fs::create_dir_all(taken.join(RESULT_FILE))?;
        assert!(matches!(
            write_results(&taken, &example(), Some(b"x")),
            Err(WriteError::Folder { .. })
        ));
        assert_eq!(names(&taken)?, ["result.json"]);
        fs::write(folder.path().join("file"), "")?;
        let error = write_results(&folder.path().join("file"), &example(), None).expect_err("a file is no folder");
        assert!(error.to_string().contains("--out"), "{error}");
        Ok(())
    }
}
