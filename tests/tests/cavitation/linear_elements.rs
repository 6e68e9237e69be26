//! The mass-conserving film on the vertices alone, by linear elements: the same scheme on a sub-mesh of its own.

use oilwedge_mesh::refine;
use oilwedge_reynolds::quantities::flow::flows;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::quantities::similarity::sommerfeld_number;
use oilwedge_scene::Scene;
use oilwedge_study::compile::compile;
use oilwedge_study::film::Film;
use oilwedge_tests::journal_bearings::{Ring, block, number, reference};
use oilwedge_tests::random_bearings::RandomBearing;
use oilwedge_tests::scenes::{path, table, variant};

/// Loads of linear elements on the mesh of `scene` and on that mesh refined so often.
fn loads(scene: &Scene, times: usize) -> Vec<f64> {
    let drawn = compile(scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let mut mesh = (**drawn.system.space().mesh()).clone();
    let mut loads = Vec::new();
    for _ in 0..=times {
        let finer = refine::uniform(&mesh).expect("a sound mesh").mesh;
        let study = linear(scene, mesh);
        let film = study.problem.solve(&study.system).expect("a film");
        loads.push(load(&film).magnitude());
        mesh = finer;
    }
    loads
}

fn linear(scene: &Scene, mesh: oilwedge_mesh::Mesh) -> Film {
    compile(scene).and_then(|model| model.film_on(mesh, &model.start(), 1)).unwrap_or_else(|error| panic!("{error}"))
}

/// Second order, towards Swift and Stieber's flooded ring of B/D 0.5 and eps 0.8 by a structured code (its last change:
/// 2e-4).
#[test]
fn flooded_ring_converges_with_order_two() {
    let ring = Ring { film_start: true, model: "jfo", size: Some(0.2), ..Ring::new(0.5, 0.8) };
    let scene = ring.scene();
    let loads = loads(&scene, 3);
    let limit = (4.0 * loads[3] - loads[2]) / 3.0;
    let errors: Vec<f64> = loads.iter().map(|load| (load / limit - 1.0).abs()).collect();
    for pair in errors[..3].windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((1.7..2.6).contains(&order), "order {order:.2} of {errors:?}");
    }
    let problem = compile(&scene).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}")).problem;
    let (bearing, viscosity) = (&problem.bearing, problem.lubricant.viscosity);
    let found = sommerfeld_number(bearing, viscosity, &problem.journal, limit).expect("a turning journal");
    let expected = number(&reference("plain360_swift_stieber", "rows")[18], "So");
    assert!((found / expected - 1.0).abs() < 5e-4, "{found} {expected}");
}

/// The groove of a structured code in Python (`tests/crosscheck/jfo_structured.py`): 1745.8 N, 2e-4; the streaks behind
/// the groove cost linear elements an order, so 1e-3 is asked of the extrapolated load.
#[test]
fn groove_bearing_has_the_load_of_the_structured_code() {
    let expected = number(&block("jfo_groove_bearing")["groove"], "F");
    let scene = variant("13_grooved_ring", |scene| {
        table(scene, "mesh").insert("size".into(), "8 mm".into());
    });
    let loads = loads(&scene, 2);
    let limit = (4.0 * loads[2] - loads[1]) / 3.0;
    assert!((limit / expected - 1.0).abs() < 1e-3, "{loads:?} {limit} {expected}");
}

/// Bearings by chance: the film on the vertices alone keeps its oil, wherever it is supplied.
#[test]
fn companions_conserve_oil() {
    let mut none = 0;
    for number in 1000..1040 {
        let study = compile(&RandomBearing::new(number).scene())
            .and_then(|model| model.film())
            .unwrap_or_else(|error| panic!("{error}"));
        let film = study.problem.solve(&study.system).expect("a film");
        let system = study.system.vertices_only();
        assert_eq!(system.space().dofs(), study.system.space().mesh().points().len());
        match film.coarse_comparison() {
            Ok(companion) => {
                let imbalance = flows(&companion).imbalance;
                assert!(imbalance < 1e-10, "{number}: {imbalance:e}");
            }
            Err(_) => none += 1,
        }
    }
    assert!(none <= 2, "{none} without");
}

/// Found from the film or cold, the companion is that of linear elements, also where oil is squeezed, but for the forms
/// chosen along the rupture line: a few thousandths of the greatest pressure there, 5e-5 of the load.
#[test]
fn companion_is_the_film_of_linear_elements() {
    for name in ["11_swift_stieber_ring", "15_squeezed_ring", "14_starved_pad"] {
        let scene = variant(name, |scene| {
            table(scene, "cavitation").insert("model".into(), "jfo".into());
            let journal = table(scene, "journal");
            if name.starts_with("15") {
                journal.insert("speed".into(), "100 rad/s".into());
                table(scene, "bearing").insert("film_start".into(), "180 deg".into());
            }
        });
        let quadratic = compile(&scene)
            .and_then(|model| model.film())
            .unwrap_or_else(|error| panic!("{}: {error}", path(name).display()));
        let film = quadratic.problem.solve(&quadratic.system).expect("a film");
        let companion = film.coarse_comparison().expect("a film");
        let study = linear(&scene, (**quadratic.system.space().mesh()).clone());
        let cold = study.problem.solve(&study.system).expect("a film");
        let most = cold.solution.unknown.iter().fold(0.0f64, |most, u| most.max(u.abs()));
        let off = (companion.solution.unknown.iter().zip(&cold.solution.unknown))
            .fold(0.0f64, |off, (a, b)| off.max((a - b).abs()));
        assert!(off < 5e-3 * most, "{name}: {:e}", off / most);
    }
}
