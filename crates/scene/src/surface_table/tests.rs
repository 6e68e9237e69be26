//! What is a grid, and what is refused of one.

use super::*;

const RING: Covered = Covered { length: 0.04, arc: None };

/// Points of a grid of degrees and millimetres, as rows in lines.
fn rows(angles: &[f64], zs: &[f64]) -> Vec<TableRow<3>> {
    let points = angles.iter().flat_map(|&angle| zs.iter().map(move |&z| (angle, z)));
    let row = |(line, (angle, z)): (usize, (f64, f64))| TableRow {
        line,
        values: [angle.to_radians(), 1e-3 * z, 1e-6 * (angle.to_radians().cos() + z)],
    };
    (2..).zip(points).map(row).collect()
}

fn turn(step: usize) -> Vec<f64> {
    (0..360).step_by(step).map(|angle| angle as f64).collect()
}

fn fault(rows: Vec<TableRow<3>>, covered: Covered) -> String {
    grid(rows, covered).expect_err("no grid").in_file(Path::new("a.csv")).to_string()
}

#[test]
fn a_grid_is_read_in_any_order_with_or_without_its_last_angle() {
    let zs = [-20.0, 0.0, 20.0];
    let mut shuffled = rows(&turn(30), &zs);
    shuffled.reverse();
    let found = grid(shuffled, RING).expect("a grid");
    assert_eq!((found.angles.len(), found.zs.len()), (12, 3));
    assert!((found.depths[3][2] - 1e-6 * (20.0 + 90f64.to_radians().cos())).abs() < 1e-18);
    let mut repeated = turn(30);
    repeated.push(360.0);
    assert_eq!(grid(rows(&repeated, &zs), RING).expect("a grid"), found);
    let arc = Covered { arc: Some(Arc { from: 1.0, to: 1.0 + 90f64.to_radians() }), ..RING };
    grid(rows(&[57.0, 80.0, 110.0, 147.0], &zs), arc).expect("a grid");
    assert_eq!(grid(rows(&[0.0], &zs), RING).expect("a grid").angles.len(), 1);
}

#[test]
fn what_is_no_grid_is_told() {
    let zs = [-20.0, 0.0, 20.0];
    let mut holed = rows(&turn(30), &zs);
    holed.remove(4);
    assert!(
        fault(holed, RING).contains("of 12 angles at 3 axial positions 1 have no depth, the first at 30 deg, z = 0 mm")
    );
    let mut twice = rows(&turn(30), &zs);
    let first = twice[0];
    twice.push(first);
    assert!(fault(twice, RING).contains("stands in line 2 already"));
    assert!(fault(rows(&turn(30), &[-10.0, 0.0, 2.0]), RING).contains("reach from z = -10 mm to 2 mm"));
    assert!(fault(rows(&turn(30), &[0.0]), RING).contains("one axial position only"));
    assert!(fault(Vec::new(), RING).contains("no points"));
    assert!(fault(rows(&[0.0, 30.0, 60.0, 90.0], &zs), RING).contains("the liner all around"));
    let mut open = turn(30);
    open.push(360.0);
    let mut open = rows(&open, &zs);
    let last = open.len() - 1;
    open[last].values[2] += 1e-6;
    assert!(fault(open, RING).contains("but has another depth"));
}

#[test]
fn noise_is_found_and_shapes_are_none() {
    let zs = [-20.0, 0.0, 20.0];
    let mut surface = grid(rows(&turn(1), &zs), RING).expect("a grid");
    let smooth = surface.noise();
    assert!(smooth < 1e-11, "{smooth:e}");
    // Independent errors of +-0.3 um from a linear congruential generator.
    let mut state = 12345u64;
    for depth in surface.depths.iter_mut().flatten() {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        *depth += if state >> 63 == 0 { 3e-7 } else { -3e-7 };
    }
    let noise = surface.noise();
    assert!((noise / 3e-7 - 1.0).abs() < 0.1, "{noise:e}");
}

#[test]
fn positions_are_those_of_a_table_or_of_an_orbit() {
    let given = positions("e_x [um], e_y [um], g_y [mrad]\n10, -20, 0.5\n", 4e-5).expect("positions");
    let orbit = "crank angle [deg],time [s],e_x/c [1],e_y/c [1],load error [N],tilt_x [rad],tilt_y [rad]\n0,0,0.25,-0.5,,0,5e-4\n";
    let orbit = positions(orbit, 4e-5).expect("positions");
    for (a, b) in [(given[0].offset, orbit[0].offset), (given[0].tilt, orbit[0].tilt)] {
        assert!((a[0] - b[0]).abs() < 1e-18 && (a[1] - b[1]).abs() < 1e-18, "{a:?} {b:?}");
    }
    let fault = |text: &str| positions(text, 4e-5).expect_err(text).in_file(Path::new("a.csv")).to_string();
    assert!(fault("e_x [um], e_y [um], load [N]\n1, 2, 3\n").contains("the column \"load\" is not known"));
    assert!(fault("e_x/c [1], load [N]\n1, 2\n").contains("there is no column \"e_y/c\""));
    assert!(fault("e_x [um], e_y [um]\n").contains("has no positions"));
}
