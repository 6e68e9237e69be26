//! What `tools/release.sh` makes works without Rust: the program, the Python package, checksums, bill of materials,
//! licences, manual.

use std::fs::read_to_string;
use std::process::Command;

use oilwedge_tests::bench::{Bench, object};
use oilwedge_tests::left_out::{is_left_out, missing_for_venv};
use oilwedge_tests::program::repository;

/// Names in the folder `dist`, the program's archive aside.
const FILES: &str = "ls dist | grep -v -- -$(uname -m)- || true";
/// Installs the wheel where no Rust is on the path, with the numpy of the cross-check.
const INSTALL: &str = "python3 -m venv venv; PATH=$PWD/venv/bin; python -m pip install --quiet --disable-pip-version-check \
    --only-binary :all: --constraint \"$REPOSITORY/tests/crosscheck/requirements.txt\" dist/*.whl";
/// Prints the greatest pressure of a scene by the wheel.
const SOLVE_IN_PYTHON: &str = "env -i PATH=$PWD/venv/bin venv/bin/python -c \
    'import sys, oilwedge; print(repr(oilwedge.solve(sys.argv[1])[\"pressure_max\"].value))' \"$SCENE\"";

#[test]
fn what_is_handed_out_works_without_rust() {
    if is_left_out("the files of a release", &missing_for_venv()) {
        return;
    }
    let bench = Bench::new();
    let own = std::env::current_exe().expect("path of this test");
    let target = own.ancestors().nth(3).expect("target/PROFILE/deps");
    let version = env!("CARGO_PKG_VERSION");
    // What a line for bash prints in the folder; it must succeed.
    let shell = |line: &str| {
        let mut bash = Command::new("bash");
        bash.args(["-euc", line]).current_dir(bench.path());
        bash.env("CARGO_TARGET_DIR", target).env("REPOSITORY", repository()).env_remove("RUSTC_BOOTSTRAP");
        bash.env("SCENE", repository().join("scenes/02_flexpde_shell.toml"));
        let output = bash.output().expect("bash starts");
        let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
        assert!(output.status.success(), "{line}: {stdout}\n{stderr}");
        stdout
    };
    let json = |path: &str| object(&read_to_string(bench.path().join(path)).expect("a file"));

    // Each file has its checksum and is listed with its size.
    let listed = shell("\"$REPOSITORY/tools/release.sh\" --out dist");
    shell("cd dist; sha256sum -c SHA256SUMS; [ $(wc -l <SHA256SUMS) = 4 ]");
    let files = shell(FILES);
    assert!(files.lines().all(|file| listed.contains(file)), "{files}: {listed}");
    for file in [".tar.gz", ".cdx.json", "-cp310-abi3-"] {
        assert!(files.contains(&format!("oilwedge-{version}{file}")), "{file}: {files}");
    }

    // The program runs in an empty environment, and the module in a Python that knows no Rust, to the same number.
    shell("tar -xzf dist/oilwedge-*-$(uname -m)-*.tar.gz; mv oilwedge-* program");
    let libraries = shell("ldd program/oilwedge");
    assert!(libraries.contains("libc.so") && libraries.lines().count() <= 5, "{libraries}");
    shell("env -i program/oilwedge solve \"$SCENE\" --out result");
    let pressure = &json("result/result.json")["quantities"]["pressure_max"]["value"];
    shell(INSTALL);
    let by_python = shell(SOLVE_IN_PYTHON);
    assert_eq!(pressure.as_f64(), by_python.trim().parse().ok(), "{by_python}");

    // What is linked is named, with its licence.
    let bill = json(&format!("dist/oilwedge-{version}.cdx.json"));
    let parts = bill["components"].as_array().expect("components");
    assert!(parts.iter().any(|part| part["name"] == "faer"), "{parts:?}");
    let licences = read_to_string(bench.path().join("program/licences/dependencies.txt")).expect("licences");
    assert!(licences.contains("SIL OPEN FONT LICENSE"), "no font");
    for part in parts.iter().filter(|part| part["hashes"].is_array()) {
        let title = ["name", "version"].map(|key| part[key].as_str().expect("a text")).join(" ");
        assert!(licences.contains(&format!("{title}: ")), "{title} has no licence");
    }

    shell("bash -n program/completions/oilwedge.bash; [ -s program/completions/oilwedge.fish ]");
    if Command::new("man").arg("--version").output().is_ok() {
        let page = shell("man -l program/man/man1/oilwedge-solve.1");
        assert!(page.contains("SYNOPSIS") && page.contains("--report"), "{page}");
    }
}

#[test]
fn what_is_missing_is_named_with_what_installs_it() {
    let bench = Bench::new();
    let script = repository().join("tools/release.sh");
    let run = |arguments: &[&str], path: &str| {
        let mut command = Command::new("/bin/bash");
        command.arg(&script).args(arguments).env_clear().env("PATH", path);
        let output = command.current_dir(bench.path()).output().expect("bash starts");
        let text = [output.stdout, output.stderr].concat();
        (output.status.code(), String::from_utf8(text).expect("UTF-8"))
    };
    let (status, help) = run(&["--help"], "/usr/bin:/bin");
    assert!(status == Some(0) && help.contains("SHA256SUMS"), "{help}");
    let (status, told) = run(&["--fast"], "/usr/bin:/bin");
    assert!(status == Some(2) && told.contains("--fast"), "{told}");
    // A path with the tools of the shell alone.
    for tool in ["dirname", "uname"] {
        let tools = ["/usr/bin", "/bin"].map(|folder| std::path::Path::new(folder).join(tool));
        let found = tools.iter().find(|path| path.exists()).expect("a tool of the system");
        std::os::unix::fs::symlink(found, bench.path().join(tool)).expect("a link");
    }
    let (status, told) = run(&["--out", "dist"], &bench.path().to_string_lossy());
    assert!(status == Some(2) && told.contains("cargo is missing: install Rust"), "{told}");
    assert!(!bench.path().join("dist").exists(), "{told}");
}
