//! Lines through places in hundredths of a millimetre: what SVG and PNG both draw.

use std::fmt::Write;

/// Parts of a millimetre in which places are kept.
pub(crate) const PARTS: f64 = 100.0;

/// How lines end.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// The line ends at its last point.
    Open,
    /// The line ends where it began.
    Closed,
}

/// Several lines that end alike.
#[derive(Debug, Clone)]
pub(crate) struct Polylines {
    /// Places of each line, of which there is one at least and no two equal ones follow each other.
    pub(crate) lines: Vec<Vec<[i32; 2]>>,
    pub(crate) end: End,
}

impl Polylines {
    /// Lines through points [mm]; points that fall on the one before are left out.
    pub(crate) fn new<L: IntoIterator<Item = [f64; 2]>>(lines: impl IntoIterator<Item = L>, end: End) -> Self {
        let placed = |line: L| {
            let points = line.into_iter();
            let mut places: Vec<_> = points.map(|point| point.map(|part| (PARTS * part).round() as i32)).collect();
            places.dedup();
            places
        };
        let lines = lines.into_iter().map(placed).filter(|places| !places.is_empty());
        Self { lines: lines.collect(), end }
    }

    /// The attribute `d` of a path, relative and in few letters.
    pub(crate) fn to_svg(&self) -> String {
        let mut text = String::new();
        let mut at = [0; 2];
        for line in &self.lines {
            for (k, place) in line.iter().enumerate() {
                let command = match k {
                    0 if text.is_empty() => "M",
                    0 => "m",
                    1 => "l",
                    _ => "",
                };
                text += command;
                for d in 0..2 {
                    let number = short(i64::from(place[d]) - i64::from(at[d]));
                    if (d == 1 || command.is_empty()) && !number.starts_with('-') {
                        text.push(' ');
                    }
                    text += &number;
                }
                at = *place;
            }
            match self.end {
                End::Closed => {
                    // After closing, the current point is the beginning of what was closed.
                    text.push('z');
                    at = line[0];
                }
                End::Open if line.len() == 1 => text += "h0",
                End::Open => {}
            }
        }
        text
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        let texts = [0, 5, 50, 100, -125, 1230, -3].map(short);
        assert_eq!(texts, ["0", ".05", ".5", "1", "-1.25", "12.3", "-.03"]);
    }

    #[test]
    fn paths_are_relative_and_do_not_drift() {
        let rims = [vec![[1.0, 2.0], [1.004, 2.0], [1.5, 1.0], [0.0, 0.0]], vec![], vec![[1.0, 1.0], [2.0, 1.0]]];
        assert_eq!(Polylines::new(rims, End::Closed).to_svg(), "M1 2l.5-1-1.5-1zm0-1l1 0z");
        let lines = [vec![[1.0, 1.0], [2.0, 1.0]], vec![[f64::NAN, f64::INFINITY]]];
        assert_eq!(Polylines::new(lines, End::Open).to_svg(), "M1 1l1 0m-2 21474835.47h0");
    }
}
