//! Parts of a sweep: computed by runs that know nothing of each other, joined to the table of the sweep by itself.

use std::path::PathBuf;
use std::process::{Child, Stdio};

use oilwedge_tests::program::oilwedge_command;
use oilwedge_tests::sweeps::*;

/// Starts part `number` of `of` of the sweep in `scene.toml`, into `map`.
fn start(bench: &Bench, number: usize, of: usize, bars: &str) -> Child {
    let part = format!("{number}/{of}");
    oilwedge_command()
        .args(["sweep", "scene.toml", "--out", "map", "--threads", "1"])
        .args(["--part", &part, "--bars", bars])
        .current_dir(bench.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

/// Computes all parts at once, the last one first; what each says on stderr, by its number.
fn compute(bench: &Bench, of: usize, bars: &str) -> Vec<String> {
    let runs: Vec<Child> = (1..=of).rev().map(|number| start(bench, number, of, bars)).collect();
    let mut told: Vec<String> = runs
        .into_iter()
        .map(|run| {
            let output = run.wait_with_output().expect("it ends");
            let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
            assert!(output.status.success(), "{stderr}");
            stderr
        })
        .collect();
    told.reverse();
    told
}

fn file(bench: &Bench, name: &str) -> PathBuf {
    bench.path().join("map").join(name)
}

fn read(bench: &Bench, name: &str) -> String {
    std::fs::read_to_string(bench.path().join(name)).expect("a file")
}

/// The lines of a `sweep.json` but those of the seconds.
fn about(bench: &Bench, folder: &str) -> Vec<String> {
    let text = read(bench, &format!("{folder}/sweep.json"));
    let lines = text.lines().filter(|line| !line.contains("\"seconds\""));
    lines.map(str::to_owned).collect()
}

#[test]
fn parts_joined_are_the_sweep_by_itself() {
    let bench = Bench::new();
    // Six chains: one a part, several a part, and more parts than chains.
    loaded(&bench, 9);
    for (of, bars) in [(1, "none"), (6, "auto"), (4, "none"), (8, "none")] {
        done(&bench.run(&["sweep", "scene.toml", "--json", "--bars", bars, "--out", "whole", "--fresh"]));
        let told = compute(&bench, of, bars);
        let empty = |text: &&String| text.contains("has no case") && text.contains("6 chains");
        assert_eq!(told.iter().filter(empty).count(), of.saturating_sub(6), "{told:?}");
        done(&bench.run(&["sweep", "scene.toml", "--join", "map", "--json", "--bars", bars]));
        assert_eq!(timeless(&table(&bench, "map")), timeless(&table(&bench, "whole")), "{of} parts");
        assert_eq!(about(&bench, "map"), about(&bench, "whole"), "{of} parts");
        // The seconds are those of the runs that computed the rows.
        let row = read(&bench, &format!("map/parts/{of:03}-of-{of:03}/sweep.csv"));
        let row = row.lines().nth(1).filter(|_| of <= 6);
        assert!(row.is_none_or(|row| table(&bench, "map").contains(row)));
        std::fs::remove_dir_all(bench.path().join("map")).expect("removed");
    }
}

#[test]
fn a_part_is_computed_once_and_goes_on_after_a_kill() {
    let bench = Bench::new();
    loaded(&bench, 9);
    let part = |number: &str| bench.run(&["sweep", "scene.toml", "--bars", "none", "--out", "map", "--part", number]);
    for number in ["1/2", "2/2"] {
        let told = part(number);
        assert_eq!(told.status, 0, "{}", told.stderr);
        assert!(told.stdout.contains(&format!("part {number}, 9 cases")), "{}", told.stdout);
    }
    let again = part("2/2");
    assert!(again.stdout.contains("nothing was left to compute"), "{}", again.stdout);
    // As a kill leaves it: a row half written, and the report of a sweep that has not ended.
    let folder = file(&bench, "parts/002-of-002");
    let whole = read(&bench, "map/parts/002-of-002/sweep.csv");
    let report = read(&bench, "map/parts/002-of-002/sweep.json");
    std::fs::write(folder.join("sweep.csv"), &whole.as_bytes()[..whole.len() * 2 / 3]).expect("a table");
    let begun = report.replacen("\"complete\": true", "\"complete\": false", 1);
    std::fs::write(folder.join("sweep.json"), begun).expect("a report");
    let join = ["sweep", "scene.toml", "--bars", "none", "--join", "map"];
    bench.refuses(&join, &["of its 2 parts 2 has not ended", "--part 2/2 --out map"]);
    assert!(part("2/2").stdout.contains("kept"), "no row was kept");
    assert_eq!(timeless(&read(&bench, "map/parts/002-of-002/sweep.csv")), timeless(&whole));
    let told = bench.run(&join);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let words = " a case, added up over all parts";
    assert!(told.stdout.contains(words) && !told.stdout.contains("kept"), "{}", told.stdout);
    let told = bench.run(&["sweep", "scene.toml", "--bars", "none", "--out", "map"]);
    assert!(told.stdout.contains("kept      18 cases"), "{}", told.stdout);
}

#[test]
fn a_join_writes_the_table_for_rotors_and_parts_do_not() {
    let bench = Bench::new();
    let speeds = "[sweep]\nspeed = { from = \"2000 rpm\", to = \"6000 rpm\", steps = 5 }\n";
    let text = edited("25_whirl", &[]);
    let own = text.find("[sweep]").expect("a sweep");
    bench.write("scene.toml", text[..own].to_owned() + speeds);
    done(&bench.run(&["sweep", "scene.toml", "--json", "--bars", "none", "--out", "whole"]));
    compute(&bench, 2, "none");
    assert!(!file(&bench, "parts/001-of-002/rotor_bearing.csv").exists());
    let told = bench.run(&["sweep", "scene.toml", "--bars", "none", "--join", "map", "--out", "joined", "--report"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    assert_eq!(read(&bench, "joined/rotor_bearing.csv"), read(&bench, "whole/rotor_bearing.csv"));
    assert!(bench.path().join("joined/sweep.html").is_file());
    assert!(!file(&bench, "sweep.csv").exists());
}

/// Joins the parts in `map`.
const JOIN: [&str; 6] = ["sweep", "scene.toml", "--bars", "none", "--join", "map"];

/// The sweep in all of its six chains.
fn six_parts() -> Bench {
    let bench = Bench::new();
    loaded(&bench, 9);
    compute(&bench, 6, "none");
    bench
}

#[test]
fn a_join_refuses_gaps() {
    let bench = Bench::new();
    loaded(&bench, 9);
    bench.refuses(&JOIN, &["holds no parts", "--part 1/N", "--out map"]);
    std::fs::create_dir(bench.path().join("map")).expect("a folder");
    bench.write("map/parts", "no folder");
    bench.refuses(&JOIN, &["cannot read", "parts"]);
    std::fs::remove_file(file(&bench, "parts")).expect("removed");
    for number in [2, 3, 6] {
        let run = start(&bench, number, 6, "none").wait_with_output().expect("it ends");
        assert!(run.status.success());
    }
    bench.refuses(&JOIN, &["of its 6 parts 1, 4-5 are missing", "--part 1/6 --out map"]);
}

#[test]
fn a_join_refuses_parts_of_other_sweeps() {
    let bench = six_parts();
    // Other bars.
    bench.refuses(&["sweep", "scene.toml", "--join", "map"], &["001-of-006", "without error bars", "--bars"]);
    // Another scene.
    let text = read(&bench, "scene.toml");
    bench.write("scene.toml", format!("# Later.\n{text}"));
    bench.refuses(&JOIN, &["another scene, or of this one before it was changed", "--part 1/6 --out map --fresh"]);
    bench.write("scene.toml", text);
    // Another program.
    let about = read(&bench, "map/parts/003-of-006/sweep.json");
    let path = "map/parts/003-of-006/sweep.json";
    bench.write(path, about.replacen("\"version\": \"", "\"version\": \"0.", 1));
    bench.refuses(&JOIN, &["003-of-006", "another version of the program", "--part 3/6"]);
    bench.write(path, &about);
    // Another sweep in the place of the table.
    bench.write("map/sweep.csv", "case\n1\n");
    bench.refuses(&JOIN, &["without the record", "--fresh"]);
    let told = bench.run(&[&JOIN[..], &["--fresh"]].concat());
    assert_eq!(told.status, 0, "{}", told.stderr);
}

/// The table of the load is part of what is computed.
#[test]
fn a_sweep_under_another_table_of_loads_is_another_one() {
    let bench = Bench::new();
    let load = |peak: f64| {
        let row = |angle: u32, force: f64| format!("{angle},{force},{}\n", 0.5 * force);
        let angles = (0..=720).step_by(90);
        let rows: String = angles.map(|angle| row(angle, if angle % 720 == 360 { peak } else { 1000.0 })).collect();
        bench.write("load.csv", format!("angle [deg],Fx [N],Fy [N]\n{rows}"));
    };
    load(2000.0);
    let scene = "title = \"cycle\"\nbearing = { diameter = \"40 mm\", length = \"16 mm\", clearance = \"20 um\" }\nmesh = { size = \"5 mm\" }\n\
        oil = { viscosity = \"10 mPa.s\" }\njournal = { speed = \"200 rad/s\" }\ncavitation = { model = \"reynolds\" }\n\
        load = { file = \"load.csv\", frame = \"shell\", period = \"720 deg\" }\norbit = { tolerance = 0.1, cycles = 2 }\n\
        [sweep]\nclearance = [\"20 um\", \"25 um\"]\n";
    bench.write("scene.toml", scene);
    let again = ["sweep", "scene.toml", "--bars", "none", "--out", "map"];
    let told = bench.run(&again);
    assert!(told.stdout.contains(" a case\n"), "{}{}", told.stdout, told.stderr);
    let told = bench.run(&again);
    assert!(told.stdout.contains("nothing was left to compute"), "{}", told.stdout);
    load(3000.0);
    bench.refuses(&again, &["map holds a sweep of another table of loads or gas pressures", "--fresh"]);
}

#[test]
fn a_join_refuses_doubles() {
    let bench = six_parts();
    // A row that stands there twice, one that does not, and one of another part.
    let path = "map/parts/002-of-006/sweep.csv";
    let rows = read(&bench, path);
    let last = rows.lines().last().expect("a row");
    let first = rows.lines().nth(1).expect("a row");
    let foreign = read(&bench, "map/parts/003-of-006/sweep.csv");
    let foreign = foreign.lines().nth(1).expect("a row");
    for (wrong, case) in [
        (format!("{rows}{last}\n"), "case 7 "),
        (rows.replacen(&format!("{first}\n"), "", 1), "case 4 "),
        (rows.replacen(first, foreign, 1), "case 4 "),
        (rows.replacen(&format!("{last}\n"), "", 1), "case 6 "),
        (format!("{rows}x{}\n", &last[1..]), "case 7 "),
    ] {
        bench.write(path, wrong);
        bench.refuses(&JOIN, &["002-of-006", case, "--part 2/6 --out map --fresh"]);
    }
    bench.write(path, &rows);
    // A part under the name of another one, a copy, and another division.
    let parts = file(&bench, "parts");
    std::fs::rename(parts.join("004-of-006"), parts.join("away")).expect("renamed");
    bench.refuses(&JOIN, &["away is not the folder of a part", "move it away"]);
    std::fs::rename(parts.join("away"), file(&bench, "away")).expect("renamed");
    std::fs::rename(parts.join("005-of-006"), parts.join("004-of-006")).expect("renamed");
    bench.refuses(&JOIN, &["004-of-006", "another part"]);
    std::fs::rename(parts.join("004-of-006"), parts.join("005-of-006")).expect("renamed");
    std::fs::rename(file(&bench, "away"), parts.join("004-of-006")).expect("renamed");
    start(&bench, 1, 3, "none").wait_with_output().expect("it ends");
    bench.refuses(&JOIN, &["holds parts of 3 and of 6", "move those of one division away"]);
}

#[test]
fn bad_parts_are_refused() {
    let bench = Bench::new();
    loaded(&bench, 9);
    for part in ["0/4", "5/4", "a/b", "3", "3/4/5", "-1/4", "1/0", "", "1.5/4", "1/1000001", "1/99999999999"] {
        let flag = format!("--part={part}");
        bench.refuses(&["sweep", "scene.toml", &flag], &["--part", "3/40", "1 <= K <= N"]);
    }
    for (flags, word) in [
        (&["--part", "1/2", "--join", "map"][..], "--join"),
        (&["--part", "1/2", "--plot"], "--plot"),
        (&["--part", "1/2", "--report"], "--report"),
        (&["--part", "1/2", "--open"], "--open"),
        (&["--join", "map", "--max-seconds", "3"], "--max-seconds"),
        (&["--join", "map", "--max-unknowns", "300"], "--max-unknowns"),
    ] {
        bench.refuses(&[&["sweep", "scene.toml"], flags].concat(), &["cannot be used with", word]);
    }
}
