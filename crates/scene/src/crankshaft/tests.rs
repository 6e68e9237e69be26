use std::path::Path;

use super::*;
use crate::SceneError;

const STRAIGHT: &str = r#"
title = "Three bearings"
[crankshaft]
speed = "2000 rpm"
youngs_modulus = "206 GPa"
[[crankshaft.piece]]
length = "400 mm"
diameter = "60 mm"
[[crankshaft.bearing]]
scene = "main.toml"
at = "0 mm"
[[crankshaft.bearing]]
scene = "main.toml"
name = "middle"
at = "200 mm"
support = { stiffness = "200 MN/m" }
[[crankshaft.load]]
at = "100 mm"
force = "12 kN"
angle = "270 deg"
"#;

const CRANKED: &str = r#"
[crankshaft]
speed = "3000 rpm"
youngs_modulus = "206 GPa"
shear_modulus = "79 GPa"
piece = [
    { length = "30 mm", diameter = "60 mm" },
    { fires_at = "0 deg" },
    { length = "30 mm", diameter = "60 mm" },
]
throw = { pin_length = "30 mm", pin_diameter = "50 mm", web_thickness = "20 mm", web_mass = "1 kg" }
bearing = [{ scene = "a.toml", at = "15 mm" }, { scene = "a.toml", at = "115 mm" }]
counterweight = [{ throw = 1, web = 2, mass = "1 kg", radius = "50 mm" }]
[crank]
radius = "45 mm"
rod_length = "150 mm"
reciprocating_mass = "0.6 kg"
rotating_mass = "0.5 kg"
bore = "86 mm"
gas = { peak = "7 MPa", angle = "12 deg", sharpness = 14 }
[orbit]
"#;

fn read(text: &str) -> Result<ShaftScene, String> {
    ShaftScene::parse(text, Path::new("folder/shaft.toml")).map_err(|error| error.to_string())
}

#[test]
fn shafts_are_read() {
    let scene = read(STRAIGHT).expect("a scene");
    let shaft = &scene.crankshaft;
    assert_eq!(shaft.bearings[0].scene, Path::new("folder/main.toml"));
    assert_eq!((&*shaft.bearings[0].name, &*shaft.bearings[1].name), ("1", "middle"));
    let supports = [0, 1].map(|k: usize| shaft.bearings[k].support.stiffness);
    assert_eq!(supports, [f64::INFINITY, 2e8]);
    let [x, y] = shaft.loads[0].force;
    assert!(x.abs() < 1e-8 && (y + 12e3).abs() < 1e-8);
    let scene = read(CRANKED).expect("a scene");
    assert_eq!(scene.title, "shaft");
    assert!((scene.crankshaft.length() - 0.13).abs() < 1e-15);
    assert_eq!(scene.crankshaft.fires_at(), [0.0]);
    let weight = scene.crankshaft.counterweights[0];
    assert_eq!((weight.throw, weight.web, weight.moment), (0, 1, 0.05));
    assert_eq!(scene.files().len(), 2);
}

#[test]
fn what_does_not_fit_is_refused() {
    let change = |text: &str, from: &str, to: &str, wanted: &str| {
        assert!(text.contains(from), "{from}");
        let error = read(&text.replacen(from, to, 1)).expect_err(wanted);
        assert!(error.contains(wanted), "{wanted}: {error}");
    };
    change(STRAIGHT, "at = \"200 mm\"", "at = \"500 mm\"", "bearing[1].at: lies on no straight piece");
    change(STRAIGHT, "at = \"200 mm\"", "at = \"0 mm\"", "bearing[1].at: does not lie behind");
    change(STRAIGHT, "name = \"middle\"", "name = \"1\"", "bearing[1].name: is the name of");
    change(STRAIGHT, "speed = \"2000 rpm\"", "speed = \"0 rpm\"", "crankshaft.speed: is not positive");
    change(STRAIGHT, "diameter = \"60 mm\"", "diameter = \"60 mm\"\nbore = \"60 mm\"", "piece[0].bore: is not between");
    change(STRAIGHT, "[[crankshaft.load]]", "[[crankshaft.weight]]", "weight: this key is not known");
    change(CRANKED, "shear_modulus = \"79 GPa\"", "", "shear_modulus: is missing");
    change(CRANKED, "throw = 1, web", "throw = 2, web", "throw: is no throw of the shaft, which has 1");
    change(CRANKED, "web = 2", "web = 3", "web: is neither 1 nor 2");
    change(CRANKED, "[orbit]", "", "crank: stands without [orbit]");
    change(CRANKED, "[orbit]", "[orbit]\nmass = \"1 kg\"", "orbit.mass: has no meaning");
    change(CRANKED, "radius = \"45 mm\"", "radius = \"450 mm\"", "crank.radius: is not less than rod_length");
    let loose = "    { length = \"30 mm\", diameter = \"60 mm\" },\n]";
    change(CRANKED, loose, "]", "piece[1]: is a throw without straight pieces");
}

#[test]
fn one_bearing_and_a_shaft_are_told_apart() {
    let error = crate::Scene::parse(STRAIGHT, Path::new("shaft.toml"), &[]).expect_err("no bearing");
    assert!(matches!(error, SceneError::Crankshaft { .. }), "{error}");
    let error = read("bearing = {}").expect_err("no shaft");
    assert!(error.contains("crankshaft: this table is missing"), "{error}");
}
