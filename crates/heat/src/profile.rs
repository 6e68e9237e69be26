//! # Flow and friction of layers
//!
//! **Equation.** With the viscosity mu at each eta = y/h, and integrals over 0..1,
//! ```text
//! F0 = Int 1/mu     F1 = Int eta/mu     F2 = Int eta^2/mu - F1^2/F0     a = Int_0^eta 1/mu     b = Int_0^eta s/mu
//! flux  q = U h theta (1 - F1/F0) e_x - h^3 F2 grad p
//! h u     = U h theta a/F0 + h^3 p_x (b - F1/F0 a)
//! heat    theta/(h mu) { [h^2 p_x (eta - F1/F0) + U/F0]^2 + [h^2 p_z (eta - F1/F0)]^2 }
//! ```
//! A flow and its heat are distributed over the layers by shares. The heat has three parts: that of the drag, with the
//! power Int theta U^2/(h F0) dA; that of the driven flow, Int h^3 F2 |grad p|^2 dA; and a part that moves heat between
//! layers, with the factor Int 2 h p_x U dA.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | F0, F1, F2 | 1/(Pa s) | `f0`, `f1`, `f2` |
//! | 1 - F1/F0 | 1 | [`LayerProfile::drag_share`] |
//! | w_l a/F0 / (1 - F1/F0) | 1 | `drag`, sums to 1 |
//! | w_l (F1/F0 a - b)/F2 | 1 | `driven`, sums to 1 |
//! | w_l/(mu F0) | 1 | `shear_friction`, sums to 1 |
//! | w_l (eta - F1/F0)^2/(mu F2) | 1 | `driven_friction`, sums to 1 |
//! | w_l (eta - F1/F0)/(mu F0) | 1 | `cross_friction`, sums to 0 |
//!
//! **Source.** Dowson, Int. J. Mech. Sci. 4 (1962) 159.
//! **Range.** Viscosity above zero; turbulent films in `eddies.rs`. All integrals are sums over the points of
//! [`Layers`], by which the sums of the shares are exact. **Verified by** `crates/heat/tests/layers.rs`.

use crate::layers::MOST_POINTS;
use crate::{EddyScales, Layers};

/// Numbers for each point across a film; those past the last point are zero.
pub type PerLayer = [f64; MOST_POINTS];

/// How a film of given viscosities flows and where its friction heats it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerProfile {
    /// Int 1/mu [1/(Pa s)].
    pub f0: f64,
    /// Int eta/mu [1/(Pa s)].
    pub f1: f64,
    /// Int eta^2/mu - F1^2/F0 [1/(Pa s)]; the flow that pressure drives is -h^3 F2 grad p.
    pub f2: f64,
    /// Share of each layer in the flow that the journal drags along.
    pub drag: PerLayer,
    /// Share of each layer in the flow that pressure drives.
    pub driven: PerLayer,
    /// Share of each layer in the heat of the dragged flow.
    pub shear_friction: PerLayer,
    /// Share of each layer in the heat of the driven flow.
    pub driven_friction: PerLayer,
    /// Heat of each layer for the two flows together, by the factor [`crate::FilmCell::cross_power`].
    pub cross_friction: PerLayer,
    /// Part of the gap that each layer takes; the mean across the film weighs temperatures by it.
    pub weights: PerLayer,
    /// Resistance to the conduction of heat across the film over that of still oil [1].
    pub resistance: f64,
    /// What eddies make of the flow; none in a laminar film.
    pub eddies: Option<EddyScales>,
}

impl LayerProfile {
    /// The profile of a film with the viscosities [Pa s] at the points of `layers`.
    pub fn of(layers: &Layers, viscosities: &[f64]) -> Self {
        let n = layers.points.len();
        let (eta, weights) = (&layers.points, &layers.weights);
        let mut fluidity = [0.0; MOST_POINTS];
        for l in 0..n {
            fluidity[l] = 1.0 / viscosities[l];
        }
        let sum = |of: &dyn Fn(usize) -> f64| -> f64 { (0..n).map(|l| weights[l] * fluidity[l] * of(l)).sum() };
        let (f0, f1) = (sum(&|_| 1.0), sum(&|l| eta[l]));
        let centre = f1 / f0;
        let f2 = sum(&|l| (eta[l] - centre).powi(2));
        let mut drag = [0.0; MOST_POINTS];
        let mut driven = [0.0; MOST_POINTS];
        for j in 0..n {
            let integral = |of: &dyn Fn(usize) -> f64| -> f64 {
                (0..n).map(|l| layers.integrals[j][l] * fluidity[l] * of(l)).sum()
            };
            drag[j] = weights[j] * integral(&|_| 1.0);
            driven[j] = weights[j] * integral(&|l| centre - eta[l]);
        }
        let friction = |scale: f64, of: &dyn Fn(usize) -> f64| {
            let mut friction = [0.0; MOST_POINTS];
            for l in 0..n {
                friction[l] = weights[l] * fluidity[l] / scale * of(l);
            }
            friction
        };
        Self {
            f0,
            f1,
            f2,
            drag: of_unit_sum(drag),
            driven: of_unit_sum(driven),
            shear_friction: friction(f0, &|_| 1.0),
            driven_friction: friction(f2, &|l| (eta[l] - centre).powi(2)),
            cross_friction: friction(f0, &|l| eta[l] - centre),
            weights: std::array::from_fn(|l| weights.get(l).copied().unwrap_or(0.0)),
            resistance: 1.0,
            eddies: None,
        }
    }

    /// Mean temperature across the film of those at the points.
    pub fn mean(&self, temperatures: &[f64]) -> f64 {
        temperatures.iter().zip(&self.weights).map(|(t, weight)| t * weight).sum()
    }

    /// Flow that the journal drags along, over U h: 1 - F1/F0, a half for one viscosity.
    pub fn drag_share(&self) -> f64 {
        1.0 - self.f1 / self.f0
    }

    /// Flow of each layer [m3/s] between two cells of profiles `self` and `other`, for what is dragged and what is
    /// driven.
    pub(crate) fn flows(&self, other: &Self, dragged: f64, driven: f64) -> PerLayer {
        let mean = |a: &PerLayer, b: &PerLayer, l: usize| 0.5 * (a[l] + b[l]);
        std::array::from_fn(|l| {
            dragged * mean(&self.drag, &other.drag, l) + driven * mean(&self.driven, &other.driven, l)
        })
    }
}

pub(crate) fn of_unit_sum(shares: PerLayer) -> PerLayer {
    let sum: f64 = shares.iter().sum();
    shares.map(|share| share / sum)
}
