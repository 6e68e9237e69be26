//! The bearings of a crankshaft as sheets: their numbers, and how counterweights are moved.

use oilwedge_scene::wording::millimetres;
use oilwedge_study::quantities::{
    CONTACT_SHARE, CYCLE_CONTACT_SHARE_MAX, CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE,
    CYCLE_LOAD_MAX, CYCLE_POWER_LOSS, CYCLE_PRESSURE_MAX, CYCLE_SIDE_FLOW, CYCLE_TEMPERATURE, FILM_THICKNESS_MIN,
    FRICTION_POWER, LOAD, LOAD_ANGLE, PRESSURE_MAX, Row, SIDE_FLOW, TEMPERATURE_EFFECTIVE, Unit,
};
use oilwedge_study::result::Geometry;
use oilwedge_study::shaft::{BearingReport, CounterweightReport, ShaftResult};

use crate::criteria;
use crate::readable::readable_unit;
use crate::sheet::{Cell, Sheet, WHOLE_LINE, none, number_as, sized, text, with_bar};

/// Columns of the bearings: heading, and the quantity at rest or over a cycle.
const COLUMNS: [(&str, [&Row; 2]); 8] = [
    GREATEST_LOAD,
    LEAST_FILM,
    ("film least at crank angle", [&LOAD_ANGLE, &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE]),
    GREATEST_PRESSURE,
    MEAN_POWER,
    OIL,
    ("temperature", [&TEMPERATURE_EFFECTIVE, &CYCLE_TEMPERATURE]),
    ("contact", [&CONTACT_SHARE, &CYCLE_CONTACT_SHARE_MAX]),
];
/// Load of a bearing.
pub(crate) const GREATEST_LOAD: (&str, [&Row; 2]) = ("greatest load", [&LOAD, &CYCLE_LOAD_MAX]);
/// Least film of a bearing.
pub(crate) const LEAST_FILM: (&str, [&Row; 2]) = ("least film", [&FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN]);
/// Pressure in a bearing.
pub(crate) const GREATEST_PRESSURE: (&str, [&Row; 2]) = ("greatest pressure", [&PRESSURE_MAX, &CYCLE_PRESSURE_MAX]);
/// Friction of a bearing.
pub(crate) const MEAN_POWER: (&str, [&Row; 2]) = ("mean power", [&FRICTION_POWER, &CYCLE_POWER_LOSS]);
/// Oil of a bearing.
pub(crate) const OIL: (&str, [&Row; 2]) = ("oil", [&SIDE_FLOW, &CYCLE_SIDE_FLOW]);

/// Which of two rows a shaft has: at rest or over a cycle.
pub(crate) fn row_of(result: &ShaftResult, rows: [&'static Row; 2]) -> &'static Row {
    let over_cycle = result.bearings.iter().any(|bearing| bearing.quantity(&CYCLE_LOAD_MAX).is_some());
    rows[usize::from(over_cycle)]
}

/// All bearings, a column each quantity in one unit.
pub(crate) fn bearings(result: &ShaftResult) -> Sheet {
    let mut columns: Vec<(String, &Row, f64)> = Vec::new();
    for (heading, rows) in COLUMNS {
        let row = row_of(result, rows);
        let heading = if row == &LOAD_ANGLE { "load towards" } else { heading };
        let values = result.bearings.iter().filter_map(|bearing| bearing.quantity(row));
        if let Some(most) = values.map(|it| it.value.abs()).reduce(f64::max) {
            let (unit, size) = readable_unit(most, row.unit);
            let comma = if unit.is_empty() { "" } else { ", " };
            columns.push((format!("{heading}{comma}{unit}"), row, size));
        }
    }
    let first = ["bearing", "verdict", "z", "diameter x length", "clearance"].map(str::to_owned);
    let last = ["tilt", "tilt at the ends"].map(str::to_owned);
    let headings = columns.iter().map(|(heading, ..)| heading.clone());
    let header: Vec<_> = first.into_iter().chain(headings).chain(last).collect();
    let cells = |bearing: &BearingReport| {
        let Geometry { radius, length, clearance, .. } = bearing.geometry;
        let tilt = bearing.tilt_max;
        let shape = format!("{} \u{d7} {}", millimetres(2.0 * radius), millimetres(length));
        let mut cells = vec![
            text(bearing.name.as_str()),
            criteria::worst(&bearing.criteria),
            sized(bearing.at, 1e-3, "mm"),
            Cell { kind: WHOLE_LINE, ..text(shape) },
            sized(clearance, 1e-6, "um"),
        ];
        cells.extend(columns.iter().map(|(_, row, size)| match bearing.quantity(row) {
            Some(it) => number_as(it.value, with_bar(it.value, it.error(), *size)),
            None => none(),
        }));
        cells.push(match bearing.tilt_max_error {
            Some(error) if error > 0.0 => number_as(tilt, format!("{} mrad", with_bar(tilt, Some(error), 1e-3))),
            _ => sized(tilt, 1e-3, "mrad"),
        });
        cells.push(sized(tilt * 0.5 * length / clearance, 1e-2, "% of c"));
        cells
    };
    let rows = result.bearings.iter().map(cells).collect();
    // The terminal is narrow: verdicts, shapes and tilts at the ends stand on the page.
    let page_only = vec![1, 3, 4, header.len() - 1];
    Sheet { header, rows, page_only, ..Sheet::default() }
}

/// How the counterweights are moved.
pub(crate) fn counterweights(found: &CounterweightReport) -> Sheet {
    let rows = found.webs.iter().map(|web| {
        let [before, after] = web.moment.map(|moment| sized(moment, 1e-3, "kg mm"));
        let [from, to] = web.angle_deg.map(|angle| sized(angle, 1.0, "deg"));
        vec![text(format!("throw {}, web {}", web.throw, web.web)), before, from, after, to]
    });
    let mut sheet = Sheet::new("counterweights moved", ["web", "before", "angle", "after", "angle"], rows.collect());
    let (unit, size) = readable_unit(1e-6, Unit::Metre);
    for (films, how) in [
        (found.film, "on the films of the scene"),
        (Some(found.film_by_maps), "by maps, the shaft cut and the counterweights moved all the way"),
    ] {
        let [before, after] = films.unwrap_or_default().map(|film| sized(film, size, unit).text);
        let note = format!("Least film of all bearings {how}: {before} before, {after} after.");
        sheet.notes.extend(films.map(|_| note));
    }
    sheet.notes.extend(match found.part {
        0.0 => {
            Some("The counterweights stay: the shaft of the scene fares no better on any part of the way.".to_owned())
        }
        part if part < 1.0 => {
            Some(format!("They are moved {part} of the way: further on the shaft of the scene fares no better."))
        }
        _ => None,
    });
    sheet.notes.push(format!("{} shafts were tried.", found.asked));
    sheet.notes.push(
        "Angles are from the throw, in the sense of rotation. Force and moment of the whole shaft stay.".to_owned(),
    );
    sheet
}
