//! # Counterweights: how to move them between the webs so that the bearings fare best
//!
//! **Equation.** Mass times radius U_j of the webs at z_j may change by dU_j where the force and the moment that the
//! whole shaft puts on its bearings stay:
//! ```text
//! sum dU_j = 0,        sum z_j dU_j = 0
//! ```
//! With a basis b_k of the numbers that meet both, perpendicular to each other, `dU_j = sum_k b_kj a_k` has free
//! vectors a_k: two less than webs that may change.
//!
//! **Source.** Definition. **Range.** Webs at two places or more. **Verified by** the tests below.

use super::matrix::product;

/// The numbers on places z [m] that change neither sum nor moment: a basis of vectors one long and perpendicular to
/// each other.
pub fn neutral(places: &[f64]) -> Vec<Vec<f64>> {
    let n = places.len();
    let middle = places.iter().sum::<f64>() / n as f64;
    let mut basis: Vec<Vec<f64>> = Vec::new();
    let kept = [vec![1.0; n], places.iter().map(|z| z - middle).collect()];
    let units = (0..n).map(|k| (0..n).map(|j| f64::from(u8::from(j == k))).collect());
    let mut constraints = 0;
    for (number, mut vector) in (0..).zip(kept.into_iter().chain(units)) {
        let size = product(&vector, &vector).sqrt();
        // Twice, so that it is perpendicular to round-off.
        for _ in 0..2 {
            for other in &basis {
                let along = product(&vector, other);
                (vector.iter_mut().zip(other)).for_each(|(entry, part)| *entry -= along * part);
            }
        }
        let left = product(&vector, &vector).sqrt();
        if left > 1e-8 * size.max(f64::MIN_POSITIVE) {
            vector.iter_mut().for_each(|entry| *entry /= left);
            basis.push(vector);
            constraints += usize::from(number < 2);
        }
    }
    basis.split_off(constraints)
}

/// Changes [kg m] of what is out of balance on webs, by the free vectors of a [`neutral`] basis: two numbers for each
/// of its entries.
pub fn changes(basis: &[Vec<f64>], free: &[f64]) -> Vec<[f64; 2]> {
    let webs = basis.first().map_or(0, Vec::len);
    let change = |web: usize| {
        let sum = |towards: usize| {
            let parts = basis.iter().zip(free.chunks_exact(2));
            parts.map(|(vector, free)| vector[web] * free[towards]).sum()
        };
        [sum(0), sum(1)]
    };
    (0..webs).map(change).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_keep_force_and_moment() {
        let places = [0.03, 0.08, 0.13, 0.18, 0.24, 0.4];
        let basis = neutral(&places);
        assert_eq!(basis.len(), 4);
        let free: Vec<f64> = (0..8).map(|k| 0.01 * f64::from(k * k) - 0.2).collect();
        let changes = changes(&basis, &free);
        for towards in 0..2 {
            let sum: f64 = changes.iter().map(|change| change[towards]).sum();
            let moment: f64 = changes.iter().zip(places).map(|(change, z)| z * change[towards]).sum();
            assert!(sum.abs() < 1e-15 && moment.abs() < 1e-15, "{sum:e} {moment:e}");
        }
        assert!(neutral(&[0.1, 0.2]).is_empty());
    }

    /// Two webs, or three at one place: what stays neutral is what statics leaves.
    #[test]
    fn webs_at_one_place_exchange_their_weights() {
        assert_eq!(neutral(&[0.1, 0.1]).len(), 1);
        assert_eq!(neutral(&[0.1, 0.1, 0.3]).len(), 1);
    }
}
