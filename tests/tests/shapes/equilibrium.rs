//! The position under a load in bores that are no circles.

use oilwedge_tests::tilted_bearings::{quantity, run, scene};

fn under(load: &str, tables: &str) -> String {
    scene(0.5, "\"1 %\"", &format!("[load]\n{load}\n{tables}"))
}

/// The load found at a position leads back to it: in a worn bore whose pit is under the load, and in an oval one.
#[test]
fn the_position_of_a_load_carries_it() {
    let worn = "[[bore]]\nworn = { depth = \"20 um\", angle = \"250 deg\", half_width = \"50 deg\" }";
    let oval = "[[bore]]\noval = { depth = \"10 um\", angle = \"0 deg\" }";
    for (tables, force) in [(worn, "20 kN"), (oval, "20 kN"), (worn, "60 kN")] {
        let found = run(&under(&format!("force = \"{force}\"\nangle = \"270 deg\""), tables));
        let of = |name: &str| quantity(&found, name)[0];
        assert!(found.balances.force < 1e-9, "{tables}: {:?}", found.balances);
        let keys = format!(
            "eccentricity = {}\nmin_film_angle = \"{} deg\"\n{tables}",
            of("eccentricity"),
            of("min_film_angle")
        );
        let back = run(&scene(0.5, "\"1 %\"", &keys));
        let [load, bar] = quantity(&back, "load");
        let wanted = 1e3 * force.trim_end_matches(" kN").parse::<f64>().expect("a number");
        assert!((load - wanted).abs() < 3.0 * bar + 2e-3 * wanted, "{tables} {force}: {load}");
        let [angle, _] = quantity(&back, "load_angle");
        assert!((angle - 270.0).abs() < 0.5, "{angle}");
    }
}

/// A journal may sink into a pit beyond the clearance of the circle.
#[test]
fn a_worn_bore_lets_the_journal_beyond_the_clearance() {
    let worn = "[[bore]]\nworn = { depth = \"25 um\", angle = \"270 deg\", half_width = \"80 deg\" }";
    let found = run(&under("force = \"200 kN\"\nangle = \"270 deg\"", worn));
    let [eps, _] = quantity(&found, "eccentricity");
    let [least, _] = quantity(&found, "film_thickness_min");
    assert!(eps > 1.0 && least > 0.0, "{eps} {least}");
}

/// A bore run in by a tilted journal leaves exactly the film asked for in that position.
#[test]
fn a_run_in_bore_leaves_the_film_of_its_positions() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("positions.csv");
    std::fs::write(&path, "e_x [um], e_y [um], g_x [mrad]\n45, 0, 0.3\n45, 0, -0.3\n").expect("a table");
    let keys = format!(
        "eccentricity = 0.9\nmin_film_angle = \"0 deg\"\ntilt = {{ x = \"0.3 mrad\" }}\n[[bore]]\nenvelope = {{ file = {:?}, film = \"4 um\" }}",
        path.display().to_string()
    );
    let found = run(&scene(0.5, "\"2 %\"", &keys));
    let [least, _] = quantity(&found, "film_thickness_min");
    assert!((least - 4e-6).abs() < 1e-12, "{least:e}");
}
