//! What each effect of a scene changes and costs, for people.

use crate::complain::printable;
use crate::readable::{bar, readable_unit, significant, supported};
use crate::terminal::{align_right, table, time};
use oilwedge_campaign::AddOns;
use oilwedge_campaign::cost::{Change, EffectCost};
use oilwedge_study::quantities::{
    ATTITUDE_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN, LOAD, PRESSURE_MAX, Row, SIDE_FLOW,
};
use oilwedge_study::result::RunResult;

/// Smaller changes are nothing [%].
const NOTHING: f64 = 1e-9;
/// Digits of a change without a bar.
const DIGITS: usize = 3;

/// The main quantities in the columns: the first of those that are there.
const COLUMNS: [&[&Row]; 5] = [
    &[&LOAD, &ECCENTRICITY],
    &[&ATTITUDE_ANGLE],
    &[&PRESSURE_MAX],
    &[&FILM_THICKNESS_MIN],
    &[&SIDE_FLOW],
];

/// A table of what each effect changes, and what follows from it; nothing where that was not asked for.
pub(crate) fn cost(result: &RunResult, add_ons: &AddOns) -> Option<String> {
    let costs = add_ons.cost.as_ref()?;
    let Some(first) = costs.first() else {
        return Some("effects   none that could be left out".to_owned());
    };
    let opening = format!(
        "what each effect changes: the result less that without the effect; with all of them a run takes {}",
        time(first.seconds_with)
    );
    let mut lines = vec![opening, changes(costs)];
    lines.extend(conclusions(result, costs));
    Some(lines.join("\n"))
}

fn changes(costs: &[EffectCost]) -> String {
    let is_there = |row: &Row| {
        let mut changes = costs.iter().flat_map(|cost| &cost.changes);
        changes.any(|it| it.quantity == row.name)
    };
    let symbol = |rows: &[&'static Row]| match rows.iter().find(|row| is_there(row)) {
        Some(row) => row.symbol.to_owned(),
        None => rows.iter().map(|row| row.symbol).collect::<Vec<_>>().join(" or "),
    };
    let [main, angle, pressure, thickness, flow] = COLUMNS.map(symbol);
    let mut table = table(["effect", &main, &angle, &pressure, &thickness, &flow, "time without it"]);
    for cost in costs {
        let cells = COLUMNS.map(|rows| {
            let shown = |it: &&Change| rows.iter().any(|row| it.quantity == row.name);
            let change = cost.changes.iter().find(shown);
            change.map_or("-".to_owned(), cell)
        });
        let seconds = match cost.seconds_without {
            0.0 => "-".to_owned(),
            seconds => time(seconds),
        };
        let row = [printable(cost.effect.name)].into_iter().chain(cells).chain([seconds]);
        table.add_row(row);
    }
    (1..=COLUMNS.len() + 1).for_each(|column| align_right(&mut table, column));
    table.to_string()
}

/// The change in percent of the value with all effects; of angles, and where that value is nothing, in their unit.
fn cell(change: &Change) -> String {
    let (Some(with), Some(difference)) = (change.with, change.change) else {
        return if change.with.is_some() {
            "only with it"
        } else {
            "only without it"
        }
        .to_owned();
    };
    let (unit, size) = match change.unit.as_str() {
        "deg" => ("deg", 1.0),
        unit if with == 0.0 => readable_unit(difference, unit),
        _ => ("%", 0.01 * with.abs()),
    };
    let difference = difference / size;
    if difference.abs() < NOTHING {
        return "0".to_owned();
    }
    let number = match change.error.map(|error| error / size) {
        Some(error) if error > NOTHING => format!("{} ± {}", supported(difference, error), bar(error)),
        _ => significant(difference, DIGITS),
    };
    let sign = if difference > 0.0 { "+" } else { "" };
    format!("{sign}{number} {unit}").trim_end().to_owned()
}

fn conclusions(result: &RunResult, costs: &[EffectCost]) -> Vec<String> {
    let names = |answer: Option<bool>| {
        let named = costs.iter().filter(|cost| cost.could_be_left_out == answer);
        named
            .map(|cost| printable(cost.effect.name))
            .collect::<Vec<_>>()
            .join(", ")
    };
    let reasons = costs.iter().filter_map(|cost| {
        let reason = printable(cost.reason.as_ref()?);
        Some(format!(
            "without {} ({}): {reason}",
            printable(cost.effect.name),
            cost.instead
        ))
    });
    let mut lines: Vec<String> = reasons.collect();
    let (idle, open) = (names(Some(true)), names(None));
    if !idle.is_empty() {
        lines.push(format!(
            "could be left out: {idle} (nothing changes beyond the error bars)"
        ));
    }
    if !open.is_empty() {
        lines.push(match result.bars {
            true => format!("not decided: {open} (error bars that could tell are not resolved)"),
            false => "no error bars were estimated, so nothing tells which changes are those of the mesh".to_owned(),
        });
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terminal::run_report;
    use crate::terminal::tests::result;
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::result::Status;
    use std::path::Path;

    fn change(quantity: &str, unit: &str, numbers: [f64; 2], error: Option<f64>) -> Change {
        Change {
            quantity: quantity.into(),
            symbol: String::new(),
            unit: unit.into(),
            with: Some(numbers[0]),
            without: Some(numbers[1]),
            change: Some(numbers[0] - numbers[1]),
            error,
        }
    }

    fn effect(name: &str, changes: Vec<Change>, could_be_left_out: Option<bool>) -> EffectCost {
        EffectCost {
            effect: EFFECTS.iter().find(|effect| effect.name == name).expect("an effect"),
            instead: "nothing",
            status: Status::Converged,
            reason: None,
            changes,
            could_be_left_out,
            seconds_with: 0.030,
            seconds_without: 0.012,
        }
    }

    #[test]
    fn changes_are_told_in_percent_or_degrees() {
        let percent = |with, without, error| cell(&change("load", "N", [with, without], error));
        assert_eq!(percent(200.0, 150.0, None), "+25.0 %");
        assert_eq!(percent(200.0, 250.0, Some(0.4)), "-25.0 ± 0.2 %");
        assert_eq!(percent(200.0, 200.0, Some(0.4)), "0");
        assert_eq!(percent(0.0, 1500.0, None), "-1.50 kN");
        assert_eq!(cell(&change("attitude_angle", "deg", [50.0, 40.0], None)), "+10.0 deg");
        let mut lost = change("attitude_angle", "deg", [50.0, 40.0], None);
        lost.change = None;
        assert_eq!(cell(&lost), "only with it");
    }

    #[test]
    fn what_follows_is_said() {
        let mut result = result();
        let mut add_ons = AddOns::default();
        assert!(cost(&result, &add_ons).is_none());
        let load = |without| vec![change("load", "N", [200.0, without], Some(1.0))];
        let mut hopeless = effect("couette", vec![], Some(false));
        hopeless.reason = Some("nothing carries the oil".into());
        add_ons.cost = Some(vec![
            effect("barus", load(199.5), Some(true)),
            effect("squeeze", load(100.0), Some(false)),
            hopeless,
        ]);
        let text = run_report(&result, &add_ons, Path::new("out"), true);
        let wanted = [
            "with all of them a run takes 30.0 ms",
            "+50.0 ± 0.5 %",
            "12.0 ms",
            "without couette (nothing): nothing carries the oil\n\
             could be left out: barus (nothing changes beyond the error bars)\n",
        ];
        for part in wanted {
            assert!(text.contains(part), "no {part} in\n{text}");
        }
        add_ons.cost = Some(vec![effect("barus", load(199.5), None)]);
        assert!(cost(&result, &add_ons).is_some_and(|text| text.contains("no error bars were estimated")));
        result.bars = true;
        assert!(cost(&result, &add_ons).is_some_and(|text| text.contains("not decided: barus")));
        add_ons.cost = Some(vec![]);
        assert!(cost(&result, &add_ons).is_some_and(|text| text.contains("none that could be left out")));
    }
}
