//! What draws say of a quantity: mean, standard deviation and percentiles, each with its sampling error.
//!
//! | number | its error, at 95 % | source |
//! |---|---|---|
//! | mean m | 1.96 s / sqrt(n) | central limit theorem |
//! | deviation s | 1.96 s sqrt((k - 1) / 4 n), k the kurtosis | delta method |
//! | percentile p | half the distance of the ranks n p -+ 1.96 sqrt(n p (1 - p)) | binomial law of ranks |
//! | share q | 1.96 sqrt(q (1 - q) / n); 3 / n where q is 0 or 1 | binomial law; Hanley and Lippman-Hand (1983) |
//!
//! A percentile interpolates linearly between ranks. Where the ranks of its error lie beyond the draws, the error is
//! not known: the first percentile needs some 400 draws. Tested by `tests` below against normal numbers.

/// Percentiles that are reported.
pub const PERCENTILES: [f64; 5] = [1.0, 5.0, 50.0, 95.0, 99.0];
/// Standard errors within which 95 % of all samples lie.
const ERRORS: f64 = 1.96;

/// A number that was estimated from draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleEstimate {
    /// The number.
    pub value: f64,
    /// Half width of the interval that holds the true one for 95 % of all seeds; `None` where there are too few draws.
    pub error: Option<f64>,
}

/// How a quantity is distributed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Statistics {
    /// Mean.
    pub mean: SampleEstimate,
    /// Standard deviation.
    pub deviation: SampleEstimate,
    /// The [`PERCENTILES`].
    pub percentiles: [SampleEstimate; PERCENTILES.len()],
}

impl Statistics {
    /// The statistics of draws; `None` of fewer than two.
    pub fn of(values: &[f64]) -> Option<Self> {
        if values.len() < 2 {
            return None;
        }
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let moment = |power: i32| values.iter().map(|value| (value - mean).powi(power)).sum::<f64>();
        let deviation = (moment(2) / (count - 1.0)).sqrt();
        let kurtosis = count * moment(4) / moment(2).powi(2);
        let of_deviation = ERRORS * deviation * ((kurtosis - 1.0) / (4.0 * count)).sqrt();
        Some(Self {
            mean: SampleEstimate { value: mean, error: Some(ERRORS * deviation / count.sqrt()) },
            deviation: SampleEstimate {
                value: deviation,
                error: Some(if deviation > 0.0 { of_deviation } else { 0.0 }),
            },
            percentiles: PERCENTILES.map(|percent| percentile(&sorted, 1e-2 * percent)),
        })
    }
}

/// The percentile `part` (from 0 to 1) of numbers in their order.
fn percentile(sorted: &[f64], part: f64) -> SampleEstimate {
    let count = sorted.len() as f64;
    let at = |rank: f64| {
        let below = rank.floor();
        let (first, next) = (sorted[below as usize], sorted[(below as usize + 1).min(sorted.len() - 1)]);
        first + (rank - below) * (next - first)
    };
    let rank = part * (count - 1.0);
    let reach = ERRORS * (count * part * (1.0 - part)).sqrt();
    let ends = [rank - reach, rank + reach];
    let is_known = ends[0] >= 0.0 && ends[1] <= count - 1.0;
    SampleEstimate { value: at(rank), error: is_known.then(|| 0.5 * (at(ends[1]) - at(ends[0]))) }
}

/// The share of `count` draws that `hits` are.
pub fn share(hits: usize, count: usize) -> Option<SampleEstimate> {
    let (part, draws) = (hits as f64 / count as f64, count as f64);
    let error = match hits {
        0 => 3.0 / draws,
        _ if hits == count => 3.0 / draws,
        _ => ERRORS * (part * (1.0 - part) / draws).sqrt(),
    };
    (count > 0).then_some(SampleEstimate { value: part, error: Some(error) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers at equal steps of probability of a uniform law from 0 to 1.
    fn uniform(count: usize) -> Vec<f64> {
        (0..count).map(|k| (k as f64 + 0.5) / count as f64).collect()
    }

    #[test]
    fn a_uniform_law_has_its_moments_and_percentiles() {
        let found = Statistics::of(&uniform(1000)).expect("statistics");
        assert!((found.mean.value - 0.5).abs() < 1e-12);
        assert!((found.deviation.value - 12f64.sqrt().recip()).abs() < 1e-3);
        for (percent, found) in PERCENTILES.iter().zip(found.percentiles) {
            assert!((found.value - 1e-2 * percent).abs() < 1e-2, "{percent}: {found:?}");
            let binomial = 1.96 * (1e-2 * percent * (1.0 - 1e-2 * percent) / 1000.0).sqrt();
            assert!((found.error.expect("an error") / binomial - 1.0).abs() < 0.01, "{percent}: {found:?}");
        }
        let of_mean = found.mean.error.expect("an error");
        assert!((of_mean / (1.96 * found.deviation.value / 1000f64.sqrt()) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn few_draws_do_not_know_their_tails() {
        let found = Statistics::of(&uniform(100)).expect("statistics");
        assert_eq!(found.percentiles.map(|it| it.error.is_some()), [false, true, true, true, false]);
        assert_eq!(Statistics::of(&[1.0]), None);
        let constant = Statistics::of(&[2.0; 20]).expect("statistics");
        assert_eq!((constant.deviation.value, constant.deviation.error), (0.0, Some(0.0)));
        assert_eq!(share(0, 300).and_then(|it| it.error), Some(0.01));
    }
}
