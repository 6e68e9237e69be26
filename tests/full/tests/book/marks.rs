//! How blocks are marked, and those that are read without being run.

use std::collections::BTreeMap;

use oilwedge_full::book::blocks::{Block, How, blocks};
use oilwedge_full::book::{Page, pages};
use oilwedge_full::notation_page;

use crate::reference::parse_fragment;

/// Languages of blocks that are run or read here. A block without a language is a formula or a drawing; `geo` is meshed
/// by the cross-check.
const LANGUAGES: [&str; 7] = ["", "sh", "toml", "python", "json", "text", "geo"];
/// Blocks that are not run, by page, so that none is marked by the way.
const NOT_RUN: [(&str, usize); 9] = [
    ("README.md", 1),
    ("docs/howto/clusters.md", 5),
    ("docs/howto/engine.md", 3),
    ("docs/howto/install.md", 5),
    ("docs/performance.md", 2),
    ("docs/theory/dynamics.md", 3),
    ("docs/tutorial.md", 1),
    ("docs/validation/accuracy.md", 1),
    ("docs/validation/hostile_input.md", 1),
];

fn all_blocks() -> impl Iterator<Item = (Page, Block)> {
    let with_page = |page: Page| blocks(&page).into_iter().map(move |block| (page.clone(), block));
    pages().into_iter().flat_map(with_page)
}

#[test]
fn blocks_are_marked_as_they_are_tested() {
    let mut not_run: BTreeMap<String, usize> = BTreeMap::new();
    for (page, block) in all_blocks() {
        let Block { place, language, how, text } = block;
        assert!(LANGUAGES.contains(&language.as_str()), "{place}: {language:?}");
        match (language.as_str(), &how) {
            ("sh" | "python", How::Not(reason)) => {
                assert!(reason.len() > 8, "{place}: say why it is not run");
                *not_run.entry(page.path).or_default() += 1;
            }
            ("toml", How::Whole | How::Fragment | How::File(_)) | ("text", How::Output) | (_, How::Whole) => {}
            _ => panic!("{place}: a block of {language:?} is not tested so"),
        }
        if language == "json" {
            let value: Result<serde_json::Value, _> = serde_json::from_str(&text);
            value.unwrap_or_else(|error| panic!("{place}: {error}"));
        }
    }
    let wanted = NOT_RUN.map(|(page, count)| (page.to_owned(), count));
    assert_eq!(not_run, BTreeMap::from(wanted));
}

#[test]
fn fragments_of_scenes_are_parts_of_scenes() {
    let fragments = all_blocks().filter(|(_, block)| block.language == "toml" && block.how == How::Fragment);
    let mut count = 0;
    for (_, block) in fragments {
        parse_fragment(&block.text).unwrap_or_else(|error| panic!("{}:\n{}\n{error}", block.place, block.text));
        count += 1;
    }
    assert!(count > 35, "{count} fragments");
}

#[test]
fn the_notation_is_that_of_the_catalogues() {
    let page = Page::read("docs/theory/notation.md");
    assert!(
        notation_page::page(&page.text) == page.text,
        "run: cargo run --release -p oilwedge-full -- validation notation"
    );
    assert_eq!(notation_page::unknown_names(), Vec::<String>::new());
}
