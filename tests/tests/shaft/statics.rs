//! Shafts at rest on their films.

use oilwedge_study::RunOptions;
use oilwedge_study::quantities::*;
use oilwedge_study::result::Status;

use super::{changed, engines, numbers, run, run_with, text};

/// Reference of a bearing: W_x, W_y [N], g_x, g_y [c/R], least film [um].
type Bearing = [f64; 5];

const CLEARANCE: f64 = 30e-6;
const RADIUS: f64 = 30e-3;

/// Forces to 0.3 % of the load, least films to 1 %, tilts to 0.5 %, by structured finite volumes of a second code on all films, extrapolated.
fn compare(text: &str, bearings: [Bearing; 3]) {
    let run = run(text);
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    let columns = [&LOAD_X, &LOAD_Y, &TILT_X, &TILT_Y, &FILM_THICKNESS_MIN].map(|row| numbers(&run, row));
    let scale = CLEARANCE / RADIUS;
    let tilt = bearings.iter().map(|it| it[2].hypot(it[3])).fold(0.0, f64::max);
    for (number, bearing) in bearings.iter().enumerate() {
        let found = [0, 1, 2, 3, 4].map(|k: usize| columns[k][number]);
        println!("{number}: {found:?}");
        let force = bearing[0].hypot(bearing[1]);
        for k in 0..2 {
            assert!(
                (found[k] - bearing[k]).abs() < 3e-3 * force,
                "{number}, force {k}: {} {}",
                found[k],
                bearing[k]
            );
            let slope = found[k + 2] / scale;
            assert!(
                (slope - bearing[k + 2]).abs() < 5e-3 * tilt,
                "{number}, tilt {k}: {slope} {}",
                bearing[k + 2]
            );
        }
        let film = 1e6 * found[4];
        assert!(
            (film / bearing[4] - 1.0).abs() < 1e-2,
            "{number}, film: {film} {}",
            bearing[4]
        );
    }
    let balances = run.result.balances;
    assert!(
        balances.force < 1e-8 && balances.moment < 1e-8 && balances.journals < 1e-8,
        "{balances:?}"
    );
}

#[test]
fn three_films_share_the_loads_of_a_shaft() {
    let outer = |sign: f64| [-84.23, -4094.6, sign * 0.013229, sign * 0.16057, 6.11];
    compare(
        &text("three_films.toml"),
        [outer(-1.0), [168.46, -15811.0, 0.0, 0.0, 3.421], outer(1.0)],
    );
}

/// Place and least film are found with the shaft: none of them is exact.
#[test]
fn what_the_shaft_decides_is_not_reported_as_exact() {
    let run = run_with(&text("three_films.toml"), &RunOptions::default());
    for bearing in &run.result.bearings {
        let error = |row: &Row| bearing.quantity(row).expect(row.name).error();
        for row in [&ECCENTRICITY, &TILT_X, &FILM_THICKNESS_MIN] {
            assert_eq!(error(row), None, "{}", row.name);
        }
        assert!(error(&LOAD).is_some_and(|error| error > 0.0));
    }
}

#[test]
fn a_soft_support_leaves_its_load_to_the_others() {
    let soft = "at    = \"200 mm\"\nsupport = { stiffness = \"200 MN/m\" }";
    let outer = |sign: f64| [13.289, -6763.3, sign * 0.0043237, sign * 0.52062, 0.6155];
    // The film at an end is a fiftieth of the clearance: the mesh of the scene would leave it off by 2 %.
    let folder = tempfile::tempdir().expect("a folder");
    let scene = changed(&text("three_films.toml"), "at    = \"200 mm\"", soft);
    let fine = with_bearing(
        folder.path(),
        ("[journal]", "[mesh]\nsize = \"2 mm\"\n\n[journal]"),
        &scene,
    );
    compare(&fine, [outer(-1.0), [-26.578, -10473.0, 0.0, 0.0, 4.478], outer(1.0)]);
}

#[test]
fn crossed_loads_tilt_the_journals_every_way() {
    let second = "at    = \"300 mm\"\nforce = \"12 kN\"\nangle = \"270 deg\"";
    let across = "at    = \"300 mm\"\nforce = \"9 kN\"\nangle = \"0 deg\"";
    compare(
        &changed(&text("three_films.toml"), second, across),
        [
            [-376.17, -5336.8, 0.034798, -0.14291, 4.769],
            [5244.4, -7343.2, 0.09319, 0.20305, 4.711],
            [4131.8, 679.91, -0.18957, 0.099003, 6.776],
        ],
    );
}

/// A scene of three films with one part of that of their bearings changed, which then stands in a folder of its own.
pub(super) fn with_bearing(folder: &std::path::Path, (from, to): (&str, &str), scene: &str) -> String {
    let bearing = text("bearings/small_ring.toml");
    std::fs::write(folder.join("ring.toml"), changed(&bearing, from, to)).expect("a file");
    let path = folder.join("ring.toml");
    scene.replace("bearings/small_ring.toml", path.to_str().expect("a path"))
}

/// Films of a hundredth of the clearance hold a shaft as rigid knife edges do: 5/16, 11/8, 5/16 of one load.
#[test]
fn thin_films_are_knife_edges() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = changed(
        &text("three_films.toml"),
        "youngs_modulus = \"206 GPa\"",
        "youngs_modulus = \"206 GPa\"\ntilt = \"none\"",
    );
    let run = run(&with_bearing(folder.path(), ("\"30 um\"", "\"0.3 um\""), &scene));
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    for (force, part) in numbers(&run, &LOAD_Y).iter().zip([5.0 / 16.0, 11.0 / 8.0, 5.0 / 16.0]) {
        assert!((force / (-12e3 * part) - 1.0).abs() < 1e-2, "{force} {part}");
    }
}

/// Load [kN] of the right one of [`two_films`].
pub(super) const RIGHT: f64 = (12.0 * 0.1 + 0.22) / 0.4;

/// The shaft without its bearing in the middle, under 12 kN and 1 kN.
pub(super) fn two_films() -> String {
    let scene = text("three_films.toml");
    let middle =
        "[[crankshaft.bearing]]\nname  = \"middle\"\nscene = \"bearings/small_ring.toml\"\nat    = \"200 mm\"\n";
    let scene = changed(&scene, middle, "");
    changed(
        &scene,
        "at    = \"300 mm\"\nforce = \"12 kN\"",
        "at    = \"220 mm\"\nforce = \"1 kN\"",
    )
}

#[test]
fn two_films_bear_what_statics_gives_them() {
    let scene = two_films();
    let stiff = "youngs_modulus = \"206e6 GPa\"\ntilt = \"none\"";
    for of_shaft in [stiff, "youngs_modulus = \"206 GPa\"\nstatics = \"cut\""] {
        let run = run(&changed(&scene, "youngs_modulus = \"206 GPa\"", of_shaft));
        assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
        for (force, wanted) in numbers(&run, &LOAD_Y).iter().zip([13.0 - RIGHT, RIGHT]) {
            assert!((force / (-1e3 * wanted) - 1.0).abs() < 1e-9, "{force} {wanted}");
        }
    }
}

#[test]
fn bearings_of_what_is_not_solved_are_refused() {
    let refused = |change: (&str, &str)| {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = with_bearing(folder.path(), change, &text("three_films.toml"));
        let scene = oilwedge_scene::ShaftScene::parse(&scene, &engines("scene.toml")).expect("a scene");
        let error = oilwedge_study::shaft::run_shaft(&scene, &oilwedge_study::RunOptions::default());
        error.expect_err("refused").to_string()
    };
    let liner = "[liner]\nwinkler = \"0.02 um/MPa\"\n\n[journal]";
    for (change, key, way_out) in [
        (("\"reynolds\"", "\"jfo\""), "cavitation.model", "reynolds"),
        (("[journal]", liner), "liner", "remove [liner]"),
    ] {
        let told = refused(change);
        assert!(
            told.contains("ring.toml") && told.contains(key) && told.contains(way_out),
            "{told}"
        );
    }
}

/// What the peaks of rough surfaces carry is a part of the force of the film that statics asks for.
#[test]
fn peaks_that_touch_carry_a_part_of_the_shaft() {
    let scene = two_films();
    let cut = changed(
        &scene,
        "youngs_modulus = \"206 GPa\"",
        "youngs_modulus = \"206 GPa\"\nstatics = \"cut\"",
    );
    let rough = "[contact]\nmodel = \"greenwood-tripp\"\neta_beta_sigma = 0.05\nsigma_over_beta = 0.01\nmodulus = \"115 GPa\"\n\
                 hardness = \"900 MPa\"\nfriction = 0.1\n\n[journal]";
    let folder = tempfile::tempdir().expect("a folder");
    let bearing = changed(
        &text("bearings/small_ring.toml"),
        "\"30 um\"",
        "\"30 um\"\nroughness = \"3 um\"",
    );
    std::fs::write(folder.path().join("ring.toml"), changed(&bearing, "[journal]", rough)).expect("a file");
    let path = folder.path().join("ring.toml");
    let run = run(&cut.replace("bearings/small_ring.toml", path.to_str().expect("a path")));
    assert_eq!(run.result.status, Status::Converged, "{:?}", run.result.reason);
    for (force, wanted) in numbers(&run, &LOAD_Y).iter().zip([13.0 - RIGHT, RIGHT]) {
        assert!((force / (-1e3 * wanted) - 1.0).abs() < 1e-9, "{force} {wanted}");
    }
    let shares = numbers(&run, &CONTACT_SHARE);
    assert!(shares.iter().all(|share| *share > 1e-3 && *share < 0.9), "{shares:?}");
}
