//! Links and images of pages, and the anchors that links may name.

use std::collections::BTreeMap;

use super::Page;

/// A link or an image.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Link {
    /// Page and line, for messages.
    pub place: String,
    /// Target of the link, as it is written.
    pub target: String,
    /// Whether it shows what is there.
    pub is_image: bool,
}

/// The lines of a page that are no code, with their numbers from 1.
fn prose(page: &Page) -> impl Iterator<Item = (usize, &str)> {
    let mut is_code = false;
    page.text.lines().enumerate().filter_map(move |(number, line)| {
        let is_fence = line.trim_start().starts_with("```");
        is_code ^= is_fence;
        (!is_code && !is_fence && !line.starts_with("    ")).then_some((number + 1, line))
    })
}

/// A line without the code within.
fn without_code(line: &str) -> String {
    line.split('`').step_by(2).collect::<Vec<_>>().join("")
}

/// The links and images of a page. One behind code, `` [`key`](page.md) ``, is a link too.
pub fn links(page: &Page) -> Vec<Link> {
    let mut links = Vec::new();
    for (number, line) in prose(page) {
        let line = without_code(line);
        let mut rest = line.as_str();
        while let Some(middle) = rest.find("](") {
            let open = rest[..middle].rfind('[');
            let behind = &rest[middle + 2..];
            let Some((target, after)) = behind.split_once(')') else {
                break;
            };
            links.push(Link {
                place: format!("{}:{number}", page.path),
                target: target.to_owned(),
                is_image: open.is_some_and(|open| rest[..open].ends_with('!')),
            });
            rest = after;
        }
    }
    links
}

/// The anchors of a page's headings, as forges and mdBook make them.
pub fn anchors(page: &Page) -> Vec<String> {
    let mut seen: BTreeMap<String, usize> = BTreeMap::new();
    let headings = prose(page).map(|(_, line)| line).filter(|line| line.starts_with('#'));
    let headings = headings.map(|line| line.trim_start_matches('#'));
    headings
        .map(|heading| {
            let letters = heading.trim().chars().filter_map(|letter| match letter {
                ' ' => Some('-'),
                letter if letter.is_alphanumeric() || "-_".contains(letter) => Some(letter),
                _ => None,
            });
            let anchor = letters.flat_map(char::to_lowercase).collect::<String>();
            let count = seen.entry(anchor.clone()).or_default();
            *count += 1;
            match *count {
                1 => anchor,
                count => format!("{anchor}-{}", count - 1),
            }
        })
        .collect()
}
