//! The page of a crankshaft: the shaft, a table of its bearings, their loads and paths side by side, and shafts beside
//! it.

use oilwedge_campaign::shafts;
use oilwedge_drawing::PAGE_WIDTH;
use oilwedge_scene::wording::millimetres;
use oilwedge_study::orbit::CycleFacts;
use oilwedge_study::quantities::Row;
use oilwedge_study::shaft::BearingReport;

use super::quantities::ShownQuantity;
use super::{Lead, Page, SceneFile, drawn, of_run, render};
use crate::Error;
use crate::balances;
use crate::comparison::sheet;
use crate::plot::{BENT, SHAFT, shaft_figures};
use crate::shaft_sheet::{
    GREATEST_LOAD, GREATEST_PRESSURE, LEAST_FILM, MEAN_POWER, OIL, bearings, counterweights, row_of,
};
use crate::shaft_view::{ShaftView, ShaftViews};
use crate::sheet::{Sheet, count, number};

/// The page of a crankshaft and of those beside it with the files that the scene names.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made.
pub fn shaft_page(views: &ShaftViews, files: &[SceneFile]) -> Result<String, Error> {
    let own = &views.own;
    let result = &own.result;
    let mut page = Page {
        kind: "crankshaft",
        cards: cards(own),
        lead: Lead { title: "The shaft", words: words(own), table: bearings(result).if_any(), ..Lead::default() },
        balances: balances::of_shaft(result),
        tables: [result.counterweights.as_ref().map(counterweights), cycles(&result.cycles)]
            .into_iter()
            .flatten()
            .collect(),
        ..of_run(&result.as_one(), files)
    };
    page.command.extend(views.beside.iter().map(|(variant, _)| format!(" --{}", variant.name())));
    let compared = views.beside.iter().map(|(variant, other)| sheet(&shafts(result, *variant, &other.result)));
    page.tables.splice(0..0, compared);
    for figure in drawn(&shaft_figures(views, PAGE_WIDTH)) {
        match figure.name.as_str() {
            SHAFT | BENT => page.lead.figures.push(figure),
            _ => page.maps.push(figure),
        }
    }
    render(page)
}

/// The bearing that is worst by a row, as a card; `worst` chooses one of two values.
fn cards(view: &ShaftView) -> Vec<ShownQuantity> {
    let worst = |(name, rows): (&str, [&'static Row; 2]), sign: f64| {
        let row = row_of(&view.result, rows);
        let value = |it: &&BearingReport| it.quantity(row).map_or(f64::NEG_INFINITY, |it| sign * it.value);
        let bearing = view.bearings().iter().max_by(|a, b| value(a).total_cmp(&value(b)))?;
        let quantity = bearing.quantity(row)?;
        // What the shaft decides has no bar.
        let mut card = ShownQuantity::of(quantity, quantity.bar.is_some());
        card.name = format!("{}: {name}", bearing.name);
        Some(card)
    };
    let sum = |rows: [&'static Row; 2], name: &str| {
        let row = row_of(&view.result, rows);
        let numbers = || view.bearings().iter().map(|bearing| bearing.quantity(row));
        let sum: f64 = numbers().map(|number| Some(number?.value)).sum::<Option<f64>>()?;
        // The errors of bearings on one shaft may have one sign.
        let error: Option<f64> = numbers().map(|number| number?.error()).sum();
        let mut card = ShownQuantity::number(row, row.name, (sum, error), error.is_some());
        card.name = format!("all bearings: {name}");
        if error.is_none() {
            card.bar = String::new();
        }
        Some(card)
    };
    let all = [
        worst(LEAST_FILM, -1.0),
        worst(GREATEST_LOAD, 1.0),
        worst(GREATEST_PRESSURE, 1.0),
        sum(MEAN_POWER.1, "power loss"),
        sum(OIL.1, "oil flow"),
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

/// The cycles that were followed.
fn cycles(cycles: &[CycleFacts]) -> Option<Sheet> {
    let rows = (1..).zip(cycles).map(|(place, it)| {
        vec![count(place), count(it.steps), count(it.rejected), count(it.films), number(it.closure)]
    });
    Sheet::new(
        "Cycles",
        ["cycle", "steps", "tried in vain", "films of all bearings", "end from its beginning, over c"],
        rows.collect(),
    )
    .if_any()
}
