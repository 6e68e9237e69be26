//! A number that a bearing is judged by: its limits, its error bar, and the verdict.

use oilwedge_reynolds::existence::readable;
use serde::{Deserialize, Serialize};

/// What a comparison with a limit has shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The limit is kept.
    Pass,
    /// The limit is not kept.
    Fail,
    /// The limit lies inside the error bar or the spread of the tolerances, or errors are estimated and that of this
    /// number is not known.
    Undecided,
}

impl Verdict {
    /// The worst verdict of those that decide; `None` where the scene sets no limit.
    pub fn of(criteria: &[Criterion]) -> Option<Self> {
        let decide = criteria.iter().filter(|criterion| criterion.decides);
        let rank = |verdict: &Self| [Self::Pass, Self::Undecided, Self::Fail].iter().position(|it| it == verdict);
        decide.map(|criterion| criterion.verdict).max_by_key(rank)
    }

    /// Name of the verdict in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::Undecided => "undecided",
        }
    }
}

/// How well a number that is judged is known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Accuracy {
    /// The error bar, in the unit of the number.
    Within(f64),
    /// Errors are estimated, and that of this number is not known.
    NotResolved,
    /// No error bars were asked for.
    NotAsked,
}

/// Why a verdict stands under reserve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Reserve {
    /// The limit lies inside the error bar.
    InsideBar,
    /// The limit lies inside the spread of the tolerances, and outside of the error bar.
    InsideSpread,
    /// The error of the number is not known.
    NotResolved,
    /// No error bars were asked for: the value alone decides.
    NoBars,
}

/// Who sets a limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Origin {
    /// The scene: the bearing is refused where the limit is not kept.
    #[serde(rename = "scene")]
    Scene,
    /// Nobody: the value is usual, and refuses nothing.
    #[serde(rename = "usual value")]
    Usual,
}

/// What a bearing must meet.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Criterion {
    /// What is asked, in words.
    pub what: String,
    /// The value found, in `unit`.
    pub value: f64,
    /// Error bar of the value, in `unit`; `None`: it was not estimated, or could not be.
    pub bar: Option<f64>,
    /// Value from which on the criterion is met; `None`: there is no such bound.
    pub least: Option<f64>,
    /// Value up to which the criterion is met; `None`: there is no such bound.
    pub most: Option<f64>,
    /// Unit of all four, one that people read.
    pub unit: String,
    /// Who sets the limits.
    pub origin: Origin,
    /// Whether the bearing is refused where it is not met; else it is only unusual.
    pub decides: bool,
    /// Whether the value meets it, whatever its bar.
    pub is_met: bool,
    /// Whether it is met beyond the error bar.
    pub verdict: Verdict,
    /// Why the verdict is no more than that; `None`: it stands without reserve.
    pub reserve: Option<Reserve>,
    /// The tolerances that it is judged with; absent in JSON where the scene has none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub spread: Option<CriterionSpread>,
}

/// How far the tolerances of a scene spread a number that is judged.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CriterionSpread {
    /// Least and greatest value within all tolerances, in the unit of the criterion.
    pub range: [f64; 2],
    /// The key whose tolerance spreads the number most.
    pub most_by: String,
}

impl Criterion {
    /// `value` must lie between `least` and `most`; a limit of the scene is not met by itself. Without bars the value
    /// alone decides; a value whose error is not known leaves it open.
    pub fn new(
        what: &str,
        unit: &str,
        (value, accuracy): (f64, Accuracy),
        limits: [Option<f64>; 2],
        origin: Origin,
    ) -> Self {
        let decides = origin == Origin::Scene;
        let [least, most] = limits.map(|limit| Some(format!("{:.11e}", limit?).parse().unwrap_or(limit?)));
        let bar = match accuracy {
            Accuracy::Within(bar) => Some(bar),
            Accuracy::NotResolved | Accuracy::NotAsked => None,
        };
        let mut criterion = Self {
            what: what.to_owned(),
            value,
            bar,
            least,
            most,
            unit: unit.to_owned(),
            origin,
            decides,
            is_met: false,
            verdict: Verdict::Undecided,
            reserve: None,
            spread: None,
        };
        criterion.is_met = criterion.admits(value);
        criterion.verdict = match accuracy {
            Accuracy::NotResolved => Verdict::Undecided,
            Accuracy::Within(_) | Accuracy::NotAsked => criterion.judged([value; 2]),
        };
        criterion.reserve = match accuracy {
            Accuracy::Within(_) => (criterion.verdict == Verdict::Undecided).then_some(Reserve::InsideBar),
            Accuracy::NotResolved => Some(Reserve::NotResolved),
            Accuracy::NotAsked => Some(Reserve::NoBars),
        };
        criterion
    }

    /// Whether a value meets it.
    fn admits(&self, value: f64) -> bool {
        // What is given to a few digits may be off by rounding.
        let room = if self.decides { -1e-9 } else { 1e-9 } * self.value.abs();
        self.least.is_none_or(|least| value >= least - room) && self.most.is_none_or(|most| value <= most + room)
    }

    /// The verdict on all values between two, each within the error bar.
    fn judged(&self, [low, high]: [f64; 2]) -> Verdict {
        let bar = self.bar.unwrap_or(0.0);
        match [low - bar, self.value, high + bar].map(|value| self.admits(value)) {
            [true, true, true] => Verdict::Pass,
            [false, false, false] => Verdict::Fail,
            _ => Verdict::Undecided,
        }
    }

    /// The criterion judged with what the tolerances of the scene leave open: it passes where all values within them
    /// do, and fails where none does.
    #[must_use]
    pub fn with_spread(self, spread: CriterionSpread) -> Self {
        let verdict = match self.reserve {
            Some(Reserve::NotResolved) => self.verdict,
            _ => self.judged(spread.range),
        };
        let is_new = verdict == Verdict::Undecided && self.verdict != Verdict::Undecided;
        let reserve = if is_new { Some(Reserve::InsideSpread) } else { self.reserve };
        Self { verdict, reserve, spread: Some(spread), ..self }
    }

    /// How it is missed, or left open: `least film below 4 um`, `least film undecided at 4 um`.
    pub fn fault(&self) -> String {
        let (side, bound) = match (self.least, self.most) {
            (Some(least), _) if self.value <= least => ("below", least),
            (_, Some(most)) => ("above", most),
            (least, None) => ("below", least.unwrap_or(self.value)),
        };
        let side = match (self.verdict, self.reserve, &self.spread) {
            (Verdict::Undecided, Some(Reserve::InsideSpread), Some(spread)) => {
                format!("undecided by {} at", spread.most_by)
            }
            (Verdict::Undecided, ..) => "undecided at".to_owned(),
            _ => side.to_owned(),
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
        let film = |value: f64, accuracy| {
            Criterion::new("least film", "um", (value, accuracy), [Some(4.0), None], Origin::Scene)
        };
        let within = Accuracy::Within;
        for (value, accuracy, verdict, reserve) in [
            (4.1, Accuracy::NotAsked, Verdict::Pass, Some(Reserve::NoBars)),
            (4.0, within(0.0), Verdict::Fail, None),
            (3.9, Accuracy::NotAsked, Verdict::Fail, Some(Reserve::NoBars)),
            (4.1, within(0.05), Verdict::Pass, None),
            (4.1, within(0.2), Verdict::Undecided, Some(Reserve::InsideBar)),
            (3.9, within(0.2), Verdict::Undecided, Some(Reserve::InsideBar)),
            (3.9, within(0.05), Verdict::Fail, None),
            (9.9, Accuracy::NotResolved, Verdict::Undecided, Some(Reserve::NotResolved)),
        ] {
            let found = film(value, accuracy);
            assert_eq!((found.verdict, found.reserve), (verdict, reserve), "{value} {accuracy:?}");
            assert_eq!((found.is_met, found.is_missed()), (value > 4.0, verdict != Verdict::Pass));
        }
        assert_eq!(film(3.9, within(0.2)).fault(), "least film undecided at 4 um");
        assert_eq!(film(3.9, within(0.0)).fault(), "least film below 4 um");
    }

    #[test]
    fn a_limit_inside_the_spread_is_undecided_by_its_widest_tolerance() {
        let film = Criterion::new("least film", "um", (4.5, Accuracy::Within(0.1)), [Some(4.0), None], Origin::Scene);
        let within = |range| CriterionSpread { range, most_by: "oil.viscosity".to_owned() };
        for (range, verdict, reserve) in [
            ([4.2, 4.8], Verdict::Pass, None),
            ([4.05, 4.95], Verdict::Undecided, Some(Reserve::InsideSpread)),
            ([3.5, 5.5], Verdict::Undecided, Some(Reserve::InsideSpread)),
        ] {
            let found = film.clone().with_spread(within(range));
            assert_eq!((found.verdict, found.reserve), (verdict, reserve), "{range:?}");
        }
        let open = film.with_spread(within([3.5, 5.5]));
        assert_eq!(open.fault(), "least film undecided by oil.viscosity at 4 um");
    }

    /// What nobody set refuses nothing, and the worst of the others is the verdict.
    #[test]
    fn a_usual_value_decides_nothing() {
        let usual = Criterion::new("pressure", "bar", (2.0, Accuracy::Within(0.1)), [Some(3.0), None], Origin::Usual);
        assert!(usual.verdict == Verdict::Fail && !usual.is_missed());
        let set = |value| Criterion { origin: Origin::Scene, decides: true, verdict: value, ..usual.clone() };
        assert_eq!(Verdict::of(std::slice::from_ref(&usual)), None);
        let all = [usual.clone(), set(Verdict::Pass), set(Verdict::Undecided)];
        assert_eq!(Verdict::of(&all), Some(Verdict::Undecided));
        assert_eq!(Verdict::of(&all[..2]), Some(Verdict::Pass));
    }
}
