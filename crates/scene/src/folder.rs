//! Files of one folder that are replaced together, whole or not at all.

use std::fs;
use std::io;
use std::path::Path;

use crate::results::WriteError;

/// Writes files into the folder `dir`, which is made if need be, and removes those without content. All are written beside
/// their places first and then moved there in their order, so the last is the sign that all are there. A program that is
/// ended leaves the old files or the new ones. The disk is not waited for: it may take longer than the whole run, and what a
/// machine loses that fails in the next seconds is computed again sooner.
///
/// # Errors
/// [`WriteError`]: the system refuses, or a folder stands in the place of a file; the old files are then left as they were.
pub fn replace(dir: &Path, files: &[(&str, Option<&[u8]>)]) -> Result<(), WriteError> {
    let fail = |path: &Path| {
        let path = path.to_path_buf();
        move |source| WriteError::System { path, source }
    };
    check(dir, files.iter().map(|(name, _)| *name))?;
    fs::create_dir_all(dir).map_err(fail(dir))?;
    let beside = tempfile::Builder::new()
        .prefix(".oilwedge-")
        .tempdir_in(dir)
        .map_err(fail(dir))?;
    let (new, old) = (beside.path().join("new"), beside.path().join("old"));
    for folder in [&new, &old] {
        fs::create_dir(folder).map_err(fail(dir))?;
    }
    for (name, content) in files {
        let path = dir.join(name);
        if let Some(bytes) = content {
            fs::write(new.join(name), bytes).map_err(fail(&path))?;
        }
        if path.exists() {
            keep(&path, &old.join(name)).map_err(fail(&path))?;
        }
    }
    for (done, (name, content)) in files.iter().enumerate() {
        let path = dir.join(name);
        let moved = match content {
            Some(_) => fs::rename(new.join(name), &path),
            None if path.exists() => fs::remove_file(&path),
            None => Ok(()),
        };
        if let Err(source) = moved {
            for (name, _) in &files[..done] {
                restore(&old.join(name), &dir.join(name));
            }
            return Err(WriteError::System { path, source });
        }
    }
    Ok(())
}

/// Whether files of these names may stand in the folder `dir`, as far as that can be told without writing.
///
/// # Errors
/// [`WriteError`]: `dir` is no folder, or a folder stands in the place of a file.
pub(crate) fn check<'a>(dir: &Path, mut names: impl Iterator<Item = &'a str>) -> Result<(), WriteError> {
    if dir.exists() && !dir.is_dir() {
        return Err(WriteError::System {
            path: dir.to_path_buf(),
            source: io::ErrorKind::NotADirectory.into(),
        });
    }
    match names.find(|name| dir.join(name).is_dir()) {
        Some(name) => Err(WriteError::Folder { path: dir.join(name) }),
        None => Ok(()),
    }
}

/// Puts back what stood there, or nothing. Of two refusals the first is told: it is the cause of this one.
fn restore(old: &Path, place: &Path) {
    let restored = match old.exists() {
        true => fs::rename(old, place),
        false => fs::remove_file(place),
    };
    drop(restored);
}

/// A second name for a file; a copy where the file system has no second names.
fn keep(file: &Path, copy: &Path) -> io::Result<()> {
    fs::hard_link(file, copy).or_else(|_| fs::copy(file, copy).map(drop))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_replaced_together_and_others_stay() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let dir = folder.path().join("a/b");
        replace(&dir, &[("one", Some(b"1")), ("two", Some(b"2"))])?;
        fs::write(dir.join("mine"), "mine")?;
        replace(&dir, &[("one", None), ("two", Some(b"3")), ("three", Some(b"4"))])?;
        let mut names = fs::read_dir(&dir)?
            .map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()))
            .collect::<io::Result<Vec<_>>>()?;
        names.sort();
        assert_eq!(names, ["mine", "three", "two"]);
        assert_eq!(fs::read(dir.join("two"))?, b"3");
        fs::create_dir(dir.join("one"))?;
        let refused = replace(&dir, &[("two", Some(b"5")), ("one", Some(b"6"))]);
        assert!(matches!(refused, Err(WriteError::Folder { .. })));
        assert_eq!(fs::read(dir.join("two"))?, b"3");
        Ok(())
    }
}
