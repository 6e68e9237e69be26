//! The catalogue of keys, quantities, effects, fields, warnings and parts of results: every row has all its
//! columns, and words that stand once in the code.

use oilwedge_report::catalogue::{CatalogueEntry, entries};
use oilwedge_tests::house::sources;
use oilwedge_tests::program::repository;

/// Sentences with fewer words may be parts of others.
const FEWEST_WORDS: usize = 4;

/// The columns that each row of a kind has.
fn columns(entry: &CatalogueEntry) -> &'static [&'static str] {
    let is_table = entry.columns.iter().any(|(name, _)| *name == "keys");
    match entry.kind {
        "key" if entry.name == "title" || is_table => &["form", "if absent"],
        "key" => &["form", "if absent", "example"],
        "quantity" => &["symbol", "unit", "definition", "error bar"],
        "effect" => &["without it"],
        "field" => &["symbol", "unit"],
        "warning" => &[],
        "result" => &["parts"],
        kind => panic!("another kind: {kind}"),
    }
}

#[test]
fn every_row_has_all_columns() {
    for entry in entries() {
        assert!(!entry.what.is_empty(), "{} has no sentence", entry.name);
        for column in columns(&entry) {
            let is_there = entry.columns.iter().any(|(name, text)| name == column && !text.is_empty());
            assert!(is_there, "{} {} has no {column}", entry.kind, entry.name);
        }
    }
}

#[test]
fn its_words_have_no_second_copy_in_the_code() {
    let sources = sources();
    let entries = entries();
    let long = entries.iter().filter(|entry| entry.what.split(' ').count() >= FEWEST_WORDS);
    let (mut seen, mut copies) = (0, Vec::new());
    for entry in long {
        let quoted = format!("{:?}", entry.what).replace("\\'", "'");
        let lines = |code: &[String]| code.iter().filter(|line| line.contains(&quoted)).count();
        let counts = sources.iter().map(|source| (source.path.as_str(), lines(&source.code)));
        let places: Vec<_> = counts.filter(|(_, count)| *count > 0).collect();
        let rows = entries.iter().filter(|other| other.what == entry.what).count();
        if places.iter().map(|(_, count)| count).sum::<usize>() != rows {
            copies.push(format!("{}: {places:?}", entry.what));
        }
        seen += 1;
    }
    assert!(copies.is_empty(), "{copies:#?}");
    assert!(seen > 150, "only {seen} sentences");
}

/// The table of `film.vtu` on the page of results has each of its fields, with its unit.
#[test]
fn fields_of_files_are_on_the_page_of_results() {
    let page = std::fs::read_to_string(repository().join("docs/reference/result.md")).expect("the page");
    for field in oilwedge_study::fields::file_fields() {
        let head = format!("| `{}` | {} |", field.name, field.unit);
        assert!(page.contains(&head), "{head}");
    }
}
