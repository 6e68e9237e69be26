//! Where the oil goes: flows of every end, hole and groove against each other, what a growing film takes up, what a
//! cavity makes, and what is told of it.

use std::sync::Arc;

use oilwedge_mesh::{Mesh, gmsh};
use oilwedge_reynolds::quantities::flow::Flows;
use oilwedge_reynolds::{Fallback, FilmSystem, NoFilm};
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::measure::measure;
use oilwedge_study::picture::{FieldValues, PictureOptions, Surface, picture};
use oilwedge_study::warnings::warnings;
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::journal_bearings::Ring;
use oilwedge_tests::scenes::{GROOVE, HOLE, POCKET, Solved, solve, table, variant, written};
use oilwedge_tests::{LENGTH_OF_STRETCHED, ends, stretched_ring};

const FULL_TURN: &str = r#"
[[feed]]
group = "middle"
groove = { width = "8 mm" }
pressure = "0.4 bar"
"#;

/// A bearing drawn with these feeds.
struct Liner {
    /// Keys of `[bearing]` besides its size.
    bearing: &'static str,
    feeds: &'static [&'static str],
    /// Pressure of the ends [bar]; that of the cavity is zero.
    ends: f64,
}

/// Every kind of supply; an arc is supplied by the edge through which oil comes in.
const LINERS: [Liner; 8] = [
    liner("", &[GROOVE], 0.0),
    liner("", &[HOLE], 0.0),
    liner("", &[GROOVE, HOLE, POCKET], 0.2),
    liner("", &[HOLE, POCKET], 0.0),
    liner("", &[FULL_TURN], 0.0),
    liner(r#"film_start = "90 deg""#, &[], 0.0),
    liner(r#"arc = { from = "-100 deg", to = "120 deg" }"#, &[], 0.0),
    liner(r#"arc = { from = "-60 deg", to = "200 deg" }"#, &[HOLE, GROOVE], 0.1),
];

const fn liner(bearing: &'static str, feeds: &'static [&'static str], ends: f64) -> Liner {
    Liner { bearing, feeds, ends }
}

impl Liner {
    fn scene(&self, model: &str, speed: f64, squeeze: &str) -> Scene {
        let (bearing, feeds, ends) = (self.bearing, self.feeds.concat(), self.ends);
        written(&format!(
            r#"
title = "Where the oil goes"
[bearing]
diameter = "100 mm"
length = "80 mm"
clearance = "150 um"
{bearing}
[mesh]
size = "9 mm"
[ends]
pressure = "{ends} bar"
[journal]
speed = "{speed} rpm"
eccentricity = 0.6
min_film_angle = "10 deg"
{squeeze}
[oil]
viscosity = "0.01 Pa.s"
[cavitation]
model = "{model}"
pressure = "0 bar"
{feeds}"#
        ))
    }
}

fn solved(scene: &Scene) -> Solved {
    solve(scene).unwrap_or_else(|reason| panic!("{reason}"))
}

/// What comes in through all regions together, less what the film takes up.
fn surplus(flows: &Flows) -> f64 {
    flows.regions.iter().map(|region| region.net).sum::<f64>() - flows.taken_up
}

#[track_caller]
fn balanced(flows: &Flows) {
    assert!(flows.throughput > 0.0 && flows.imbalance < 1e-10, "{flows:?}");
}

#[test]
fn flows_of_a_mass_conserving_film_balance() {
    for (index, liner) in LINERS.iter().enumerate() {
        for speed in [3000.0, -3000.0] {
            let film = solved(&liner.scene("jfo", speed, ""));
            let flows = &film.measured.flows;
            balanced(flows);
            assert!(surplus(flows).abs() < 1e-10 * flows.throughput, "{index}: {flows:?}");
            assert_eq!((flows.taken_up, flows.cavity), (0.0, 0.0));
            assert!(film.quantity("cavity_share") > 0.05, "{index} {speed}: no cavity");
            let least = film.quantity("film_fraction_min");
            assert!(0.0 < least && least < 1.0, "{index} {speed}: {least}");
            assert_eq!(film.quantity("pressure_min"), 0.0);
            // Region by region, as they are reported; the edges of an arc and the film start have no quantity.
            let lines = ["arc_from", "arc_to", "film_start"];
            let on_lines = flows.regions.iter().filter(|it| lines.contains(&it.name.as_str()));
            let fed = flows.regions.iter().filter(|it| ["groove", "hole", "middle"].contains(&it.name.as_str()));
            let fed: f64 = fed.map(|it| film.quantity(&format!("feed_flow.{}", it.name))).sum();
            let left = on_lines.map(|it| it.net).sum::<f64>() + fed - film.quantity("side_flow");
            assert!(left.abs() < 1e-10 * flows.throughput, "{index} {speed}: {left:e}");
        }
    }
}

/// The journal carries oil out by the trailing edge of an arc, where the film is not full: less than a full film would.
#[test]
fn a_broken_film_leaves_by_the_edge_of_an_arc() {
    for (speed, inlet, outlet) in [(3000.0, "arc_from", "arc_to"), (-3000.0, "arc_to", "arc_from")] {
        let film = solved(&LINERS[6].scene("jfo", speed, ""));
        let flow = |name: &str| {
            let found = film.measured.flows.regions.iter().find(|region| region.name == name);
            found.expect("an edge of the arc").net
        };
        assert!(flow(inlet) > 0.0 && flow(outlet) < 0.0);
        let drag = 0.5 * film.study.problem.surface_velocity()[0].abs() * 0.08;
        let angle = if outlet == "arc_to" { 120.0f64 } else { -100.0 };
        let thickness = 150e-6 * (1.0 - 0.6 * (angle - 10.0).to_radians().cos());
        let share = -flow(outlet) / (drag * thickness);
        assert!(0.2 < share && share < 0.9, "{share}");
    }
}

/// The centre of the journal moves while it turns: a full film takes up what the rate of its thickness says, a broken
/// one less.
#[test]
fn a_growing_film_takes_oil_up() {
    let squeeze = r#"squeeze = { radial = "3 mm/s", tangential = "-2 mm/s" }"#;
    let [full, swift, jfo] = ["none", "reynolds", "jfo"].map(|model| {
        let film = solved(&LINERS[6].scene(model, 3000.0, squeeze));
        balanced(&film.measured.flows);
        film
    });
    // -Int v_r cos + v_t sin dA, from 110 degrees before the minimum film to 110 degrees behind it.
    let expected = -3e-3 * 2.0 * 110f64.to_radians().sin() * 0.05 * 0.08;
    let taken = full.measured.flows.taken_up;
    assert!((taken / expected - 1.0).abs() < 1e-6, "{taken} {expected}");
    assert!((swift.measured.flows.taken_up - taken).abs() < 1e-12 * taken.abs());
    assert!((jfo.measured.flows.taken_up - taken).abs() > 0.02 * taken.abs());
}

/// A journal that does not turn presses all oil out by the squeeze.
#[test]
fn oil_that_is_pressed_out_counts_as_passing() {
    for radial in ["2 mm/s", "-2 mm/s"] {
        let squeeze = format!(r#"squeeze = {{ radial = "{radial}" }}"#);
        for liner in [&LINERS[0], &LINERS[6]] {
            let film = solved(&liner.scene("none", 0.0, &squeeze));
            balanced(&film.measured.flows);
        }
    }
}

/// The equations are balanced to rounding; what the cavity makes is told by itself, and leaves the film.
#[test]
fn what_a_swift_stieber_cavity_makes_is_told() {
    for (index, liner) in LINERS.iter().enumerate() {
        for speed in [3000.0, -3000.0] {
            let film = solved(&liner.scene("reynolds", speed, ""));
            let flows = &film.measured.flows;
            balanced(flows);
            let made = film.quantity("cavity_flow");
            assert!(made > 1e-3 * flows.throughput, "{index} {speed}: {made}");
            assert!((made + surplus(flows)).abs() < 1e-10 * flows.throughput);
            assert!(film.quantity("cavity_share") > 0.05);
            assert_eq!(film.quantity("pressure_min"), 0.0);
        }
    }
}

/// Where a short film breaks by itself, half of the ring is cavity; a flooded one breaks at the same place in both
/// models.
#[test]
fn share_of_the_cavity() {
    let short = Ring::new(0.05, 0.3).solve().solved.quantity("cavity_share");
    assert!((short - 0.5).abs() < 0.02, "{short}");
    let flooded = |model| {
        let ring = Ring { film_start: true, model, ..Ring::new(1.0, 0.6) };
        ring.solve().solved.quantity("cavity_share")
    };
    let (swift, jfo) = (flooded("reynolds"), flooded("jfo"));
    assert!((swift / jfo - 1.0).abs() < 0.05, "{swift} {jfo}");
    let full = solved(&LINERS[0].scene("none", 3000.0, ""));
    assert!(full.measured.cavity.is_none());
}

/// A plain ring: all oil that leaves its half film is made by the clip, and
/// half of the full film is under tension.
#[test]
fn what_the_plain_models_get_wrong_is_told() {
    let with = |model: &str| {
        let film = solved(&variant("01_plain_ring", |scene| {
            table(scene, "cavitation").insert("model".into(), model.into());
        }));
        (warnings(&film.study, &film.measured).concat(), film.measured)
    };
    let (told, measured) = with("guembel");
    assert!((measured.flows.made() - 1.0).abs() < 1e-3, "{}", measured.flows.made());
    assert!(told.contains("some 100 % of the oil that passes is created"), "{told}");
    let (told, measured) = with("none");
    assert!((measured.under_tension - 0.5).abs() < 1e-2, "{}", measured.under_tension);
    assert!(told.contains("lies below the 0.00 bar of the ends on 50 % of the film"), "{told}");
}

/// Ways out of the solver are no secret.
#[test]
fn every_way_out_is_a_warning() {
    let mut film = solved(&LINERS[0].scene("jfo", 3000.0, ""));
    let before = warnings(&film.study, &film.measured).len();
    assert_eq!(before, film.film.solution.fallbacks.len());
    film.measured.fallbacks = vec![Fallback::PseudoTime];
    let told = warnings(&film.study, &film.measured);
    for (told, fallback) in told.iter().zip(&film.measured.fallbacks) {
        assert!(told.starts_with(&format!("{fallback}: ")), "{told}");
    }
}

/// A ring whose triangles are long and obtuse, fed from its ends, compiled from a file.
fn stretched(mesh: &Mesh, film_start: &str) -> Film {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("ring.msh");
    gmsh::write(mesh, &file).expect("written");
    let text = format!(
        r#"
title = "Stretched mesh"
bearing = {{ diameter = "100 mm", length = "{LENGTH_OF_STRETCHED} m", clearance = "50 um"{film_start} }}
mesh = {{ file = "ring.msh" }}
ends = {{ pressure = "1 bar" }}
journal = {{ speed = "100 rad/s", eccentricity = 0.6, min_film_angle = "180 deg" }}
oil = {{ viscosity = "0.02 Pa.s" }}
cavitation = {{ model = "jfo" }}
"#
    );
    let scene = folder.path().join("scene.toml");
    std::fs::write(&scene, text).expect("written");
    let scene = oilwedge_study::read(&scene).unwrap_or_else(|error| panic!("{error}"));
    compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn stretched_meshes_are_flipped() {
    let mesh = stretched_ring();
    // The line of a film start stays.
    for film_start in ["", r#", film_start = "0 deg""#] {
        let study = stretched(&mesh, film_start);
        assert!(study.origin.flips > 1000, "{}", study.origin.flips);
        let film = study.problem.solve(&study.system);
        let film = film.unwrap_or_else(|reason| panic!("{reason}"));
        let measured = measure(&film);
        let least = measured.cavity.and_then(|cavity| cavity.least_fraction);
        assert!(least.is_some_and(|least| 0.0 < least && least < 1.0), "{least:?}");
        balanced(&measured.flows);
        let told = warnings(&study, &measured);
        assert!(told.iter().any(|it| it.starts_with("the mesh was made Delaunay by")), "{told:?}");
    }
    let mut regions = ends(&mesh, LENGTH_OF_STRETCHED, None);
    regions.iter_mut().for_each(|region| region.pressure = 1e5);
    let study = stretched(&mesh, "");
    let as_it_was = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("a system"));
    let found = study.problem.solve(&as_it_was);
    assert!(
        matches!(found, Err(NoFilm::FilmFraction { .. } | NoFilm::NotConverged(_))),
        "{:?}",
        found.map(|_| "a film")
    );
}

/// Film fractions in the file, and no pressure below that of the cavity.
#[test]
fn fields_of_broken_films() {
    for (model, fields) in [("reynolds", 5), ("jfo", 6)] {
        let film = solved(&LINERS[2].scene(model, 3000.0, ""));
        let indicator = vec![0.5; film.study.system.space().mesh().triangles().len()];
        let drawn = picture(
            &film.study,
            &film.film,
            Some(&indicator),
            PictureOptions { surface: Surface::Developed, ..Default::default() },
        );
        assert_eq!(
            (&*drawn.cell_data[0].name, drawn.cell_data[0].values.numbers()),
            ("error_indicator", &indicator[..])
        );
        assert_eq!(drawn.point_data.len(), fields);
        let field = |name: &str| drawn.at_points(name).map(FieldValues::numbers);
        let pressures = field("pressure").expect("pressures");
        assert_eq!(pressures.iter().copied().fold(f64::INFINITY, f64::min), 0.0);
        if let Some(fractions) = field("film_fraction") {
            assert!(fractions.iter().all(|&it| 0.0 < it && it <= 1.0));
            assert!(fractions.iter().any(|&it| it < 0.9) && fractions.contains(&1.0));
        }
    }
}

#[test]
fn the_history_tells_the_nodes_in_the_cavity() {
    for model in ["reynolds", "jfo"] {
        let run = run(&LINERS[0].scene(model, 3000.0, ""), &RunOptions::default()).expect("a run");
        let last = run.result.history.last().expect("a step");
        assert!(last.active > 50 && last.residual < 1e-6, "{last:?}");
        assert!(run.result.counts.levels > 0);
    }
}
