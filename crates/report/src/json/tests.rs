use super::*;
use oilwedge_study::effects::{EFFECTS, Effects};
use oilwedge_study::quantities::{ATTITUDE_ANGLE, Bar, LOAD, Quantity};
use oilwedge_study::result::{
    Balances, Counts, Geometry, HistoryStep, LevelFacts, MeshFacts, RESULT_FORMAT, RunResult, Status,
};

pub(crate) fn example() -> RunResult {
    RunResult {
        format: RESULT_FORMAT.into(),
        title: "example".into(),
        version: "0.1.0".into(),
        scene: "title = \"example\"\n".into(),
        scene_sha256: "ab".into(),
        mesh_sha256: "cd".into(),
        status: Status::NotConverged,
        reason: None,
        effects: Effects {
            simulated: vec![EFFECTS[2]],
            not_simulated: vec!["squeeze"],
        },
        geometry: Geometry::default(),
        mesh: MeshFacts {
            cells: 592,
            nodes: 1245,
            order: 2,
            min_angle_deg: 31.0,
        },
        quantities: vec![Quantity::new(&LOAD, 12910.0), Quantity::new(&ATTITUDE_ANGLE, 49.29)],
        bars: false,
        levels: vec![],
        balances: Balances {
            mass: 1e-12,
            power: 1e-12,
            moment: 0.0,
            force: 0.0,
            tilt: 0.0,
            thermal: 0.0,
            energy: None,
        },
        regime: None,
        orbit: None,
        temperature: None,
        dynamics: None,
        history: vec![HistoryStep {
            step: 1,
            residual: 1.0,
            active: 0,
        }],
        counts: Counts::default(),
        linear_solver: None,
        of_hill: Vec::new(),
        timing_s: vec![("read".into(), 0.25), ("assemble".into(), 0.5)],
        warnings: vec![],
    }
}

#[test]
fn the_json_is_that_of_the_contract() {
    let text = result_json(&example(), &[]).expect("all numbers are finite");
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

#[test]
fn what_is_not_finite_is_not_written() {
    let level = |result: &mut RunResult, error: f64, seconds: f64| {
        result.levels = vec![LevelFacts {
            errors: vec![("load".into(), error)],
            seconds,
            ..LevelFacts::default()
        }];
    };
    let spoil: [&dyn Fn(&mut RunResult); 10] = [
        &|result| result.quantities[1].value = f64::NAN,
        &|result| result.quantities[0].bar = Some(Bar::of(f64::INFINITY)),
        &|result| result.balances.mass = f64::NAN,
        &|result| result.balances.power = f64::NAN,
        &|result| result.history[0].residual = f64::INFINITY,
        &|result| result.timing_s[1].1 = f64::NAN,
        &|result| result.mesh.min_angle_deg = f64::NAN,
        &|result| {
            let front = f64::NAN;
            result.quantities[0].bar = Some(Bar {
                front,
                ..Bar::default()
            });
        },
        &|result| level(result, f64::INFINITY, 0.0),
        &|result| level(result, 0.0, f64::NAN),
    ];
    for spoil in spoil {
        let mut result = example();
        spoil(&mut result);
        assert!(matches!(result_json(&result, &[]), Err(Error::NotFinite { .. })));
    }
    let mut result = example();
    result.quantities[1].name = "load".into();
    assert!(matches!(result_json(&result, &[]), Err(Error::Twice { .. })));
}
