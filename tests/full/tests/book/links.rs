//! Links, images, and the list of chapters.

use std::collections::{BTreeMap, BTreeSet};

use oilwedge_full::book::links::{anchors, links};
use oilwedge_full::book::{Page, README, SUMMARY, pages};
use oilwedge_tests::program::repository;

use super::texts_below;

#[test]
fn links_and_images_lead_somewhere() {
    let by_path: BTreeMap<String, Page> = pages().into_iter().map(|page| (page.path.clone(), page)).collect();
    let mut faults = Vec::new();
    let mut count = 0;
    for page in by_path.values() {
        for link in links(page) {
            count += 1;
            let is_outside = link.target.contains("://");
            if is_outside {
                if link.is_image {
                    faults.push(format!("{}: an image from the network: {}", link.place, link.target));
                }
                continue;
            }
            let (path, anchor) = link.target.split_once('#').unwrap_or((&link.target, ""));
            let path = joined(&page.path, path);
            if !repository().join(&path).exists() {
                faults.push(format!("{}: there is no {path}", link.place));
            } else if page.path != README && !path.starts_with("docs/") {
                faults.push(format!("{}: {path} is not in the book; name it without a link", link.place));
            } else if !anchor.is_empty()
                && !by_path.get(&path).is_some_and(|to| anchors(to).iter().any(|it| it == anchor))
            {
                faults.push(format!("{}: {path} has no #{anchor}", link.place));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    assert!(count > 200, "{count} links");
}

/// The path of a link on a page, below the repository.
fn joined(page: &str, target: &str) -> String {
    if target.is_empty() {
        return page.to_owned();
    }
    let mut names: Vec<&str> = page.split('/').collect();
    names.pop();
    for name in target.trim_end_matches('/').split('/') {
        match name {
            ".." => drop(names.pop()),
            name => names.push(name),
        }
    }
    names.join("/")
}

#[test]
fn the_list_of_chapters_has_every_page_once() {
    let summary = Page::read(SUMMARY);
    let listed: Vec<String> = links(&summary).iter().map(|link| joined(SUMMARY, &link.target)).collect();
    let once: BTreeSet<&String> = listed.iter().collect();
    assert_eq!(listed.len(), once.len(), "a page is listed twice");
    let paths = pages().into_iter().map(|page| page.path);
    let wanted: BTreeSet<String> = paths.filter(|path| path != README && path != SUMMARY).collect();
    assert_eq!(once.into_iter().cloned().collect::<BTreeSet<_>>(), wanted);
}

#[test]
fn pages_and_pictures_load_nothing() {
    for (path, text) in texts_below(&repository().join("docs"), &["md", "svg", "toml"]) {
        for mark in ["<script", "<img", "<iframe", "<link", "@import", "url(http", "src=\"http", "href=\"http"] {
            assert!(!text.contains(mark), "{path}: {mark}");
        }
        if path.ends_with(".svg") {
            let addresses: BTreeSet<&str> = text.split("://").skip(1).map(|rest| &rest[..10]).collect();
            assert!(addresses.iter().all(|address| *address == "www.w3.org"), "{path}: {addresses:?}");
        }
    }
}
