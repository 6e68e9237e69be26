//! A design for people: its keys, what limits it, and the way of the search as a table of its own.

use std::fmt::Write;

use oilwedge_campaign::Records;
use oilwedge_campaign::design::{DesignEnd, DesignRecord};
use oilwedge_study::quantities::{Unit, row};

use crate::digits::significant;
use crate::readable::{plain_words, readable_unit};
use crate::sheet::{Cell, Sheet, none, number_as, text};

/// File of the films of a search.
pub const DESIGN_FILE: &str = "design.csv";
/// File of the scene with the numbers of the optimum.
pub const OPTIMUM_FILE: &str = "optimum.toml";
/// Digits of numbers in the sheets.
const DIGITS: usize = 5;
/// Digits of what a limit costs.
const COST_DIGITS: usize = 3;

/// The sheets of a design; none without one.
pub(crate) fn design_sheets(records: &Records) -> Vec<Sheet> {
    let Some(found) = &records.design else { return Vec::new() };
    [Some(keys(found)), limits(found), choices(found)].into_iter().flatten().collect()
}

/// Unit of the objective for people, and its size.
fn unit(found: &DesignRecord) -> (&'static str, f64) {
    readable_unit(found.value, row(&found.objective).map_or(Unit::One, |row| row.unit))
}

fn with_unit(number: String, unit: &str) -> String {
    format!("{number} {unit}").trim_end().to_owned()
}

fn numeral(value: f64, unit: &str) -> Cell {
    number_as(value, with_unit(significant(value, DIGITS), unit))
}

fn keys(found: &DesignRecord) -> Sheet {
    let row = |key: &oilwedge_campaign::design::ChosenKey| {
        let [least, most] = key.bounds.map(|bound| significant(bound, DIGITS));
        let bounds = with_unit(format!("{least} to {most}"), &key.unit);
        let place = if key.is_at_bound { "at a bound" } else { "" };
        vec![
            text(key.key.as_str()),
            numeral(key.start, &key.unit),
            numeral(key.optimum, &key.unit),
            text(bounds),
            text(place),
        ]
    };
    let (name, (unit, size)) = (plain_words(&found.objective), unit(found));
    let told = |value: f64| with_unit(significant(value / size, DIGITS), unit);
    let mut notes = vec![match found.end {
        DesignEnd::Optimum => format!("{}: {name} {} from {}", found.sense, told(found.value), told(found.start)),
        DesignEnd::Infeasible => {
            format!(
                "no numbers within the bounds meet all criteria; {name} is {} where they miss least",
                told(found.value)
            )
        }
        DesignEnd::NoFilm => format!(
            "the search ended at {name} {}, for there is no film further on: {}",
            told(found.value),
            found.reason.as_deref().unwrap_or_default()
        ),
        DesignEnd::Limit => {
            format!("the search ended at {name} {} after the most films, before an optimum", told(found.value))
        }
        DesignEnd::NoStep => {
            format!(
                "the search ended at {name} {}, where no step is better although the gradient says so; a finer mesh.size makes films smoother",
                told(found.value)
            )
        }
    }];
    let apart = found.solved.filter(|solved| is_apart(found, *solved) && told(*solved) != told(found.value));
    notes.extend(apart.map(|solved| {
        format!("solved by itself on a mesh of its own the optimum has {name} {}, beyond its error bar", told(solved))
    }));
    let gradients = match found.gradient_films {
        0 => "none for gradients".to_owned(),
        films => format!("{films} more for gradients"),
    };
    notes.push(format!("{} films, {gradients}", found.films));
    let mut sheet =
        Sheet::new("design", ["key", "scene", "optimum", "bounds", ""], found.keys.iter().map(row).collect());
    sheet.notes = notes;
    sheet
}

/// Whether the optimum by itself differs from that of the search by more than its bar.
fn is_apart(found: &DesignRecord, solved: f64) -> bool {
    found.error.is_some_and(|error| (solved - found.value).abs() > error)
}

fn limits(found: &DesignRecord) -> Option<Sheet> {
    let (unit, size) = unit(found);
    let row = |limit: &oilwedge_campaign::design::Constraint| {
        let per = match limit.unit.as_str() {
            "" => unit.to_owned(),
            own => format!("{unit}/{own}"),
        };
        let cost = match limit.cost > 0.0 {
            true => number_as(limit.cost, with_unit(significant(limit.cost / size, COST_DIGITS), &per)),
            false => none(),
        };
        vec![
            text(limit.what.as_str()),
            numeral(limit.value, &limit.unit),
            limit.spread.map_or_else(none, |spread| numeral(spread, &limit.unit)),
            numeral(limit.limit, &limit.unit),
            text(if limit.is_active { "active" } else { "" }),
            cost,
        ]
    };
    let header = ["criterion", "value", "spread", "limit", "", "costs"];
    Sheet::new("what limits the design", header, found.constraints.iter().map(row).collect()).if_any()
}

fn choices(found: &DesignRecord) -> Option<Sheet> {
    let (unit, size) = unit(found);
    let rows = found.choices.iter().map(|choice| {
        let values = choice.values.iter().map(|value| text(value.as_str()));
        let objective = choice.objective;
        let number =
            objective.map_or_else(none, |value| number_as(value, with_unit(significant(value / size, DIGITS), unit)));
        let verdict = match (objective, choice.is_met) {
            (None, _) => "no film",
            (_, true) => "",
            (_, false) => "misses a criterion",
        };
        values.chain([number, text(verdict)]).collect()
    });
    let name = plain_words(&found.objective);
    let header = found.choice_keys.iter().cloned().chain([name, String::new()]).collect();
    Sheet { title: "listed choices".to_owned(), header, rows: rows.collect(), ..Sheet::default() }.if_any()
}

/// The films of the search as CSV: number, keys, objective, criteria, and why there is no film.
pub fn design_csv(found: &DesignRecord) -> String {
    let heading = |name: &str, unit: &str| match unit {
        "" => name.to_owned(),
        unit => format!("{name} [{unit}]"),
    };
    let objective = row(&found.objective).map_or("", |row| row.unit.name());
    let mut columns = vec!["film".to_owned()];
    columns.extend(found.keys.iter().map(|key| heading(&key.key, &key.unit)));
    columns.push(heading(&found.objective, objective));
    columns.extend(found.constraints.iter().map(|it| heading(&it.what, &it.unit)));
    columns.push("reason".to_owned());
    let mut text = columns.join(",") + "\n";
    for (number, point) in (1..).zip(&found.path) {
        let keys = point.keys.iter().map(f64::to_string);
        let objective = point.objective.map_or(String::new(), |value| value.to_string());
        let criteria = (0..found.constraints.len())
            .map(|index| point.constraints.get(index).map_or(String::new(), |it| it.value.to_string()));
        let reason = point.reason.as_deref().unwrap_or_default().replace(['"', '\n', '\r'], " ");
        let cells: Vec<String> = keys.chain([objective]).chain(criteria).collect();
        // A text is written in any case, so that nothing is lost.
        let _ = writeln!(text, "{number},{},\"{reason}\"", cells.join(","));
    }
    text
}
