//! The terms of Reynolds' equation: a sum of fluxes and sources, one a file.

mod couette;
mod poiseuille;
pub mod squeeze;

pub use couette::Couette;
pub use poiseuille::Poiseuille;

use std::sync::Arc;

use crate::{FilmFlow, FilmPoint};

/// One term of the equation.
pub trait Term: Send + Sync + std::fmt::Debug {
    /// Name in reports.
    fn name(&self) -> &'static str;

    /// Adds its flow at a point of the film.
    fn add(&self, film: &FilmPoint, flow: &mut FilmFlow);

    /// Adds its flow at all points of a triangle: one call of an unknown function, the loop inside.
    fn add_all(&self, film: &[FilmPoint], flows: &mut [FilmFlow]) {
        for (point, flow) in film.iter().zip(flows) {
            self.add(point, flow);
        }
    }

    /// Adds what its flow changes, to first order, where thickness, slope, rate and viscosity change by
    /// those of `change`.
    fn vary(&self, film: &FilmPoint, change: &FilmPoint, flow: &mut FilmFlow);
}

/// What makes a film change with the rates of its journal, beside the conductance that control volumes divide by.
pub(crate) fn of_rates() -> Vec<Arc<dyn Term>> {
    let mut terms: Vec<Arc<dyn Term>> = vec![Arc::new(Poiseuille)];
    terms.push(Arc::new(squeeze::Squeeze));
    terms
}

/// Checks that the variation of a term matches finite differences.
#[cfg(test)]
fn check(term: &dyn Term) {
    let film = FilmPoint {
        thickness: 2.1,
        slope: [0.3, -0.2],
        rate: 0.4,
        viscosity: 0.7,
        shear_viscosity: 0.8,
        drag: 0.45,
        velocity: [1.3, 0.6],
        eddies: None,
    };
    let change = FilmPoint { thickness: 0.9, slope: [-0.5, 0.8], rate: -1.1, viscosity: 0.3, ..FilmPoint::default() };
    let values = |flow: FilmFlow| [flow.conductance[0], flow.flux[0], flow.flux[1], flow.divergence, flow.storage];
    let at = |step: f64| {
        let mut flow = FilmFlow::default();
        let moved = FilmPoint {
            thickness: film.thickness + step * change.thickness,
            slope: [0, 1].map(|k| film.slope[k] + step * change.slope[k]),
            rate: film.rate + step * change.rate,
            viscosity: film.viscosity + step * change.viscosity,
            ..film
        };
        term.add(&moved, &mut flow);
        values(flow)
    };
    let mut varied = FilmFlow::default();
    term.vary(&film, &change, &mut varied);
    let (exact, ahead, behind) = (values(varied), at(1e-6), at(-1e-6));
    for k in 0..5 {
        let difference = (ahead[k] - behind[k]) / 2e-6;
        assert!((difference - exact[k]).abs() < 1e-8, "{} {k}", term.name());
    }
}
