//! What scales the flows of a film: a product of factors, one a file. A film without factors is computed as if there
//! were no such socket.

mod patir_cheng;
mod turbulence;

pub use patir_cheng::PatirCheng;
pub use turbulence::{TurbulenceModel, reynolds_number};

use std::sync::Arc;

use crate::{FilmFlow, FilmPoint};

/// A factor and its first two derivatives by the gap, in units of the gap to the power of minus their order.
pub type Jet = [f64; 3];

/// A factor of a conductance and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ConductanceFactor {
    /// Conductance over that without the factor [1].
    pub value: f64,
    /// Derivative by the gap [1/m].
    pub by_gap: f64,
    /// Derivative by the viscosity [1/(Pa s)].
    pub by_viscosity: f64,
}

/// A factor of the flows of a film.
pub trait FlowFactor: Send + Sync + std::fmt::Debug {
    /// Name in reports.
    fn name(&self) -> &'static str;

    /// Whether it is of laminar films, and scales the conductances along x and along z alike.
    fn is_laminar(&self) -> bool {
        true
    }

    /// FlowScales of the conductance along x and along z at a point of a film of this `density` [kg/m3].
    fn conductance(&self, film: &FilmPoint, density: f64) -> [ConductanceFactor; 2];

    /// Shear stress of the whole gap over that without the factor [1].
    fn shear(&self, _film: &FilmPoint, _density: f64) -> f64 {
        1.0
    }

    /// Mean gap [m], which holds and carries the oil, and its derivatives [1, 1/m], at the gap `h` [m] between the mean
    /// planes of the surfaces; `None`: the gap itself, for the surfaces are smooth.
    fn mean_gap(&self, _gap: f64) -> Option<Jet> {
        None
    }
}

/// FlowScales of the flows of a film, and the density [kg/m3] of its oil.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlowScales<'a> {
    pub(crate) factors: &'a [Arc<dyn FlowFactor>],
    pub(crate) density: f64,
}

impl FlowScales<'_> {
    /// Scales the flows of a film without factors at one point: the conductance by its factor; what is dragged along by
    /// the mean gap over the gap, its divergence and what is taken up by the change of the mean gap with the gap.
    pub(crate) fn scale(&self, film: &FilmPoint, flow: &mut FilmFlow) {
        self.factors.iter().for_each(|factor| self.scale_by(factor.as_ref(), film, flow));
    }

    fn scale_by(&self, factor: &dyn FlowFactor, film: &FilmPoint, flow: &mut FilmFlow) {
        for (along, factor) in flow.conductance.iter_mut().zip(factor.conductance(film, self.density)) {
            *along *= factor.value;
        }
        if let Some([mean, by_gap, _]) = factor.mean_gap(film.thickness) {
            for part in &mut flow.flux {
                *part *= mean / film.thickness;
            }
            flow.divergence *= by_gap;
            flow.storage *= by_gap;
        }
    }

    /// Scales the change `varied` of the flows of a film without factors, `flow`, where thickness and viscosity of the
    /// film change by those of `change`.
    pub(crate) fn vary(&self, film: &FilmPoint, change: &FilmPoint, flow: &FilmFlow, varied: &mut FilmFlow) {
        let mut flow = *flow;
        for factor in self.factors {
            let conductance = factor.conductance(film, self.density);
            for ((varied, flow), by) in varied.conductance.iter_mut().zip(flow.conductance).zip(conductance) {
                let more = by.by_gap * change.thickness + by.by_viscosity * change.viscosity;
                *varied = by.value * *varied + more * flow;
            }
            if let Some([mean, by_gap, bend]) = factor.mean_gap(film.thickness) {
                let carried = mean / film.thickness;
                let by_carried = (by_gap - carried) / film.thickness * change.thickness;
                for (varied, flow) in varied.flux.iter_mut().zip(flow.flux) {
                    *varied = carried * *varied + by_carried * flow;
                }
                varied.divergence = by_gap * varied.divergence + bend * change.thickness * flow.divergence;
                varied.storage = by_gap * varied.storage + bend * change.thickness * flow.storage;
            }
            self.scale_by(factor.as_ref(), film, &mut flow);
        }
    }

    /// Shear stress of the whole gap over that without factors [1].
    pub(crate) fn shear(&self, film: &FilmPoint) -> f64 {
        self.factors.iter().map(|factor| factor.shear(film, self.density)).product()
    }
}

/// Mean gap [m] and its derivative by the gap [1] where surfaces with these factors are `gap` [m] apart.
pub(crate) fn mean_gap(factors: &[Arc<dyn FlowFactor>], gap: f64) -> [f64; 2] {
    factors.iter().fold([gap, 1.0], |[mean, slope], factor| match factor.mean_gap(mean) {
        Some([next, by_gap, _]) => [next, slope * by_gap],
        None => [mean, slope],
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::EddyFactors;
    use crate::terms::{Couette, Poiseuille, Term, squeeze::Squeeze};

    /// Reynolds numbers of the films below reach some 5e4 with it.
    const DENSITY: f64 = 3000.0;

    fn flow(factors: &[Arc<dyn FlowFactor>], film: &FilmPoint) -> [f64; 6] {
        let mut flow = FilmFlow::default();
        for term in [&Poiseuille as &dyn Term, &Couette, &Squeeze] {
            term.add(film, &mut flow);
        }
        FlowScales { factors, density: DENSITY }.scale(film, &mut flow);
        values(&flow)
    }

    fn values(flow: &FilmFlow) -> [f64; 6] {
        let ([k_x, k_z], [x, z]) = (flow.conductance, flow.flux);
        [k_x, k_z, x, z, flow.divergence, flow.storage]
    }

    #[test]
    fn variations_match_differences() {
        let factors: [Arc<dyn FlowFactor>; 3] = [
            Arc::new(PatirCheng { roughness: 1.0 }),
            Arc::new(TurbulenceModel::NgPan),
            Arc::new(TurbulenceModel::Constantinescu),
        ];
        check_variations(&factors, None);
        let eddies = EddyFactors {
            gap: 1.2,
            conductance: [0.4, 0.6],
            conductance_growth: [-0.7, -0.5],
            shear: 1.8,
            shear_growth: 0.6,
        };
        check_variations(&[Arc::new(TurbulenceModel::Reichardt)], Some(eddies));
    }

    fn check_variations(factors: &[Arc<dyn FlowFactor>], eddies: Option<EddyFactors>) {
        let change =
            FilmPoint { thickness: 0.4, slope: [0.3, -0.2], rate: 0.7, viscosity: 0.2, ..FilmPoint::default() };
        for thickness in [0.1, 0.6, 1.7, 4.0, 9.5] {
            let (slope, velocity) = ([0.2, 0.1], [1.3, 0.6]);
            let even = FilmPoint { viscosity: 0.7, shear_viscosity: 0.7, drag: 0.5, eddies, ..FilmPoint::default() };
            let film = FilmPoint { thickness, slope, rate: -0.4, velocity, ..even };
            let at = |step: f64| FilmPoint {
                thickness: film.thickness + step * change.thickness,
                slope: [0, 1].map(|k| film.slope[k] + step * change.slope[k]),
                rate: film.rate + step * change.rate,
                viscosity: film.viscosity + step * change.viscosity,
                ..film
            };
            let (mut smooth, mut varied) = (FilmFlow::default(), FilmFlow::default());
            for term in [&Poiseuille as &dyn Term, &Couette, &Squeeze] {
                term.add(&film, &mut smooth);
                term.vary(&film, &change, &mut varied);
            }
            FlowScales { factors, density: DENSITY }.vary(&film, &change, &smooth, &mut varied);
            let (ahead, behind) = (flow(factors, &at(1e-5)), flow(factors, &at(-1e-5)));
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
        let difference = (at(0.3 + 1e-5).1[2] - at(0.3 - 1e-5).1[2]) / 2e-5;
        assert!((here[4] - difference).abs() < 1e-9);
        assert!((here[2] - mean_gap(&factors, film.thickness)[0]).abs() < 1e-15);
    }
}
