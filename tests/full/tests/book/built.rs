//! The book as HTML.

use std::path::Path;
use std::process::Command;

use oilwedge_tests::left_out::{Missing, is_skipped};
use oilwedge_tests::program::repository;

use super::texts_below;

/// Where mdBook is installed: it builds the book, whose pages lead to each other and ask for nothing outside.
#[test]
fn the_book_is_built() {
    let is_there = Command::new("mdbook").arg("--version").output().is_ok_and(|output| output.status.success());
    let missing = match is_there {
        true => Vec::new(),
        false => vec![Missing::new("mdBook", "cargo install mdbook --version 0.5.4 --locked")],
    };
    if is_skipped("building the book", &missing) {
        return;
    }
    let folder = tempfile::tempdir().expect("a temporary folder");
    let output = Command::new("mdbook")
        .arg("build")
        .arg(repository().join("docs"))
        .arg("--dest-dir")
        .arg(folder.path())
        .output()
        .expect("mdBook starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success() && !said.contains("WARN") && !said.contains("ERROR"), "{said}");
    let mut links = 0;
    for (path, html) in texts_below(folder.path(), &["html"]) {
        let file = Path::new(&path);
        // The page for addresses that are not there names all others from the root.
        if file.ends_with("404.html") {
            continue;
        }
        for mark in ["src=\"", "href=\""] {
            for target in html.split(mark).skip(1).filter_map(|rest| rest.split('"').next()) {
                let is_page = html.contains(&format!("<a href=\"{target}\""))
                    || html.contains(&format!("class=\"header\" href=\"{target}\""));
                if target.contains("://") {
                    assert!(is_page, "{path} loads {target}");
                } else if !target.is_empty() && !target.starts_with('#') {
                    links += 1;
                    let to = file.parent().expect("a folder").join(target.split(['#', '?']).next().unwrap_or_default());
                    assert!(to.exists(), "{path}: {target}");
                }
            }
        }
    }
    assert!(links > 500, "{links} links");
}
