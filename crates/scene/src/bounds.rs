//! The numbers that a key accepts, as the range of its row says: `> 0`, `0 to 1`, `-60 to 350 C`, `0 < share <= 1`,
//! `whole, 1 to 1000`. What a range says in other words is left to the reader of its key.

use crate::keys::Key;
use crate::unit;

/// Least and greatest number in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    /// The least one and the greatest one.
    pub(crate) ends: [f64; 2],
    /// Whether the end itself is no such number.
    is_open: [bool; 2],
    /// Whether a number must be whole.
    pub(crate) is_whole: bool,
}

impl Bounds {
    /// All numbers.
    pub(crate) const ALL: Self =
        Self { ends: [f64::NEG_INFINITY, f64::INFINITY], is_open: [false; 2], is_whole: false };

    /// The numbers that the row of a key accepts.
    pub(crate) fn of(key: &Key) -> Self {
        key.range.split([',', ';']).fold(Self::ALL, |bounds, clause| bounds.with(key, clause.trim()))
    }

    /// Whether a number is one of them.
    pub(crate) fn hold(&self, value: f64) -> bool {
        let [least, most] = self.ends;
        let is_above = if self.is_open[0] { value > least } else { value >= least };
        let is_below = if self.is_open[1] { value < most } else { value <= most };
        is_above && is_below && !(self.is_whole && value.fract() != 0.0)
    }

    /// Whether they are the numbers above zero.
    pub(crate) fn are_positive(&self) -> bool {
        self.ends[0] == 0.0 && self.is_open[0]
    }

    /// The numbers of which one clause of the range holds too.
    fn with(self, key: &Key, clause: &str) -> Self {
        let words: Vec<&str> = clause.split(' ').collect();
        let unit = |words: &[&str]| words.join(" ");
        let ends = match words[..] {
            ["whole"] => return Self { is_whole: true, ..self },
            [sign @ (">" | ">="), least, ref unit_words @ ..] => {
                [in_si(key, least, &unit(unit_words)).map(|least| (least, sign == ">")), None]
            }
            [sign @ ("<" | "<="), most, ref unit_words @ ..] => {
                [None, in_si(key, most, &unit(unit_words)).map(|most| (most, sign == "<"))]
            }
            [least, below @ ("<" | "<="), _, sign @ ("<" | "<="), most] => {
                [in_si(key, least, "").map(|it| (it, below == "<")), in_si(key, most, "").map(|it| (it, sign == "<"))]
            }
            ["between", least, "and", most] => [least, most].map(|end| in_si(key, end, "").map(|end| (end, true))),
            ["above", least] => [in_si(key, least, "").map(|least| (least, true)), None],
            ["at", "most", most] => [None, in_si(key, most, "").map(|most| (most, false))],
            ["from", least] => [in_si(key, least, "").map(|least| (least, false)), None],
            [.., least, "%", "to", most, "%"] => [least, most].map(|end| in_si(key, end, "%").map(|end| (end, false))),
            [.., least, "to", most] => [least, most].map(|end| in_si(key, end, "").map(|end| (end, false))),
            [least, "to", most, ref unit_words @ ..] => {
                [least, most].map(|end| in_si(key, end, &unit(unit_words)).map(|end| (end, false)))
            }
            _ => [None; 2],
        };
        let mut narrowed = self;
        for (side, end) in ends.into_iter().enumerate() {
            if let Some((end, is_open)) = end {
                (narrowed.ends[side], narrowed.is_open[side]) = (end, is_open);
            }
        }
        narrowed
    }
}

/// The number in SI that counts where a key is not written, as its row says: `0`, `196.2 MPa`; `None` where that is no
/// number.
pub(crate) fn usual(key: &Key) -> Option<f64> {
    let (number, unit) = key.absent.split_once(' ').unwrap_or((key.absent, ""));
    in_si(key, number, unit)
}

/// A number with this unit in SI; `None` where it is none.
fn in_si(key: &Key, number: &str, unit: &str) -> Option<f64> {
    match key.dimension().filter(|_| !unit.is_empty()) {
        Some(dimension) => unit::parse(&format!("{number} {unit}"), dimension).ok(),
        None => number.parse().ok(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::keys;
    use crate::keys::KeyForm;

    fn bounds(path: &str) -> Bounds {
        Bounds::of(keys().find(|key| key.path == path).expect("a key"))
    }

    /// A range with a number that is read as none would accept every number. Ranges that depend on another key, or on
    /// whole numbers of it, are left to the readers of their keys.
    #[test]
    fn no_range_with_numbers_accepts_all() {
        let has_number =
            |key: &&Key| key.forms.iter().any(|form| matches!(form, KeyForm::Number | KeyForm::Quantity(_)));
        let read_as_none =
            |key: &&Key| key.range.contains(|letter: char| letter.is_ascii_digit()) && Bounds::of(key) == Bounds::ALL;
        let found: Vec<&str> = keys().filter(has_number).filter(read_as_none).map(|key| key.path).collect();
        assert_eq!(found, LEFT_TO_READERS, "ranges that are not understood");
    }

    /// Keys whose readers judge their numbers themselves.
    const LEFT_TO_READERS: [&str; 7] = [
        "bearing.arc.to",
        "journal.speed",
        "load.period",
        "oil.vogel.c",
        "cap.bolts.count",
        "crankshaft.period",
        "crankshaft.counterweight.web",
    ];

    #[test]
    fn ranges_are_read() {
        let cases = [
            ("bearing.diameter", [0.0, f64::INFINITY]),
            ("load.force", [0.0, f64::INFINITY]),
            ("heat.inlet", [273.15 - 60.0, 273.15 + 350.0]),
            ("heat.heat_capacity", [5e5, 5e6]),
            ("oil.high_shear", [0.3, 1.0]),
            ("oil.density.expansion", [0.0, 2e-3]),
            ("bore.worn.half_width", [0.0, std::f64::consts::PI]),
            ("orbit.cycles", [1.0, 1000.0]),
            ("load.at", [f64::NEG_INFINITY, f64::INFINITY]),
        ];
        for (path, ends) in cases {
            assert_eq!(bounds(path).ends, ends, "{path}");
        }
        assert!(bounds("load.force").hold(0.0) && !bounds("bearing.diameter").hold(0.0));
        assert!(!bounds("orbit.start.eccentricity").hold(1.0) && bounds("bearing.arc.inlet_fraction").hold(1.0));
        assert!(!bounds("orbit.cycles").hold(1.5) && !bounds("cap.bolts.load_share").hold(0.0));
    }
}
