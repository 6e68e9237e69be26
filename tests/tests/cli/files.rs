//! Where results go, and that they are written whole or not at all.

use oilwedge_tests::bench::{Bench, object};

#[test]
fn results_of_an_earlier_run_are_replaced_whole() {
    let bench = Bench::new();
    let solve = ["solve", "scene.toml", "--out", "here"];
    bench.scene("02_flexpde_shell", &[]);
    assert_eq!(bench.run(&solve).status, 0);
    bench.write("here/notes.txt", "mine");
    let result = || object(&std::fs::read_to_string(bench.path().join("here/result.json")).expect("result.json"));
    let picture = || std::fs::read(bench.path().join("here/film.vtu")).ok();
    let (first, first_picture) = (result(), picture().expect("film.vtu"));

    bench.scene("02_flexpde_shell", &[("\"10 rad/s\"", "\"5 rad/s\"")]);
    assert_eq!(bench.run(&solve).status, 0);
    assert_ne!(result()["scene_sha256"], first["scene_sha256"]);
    assert_ne!(result()["quantities"]["load"], first["quantities"]["load"]);
    assert!(picture().is_some_and(|picture| picture != first_picture));

    // No film: the picture of another run does not stay beside its result.
    bench.scene("02_flexpde_shell", &[("\"10 rad/s\"", "\"100 rad/s\"")]);
    assert_eq!(bench.run(&solve).status, 1);
    assert_eq!(result()["status"], "no_solution");
    assert!(picture().is_none());
    let left: Vec<_> = bench.files().into_keys().collect();
    let expected = ["here/", "here/notes.txt", "here/result.json", "scene.toml"];
    assert_eq!(left, expected.map(|name| bench.path().join(name)));
}

#[test]
fn the_fields_are_compressed_as_wanted() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let written = |options: &[&str]| {
        assert_eq!(bench.run(&[&["solve", "scene.toml", "--out", "here"], options].concat()).status, 0);
        std::fs::read(bench.path().join("here/film.vtu")).expect("film.vtu")
    };
    let plain = written(&[]);
    assert_eq!(plain, written(&["--vtu", "none"]));
    let has = |file: &[u8], name: &str| String::from_utf8_lossy(file).contains(name);
    let (lz4, zlib) = (written(&["--vtu", "lz4"]), written(&["--vtu", "zlib"]));
    assert!(!has(&plain, "compressor") && has(&lz4, "vtkLZ4DataCompressor") && has(&zlib, "vtkZLibDataCompressor"));
    assert!(zlib.len() < lz4.len() && lz4.len() < plain.len());
    bench.refuses(&["solve", "scene.toml", "--vtu", "gzip"], &["gzip", "none, lz4, zlib"]);
}

#[test]
fn a_folder_that_cannot_be_written_leaves_everything_as_it_was() {
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    bench.write("file", "mine");
    let out = |folder: &str| bench.refuses(&["solve", "scene.toml", "--json", "--out", folder], &[folder, "--out"]);
    out("file");
    out("file/below");
    std::fs::create_dir_all(bench.path().join("taken/result.json")).expect("a folder");
    let told = out("taken");
    assert!(told.stderr.contains("a folder stands there"), "{}", told.stderr);
    std::fs::create_dir_all(bench.path().join("drawn/film.vtu")).expect("a folder");
    out("drawn");
    if cfg!(target_os = "linux") {
        out("/proc/oilwedge");
    }
}

#[cfg(unix)]
#[test]
fn a_read_only_folder_is_refused() {
    use std::os::unix::fs::PermissionsExt;
    let bench = Bench::new();
    bench.scene("01_plain_ring", &[]);
    let folder = bench.path().join("read_only");
    std::fs::create_dir(&folder).expect("a folder");
    let permit = |mode: u32| std::fs::set_permissions(&folder, std::fs::Permissions::from_mode(mode)).expect("chmod");
    permit(0o555);
    // The superuser may write there all the same.
    if std::fs::write(folder.join("probe"), "").is_err() {
        bench.refuses(&["solve", "scene.toml", "--out", "read_only"], &["read_only", "ermission denied", "--out"]);
    }
    permit(0o755);
}

#[test]
fn check_writes_nothing() {
    let bench = Bench::new();
    bench.scene("07_grooved_liner", &[]);
    let mesh = oilwedge_tests::program::repository().join("meshes/grooved_liner.msh");
    let mesh = mesh.display().to_string();
    let before = bench.files();
    for file in ["scene.toml", &mesh] {
        let people = bench.run(&["check", file]);
        assert_eq!(people.status, 0, "{}", people.stderr);
        for part in ["can be used", "groove", "116 edges", "3286 triangles", "closed curves"] {
            assert!(people.stdout.contains(part), "no {part:?} in\n{}", people.stdout);
        }
        let found = object(&bench.run(&["check", file, "--json"]).stdout);
        assert_eq!(found["format"], "oilwedge-check/1");
        assert_eq!(found["mesh"]["cells"], 3286);
        assert_eq!(found["quality"]["boundary_loops"], 5);
        assert_eq!(found["effects"].is_object(), file == "scene.toml");
    }
    assert!(bench.files() == before);
}
