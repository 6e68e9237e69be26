//! `oilwedge solve --standard`.

use oilwedge_tests::program::repository;

use oilwedge_tests::bench::{Bench, object};

/// The bearing of `tests/tests/literature/thermal_balance.rs` at the temperature that its film finds.
#[test]
fn the_twin_stands_beside_the_film() {
    let bench = Bench::new();
    let scene = repository().join("scenes/20_heat_balance.toml").display().to_string();
    let told = bench.run(&["solve", &scene, "--standard", "--out", "out"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    for words in ["ISO 7902 (DIN 31652)", "a hole opposite to the load", "its side_flow", "Q_3"] {
        assert!(told.stdout.contains(words), "{words}: {}", told.stdout);
    }
    let text = std::fs::read_to_string(bench.path().join("out/result.json")).expect("a result");
    let result = object(&text);
    let standard = &result["standard"];
    assert_eq!(standard["given"], "load");
    let numbers = standard["numbers"].as_array().expect("numbers");
    let parts = ["squeezed_flow", "pressed_flow"].map(|part| standard[part].as_f64().expect(part));
    let side_flow = numbers.iter().find(|it| it["quantity"] == "side_flow").expect("a side flow");
    let whole = side_flow["standard"].as_f64().expect("a number");
    assert!((parts[0] + parts[1] - whole).abs() < 1e-12 * whole, "{parts:?}, {whole}");
    let film_of = |name: &str| &result["quantities"][name]["value"];
    for name in ["eccentricity", "friction_power", "side_flow"] {
        let beside = numbers.iter().find(|it| it["quantity"] == name).expect(name);
        assert_eq!(&beside["film"], film_of(name), "{name}");
        assert!(beside["standard"].as_f64().is_some_and(|it| it > 0.0), "{name}");
    }
}

#[test]
fn nobody_is_told_of_the_standard_who_does_not_ask() {
    let bench = Bench::new();
    let scene = repository().join("scenes/01_plain_ring.toml").display().to_string();
    let told = bench.run(&["solve", &scene, "--json", "--out", "out"]);
    assert!(object(&told.stdout).get("standard").is_none());
}
