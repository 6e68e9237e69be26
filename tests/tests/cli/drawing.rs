//! Liners without a mesh file: meshed, written, drawn, and refused by name.

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::program::repository;

/// Scene 10 with edits, as `scene.toml`.
fn drawn(bench: &Bench, edits: &[(&str, &str)]) {
    bench.scene("10_drawn_liner", edits);
}

fn load(bench: &Bench, scene: &str) -> f64 {
    let told = bench.run(&["solve", scene, "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    object(&told.stdout)["quantities"]["load"]["value"].as_f64().expect("a load")
}

#[test]
fn a_written_mesh_is_the_mesh_that_is_solved() {
    let bench = Bench::new();
    drawn(&bench, &[]);
    let told = bench.run(&["mesh", "scene.toml", "-o", "liner.msh"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""));
    assert!(told.stdout.starts_with("liner.msh: "), "{}", told.stdout);
    let own = load(&bench, "scene.toml");
    let scene = std::fs::read_to_string(repository().join("scenes/10_drawn_liner.toml")).expect("scene 10");
    bench.write("file.toml", scene.replacen("size = \"4 mm\"", "file = \"liner.msh\"", 1));
    // The same nodes in the same order, written with all their digits; an axial shift of rounding remains.
    let read_back = load(&bench, "file.toml");
    assert!((read_back / own - 1.0).abs() < 1e-10, "{own} {read_back}");
}

#[test]
fn what_cannot_be_drawn_is_named() {
    let bench = Bench::new();
    for (from, to, words) in [
        ("angle = \"240 deg\"", "angle = \"300 deg\"", ["overlaps \"groove\"", "give both one pressure"]),
        ("z = \"15 mm\"", "z = \"32.49 mm\"", ["\"hole_a\" leaves", "of land to the edge"]),
        ("diameter = \"10 mm\"", "diameter = \"10 um\"", ["\"hole_a\" is", "thinner than can be meshed"]),
        ("size = \"4 mm\"", "size = \"1 um\"", ["more than", "choose a larger size"]),
        ("size = \"4 mm\"", "size = \"0 mm\"", ["mesh.size", "is not positive"]),
        ("hole     = { diameter = \"10 mm\", angle = \"30 deg\", z = \"15 mm\" }", "", ["has no shape", "hole = {"]),
    ] {
        drawn(&bench, &[(from, to)]);
        bench.refuses(&["solve", "scene.toml"], &words);
        bench.refuses(&["mesh", "scene.toml", "-o", "liner.msh"], &words);
    }
}

#[test]
fn check_tells_and_draws_the_liner() {
    let bench = Bench::new();
    drawn(&bench, &[]);
    let told = bench.run(&["check", "scene.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    for part in [
        "full ring, periodic; diameter 75 mm",
        "\"hole_b\": hole of 8 mm at 240 deg, z = -12 mm, at 3 bar",
        "AAAA",
        "A groove, B hole_a, C hole_b",
    ] {
        assert!(told.stdout.contains(part), "{part}\n{}", told.stdout);
    }
}

#[test]
fn check_tells_the_load_that_the_film_is_to_carry() {
    let bench = Bench::new();
    let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"\n";
    let load = "squeeze = { radial = \"2 mm/s\" }\n[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n";
    bench.scene("01_plain_ring", &[(position, load)]);
    let told = bench.run(&["check", "scene.toml"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    for part in [
        "load of 5000 N at 270 deg; the position of the journal is found",
        "squeeze",
        "pressed out as the journal's centre moves",
        "equilibrium",
        "the position is found where the film carries the load",
    ] {
        assert!(told.stdout.contains(part), "{part}\n{}", told.stdout);
    }
}

#[test]
fn a_pocket_is_a_deeper_film() {
    let bench = Bench::new();
    let pocket = |depth: &str| {
        let groove =
            "groove   = { from = \"290 deg\", to = \"310 deg\", width = \"56.25 mm\" }\npressure = \"1.96 bar\"";
        let deeper =
            groove.replace("\"56.25 mm\" }\npressure = \"1.96 bar\"", &format!("\"56.25 mm\" }}\ndepth = \"{depth}\""));
        drawn(&bench, &[(groove, &deeper)]);
        load(&bench, "scene.toml")
    };
    let (even, shallow, deep) = (pocket("0 um"), pocket("1 nm"), pocket("200 um"));
    assert!((shallow / even - 1.0).abs() < 1e-3 && (deep / even - 1.0).abs() > 1e-2, "{even} {shallow} {deep}");
}

#[test]
fn a_groove_that_is_not_that_of_the_mesh_is_refused() {
    let bench = Bench::new();
    let pressure =
        "group    = \"groove\"                             # 20 degrees wide, 0.75 of the length, at 300 degrees\n";
    let groove =
        |from: &str| format!("{pressure}groove = {{ from = \"{from}\", to = \"310 deg\", width = \"56.25 mm\" }}\n");
    bench.scene("07_grooved_liner", &[(pressure, &groove("290 deg"))]);
    assert_eq!(bench.run(&["solve", "scene.toml"]).status, 0);
    bench.scene("07_grooved_liner", &[(pressure, &groove("250 deg"))]);
    bench.refuses(&["solve", "scene.toml"], &["\"groove\" is not that of the mesh file", "remove groove"]);
}

#[test]
fn a_groove_beside_the_film_start_is_told() {
    let bench = Bench::new();
    let clearance = "clearance = \"37.5 um\"\n";
    let start = |angle: &str| format!("clearance = \"37.5 um\"\nfilm_start = \"{angle}\"\n");
    drawn(&bench, &[(clearance, &start("289.999 deg"))]);
    bench.refuses(&["solve", "scene.toml"], &["\"groove\" and \"the film start\"", "of land between"]);
    drawn(&bench, &[(clearance, &start("300 deg"))]);
    assert_eq!(bench.run(&["solve", "scene.toml"]).status, 0);
}

#[test]
fn liners_too_narrow_to_be_meshed_are_refused() {
    let bench = Bench::new();
    let clearance = "clearance = \"37.5 um\"\n";
    let arc = format!("{clearance}arc = {{ from = \"0 deg\", to = \"1e-6 deg\" }}\n");
    bench.scene("09_drawn_ring", &[(clearance, &arc)]);
    bench.refuses(&["solve", "scene.toml"], &["the coarsest mesh of the liner", "lands and grooves are not so small"]);
}
