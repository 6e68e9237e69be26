//! mshio behind a guard: what it gets to see, and its errors and panics as values.

use std::borrow::Cow;
use std::panic::catch_unwind;

use super::cursor::position;
use super::scan::{Blocks, Scan, format_line};
use crate::Error;

/// A file as mshio gives it.
pub(super) type Decoded = mshio::MshFile<u64, i32, f64>;

/// Runs mshio over the sections that it reads.
pub(super) fn decode(bytes: &[u8], scan: &Scan) -> Result<Decoded, Error> {
    let seen = palatable(bytes, scan);
    let failure = |offset: usize, what: String| Error::Damaged {
        section: section_before(&seen, offset),
        position: position(&seen, offset, scan.binary),
        what,
    };
    let outcome = catch_unwind(|| mshio::parse_msh_bytes(&seen).map_err(|error| innermost(&seen, &error)));
    match outcome {
        Ok(Ok(file)) => Ok(file),
        Ok(Err((offset, what))) => Err(failure(offset, what)),
        Err(_) => Err(failure(0, "the reader gave up on the file".to_owned())),
    }
}

/// Name of the section that holds the byte `offset`.
fn section_before(bytes: &[u8], offset: usize) -> String {
    let before = &bytes[..offset.min(bytes.len())];
    let opening = |at: usize| before[at] == b'$' && (at == 0 || before[at - 1] == b'\n');
    let start = (0..before.len()).rev().find(|&at| opening(at)).map_or(0, |at| at + 1);
    let name = before[start..].iter().take_while(|byte| byte.is_ascii_alphanumeric());
    name.map(|&byte| char::from(byte)).collect()
}

/// Where mshio stopped, and why.
fn innermost(bytes: &[u8], error: &mshio::MshParserError<&[u8]>) -> (usize, String) {
    let mut reasons = error.filter_msh_errors();
    let Some((rest, reason)) = reasons.next() else {
        return (0, "the text does not follow the format".to_owned());
    };
    // mshio hands back the part of the file that is left.
    let offset = (rest.as_ptr() as usize).saturating_sub(bytes.as_ptr() as usize);
    let around = reasons
        .next()
        .map_or(String::new(), |(_, around)| format!(" ({around})"));
    (offset, format!("{reason}{around}"))
}

/// The file itself if mshio can take it as it is; else a copy of the sections that it reads, with
/// tags that claim to be dense: mshio builds a hash table of those that are not, and the tags are
/// known from the scan already.
fn palatable<'a>(bytes: &'a [u8], scan: &Scan) -> Cow<'a, [u8]> {
    let blocks = [&scan.nodes, &scan.elements];
    if !scan.odd && !blocks.iter().any(|section| section.as_ref().is_some_and(|s| s.sparse)) {
        return Cow::Borrowed(bytes);
    }
    let mut copy = Vec::with_capacity(bytes.len() + 64);
    let format = format!("$MeshFormat\n{}\n$EndMeshFormat\n", format_line(scan.binary));
    copy.extend_from_slice(format.as_bytes());
    if let Some(entities) = &scan.entities {
        copy.extend_from_slice(&bytes[entities.clone()]);
        copy.push(b'\n');
    }
    for (name, section) in ["$Nodes\n", "$Elements\n"].iter().zip(blocks) {
        if let Some(section) = section {
            copy.extend_from_slice(name.as_bytes());
            copy.extend(dense_opening(section, scan.binary));
            copy.extend_from_slice(&bytes[section.body..section.whole.end]);
            copy.push(b'\n');
        }
    }
    Cow::Owned(copy)
}

/// The four numbers that open a section, with tags from 1 to the number of things.
fn dense_opening(section: &Blocks, binary: bool) -> Vec<u8> {
    let numbers = [
        section.blocks.len() as u64,
        section.total as u64,
        1,
        section.total as u64,
    ];
    if binary {
        numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
    } else {
        numbers.map(|number| number.to_string()).join(" ").into_bytes()
    }
}
