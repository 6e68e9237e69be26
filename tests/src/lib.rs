//! What the tests share: structured liners and plain films, made without files.

pub mod bench;
pub mod big_end;
pub mod capabilities;
pub mod crankshafts;
pub mod elastic_liner;
pub mod engine_bearings;
pub mod flexpde_study;
pub mod house;
pub mod journal_bearings;
pub mod left_out;
pub mod printed;
pub mod program;
pub mod python_environment;
pub mod random_bearings;
pub mod rough_surfaces;
pub mod scenes;
pub mod shaped_bearings;
pub mod short_crankshaft;
pub mod short_orbits;
pub mod sweeps;
pub mod thermal_films;
pub mod tilted_bearings;
pub mod two_scenes;

/// The examples on the first pages of crates that are published alone are tests of the documentation.
#[cfg(doctest)]
mod readmes {
    #[doc = include_str!("../../crates/mesh/README.md")]
    struct Mesh;
    #[doc = include_str!("../../crates/scene/README.md")]
    struct Scene;
    #[doc = include_str!("../../crates/drawing/README.md")]
    struct Drawing;
}

use std::sync::Arc;

use oilwedge_fem::Space;
use oilwedge_mesh::{Mesh, RawMesh};
use oilwedge_reynolds::film_thickness::Eccentricity;
use oilwedge_reynolds::lubricant::{Lubricant, PressureLaw};
use oilwedge_reynolds::supply::{BoundaryKind, SupplyRegion, line_at_angle};
use oilwedge_reynolds::terms::{Couette, Poiseuille};
use oilwedge_reynolds::{Bearing, Cavitation, FilmProblem, FilmSystem, Form, JournalState, Theory};

/// Journal radius of all films here [m].
pub const RADIUS: f64 = 0.05;
/// Radial clearance [m].
pub const CLEARANCE: f64 = 5e-5;
/// Viscosity [Pa s].
pub const VISCOSITY: f64 = 0.02;
/// Density [kg/m3].
pub const DENSITY: f64 = 850.0;
/// Speed [rad/s].
pub const SPEED: f64 = 100.0;

/// A full ring of `columns` by `rows` cells, two triangles each, with groups `end_low` and `end_high`.
///
/// Diagonals alternate, so that the mesh is its own mirror image in both directions if both counts are even.
pub fn ring(columns: u32, rows: u32, length: f64, start: f64) -> Mesh {
    ring_of_radius(RADIUS, columns, rows, length, start)
}

/// A full ring as [`ring`], with another radius [m].
pub fn ring_of_radius(radius: f64, columns: u32, rows: u32, length: f64, start: f64) -> Mesh {
    let circumference = std::f64::consts::TAU * radius;
    let vertex = |i: u32, j: u32| (i % columns) * (rows + 1) + j;
    let points = (0..columns * (rows + 1))
        .map(|k| {
            let (i, j) = (f64::from(k / (rows + 1)), f64::from(k % (rows + 1)));
            let z = length * (j / f64::from(rows) - 0.5);
            [radius * start + circumference * i / f64::from(columns), z]
        })
        .collect();
    let mut triangles = Vec::new();
    for i in 0..columns {
        for j in 0..rows {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            if (i + j) % 2 == 0 {
                triangles.extend([[a, b, c], [a, c, d]]);
            } else {
                triangles.extend([[a, b, d], [b, c, d]]);
            }
        }
    }
    let end = |j: u32| (0..columns).map(|i| [vertex(i, j), vertex(i + 1, j)]).collect();
    let raw = RawMesh {
        points,
        triangles,
        curves: vec![("end_low".into(), end(0)), ("end_high".into(), end(rows))],
        period: Some(circumference),
        ..RawMesh::default()
    };
    Mesh::build(raw).expect("a structured ring has no defects")
}

/// A copy of a mesh with vertices and triangles numbered in reverse order, the corners of each triangle beginning with
/// another one.
pub fn renumbered(mesh: &Mesh) -> Mesh {
    let mut raw = mesh.to_raw();
    let last = raw.points.len() as u32 - 1;
    raw.points.reverse();
    raw.labels.reverse();
    raw.triangles.reverse();
    let turn = |v: u32| last - v;
    for (t, triangle) in raw.triangles.iter_mut().enumerate() {
        *triangle = triangle.map(turn);
        triangle.rotate_left(t % 3);
    }
    for (_, edges) in &mut raw.curves {
        edges.iter_mut().for_each(|edge| *edge = edge.map(turn));
    }
    Mesh::build(raw).expect("the same mesh")
}

/// Length [m] of [`stretched_ring`].
pub const LENGTH_OF_STRETCHED: f64 = 0.1;

/// A ring of triangles some fifteen times longer around than along the axis, many of them obtuse; the line at the angle
/// 0 is straight.
pub fn stretched_ring() -> Mesh {
    let (columns, rows) = (16, 80);
    let mut raw = ring(columns, rows, LENGTH_OF_STRETCHED, 0.0).to_raw();
    let step = std::f64::consts::TAU * RADIUS / f64::from(columns);
    for (k, point) in (1u32..).zip(&mut raw.points) {
        if point[0] > 0.0 && point[1].abs() < 0.499 * LENGTH_OF_STRETCHED {
            point[0] += 0.4 * step * (78.233 * f64::from(k)).sin();
        }
    }
    Mesh::build(raw).expect("no triangle is turned over")
}

/// The ends of a ring at zero pressure and, if given, a film start at that angle [rad].
pub fn ends(mesh: &Mesh, length: f64, film_start: Option<f64>) -> Vec<SupplyRegion> {
    let region = |name: &str, kind, edges| SupplyRegion {
        name: name.to_owned(),
        kind,
        pressure: 0.0,
        edges,
        cells: Vec::new(),
        disc: None,
        film_fraction: None,
    };
    let mut regions: Vec<_> = ["end_low", "end_high"]
        .map(|name| region(name, BoundaryKind::End, mesh.region(name).expect("group of the ring").edges.clone()))
        .into();
    if let Some(angle) = film_start {
        let line = line_at_angle(mesh, RADIUS, length, angle).expect("line of element edges");
        regions.push(region("film_start", BoundaryKind::Line, line));
    }
    regions
}

/// The system of quadratic elements on a ring with film start at `film_start` [rad] or without one.
pub fn ring_system(columns: u32, rows: u32, length: f64, film_start: Option<f64>) -> Arc<FilmSystem> {
    Arc::new(ring_alone(columns, rows, length, film_start))
}

/// The system of [`ring_system`], to have coarser ones put behind it.
pub fn ring_alone(columns: u32, rows: u32, length: f64, film_start: Option<f64>) -> FilmSystem {
    let mesh = ring(columns, rows, length, film_start.unwrap_or(0.0));
    let regions = ends(&mesh, length, film_start);
    FilmSystem::new(Arc::new(mesh), 2, regions).expect("the ends close the ring")
}

/// A plain film: constant viscosity, full Sommerfeld, ends at zero.
pub fn plain_film(length: f64, eccentricity: f64, min_film_angle: f64, speed: f64) -> FilmProblem {
    let journal = JournalState::at_eccentricity(eccentricity, min_film_angle, CLEARANCE, speed);
    FilmProblem {
        theory: Theory::Full,
        bearing: Bearing { radius: RADIUS, length, clearance: CLEARANCE, end_pressure: 0.0 },
        journal,
        film_thickness: vec![Arc::new(Eccentricity { radius: RADIUS, clearance: CLEARANCE })],
        lubricant: Lubricant {
            viscosity: VISCOSITY,
            pressure_law: PressureLaw::Constant,
            density: DENSITY,
            temperature: None,
        },
        form: Form::Conservative,
        terms: vec![Arc::new(Poiseuille), Arc::new(Couette)],
        cavitation: Cavitation::None,
        flow_factors: Vec::new(),
        storage: None,
        viscosity_across: None,
        contact: None,
    }
}

/// Scale of pressure `mu omega / psi^2` [Pa] of the films here.
pub fn pressure_scale() -> f64 {
    VISCOSITY * SPEED * (RADIUS / CLEARANCE).powi(2)
}

/// Observed order from errors on meshes each half as fine as the next.
pub fn order(errors: &[f64]) -> f64 {
    let n = errors.len();
    (errors[n - 2] / errors[n - 1]).log2()
}

/// The dof at the vertex nearest to `(x, z)` [m].
pub fn vertex_dof_at(space: &Space, target: [f64; 2]) -> usize {
    let distance = |point: &[f64; 2]| (point[0] - target[0]).hypot(point[1] - target[1]);
    let nearest = (0u32..).zip(space.mesh().points()).min_by(|(_, a), (_, b)| distance(a).total_cmp(&distance(b)));
    space.vertex_dof(nearest.map_or(0, |(vertex, _)| vertex))
}
