//! Towards a tolerance: meshes until the bars are small enough, or until a limit.

use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_bearing::SearchObserver;
use oilwedge_bearing::orbit::OrbitObserver;
use oilwedge_study::result::{Refinement, Status};
use oilwedge_study::{Reached, RunObserver, RunOptions, run};
use oilwedge_tests::scenes::{table, variant};

use super::films::{NO_BARS, answer, bar, drawn, quantity, set};

#[test]
fn a_tolerance_is_met_by_the_bars() {
    for (name, asked) in [
        ("09_drawn_ring", "{ load = \"0.01 %\", pressure_max = \"0.1 %\" }"),
        ("02_flexpde_shell", "{ load = \"0.0005 %\", attitude_angle = \"0.001 %\" }"),
        ("12_flexpde_shell_cavitated", "{ load = \"0.02 %\", side_flow = \"1 %\" }"),
        ("16_loaded_shell", "{ eccentricity = \"0.01 %\" }"),
    ] {
        let tolerance: toml::Table = format!("tolerance = {asked}").parse().expect("TOML");
        let result =
            answer(&variant(name, |scene| table(scene, "mesh").extend(tolerance.clone())), &RunOptions::default());
        let targets = tolerance["tolerance"].as_table().expect("a table");
        let last = result.levels.last().expect("a level");
        for (name, relative) in targets {
            let relative: f64 =
                relative.as_str().and_then(|it| it.strip_suffix(" %")?.parse().ok()).expect("a percentage");
            let (value, error) = bar(&result, name);
            let size = if name.ends_with("angle") { 1f64.to_degrees() } else { value.abs() };
            assert!(error <= 0.01 * relative * size, "{name}: {error:e}");
            let told = last.errors.iter().find(|(told, _)| told == name).expect("its bar");
            assert_eq!(told.1, error);
        }
        assert_eq!(last.cells, result.mesh.cells);
        assert_eq!(result.levels[0].refinement, Refinement::Given);
        assert!(result.levels.windows(2).all(|pair| pair[0].unknowns < pair[1].unknowns));
    }
}

/// A scene with neither mesh file, size nor tolerance is as accurate as half a percent of its load.
#[test]
fn half_a_percent_is_what_is_meant() {
    let result = answer(&variant("09_drawn_ring", |_| ()), &RunOptions::default());
    let (load, error) = bar(&result, "load");
    assert!(error < 0.005 * load && !result.levels.is_empty());
    // Its limit: a spectral solution, Fourier modes around and Chebyshev polynomials along, the same to 1e-12 from 48 x
    // 20 modes on.
    assert!((load - 43567.912956).abs() < error, "{load} ± {error}");
    // Without bars it is computed on the mesh that it always had.
    let plain = answer(&variant("09_drawn_ring", |_| ()), &NO_BARS);
    assert!((quantity(&plain, "load").value / 43567.912956 - 1.0).abs() < 2e-5);
    assert!(plain.mesh.cells > 2 * result.mesh.cells);
}

#[test]
fn a_limit_that_is_reached_is_told_with_the_best_numbers() {
    let scene = variant("12_flexpde_shell_cavitated", |scene| set(scene, "mesh", "tolerance", "0.00001 %"));
    for options in [
        RunOptions { max_unknowns: 10_000, ..RunOptions::default() },
        RunOptions { max_seconds: 1e-3, ..RunOptions::default() },
    ] {
        let result = run(&scene, &options).expect("a mesh").result;
        assert_eq!(result.head.status, Status::NotConverged);
        let reason = result.head.reason.as_deref().expect("a reason");
        assert!(reason.starts_with("limit: "), "{reason}");
        let flag = if options.max_unknowns < 1_000_000 { "--max-unknowns" } else { "--max-seconds" };
        assert!(reason.contains(flag), "{reason}");
        assert!(quantity(&result, "load").error().is_some() && !result.levels.is_empty());
        assert!(result.levels.iter().all(|level| level.unknowns <= options.max_unknowns), "{:?}", result.levels);
        assert!(result.mesh.nodes > 0 && oilwedge_report::json(&result).is_ok());
    }
}

/// Uniform refinement of a mesh file makes four of each triangle: the limit counts them before they are made.
#[test]
fn no_mesh_has_more_unknowns_than_allowed() {
    for tolerance in ["0.0003 %", "0.00001 %"] {
        for max_unknowns in [7_000, 12_000, 30_000] {
            let scene = variant("02_flexpde_shell", |scene| set(scene, "mesh", "tolerance", tolerance));
            let options = RunOptions { max_unknowns, ..RunOptions::default() };
            let result = run(&scene, &options).expect("a mesh").result;
            let most = result.levels.iter().map(|level| level.unknowns).max();
            assert!(most <= Some(max_unknowns), "{tolerance}, {max_unknowns}: {:?}", result.levels);
        }
    }
}

/// A ring four thousand times as wide as long has a first mesh of 150 000 unknowns, which is not made where fewer are
/// allowed.
#[test]
fn a_first_mesh_has_no_more_unknowns_than_allowed() {
    for model in ["reynolds", "jfo"] {
        let scene = variant("09_drawn_ring", |scene| {
            set(scene, "bearing", "length", "0.02 mm");
            set(scene, "cavitation", "model", model);
        });
        let options = RunOptions { max_unknowns: 40_000, ..RunOptions::default() };
        let error = run(&scene, &options).expect_err("it is too large").to_string();
        for words in ["--max-unknowns 40000", "235.619 mm around and 0.02 mm long", "higher limit"] {
            assert!(error.contains(words), "{error}");
        }
    }
}

/// The side flow is unsure where the edge of the cavity crosses an end, which triangles that matter to the load do not
/// cure.
#[test]
fn a_bar_that_local_division_does_not_serve_is_narrowed_by_uniform_division() {
    let result = answer(
        &variant("11_swift_stieber_ring", |scene| {
            let tolerance: toml::Table =
                "tolerance = { load = \"0.05 %\", side_flow = \"0.2 %\" }".parse().expect("TOML");
            table(scene, "mesh").extend(tolerance);
            set(scene, "journal", "eccentricity", 0.97);
        }),
        &RunOptions::default(),
    );
    assert!(result.levels.len() < 8, "{:?}", result.levels);
    let (flow, error) = bar(&result, "side_flow");
    assert!(error < 0.002 * flow);
}

/// Near the limit of Barus' law a coarse mesh may have a film that a finer one has not.
#[test]
fn a_film_that_a_finer_mesh_has_not_is_no_solution() {
    let at = |speed: &str| {
        let scene = drawn("02_flexpde_shell", 12.0, |scene| {
            set(scene, "mesh", "tolerance", "0.01 %");
            set(scene, "journal", "speed", speed);
        });
        run(&scene, &RunOptions::default()).expect("a mesh").result
    };
    let below = at("81.47 rad/s");
    assert_eq!(below.head.status, Status::Converged);
    assert!(below.levels.len() > 1);
    // The limit lies at 81.4745 rad/s, as edges of 1.5 mm tell.
    let above = at("81.48 rad/s");
    assert_eq!(above.head.status, Status::NoSolution);
    assert!(
        above.quantities.is_empty() && above.head.reason.is_some_and(|reason| reason.starts_with("no steady film"))
    );
}

/// A bar tells how well a mesh resolves a film; without one its steepest triangle does.
#[test]
fn a_film_with_bars_is_not_called_unresolved() {
    let thin = |options: &RunOptions| {
        let scene = drawn("09_drawn_ring", 16.0, |scene| set(scene, "journal", "eccentricity", 0.999));
        let warnings = answer(&scene, options).tail.warnings;
        warnings.iter().any(|warning| warning.starts_with("the film is not resolved"))
    };
    assert!(!thin(&RunOptions::default()) && thin(&NO_BARS));
}

/// Where the edge of the cavity is what is uncertain, only triangles there are divided.
#[test]
fn the_edge_of_a_cavity_is_refined_where_it_dominates() {
    let scene = variant("11_swift_stieber_ring", |scene| {
        set(scene, "mesh", "tolerance", "0.01 %");
        set(scene, "journal", "eccentricity", 0.9);
    });
    let result = answer(&scene, &RunOptions::default());
    let local = result.levels.windows(2).filter(|pair| pair[1].refinement == Refinement::Local);
    let growths: Vec<f64> = local.map(|pair| pair[1].unknowns as f64 / pair[0].unknowns as f64).collect();
    assert!(!growths.is_empty() && growths.iter().all(|growth| *growth < 3.0), "{growths:?}");
    let (load, error) = bar(&result, "load");
    assert!(error < 1e-4 * load);
}

/// What a run has told of.
#[derive(Debug)]
struct Told {
    /// Positions before the first mesh was named.
    first: AtomicUsize,
    /// Positions after the first mesh was named.
    later: AtomicUsize,
    levels: AtomicUsize,
}

impl SearchObserver for Told {
    fn position(&self, _: usize, _: f64) {
        let is_first = self.levels.load(Ordering::Relaxed) == 0;
        let counter = if is_first { &self.first } else { &self.later };
        counter.fetch_add(1, Ordering::Relaxed);
    }
}

impl OrbitObserver for Told {
    fn step(&self, _: usize, _: f64, _: f64) {}
}

impl RunObserver for Told {
    fn level(&self, _: usize, _: usize) {
        self.levels.fetch_add(1, Ordering::Relaxed);
    }

    fn reached(&self, _: &Reached) {}

    fn temperature(&self, _: usize, _: f64) {}
}

/// The search that grades the first mesh for its load may take long: the observer is notified of its positions before
/// that mesh is made.
#[test]
fn a_run_tells_of_the_search_that_grades_its_mesh() {
    static TOLD: Told = Told { first: AtomicUsize::new(0), later: AtomicUsize::new(0), levels: AtomicUsize::new(0) };
    let options = RunOptions { observer: Some(&TOLD), ..RunOptions::default() };
    let result = answer(&variant("24_load_off_the_middle", |_| ()), &options);
    assert_eq!(result.head.status, Status::Converged);
    let [first, later, levels] = [&TOLD.first, &TOLD.later, &TOLD.levels].map(|count| count.load(Ordering::Relaxed));
    assert!(first > 0 && later > 0 && levels == result.levels.len(), "{first} {later} {levels}");
}
