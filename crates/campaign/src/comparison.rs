//! Answers side by side: the numbers of a film, and those of a changed scene, another theory or a standard.
//!
//! [`answer`] solves a changed scene, [`pairs`] puts its numbers beside those of the film, and [`Comparison`] is the
//! table of all of them, which terminal and page show.

use oilwedge_scene::Scene;
use oilwedge_study::quantities::{Quantity, Row};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::run::run;
use oilwedge_study::run_options::RunOptions;

/// Other answers beside a film, with what there is to say about them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Comparison {
    /// One sentence about what is compared; empty where the table needs none.
    pub title: String,
    /// What the film is called here, as `all effects`.
    pub film: String,
    /// The other answers, in their order.
    pub alternatives: Vec<Alternative>,
    /// Further numbers, in lists with a title each.
    pub lists: Vec<(&'static str, Vec<Quantity>)>,
    /// Reasons and conclusions, in sentences.
    pub notes: Vec<String>,
}

/// One other answer, number beside number.
#[derive(Debug, Clone, PartialEq)]
pub struct Alternative {
    /// Name of the alternative, as `without barus`.
    pub name: String,
    /// Numbers of the film beside those of the alternative; none where there is no answer.
    pub pairs: Vec<QuantityPair>,
    /// Wall times of the film and of this answer [s], where they are compared.
    pub seconds: Option<[f64; 2]>,
}

/// One quantity of a film and of another answer, of which at least one has it.
#[derive(Debug, Clone, PartialEq)]
pub struct QuantityPair {
    /// Row of the quantity in the catalogue.
    pub row: &'static Row,
    /// Name of the quantity.
    pub name: String,
    /// What the film gives.
    pub film: Option<Quantity>,
    /// What the other answer gives.
    pub other: Option<Quantity>,
}

impl QuantityPair {
    /// A quantity of the film beside that of another answer; `None` where neither has it.
    pub fn between(film: Option<&Quantity>, other: Option<&Quantity>) -> Option<Self> {
        let one = film.or(other)?;
        Some(Self { row: one.row, name: one.name.to_string(), film: film.cloned(), other: other.cloned() })
    }

    /// Values of the film and of the other answer.
    pub fn values(&self) -> [Option<f64>; 2] {
        [&self.film, &self.other].map(|it| it.as_ref().map(|it| it.value))
    }

    /// The other value less that of the film; of angles the shorter way round.
    pub fn difference(&self) -> Option<f64> {
        let [film, other] = self.values();
        film.zip(other).map(|(film, other)| self.row.difference(other, film))
    }

    /// Half the width of the error bar of the difference, the sum of both; `None` where one is missing.
    pub fn error(&self) -> Option<f64> {
        Some(self.film.as_ref()?.error()? + self.other.as_ref()?.error()?)
    }

    /// Whether the difference is more than its error bar; `None` where it has no bar, or there is no difference.
    pub fn exceeds_bars(&self) -> Option<bool> {
        self.difference().zip(self.error()).map(|(difference, error)| difference.abs() > error)
    }
}

/// The quantities of `rows` of the film beside those of another answer.
pub(crate) fn pairs(rows: &[&'static Row], film: &[Quantity], other: &[Quantity]) -> Vec<QuantityPair> {
    let find = |all: &'_ [Quantity], row: &Row| all.iter().position(|it| it.row == row);
    let pair = |row: &&'static Row| {
        let [film, other] = [film, other].map(|all| find(all, row).map(|place| &all[place]));
        QuantityPair::between(film, other)
    };
    rows.iter().filter_map(pair).collect()
}

/// What a changed scene gives, or why it gives nothing.
pub(crate) struct ChangedRun {
    pub(crate) status: Status,
    pub(crate) reason: Option<String>,
    /// The result, where the scene could be run.
    pub(crate) result: Option<RunResult>,
}

/// Solves a changed scene. A scene that cannot be run has its reason, as one without a film has.
pub(crate) fn answer(scene: &Scene, options: &RunOptions) -> ChangedRun {
    let none = |reason: String| ChangedRun { status: Status::NoSolution, reason: Some(reason), result: None };
    // A journal at rest, for one, carries no oil into a cavity that conserves it.
    if let Some(complaint) = oilwedge_study::complaints(scene).first() {
        return none(complaint.to_string());
    }
    match run(scene, options) {
        Ok(found) => ChangedRun {
            status: found.result.head.status,
            reason: found.result.head.reason.clone(),
            result: Some(found.result),
        },
        Err(error) => none(error.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, Bar, LOAD};

    fn quantity(row: &'static Row, value: f64, error: Option<f64>) -> Option<Quantity> {
        Some(Quantity { bar: error.map(Bar::of), ..Quantity::new(row, value) })
    }

    fn between(film: Option<Quantity>, other: Option<Quantity>) -> QuantityPair {
        QuantityPair::between(film.as_ref(), other.as_ref()).expect("one of two")
    }

    #[test]
    fn a_difference_has_the_sum_of_both_bars() {
        let load = |value, error| quantity(&LOAD, value, error);
        let it = between(load(12.0, Some(0.5)), load(10.0, Some(0.25)));
        assert_eq!((it.difference(), it.error(), it.exceeds_bars()), (Some(-2.0), Some(0.75), Some(true)));
        assert_eq!(between(load(12.0, None), load(10.0, Some(0.25))).exceeds_bars(), None);
        let lost = between(load(12.0, Some(0.5)), None);
        assert_eq!((lost.difference(), lost.error()), (None, None));
        assert!(QuantityPair::between(None, None).is_none());
    }

    #[test]
    fn angles_differ_by_the_shorter_way_round() {
        let angle = |value| quantity(&ATTITUDE_ANGLE, value, None);
        for (film, other, difference) in
            [(170.0, -170.0, 20.0), (-170.0, 170.0, -20.0), (50.0, 40.0, -10.0), (-90.0, 90.0, 180.0)]
        {
            assert_eq!(between(angle(film), angle(other)).difference(), Some(difference));
        }
    }
}
