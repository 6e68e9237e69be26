//! `converge`: what accuracy costs, as tables, for scripts and as pictures.

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::program::repository;
use serde_json::Value;
use std::collections::{BTreeSet, HashSet};
use std::io::Cursor;

const FILES: [&str; 4] = ["converge.csv", "converge.json", "converge.png", "converge.svg"];

/// Names of the files in a folder of the bench.
fn names(bench: &Bench, folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(bench.path().join(folder)).expect("a folder");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn read(bench: &Bench, file: &str) -> String {
    std::fs::read_to_string(bench.path().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

fn levels<'a>(study: &'a Value, strategy: &str) -> &'a [Value] {
    let strategies = study["strategies"].as_array().expect("strategies");
    let course = strategies.iter().find(|course| course["strategy"] == strategy);
    course.and_then(|course| course["levels"].as_array()).map_or(&[], Vec::as_slice)
}

/// All keys of an object and of those within it, lists by their first entry; parts of times by no name.
fn keys(value: &Value, path: &str, found: &mut BTreeSet<String>) {
    match value {
        Value::Object(object) => {
            for (key, value) in object {
                let path = format!("{path}.{key}");
                if !path.ends_with(".parts") {
                    keys(value, &path, found);
                }
                found.insert(path);
            }
        }
        Value::Array(entries) => entries.iter().take(1).for_each(|entry| keys(entry, path, found)),
        _ => {}
    }
}

#[test]
fn a_study_of_the_plain_ring_is_told_written_and_drawn() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let told = bench.run(&["converge", "scene.toml", "--max-seconds", "2"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""), "{}", told.stdout);
    for part in [
        "Plain ring: converged",
        "P1 uniform",
        "P2 adaptive",
        "unknowns",
        "load [kN]",
        "factorise",
        "Cost of accuracy, by error bars",
        "by the true error",
        "predicted, not run",
        "out/scene: converge.csv, converge.json, converge.svg, converge.png",
    ] {
        assert!(told.stdout.contains(part), "no {part:?} in\n{}", told.stdout);
    }
    assert_eq!(names(&bench, "out/scene"), FILES);

    let study = object(&read(&bench, "out/scene/converge.json"));
    assert_eq!(study["format"], "oilwedge-converge/1");
    assert_eq!(study["goal"]["name"], "load");
    let (p1, p2) = (levels(&study, "p1_uniform"), levels(&study, "p2_uniform"));
    assert!(p1.len() >= 2 && p2.len() >= 2 && !levels(&study, "p2_adaptive").is_empty());
    // The load of scene 01; quadratic elements of the first mesh are better than linear ones of the second.
    let value = study["reference"]["value"].as_f64().expect("a value");
    assert!((value / 43_567.9 - 1.0).abs() < 1e-5, "{value}");
    let error = |level: &Value| level["relative_error"].as_f64().expect("an error");
    assert!(error(&p2[0]) < 1e-4 && error(&p2[0]) < 0.1 * error(&p1[1]));
    assert!((error(&p1[0]) / error(&p1[1]) - 4.0).abs() < 0.5);
    let prices = study["prices"].as_array().expect("prices");
    assert!(prices[0]["accuracy"] == 0.01 && prices.last().is_some_and(|price| price["extrapolated"] == true));

    let table = read(&bench, "out/scene/converge.csv");
    let fields: Vec<usize> = table.lines().map(|line| line.split(',').count()).collect();
    let all = ["p1_uniform", "p2_uniform", "p2_adaptive"].map(|strategy| levels(&study, strategy).len());
    assert_eq!(fields, vec![fields[0]; 1 + all.iter().sum::<usize>()]);

    assert!(read(&bench, "out/scene/converge.svg").starts_with("<svg "));
    let png = std::fs::read(bench.path().join("out/scene/converge.png")).expect("converge.png");
    assert!(png.starts_with(b"\x89PNG\r\n\x1a\n"));
    let mut reader = png::Decoder::new(Cursor::new(png)).read_info().expect("a picture");
    let mut dots = vec![0; reader.output_buffer_size().expect("a size")];
    let size = reader.next_frame(&mut dots).expect("dots");
    assert!(size.width > 1000 && size.height > 800);
    let colours: HashSet<&[u8]> = dots.chunks(3).collect();
    assert!(colours.len() > 100, "{} colours", colours.len());
    for strategy in [[213u8, 94, 0], [0, 158, 115]] {
        assert!(colours.contains(&strategy[..]), "{strategy:?} is not drawn");
    }
}

#[test]
fn json_is_one_object_and_that_of_the_reference_page() {
    let bench = Bench::new();
    bench.scene("09_drawn_ring", &[]);
    let told = bench.run(&["converge", "scene.toml", "--max-seconds", "1.5", "--json", "--out", "here"]);
    assert_eq!((told.status, told.stderr.as_str()), (0, ""));
    assert_eq!(told.stdout, read(&bench, "here/converge.json"));
    let page = std::fs::read_to_string(repository().join("docs/reference/converge.md")).expect("the page");
    let example = page.split("```json\n").nth(1).and_then(|rest| rest.split("```").next());
    let found = |value: &Value| {
        let mut found = BTreeSet::new();
        keys(value, "", &mut found);
        found
    };
    assert_eq!(found(&object(&told.stdout)), found(&object(example.expect("an example"))));
    let heading = read(&bench, "here/converge.csv");
    for column in heading.lines().next().unwrap_or_default().split(',') {
        assert!(page.contains(&format!("`{column}`")), "{column} is not explained");
    }
    assert!(levels(&object(&told.stdout), "p2_uniform").len() >= 2);
}

#[test]
fn under_a_load_the_eccentricity_converges() {
    let bench = Bench::new();
    let position = "eccentricity = 0.6\nmin_film_angle = \"180 deg\"\n";
    bench.scene("09_drawn_ring", &[(position, "[load]\nforce = \"5 kN\"\nangle = \"270 deg\"\n")]);
    let told = bench.run(&["converge", "scene.toml", "--max-seconds", "2", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let study = object(&told.stdout);
    assert_eq!((&study["goal"]["name"], &study["goal"]["unit"]), (&"eccentricity".into(), &"1".into()));
    assert!(levels(&study, "p2_uniform").len() >= 2);
}

#[test]
fn all_strategies_take_part_where_oil_is_conserved() {
    let bench = Bench::new();
    bench.scene("14_starved_pad", &[]);
    let told = bench.run(&["converge", "scene.toml", "--max-seconds", "2", "--json"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let study = object(&told.stdout);
    for strategy in ["p1_uniform", "p2_uniform", "p2_adaptive"] {
        assert!(!levels(&study, strategy).is_empty(), "{strategy}");
    }
}

#[test]
fn without_a_film_there_is_a_reason_and_no_picture_of_another_study() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    assert_eq!(bench.run(&["converge", "scene.toml", "--max-seconds", "0.5"]).status, 0);
    bench.scene("02_flexpde_shell", &[("\"10 rad/s\"", "\"100 rad/s\"")]);
    let told = bench.run(&["converge", "scene.toml", "--max-seconds", "0.5", "--json"]);
    assert_eq!(told.status, 1, "{}", told.stderr);
    let study = object(&told.stdout);
    assert_eq!((&study["status"], &study["reference"]), (&"no_solution".into(), &Value::Null));
    assert!(study["reason"].as_str().is_some_and(|reason| reason.contains("lower speed")));
    assert_eq!(names(&bench, "out/scene"), ["converge.json"]);
    let people = bench.run(&["converge", "scene.toml", "--max-seconds", "0.5"]);
    assert!(people.status == 1 && people.stdout.contains("there is no solution"), "{}", people.stdout);
}

#[test]
fn what_cannot_be_studied_is_refused_and_nothing_is_written() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    for (seconds, words) in [("0", "above 0"), ("-3", "-3"), ("nan", "above 0"), ("1e9", "86400"), ("soon", "as 30")] {
        let seconds = format!("--max-seconds={seconds}");
        bench.refuses(&["converge", "scene.toml", &seconds], &["--max-seconds", words]);
    }
    bench.refuses(&["converge"], &["<SCENE>"]);
    bench.refuses(&["converge", "nowhere.toml"], &["nowhere.toml"]);
    bench.refuses(&["converge", "scene.toml", "--unrolled"], &["'--unrolled'"]);
    bench.write("file", "mine");
    bench.refuses(&["converge", "scene.toml", "--max-seconds", "0.2", "--out", "file"], &["file", "--out"]);
    bench.scene("01_plain_ring", &[("eccentricity = 0.6", "eccentricity = 0")]);
    bench.refuses(&["converge", "scene.toml", "--max-seconds", "0.2"], &["load", "is zero", "give an eccentricity"]);
}
