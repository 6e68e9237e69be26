//! Blocks are run in the order of their page.

use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};

use oilwedge_full::book::blocks::{Block, How, blocks};
use oilwedge_full::book::{Page, pages};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::left_out::{is_left_out, missing_for_python};
use oilwedge_tests::program::{oilwedge_command, repository};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use oilwedge_tests::python_environment::python;

/// A folder as a reader has it: the shipped scenes and meshes, and the program on PATH. A browser is not opened, and
/// `cargo run --release --` is the program that is built.
struct Desk {
    bench: Bench,
}

impl Desk {
    fn new() -> Self {
        let bench = Bench::new();
        for folder in ["scenes", "scenes/loads", "scenes/engines", "scenes/engines/bearings", "meshes", "bin", "home"] {
            std::fs::create_dir_all(bench.path().join(folder)).expect("a folder");
            let Ok(entries) = std::fs::read_dir(repository().join(folder)) else {
                continue;
            };
            for path in entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_file()) {
                let name = path.file_name().expect("a name");
                std::fs::copy(&path, bench.path().join(folder).join(name)).expect("a copy");
            }
        }
        let program = oilwedge_command().get_program().to_owned();
        let program = program.to_string_lossy();
        // A difference is the status 1 of `diff`, and no failure.
        let run = format!("'{program}' \"$@\" || [ $? = 1 -a \"$1\" = diff ]");
        let cargo = "[ \"$1 $2 $3\" = 'run --release --' ] || exit 9; shift 3; oilwedge \"$@\"".to_owned();
        for (name, text) in [("oilwedge", run), ("cargo", cargo), ("xdg-open", String::new()), ("open", String::new())]
        {
            let path = bench.path().join("bin").join(name);
            bench.write(&format!("bin/{name}"), format!("#!/bin/sh\n{text}\n"));
            let mode = std::os::unix::fs::PermissionsExt::from_mode(0o755);
            std::fs::set_permissions(path, mode).expect("a program");
        }
        Self { bench }
    }

    /// A command that runs there.
    fn command(&self, program: impl AsRef<std::ffi::OsStr>) -> Command {
        let mut command = Command::new(program);
        let path = std::env::var("PATH").unwrap_or_default();
        command
            .env("PATH", format!("{}:{path}", self.bench.path().join("bin").display()))
            .env("HOME", self.bench.path().join("home"))
            .env("PYVISTA_OFF_SCREEN", "true")
            .env("PYTHONDONTWRITEBYTECODE", "1")
            .current_dir(self.bench.path());
        command
    }

    /// Writes a scene to a file and checks it.
    fn scene(&self, name: &str, text: &str) -> Ran {
        self.bench.write(name, text);
        self.shell(&format!("oilwedge check {name}"))
    }

    fn shell(&self, text: &str) -> Ran {
        let output = self.command("sh").args(["-e", "-u", "-c", text]).output().expect("a shell");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        Ran {
            fault: (!output.status.success()).then(|| format!("{}{}", text(&output.stderr), output.status)),
            printed: text(&output.stdout),
        }
    }
}

/// What a block did.
struct Ran {
    /// What it printed.
    printed: String,
    /// Why it failed, if it did.
    fault: Option<String>,
}

/// Python that runs the blocks of a page, each with the names of those before it.
struct Session {
    process: Child,
    answers: BufReader<ChildStdout>,
}

/// Reads a block a line, as JSON, and answers with what it printed and how it failed. What libraries print by
/// themselves goes to stderr.
const DRIVER: &str = r#"
import contextlib, io, json, os, sys, traceback
answers = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
names = {"__name__": "__main__"}
for line in sys.stdin:
    printed, fault = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        try:
            exec(compile(json.loads(line), "<block>", "exec"), names)
        except BaseException:
            fault = traceback.format_exc()
    print(json.dumps([printed.getvalue(), fault]), file=answers, flush=True)
"#;

impl Session {
    fn start(desk: &Desk, python: &Path) -> Self {
        let mut command = desk.command(python);
        command.args(["-c", DRIVER]).stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut process = command.spawn().expect("Python starts");
        let answers = BufReader::new(process.stdout.take().expect("its stdout"));
        Self { process, answers }
    }

    fn run(&mut self, text: &str) -> Ran {
        let stdin = self.process.stdin.as_mut().expect("its stdin");
        writeln!(stdin, "{}", serde_json::Value::from(text)).expect("Python listens");
        let mut answer = String::new();
        self.answers.read_line(&mut answer).expect("Python answers");
        let answer: serde_json::Value = serde_json::from_str(&answer).expect("an answer");
        let text = |place: usize| answer[place].as_str().map(str::to_owned);
        Ran { printed: text(0).unwrap_or_default(), fault: text(1) }
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        drop(self.process.stdin.take());
        let _ = self.process.wait();
    }
}

/// The first line that does not stand in the text, behind those before it.
fn missing<'a>(text: &str, lines: &'a str) -> Option<&'a str> {
    let mut printed = text.lines();
    (lines.lines()).find(|line| !printed.any(|other| other.trim_end() == line.trim_end()))
}

/// What is wrong with the blocks of a page, run one after the other.
fn faults(page: &Page, python: Option<&Path>) -> Vec<String> {
    let desk = Desk::new();
    let mut faults = Vec::new();
    let mut printed = String::new();
    let mut session = None;
    for block in blocks(page) {
        let Block { place, language, how, text } = block;
        let ran = match (language.as_str(), &how) {
            ("sh", How::Whole) => desk.shell(&text),
            ("toml", How::Whole) => desk.scene("scenes/example.toml", &text),
            ("toml", How::File(name)) => desk.scene(name, &text),
            ("python", How::Whole) => {
                let start = || Session::start(&desk, python.expect("a page without Python"));
                session.get_or_insert_with(start).run(&text)
            }
            ("text", How::Output) => {
                faults.extend(
                    missing(&printed, &text).map(|line| format!("{place}: not printed: {line}\nbut:\n{printed}")),
                );
                continue;
            }
            _ => continue,
        };
        printed = ran.printed;
        faults.extend(ran.fault.map(|fault| format!("{place}:\n{text}\n{printed}{fault}")));
    }
    faults
}

/// Pages with blocks of Python need the environment of the cross-check.
fn has_python(page: &Page) -> bool {
    blocks(page).iter().any(|block| block.language == "python" && block.how == How::Whole)
}

#[test]
fn blocks_run_in_the_order_of_each_page() {
    let (_, pages): (Vec<Page>, Vec<Page>) = pages().into_iter().partition(has_python);
    // Threads that wait for programs are none of those on which other tests solve.
    let threads = ThreadPoolBuilder::new().build().expect("threads");
    let faults: Vec<String> = threads.install(|| pages.par_iter().flat_map_iter(|page| faults(page, None)).collect());
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}

#[test]
fn pages_with_python_run() {
    if is_left_out("Python in the book", &missing_for_python()) {
        return;
    }
    let python = python();
    let pages: Vec<Page> = pages().into_iter().filter(has_python).collect();
    assert!(pages.len() >= 2, "{} pages", pages.len());
    let faults: Vec<String> = pages.iter().flat_map(|page| faults(page, Some(&python))).collect();
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}
