//! `oilwedge verify`.

use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use oilwedge_tests::program::{oilwedge, oilwedge_command};

#[test]
fn known_values_are_met() {
    let output = oilwedge(Path::new("."), &["verify"]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("all as expected") && text.contains("known sommerfeld_number"), "{text}");
}

#[test]
fn what_cannot_be_followed_is_refused() {
    let told = |arguments: &[&str]| {
        let output = oilwedge(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(output.stdout.is_empty());
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let family = told(&["verify", "--family", "moon"]);
    assert!(family.contains("moon") && family.contains("slenderness"), "{family}");
    assert!(told(&["verify", "--out", "x"]).contains("--hard"));
}

/// The page grows while the suite runs, and is whole when the run is killed: it says how far it got.
#[test]
fn the_page_is_written_as_cases_end() {
    let folder = tempfile::tempdir().expect("a folder");
    let page = folder.path().join("page/stability.md");
    let mut child = oilwedge_command()
        .current_dir(folder.path())
        .args(["verify", "--hard", "--out", "page"])
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program");
    let clock = Instant::now();
    let has_cases = || {
        std::fs::read_to_string(&page).is_ok_and(|text| text.lines().filter(|line| line.starts_with("| ")).count() > 1)
    };
    while !has_cases() && clock.elapsed() < Duration::from_secs(120) {
        std::thread::sleep(Duration::from_millis(50));
    }
    child.kill().expect("it runs");
    let told = child.wait_with_output().expect("it ended");
    let text = std::fs::read_to_string(&page).expect("a page");
    let (_, rest) = text.split_once("**Incomplete: ").expect("a note");
    let (done, rest) = rest.split_once(" of ").expect("a number");
    let (cases, _) = rest.split_once(" cases.**").expect("all");
    let [done, cases]: [usize; 2] = [done, cases].map(|number| number.parse().expect("a number"));
    let rows = text.lines().filter(|line| line.starts_with("| ") && !line.starts_with("| case |")).count();
    assert!(done > 0 && done < cases && rows == done && text.ends_with("|\n"), "{text}");
    let stderr = String::from_utf8_lossy(&told.stderr).into_owned();
    assert!(stderr.contains(&format!(" of {cases} cases, ")), "{stderr}");
}
