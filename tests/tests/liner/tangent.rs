//! The tangent of film and wall against central differences of closed films.

use std::sync::Arc;

use oilwedge_bearing::Coefficients;
use oilwedge_bearing::deflection::{closed_film, displaced};
use oilwedge_reynolds::film_thickness::{FilmContribution, WallStage};
use oilwedge_reynolds::flow_factors::PatirCheng;
use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::barus::Barus;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::wall::GapTangent;
use oilwedge_reynolds::{Cavitation, FilmChange, FilmProblem, Form, JournalChange, JournalState, SolvedFilm};
use oilwedge_tests::elastic_liner::{carried, closed, layer, walled};
use oilwedge_tests::*;

const MODELS: [Cavitation; 4] = [
    Cavitation::None,
    Cavitation::Guembel { pressure: 0.0 },
    Cavitation::Reynolds { pressure: 0.0 },
    Cavitation::Jfo { pressure: 0.0 },
];

#[test]
fn stiffness_of_film_and_wall_is_differences_of_closed_films() {
    for model in MODELS {
        let system = ring_system(72, 8, RADIUS, Some(std::f64::consts::PI));
        let film = closed(walled(RADIUS, 0.7, model, |_| layer(0.02)), &system);
        let problem = &film.problem;
        let coefficients = Coefficients::of(&film, 0.0).expect("coefficients");
        let at = |offset: [f64; 2]| {
            let journal = JournalState { offset, ..problem.journal };
            let moved = FilmProblem { journal, ..problem.clone() };
            let moved = closed_film(moved, &system, Neighbour::Start(&film));
            carried(&moved.unwrap_or_else(|reason| panic!("{reason}"))).force
        };
        let size = coefficients.stiffness[0][0].abs().max(coefficients.stiffness[1][1].abs());
        for step in [1e-7, 1e-6] {
            for k in 0..2 {
                let by = |sign: f64| {
                    let mut offset = problem.journal.offset;
                    offset[k] += sign * step * CLEARANCE;
                    at(offset)
                };
                let (ahead, behind) = (by(1.0), by(-1.0));
                for d in 0..2 {
                    let difference = (ahead[d] - behind[d]) / (2.0 * step * CLEARANCE);
                    let error = (difference - coefficients.stiffness[d][k]).abs() / size;
                    assert!(error < 1e-6, "{} {d} {k} step {step:e}: {error:e}", model.name());
                }
            }
        }
    }
}

/// The sparse matrix of film and wall answers as the law does at every point.
#[test]
fn the_matrix_of_the_gap_is_the_change_of_the_law() {
    let system = ring_system(48, 6, RADIUS, Some(std::f64::consts::PI));
    let mut problems: Vec<FilmProblem> = MODELS.map(|model| walled(RADIUS, 0.7, model, |_| layer(0.02))).into();
    for problem in &mut problems {
        problem.terms.push(Arc::new(Squeeze));
    }
    let mut rough = problems[3].clone();
    rough.flow_factors = vec![Arc::new(PatirCheng { roughness: 0.1 * CLEARANCE })];
    let mut printed = problems[0].clone();
    printed.form = Form::AsPrinted;
    printed.lubricant.pressure_law = PressureLaw::Barus(Barus { alpha: 0.02 / pressure_scale() });
    problems.extend([rough, printed]);
    for problem in problems {
        let film = closed(problem, &system);
        let problem = &film.problem;
        let bent = problem.deflection().expect("a wall");
        let stage = WallStage { per_time: 0.3 * SPEED, known: bent.coefficients.clone() };
        for deflection in [bent.clone(), bent.in_stage(stage)] {
            let number = deflection.coefficients.len();
            let shape: Vec<f64> = (0..number).map(|k| 1e-3 * CLEARANCE * (0.7 * k as f64).sin()).collect();
            let matrix = GapTangent::kept(&film, &deflection).expect("a matrix");
            let by_matrix = film.answer(&matrix.times(&system, &shape), 0.0).expect("an answer");
            let change = deflection.change(shape);
            let by_law = film.unknown_change(FilmChange::Gap(&change)).expect("an answer");
            let size = by_law.iter().fold(0.0f64, |most, u| most.max(u.abs()));
            let off = by_matrix.iter().zip(&by_law).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            assert!(
                size > 0.0 && off < 1e-11 * size,
                "{} {:?}: {off:e} of {size:e}",
                problem.cavitation.name(),
                problem.form
            );
        }
    }
}

/// A film that is moved along the tangent is the closed film there, to second order.
#[test]
fn displaced_films_are_closed_to_second_order() {
    let system = ring_system(72, 8, RADIUS, Some(std::f64::consts::PI));
    let film = closed(walled(RADIUS, 0.7, Cavitation::None, |_| layer(0.02)), &system);
    let problem = &film.problem;
    let off = [1e-3, 5e-4].map(|part| {
        let change = JournalChange { offset: [part * CLEARANCE, -0.5 * part * CLEARANCE], ..JournalChange::default() };
        let moved = displaced(&film, &change).unwrap_or_else(|reason| panic!("{reason}"));
        let exact = closed(FilmProblem { journal: moved.problem.journal, ..problem.clone() }, &system);
        let films = [&moved, &exact];
        let deflections = films.map(|film| film.problem.deflection().expect("a wall").at([0.01, 0.0]));
        let forces = films.map(|film| carried(film).force);
        let force = (forces[0][0] - forces[1][0]).hypot(forces[0][1] - forces[1][1]);
        [force, (deflections[0] - deflections[1]).abs()]
    });
    for k in 0..2 {
        let ratio = off[0][k] / off[1][k];
        assert!((3.5..4.5).contains(&ratio), "{k}: {off:?}");
    }
}

/// A stiff wall leaves stiffness and damping as they are, and a softer film on it damps less.
#[test]
fn coefficients_of_a_stiff_wall_are_those_of_the_film() {
    let system = ring_system(72, 8, RADIUS, Some(std::f64::consts::PI));
    for model in MODELS {
        let of = |lambda: f64| {
            let mut problem = walled(RADIUS, 0.7, model, |_| layer(lambda));
            problem.terms.push(Arc::new(Squeeze));
            problem
        };
        let mut rigid = of(0.0);
        rigid.film_thickness.pop();
        let film = rigid.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
        let films = [closed(of(1e-12), &system), closed(of(0.02), &system), film];
        for frequency in [0.0, 0.5 * SPEED] {
            let [stiff, soft, rigid] =
                films.each_ref().map(|film| Coefficients::of(film, frequency).expect("coefficients"));
            for (a, b) in [(stiff.stiffness, rigid.stiffness), (stiff.damping, rigid.damping)] {
                let size = b.iter().flatten().fold(0.0f64, |most, entry| most.max(entry.abs()));
                for (row, other) in a.iter().zip(b) {
                    for (x, y) in row.iter().zip(other) {
                        assert!((x - y).abs() < 1e-8 * size, "{}: {x} {y}", model.name());
                    }
                }
            }
            assert!(soft.damping[0][0] < rigid.damping[0][0], "{}", model.name());
        }
    }
}

/// Neither the grid nor its value knows triangles.
#[test]
fn deflections_are_the_same_on_coarser_meshes() {
    let system = ring_system(48, 6, RADIUS, None);
    let SolvedFilm { problem, .. } =
        closed(walled(RADIUS, 0.6, Cavitation::Reynolds { pressure: 0.0 }, |_| layer(0.02)), &system);
    let deflection = problem.deflection().expect("a wall");
    let carried = deflection.carried(&[0; 4]);
    assert_eq!(
        carried.as_deflection().map(|carried| carried.coefficients.clone()),
        Some(deflection.coefficients.clone())
    );
}
