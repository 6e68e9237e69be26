//! A row of the catalogue: all that is known of one quantity.

use std::borrow::Cow;
use std::fmt;

use super::cycle_view::{CycleView, ValueWithBar};
use super::rule::ErrorRule;
use super::unit::Unit;
use super::view::View;
use crate::scope::Scope;

/// Rows as statics: the comment is the definition, then `NAME = "name", "symbol", Unit, "what it is":`, how it is
/// measured, and its error rule; last what else it is, if anything.
macro_rules! rows {
    ($($(#[doc = $definition:literal])+ $id:ident = $name:literal, $symbol:literal, $unit:ident, $what:literal:
        $measure:expr, $error:expr $(, $($also:ident $(($with:expr))?)+)?;)+) => {
        $($(#[doc = $definition])+
        pub static $id: $crate::quantities::Row = $crate::quantities::Row::new(
            [$name, $symbol, $what, concat!($($definition),+)],
            $crate::quantities::Unit::$unit,
            $measure,
            $error,
        )$($(.$also($($with)?))+)?;)+
    };
}

/// How a quantity is measured on a film; one that has no meaning there is absent.
#[derive(Clone, Copy)]
pub enum Measure {
    /// One number.
    One(fn(&View) -> Option<f64>),
    /// A family: one number for each region, by its name.
    Each(fn(&View) -> Vec<(String, f64)>),
    /// One number of a cycle, with its bar where errors are estimated.
    OverCycle(fn(&CycleView) -> Option<ValueWithBar>),
}

/// Table in which people read a quantity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    /// The table of the film.
    Film,
    /// The table of the balance of heat.
    Temperature,
    /// The table of the cap of a connecting rod.
    Cap,
    /// The table of small motions of the journal.
    Dynamics,
}

/// Whether a quantity stands in the first table of a run and in the columns of a short one: its place there, smallest
/// first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Headline {
    /// The quantity stands in no short table.
    Never,
    /// The quantity stands in every short table.
    Always(u8),
    /// The quantity stands in a short table where the position of the journal is given; for a given load it repeats
    /// what the scene says.
    AtPosition(u8),
}

/// One quantity, or a family of them by region.
pub struct Row {
    /// Key in results; that of a family ends with a dot, and the name of the region follows.
    pub name: &'static str,
    /// Symbol, as `W`.
    pub symbol: &'static str,
    /// Unit of value and error.
    pub unit: Unit,
    /// What it is, in a few words.
    pub what: &'static str,
    /// Definition with its formula, and where there is none.
    pub definition: &'static str,
    /// How it is measured.
    pub measure: Measure,
    /// How its error is estimated.
    pub error: ErrorRule,
    /// Table in which the quantity is read.
    pub table: Table,
    /// Whether a mesh may be refined until its bar is small enough.
    pub may_be_tolerance: bool,
    /// Place of the quantity in short tables.
    pub headline: Headline,
    /// Whether a film of this scope may have it.
    pub occurs: fn(&Scope) -> bool,
}

impl Row {
    /// A row that is measured and judged so.
    pub(super) const fn new(
        [name, symbol, what, definition]: [&'static str; 4],
        unit: Unit,
        measure: Measure,
        error: ErrorRule,
    ) -> Self {
        Self {
            name,
            symbol,
            unit,
            what,
            definition: definition.trim_ascii_start(),
            measure,
            error,
            table: Table::Film,
            may_be_tolerance: false,
            headline: Headline::Never,
            occurs: |_| true,
        }
    }

    /// One that may have a tolerance.
    pub(super) const fn tolerance(self) -> Self {
        Self { may_be_tolerance: true, ..self }
    }

    /// One that short tables show.
    pub(super) const fn headline(self, headline: Headline) -> Self {
        Self { headline, ..self }
    }

    /// One of films of certain scopes.
    pub(super) const fn only(self, occurs: fn(&Scope) -> bool) -> Self {
        Self { occurs, ..self }
    }

    /// One of another table than the film's.
    pub(super) const fn in_table(self, table: Table) -> Self {
        Self { table, ..self }
    }

    /// Whether an answer of this scope may have it: a film, or an orbit.
    pub fn may_occur(&self, scope: &Scope) -> bool {
        self.is_of_cycle() == scope.orbit.is_some() && (self.occurs)(scope)
    }

    /// True of a number of a cycle.
    pub fn is_of_cycle(&self) -> bool {
        matches!(self.measure, Measure::OverCycle(_))
    }

    /// True of a family by region.
    pub fn is_family(&self) -> bool {
        self.name.ends_with('.')
    }

    /// True if a quantity of this name belongs to the row.
    pub fn has(&self, name: &str) -> bool {
        match self.is_family() {
            true => name.strip_prefix(self.name).is_some_and(|region| !region.is_empty()),
            false => name == self.name,
        }
    }

    /// Name of the member of a family that belongs to a region.
    pub fn region_name(&self, region: &str) -> Cow<'static, str> {
        format!("{}{region}", self.name).into()
    }

    /// `a - b`; of angles the lesser way round.
    pub fn difference(&self, a: f64, b: f64) -> f64 {
        let difference = a - b;
        match self.unit == Unit::Degree && difference.abs() > 180.0 {
            true => difference - 360f64.copysign(difference),
            false => difference,
        }
    }
}

impl PartialEq for Row {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl fmt::Debug for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Row({})", self.name)
    }
}
