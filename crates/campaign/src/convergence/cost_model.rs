//! What accuracy costs in unknowns and seconds, and what one more digit would cost.
//!
//! ```text
//! error(n') = error(n) (n'/n)^-s      extrapolated from the last level, s the order of the strategy
//! seconds(n') = seconds(n) (n'/n)^t   likewise, t fitted to the last levels and kept within [1, 1.6]
//! ```
//! Between levels both are interpolated in logarithms. A level counts as accurate only where all later ones are too.
//! The order s is that of theory: orders fitted to few levels are unreliable. Only where the last steps all stay
//! clearly behind it, as they do at sharp corners of grooves, their mean is taken.

use serde::{Deserialize, Serialize};

use super::strategy::Strategy;

/// Bounds of the exponent t: every solve visits each unknown, and nested dissection needs n^1.5.
const EXPONENTS: (f64, f64) = (1.0, 1.6);
/// The exponent where there is one level only.
const USUAL_EXPONENT: f64 = 1.3;
/// How many of the last levels the exponent is fitted to.
const LAST: usize = 3;
/// Steps that gain less than this part of the order stay behind it.
const BEHIND: f64 = 0.8;
/// The least order that is accepted, as a part of that of theory for elements of second order: that of quadratic
/// elements at a corner of 270 degrees.
const LEAST_PART: f64 = 1.0 / 3.0;
/// The order of these elements.
const SECOND: f64 = 2.0;
/// A strategy is quicker than a simpler one only if its time is below this part of the other: timings scatter.
const QUICKER: f64 = 0.9;
/// The coarsest accuracy of the list, as a power of ten, and the finest that numbers of 16 digits can carry.
const DIGITS: (i32, i32) = (2, 11);

/// How accuracy is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum AccuracyMeasure {
    /// The error bar, the estimate of the level itself.
    Bar,
    /// The true error, which only finer levels show.
    Error,
}

/// The cost of one level, and its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LevelCost {
    /// Unknowns.
    pub unknowns: f64,
    /// Seconds [s] from the scene to its answer.
    pub seconds: f64,
    /// Relative error, estimated or true.
    pub error: f64,
}

/// Cost and error of a strategy.
#[derive(Debug, Clone, PartialEq)]
pub struct CostModel {
    /// The strategy.
    pub strategy: Strategy,
    /// Theoretical order s of the strategy.
    pub order: f64,
    /// Levels of the strategy, from coarse to fine.
    pub levels: Vec<LevelCost>,
}

/// The cost of one accuracy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Price {
    /// How accuracy is measured.
    pub measure: AccuracyMeasure,
    /// The relative error.
    pub accuracy: f64,
    /// The quickest strategy.
    pub strategy: Strategy,
    /// Unknowns.
    pub unknowns: f64,
    /// Seconds [s].
    pub seconds: f64,
    /// Whether it lies beyond what was run.
    pub extrapolated: bool,
}

/// The cost of 1 %, 0.1 % and so on to one digit beyond what was run. Of what was run the quickest strategy, else the
/// one that is predicted to be; of equally quick ones the first. Nothing where there are no levels.
pub fn price_list(models: &[CostModel], measure: AccuracyMeasure) -> Vec<Price> {
    let reached =
        (models.iter()).filter_map(|model| model.levels.last()).map(|level| level.error).fold(f64::INFINITY, f64::min);
    if !reached.is_finite() {
        return Vec::new();
    }
    let digits = if reached > 0.0 { -reached.log10() } else { f64::INFINITY };
    // Rounding must not cost a digit.
    let finest = (digits + 1e-9).floor().clamp(-1.0, f64::from(DIGITS.1)) as i32 + 1;
    let accuracies = (DIGITS.0..=finest.clamp(DIGITS.0, DIGITS.1)).map(|digit| 10f64.powi(-digit));
    let price = |accuracy: f64| {
        let prices = models.iter().filter_map(|model| model.price(accuracy, measure));
        prices.reduce(|best, other| match (best.extrapolated, other.extrapolated) {
            (true, false) => other,
            (false, true) => best,
            _ if other.seconds < QUICKER * best.seconds => other,
            _ => best,
        })
    };
    accuracies.filter_map(price).collect()
}

/// Prices by error bars, followed by those by true errors. A bar holds the error, so that an accuracy which a bar shows
/// costs no more by the error.
pub fn with_errors(by_bars: &[Price], by_errors: Vec<Price>) -> Vec<Price> {
    let at_most = |price: Price| {
        let shown = by_bars.iter().find(|shown| shown.accuracy == price.accuracy);
        match shown.filter(|shown| shown.unknowns < price.unknowns && (!shown.extrapolated || price.extrapolated)) {
            Some(shown) => Price { measure: AccuracyMeasure::Error, ..*shown },
            None => price,
        }
    };
    let by_errors = by_errors.into_iter().map(at_most);
    by_bars.iter().copied().chain(by_errors).collect()
}

impl CostModel {
    /// The cost of an accuracy by this strategy.
    fn price(&self, accuracy: f64, measure: AccuracyMeasure) -> Option<Price> {
        let row = |unknowns: f64, seconds: f64, extrapolated: bool| Price {
            measure,
            accuracy,
            strategy: self.strategy,
            unknowns,
            seconds,
            extrapolated,
        };
        let accurate = |level: &LevelCost| level.error <= accuracy * (1.0 + 1e-9);
        let last = self.levels.last()?;
        if !accurate(last) {
            let growth = (last.error / accuracy).powf(1.0 / self.order());
            let seconds = last.seconds * growth.powf(self.exponent());
            return Some(row(last.unknowns * growth, seconds, true));
        }
        let first = (self.levels.iter().rposition(|level| !accurate(level))).map_or(0, |coarse| coarse + 1);
        let fine = self.levels[first];
        let Some(coarse) = first.checked_sub(1).map(|coarse| self.levels[coarse]) else {
            return Some(row(fine.unknowns, fine.seconds, false));
        };
        let part = match fine.error > 0.0 {
            true => (coarse.error / accuracy).ln() / (coarse.error / fine.error).ln(),
            false => 1.0,
        };
        let between = |coarse: f64, fine: f64| coarse * (fine / coarse).powf(part.clamp(0.0, 1.0));
        let unknowns = between(coarse.unknowns, fine.unknowns);
        Some(row(unknowns, between(coarse.seconds, fine.seconds), false))
    }

    /// The order s of the extrapolation.
    pub fn order(&self) -> f64 {
        let last = &self.levels[self.levels.len().saturating_sub(LAST)..];
        let gained =
            |pair: &[LevelCost]| (pair[0].error / pair[1].error).ln() / (pair[1].unknowns / pair[0].unknowns).ln();
        let steps: Vec<f64> = last.windows(2).map(gained).collect();
        let all_behind = last.len() == LAST && steps.iter().all(|step| *step < BEHIND * self.order);
        match all_behind {
            true => (steps.iter().sum::<f64>() / steps.len() as f64).clamp(least_order(self.order), self.order),
            false => self.order,
        }
    }

    /// The exponent t of `seconds ~ unknowns^t`.
    pub fn exponent(&self) -> f64 {
        let last = &self.levels[self.levels.len().saturating_sub(LAST)..];
        let points: Vec<_> = last.iter().map(|level| (level.unknowns.ln(), level.seconds.ln())).collect();
        exponent(&points)
    }
}

/// The least order that is accepted where theory has `order`.
pub(super) fn least_order(order: f64) -> f64 {
    LEAST_PART * order.min(SECOND)
}

/// Slope of the least-squares line through points of logarithms, kept within its bounds.
pub(super) fn exponent(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|point| (point.0 - x).powi(2)).sum();
    let slope = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum::<f64>() / spread;
    match slope.is_finite() {
        true => slope.clamp(EXPONENTS.0, EXPONENTS.1),
        false => USUAL_EXPONENT,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Levels of `error = a n^-s`, `seconds = b n^t`, each with four times the unknowns of the one before.
    fn model(strategy: Strategy, (a, s): (f64, f64), (b, t): (f64, f64), levels: i32) -> CostModel {
        let level = |k: i32| {
            let n = 100.0 * 4f64.powi(k);
            LevelCost { unknowns: n, seconds: b * n.powf(t), error: a * n.powf(-s) }
        };
        CostModel { strategy, order: s, levels: (0..levels).map(level).collect() }
    }

    #[test]
    fn powers_are_met_exactly_within_and_beyond_what_was_run() {
        // Errors from 1e-1 to 1e-1 4^-8 = 1.5e-6.
        let model = model(Strategy::P2Uniform, (1e3, 2.0), (1e-6, 1.25), 5);
        let prices = price_list(std::slice::from_ref(&model), AccuracyMeasure::Bar);
        let accuracies: Vec<f64> = prices.iter().map(|price| price.accuracy).collect();
        assert_eq!(accuracies, [1e-2, 1e-3, 1e-4, 1e-5, 1e-6]);
        for price in &prices {
            let n = (1e3 / price.accuracy).sqrt();
            assert!((price.unknowns / n - 1.0).abs() < 1e-12, "{price:?}");
            assert!((price.seconds / (1e-6 * n.powf(1.25)) - 1.0).abs() < 1e-12, "{price:?}");
            assert_eq!(price.extrapolated, price.accuracy < 1.5e-6);
        }
        assert!((model.exponent() - 1.25).abs() < 1e-12);
    }

    #[test]
    fn a_level_is_trusted_only_if_all_later_ones_are_better() {
        let mut model = model(Strategy::P2Uniform, (1e3, 2.0), (1e-6, 1.0), 4);
        // Errors 1e-1, 6e-3, 4e-4, 2.4e-5: by chance the first level is good.
        model.levels[0].error = 1e-7;
        let prices = price_list(std::slice::from_ref(&model), AccuracyMeasure::Bar);
        assert!(prices.iter().find(|price| price.accuracy == 1e-3).is_some_and(|price| price.unknowns > 400.0));
        assert!(prices.iter().find(|price| price.accuracy == 1e-2).is_some_and(|price| price.unknowns == 100.0));
    }

    /// A reference that is hardly better than a level makes its true error look large.
    #[test]
    fn what_a_bar_shows_costs_no_more_by_the_true_error() {
        let bars = model(Strategy::P2Uniform, (1e3, 2.0), (1e-6, 1.25), 5);
        let errors = model(Strategy::P2Uniform, (1e4, 2.0), (1e-6, 1.25), 5);
        let by_bars = price_list(&[bars], AccuracyMeasure::Bar);
        let both = with_errors(&by_bars, price_list(&[errors], AccuracyMeasure::Error));
        let (shown, true_errors) = both.split_at(by_bars.len());
        assert_eq!(shown, by_bars);
        assert!(!true_errors.is_empty());
        for price in true_errors {
            let bar = shown.iter().find(|bar| bar.accuracy == price.accuracy).expect("a price");
            assert!(price.measure == AccuracyMeasure::Error && price.unknowns <= bar.unknowns, "{price:?}");
        }
    }

    #[test]
    fn the_quickest_is_named_and_what_was_run_goes_first() {
        let linear = model(Strategy::P1Uniform, (1.0, 1.0), (1e-7, 1.0), 6);
        let quadratic = model(Strategy::P2Uniform, (1e3, 2.0), (1e-6, 1.0), 3);
        let prices = price_list(&[linear, quadratic], AccuracyMeasure::Bar);
        let quickest: Vec<_> = (prices.iter()).map(|price| (price.strategy, price.extrapolated)).collect();
        let (p1, p2) = (Strategy::P1Uniform, Strategy::P2Uniform);
        // Linear elements reach 1e-5 at the last level, quadratic ones 4e-4.
        assert_eq!(quickest, [(p1, false), (p1, false), (p1, false), (p1, false), (p2, true)]);
    }

    #[test]
    fn an_order_is_that_of_theory_unless_all_steps_stay_behind_it() {
        let mut slow = model(Strategy::P2Uniform, (1.0, 1.0), (1e-6, 1.0), 4);
        assert_eq!(slow.order(), 1.0);
        slow.order = 2.0;
        assert!((slow.order() - 1.0).abs() < 1e-12);
        // One good step is enough to believe in the theory.
        slow.levels[3].error *= 0.2;
        assert_eq!(slow.order(), 2.0);
        slow.levels[3].error *= 100.0;
        assert_eq!(slow.order(), 2.0 / 3.0);
        slow.levels.truncate(2);
        assert_eq!(slow.order(), 2.0);
    }

    #[test]
    fn a_strategy_that_is_not_clearly_quicker_does_not_win() {
        let simple = model(Strategy::P2Uniform, (1e3, 2.0), (1e-6, 1.0), 3);
        let mut other = model(Strategy::P2Adaptive, (1e3, 2.0), (0.95e-6, 1.0), 3);
        let quickest = |models: &[CostModel]| price_list(models, AccuracyMeasure::Bar)[0].strategy;
        assert_eq!(quickest(&[simple.clone(), other.clone()]), Strategy::P2Uniform);
        other.levels.iter_mut().for_each(|level| level.seconds *= 0.9);
        assert_eq!(quickest(&[simple, other]), Strategy::P2Adaptive);
    }

    #[test]
    fn exponents_stay_within_bounds_and_one_level_has_the_usual_one() {
        for (t, found) in [(0.5, 1.0), (1.3, 1.3), (2.0, 1.6)] {
            let model = model(Strategy::P2Uniform, (1.0, 2.0), (1e-6, t), 4);
            assert!((model.exponent() - found).abs() < 1e-12);
        }
        assert_eq!(model(Strategy::P2Uniform, (1.0, 2.0), (1e-6, 1.0), 1).exponent(), USUAL_EXPONENT);
        assert!(price_list(&[], AccuracyMeasure::Bar).is_empty());
    }

    #[test]
    fn a_coarse_answer_still_has_a_cost_of_one_percent() {
        let model = model(Strategy::P2Uniform, (1e4, 2.0), (1e-6, 1.0), 1);
        let prices = price_list(&[model], AccuracyMeasure::Bar);
        assert_eq!(prices.len(), 1);
        assert!(prices[0].extrapolated && (prices[0].unknowns - 1000.0).abs() < 1e-9);
    }
}
