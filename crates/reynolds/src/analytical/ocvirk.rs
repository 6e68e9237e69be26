//! # Infinitely short bearing, turning and squeezed
//!
//! **Equation.** With `H = 1 - eps cos(phi)`, phi from the **narrowest** film in the sense of positive speeds,
//! `d/dz (h^3 dp/dz) = 6 mu omega dh/dphi + 12 mu dh/dt` gives above the end pressure
//! `p = -(3 mu/c^2) (B^2/4 - z^2) [(omega - 2 delta') eps sin(phi) - 2 eps' cos(phi)] / H^3`, delta the angle of the
//! narrowest film. The half film of Guembel is loaded over `phi_H .. phi_H + pi`, `phi_H = atan2(E, eps G) + pi`. With
//! `A_k^mn = Int sin^m cos^n / H^k dphi` over that half and all forces over `B D (mu omega_0/psi^2) (B/D)^2`:
//! `W = E A_3^02 - eps G A_3^11` towards the narrowest film, `V = E A_3^11 - eps G A_3^20` a quarter turn on, attitude
//! `atan2(-V, W)`. Sommerfeld's substitution `H = (1 - eps^2)/(1 + eps cos(gamma))` makes every integral one of sines
//! and cosines.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | eps = e/c | - | `eccentricity` |
//! | G = (omega - 2 delta')/omega_0 | - | `rotation` |
//! | E = 2 eps'/omega_0 | - | `closing` |
//! | phi_H | rad | [`ShortFilm::loaded_from`] |
//! | W, V | - | `along`, `across` |
//! | q, kN | - | [`ShortFilm::side_flow`], [`ShortFilm::pumping_power`], [`shear_power`] |
//!
//! **Source.** Ocvirk, NACA TN 2808 (1952); DuBois & Ocvirk, NACA Rep. 1157 (1953); the substitution: Booker, J. Basic
//! Eng. 87 (1965) 537.
//! **Range.** B/D small, 0 <= eps < 1, any signs of G and E. **Verified by** the tests below against sums of the
//! pressure, and `tests/tests/literature/short_crankshaft_bearing.rs`.

use std::f64::consts::{PI, TAU};

/// A short film, its speeds in parts of a reference angular velocity `omega_0`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortFilm {
    /// Relative eccentricity eps in [0, 1).
    pub eccentricity: f64,
    /// `G`: speed of the journal less twice that of the line of centres.
    pub rotation: f64,
    /// `E`: twice the rate of eps; positive while the narrowest film closes.
    pub closing: f64,
}

/// The integrals `A_k^mn` of a loaded part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Integrals {
    /// `Int 1/H`.
    pub a1_00: f64,
    /// `Int 1/H^2`.
    pub a2_00: f64,
    /// `Int 1/H^3`.
    pub a3_00: f64,
    /// `Int cos^2/H^3`.
    pub a3_02: f64,
    /// `Int sin cos/H^3`.
    pub a3_11: f64,
    /// `Int sin^2/H^3`.
    pub a3_20: f64,
}

/// External force that a short film carries, over `B D (mu omega_0/psi^2) (B/D)^2`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShortLoad {
    /// `W`: towards the narrowest film.
    pub along: f64,
    /// `V`: towards the point a quarter turn on in the sense of positive speeds.
    pub across: f64,
}

impl ShortLoad {
    /// Sommerfeld number over `(B/D)^2`, with omega_0 for the speed.
    pub fn magnitude(self) -> f64 {
        self.along.hypot(self.across)
    }

    /// Angle [rad] from the load to the narrowest film, in (-pi, pi], positive in the sense of positive speeds.
    pub fn attitude(self) -> f64 {
        (-self.across).atan2(self.along)
    }
}

impl ShortFilm {
    /// The film of a journal that turns at `omega_0` about a centre at rest.
    pub fn steady(eccentricity: f64) -> Self {
        Self { eccentricity, rotation: 1.0, closing: 0.0 }
    }

    /// Pressure of the full film `p psi^2/(mu omega_0)` over `(B/D)^2`, at `phi` [rad] from the narrowest film and the
    /// axial position `zeta = 2 z/B` in [-1, 1]. Negative outside the loaded half.
    pub fn pressure(&self, phi: f64, zeta: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        let film = 1.0 - self.eccentricity * cos;
        let drive = self.eccentricity * self.rotation * sin - self.closing * cos;
        -3.0 * drive / film.powi(3) * (1.0 - zeta * zeta)
    }

    /// Where the loaded half begins: `phi_H` [rad] in (0, 2 pi]; it ends half a turn on.
    pub fn loaded_from(&self) -> f64 {
        self.closing.atan2(self.eccentricity * self.rotation) + PI
    }

    /// The integrals over the loaded half.
    pub fn half_integrals(&self) -> Integrals {
        let from = self.substituted(self.loaded_from());
        let to = self.substituted(self.loaded_from() + PI);
        self.integrals(from, from + (to - from).rem_euclid(TAU))
    }

    /// The integrals over the whole circumference.
    pub fn full_integrals(&self) -> Integrals {
        self.integrals(0.0, TAU)
    }

    /// Load of the half film of Guembel.
    pub fn half_film(&self) -> ShortLoad {
        self.load(&self.half_integrals())
    }

    /// Load of the full film.
    pub fn full_film(&self) -> ShortLoad {
        self.load(&self.full_integrals())
    }

    /// Oil that leaves the loaded half at both ends, `q = Q/(B D^2 psi omega_0/2)`:
    /// `Q = R c B omega_0 sqrt((eps G)^2 + E^2)`.
    pub fn side_flow(&self) -> f64 {
        0.5 * (self.eccentricity * self.rotation).hypot(self.closing)
    }

    /// Power that drives oil out of the half film, `-eps G V/2` and `E W/2`, over
    /// `(B D^2/2) (mu omega_0^2/psi) (B/D)^2`.
    pub fn pumping_power(&self) -> [f64; 2] {
        let load = self.half_film();
        [-0.5 * self.eccentricity * self.rotation * load.across, 0.5 * self.closing * load.along]
    }

    /// `gamma` [rad] at the angle `phi` [rad].
    fn substituted(&self, phi: f64) -> f64 {
        let (sin, cos) = phi.sin_cos();
        ((1.0 - self.eccentricity * self.eccentricity).sqrt() * sin).atan2(cos - self.eccentricity)
    }

    /// The integrals from one `gamma` to another.
    fn integrals(&self, from: f64, to: f64) -> Integrals {
        let eps = self.eccentricity;
        let rest = 1.0 - eps * eps;
        let turn = to - from;
        let (sin, cos) = (to.sin() - from.sin(), to.cos() - from.cos());
        let twice = 0.25 * ((2.0 * to).sin() - (2.0 * from).sin());
        let sin_cos = 0.5 * (to.sin().powi(2) - from.sin().powi(2));
        let a3_20 = (0.5 * turn - twice) / rest.powf(1.5);
        let a3_02 = (eps * eps * turn + 2.0 * eps * sin + 0.5 * turn + twice) / rest.powf(2.5);
        Integrals {
            a1_00: turn / rest.sqrt(),
            a2_00: (turn + eps * sin) / rest.powf(1.5),
            a3_00: a3_02 + a3_20,
            a3_02,
            a3_11: (sin_cos - eps * cos) / rest.powi(2),
            a3_20,
        }
    }

    fn load(&self, a: &Integrals) -> ShortLoad {
        let rotation = self.eccentricity * self.rotation;
        ShortLoad {
            along: self.closing * a.a3_02 - rotation * a.a3_11,
            across: self.closing * a.a3_11 - rotation * a.a3_20,
        }
    }
}

/// Power that shears a film all around, over `(B D^2/2) (mu omega_0^2/psi)`, at the journal's own speed in parts of
/// omega_0.
pub fn shear_power(eccentricity: f64, speed: f64) -> f64 {
    PI * speed * speed / (1.0 - eccentricity * eccentricity).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: u32 = 40_000;

    fn films() -> impl Iterator<Item = ShortFilm> {
        let speeds = [(1.0, 0.0), (0.4, 0.4), (0.0, 0.3), (-0.7, 0.2), (0.5, -0.6), (-1.0, -0.1), (0.0, -1.0)];
        [0.0, 1e-6, 0.3, 0.8].into_iter().flat_map(move |eccentricity| {
            speeds.map(|(rotation, closing)| ShortFilm { eccentricity, rotation, closing })
        })
    }

    /// `Int f dphi` by the middles of [`POINTS`] pieces of `from .. from + span`.
    fn sum(from: f64, span: f64, f: impl Fn(f64) -> f64) -> f64 {
        let piece = span / f64::from(POINTS);
        (0..POINTS).map(|k| f(from + (f64::from(k) + 0.5) * piece)).sum::<f64>() * piece
    }

    /// The middle rule errs by `piece^2` times a second derivative, which is some hundreds at eps = 0.8.
    fn assert_near(found: f64, sum: f64, what: &str, film: &ShortFilm) {
        assert!((found - sum).abs() < 3e-7 * (1.0 + sum.abs()), "{what} of {film:?}: {found}, sum {sum}");
    }

    #[test]
    fn integrals_are_those_of_their_names() {
        for film in films() {
            let eps = film.eccentricity;
            let cases = [(film.half_integrals(), film.loaded_from(), PI), (film.full_integrals(), 0.0, TAU)];
            for (a, from, span) in cases {
                // Powers of sine and cosine above, of the film below.
                let named = [
                    (a.a1_00, [0, 0, 1], "A1_00"),
                    (a.a2_00, [0, 0, 2], "A2_00"),
                    (a.a3_00, [0, 0, 3], "A3_00"),
                    (a.a3_02, [0, 2, 3], "A3_02"),
                    (a.a3_11, [1, 1, 3], "A3_11"),
                    (a.a3_20, [2, 0, 3], "A3_20"),
                ];
                for (found, [m, n, k], what) in named {
                    let right =
                        sum(from, span, |phi| phi.sin().powi(m) * phi.cos().powi(n) / (1.0 - eps * phi.cos()).powi(k));
                    assert_near(found, right, what, &film);
                }
            }
        }
    }

    /// Force, side flow and pumping power, summed from the pressure alone; the load is where the pressure is positive.
    #[test]
    fn the_half_film_is_where_pressure_is_positive() {
        // Over zeta: Int (1 - zeta^2) = 4/3; So = 1/4 Int Int P (cos, sin) dzeta dphi.
        const ACROSS_THE_WIDTH: f64 = 1.0 / 3.0;
        for film in films() {
            let loaded = |phi: f64| film.pressure(phi, 0.0).max(0.0);
            let along = sum(0.0, TAU, |phi| ACROSS_THE_WIDTH * loaded(phi) * phi.cos());
            let across = sum(0.0, TAU, |phi| ACROSS_THE_WIDTH * loaded(phi) * phi.sin());
            let load = film.half_film();
            assert_near(load.along, along, "W", &film);
            assert_near(load.across, across, "V", &film);
            assert_near(load.magnitude(), along.hypot(across), "So", &film);
            // Both ends: dp/dzeta = 2 p(0), Q = 2 R Int h^3/(12 mu) |dp/dz| dphi is q = 1/12 Int H^3 P(phi, 0) dphi.
            let thick = |phi: f64| (1.0 - film.eccentricity * phi.cos()).powi(3);
            assert_near(film.side_flow(), sum(0.0, TAU, |phi| thick(phi) * loaded(phi) / 12.0), "q", &film);
            // Int h^3/(12 mu) (dp/dz)^2 dA, with Int (2 zeta)^2 dzeta = 8/3, is kN = 1/18 Int H^3 P(phi, 0)^2 dphi.
            let dissipated = sum(0.0, TAU, |phi| thick(phi) * loaded(phi).powi(2) / 18.0);
            assert_near(film.pumping_power().iter().sum(), dissipated, "kN", &film);
            let full = film.full_film();
            let whole = |phi: f64| ACROSS_THE_WIDTH * film.pressure(phi, 0.0);
            assert_near(full.along, sum(0.0, TAU, |phi| whole(phi) * phi.cos()), "W", &film);
            assert_near(full.across, sum(0.0, TAU, |phi| whole(phi) * phi.sin()), "V", &film);
            let shear = sum(0.0, TAU, |phi| 0.25 * 2.0 / (1.0 - film.eccentricity * phi.cos()));
            assert_near(shear_power(film.eccentricity, 1.0), shear, "kN1", &film);
        }
    }

    /// Turned about, a film is its mirror image.
    #[test]
    fn the_other_sense_is_the_mirror_image() {
        for film in films() {
            let load = film.half_film();
            let mirrored = ShortFilm { rotation: -film.rotation, ..film };
            assert_near(mirrored.half_film().along, load.along, "W", &film);
            assert_near(mirrored.half_film().across, -load.across, "V", &film);
        }
    }

    /// The closed forms as Ocvirk gives them.
    #[test]
    fn a_steady_film_is_ocvirks() {
        for eps in [0.05, 0.3, 0.6, 0.9, 0.99f64] {
            let rest = 1.0 - eps * eps;
            let film = ShortFilm::steady(eps);
            let half = film.half_film();
            let load = eps / (2.0 * rest * rest) * (PI * PI * rest + 16.0 * eps * eps).sqrt();
            assert!((half.magnitude() / load - 1.0).abs() < 1e-12, "{eps}");
            assert!((half.attitude() - (PI * rest.sqrt() / (4.0 * eps)).atan()).abs() < 1e-12, "{eps}");
            let full = film.full_film();
            assert!((full.magnitude() / (PI * eps / rest.powf(1.5)) - 1.0).abs() < 1e-12, "{eps}");
            assert!((full.attitude() - PI / 2.0).abs() < 1e-12, "{eps}");
            assert_eq!(film.side_flow(), 0.5 * eps);
        }
    }
}
