//! Films at even crank angles of the last cycle, drawn one after the other: an animation.

use oilwedge_bearing::orbit::{Motion, PathStep, Span};
use oilwedge_reynolds::JournalState;
use rayon::prelude::*;

use super::sample;
use crate::film::Film;
use crate::no_answer::NoAnswer;
use crate::picture::{FilmPicture, Surface, picture};
use crate::run_options::RunOptions;
use crate::solved::Errors;

/// Name of the line along the axis of the journal, from end to end of the bearing.
const JOURNAL_AXIS: &str = "journal_axis";

/// A film of the cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// Crank angle [deg].
    pub crank_angle: f64,
    /// The film; on the cylinder with the axis of the journal among its lines.
    pub picture: FilmPicture,
}

/// The films that are asked for, over a period [s], by the step before a time and the path from it.
///
/// # Errors
/// [`NoAnswer`]: there is no film at one of the crank angles.
pub(super) fn frames<'a>(
    (film, motion): (&Film, &Motion),
    period: f64,
    around: &(dyn Fn(f64) -> Option<(&'a PathStep, Span)> + Sync),
    options: &RunOptions,
) -> Result<Vec<Frame>, NoAnswer> {
    let frame = |k: u32| {
        let time = period * f64::from(k) / f64::from(options.frames);
        let solved = sample::solved_at(film, motion, around(time), time, Errors::Omitted)?;
        let mut picture = picture(&solved.film, &solved.primary, None, options.picture);
        if options.picture.surface == Surface::Cylinder {
            let axis = axis(&solved.film.problem.journal, film.problem.bearing.length);
            picture.lines.push((JOURNAL_AXIS.to_owned(), vec![axis]));
        }
        Ok(Frame { crank_angle: (motion.cycle.angular_speed() * time).to_degrees(), picture })
    };
    (0..options.frames).into_par_iter().map(frame).collect()
}

/// Both ends of the axis of a journal [m].
fn axis(journal: &JournalState, length: f64) -> [[f64; 3]; 2] {
    [-0.5 * length, 0.5 * length].map(|z| {
        let [x, y] = [0, 1].map(|d| journal.offset[d] + z * journal.tilt[d]);
        [x, y, z]
    })
}
