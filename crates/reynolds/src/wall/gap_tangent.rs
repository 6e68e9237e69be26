//! How the residual of a film changes with the deflection of its wall and with the place of the journal: a sparse
//! matrix of a mesh and a grid, and one column a coordinate.
//!
//! At a point the law changes linearly with the gap and its slopes there. Where the wall moves by `Sum x_j B_j` the
//! residual of dof i changes by `Sum_j x_j Sum_p (G_ip B_j(p) + G'_ip . grad B_j(p))`: G is found once a film, from
//! unit changes at the points p of each triangle. Slopes count in the as-printed form alone. A journal that moves by
//! dx_k changes the gap by `dx_k dh/dx_k`, and the residual by the same G times that.

use std::ops::AddAssign;
use std::sync::Arc;

use oilwedge_fem::conservation_law::{ConservationLaw, Response, State};
use oilwedge_fem::integrate::{Nodal, Points, Rule};
use oilwedge_fem::{Dual, Error, integrate};

use super::blocks::Blocks;
use super::grid::{Grid, SplinePart};
use crate::cavitation::{FilmFraction, PointChanges};
use crate::film_law::{AtPoints, FilmLaw};
use crate::film_thickness::{Deflection, FilmContribution};
use crate::journal_state::{COORDINATES, JournalChange};
use crate::{FilmChange, FilmPoint, FilmProblem, FilmSystem, Form, JournalState, SolvedFilm};

/// How the residual of a solved film changes with the coefficients of the deflection, and with the coordinates of the
/// journal.
#[derive(Debug)]
pub struct GapTangent {
    columns: SplineColumns,
    /// What pieces of the boundary add: dof, spline, entry.
    on_boundary: Vec<(usize, usize, f64)>,
    /// What pieces of the boundary add with the coordinates of the journal: dof, entries.
    on_boundary_by_place: Vec<(usize, [f64; COORDINATES])>,
    /// How many splines there are.
    splines: usize,
    /// Growth of the rate of a wall in a stage with its deflection [1/s]; zero in no stage. It is not known in one what
    /// a place of the journal changes.
    per_time: f64,
}

/// Columns of splines, and of coordinates.
#[derive(Debug, Clone, Default)]
struct SplineColumns {
    of_splines: Blocks,
    of_place: Blocks,
}

impl SplineColumns {
    /// Adds, at each of some `positions` [m] of triangle `cell`, what a part of the gap shares out among the first
    /// `shapes` dofs.
    fn add(
        &mut self,
        (problem, grid, part): (&FilmProblem, &Grid, SplinePart),
        (cell, positions): (usize, &[[f64; 2]]),
        shares: &AtPoints<Nodal>,
        shapes: usize,
    ) {
        let moved = by_place(problem, part, cell, positions);
        for (q, (&position, shares)) in positions.iter().zip(shares).enumerate() {
            grid.each_part_at(part, position, |spline, value| {
                self.of_splines.add(spline, value, shares, shapes);
            });
            for (coordinate, gap) in moved.iter().enumerate() {
                self.of_place.add(coordinate, gap[q], shares, shapes);
            }
        }
    }

    /// The columns of a triangle to which all has been added.
    fn ended(self) -> Self {
        Self { of_splines: self.of_splines.ended(), of_place: self.of_place.ended() }
    }
}

impl AddAssign for SplineColumns {
    fn add_assign(&mut self, other: Self) {
        self.of_splines += other.of_splines;
        self.of_place += other.of_place;
    }
}

/// Change of a part of the gap with each coordinate of the journal at some positions.
fn by_place(
    problem: &FilmProblem,
    part: SplinePart,
    cell: usize,
    positions: &[[f64; 2]],
) -> [AtPoints<f64>; COORDINATES] {
    std::array::from_fn(|k| {
        let mut film = AtPoints::<FilmPoint>::default();
        let change = JournalChange::of_coordinate(k);
        for contribution in &problem.film_thickness {
            contribution.vary(&change, cell, positions, &mut film[..positions.len()]);
        }
        film.map(|point| match part {
            SplinePart::Value => point.thickness,
            SplinePart::SlopeAround => point.slope[0],
            SplinePart::SlopeAlong => point.slope[1],
        })
    })
}

/// A gap that grows alike everywhere.
#[derive(Debug, Clone, Copy)]
struct UniformGap(FilmPoint);

impl UniformGap {
    /// A growth of one, in a stage with its rate.
    fn thickness(deflection: &Deflection) -> Self {
        Self(FilmPoint { thickness: 1.0, rate: deflection.per_time(), ..FilmPoint::default() })
    }

    /// A slope of one in this direction.
    fn slope(direction: usize) -> Self {
        let mut unit = FilmPoint::default();
        unit.slope[direction] = 1.0;
        Self(unit)
    }
}

impl FilmContribution for UniformGap {
    fn add(&self, _journal: &JournalState, _cell: usize, _positions: &[[f64; 2]], film: &mut [FilmPoint]) {
        for point in film {
            point.thickness += self.0.thickness;
            point.rate += self.0.rate;
            for (slope, more) in point.slope.iter_mut().zip(self.0.slope) {
                *slope += more;
            }
        }
    }

    fn carried(&self, _parents: &[u32]) -> Arc<dyn FilmContribution> {
        Arc::new(*self)
    }
}

impl GapTangent {
    /// The tangent of a film that was solved under this deflection: its cavity and film fraction stay.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn of(film: &SolvedFilm, deflection: &Deflection) -> Result<Self, Error> {
        let (grid, unit) = (&deflection.wall.grid, UniformGap::thickness(deflection));
        match &film.solution.film_fraction {
            Some(fraction) => Self::conserving(film, fraction, (grid, unit)),
            None => Ok(Self::integrated(film, (grid, unit))),
        }
    }

    /// The tangent of [`Self::of`], found once for each film: problem and system are those that it was solved for.
    ///
    /// # Errors
    /// A system that does not fit in memory.
    pub fn kept(film: &SolvedFilm, deflection: &Deflection) -> Result<Arc<Self>, Error> {
        let kept = film.solution.gap_tangent.get();
        if let Some(kept) = kept.filter(|kept| kept.per_time == deflection.per_time()) {
            return Ok(kept.clone());
        }
        let found = Arc::new(Self::of(film, deflection)?);
        // Another stage than that for which one is kept has its own.
        Ok(match kept {
            Some(_) => found,
            None => film.solution.gap_tangent.get_or_init(|| found).clone(),
        })
    }

    /// Change of the residual at each dof of the space with a deflection of these coefficients [m].
    pub fn times(&self, system: &FilmSystem, coefficients: &[f64]) -> Vec<f64> {
        let mut change = self.columns.of_splines.times(system.space(), coefficients);
        for &(dof, spline, entry) in &self.on_boundary {
            change[dof] += entry * coefficients[spline];
        }
        change
    }

    /// The transposed product: change with the coefficient of each spline of a sum over residuals with these weights of
    /// the dofs: by metre, in the unit of that sum.
    pub fn times_transposed(&self, system: &FilmSystem, weights: &[f64]) -> Vec<f64> {
        let mut change = (self.columns.of_splines).transposed(system.space(), weights, self.splines);
        for &(dof, spline, entry) in &self.on_boundary {
            change[spline] += entry * weights[dof];
        }
        change
    }

    /// First-order change of the residual at each dof, in its unit, with a `change` of the journal [m, rad], the wall
    /// held; none where the journal changes its velocity, or the wall is in a stage.
    pub fn by_journal(&self, system: &FilmSystem, change: &JournalChange) -> Option<Vec<f64>> {
        let place = change.of_place().filter(|_| self.per_time == 0.0)?;
        let mut residual = self.columns.of_place.times(system.space(), &place);
        for (dof, entries) in &self.on_boundary_by_place {
            residual[*dof] += entries.iter().zip(place).map(|(entry, part)| entry * part).sum::<f64>();
        }
        Some(residual)
    }

    /// The tangent of a mass-conserving film.
    fn conserving(
        film: &SolvedFilm,
        fraction: &FilmFraction,
        (grid, unit): (&Grid, UniformGap),
    ) -> Result<Self, Error> {
        let changes = PointChanges::new(film, fraction, FilmChange::Gap(&unit))?;
        let space = film.system.space();
        let columns = integrate(space.mesh(), |t| {
            let (mut columns, at_points) = (SplineColumns::default(), changes.of_triangle(t));
            let place = (t, at_points.positions());
            columns.add((&film.problem, grid, SplinePart::Value), place, &at_points.balances, space.shapes());
            columns.ended()
        });
        let (mut on_boundary, mut on_boundary_by_place) = (Vec::new(), Vec::new());
        for (dof, (cell, position), by_gap) in changes.of_boundary() {
            grid.each_at(position, |spline, value| on_boundary.push((dof, spline, by_gap * value)));
            let moved = by_place(&film.problem, SplinePart::Value, cell, &[position]);
            on_boundary_by_place.push((dof, moved.map(|gap| by_gap * gap[0])));
        }
        Ok(Self { columns, on_boundary, on_boundary_by_place, splines: grid.number(), per_time: unit.0.rate })
    }

    /// The tangent of a film without a film fraction: by the quadrature of its residual.
    fn integrated(film: &SolvedFilm, (grid, unit): (&Grid, UniformGap)) -> Self {
        let space = film.system.space();
        let rule = Rule::for_degree(space.degree());
        let mut units = vec![(SplinePart::Value, unit)];
        if film.problem.form == Form::AsPrinted {
            units.extend([
                (SplinePart::SlopeAround, UniformGap::slope(0)),
                (SplinePart::SlopeAlong, UniformGap::slope(1)),
            ]);
        }
        let columns = integrate(space.mesh(), |t| {
            let mut nodal = Nodal::default();
            for (value, &dof) in nodal.iter_mut().zip(&space.element_dofs(t)[..space.shapes()]) {
                *value = film.solution.unknown[dof];
            }
            let columns: SplineColumns = rule.integrate(space.mesh(), t, |points, columns: &mut SplineColumns| {
                for (part, unit) in &units {
                    let law = FilmLaw::changed(&film.problem, FilmChange::Gap(unit));
                    let shares = residuals(&law, points, &nodal, space.shapes());
                    let place = (points.cell, points.positions);
                    columns.add((&film.problem, grid, *part), place, &shares, space.shapes());
                }
            });
            columns.ended()
        });
        Self {
            columns,
            on_boundary: Vec::new(),
            on_boundary_by_place: Vec::new(),
            splines: grid.number(),
            per_time: unit.0.rate,
        }
    }
}

/// What each point adds to the residuals of a triangle's dofs under a law.
fn residuals(law: &FilmLaw, points: &Points, nodal: &Nodal, shapes: usize) -> AtPoints<Nodal> {
    let number = points.positions.len();
    let (mut states, mut responses) = (AtPoints::<State>::default(), AtPoints::<Response>::default());
    for (q, state) in states.iter_mut().enumerate().take(number) {
        *state = State {
            value: Dual::constant(points.value(q, nodal)),
            gradient: points.gradient(q, nodal).map(Dual::constant),
        };
    }
    law.response(points.cell, points.positions, &states[..number], &mut responses[..number]);
    let mut residuals = AtPoints::<Nodal>::default();
    for (q, residual) in residuals.iter_mut().enumerate().take(number) {
        let (area, Response { flux, source }) = (points.area(q), responses[q]);
        for (i, part) in residual.iter_mut().enumerate().take(shapes) {
            let gradient = points.shape_gradient(q, i);
            *part = area * (source.v * points.shapes(q)[i] - flux[0].v * gradient[0] - flux[1].v * gradient[1]);
        }
    }
    residuals
}
