//! `oilwedge oil`, and scenes that name their oil.

use std::path::Path;

use oilwedge_tests::program::oilwedge;
use oilwedge_tests::scenes::path;
use serde_json::Value;

#[test]
fn grades_are_listed_and_told() {
    let text = |arguments: &[&str]| {
        let output = oilwedge(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let list = text(&["oil"]);
    assert!(list.contains("SAE 10W-40") && list.contains("ISO VG 46"), "{list}");
    let sheet = text(&["oil", "SAE", "10W-40"]);
    assert!(sheet.contains("14.30") && sheet.contains("SAE J300"), "{sheet}");
    let json: Value = serde_json::from_str(&text(&["oil", "iso vg 46", "--at", "40 C", "--json"])).expect("JSON");
    assert_eq!(json["format"], "oilwedge-oil/1");
    let viscosity = json["at"][0]["kinematic_viscosity"].as_f64().expect("a number");
    assert!((viscosity / 46e-6 - 1.0).abs() < 1e-12);
}

#[test]
fn what_is_no_oil_is_refused() {
    for (arguments, wanted) in [
        (&["oil", "SAE 10W-41"][..], "did you mean \"SAE 10W-40\""),
        (&["oil", "VG 46", "--at", "80"], "has no unit; a temperature is wanted"),
        (&["oil", "VG 46", "--at", "-80 C"], "-80 C is not between -40 C and 250 C"),
        (&["oil", "--at", "80 C"], "NAME"),
    ] {
        let output = oilwedge(Path::new("."), arguments);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty());
        assert!(told.contains(wanted), "{arguments:?}: {told}");
    }
}

/// The oil of a grade at a temperature is that of its viscosity there.
#[test]
fn a_grade_is_its_viscosity() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = std::fs::read_to_string(path("01_plain_ring")).expect("scene 01");
    let text = text.replace("file = \"../meshes/ring.msh\"", "size = \"4 mm\"");
    let mut numbers = Vec::new();
    // 10 mm2/s times 850/(1 + 5 k_v) (1 - 20 k_v) kg/m3.
    for oil in ["grade = \"ISO VG 10\"\ntemperature = \"40 C\"", "viscosity = \"8.354301203858725 mPa.s\""] {
        std::fs::write(folder.path().join("a.toml"), text.replace("viscosity = \"0.4 Pa.s\"", oil)).expect("written");
        let output = oilwedge(folder.path(), &["solve", "a.toml", "--json"]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        let result: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        numbers.push(result["quantities"]["load"]["value"].as_f64().expect("a load"));
        let temperature = &result["quantities"]["temperature_effective"];
        match oil.starts_with("grade") {
            true => {
                assert!((temperature["value"].as_f64().expect("a temperature") - 40.0).abs() < 1e-9);
                assert_eq!(temperature["error"], 0.0);
                let density = result["regime"]["density"].as_f64().expect("a density");
                assert!((density - 835.43).abs() < 0.01, "{density}");
            }
            false => assert!(temperature.is_null()),
        }
    }
    assert!((numbers[0] / numbers[1] - 1.0).abs() < 1e-8, "{numbers:?}");
}
