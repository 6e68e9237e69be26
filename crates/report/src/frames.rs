//! The animation of a cycle: `film.pvd`, which ParaView and PyVista open, and a VTU file for each crank angle in the
//! folder `frames`.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::Path;

use oilwedge_study::orbit::Frame;
use rayon::prelude::*;

use crate::Error;
use crate::folder::replace;
use crate::vtu::{VtuForm, to_vtu};

/// File that names the frames and their crank angles.
pub const COLLECTION_FILE: &str = "film.pvd";
/// Folder of the frames.
pub const FRAMES_FOLDER: &str = "frames";

/// Writes the frames of a cycle into the folder `dir`, the collection last; those of an earlier run are removed.
///
/// # Errors
/// [`Error`]: a picture cannot be written, or the system refuses.
pub fn write_frames(dir: &Path, frames: Vec<Frame>, form: VtuForm) -> Result<(), Error> {
    let collection = collection(&frames);
    let files: Vec<(OsString, Vec<u8>)> = frames
        .into_par_iter()
        .enumerate()
        .map(|(number, frame)| Ok((name(number).into(), to_vtu(&frame.picture, form)?)))
        .collect::<Result<_, Error>>()?;
    replace(dir, &[(OsStr::new(COLLECTION_FILE), None)])?;
    remove_frames(dir);
    let steps: Vec<(&OsStr, Option<&[u8]>)> =
        files.iter().map(|(name, bytes)| (name.as_os_str(), Some(&bytes[..]))).collect();
    replace(&dir.join(FRAMES_FOLDER), &steps)?;
    replace(dir, &[(OsStr::new(COLLECTION_FILE), Some(collection.as_bytes()))])
}

/// Removes the frames of an earlier run, and their folder where nothing else is in it. What cannot be removed does no
/// harm: no collection names it.
pub(crate) fn remove_frames(dir: &Path) {
    let folder = dir.join(FRAMES_FOLDER);
    let mut number = 0;
    while fs::remove_file(folder.join(name(number))).is_ok() {
        number += 1;
    }
    drop(fs::remove_dir(folder));
}

fn name(number: usize) -> String {
    format!("film_{number:04}.vtu")
}

/// The collection: a data set for each crank angle [deg], which takes the place of the time.
fn collection(frames: &[Frame]) -> String {
    let entry = |(number, frame): (usize, &Frame)| {
        format!("<DataSet timestep=\"{}\" part=\"0\" file=\"{FRAMES_FOLDER}/{}\"/>\n", frame.crank_angle, name(number))
    };
    let entries: String = frames.iter().enumerate().map(entry).collect();
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n<Collection>\n{entries}</Collection>\n</VTKFile>\n"
    )
}
