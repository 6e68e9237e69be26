//! # Round rims that quadratic edges follow only nearly
//!
//! **Equation.** Hadamard's formula for a goal with the weight w and the dual z, over the rims of holes that are cut out:
//! ```text
//! G = -Int d (p_f w + h^3/(12 mu0) dq/dn dz/dn) ds
//! ```
//! with the distance d from the element edge to the true rim, positive where the film was meshed too large, and the outward
//! normal n.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `gap` |
//! | p_f | Pa | `pressure` |
//!
//! **Source.** Delfour and Zolesio, Shapes and Geometries (2011), ch. 9. **Range.** Circles that the mesh knows; a
//! polygon whose circle nobody told is the rim. **Verified by** `a_straight_rim_raises_the_geometry_part`.

use oilwedge_fem::{Field, quadrature::gauss_interval};
use oilwedge_mesh::Circle;

use crate::film_law::FilmLaw;
use crate::supply::{self, SupplyRegion};
use crate::{FilmPoint, FilmProblem, FilmSolution, FilmSystem};

/// The weight of a goal at a rim: from the region, the position [m] and the film there.
pub(super) type RimWeight<'a> = &'a dyn Fn(&SupplyRegion, [f64; 2], &FilmPoint) -> f64;

/// The formula over all rims, for the goal with the weight `given` and the dual `dual`: exact less computed.
pub(super) fn rims(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    dual: &[f64],
    given: RimWeight,
) -> f64 {
    let mesh = system.space().mesh();
    let regions = system.supply.regions().iter();
    regions
        .flat_map(|region| supply::rim(mesh, region).map(move |edge| (region, edge)))
        .filter_map(|(region, edge)| {
            let disc = region.disc.map(|disc| Circle {
                centre: disc.centre,
                radius: disc.radius,
            });
            let circle = disc.or(mesh.circle(edge).copied())?;
            Some(rim_edge(problem, system, film, dual, given, region, &circle, edge))
        })
        .sum()
}

#[expect(clippy::too_many_arguments, reason = "one edge of the sum above")]
fn rim_edge(
    problem: &FilmProblem,
    system: &FilmSystem,
    film: &FilmSolution,
    dual: &[f64],
    given: RimWeight,
    region: &SupplyRegion,
    circle: &Circle,
    edge: u32,
) -> f64 {
    let (space, mesh) = (system.space(), system.space().mesh());
    let t = mesh.topology().edge_triangles[edge as usize][0] as usize;
    let local = mesh.local_edge(t, edge);
    let nodes = mesh.nodes(t);
    let (a, b, m) = (nodes[local], nodes[(local + 1) % 3], nodes[3 + local]);
    let corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let (from, to) = (corners[local], corners[(local + 1) % 3]);
    let [pressure_field, dual_field] = [&film.unknown[..], dual].map(|values| Field { space, values });
    let mut sum = 0.0;
    for (s, weight) in gauss_interval() {
        let shapes = [(1.0 - s) * (1.0 - 2.0 * s), s * (2.0 * s - 1.0), 4.0 * s * (1.0 - s)];
        let slopes = [4.0 * s - 3.0, 4.0 * s - 1.0, 4.0 - 8.0 * s];
        let at = [0, 1].map(|d| shapes[0] * a[d] + shapes[1] * b[d] + shapes[2] * m[d]);
        let along = [0, 1].map(|d| slopes[0] * a[d] + slopes[1] * b[d] + slopes[2] * m[d]);
        let length = along[0].hypot(along[1]);
        // Triangles run counter-clockwise: outwards is to the right.
        let normal = [along[1] / length, -along[0] / length];
        let point = [0, 1].map(|d| from[d] + s * (to[d] - from[d]));
        let by_normal = |field: &Field| {
            let [x, z] = field.value_and_gradient(t, point).1;
            x * normal[0] + z * normal[1]
        };
        let (film, flows) = FilmLaw::new(problem, 1.0).film_and_flows(t, &[at]);
        let given = given(region, at, &film[0]);
        let gap = circle.radius - distance(mesh.period(), at, circle.centre);
        sum -= weight
            * length
            * gap
            * (given + flows[0].conductance * by_normal(&pressure_field) * by_normal(&dual_field));
    }
    sum
}

/// Distance [m] of two points of the developed surface; on a ring the shorter way round.
fn distance(period: Option<f64>, a: [f64; 2], b: [f64; 2]) -> f64 {
    let mut x = a[0] - b[0];
    if let Some(period) = period {
        x -= period * (x / period).round();
    }
    x.hypot(a[1] - b[1])
}
