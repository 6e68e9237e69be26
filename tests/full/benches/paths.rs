//! One benchmark for each structurally different path, by unknowns: `cargo bench -p oilwedge-full [-- PATH]`.
//!
//! Beside each size stands the floor: the bytes that must be moved and the operations that must be done, at the rates
//! that this machine shows in the same run (`performance::floor`). All on one thread; the page `docs/performance.md`
//! has two as well. Baselines: keep the output of one run beside that of another on the same quiet machine; the gate is
//! `cargo run --release -p oilwedge-full -- performance gate`.

use std::fmt;
use std::sync::LazyLock;

use divan::Bencher;
use oilwedge_full::performance::clock::on_threads;
use oilwedge_full::performance::films::{Films, Kind, scene};
use oilwedge_full::performance::floor::{Path, Sizes};
use oilwedge_full::performance::machine::Machine;
use oilwedge_full::performance::phase_table::milliseconds;
use oilwedge_full::performance::{phases, process};
use oilwedge_tests::program::build;

static MACHINE: LazyLock<Machine> = LazyLock::new(Machine::measured);
static FILMS: LazyLock<Films> = LazyLock::new(Films::new);

/// Unknowns of the paths that are linear in the unknowns, or nearly so.
const SIZES: [usize; 4] = [1000, 10_000, 100_000, 1_000_000];
/// Unknowns of the films that are iterated.
const ITERATED: [usize; 3] = [1000, 10_000, 100_000];

fn main() {
    println!(
        "copy {:.1} GB/s, dense product {:.1} Gflop/s on one thread",
        1e-9 * MACHINE.bandwidth,
        1e-9 * MACHINE.flops
    );
    on_threads(1, divan::main);
}

/// What the floors at [`SIZES`] depend on.
static RINGS: LazyLock<[Sizes; 4]> =
    LazyLock::new(|| SIZES.map(|size| phases::sizes(&scene(&FILMS.ring(Kind::Linear, size)))));

/// A size, shown with the floor of a path there.
struct At(usize, Path);

impl fmt::Display for At {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let ring = SIZES.iter().zip(&*RINGS).find(|(size, _)| **size == self.0);
        let floor = ring.map_or(0.0, |(_, sizes)| sizes.floor(self.1, &MACHINE, 1));
        write!(f, "{}, floor {} ms", self.0, milliseconds(floor))
    }
}

fn at(sizes: &'static [usize], path: Path) -> impl Iterator<Item = At> {
    sizes.iter().map(move |&size| At(size, path))
}

#[divan::bench(args = at(&SIZES, Path::Read), max_time = 3)]
fn read(bencher: Bencher, at: &At) {
    let scene = scene(&FILMS.ring(Kind::Linear, at.0));
    bencher.bench_local(|| phases::mesh(&scene));
}

#[divan::bench(args = at(&SIZES, Path::Draw), max_time = 3)]
fn mesh(bencher: Bencher, at: &At) {
    let scene = scene(&FILMS.drawn_ring(at.0));
    bencher.bench_local(|| phases::mesh(&scene));
}

#[divan::bench(args = at(&SIZES, Path::Number), max_time = 3)]
fn number(bencher: Bencher, at: &At) {
    let mesh = phases::mesh(&scene(&FILMS.ring(Kind::Linear, at.0))).into();
    bencher.bench_local(|| phases::number(&mesh));
}

#[divan::bench(args = at(&SIZES, Path::Analyse), max_time = 3)]
fn order_and_analyse(bencher: Bencher, at: &At) {
    let mesh = phases::mesh(&scene(&FILMS.ring(Kind::Linear, at.0))).into();
    let assembler = phases::number(&mesh);
    bencher.bench_local(|| phases::analyse(&assembler));
}

#[divan::bench(args = at(&SIZES, Path::Assemble), max_time = 3)]
fn assemble(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::Linear, at.0)));
    let mut linear = phases::Linear::of(&study);
    bencher.bench_local(|| phases::assemble(&study, &mut linear));
}

#[divan::bench(args = at(&SIZES, Path::Factorise), max_time = 3)]
fn factorise(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::Linear, at.0)));
    let mut linear = phases::Linear::of(&study);
    phases::assemble(&study, &mut linear);
    let analysis = phases::analyse(&study.system.assembler);
    bencher.bench_local(|| phases::factorise(&analysis, &linear));
}

#[divan::bench(args = at(&SIZES, Path::Substitute), max_time = 3)]
fn solve(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::Linear, at.0)));
    let mut linear = phases::Linear::of(&study);
    phases::assemble(&study, &mut linear);
    let factor = phases::factorise(&phases::analyse(&study.system.assembler), &linear);
    bencher.bench_local(|| phases::substitute(&factor, &linear));
}

/// The film by the way that the program chooses for its size.
#[divan::bench(args = at(&SIZES, Path::Film), max_time = 3)]
fn film(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::Linear, at.0)));
    bencher.bench_local(|| phases::film(&study));
}

#[divan::bench(args = at(&SIZES, Path::FileToLoad), max_time = 3)]
fn file_to_load(bencher: Bencher, at: &At) {
    let scene = scene(&FILMS.ring(Kind::Linear, at.0));
    bencher.bench_local(|| phases::file_to_load(&scene));
}

/// Swift and Stieber's cavity from nothing, coarser meshes among it.
#[divan::bench(args = at(&ITERATED, Path::Film), max_time = 3, sample_count = 5)]
fn cavitation_swift_stieber(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::SwiftStieber, at.0)));
    bencher.bench_local(|| phases::film(&study));
}

/// A mass-conserving film by its active sets.
#[divan::bench(args = at(&ITERATED, Path::Film), max_time = 3, sample_count = 3)]
fn cavitation_jfo(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.grooved_ring(at.0)));
    bencher.bench_local(|| phases::film(&study));
}

#[divan::bench(args = at(&ITERATED, Path::Film), max_time = 3, sample_count = 3)]
fn equilibrium(bencher: Bencher, at: &At) {
    let study = phases::study(&scene(&FILMS.ring(Kind::Loaded, at.0)));
    bencher.bench_local(|| phases::equilibrium(&study));
}

/// The program, from its start to its written files, without error bars.
#[divan::bench(args = at(&SIZES, Path::FileToLoad), max_time = 3, sample_count = 10)]
fn whole_process(bencher: Bencher, at: &At) {
    let program = build("oilwedge");
    let scene = FILMS.ring(Kind::Linear, at.0);
    bencher.bench_local(|| process::run(&program, &scene, 1, false));
}

/// 1000 operating points.
#[divan::bench(sample_count = 1)]
fn sweep(bencher: Bencher) {
    let program = build("oilwedge");
    let map = FILMS.map(5000);
    bencher.bench_local(|| process::sweep(&program, &map, 1));
}

/// The shipped plain scene: no effect may move it.
#[divan::bench]
fn plain_scene(bencher: Bencher) {
    let program = build("oilwedge");
    let scene = FILMS.plain_ring(1000);
    bencher.bench_local(|| process::run(&program, &scene, 1, false));
}
