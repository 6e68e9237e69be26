//! The time integration: a singly diagonally implicit Runge-Kutta method of order 4 with an embedded one of order 3, six stages of which the first is
//! explicit. It is L-stable and stiffly accurate: the last stage is the end of the step.
//!
//! ```text
//! x_i = x_n + dt sum_{j<=i} a_ij x_j'        x_{n+1} = x_6        error = dt sum_j (a_6j - b_j) x_j'
//! ```
//!
//! **Source.** Kennedy and Carpenter, Appl. Numer. Math. 44 (2003) 139, ARK4(3)6L\[2\]SA, implicit part.

/// Number of stages; the first is the end of the step before.
pub(crate) const STAGES: usize = 6;
/// The common coefficient a_ii of the implicit stages.
pub(crate) const DIAGONAL: f64 = 0.25;
/// Order of the embedded method plus one: its local error goes like this power of the step.
pub(crate) const ERROR_POWER: f64 = 4.0;

/// Times of the stages in steps.
pub(crate) const NODES: [f64; STAGES] = [0.0, 0.5, 83.0 / 250.0, 31.0 / 50.0, 17.0 / 20.0, 1.0];

/// The coefficients a_ij.
pub(crate) const COEFFICIENTS: [[f64; STAGES]; STAGES] = [
    [0.0; STAGES],
    [0.25, DIAGONAL, 0.0, 0.0, 0.0, 0.0],
    [8611.0 / 62_500.0, -1743.0 / 31_250.0, DIAGONAL, 0.0, 0.0, 0.0],
    [
        5_012_029.0 / 34_652_500.0,
        -654_441.0 / 2_922_500.0,
        174_375.0 / 388_108.0,
        DIAGONAL,
        0.0,
        0.0,
    ],
    [
        15_267_082_809.0 / 155_376_265_600.0,
        -71_443_401.0 / 120_774_400.0,
        730_878_875.0 / 902_184_768.0,
        2_285_395.0 / 8_070_912.0,
        DIAGONAL,
        0.0,
    ],
    [
        82_889.0 / 524_892.0,
        0.0,
        15_625.0 / 83_664.0,
        69_875.0 / 102_672.0,
        -2260.0 / 8211.0,
        DIAGONAL,
    ],
];

/// The weights b_j of the embedded method.
pub(crate) const EMBEDDED: [f64; STAGES] = [
    4_586_570_599.0 / 29_645_900_160.0,
    0.0,
    178_811_875.0 / 945_068_544.0,
    814_220_225.0 / 1_159_782_912.0,
    -3_700_637.0 / 11_593_932.0,
    61_727.0 / 225_920.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn product(a: &[f64; STAGES], b: &[f64; STAGES]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn weighted(vector: &[f64; STAGES]) -> [f64; STAGES] {
        COEFFICIENTS.map(|row| product(&row, vector))
    }

    fn powers(power: i32) -> [f64; STAGES] {
        NODES.map(|node| node.powi(power))
    }

    /// Order conditions by rooted trees (Hairer, Norsett, Wanner, Solving ODEs I, II.2).
    #[test]
    fn the_methods_have_orders_four_and_three() {
        let one = [1.0; STAGES];
        for (row, node) in COEFFICIENTS.iter().zip(NODES) {
            assert!((product(row, &one) - node).abs() < 1e-14, "{row:?}");
        }
        let [c, c2, c3] = [1, 2, 3].map(powers);
        let (ac, ac2) = (weighted(&c), weighted(&c2));
        let mut c_ac = ac;
        c_ac.iter_mut().zip(NODES).for_each(|(entry, node)| *entry *= node);
        let third = [(one, 1.0), (c, 1.0 / 2.0), (c2, 1.0 / 3.0), (ac, 1.0 / 6.0)];
        let fourth = [
            (c3, 1.0 / 4.0),
            (c_ac, 1.0 / 8.0),
            (ac2, 1.0 / 12.0),
            (weighted(&ac), 1.0 / 24.0),
        ];
        let last = COEFFICIENTS[STAGES - 1];
        for (tree, value) in third.into_iter().chain(fourth) {
            assert!((product(&last, &tree) - value).abs() < 1e-14, "{value}");
        }
        for (tree, value) in third {
            assert!((product(&EMBEDDED, &tree) - value).abs() < 1e-14, "{value}");
        }
        let differs = fourth
            .iter()
            .any(|(tree, value)| (product(&EMBEDDED, tree) - value).abs() > 1e-4);
        assert!(differs, "the embedded method is of order 4: it tells no error");
    }
}
