//! `docs/validation/short_bearing.md` and its figures are those that the program writes.

use oilwedge_full::{short_bearing_figures as figures, short_bearing_page as page};
use oilwedge_tests::program::repository;

/// Words and numbers of a drawing; numbers of paths stand apart.
fn parts(svg: &str) -> impl Iterator<Item = String> {
    let apart = svg.replace(['m', 'l', 'z'], " ").replace('-', " -");
    let words = apart.split(|letter: char| letter.is_whitespace() || ",\"=<>()".contains(letter));
    let words: Vec<String> = words.filter(|part| !part.is_empty()).map(str::to_owned).collect();
    words.into_iter()
}

/// Tables to the letter; figures to a tenth of a millimetre: where a curve falls between two hundredths, another
/// machine may round it to the other.
#[test]
fn the_page_and_its_figures_are_up_to_date() {
    const COMMAND: &str = "run: cargo run --release -p oilwedge-full -- validation";
    let study = page::Study::solved();
    let docs = repository().join("docs/validation");
    let written = std::fs::read_to_string(docs.join("short_bearing.md")).expect("the page");
    assert!(written == page::page_of(&written, &study), "{COMMAND}");
    let sheets = figures::sheets(&study);
    let mut shown = String::new();
    for (name, svg) in &sheets {
        let file = format!("short_bearing/{name}.svg");
        assert!(written.contains(&format!("]({file})")), "{file} is not shown");
        let drawn = std::fs::read_to_string(docs.join(&file)).expect(&file);
        assert_eq!(parts(&drawn).count(), parts(svg).count(), "{file}: {COMMAND}");
        for (old, new) in parts(&drawn).zip(parts(svg)) {
            let near = match (old.parse::<f64>(), new.parse::<f64>()) {
                (Ok(old), Ok(new)) => (old - new).abs() <= 0.1,
                _ => old == new,
            };
            assert!(near, "{file}: {old}, now {new}; {COMMAND}");
        }
        shown += svg;
    }
    for figure in 2..=14 {
        assert!(shown.contains(&format!("Figure {figure}. ")), "figure {figure}");
    }
    let files = std::fs::read_dir(docs.join("short_bearing")).expect("the figures");
    assert_eq!(files.count(), sheets.len(), "a figure that no page shows");
}
