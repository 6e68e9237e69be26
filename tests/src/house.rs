//! What the layout of the sources promises, counted: which files know an effect, import circles, sizes, names of
//! quantities in quotes.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use crate::program::repository;

/// Effects whose knowledge is bounded: the word by which code names them, and the most files that may do so. A law or
/// a term is known to five, the term of which damping is made to seven, a closure to eight. What closes around a
/// film is known to more, heat as a field too: these lists may shrink, and never grow.
pub const EFFECTS: [(&str, usize); 13] = [
    ("barus", 5),
    ("squeeze", 7),
    ("jfo", 8),
    ("heat", 39),
    ("iso7902", 4),
    ("roughness", 15),
    ("turbulence", 14),
    ("contact", 67),
    ("deflection", 73),
    ("liner", 50),
    ("tilt", 79),
    ("orbit", 96),
    ("crankshaft", 29),
];

/// A file of production code.
#[derive(Debug, Clone)]
pub struct Source {
    /// Path from the root of the repository.
    pub path: String,
    /// The crate, as `fem`.
    pub package: String,
    /// Text of the file.
    pub text: String,
    /// Lines of the file without comments and test modules; a line that is not code is empty.
    pub code: Vec<String>,
}

/// All production files: `crates/*/src`, test files aside.
///
/// # Panics
/// If a file cannot be read.
pub fn sources() -> Vec<Source> {
    let root = repository();
    let mut files: Vec<PathBuf> = Vec::new();
    let mut folders = vec![root.join("crates")];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            match path.is_dir() {
                true => folders.push(path),
                false if path.extension().is_some_and(|ending| ending == "rs") => files.push(path),
                false => {}
            }
        }
    }
    files.sort();
    let all = files.iter().map(|file| source(&root, file));
    all.filter(|source| source.path.contains("/src/") && !source.path.ends_with("tests.rs")).collect()
}

fn source(root: &Path, file: &Path) -> Source {
    let path = file.strip_prefix(root).unwrap_or(file).to_string_lossy().into_owned();
    let text = std::fs::read_to_string(file).expect("a source file");
    Source { package: path.split('/').nth(1).unwrap_or_default().to_owned(), code: code(&text), path, text }
}

/// The lines of a text without comments and without what follows the first test module.
fn code(text: &str) -> Vec<String> {
    let lines: Vec<&str> = text.lines().collect();
    let tests = (0..lines.len()).find(|&k| {
        let next = lines.get(k + 1).copied().unwrap_or_default();
        lines[k].trim() == "#[cfg(test)]" && next.contains("mod ") && !next.trim_end().ends_with(';')
    });
    let bare = |line: &&str| match line.find("//") {
        Some(place) if line[..place].matches('"').count().is_multiple_of(2) => line[..place].trim_end().to_owned(),
        _ => (*line).to_owned(),
    };
    lines[..tests.unwrap_or(lines.len())].iter().map(bare).collect()
}

impl Source {
    /// Lines of code, blank ones aside.
    pub fn lines_of_code(&self) -> usize {
        self.code.iter().filter(|line| !line.trim().is_empty()).count()
    }

    /// Whether its code names the effect: an identifier or a key that holds the word. Lines that only list a module or
    /// a row do not count.
    pub fn knows(&self, word: &str) -> bool {
        (self.code.iter()).filter(|line| !is_listing(line)).any(|line| holds(&without_messages(line), word))
    }
}

/// `mod barus;`, `&barus::BARUS,`, `("barus", include_str!("barus.toml")),`: a line of a list, that goes with the file
/// it names.
fn is_listing(line: &str) -> bool {
    let line = line.trim().trim_start_matches("pub ").trim_start_matches("pub(crate) ");
    let is_entry = |line: &str| line.chars().all(|letter| letter.is_alphanumeric() || "_:&,".contains(letter));
    line.starts_with("mod ") && line.ends_with(';')
        || line.starts_with("use ") && line.ends_with("::*;")
        || line.ends_with(',')
            && line.to_uppercase().ends_with(line.rsplit("::").next().unwrap_or(line))
            && is_entry(line)
        || line.starts_with("(\"") && line.contains("include_str!")
        || line.starts_with('&') && line.ends_with(',') && line.contains("::")
}

/// Properties of liquids and machines that are no effect.
const PROPERTIES: [&str; 5] = ["oilwedge_heat", "heat_capacity", "HEAT_CAPACITY", "HeatCapacity", "HeatTransfer"];

/// A line without what people read, texts with a space in quotes, and without the names of properties.
fn without_messages(line: &str) -> String {
    let parts = line.split('"').enumerate();
    let kept = parts.filter(|(index, part)| index % 2 == 0 || !part.contains(' '));
    let kept: String = kept.map(|(_, part)| format!("{part} ")).collect();
    PROPERTIES.iter().fold(kept, |line, property| line.replace(property, ""))
}

/// Whether a line holds the word as a part of an identifier (`heat_balance`, `HeatBalance`, but neither `sheath` nor
/// `squeezed`).
fn holds(line: &str, word: &str) -> bool {
    let small = line.to_ascii_lowercase();
    small.match_indices(word).any(|(place, _)| {
        let [before, it] = [&line[..place], &line[place..]];
        let begins = !before.ends_with(char::is_alphabetic)
            || before.ends_with(char::is_lowercase) && it.starts_with(char::is_uppercase);
        let ends = !it[word.len()..].starts_with(char::is_lowercase);
        begins && ends
    })
}

/// The files whose code names the effect.
pub fn knowing<'a>(sources: &'a [Source], word: &str) -> Vec<&'a str> {
    let knowing = sources.iter().filter(|source| source.knows(word));
    knowing.map(|source| source.path.as_str()).collect()
}

/// Groups of files of one crate that import each other in a circle.
pub fn circles(sources: &[Source], package: &str) -> Vec<BTreeSet<String>> {
    let own: Vec<&Source> = sources.iter().filter(|source| source.package == package).collect();
    let modules: BTreeMap<String, usize> =
        (own.iter().enumerate()).map(|(index, source)| (module(&source.path), index)).collect();
    let uses: Vec<BTreeSet<usize>> = own
        .iter()
        .map(|source| {
            let here = module(&source.path);
            imports(source, &here).iter().filter_map(|path| found(&modules, path)).collect()
        })
        .collect();
    let reach: Vec<BTreeSet<usize>> = (0..own.len()).map(|start| reached(&uses, start)).collect();
    let mut circles = BTreeSet::new();
    for one in 0..own.len() {
        let circle: BTreeSet<usize> = (0..own.len())
            .filter(|&other| other != one && reach[one].contains(&other) && reach[other].contains(&one))
            .chain([one])
            .collect();
        if circle.len() > 1 {
            circles.insert(circle);
        }
    }
    let names = |circle: BTreeSet<usize>| circle.into_iter().map(|index| own[index].path.clone()).collect();
    circles.into_iter().map(names).collect()
}

fn reached(uses: &[BTreeSet<usize>], start: usize) -> BTreeSet<usize> {
    let (mut reached, mut open) = (BTreeSet::new(), vec![start]);
    while let Some(one) = open.pop() {
        for &next in &uses[one] {
            if reached.insert(next) {
                open.push(next);
            }
        }
    }
    reached
}

/// `a::b` of `crates/x/src/a/b.rs`; nothing of `lib.rs`.
fn module(path: &str) -> String {
    let inner = path.split("/src/").nth(1).unwrap_or_default().trim_end_matches(".rs");
    let inner = inner.trim_end_matches("/mod");
    match inner {
        "lib" | "main" => String::new(),
        inner => inner.replace('/', "::"),
    }
}

/// The deepest module of a path.
fn found(modules: &BTreeMap<String, usize>, path: &str) -> Option<usize> {
    let mut path = path;
    loop {
        if let Some(&index) = modules.get(path).filter(|_| !path.is_empty()) {
            return Some(index);
        }
        path = path.rsplit_once("::")?.0;
    }
}

/// Paths in the crate that a file names, `crate::a::b::Item` as `a::b::Item`, groups in braces taken apart.
fn imports(source: &Source, here: &str) -> Vec<String> {
    let text = source.code.join(" ");
    let mut paths = Vec::new();
    for (mark, base) in [("crate::", String::new()), ("super::", parent(here))] {
        for (place, _) in text.match_indices(mark) {
            let before = text[..place].chars().next_back();
            if before.is_some_and(|letter| letter.is_alphanumeric() || letter == '_' || letter == ':') {
                continue;
            }
            let rest = &text[place + mark.len()..];
            // A parent that is a file of its own re-exports its children: it is no import of the parent itself.
            take_apart(&base, rest, &mut paths);
        }
    }
    paths
}

fn parent(module: &str) -> String {
    module.rsplit_once("::").map_or(String::new(), |(parent, _)| parent.to_owned())
}

fn take_apart(base: &str, rest: &str, paths: &mut Vec<String>) {
    let join = |tail: &str| match base {
        "" => tail.to_owned(),
        base => format!("{base}::{tail}"),
    };
    let end =
        rest.find(|letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == ':')).unwrap_or(rest.len());
    let head = rest[..end].trim_end_matches(':');
    if !rest[end..].starts_with('{') {
        paths.push(join(head));
        return;
    }
    let Some(close) = rest[end..].find('}') else { return };
    let items = rest[end + 1..end + close].split(',').map(|item| item.trim().split(' ').next().unwrap_or_default());
    paths.extend(items.map(|item| match head {
        "" => join(item),
        head => join(&format!("{head}::{item}")),
    }));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_in_identifiers_only() {
        let knows = holds;
        assert!(knows("enum Law { Barus(Barus) }", "barus") && knows("fn heat_balance()", "heat"));
        assert!(knows("HeatBalance", "heat") && knows("\"jfo\"", "jfo"));
        assert!(knows("FilmHeat", "heat") && !knows("a sheath", "heat") && !knows("squeezed_flow", "squeeze"));
        assert!(
            is_listing("    &barus::BARUS,") && is_listing("pub mod barus;") && !is_listing("Self::Barus(law) => law,")
        );
    }

    #[test]
    fn comments_and_tests_are_no_code() {
        let text = "let a = 1; // heat\n//! heat\nlet b = \"//\";\n#[cfg(test)]\nmod tests {\n}\n";
        assert_eq!(code(text), ["let a = 1;", "", "let b = \"//\";"]);
    }

    #[test]
    fn groups_are_taken_apart() {
        let mut paths = Vec::new();
        take_apart("", "a::{B, c::D} rest", &mut paths);
        take_apart("x", "y::Z;", &mut paths);
        assert_eq!(paths, ["a::B", "a::c::D", "x::y::Z"]);
    }
}
