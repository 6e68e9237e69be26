//! A disk that is full. Most machines let nobody mount a small one, so files are kept from growing by a limit of the
//! shell; where a disk of some kilobytes can be mounted it is tried too.

use std::process::{Command, Output};

use oilwedge_tests::bench::Bench;
use oilwedge_tests::program::oilwedge_command;
use oilwedge_tests::two_scenes::{TWO, left_over, names, pair, rows, sweep, two_scenes, whole_pairs};

/// Runs the program from a script of the shell in which `"$@"` is its command line.
fn by_script(bench: &Bench, script: &str, arguments: &[&str]) -> Output {
    Command::new("sh")
        .args(["-c", script, "sh"])
        .arg(oilwedge_command().get_program())
        .args(arguments)
        .current_dir(bench.path())
        .output()
        .expect("a shell")
}

/// A shell that limits files to 4 blocks: a write beyond fails, as on a full disk.
const LIMITED: &str = "trap '' XFSZ; ulimit -f 4; exec \"$@\"";

fn refuses(output: &Output, words: &[&str]) {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(output.stdout.is_empty());
    for word in words {
        assert!(stderr.contains(word), "no {word:?} in\n{stderr}");
    }
    assert!(!stderr.contains("panicked"), "{stderr}");
}

#[test]
fn a_result_that_finds_no_room_leaves_the_earlier_one() {
    let bench = Bench::new();
    two_scenes(&bench);
    whole_pairs(&bench);
    let folder = bench.path().join("whole");
    let before = pair(&folder);
    let solve = ["solve", TWO[0], "--out", "whole"];
    refuses(&by_script(&bench, LIMITED, &solve), &["cannot write", "film.vtu", "too large", "--out"]);
    assert!(pair(&folder) == before);
    assert_eq!(names(&folder), ["film.vtu", "result.json"]);
    // Without a handler the system ends the program there.
    let ended = by_script(&bench, "ulimit -f 4; exec \"$@\"", &solve);
    assert_eq!(ended.status.code(), None);
    assert!(pair(&folder) == before);
    assert_eq!(bench.run(&solve).status, 0);
    assert!(left_over(&folder).is_empty());
}

#[test]
fn meshes_and_studies_find_no_room() {
    let bench = Bench::new();
    two_scenes(&bench);
    bench.write("liner.msh", "earlier");
    refuses(
        &by_script(&bench, LIMITED, &["mesh", TWO[0], "-o", "liner.msh"]),
        &["cannot write", "liner.msh", "too large"],
    );
    let study = ["converge", TWO[0], "--max-seconds", "0.1", "--out", "out"];
    refuses(&by_script(&bench, LIMITED, &study), &["cannot write", "converge.", "too large", "--out"]);
    assert_eq!(std::fs::read(bench.path().join("liner.msh")).expect("a file"), b"earlier");
    assert_eq!(names(bench.path()), [TWO[1], "liner.msh", "out", TWO[0]]);
    assert!(names(&bench.path().join("out")).is_empty());
}

#[test]
fn a_sweep_that_finds_no_room_keeps_its_rows() {
    let bench = Bench::new();
    sweep(&bench, 16);
    let command = ["sweep", "scene.toml", "--bars", "none", "--out"];
    let run = |folder: &str| bench.run(&[&command[..], &[folder]].concat());
    assert_eq!(run("whole").status, 0);
    let whole = rows(&bench.path().join("whole"));
    let arguments = [&command[..], &["out"]].concat();
    refuses(&by_script(&bench, LIMITED, &arguments), &["cannot write", "sweep.csv", "too large", "--out"]);
    let folder = bench.path().join("out");
    let kept = rows(&folder);
    assert!((1..32).contains(&kept.len()), "{} rows", kept.len());
    assert!(kept.iter().all(|(case, row)| whole.get(case) == Some(row)));
    let told = run("out");
    assert_eq!((told.status, rows(&folder)), (0, whole), "{}", told.stderr);
    assert!(told.stdout.contains(&format!("kept      {} cases", kept.len())), "{}", told.stdout);
}

#[test]
fn a_disk_of_some_kilobytes_is_full() {
    let bench = Bench::new();
    two_scenes(&bench);
    std::fs::create_dir(bench.path().join("disk")).expect("a folder");
    let script = "mount -t tmpfs -o size=64k oilwedge disk 2>/dev/null || { echo no disk; exit 0; }
        echo earlier > disk/result.json; \"$@\"; status=$?; ls -A disk; cat disk/result.json; exit $status";
    let inside = format!("exec unshare --mount sh -c '{script}' sh \"$@\"");
    let output = by_script(&bench, &inside, &["solve", TWO[0], "--out", "disk"]);
    let (stdout, stderr) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    if stdout.starts_with("no disk") || stderr.contains("unshare") {
        println!("no disk can be mounted here: {stderr}");
        return;
    }
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert_eq!(stdout, "result.json\nearlier\n");
    for word in ["film.vtu", "No space left", "--out"] {
        assert!(stderr.contains(word), "no {word:?} in\n{stderr}");
    }
}
