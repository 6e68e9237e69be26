//! What the targets share: the bound of memory, and a mutation that knows words.
//!
//! `docs/validation/hostile_input.md` tells how to run them and what they found.

#![forbid(unsafe_code)]

use std::alloc::System;

use cap::Cap;

/// Bytes that reading may take whatever the input: messages, tables of units, buffers.
pub const BYTES_AT_LEAST: usize = 4 << 20;

/// Runs `read` with no more memory than `most` bytes and some megabytes: an allocation beyond that ends the program,
/// and libFuzzer keeps the input.
pub fn bounded<T>(allocator: &Cap<System>, most: usize, read: impl FnOnce() -> T) -> T {
    let limit = allocator.allocated() + BYTES_AT_LEAST + most;
    allocator.set_limit(limit).expect("less is in use");
    let done = read();
    allocator.set_limit(usize::MAX).expect("there is no limit");
    done
}

/// Numbers and words at which readers stumble.
const WORDS: [&str; 28] = [
    "0",
    "1",
    "-1",
    "2",
    "3",
    "9",
    "15",
    "255",
    "65535",
    "65536",
    "2147483647",
    "-2147483648",
    "4294967295",
    "4294967296",
    "1000000000000000000",
    "18446744073709551615",
    "18446744073709551616",
    "nan",
    "-nan",
    "inf",
    "-inf",
    "1e308",
    "-1e308",
    "1e999",
    "1e-320",
    "0.1",
    "-0",
    "1e-9",
];

/// One step of Marsaglia's xorshift.
fn step(state: &mut u64) -> usize {
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    (*state >> 11) as usize
}

/// Changes the text in `data[..size]` by words and lines: a word becomes another one or that of another place, a line
/// is doubled, removed or moved. Returns the new size, at most `most`; `None` where there is nothing to change.
pub fn mutate_words(data: &mut [u8], size: usize, most: usize, seed: u32) -> Option<usize> {
    let mut state = (u64::from(seed) << 20) | 0x9e37_79b9;
    let text = data[..size].to_vec();
    let of_line = step(&mut state).is_multiple_of(3);
    let is_gap = |byte: &u8| {
        if of_line {
            *byte == b'\n'
        } else {
            b" \t\r\n=,\"{}[]".contains(byte)
        }
    };
    let mut parts = Vec::new();
    let mut start = None;
    for (at, byte) in text.iter().enumerate() {
        match (start, is_gap(byte)) {
            (None, false) => start = Some(at),
            (Some(from), true) => {
                parts.push(from..at);
                start = None;
            }
            _ => {}
        }
    }
    parts.extend(start.map(|from| from..text.len()));
    if parts.is_empty() {
        return None;
    }
    let part = parts[step(&mut state) % parts.len()].clone();
    let other = parts[step(&mut state) % parts.len()].clone();
    let new: Vec<u8> = match (of_line, step(&mut state) % 4) {
        (true, 0) => Vec::new(),
        (true, 1) => [&text[part.clone()], b"\n", &text[part.clone()]].concat(),
        (_, 2) => text[other].to_vec(),
        _ => WORDS[step(&mut state) % WORDS.len()].into(),
    };
    let changed = [&text[..part.start], &new, &text[part.end..]].concat();
    let kept = changed.len().min(most).min(data.len());
    data[..kept].copy_from_slice(&changed[..kept]);
    Some(kept)
}
