//! How long a sweep will take, from the first cases of some of its chains.
//!
//! The first case of a chain is solved cold, those behind it start from their neighbours. Both times are averaged over
//! chains that are spread over the whole sweep.

use std::ops::Range;

/// Cases of each sampled chain.
pub(super) const SAMPLED: usize = 3;
/// Most chains that are sampled, in a long sweep.
const MOST: usize = 8;
/// One chain of this many cases is sampled in a short sweep; in any sweep, at least as many chains as there are
/// workers.
const ONE_OF: usize = 50;

/// How long a sweep will take.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Forecast {
    /// Cases that this run computes.
    pub cases: usize,
    /// Wall time of all of them [s], what has passed included.
    pub seconds: f64,
    /// Threads that compute them.
    pub threads: usize,
}

/// The chains with those in front that are sampled, spread evenly, and how many these are.
pub(super) fn samples_first(chains: Vec<Range<usize>>, workers: usize) -> (Vec<Range<usize>>, usize) {
    let cases: usize = chains.iter().map(Range::len).sum();
    let count = (cases / ONE_OF).min(MOST).max(workers).min(chains.len());
    // In the middle of each of `count` equal parts.
    let is_sample = |place: usize| (0..count).any(|k| (2 * k + 1) * chains.len() / (2 * count) == place);
    let (samples, others): (Vec<_>, Vec<_>) = (0..chains.len()).partition(|&place| is_sample(place));
    let order = samples.into_iter().chain(others);
    (order.map(|place| chains[place].clone()).collect(), count)
}

/// Wall time [s] of what is left of the chains after the first cases of the first `seconds.len()` of them took these
/// times [s]; `None` where nothing is left, or nothing was measured.
pub(super) fn rest(chains: &[Range<usize>], seconds: &[Vec<f64>], workers: usize) -> Option<f64> {
    let mean = |times: &[f64]| times.iter().sum::<f64>() / times.len().max(1) as f64;
    let measured: Vec<&Vec<f64>> = seconds.iter().filter(|times| !times.is_empty()).collect();
    let cold: Vec<f64> = measured.iter().map(|times| times[0]).collect();
    let warm = |times: &[f64]| {
        if times.len() > 1 { mean(&times[1..]) } else { mean(times) }
    };
    let each: Vec<f64> = measured.iter().map(|times| warm(times)).collect();
    let (cold, each) = (mean(&cold), mean(&each));
    let sampled = chains.iter().zip(seconds);
    let sampled = sampled.map(|(chain, times)| (chain.len() - times.len()) as f64 * warm(times));
    let others = chains.iter().skip(seconds.len());
    let others = others.map(|chain| cold + (chain.len() - 1) as f64 * each);
    let left: Vec<f64> = sampled.chain(others).collect();
    let longest = left.iter().copied().fold(0.0, f64::max);
    let total = longest.max(left.iter().sum::<f64>() / workers.max(1) as f64);
    (!measured.is_empty()).then_some(total)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_are_spread_and_no_chain_is_lost() {
        let chains: Vec<Range<usize>> = (0..100).map(|k| 50 * k..50 * (k + 1)).collect();
        let (order, count) = samples_first(chains.clone(), 2);
        assert_eq!(count, 8);
        let first: Vec<usize> = order[..count].iter().map(|chain| chain.start / 50).collect();
        assert_eq!(first, [6, 18, 31, 43, 56, 68, 81, 93]);
        let mut sorted = order;
        sorted.sort_by_key(|chain| chain.start);
        assert_eq!(sorted, chains);
        assert_eq!(samples_first(vec![0..4, 4..8, 8..12], 2).1, 2);
        assert_eq!(samples_first(Vec::new(), 0), (Vec::new(), 0));
    }

    #[test]
    fn the_rest_is_cold_and_warm_cases_of_the_chains_left() {
        // Ten cases a chain, the first of 5 s, all others of 1 s: 2 x 7 + 3 x 14 s on two threads.
        let chains: Vec<Range<usize>> = (0..5).map(|k| 10 * k..10 * (k + 1)).collect();
        let seconds = [vec![5.0, 1.0, 1.0], vec![5.0, 1.0, 1.0]];
        assert_eq!(rest(&chains, &seconds, 2), Some(28.0));
        assert_eq!(rest(&chains, &[], 2), None);
    }
}
