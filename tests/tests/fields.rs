//! Fields of a film: what the numbers of the report are integrals of.

use oilwedge_study::picture::{FieldChoice, FieldValues, FilmPicture, PictureOptions, Surface, picture};
use oilwedge_tests::bench::Bench;
use oilwedge_tests::scenes::{Solved, solve, table, variant};

const RADIUS: f64 = 0.0375;
const FLOW: &str = "volume_flow [m2/s]";
const ON_JOURNAL: &str = "shear_stress_journal [Pa]";
const ON_BEARING: &str = "shear_stress_bearing [Pa]";

/// The ring of scene 09 with a cavity, fed where it is widest.
fn ring(model: &str, size: &str) -> Solved {
    let scene = variant("09_drawn_ring", |scene| {
        table(scene, "cavitation").insert("model".into(), model.into());
        table(scene, "bearing").insert("film_start".into(), "0 deg".into());
        table(scene, "mesh").insert("size".into(), size.into());
    });
    solve(&scene).expect("a film")
}

/// All fields on a surface.
fn drawn_on(surface: Surface) -> PictureOptions {
    PictureOptions { surface, fields: FieldChoice::All }
}

fn vectors<'a>(picture: &'a FilmPicture, name: &str) -> &'a [[f64; 3]] {
    match picture.at_points(name) {
        Some(FieldValues::Vectors(values)) => values,
        other => panic!("{name}: {other:?}"),
    }
}

/// `Int f dA` of a field on the unrolled liner: quadratics are integrated by the middles of edges.
fn integral(picture: &FilmPicture, value: impl Fn(usize) -> f64) -> f64 {
    let cell = |cell: &[u32; 6]| {
        let [a, b, c] = [0, 1, 2].map(|k| picture.points[cell[k] as usize]);
        let twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        twice / 6.0 * cell[3..].iter().map(|&node| value(node as usize)).sum::<f64>()
    };
    picture.cells.iter().map(cell).sum()
}

/// Torques are the moments of the stresses: T that against which the journal is turned, T_b that with which the bearing
/// is held.
#[test]
fn torques_are_integrals_of_the_stresses() {
    for (model, share) in [("none", 1e-4), ("guembel", 5e-3), ("reynolds", 2e-3), ("jfo", 5e-3)] {
        let film = ring(model, "3 mm");
        let drawn = picture(&film.study, &film.film, None, drawn_on(Surface::Developed));
        for (name, sign, quantity) in
            [(ON_JOURNAL, -1.0, "friction_torque"), (ON_BEARING, 1.0, "friction_torque_bearing")]
        {
            let stress = vectors(&drawn, name);
            let torque = sign * RADIUS * integral(&drawn, |node| stress[node][0]);
            let expected = film.quantity(quantity);
            assert!((torque / expected - 1.0).abs() < share, "{model} {name}: {torque} {expected}");
        }
    }
}

/// What crosses each end, and every line around: the flow has no divergence in a film that conserves oil.
#[test]
fn side_flow_is_the_axial_flow_over_the_ends() {
    let film = ring("jfo", "2 mm");
    let drawn = picture(&film.study, &film.film, None, drawn_on(Surface::Developed));
    let flow = vectors(&drawn, FLOW);
    let mut out = 0.0;
    for cell in &drawn.cells {
        for k in 0..3 {
            let nodes = [cell[k], cell[(k + 1) % 3], cell[3 + k]].map(|node| node as usize);
            let [a, b, _] = nodes.map(|node| drawn.points[node]);
            if a[1].abs() > 0.9999 * RADIUS && (a[1] - b[1]).abs() < 1e-9 {
                let across = nodes.map(|node| flow[node][1] * a[1].signum());
                out += (a[0] - b[0]).abs() / 6.0 * (across[0] + across[1] + 4.0 * across[2]);
            }
        }
    }
    let expected = film.quantity("side_flow");
    assert!((out / expected - 1.0).abs() < 0.02, "{out} {expected}");
}

/// Vectors drawn on the cylinder are tangential to it everywhere, and as long as those drawn in the plane.
#[test]
fn vectors_turn_with_the_cylinder() {
    let film = ring("reynolds", "6 mm");
    let [plane, round] =
        [Surface::Developed, Surface::Cylinder].map(|it| picture(&film.study, &film.film, None, drawn_on(it)));
    for name in [FLOW, ON_JOURNAL, ON_BEARING] {
        let sizes = |picture: &FilmPicture| {
            let size = |vector: &[f64; 3]| vector.iter().map(|part| part * part).sum::<f64>().sqrt();
            vectors(picture, name).iter().map(size).fold(0.0, f64::max)
        };
        assert!((sizes(&plane) / sizes(&round) - 1.0).abs() < 1e-12, "{name}");
        for (vector, point) in vectors(&round, name).iter().zip(&round.points) {
            let outwards = (vector[0] * point[0] + vector[1] * point[1]) / RADIUS;
            assert!(outwards.abs() < 1e-12 * sizes(&round), "{name}: {outwards}");
        }
    }
    let numbers = |picture: &FilmPicture, name| picture.at_points(name).expect("a field").numbers().to_vec();
    let (angles, heights) = (numbers(&round, "phi [deg]"), numbers(&round, "z [m]"));
    for ((angle, z), point) in angles.iter().zip(&heights).zip(&round.points) {
        let (sin, cos) = angle.to_radians().sin_cos();
        assert!((0.0..360.0).contains(angle) && *z == point[2]);
        assert!((RADIUS * cos - point[0]).hypot(RADIUS * sin - point[1]) < 1e-12);
    }
    // In the plane the angle runs on to the far side of the cut.
    let greatest = numbers(&plane, "phi [deg]").into_iter().fold(0.0, f64::max);
    assert!((greatest - 360.0).abs() < 1e-6, "{greatest}");
}

/// A feed gives the pressure: there is no film under it, and nothing is sheared.
#[test]
fn no_stress_under_a_feed() {
    let film = solve(&variant("13_grooved_ring", |_| {})).expect("a film");
    let drawn = picture(&film.study, &film.film, None, drawn_on(Surface::Developed));
    let stress = vectors(&drawn, ON_BEARING);
    let torque = film.quantity("friction_torque_bearing");
    let radius = film.study.problem.bearing.radius;
    let moment = radius * integral(&drawn, |node| stress[node][0]);
    assert!((moment / torque - 1.0).abs() < 0.05, "{moment} {torque}");
}

/// The names that scripts know stay; every array has its unit as an information key of VTK.
#[test]
fn arrays_of_the_file_have_units() {
    let bench = Bench::new();
    bench.scene("09_drawn_ring", &[]);
    let told = bench.run(&["solve", "scene.toml", "--out", "out", "--fields", "all"]);
    assert_eq!(told.status, 0, "{}", told.stderr);
    let file = std::fs::read(bench.path().join("out/film.vtu")).expect("a picture");
    let text = String::from_utf8(file).expect("text");
    for (name, unit) in [
        ("pressure", "Pa"),
        ("film_thickness", "m"),
        ("viscosity", "Pa.s"),
        ("phi [deg]", "deg"),
        ("z [m]", "m"),
        (FLOW, "m2/s"),
        (ON_JOURNAL, "Pa"),
        (ON_BEARING, "Pa"),
        ("error_indicator", "N"),
    ] {
        let begin = text.find(&format!("Name=\"{name}\"")).unwrap_or_else(|| panic!("no {name}"));
        let array = text[begin..].split("</DataArray>").next().expect("an array");
        let key = format!("<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">{unit}</InformationKey>");
        assert!(array.ends_with(&key), "{name}: {}", &array[array.len().min(200)..]);
    }
}
