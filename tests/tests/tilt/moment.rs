//! Force and moment of tilted rings against two independent codes.

use oilwedge_study::result::RunResult;
use oilwedge_tests::journal_bearings::{each, number};
use oilwedge_tests::tilted_bearings::{FORCE, MOMENT, block, numbers, quantity, rows, run, scene};

/// The numbers of a run by name and what they should be, each with the size that differences count against: `part` of
/// it, and the bar must hold.
fn compare(result: &RunResult, wanted: &[(&str, f64, f64)], part: f64) -> Result<(), String> {
    for &(name, wanted, size) in wanted {
        let [value, bar] = quantity(result, name);
        let off = (value - wanted).abs();
        // The reference has five digits.
        if off > part * size || off > bar + 2e-5 * size {
            return Err(format!("{name}: {value} (bar {bar}), wanted {wanted}"));
        }
    }
    Ok(())
}

/// Periodic rings with Swift-Stieber cavities, by finite volumes; 5e-4 of the greatest part of force and moment.
#[test]
fn forces_and_moments_are_those_of_finite_volumes() {
    each(&rows(&block("dynamic_4x4")), |row| {
        let [g_x, g_y] = ["gamma_x", "gamma_y"].map(|key| 1e-3 * number(row, key));
        let keys = format!(
            "eccentricity = {}\nmin_film_angle = \"0 deg\"\ntilt = {{ x = \"{g_x} rad\", y = \"{g_y} rad\" }}",
            number(row, "eps")
        );
        let tolerance = "{ load = \"0.2 %\", moment_x = \"0.3 %\", moment_y = \"1 %\" }";
        let result = run(&scene(number(row, "b"), tolerance, &keys));
        let (force, moment) = (numbers(&row["W"]), numbers(&row["m"]));
        let greatest = |of: &[f64]| of.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        // Moments of straight journals vanish: against a thousandth of the force at an end.
        let (of_force, of_moment) = (greatest(&force), greatest(&moment).max(number(row, "b") * greatest(&force)));
        let wanted = [
            ("load_x", FORCE * force[0], FORCE * of_force),
            ("load_y", FORCE * force[1], FORCE * of_force),
            ("moment_x", MOMENT * moment[0], MOMENT * of_moment),
            ("moment_y", MOMENT * moment[1], MOMENT * of_moment),
        ];
        compare(&result, &wanted, 5e-4)?;
        let least = quantity(&result, "film_thickness_min")[0] / 50e-6;
        let moment_balance = result.balances.moment;
        match (least - number(row, "hmin")).abs() < 1e-6 && moment_balance < 1e-12 {
            true => Ok(()),
            false => Err(format!("h_min {least}, {row}, torque off by {moment_balance}")),
        }
    });
}

/// Rings with a film start, recomputed to a thousandth: `zeta = z/(B/2)`, slopes in `c/(B/2)`, moments scaled as So
/// over the half length.
#[test]
fn misaligned_rings_with_a_film_start() {
    let block = block("misaligned_plain360");
    each(&rows(&block["rows"]), |row| {
        let [ratio, eps, g_x, g_y, so, beta, p_max, h_min, m_x, m_y] = numbers(row)[..] else {
            return Err(format!("{row} is no row"));
        };
        let half = 0.05 * ratio;
        let slope = [g_x, g_y].map(|g| g * 50e-6 / half);
        let keys = format!(
            "eccentricity = {eps}\nmin_film_angle = \"180 deg\"\ntilt = {{ x = \"{} rad\", y = \"{} rad\" }}",
            slope[0], slope[1]
        );
        let text = scene(ratio, "{ load = \"0.2 %\", pressure_max = \"0.3 %\" }", &keys).replacen(
            "clearance = \"50 um\"",
            "clearance = \"50 um\", film_start = \"0 deg\"",
            1,
        );
        let result = run(&text);
        let scaled = |name: &str| -0.25 * quantity(&result, name)[0] / (MOMENT * ratio);
        let found = [
            (quantity(&result, "sommerfeld_number")[0], so, so),
            (quantity(&result, "attitude_angle")[0], beta, 57.3),
            (quantity(&result, "pressure_max")[0] / 6e6, p_max, p_max),
            (quantity(&result, "film_thickness_min")[0] / 50e-6, h_min, 1.0),
            (scaled("moment_x"), m_x, so),
            (scaled("moment_y"), m_y, so),
        ];
        match found.iter().all(|(value, wanted, size)| (value - wanted).abs() < 2e-3 * size) {
            true => Ok(()),
            false => Err(format!("{row}: {found:?}")),
        }
    });
}

/// A hole beside mid-length: its part of the moment is that of its load at its place, by symmetry of the disc.
#[test]
fn a_hole_counts_with_its_arm() {
    let keys = "eccentricity = 0.3\nmin_film_angle = \"0 deg\"\ntilt = {}\n\
                [[feed]]\ngroup = \"hole\"\npressure = \"30 bar\"\nhole = { diameter = \"6 mm\", angle = \"60 deg\", z = \"12 mm\" }";
    let result = run(&scene(0.5, "\"2 %\"", keys));
    let [[m_x, _], [m_y, _]] = ["moment_x", "moment_y"].map(|name| quantity(&result, name));
    let [[z, bar], [x, _], [y, _]] = ["load_z", "load_x", "load_y"].map(|name| quantity(&result, name));
    assert!((z - (m_x * x + m_y * y) / (x * x + y * y)).abs() < 1e-15 && bar > 0.0);
    // The feed pushes at z > 0, towards its angle.
    assert!(m_x > 0.0 && m_y > 0.0, "{m_x} {m_y}");
    let straight = run(&scene(0.5, "\"2 %\"", &keys.replacen("tilt = {}\n", "", 1)));
    assert!(straight.by_name("moment_x").is_none());
    let [load, _] = quantity(&straight, "load");
    assert!((load - x.hypot(y)).abs() < 1e-12 * load);
}
