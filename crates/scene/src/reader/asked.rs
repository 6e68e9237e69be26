//! What keys the readers of tables asked for, in a test.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::keys::Form;

/// Forms and examples of keys by path.
pub(crate) type Asked = BTreeMap<String, Vec<(String, String)>>;

thread_local! {
    static ASKED: RefCell<Asked> = RefCell::default();
}

/// Records a key that is asked for.
pub(crate) fn record(path: &str, form: &Form<'_>, example: &str) {
    // The number of a table in its list is no part of the path.
    let mut plain = String::new();
    for part in path.split('[') {
        plain += part.split_once(']').map_or(part, |(_, rest)| rest);
    }
    let entry = (format!("{form:?}"), example.to_owned());
    ASKED.with_borrow_mut(|asked| {
        let entries = asked.entry(plain).or_default();
        if !entries.contains(&entry) {
            entries.push(entry);
        }
    });
}

/// All keys that were asked for on this thread since the last time.
pub(crate) fn take() -> Asked {
    ASKED.take()
}
