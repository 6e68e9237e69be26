//! One HTML file about a run, a sweep or a convergence study, which needs nothing but itself: no request leaves it.
//!
//! Everything is in it without a script: numbers, tables, and the figures of [`crate::plot`]. The script draws the film
//! on canvases (`assets/film.js` unpacks it and finds values, `map.js` draws the unrolled liner and profiles, `view.js`
//! the liner in space, `sweep.js` curves and maps of a sweep). A policy in the page forbids all else:
//! `default-src 'none'`, with the hashes of the script and the style. The same results give the same bytes; what
//! differs from run to run, the wall times, stands in the element `timings`.
//!
//! Reading order: this file (what the page shows), `verdict.rs` (what it says first), `lead.rs` (what comes before all
//! else), `files.rs` (what is saved with the scene), `quantities.rs`, `table.rs` and `tables.rs`, `comparisons.rs`,
//! `studies.rs`, `shaft.rs`, `film_data.rs` and `sweep_data.rs` (what the script draws), `packing.rs`, `coarser.rs` and
//! `thinning.rs` (a film that is too large).

mod coarser;
mod comparisons;
mod files;
mod film_data;
mod lead;
mod packing;
mod quantities;
mod shaft;
mod studies;
mod sweep_data;
mod table;
mod tables;
mod thinning;
mod verdict;

use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use minijinja::Environment;
use minijinja::value::Serde;
use oilwedge_drawing::{Figure, PAGE_WIDTH};
use oilwedge_scene::Scene;
use oilwedge_study::picture::FilmPicture;
use rayon::prelude::*;
use serde::Serialize;
use serde_json::Value;
use sha2::{Digest, Sha256};

use crate::Error;
use crate::orbit_course::OrbitCourse;
use crate::plot::{BALANCE, CONVERGENCE, DrawnFilm, PlotOptions, figures_of_sweep, film_figures};
use crate::sketch::words;
use coarser::coarser;
use files::{SavedFiles, saved};
use film_data::FilmData;
use lead::Lead;
use quantities::{Shown, cards, quantities, simulated};
use sweep_data::SweepData;
use table::Table;
use verdict::Outcome;

pub use files::SceneFile;
pub use shaft::{shaft_page, shaft_page_with};

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
struct Drawn {
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
    criteria: Option<Table>,
    /// What the analysis asks, before all else: figures, and a table.
    lead: Lead,
    simulated: Vec<Told>,
    not_simulated: Vec<String>,
    cards: Vec<Shown>,
    words: Vec<String>,
    section: Option<String>,
    /// Heading of the film that is drawn.
    film_title: String,
    profiles: Option<String>,
    balance: Option<String>,
    maps: Vec<Drawn>,
    notes: Vec<String>,
    film: Option<Interactive>,
    /// A sweep for the script, as JSON.
    cases: Option<String>,
    quantities: Vec<Shown>,
    warnings: Vec<String>,
    balances: Table,
    assumptions: Table,
    tables: Vec<Table>,
    work: Vec<Table>,
    mesh: String,
    timings: Table,
    scene: String,
    /// The files that the scene names.
    files: SavedFiles,
    command: String,
}

/// The page of a film, from the object of `result.json` and, where there is one, the picture of the same run.
///
/// # Errors
/// [`Error::Format`]: the object lacks the shape of the bearing, or the page cannot be made of it.
pub fn film_page(result: &Value, picture: Option<&FilmPicture>) -> Result<String, Error> {
    film_page_with(result, picture, Extras::default())
}

/// [`film_page`] with what it has beside the numbers and the film.
///
/// # Errors
/// Those of [`film_page`].
pub fn film_page_with(result: &Value, picture: Option<&FilmPicture>, extras: Extras) -> Result<String, Error> {
    let quantities = quantities(result);
    let criteria = verdict::criteria_of(result);
    let mut page = Page {
        kind: "film",
        cards: cards(&quantities, result),
        quantities,
        criteria: verdict::table(&criteria),
        film_title: "The film".to_owned(),
        warnings: texts(&result["warnings"]),
        balances: tables::balances(result),
        assumptions: tables::assumptions(result),
        mesh: mesh_in_words(&result["mesh"]),
        work: [tables::levels(result), Some(tables::work(result)), tables::history(result)]
            .into_iter()
            .flatten()
            .collect(),
        tables: comparisons::comparisons(result),
        timings: tables::timings(result),
        ..head(result, extras.files)
    };
    page.verdict = Outcome::of(&criteria, result["status"].as_str().unwrap_or_default());
    page.command = command("solve", result, &["cost", "standard", "theories"]);
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

/// The page of a sweep, from the object of `sweep.json`.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made of it.
pub fn sweep_page(sweep: &Value) -> Result<String, Error> {
    sweep_page_with(sweep, &[])
}

/// [`sweep_page`] with the files that the scene names.
///
/// # Errors
/// Those of [`sweep_page`].
pub fn sweep_page_with(sweep: &Value, files: &[SceneFile]) -> Result<String, Error> {
    let options = PlotOptions { selected: Vec::new(), width: PAGE_WIDTH };
    let figures = figures_of_sweep(sweep, &options).map_err(|unknown| Error::format("page")(unknown.name))?;
    render(Page {
        kind: "sweep",
        status: studies::cases_in_words(sweep),
        verdict: sweep["rows"].as_array().and_then(|rows| Outcome::of_cases(rows)),
        maps: drawn(&figures),
        cases: SweepData::of(sweep).map(|data| embedded(&data)).transpose()?,
        lead: Lead { title: "All cases", table: studies::sweep_rows(sweep), ..Lead::default() },
        command: command("sweep", sweep, &[]),
        ..head(sweep, files)
    })
}

/// The page of a convergence study, from the object of `converge.json` and its picture as SVG, if it has one.
///
/// # Errors
/// [`Error::Format`]: the page cannot be made of it.
pub fn convergence_page(study: &Value, svg: Option<&str>) -> Result<String, Error> {
    let picture = svg
        .filter(|svg| svg.starts_with("<svg"))
        .map(|svg| Drawn { name: CONVERGENCE.to_owned(), svg: svg.to_owned() });
    render(Page {
        kind: "convergence study",
        maps: picture.into_iter().collect(),
        tables: studies::study_levels(study).into_iter().collect(),
        command: command("converge", study, &[]),
        ..head(study, &[])
    })
}

/// What all pages begin with.
fn head(result: &Value, files: &[SceneFile]) -> Page {
    let text = |key: &str| result[key].as_str().unwrap_or_default().to_owned();
    let scene = text("scene");
    let parsed = Scene::parse(&scene, Path::new("scene.toml"), &[]);
    Page {
        title: text("title"),
        version: text("version"),
        sum: text("scene_sha256").chars().take(12).collect(),
        status: text("status").replace('_', " "),
        reason: text("reason"),
        simulated: simulated(result).map(|effect| Told { name: effect.name, sentence: effect.sentence }).collect(),
        not_simulated: texts(&result["effects"]["not_simulated"]),
        words: parsed
            .map(|scene| words(&scene).iter().map(|line| line.replace(" deg", "\u{b0}")).collect())
            .unwrap_or_default(),
        files: saved(&scene, files),
        scene,
        ..Page::default()
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
    for Drawn { name, svg } in figures.map_err(|unknown| Error::format("page")(unknown.name))? {
        match name.as_str() {
            SECTION => page.section = Some(svg),
            PROFILES => page.profiles = Some(svg),
            BALANCE => page.balance = Some(svg),
            MESH if svg.len() > LARGEST_MESH => page.notes.push(format!(
                "The mesh of {} triangles is too fine to be drawn on a page; film.vtu has it.",
                picture.cells.len()
            )),
            _ => page.maps.push(Drawn { name, svg }),
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

fn drawn(figures: &[(String, Figure)]) -> Vec<Drawn> {
    let each = |(name, figure): &(String, Figure)| Drawn { name: name.clone(), svg: figure.to_svg() };
    figures.par_iter().map(each).collect()
}

fn texts(list: &Value) -> Vec<String> {
    let list = list.as_array().into_iter().flatten();
    list.filter_map(Value::as_str).map(str::to_owned).collect()
}

fn mesh_in_words(mesh: &Value) -> String {
    let count = |key: &str| mesh[key].as_u64().unwrap_or_default();
    format!(
        "{} triangles, {} nodes for a pressure of degree {}, smallest angle {:.1}\u{b0}",
        count("cells"),
        count("nodes"),
        count("order"),
        mesh["min_angle_deg"].as_f64().unwrap_or_default()
    )
}

/// The command that gives these results again, for the scene in a file of that name.
fn command(verb: &str, result: &Value, options: &[&str]) -> String {
    let mut command = format!("oilwedge {verb} scene.toml --report");
    if verb == "solve" && result["bars"].as_bool() == Some(false) {
        command += " --bars none";
    }
    for option in options.iter().filter(|option| !result[**option].is_null()) {
        command += &format!(" --{option}");
    }
    command
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
    STANDARD.encode(Sha256::digest(text))
}
