//! The wall of the liner: how it gives way to the pressure of the film.
//!
//! Reading order: `spline.rs` and [`grid`] (where forces and deflections live), `pressing.rs` and `touching.rs` (forces
//! of the film and of contact), [`compliance`] (what makes one of the other), `gap_tangent.rs` (how a film answers to a
//! deflection), [`Wall`]; [`crate::film_thickness::Deflection`] adds the deflection to the gap. What closes around film
//! and wall is in the crate `bearing`.

mod blocks;
pub mod compliance;
mod dense;
mod gap_tangent;
pub mod grid;
pub(crate) mod pressing;
pub mod spline;
mod touching;

pub use compliance::Compliance;
pub use dense::Dense;
pub use gap_tangent::GapTangent;
pub use grid::Grid;
pub(crate) use pressing::Pressing;
pub use spline::{Along, Around};
pub use touching::ContactTangent;

use std::sync::Arc;

use crate::quantities::contact_points::ContactPoints;
use crate::supply::{BoundaryKind, SupplyRegion};
use crate::{Bearing, FilmProblem, FilmSystem};

/// Splines around the liner, and cells along it, of walls without a grid of their own.
const AROUND: usize = 180;
const ALONG: usize = 20;
/// Part of the difference between grids of the whole and of twice the width of cells by which the finer one is off:
/// splines gain a factor of eight or, where the pressure has a kink, four.
const OF_COARSER: f64 = 0.25;

/// A wall that gives way.
#[derive(Debug, Clone)]
pub struct Wall {
    /// Grid on which forces and deflections live.
    pub grid: Grid,
    /// What makes deflections of forces.
    pub compliance: Compliance,
    /// This wall on a grid of half as many cells each way; none where the grid is given with the wall.
    pub coarser: Option<Arc<Wall>>,
}

impl Wall {
    /// Slices of the liner of a bearing that move by `by_wave(n)` [m/Pa] under a pressure `cos(n phi)`; none in a
    /// bearing without length.
    pub fn of_slices(bearing: &Bearing, by_wave: impl Fn(usize) -> f64) -> Option<Self> {
        let on = |parts: usize| {
            let cells = ALONG / parts;
            let [low, high] = bearing.ends();
            // Finer towards the ends, where the pressure of a thin film falls within a short way.
            let part = |k: usize| 0.5 - 0.5 * (std::f64::consts::PI * k as f64 / cells as f64).cos();
            let breaks: Vec<f64> = (0..=cells).map(|k| low + (high - low) * part(k)).collect();
            let grid = Grid {
                radius: bearing.radius,
                around: Around::centred(AROUND / parts, 0.0),
                along: Along::on_breaks(&breaks),
            };
            let compliance = Compliance::of_slices((grid.radius, &grid.around, &grid.along), &by_wave)?;
            Some((grid, compliance))
        };
        let [(grid, compliance), (coarse, coarsely)] = [on(1)?, on(2)?];
        Some(Self {
            grid,
            compliance,
            coarser: Some(Arc::new(Self { grid: coarse, compliance: coarsely, coarser: None })),
        })
    }

    /// A matrix of displacements for unit forces at `points` [m] along the liner of a bearing for each of `angles`
    /// equally spaced ones from `first` [rad] on; none where it does not fit.
    pub fn of_matrix(
        bearing: &Bearing,
        (first, angles): (f64, usize),
        points: &[f64],
        displacements: Dense,
    ) -> Option<Self> {
        let grid = Grid {
            radius: bearing.radius,
            around: Around::centred(angles, first),
            along: Along::through(points, bearing.ends()),
        };
        let compliance = Compliance::of_matrix((&grid.around, &grid.along), points, displacements)?;
        Some(Self { grid, compliance, coarser: None })
    }

    /// Coefficients of the deflection [m] by the pressure of a film with this unknown, and by that of `contact` on its
    /// grid.
    pub fn deflection(
        &self,
        (problem, system): (&FilmProblem, &FilmSystem),
        unknown: &[f64],
        contact: Option<&ContactPoints>,
    ) -> Vec<f64> {
        let mut forces = self.grid.forces(problem, system, unknown);
        if let Some(contact) = contact {
            forces.iter_mut().zip(contact.forces()).for_each(|(force, contact)| *force += contact);
        }
        self.compliance.deflection(&forces)
    }

    /// Coefficients of the deflection [m] of this wall by the pressure that bends `other` so, a wall of slices on the
    /// same grid; none where there is no such pressure.
    pub fn deflected_as(&self, other: &Self, coefficients: &[f64]) -> Option<Vec<f64>> {
        Some(self.compliance.deflection(&other.compliance.forces(coefficients)?))
    }

    /// Error [m] of the deflection by the pressure of a film that is due to its grid, as coefficients; none where the
    /// grid is given with the wall.
    pub fn grid_error(&self, problem: &FilmProblem, system: &FilmSystem, unknown: &[f64]) -> Option<Vec<f64>> {
        let coarser = self.coarser.as_ref()?;
        let by = |wall: &Self| {
            let contact = ContactPoints::on(&wall.grid, problem, system);
            wall.deflection((problem, system), unknown, contact.as_ref())
        };
        let coarse = by(coarser);
        let there = self.grid.interpolated(|position| coarser.grid.value(&coarse, position))?;
        let here = by(self);
        let difference = there.iter().zip(here).map(|(there, here)| OF_COARSER * (here - there));
        Some(difference.collect())
    }

    /// How much more [m] the ends are bent than by this deflection of a film, as coefficients: slices there are bent by
    /// the pressure of the ends and by contact alone (where a feed reaches an end, by its own: too much is counted).
    /// None where the grid is given with the wall, or an end is sealed.
    pub fn error_at_ends(&self, problem: &FilmProblem, system: &FilmSystem, deflection: &[f64]) -> Option<Vec<f64>> {
        let is_sealed = |region: &SupplyRegion| region.kind == BoundaryKind::Sealed;
        if self.coarser.is_none() || system.supply.regions().iter().any(is_sealed) {
            return None;
        }
        let even = vec![problem.unknown_at(problem.bearing.end_pressure); system.space().dofs()];
        let contact = ContactPoints::on(&self.grid, problem, system);
        let ends = self.deflection((problem, system), &even, contact.as_ref());
        let along = self.grid.along.number();
        let of = |(k, (film, ends)): (usize, (&f64, f64))| match [0, along - 1].contains(&(k % along)) {
            true => ends - film,
            false => 0.0,
        };
        Some(deflection.iter().zip(ends).enumerate().map(of).collect())
    }
}
