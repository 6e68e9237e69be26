//! What a page shows before all else, as its analysis asks it.

use oilwedge_drawing::PAGE_WIDTH;
use serde::Serialize;

use super::{PageFigure, drawn};
use crate::orbit_course::OrbitCourse;
use crate::plot::{film_over_cycle, path_and_load};
use crate::sheet::Sheet;

/// What a page leads with.
#[derive(Debug, Default, Serialize)]
pub(super) struct Lead {
    pub(super) title: &'static str,
    pub(super) words: Vec<String>,
    /// Figures side by side, as far as they fit.
    pub(super) beside: Vec<PageFigure>,
    /// A figure a row.
    pub(super) figures: Vec<PageFigure>,
    pub(super) table: Option<Sheet>,
}

impl Lead {
    /// What an orbit asks: the film over the crank angle, the path, and what the film carries.
    pub(super) fn of_cycle(title: &str, course: &OrbitCourse) -> Self {
        let narrow = path_and_load(title, course, 0.5 * PAGE_WIDTH);
        Self {
            title: "The cycle",
            beside: drawn(&narrow),
            figures: drawn(&film_over_cycle(title, course, PAGE_WIDTH)),
            ..Self::default()
        }
    }
}
