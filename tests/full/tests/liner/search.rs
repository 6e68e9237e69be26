//! Searches for the position under a load that presses a soft wall out: contact and wall are found together.

use std::sync::atomic::{AtomicUsize, Ordering};

use oilwedge_bearing::{Carrier, InitialGuess, SearchObserver, SearchOptions, find};
use oilwedge_full::random_tilted::{TiltedBearing, solved};
use oilwedge_reynolds::{Cavitation, FilmProblem};
use oilwedge_study::compile::compile;
use oilwedge_study::quantities::{DEFLECTION_MAX, FILM_THICKNESS_MIN, Row};
use oilwedge_tests::elastic_liner::{layer, walled};
use oilwedge_tests::*;

use oilwedge_tests::rough_surfaces::contacts;

const LENGTH: f64 = 0.06;
const REYNOLDS: Cavitation = Cavitation::Reynolds { pressure: 0.0 };

/// A journal that presses a soft wall out takes it along: few positions lead to the balance, and fewer on a finer mesh
/// that begins under the wall found.
#[test]
fn a_search_takes_the_wall_along() {
    let coarse = ring_system(48, 8, LENGTH, Some(160f64.to_radians()));
    let fine = ring_system(96, 16, LENGTH, Some(160f64.to_radians()));
    let load = [-1e5, 0.0];
    for contact in contacts().into_iter().take(1) {
        let mut problem = walled(LENGTH, 0.5, REYNOLDS, |_| layer(5e-3));
        problem.contact = Some(contact);
        let found =
            find(&problem, &coarse, load, &SearchOptions::default()).unwrap_or_else(|reason| panic!("{reason}"));
        let eccentricity = found.film.problem.journal.eccentricity() / CLEARANCE;
        let begun =
            FilmProblem { journal: found.film.problem.journal, ..problem.deflected(found.film.problem.deflection()) };
        let options = SearchOptions { guess: InitialGuess::NearlyBalanced, ..SearchOptions::default() };
        let finer = find(&begun, &fine, load, &options).unwrap_or_else(|reason| panic!("{reason}"));
        assert!(found.residual < 1e-10 && finer.residual < 1e-10);
        assert!(eccentricity > 1.0, "{eccentricity}");
        // Each position near the balance is one film.
        assert!(found.steps <= 24 && finer.steps <= 5, "{} {}", found.steps, finer.steps);
    }
}

/// A tilted journal whose end needs more room than the unbent wall leaves: contact presses the wall out there.
#[test]
fn a_wall_is_pressed_out_further_than_the_clearance() {
    let mut bearing = TiltedBearing::with_walls(13);
    bearing.text += "[mesh]\nsize = \"10 mm\"\n";
    let (result, fault) = solved(&bearing);
    assert!(fault.is_none(), "{}", fault.map_or(String::new(), |fault| fault.what));
    let value = |row: &Row| result.quantity(row).map_or(f64::NAN, |quantity| quantity.value);
    let film = value(&FILM_THICKNESS_MIN);
    assert!(film > 0.0 && value(&DEFLECTION_MAX) > film, "{film:e}");
}

/// How many films a search has solved.
#[derive(Debug)]
struct Films(AtomicUsize);

impl SearchObserver for Films {
    fn position(&self, _: usize, _: f64) {
        self.0.fetch_add(1, Ordering::Relaxed);
    }
}

/// Journals whose ends lie further out than a rigid wall lets them, to which no step of a search from the usual start
/// leads: moments grow until they are balanced. Surfaces touch on the way, and steps along the tangent press them into
/// each other. If contact did not settle before the next film is solved the first of these journals would seem to come
/// into contact with the liner.
#[test]
fn loads_that_press_soft_walls_far_out_are_balanced() {
    far_out(63, 1.0, 140);
    let quadratic = far_out(255, 1.1, 100);
    few_films_lead_to_the_cubic_balance(255, &quadratic);
}

/// The balance of a random bearing at no less than this eccentricity, found by fewer films than so many.
fn far_out(number: u64, least_eccentricity: f64, most_films: usize) -> FilmProblem {
    let (found, films) = balance(number, Carrier::Quadratic);
    let eccentricity = found.journal.eccentricity() / CLEARANCE;
    assert!(eccentricity > least_eccentricity, "{number}: {eccentricity}");
    assert!(films < most_films, "{number}: {films}");
    found
}

/// The balance of a random bearing on a soft wall, and how many films lead to it.
fn balance(number: u64, carrier: Carrier) -> (FilmProblem, usize) {
    static FILMS: Films = Films(AtomicUsize::new(0));
    let mut bearing = TiltedBearing::with_walls(number);
    bearing.text += "[mesh]\nsize = \"30 mm\"\n";
    let film = compile(&bearing.scene()).and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"));
    let options = SearchOptions { carrier, observer: Some(&FILMS), ..SearchOptions::default() };
    let found = find(&film.problem, &film.system, film.load().expect("a load"), &options);
    let found = found.unwrap_or_else(|reason| panic!("{number}: {reason}"));
    assert!(found.residual < 1e-10, "{number}: {:e}", found.residual);
    (found.film.problem, FILMS.0.swap(0, Ordering::Relaxed))
}

/// The systems of the film in cubic elements are nearly solved by those of the quadratic film: from the balance of that
/// one few films lead to its own, with few products each.
fn few_films_lead_to_the_cubic_balance(number: u64, quadratic: &FilmProblem) {
    let (cubic, _) = balance(number, Carrier::Cubic);
    let [quadratic, cubic] = [quadratic, &cubic].map(|problem| problem.deflection().expect("a wall").closing);
    assert!(cubic.residual < 1e-10, "{number}: {cubic:?}");
    // The balance of the quadratic film is a start, and found less exactly.
    let films = cubic.outer - quadratic.outer;
    assert!(films <= 10, "{number}: {films} films");
    let most = quadratic.inner + 8 * films;
    assert!(cubic.inner <= most, "{number}: {} products, {most} at most", cubic.inner);
}
