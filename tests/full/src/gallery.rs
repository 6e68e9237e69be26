//! The page `docs/gallery.md`: every shipped scene with its own words, a picture and its main numbers.

use std::path::PathBuf;

use oilwedge_campaign::sweep::Sweep;
use oilwedge_report::digits::{bar, quantity_value};
use oilwedge_report::orbit_course::OrbitCourse;
use oilwedge_report::plot::{DrawnFilm, PlotOptions, figures_of_sweep, film_figures, orbit_figures};
use oilwedge_report::readable::{printed_unit, readable_unit, readable_unit_of};
use oilwedge_report::sweep::{CaseRecord, SweepOptions, SweepReport, SweepResult};
use oilwedge_scene::Scene;
use oilwedge_study::column::Column;
use oilwedge_study::picture::{PictureOptions, Surface};
use oilwedge_study::quantities::Quantity;
use oilwedge_study::result::headlines;
use oilwedge_study::{RunOptions, run};

use crate::tables::{row, written};
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::path;

/// Each scene and what is drawn of it: a field or another picture of its film, `orbit`, or a quantity of its sweep.
pub fn scenes() -> impl Iterator<Item = (&'static str, &'static str)> {
    include_str!("gallery.txt").lines().map(|line| line.split_once(' ').expect("a scene and what is drawn"))
}

/// Width of the pictures [mm].
const WIDTH: f64 = 120.0;
/// Digits of a number without a bar.
const DIGITS: usize = 5;
/// Folder of the pictures, below `docs`.
pub const PICTURES: &str = "images/gallery";

const HEAD: &str = "# Gallery

All scenes of the folder `scenes`, in teaching order: each scene's own words, a picture of what it computes, and its main numbers with their error bars. Solve one with
`oilwedge solve scenes/NAME.toml --open`, or a sweep with `oilwedge sweep scenes/NAME.toml --open`, and look at all of it. Written by
`cargo run --release -p oilwedge-full -- validation gallery`.
";

/// A scene as the page shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Exhibit {
    /// Part of the page for the exhibit.
    pub text: String,
    /// Picture of the exhibit, as SVG.
    pub svg: String,
}

/// The page made of these parts.
pub fn page<'a>(parts: impl IntoIterator<Item = &'a str>) -> String {
    let parts = parts.into_iter().map(|part| format!("\n{part}"));
    HEAD.to_owned() + &parts.collect::<String>()
}

/// File of the picture of a scene.
pub fn picture_file(name: &str) -> PathBuf {
    repository().join("docs").join(PICTURES).join(format!("{name}.svg"))
}

/// Solves and draws a scene.
///
/// # Panics
/// It has no film, or no such picture.
pub fn exhibit(name: &str, picture: &str) -> Exhibit {
    let scene = oilwedge_study::read(&path(name)).unwrap_or_else(|error| panic!("{error}"));
    let (numbers, effects, svg) = match Sweep::of(&scene).expect("good cases") {
        Some(sweep) => of_sweep(&sweep, picture),
        None => of_film(&scene, picture),
    };
    let words = words(&std::fs::read_to_string(path(name)).expect("a scene"));
    let text = format!(
        "## {}\n`scenes/{name}.toml`\n\n{words}\n![{}]({PICTURES}/{name}.svg)\n\n{numbers}\nSimulated: {effects}.\n",
        scene.title, scene.title
    );
    Exhibit { text, svg }
}

/// The comment at the head of a scene: a line for each paragraph, and commands as code.
fn words(scene: &str) -> String {
    let mut words = String::new();
    for line in scene.lines().map_while(|line| line.strip_prefix('#')) {
        match (line.strip_prefix("   "), line.trim()) {
            (Some(command), _) => words += &format!("    {command}\n"),
            (None, "") if words.ends_with('\n') => words.push('\n'),
            (None, "") => words += "\n\n",
            (None, line) if words.is_empty() || words.ends_with('\n') => words += line,
            (None, line) => words += &format!(" {line}"),
        }
    }
    words + "\n"
}

fn options() -> PlotOptions {
    PlotOptions { selected: Vec::new(), width: WIDTH }
}

/// Numbers, effects and picture of a film or an orbit.
fn of_film(scene: &Scene, picture: &str) -> (String, String, String) {
    let options_of_run = RunOptions {
        picture: PictureOptions { surface: Surface::Developed, ..PictureOptions::default() },
        curve: true,
        ..RunOptions::of(scene)
    };
    let run = run(scene, &options_of_run).expect("a mesh");
    let result = &run.result;
    let rows = headlines(&result.quantities, |quantity| quantity.row, &result.effects).into_iter();
    let head = row(["quantity", "symbol", "value", "± error", "unit"]);
    let numbers = written(&[head].into_iter().chain(rows.map(line)).collect::<Vec<_>>());
    let effects = names(result.effects.simulated.iter().map(|effect| effect.name));
    let figures = match (&run.orbit, picture) {
        (Some(orbit), "orbit") => orbit_figures(&scene.title, &OrbitCourse::of_path(orbit), WIDTH),
        _ => {
            let film = DrawnFilm::new(result.clone(), run.picture.as_ref().expect("a film")).expect("a film to draw");
            let selected = vec![picture.to_owned()];
            film_figures(&film, &PlotOptions { selected, ..options() }).expect("such a picture")
        }
    };
    let (_, figure) = figures.first().expect("a picture");
    (numbers, effects, figure.to_svg())
}

fn line(quantity: &Quantity) -> Vec<String> {
    let (unit, size) = readable_unit(quantity.value, quantity.row.unit);
    let [value, error] = shown(quantity.value / size, quantity.error().map(|error| error / size));
    let symbol = format!("`{}`", quantity.row.symbol);
    row([&quantity.name.replace('_', " "), &symbol, &value, &error, &printed_unit(unit)])
}

/// Value and bar as people read them.
fn shown(value: f64, error: Option<f64>) -> [String; 2] {
    let words = match error {
        None => "not resolved".to_owned(),
        Some(0.0) => "exact".to_owned(),
        Some(error) => bar(error),
    };
    [quantity_value(value, error, DIGITS), words]
}

/// Numbers, effects and picture of a sweep.
fn of_sweep(sweep: &Sweep, picture: &str) -> (String, String, String) {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let options_of_run = SweepOptions { case: RunOptions::default(), ..SweepOptions::default() };
    let report = oilwedge_report::sweep::run(sweep, &options_of_run, folder.path(), &mut |_| {}).expect("a sweep");
    let result = SweepResult::from(&report);
    let selected = vec![picture.to_owned()];
    let figures = figures_of_sweep(&result, &PlotOptions { selected, ..options() }).expect("such a picture");
    let (_, figure) = figures.first().expect("a picture");
    let effects = names(report.effects.simulated.iter().map(|effect| effect.name));
    (extremes(&report, &result.rows), effects, figure.to_svg())
}

/// The quantities of a sweep where they are least and greatest: those that the scene asks for, in their units, else the
/// main ones.
fn extremes(report: &SweepReport, cases: &[CaseRecord]) -> String {
    let head = row(["quantity", "symbol", "least", "± error", "greatest", "± error", "unit"]);
    let all = &report.columns.quantities;
    let columns: Vec<&Column> = match report.plan.columns {
        Some(_) => all.iter().collect(),
        None => headlines(all, |column| column.row, &report.effects),
    };
    let rows = columns.into_iter().filter_map(|column| {
        let found = cases.iter().filter_map(|case| case.quantities.get(&*column.name));
        let mut found: Vec<(f64, Option<f64>)> = found.map(|it| (it.value, it.error)).collect();
        found.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let (unit, size) = readable_unit_of(found.last()?.0, &column.unit);
        let [least, greatest] = [found.first()?, found.last()?];
        let [[low, low_bar], [high, high_bar]] =
            [least, greatest].map(|(value, error)| shown(value / size, error.map(|error| error / size)));
        let (name, symbol) = (column.quantity.replace('_', " "), format!("`{}`", column.row.symbol));
        Some(row([&name, &symbol, &low, &low_bar, &high, &high_bar, &printed_unit(unit)]))
    });
    let table: Vec<_> = [head].into_iter().chain(rows).collect();
    format!("{} cases.\n\n{}", cases.len(), written(&table))
}

fn names(effects: impl Iterator<Item = &'static str>) -> String {
    effects.collect::<Vec<_>>().join(", ")
}
