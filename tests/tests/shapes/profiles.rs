//! Force, moment and least film of profiled bores against finite volumes, by formula and by measured points.

use oilwedge_tests::journal_bearings::{each, number};
use oilwedge_tests::shaped_bearings::{block, bore, measured, scene_of};
use oilwedge_tests::tilted_bearings::{FORCE, MOMENT, numbers, quantity, rows, run};
use serde_json::Value;

/// How far force and moment of a run are from those of a row, over the greatest of each.
fn off(row: &Value, text: &str) -> [f64; 3] {
    let result = run(text);
    let of = |name: &str| quantity(&result, name)[0];
    let part = |found: [f64; 2], wanted: &[f64], least: f64| {
        let size = wanted.iter().fold(least, |most: f64, x| most.max(x.abs()));
        (0..2).map(|k| (found[k] - wanted[k]).abs()).fold(0.0, f64::max) / size
    };
    let (force, moment) = (numbers(&row["W"]), numbers(&row["m"]));
    let greatest = force.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    // A moment that vanishes by symmetry is small against the force at the end.
    let arm = number(row, "b") * greatest;
    let symmetric = moment.iter().all(|m| *m == 0.0);
    [
        part([of("load_x") / FORCE, of("load_y") / FORCE], &force, 0.0),
        part([of("moment_x") / MOMENT, of("moment_y") / MOMENT], &moment, if symmetric { arm } else { 0.0 }),
        (of("film_thickness_min") / 50e-6 / number(row, "hmin") - 1.0).abs(),
    ]
}

/// Force and moment within 5e-4 of the greatest; the finite volumes have their least film at nodes.
#[test]
fn profiles_are_those_of_finite_volumes() {
    each(&rows(&block("profiles")["rows"]), |row| {
        let name = row["profile"].as_str().expect("a name");
        let (table, _) = bore(name);
        let off = off(row, &scene_of(row, "\"0.02 %\"", table));
        match off[0] < 5e-4 && off[1] < 5e-4 && off[2] < 1e-3 {
            true => Ok(()),
            false => Err(format!("{name}: {off:?}")),
        }
    });
}

/// Bores of the reference, given by points of one degree and 20 positions along the axis.
#[test]
fn measured_points_give_the_same_film() {
    let folder = tempfile::tempdir().expect("a folder");
    let all = rows(&block("profiles")["rows"]);
    each(&[all[0].clone(), all[4].clone()], |row| {
        let name = row["profile"].as_str().expect("a name");
        let (_, depth) = bore(name);
        let path = folder.path().join(format!("{}.csv", name.replace(' ', "_")));
        let path = measured(&path, 0.1 * number(row, "b"), [360, 20], depth);
        let off = off(row, &scene_of(row, "\"0.1 %\"", &format!("file = {:?}", path.display().to_string())));
        match off[0] < 2e-3 && off[1] < 2e-3 && off[2] < 2e-3 {
            true => Ok(()),
            false => Err(format!("{name}: {off:?}")),
        }
    });
}

/// Noise of some tenths of the least film, and points too far apart, are warned of; the film is found nevertheless.
#[test]
fn noise_and_coarse_points_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let row = rows(&block("profiles")["rows"])[4].clone();
    let (table, depth) = bore(row["profile"].as_str().expect("a name"));
    // A scatter of +-3 um from a linear congruential generator.
    let mut state = 7u64;
    let mut scatter = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        if state >> 63 == 0 { 0.06 } else { -0.06 }
    };
    let noise: Vec<f64> = (0..360 * 20).map(|_| scatter()).collect();
    let noise = |phi: f64, part: f64| {
        let [i, j] = [phi.to_degrees(), 9.5 * (part + 1.0)].map(|place| place.round() as usize);
        noise[20 * (i % 360) + j]
    };
    let noisy =
        measured(&folder.path().join("noisy.csv"), 0.05, [360, 20], |phi, part| depth(phi, part) + noise(phi, part));
    let coarse = measured(&folder.path().join("coarse.csv"), 0.05, [8, 3], depth);
    let plain = run(&scene_of(&row, "\"1 %\"", table));
    for (path, code) in [(noisy, "noisy_points"), (coarse, "coarse_points")] {
        let text = scene_of(&row, "\"2 %\"", &format!("file = {:?}", path.display().to_string()));
        let found = run(&text);
        assert!(found.tail.warnings.iter().any(|warning| warning.kind.code == code), "{:?}", found.tail.warnings);
        let [load, smooth] = [&found, &plain].map(|result| quantity(result, "load")[0]);
        assert!((load / smooth - 1.0).abs() < 0.3, "{code}: {load} {smooth}");
    }
    assert!(plain.tail.warnings.iter().all(|warning| !warning.kind.code.ends_with("points")));
}
