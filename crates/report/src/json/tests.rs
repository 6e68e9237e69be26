use super::*;
use oilwedge_campaign::records::TheoriesRecord;
use oilwedge_study::quantities::Bar;
use oilwedge_study::result::{
    HistoryStep, LevelFacts, RESULT_FORMAT, ResultHead, ResultTail, RunResult, Status, TemperatureReport,
};

pub(crate) fn example() -> RunResult {
    RunResult {
        head: ResultHead {
            mesh_sha256: Some("cd".into()),
            status: Status::NotConverged,
            ..ResultHead::of(RESULT_FORMAT, ["example", "title = \"example\"\n", "ab"])
        },
        history: vec![HistoryStep { step: 1, residual: 1.0, active: 0 }],
        tail: ResultTail { timing_s: vec![("read".into(), 0.25), ("assemble".into(), 0.5)], ..ResultTail::default() },
        ..crate::tables::example()
    }
}

#[test]
fn the_json_is_that_of_the_contract() {
    let text = result_json(&example(), &Records::default()).expect("all numbers are finite");
    let value: serde_json::Value = serde_json::from_str(&text).expect("it is JSON");
    assert_eq!(value["status"], "not_converged");
    assert_eq!(value["reason"], serde_json::Value::Null);
    let load = serde_json::json!({ "symbol": "W", "value": 12910.0, "unit": "N", "error": null, "error_parts": null });
    assert_eq!(value["quantities"]["load"], load);
    assert_eq!(value["timing_s"]["assemble"], 0.5);
    let place = |word: &str| text.find(word).expect(word);
    let order = [
        "format",
        "title",
        "version",
        "scene_sha256",
        "mesh_sha256",
        "status",
        "reason",
        "effects",
        "mesh\"",
        "quantities",
        "\"load",
        "attitude_angle",
        "bars",
        "levels",
        "balances",
        "regime",
        "history",
        "counts",
        "linear_solver",
        "timing_s",
        "read",
        "assemble",
        "warnings",
    ];
    assert!(order.windows(2).all(|pair| place(pair[0]) < place(pair[1])), "{text}");
}

/// A result is read back as it was written, with its add-ons; keys, quantities and effects of newer versions are passed
/// over, and what an older one lacks is empty.
#[test]
fn a_result_is_read_back() {
    let bar = Bar { front: 0.1, algebra: 1e-17, ..Bar::default() };
    let mut result = example();
    result.quantities[0].bar = Some(bar);
    result.temperature = Some(TemperatureReport { inlet_temperature: 80.1, ..TemperatureReport::default() });
    let films = vec![];
    let theories = TheoriesRecord { slenderness: 0.1 + 0.2, without: vec!["feeds".into()], films };
    let records = Records { theories: Some(theories), ..Records::default() };
    let file = ResultFile { result, records };
    let text = json(&file).expect("all numbers are finite");
    let read = |text: &str| serde_json::from_str::<ResultFile>(text).expect("a result");
    assert_eq!(read(&text), file);
    let newer = text
        .replacen("\"title\"", "\"colour\": { \"of\": [1] }, \"title\"", 1)
        .replacen("\"load\": {", "\"taste\": { \"value\": 1.0, \"unit\": \"1\" }, \"load\": { \"colour\": 3,", 1)
        .replacen("\"simulated\": [", "\"simulated\": [\"magic\", ", 1);
    assert!(["colour", "taste", "magic"].iter().all(|word| newer.contains(word)), "{newer}");
    assert_eq!(read(&newer), file);
    assert_eq!(read("{}").result, RunResult::default());
}

#[test]
fn what_is_not_finite_is_not_written() {
    let level = |result: &mut RunResult, error: f64, seconds: f64| {
        result.levels = vec![LevelFacts { errors: vec![("load".into(), error)], seconds, ..LevelFacts::default() }];
    };
    let spoil: [&dyn Fn(&mut RunResult); 10] = [
        &|result| result.quantities[1].value = f64::NAN,
        &|result| result.quantities[0].bar = Some(Bar::of(f64::INFINITY)),
        &|result| result.balances.mass = f64::NAN,
        &|result| result.balances.power = f64::NAN,
        &|result| result.history[0].residual = f64::INFINITY,
        &|result| result.tail.timing_s[1].1 = f64::NAN,
        &|result| result.mesh.min_angle_deg = f64::NAN,
        &|result| {
            let front = f64::NAN;
            result.quantities[0].bar = Some(Bar { front, ..Bar::default() });
        },
        &|result| level(result, f64::INFINITY, 0.0),
        &|result| level(result, 0.0, f64::NAN),
    ];
    for spoil in spoil {
        let mut result = example();
        spoil(&mut result);
        assert!(matches!(result_json(&result, &Records::default()), Err(Error::NotFinite { .. })));
    }
    let mut result = example();
    result.quantities[1].name = "load".into();
    assert!(matches!(result_json(&result, &Records::default()), Err(Error::Twice { .. })));
}
