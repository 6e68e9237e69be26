//! The table of paths: seconds, floor and their ratio, by size.

use std::sync::Arc;

use super::clock::{Spent, median, on_threads};
use super::films::{Films, Kind, scene};
use super::floor::Path;
use super::machine::Machine;
use super::phases;

/// A timed path.
pub struct Timed {
    /// What the page calls it.
    pub name: &'static str,
    /// What it took.
    pub spent: Spent,
    /// Floor of the phase [s].
    pub floor: f64,
}

/// All paths at one size.
pub struct Column {
    /// Unknowns.
    pub unknowns: usize,
    /// The paths, in the order of [`NAMES`], but for those too large here.
    pub paths: Vec<Timed>,
}

/// The paths, in the order of the table.
pub const NAMES: [&str; 13] = [
    "read",
    "draw the mesh",
    "number",
    "order and analyse",
    "assemble",
    "factorise",
    "back-substitute",
    "film",
    "measure",
    FILE_TO_LOAD,
    "cavity (Swift-Stieber)",
    "cavity (`jfo`)",
    "equilibrium",
];
/// The sum of a linear film.
pub const FILE_TO_LOAD: &str = "file to load";

/// Most unknowns of films that are iterated, and of those that conserve oil.
const MOST_ITERATED: usize = 300_000;
const MOST_CONSERVING: usize = 30_000;

/// Times every path on about so many unknowns.
///
/// # Panics
/// If a film has no solution.
pub fn column(films: &Films, unknowns: usize, threads: usize, machine: &Machine) -> Column {
    on_threads(threads, || timed_paths(films, unknowns, threads, machine))
}

fn timed_paths(films: &Films, unknowns: usize, threads: usize, machine: &Machine) -> Column {
    let runs = if unknowns < 300_000 { 5 } else { 3 };
    let ring = scene(&films.ring(Kind::Linear, unknowns));
    let sizes = phases::sizes(&ring);
    let drawn = scene(&films.drawn_ring(unknowns));
    let mut column = Column { unknowns: sizes.rows as usize, paths: Vec::new() };
    let mut add = |name, path, spent| {
        let floor = sizes.floor(path, machine, threads);
        column.paths.push(Timed { name, spent, floor });
    };
    let mesh = Arc::new(phases::mesh(&ring));
    add("read", Path::Read, median(runs, || phases::mesh(&ring)));
    add("draw the mesh", Path::Draw, median(runs.min(3), || phases::mesh(&drawn)));
    add("number", Path::Number, median(runs, || phases::number(&mesh)));
    drop(mesh);
    let study = phases::study(&ring);
    let assembler = &study.system.assembler;
    add("order and analyse", Path::Analyse, median(runs, || phases::analyse(assembler)));
    let analysis = phases::analyse(assembler);
    let mut linear = phases::Linear::of(&study);
    add("assemble", Path::Assemble, median(runs, || phases::assemble(&study, &mut linear)));
    add("factorise", Path::Factorise, median(runs, || phases::factorise(&analysis, &linear)));
    let factor = phases::factorise(&analysis, &linear);
    add("back-substitute", Path::Substitute, median(runs, || phases::substitute(&factor, &linear)));
    drop((factor, linear, analysis));
    add("film", Path::Film, median(runs, || phases::film(&study)));
    let film = phases::film(&study);
    add("measure", Path::Measure, median(runs, || phases::measured(&film)));
    drop((film, study));
    add(FILE_TO_LOAD, Path::FileToLoad, median(runs, || phases::file_to_load(&ring)));
    if unknowns <= MOST_ITERATED {
        let study = phases::study(&scene(&films.ring(Kind::SwiftStieber, unknowns)));
        add("cavity (Swift-Stieber)", Path::Film, median(runs.min(3), || phases::film(&study)));
        let study = phases::study(&scene(&films.ring(Kind::Loaded, unknowns)));
        add("equilibrium", Path::Film, median(runs.min(3), || phases::equilibrium(&study)));
    }
    if unknowns <= MOST_CONSERVING {
        let study = phases::study(&scene(&films.grooved_ring(unknowns)));
        add("cavity (`jfo`)", Path::Film, median(runs.min(3), || phases::film(&study)));
    }
    column
}

/// The table: on one thread the seconds are those of the processor, on more those on the wall.
pub fn rows(columns: &[Column], threads: usize) -> Vec<Vec<String>> {
    let mut head = vec!["path".to_owned()];
    head.extend(columns.iter().map(|column| format!("{} unknowns", column.unknowns)));
    let mut rows = vec![head];
    for name in NAMES {
        let mut row = vec![name.to_owned()];
        row.extend(columns.iter().map(|column| {
            let timed = column.paths.iter().find(|timed| timed.name == name);
            timed.map_or(String::new(), |timed| {
                let seconds = timed.spent.on(threads);
                format!("{} / {} = {:.1}", milliseconds(seconds), milliseconds(timed.floor), seconds / timed.floor)
            })
        }));
        rows.push(row);
    }
    rows
}

/// Three digits of a time, in ms.
pub fn milliseconds(seconds: f64) -> String {
    let ms = 1e3 * seconds;
    let digits = (2 - ms.log10().floor() as i32).clamp(0, 3) as usize;
    format!("{ms:.digits$}")
}

/// The exponent t of `seconds ~ unknowns^t` from file to load, by least squares from 1e4 unknowns on; none from one
/// column.
pub fn exponent(columns: &[Column], threads: usize) -> Option<f64> {
    let points: Vec<[f64; 2]> = (columns.iter().filter(|column| column.unknowns > 7000))
        .filter_map(|column| {
            let timed = column.paths.iter().find(|timed| timed.name == FILE_TO_LOAD)?;
            Some([(column.unknowns as f64).ln(), timed.spent.on(threads).ln()])
        })
        .collect();
    let count = points.len() as f64;
    let mean = |k: usize| points.iter().map(|point| point[k]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let slope = points.iter().map(|point| (point[0] - x) * (point[1] - y)).sum::<f64>();
    let spread = points.iter().map(|point| (point[0] - x).powi(2)).sum::<f64>();
    (points.len() > 1).then(|| slope / spread)
}
