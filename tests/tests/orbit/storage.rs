//! Films that conserve their oil from one time to the next, along motions that are given: closed solutions and orders
//! in time.

use std::sync::Arc;

use oilwedge_bearing::orbit::scheme::SECOND_ORDER;
use oilwedge_bearing::orbit::{Before, StoredOil};
use oilwedge_mesh::{Mesh, RawMesh};
use oilwedge_reynolds::film_thickness::FilmContribution;
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{Cavitation, FilmPoint, FilmProblem, FilmSystem, JournalChange, JournalState, SolvedFilm};
use oilwedge_tests::*;

/// Length of the stage by which a motion begins, over the first step.
const BEGINNING: f64 = 1e-6;

/// The end of a step.
struct Seen<'a> {
    time: f64,
    film: &'a SolvedFilm,
    oil: &'a StoredOil,
    /// Impulse [N s] of the film's force over the step: the forces of the stages with the weights of the method, as it
    /// sums what flows.
    impulse: [f64; 2],
}

/// Follows a film whose journal moves as given from the first of the `times` on, in steps from each to the next; `each`
/// sees every one.
fn follow(
    still: &FilmProblem,
    system: &Arc<FilmSystem>,
    journal: impl Fn(f64) -> JournalState,
    times: &[f64],
    mut each: impl FnMut(&Seen),
) {
    let at = |time: f64, before: &Before| FilmProblem {
        journal: journal(time),
        storage: Some(before.storage.clone()),
        ..still.clone()
    };
    let short = BEGINNING * (times[1] - times[0]);
    let full = FilmProblem { journal: journal(times[0] - short), ..still.clone() };
    let before = Before::at_rest(1.0 / short, full.oil_of_full_film(system).expect("volumes"));
    let problem = at(times[0], &before);
    let mut film = problem.solve_from(system, Neighbour::None).expect("a film");
    let mut oil = Arc::new(before.oil(&film).expect("oil"));
    let mut force = load(&film).total.force;
    let weights = SECOND_ORDER.coefficients[SECOND_ORDER.stages() - 1];
    for pair in times.windows(2) {
        let dt = pair[1] - pair[0];
        let mut stages = vec![oil.clone()];
        let mut impulse = force.map(|force| dt * weights[0] * force);
        for stage in 1..SECOND_ORDER.stages() {
            let before = oil.before(&SECOND_ORDER, stage, dt, &stages);
            let problem = at(pair[0] + dt * SECOND_ORDER.nodes[stage], &before);
            film = (problem.solve_from(system, Neighbour::Start(&film))).unwrap_or_else(|reason| panic!("{reason}"));
            stages.push(Arc::new(before.oil(&film).expect("oil")));
            force = load(&film).total.force;
            impulse = [0, 1].map(|d| impulse[d] + dt * weights[stage] * force[d]);
        }
        oil = stages.pop().expect("stages");
        each(&Seen { time: pair[1], film: &film, oil: &oil, impulse });
    }
}

fn steps(from: f64, to: f64, number: u32) -> Vec<f64> {
    let part = |k: u32| f64::from(k) / f64::from(number);
    (0..=number).map(|k| from + (to - from) * part(k)).collect()
}

/// Two plates as far apart as the first offset of the journal.
#[derive(Debug)]
struct Plates;

impl FilmContribution for Plates {
    fn add(&self, journal: &JournalState, _: usize, _: &[[f64; 2]], film: &mut [FilmPoint]) {
        for point in film {
            point.thickness += journal.offset[0];
            point.rate += journal.velocity[0];
        }
    }

    fn vary(&self, change: &JournalChange, _: usize, _: &[[f64; 2]], film: &mut [FilmPoint]) {
        for point in film {
            point.thickness += change.offset[0];
            point.rate += change.velocity[0];
        }
    }

    fn carried(&self, _: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(Self)
    }
}

/// A strip from 0 to 1 of so many squares, sealed along both sides, 0.025 Pa at both ends.
fn strip(columns: u32) -> Arc<FilmSystem> {
    let size = 1.0 / f64::from(columns);
    let vertex = |i: u32, j: u32| 2 * i + j;
    let points = (0..=columns).flat_map(|i| [0u32, 1].map(|j| [size * f64::from(i), size * f64::from(j)]));
    let triangles = (0..columns).flat_map(|i| {
        let [a, b, c, d] = [vertex(i, 0), vertex(i + 1, 0), vertex(i + 1, 1), vertex(i, 1)];
        [[a, b, c], [a, c, d]]
    });
    let side = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect::<Vec<_>>();
    let raw = RawMesh {
        points: points.collect(),
        triangles: triangles.collect(),
        curves: vec![
            ("sides".into(), [side(0), side(1)].concat()),
            ("ends".into(), vec![[0, 1], [2 * columns, 2 * columns + 1]]),
        ],
        ..RawMesh::default()
    };
    let mesh = Mesh::build(raw).expect("a strip");
    let kinds = [("sides", BoundaryKind::Sealed), ("ends", BoundaryKind::End)];
    let regions = kinds.map(|(name, kind)| SupplyRegion {
        name: name.into(),
        kind,
        pressure: 0.025,
        edges: mesh.region(name).expect("a group").edges.clone(),
        cells: Vec::new(),
        disc: None,
        film_fraction: None,
    });
    Arc::new(FilmSystem::new(Arc::new(mesh), 1, regions.into()).expect("a closed film"))
}

/// Parallel plates at `H = 0.125 cos(4 pi t) + 0.375` with `d/dx(H^3 dp/dx) = 2 d(theta H)/dt`, full at first: left
/// edge of the cavity at times, and the time at which the film is full again, by the ordinary differential equation of
/// the front (Optasanu, Bonneau, J. Tribol. 122 (2000) 162, for the case).
const FRONT: [(f64, f64); 11] = [
    (0.26, 0.04480746),
    (0.27, 0.03237014),
    (0.28, 0.02737181),
    (0.30, 0.02358437),
    (0.35, 0.02368263),
    (0.40, 0.02678061),
    (0.45, 0.03201014),
    (0.50, 0.03908713),
    (0.54, 0.04635082),
    (0.58, 0.0561526),
    (0.60, 0.06277688),
];
const FULL_AGAIN: f64 = 0.73238984;

/// Greatest error of the front, and the error of the time at which the film is full again.
fn errors_of_plates(columns: u32, number: u32) -> [f64; 2] {
    let system = strip(columns);
    let mut problem = plain_film(1.0 / f64::from(columns), 0.0, 0.0, 0.0);
    problem.bearing.radius = 1.0;
    problem.bearing.clearance = 0.375;
    problem.lubricant.viscosity = 1.0 / 6.0;
    problem.film_thickness = vec![Arc::new(Plates)];
    problem.terms.push(Arc::new(Squeeze));
    problem.cavitation = Cavitation::Jfo { pressure: 0.0 };
    let journal = |time: f64| {
        let (sin, cos) = (4.0 * std::f64::consts::PI * time).sin_cos();
        JournalState {
            offset: [0.125 * cos + 0.375, 0.0],
            velocity: [-0.5 * std::f64::consts::PI * sin, 0.0],
            ..problem.journal
        }
    };
    let places = system.space().positions();
    let (mut front, mut full_again) = (0.0f64, f64::INFINITY);
    // The steps meet every hundredth.
    follow(&problem, &system, journal, &steps(0.0, 0.75, 75 * number), |&Seen { time, film, oil, .. }| {
        let size = 1.0 / f64::from(columns);
        let fraction = film.solution.film_fraction.as_ref().expect("a fraction");
        let broken = |(dof, place): (usize, &[f64; 2])| {
            (place[1] == 0.0 && film.solution.cavity[dof]).then_some((place[0], fraction.values[dof]))
        };
        let mut broken: Vec<(f64, f64)> = places.iter().enumerate().filter_map(broken).collect();
        broken.sort_by(|a, b| a.0.total_cmp(&b.0));
        if let (Some((_, edge)), [first, next, ..]) =
            (FRONT.iter().find(|(at, _)| (at - time).abs() < 1e-9), &broken[..])
        {
            // The first cell of the cavity is full as far as its oil reaches beyond that of the next one.
            let full = ((first.1 - next.1) / (1.0 - next.1)).clamp(0.0, 1.0);
            front = front.max((first.0 + (full - 0.5) * size - edge).abs());
        }
        if time > 0.6 && broken.is_empty() {
            full_again = full_again.min(time);
        }
        assert!((oil.received - (oil.total() - 0.5 / f64::from(columns))).abs() < 1e-10 * oil.total(), "{time}");
    });
    [front, (full_again - FULL_AGAIN).abs()]
}

#[test]
fn squeezed_plates_cavitate_and_reform_as_the_closed_front() {
    let coarse = errors_of_plates(100, 2);
    let fine = errors_of_plates(400, 5);
    assert!(fine[0] < 2e-3 && fine[1] < 2e-3, "{fine:?}");
    assert!(coarse[0] > fine[0] && coarse[0] < 1e-2 && coarse[1] < 1e-2, "{coarse:?} {fine:?}");
}

/// A ring whose journal goes round, with a cavity at this part of the unit of pressure: impulse of the force and oil in
/// the film at common times of the second turn, in so many steps a turn.
fn second_turn(number: u32, cavity: f64) -> Vec<[f64; 3]> {
    let length = RADIUS;
    let system = ring_system(16, 2, length, None);
    let mut problem = plain_film(length, 0.0, 0.0, SPEED);
    problem.terms.push(Arc::new(Squeeze));
    problem.cavitation = Cavitation::Jfo { pressure: cavity * pressure_scale() };
    let journal = |time: f64| {
        let (sin, cos) = (SPEED * time).sin_cos();
        JournalState {
            offset: [CLEARANCE * (0.4 + 0.3 * cos), CLEARANCE * 0.3 * sin],
            velocity: [-0.3 * SPEED * CLEARANCE * sin, 0.3 * SPEED * CLEARANCE * cos],
            ..problem.journal
        }
    };
    let turn = std::f64::consts::TAU / SPEED;
    let unit = pressure_scale() * RADIUS * RADIUS * turn;
    let volume = std::f64::consts::TAU * RADIUS * CLEARANCE * length;
    let (mut found, mut step, mut sum) = (Vec::new(), 0, [0.0; 2]);
    follow(&problem, &system, journal, &steps(0.0, 2.0 * turn, 2 * number), |Seen { oil, impulse, .. }| {
        step += 1;
        if step > number {
            sum = [0, 1].map(|d| sum[d] + impulse[d] / unit);
            if step % (number / COMMON) == 0 {
                found.push([sum[0], sum[1], oil.total() / volume]);
            }
        }
    });
    found
}

/// Times of the second turn at which films are compared.
const COMMON: u32 = 32;

/// Mean order of the two parts of the impulse and of the oil over three halvings of the step, and the least errors.
fn orders_in_time(cavity: f64) -> [[f64; 2]; 3] {
    let exact = second_turn(1024, cavity);
    let error = |number: u32| {
        let found = second_turn(number, cavity);
        let mean = |k: usize| {
            let apart = found.iter().zip(&exact).map(|(a, b)| (a[k] - b[k]).abs());
            apart.sum::<f64>() / f64::from(COMMON)
        };
        [0, 1, 2].map(mean)
    };
    let [coarse, fine] = [32, 256].map(error);
    [0, 1, 2].map(|k| [(coarse[k] / fine[k]).log2() / 3.0, fine[k]])
}

/// A film that never breaks.
#[test]
fn a_full_film_is_of_second_order_in_time() {
    let [x, y, oil] = orders_in_time(-100.0);
    assert!(x[0] > 1.9 && y[0] > 1.9, "{x:?} {y:?}");
    // It holds what the ring holds.
    assert!(oil[1] < 1e-14, "{oil:?}");
}

/// Nodes fill and empty within the steps, and the force jumps where one does. Its impulse does not: the stages sum the
/// force as they sum what flows. The force at the ends of the steps alone, by trapezia, converges with the order 1.5.
#[test]
fn the_history_is_of_second_order_in_time() {
    let orders = orders_in_time(-0.1);
    assert!(orders.iter().all(|[order, _]| *order > 1.9), "{orders:?}");
}
