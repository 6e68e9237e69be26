//! # The bush as a ring that conducts heat
//!
//! **Equation.** The temperature of the ring, counted from that of the surroundings, is a sum of modes that are
//! {1, cos n phi, sin n phi} around and cos(pi m (z/L + 1/2)) along, with insulated ends. A mode follows the radius by
//! ```text
//! T'' + T'/r - (n^2/r^2 + lambda^2) T = 0,   lambda = pi m/L,   -k T' = H T at R_o,   C_nm = -k T'/T at R
//! ```
//! With m = 0 it is powers of r (n = 0: a logarithm), else modified Bessel functions. C_nm is the heat that enters the
//! mode, for its area and temperature. The projection of the heat that films give on a mode balances it:
//! `sum_i B_k(i) q_i = C_k Int B_k^2 dA b_k`, with the whole bore, feeds included; so the mean balances exactly.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | R, R_o, L | m | `inner_radius`, `outer_radius`, `length` |
//! | k | W/(m K) | `conductivity` |
//! | H | W/(m2 K) | `transfer` |
//! | C_nm | W/(m2 K) | [`BushShape::conductances`] |
//! | b_k | K | `LayerTemperatures::bush` |
//!
//! **Source.** Carslaw and Jaeger, Conduction of Heat in Solids (1959), ch. 8.
//! **Range.** A full ring with one conductivity. What films have finer than the last modes along or around is cut off.
//! **Verified by** `crates/heat/tests/bush.rs`.

use std::f64::consts::PI;

use crate::bessel::{Logarithmic, bessel};

/// Waves along with a greater product of wave number and radius are so short that the ring is a plate to them.
const SHORT_WAVE: f64 = 1e4;

/// Dimensions and conductivity of a ring around the film.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BushShape {
    /// Radius of the bore R [m].
    pub inner_radius: f64,
    /// Outer radius R_o [m].
    pub outer_radius: f64,
    /// Length L [m].
    pub length: f64,
    /// Conductivity k [W/(m K)].
    pub conductivity: f64,
    /// Heat transfer at the outer side H [W/(m2 K)].
    pub transfer: f64,
    /// Temperature of the surroundings [K].
    pub ambient: f64,
}

impl BushShape {
    /// Conductances C_nm [W/(m2 K)] of the modes with n = 0 to `last` waves around and m half waves along.
    pub fn conductances(&self, last: usize, m: usize) -> Vec<f64> {
        let wave = PI * m as f64 / self.length;
        let is_ring = m > 0 && wave * self.inner_radius <= SHORT_WAVE;
        let both = [self.inner_radius, self.outer_radius];
        let both = both.map(|radius| if is_ring { bessel(last, wave * radius) } else { Vec::new() });
        (0..=last).map(|n| self.conductance(n, m, &both)).collect()
    }

    /// The conductance of a mode, by Bessel's functions at both radii.
    fn conductance(&self, n: usize, m: usize, both: &[Vec<[Logarithmic; 2]>; 2]) -> f64 {
        let Self { inner_radius: inner, outer_radius: outer, conductivity, transfer, .. } = *self;
        if n == 0 && m == 0 {
            return 1.0 / (inner * ((outer / inner).ln() / conductivity + 1.0 / (transfer * outer)));
        }
        let wave = PI * m as f64 / self.length;
        if !(wave * inner).is_finite() {
            return f64::NAN;
        }
        if wave * inner > SHORT_WAVE {
            // The ring is a plate to waves much shorter than its radius.
            let (decay, thickness) = ((n as f64 / inner).hypot(wave), outer - inner);
            let (slope, tanh) = (conductivity * decay, (decay * thickness).tanh());
            return slope * (slope * tanh + transfer) / (slope + transfer * tanh);
        }
        // Of the two solutions, one grows with the radius and is 1 outside, and one falls and is 1 inside: slopes over
        // values, both sides, and the ratio of the lesser value to 1.
        let (grows, falls);
        let (least_grows, least_falls);
        if m == 0 {
            let slope = |radius: f64| n as f64 / radius;
            let power = (inner / outer).powi(i32::try_from(n).expect("a mode"));
            (grows, falls) = ([inner, outer].map(slope), [inner, outer].map(|radius| -slope(radius)));
            (least_grows, least_falls) = (power, power);
        } else {
            let [i, k] = [0, 1].map(|kind| both.each_ref().map(|at_radius| at_radius[n][kind]));
            (grows, falls) = (i.map(|i| wave * i.slope), k.map(|k| wave * k.slope));
            (least_grows, least_falls) = ((i[0].log - i[1].log).exp(), (k[1].log - k[0].log).exp());
        }
        let share = least_falls * (-conductivity * falls[1] - transfer) / (conductivity * grows[1] + transfer);
        let value = 1.0 + share * least_grows;
        -conductivity * (falls[0] + share * least_grows * grows[0]) / value
    }
}

/// A ring, with the modes by which its temperature is described.
#[derive(Debug, Clone, PartialEq)]
pub struct BushRing {
    /// The ring.
    pub shape: BushShape,
    /// Greatest n: waves around.
    pub around: usize,
    /// Greatest m: half waves along.
    pub along: usize,
    /// Conductance of each mode times the integral of its square over the bore [W/K].
    pub(crate) conductances: Vec<f64>,
}

impl BushRing {
    /// Waves around that follow a film well.
    pub const AROUND: usize = 24;
    /// Half waves along that follow a film well.
    pub const ALONG: usize = 4;

    /// A ring with modes up to `around` waves around and `along` half waves along it.
    pub fn new(shape: BushShape, around: usize, along: usize) -> Self {
        let bore = 2.0 * PI * shape.inner_radius * shape.length;
        let half = |index: usize| if index == 0 { 1.0 } else { 0.5 };
        let by_waves: Vec<_> = (0..=along).map(|m| shape.conductances(around, m)).collect();
        let mut conductances = Vec::new();
        for n in 0..=around {
            for _ in 0..if n == 0 { 1 } else { 2 } {
                conductances.extend((0..=along).map(|m| by_waves[m][n] * bore * half(n) * half(m)));
            }
        }
        Self { shape, around, along, conductances }
    }

    /// Number of modes.
    pub fn modes(&self) -> usize {
        self.conductances.len()
    }

    /// Temperature [K] of the bore at an angle [rad] and a place z/L, for the amplitudes of the modes [K].
    pub fn temperature(&self, modes: &[f64], angle: f64, along: f64) -> f64 {
        let (around, axial) = self.waves(angle, along);
        let rows = modes.chunks_exact(axial.len()).zip(around);
        let row = |row: &[f64]| row.iter().zip(&axial).map(|(mode, wave)| mode * wave).sum::<f64>();
        self.shape.ambient + rows.map(|(modes, wave)| wave * row(modes)).sum::<f64>()
    }

    /// Factors of the modes at a place: {1, cos phi, sin phi, cos 2 phi, ..}, and those along. The mode of index
    /// `a (along + 1) + m` is the product of factor `a` of the first and `m` of the second.
    pub(crate) fn waves(&self, angle: f64, along: f64) -> (Vec<f64>, Vec<f64>) {
        let mut around = Vec::with_capacity(2 * self.around + 1);
        around.push(1.0);
        let (sine, cosine) = angle.sin_cos();
        let (mut s, mut c) = (0.0, 1.0);
        for _ in 0..self.around {
            (s, c) = (s * cosine + c * sine, c * cosine - s * sine);
            around.extend([c, s]);
        }
        let axial = (0..=self.along).map(|m| (PI * m as f64 * (along + 0.5)).cos()).collect();
        (around, axial)
    }
}
