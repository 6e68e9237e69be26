//! Error bars of mass-conserving films: what finer meshes give lies inside, and they are not many times too wide.

use oilwedge_mesh::refine;
use oilwedge_reynolds::SolvedFilm;
use oilwedge_reynolds::error_bar::conserving::{ConservingError, conserving_error};
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_study::measure::{Measured, measure};
use oilwedge_tests::random_bearings::RandomBearing;
use oilwedge_tests::scenes::{table, variant, written};

fn film(study: &Film) -> SolvedFilm {
    study.problem.solve(&study.system).unwrap_or_else(|reason| panic!("{reason}"))
}

fn bars(film: &SolvedFilm) -> ConservingError {
    let companion = film.coarse_comparison().unwrap_or_else(|reason| panic!("{reason}"));
    let bars = conserving_error(film, &companion, None).expect("a mass-conserving film");
    let greatest = bars.load.total().max(bars.across.total());
    assert!(bars.indicator.iter().sum::<f64>() > (1.0 - 1e-12) * greatest);
    bars
}

/// Numbers of a film on the mesh of `study`, refined uniformly `times` times.
fn finer(study: &Film, times: usize) -> Measured {
    let mut mesh = (**study.system.space().mesh()).clone();
    for _ in 0..times {
        mesh = refine::uniform(&mesh).expect("a sound mesh").mesh;
    }
    let model = &study.model;
    let study = model.film_on(mesh, &model.start(), 2).unwrap_or_else(|error| panic!("{error}"));
    {
        let film = film(&study);
        measure(&film)
    }
}

/// A ring that breaks once, a groove and its streaks, a starved pad, a groove and holes.
#[test]
fn finer_meshes_lie_inside() {
    for (name, size, times) in [
        ("11_swift_stieber_ring", "8 mm", 2),
        ("13_grooved_ring", "8 mm", 1),
        ("14_starved_pad", "6 mm", 2),
        ("10_drawn_liner", "10 mm", 1),
    ] {
        let scene = variant(name, |scene| {
            table(scene, "cavitation").insert("model".into(), "jfo".into());
            table(scene, "mesh").insert("size".into(), size.into());
        });
        let study = compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
        let coarse_film = film(&study);
        let bars = bars(&coarse_film);
        assert!(bars.is_resolved, "{name}");
        let (coarse, fine) = (measure(&coarse_film), finer(&study, times));
        let side = |measured: &Measured| -measured.flows.regions[..2].iter().map(|flow| flow.net).sum::<f64>();
        let cavity = |measured: &Measured| measured.cavity.expect("a cavity");
        let turned = (coarse.load.angle() - fine.load.angle()).sin();
        for (what, error, bar) in [
            ("load", coarse.load.magnitude() - fine.load.magnitude(), bars.load.total()),
            ("load_x", coarse.load.total.force[0] - fine.load.total.force[0], bars.force[0].total()),
            ("load_y", coarse.load.total.force[1] - fine.load.total.force[1], bars.force[1].total()),
            ("angle", turned, bars.across.total() / coarse.load.magnitude()),
            (
                "pressure_integral",
                coarse.load.total.pressure - fine.load.total.pressure,
                bars.pressure_integral.total(),
            ),
            ("pressure_max", coarse.extremes.greatest - fine.extremes.greatest, bars.greatest_pressure),
            ("side_flow", side(&coarse) - side(&fine), bars.side_flow),
            ("cavity_share", cavity(&coarse).share - cavity(&fine).share, bars.cavity_share),
        ] {
            assert!(error.abs() <= bar, "{name}: {what} is {error:e} off, bar {bar:e}");
            assert!(what != "load" || bar < 60.0 * error.abs(), "{name}: {what} is {error:e} off, bar {bar:e}");
        }
    }
}

/// Bars of bearings by chance are finite, and shrink with the mesh.
#[test]
fn bars_shrink_with_the_mesh() {
    let mut ratios = Vec::new();
    for number in 2000..2009 {
        let scene = RandomBearing::new(number).scene();
        let study = compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
        let mesh = refine::uniform(study.system.space().mesh()).expect("a sound mesh").mesh;
        let finer = study.model.film_on(mesh, &study.model.start(), 2).unwrap_or_else(|error| panic!("{error}"));
        let [before, after] = [&study, &finer].map(|study| bars(&film(study)));
        assert!(before.load.total().is_finite() && before.flows.iter().all(|bar| bar.is_finite()));
        ratios.push(before.load.total() / after.load.total());
    }
    ratios.sort_by(f64::total_cmp);
    assert!((2.5..6.0).contains(&ratios[ratios.len() / 2]), "{ratios:.2?}");
}

/// A tilted journal whose film is thin at one end and fed by a hole near the middle, too little to fill it.
fn thin_end(size: &str) -> Scene {
    written(&format!(
        "title = \"Thin end\"\n\
         bearing = {{ diameter = \"100 mm\", length = \"120 mm\", clearance = \"50 um\" }}\n\
         oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"jfo\" }}\nmesh = {{ size = \"{size}\" }}\n\
         journal = {{ speed = \"-100 rad/s\", eccentricity = 0.63, min_film_angle = \"156 deg\", \
         tilt = {{ x = \"-0.33 mrad\", y = \"-0.33 mrad\" }} }}\n\
         [[feed]]\ngroup = \"hole\"\nhole = {{ diameter = \"28 mm\", angle = \"237 deg\", z = \"-11 mm\" }}\npressure = \"8 kPa\"\n"
    ))
}

fn forces(measured: &Measured) -> [f64; 4] {
    let carried = measured.load.total.resultant();
    let ([x, y], [m_x, m_y]) = (carried.force, carried.moment);
    [x, y, m_x / 0.06, m_y / 0.06]
}

/// Finer meshes lie inside the bars of all directions of force and moment, and a film that is thin at one end errs in
/// one of them.
#[test]
fn a_film_thin_at_one_end_errs_in_one_direction() {
    let scene = thin_end("10 mm");
    let study = compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let coarse_film = film(&study);
    let bars = bars(&coarse_film);
    let here = forces(&measure(&coarse_film));
    let there = forces(&finer(&study, 1));
    let mut totals = Vec::new();
    for direction in &bars.directions {
        let error: f64 = (0..4).map(|k| direction.direction[k] * (there[k] - here[k])).sum();
        let bar = direction.bar.total();
        assert!(error.abs() < bar, "{error} {bar}");
        totals.push(bar);
    }
    totals.sort_by(f64::total_cmp);
    assert!(totals.len() == 4 && totals[2] < 0.6 * totals[3], "{totals:?}");
}

/// Triangles that spread oil across the flow would feed what should starve: a coarser mesh lies in rows like its own,
/// and its film carries nearly as much.
#[test]
fn coarser_meshes_of_a_starved_film_carry_nearly_what_it_carries() {
    let study = compile(&thin_end("5 mm")).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let here = forces(&measure(&film(&study)));
    let coarser = study.system.coarser.as_ref().expect("a coarser mesh");
    let problem = coarser.problem(&study.problem);
    let coarse_film = problem.solve(&coarser.system).unwrap_or_else(|reason| panic!("{reason}"));
    let there = forces(&measure(&coarse_film));
    let size = here.iter().map(|x| x * x).sum::<f64>().sqrt();
    let off = (0..4).map(|k| (there[k] - here[k]).powi(2)).sum::<f64>().sqrt() / size;
    assert!(off < 0.05, "{off}");
}
