//! Which triangles to refine: the fewest that carry a given share of an indicator (bulk marking).
//!
//! Source: W. Doerfler, A convergent adaptive algorithm for Poisson's equation, SIAM J. Numer. Anal. 33 (1996)
//! 1106-1124.

/// Marks the fewest entries whose magnitudes add up to `share` of the sum of all; ties go to the lesser number.
/// Nothing is marked where there is nothing to refine for: an indicator of zeros, or a share of zero. Entries that are
/// not finite are marked, for nothing is known there.
pub fn doerfler(indicator: &[f64], share: f64) -> Vec<bool> {
    let mut marked: Vec<bool> = indicator.iter().map(|value| !value.is_finite()).collect();
    let mut order: Vec<usize> = (0..indicator.len()).filter(|&t| indicator[t].is_finite()).collect();
    order.sort_by(|&a, &b| indicator[b].abs().total_cmp(&indicator[a].abs()).then(a.cmp(&b)));
    let all: f64 = order.iter().rev().map(|&t| indicator[t].abs()).sum();
    let mut reached = 0.0;
    for t in order {
        if reached >= share * all || indicator[t] == 0.0 {
            break;
        }
        reached += indicator[t].abs();
        marked[t] = true;
    }
    marked
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(marked: &[bool]) -> Vec<usize> {
        (0..marked.len()).filter(|&t| marked[t]).collect()
    }

    #[test]
    fn the_fewest_that_carry_the_share_are_marked() {
        let indicator = [1.0, -4.0, 2.0, 3.0];
        assert_eq!(places(&doerfler(&indicator, 0.7)), [1, 3]);
        assert_eq!(places(&doerfler(&indicator, 0.4)), [1]);
        assert_eq!(places(&doerfler(&indicator, 0.71)), [1, 2, 3]);
        assert_eq!(places(&doerfler(&indicator, 1.0)), [0, 1, 2, 3]);
        assert_eq!(places(&doerfler(&indicator, 2.0)), [0, 1, 2, 3]);
    }

    #[test]
    fn nothing_is_marked_for_nothing() {
        assert!(doerfler(&[], 0.7).is_empty());
        assert_eq!(places(&doerfler(&[0.0, 0.0], 0.7)), [0; 0]);
        assert_eq!(places(&doerfler(&[1.0, 2.0], 0.0)), [0; 0]);
        assert_eq!(places(&doerfler(&[1.0, 0.0], 1.0)), [0]);
    }

    #[test]
    fn equal_entries_are_marked_in_their_order_and_unknown_ones_always() {
        assert_eq!(places(&doerfler(&[1.0; 4], 0.5)), [0, 1]);
        assert_eq!(places(&doerfler(&[1.0, f64::NAN, 3.0], 0.7)), [1, 2]);
        assert_eq!(places(&doerfler(&[f64::INFINITY, 1.0], 0.1)), [0, 1]);
    }
}
