//! A table survives its writer, and threads change no row.

use std::process::Stdio;
use std::time::{Duration, Instant};

use oilwedge_tests::bench::Bench;
use oilwedge_tests::program::oilwedge_command;
use oilwedge_tests::sweeps::*;

#[test]
fn any_number_of_threads_gives_the_same_rows() {
    let bench = Bench::new();
    loaded(&bench, 9);
    let run = |threads: &str, folder: &str, bars: &str| {
        let told = bench.run(&["sweep", "scene.toml", "--json", "--threads", threads, "--out", folder, "--bars", bars]);
        done(&told);
        timeless(&table(&bench, folder))
    };
    for bars in ["none", "auto"] {
        let one = run("1", &format!("one_{bars}"), bars);
        assert_eq!(one.len(), 19);
        assert_eq!(one, run("2", &format!("two_{bars}"), bars));
        assert_eq!(one, run("5", &format!("five_{bars}"), bars));
    }
}

#[test]
fn a_table_that_was_cut_off_anywhere_is_completed() {
    let bench = Bench::new();
    loaded(&bench, 9);
    let again = || bench.run(&["sweep", "scene.toml", "--json", "--bars", "none"]);
    done(&again());
    let (whole, folder) = (table(&bench, "out/scene"), bench.path().join("out/scene"));
    let about = std::fs::read_to_string(folder.join("sweep.json")).expect("a report");
    let begun = about.replacen("\"complete\": true", "\"complete\": false", 1);
    let line = whole.lines().next().expect("headings").len() + 1;
    for cut in [0, 5, line - 1, line, line + 1, whole.len() / 2, whole.len() * 2 / 3, whole.len() - 1, whole.len()] {
        std::fs::write(folder.join("sweep.csv"), &whole.as_bytes()[..cut]).expect("a table");
        std::fs::write(folder.join("sweep.json"), &begun).expect("a report");
        done(&again());
        assert_eq!(timeless(&table(&bench, "out/scene")), timeless(&whole), "cut at {cut}");
        assert!(std::fs::read_to_string(folder.join("sweep.json")).expect("a report").contains("\"complete\": true"));
    }
    // Rows that stand there are believed: one that is marked stays.
    let marked = whole.replacen(",converged,", ",marked,", 1);
    std::fs::write(folder.join("sweep.csv"), &marked).expect("a table");
    again();
    assert_eq!(table(&bench, "out/scene"), marked);
}

#[test]
fn another_sweep_in_the_folder_is_left_alone() {
    let bench = Bench::new();
    sweep(&bench, "eccentricity = [0.3, 0.4]", &[]);
    done(&bench.run(&["sweep", "scene.toml", "--json"]));
    bench.refuses(&["sweep", "scene.toml", "--bars", "none"], &["holds a sweep with error bars", "--out", "--fresh"]);
    sweep(&bench, "eccentricity = [0.3, 0.5]", &[]);
    bench.refuses(&["sweep", "scene.toml"], &["of another scene, or of this one before it was changed"]);
    done(&bench.run(&["sweep", "scene.toml", "--json", "--fresh"]));
    std::fs::remove_file(bench.path().join("out/scene/sweep.json")).expect("a report");
    bench.refuses(&["sweep", "scene.toml"], &["without the record of what it was computed from"]);
}

#[test]
fn a_sweep_that_is_killed_goes_on_where_it_was() {
    let bench = Bench::new();
    loaded(&bench, 60);
    let arguments = ["sweep", "scene.toml", "--json", "--bars", "none", "--threads", "2"];
    let rows = |folder: &str| {
        let text = std::fs::read_to_string(bench.path().join(folder).join("sweep.csv"));
        text.map_or(0, |text| text.lines().count().saturating_sub(1))
    };
    let mut killed = oilwedge_command()
        .args(arguments)
        .current_dir(bench.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let deadline = Instant::now() + Duration::from_secs(120);
    while rows("out/scene") < 30 && Instant::now() < deadline {
        std::thread::sleep(Duration::from_millis(2));
    }
    killed.kill().expect("it can be killed");
    killed.wait().expect("it ends");
    let left = rows("out/scene");
    assert!((30..120).contains(&left), "{left} rows when it was killed");
    done(&bench.run(&arguments));
    let resumed = timeless(&table(&bench, "out/scene"));
    done(&bench.run(&[&arguments[..], &["--out", "whole"]].concat()));
    assert_eq!(resumed, timeless(&table(&bench, "whole")));
}
