//! Limits, units and names: what a scene says about its bearing, and what is said where it is unlikely.

use oilwedge_study::result::{Origin, RunResult, Verdict};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::scenes::written;

const PLAIN: &str = r#"
[bearing]
diameter = "60 mm"
length = "30 mm"
clearance = "30 um"
[mesh]
size = "4 mm"
[journal]
speed = "3000 rpm"
eccentricity = 0.6
min_film_angle = "300 deg"
[oil]
viscosity = "20 mPa.s"
[cavitation]
model = "reynolds"
"#;
const HOT: [(&str, &str); 1] = [("viscosity = \"20 mPa.s\"", "grade = \"SAE 30\"\n[heat]\ninlet = \"60 C\"")];

fn edited(edits: &[(&str, &str)], more: &str) -> String {
    let text = edits.iter().fold(PLAIN.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    text + more
}

/// The result of a scene.
fn result(text: &str) -> RunResult {
    let scene = written(text);
    run(&scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}")).result
}

/// What its criteria find: what, verdict, and whether it decides.
fn verdicts(result: &RunResult) -> Vec<(&str, Verdict, bool)> {
    let all = result.criteria.iter();
    all.map(|it| (it.what.as_str(), it.verdict, it.decides)).collect()
}

/// A limit has one verdict, whichever table it stands in and by whatever name, and no warning beside it.
#[test]
fn a_limit_of_any_table_is_one_criterion() {
    let of = |table: &str, keys: &str| result(&edited(&[], &format!("[{table}]\n{keys}\n")));
    let keys = "film_min = \"12.1 um\"\npressure_max = \"120 bar\"";
    let (new, old) = (of("criteria", keys), of("limits", keys));
    assert_eq!(new.criteria, old.criteria);
    let wanted = [("least film", Verdict::Fail, true), ("greatest pressure", Verdict::Pass, true)];
    assert_eq!(verdicts(&new), wanted);
    assert_eq!(new.criteria[0].fault(), "least film below 12.1 um");
    let codes = |result: &RunResult| result.tail.warnings.iter().map(|warning| warning.kind.code).collect::<Vec<_>>();
    assert_eq!([codes(&new), codes(&old)], [["warmed"], ["warmed"]]);
    let given = [("viscosity = \"20 mPa.s\"", "grade = \"SAE 30\"\ntemperature = \"90 C\"")];
    let hot = result(&edited(&given, "[criteria]\ntemperature_max = \"85 C\"\n"));
    assert_eq!(hot.criteria[0].fault(), "temperature of the film above 85 degC");
}

/// A limit of the scene replaces the usual value that `[heat]` brings; a usual value decides nothing.
#[test]
fn a_usual_value_makes_no_bearing_unfit() {
    let heavy = [HOT[0], ("\"30 um\"", "\"4 um\""), ("eccentricity = 0.6", "eccentricity = 0.5")];
    let free = result(&edited(&heavy, ""));
    let film = &free.criteria[0];
    assert_eq!((film.what.as_str(), film.least, film.origin), ("least film", Some(4.0), Origin::Usual));
    assert_eq!((film.verdict, Verdict::of(&free.criteria)), (Verdict::Fail, None));
    assert!(free.temperature.expect("a balance of heat").is_fit);
    let limited = result(&edited(&heavy, "[criteria]\nfilm_min = \"1 um\"\n"));
    let films: Vec<_> = limited.criteria.iter().filter(|it| it.what == "least film").collect();
    assert!(films.len() == 1 && films[0].decides && films[0].least == Some(1.0), "{films:?}");
    assert_eq!(Verdict::of(&limited.criteria), Some(Verdict::Pass));
}

/// A limit in `[limits]` is the criterion of the heat balance that it is in `[heat]`.
#[test]
fn one_table_of_limits() {
    let report = |more: &str| {
        let scene = written(&edited(&HOT, more));
        let run = run(&scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"));
        run.result.temperature.expect("a balance of heat")
    };
    let fit = |report: &oilwedge_study::result::TemperatureReport| {
        let met = report.criteria.iter().map(|it| (it.what.clone(), it.is_met));
        met.collect::<Vec<_>>()
    };
    let old = report("[limits]\nfilm_min = \"14 um\"\ntemperature_max = \"70 C\"\n");
    let scene = edited(&HOT, "")
        .replace("inlet = \"60 C\"", "inlet = \"60 C\"\nfilm_min = \"14 um\"\ntemperature_max = \"70 C\"");
    let run = run(&written(&scene), &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(fit(&old), fit(&run.result.temperature.expect("a balance of heat")));
    assert!(!old.is_fit);
    let pressed = report("[limits]\npressure_max = \"5 bar\"\n");
    let of_pressure = pressed.criteria.iter().find(|it| it.what == "greatest pressure");
    let of_pressure = of_pressure.expect("a criterion");
    assert!(of_pressure.decides && !of_pressure.is_met && !pressed.is_fit, "{pressed:?}");
}

#[test]
fn limits_are_refused_where_they_stand_twice_or_alone() {
    let bench = Bench::new();
    let refused = |text: String, words: &[&str]| {
        bench.write("scene.toml", text);
        bench.refuses(&["solve", "scene.toml"], words);
    };
    let twice = edited(&HOT, "[limits]\nfilm_min = \"3 um\"\n").replace("inlet", "film_min = \"2 um\"\ninlet");
    refused(twice, &["heat.film_min", "stands beside limits.film_min"]);
    let twice = edited(&[], "[limits]\nfilm_min = \"3 um\"\n[criteria]\nfilm_min = \"3 um\"\n");
    refused(twice, &["limits.film_min", "stands beside criteria.film_min"]);
    let alone = edited(&[], "[limits]\ntemperature_max = \"90 C\"\n");
    refused(alone, &["limits.temperature_max", "the film of this scene has no temperature"]);
    refused(edited(&[], "[limits]\npressure = \"90 bar\"\n"), &["did you mean \"pressure_max\"?"]);
}

#[test]
fn a_diametral_clearance_is_twice_the_radial_one() {
    let radial = written(PLAIN);
    let diametral = written(&edited(&[("clearance = \"30 um\"", "diametral_clearance = \"60 um\"")], ""));
    assert_eq!(radial.bearing, diametral.bearing);
    let bench = Bench::new();
    bench.write("scene.toml", edited(&[("clearance", "diametral_clearance = \"60 um\"\nclearance")], ""));
    bench.refuses(&["solve", "scene.toml"], &["bearing.diametral_clearance", "stands beside clearance"]);
}

/// The power of a squeezed journal at rest heats the oil that leaves at the ends: `F v = rho c Q (t_out - t_in)`, with
/// the mean of both temperatures that of the film.
#[test]
fn squeeze_heats_a_journal_at_rest() {
    let squeezed = [HOT[0], ("\"3000 rpm\"", "\"0 rpm\"\nsqueeze = { radial = \"20 mm/s\" }")];
    let scene = written(&edited(&squeezed, ""));
    let run = run(&scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    let value = |name: &str| {
        let found = run.result.quantities.iter().find(|it| it.name == name);
        found.unwrap_or_else(|| panic!("no {name}")).value
    };
    let power = value("load_x") * 300f64.to_radians().cos() + value("load_y") * 300f64.to_radians().sin();
    let power = 0.02 * power.abs();
    let carried = 1.8e6 * value("side_flow") * 2.0 * (value("temperature_effective") - 60.0);
    assert!((carried / power - 1.0).abs() < 5e-3, "{carried} {power}");
    let bench = Bench::new();
    bench.write("scene.toml", edited(&[HOT[0], ("3000 rpm", "0 rpm")], ""));
    bench.refuses(&["solve", "scene.toml"], &["journal.speed", "the centre does not move", "journal.squeeze"]);
}

#[test]
fn meshes_are_written_as_gmsh_files_only() {
    let bench = Bench::new();
    bench.write("scene.toml", PLAIN);
    for name in ["liner.vtk", "liner", "liner.msh.gz"] {
        let words = ["a gmsh file (.msh) is the only form", name];
        bench.refuses(&["mesh", "scene.toml", "-o", name], &words);
    }
    assert_eq!(bench.run(&["mesh", "scene.toml", "-o", "liner.MSH"]).status, 0);
}

#[test]
fn lengths_of_metres_are_suspected() {
    let bench = Bench::new();
    bench.write("scene.toml", edited(&[("60 mm", "60 m"), ("30 mm", "30 m"), ("30 um", "30 mm"), ("4 mm", "4 m")], ""));
    let told = bench.run(&["check", "scene.toml"]);
    assert!(
        told.status == 0 && told.stderr.contains("larger than any bearing: are bearing.diameter"),
        "{}",
        told.stderr
    );
    assert_eq!(bench.run(&["mesh", "scene.toml", "-o", "liner.msh"]).status, 0);
    let told = bench.run(&["check", "liner.msh"]);
    assert!(told.stderr.contains("[mesh] unit = \"mm\""), "{}", told.stderr);
    bench.write("scene.toml", PLAIN);
    let told = bench.run(&["check", "scene.toml"]);
    assert!(!told.stderr.contains("larger than any bearing"), "{}", told.stderr);
}

#[test]
fn misspelt_groups_of_a_mesh_are_told_with_the_nearest_name() {
    let bench = Bench::new();
    bench.write("scene.toml", PLAIN);
    assert_eq!(bench.run(&["mesh", "scene.toml", "-o", "liner.msh"]).status, 0);
    let mesh = std::fs::read_to_string(bench.path().join("liner.msh")).expect("the mesh");
    bench.write("liner.msh", mesh.replace("\"end_low\"", "\"end_lo\""));
    bench.write("scene.toml", edited(&[("size = \"4 mm\"", "file = \"liner.msh\"")], ""));
    bench.refuses(&["solve", "scene.toml"], &["is curve \"end_lo\" meant as curve \"end_low\"?"]);
}

/// Feeds are called by their names, unless two have one.
#[test]
fn feeds_are_called_by_name() {
    let bench = Bench::new();
    let feed = |name: &str, z: u32| {
        let hole = format!("hole = {{ diameter = \"9 mm\", angle = \"{z}0 deg\", z = \"{z} mm\" }}");
        format!("[[feed]]\ngroup = \"{name}\"\npressure = \"1 bar\"\n{hole}\n")
    };
    bench.write("scene.toml", edited(&[], &(feed("a", 1) + &feed("b", 14))));
    bench.refuses(&["check", "scene.toml"], &["feed \"b\".hole.z: puts the hole's rim"]);
    bench.write("scene.toml", edited(&[], &(feed("a", 1) + &feed("a", 14))));
    bench.refuses(&["check", "scene.toml"], &["feed[1].hole.z", "feed[1].group: \"a\" is fed already"]);
}

/// An exponent for which no film exists is not answered by the advice to take the law that the scene has.
#[test]
fn a_roelands_scene_is_not_advised_to_take_roelands() {
    let thick = [
        ("viscosity = \"20 mPa.s\"", "viscosity = \"0.4 Pa.s\"\nroelands = { z = 1.4 }"),
        ("eccentricity = 0.6", "eccentricity = 0.9"),
    ];
    let bench = Bench::new();
    bench.write("scene.toml", edited(&thick, ""));
    let told = bench.run(&["solve", "scene.toml"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    assert!(!told.stdout.contains("(Roelands)") && !told.stderr.contains("(Roelands)"), "{}", told.stdout);
    assert!((told.stdout + &told.stderr).contains("a smaller exponent"));
}
