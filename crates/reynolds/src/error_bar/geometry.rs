//! # Round rims that quadratic edges follow only nearly
//!
//! **Equation.** Hadamard's formula for a goal with the weight w and the dual z, over the rims of holes that are cut
//! out:
//! ```text
//! G = -Int d (p_f w + h^3/(12 mu0) dq/dn dz/dn) ds
//! ```
//! with the distance d from the element edge to the true rim, positive where the film was meshed too large, and the
//! outward normal n.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | d | m | `gap` |
//! | p_f | Pa | `pressure` |
//!
//! **Source.** Delfour and Zolesio, Shapes and Geometries (2011), ch. 9. **Range.** Circles that the mesh knows; a
//! polygon whose circle nobody told is the rim. **Verified by** `a_straight_rim_raises_the_geometry_part`.

use oilwedge_fem::Field;
use oilwedge_fem::integrate::edge_points;
use oilwedge_mesh::Circle;

use crate::film_law::FilmLaw;
use crate::supply::{self, SupplyRegion};
use crate::{FilmPoint, SolvedFilm};

/// The weight of a goal at a rim: from the region, the position [m] and the film there.
pub(super) type RimWeight<'a> = &'a dyn Fn(&SupplyRegion, [f64; 2], &FilmPoint) -> f64;

/// The formula over all rims, for the goal with the weight `given` and the dual `dual`: exact less computed.
pub(super) fn rims(film: &SolvedFilm, dual: &[f64], given: RimWeight) -> f64 {
    let (space, mesh) = (film.system.space(), film.system.space().mesh());
    let fields = [&film.solution.unknown[..], dual].map(|values| Field { space, values });
    let law = FilmLaw::new(&film.problem, 1.0);
    let edge_part = |region: &SupplyRegion, edge: u32| {
        let disc = region.disc.map(|disc| Circle { centre: disc.centre, radius: disc.radius });
        let circle = disc.or(mesh.circle(edge).copied())?;
        let mut sum = 0.0;
        for at in edge_points(mesh, edge) {
            let length = at.tangent[0].hypot(at.tangent[1]);
            // Triangles run counter-clockwise: outwards is to the right.
            let normal = [at.tangent[1] / length, -at.tangent[0] / length];
            let [pressure_slope, dual_slope] = fields.map(|field| {
                let [x, z] = field.value_and_gradient(at.cell, at.point).1;
                x * normal[0] + z * normal[1]
            });
            let (film, flows) = law.film_and_flows(at.cell, &[at.position]);
            // The pressure is one along a rim, so that its gradient and that of the dual lie across it.
            let [k_x, k_z] = flows[0].conductance;
            let conductance = k_x + (k_z - k_x) * normal[1] * normal[1];
            let given = given(region, at.position, &film[0]);
            let gap = circle.radius - distance(mesh.period(), at.position, circle.centre);
            sum -= at.weight * length * gap * (given + conductance * pressure_slope * dual_slope);
        }
        Some(sum)
    };
    let regions = film.system.supply.regions().iter();
    regions
        .flat_map(|region| supply::rim(mesh, region).map(move |edge| (region, edge)))
        .filter_map(|(region, edge)| edge_part(region, edge))
        .sum()
}

/// Distance [m] of two points of the developed surface; on a ring the shorter way round.
fn distance(period: Option<f64>, a: [f64; 2], b: [f64; 2]) -> f64 {
    let mut x = a[0] - b[0];
    if let Some(period) = period {
        x -= period * (x / period).round();
    }
    x.hypot(a[1] - b[1])
}
