//! Stiffness, damping and critical masses of bearings in tables.

use oilwedge_bearing::dynamics::Square;
use oilwedge_study::result::{Matrix, RunResult, Stable};
use oilwedge_tests::journal_bearings::{each, number};
use oilwedge_tests::tilted_bearings::{FORCE, block, numbers, quantity, rows, run, scene};
use serde_json::Value;

/// Unit of stiffness `mu omega R^2/(psi^2 c)` [N/m] of the scenes, whose speed is 300 rad/s and whose clearance is 50 um.
const STIFFNESS: f64 = FORCE / 50e-6;
const RADIUS: f64 = 0.05;

fn square(list: &Value) -> Square {
    let rows: Vec<Vec<f64>> = rows(list).iter().map(numbers).collect();
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| rows[i][j]))
}

/// Rings straight and tilted: 0.5 % of `sqrt(K_ii K_jj)`.
#[test]
fn sixteen_coefficients_are_those_of_finite_volumes() {
    each(&rows(&block("dynamic_4x4")), |row| {
        let [g_x, g_y] = ["gamma_x", "gamma_y"].map(|key| 1e-3 * number(row, key));
        let keys = format!(
            "eccentricity = {}\nmin_film_angle = \"0 deg\"\ntilt = {{ x = \"{g_x} rad\", y = \"{g_y} rad\" }}\n[dynamics]",
            number(row, "eps")
        );
        let result = run(&scene(number(row, "b"), "\"0.02 %\"", &keys));
        let found = &result.dynamics.as_ref().ok_or("no coefficients")?.coefficients[0].in_bearing;
        let arm = |place: usize| if place < 2 { 1.0 } else { RADIUS };
        for (name, found, wanted, unit) in [
            ("K", &found.stiffness, square(&row["K"]), STIFFNESS),
            ("C", &found.damping, square(&row["C"]), STIFFNESS / 300.0),
        ] {
            for i in 0..4 {
                for j in 0..4 {
                    let value = found[i][j] / (unit * arm(i) * arm(j));
                    let off = (value - wanted[i][j]).abs() / (wanted[i][i] * wanted[j][j]).sqrt();
                    if off > 5e-3 {
                        return Err(format!("{name} {i} {j}: {value}, not {}, off by {off:e}", wanted[i][j]));
                    }
                }
            }
        }
        Ok(())
    });
}

/// Two by two, in a row of a table: `xx xy yx yy`.
fn entries(matrix: &Matrix) -> [f64; 4] {
    [matrix[0][0], matrix[0][1], matrix[1][0], matrix[1][1]]
}

/// `M_crit c omega^2/W` and the whirl ratio; `None` of a rotor that is stable with any mass.
fn threshold(result: &RunResult) -> Option<[f64; 2]> {
    let rotor = result.dynamics.as_ref().expect("coefficients").rotor;
    match rotor.stable {
        Stable::WithAnyMass => None,
        Stable::BelowCriticalMass => Some([
            rotor.critical_mass_without_dimension.expect("a mass"),
            quantity(result, "whirl_ratio")[0],
        ]),
        other => panic!("{other:?}"),
    }
}

/// Grooves of 20 degrees at 90 degrees from the load, L/D = 1/2: K and C to 1 % of the greatest of a row, and below eps 0.75 the critical mass to 1 % and the
/// whirl ratio to 0.005.
#[test]
fn two_grooves_of_lund_and_thomsen() {
    let block = block("lund_thomsen_recomputed");
    let stability = rows(&block["stability"]);
    let both: Vec<Value> = rows(&block["rows"])
        .into_iter()
        .zip(stability)
        .map(|(row, stability)| serde_json::json!({ "row": row, "stability": stability }))
        .collect();
    each(&both, |row| {
        let (of, stability) = (numbers(&row["row"]), rows(&row["stability"]));
        let groove = |name: &str, from: f64| {
            format!(
                "[[feed]]\ngroup = \"{name}\"\npressure = \"0 bar\"\ngroove = {{ from = \"{from} deg\", to = \"{} deg\", width = \"50 mm\", z = \"0 mm\" }}\n",
                from + 20.0
            )
        };
        let keys = format!(
            "eccentricity = {}\nmin_film_angle = \"{} deg\"\n[dynamics]\n{}{}",
            of[0],
            of[2],
            groove("left", 80.0),
            groove("right", 260.0)
        );
        // Near the threshold of stability with any mass the critical mass depends much on K and C.
        let tolerance = if (0.6..0.75).contains(&of[0]) {
            "\"0.0003 %\""
        } else {
            "\"0.02 %\""
        };
        let result = run(&scene(0.5, tolerance, &keys));
        let found = result.dynamics.as_ref().ok_or("no coefficients")?;
        let found = found.coefficients[0].without_dimension.as_ref().ok_or("no load")?;
        let number = 1.0 / (2.0 * std::f64::consts::PI * quantity(&result, "sommerfeld_number")[0]);
        if (number / of[1] - 1.0).abs() > 5e-3 {
            return Err(format!("S {number}, not {}", of[1]));
        }
        for (name, found, wanted) in [
            ("K", entries(&found.stiffness), &of[3..7]),
            ("C", entries(&found.damping), &of[7..11]),
        ] {
            for k in 0..4 {
                let greatest = wanted[k - k % 2].abs().max(wanted[k - k % 2 + 1].abs());
                if (found[k] - wanted[k]).abs() > 1e-2 * greatest {
                    return Err(format!("{name} {found:?}, not {wanted:?}"));
                }
            }
        }
        let wanted = stability[3].as_f64().zip(stability[4].as_f64());
        match (threshold(&result), wanted) {
            (Some([mass, ratio]), Some((whirl, critical))) if of[0] < 0.75 => {
                match (mass / critical - 1.0).abs() < 1e-2 && (ratio - whirl).abs() < 5e-3 {
                    true => Ok(()),
                    false => Err(format!("M_crit {mass}, not {critical}; whirl {ratio}, not {whirl}")),
                }
            }
            (Some(_), Some(_)) | (None, None) => Ok(()),
            (found, wanted) => Err(format!("stability {found:?}, not {wanted:?}")),
        }
    });
}

/// Short bearing, half film: K, C and the critical mass to 1e-3; stable with any mass from eps 0.75 to 0.76 on.
#[test]
fn short_bearings_with_a_half_film() {
    each(&rows(&block("short_bearing_KC")["rows"]), |row| {
        let eps = number(row, "eps");
        let keys = format!("eccentricity = {eps}\nmin_film_angle = \"0 deg\"\n[dynamics]");
        let text = scene(0.5, "\"0.002 %\"", &keys)
            .replacen("clearance = \"50 um\"", "clearance = \"50 um\", theory = \"short\"", 1)
            .replacen("\"reynolds\"", "\"guembel\"", 1);
        let result = run(&text);
        let found = result.dynamics.as_ref().ok_or("no coefficients")?;
        let found = found.coefficients[0].without_dimension.as_ref().ok_or("no load")?;
        for (name, found) in [("K", &found.stiffness), ("C", &found.damping)] {
            let (found, wanted) = (entries(found), numbers(&row[name]));
            let greatest = wanted.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
            if (0..4).any(|k| (found[k] - wanted[k]).abs() > 1e-3 * wanted[k].abs().max(0.1 * greatest)) {
                return Err(format!("{name} {found:?}, not {wanted:?}"));
            }
        }
        match (threshold(&result), row["M_crit"].as_f64()) {
            (Some([mass, _]), Some(wanted)) if (mass / wanted - 1.0).abs() < 1e-3 => Ok(()),
            (None, None) => Ok(()),
            (found, wanted) => Err(format!("stability {found:?}, not {wanted:?}")),
        }
    });
}
