//! A tilted film against films that must be equal to it.

use std::sync::Arc;

use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::quantities::load::Resultant;
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, JournalState, terms};
use oilwedge_tests::tilted_bearings::{carried, slope, tilted};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;
const MODELS: [Cavitation; 4] = [
    Cavitation::None,
    Cavitation::Guembel { pressure: 0.0 },
    Cavitation::Reynolds { pressure: 0.0 },
    Cavitation::Jfo { pressure: 0.0 },
];

/// A ring with a film start at 180 degrees, its journal at eps 0.6 towards angle 0.
fn bearing(cavitation: Cavitation, alpha: f64) -> (FilmProblem, Arc<FilmSystem>) {
    let mut problem = plain_film(LENGTH, 0.6, 0.0, SPEED);
    problem.cavitation = cavitation;
    problem.lubricant.pressure_law = match alpha {
        0.0 => PressureLaw::Constant,
        alpha => PressureLaw::Barus(Barus { alpha }),
    };
    (problem, ring_system(48, 8, LENGTH, Some(std::f64::consts::PI)))
}

fn values(carried: Resultant) -> [f64; 4] {
    let ([a, b], [c, d]) = (carried.force, carried.moment);
    // Moments with the arm of half the length: forces.
    [a, b, c / (0.5 * LENGTH), d / (0.5 * LENGTH)]
}

fn assert_close(a: [f64; 4], b: [f64; 4], part: f64, what: &str) {
    let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (x, y) in a.iter().zip(b) {
        assert!((x - y).abs() <= part * size, "{what}: {a:?} {b:?}");
    }
}

#[test]
fn tilt_zero_is_absence() {
    for model in MODELS {
        for alpha in [0.0, 2e-8] {
            let (plain, system) = bearing(model, alpha);
            let zero = tilted(plain.clone(), [0.0; 2]);
            let (without, with) = (carried(&plain, &system), carried(&zero, &system));
            assert_close(values(without), values(with), 1e-12, model.name());
        }
    }
}

/// A film seen from the other end, and one seen in a mirror that swaps the sense of rotation.
#[test]
fn mirrored_films_carry_mirrored_moments() {
    for model in MODELS {
        let (plain, system) = bearing(model, 0.0);
        let [x, y] = slope([0.3, 0.2]);
        let here = values(carried(&tilted(plain.clone(), [x, y]), &system));
        let turned = values(carried(&tilted(plain.clone(), [-x, -y]), &system));
        assert_close(here, [turned[0], turned[1], -turned[2], -turned[3]], 1e-9, "other end");
        let mut reversed = tilted(plain, [x, -y]);
        reversed.journal.speed = -SPEED;
        let reversed = values(carried(&reversed, &system));
        assert_close(here, [reversed[0], -reversed[1], reversed[2], -reversed[3]], 1e-9, "mirror");
        // The journal leans towards its thin side at z > 0: the film carries more there.
        assert!(here[2] > 0.05 * here[0], "{here:?}");
    }
}

/// Rotation is a motion of the film: that of the offset by `omega/2 (e_y, -e_x)` and of the slope by
/// `omega/2 (g_y, -g_x)`.
#[test]
fn five_motions_are_four() {
    let problem = tilted(plain_film(LENGTH, 0.6, 0.4, SPEED), slope([0.2, 0.3]));
    let system = ring_system(192, 24, LENGTH, None);
    let turning = values(carried(&problem, &system));
    let mut moving = problem.clone();
    moving.terms.push(Arc::new(terms::squeeze::Squeeze));
    let turn = |[x, y]: [f64; 2]| [0.5 * SPEED * y, -0.5 * SPEED * x];
    moving.journal = JournalState {
        velocity: turn(problem.journal.offset),
        tilt_rate: turn(problem.journal.tilt),
        speed: 0.0,
        ..problem.journal
    };
    assert_close(turning, values(carried(&moving, &system)), 1e-5, "motions");
}
