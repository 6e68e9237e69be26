//! One HTML file about a run, a sweep or a convergence study, which needs nothing but itself: no request leaves it.
//!
//! Everything is in it without a script: numbers, tables, and the figures of [`crate::plot`]. The script draws the film
//! on canvases (`assets/film.js` unpacks it and finds values, `map.js` draws the unrolled liner and profiles, `view.js`
//! the liner in space, `sweep.js` curves and maps of a sweep). A policy in the page forbids all else:
//! `default-src 'none'`, with the hashes of the script and the style. The same results give the same bytes; what
//! differs from run to run, the wall times, stands in the element `timings`.
//!
//! Reading order: this file (what the page shows), `verdict.rs` (what it says first), `lead.rs` (what comes before all
//! else), `files.rs` (what is saved with the scene), `quantities.rs`, `tables.rs`,
//! `studies.rs`, `shaft.rs`, `film_data.rs` and `sweep_data.rs` (what the script draws), `packing.rs`, `coarser.rs` and
//! `thinning.rs` (a film that is too large).

mod coarser;
mod files;
mod film_data;
mod lead;
mod packing;
mod quantities;
mod shaft;
mod studies;
mod sweep_data;
mod tables;
mod thinning;
mod verdict;

use std::path::Path;

use base64_simd::STANDARD;
use minijinja::Environment;
use minijinja::value::Serde;
use oilwedge_campaign::convergence::ConvergenceReport;
use oilwedge_campaign::{Records, comparisons};
use oilwedge_drawing::{Figure, PAGE_WIDTH};
use oilwedge_scene::Scene;
use oilwedge_study::effects::Effects;
use oilwedge_study::picture::FilmPicture;
use oilwedge_study::result::{ResultHead, RunResult};
use rayon::prelude::*;
use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::Error;
use crate::balances;
use crate::comparison::sheet;
use crate::criteria::criteria_sheet;
use crate::design_sheet::design_sheets;
use crate::orbit_course::OrbitCourse;
use crate::plot::{BALANCE, CONVERGENCE, DrawnFilm, PlotOptions, TOLERANCES, figures_of_sweep, film_figures};
use crate::sheet::Sheet;
use crate::sketch::words;
use crate::spread_sheet::{sensitivity_sheet, spread_sheet};
use crate::sweep::{SWEEP_FORMAT, SweepResult};
use crate::tables::mesh;
use coarser::coarser;
use files::{SavedFiles, saved};
use film_data::FilmData;
use lead::Lead;
use quantities::{ShownQuantity, cards, quantities};
use sweep_data::SweepData;
use verdict::Outcome;

pub use files::SceneFile;
pub use shaft::shaft_page;

/// Name of the page of a film, an orbit or a crankshaft.
pub const PAGE_FILE: &str = "report.html";
/// Name of the page of a sweep.
pub const SWEEP_PAGE_FILE: &str = "sweep.html";
/// Name of the page of a convergence study.
pub const STUDY_PAGE_FILE: &str = "converge.html";
/// Most nodes of a film that the page carries.
pub const MOST_NODES: usize = 100_000;
/// Most bytes of the drawing of a mesh: a finer one is black at the width of a page.
const LARGEST_MESH: usize = 500_000;

const TEMPLATE: &str = include_str!("assets/page.html");
const STYLE: &str = include_str!("assets/report.css");
const SCRIPT: &str = concat!(
    include_str!("assets/film.js"),
    include_str!("assets/map.js"),
    include_str!("assets/view.js"),
    include_str!("assets/sweep.js"),
    include_str!("assets/start.js")
);
/// Figures that stand by themselves; all others are maps of the liner.
const SECTION: &str = "section";
const PROFILES: &str = "profiles";
const MESH: &str = "mesh";

/// A figure on the page.
#[derive(Debug, Serialize)]
struct PageFigure {
    name: String,
    svg: String,
}

/// A field that can be chosen.
#[derive(Debug, Serialize)]
struct Choice {
    name: String,
    label: String,
}

/// The film that the script draws.
#[derive(Debug, Serialize)]
struct Interactive {
    /// JSON.
    data: String,
    choices: Vec<Choice>,
}

/// An effect.
#[derive(Debug, Serialize)]
struct Told {
    name: &'static str,
    sentence: &'static str,
}

/// What a page has beside the numbers and the film.
#[derive(Debug, Clone, Copy, Default)]
pub struct Extras<'a> {
    /// What was compared with the film.
    pub records: Option<&'a Records>,
    /// The path of the journal over a cycle.
    pub course: Option<&'a OrbitCourse>,
    /// The files that the scene names, where they can be read.
    pub files: &'a [SceneFile],
}

/// Everything on the page; what is empty is left out.
#[derive(Debug, Default, Serialize)]
struct Page {
    kind: &'static str,
    title: String,
    version: String,
    sum: String,
    status: String,
    reason: String,
    /// What the header says first.
    verdict: Option<Outcome>,
    criteria: Option<Sheet>,
    /// What the analysis asks, before all else: figures, and a table.
    lead: Lead,
    simulated: Vec<Told>,
    not_simulated: Vec<String>,
    cards: Vec<ShownQuantity>,
    words: Vec<String>,
    section: Option<String>,
    /// Heading of the film that is drawn.
    film_title: String,
    profiles: Option<String>,
    balance: Option<String>,
    tolerances: Option<String>,
    maps: Vec<PageFigure>,
    notes: Vec<String>,
    film: Option<Interactive>,
    /// A sweep for the script, as JSON.
    cases: Option<String>,
    quantities: Vec<ShownQuantity>,
    warnings: Vec<String>,
    balances: Sheet,
    assumptions: Sheet,
    tables: Vec<Sheet>,
    work: Vec<Sheet>,
    mesh: String,
    timings: Sheet,
    scene: String,
    /// The files that the scene names.
    files: SavedFiles,
    command: String,
}

/// The page of a film, from its numbers, where there is one the picture of the same run, and what it has beside them.
///
/// # Errors
/// [`Error::Format`]: the numbers lack the shape of the bearing, or the page cannot be made of them.
pub fn film_page(result: &RunResult, picture: Option<&FilmPicture>, extras: Extras) -> Result<String, Error> {
    let none = Records::default();
    let records = extras.records.unwrap_or(&none);
    let quantities = quantities(result);
    let mut page = Page {
        kind: "film",
        cards: cards(&quantities, &result.effects),
        quantities,
        film_title: "The film".to_owned(),
        balances: balances::of_film(result),
        assumptions: tables::assumptions(result),
        mesh: mesh(&result.mesh).trim_end_matches(" deg").to_owned() + "\u{b0}",
        work: [tables::levels(&result.levels), Some(tables::work(&result.counts)), tables::history(&result.history)]
            .into_iter()
            .flatten()
            .collect(),
        tables: compared(records, result),
        timings: tables::timings_of_film(result, records),
        ..of_run(result, extras.files)
    };
    let options = [
        records.cost.as_ref().map(|_| " --cost"),
        records.standard.as_ref().map(|_| " --standard"),
        records.theories.as_ref().map(|_| " --theories"),
    ];
    page.command.extend(options.into_iter().flatten());
    if let Some(course) = extras.course {
        page.lead = Lead::of_cycle(&page.title, course);
        page.kind = "orbit";
        page.film_title = "The film where it is thinnest in the cycle".to_owned();
    }
    if let Some(picture) = picture {
        add_film(&mut page, DrawnFilm::new(result.clone(), picture)?, picture)?;
    }
    render(page)
}

/// The page of a sweep with the files that the scene names.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made of it.
pub fn sweep_page(sweep: &SweepResult, files: &[SceneFile]) -> Result<String, Error> {
    let options = PlotOptions { selected: Vec::new(), width: PAGE_WIDTH };
    let figures = figures_of_sweep(sweep, &options).map_err(|unknown| Error::format("page")(unknown.name))?;
    let of_scene = [&sweep.identity.title, &sweep.scene, &sweep.identity.scene_sha256].map(String::as_str);
    let of_sweep = ResultHead { version: sweep.identity.version.clone(), ..ResultHead::of(SWEEP_FORMAT, of_scene) };
    render(Page {
        kind: "sweep",
        status: studies::cases_in_words(&sweep.rows),
        verdict: Outcome::of_cases(&sweep.rows),
        maps: drawn(&figures),
        tables: sweep.distribution_sheet().into_iter().collect(),
        cases: SweepData::of(sweep).map(|data| embedded(&data)).transpose()?,
        lead: Lead { title: "All cases", table: studies::sweep_rows(sweep), ..Lead::default() },
        command: command("sweep", true),
        ..head(&of_sweep, &sweep.effects, files)
    })
}

/// The page of a convergence study and its picture as SVG, if it has one.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made of it.
pub fn convergence_page(study: &ConvergenceReport, svg: Option<&str>) -> Result<String, Error> {
    let picture = svg
        .filter(|svg| svg.starts_with("<svg"))
        .map(|svg| PageFigure { name: CONVERGENCE.to_owned(), svg: svg.to_owned() });
    render(Page {
        kind: "convergence study",
        maps: picture.into_iter().collect(),
        tables: studies::study_levels(study).into_iter().collect(),
        command: command("converge", true),
        ..head(&study.head, &study.effects, &[])
    })
}

/// What all pages begin with.
fn head(head: &ResultHead, effects: &Effects, files: &[SceneFile]) -> Page {
    let parsed = Scene::parse(&head.scene, Path::new("scene.toml"), &[]);
    Page {
        title: head.title.clone(),
        version: head.version.clone(),
        sum: head.scene_sha256.chars().take(12).collect(),
        status: head.status.name().replace('_', " "),
        reason: head.reason.clone().unwrap_or_default(),
        simulated: effects.simulated.iter().map(|it| Told { name: it.name, sentence: it.sentence }).collect(),
        not_simulated: effects.not_simulated.iter().map(ToString::to_string).collect(),
        words: parsed
            .map(|scene| words(&scene).iter().map(|line| line.replace(" deg", "\u{b0}")).collect())
            .unwrap_or_default(),
        files: saved(&head.scene, files),
        scene: head.scene.clone(),
        ..Page::default()
    }
}

/// What the page of a run has: verdict, warnings, times.
fn of_run(result: &RunResult, files: &[SceneFile]) -> Page {
    Page {
        verdict: Outcome::of(&result.criteria, result.head.status),
        criteria: criteria_sheet(&result.criteria),
        warnings: result.tail.warnings.iter().map(|warning| warning.text.clone()).collect(),
        timings: tables::timings(&result.tail),
        command: command("solve", result.bars),
        ..head(&result.head, &result.effects, files)
    }
}

/// What the script draws of a film, and what the page says of it.
fn film_data(film: &DrawnFilm, picture: &FilmPicture) -> Result<(FilmData, Option<String>), Error> {
    if picture.points.len() <= MOST_NODES {
        return Ok((FilmData::of(film, picture), None));
    }
    let coarser = coarser(film, picture, MOST_NODES)?;
    let data = FilmData::of(&coarser.film, &coarser.picture);
    Ok((data, Some(coarser.note(picture.points.len()))))
}

fn add_film(page: &mut Page, film: DrawnFilm, picture: &FilmPicture) -> Result<(), Error> {
    let options = PlotOptions { selected: Vec::new(), width: PAGE_WIDTH };
    let (figures, data) =
        rayon::join(|| film_figures(&film, &options).map(|figures| drawn(&figures)), || film_data(&film, picture));
    let (data, note) = data?;
    for PageFigure { name, svg } in figures.map_err(|unknown| Error::format("page")(unknown.name))? {
        match name.as_str() {
            SECTION => page.section = Some(svg),
            PROFILES => page.profiles = Some(svg),
            BALANCE => page.balance = Some(svg),
            TOLERANCES => page.tolerances = Some(svg),
            MESH if svg.len() > LARGEST_MESH => page.notes.push(format!(
                "The mesh of {} triangles is too fine to be drawn on a page; film.vtu has it.",
                picture.cells.len()
            )),
            _ => page.maps.push(PageFigure { name, svg }),
        }
    }
    page.notes.extend(note);
    let choices = data.choices().map(|(name, label)| Choice { name: name.to_owned(), label: label.to_owned() });
    page.film = Some(Interactive { choices: choices.collect(), data: embedded(&data)? });
    Ok(())
}

/// Data as JSON in an element of the page; nothing within ends the element.
fn embedded(data: &impl Serialize) -> Result<String, Error> {
    let json = serde_json::to_string(data).map_err(Error::format("page"))?;
    Ok(json.replace('<', "\\u003c"))
}

fn drawn(figures: &[(String, Figure)]) -> Vec<PageFigure> {
    let each = |(name, figure): &(String, Figure)| PageFigure { name: name.clone(), svg: figure.to_svg() };
    figures.par_iter().map(each).collect()
}

/// A design, what matters among tolerances, how numbers change, and what is compared with the film; times stand among
/// the other times.
fn compared(records: &Records, result: &RunResult) -> Vec<Sheet> {
    let mut all = comparisons(records, result);
    all.iter_mut().flat_map(|it| &mut it.alternatives).for_each(|it| it.seconds = None);
    let beside = [spread_sheet(result), sensitivity_sheet(result)].into_iter().flatten();
    design_sheets(records).into_iter().chain(beside).chain(all.iter().filter_map(|it| sheet(it).if_any())).collect()
}

/// The command that gives these results again, for the scene in a file of that name.
fn command(verb: &str, has_bars: bool) -> String {
    format!("oilwedge {verb} scene.toml --report{}", if has_bars { "" } else { " --bars none" })
}

fn render(page: Page) -> Result<String, Error> {
    #[derive(Serialize)]
    struct Whole<'a> {
        page: Page,
        policy: String,
        style: &'a str,
        script: &'a str,
    }
    let policy = format!(
        "default-src 'none'; script-src 'sha256-{}'; style-src 'sha256-{}'; base-uri 'none'; form-action 'none'",
        hash(SCRIPT),
        hash(STYLE)
    );
    let mut environment = Environment::new();
    environment.add_template("page.html", TEMPLATE).map_err(Error::format("page"))?;
    let template = environment.get_template("page.html").map_err(Error::format("page"))?;
    let whole = Whole { page, policy, style: STYLE, script: SCRIPT };
    let whole = minijinja::Value::from(Serde(whole));
    template.render(whole).map_err(Error::format("page"))
}

/// The hash by which a policy names a text.
fn hash(text: &str) -> String {
    STANDARD.encode_to_string(Sha256::digest(text))
}
