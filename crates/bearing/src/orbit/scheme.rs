//! The time integration: singly diagonally implicit Runge-Kutta methods whose first stage is explicit, the end of the
//! step before. They are L-stable and stiffly accurate: the last stage is the end of the step.
//!
//! ```text
//! x_i = x_n + dt sum_{j<=i} a_ij x_j'        x_{n+1} = x_s        error = dt sum_j (a_sj - b_j) x_j'
//! ```
//!
//! Films without memory are smooth in time but for their edges, and are followed by a method of order 4. Where the
//! cavity conserves its oil, nodes fill and empty at times that no step meets; the method of order 2 for them has
//! coefficients that are not negative, so that what a stage leaves to a cell is close to what the cell held.
//!
//! **Source.** Kennedy and Carpenter, Appl. Numer. Math. 44 (2003) 139, ARK4(3)6L\[2\]SA, implicit part; Bank,
//! Coughran, Fichtner, Grosse, Rose, Smith, IEEE Trans. Electron Devices 32 (1985) 1992, and Hosea, Shampine, Appl.
//! Numer. Math. 20 (1996) 21 (TR-BDF2).

use std::f64::consts::SQRT_2;

/// A method.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scheme {
    /// Times of the stages in steps.
    pub nodes: &'static [f64],
    /// The coefficients a_ij, up to and with the diagonal.
    pub coefficients: &'static [&'static [f64]],
    /// The common coefficient a_ii of the implicit stages.
    pub diagonal: f64,
    /// The weights b_j of the embedded method.
    pub embedded: &'static [f64],
    /// The local error that is estimated goes like this power of the step.
    pub error_power: f64,
}

impl Scheme {
    /// Number of stages; the first is the end of the step before.
    pub fn stages(&self) -> usize {
        self.nodes.len()
    }

    /// Weights of the rates of the stages in the estimate of the error.
    pub fn error_weights(&self) -> Vec<f64> {
        let last = self.coefficients[self.stages() - 1];
        last.iter().zip(self.embedded).map(|(last, other)| last - other).collect()
    }
}

/// Order 4 with an embedded method of order 3, six stages.
pub const FOURTH_ORDER: Scheme = Scheme {
    nodes: &[0.0, 0.5, 83.0 / 250.0, 31.0 / 50.0, 17.0 / 20.0, 1.0],
    coefficients: &[
        &[0.0],
        &[0.25, 0.25],
        &[8611.0 / 62_500.0, -1743.0 / 31_250.0, 0.25],
        &[5_012_029.0 / 34_652_500.0, -654_441.0 / 2_922_500.0, 174_375.0 / 388_108.0, 0.25],
        &[
            15_267_082_809.0 / 155_376_265_600.0,
            -71_443_401.0 / 120_774_400.0,
            730_878_875.0 / 902_184_768.0,
            2_285_395.0 / 8_070_912.0,
            0.25,
        ],
        &[82_889.0 / 524_892.0, 0.0, 15_625.0 / 83_664.0, 69_875.0 / 102_672.0, -2260.0 / 8211.0, 0.25],
    ],
    diagonal: 0.25,
    embedded: &[
        4_586_570_599.0 / 29_645_900_160.0,
        0.0,
        178_811_875.0 / 945_068_544.0,
        814_220_225.0 / 1_159_782_912.0,
        -3_700_637.0 / 11_593_932.0,
        61_727.0 / 225_920.0,
    ],
    error_power: 4.0,
};

/// TR-BDF2: order 2 with an embedded method of order 3, three stages.
pub const SECOND_ORDER: Scheme = Scheme {
    nodes: &[0.0, 2.0 - SQRT_2, 1.0],
    coefficients: &[
        &[0.0],
        &[1.0 - 0.5 * SQRT_2, 1.0 - 0.5 * SQRT_2],
        &[0.25 * SQRT_2, 0.25 * SQRT_2, 1.0 - 0.5 * SQRT_2],
    ],
    diagonal: 1.0 - 0.5 * SQRT_2,
    embedded: &[(1.0 - 0.25 * SQRT_2) / 3.0, (1.0 + 0.75 * SQRT_2) / 3.0, (1.0 - 0.5 * SQRT_2) / 3.0],
    error_power: 3.0,
};

#[cfg(test)]
mod tests {
    use super::*;

    fn product(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    fn weighted(scheme: &Scheme, vector: &[f64]) -> Vec<f64> {
        scheme.coefficients.iter().map(|row| product(row, vector)).collect()
    }

    fn powers(scheme: &Scheme, power: i32) -> Vec<f64> {
        scheme.nodes.iter().map(|node| node.powi(power)).collect()
    }

    /// Order conditions by rooted trees (Hairer, Norsett, Wanner, Solving ODEs I, II.2), by order.
    fn conditions(scheme: &Scheme) -> [Vec<(Vec<f64>, f64)>; 4] {
        let one = vec![1.0; scheme.stages()];
        let [c, c2, c3] = [1, 2, 3].map(|power| powers(scheme, power));
        let (ac, ac2) = (weighted(scheme, &c), weighted(scheme, &c2));
        let c_ac = ac.iter().zip(scheme.nodes).map(|(entry, node)| entry * node).collect();
        let aac = weighted(scheme, &ac);
        [
            vec![(one, 1.0)],
            vec![(c, 1.0 / 2.0)],
            vec![(c2, 1.0 / 3.0), (ac, 1.0 / 6.0)],
            vec![(c3, 1.0 / 4.0), (c_ac, 1.0 / 8.0), (ac2, 1.0 / 12.0), (aac, 1.0 / 24.0)],
        ]
    }

    /// The greatest order whose conditions these weights meet.
    fn order(scheme: &Scheme, weights: &[f64]) -> usize {
        let meets = |(tree, value): &(Vec<f64>, f64)| (product(weights, tree) - value).abs() < 1e-14;
        conditions(scheme).iter().take_while(|trees| trees.iter().all(meets)).count()
    }

    #[test]
    fn the_methods_have_their_orders() {
        for (scheme, orders) in [(FOURTH_ORDER, [4, 3]), (SECOND_ORDER, [2, 3])] {
            for (row, node) in scheme.coefficients.iter().zip(scheme.nodes) {
                assert!((row.iter().sum::<f64>() - node).abs() < 1e-14, "{row:?}");
            }
            let last = scheme.coefficients[scheme.stages() - 1];
            assert_eq!([order(&scheme, last), order(&scheme, scheme.embedded)], orders);
            // The estimate is of the lower of both orders.
            let lower = orders[0].min(orders[1]);
            assert_eq!(scheme.error_power, lower as f64 + 1.0);
        }
    }

    #[test]
    fn the_method_for_films_that_conserve_oil_leaves_no_cell_a_negative_share() {
        let coefficients = SECOND_ORDER.coefficients.iter().flat_map(|row| row.iter());
        assert!(coefficients.into_iter().all(|&entry| entry >= 0.0));
    }
}
