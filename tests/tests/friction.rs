//! Friction and power: closed forms, the moments of the two surfaces, and what is put in against what becomes heat.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::lubricant::roelands::Roelands;
use oilwedge_reynolds::quantities::friction::{Friction, friction};
use oilwedge_reynolds::quantities::inlet::inlet_flow;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::quantities::power::{Power, power};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, Form, SolvedFilm};
use oilwedge_scene::Scene;
use oilwedge_tests::scenes::{GROOVE, HOLE, POCKET, Solved, solve, written};
use oilwedge_tests::*;

const LENGTH: f64 = 0.08;

fn system(film_start: bool) -> Arc<FilmSystem> {
    ring_system(60, 12, LENGTH, film_start.then_some(0.0))
}

/// Widest at 0 degrees.
fn film(eccentricity: f64, cavitation: Cavitation) -> FilmProblem {
    FilmProblem { cavitation, ..plain_film(LENGTH, eccentricity, PI, SPEED) }
}

struct Measured {
    film: SolvedFilm,
    power: Power,
    friction: Friction,
}

fn measured(problem: &FilmProblem, system: &Arc<FilmSystem>) -> Measured {
    let film = problem.solve(system).expect("a film");
    let power = power(&film);
    Measured { power, friction: friction(&problem.journal, &power).expect("a turning journal"), film }
}

/// Petroff (1883) for a centred journal, and the drag through a gap of varying width:
/// `2 pi mu omega R^3 B/(c sqrt(1 - eps^2))`.
#[test]
fn shear_is_that_of_the_closed_form() {
    for eccentricity in [0.0, 0.3, 0.8] {
        let problem = film(eccentricity, Cavitation::None);
        let found = measured(&problem, &system(false));
        let rest: f64 = 1.0 - eccentricity * eccentricity;
        let expected = TAU * VISCOSITY * SPEED * RADIUS.powi(3) * LENGTH / (CLEARANCE * rest.sqrt());
        let error = found.power.shear / (SPEED * expected) - 1.0;
        assert!(error.abs() < 1e-9, "{eccentricity}: {error:e}");
        if eccentricity == 0.0 {
            assert!((found.friction.on_journal / expected - 1.0).abs() < 1e-9);
            assert!((found.friction.on_bearing / expected - 1.0).abs() < 1e-9);
        }
    }
}

/// The moments on journal and bearing differ by that of the load about the bearing's centre, whatever cavitates; the
/// drag of pressure is half of it: the source's kN2. To rounding of the integrals where nothing cavitates, else as well
/// as the film is resolved: a cut pressure is bent where the nodes tell, and the flows between cells drag with the
/// scheme's thickness.
#[test]
fn moments_of_the_two_surfaces_and_of_the_load_balance() {
    let pressure = 0.0;
    let models = [
        (Cavitation::None, 1e-7),
        (Cavitation::Guembel { pressure }, 1e-3),
        (Cavitation::Reynolds { pressure }, 1e-4),
        (Cavitation::Jfo { pressure }, 1e-3),
    ];
    for (cavitation, tolerance) in models {
        for sense in [1.0, -1.0] {
            let mut problem = film(0.7, cavitation);
            problem.journal.speed *= sense;
            let errors = [60, 120].map(|columns| {
                let system = ring_system(columns, columns / 5, LENGTH, Some(0.0));
                let found = measured(&problem, &system);
                let [w_x, w_y] = load(&found.film).total.force;
                let [e_x, e_y] = problem.journal.offset;
                // The load pushes the journal on: its moment has the sense of the rotation.
                let moment = sense * (w_x * e_y - w_y * e_x);
                let Friction { on_journal, on_bearing } = found.friction;
                assert!(moment > 0.0 && on_journal > on_bearing && on_bearing > 0.0);
                ((on_journal - on_bearing) / moment - 1.0).abs()
            });
            let falls = errors[1] < 0.5 * errors[0] || errors[1] < 1e-10;
            assert!(falls && errors[1] < tolerance, "{cavitation:?} {sense}: {errors:?}");
        }
    }
}

fn scene(model: &str, bearing: &str, journal: &str, oil: &str, feeds: &str) -> Scene {
    written(&format!(
        r#"
title = "Where the power goes"
[bearing]
diameter = "100 mm"
length = "80 mm"
clearance = "150 um"
{bearing}
[mesh]
size = "9 mm"
[ends]
pressure = "0.2 bar"
[journal]
eccentricity = 0.6
min_film_angle = "10 deg"
{journal}
[oil]
viscosity = "0.01 Pa.s"
{oil}
[cavitation]
model = "{model}"
pressure = "0 bar"
{feeds}"#
    ))
}

/// Feeds of ten times the pressure, against which oil is pressed in.
fn pressed(feeds: &str) -> String {
    feeds.replace("\"0.7 bar\"", "\"7 bar\"").replace("\"0.3 bar\"", "\"3 bar\"")
}

fn solved(scene: &Scene) -> Solved {
    solve(scene).unwrap_or_else(|reason| panic!("{reason}"))
}

const TURNS: &str = r#"speed = "3000 rpm""#;
const SQUEEZES: &str = r#"speed = "-3000 rpm"
squeeze = { radial = "4 mm/s", tangential = "-3 mm/s" }"#;

/// Whatever feeds the film, breaks it or thickens the oil: what is put in becomes heat.
#[test]
fn power_put_in_becomes_heat() {
    let arc = r#"arc = { from = "-60 deg", to = "200 deg" }"#;
    let oils = ["", r#"barus = { alpha = "200 1/GPa" }"#, r#"roelands = { alpha = "200 1/GPa" }"#];
    let feeds = pressed(&[GROOVE, HOLE, POCKET].concat());
    for model in ["none", "guembel", "reynolds", "jfo"] {
        for (bearing, journal, feeds) in [("", TURNS, &feeds), (arc, SQUEEZES, &feeds), (arc, TURNS, &String::new())] {
            for oil in oils {
                let film = solved(&scene(model, bearing, journal, oil, feeds));
                let power = &film.measured.power;
                assert!(power.imbalance < 1e-9, "{model} {bearing} {journal} {oil}: {power:?}");
                assert!(power.shear > 0.0 && power.driven > 0.0, "{power:?}");
                assert_eq!(power.supplied > 0.0, !feeds.is_empty(), "{power:?}");
            }
        }
    }
}

/// A journal at rest that sinks: all that its load puts in drives oil.
#[test]
fn a_sinking_journal_heats_the_oil() {
    let at_rest = "speed = \"0 rpm\"\nsqueeze = { radial = \"4 mm/s\" }";
    let film = solved(&scene("reynolds", "", at_rest, "", ""));
    let power = &film.measured.power;
    assert!(power.imbalance < 1e-9 && power.shear == 0.0 && power.pressure == 0.0, "{power:?}");
    assert!((power.motion + power.cavity - power.driven).abs() < 1e-9 * power.driven);
    assert!((film.quantity("squeeze_power") / power.motion - 1.0).abs() < 1e-9);
}

/// The balance is no identity: it opens where the equation is not solved, and where flow, pressure or drag is another
/// one.
#[test]
fn a_spoiled_film_does_not_balance() {
    let pressure = 0.0;
    for cavitation in [
        Cavitation::None,
        Cavitation::Guembel { pressure },
        Cavitation::Reynolds { pressure },
        Cavitation::Jfo { pressure },
    ] {
        let problem = film(0.7, cavitation);
        let system = system(true);
        let mut film = problem.solve(&system).expect("a film");
        assert!(power(&film).imbalance < 1e-10, "{cavitation:?}");
        let unknown = &mut Arc::make_mut(&mut film.solution).unknown;
        let top = (0..unknown.len()).max_by(|&a, &b| unknown[a].total_cmp(&unknown[b]));
        unknown[top.expect("dofs")] *= 1.001;
        let spoiled = power(&film).imbalance;
        assert!(spoiled > 1e-8, "{cavitation:?}, a pressure: {spoiled:e}");
        let film = problem.solve(&system).expect("a film");
        let mut other = film.clone();
        other.problem.lubricant.viscosity *= 1.001;
        let spoiled = power(&other).imbalance;
        assert!(spoiled > 1e-6, "{cavitation:?}, the viscosity: {spoiled:e}");
        let mut other = film;
        other.problem.journal.speed *= 1.001;
        let spoiled = power(&other).imbalance;
        assert!(spoiled > 1e-6, "{cavitation:?}, the speed: {spoiled:e}");
    }
    let mut film = solved(&scene("none", "", TURNS, "", &pressed(GROOVE)));
    let flow = Arc::make_mut(&mut film.film.solution)
        .inflow
        .iter_mut()
        .zip(0..)
        .filter(|(_, dof)| film.study.system.supply.owner(*dof).is_some());
    flow.for_each(|(inflow, _)| *inflow *= 1.001);
    let spoiled = power(&film.film).imbalance;
    assert!(spoiled > 1e-6, "flows: {spoiled:e}");
}

/// The as-printed form makes oil where the pressure is high, and tells so.
#[test]
fn the_as_printed_form_does_not_balance() {
    let mut problem = film(0.6, Cavitation::None);
    let law = Barus { alpha: 3e-8 };
    problem.lubricant.pressure_law = PressureLaw::Barus(law);
    problem.form = Form::AsPrinted;
    assert!(measured(&problem, &system(false)).power.imbalance > 1e-4);
}

/// Thicker oil under pressure drags more; a law without thickening is none.
#[test]
fn viscosity_counts_where_it_is() {
    let at = |pressure_law| {
        let mut problem = film(0.7, Cavitation::None);
        problem.lubricant.pressure_law = pressure_law;
        measured(&problem, &system(false)).power
    };
    let plain = at(PressureLaw::Constant);
    assert_eq!(at(PressureLaw::Barus(Barus { alpha: 0.0 })), plain);
    let thickened = at(PressureLaw::Barus(Barus { alpha: 3e-8 }));
    assert!(thickened.shear > 1.001 * plain.shear);
    let roelands = PressureLaw::Roelands(Roelands::new(VISCOSITY, 0.5, 196.2e6));
    assert!(at(roelands).shear > 1.0001 * plain.shear);
}

/// A gap of even width that is half full all along is sheared half as much.
#[test]
fn a_starved_gap_is_sheared_as_far_as_it_is_full() {
    let pad = |fraction: &str| {
        let bearing = format!(r#"arc = {{ from = "0 deg", to = "120 deg"{fraction} }}"#);
        let text = format!(
            r#"
title = "Parallel gap"
[bearing]
diameter = "100 mm"
length = "80 mm"
clearance = "150 um"
{bearing}
[mesh]
size = "9 mm"
[journal]
speed = "300 rpm"
eccentricity = 0.0
[oil]
viscosity = "0.01 Pa.s"
[cavitation]
model = "jfo"
pressure = "0 bar"
"#
        );
        solved(&written(&text)).measured.power.shear
    };
    let (half, full) = (pad(", inlet_fraction = 0.5"), pad(""));
    assert!((half / full - 0.5).abs() < 1e-9, "{}", half / full);
}

/// A feed has no film, whether it is cut out of the mesh or meshed.
#[test]
fn feeds_shear_nothing() {
    let (with, without) =
        (solved(&scene("none", "", TURNS, "", &pressed(HOLE))), solved(&scene("none", "", TURNS, "", "")));
    let problem = &with.study.problem;
    let thickness = problem.thickness_at(0, &[[-40f64.to_radians() * 0.05, 0.012]])[0];
    let [velocity, _] = problem.surface_velocity();
    let hole = 0.25 * PI * 0.01 * 0.01 * 0.01 * velocity * velocity / thickness;
    let missing = without.measured.power.shear - with.measured.power.shear;
    assert!((missing / hole - 1.0).abs() < 2e-2, "{missing} {hole}");
}

/// `side_flow` has two ends, and what goes in by the film start and out by the ends goes round no more.
#[test]
fn flows_of_the_ends_and_the_inlet() {
    let problem = film(0.6, Cavitation::Reynolds { pressure: 0.0 });
    let system = system(true);
    let film = problem.solve(&system).expect("a film");
    let inlet = inlet_flow(&film).expect("it turns");
    let mut backwards = problem.clone();
    backwards.journal.speed *= -1.0;
    let mirrored = backwards.solve(&system).expect("a film");
    let other = inlet_flow(&mirrored).expect("it turns");
    assert!(inlet > 0.0 && (other / inlet - 1.0).abs() < 1e-6, "{inlet:e} {other:e}");
    let mut at_rest = film;
    at_rest.problem.journal.speed = 0.0;
    at_rest.problem.terms.push(Arc::new(Squeeze));
    assert_eq!(inlet_flow(&at_rest), None);
    let tilted = solved(&scene("none", "", TURNS, "", &pressed(HOLE)));
    let ends = ["side_flow_low", "side_flow_high"].map(|name| tilted.quantity(name));
    let both = tilted.quantity("side_flow");
    assert!((ends[0] + ends[1] - both).abs() < 1e-12 * both.abs(), "{ends:?} {both}");
    assert!((ends[0] - ends[1]).abs() > 1e-3 * both.abs(), "{ends:?}");
    let unit = 1e-3 * 3e-3 * 100.0 * PI;
    assert!((tilted.quantity("side_flow_number") * unit / both - 1.0).abs() < 1e-12);
}

/// Without a film start the inlet is where the film is widest: there the journal drags `U c (1 + eps)/2` along, and the
/// pressure of a full film, odd about that line, helps or hinders.
#[test]
fn inlet_of_a_full_ring() {
    let problem = film(0.5, Cavitation::None);
    let system = ring_system(90, 20, 0.04, None);
    let film = problem.solve(&system).expect("a film");
    // A short film carries U c/2 everywhere but for what pressure drives: none in the limit of no length.
    let inlet = inlet_flow(&film).expect("it turns");
    let dragged = 0.5 * SPEED * RADIUS * CLEARANCE * 1.5 * 0.04;
    assert!(inlet < dragged && inlet > 0.8 * dragged, "{}", inlet / dragged);
}

/// Guembel drops the pressure on the half of a ring where the film widens: half of the shear, for the two are as thick.
/// Of Swift-Stieber's film the cavity begins later.
#[test]
fn shear_in_the_cavity_is_told() {
    let told = |cavitation| {
        let problem = film(0.6, cavitation);
        let system = ring_system(120, 20, 0.04, None);
        let film = problem.solve(&system).expect("a film");
        let power = power(&film);
        power.cavity_shear / power.shear
    };
    let guembel = told(Cavitation::Guembel { pressure: 0.0 });
    assert!((guembel - 0.5).abs() < 5e-3, "{guembel}");
    let reynolds = told(Cavitation::Reynolds { pressure: 0.0 });
    assert!(reynolds > 0.2 && reynolds < 0.5, "{reynolds}");
    assert_eq!(told(Cavitation::None), 0.0);
}
