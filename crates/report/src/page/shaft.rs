//! The page of a crankshaft: the shaft, a table of its bearings, their loads and paths side by side, and shafts beside
//! it.

use oilwedge_drawing::PAGE_WIDTH;
use oilwedge_scene::wording::millimetres;
use oilwedge_study::effects::Effects;
use oilwedge_study::orbit::CycleFacts;
use oilwedge_study::quantities::{
    CONTACT_SHARE, CYCLE_CONTACT_SHARE_MAX, CYCLE_FILM_THICKNESS_MIN, CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE,
    CYCLE_LOAD_MAX, CYCLE_POWER_LOSS, CYCLE_PRESSURE_MAX, CYCLE_SIDE_FLOW, CYCLE_TEMPERATURE, FILM_THICKNESS_MIN,
    FRICTION_POWER, LOAD, LOAD_ANGLE, PRESSURE_MAX, Quantity, Row, SIDE_FLOW, TEMPERATURE_EFFECTIVE, Unit,
};
use oilwedge_study::result::{Criterion, Geometry};
use oilwedge_study::shaft::{BearingReport, CounterweightReport, ShaftBalances, ShaftResult, Variant};

use super::quantities::{Shown, shown_unit, with_minus};
use super::table::{Cell, Table, count, number, number_as, sized, text, with_bar};
use super::verdict::{self, Outcome};
use super::{Lead, Page, SceneFile, command, drawn, head, render, tables, texts};
use crate::Error;
use crate::plot::{BENT, SHAFT, shaft_figures};
use crate::readable::readable_unit;
use crate::shaft_view::{ShaftView, ShaftViews};

/// Columns of the bearings: heading, and the quantity at rest or over a cycle.
const COLUMNS: [(&str, [&Row; 2]); 7] = [
    ("greatest load", [&LOAD, &CYCLE_LOAD_MAX]),
    ("least film", [&FILM_THICKNESS_MIN, &CYCLE_FILM_THICKNESS_MIN]),
    ("greatest pressure", [&PRESSURE_MAX, &CYCLE_PRESSURE_MAX]),
    ("mean power", [&FRICTION_POWER, &CYCLE_POWER_LOSS]),
    ("oil", [&SIDE_FLOW, &CYCLE_SIDE_FLOW]),
    ("temperature", [&TEMPERATURE_EFFECTIVE, &CYCLE_TEMPERATURE]),
    ("contact", [&CONTACT_SHARE, &CYCLE_CONTACT_SHARE_MAX]),
];
/// What of two shafts is compared.
const COMPARED: [(&str, [&Row; 2]); 3] = [COLUMNS[0], COLUMNS[1], COLUMNS[2]];

/// The page of a crankshaft and of those beside it with the files that the scene names.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made.
pub fn shaft_page(views: &ShaftViews, files: &[SceneFile]) -> Result<String, Error> {
    let own = &views.own;
    let result = &own.result;
    let criteria = criteria(own);
    let mut page = Page {
        kind: "crankshaft",
        verdict: Outcome::of(&criteria, result.head.status),
        cards: cards(own),
        criteria: verdict::table(&criteria),
        lead: Lead { title: "The shaft", words: words(own), table: bearings(own).if_any(), ..Lead::default() },
        warnings: texts(&result.warnings),
        balances: balances(result),
        tables: [result.counterweights.as_ref().map(moved), cycles(&result.cycles)].into_iter().flatten().collect(),
        timings: tables::timings(&result.timing_s),
        command: command("solve", result.bars),
        ..head(&result.head, &Effects::default(), files)
    };
    page.command.extend(views.beside.iter().map(|(variant, _)| format!(" --{}", variant.name())));
    let compared = views.beside.iter().map(|(variant, other)| compared(own, *variant, other));
    page.tables.splice(0..0, compared);
    for figure in drawn(&shaft_figures(views, PAGE_WIDTH)) {
        match figure.name.as_str() {
            SHAFT | BENT => page.lead.figures.push(figure),
            _ => page.maps.push(figure),
        }
    }
    render(page)
}

/// Which of two rows a shaft has: at rest or over a cycle.
fn row_of(view: &ShaftView, rows: [&'static Row; 2]) -> &'static Row {
    rows[usize::from(!view.courses.is_empty())]
}

/// The bearing that is worst by a row, as a card; `worst` chooses one of two values.
fn cards(view: &ShaftView) -> Vec<Shown> {
    let worst = |(name, rows): (&str, [&'static Row; 2]), sign: f64| {
        let row = row_of(view, rows);
        let value = |it: &&BearingReport| it.quantity(row).map_or(f64::NEG_INFINITY, |it| sign * it.value);
        let bearing = view.bearings().iter().max_by(|a, b| value(a).total_cmp(&value(b)))?;
        let quantity = bearing.quantity(row)?;
        // What the shaft decides has no bar.
        let mut card = Shown::of(quantity, quantity.bar.is_some());
        card.name = format!("{}: {name}", bearing.name);
        Some(card)
    };
    let sum = |rows: [&'static Row; 2], name: &str| {
        let row = row_of(view, rows);
        let numbers = || view.bearings().iter().map(|bearing| bearing.quantity(row));
        let sum: f64 = numbers().map(|number| Some(number?.value)).sum::<Option<f64>>()?;
        // The errors of bearings on one shaft may have one sign.
        let error: Option<f64> = numbers().map(|number| number?.error()).sum();
        let mut card = Shown::number(row, row.name, (sum, error), error.is_some());
        card.name = format!("all bearings: {name}");
        if error.is_none() {
            card.bar = String::new();
        }
        Some(card)
    };
    let all = [
        worst(COLUMNS[1], -1.0),
        worst(COLUMNS[0], 1.0),
        worst(COLUMNS[2], 1.0),
        sum(COLUMNS[3].1, "power loss"),
        sum(COLUMNS[4].1, "oil flow"),
    ];
    all.into_iter().flatten().collect()
}

fn words(view: &ShaftView) -> Vec<String> {
    let Some(scene) = view.scene() else { return Vec::new() };
    let shaft = &scene.crankshaft;
    let bearings = shaft.bearings.len();
    let rpm = shaft.speed.to_degrees() / 6.0;
    let mut words = vec![format!(
        "{} long, {} throws on {bearings} bearings, at {rpm:.0} rpm",
        millimetres(shaft.length()),
        shaft.fires_at().len()
    )];
    words.push(match shaft.statics {
        oilwedge_scene::Statics::Elastic => "shaft and films bear the loads together".to_owned(),
        oilwedge_scene::Statics::Cut => {
            "the shaft is cut at its bearings, which bear what statics gives them".to_owned()
        }
    });
    if !view.courses.is_empty() {
        words.push("x to the cylinders, y a quarter turn later in the sense of rotation; forces are those on the shells' films, and crank angle 0 is that of a throw that fires at 0".to_owned());
    }
    words
}

/// All bearings, a column each quantity in one unit.
fn bearings(view: &ShaftView) -> Table {
    let has_cycle = !view.courses.is_empty();
    let of_rest = COLUMNS.map(|(heading, rows)| (heading, row_of(view, rows)));
    let angle = match has_cycle {
        true => ("film least at crank angle", &CYCLE_FILM_THICKNESS_MIN_CRANK_ANGLE),
        false => ("load towards", &LOAD_ANGLE),
    };
    let mut columns = of_rest.to_vec();
    columns.insert(2, angle);
    let columns: Vec<Column> =
        columns.into_iter().filter_map(|(heading, row)| Column::of(view, heading, row)).collect();
    let first = ["bearing", "verdict", "z", "diameter x length", "clearance"].map(str::to_owned);
    let mut table =
        Table { header: first.into_iter().chain(columns.iter().map(Column::heading)).collect(), ..Table::default() };
    table.header.extend(["tilt", "tilt at the ends"].map(str::to_owned));
    for bearing in view.bearings() {
        let Geometry { radius, length, clearance, .. } = bearing.geometry;
        let tilt = bearing.tilt_max;
        let shape = format!("{} x {}", millimetres(2.0 * radius), millimetres(length));
        let mut cells = vec![
            text(bearing.name.as_str()),
            verdict::cell(&bearing.criteria),
            sized(bearing.at, 1e-3, "mm"),
            Cell { kind: "whole", ..text(shape.replace(" x ", " \u{d7} ")) },
            sized(clearance, 1e-6, "\u{b5}m"),
        ];
        cells.extend(columns.iter().map(|column| column.cell(bearing)));
        cells.push(match bearing.tilt_max_error {
            Some(error) if error > 0.0 => number_as(tilt, format!("{} mrad", with_bar(tilt, Some(error), 1e-3))),
            _ => sized(tilt, 1e-3, "mrad"),
        });
        let at_ends = tilt * 0.5 * length / clearance;
        cells.push(sized(at_ends, 1e-2, "% of c"));
        table.rows.push(cells);
    }
    table
}

/// A quantity of all bearings in one unit.
struct Column {
    heading: &'static str,
    row: &'static Row,
    unit: String,
    size: f64,
}

impl Column {
    /// `None` where no bearing has the quantity.
    fn of(view: &ShaftView, heading: &'static str, row: &'static Row) -> Option<Self> {
        let values = view.bearings().iter().filter_map(|bearing| bearing.quantity(row));
        let most = values.map(|it| it.value.abs()).reduce(f64::max)?;
        let (unit, size) = readable_unit(most, row.unit);
        Some(Self { heading, row, unit: shown_unit(unit), size })
    }

    fn heading(&self) -> String {
        match self.unit.is_empty() {
            true => self.heading.to_owned(),
            false => format!("{}, {}", self.heading, self.unit),
        }
    }

    fn cell(&self, bearing: &BearingReport) -> Cell {
        let shown = |it: &Quantity| number_as(it.value, with_bar(it.value, it.error(), self.size));
        bearing.quantity(self.row).map_or_else(|| text("\u{2013}"), shown)
    }
}

/// Loads and least films of two shafts, and how far the other is off.
fn compared(own: &ShaftView, variant: Variant, other: &ShaftView) -> Table {
    let mut table =
        Table { title: format!("Beside {}", variant.words()), header: vec!["bearing".to_owned()], ..Table::default() };
    let columns: Vec<_> =
        COMPARED.into_iter().filter_map(|(heading, rows)| Column::of(own, heading, row_of(own, rows))).collect();
    for column in &columns {
        let short = variant.name();
        table.header.extend([column.heading(), short.to_owned(), "change".to_owned()]);
    }
    for (bearing, beside) in own.bearings().iter().zip(other.bearings()) {
        let mut cells = vec![text(bearing.name.as_str())];
        for column in &columns {
            let [before, after] = [bearing, beside].map(|it| it.quantity(column.row));
            let change = before.zip(after).map(|(before, after)| after.value / before.value - 1.0);
            cells.extend([column.cell(bearing), column.cell(beside)]);
            cells.push(change.map_or_else(|| text("\u{2013}"), percent));
        }
        table.rows.push(cells);
    }
    if let Some(reason) = &other.result.head.reason {
        table.notes.push(format!("Of {}: {reason}", variant.words()));
    }
    if variant == Variant::Cut {
        let note = "A shaft cut at its bearings gives each of them what statics gives, and no tilt.";
        table.notes.push(note.to_owned());
    }
    table
}

/// A relative change with its sign.
fn percent(change: f64) -> Cell {
    number_as(change, with_minus(format!("{:+.1} %", 1e2 * change)))
}

/// What all bearings are judged by, each criterion with the name of its bearing.
fn criteria(view: &ShaftView) -> Vec<Criterion> {
    let of_bearing = |bearing: &BearingReport| {
        let named = |criterion: &Criterion| Criterion {
            what: format!("{}: {}", bearing.name, criterion.what),
            ..criterion.clone()
        };
        bearing.criteria.iter().map(named).collect::<Vec<_>>()
    };
    view.bearings().iter().flat_map(of_bearing).collect()
}

/// How the counterweights are moved.
fn moved(found: &CounterweightReport) -> Table {
    let rows = found.webs.iter().map(|web| {
        let [before, after] = web.moment.map(|moment| sized(moment, 1e-3, "kg\u{b7}mm"));
        let [from, to] = web.angle_deg.map(|angle| sized(angle, 1.0, "\u{b0}"));
        let place = format!("throw {}, web {}", web.throw, web.web);
        vec![text(place), before, from, after, to]
    });
    let mut table = Table::new("Counterweights moved", ["web", "before", "angle", "after", "angle"], rows.collect());
    let (unit, size) = readable_unit(1e-6, Unit::Metre);
    for (films, how) in [
        (found.film, "on the films of the scene"),
        (Some(found.film_by_maps), "by maps, the shaft cut and the counterweights moved all the way"),
    ] {
        let [before, after] = films.unwrap_or_default().map(|film| sized(film, size, &shown_unit(unit)).text);
        let note = format!("Least film of all bearings {how}: {before} before, {after} after.");
        table.notes.extend(films.map(|_| note));
    }
    table.notes.extend(match found.part {
        0.0 => {
            Some("The counterweights stay: the shaft of the scene fares no better on any part of the way.".to_owned())
        }
        part if part < 1.0 => {
            Some(format!("They are moved {part} of the way: further on the shaft of the scene fares no better."))
        }
        _ => None,
    });
    table
        .notes
        .push("Angles from the throw, in the sense of rotation. Force and moment of the whole shaft stay.".to_owned());
    table
}

/// What must vanish, and what was left of it.
fn balances(result: &ShaftResult) -> Table {
    let energies = result.bearings.iter().filter_map(|bearing| bearing.energy);
    let ShaftBalances { force, moment, journals, power, thermal } = result.balances;
    let left = [
        (Some(force), "loads less forces of all films, over the loads, at the worst step"),
        (Some(moment), "their moments, over those of the loads, at the worst step"),
        (Some(journals), "what is left of the equations of all journals, over the loads"),
        (
            power,
            "power of the loads and of what turns the shaft, less what films dissipate and the shaft stores, over the dissipation, at the worst step",
        ),
        (Some(thermal), "power of a film that neither its oil nor its housing takes, over that power"),
    ];
    let known = left.into_iter().filter_map(|(left, what)| Some(vec![text(what), number(left?)]));
    let mut rows: Vec<_> = known.collect();
    rows.extend(energies.reduce(f64::max).map(|energy| {
        let what = "energy of a bearing over the cycle, over its dissipation: the error of the steps";
        vec![text(what), number(energy)]
    }));
    Table::new("", ["balance", "left over"], rows)
}

/// The cycles that were followed.
fn cycles(cycles: &[CycleFacts]) -> Option<Table> {
    let rows = (1..).zip(cycles).map(|(place, it)| {
        vec![count(place), count(it.steps), count(it.rejected), count(it.films), number(it.closure)]
    });
    Table::new(
        "Cycles",
        ["cycle", "steps", "tried in vain", "films of all bearings", "end from its beginning, over c"],
        rows.collect(),
    )
    .if_any()
}
