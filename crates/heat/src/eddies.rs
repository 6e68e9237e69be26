//! # Eddies across a turbulent film
//!
//! **Equation.** Eddies add to the viscosity mu and to the conductivity k of the oil. At a distance y from the nearer
//! wall, whose oil has the viscosity mu_w, and in a film with the speed U of the journal,
//! ```text
//! mu_e = 0.4 mu_w (y+ - 10.7 tanh(y+/10.7))     y+ = y sqrt(rho tau)/mu_w     k_e = c mu_e/Pr_t
//! tau = U/(h F0)     F0 = Int 1/(mu + mu_e)     F1 = Int eta/(mu + mu_e)      over eta from 0 to 1
//! F2_z = Int (eta - F1/F0)^2/(mu + mu_e)        g = 0.4 y+ tanh^2(y+/10.7)
//! F2_x = Int (eta - F1/F0)^2/(mu + mu_e) (1 - g mu_w/(2 (mu + mu_e)))
//! xi = Int_0^eta k/(k + k_e)/R                  R = Int k/(k + k_e)
//! ```
//! The stress tau of the shear makes the eddies, and pressure moves oil through them. A temperature is linear in xi
//! where heat is conducted only: xi is the coordinate of the layers, in which the sublayers at the walls, which have
//! nearly all resistance, are as wide as they resist, and the core between them is a point.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | rho, U, h | kg/m3, m/s, m | `density`, `speed`, `gap` of [`TurbulentFlow`] |
//! | h sqrt(rho tau) | Pa s | `stirring`; y+ is eta times it over mu_w |
//! | R | 1 | [`LayerProfile::resistance`] |
//! | d ln/d ln h of conductances and shear | 1 | `growth` of [`EddyScales`] |
//!
//! **Source.** Reichardt, Z. angew. Math. Mech. 31 (1951) 208, for the eddies; Ng, Pan, Trans. ASME J. Basic Eng. 87
//! (1965) 675, for F2_x; Kays, Crawford, Convective Heat and Mass Transfer (1993), for Pr_t of 0.9. **Range.** Shear
//! that is great beside pressure; Re up to 3e4. **Verified by** `crates/heat/tests/eddies.rs`.

use std::sync::LazyLock;

use crate::layers::{MOST_POINTS, basis};
use crate::profile::{LayerProfile, PerLayer, of_unit_sum};
use crate::{Layers, OilProperties};

/// Karman's constant in Reichardt's law.
const KARMAN: f64 = 0.4;
/// Thickness of the viscous sublayer in wall units in that law.
const SUBLAYER: f64 = 10.7;
/// Turbulent Prandtl number.
const PRANDTL: f64 = 0.9;
/// Points of integration between a wall and the middle: at Re = 3e4 sums are good to 3e-5, R to 4e-4.
const HALF: usize = 28;
/// Most steps to the stress of the shear.
const STEPS: usize = 50;
/// The logarithm of the stirring is found where it changes by no more than this.
const FOUND: f64 = 1e-10;
/// Change of that logarithm by which slopes are differenced.
const APART: f64 = 1e-3;

/// A place of a turbulent film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurbulentFlow {
    /// Film thickness h [m].
    pub gap: f64,
    /// Speed U of the journal's surface [m/s].
    pub speed: f64,
    /// Density of the oil [kg/m3].
    pub density: f64,
    /// Heat capacity and conductivity of the oil.
    pub oil: OilProperties,
}

/// What eddies make of the flow of a place, over that of a laminar film with the same temperatures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EddyScales {
    /// Int 1/mu without eddies [1/(Pa s)].
    pub laminar_f0: f64,
    /// Int eta^2/mu - F1^2/F0 without eddies [1/(Pa s)].
    pub laminar_f2: f64,
    /// Flow that pressure drives along x and along z over that of the laminar film [1].
    pub conductance: [f64; 2],
    /// How these grow with the gap: d ln/d ln h [1], negative.
    pub conductance_growth: [f64; 2],
    /// Shear stress over that of the laminar film [1].
    pub shear: f64,
    /// How it grows with the gap: d ln/d ln h [1].
    pub shear_growth: f64,
    /// How strongly the film at each wall is stirred.
    pub(crate) walls: [StirredWall; 2],
}

/// What decides on the eddies near a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct StirredWall {
    /// The film thickness in wall units, h sqrt(rho tau)/mu_w.
    wall_gap: f64,
    /// Prandtl number of the oil at the wall over the turbulent one.
    prandtl_ratio: f64,
}

impl StirredWall {
    /// Viscosity of the eddies over that of the oil at the wall, at a distance eta from it.
    fn eddies(&self, eta: f64) -> f64 {
        let y = eta * self.wall_gap;
        KARMAN * (y - SUBLAYER * (y / SUBLAYER).tanh())
    }

    /// How that grows with the logarithm of the wall gap.
    fn eddy_growth(&self, eta: f64) -> f64 {
        let y = eta * self.wall_gap;
        KARMAN * y * (y / SUBLAYER).tanh().powi(2)
    }
}

/// Points of integration across a film, dense at the walls: eta = s^3/2 from either wall with Gauss points s.
struct WallRule {
    /// Distances from the nearer wall over the gap.
    eta: [f64; HALF],
    /// Weights of these; they sum to 1/2.
    weights: [f64; HALF],
    /// Weights of the value at each point in the integrals from the wall up to every point.
    up_to: [[f64; HALF]; HALF],
}

static RULE: LazyLock<WallRule> = LazyLock::new(WallRule::new);

impl WallRule {
    fn new() -> Self {
        let (points, gauss) = crate::layers::gauss(HALF);
        let slope = |s: f64| 1.5 * s * s;
        let up_to = |m: usize, end: f64| -> f64 {
            let inner = points.iter().zip(&gauss);
            inner.map(|(x, weight)| end * weight * basis(&points, m, end * x)).sum::<f64>() * slope(points[m])
        };
        Self {
            eta: std::array::from_fn(|q| 0.5 * points[q].powi(3)),
            weights: std::array::from_fn(|q| gauss[q] * slope(points[q])),
            up_to: std::array::from_fn(|m| std::array::from_fn(|q| up_to(m, points[q]))),
        }
    }

    /// The integral of `values` from the wall up to each point, and up to the middle.
    fn from_wall(&self, values: impl Iterator<Item = f64>) -> ([f64; HALF], f64) {
        let (mut up_to, mut all) = ([0.0; HALF], 0.0);
        for ((value, row), weight) in values.zip(&self.up_to).zip(&self.weights) {
            all += weight * value;
            up_to.iter_mut().zip(row).for_each(|(sum, weight)| *sum += weight * value);
        }
        (up_to, all)
    }

    /// The integral of `values` from the bush up to each point, and over the whole film.
    fn integrals(&self, values: &[f64; 2 * HALF]) -> ([f64; 2 * HALF], f64) {
        let (from_bush, below) = self.from_wall(values[..HALF].iter().copied());
        let (from_journal, above) = self.from_wall(values[HALF..].iter().rev().copied());
        let all = below + above;
        let mut up_to = [0.0; 2 * HALF];
        up_to[..HALF].copy_from_slice(&from_bush);
        up_to[HALF..].iter_mut().zip(from_journal.iter().rev()).for_each(|(sum, above)| *sum = all - above);
        (up_to, all)
    }

    /// Wall, distance from it, distance from the bush, and weight of each point.
    fn points(&self) -> impl Iterator<Item = (usize, f64, f64, f64)> {
        let below = (0..HALF).map(|q| (0, self.eta[q], self.eta[q], self.weights[q]));
        below.chain((0..HALF).rev().map(|q| (1, self.eta[q], 1.0 - self.eta[q], self.weights[q])))
    }
}

/// The film at the points of integration.
struct StirredFilm {
    /// Resistance R to heat over that without eddies [1].
    resistance: f64,
    /// Coordinate xi of each point.
    xi: [f64; 2 * HALF],
    /// 1/(mu + mu_e) over 1/mu at each point.
    slowing: [f64; 2 * HALF],
    /// 1/(mu + mu_e) [1/(Pa s)] at each point.
    fluidity: [f64; 2 * HALF],
    /// Int 1/(mu + mu_e), Int eta/(mu + mu_e), F2_x and F2_z [1/(Pa s)].
    f0: f64,
    f1: f64,
    f2: [f64; 2],
}

impl StirredFilm {
    fn of(layers: &Layers, (fluidities, viscosity): (&[f64], [f64; 2]), walls: &[StirredWall; 2]) -> Self {
        let (resistance, xi) = coordinate(walls);
        let (mut slowing, mut fluidity) = ([0.0; 2 * HALF], [0.0; 2 * HALF]);
        let (mut f0, mut f1) = (0.0, 0.0);
        for (k, (wall, near, eta, weight)) in RULE.points().enumerate() {
            let plain = layers.at(fluidities, xi[k]);
            slowing[k] = 1.0 / (1.0 + plain * viscosity[wall] * walls[wall].eddies(near));
            fluidity[k] = plain * slowing[k];
            f0 += weight * fluidity[k];
            f1 += weight * fluidity[k] * eta;
        }
        let mut f2 = [0.0; 2];
        for (k, (wall, near, eta, weight)) in RULE.points().enumerate() {
            let part = weight * fluidity[k] * (eta - f1 / f0).powi(2);
            let along = 1.0 - 0.5 * fluidity[k] * viscosity[wall] * walls[wall].eddy_growth(near);
            f2[0] += part * along;
            f2[1] += part;
        }
        Self { resistance, xi, slowing, fluidity, f0, f1, f2 }
    }
}

/// Resistance R to heat, and the coordinate xi of each point of integration.
fn coordinate(walls: &[StirredWall; 2]) -> (f64, [f64; 2 * HALF]) {
    let mut resisting = [0.0; 2 * HALF];
    for (value, (wall, near, ..)) in resisting.iter_mut().zip(RULE.points()) {
        *value = 1.0 / (1.0 + walls[wall].prandtl_ratio * walls[wall].eddies(near));
    }
    let (up_to, resistance) = RULE.integrals(&resisting);
    let mut before = 0.0f64;
    // Rounding of the interpolation aside, xi grows.
    let grown = up_to.map(|part| {
        before = before.max((part / resistance).min(1.0));
        before
    });
    (resistance, grown)
}

impl EddyScales {
    /// Places across the film, as distances eta from the bush, with the coordinate xi of each, both walls included.
    pub fn places(&self) -> Vec<[f64; 2]> {
        let (_, xi) = coordinate(&self.walls);
        let inner = RULE.points().zip(xi).map(|((.., eta, _), xi)| [eta, xi]);
        std::iter::once([0.0; 2]).chain(inner).chain([[1.0; 2]]).collect()
    }
}

impl LayerProfile {
    /// The profile of a turbulent film with the viscosities [Pa s] at the points of `layers`, which are equal steps of
    /// xi ([`Layers::linear`]).
    pub fn turbulent(layers: &Layers, viscosities: &[f64], flow: &TurbulentFlow) -> Self {
        let n = layers.points.len();
        let fluidities: Vec<f64> = viscosities.iter().map(|mu| 1.0 / mu).collect();
        let viscosity = [viscosities[0], viscosities[n - 1]];
        let prandtl = flow.oil.capacity / (flow.density * flow.oil.conductivity * PRANDTL);
        let walls =
            |stirring: f64| viscosity.map(|mu| StirredWall { wall_gap: stirring / mu, prandtl_ratio: prandtl * mu });
        let at = |stirring: f64| StirredFilm::of(layers, (&fluidities, viscosity), &walls(stirring));
        let stirring = stirring(flow.density * flow.speed.abs() * flow.gap, |stirring| at(stirring).f0);
        let film = at(stirring);
        let [behind, ahead] = [-APART, APART].map(|apart| at(stirring * apart.exp()));
        let slope = |of: &dyn Fn(&StirredFilm) -> f64| (of(&ahead) / of(&behind)).ln() / (2.0 * APART);
        // The stirring grows with the gap h as h^(1/(2 - a)), where F0 falls with it as the power a.
        let by_gap = 1.0 / (2.0 + slope(&|film| film.f0));
        let still = at(0.0);
        let laminar_f2 = still.f2[1];
        let eddies = EddyScales {
            laminar_f0: still.f0,
            laminar_f2,
            conductance: film.f2.map(|f2| f2 / laminar_f2),
            conductance_growth: [0, 1].map(|axis| by_gap * slope(&|film| film.f2[axis])),
            shear: still.f0 / film.f0,
            shear_growth: -by_gap * slope(&|film| film.f0),
            walls: walls(stirring),
        };
        Self { eddies: Some(eddies), ..film.profile(layers, &fluidities) }
    }
}

impl StirredFilm {
    /// Flow and friction of the layers: integrals with their hats, which are nowhere negative.
    fn profile(&self, layers: &Layers, fluidities: &[f64]) -> LayerProfile {
        let centre = self.f1 / self.f0;
        let mut moment = [0.0; 2 * HALF];
        for (moment, (fluidity, (.., eta, _))) in moment.iter_mut().zip(self.fluidity.iter().zip(RULE.points())) {
            *moment = fluidity * (centre - eta);
        }
        let [(dragged, _), (pressed, _)] = [&self.fluidity, &moment].map(|values| RULE.integrals(values));
        let mut weights = [0.0; MOST_POINTS];
        let [mut drag, mut driven, mut shear_friction, mut driven_friction, mut cross_friction] = [weights; 5];
        for (k, (.., eta, weight)) in RULE.points().enumerate() {
            let (left, share) = layers.step(self.xi[k]);
            for (l, part) in [(left, 1.0 - share), (left + 1, share)] {
                let part = weight * part;
                let sheared = part * self.slowing[k] * fluidities[l] / self.f0;
                weights[l] += part;
                drag[l] += part * dragged[k];
                driven[l] += part * pressed[k];
                shear_friction[l] += sheared;
                driven_friction[l] += sheared * (eta - centre).powi(2);
                cross_friction[l] += sheared * (eta - centre);
            }
        }
        LayerProfile {
            f0: self.f0,
            f1: self.f1,
            f2: self.f2[1],
            drag: of_unit_sum(drag),
            driven: of_unit_sum(driven),
            shear_friction: of_unit_sum(shear_friction),
            driven_friction: of_unit_sum(driven_friction),
            cross_friction: of_no_sum(cross_friction, layers.points.len()),
            weights,
            resistance: self.resistance,
            eddies: None,
        }
    }
}

/// The stirring `s = h sqrt(rho tau)` [Pa s] at which `s^2 F0(s)` is `rho U h`, by secants of the logarithms.
fn stirring(product: f64, f0: impl Fn(f64) -> f64) -> f64 {
    if product <= 0.0 {
        return 0.0;
    }
    let lacking = |x: f64| product.ln() - 2.0 * x - f0(x.exp()).ln();
    let mut x = 0.5 * (product / f0(0.0)).ln();
    // F0 falls with s, by its first power at most: the slope lies between 1 and 2.
    let (mut here, mut slope) = (lacking(x), 2.0f64);
    for _ in 0..STEPS {
        let step = here / slope;
        x += step;
        if step.abs() < FOUND {
            break;
        }
        let next = lacking(x);
        slope = ((here - next) / step).clamp(1.0, 2.0);
        here = next;
    }
    x.exp()
}

/// Shares less their mean, so that they add nothing.
fn of_no_sum(mut shares: PerLayer, count: usize) -> PerLayer {
    let mean = shares.iter().sum::<f64>() / count as f64;
    shares[..count].iter_mut().for_each(|share| *share -= mean);
    shares
}
