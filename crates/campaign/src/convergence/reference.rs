//! The finest answer of a study, and how far the others are from it.

use super::cost_model::least_order;
use super::report::{LevelReport, Reference, StrategyLevels};

/// Answers are not known better than this, however small their bars: rounding of long sums.
const ROUNDING: f64 = 1e-14;

/// The finest answer: that of the smallest bar or, without bars, of the highest degree on the most unknowns; `None`
/// without levels.
pub(super) fn finest(courses: &[StrategyLevels]) -> Option<Reference> {
    let degree = courses.iter().filter(|course| !course.levels.is_empty());
    let degree = degree.map(|course| course.strategy.degree()).max()?;
    let best = (courses.iter().filter(|course| course.strategy.degree() == degree))
        .flat_map(|course| (0..course.levels.len()).map(move |place| (course, place)))
        .max_by(|(a, i), (b, j)| {
            let (a, b) = (&a.levels[*i], &b.levels[*j]);
            let bar = |level: &LevelReport| level.relative_bar.unwrap_or(f64::INFINITY);
            bar(b).total_cmp(&bar(a)).then(a.unknowns.cmp(&b.unknowns))
        });
    let (course, place) = best?;
    let level = &course.levels[place];
    let estimates = [level.relative_bar, predicted(course.order, &course.levels[..=place])];
    let uncertainty = estimates.into_iter().flatten().reduce(f64::min);
    Some(Reference {
        strategy: course.strategy,
        level: level.level,
        unknowns: level.unknowns,
        value: level.value,
        uncertainty: uncertainty.map(|uncertainty| uncertainty.max(ROUNDING)),
    })
}

/// The relative error of the last level by a law of order s, `e = d r/(1 - r)`: d the distance of a level from the one
/// before, r the ratio of their errors. s is that of theory or, if it is less, the one by which the last two distances
/// shrank. The greater of what the last two distances predict counts, since one of them may be small by chance.
fn predicted(order: f64, levels: &[LevelReport]) -> Option<f64> {
    let last = levels.last()?;
    let growth = |from: &LevelReport, to: &LevelReport| to.unknowns as f64 / from.unknowns as f64;
    let distance = |pair: &[LevelReport]| (pair[1].value - pair[0].value).abs() / last.value.abs();
    let pairs: Vec<&[LevelReport]> = levels.windows(2).rev().take(2).collect();
    let order = match pairs[..] {
        [pair, earlier] => {
            let observed = (distance(earlier) / distance(pair)).ln() / growth(&pair[0], &pair[1]).ln();
            if observed.is_nan() { order } else { observed.clamp(least_order(order), order) }
        }
        _ => order,
    };
    let error = |pair: &&[LevelReport]| {
        let ratio = growth(&pair[0], &pair[1]).powf(-order);
        distance(pair) * ratio / (1.0 - ratio) * growth(&pair[1], last).powf(-order)
    };
    let errors = pairs.iter().map(error);
    errors.filter(|error| error.is_finite() && *error >= 0.0).reduce(f64::max)
}

/// Fills in the relative errors of all levels, and makes their bars, so far relative to their own values, relative to
/// the finest answer.
pub(super) fn measure(courses: &mut [StrategyLevels], reference: &Reference) {
    for course in courses {
        for level in &mut course.levels {
            let is_reference = course.strategy == reference.strategy && level.level == reference.level;
            let distance = (level.value - reference.value).abs() / reference.value.abs();
            let known = !is_reference && reference.uncertainty.is_some();
            level.relative_error = known.then_some(distance);
            level.relative_bar = level.relative_bar.map(|bar| bar * (level.value / reference.value).abs());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::report::Timing;
    use super::super::strategy::Strategy;
    use super::*;

    /// Values `1000 (1 - n^-2 1e4)` on 190 and 380 unknowns, without bars.
    fn courses() -> Vec<StrategyLevels> {
        let level = |level: usize| LevelReport {
            level,
            cells: 100 * level,
            unknowns: 190 * level,
            value: 1000.0 * (1.0 - 1e4 / (190.0 * level as f64).powi(2)),
            relative_bar: None,
            relative_error: None,
            seconds: Timing::default(),
        };
        let course = StrategyLevels {
            strategy: Strategy::P2Uniform,
            order: 2.0,
            time_exponent: None,
            levels: vec![level(1), level(2)],
            ended: String::new(),
        };
        let mut linear = course.clone();
        linear.strategy = Strategy::P1Uniform;
        linear.levels[1].unknowns = 5000;
        vec![linear, course]
    }

    #[test]
    fn the_finest_answer_is_of_the_highest_degree_and_knows_how_good_it_is() {
        let courses = courses();
        let reference = finest(&courses).expect("there are levels");
        assert_eq!((reference.strategy, reference.level), (Strategy::P2Uniform, 2));
        let error = 1e4 / 380f64.powi(2);
        let known = reference.uncertainty.expect("there are two levels");
        assert!((known / (error / (1.0 - error)) - 1.0).abs() < 1e-12, "{known} {error}");
        assert!(finest(&[]).is_none());
    }

    #[test]
    fn differences_that_shrink_slowly_tell_of_a_greater_error() {
        let mut levels = courses().remove(1).levels;
        let mut third = levels[1].clone();
        (third.level, third.unknowns) = (3, 760);
        levels.push(third);
        // Errors 1, 1/2, 1/4 over twice the unknowns each: order 1.
        for (level, error) in levels.iter_mut().zip([1.0, 0.5, 0.25]) {
            level.value = 1000.0 + error;
        }
        let error = predicted(2.0, &levels).expect("three levels");
        assert!((error * levels[2].value - 0.25).abs() < 1e-12, "{error}");
        assert!(predicted(2.0, &levels[..1]).is_none());
        // That the last two agree by chance is not believed: the level before was 1/2 r/(1 - r) off, r = 1/4.
        levels[2].value = levels[1].value;
        let error = predicted(2.0, &levels).expect("three levels");
        assert!((error * levels[2].value - 0.5 / 3.0 / 4.0).abs() < 1e-12, "{error}");
    }

    #[test]
    fn the_smallest_bar_is_the_finest_answer_and_differences_may_tell_more() {
        let mut courses = courses();
        courses[1].levels[0].relative_bar = Some(1e-3);
        courses[1].levels[1].relative_bar = Some(2e-3);
        let reference = finest(&courses).expect("there are levels");
        assert_eq!((reference.level, reference.uncertainty), (1, Some(1e-3)));
        courses[1].levels[1].relative_bar = Some(0.9e-3);
        courses[1].levels[1].value = courses[1].levels[0].value * (1.0 + 3e-5);
        let known = finest(&courses).and_then(|reference| reference.uncertainty);
        assert!(known.is_some_and(|known| (known / 1e-5 - 1.0).abs() < 1e-3), "{known:?}");
    }

    #[test]
    fn errors_are_relative_to_the_finest_answer() {
        let mut courses = courses();
        courses[1].levels[0].relative_bar = Some(0.5);
        let reference = Reference {
            strategy: Strategy::P2Uniform,
            level: 2,
            unknowns: 380,
            value: -1000.0,
            uncertainty: Some(1e-3),
        };
        measure(&mut courses, &reference);
        let first = &courses[1].levels[0];
        assert!(first.relative_error.is_some_and(|error| (error - (first.value + 1000.0) / 1000.0).abs() < 1e-15));
        assert!(first.relative_bar.is_some_and(|bar| (bar - 0.5 * first.value / 1000.0).abs() < 1e-15));
        assert_eq!(courses[1].levels[1].relative_error, None);
        assert!(courses[0].levels[1].relative_error.is_some());
    }
}
