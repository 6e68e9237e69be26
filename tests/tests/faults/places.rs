//! Folders that cannot be written, are none, or go away. What the superuser may not write either is in `cli/files.rs`.

use std::fs::OpenOptions;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::process::{Command, Output};

use oilwedge_tests::bench::{Bench, edited};
use oilwedge_tests::program::oilwedge_command;
use oilwedge_tests::two_scenes::{TWO, names, pair, rows, send, start, sweep, two_scenes, until, whole_pairs};

/// Runs the program as a user who is not the superuser; none where that cannot be done.
fn as_nobody(bench: &Bench, arguments: &[&str]) -> Option<Output> {
    let program = oilwedge_command().get_program().to_owned();
    let run = |arguments: &[&str]| {
        let mut command = Command::new("setpriv");
        command.args(["--reuid=65534", "--regid=65534", "--clear-groups"]);
        command.arg(&program).args(arguments).current_dir(bench.path());
        command.output().ok()
    };
    run(&["--version"]).filter(|output| output.status.success())?;
    run(arguments)
}

fn refuses(output: &Output, words: &[&str]) {
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    for word in words {
        assert!(stderr.contains(word), "no {word:?} in\n{stderr}");
    }
    assert!(output.stdout.is_empty() && !stderr.contains("panicked"), "{stderr}");
}

#[test]
fn a_folder_that_may_only_be_read_is_refused() {
    let bench = Bench::new();
    two_scenes(&bench);
    let whole = whole_pairs(&bench);
    sweep(&bench, 4);
    let permit = |path: &str, mode: u32| {
        let permissions = std::fs::Permissions::from_mode(mode);
        std::fs::set_permissions(bench.path().join(path), permissions).expect("chmod");
    };
    permit("", 0o755);
    permit("whole", 0o555);
    let words = ["cannot write", "whole", "ermission denied"];
    let runs: [&[&str]; 5] = [
        &["solve", TWO[0], "--out", "whole"],
        &["solve", TWO[0], "--out", "whole/below"],
        &["sweep", "scene.toml", "--out", "whole"],
        &["converge", TWO[0], "--max-seconds", "0.1", "--out", "whole"],
        &["mesh", TWO[0], "-o", "whole/liner.msh"],
    ];
    for arguments in runs {
        let Some(output) = as_nobody(&bench, arguments) else {
            println!("no other user can be had here");
            break;
        };
        refuses(&output, &words);
    }
    permit("whole", 0o755);
    let (scene, picture) = pair(&bench.path().join("whole")).expect("the earlier result");
    assert!(whole.get(&scene) == Some(&picture));
    assert_eq!(names(&bench.path().join("whole")), ["film.vtu", "result.json"]);
}

#[test]
fn links_and_files_in_the_place_of_the_folder_are_refused() {
    let bench = Bench::new();
    two_scenes(&bench);
    sweep(&bench, 4);
    bench.write("file", "mine");
    symlink("nowhere", bench.path().join("link")).expect("a link");
    for place in ["file", "link"] {
        for command in [
            &["solve", TWO[0], "--out", place][..],
            &["sweep", "scene.toml", "--out", place],
            &["converge", TWO[0], "--max-seconds", "0.1", "--out", place],
        ] {
            bench.refuses(command, &["cannot write", place, "not a directory", "--out"]);
        }
        bench.refuses(&["mesh", TWO[0], "-o", &format!("{place}/liner.msh")], &["cannot write", place]);
    }
    bench.refuses(&["mesh", TWO[0], "-o", "none/liner.msh"], &["cannot write none/liner.msh", "check the path"]);
}

#[test]
fn links_in_the_place_of_files_are_replaced_or_followed() {
    let bench = Bench::new();
    two_scenes(&bench);
    let whole = whole_pairs(&bench);
    let place = |name: &str| bench.path().join(name);
    std::fs::create_dir(place("out")).expect("a folder");
    symlink("/dev/full", place("out/result.json")).expect("a link");
    symlink("nowhere", place("out/film.vtu")).expect("a link");
    let told = bench.run(&["solve", TWO[0], "--out", "out"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let (scene, picture) = pair(&place("out")).expect("a result");
    assert!(whole.get(&scene) == Some(&picture));
    // A mesh goes where its path leads, whatever is there.
    bench.write("target.msh", "earlier");
    symlink("target.msh", place("link.msh")).expect("a link");
    assert_eq!(bench.run(&["mesh", TWO[0], "-o", "link.msh"]).status, 0);
    assert!(place("link.msh").is_symlink());
    let mesh = std::fs::read_to_string(place("target.msh")).expect("a mesh");
    assert!(mesh.ends_with("$EndPeriodic\n"), "the mesh is not whole");
    let told = bench.run(&["mesh", TWO[0], "-o", "/dev/stdout"]);
    assert!(told.stdout.starts_with(&mesh), "{}", told.stderr);
    bench.refuses(&["mesh", TWO[0], "-o", "/dev/full"], &["cannot write /dev/full", "No space left"]);
}

/// Results in the folder are whole though stdout is full: status 1, and stderr says both. What writes no files ends
/// with 2.
#[test]
fn stdout_may_be_full() {
    let bench = Bench::new();
    two_scenes(&bench);
    sweep(&bench, 2);
    for (arguments, status, file) in [
        (&["solve", TWO[0], "--json", "--out", "solved"][..], 1, "solved/result.json"),
        (&["solve", TWO[0], "--out", "told"], 1, "told/result.json"),
        (&["sweep", "scene.toml", "--json", "--out", "swept"], 1, "swept/sweep.csv"),
        (&["converge", TWO[0], "--max-seconds", "0.1", "--out", "study"], 1, "study/converge.csv"),
        (&["mesh", TWO[0], "-o", "liner.msh"], 1, "liner.msh"),
        (&["check", TWO[0], "--json"], 2, ""),
        (&["oil"], 2, ""),
    ] {
        let full = OpenOptions::new().write(true).open("/dev/full").expect("a device");
        let mut command = oilwedge_command();
        command.args(arguments).current_dir(bench.path()).stdout(full);
        let output = command.output().expect("it runs");
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {stderr}");
        assert!(stderr.contains("standard output"), "{stderr}");
        assert_eq!(stderr.contains("were written to"), status == 1, "{stderr}");
        assert!(bench.path().join(file).exists(), "{file}");
    }
}

/// Where nobody can read complaints and warnings, a run ends as it would.
#[test]
fn stderr_may_be_full() {
    let bench = Bench::new();
    two_scenes(&bench);
    bench.write("bad.toml", "nonsense = 1");
    let status = |arguments: &[&str]| {
        let full = OpenOptions::new().write(true).open("/dev/full").expect("a device");
        let mut command = oilwedge_command();
        command.args(arguments).current_dir(bench.path()).stderr(full);
        command.output().expect("it runs").status.code()
    };
    // Scene 01 is warned about.
    bench.write("warned.toml", edited("01_plain_ring", &[]));
    assert_eq!(status(&["solve", "warned.toml"]), Some(0));
    for verb in ["solve", "check", "sweep", "converge"] {
        assert_eq!(status(&[verb, "bad.toml"]), Some(2), "{verb}");
    }
}

#[test]
fn a_mesh_does_not_take_the_place_of_its_scene() {
    let bench = Bench::new();
    two_scenes(&bench);
    bench.refuses(&["mesh", TWO[0], "-o", TWO[0]], &["--output", "from which the mesh is made"]);
}

#[test]
fn a_folder_that_goes_away_comes_again() {
    let bench = Bench::new();
    sweep(&bench, 30);
    let run = start(&bench, &["sweep", "scene.toml", "--out", "out"]);
    let folder = bench.path().join("out");
    until(|| rows(&folder).len() > 1);
    send("-STOP", &run);
    std::fs::remove_dir_all(&folder).expect("a folder");
    send("-CONT", &run);
    let output = run.wait_with_output().expect("it ends");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(rows(&folder).len(), 60);
    assert_eq!(names(&folder), ["sweep.csv", "sweep.json"]);
    // The working folder itself.
    bench.write("alone.toml", edited("01_plain_ring", &[]));
    let scene = bench.path().join("alone.toml").display().to_string();
    let away = tempfile::tempdir().expect("a folder");
    let script = format!("rmdir \"$PWD\"; exec \"$@\" solve {scene} --json");
    let output = Command::new("sh")
        .args(["-c", &script, "sh"])
        .arg(oilwedge_command().get_program())
        .current_dir(away.path())
        .output()
        .expect("a shell");
    refuses(&output, &["cannot write", "--out"]);
}
