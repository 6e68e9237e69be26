//! The gate: four scenes may not cost more than they did; counted are instructions.
//!
//! Instructions (callgrind) are the same on a busy machine. They depend on the compiler, its settings and the libraries
//! of the system: `docs/performance.md` records a count for each scene and compiler, `gate.txt` those of the functions.
//! Where none is recorded, two programs are compared.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use oilwedge_tests::program::repository;

use super::films::{Films, Kind};
use crate::tables::{replace, row};

/// Part by which a count may differ: that of addresses, of hash seeds and of the length of paths.
pub const NOISE: f64 = 0.01;
/// Part of all instructions from which on a function is recorded, and its growth is worth a line.
const WORTH_A_LINE: f64 = 0.001;
/// Counts of functions, relative to the repository: lines of scene, instructions, function.
const FUNCTIONS: &str = "tests/full/src/performance/gate.txt";
/// Columns of the page's table: scene, count, compiler.
const COLUMNS: [usize; 3] = [1, 2, 3];

/// Instructions of one run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Count {
    /// Instructions of the whole run.
    pub total: f64,
    /// Instructions of each function, without those of what it calls.
    pub functions: BTreeMap<String, f64>,
}

/// The scenes that are counted: a plain film, 1e5 unknowns from a file, a cavity after Swift and Stieber, and a film
/// that conserves its oil under a load.
pub fn scenes(films: &Films) -> [(&'static str, PathBuf); 4] {
    let shipped = |name: &str| repository().join("scenes").join(format!("{name}.toml"));
    [
        ("01_plain_ring", shipped("01_plain_ring")),
        ("ring of 1e5 unknowns from a file", films.ring(Kind::Linear, 100_000)),
        ("11_swift_stieber_ring", shipped("11_swift_stieber_ring")),
        ("17_engine_main_bearing", shipped("17_engine_main_bearing")),
    ]
}

/// Instructions of `oilwedge solve SCENE` without error bars, on one thread; none without valgrind.
///
/// # Panics
/// If the program fails.
pub fn counted(program: &Path, scene: &Path) -> Option<Count> {
    let folder = tempfile::TempDir::new().expect("a folder");
    let profile = folder.path().join("profile");
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--compress-strings=no", "--compress-pos=no"])
        .arg(format!("--callgrind-out-file={}", profile.display()))
        .arg(program)
        .args(["solve", "--bars", "none", "--threads", "1", "--out"])
        .arg(folder.path().join("out"))
        .arg(scene)
        .output()
        .ok()?;
    assert!(output.status.success(), "{} fails", program.display());
    Some(of_profile(&std::fs::read_to_string(profile).expect("a profile")))
}

/// The counts in a file of callgrind: after `fn=` come lines `place instructions` of the function itself, and after
/// `calls=` one line of what it calls.
pub fn of_profile(text: &str) -> Count {
    let (mut count, mut function) = (Count::default(), "");
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        if let Some(name) = line.strip_prefix("fn=") {
            function = name;
        } else if line.starts_with("calls=") {
            lines.next();
        } else if line.starts_with(|first: char| first.is_ascii_digit())
            && let Some(own) = line.split_whitespace().nth(1).and_then(|number| number.parse::<f64>().ok())
        {
            count.total += own;
            *count.functions.entry(function.to_owned()).or_default() += own;
        }
    }
    count
}

/// The compiler, as it names itself, its settings where they are not those of a release, and the library of C with the
/// processor for which that chooses its functions.
pub fn compiler() -> String {
    let told = |program: &str, argument: &str| {
        let output = Command::new(program).arg(argument).output();
        output.map_or("unknown".to_owned(), |output| String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let settings = [
        Some(format!(", {}", told("getconf", "GNU_LIBC_VERSION"))),
        has_avx2().then(|| ", AVX2".to_owned()),
        option_env!("CARGO_PROFILE_RELEASE_CODEGEN_UNITS").map(|units| format!(", {units} codegen units")),
        option_env!("CARGO_INCREMENTAL").filter(|kind| *kind != "0").map(|_| ", incremental".to_owned()),
    ];
    settings.into_iter().flatten().fold(told("rustc", "--version"), |name, setting| name + &setting)
}

/// Whether this processor has AVX2, by which the library of C chooses how it copies and takes powers.
fn has_avx2() -> bool {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    told.split_whitespace().any(|flag| flag == "avx2")
}

/// The count of a scene that is recorded for this compiler.
pub fn recorded(page: &str, scene: &str) -> Option<Count> {
    let table = page.split("<!-- table: gate -->").nth(1)?.split("<!-- end -->").next()?;
    let (compiler, [name, count, by]) = (compiler(), COLUMNS);
    let mut rows = table.lines().map(|line| line.split('|').map(str::trim).collect::<Vec<_>>());
    let row = rows.find(|row| row.get(name) == Some(&scene) && row.get(by) == Some(&compiler.as_str()))?;
    let functions = std::fs::read_to_string(repository().join(FUNCTIONS)).unwrap_or_default();
    let of_scene = functions.lines().filter_map(|line| line.strip_prefix(scene)?.strip_prefix('\t')?.split_once('\t'));
    let functions = of_scene.filter_map(|(count, function)| Some((function.to_owned(), count.parse().ok()?)));
    Some(Count { total: row[count].parse().ok()?, functions: functions.collect() })
}

/// Records the counts of the scenes for this compiler: the page with its table, and the file of functions. Nothing
/// without valgrind.
///
/// # Errors
/// The file of functions cannot be written.
pub fn record(page: &str, program: &Path) -> std::io::Result<Option<String>> {
    let (films, compiler) = (Films::new(), compiler());
    let (mut rows, mut functions) = (vec![row(["scene", "instructions", "compiler"])], String::new());
    for (scene, path) in scenes(&films) {
        eprintln!("gate: {scene}");
        let Some(Count { total, functions: own }) = counted(program, &path) else { return Ok(None) };
        rows.push(vec![scene.to_owned(), format!("{total:.0}"), compiler.clone()]);
        let mut own: Vec<_> = own.into_iter().filter(|(_, count)| *count > WORTH_A_LINE * total).collect();
        own.sort_by(|a, b| b.1.total_cmp(&a.1));
        functions.extend(own.iter().map(|(function, count)| format!("{scene}\t{count:.0}\t{function}\n")));
    }
    std::fs::write(repository().join(FUNCTIONS), functions)?;
    Ok(Some(replace(page, "gate", &rows)))
}

/// Compares the count of a scene with one before: what to say, and whether the gate is open. What grew is listed where
/// it is not.
pub fn judged(scene: &str, count: &Count, before: &Count) -> (String, bool) {
    let change = count.total / before.total - 1.0;
    let is_open = change <= NOISE;
    let verdict = if is_open { "the gate is open" } else { "this scene pays for something" };
    let [now, then] = [count.total, before.total];
    let mut told = format!("{scene}: {now:.0} instructions, before {then:.0}: {:+.2} %; {verdict}", 100.0 * change);
    if !is_open {
        let grown = |(function, now): (&String, &f64)| {
            let then = before.functions.get(function).copied().unwrap_or(0.0);
            (now - then > WORTH_A_LINE * before.total).then(|| (now - then, function.clone(), then))
        };
        let mut grown: Vec<_> = count.functions.iter().filter_map(grown).collect();
        grown.sort_by(|a, b| b.0.total_cmp(&a.0));
        told.extend(grown.iter().map(|(more, function, then)| format!("\n  {more:+.0} after {then:.0}: {function}")));
    }
    (told, is_open)
}
