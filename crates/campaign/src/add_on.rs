//! Numbers beside numbers: other answers that stand beside a result, in its file and on the terminal.

use oilwedge_study::quantities::{Quantity, Row};

use crate::records::{Compared, Records};

/// Further answers beside a film: the film without each effect, by other theories, or by a standard.
#[derive(Debug, Clone, PartialEq)]
pub struct AddOn {
    /// One sentence about what is compared.
    pub title: String,
    /// What the film is called here, as `all effects`.
    pub film: &'static str,
    /// The other answers, in their order.
    pub alternatives: Vec<Alternative>,
    /// Further numbers, in lists with a title each.
    pub lists: Vec<(&'static str, Vec<Quantity>)>,
    /// Reasons and conclusions, in sentences.
    pub notes: Vec<String>,
    /// Record of the add-on in the result file.
    pub record: Records,
}

/// One other answer, number beside number.
#[derive(Debug, Clone, PartialEq)]
pub struct Alternative {
    /// Name of the alternative, as `without barus`.
    pub name: String,
    /// Numbers of the alternative beside those of the film; none where there is no answer.
    pub comparisons: Vec<Comparison>,
    /// Wall times of the film and of this answer [s], where they are compared.
    pub seconds: Option<[f64; 2]>,
}

/// One quantity of a film and of another answer.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The quantity.
    pub row: &'static Row,
    /// What the film gives; `None` where it has no such number.
    pub film: Option<Estimate>,
    /// What the other answer gives.
    pub other: Option<Estimate>,
}

/// A value and half the width of its error bar, where there is one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The value, in the unit of its quantity.
    pub value: f64,
    /// Half the width of its error bar.
    pub error: Option<f64>,
}

impl From<&Quantity> for Estimate {
    fn from(quantity: &Quantity) -> Self {
        Self { value: quantity.value, error: quantity.error() }
    }
}

impl Comparison {
    /// A quantity of the film beside that of another answer; `None` where neither has it.
    pub fn between(film: Option<&Quantity>, other: Option<&Quantity>) -> Option<Self> {
        Some(Self { row: film.or(other)?.row, film: film.map(Estimate::from), other: other.map(Estimate::from) })
    }

    /// The film's value less the other one; of angles the shorter way round.
    pub fn surplus(&self) -> Option<f64> {
        let (film, other) = self.film.zip(self.other)?;
        Some(self.row.difference(film.value, other.value))
    }

    /// The other value less that of the film; of angles the shorter way round.
    pub fn difference(&self) -> Option<f64> {
        let (film, other) = self.film.zip(self.other)?;
        Some(self.row.difference(other.value, film.value))
    }

    /// Half the width of the error bar of the difference, the sum of both; `None` where one is missing.
    pub fn error(&self) -> Option<f64> {
        let (film, other) = self.film.zip(self.other)?;
        Some(film.error? + other.error?)
    }

    /// The entry of a quantity among comparisons.
    pub fn of<'a>(row: &Row, comparisons: &'a [Self]) -> Option<&'a Self> {
        comparisons.iter().find(|it| it.row == row)
    }
}

impl Records {
    /// Records of several add-ons together.
    pub fn of(add_ons: &[AddOn]) -> Self {
        add_ons.iter().map(|it| it.record.clone()).fold(Self::default(), |all, it| Self {
            cost: it.cost.or(all.cost),
            standard: it.standard.or(all.standard),
            theories: it.theories.or(all.theories),
            mobility: it.mobility.or(all.mobility),
        })
    }
}

/// Comparisons as the result file has them: `numbers` of each, by the names of the quantities.
pub(crate) fn by_name<T>(
    comparisons: &[Comparison],
    numbers: impl Fn(&Comparison) -> Option<T>,
) -> Vec<(String, Compared<T>)> {
    let entry = |it: &Comparison| {
        let (symbol, unit) = (it.row.symbol.to_owned(), it.row.unit.name().to_owned());
        Some((it.row.name.to_owned(), Compared { symbol, unit, numbers: numbers(it)? }))
    };
    comparisons.iter().filter_map(entry).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, Bar, LOAD};

    fn quantity(row: &'static Row, value: f64, error: Option<f64>) -> Option<Quantity> {
        Some(Quantity { bar: error.map(Bar::of), ..Quantity::new(row, value) })
    }

    fn between(film: Option<Quantity>, other: Option<Quantity>) -> Comparison {
        Comparison::between(film.as_ref(), other.as_ref()).expect("one of two")
    }

    #[test]
    fn a_difference_has_the_sum_of_both_bars() {
        let load = |value, error| quantity(&LOAD, value, error);
        let it = between(load(12.0, Some(0.5)), load(10.0, Some(0.25)));
        assert_eq!((it.surplus(), it.difference(), it.error()), (Some(2.0), Some(-2.0), Some(0.75)));
        assert_eq!(between(load(12.0, None), load(10.0, Some(0.25))).error(), None);
        let lost = between(load(12.0, Some(0.5)), None);
        assert_eq!((lost.difference(), lost.error()), (None, None));
        assert!(Comparison::between(None, None).is_none());
    }

    #[test]
    fn angles_differ_by_the_shorter_way_round() {
        let angle = |value| quantity(&ATTITUDE_ANGLE, value, None);
        for (film, other, surplus) in
            [(170.0, -170.0, -20.0), (-170.0, 170.0, 20.0), (50.0, 40.0, 10.0), (90.0, -90.0, 180.0)]
        {
            assert_eq!(between(angle(film), angle(other)).surplus(), Some(surplus));
        }
    }
}
