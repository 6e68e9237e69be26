//! # The rigid rotor
//!
//! **Equation.** `M e'' + C e' + K e = 0` for the mass M that one of the bearings carries, the journal parallel to
//! itself. Its roots s satisfy `M^2 s^4 + M tr C s^3 + (M tr K + det C) s^2 + k tr C s + det K = 0` with
//! `k = (K_xx C_yy + K_yy C_xx - K_xy C_yx - K_yx C_xy)/tr C`. At the threshold of stability a pair of roots is
//! `+- i omega_w`:
//! ```text
//! omega_w^2 = ((K_xx - k)(K_yy - k) - K_xy K_yx)/det C        M_crit = k/omega_w^2
//! ```
//! By the conditions of Routh and Hurwitz the rotor is stable below that mass, and with any mass where
//! `omega_w^2 <= 0`; with none where k or det K is negative. The logarithmic decrement of a root is
//! `-2 pi Re s/|Im s|`.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | M_crit | kg | [`Threshold::mass`] |
//! | omega_w | rad/s | [`Threshold::frequency`] |
//!
//! **Source.** Lund, Thomsen (1978); Routh, A Treatise on the Stability of a Given State of Motion (1877). **Range.**
//! Small motions of a rotor without gyroscopic moments. **Verified by** the roots at the threshold, and ROSS in
//! `tests/crosscheck`.

use std::f64::consts::TAU;

use super::Coefficients;

/// The threshold of stability.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold {
    /// Greatest mass [kg] of a stable rotor for each of its bearings.
    pub mass: f64,
    /// Frequency of the whirl there [rad/s].
    pub frequency: f64,
}

/// Whether a rigid rotor is stable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Stability {
    /// With any mass.
    Always,
    /// With less mass than at the threshold.
    Below(Threshold),
    /// With no mass.
    Never,
    /// Stability is not known: the film does not damp all motions, or no whirl has the frequency for which its
    /// coefficients hold.
    Undetermined,
}

/// What decides: `k` [N/m], and `omega_w^2` [1/s^2], both not finite where nothing is damped.
pub(super) fn threshold(of: &Coefficients) -> [f64; 2] {
    let (stiffness, damping) = (Coefficients::forces(&of.stiffness), Coefficients::forces(&of.damping));
    let k = mixed(stiffness, damping) / (damping[0][0] + damping[1][1]);
    let [[xx, xy], [yx, yy]] = stiffness;
    [k, ((xx - k) * (yy - k) - xy * yx) / determinant(damping)]
}

/// Whether a rigid rotor is stable with these coefficients.
pub fn stability(of: &Coefficients) -> Stability {
    let (stiffness, damping) = (Coefficients::forces(&of.stiffness), Coefficients::forces(&of.damping));
    let [k, square] = threshold(of);
    let damps = damping[0][0] + damping[1][1] > 0.0 && determinant(damping) > 0.0;
    if !(damps && k.is_finite() && square.is_finite()) {
        return Stability::Undetermined;
    }
    match k > 0.0 && determinant(stiffness) > 0.0 {
        false => Stability::Never,
        true if square <= 0.0 => Stability::Always,
        true => Stability::Below(Threshold { mass: k / square, frequency: square.sqrt() }),
    }
}

/// A whirl of a rigid rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whirling {
    /// Logarithmic decrement [1]; negative: it grows.
    pub decrement: f64,
    /// Frequency [rad/s].
    pub frequency: f64,
}

/// The least damped whirl of a rigid rotor of this mass [kg]; `None` where all its motions creep.
pub fn whirling(of: &Coefficients, mass: f64) -> Option<Whirling> {
    let (stiffness, damping) = (Coefficients::forces(&of.stiffness), Coefficients::forces(&of.damping));
    let trace = |[[xx, _], [_, yy]]: [[f64; 2]; 2]| xx + yy;
    let monic = [
        determinant(stiffness) / (mass * mass),
        mixed(stiffness, damping) / (mass * mass),
        trace(stiffness) / mass + determinant(damping) / (mass * mass),
        trace(damping) / mass,
    ];
    // A real root, found twice or beside another one, has an imaginary part of rounding.
    const CREEPS: f64 = 1e-7;
    let whirls = roots(monic)
        .into_iter()
        .filter(|[re, im]| *im > CREEPS * re.hypot(*im))
        .map(|[re, im]| Whirling { decrement: -TAU * re / im, frequency: im });
    whirls.min_by(|a, b| a.decrement.total_cmp(&b.decrement))
}

fn determinant([[xx, xy], [yx, yy]]: [[f64; 2]; 2]) -> f64 {
    xx * yy - xy * yx
}

/// `K_xx C_yy + K_yy C_xx - K_xy C_yx - K_yx C_xy`.
fn mixed(stiffness: [[f64; 2]; 2], damping: [[f64; 2]; 2]) -> f64 {
    let ([[k_xx, k_xy], [k_yx, k_yy]], [[c_xx, c_xy], [c_yx, c_yy]]) = (stiffness, damping);
    k_xx * c_yy + k_yy * c_xx - k_xy * c_yx - k_yx * c_xy
}

type Complex = [f64; 2];

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

fn over(a: Complex, [c, d]: Complex) -> Complex {
    let square = c * c + d * d;
    times(a, [c / square, -d / square])
}

/// The roots of `s^4 + a_3 s^3 + a_2 s^2 + a_1 s + a_0`, all at once (Durand, Kerner: Kerner, Numer. Math. 8 (1966)
/// 290).
fn roots(coefficients: [f64; 4]) -> [Complex; 4] {
    const MOST_STEPS: usize = 500;
    const STILL: f64 = 1e-15;
    // In units of a bound of the roots (Fujiwara).
    let bound = |(k, a): (usize, &f64)| 2.0 * a.abs().powf(1.0 / (4 - k) as f64);
    let unit = coefficients.iter().enumerate().map(bound).fold(f64::MIN_POSITIVE, f64::max);
    let scaled = [0, 1, 2, 3].map(|k| coefficients[k] / unit.powi(4 - k as i32));
    let value = |s: Complex| {
        let horner = |sum: Complex, a: &f64| {
            let [re, im] = times(sum, s);
            [re + a, im]
        };
        scaled.iter().rev().fold([1.0, 0.0], horner)
    };
    let mut roots = [[0.4, 0.9], [-0.65, 0.72], [-0.908, -0.297], [0.1, -1.0]];
    for _ in 0..MOST_STEPS {
        let mut moved = 0.0f64;
        for k in 0..4 {
            let others = (0..4).filter(|&other| other != k);
            let product = others.fold([1.0, 0.0], |product, other| {
                times(product, [roots[k][0] - roots[other][0], roots[k][1] - roots[other][1]])
            });
            let [re, im] = over(value(roots[k]), product);
            if !(re.is_finite() && im.is_finite()) {
                continue;
            }
            roots[k] = [roots[k][0] - re, roots[k][1] - im];
            moved = moved.max(re.hypot(im));
        }
        if moved < STILL {
            break;
        }
    }
    roots.map(|[re, im]| [unit * re, unit * im])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(stiffness: [[f64; 2]; 2], damping: [[f64; 2]; 2]) -> Coefficients {
        let square = |[[a, b], [c, d]]: [[f64; 2]; 2]| [[a, b, 0.0, 0.0], [c, d, 0.0, 0.0], [0.0; 4], [0.0; 4]];
        Coefficients { stiffness: square(stiffness), damping: square(damping), order: 2 }
    }

    /// A short bearing with a half film at the eccentricity 0.5: `tests/data/tilted_bearings.json`.
    fn short() -> Coefficients {
        of([[2.92325, 3.97664], [-0.8577, 2.20994]], [[6.61476, 2.24496], [2.24496, 3.05392]])
    }

    #[test]
    fn at_the_threshold_a_whirl_neither_grows_nor_decays() {
        let Stability::Below(Threshold { mass, frequency }) = stability(&short()) else {
            panic!("{:?}", stability(&short()));
        };
        assert!((mass - 6.4604).abs() < 2e-4 && (frequency - 0.51464).abs() < 2e-5, "{mass} {frequency}");
        let there = whirling(&short(), mass).expect("it whirls");
        assert!(there.decrement.abs() < 1e-12 && (there.frequency - frequency).abs() < 1e-12, "{there:?}");
        let decrement = |part: f64| whirling(&short(), part * mass).expect("it whirls").decrement;
        assert!(decrement(0.9) > 0.0 && decrement(1.1) < 0.0);
    }

    #[test]
    fn a_bearing_may_be_stable_with_any_mass_or_with_none() {
        let damping = [[2.0, 0.1], [0.1, 1.0]];
        assert_eq!(stability(&of([[3.0, 0.2], [0.2, 2.0]], damping)), Stability::Always);
        assert_eq!(stability(&of([[-3.0, 0.2], [0.2, 2.0]], damping)), Stability::Never);
        assert_eq!(stability(&of([[3.0, 0.0], [0.0, 2.0]], [[0.0; 2]; 2])), Stability::Undetermined);
        assert_eq!(stability(&of([[3.0, 0.0], [0.0, 2.0]], [[1.0, 0.0], [0.0, -0.1]])), Stability::Undetermined);
    }

    /// One degree of freedom: `M s^2 + C s + K`, and a second one that creeps.
    #[test]
    fn the_decrement_is_that_of_an_oscillator() {
        let (k, c, m) = (400.0, 3.0, 2.0);
        let found = whirling(&of([[k, 0.0], [0.0, 1.0]], [[c, 0.0], [0.0, 50.0]]), m).expect("it whirls");
        let (re, im) = (-c / (2.0 * m), (k / m - (c / (2.0 * m)).powi(2)).sqrt());
        assert!(
            (found.frequency / im - 1.0).abs() < 1e-12 && (found.decrement + TAU * re / im).abs() < 1e-12,
            "{found:?}"
        );
        assert_eq!(whirling(&of([[1.0, 0.0], [0.0, 1.0]], [[90.0, 0.0], [0.0, 50.0]]), m), None);
    }

    #[test]
    fn roots_are_found_over_many_orders() {
        for scale in [1e-6, 1.0, 1e7f64] {
            let wanted = [[-1.0, 2.0], [-1.0, -2.0], [-0.25, 0.0], [-3.0, 0.0]];
            // (s^2 + 2 s + 5)(s^2 + 3.25 s + 0.75)
            let coefficients = [3.75 * scale.powi(4), 17.75 * scale.powi(3), 12.25 * scale * scale, 5.25 * scale];
            let found = roots(coefficients);
            for [re, im] in wanted {
                let off = |[a, b]: &Complex| (a / scale - re).hypot(b / scale - im);
                assert!(found.iter().any(|root| off(root) < 1e-12), "{scale:e}: {found:?}");
            }
        }
    }
}
