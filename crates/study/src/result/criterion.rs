//! A number that a bearing is judged by: its limits, its error bar, and the verdict.

use oilwedge_reynolds::existence::readable;
use serde::Serialize;

/// What a comparison with a limit has shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The limit is kept.
    Pass,
    /// It is not.
    Fail,
    /// The limit lies inside the error bar, or errors are estimated and that of this number is not known.
    Undecided,
}

impl Verdict {
    /// Its name in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::Undecided => "undecided",
        }
    }
}

/// What a bearing must meet.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Criterion {
    /// What is asked, in words.
    pub what: String,
    /// The value found, in `unit`.
    pub value: f64,
    /// Its error bar, in `unit`; `None`: it was not estimated, or could not be.
    pub bar: Option<f64>,
    /// From which value on it is met; `None`: there is no such bound.
    pub least: Option<f64>,
    /// Up to which value.
    pub most: Option<f64>,
    /// Unit of all four, one that people read.
    pub unit: String,
    /// Whether the bearing is refused where it is not met; else it is only unusual.
    pub decides: bool,
    /// Whether the value meets it, whatever its bar.
    pub is_met: bool,
    /// Whether it is met beyond the error bar.
    pub verdict: Verdict,
}

impl Criterion {
    /// `value` must lie between `least` and `most`; a limit that `decides` is not met by itself. Without a `bar` the value alone decides; an infinite one, of a
    /// number whose error is not known, leaves it open.
    pub fn new(
        what: &str,
        unit: &str,
        (value, bar): (f64, Option<f64>),
        limits: [Option<f64>; 2],
        decides: bool,
    ) -> Self {
        // What is given to a few digits may be off by rounding.
        let room = if decides { -1e-9 } else { 1e-9 } * value.abs();
        let [least, most] = limits.map(|limit| Some(format!("{:.11e}", limit?).parse().unwrap_or(limit?)));
        let is_met = |value: f64| {
            least.is_none_or(|least| value >= least - room) && most.is_none_or(|most| value <= most + room)
        };
        let off = bar.unwrap_or(0.0);
        let verdict = match [value - off, value, value + off].map(is_met) {
            [true, true, true] => Verdict::Pass,
            [false, false, false] => Verdict::Fail,
            _ => Verdict::Undecided,
        };
        Self {
            what: what.to_owned(),
            value,
            bar: bar.filter(|bar| bar.is_finite()),
            least,
            most,
            unit: unit.to_owned(),
            decides,
            is_met: is_met(value),
            verdict,
        }
    }

    /// How it is missed, or left open: `thinnest film below 4 um`, `thinnest film undecided at 4 um`.
    pub fn fault(&self) -> String {
        let (side, bound) = match (self.least, self.most) {
            (Some(least), _) if self.value <= least => ("below", least),
            (_, Some(most)) => ("above", most),
            (least, None) => ("below", least.unwrap_or(self.value)),
        };
        let side = if self.verdict == Verdict::Undecided {
            "undecided at"
        } else {
            side
        };
        format!("{} {side} {} {}", self.what, readable(bound), self.unit)
    }

    /// True if the bearing is refused for it, or may have to be.
    pub fn is_missed(&self) -> bool {
        self.decides && self.verdict != Verdict::Pass
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_limit_inside_the_bar_is_undecided() {
        let film =
            |value: f64, bar: Option<f64>| Criterion::new("thinnest film", "um", (value, bar), [Some(4.0), None], true);
        for (value, bar, verdict) in [
            (4.1, None, Verdict::Pass),
            (4.0, None, Verdict::Fail),
            (3.9, None, Verdict::Fail),
            (4.1, Some(0.05), Verdict::Pass),
            (4.1, Some(0.2), Verdict::Undecided),
            (3.9, Some(0.2), Verdict::Undecided),
            (3.9, Some(0.05), Verdict::Fail),
            (9.9, Some(f64::INFINITY), Verdict::Undecided),
        ] {
            let found = film(value, bar);
            assert_eq!((found.verdict, found.is_met), (verdict, value > 4.0), "{value} {bar:?}");
            assert_eq!(found.is_missed(), verdict != Verdict::Pass);
        }
        assert_eq!(film(3.9, Some(0.2)).fault(), "thinnest film undecided at 4 um");
        assert_eq!(film(3.9, None).fault(), "thinnest film below 4 um");
        let usual = Criterion::new("pressure", "bar", (2.0, Some(1.5)), [Some(1.0), Some(5.0)], false);
        assert!(usual.verdict == Verdict::Undecided && !usual.is_missed());
    }
}
