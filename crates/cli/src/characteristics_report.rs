//! The characteristics of a film for people: the sixteen numbers, the film beside the sum of its parts, and the fit.

use crate::readable::{bar, quantity_value, readable_unit, significant};
use oilwedge_campaign::characteristics::fit::{Domain, Fit};
use oilwedge_campaign::characteristics::{Characteristics, ForceAndMoment, JournalFacts, NumberWithBar, Units};
use oilwedge_report::characteristics::FILE;
use oilwedge_report::sheet::{Cell, Sheet, none, numeral, text};
use oilwedge_report::tables::{printable, whole_run};
use oilwedge_study::quantities::Unit;
use std::path::Path;

/// Digits of numbers without a bar.
const DIGITS: usize = 5;

/// Everything about the characteristics of a film.
pub(crate) fn characteristics_report(found: &Characteristics, folder: &Path) -> String {
    let mut parts: Vec<String> = found.journal.as_ref().map(journal).into_iter().collect();
    if let Some(units) = found.units {
        parts.push(sixteen(found, units));
        parts.push(together(found));
    }
    parts.extend(found.fit.as_ref().map(fit));
    whole_run(&found.head, parts, &[format!("written   {}: {FILE}", folder.display())])
}

fn journal(it: &JournalFacts) -> String {
    let number = |value: f64| significant(value, 4);
    let tilt = match [it.gamma_x, it.gamma_y] == [0.0; 2] {
        true => "parallel to the bearing".to_owned(),
        false => format!(
            "tilted by gamma_x = {} along the line of centres and gamma_y = {} across it (slope R/c)",
            number(it.gamma_x),
            number(it.gamma_y)
        ),
    };
    format!(
        "journal   eps = {} towards {} deg, {tilt}\nbearing   B/D = {}, least film {} of the clearance",
        number(it.eccentricity),
        number(it.min_film_angle_deg),
        number(it.slenderness),
        number(it.least_film)
    )
}

/// The sixteen characteristics.
fn sixteen(found: &Characteristics, units: Units) -> String {
    let header = [
        "motion",
        "rate",
        "force along\nS, cos",
        "force across\nS^x, sin",
        "moment along\nS^z, z cos",
        "moment across\nS^y, z sin",
    ];
    let rows = found.parts.iter().map(|part| {
        let cells = four(part.characteristics.as_ref(), |number, _| shown(number, 1.0));
        [text(words(part.part)), text(part.rate_symbol)].into_iter().chain(cells).collect()
    });
    let table = Sheet::new("", header, rows.collect()).terminal();
    format!(
        "characteristics: force and moment for a unit of each rate, each with its own cavity\n{table}\n\
         force = S mu R^2/psi^2 rate = S {} N s rate, moment = S mu R^3/psi^2 rate = S {} N.m.s rate; rates in 1/s, of the sign that they have in the scene\n\
         0 is zero by symmetry; along: line of centres, across: towards growing angles; z from mid-length in radii",
        significant(units.force, 4),
        significant(units.moment, 4)
    )
}

/// What the parts carry at the rates of the scene, their sum, and the film.
fn together(found: &Characteristics) -> String {
    let all = || found.parts.iter().map(|part| part.share).chain([found.sum, found.film]).flatten();
    let greatest = |numbers: [usize; 2]| {
        let values = all().flat_map(|it| numbers.map(|k| it.numbers()[k].value.abs()));
        values.fold(0.0, f64::max)
    };
    let [force, moment] =
        [([0, 1], Unit::Newton), ([2, 3], Unit::NewtonMetre)].map(|(k, unit)| readable_unit(greatest(k), unit));
    let names = [("force along", force), ("force across", force), ("moment along", moment), ("moment across", moment)];
    let header = names.map(|(name, (unit, _))| format!("{name}\n{unit}"));
    let header = ["this film".to_owned(), "rate\n1/s".to_owned()].into_iter().chain(header);
    let cells = |carried: Option<&ForceAndMoment>| four(carried, |number, k| shown(number, names[k].1.1));
    let parts = found.parts.iter().map(|part| (words(part.part), significant(part.rate, 4), part.share));
    let sums = [("sum of the parts", found.sum), ("film", found.film)];
    let sums = sums.map(|(name, carried)| (name.to_owned(), String::new(), carried));
    let rows = parts
        .chain(sums)
        .map(|(name, rate, carried)| [text(name), numeral(rate)].into_iter().chain(cells(carried.as_ref())).collect());
    let table = Sheet { header: header.collect(), rows: rows.collect(), ..Sheet::default() }.terminal();
    let stronger = found.surplus().map(|ratio| {
        format!(
            "\nthe sum of the parts carries {} of the load of the film, whose motions share one cavity",
            times(ratio)
        )
    });
    format!("{table}{}", stronger.unwrap_or_default())
}

/// A ratio near one in percent.
fn times(ratio: f64) -> String {
    match ratio < 10.0 {
        true => format!("{} %", significant(100.0 * ratio, 4)),
        false => format!("{} times", significant(ratio, 3)),
    }
}

fn four(carried: Option<&ForceAndMoment>, cell: impl Fn(NumberWithBar, usize) -> Cell) -> [Cell; 4] {
    match carried {
        Some(carried) => {
            let numbers = carried.numbers();
            [0, 1, 2, 3].map(|k| cell(numbers[k], k))
        }
        None => [(); 4].map(|()| none()),
    }
}

/// A number in a unit of this size; zero by symmetry without a bar.
fn shown(number: NumberWithBar, size: f64) -> Cell {
    let (value, error) = (number.value / size, number.error.map(|error| error / size));
    numeral(match error.filter(|error| *error > 0.0) {
        _ if number.zero_by_symmetry || value == 0.0 => "0".to_owned(),
        Some(error) => format!("{} \u{b1} {}", quantity_value(value, Some(error), DIGITS), bar(error)),
        None => quantity_value(value, None, DIGITS),
    })
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

fn fit(fit: &Fit) -> String {
    let mut parts = vec![format!(
        "fit of a parallel journal: {}\n{} straight bearings, full rings after Swift and Stieber",
        fit.formula,
        fit.grid.len()
    )];
    parts.extend(fit.reason.as_ref().map(|reason| format!("reason: {}", printable(reason))));
    if !fit.rows.is_empty() {
        let header = ["S", "n", "sign", "k0", "k1", "k2", "a0", "a1", "worst in core", "worst"];
        let percent = |error: f64| format!("{} %", significant(100.0 * error, 2));
        let rows = fit.rows.iter().map(|row| {
            let sign = if row.sign < 0.0 { "-" } else { "+" };
            let first = [text(row.name), numeral(row.power.to_string()), numeral(sign)];
            let coefficients = row.coefficients.map(|number| significant(number, 4));
            let last = [row.worst_core, row.worst_wide].map(percent);
            first.into_iter().chain(coefficients.into_iter().chain(last).map(numeral)).collect()
        });
        parts.push(Sheet::new("", header, rows.collect()).terminal());
        let domain = |it: &Domain| {
            let [[eps, to_eps], [b, to_b]] = [it.eccentricity, it.slenderness];
            format!("eps {eps} to {to_eps}, B/D {b} to {to_b}: {} % allowed", 100.0 * it.allowed)
        };
        parts.push(format!("core {}; all {}", domain(&fit.core), domain(&fit.wide)));
    }
    parts.join("\n")
}
