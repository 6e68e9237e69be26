//! # Points of contact: where rough surfaces touch, once a film
//!
//! **Equation.** `Int f(p_a, p_a') dA = Sum a f(p_a(h), p_a'(h))` over points of the developed surface with areas a: what contact carries, what it presses the wall with, and how
//! both change with the gap, all by the same points.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | a | m2 | `area` |
//! | p_a, p_a' | Pa, Pa/m | `pressure`, `slope` |
//!
//! The pressure falls to nothing over some roughnesses, far quicker than a film changes: each triangle is quartered, and each part again, until the gap changes little over a part, and
//! further where the law has a kink in it. For the splines of a wall parts are no wider than its cells, too.
//! Contact depends on the gap alone, so that this quadrature, and not the elements of the film, limits its accuracy.
//!
//! **Source.** Strang, Fix, An Analysis of the Finite Element Method (1973): rules on parts of triangles. **Range.** Any law of contact. **Verified by** `tests/tests/contact`,
//! `tests/tests/liner/contact.rs`.

use std::ops::AddAssign;
use std::sync::LazyLock;

use oilwedge_fem::integrate::Rule;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use oilwedge_fem::{Quadrature, integrate};
use rayon::prelude::*;

use super::share::{Resultant, Share};
use crate::angles::sines_and_cosines;
use crate::contact::ContactLaw;
use crate::wall::grid::{Grid, SplinesAt};
use crate::wall::pressing::quarterings;
use crate::{FilmChange, FilmPoint, FilmProblem, FilmSystem};

/// Triangles, and their parts again, are quartered at most this often,
const MOST_QUARTERINGS: usize = 5;
/// until the gap changes by this part of the scale of the law over each part where the pressure is the hardness: an error that falls with the tenth power of the parts
/// is the same for parts that are longer by the tenth root where the pressure is less,
const PART: f64 = 0.5;
const ORDER: f64 = 10.0;
/// and at least so often where the law has a kink in them,
const KINK_QUARTERINGS: usize = 4;
/// where the pressure is more than this part of the hardness.
const SLIGHT: f64 = 1e-10;

/// Fewest batches of points for which a task is made.
const FEW: usize = 64;

/// How finely contact is integrated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fineness {
    /// As it is reported.
    Full,
    /// With a quartering less, to compare with.
    Halved,
}

/// A part of the reference triangle.
struct Part {
    /// Of degree 8,
    rule: Rule,
    /// and of degree 6, for splines that have a kink amid the part.
    for_splines: Rule,
    /// Corners and middles of the sides.
    nodes: [[f64; 2]; 6],
}

/// The parts of a triangle after each quartering; those of part k are numbers 4 k to 4 k + 3 of the next.
static PARTS: LazyLock<Vec<Vec<Part>>> = LazyLock::new(|| {
    let mut corners = vec![[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]];
    let mut parts = vec![corners.iter().map(Part::of).collect()];
    for _ in 0..MOST_QUARTERINGS {
        corners = corners.iter().flat_map(quartered).collect();
        parts.push(corners.iter().map(Part::of).collect());
    }
    parts
});

impl Part {
    fn of(corners: &[[f64; 2]; 3]) -> Self {
        let ([a, b, c], [ab, bc, ca]) = (*corners, middles(corners));
        Self {
            rule: Rule::new(Quadrature::for_degree(3).on_part(*corners), 1),
            for_splines: Rule::new(Quadrature::for_degree(2).on_part(*corners), 1),
            nodes: [a, b, c, ab, bc, ca],
        }
    }
}

/// The middles of the sides of a triangle.
fn middles(&[a, b, c]: &[[f64; 2]; 3]) -> [[f64; 2]; 3] {
    [(a, b), (b, c), (c, a)].map(|(from, to)| [0, 1].map(|d| 0.5 * (from[d] + to[d])))
}

/// The four congruent parts of a triangle.
fn quartered(corners: &[[f64; 2]; 3]) -> [[[f64; 2]; 3]; 4] {
    let ([a, b, c], [ab, bc, ca]) = (*corners, middles(corners));
    [[a, ab, ca], [ab, b, bc], [ca, bc, c], [bc, ca, ab]]
}

/// A point where surfaces touch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactPoint {
    /// The triangle in which it lies.
    pub(crate) cell: usize,
    /// Position on the developed surface [m].
    pub(crate) position: [f64; 2],
    /// `cos phi`, `sin phi`.
    normal: [f64; 2],
    /// What its pressure acts on [m2].
    pub(crate) area: f64,
    /// Pressure of contact [Pa].
    pub(crate) pressure: f64,
    /// Its derivative by the gap [Pa/m].
    pub(crate) slope: f64,
    /// The splines of the wall there.
    pub(crate) splines: SplinesAt,
    serves: Serves,
}

impl ContactPoint {
    /// Force and moment of a thrust [N] there.
    pub(crate) fn carried(&self, thrust: f64) -> Resultant {
        let force = self.normal.map(|part| thrust * part);
        Resultant {
            force,
            moment: force.map(|force| self.position[1] * force),
        }
    }
}

/// What points are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Serves {
    /// What the journal carries.
    Load,
    /// The splines of the wall.
    Wall,
    /// Both.
    Both,
}

/// The points of a film where its surfaces touch.
#[derive(Debug, Clone)]
pub struct ContactPoints {
    points: Vec<ContactPoint>,
    /// How many splines the wall has around and along; none where it is rigid.
    splines: [usize; 2],
}

/// The points of some triangles.
#[derive(Default)]
struct OfTriangles(Vec<ContactPoint>);

impl AddAssign for OfTriangles {
    fn add_assign(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }
}

impl OfTriangles {
    /// Adds the points of a rule in a triangle.
    fn visit(
        &mut self,
        (problem, system): (&FilmProblem, &FilmSystem),
        (law, grid): (&ContactLaw, Option<&Grid>),
        (t, rule): (usize, &Rule),
        serves: Serves,
    ) {
        rule.visit(system.space().mesh(), t, |points| {
            let gaps = problem.gaps_at(t, points.positions);
            let [sines, cosines] = sines_and_cosines(points.positions, problem.bearing.radius);
            for (q, &position) in points.positions.iter().enumerate() {
                let at = law.at(gaps[q]);
                self.0.push(ContactPoint {
                    cell: t,
                    position,
                    normal: [cosines[q], sines[q]],
                    area: points.area(q),
                    pressure: at.pressure,
                    slope: at.slope,
                    splines: grid.map_or_else(SplinesAt::default, |grid| grid.splines_at(position)),
                    serves,
                });
            }
        });
    }
}

impl ContactPoints {
    /// Of the film of a problem; none where no contact is simulated.
    pub fn of(problem: &FilmProblem, system: &FilmSystem) -> Option<Self> {
        let grid = problem.deflection().map(|deflection| &deflection.wall.grid);
        Self::found((problem, system), grid, Fineness::Full)
    }

    /// Of that film, for a wall on this grid.
    pub(crate) fn on(grid: &Grid, problem: &FilmProblem, system: &FilmSystem) -> Option<Self> {
        Self::found((problem, system), Some(grid), Fineness::Full)
    }

    /// Of that film, for what the journal carries alone.
    pub(crate) fn of_load_alone(problem: &FilmProblem, system: &FilmSystem, fineness: Fineness) -> Option<Self> {
        Self::found((problem, system), None, fineness)
    }

    fn found((problem, system): (&FilmProblem, &FilmSystem), grid: Option<&Grid>, fineness: Fineness) -> Option<Self> {
        let law = problem.contact?.law;
        let mesh = system.space().mesh();
        let is_film = system.supply.film(mesh);
        let points = integrate(mesh, |t| {
            let (mut points, mapping) = (OfTriangles::default(), Mapping::of(mesh, t));
            let by_wall = grid.map_or(0, |grid| quarterings(grid, &mesh.corners(t)));
            let mut left = if is_film[t] { vec![(0, 0, true)] } else { Vec::new() };
            while let Some((level, number, is_for_load)) = left.pop() {
                let part = &PARTS[level][number];
                let positions = part.nodes.map(|node| mapping.at(node).position);
                let gaps = problem.thickness_at(t, &positions);
                let parts = |is_for_load: bool| (0..4).map(move |k| (level + 1, 4 * number + k, is_for_load));
                let (serves, rule) = match division(&law, &gaps, level, fineness) {
                    Division::NoContact => continue,
                    Division::Parts => {
                        left.extend(parts(is_for_load));
                        continue;
                    }
                    Division::Whole if level < by_wall => {
                        left.extend(parts(false));
                        if !is_for_load {
                            continue;
                        }
                        (Serves::Load, &part.rule)
                    }
                    Division::Whole | Division::Last if is_for_load => (Serves::Both, &part.rule),
                    Division::Whole | Division::Last => (Serves::Wall, &part.for_splines),
                };
                points.visit((problem, system), (&law, grid), (t, rule), serves);
            }
            points
        });
        Some(Self {
            points: points.0,
            splines: grid.map_or([0; 2], Grid::numbers),
        })
    }

    /// How many splines there are around and along the wall.
    pub(crate) fn splines(&self) -> [usize; 2] {
        self.splines
    }

    /// What contact carries.
    pub fn share(&self) -> Share {
        let mut sum = Share::default();
        for (_, point) in self.of_load() {
            let thrust = point.area * point.pressure;
            let Resultant { force, moment } = point.carried(thrust);
            sum += Share {
                force,
                moment,
                pressure: thrust,
                possible: thrust.abs(),
            };
        }
        sum
    }

    /// First-order change [m] of the gap at each point with a `change` of the journal or the gap.
    pub fn gap_change(&self, problem: &FilmProblem, change: FilmChange<'_>) -> Vec<f64> {
        let batches: Vec<&[ContactPoint]> = (self.points.chunk_by(|a, b| a.cell == b.cell))
            .flat_map(|of_cell| of_cell.chunks(MOST_POINTS))
            .collect();
        let moved = |batch: &&[ContactPoint]| {
            let mut film = [FilmPoint::default(); MOST_POINTS];
            let mut positions = [[0.0; 2]; MOST_POINTS];
            (positions.iter_mut().zip(*batch)).for_each(|(position, point)| *position = point.position);
            let (cell, number) = (batch[0].cell, batch.len());
            let (positions, moved) = (&positions[..number], &mut film[..number]);
            match change {
                FilmChange::Journal(change) => {
                    for contribution in &problem.film_thickness {
                        contribution.vary(&change, cell, positions, moved);
                    }
                }
                FilmChange::Gap(shape) => shape.add(&problem.journal, cell, positions, moved),
                FilmChange::GapRate(_) => {}
            }
            film.into_iter().take(number).map(|point| point.thickness)
        };
        batches.par_iter().with_min_len(FEW).flat_map_iter(moved).collect()
    }

    /// First-order change of what contact carries where the gap changes by `moved` [m] at each point.
    pub fn load_change(&self, moved: &[f64]) -> Resultant {
        let mut sum = Resultant::default();
        for (number, point) in self.of_load() {
            sum += point.carried(point.area * point.slope * moved[number]);
        }
        sum
    }

    /// The points for what the journal carries, with their numbers.
    pub(crate) fn of_load(&self) -> impl Iterator<Item = (usize, &ContactPoint)> {
        let points = self.points.iter().enumerate();
        points.filter(|(_, point)| point.serves != Serves::Wall)
    }

    /// The points for the splines of the wall, with their numbers; none of a rigid one.
    pub(crate) fn of_wall(&self) -> impl Iterator<Item = (usize, &ContactPoint)> {
        let points: &[ContactPoint] = if self.splines == [0; 2] { &[] } else { &self.points };
        let points = points.iter().enumerate();
        points.filter(|(_, point)| point.serves != Serves::Load)
    }
}

/// What is done with a part of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Division {
    /// Surfaces do not touch there.
    NoContact,
    /// It is integrated as it is; the splines of the wall may have it divided further.
    Whole,
    /// It is integrated as it is: its pressure is slight, or its parts would be too many.
    Last,
    /// It is quartered.
    Parts,
}

/// What is done with a part of a triangle, from the gaps [m] at its nodes and how often it was quartered.
fn division(law: &ContactLaw, gaps: &[f64; 6], level: usize, fineness: Fineness) -> Division {
    /// The gap inside of a triangle may be less than that at its nodes by this part of its range.
    const WITHIN: f64 = 0.25;
    let (least, greatest) = gaps
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, greatest), &gap| {
            (least.min(gap), greatest.max(gap))
        });
    let least = least - WITHIN * (greatest - least);
    if least >= law.reach() {
        return Division::NoContact;
    }
    let pressure = law.at(least).pressure / law.hardness();
    // How much further it would be divided in full.
    let spared = match fineness {
        Fineness::Full => 0,
        Fineness::Halved => 1,
    };
    if pressure < SLIGHT || level + spared >= MOST_QUARTERINGS {
        return Division::Last;
    }
    let part = PART * pressure.powf(-1.0 / ORDER);
    // Beyond the reach the gap does not matter.
    let range = greatest.min(law.reach()) - least;
    let is_steep = range > f64::from(1u32 << spared) * part * law.scale();
    let is_kinked = level + spared < KINK_QUARTERINGS && law.has_kink_in(least..greatest);
    match is_steep || is_kinked || level + spared == 0 {
        true => Division::Parts,
        false => Division::Whole,
    }
}
