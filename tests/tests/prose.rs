//! The prose of the sources: comments that stand by themselves, in lines of a width that can be read.

use std::path::Path;

use oilwedge_tests::program::repository;

/// Widest line of a comment [letters].
const WIDEST: usize = 120;

/// Words with which a comment begins that continues the one before it.
const CONTINUING: [&str; 22] = [
    "and", "another", "as [", "but", "it", "its", "less", "likewise", "nor", "not", "of", "or", "so", "such", "that",
    "the same", "their", "then", "these", "they", "those", "under",
];

/// A text of the repository.
struct File {
    /// Path from the root of the repository.
    path: String,
    text: String,
}

/// The texts of these kinds in the crates, the tests and the tools.
fn files(endings: &[&str]) -> Vec<File> {
    let root = repository();
    let mut folders = ["crates", "tests", "tools"].map(|folder| root.join(folder)).to_vec();
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
            if path.is_dir() && !name.starts_with('.') && !["target", "corpus"].contains(&name) {
                folders.push(path);
            } else if path.is_file() && endings.contains(&ending) {
                let below = path.strip_prefix(&root).unwrap_or(&path).to_string_lossy().into_owned();
                files.push(File { path: below, text: text(&path) });
            }
        }
    }
    files
}

fn text(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a text")
}

/// The words of a line of documentation, with its mark.
fn documentation(line: &str) -> Option<(&str, &str)> {
    let line = line.trim_start();
    let mark = ["///", "//!"].into_iter().find(|mark| line.starts_with(mark))?;
    Some((mark, line[mark.len()..].trim()))
}

/// Whether a comment begins as if it continued another one.
fn continues(words: &str) -> bool {
    let lower = words.to_lowercase();
    let begins = |word: &str| {
        let rest = lower.strip_prefix(word);
        rest.is_some_and(|rest| word.ends_with('[') || !rest.starts_with(|next: char| next.is_alphanumeric()))
    };
    words.starts_with(|first: char| first.is_lowercase()) || CONTINUING.into_iter().any(begins)
}

/// Rows of the catalogue of quantities carry their definitions as documentation, which begins with the formula.
fn is_row(item: &str) -> bool {
    item.split_once(" = \"").is_some_and(|(name, _)| name.trim().chars().all(|it| it.is_uppercase() || it == '_'))
}

#[test]
fn comments_stand_by_themselves() {
    let files = files(&["rs"]);
    assert!(files.len() > 500, "only {} files were found", files.len());
    let mut faults = Vec::new();
    for File { path, text } in &files {
        let lines: Vec<&str> = text.lines().collect();
        let marks: Vec<Option<(&str, &str)>> = lines.iter().map(|line| documentation(line)).collect();
        for (k, mark) in marks.iter().enumerate() {
            let Some((mark, words)) = mark else { continue };
            let of_same = |other: Option<&Option<(&str, &str)>>| matches!(other, Some(Some((it, _))) if it == mark);
            let is_first = k == 0 || !of_same(marks.get(k - 1));
            let is_last = !of_same(marks.get(k + 1));
            let item = marks[k..].iter().position(|it| it.is_none()).map_or("", |after| lines[k + after]);
            let goes_on = is_first && continues(words) || is_last && words.ends_with([',', ';']);
            if goes_on && !is_row(item) {
                faults.push(format!("{path}:{}: {words}", k + 1));
            }
        }
    }
    assert!(faults.is_empty(), "comments that continue another one:\n{}", faults.join("\n"));
}

/// Code may be wider, for the sake of a message that is not cut; formatting it is a matter of rustfmt.
#[test]
fn lines_of_comments_can_be_read() {
    let mut faults = Vec::new();
    for File { path, text } in files(&["rs", "js", "py", "sh", "toml"]) {
        let mark = if path.ends_with(".rs") || path.ends_with(".js") { "//" } else { "# " };
        let mut in_documentation = false;
        for (k, line) in text.lines().enumerate() {
            let quotes = if path.ends_with(".py") { line.matches("\"\"\"").count() } else { 0 };
            let begins = in_documentation || line.trim_start().starts_with("\"\"\"");
            in_documentation ^= quotes % 2 == 1;
            if (begins || line.trim_start().starts_with(mark)) && line.chars().count() > WIDEST {
                faults.push(format!("{path}:{}: {} letters", k + 1, line.chars().count()));
            }
        }
    }
    assert!(faults.is_empty(), "comments wider than {WIDEST} letters:\n{}", faults.join("\n"));
}
