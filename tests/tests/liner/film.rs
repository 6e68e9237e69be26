//! Films with elastic walls against films that must be equal to them, and against a second code.

use std::sync::Arc;

use oilwedge_bearing::deflection::{CLOSED, closed_film, closed_pair};
use oilwedge_bearing::{Deadline, InitialGuess, Interrupt, SearchOptions, find};
use oilwedge_reynolds::analytical::elastic_ring::{ElasticRing, RingSupport};
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::quantities::pressure::extremes;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::wall::{Along, Around, Compliance, Dense, Grid, Wall};
use oilwedge_reynolds::{Cavitation, FilmProblem, FilmSystem, SolvedFilm};
use oilwedge_tests::elastic_liner::{block, carried, closed, force_scale, layer, walled, with_wall};
use oilwedge_tests::*;

const SWIFT_STIEBER: Cavitation = Cavitation::Reynolds { pressure: 0.0 };
const MODELS: [Cavitation; 4] =
    [Cavitation::None, Cavitation::Guembel { pressure: 0.0 }, SWIFT_STIEBER, Cavitation::Jfo { pressure: 0.0 }];

/// Least film [m] on the mid-plane.
fn least_at_middle(problem: &FilmProblem) -> f64 {
    let turn = std::f64::consts::TAU * RADIUS;
    let at = |k: u32| problem.thickness_at(0, &[[turn * f64::from(k) / 8000.0, 0.0]])[0];
    (0..8000).map(at).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_stiff_wall_is_none() {
    let length = RADIUS;
    for model in MODELS {
        let system = ring_system(48, 8, length, Some(std::f64::consts::PI));
        let stiff = walled(length, 0.7, model, |_| layer(1e-30));
        let mut rigid = stiff.clone();
        rigid.film_thickness.pop();
        let film = rigid.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let wanted = carried(&film).force;
        let found = carried(&closed(stiff, &system)).force;
        let size = wanted[0].hypot(wanted[1]);
        for d in 0..2 {
            let off = (found[d] - wanted[d]).abs() / size;
            assert!(off < 1e-12, "{}: {off:e}", model.name());
        }
    }
}

/// Block `winkler`, but for eps 0.95: the film at the ends is so thin there that a uniform mesh does not resolve it (a
/// hard case on a graded mesh).
#[test]
fn layers_carry_what_a_second_code_has() {
    for row in block("winkler")["rows"].as_array().expect("rows") {
        let number = |key: &str| row[key].as_f64().expect("a number");
        if number("eps") > 0.9 {
            continue;
        }
        let (length, eps) = (2.0 * RADIUS * number("b"), number("eps"));
        let system = ring_system(240, 12, length, None);
        let film = closed(walled(length, eps, SWIFT_STIEBER, |_| layer(number("lam"))), &system);
        let force = carried(&film).force.map(|part| part / force_scale());
        let wanted = [0, 1].map(|d| row["W"][d].as_f64().expect("a force"));
        let size = wanted[0].hypot(wanted[1]);
        for d in 0..2 {
            assert!((force[d] - wanted[d]).abs() < 1e-3 * size, "{row}: {force:?}");
        }
        let greatest = extremes(&film).greatest / pressure_scale();
        assert!((greatest / number("p_max") - 1.0).abs() < 1e-3, "{row}: {greatest}");
        let middle = least_at_middle(&film.problem) / CLEARANCE;
        assert!((middle / number("hmin_mid") - 1.0).abs() < 1e-3, "{row}: {middle}");
    }
}

/// Block `elastic_ring_film`: a clamped steel wall as thick as the radius, in units of the bearing here.
#[test]
fn a_thick_wall_carries_what_a_second_code_has() {
    // The wall moves by so many clearances under the pressure scale as that of the reference, R 50 mm, c 50 um, 6 MPa.
    let ring =
        ElasticRing { radius: 0.05, thickness: 0.05, modulus: 2.1e11, poisson: 0.3, outer: RingSupport::Clamped };
    let by_wave = |n: usize| layer(ring.compliance(n) * 6e6 / 50e-6);
    for row in block("elastic_ring_film")["rows"].as_array().expect("rows") {
        let number = |key: &str| row[key].as_f64().expect("a number");
        let system = ring_system(240, 12, RADIUS, None);
        let film = closed(walled(RADIUS, number("eps"), SWIFT_STIEBER, by_wave), &system);
        let force = carried(&film).force.map(|part| part / force_scale());
        for d in 0..2 {
            let wanted = row["W"][d].as_f64().expect("a force");
            assert!((force[d] / wanted - 1.0).abs() < 3e-3, "{row}: {force:?}");
        }
        let greatest = extremes(&film).greatest / pressure_scale();
        assert!((greatest / number("p_max") - 1.0).abs() < 3e-3, "{row}: {greatest}");
    }
}

/// Axial middles of cells, and the wall of a matrix on them.
fn by_matrix(problem: &FilmProblem, angles: usize, along: usize, entry: impl Fn(&[f64]) -> Dense) -> Wall {
    let length = problem.bearing.length;
    let points: Vec<f64> = (0..along).map(|k| length * ((k as f64 + 0.5) / along as f64 - 0.5)).collect();
    Wall::of_matrix(&problem.bearing, (0.0, angles), &points, entry(&points)).expect("it fits")
}

/// Unit forces on the cells of a layer.
fn lumped_layer(problem: &FilmProblem, angles: usize, along: usize, per_pressure: f64) -> Wall {
    let area = std::f64::consts::TAU * RADIUS / angles as f64 * problem.bearing.length / along as f64;
    by_matrix(problem, angles, along, |_| {
        Dense::from_diagonal_element(angles * along, angles * along, per_pressure / area)
    })
}

/// Unit forces at the points of a layer whose deflections are the splines of the grid.
fn condensed_layer(problem: &FilmProblem, angles: usize, along: usize, per_pressure: f64) -> Wall {
    by_matrix(problem, angles, along, |points| {
        let grid = Grid {
            radius: RADIUS,
            around: Around::centred(angles, 0.0),
            along: Along::through(points, problem.bearing.ends()),
        };
        let layer = Compliance::of_slices((RADIUS, &grid.around, &grid.along), |_| per_pressure).expect("a grid");
        let n = grid.number();
        let turn = std::f64::consts::TAU * RADIUS / angles as f64;
        let at = |k: usize| [turn * (k / along) as f64, points[k % along]];
        let unit = |k: usize| (0..n).map(|i| if i == k { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
        // Values of all splines at each point.
        let splines: Vec<Vec<f64>> =
            (0..n).map(unit).map(|unit| (0..n).map(|k| grid.value(&unit, at(k))).collect()).collect();
        let mut matrix = Dense::zeros(n, n);
        for column in 0..n {
            let forces: Vec<f64> = splines.iter().map(|values| values[column]).collect();
            let deflection = layer.deflection(&forces);
            for row in 0..n {
                matrix[(row, column)] = splines.iter().zip(&deflection).map(|(values, d)| values[row] * d).sum();
            }
        }
        matrix
    })
}

#[test]
fn a_matrix_of_a_layer_has_the_film_of_the_layer() {
    let system = ring_system(120, 8, RADIUS, Some(std::f64::consts::PI));
    let force = |problem: FilmProblem, system: &Arc<FilmSystem>| carried(&closed(problem, system)).force;
    let slices = walled(RADIUS, 0.8, SWIFT_STIEBER, |_| layer(0.02));
    let mut rigid = slices.clone();
    rigid.film_thickness.pop();
    let wanted = force(slices, &system);
    let off = |wall: Wall| {
        let found = force(with_wall(rigid.clone(), wall), &system);
        (found[0] - wanted[0]).hypot(found[1] - wanted[1]) / wanted[0].hypot(wanted[1])
    };
    let condensed = off(condensed_layer(&rigid, 72, 8, layer(0.02)));
    assert!(condensed < 1e-3, "{condensed:e}");
    // Forces on cells are those at points as far as the cells are small.
    let lumped = [(36, 6), (72, 12)].map(|(angles, along)| off(lumped_layer(&rigid, angles, along, layer(0.02))));
    assert!(lumped[1] < 0.5 * lumped[0] && lumped[1] < 1e-2, "{lumped:?}");
}

/// Softness that bends the film by several of its least thickness, with each model, Barus's oil where films break, and
/// both films of a pair.
#[test]
fn soft_walls_close_with_every_model() {
    for (model, alpha) in MODELS.into_iter().zip([0.0, 0.0, 2e-8, 2e-8]) {
        let system = ring_system(96, 6, RADIUS, Some(std::f64::consts::PI));
        let mut problem = walled(RADIUS, 0.9, model, |_| layer(0.02));
        if alpha > 0.0 {
            problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha });
        }
        let film = closed(problem, &system);
        let closing = film.problem.deflection().expect("a wall").closing;
        assert!(closing.residual < 1e-8, "{}: {closing:?}", model.name());
        if model.is_symmetric() {
            let pair = closed_pair(film, None, CLOSED).unwrap_or_else(|reason| panic!("{reason}"));
            let both = pair.film.problem.deflection().expect("a wall").closing;
            assert!(both.residual < 1e-8, "{} in cubics: {both:?}", model.name());
            // The film in quadratic elements nearly solves the systems of the one in cubic elements.
            let [steps, products] = [both.outer - closing.outer, both.inner - closing.inner];
            assert!(products <= 6 * steps, "{}: {products} products in {steps} steps", model.name());
        }
    }
}

/// A film whose wall is found is one of the viscosity law itself: beyond the limit of Barus' law there is none, though
/// the films on the way have a viscosity that saturates.
#[test]
fn a_wall_under_a_film_beyond_the_viscosity_law_is_refused() {
    let system = ring_system(48, 8, RADIUS, Some(std::f64::consts::PI));
    let soft = || walled(RADIUS, 0.7, SWIFT_STIEBER, |_| layer(0.05));
    let greatest = closed(soft(), &system).greatest_unknown().value;
    let with_limit = |limit: f64| {
        let mut problem = soft();
        problem.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 1.0 / limit });
        closed_film(problem, &system, Neighbour::None)
    };
    let has_film = |part: f64| match with_limit(part * greatest) {
        Ok(film) => {
            let law = &film.problem.lubricant.pressure_law;
            assert!(matches!(law, PressureLaw::Barus(_)) && film.greatest_unknown().value < part * greatest, "{part}");
            true
        }
        Err(_) => false,
    };
    assert!(has_film(5.0) && has_film(2.0) && !has_film(0.01));
}

/// Journal and wall are found together: the film that closes the wall at the place found by itself carries the load,
/// and from a place nearby both take some films, not some at each place.
#[test]
fn place_and_wall_are_those_of_one_another() {
    for model in MODELS {
        let system = Arc::new(ring_alone(96, 8, RADIUS, Some(std::f64::consts::PI)).for_many_solves());
        let film = closed(walled(RADIUS, 0.8, model, |_| layer(0.3)), &system);
        let near = &film.problem;
        let load = carried(&film).force.map(|part| 1.1 * part);
        let options = SearchOptions { guess: InitialGuess::Near(Neighbour::Start(&film)), ..SearchOptions::default() };
        let found = find(near, &system, load, &options).unwrap_or_else(|reason| panic!("{reason}"));
        let closing = |problem: &FilmProblem| problem.deflection().expect("a wall").closing;
        let films = closing(&found.film.problem).outer - closing(near).outer;
        assert!(films <= 6, "{}: {films}", model.name());
        assert!(found.residual < 1e-10 && closing(&found.film.problem).residual < 1e-10);
        let force = carried(&closed(found.film.problem.deflected(near.deflection()), &system)).force;
        let off = (force[0] - load[0]).hypot(force[1] - load[1]) / load[0].hypot(load[1]);
        assert!(off < 1e-9, "{}: {off:e}", model.name());
    }
}

/// A search whose time is over begins a film and closes no wall. Where that film happens to carry the load its wall is
/// still open: the search was ended, and there is no balance.
#[test]
fn a_search_that_is_ended_has_no_balance_while_its_wall_is_open() {
    let (length, system) = (RADIUS, ring_system(48, 8, RADIUS, Some(std::f64::consts::PI)));
    let SolvedFilm { problem, .. } = closed(walled(length, 0.7, SWIFT_STIEBER, |_| layer(0.05)), &system);
    let half: Vec<f64> = problem.deflection().expect("a wall").coefficients.iter().map(|d| 0.5 * d).collect();
    let open = problem.clone().deflected(problem.deflection().map(|bent| bent.with(half)).as_ref());
    let film = open.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
    let load = carried(&film).force;
    for guess in [InitialGuess::NearlyBalanced, InitialGuess::Cold] {
        let options =
            SearchOptions { guess, deadline: Deadline::after(0.0, Interrupt::NEVER), ..SearchOptions::default() };
        let found = find(&open, &system, load, &options).unwrap_or_else(|reason| panic!("{reason}"));
        let left = found.film.problem.deflection().expect("a wall").closing.residual;
        assert!(found.residual < 1e-12 && left > 0.1, "{:e} {left:e}", found.residual);
        assert!(found.is_ended && found.steps == 1, "{} {}", found.is_ended, found.steps);
    }
}
