//! The terms of Reynolds' equation: a sum of fluxes, one a file.

mod couette;
mod poiseuille;

pub use couette::Couette;
pub use poiseuille::Poiseuille;

use crate::{FilmFlow, FilmPoint};

/// One term of the equation.
pub trait Term: Send + Sync {
    /// Name in reports.
    fn name(&self) -> &'static str;

    /// Adds its flow at a point of the film.
    fn add(&self, film: &FilmPoint, flow: &mut FilmFlow);
}
