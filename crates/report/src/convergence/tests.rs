use oilwedge_campaign::convergence::cost_model::{AccuracyMeasure, Price};
use oilwedge_campaign::convergence::report::{
    CONVERGE_FORMAT, ConvergenceReport, GoalFacts, LevelReport, Reference, StrategyLevels, Timing,
};
use oilwedge_campaign::convergence::strategy::Strategy;
use oilwedge_study::effects::Effects;
use oilwedge_study::result::ResultHead;

use crate::Error;
use crate::json::json;

pub(crate) fn example() -> ConvergenceReport {
    let level = |level: usize, value: f64, relative_error: Option<f64>| LevelReport {
        level,
        cells: 100 * level,
        unknowns: 190 * level,
        value,
        relative_bar: relative_error.map(|error| 1.5 * error),
        relative_error,
        seconds: Timing {
            total: 0.25 * level as f64,
            least: 0.2,
            greatest: 0.5,
            runs: 3,
            parts: vec![("mesh".into(), 0.125), ("factorise".into(), 0.0625)],
        },
    };
    ConvergenceReport {
        head: ResultHead::of(CONVERGE_FORMAT, ["example", "title = \"example\"\n", "ab"]),
        effects: Effects::default(),
        goal: GoalFacts { name: "load".into(), symbol: "W".into(), unit: "N".into() },
        reference: Some(Reference {
            strategy: Strategy::P2Uniform,
            level: 2,
            unknowns: 380,
            value: 1000.0,
            uncertainty: Some(1e-4),
        }),
        strategies: vec![StrategyLevels {
            strategy: Strategy::P2Uniform,
            order: 2.0,
            time_exponent: Some(1.0),
            levels: vec![level(1, 1010.0, Some(0.01)), level(2, 1000.0, None)],
            ended: "the time is up".into(),
        }],
        prices: vec![Price {
            measure: AccuracyMeasure::Bar,
            accuracy: 0.01,
            strategy: Strategy::P2Uniform,
            unknowns: 190.0,
            seconds: 0.25,
            extrapolated: false,
        }],
        notes: vec![],
        max_seconds: 30.0,
        seconds: 1.5,
    }
}

#[test]
fn the_json_is_that_of_the_reference_page() {
    let text = json(&example()).expect("all numbers are finite");
    let value: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    assert_eq!(value["format"], "oilwedge-converge/1");
    assert_eq!(value["reference"]["strategy"], "p2_uniform");
    let level = &value["strategies"][0]["levels"][0];
    assert_eq!((&level["unknowns"], &level["relative_error"]), (&190.into(), &0.01.into()));
    assert_eq!(level["seconds"]["parts"]["factorise"], 0.0625);
    assert!(value["strategies"][0]["levels"][1]["relative_error"].is_null());
    assert_eq!(value["prices"][0]["extrapolated"], false);
}

#[test]
fn what_is_not_finite_is_not_written() {
    let spoil: [fn(&mut ConvergenceReport); 3] = [
        |report| report.strategies[0].levels[1].value = f64::NAN,
        |report| report.strategies[0].levels[0].relative_bar = Some(f64::INFINITY),
        |report| report.prices[0].seconds = f64::NAN,
    ];
    for spoil in spoil {
        let mut report = example();
        spoil(&mut report);
        assert!(matches!(json(&report), Err(Error::NotFinite { .. })));
    }
}

#[test]
fn a_true_error_is_known_as_well_as_the_reference() {
    let report = example();
    let (reference, levels) = (report.reference.expect("one"), &report.strategies[0].levels);
    let errors = |measure: AccuracyMeasure| [0, 1].map(|level| levels[level].error(measure, &reference));
    assert_eq!(errors(AccuracyMeasure::Bar), [Some(0.015), None]);
    assert_eq!(errors(AccuracyMeasure::Error), [Some(0.01), Some(1e-4)]);
}
