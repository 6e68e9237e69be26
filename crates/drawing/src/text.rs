//! Labels: words with italic symbols, indices and exponents, and how wide they are.

use std::sync::LazyLock;

use ttf_parser::{Face, GlyphId};

use crate::{Colour, INK, LETTERS, POINT, SMALLEST_LETTERS};

/// Advance widths of Noto Sans Regular from the space to `~` [1/2048 of the height of the letters].
#[rustfmt::skip]
const ADVANCES: [u16; 95] = [
    532, 551, 836, 1323, 1171, 1702, 1499, 461, 614, 614, 1128, 1171,
    549, 659, 549, 762, 1171, 1171, 1171, 1171, 1171, 1171, 1171, 1171,
    1171, 1171, 549, 549, 1171, 1171, 1171, 889, 1841, 1309, 1331, 1294,
    1495, 1139, 1063, 1491, 1518, 694, 559, 1268, 1073, 1858, 1556, 1599,
    1239, 1599, 1274, 1124, 1139, 1497, 1229, 1905, 1200, 1159, 1171, 674,
    762, 674, 1171, 909, 1188, 1149, 1260, 983, 1260, 1155, 705, 1260,
    1266, 528, 528, 1094, 528, 1915, 1266, 1239, 1260, 1260, 846, 981,
    739, 1266, 1040, 1610, 1083, 1044, 963, 778, 1128, 778, 1171,
];
/// Advance of a letter that the table lacks [1/2048 of the height].
const OTHER_ADVANCE: f64 = 1220.0;
/// Bold letters are wider.
const BOLD: f64 = 1.07;
/// How far indices are lowered and exponents raised [of the height of the letters].
const LOWERED: f64 = 0.22;
const RAISED: f64 = 0.38;

/// Stands for what is cut off.
const ELLIPSIS: &str = "\u{2026}";

/// How a part of a label is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Style {
    Upright,
    Italic,
    Lowered,
    Raised,
}

impl Style {
    /// Height of its letters [mm].
    pub(crate) fn size(self, letters: Letters) -> f64 {
        POINT
            * match self {
                Self::Upright | Self::Italic => letters.size,
                Self::Lowered | Self::Raised => f64::max(0.72 * letters.size, SMALLEST_LETTERS),
            }
    }

    /// How far its letters stand above the line [mm].
    pub(crate) fn raised(self, letters: Letters) -> f64 {
        let part = match self {
            Self::Upright | Self::Italic => 0.0,
            Self::Lowered => -LOWERED,
            Self::Raised => RAISED,
        };
        part * letters.size * POINT
    }
}

/// Words on a sheet.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Label {
    parts: Vec<(Style, String)>,
}

impl Label {
    /// The text as it is; control characters are left out.
    pub fn plain(text: &str) -> Self {
        let text: String = text.chars().filter(|letter| !letter.is_control()).collect();
        Self { parts: if text.is_empty() { Vec::new() } else { vec![(Style::Upright, text)] } }
    }

    /// A text in which `*p*` is italic, `_{max}` lowered and `^{3}` raised.
    pub fn marked(text: &str) -> Self {
        let mut parts: Vec<(Style, String)> = Vec::new();
        let mut style = Style::Upright;
        let mut letters = text.chars().filter(|letter| !letter.is_control()).peekable();
        while let Some(letter) = letters.next() {
            let next = match (letter, style, letters.peek()) {
                ('*', Style::Italic, _) => Style::Upright,
                ('*', Style::Upright, _) => Style::Italic,
                ('_', Style::Upright, Some('{')) => Style::Lowered,
                ('^', Style::Upright, Some('{')) => Style::Raised,
                ('}', Style::Lowered | Style::Raised, _) => Style::Upright,
                _ => {
                    match parts.last_mut().filter(|(last, _)| *last == style) {
                        Some((_, text)) => text.push(letter),
                        None => parts.push((style, letter.to_string())),
                    }
                    continue;
                }
            };
            if matches!(next, Style::Lowered | Style::Raised) {
                letters.next();
            }
            style = next;
        }
        Self { parts }
    }

    /// True without any letter.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty()
    }

    /// Letters of the label without their style.
    pub fn text(&self) -> String {
        self.parts.iter().map(|(_, text)| text.as_str()).collect()
    }

    /// The label with another one behind it.
    #[must_use]
    pub fn and(mut self, other: Label) -> Self {
        self.parts.extend(other.parts);
        self
    }

    /// Width of the label [mm] in Noto Sans; other typefaces differ by some percent.
    pub fn width(&self, letters: Letters) -> f64 {
        let width = |(style, text): &(Style, String)| style.size(letters) * text.chars().map(advance).sum::<f64>();
        let width: f64 = self.parts.iter().map(width).sum();
        width * if letters.weight == Weight::Bold { BOLD } else { 1.0 }
    }

    /// A plain text cut off with an ellipsis where it is wider than this [mm].
    pub fn fitted(text: &str, letters: Letters, width: f64) -> Self {
        let whole = Self::plain(text);
        if whole.width(letters) <= width {
            return whole;
        }
        let room = width - Self::plain(ELLIPSIS).width(letters);
        let mut used = 0.0;
        let is_within = |letter: &char| {
            used += Self::plain(letter.encode_utf8(&mut [0; 4])).width(letters);
            used <= room
        };
        let short: String = whole.parts.iter().flat_map(|(_, text)| text.chars()).take_while(is_within).collect();
        Self::plain(&format!("{}{ELLIPSIS}", short.trim_end()))
    }

    /// A plain text in lines that are no wider than this [mm], as far as its words are not.
    pub fn wrapped(text: &str, letters: Letters, width: f64) -> Vec<Self> {
        let mut lines: Vec<String> = Vec::new();
        for word in text.split_whitespace() {
            let longer = lines.last().map(|line| format!("{line} {word}"));
            match longer.filter(|line| Self::plain(line).width(letters) <= width) {
                Some(longer) => {
                    lines.pop();
                    lines.push(longer);
                }
                None => lines.push(word.to_owned()),
            }
        }
        lines.iter().map(|line| Self::plain(line)).collect()
    }

    /// Parts of the label, each in one style.
    pub(crate) fn parts(&self) -> &[(Style, String)] {
        &self.parts
    }

    /// Sets the letters on a line from 0 on: `put` takes each glyph, its typeface, the length of a unit of that [mm],
    /// how far the letter stands along the line and how far above it [mm]. Returns the length of the line [mm].
    pub(crate) fn set(&self, letters: Letters, mut put: impl FnMut(GlyphId, &Face, f64, [f64; 2])) -> f64 {
        let mut along = 0.0;
        for (style, text) in &self.parts {
            let face = typeface(*style, letters.weight);
            let unit = style.size(letters) / f64::from(face.units_per_em());
            for letter in text.chars() {
                // The first glyph is the box of letters that the typeface lacks.
                let glyph = face.glyph_index(letter).unwrap_or_default();
                put(glyph, face, unit, [along, style.raised(letters)]);
                along += unit * f64::from(face.glyph_hor_advance(glyph).unwrap_or_default());
            }
        }
        along
    }
}

/// The faces of Noto Sans that the program carries; italic letters have no bold ones.
fn typeface(style: Style, weight: Weight) -> &'static Face<'static> {
    static FACES: LazyLock<[Face; 3]> = LazyLock::new(|| {
        [notosans::REGULAR_TTF, notosans::BOLD_TTF, notosans::ITALIC_TTF]
            .map(|font| Face::parse(font, 0).expect("the program carries fonts"))
    });
    match (style, weight) {
        (Style::Italic, _) => &FACES[2],
        (_, Weight::Bold) => &FACES[1],
        (_, Weight::Usual) => &FACES[0],
    }
}

impl From<&str> for Label {
    fn from(text: &str) -> Self {
        Self::plain(text)
    }
}

fn advance(letter: char) -> f64 {
    let known = (letter as usize).checked_sub(32).and_then(|place| ADVANCES.get(place));
    known.map_or(OTHER_ADVANCE, |advance| f64::from(*advance)) / 2048.0
}

/// Weight of letters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Weight {
    Usual,
    Bold,
}

/// How a label is set.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Letters {
    pub(crate) size: f64,
    pub(crate) colour: Colour,
    pub(crate) weight: Weight,
    /// A white line around the letters, so that they can be read on colours.
    pub(crate) halo: f64,
}

impl Default for Letters {
    fn default() -> Self {
        Self { size: LETTERS, colour: INK, weight: Weight::Usual, halo: 0.0 }
    }
}

impl Letters {
    /// Letters of this height [points]; none is smaller than [`SMALLEST_LETTERS`].
    pub fn sized(size: f64) -> Self {
        Self { size: size.max(SMALLEST_LETTERS), ..Self::default() }
    }

    /// The letters in this colour.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        Self { colour, ..self }
    }

    /// The letters in bold type.
    #[must_use]
    pub fn bold(self) -> Self {
        Self { weight: Weight::Bold, ..self }
    }

    /// The letters with a white line of half a millimetre around them.
    #[must_use]
    pub fn with_halo(self) -> Self {
        Self { halo: 0.7, ..self }
    }

    /// Height of a capital [mm].
    pub fn capital(self) -> f64 {
        0.714 * self.size * POINT
    }

    /// Height of a line [mm].
    pub fn line(self) -> f64 {
        1.35 * self.size * POINT
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_cut_off_or_wrapped() {
        let letters = Letters::default();
        let text = "a text of several words that is too long for its place";
        let short = Label::fitted(text, letters, 30.0);
        assert!(short.width(letters) <= 30.0 && short.text().ends_with('\u{2026}'), "{short:?}");
        assert_eq!(Label::fitted(text, letters, 200.0).text(), text);
        let long = Label::fitted(&"x".repeat(1_000_000), letters, 30.0);
        assert!(long.text().len() < 40 && long.width(letters) <= 30.0, "{long:?}");
        let lines = Label::wrapped(text, letters, 30.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| line.width(letters) <= 30.0));
        assert_eq!(lines.iter().map(Label::text).collect::<Vec<_>>().join(" "), text);
    }

    #[test]
    fn letters_are_no_smaller_than_the_smallest() {
        assert_eq!(Letters::sized(3.0).size, SMALLEST_LETTERS);
        assert!(Label::plain("").is_empty());
    }
}
