//! # Flow into the loaded film
//!
//! **Equation.** `Q = Int (theta U h/2 - h^3/(12 mu0) dq/dx) dz`, in the sense of the rotation, along the line at which
//! the loaded film begins: behind the film start, behind the leading edge of an arc; in a ring without such lines where
//! the film is thickest. Where a feed lies on that line it is taken just behind the feed, so that the oil which the
//! feed brings counts; a groove all around cuts every line.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | Q | m3/s | `inlet_flow` |
//!
//! **Source.** Raimondi, Boyd, Trans. ASLE 1 (1958) 159: their flow Q, of which the part Q_s leaves at the ends and the
//! rest goes round.
//! **Range.** A turning journal; the film alone, without what grooves all around carry. **Verified by**
//! `tests/tests/friction.rs`.

use oilwedge_fem::Field;
use oilwedge_fem::control_volumes::sub_triangle_at;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::integrate_interval;

use super::line_cut::{between, cut};
use crate::cavitation::Carriage;
use crate::film_law::FilmLaw;
use crate::film_point::dragged_thickness;
use crate::supply::BoundaryKind;
use crate::{FilmProblem, FilmSystem, SolvedFilm};

/// The flow is taken behind the line by this part of the radius, for the pressure has a kink on it.
const BEHIND: f64 = 1e-9;

/// Flow [m3/s] into the loaded film; none at rest.
pub fn inlet_flow(film: &SolvedFilm) -> Option<f64> {
    inlet_flows(film).map(|flows| flows.iter().sum())
}

/// Parts of the inlet flow [m3/s] through each triangle, zero in those that the line does not cross; none at rest.
pub fn inlet_flows(film: &SolvedFilm) -> Option<Vec<f64>> {
    let SolvedFilm { problem, system, .. } = film;
    let speed = problem.journal.speed;
    if speed == 0.0 {
        return None;
    }
    let sense = speed.signum();
    let mesh = system.space().mesh();
    let step = sense * BEHIND * problem.bearing.radius;
    let x = behind_feeds(system, line(problem, system, sense), step);
    let is_film = system.supply.film(mesh);
    let law = FilmLaw::new(problem, 1.0);
    let carriage = match &film.solution.film_fraction {
        Some(fraction) => Some(Carriage::new(problem, system, fraction).ok()?),
        None => None,
    };
    let [around, _] = problem.theory.directions();
    let part = |t: usize| match is_film[t] {
        true => sense * across((film, carriage.as_ref()), &law, t, x, around),
        false => 0.0,
    };
    Some((0..is_film.len()).map(part).collect())
}

/// Position [m] just behind the line at `x`, or behind the feed on it, in the sense of `step` [m]; on the line where
/// feeds leave no other place.
fn behind_feeds(system: &FilmSystem, x: f64, step: f64) -> f64 {
    let mesh = system.space().mesh();
    let feeds = system.supply.regions().iter().filter(|region| region.kind == BoundaryKind::Feed);
    let extents: Vec<[f64; 2]> = feeds
        .flat_map(|region| {
            let edges = region.edges.iter().map(|&edge| mesh.edge_nodes(edge));
            edges.chain(region.cells.iter().map(|&cell| mesh.corners(cell as usize)))
        })
        .map(|nodes| nodes.map(|[x, _]| x))
        .map(|[a, b, c]| [a.min(b).min(c), a.max(b).max(c)])
        .collect();
    // How far a place is from the nearest image of another.
    let apart = |from: f64, to: f64| match mesh.period() {
        Some(period) => to - from - period * ((to - from) / period).round(),
        None => to - from,
    };
    // No film lies across a groove from end to end.
    let has_film = |x: f64| {
        (0..mesh.triangles().len()).any(|t| {
            let offsets = mesh.corners(t).map(|corner| apart(corner[0], x));
            let extent = offsets.iter().fold(0.0, |most: f64, offset| most.max(offset.abs()));
            let is_near = mesh.period().is_none_or(|period| extent < 0.25 * period);
            is_near && offsets.iter().any(|&offset| offset > 0.0) && offsets.iter().any(|&offset| offset < 0.0)
        })
    };
    let is_free = |x: f64| {
        let covers = |&[low, high]: &[f64; 2]| apart(0.5 * (low + high), x).abs() < 0.5 * (high - low);
        !extents.iter().any(covers) && (extents.is_empty() || has_film(x))
    };
    if is_free(x + step) {
        return x + step;
    }
    let downstream = |place: f64| match mesh.period() {
        Some(period) => (step.signum() * (place - x)).rem_euclid(period),
        None => step.signum() * (place - x),
    };
    let ends = extents.iter().flatten().filter(|&&end| downstream(end) > 0.0);
    let free = ends.filter(|&&end| is_free(end + step));
    let nearest = free.min_by(|a, b| downstream(**a).total_cmp(&downstream(**b)));
    nearest.copied().unwrap_or(x) + step
}

/// Position [m] of the line at which the loaded film begins.
fn line(problem: &FilmProblem, system: &FilmSystem, sense: f64) -> f64 {
    let mesh = system.space().mesh();
    let lines = system.supply.regions().iter().filter(|region| region.kind == BoundaryKind::Line);
    let positions = lines.filter_map(|region| Some(mesh.edge_nodes(*region.edges.first()?)[0][0]));
    // Of the edges of an arc that which the journal leaves.
    let first = positions.min_by(|a, b| (sense * a).total_cmp(&(sense * b)));
    first.unwrap_or_else(|| problem.bearing.radius * (problem.journal.min_film_angle() + std::f64::consts::PI))
}

/// Flow [m3/s] towards growing x through the part of the line at `x` [m] that lies in triangle `t`; pressure drives the
/// part `around` of it. In a cavity flows the oil of the `carriage`.
fn across((film, carriage): (&SolvedFilm, Option<&Carriage>), law: &FilmLaw, t: usize, x: f64, around: f64) -> f64 {
    let space = film.system.space();
    let corners = space.mesh().corners(t);
    let x = match space.mesh().period() {
        Some(period) => {
            let middle = (corners[0][0] + corners[1][0] + corners[2][0]) / 3.0;
            x - period * ((x - middle) / period).round()
        }
        None => x,
    };
    let Some([from, to]) = cut(&corners, 0, x) else {
        return 0.0;
    };
    let mapping = Mapping::of(space.mesh(), t);
    let length = (mapping.at(to).position[1] - mapping.at(from).position[1]).abs();
    let unknown = Field { space, values: &film.solution.unknown };
    let flux = |part: f64| {
        let point = between(&from, &to, part);
        let flow = law.film_and_flows(t, &[mapping.at(point).position]).1[0];
        let fraction = carriage.map_or(1.0, |carriage| {
            let (sub, coordinates) = sub_triangle_at(space, t, point);
            (carriage.carried_to(t, sub, coordinates) / dragged_thickness(law.velocity(), flow.flux)).min(1.0)
        });
        fraction * flow.flux[0] - around * flow.conductance[0] * unknown.value_and_gradient(t, point).1[0]
    };
    length * integrate_interval(flux)
}
