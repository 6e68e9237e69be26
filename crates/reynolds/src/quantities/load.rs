//! # Load and moment: what the film carries
//!
//! **Equation.** `W = Int (p - p_e) (cos phi, sin phi) dA` over the whole developed surface: the film by quadrature,
//! regions cut out of the mesh with their pressure. For a region D `Int_D cos(x/R) dA = R closed-Int sin(x/R) dz`,
//! `Int_D sin(x/R) dA = -R closed-Int cos(x/R) dz`. The moment about mid-length is
//! `m = Int (p - p_e) z (cos phi, sin phi) dA`, with z under the integrals of the rims: each part is a force times its
//! arm along the axis, so that m does work on the slope of the journal's axis as W does on its offset.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | W | N | `total` |
//! | m | N m | `moment` |
//! | p, p_e | Pa | `pressure_at`, `end_pressure` |
//!
//! With contact the journal carries that too ([`contact`]).
//!
//! **Source.** Definition; Green's theorem. **Range.** Any closed rim that does not wind round the ring alone, and that
//! of a groove from end to end. **Verified by** `disc_and_rim_agree`, meshed against cut-out holes, scikit-fem.

use std::f64::consts::TAU;

use oilwedge_fem::integrate::edge_points;
use oilwedge_fem::{Field, KinkRule, integrate};
use oilwedge_mesh::Mesh;

use super::contact;
use super::contact_division::ContactTolerance;
use super::contact_points::ContactPoints;
pub use super::share::{Resultant, Share};
use crate::angles::sines_and_cosines;
use crate::supply::{self, Disc, SupplyRegion};
use crate::{FilmChange, FilmProblem, FilmSystem, SolvedFilm};

/// Load of a film and its shares.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Everything: film, regions cut out and contact.
    pub total: Share,
    /// What contact carries; `None` where none is simulated.
    pub contact: Option<Share>,
    /// Regions cut out of the mesh, by name.
    pub cut_out: Vec<(String, Share)>,
}

impl Load {
    /// What the oil carries: all but contact.
    pub fn of_oil(&self) -> Share {
        self.contact.map_or(self.total, |contact| self.total.less(&contact))
    }

    /// Magnitude [N].
    pub fn magnitude(&self) -> f64 {
        self.total.force[0].hypot(self.total.force[1])
    }

    /// Direction [rad], in (-pi, pi].
    pub fn angle(&self) -> f64 {
        self.total.force[1].atan2(self.total.force[0])
    }
}

/// Load of a solved film.
pub fn load(film: &SolvedFilm) -> Load {
    let contact = ContactPoints::of_load_alone(&film.problem, &film.system, ContactTolerance::Full);
    load_touching(film, contact.as_ref())
}

/// Load of a solved film with these points of contact.
pub fn load_touching(film: &SolvedFilm, contact: Option<&ContactPoints>) -> Load {
    let cut_out = cut_out_shares(&film.problem, &film.system);
    let mut total = film_share(film);
    let contact = contact.map(ContactPoints::share);
    for share in cut_out.iter().map(|(_, share)| share).chain(&contact) {
        total += *share;
    }
    Load { total, contact, cut_out }
}

/// The shares of regions cut out of the mesh, by name.
pub(crate) fn cut_out_shares(problem: &FilmProblem, system: &FilmSystem) -> Vec<(String, Share)> {
    let mesh = system.space().mesh();
    let cut_out = (system.supply.regions().iter()).filter(|region| supply::rim(mesh, region).next().is_some());
    cut_out.map(|region| (region.name.clone(), cut_out_share(problem, mesh, region))).collect()
}

/// What loads are small against [N]: what the pressures of a film with this `share` could carry, all on one side. At
/// least what is rounding against drag and against the pressure of the ends.
pub fn possible_load(problem: &FilmProblem, share: &Share) -> f64 {
    const ROUNDING: f64 = 1e-6;
    let bearing = &problem.bearing;
    let drag = problem.lubricant.viscosity * problem.journal.speed.abs() * (bearing.radius / bearing.clearance).powi(2);
    let rounding = ROUNDING * (drag + bearing.end_pressure.abs()) * 2.0 * bearing.radius * bearing.length;
    share.possible.max(rounding)
}

/// First-order change of force and moment with `changes` of the journal and the gap, by which the unknown changes at
/// each dof; contact follows the gap, regions cut out keep their pressure.
pub fn load_change(film: &SolvedFilm, changes: &[FilmChange<'_>], unknown: &[f64]) -> Resultant {
    let mut sum = oil_change(film, unknown);
    sum += contact::contact_change(&film.problem, &film.system, changes);
    sum
}

/// First-order change of force and moment of the oil where the unknown changes by `change` at each dof; regions cut out
/// keep their pressure.
pub fn oil_change(film: &SolvedFilm, change: &[f64]) -> Resultant {
    let excess = |[u, change]: [f64; 2]| film.problem.pressure_slope_at(u) * change;
    let Integral { force, moment, .. } =
        integrated(&film.problem, &film.system, [&film.solution.unknown, change], excess);
    Resultant { force, moment }
}

fn film_share(film: &SolvedFilm) -> Share {
    let p_e = film.problem.bearing.end_pressure;
    let excess =
        integrated(&film.problem, &film.system, [&film.solution.unknown], |[u]| film.problem.pressure_at(u) - p_e);
    Share {
        force: excess.force,
        moment: excess.moment,
        pressure: excess.thrust + p_e * excess.area,
        possible: excess.magnitude,
    }
}

/// Integrals over the film of a density [Pa].
#[derive(Debug, Clone, Copy, Default)]
struct Integral {
    /// Integral with the weight `(cos phi, sin phi)` [N].
    force: [f64; 2],
    /// Integral with the weight `z (cos phi, sin phi)` [N m].
    moment: [f64; 2],
    /// Integral with the weight one [N].
    thrust: f64,
    /// Integral of the magnitude [N].
    magnitude: f64,
    /// Area of the film [m2].
    area: f64,
}

impl std::ops::AddAssign for Integral {
    fn add_assign(&mut self, other: Self) {
        for d in 0..2 {
            self.force[d] += other.force[d];
            self.moment[d] += other.moment[d];
        }
        self.thrust += other.thrust;
        self.magnitude += other.magnitude;
        self.area += other.area;
    }
}

/// Integrals of a density [Pa] that depends on the unknown, and on other functions, given by their nodal values.
fn integrated<const N: usize>(
    problem: &FilmProblem,
    system: &FilmSystem,
    fields: [&[f64]; N],
    density: impl Fn([f64; N]) -> f64 + Sync,
) -> Integral {
    let (space, mesh) = (system.space(), system.space().mesh());
    let rule = KinkRule::for_degree(space.degree());
    let fields = fields.map(|values| Field { space, values });
    integrate(mesh, |t| {
        let nodal = fields.map(|field| field.element_values(t));
        let mut sum = Integral::default();
        rule.visit(mesh, t, problem.kink([&nodal[0]]), |points| {
            let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
            for q in 0..points.positions.len() {
                let area = points.area(q);
                let thrust = area * density(nodal.each_ref().map(|nodal| points.value(q, nodal)));
                let force = [thrust * cosines[q], thrust * sines[q]];
                let arm = points.positions[q][1];
                sum += Integral { force, moment: force.map(|part| arm * part), thrust, magnitude: thrust.abs(), area };
            }
        });
        sum
    })
}

/// Integrals of `cos phi`, `sin phi` and one over a region [m2], and of `z cos phi` and `z sin phi` [m3].
type Moments = [f64; 5];

fn cut_out_share(problem: &FilmProblem, mesh: &Mesh, region: &SupplyRegion) -> Share {
    let radius = problem.bearing.radius;
    let [cos, sin, area, z_cos, z_sin] = match &region.disc {
        Some(disc) => disc_moments(disc, radius),
        None => rim_moments(mesh, region, radius),
    };
    let excess = region.pressure - problem.bearing.end_pressure;
    Share {
        force: [excess * cos, excess * sin],
        moment: [excess * z_cos, excess * z_sin],
        pressure: region.pressure * area,
        possible: (excess * area).abs(),
    }
}

/// Moments along the circle; the trapezoidal rule is exact to rounding for a periodic integrand.
fn disc_moments(disc: &Disc, radius: f64) -> Moments {
    const POINTS: u32 = 64;
    let mut moments = [0.0, 0.0, TAU / 2.0 * disc.radius * disc.radius, 0.0, 0.0];
    for k in 0..POINTS {
        let (up, out) = (TAU * f64::from(k) / f64::from(POINTS)).sin_cos();
        let z = disc.centre[1] + disc.radius * up;
        let dz = disc.radius * out * TAU / f64::from(POINTS);
        let (sin, cos) = ((disc.centre[0] + disc.radius * out) / radius).sin_cos();
        moments[0] += radius * sin * dz;
        moments[1] -= radius * cos * dz;
        moments[3] += z * radius * sin * dz;
        moments[4] -= z * radius * cos * dz;
    }
    moments
}

/// Moments along the quadratic edges of the rim, the film on their left and the region on their right. What closes the
/// rim of a groove of full length lies on the ends, along which `dz = 0`; the area is counted along the axis, and on a
/// ring it is known up to whole rings.
fn rim_moments(mesh: &Mesh, region: &SupplyRegion, radius: f64) -> Moments {
    let mut moments = [0.0; 5];
    for at in supply::rim(mesh, region).flat_map(|edge| edge_points(mesh, edge)) {
        let (sin, cos) = (at.position[0] / radius).sin_cos();
        let along = at.tangent.map(|slope| at.weight * slope);
        moments[0] -= radius * sin * along[1];
        moments[1] += radius * cos * along[1];
        moments[2] -= at.position[0] * along[1];
        moments[3] -= at.position[1] * radius * sin * along[1];
        moments[4] += at.position[1] * radius * cos * along[1];
    }
    if let Some(period) = mesh.period() {
        let ends = mesh.points().iter().map(|point| point[1]);
        let length = ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min);
        moments[2] = moments[2].rem_euclid(period * length);
    }
    moments
}

/// What the share of a region that is cut out of the mesh may be off [N], because parabolas stand for the arcs of its
/// rim; zero for a region that is one round hole, whose shape is given, and along straight sides.
///
/// Between an arc of half the angle a and the parabola through its ends and its middle lies the area `r^2 a^5/30`. That
/// is `8 s^3/(15 l)` for the height s of the arc over its chord l.
pub fn rim_error(problem: &FilmProblem, mesh: &Mesh, region: &SupplyRegion) -> f64 {
    /// An edge whose middle is off its chord by less than this part of its length is straight.
    const STRAIGHT: f64 = 1e-9;
    if region.disc.is_some() {
        return 0.0;
    }
    let between = |edge: u32| {
        let [a, b, middle] = mesh.edge_nodes(edge);
        let chord = (b[0] - a[0]).hypot(b[1] - a[1]);
        let height = (middle[0] - 0.5 * (a[0] + b[0])).hypot(middle[1] - 0.5 * (a[1] + b[1]));
        if height > STRAIGHT * chord { 8.0 / 15.0 * height.powi(3) / chord } else { 0.0 }
    };
    let area: f64 = supply::rim(mesh, region).map(between).sum();
    (region.pressure - problem.bearing.end_pressure).abs() * area
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::supply::BoundaryKind;
    use oilwedge_mesh::RawMesh;

    /// A ring of quadrilaterals round a hole, rims on circles.
    fn annulus(n: u32, hole: &Disc) -> Mesh {
        let at = |k: u32, radius: f64| {
            let (sin, cos) = (TAU * f64::from(k) / f64::from(2 * n)).sin_cos();
            [hole.centre[0] + radius * cos, hole.centre[1] + radius * sin]
        };
        let outer = 2.0 * hole.radius;
        let mut raw = RawMesh::default();
        for k in 0..n {
            raw.points.extend([at(2 * k, hole.radius), at(2 * k, outer)]);
            let (a, b) = (2 * k, 2 * ((k + 1) % n));
            raw.triangles.extend([[a, a + 1, b + 1], [a, b + 1, b]]);
            let (from, to, mid) = (at(2 * k, hole.radius), at(2 * k + 2, hole.radius), at(2 * k + 1, hole.radius));
            raw.bulges.push((2 * k + 1, 2, [0, 1].map(|d| mid[d] - 0.5 * (from[d] + to[d]))));
        }
        raw.curves.push(("hole".into(), (0..n).map(|k| [2 * k, 2 * ((k + 1) % n)]).collect()));
        Mesh::build(raw).unwrap()
    }

    #[test]
    fn disc_and_rim_agree() {
        let hole = Disc { centre: [0.5, 0.1], radius: 0.2 };
        let mesh = annulus(64, &hole);
        let region = SupplyRegion {
            name: "hole".into(),
            kind: BoundaryKind::Feed,
            pressure: 1.0,
            edges: mesh.region("hole").unwrap().edges.clone(),
            cells: Vec::new(),
            disc: None,
            film_fraction: None,
        };
        let (disc, rim) = (disc_moments(&hole, 0.7), rim_moments(&mesh, &region, 0.7));
        for k in 0..5 {
            assert!((disc[k] - rim[k]).abs() < 1e-6 * disc[2], "{k}: {} {}", disc[k], rim[k]);
        }
        assert!((disc[2] - TAU / 2.0 * 0.04).abs() < 1e-15);
        // By symmetry the first moment of the disc is its area's at its centre.
        for k in 0..2 {
            assert!((disc[3 + k] - 0.1 * disc[k]).abs() < 1e-15, "{disc:?}");
        }
    }
}
