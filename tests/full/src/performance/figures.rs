//! The figures that the program is to reach, beside what was measured.

use std::path::Path;

use super::clock::{median, median_of, on_threads};
use super::films::{Films, Kind, scene};
use super::machine::Machine;
use super::phase_table::{Column, FILE_TO_LOAD, exponent, milliseconds};
use super::phases;
use super::process::{apart, sweep};
use crate::tables::row;

/// Bytes that the machine for which the figures are told copies a second.
const COPIED: f64 = 10e9;
/// Unknowns of the films that are iterated.
const ITERATED: usize = 100_000;
/// Unknowns of the films whose bars are priced.
const PRICED: [usize; 2] = [10_000, 100_000];
/// Unknowns of the films of a sweep.
const MAPPED: usize = 5_000;
/// Runs of the smallest scene.
const RUNS: usize = 21;

/// Rows `case, figure, measured`.
struct Rows {
    rows: Vec<Vec<String>>,
    /// What seconds of the machine of the figures are here.
    here: f64,
}

impl Rows {
    fn seconds(&mut self, case: &str, figure: f64, measured: f64) {
        let goal = figure * self.here;
        self.rows.push(vec![
            case.to_owned(),
            format!("{} ms", milliseconds(figure)),
            format!("{} ms", milliseconds(goal)),
            format!("{} ms", milliseconds(measured)),
            format!("{:.2}", measured / goal),
        ]);
    }
    fn number(&mut self, case: &str, figure: f64, measured: f64, unit: &str) {
        let told = |x: f64| format!("{x:.2}{unit}");
        self.rows.push(vec![
            case.to_owned(),
            told(figure),
            told(figure),
            told(measured),
            format!("{:.2}", measured / figure),
        ]);
    }
}

/// The table, on sizes of at most `most` unknowns, from columns of the table of paths on one thread and on two.
pub fn rows(
    films: &Films,
    program: &Path,
    machine: &Machine,
    columns: [&[Column]; 2],
    most: usize,
) -> Vec<Vec<String>> {
    let mut rows = Rows {
        rows: vec![row(["case", "figure", "figure here", "measured", "measured / figure"])],
        here: COPIED / machine.copied(),
    };
    let [one, two] = columns;
    let load = |columns: &[Column], near: usize, threads| {
        let column = (columns.iter()).find(|column| (0.7..1.4).contains(&(column.unknowns as f64 / near as f64)))?;
        let timed = column.paths.iter().find(|timed| timed.name == FILE_TO_LOAD)?;
        Some(timed.spent.on(threads))
    };
    for (near, figure) in [(10_000, 0.015), (100_000, 0.14), (1_000_000, 1.4)] {
        if let Some(measured) = load(one, near, 1) {
            rows.seconds(&format!("linear film, {near} unknowns, file to load"), figure, measured);
        }
    }
    if let Some(measured) = load(two, 1_000_000, 2) {
        rows.seconds("the same on two threads, wall, 1000000 unknowns", 0.9, measured);
    }
    if let Some(exponent) = exponent(one, 1) {
        rows.number("growth of file to load from 1e4 unknowns on, exponent", 1.05, exponent, "");
    }
    if most >= ITERATED {
        iterated(&mut rows, films, load(one, ITERATED, 1));
    }
    for unknowns in PRICED.into_iter().filter(|&unknowns| unknowns <= most) {
        eprintln!("figures: price of bars, {unknowns} unknowns");
        for kind in [Kind::Linear, Kind::SwiftStieber] {
            let scene = scene(&films.ring(kind, unknowns));
            let [with, without] =
                [true, false].map(|bars| on_threads(1, || median(3, || phases::whole_run(&scene, bars)).cpu));
            let case = format!("price of bars, {kind:?}, {unknowns} unknowns");
            rows.number(&case, 1.5, with / without - 1.0, "");
        }
    }
    if most >= ITERATED {
        eprintln!("figures: sweep");
        let map = films.map(MAPPED);
        let [one, two] = [1, 2].map(|threads| sweep(program, &map, threads).wall);
        let case = format!("sweep, 1000 loads and speeds, Swift-Stieber, {MAPPED} unknowns, two threads, wall");
        rows.seconds(&case, 10.0, two);
        rows.number("the same on one thread over two, at least", 1.8, one / two, "");
    }
    eprintln!("figures: whole process");
    let plain = films.plain_ring(1000);
    let spent = median_of((0..RUNS).map(|_| apart(program, &plain, 1, false).spent).collect());
    rows.seconds("whole process, plain scene of 1000 unknowns, wall", 0.010, spent.wall);
    rows.seconds("the same, processor", 0.010, spent.cpu);
    if most >= 1_000_000 {
        let peak = apart(program, &films.ring(Kind::Linear, 1_000_000), 1, false).peak;
        rows.number("most memory, linear film, 1000000 unknowns", 450.0, peak as f64 / 1e6, " MB");
    }
    rows.rows
}

/// Films that are iterated, on one thread.
fn iterated(rows: &mut Rows, films: &Films, linear: Option<f64>) {
    let from_file = |kind| {
        eprintln!("figures: {kind:?}");
        let scene = scene(&films.ring(kind, ITERATED));
        on_threads(1, || median(3, || phases::file_to_load(&scene)).cpu)
    };
    if let Some(linear) = linear {
        rows.number("Barus over the linear film, 100000 unknowns", 1.0, from_file(Kind::Barus) / linear, "");
    }
    rows.seconds("Swift-Stieber, 100000 unknowns, file to load", 0.6, from_file(Kind::SwiftStieber));
    eprintln!("figures: jfo");
    let study = phases::study(&scene(&films.grooved_ring(ITERATED)));
    let conserved = on_threads(1, || median(1, || phases::film(&study)).cpu);
    rows.seconds("`jfo`, groove bearing, 100000 unknowns, film from nothing", 6.0, conserved);
}

/// The table of whole processes: `oilwedge solve`, its output included.
pub fn processes(films: &Films, program: &Path, sizes: &[usize]) -> Vec<Vec<String>> {
    let mut rows =
        vec![row(["unknowns", "error bars", "processor, 1 thread [s]", "wall, 2 threads [s]", "most memory [MB]"])];
    for &unknowns in sizes {
        eprintln!("whole process, {unknowns} unknowns");
        let scene = films.ring(Kind::Linear, unknowns);
        for bars in [false, true] {
            let runs = match unknowns {
                0..300_000 => 5,
                _ if bars => 1,
                _ => 3,
            };
            let on = |threads| {
                let runs: Vec<_> = (0..runs).map(|_| apart(program, &scene, threads, bars)).collect();
                let peak = runs.iter().map(|run| run.peak).max().unwrap_or(0);
                (median_of(runs.iter().map(|run| run.spent).collect()), peak)
            };
            let ((one, peak), (two, _)) = (on(1), on(2));
            rows.push(vec![
                unknowns.to_string(),
                if bars { "auto" } else { "none" }.to_owned(),
                format!("{:.3}", one.cpu),
                format!("{:.3}", two.wall),
                format!("{:.0}", peak as f64 / 1e6),
            ]);
        }
    }
    rows
}
