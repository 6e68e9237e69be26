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
//! Triangles are divided as the gap asks for (`contact_division`); for the splines of a wall parts are no wider than its cells, too.
//!
//! **Source.** Strang, Fix, An Analysis of the Finite Element Method (1973): rules on parts of triangles. **Range.** Any law of contact. **Verified by** `tests/tests/contact`,
//! `tests/tests/liner/contact.rs`.

use std::ops::AddAssign;

use oilwedge_fem::integrate;
use oilwedge_fem::integrate::Rule;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use rayon::prelude::*;

use super::contact_division::{Accuracy, Division, PARTS, Part, Piece, division};
use super::share::{Resultant, Share};
use crate::angles::sines_and_cosines;
use crate::contact::{Contact, ContactLaw};
use crate::wall::grid::{Grid, SplinesAt};
use crate::wall::pressing::quarterings;
use crate::{FilmChange, FilmPoint, FilmProblem, FilmSystem};

/// Fewest batches of points for which a task is made.
const FEW: usize = 64;

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
        (t, rule, weight): (usize, &Rule, f64),
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
                    area: weight * points.area(q),
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
        Self::found((problem, system), grid, Accuracy::Full)
    }

    /// Of that film, for a wall on this grid.
    pub(crate) fn on(grid: &Grid, problem: &FilmProblem, system: &FilmSystem) -> Option<Self> {
        Self::found((problem, system), Some(grid), Accuracy::Full)
    }

    /// Of that film, for what the journal carries alone.
    pub(crate) fn of_load_alone(problem: &FilmProblem, system: &FilmSystem, accuracy: Accuracy) -> Option<Self> {
        Self::found((problem, system), None, accuracy)
    }

    fn found((problem, system): (&FilmProblem, &FilmSystem), grid: Option<&Grid>, accuracy: Accuracy) -> Option<Self> {
        let Contact { law, fineness, .. } = problem.contact?;
        let mesh = system.space().mesh();
        let is_film = system.supply.film(mesh);
        let of_load = |part: &'static Part| match accuracy {
            Accuracy::Full => &part.rule,
            Accuracy::Lower => &part.lower,
        };
        let points = integrate(mesh, |t| {
            let (mut points, mapping) = (OfTriangles::default(), Mapping::of(mesh, t));
            let by_wall = grid.map_or(0, |grid| quarterings(grid, &mesh.corners(t)));
            let mut left = if is_film[t] { vec![Piece::WHOLE] } else { Vec::new() };
            while let Some(piece) = left.pop() {
                let part = &PARTS[piece.level][piece.number];
                let positions = part.nodes.map(|node| mapping.at(node).position);
                let gaps = problem.thickness_at(t, &positions);
                let (of_quarters, is_wide) = match division(&law, fineness, &gaps, piece.level) {
                    Division::NoContact => continue,
                    Division::Last => (0.0, false),
                    Division::Quarters(weight) => (weight, piece.level < by_wall),
                };
                if is_wide && !piece.is_for_load {
                    left.extend(piece.quarters());
                    continue;
                }
                let [quartered, whole] = piece.shared(of_quarters);
                left.extend(quartered.into_iter().flat_map(Piece::quarters));
                let Some(whole) = whole else { continue };
                let (serves, rule) = match whole.is_for_load {
                    true if is_wide => (Serves::Load, of_load(part)),
                    true => (Serves::Both, of_load(part)),
                    false => (Serves::Wall, &part.lower),
                };
                points.visit((problem, system), (&law, grid), (t, rule, whole.weight), serves);
                if is_wide {
                    left.extend(whole.for_wall().quarters());
                }
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
