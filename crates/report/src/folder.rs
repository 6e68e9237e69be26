//! Files of one folder that are replaced together, whole or not at all.
//!
//! A run that is killed leaves the files of before or the new ones, and perhaps a folder `.oilwedge-...` beside them,
//! which the next run takes away. Runs that write into one folder wait for each other while they do, by a lock on the
//! folder that the system releases when its holder ends, however it ends. Where the file system has no locks (some
//! network drives, Windows) runs must not share a folder, and what a killed one leaves stays.

use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::Path;
use std::time::{Duration, Instant};

use crate::Error;

/// Folders in which files wait for their place begin so.
const BESIDE: &str = ".oilwedge-";
/// How long another run is waited for that writes into the same folder.
const LONGEST_WAIT: Duration = Duration::from_secs(10);
/// Time between two looks whether the other run has ended.
const LOOK: Duration = Duration::from_millis(2);

/// Replaces and removes files of the folder `dir`, which is made if need be, step by step in this order: a name and its
/// new content, or `None` to remove it. All contents are written beside their places first, so that what may fail has
/// been done when the first file is touched. A file whose presence shows that others are there is removed in the first
/// step and comes in the last. The disk is not waited for: it may take longer than the whole run, and what a machine
/// loses that fails in the next seconds is computed again sooner.
///
/// # Errors
/// [`Error`]: the system refuses, or a folder stands in the place of a file; the old files are then left as they were.
pub fn replace(dir: &Path, steps: &[(&OsStr, Option<&[u8]>)]) -> Result<(), Error> {
    check(dir, steps.iter().map(|(name, _)| *name))?;
    fs::create_dir_all(dir).map_err(Error::system(dir))?;
    let _lock = alone_in(dir)?;
    replace_alone(dir, steps)
}

/// Replaces files as [`replace`] does, for a run that holds the lock of the folder ([`alone_in`]).
///
/// # Errors
/// As [`replace`].
pub fn replace_alone(dir: &Path, steps: &[(&OsStr, Option<&[u8]>)]) -> Result<(), Error> {
    let beside = tempfile::Builder::new().prefix(BESIDE).tempdir_in(dir).map_err(Error::system(dir))?;
    let (new, old) = (beside.path().join("new"), beside.path().join("old"));
    for folder in [&new, &old] {
        fs::create_dir(folder).map_err(Error::system(dir))?;
    }
    for (name, content) in steps {
        let path = dir.join(name);
        if let Some(bytes) = content {
            fs::write(new.join(name), bytes).map_err(Error::system(&path))?;
        }
        if stands(&path) && !stands(&old.join(name)) {
            keep(&path, &old.join(name)).map_err(Error::system(&path))?;
        }
    }
    for (done, (name, content)) in steps.iter().enumerate() {
        let path = dir.join(name);
        let moved = match content {
            Some(_) => fs::rename(new.join(name), &path),
            None if stands(&path) => fs::remove_file(&path),
            None => Ok(()),
        };
        if let Err(source) = moved {
            let mut undone = Vec::new();
            for (name, _) in steps[..done].iter().rev() {
                if !undone.contains(name) {
                    restore(&old.join(name), &dir.join(name));
                    undone.push(*name);
                }
            }
            return Err(Error::System { path, source });
        }
    }
    Ok(())
}

/// Waits until no other run writes into the folder `dir`, keeps others out as long as the lock is held, and takes away
/// what runs that were killed have left. `None` where the file system has no locks.
///
/// # Errors
/// [`Error::Busy`]: another run keeps writing there.
pub fn alone_in(dir: &Path) -> Result<Option<File>, Error> {
    let Ok(folder) = File::open(dir) else { return Ok(None) };
    let clock = Instant::now();
    loop {
        match folder.try_lock() {
            Ok(()) => break,
            Err(TryLockError::WouldBlock) if clock.elapsed() < LONGEST_WAIT => std::thread::sleep(LOOK),
            Err(TryLockError::WouldBlock) => {
                return Err(Error::Busy { path: dir.to_path_buf() });
            }
            Err(TryLockError::Error(_)) => return Ok(None),
        }
    }
    for entry in fs::read_dir(dir).into_iter().flatten().flatten() {
        if entry.file_name().to_string_lossy().starts_with(BESIDE) {
            // Left by a dead run, for living ones hold the lock. Where it cannot be removed it does no harm.
            drop(fs::remove_dir_all(entry.path()));
        }
    }
    Ok(Some(folder))
}

/// Whether files of these names may stand in the folder `dir`, as far as that is known without writing.
///
/// # Errors
/// [`Error`]: `dir` is no folder, or a folder stands in the place of a file.
pub fn check<'a>(dir: &Path, mut names: impl Iterator<Item = &'a OsStr>) -> Result<(), Error> {
    if stands(dir) && !dir.is_dir() {
        return Err(Error::System { path: dir.to_path_buf(), source: io::ErrorKind::NotADirectory.into() });
    }
    match names.find(|name| dir.join(name).is_dir()) {
        Some(name) => Err(Error::Folder { path: dir.join(name) }),
        None => Ok(()),
    }
}

/// Whether there is anything of this name, also a link that leads nowhere.
fn stands(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

/// Puts back what stood there, or nothing. Of two refusals the first is reported: it is the cause of the second.
fn restore(old: &Path, place: &Path) {
    let restored = match stands(old) {
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

    type Outcome = Result<(), Box<dyn std::error::Error>>;

    fn put(dir: &Path, steps: &[(&str, Option<&[u8]>)]) -> Result<(), Error> {
        let steps: Vec<_> = steps.iter().map(|(name, content)| (OsStr::new(*name), *content)).collect();
        replace(dir, &steps)
    }

    fn names(dir: &Path) -> io::Result<Vec<String>> {
        let mut names = fs::read_dir(dir)?
            .map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()))
            .collect::<io::Result<Vec<_>>>()?;
        names.sort();
        Ok(names)
    }

    #[test]
    fn files_are_replaced_together_and_others_stay() -> Outcome {
        let folder = tempfile::tempdir()?;
        let dir = folder.path().join("a/b");
        put(&dir, &[("one", Some(b"1")), ("two", Some(b"2"))])?;
        fs::write(dir.join("mine"), "mine")?;
        put(&dir, &[("two", None), ("one", None), ("three", Some(b"4")), ("two", Some(b"3"))])?;
        assert_eq!(names(&dir)?, ["mine", "three", "two"]);
        assert_eq!(fs::read(dir.join("two"))?, b"3");
        fs::create_dir(dir.join("one"))?;
        let refused = put(&dir, &[("two", Some(b"5")), ("one", Some(b"6"))]);
        assert!(matches!(refused, Err(Error::Folder { .. })));
        assert_eq!(fs::read(dir.join("two"))?, b"3");
        Ok(())
    }

    #[test]
    fn a_step_that_fails_puts_back_those_before() -> Outcome {
        let folder = tempfile::tempdir()?;
        let dir = folder.path();
        put(dir, &[("one", Some(b"1")), ("two", Some(b"2"))])?;
        let beside = alone_in(dir)?;
        // A folder appears in the place of a file after the check.
        fs::create_dir(dir.join("three"))?;
        let steps: [(&OsStr, Option<&[u8]>); 4] = [
            ("two".as_ref(), None),
            ("one".as_ref(), Some(b"3")),
            ("two".as_ref(), Some(b"4")),
            ("three".as_ref(), None),
        ];
        assert!(replace_alone(dir, &steps).is_err());
        drop(beside);
        assert_eq!(names(dir)?, ["one", "three", "two"]);
        assert_eq!((fs::read(dir.join("one"))?, fs::read(dir.join("two"))?), (b"1".into(), b"2".into()));
        Ok(())
    }

    #[test]
    fn what_a_killed_run_left_is_taken_away() -> Outcome {
        let folder = tempfile::tempdir()?;
        let dir = folder.path();
        fs::create_dir_all(dir.join(".oilwedge-dead/new"))?;
        fs::write(dir.join(".oilwedge-dead/new/one"), "half")?;
        put(dir, &[("one", Some(b"1"))])?;
        assert_eq!(names(dir)?, ["one"]);
        Ok(())
    }

    #[test]
    fn runs_wait_for_each_other() -> Outcome {
        let folder = tempfile::tempdir()?;
        let dir = folder.path();
        let held = alone_in(dir)?;
        assert!(held.is_some(), "no locks here");
        std::thread::scope(|scope| {
            let other = scope.spawn(|| put(dir, &[("one", Some(b"other"))]));
            std::thread::sleep(20 * LOOK);
            assert!(!dir.join("one").exists());
            drop(held);
            other.join().expect("no panic")
        })?;
        assert!(dir.join("one").exists());
        Ok(())
    }
}
