//! What scales the flows of a film: a product of factors, one a file. A film without factors is computed as if there
//! were no such socket.

mod patir_cheng;

pub use patir_cheng::PatirCheng;

use std::sync::Arc;

use crate::{FilmFlow, FilmPoint};

/// A factor and its first two derivatives by the gap, in units of the gap to the power of minus their order.
pub type Jet = [f64; 3];

/// Scales of a film's flows at one gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Conductance over that of smooth surfaces [1], and its derivative [1/m].
    pub conductance: [f64; 2],
    /// Mean gap [m], which holds and carries the oil, and its derivatives [1, 1/m].
    pub mean_gap: Jet,
}

/// A factor of the flows of a film.
pub trait FlowFactor: Send + Sync + std::fmt::Debug {
    /// Name in reports.
    fn name(&self) -> &'static str;

    /// Scales at the gap `h` [m] between the mean planes of the surfaces.
    fn scales(&self, gap: f64) -> Scales;
}

/// Scales the flows of a smooth film at one point: the conductance by its factor; what is dragged along by the mean gap
/// over the gap, its divergence and what is taken up by the change of the mean gap with the gap.
pub(crate) fn scale(factors: &[Arc<dyn FlowFactor>], film: &FilmPoint, flow: &mut FilmFlow) {
    for factor in factors {
        let Scales { conductance, mean_gap } = factor.scales(film.thickness);
        flow.conductance *= conductance[0];
        for part in &mut flow.flux {
            *part *= mean_gap[0] / film.thickness;
        }
        flow.divergence *= mean_gap[1];
        flow.storage *= mean_gap[1];
    }
}

/// Scales the change `varied` of the flows of a smooth film, `flow`, where its thickness changes by `change`.
pub(crate) fn vary(
    factors: &[Arc<dyn FlowFactor>],
    film: &FilmPoint,
    change: f64,
    flow: &FilmFlow,
    varied: &mut FilmFlow,
) {
    let mut flow = *flow;
    for factor in factors {
        let Scales { conductance, mean_gap } = factor.scales(film.thickness);
        let carried = mean_gap[0] / film.thickness;
        let by_carried = (mean_gap[1] - carried) / film.thickness * change;
        varied.conductance = conductance[0] * varied.conductance + conductance[1] * change * flow.conductance;
        for (varied, flow) in varied.flux.iter_mut().zip(flow.flux) {
            *varied = carried * *varied + by_carried * flow;
        }
        varied.divergence = mean_gap[1] * varied.divergence + mean_gap[2] * change * flow.divergence;
        varied.storage = mean_gap[1] * varied.storage + mean_gap[2] * change * flow.storage;
        scale(std::slice::from_ref(factor), film, &mut flow);
    }
}

/// Mean gap [m] and its derivative by the gap [1] where surfaces with these factors are `gap` [m] apart.
pub(crate) fn mean_gap(factors: &[Arc<dyn FlowFactor>], gap: f64) -> [f64; 2] {
    factors.iter().fold([gap, 1.0], |[mean, slope], factor| {
        let [next, by_gap, _] = factor.scales(mean).mean_gap;
        [next, slope * by_gap]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terms::{Couette, Poiseuille, Term, squeeze::Squeeze};

    fn flow(factors: &[Arc<dyn FlowFactor>], film: &FilmPoint) -> [f64; 5] {
        let mut flow = FilmFlow::default();
        for term in [&Poiseuille as &dyn Term, &Couette, &Squeeze] {
            term.add(film, &mut flow);
        }
        scale(factors, film, &mut flow);
        values(&flow)
    }

    fn values(flow: &FilmFlow) -> [f64; 5] {
        let [x, z] = flow.flux;
        [flow.conductance, x, z, flow.divergence, flow.storage]
    }

    #[test]
    fn variations_match_differences() {
        let factors: [Arc<dyn FlowFactor>; 1] = [Arc::new(PatirCheng { roughness: 1.0 })];
        let change = FilmPoint { thickness: 0.4, slope: [0.3, -0.2], rate: 0.7, ..FilmPoint::default() };
        for thickness in [0.1, 0.6, 1.7, 4.0, 9.5] {
            let (slope, velocity) = ([0.2, 0.1], [1.3, 0.6]);
            let even = FilmPoint { viscosity: 0.7, shear_viscosity: 0.7, drag: 0.5, ..FilmPoint::default() };
            let film = FilmPoint { thickness, slope, rate: -0.4, velocity, ..even };
            let at = |step: f64| FilmPoint {
                thickness: film.thickness + step * change.thickness,
                slope: [0, 1].map(|k| film.slope[k] + step * change.slope[k]),
                rate: film.rate + step * change.rate,
                ..film
            };
            let (mut smooth, mut varied) = (FilmFlow::default(), FilmFlow::default());
            for term in [&Poiseuille as &dyn Term, &Couette, &Squeeze] {
                term.add(&film, &mut smooth);
                term.vary(&film, &change, &mut varied);
            }
            vary(&factors, &film, change.thickness, &smooth, &mut varied);
            let (ahead, behind) = (flow(&factors, &at(1e-5)), flow(&factors, &at(-1e-5)));
            for (k, exact) in values(&varied).into_iter().enumerate() {
                let difference = (ahead[k] - behind[k]) / 2e-5;
                let scale = 1.0 + exact.abs();
                assert!((difference - exact).abs() < 1e-8 * scale, "{thickness} {k}: {difference} {exact}");
            }
        }
    }

    /// What a rough film carries is its mean gap, and its divergence is that of the flux.
    #[test]
    fn the_divergence_is_that_of_the_flux() {
        let factors: [Arc<dyn FlowFactor>; 1] = [Arc::new(PatirCheng { roughness: 1.0 })];
        let at = |x: f64| {
            let film = FilmPoint {
                thickness: 0.8 + 0.5 * x,
                slope: [0.5, 0.0],
                viscosity: 1.0,
                drag: 0.5,
                velocity: [2.0, 0.0],
                ..FilmPoint::default()
            };
            (film, flow(&factors, &film))
        };
        let (film, here) = at(0.3);
        let difference = (at(0.3 + 1e-5).1[1] - at(0.3 - 1e-5).1[1]) / 2e-5;
        assert!((here[3] - difference).abs() < 1e-9);
        assert!((here[1] - mean_gap(&factors, film.thickness)[0]).abs() < 1e-15);
    }
}
