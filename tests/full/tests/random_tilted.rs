//! A few of the random tilted bearings that the program `tilted` of these tests solves by the hundred: those that take
//! milliseconds.

use oilwedge_full::random_tilted::{TiltedBearing, solved};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_tests::journal_bearings::each;

/// Given, held and free tilts with holes and grooves: each converges, and force and moment balance to 1e-10.
#[test]
fn random_tilted_bearings_converge() {
    each(&[7, 27, 28, 30, 32, 33], |&number: &u64| {
        let (result, fault) = solved(&TiltedBearing::new(number));
        match (result.head.status, fault) {
            (Status::Converged, None) => Ok(()),
            (status, fault) => Err(format!("{number}: {status:?} {:?} {fault:?}", result.head.reason)),
        }
    });
}

/// A coarse mesh shows contact long before the film does: the balance is found on meshes that resolve the thin film at
/// the end.
#[test]
fn contact_is_judged_by_a_mesh_that_resolves_it() {
    let (result, fault) = solved(&TiltedBearing::new(51));
    assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
    assert!(fault.is_none(), "{fault:?}");
}

/// A journal on an elastic liner that tips over is reported as such.
#[test]
fn walls_that_give_way_leave_a_reason() {
    let (result, fault) = solved(&TiltedBearing::with_walls(94));
    assert_eq!(result.head.status, Status::NoSolution, "{fault:?}");
    let reason = result.head.reason.unwrap_or_default();
    assert!(reason.contains("tips over"), "{reason}");
}

/// A film of 2 thousandths of the clearance at one end only is resolved by thin cells there, on less than 5 000
/// unknowns: with cells as short all around and all along the bearing its first mesh had 34 000.
#[test]
fn a_thin_film_at_one_end_has_thin_cells_there_alone() {
    let (result, fault) = solved(&TiltedBearing::new(219));
    assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
    assert!(fault.is_none(), "{fault:?}");
    let thinnest = result.quantities.iter().find(|quantity| quantity.name == "film_thickness_min");
    let thinnest = thinnest.expect("a film").value;
    assert!(thinnest < 0.3e-6, "{thinnest}");
    // On the very first mesh the film is no thicker than its bar.
    let mut resolved = result.levels.iter().filter(|level| !level.errors.is_empty());
    let first = resolved.next().expect("a mesh that resolves the film");
    assert!(first.unknowns < 5_000, "{first:?}");
    assert!(first.errors[0].1 < 0.01, "{first:?}");
}

/// A full film carries a moment up to a fold, beyond which it resists tilt no more. With a part of the moment below
/// that of the fold the journal is balanced, with one above it is not, and the reason says so.
#[test]
fn a_journal_that_tips_over_is_told() {
    let bearing = TiltedBearing::new(26);
    let of = |result: &RunResult| result.head.reason.clone().unwrap_or_default();
    let (whole, _) = solved(&bearing);
    assert_eq!(whole.head.status, Status::NoSolution, "{}", of(&whole));
    let reason = of(&whole);
    let part = reason.split("at most ").nth(1).and_then(|rest| rest.split(' ').next());
    let part: f64 = part.and_then(|part| part.parse().ok()).unwrap_or_else(|| panic!("{reason}"));
    assert!(reason.contains("tips over") && part > 5.0 && part < 30.0, "{reason}");
    // The whole moment about mid-length, z_F F + M.
    let with = |share: f64| {
        let [x, y] = [6.1, 41.2].map(|moment: f64| share * moment);
        let mut text = String::new();
        for line in bearing.text.lines().filter(|line| !line.starts_with("at = ")) {
            match line.starts_with("moment = ") {
                true => text += &format!("moment = {{ x = \"{x} N.m\", y = \"{y} N.m\" }}\n"),
                false => text += &format!("{line}\n"),
            }
        }
        solved(&TiltedBearing { text, ..bearing.clone() }).0
    };
    let (below, above) = (with(0.9e-2 * part), with(1.2e-2 * part));
    assert_eq!(below.head.status, Status::Converged, "{}", of(&below));
    // Above it the film has tipped over: what carries the moment, if anything does, is tilted further than the fold.
    let slope = reason.split("a slope of ").nth(1).and_then(|rest| rest.split(' ').next());
    let slope: f64 = slope.and_then(|slope| slope.parse().ok()).unwrap_or_else(|| panic!("{reason}"));
    let tilt = |result: &RunResult| {
        let [x, y] = ["tilt_x", "tilt_y"].map(|name| result.by_name(name).map_or(f64::INFINITY, |it| it.value));
        1e3 * x.hypot(y)
    };
    assert!(slope < tilt(&above) && tilt(&below) < tilt(&above), "{} {slope} {}", tilt(&below), tilt(&above));
}
