//! Labels: words with italic symbols, indices and exponents, and how wide they are.

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
/// Of other letters [1/2048 of the height].
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
enum Style {
    Upright,
    Italic,
    Lowered,
    Raised,
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
        Self {
            parts: if text.is_empty() {
                Vec::new()
            } else {
                vec![(Style::Upright, text)]
            },
        }
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

    /// Its letters without their style.
    pub fn text(&self) -> String {
        self.parts.iter().map(|(_, text)| text.as_str()).collect()
    }

    /// This label and another one behind it.
    #[must_use]
    pub fn and(mut self, other: Label) -> Self {
        self.parts.extend(other.parts);
        self
    }

    /// Its width [mm] in Noto Sans; other typefaces differ by some percent.
    pub fn width(&self, letters: Letters) -> f64 {
        let width = |(style, text): &(Style, String)| {
            let size = match style {
                Style::Upright | Style::Italic => letters.size,
                Style::Lowered | Style::Raised => small(letters.size),
            };
            size * text.chars().map(advance).sum::<f64>()
        };
        let width: f64 = self.parts.iter().map(width).sum();
        POINT * width * if letters.weight == Weight::Bold { BOLD } else { 1.0 }
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
        let short: String = whole
            .parts
            .iter()
            .flat_map(|(_, text)| text.chars())
            .take_while(is_within)
            .collect();
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

    /// The content of an SVG text element.
    pub(crate) fn to_svg(&self, letters: Letters) -> String {
        let mut svg = String::new();
        let mut shift = 0.0;
        for (style, text) in &self.parts {
            let wanted = match style {
                Style::Upright | Style::Italic => 0.0,
                Style::Lowered => LOWERED,
                Style::Raised => -RAISED,
            } * letters.size
                * POINT;
            let mut attributes = String::new();
            if wanted != shift {
                attributes += &format!(" dy=\"{:.2}\"", wanted - shift);
            }
            match style {
                Style::Upright => {}
                Style::Italic => attributes += " font-style=\"italic\"",
                Style::Lowered | Style::Raised => {
                    attributes += &format!(" font-size=\"{:.3}\"", small(letters.size) * POINT);
                }
            }
            shift = wanted;
            match attributes.is_empty() {
                true => svg += &escaped(text),
                false => svg += &format!("<tspan{attributes}>{}</tspan>", escaped(text)),
            }
        }
        svg
    }
}

impl From<&str> for Label {
    fn from(text: &str) -> Self {
        Self::plain(text)
    }
}

/// Size of indices.
fn small(size: f64) -> f64 {
    f64::max(0.72 * size, SMALLEST_LETTERS)
}

fn advance(letter: char) -> f64 {
    let known = (letter as usize).checked_sub(32).and_then(|place| ADVANCES.get(place));
    known.map_or(OTHER_ADVANCE, |advance| f64::from(*advance)) / 2048.0
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
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
        Self {
            size: LETTERS,
            colour: INK,
            weight: Weight::Usual,
            halo: 0.0,
        }
    }
}

impl Letters {
    /// Letters of this height [points]; none is smaller than [`SMALLEST_LETTERS`].
    pub fn sized(size: f64) -> Self {
        Self {
            size: size.max(SMALLEST_LETTERS),
            ..Self::default()
        }
    }

    /// In this colour.
    #[must_use]
    pub fn coloured(self, colour: Colour) -> Self {
        Self { colour, ..self }
    }

    /// In bold type.
    #[must_use]
    pub fn bold(self) -> Self {
        Self {
            weight: Weight::Bold,
            ..self
        }
    }

    /// With a white line of half a millimetre around them.
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
    fn marks_become_styles() {
        let label = Label::marked("pressure *p*_{max}, 10^{3} Pa & a_b");
        assert_eq!(label.text(), "pressure pmax, 103 Pa & a_b");
        let svg = label.to_svg(Letters::default());
        for part in ["<tspan font-style=\"italic\">p</tspan>", ">max</tspan>", "&amp; a_b"] {
            assert!(svg.contains(part), "{svg}");
        }
        assert_eq!(Label::plain("a *b* \u{1b}").to_svg(Letters::default()), "a *b* ");
        assert!(Label::plain("").is_empty());
    }

    #[test]
    fn long_texts_are_cut_off_or_wrapped() {
        let letters = Letters::default();
        let text = "a text of several words that is too long for its place";
        let short = Label::fitted(text, letters, 30.0);
        assert!(
            short.width(letters) <= 30.0 && short.text().ends_with('\u{2026}'),
            "{short:?}"
        );
        assert_eq!(Label::fitted(text, letters, 200.0).text(), text);
        let long = Label::fitted(&"x".repeat(1_000_000), letters, 30.0);
        assert!(long.text().len() < 40 && long.width(letters) <= 30.0, "{long:?}");
        let lines = Label::wrapped(text, letters, 30.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| line.width(letters) <= 30.0));
        assert_eq!(lines.iter().map(Label::text).collect::<Vec<_>>().join(" "), text);
    }

    #[test]
    fn indices_are_no_smaller_than_the_smallest_letters() {
        let svg = Label::marked("*p*_{max}").to_svg(Letters::sized(7.0));
        assert!(
            svg.contains(&format!("font-size=\"{:.3}\"", SMALLEST_LETTERS * POINT)),
            "{svg}"
        );
        assert_eq!(Letters::sized(3.0).size, SMALLEST_LETTERS);
    }
}
