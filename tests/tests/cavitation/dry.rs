//! Films that nothing supplies are refused by place; parts of a film that touch a supply are films of their own.

use std::sync::Arc;

use oilwedge_reynolds::quantities::flow::flows;
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion};
use oilwedge_reynolds::{Cavitation, FilmSystem, NoFilm, SolvedFilm};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;
const JFO: Cavitation = Cavitation::Jfo { pressure: 0.0 };

#[test]
fn a_ring_without_supply_is_refused_with_a_place() {
    let mut film = plain_film(LENGTH, 0.6, 0.3, SPEED);
    film.cavitation = JFO;
    let system = ring_system(24, 6, LENGTH, None);
    for system in [
        Arc::new(ring_alone(24, 6, LENGTH, None).with_coarser(&film, oilwedge_reynolds::levels::LevelLayout::Rows)),
        system,
    ] {
        match film.solve(&system) {
            Err(NoFilm::NoSupply { angle, z }) => {
                assert!(angle.abs() < 7.0 && z.abs() <= 0.5 * LENGTH, "{angle} {z}");
            }
            other => panic!("{:?}", other.map(|film| film.solution.history.clone())),
        }
    }
}

/// A feed over all cells whose corners lie between two `z` [m].
fn band(system: &Arc<FilmSystem>, name: &str, from: f64, to: f64, pressure: f64) -> SupplyRegion {
    let mesh = system.space().mesh();
    let inside = |t: &u32| {
        let corners = mesh.corners(*t as usize);
        corners.iter().all(|c| c[1] > from - 1e-9 && c[1] < to + 1e-9)
    };
    SupplyRegion {
        name: name.into(),
        kind: BoundaryKind::Feed,
        pressure,
        edges: Vec::new(),
        cells: (0..mesh.triangles().len() as u32).filter(inside).collect(),
        disc: None,
        film_fraction: None,
    }
}

/// The land between two grooves all around is a bearing of its own, between ends at the pressure of the grooves.
#[test]
fn the_land_between_two_full_grooves_is_a_bearing_of_its_own() {
    let (columns, pressure) = (32, 2e4);
    // Twelve rows of 5 mm: grooves in rows 2 and 9, six rows of land between them.
    let whole = ring_system(columns, 12, LENGTH, None);
    let grooves = [("low", -0.02, -0.015), ("high", 0.015, 0.02)];
    let mut regions = ends(whole.space().mesh(), LENGTH, None);
    regions.extend(grooves.map(|(name, from, to)| band(&whole, name, from, to, pressure)));
    let whole = Arc::new(FilmSystem::new(Arc::new(ring(columns, 12, LENGTH, 0.0)), 2, regions).unwrap());
    let mut film = plain_film(LENGTH, 0.8, 0.3, SPEED);
    film.cavitation = JFO;
    let solved = film.solve(&whole).unwrap_or_else(|reason| panic!("{reason}"));
    assert!(flows(&solved).imbalance < 1e-12);

    // The same triangles: its diagonals begin the other way round in row 3.
    let land = 0.03;
    let mesh = ring(columns, 6, land, -RADIUS_OF_COLUMN);
    let mut regions = ends(&mesh, land, None);
    regions.iter_mut().for_each(|region| region.pressure = pressure);
    let alone = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).unwrap());
    let mut short = plain_film(land, 0.8, 0.3, SPEED);
    short.cavitation = JFO;
    short.bearing.end_pressure = pressure;
    let expected = short.solve(&alone).unwrap_or_else(|reason| panic!("{reason}"));
    assert!(expected.solution.cavity.contains(&true));
    let theta = |film: &SolvedFilm, dof: usize| {
        film.solution.film_fraction.as_ref().map_or(f64::NAN, |fraction| fraction.values[dof])
    };
    for z in [-0.01, -0.005, 0.0, 0.01] {
        for k in 0..columns {
            let x = RADIUS_OF_COLUMN * RADIUS * f64::from(k);
            let (a, b) = (vertex_dof_at(whole.space(), [x, z]), nearest_on_ring(&alone, [x, z]));
            let error = (solved.solution.unknown[a] - expected.solution.unknown[b]).abs();
            assert!(error < 1e-9 * pressure_scale(), "{error:e} at {x} {z}");
            let error = (theta(&solved, a) - theta(&expected, b)).abs();
            assert!(error < 1e-9, "{error:e} at {x} {z}");
        }
    }
}

/// Angle [rad] of one of 32 columns.
const RADIUS_OF_COLUMN: f64 = std::f64::consts::TAU / 32.0;

/// The dof at the vertex nearest to `(x, z)` [m], modulo a turn.
fn nearest_on_ring(system: &Arc<FilmSystem>, target: [f64; 2]) -> usize {
    let turn = std::f64::consts::TAU * RADIUS;
    let mesh = system.space().mesh();
    let distance = |point: &[f64; 2]| {
        let along = point[0] - target[0];
        (along - turn * (along / turn).round()).hypot(point[1] - target[1])
    };
    let nearest = (0u32..).zip(mesh.points()).min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)));
    system.space().vertex_dof(nearest.map_or(0, |(vertex, _)| vertex))
}
