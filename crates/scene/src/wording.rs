//! Lengths, angles, pressures, forces, temperatures and ratios as sentences give them: six significant digits, no zeros
//! at the end.

use crate::unit::ZERO_CELSIUS;

/// The text without control characters, which could steer a terminal, and characters of direction, which could show a
/// text in another order; each is replaced.
pub fn printable(text: &str) -> String {
    let shown = |letter: char| match letter {
        '\n' => letter,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => REPLACED,
        letter if letter.is_control() => REPLACED,
        letter => letter,
    };
    text.chars().map(shown).collect()
}

/// A title as every file and picture has it: one line that can be shown.
pub(crate) fn title(text: &str) -> String {
    printable(text).replace('\n', " ")
}

/// Stands for a character that is not shown.
const REPLACED: char = '\u{fffd}';

/// A length [m] in millimetres.
pub fn millimetres(metres: f64) -> String {
    format!("{} mm", rounded(1e3 * metres))
}

/// A length [m] in micrometres.
pub fn micrometres(metres: f64) -> String {
    format!("{} um", rounded(1e6 * metres))
}

/// An angle [rad] in degrees.
pub fn degrees(radians: f64) -> String {
    format!("{} deg", rounded(radians.to_degrees()))
}

/// A pressure [Pa] in bar.
pub fn bars(pascals: f64) -> String {
    format!("{} bar", rounded(1e-5 * pascals))
}

/// A force [N] in newtons.
pub fn newtons(force: f64) -> String {
    format!("{} N", rounded(force))
}

/// A temperature [K] in degrees Celsius.
pub fn celsius(temperature: f64) -> String {
    format!("{} C", rounded(temperature - ZERO_CELSIUS))
}

/// A ratio [1] in percent.
pub fn percent(ratio: f64) -> String {
    format!("{} %", rounded(100.0 * ratio))
}

/// A factor with two significant digits.
pub fn factor(value: f64) -> String {
    format!("{}", format!("{value:.1e}").parse().unwrap_or(f64::NAN))
}

/// Six digits; with an exponent where there would be a row of zeros.
fn rounded(value: f64) -> String {
    let value: f64 = format!("{value:.5e}").parse().unwrap_or(f64::NAN);
    if value == 0.0 || (1e-6..1e15).contains(&value.abs()) { value.to_string() } else { format!("{value:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_are_one_line_that_can_be_shown() {
        assert_eq!(title("a\u{202e}b\nc\u{1b}[31m\u{2028}d"), "a\u{fffd}b c\u{fffd}[31m\u{fffd}d");
        assert_eq!(printable("a\n\u{7}"), "a\n\u{fffd}");
    }

    #[test]
    fn no_digit_too_many() {
        assert_eq!(millimetres(0.05625), "56.25 mm");
        assert_eq!(degrees(130f64.to_radians()), "130 deg");
        assert_eq!((bars(98_000.0), bars(-7e3)), ("0.98 bar".into(), "-0.07 bar".into()));
        assert_eq!((newtons(5e3), percent(1e-3)), ("5000 N".into(), "0.1 %".into()));
        assert_eq!((celsius(353.15), celsius(ZERO_CELSIUS)), ("80 C".into(), "0 C".into()));
        assert_eq!((newtons(-1e308), millimetres(0.0)), ("-1e308 N".into(), "0 mm".into()));
    }
}
