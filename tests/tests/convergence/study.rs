//! A study of a scene: its levels, what its observer is told, and its time.

use oilwedge_campaign::convergence::{AccuracyMeasure, Budget, LevelReport, Observer, Strategy, converge};
use oilwedge_tests::scenes::path;

/// Everything that was told: strategy, level, and whether it ended.
#[derive(Default)]
struct Diary(Vec<(Strategy, usize, bool)>);

impl Observer for Diary {
    fn begins(&mut self, strategy: Strategy, level: usize, cells: usize, _: Option<f64>) {
        assert!(cells > 10);
        self.0.push((strategy, level, false));
    }

    fn ended(&mut self, strategy: Strategy, level: &LevelReport) {
        assert!(level.seconds.least <= level.seconds.total && level.seconds.total <= level.seconds.greatest);
        self.0.push((strategy, level.level, true));
    }
}

/// Uniform refinement divides each triangle into four, and the error falls with the order of the degree. What is told
/// as begun ends, level by level. An empty budget still has the first level of quadratic elements, with which both of
/// their strategies begin.
#[test]
fn levels_are_told_in_their_order_and_errors_fall_by_theirs() {
    let scene = oilwedge_study::read(&path("09_drawn_ring")).expect("a shipped scene");
    let mut diary = Diary::default();
    let study = converge(&scene, &Budget::seconds(3.0), &mut diary).expect("it has a film");
    let report = study.report;
    for course in report.strategies.iter().filter(|course| course.strategy != Strategy::P2Adaptive) {
        for pair in course.levels.windows(2) {
            assert_eq!(pair[1].cells, 4 * pair[0].cells);
        }
        // The bar of quadratic elements, the true error of linear ones. The first level is coarse.
        let told = |level: &LevelReport| level.relative_bar.or(level.relative_error);
        let points: Vec<(f64, f64)> =
            (course.levels.iter().skip(1)).filter_map(|level| Some((level.unknowns as f64, told(level)?))).collect();
        let [first, second, ..] = points[..] else { panic!("{:?}: too few levels", course.strategy) };
        let gain = (first.1 / second.1).ln() / (second.0 / first.0).ln();
        assert!((gain / course.order - 1.0).abs() < 0.2, "{:?}: {gain}", course.strategy);
        assert!(!course.ended.is_empty());
    }
    let told: Vec<_> = report.levels().map(|(course, level)| (course.strategy, level.level)).collect();
    // Both strategies of quadratic elements begin with the same level.
    for (strategy, level) in told.into_iter().filter(|told| *told != (Strategy::P2Adaptive, 1)) {
        let places: Vec<usize> = [false, true]
            .map(|ended| diary.0.iter().position(|&entry| entry == (strategy, level, ended)).expect("told"))
            .into();
        assert_eq!(places[1], places[0] + 1);
    }
    for measure in [AccuracyMeasure::Bar, AccuracyMeasure::Error] {
        let prices: Vec<_> = report.prices.iter().filter(|price| price.measure == measure).collect();
        assert!(prices.len() > 3 && prices.iter().rev().skip(1).all(|price| !price.extrapolated));
    }
    assert!(study.mesh.is_some_and(|marked| marked.mesh.triangles().len() <= 5000));

    let short = converge(&scene, &Budget::seconds(1e-6), &mut ()).expect("it has a film").report;
    assert_eq!(short.levels().count(), 2);
}
