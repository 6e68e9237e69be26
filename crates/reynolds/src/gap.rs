//! # Where journal and liner are nearest
//!
//! **Equation.** `h_min = min h(phi, z)`, `h = c - (e + z g).n + shape(phi, z)`. Circular surfaces:
//! `h_min = c - |e + z g|` at the end where it is least, for that is convex in z. Others: the least of the
//! contributions to the film thickness on the triangles of the mesh. The film is linear in the place of the journal, so
//! each node has five numbers: the thickness with the journal in the middle, and what each coordinate changes. The
//! triangles whose quadratic may be least are then searched in the thickness itself.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | h_min | m | `thickness` |
//! | e, g | m, rad | `offset`, `tilt` of the journal |
//! | shape | m | contributions that follow nothing |
//!
//! **Source.** Definition. **Range.** Shapes that triangles resolve: a dent that lies between nodes altogether is not
//! seen. **Verified by** the tests below.

mod lattice;
mod room;

use std::sync::{Arc, OnceLock};

use oilwedge_fem::extrema::{Quadratic, least_at, lower_bound};
use oilwedge_fem::lagrange;
use oilwedge_fem::mapping::Mapping;
use oilwedge_mesh::Mesh;

use self::lattice::{LATTICE, NODES, SPACING, crossing, within};
use crate::film_thickness::FilmContribution;
use crate::journal_state::{COORDINATES, JournalChange};
use crate::{Bearing, FilmPoint, FilmProblem, FilmSystem, JournalState};

/// Triangles that a search for the least film enters, of the [`LOOKED_AT`] it compares.
const SEARCHED: usize = 8;
/// Triangles that are compared, whose films may be least where it is nearly even along a line.
const LOOKED_AT: usize = 64;
/// Smaller triangles in one of them, each at most three quarters of the one before, by which the least of them are
/// told.
const FEW_SHRINKS: usize = 8;
/// Smaller triangles in one that is searched.
const SHRINKS: usize = 96;
/// A search ends when the film in its triangle is even to this part.
const EVEN: f64 = 1e-14;
/// Halvings of the part of a line in which the film is least.
const HALVINGS: usize = 32;
/// Part of the clearance to which the reach of a journal is known.
const EXACT: f64 = 1e-13;
/// Most steps of Newton's method for the reach of a journal.
const MOST_STEPS: usize = 50;

/// The place of the least gap between journal and liner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thinnest {
    /// Gap there [m].
    pub thickness: f64,
    /// Angle [rad].
    pub angle: f64,
    /// Axial position [m].
    pub z: f64,
}

impl Thinnest {
    const NONE: Self = Self { thickness: f64::INFINITY, angle: 0.0, z: 0.0 };

    fn or(self, other: Self) -> Self {
        if other.thickness < self.thickness { other } else { self }
    }
}

/// The space between the liner and a journal that may be anywhere: the only place that knows where the film is least.
#[derive(Debug, Clone)]
pub struct Gap {
    bearing: Bearing,
    shaped: Option<Arc<Shaped>>,
}

/// Surfaces that are not circular, on a mesh.
#[derive(Debug)]
struct Shaped {
    mesh: Arc<Mesh>,
    film_thickness: Vec<Arc<dyn FilmContribution>>,
    /// Film of each triangle at its nodes [m]: with the journal in the middle, and what each coordinate changes; made
    /// for the first of many journals.
    nodes: OnceLock<Vec<[Quadratic; 5]>>,
}

impl Gap {
    /// Gap of circular surfaces.
    pub fn circular(bearing: Bearing) -> Self {
        Self { bearing, shaped: None }
    }

    /// The gap of a film on a mesh.
    pub fn of(problem: &FilmProblem, system: &FilmSystem) -> Self {
        let is_circular = problem.film_thickness.iter().all(|it| it.keeps_circles());
        let shaped = (!is_circular).then(|| Arc::new(Shaped::of(problem, system.space().mesh())));
        Self { bearing: problem.bearing, shaped }
    }

    /// The bearing's dimensions.
    pub fn bearing(&self) -> &Bearing {
        &self.bearing
    }

    /// Where the gap is least with the journal in this state: over the whole circumference, beside the liner of an arc
    /// too, where the bore is taken as circular.
    pub fn thinnest(&self, journal: &JournalState) -> Thinnest {
        self.thinnest_by(journal, Shaped::thinnest)
    }

    fn thinnest_by(&self, journal: &JournalState, on_mesh: fn(&Shaped, &JournalState, f64) -> Thinnest) -> Thinnest {
        let Some(shaped) = &self.shaped else {
            return self.bearing.thinnest(journal);
        };
        let beside = (self.bearing.ends().into_iter())
            .map(|z| self.bearing.thinnest_at(journal, z))
            .filter(|place| !covers(&shaped.mesh, self.bearing.radius, place.angle));
        beside.fold(on_mesh(shaped, journal, self.bearing.radius), Thinnest::or)
    }

    /// Least gap [m] with the journal in this state; negative where it would touch.
    pub fn least(&self, journal: &JournalState) -> f64 {
        self.thinnest(journal).thickness
    }

    /// Least gap [m] of a gap that is asked for one journal alone; see [`Gap::least`].
    pub fn least_of_one(&self, journal: &JournalState) -> f64 {
        self.thinnest_by(journal, Shaped::thinnest_of_one).thickness
    }

    /// Offset [m] towards `angle` [rad] at which a journal with this tilt touches; zero where its tilt alone makes it
    /// touch.
    pub fn reach(&self, journal: &JournalState, angle: f64) -> f64 {
        if self.shaped.is_none() {
            return self.bearing.reach(journal, angle);
        }
        let (sin, cos) = angle.sin_cos();
        let at = |e: f64| self.thinnest(&JournalState { offset: [e * cos, e * sin], ..*journal });
        if at(0.0).thickness <= 0.0 {
            return 0.0;
        }
        // The least of functions that are linear in e is concave: from a journal that touches Newton's method comes
        // nearer without passing.
        let mut e = self.bearing.clearance;
        while at(e).thickness > 0.0 {
            e *= 2.0;
        }
        for _ in 0..MOST_STEPS {
            let place = at(e);
            let step = place.thickness / (place.angle - angle).cos();
            e += step;
            if step.abs() < EXACT * self.bearing.clearance {
                break;
            }
        }
        e.max(0.0)
    }

    /// Where the film on the liner of `mesh` is least. Where the liner of an arc covers neither end's thinnest gap,
    /// that is at an edge.
    pub fn thinnest_film(&self, problem: &FilmProblem, system: &FilmSystem) -> Thinnest {
        let (bearing, journal, mesh) = (&self.bearing, &problem.journal, system.space().mesh());
        if let Some(shaped) = &self.shaped {
            // A wall that gives way rises towards the ends within less than a triangle.
            let ends = bearing.ends().map(|z| shaped.thinnest_at(journal, bearing.radius, z));
            return ends.into_iter().fold(shaped.thinnest_of_one(journal, bearing.radius), Thinnest::or);
        }
        let is_covered = |place: &Thinnest| covers(mesh, bearing.radius, place.angle);
        let thinnest = bearing.thinnest(journal);
        if is_covered(&thinnest) {
            return thinnest;
        }
        let at_nodes = (0..mesh.triangles().len()).flat_map(|t| {
            let nodes = mesh.nodes(t);
            problem.thickness_at(t, &nodes).into_iter().zip(nodes)
        });
        let at_nodes = at_nodes.map(|(thickness, [x, z])| Thinnest { thickness, angle: x / bearing.radius, z });
        let ends = bearing.ends().map(|z| bearing.thinnest_at(journal, z)).into_iter();
        ends.filter(is_covered).chain(at_nodes).fold(Thinnest::NONE, Thinnest::or)
    }

    /// Where the gap at the axial position `z` [m] is least with the journal in this state.
    pub fn thinnest_at(&self, journal: &JournalState, z: f64) -> Thinnest {
        match &self.shaped {
            None => self.bearing.thinnest_at(journal, z),
            Some(shaped) => shaped.thinnest_at(journal, self.bearing.radius, z),
        }
    }

    /// Where the film on the liner of `mesh` is least at the axial position `z` [m].
    pub fn thinnest_film_at(&self, problem: &FilmProblem, system: &FilmSystem, z: f64) -> Thinnest {
        let (journal, mesh) = (&problem.journal, system.space().mesh());
        let place = self.thinnest_at(journal, z);
        match self.shaped.is_some() || covers(mesh, self.bearing.radius, place.angle) {
            true => place,
            false => Shaped::of(problem, mesh).thinnest_at(journal, self.bearing.radius, z),
        }
    }
}

/// Whether the liner of a mesh covers an angle [rad].
fn covers(mesh: &Mesh, radius: f64, angle: f64) -> bool {
    match mesh.period() {
        Some(_) => true,
        None => {
            let xs = mesh.points().iter().map(|point| point[0]);
            let (low, high) = xs.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            let x = angle * radius;
            let turn = std::f64::consts::TAU * radius;
            (x - low).rem_euclid(turn) <= high - low
        }
    }
}

impl Shaped {
    fn of(problem: &FilmProblem, mesh: &Arc<Mesh>) -> Self {
        Self { nodes: OnceLock::new(), mesh: mesh.clone(), film_thickness: problem.film_thickness.clone() }
    }

    /// The film at the nodes of triangle `t` [m]: with the journal in the middle, and what each coordinate changes.
    fn nodes_of(&self, t: usize) -> [Quadratic; 5] {
        let (contributions, positions) = (&self.film_thickness, self.mesh.nodes(t));
        let mut numbers = [[0.0; 6]; 5];
        numbers[0] = thickness(contributions, &JournalState::default(), t, &positions);
        for k in 0..COORDINATES {
            let mut film = [FilmPoint::default(); 6];
            let change = JournalChange::of_coordinate(k);
            (contributions.iter()).for_each(|it| it.vary(&change, t, &positions, &mut film));
            numbers[1 + k] = film.map(|point| point.thickness);
        }
        numbers
    }

    /// Place at which the film on the mesh is least.
    fn thinnest(&self, journal: &JournalState, radius: f64) -> Thinnest {
        let [e, g] = [journal.offset, journal.tilt];
        let place = [1.0, e[0], e[1], g[0], g[1]];
        let triangles = 0..self.mesh.triangles().len();
        let nodes = (self.nodes).get_or_init(|| triangles.map(|t| self.nodes_of(t)).collect());
        let at_nodes = |t: usize| {
            let mut values = [0.0; 6];
            for (number, part) in nodes[t].iter().zip(place) {
                (0..6).for_each(|node| values[node] += part * number[node]);
            }
            values
        };
        self.thinnest_by(at_nodes, journal, radius)
    }

    /// Where the film on the mesh is least for one journal alone: its film at the nodes is evaluated directly, and what
    /// each coordinate changes is not made.
    fn thinnest_of_one(&self, journal: &JournalState, radius: f64) -> Thinnest {
        let at_nodes = |t: usize| thickness(&self.film_thickness, journal, t, &self.mesh.nodes(t));
        self.thinnest_by(at_nodes, journal, radius)
    }

    /// Where the film is least that has this thickness [m] at the nodes of each triangle.
    fn thinnest_by(&self, at_nodes: impl Fn(usize) -> Quadratic, journal: &JournalState, radius: f64) -> Thinnest {
        let mut lowest: Vec<(f64, usize)> = Vec::with_capacity(LOOKED_AT + 1);
        // No film is least that lies above a node of another triangle.
        let mut least_node = f64::INFINITY;
        for t in 0..self.mesh.triangles().len() {
            let nodes = at_nodes(t);
            let bound = lower_bound(&nodes);
            least_node = nodes.into_iter().fold(least_node, f64::min);
            let at = lowest.partition_point(|(other, _)| *other <= bound);
            if at < LOOKED_AT {
                lowest.insert(at, (bound, t));
                lowest.truncate(LOOKED_AT);
            }
        }
        let may_be_least = lowest.iter().filter(|(bound, _)| *bound <= least_node).count();
        lowest.truncate(may_be_least.max(SEARCHED));
        if lowest.len() > SEARCHED {
            for (film, t) in &mut lowest {
                *film = self.thinnest_in(*t, journal, radius, FEW_SHRINKS).thickness;
            }
            lowest.sort_by(|(a, _), (b, _)| a.total_cmp(b));
            lowest.truncate(SEARCHED);
        }
        let searched = (lowest.into_iter()).map(|(_, t)| self.thinnest_in(t, journal, radius, SHRINKS));
        searched.fold(Thinnest::NONE, Thinnest::or)
    }

    /// Where the film in triangle `t` is least: in ever smaller triangles, so many, around the least value of a
    /// lattice, or of the quadratic through the nodes.
    fn thinnest_in(&self, t: usize, journal: &JournalState, radius: f64, shrinks: usize) -> Thinnest {
        let mapping = Mapping::of(&self.mesh, t);
        let mut corners = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let mut best = Thinnest::NONE;
        for _ in 0..shrinks {
            let points = LATTICE.map(|at| within(&corners, at));
            let film = self.film(&mapping, t, journal, &points);
            let between = least_at(&NODES.map(|k| film[k].0));
            let [at_least] = self.film(&mapping, t, journal, &[within(&corners, between)]);
            let mut least = (between, at_least);
            for (point, film) in LATTICE.into_iter().zip(film) {
                least = if film.0 < least.1.0 { (point, film) } else { least };
            }
            let (point, (thickness, [x, z])) = least;
            best = best.or(Thinnest { thickness, angle: x / radius, z });
            let greatest = film.iter().fold(thickness, |greatest, (film, _)| greatest.max(*film));
            if greatest - thickness <= EVEN * thickness.abs() {
                break;
            }
            // The triangle around it that holds its neighbours.
            let beyond = lagrange::barycentric(point).map(|part| (part - SPACING).max(0.0));
            let left = 1.0 - beyond.iter().sum::<f64>();
            corners = [0, 1, 2].map(|k| {
                let place = |d: usize| beyond[d] + if d == k { left } else { 0.0 };
                within(&corners, [place(1), place(2)])
            });
        }
        best
    }

    /// Where the film at the axial position `z` [m] is least: on the parts of that line in the triangles.
    fn thinnest_at(&self, journal: &JournalState, radius: f64, z: f64) -> Thinnest {
        let mut lowest: Vec<(f64, usize, [f64; 2])> = Vec::with_capacity(SEARCHED + 1);
        for t in 0..self.mesh.triangles().len() {
            let Some([from, to]) = crossing(self.mesh.corners(t), z) else {
                continue;
            };
            let xs = [from, 0.5 * (from + to), to];
            let film = thickness(&self.film_thickness, journal, t, &xs.map(|x| [x, z]));
            let least = film.into_iter().fold(f64::INFINITY, f64::min);
            let at = lowest.partition_point(|(other, ..)| *other <= least);
            if at < SEARCHED {
                lowest.insert(at, (least, t, [from, to]));
                lowest.truncate(SEARCHED);
            }
        }
        let searched = (lowest.into_iter()).map(|(_, t, [mut from, mut to])| {
            let mut best = Thinnest::NONE;
            for _ in 0..HALVINGS {
                let xs: [f64; 5] = std::array::from_fn(|k| from + 0.25 * k as f64 * (to - from));
                let film = thickness(&self.film_thickness, journal, t, &xs.map(|x| [x, z]));
                let least = (0..5).fold(0, |least, k| if film[k] < film[least] { k } else { least });
                best = best.or(Thinnest { thickness: film[least], angle: xs[least] / radius, z });
                (from, to) = (xs[least.saturating_sub(1)], xs[(least + 1).min(4)]);
            }
            best
        });
        searched.fold(Thinnest::NONE, Thinnest::or)
    }

    /// Film thickness [m] at reference points of triangle `t`, and where they are [m].
    fn film<const N: usize>(
        &self,
        mapping: &Mapping,
        t: usize,
        journal: &JournalState,
        points: &[[f64; 2]; N],
    ) -> [(f64, [f64; 2]); N] {
        let positions = points.map(|point| mapping.at(point).position);
        let film = thickness(&self.film_thickness, journal, t, &positions);
        std::array::from_fn(|k| (film[k], positions[k]))
    }
}

fn thickness<const N: usize>(
    contributions: &[Arc<dyn FilmContribution>],
    journal: &JournalState,
    t: usize,
    positions: &[[f64; 2]; N],
) -> [f64; N] {
    let mut film = [FilmPoint::default(); N];
    (contributions.iter()).for_each(|it| it.add(journal, t, positions, &mut film));
    film.map(|point| point.thickness)
}

#[cfg(test)]
mod tests;
