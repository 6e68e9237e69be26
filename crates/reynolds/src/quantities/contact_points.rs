//! # Points of contact: where rough surfaces touch, once a film
//!
//! **Equation.** `Int f(p_a, p_a') dA = Sum a f(p_a(h), p_a'(h))` over points of the developed surface with areas a:
//! what contact carries, what it presses the wall with, and how both change with the gap, all by the same points.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | a | m2 | `area` |
//! | p_a, p_a' | Pa, Pa/m | `pressure`, `slope` |
//!
//! Triangles are divided as the gap asks for (`contact_division`); for the splines of a wall parts are no wider than
//! its cells, too.
//!
//! **Source.** Strang, Fix, An Analysis of the Finite Element Method (1973): rules on parts of triangles. **Range.**
//! Any law of contact. **Verified by** `tests/tests/contact`, `tests/full/tests/contact`.

use oilwedge_fem::in_order;
use oilwedge_fem::integrate::Rule;
use oilwedge_fem::mapping::Mapping;
use oilwedge_fem::quadrature::MOST_POINTS;
use rayon::prelude::*;

use super::contact_division::{ContactTolerance, Division, PARTS, PendingPart, TrianglePart, division};
use super::share::{Resultant, Share};
use crate::angles::sines_and_cosines;
use crate::contact::{Contact, ContactLaw, Fineness};
use crate::wall::grid::{Grid, SplinesAt};
use crate::wall::pressing::quarterings;
use crate::{FilmChange, FilmPoint, FilmProblem, FilmSystem};

/// Fewest batches of points for which a task is made.
const FEW: usize = 64;
/// Triangles that one task looks for points in: surfaces touch on few of them.
const CELLS_A_TASK: usize = 64;

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
    /// Gap between the mean planes [m].
    gap: f64,
    /// Pressure of contact [Pa].
    pub(crate) pressure: f64,
    /// Derivative of the pressure by the gap [Pa/m].
    pub(crate) slope: f64,
    /// The splines of the wall there.
    pub(crate) splines: SplinesAt,
    serves: Serves,
}

impl ContactPoint {
    /// Force and moment of a thrust [N] there.
    pub(crate) fn carried(&self, thrust: f64) -> Resultant {
        let force = self.normal.map(|part| thrust * part);
        Resultant { force, moment: force.map(|force| self.position[1] * force) }
    }
}

/// What points are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Serves {
    /// What the journal carries.
    Load,
    /// The splines of the wall.
    Wall,
    /// Load and wall.
    Both,
}

/// The points of a film where its surfaces touch.
#[derive(Debug, Clone)]
pub struct ContactPoints {
    points: Vec<ContactPoint>,
    /// How many splines the wall has around and along; none where it is rigid.
    splines: [usize; 2],
}

/// A film whose surfaces touch.
struct TouchingFilm<'a> {
    problem: &'a FilmProblem,
    system: &'a FilmSystem,
    law: &'a dyn ContactLaw,
    fineness: Fineness,
    accuracy: ContactTolerance,
    /// The splines whose forces are asked for.
    grid: Option<&'a Grid>,
    /// The splines of the wall that gives way, and how it is bent.
    bent: Option<(&'a Grid, &'a [f64])>,
}

impl TouchingFilm<'_> {
    /// Adds the points of triangle `t`, where its parts touch.
    fn add(&self, t: usize, points: &mut Vec<ContactPoint>) {
        let mesh = self.system.space().mesh();
        let mapping = Mapping::of(mesh, t);
        let by_wall = self.grid.map_or(0, |grid| quarterings(grid, &mesh.corners(t)));
        let mut left = vec![PendingPart::WHOLE];
        while let Some(piece) = left.pop() {
            let part = &PARTS[piece.level][piece.number];
            let gaps = self.at_nodes(t, part.nodes.map(|node| mapping.at(node).position));
            let (of_quarters, is_wide) = match division(self.law, self.fineness, &gaps, piece.level) {
                Division::NoContact => continue,
                Division::Last => (0.0, false),
                Division::Quarters(weight) => (weight, piece.level < by_wall),
            };
            if is_wide && !piece.is_for_load {
                left.extend(piece.quarters());
                continue;
            }
            let [quartered, whole] = piece.shared(of_quarters);
            left.extend(quartered.into_iter().flat_map(PendingPart::quarters));
            let Some(whole) = whole else { continue };
            let (serves, rule) = match whole.is_for_load {
                true if is_wide => (Serves::Load, self.of_load(part)),
                true => (Serves::Both, self.of_load(part)),
                false => (Serves::Wall, &part.lower),
            };
            self.visit((t, rule, whole.weight), serves, points);
            if is_wide {
                left.extend(whole.for_wall().quarters());
            }
        }
    }

    fn of_load<'a>(&self, part: &'a TrianglePart) -> &'a Rule {
        match self.accuracy {
            ContactTolerance::Full => &part.rule,
            ContactTolerance::Lower => &part.lower,
        }
    }

    /// Adds the points of a rule in a triangle.
    fn visit(&self, (t, rule, weight): (usize, &Rule, f64), serves: Serves, found: &mut Vec<ContactPoint>) {
        rule.visit(self.system.space().mesh(), t, |points| {
            let unbent = self.problem.unbent_at(t, points.positions);
            let [sines, cosines] = sines_and_cosines(points.positions, self.problem.bearing.radius);
            for (q, &position) in points.positions.iter().enumerate() {
                let splines = self.grid.map(|grid| grid.splines_at(position));
                let gap = unbent[q] + self.deflection(position, splines);
                let at = self.law.at(gap);
                found.push(ContactPoint {
                    cell: t,
                    position,
                    normal: [cosines[q], sines[q]],
                    area: weight * points.area(q),
                    gap,
                    pressure: at.pressure,
                    slope: at.slope,
                    splines: splines.unwrap_or_default(),
                    serves,
                });
            }
        });
    }

    /// Gaps [m] at the nodes of a part of triangle `t`.
    fn at_nodes(&self, t: usize, positions: [[f64; 2]; 6]) -> [f64; 6] {
        let unbent = self.problem.unbent_at(t, &positions);
        std::array::from_fn(|node| unbent[node] + self.deflection(positions[node], None))
    }

    /// Deflection [m] of the wall at a position, by the splines that are asked for where those are its own.
    fn deflection(&self, position: [f64; 2], splines: Option<SplinesAt>) -> f64 {
        let Some((grid, coefficients)) = self.bent else {
            return 0.0;
        };
        let own = splines.filter(|_| self.grid.is_some_and(|asked| std::ptr::eq(asked, grid)));
        own.unwrap_or_else(|| grid.splines_at(position)).value(grid.numbers(), coefficients)
    }
}

impl ContactPoints {
    /// The points of contact of the film of a problem; none where no contact is simulated.
    pub fn of(problem: &FilmProblem, system: &FilmSystem) -> Option<Self> {
        let grid = problem.deflection().map(|deflection| &deflection.wall.grid);
        Self::found((problem, system), grid, ContactTolerance::Full)
    }

    /// The points of contact of the film of a problem, for a wall on this grid.
    pub(crate) fn on(grid: &Grid, problem: &FilmProblem, system: &FilmSystem) -> Option<Self> {
        Self::found((problem, system), Some(grid), ContactTolerance::Full)
    }

    /// The points of contact of the film of a problem, for what the journal carries alone.
    pub(crate) fn of_load_alone(
        problem: &FilmProblem,
        system: &FilmSystem,
        accuracy: ContactTolerance,
    ) -> Option<Self> {
        Self::found((problem, system), None, accuracy)
    }

    fn found(
        (problem, system): (&FilmProblem, &FilmSystem),
        grid: Option<&Grid>,
        accuracy: ContactTolerance,
    ) -> Option<Self> {
        let Contact { law, fineness, .. } = problem.contact.as_ref()?;
        let deflection = problem.deflection();
        let touching = TouchingFilm {
            problem,
            system,
            law: &**law,
            fineness: *fineness,
            accuracy,
            grid,
            bent: deflection.map(|deflection| (&deflection.wall.grid, &*deflection.coefficients)),
        };
        let is_film = system.supply.film(system.space().mesh());
        let cells: Vec<usize> = (0..is_film.len()).filter(|&t| is_film[t]).collect();
        let of_cells = |cells: &[usize]| {
            let mut points = Vec::new();
            cells.iter().for_each(|&t| touching.add(t, &mut points));
            points
        };
        let points: Vec<Vec<ContactPoint>> = in_order(cells.par_chunks(CELLS_A_TASK).map(of_cells));
        Some(Self { points: points.concat(), splines: grid.map_or([0; 2], Grid::numbers) })
    }

    /// The points where the wall on whose grid they are gives way by more [m], their areas kept; `law` is the law of
    /// their contact.
    pub fn bent_further(&self, law: &dyn ContactLaw, more: &[f64]) -> Self {
        let bent = |point: &ContactPoint| {
            let gap = point.gap + point.splines.value(self.splines, more);
            let at = law.at(gap);
            ContactPoint { gap, pressure: at.pressure, slope: at.slope, ..*point }
        };
        Self { points: in_order(self.points.par_iter().with_min_len(FEW).map(bent)), splines: self.splines }
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
            sum += Share { force, moment, pressure: thrust, possible: thrust.abs() };
        }
        sum
    }

    /// First-order change [m] of the gap at each point with a `change` of the journal or the gap.
    pub fn gap_change(&self, problem: &FilmProblem, change: FilmChange<'_>) -> Vec<f64> {
        let batches: Vec<&[ContactPoint]> =
            (self.points.chunk_by(|a, b| a.cell == b.cell)).flat_map(|of_cell| of_cell.chunks(MOST_POINTS)).collect();
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
                FilmChange::GapRate(_) | FilmChange::Viscosity(_) => {}
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
