//! Error bars of films with elastic walls hold the numbers of finer meshes; what the wall takes back of an error is
//! that of closed films.

use oilwedge_bearing::deflection::{CLOSED, closed_film, closed_pair, following_wall};
use oilwedge_reynolds::Cavitation;
use oilwedge_reynolds::error_bar::film_error;
use oilwedge_reynolds::quantities::load::{Resultant, load};
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_study::result::RunResult;
use oilwedge_tests::elastic_liner::{carried, closed, layer, walled};
use oilwedge_tests::tilted_bearings::{quantity, run, tilted};
use oilwedge_tests::*;

use oilwedge_tests::rough_surfaces::contacts;

/// A ring on a mesh of this size, with a table of a liner.
fn found(size: &str, eps: f64, model: &str, liner: &str) -> RunResult {
    let result = run(&format!(
        "bearing = {{ diameter = \"100 mm\", length = \"50 mm\", clearance = \"50 um\" }}\nmesh.size = \"{size}\"\n\
         oil.viscosity = \"20 mPa.s\"\ncavitation.model = \"{model}\"\n\
         journal = {{ speed = \"300 rad/s\", eccentricity = {eps}, min_film_angle = \"0 deg\" }}\n{liner}\n"
    ));
    assert_eq!(result.head.reason, None);
    result
}

#[test]
fn bars_hold_the_numbers_of_finer_meshes() {
    const WALL: &str = "liner.wall = { thickness = \"50 mm\", modulus = \"210 GPa\", poisson = 0.3 }";
    const SOFT: &str = "liner.winkler = \"0.167 um/MPa\"";
    let mut missed = Vec::new();
    let mut compared = 0;
    for (eps, model, liner) in [(0.8, "reynolds", WALL), (0.7, "none", SOFT)] {
        let fine = found("2.5 mm", eps, model, liner);
        for size in ["12 mm", "6 mm"] {
            let coarse = found(size, eps, model, liner);
            let names = [
                "load",
                "attitude_angle",
                "pressure_max",
                "film_thickness_min",
                "deflection_max",
                "side_flow",
                "friction_torque",
            ];
            for name in names {
                let ([value, bar], [better, rest]) = (quantity(&coarse, name), quantity(&fine, name));
                compared += 1;
                if (value - better).abs() > bar + rest {
                    missed.push(format!("{model} {size} {name}: {value} +- {bar}, {better} +- {rest}"));
                }
            }
        }
    }
    assert!(missed.is_empty(), "{} of {compared}: {missed:#?}", missed.len());
}

/// A layer moves by the pressure on it alone. Where no pressure is negative its least film is that of the rigid wall,
/// at an open end.
#[test]
fn bars_hold_the_film_of_the_rigid_wall_at_the_ends() {
    const RIGID: f64 = 1e-5;
    let mut missed = Vec::new();
    for layer in [0.2, 10.0] {
        for size in ["12 mm", "5 mm"] {
            let film = found(size, 0.8, "reynolds", &format!("liner.winkler = \"{layer} um/MPa\""));
            let parts = film.by_name("film_thickness_min").and_then(|it| it.bar).expect("a bar");
            assert!(parts.wall > 0.0 && parts.position == 0.0, "{parts:?}");
            let [thickness, bar] = quantity(&film, "film_thickness_min");
            let [angle, of_angle] = quantity(&film, "film_thickness_min_angle");
            let off = angle.min(360.0 - angle);
            if (thickness - RIGID).abs() > bar || off > of_angle {
                missed.push(format!("{layer} {size}: {thickness:e} +- {bar:e}, {angle} +- {of_angle}"));
            }
        }
    }
    assert!(missed.is_empty(), "{missed:#?}");
}

/// The shares of all triangles in the difference of two degrees sum to the difference of two films that each bend the
/// wall themselves, in a soft wall much less than that under one wall.
#[test]
fn shares_are_those_of_films_under_walls_of_their_own() {
    let system = ring_system(96, 12, RADIUS, Some(std::f64::consts::PI));
    for (cavitation, touches) in [(Cavitation::None, false), (Cavitation::Reynolds { pressure: 0.0 }, true)] {
        let mut problem = tilted(walled(RADIUS, 0.8, cavitation, |_| layer(0.05)), [2e-5, -1e-5]);
        problem.contact = touches.then(|| contacts().into_iter().next().expect("a law"));
        let pair = closed_pair(closed(problem, &system), None, CLOSED).unwrap_or_else(|reason| panic!("{reason}"));
        let following = following_wall(&pair.film).expect("a tangent");
        let share = load(&pair.cubic).total;
        let eta = |following| {
            let error = film_error(&pair.film, &pair.cubic, &share, following).expect("duals");
            let [x, y] = error.moments.expect("the journal can tilt");
            [&error.goals[0], &error.goals[1], &x, &y].map(|goal| goal.shares.iter().sum::<f64>())
        };
        let (held, found) = (eta(None), eta(following.as_ref()));
        let own = closed_film(pair.film.problem.clone(), &system, Neighbour::Start(&pair.film))
            .unwrap_or_else(|reason| panic!("{reason}"));
        let [better, worse] = [carried(&pair.cubic), carried(&own)];
        let parts = |of: &Resultant| [of.force[0], of.force[1], of.moment[0], of.moment[1]];
        let wanted: Vec<f64> = parts(&better).iter().zip(parts(&worse)).map(|(a, b)| a - b).collect();
        for (range, name) in [(0..2, "force"), (2..4, "moment")] {
            let size = |of: &[f64]| of[range.clone()].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let off: Vec<f64> = found.iter().zip(&wanted).map(|(a, b)| a - b).collect();
            let case = format!("{} {touches} {name}: {found:?}, {wanted:?}, held {held:?}", cavitation.name());
            assert!(size(&off) < 0.01 * size(&held), "{case}");
            assert!(size(&wanted) < 0.5 * size(&held), "{case}");
        }
    }
}
