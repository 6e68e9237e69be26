//! The page `docs/reference/scene.md`: tables made of the catalogue of keys.

use oilwedge_scene::catalogue::keys;
use oilwedge_scene::keys::Key;

use crate::tables::{replace, row};

/// Tables of a scene that have a table of the page: all but `[sweep]`, whose keys are those of other tables.
fn tables() -> Vec<&'static str> {
    let mut tables: Vec<_> = (keys().filter_map(|key| key.path.split_once('.')))
        .map(|(table, _)| table)
        .filter(|table| *table != "sweep")
        .collect();
    tables.dedup();
    tables
}

/// The page with tables made anew.
pub fn page(text: &str) -> String {
    tables().into_iter().fold(text.to_owned(), |text, table| {
        let prefix = format!("{table}.");
        let below = keys().filter(|key| key.path.starts_with(&prefix));
        let rows = below.map(|key| line(key, &key.path[prefix.len()..]));
        let head = row(["key", "form", "absent", "range", "meaning"]);
        let rows: Vec<_> = std::iter::once(head).chain(rows).collect();
        replace(&text, table, &rows)
    })
}

fn line(key: &Key, name: &str) -> Vec<String> {
    vec![format!("`{name}`"), key.forms_in_words(), key.absent.to_owned(), key.range_in_words(), key.what.to_owned()]
}
