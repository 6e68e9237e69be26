//! A convergence study for people: a table of levels for each strategy, and the cost of accuracies.

use crate::readable::{readable_unit, significant};
use oilwedge_campaign::convergence::{
    AccuracyMeasure, ConvergenceReport, LevelReport, Price, StrategyLevels, TIME_PARTS,
};
use oilwedge_report::sheet::{Sheet, numeral, text};
use oilwedge_report::tables::{effects, time, whole_run};
use oilwedge_study::quantities::{self, Unit};
use std::path::Path;

/// The least part of the time of a level that has a column; smaller ones are counted among the others.
const SMALL: f64 = 0.02;

/// Everything about a study.
pub(crate) fn convergence_report(report: &ConvergenceReport, folder: &Path) -> String {
    let mut parts = Vec::new();
    if !report.effects.simulated.is_empty() {
        parts.push(effects(&report.effects));
    }
    parts.extend(reference(report));
    for course in report.strategies.iter().filter(|course| !course.levels.is_empty()) {
        let title = format!("{} ({})", course.strategy.name(), course.ended);
        parts.push(Sheet { title, ..levels(course, report) }.terminal());
    }
    let lists = [
        (AccuracyMeasure::Bar, "Cost of accuracy, by error bars"),
        (AccuracyMeasure::Error, "Cost of accuracy, by the true error, which only finer meshes show"),
    ];
    for (measure, title) in lists {
        let list: Vec<&Price> = report.prices.iter().filter(|price| price.measure == measure).collect();
        if !list.is_empty() {
            parts.push(prices(title, &list).terminal());
        }
    }
    let mut lines: Vec<String> = report.notes.clone();
    let without = report.strategies.iter().filter(|course| course.levels.is_empty());
    lines.extend(without.map(|course| format!("{} has no level: {}", course.strategy.name(), course.ended)));
    lines.push(format!("time      {} of {} s", time(report.seconds), report.max_seconds));
    let files = match report.strategies.iter().any(|course| !course.levels.is_empty()) {
        true => "converge.csv, converge.json, converge.svg, converge.png",
        false => "converge.json",
    };
    lines.push(format!("written   {}: {files}", folder.display()));
    whole_run(&report.head, parts, &lines)
}

/// The finest answer.
fn reference(report: &ConvergenceReport) -> Option<String> {
    let reference = report.reference.as_ref()?;
    let (unit, size) = readable_unit(reference.value, unit_of(report));
    let known = match reference.uncertainty {
        Some(known) => format!("known to {}", percent(known)),
        None => "of unknown error".to_owned(),
    };
    Some(format!(
        "finest    {} {} {unit}: {}, level {}, {} unknowns; {known}\n          errors are differences from it, \
         bars are each level's own estimate, both relative; parts of the time in ms",
        report.goal.name,
        significant(reference.value / size, 10),
        reference.strategy.name(),
        reference.level,
        reference.unknowns,
    ))
}

/// Unit of what was studied.
fn unit_of(report: &ConvergenceReport) -> Unit {
    quantities::row(&report.goal.name).map_or(Unit::One, |row| row.unit)
}

fn levels(course: &StrategyLevels, report: &ConvergenceReport) -> Sheet {
    let share = |level: &LevelReport, part: &str| level.seconds.part(part) / level.seconds.total;
    let needed: Vec<&str> = (TIME_PARTS[..TIME_PARTS.len() - 1].iter().copied())
        .filter(|part| course.levels.iter().any(|level| share(level, part) > SMALL))
        .collect();
    let scale = report.reference.as_ref().map_or(1.0, |reference| reference.value);
    let (unit, size) = readable_unit(scale, unit_of(report));
    let value = match unit {
        "" => report.goal.name.clone(),
        unit => format!("{} [{unit}]", report.goal.name),
    };
    let bars = course.levels.iter().any(|level| level.relative_bar.is_some());
    let mut header = vec!["unknowns".to_owned(), value];
    header.extend(bars.then(|| "± bar".to_owned()));
    header.extend(["error", "time", "spread"].map(str::to_owned));
    header.extend(needed.iter().chain(&["other"]).map(|part| (*part).to_owned()));
    let row = |level: &LevelReport| {
        let mut row = vec![level.unknowns.to_string(), significant(level.value / size, 9)];
        row.extend(bars.then(|| level.relative_bar.map_or(String::new(), percent)));
        row.extend([error(level, report), time(level.seconds.total), spread(level)]);
        let shown: Vec<f64> = needed.iter().map(|part| level.seconds.part(part)).collect();
        let other = f64::max(level.seconds.total - shown.iter().sum::<f64>(), 0.0);
        row.extend(shown.into_iter().chain([other]).map(milliseconds));
        row.into_iter().map(numeral).collect()
    };
    Sheet { header, rows: course.levels.iter().map(row).collect(), ..Sheet::default() }
}

/// A time in ms with as many decimals as a clock can give.
fn milliseconds(seconds: f64) -> String {
    match 1e3 * seconds {
        short if short < 9.995 => format!("{short:.2}"),
        short if short < 99.95 => format!("{short:.1}"),
        long => format!("{long:.0}"),
    }
}

/// The error, or what it is known to be below.
fn error(level: &LevelReport, report: &ConvergenceReport) -> String {
    let known = report.reference.as_ref().and_then(|reference| reference.uncertainty);
    match (level.relative_error, known) {
        (Some(error), Some(known)) if error < known => format!("< {}", percent(known)),
        (Some(error), _) => percent(error),
        (None, _) => "finest".to_owned(),
    }
}

/// Half of the range of the runs, and how many there were.
fn spread(level: &LevelReport) -> String {
    let seconds = &level.seconds;
    match seconds.runs {
        1 => "1 run".to_owned(),
        runs => {
            let half = 0.5 * (seconds.greatest - seconds.least) / seconds.total;
            format!("±{:.0} % of {runs}", 100.0 * half)
        }
    }
}

fn prices(title: &str, prices: &[&Price]) -> Sheet {
    let row = |price: &&Price| {
        let about = if price.extrapolated { "~ " } else { "" };
        let beyond = if price.extrapolated { "predicted, not run" } else { "" };
        vec![
            numeral(percent(price.accuracy)),
            numeral(format!("{about}{}", round(price.unknowns))),
            numeral(format!("{about}{}", time(price.seconds))),
            text(price.strategy.name()),
            text(beyond),
        ]
    };
    Sheet::new(title, ["accuracy", "unknowns", "time", "by", ""], prices.iter().map(row).collect())
}

/// A number of unknowns to two digits: no more is known of it between levels.
fn round(unknowns: f64) -> String {
    let size = 10f64.powf(unknowns.log10().floor() - 1.0);
    format!("{:.0}", (unknowns / size).round() * size)
}

/// A relative number in percent, as a power of ten where that is shorter.
fn percent(part: f64) -> String {
    let digits = if (part.log10().round() - part.log10()).abs() < 1e-9 { 1 } else { 2 };
    match part {
        small if small < 0.95e-6 => significant(part, digits),
        part => format!("{} %", significant(100.0 * part, digits)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_parts_are_shown_shortly() {
        assert_eq!(percent(0.01), "1 %");
        assert_eq!(percent(0.1), "10 %");
        assert_eq!(percent(0.0123), "1.2 %");
        assert_eq!(percent(1e-6), "0.0001 %");
        assert_eq!([1.234e-9, 1e-7].map(percent), ["1.2e-9", "1e-7"]);
        assert_eq!(round(12_345.6), "12000");
        assert_eq!([0.000_123_4, 0.012_34, 1.234].map(milliseconds), ["0.12", "12.3", "1234"]);
    }
}
