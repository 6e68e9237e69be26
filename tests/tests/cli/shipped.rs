//! The shipped scenes through the program, and its help.

use oilwedge_tests::bench::{Bench, edited, lines_without_times, object};
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::table;

const TENSION: &str = "full Sommerfeld film: the pressure falls to";
const HEATED: &str = "an assumption does not hold: a film as warm as its oil is fed";
/// Orbits: they take long as they are shipped.
const COARSE: [&str; 4] =
    ["27_big_end_orbit", "28_big_end_orbit_conserving", "34_elastic_big_end_orbit", "35_squeeze_film_damper"];
const COARSELY: &str = "the film is not resolved where it is thin";
const PRINTED: &str = "the as-printed equation is no mass balance";

/// Every shipped scene and the beginnings of its warnings.
const SCENES: [(&str, &[&str]); 40] = [
    ("01_plain_ring", &[TENSION, HEATED]),
    ("02_flexpde_shell", &[TENSION]),
    ("03_hydrostatic_shell", &[]),
    ("04_flexpde_ring", &[TENSION, HEATED]),
    ("05_flexpde_ring_top", &[TENSION, HEATED]),
    ("06_flexpde_as_printed", &[TENSION, PRINTED]),
    ("07_grooved_liner", &[TENSION, HEATED]),
    ("08_flexpde_study_size", &[TENSION]),
    ("09_drawn_ring", &[TENSION, HEATED]),
    ("10_drawn_liner", &[TENSION, HEATED]),
    ("11_swift_stieber_ring", &[HEATED]),
    ("12_flexpde_shell_cavitated", &[]),
    ("13_grooved_ring", &[]),
    ("14_starved_pad", &[]),
    ("15_squeezed_ring", &[]),
    ("16_loaded_shell", &[]),
    ("17_engine_main_bearing", &[]),
    ("18_sweep_eccentricity", &[TENSION]),
    (
        "19_connecting_rod_cap",
        &[
            "an assumption does not hold: a viscosity that does not depend on pressure",
            "an assumption does not hold: rigid surfaces",
            HEATED,
        ],
    ),
    ("20_heat_balance", &[]),
    ("21_short_crankshaft_bearing", &[]),
    ("22_squeezed_crankshaft_bearing", &[]),
    ("23_tilted_ring", &[]),
    ("24_load_off_the_middle", &[]),
    ("25_whirl", &[]),
    ("26_tilting_crankshaft_journal", &[]),
    // On the coarse mesh on which orbits are solved here.
    ("27_big_end_orbit", &[COARSELY, HEATED]),
    ("28_big_end_orbit_conserving", &[COARSELY, "an assumption does not hold: rigid surfaces", HEATED]),
    (
        "29_mixed_lubrication",
        &[
            "an assumption does not hold: a viscosity that does not depend on pressure",
            "an assumption does not hold: rigid surfaces",
            HEATED,
        ],
    ),
    ("31_worn_bore", &[]),
    ("32_crowned_bore", &[]),
    ("33_polymer_liner", &[]),
    (
        "34_elastic_big_end_orbit",
        &[COARSELY, "an assumption does not hold: slices of the wall that move by themselves", HEATED],
    ),
    ("35_squeeze_film_damper", &[]),
    ("36_thermal_engine_main", &[]),
    ("37_tolerances", &[]),
    ("38_thermal_turbine", &[]),
    ("39_turbine_turbulent", &[HEATED]),
    ("40_design", &[]),
    ("41_thermal_turbulent", &[]),
];

/// Scenes that are solved on one thread too: a linear film, one that breaks, a balance of heat, a tangent, a wall.
const ON_ONE_THREAD: [&str; 5] =
    ["02_flexpde_shell", "12_flexpde_shell_cavitated", "20_heat_balance", "25_whirl", "33_polymer_liner"];

/// The scene to solve, and how. Orbits have a coarse mesh and no bars here; as they are shipped, the full tier solves
/// them.
fn to_solve(bench: &Bench, name: &str) -> (String, &'static [&'static str]) {
    if !COARSE.contains(&name) {
        return (shipped(name), &[]);
    }
    let mut scene: toml::Table = edited(name, &[]).parse().expect("a scene");
    table(&mut scene, "mesh").insert("size".into(), "40 mm".into());
    let file = format!("{name}.toml");
    let loads = repository().join("scenes/loads");
    bench.write(&file, scene.to_string().replace("\"loads/", &format!("\"{}/", loads.display())));
    (file, &["--bars", "none"])
}

fn shipped(name: &str) -> String {
    repository().join(format!("scenes/{name}.toml")).display().to_string()
}

/// The numbers and the picture of a scene are the same bits on one thread and on two or three.
#[test]
fn every_scene_solves_with_the_warnings_expected_on_any_number_of_threads() {
    let bench = Bench::new();
    for (number, (name, warnings)) in SCENES.into_iter().enumerate() {
        let (scene, bars) = to_solve(&bench, name);
        let solved = |threads: &str| bench.run(&[&["solve", &scene, "--json", "--threads", threads], bars].concat());
        let told = solved(if number % 2 == 0 { "2" } else { "3" });
        assert_eq!(told.status, 0, "{name}: {}", told.stderr);
        let result = object(&told.stdout);
        assert_eq!(result["status"], "converged", "{name}");
        let given = result["warnings"].as_array().expect("warnings");
        assert_eq!(given.len(), warnings.len(), "{name}: {given:?}");
        for (given, expected) in given.iter().zip(warnings) {
            let given = given.as_str().expect("a text");
            assert!(given.starts_with(expected), "{name}: {given}");
            assert!(told.stderr.contains(&format!("warning: {given}")), "{name}: {}", told.stderr);
        }
        let picture = || std::fs::read(bench.path().join(format!("out/{name}/film.vtu"))).expect("a picture");
        let drawn = picture();
        if ON_ONE_THREAD.contains(&name) {
            let alone = solved("1");
            assert_eq!(lines_without_times(&alone.stdout), lines_without_times(&told.stdout), "{name}");
            assert!(picture() == drawn, "{name}: another picture");
        }
        let told = bench.run(&["check", &shipped(name)]);
        assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{name}");
    }
    assert!(ON_ONE_THREAD.iter().all(|one| SCENES.iter().any(|(name, _)| name == one)));
}

#[test]
fn all_scenes_are_tried_here() {
    let mut shipped: Vec<String> = std::fs::read_dir(repository().join("scenes"))
        .expect("scenes")
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()))
        .collect();
    shipped.sort_unstable();
    assert_eq!(shipped, SCENES.map(|(name, _)| name));
}

#[test]
fn every_mesh_can_be_checked_by_itself() {
    let bench = Bench::new();
    for entry in std::fs::read_dir(repository().join("meshes")).expect("meshes") {
        let path = entry.expect("an entry").path();
        if path.extension().is_some_and(|ending| ending == "msh") {
            let told = bench.run(&["check", &path.display().to_string()]);
            assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{}", path.display());
        }
    }
}

#[test]
fn the_first_scene_has_at_most_fifteen_lines() {
    let text = std::fs::read_to_string(repository().join("scenes/01_plain_ring.toml")).expect("scene 01");
    assert!(text.lines().count() <= 15);
}

#[test]
fn help_has_examples_and_the_exit_status() {
    let bench = Bench::new();
    let verbs = [
        &["--help"][..],
        &["solve", "--help"],
        &["check", "--help"],
        &["mesh", "--help"],
        &["load", "--help"],
        &["sweep", "--help"],
        &["oil", "--help"],
    ];
    for arguments in verbs {
        let told = bench.run(arguments);
        assert_eq!((told.status, told.stderr.as_str()), (0, ""));
        for part in ["Usage: oilwedge", "Examples:\n  oilwedge ", "Exit status: 0 ", "2 "] {
            assert!(told.stdout.contains(part), "{arguments:?}: no {part:?} in\n{}", told.stdout);
        }
    }
    let top = bench.run(&["--help"]).stdout;
    assert!(top.contains("scenes/01_plain_ring.toml") && top.contains("--threads"));
    let version = bench.run(&["--version"]).stdout;
    assert_eq!(version.trim(), concat!("oilwedge ", env!("CARGO_PKG_VERSION")));
}
