//! Blocks of code between fences. The word behind the opening fence is their language; behind a comma stands how a
//! block is tested, behind a space the reason where it is not.

use super::Page;

/// How a block is tested.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum How {
    /// The block is used as a whole: run, or solved.
    Whole,
    /// A part of a scene, checked within another one.
    Fragment,
    /// A whole scene that stands in a file for the blocks behind it.
    File(String),
    /// Lines that the block of shell before it prints.
    Output,
    /// The block is not run, for this reason.
    Not(String),
}

/// One block.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Block {
    /// Page and line of its opening fence, for messages.
    pub place: String,
    /// Language of the block; empty for formulas and drawings.
    pub language: String,
    /// How it is tested.
    pub how: How,
    /// Text of the block.
    pub text: String,
}

const FENCE: &str = "```";

/// The blocks of a page in their order.
///
/// # Panics
/// A fence has a mark that is not known, or does not end.
pub fn blocks(page: &Page) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut lines = page.text.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        let Some(info) = line.trim_start().strip_prefix(FENCE) else {
            continue;
        };
        let place = format!("{}:{}", page.path, number + 1);
        let mut text = String::new();
        loop {
            match lines.next() {
                None => panic!("{place}: the block does not end"),
                Some((_, line)) if line.trim() == FENCE => break,
                Some((_, line)) => text += &format!("{line}\n"),
            }
        }
        let (marks, reason) = info.split_once(' ').unwrap_or((info, ""));
        let (language, mark) = marks.split_once(',').unwrap_or((marks, ""));
        let how = match (mark, mark.strip_prefix("file=")) {
            ("", _) => How::Whole,
            ("fragment", _) => How::Fragment,
            ("output", _) => How::Output,
            ("norun", _) => How::Not(reason.to_owned()),
            (_, Some(name)) => How::File(name.to_owned()),
            _ => panic!("{place}: the mark {mark:?} is not known"),
        };
        blocks.push(Block { place, language: language.to_owned(), how, text });
    }
    blocks
}
