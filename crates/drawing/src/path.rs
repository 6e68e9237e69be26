//! Paths in few letters: relative places in hundredths of a millimetre.

use std::fmt::Write;

/// Parts of a millimetre in which places are written.
pub(crate) const PARTS: f64 = 100.0;

/// How a path ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// Where its last point is.
    Open,
    /// Where it began.
    Closed,
}

/// The data of a path through several lines.
#[derive(Debug, Default)]
pub(crate) struct PathData {
    text: String,
    at: [i64; 2],
}

impl PathData {
    /// Adds a line through points [mm]; points that fall on the one before are left out.
    pub(crate) fn add(&mut self, points: impl IntoIterator<Item = [f64; 2]>, end: End) {
        let mut points = points
            .into_iter()
            .map(|point| point.map(|part| (PARTS * part).round() as i64));
        let Some(first) = points.next() else { return };
        let command = if self.text.is_empty() { "M" } else { "m" };
        // After closing, the current point is the beginning of what was closed.
        self.step(command, first);
        let mut has_line = false;
        for point in points {
            if point != self.at {
                self.step(if has_line { "" } else { "l" }, point);
                has_line = true;
            }
        }
        if !has_line && end == End::Open {
            self.text += "h0";
        }
        if end == End::Closed {
            self.text += "z";
            self.at = first;
        }
    }

    fn step(&mut self, command: &str, to: [i64; 2]) {
        self.text += command;
        for k in 0..2 {
            let number = short(to[k] - self.at[k]);
            let needs_space = (k == 1 || command.is_empty()) && !number.starts_with('-');
            if needs_space {
                self.text.push(' ');
            }
            self.text += &number;
        }
        self.at = to;
    }

    /// The attribute `d`.
    pub(crate) fn into_text(self) -> String {
        self.text
    }
}

/// Hundredths as a number with as few letters as it needs.
fn short(hundredths: i64) -> String {
    let (whole, part) = (hundredths.abs() / 100, hundredths.abs() % 100);
    let mut text = String::new();
    if hundredths < 0 {
        text.push('-');
    }
    if whole > 0 || part == 0 {
        let _ = write!(text, "{whole}");
    }
    match (part, part % 10) {
        (0, _) => {}
        (_, 0) => {
            let _ = write!(text, ".{}", part / 10);
        }
        _ => {
            let _ = write!(text, ".{part:02}");
        }
    }
    text
}

/// A length as an attribute, to a thousandth of a millimetre.
pub(crate) fn length(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0, 5, 50, 100, -125, 1230, -3].map(short);
        assert_eq!(texts, ["0", ".05", ".5", "1", "-1.25", "12.3", "-.03"]);
        assert_eq!([length(1.0), length(-0.0001), length(0.25)], ["1", "0", "0.25"]);
    }

    #[test]
    fn paths_are_relative_and_do_not_drift() {
        let mut path = PathData::default();
        path.add([[1.0, 2.0], [1.004, 2.0], [1.5, 1.0], [0.0, 0.0]], End::Closed);
        path.add([[1.0, 1.0], [2.0, 1.0]], End::Open);
        assert_eq!(path.into_text(), "M1 2l.5-1-1.5-1zm0-1l1 0");
    }
}
