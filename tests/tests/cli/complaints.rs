//! Broken scenes and arguments: exit status 2, nothing written, and a message that names file, key, value and way out.

use oilwedge_tests::bench::Bench;

const SHELL: &str = "02_flexpde_shell";

/// Scene 02 with one edit is refused, in these words, by `solve` and by `check`.
fn refused(from: &str, to: &str, words: &[&str]) {
    refused_with(&[(from, to)], words);
}

/// Scene 02 with these edits is refused, in these words, by `solve` and by `check`.
fn refused_with(edits: &[(&str, &str)], words: &[&str]) {
    let bench = Bench::new();
    bench.scene(SHELL, edits);
    for verb in ["solve", "check"] {
        let told = bench.refuses(&[verb, "scene.toml", "--json"], words);
        assert!(told.stderr.contains("scene.toml"), "{}", told.stderr);
    }
}

/// The position of scene 02.
const POSITION: &str = "eccentricity   = 0.6\nmin_film_angle = \"180 deg\"";

/// What replaces what in scene 02, and the words of the refusal.
#[rustfmt::skip]
const ONE_EDIT: [(&str, &str, &[&str]); 26] = [
    ("clearance", "clearence",
        &["scene.toml:9:1", "bearing.clearence", "this key is not known", "did you mean \"clearance\"?"]),
    ("[oil]", "[oli]", &["oli", "this table is not known", "did you mean \"oil\"?"]),
    ("z = \"0 mm\"", "colour = 5", &["feed \"feed_hole\".hole.colour", "known here: angle, diameter, z"]),
    ("\"37.5 um\"", "37.5",
        &["bearing.clearance", "a bare number has no unit", "37.5", "write clearance = \"37.5 um\""]),
    ("\"37.5 um\"", "\"37.5\"", &["bearing.clearance", "has no unit", "for example \"37.5 um\""]),
    ("\"37.5 um\"", "\"37.5 bar\"",
        &["bearing.clearance", "\"bar\" is a unit of pressure", "a length is wanted", "um, nm"]),
    ("\"0.4 Pa.s\"", "\"0.4 pa.s\"", &["oil.viscosity", "\"pa.s\"", "did you mean \"Pa.s\"?"]),
    ("\"0.98 bar\"", "\"0,98 bar\"", &["ends.pressure", "decimal comma", "0,98 bar"]),
    ("= 0.6", "= 1.0", &["journal.eccentricity", "1.0", "touches the liner", "give 0 <= eccentricity < 1"]),
    ("= 0.6", "= -0.1",
        &["journal.eccentricity", "-0.1", "is negative", "give 0 <= eccentricity < 1",
            "turn min_film_angle by 180 deg"]),
    ("= 0.6", "= nan", &["journal.eccentricity", "nan", "is not a finite number", "= 0.6"]),
    ("= 0.6", "= -nan", &["journal.eccentricity", "-nan", "is not a finite number", "= 0.6"]),
    ("= 0.6", "= inf", &["journal.eccentricity", "inf", "is not a finite number", "= 0.6"]),
    ("= 0.6", "= \"0.6\"", &["journal.eccentricity", "a plain number is wanted", "without quotes"]),
    (POSITION, "[load]\nforce = \"-5 kN\"\nangle = \"270 deg\"\n",
        &["load.force: is negative", "-5 kN", "turn angle by 180 deg"]),
    (POSITION, "[load]\nforce = \"inf N\"\nangle = \"270 deg\"\n",
        &["load.force", "\"inf N\"", "for example \"5 kN\""]),
    (POSITION, "[load]\nforce = 5\nangle = \"270 deg\"\n",
        &["load.force", "a bare number has no unit; a force is wanted", "N, mN, kN"]),
    (POSITION, "[load]\nforce = \"5 kN\"\n", &["load.angle: is missing", "write for example angle = \"270 deg\""]),
    (POSITION, "eccentricity = 0\nsqueeze = { radial = \"2 mm/s\" }",
        &["journal.min_film_angle: is missing", "write for example min_film_angle = \"180 deg\"",
            "with eccentricity = 0 it says where the line of centres points"]),
    ("eccentricity   = 0.6", "squeeze = { radial = \"2 mm\" }\neccentricity = 0.6",
        &["journal.squeeze.radial", "\"mm\" is a unit of length", "a velocity is wanted", "mm/s"]),
    ("[oil]", "[heat]\ninlet = \"75 C\"\n[oil]",
        &["oil.viscosity: ", "[heat] needs one that falls with temperature", "grade = \"SAE 10W-40\""]),
    ("[oil]", "[heat]\n[oil]", &["heat.inlet: is missing", "\"75 C\""]),
    ("[oil]", "[cavitation]\nmodel = \"reynolds\"\npressure = \"1.5 bar\"\n[oil]",
        &["cavitation.pressure: is 1.5 bar, above the 0.98 bar of ends.pressure: the oil there would be vapour",
            "at most that of ends and feeds, or raise ends.pressure"]),
    ("[oil]", "[cavitation]\nmodel = \"jfo\"\npressure = \"2 bar\"\n[oil]",
        &["for 2 reasons", "above the 1.96 bar of feed \"feed_hole\".pressure",
            "or raise feed \"feed_hole\".pressure"]),
    (POSITION, "",
        &["journal.eccentricity: is missing", "eccentricity = 0.6 and min_film_angle = \"180 deg\"",
            "or [load] with force = \"5 kN\" and angle = \"270 deg\""]),
    ("\"../meshes/flexpde_shell.msh\"", "\"\"", &["mesh.file", "is empty"]),
];

#[test]
fn one_wrong_key_or_value_is_told_with_the_way_out() {
    for (from, to, words) in ONE_EDIT {
        refused(from, to, words);
    }
}

#[test]
fn a_position_is_given_or_found() {
    let load = ("[oil]", "[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n[oil]");
    let beside = "stands beside [load], but under a load the position is found";
    let both = "remove eccentricity and min_film_angle from [journal], or remove [load]";
    refused_with(&[load], &["scene.toml:25:18", "journal.eccentricity", beside, both]);
    let angle = "remove min_film_angle from [journal], or remove [load]";
    let edits = [load, ("eccentricity   = 0.6\n", "")];
    refused_with(&edits, &["journal.min_film_angle", beside, angle]);
}

#[test]
fn a_tolerance_that_cannot_be_met_is_refused() {
    let tolerance = |value: &str| format!("tolerance = {value}\nfile = ");
    let one = |value: &str, words: &[&str]| refused("file = ", &tolerance(value), words);
    let range = "give a tolerance within 1e-8 % and 50 %";
    one("\"0 %\"", &["mesh.tolerance: is 0 %, but round-off hides errors below", range]);
    one("\"60 %\"", &["mesh.tolerance: is 60 %", "tells nothing", range]);
    one("0.001", &["mesh.tolerance", "a ratio is wanted", "write tolerance = \"0.1 %\""]);
    one("\"0.1\"", &["mesh.tolerance", "\"0.1\" has no unit", "%, ppm"]);
    one("{ laod = \"1 %\" }", &["mesh.tolerance.laod", "not known", "did you mean \"load\"?"]);
    one("{ eccentricity = \"1 %\" }", &["mesh.tolerance.eccentricity: follows from the position", "or [load]"]);
    let words = ["mesh.tolerance.feed_flow.fed_hole: belongs to no [[feed]]", "did you mean \"feed_flow.feed_hole\"?"];
    one("{ feed_flow.fed_hole = \"1 %\" }", &words);
}

#[test]
fn a_tolerance_needs_error_bars() {
    let bench = Bench::new();
    bench.scene(SHELL, &[("file = ", "tolerance = \"1 %\"\nfile = ")]);
    let words = [
        "--bars none conflicts with the mesh.tolerance of the scene scene.toml",
        "leave out --bars none, or remove tolerance",
    ];
    bench.refuses(&["solve", "scene.toml", "--bars", "none"], &words);
    let told = bench.run(&["check", "scene.toml"]);
    assert!(told.status == 0 && told.stdout.contains("\ntolerance load to 1 %\n"), "{}", told.stdout);
    // The tolerance of a scene that gives none is no reason to refuse.
    bench.scene("15_squeezed_ring", &[]);
    let told = bench.run(&["solve", "scene.toml", "--bars", "none"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let told = bench.run(&["check", "scene.toml"]);
    assert!(told.stdout.contains("\ntolerance load to 0.5 %\n"), "{}", told.stdout);
}

#[test]
fn a_cavity_that_conserves_oil_needs_an_equation_and_a_journal_that_do() {
    let jfo = ("[oil]", "[cavitation]\nmodel = \"jfo\"\n[oil]");
    let words = ["oil.barus.form", "no balance of mass", "cavitation.model = \"jfo\"", "help: remove form"];
    refused_with(&[jfo, ("1/Pa\"", "1/Pa\", form = \"as-printed\"")], &words);
    let words = [
        "cavitation.model",
        "journal.speed is 0",
        "film fraction is undetermined",
        "take cavitation.model = \"reynolds\"",
    ];
    refused_with(&[jfo, ("\"10 rad/s\"", "\"0 rpm\"")], &words);
}

#[test]
fn several_complaints_come_at_once() {
    let bench = Bench::new();
    let edits = [
        ("\"37.5 um\"", "37.5"),
        ("\"17 mm\"", "\"170 mm\""),
        ("= 0.6", "= 1.5"),
        ("viscosity =", "viscocity ="),
        ("flexpde_shell.msh", "nowhere.msh"),
    ];
    bench.scene(SHELL, &edits);
    let words = [
        "for 5 reasons",
        "bearing.clearance",
        "feed \"feed_hole\".hole.diameter",
        "journal.eccentricity",
        "oil.viscocity",
        "mesh.file",
        "nowhere.msh",
    ];
    bench.refuses(&["solve", "scene.toml"], &words);
}

#[test]
fn a_mesh_that_is_no_file_is_told() {
    let folder = "give the path of a gmsh 4.1 file, counted from the folder of the scene";
    refused("flexpde_shell.msh", "nowhere.msh", &["mesh.file", "there is no file", "nowhere.msh", folder]);
    refused("../meshes/flexpde_shell.msh", ".", &["mesh.file", "is a folder", folder]);
    refused("../meshes/flexpde_shell.msh", "scene.toml", &["scene.toml", "not a gmsh mesh file", "msh41"]);
}

#[test]
fn what_is_no_scene_is_told() {
    let bench = Bench::new();
    let toml = "give the path of a scene in TOML";
    bench.refuses(&["solve", "."], &["the scene . is not a plain file", toml]);
    bench.refuses(&["solve", "nowhere.toml"], &["nowhere.toml", toml]);
    bench.write("empty.toml", "");
    bench.refuses(
        &["solve", "empty.toml"],
        &["empty.toml", "for 3 reasons", "write [bearing] with", "write [journal] with", "write [oil] with"],
    );
    bench.write("latin.toml", b"title = \"B\xfcchse\"\n");
    bench.refuses(&["solve", "latin.toml"], &["latin.toml", "not UTF-8", "save it as UTF-8"]);
    bench.write("mesh.toml", "$MeshFormat\n4.1 0 8\n");
    bench.refuses(&["solve", "mesh.toml"], &["mesh.toml", "is a gmsh mesh, not a scene", "below [mesh]"]);
    bench.write("broken.toml", "[bearing\ndiameter = \"75 mm\"\n");
    bench.refuses(&["solve", "broken.toml"], &["broken.toml:1:9", "not valid TOML", "a scene is TOML"]);
    bench.write("big.toml", vec![b'#'; (1 << 20) + 1]);
    bench.refuses(&["solve", "big.toml"], &["big.toml", "larger than 1048576 bytes", "is it a mesh"]);
}

#[test]
fn a_hostile_text_cannot_steer_the_terminal() {
    let bench = Bench::new();
    bench.scene(SHELL, &[("clearance =", "\"\\u001b[31mred\" ="), ("title = \"", "title = \"\\u001b[31m")]);
    let told = bench.refuses(&["check", "scene.toml"], &["this key is not known"]);
    assert!(!told.stderr.contains('\u{1b}'), "{}", told.stderr);
    bench.scene(SHELL, &[("title = \"", "title = \"\\u001b[31m")]);
    let told = bench.run(&["check", "scene.toml"]);
    assert!(told.status == 0 && !told.stdout.contains('\u{1b}'), "{}", told.stdout);
}

#[test]
fn wrong_arguments_are_refused() {
    let bench = Bench::new();
    bench.scene(SHELL, &[]);
    bench.refuses(&[], &["Usage: oilwedge", "Examples:"]);
    bench.refuses(&["solve"], &["<SCENE>", "--help"]);
    bench.refuses(&["solv", "scene.toml"], &["'solv'", "'solve'"]);
    bench.refuses(&["solve", "scene.toml", "--jsn"], &["'--jsn'", "'--json'"]);
    bench.refuses(&["solve", "scene.toml", "--threads", "0"], &["'0'", "1..=1024"]);
    bench.refuses(&["solve", "scene.toml", "--threads", "many"], &["'many'"]);
    bench.refuses(&["solve", "scene.toml", "--out", ""], &["--out"]);
    bench.refuses(&["solve", "scene.toml", "--bars", "some"], &["'some'", "auto, none"]);
    for (limit, wanted) in [("--max-seconds", "seconds above zero"), ("--max-unknowns", "whole number above zero")] {
        for wrong in ["0", "-1", "nan", "many"] {
            bench.refuses(&["solve", "scene.toml", &format!("{limit}={wrong}")], &[wrong, wanted]);
        }
    }
}
