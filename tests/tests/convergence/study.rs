//! A study of a scene: its levels, what its observer is told, and its time.

use oilwedge_scene::convergence::{Budget, LevelReport, Observer, Strategy, converge};
use oilwedge_scene::scene::Scene;
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

/// Uniform refinement divides each triangle into four, and the error falls with the order of the degree. What is told as begun
/// ends, level by level. An empty budget still has one level.
#[test]
fn levels_are_told_in_their_order_and_errors_fall_by_theirs() {
    let scene = Scene::read(&path("09_drawn_ring")).expect("a shipped scene");
    let mut diary = Diary::default();
    let study = converge(&scene, &Budget::seconds(1.5), &mut diary).expect("it has a film");
    let report = study.report;
    for course in report
        .strategies
        .iter()
        .filter(|course| course.strategy != Strategy::P2Adaptive)
    {
        for pair in course.levels.windows(2) {
            assert_eq!(pair[1].cells, 4 * pair[0].cells);
        }
        let gains = course.levels.windows(2).filter_map(|pair| {
            Some(
                (pair[0].relative_error? / pair[1].relative_error?).ln()
                    / (pair[1].unknowns as f64 / pair[0].unknowns as f64).ln(),
            )
        });
        // The first level is coarse; the last ones may be as good as the finest answer.
        let gain = gains.skip(1).take(1).next().expect("three levels");
        assert!(
            (gain / course.order - 1.0).abs() < 0.15,
            "{:?}: {gain}",
            course.strategy
        );
        assert!(!course.ended.is_empty());
    }
    let told: Vec<_> = report
        .levels()
        .map(|(course, level)| (course.strategy, level.level))
        .collect();
    for (strategy, level) in told {
        let places: Vec<usize> = [false, true]
            .map(|ended| {
                diary
                    .0
                    .iter()
                    .position(|&entry| entry == (strategy, level, ended))
                    .expect("told")
            })
            .into();
        assert_eq!(places[1], places[0] + 1);
    }
    assert!(report.prices.len() > 3 && report.prices.iter().rev().skip(1).all(|price| !price.extrapolated));
    assert!(study.mesh.is_some_and(|marked| marked.mesh.triangles().len() <= 5000));

    let short = converge(&scene, &Budget::seconds(1e-6), &mut ())
        .expect("it has a film")
        .report;
    assert_eq!(short.levels().count(), 1);
    assert!(short.prices.is_empty() && short.reference.is_some_and(|reference| reference.uncertainty.is_none()));
    assert!(
        short
            .left_out
            .iter()
            .any(|sentence| sentence.contains("errors are not known"))
    );
}
