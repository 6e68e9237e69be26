//! Derivatives of the quantities of a film by numbers of its scene, by the tangent of the solved film.
//!
//! **Equation.** With the unknowns y, coordinates of the journal and temperature as far as they are found, and what
//! they must balance, `G(y, x) = 0`, excess of forces and surplus of heat, a number x of the scene moves them by
//!
//! ```text
//! dy/dx = -(dG/dy)^-1 dG/dx
//! dQ/dx = (Q(y + s dy/dx, x + s) - Q(y - s dy/dx, x - s))/(2 s)
//! ```
//!
//! Each film is one back-substitution with the factor of the solved one ([`SolvedFilm::chord`]), under a wall that
//! follows; a number costs four of them, and two measurements. With that of the film at hand these show where there is
//! a kink. Offset and slope are kept over the clearance where that is the number, so that a thin film stays what it is.
//! Temperatures across the film are not in the tangent.
//!
//! **Source.** The implicit function theorem. **Verified by** `tests/tests/sensitivity.rs`: closed forms, dimensional
//! analysis, and films solved again.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::Arc;

use oilwedge_bearing::coordinates::moved;
use oilwedge_bearing::stiffness::eliminate;
use oilwedge_bearing::{Coordinates, Neighbourhood};
use oilwedge_reynolds::quantities::load::load;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{Gap, NoFilm, SolvedFilm};
use oilwedge_scene::PositionTable as Placed;

use crate::film::Film;
use crate::measure::measure;
use crate::model::Model;
use crate::position::{FilmState, Position};
use crate::quantities::{CAVITY_SHARE, FRICTION_CAVITY_POWER, Quantity, Row, View, measured};
use crate::solved::Solved;
use crate::thermal::flows::thermal_flows_of;

/// Step of a coordinate of the journal over the least film [1].
const OF_FILM: f64 = 3e-5;
/// Least film over the clearance [1] that steps are made for: where surfaces touch there may be none.
const LEAST_FILM: f64 = 1e-3;
/// Step of the temperature [K].
const KELVIN: f64 = 3e-3;
/// Most unknowns around a film: four coordinates of the journal and its temperature.
const MOST: usize = 5;

/// Numbers that count whole triangles, so that their changes are steps.
const STEPWISE: [&Row; 2] = [&CAVITY_SHARE, &FRICTION_CAVITY_POWER];

/// What is found around a film: coordinates of the journal [m] and the temperature [K]; or what balances them [N, W].
type AroundFilm = [f64; MOST];

/// A number of a film, and how it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slope {
    /// The number, in the unit of its quantity.
    pub value: f64,
    /// The derivative, per SI unit of what changes the number.
    pub derivative: f64,
    /// The derivative above the number less that below it; zero where it is not known.
    pub bend: f64,
}

impl Slope {
    /// The slope of a quantity between two films whose numbers differ by `width`; none where the first one lacks it.
    pub fn between(below: &[Quantity], above: &Quantity, width: f64) -> Option<(Cow<'static, str>, Self)> {
        let below = below.iter().find(|below| below.name == above.name)?;
        let change = above.row.difference(above.value, below.value);
        Some((above.name.clone(), Self { value: below.value + 0.5 * change, derivative: change / width, bend: 0.0 }))
    }
}

/// Why there is no derivative by the tangent.
#[derive(Debug, thiserror::Error)]
pub enum NoTangent {
    /// The film of the neighbouring scene has other unknowns.
    #[error("its number moves the mesh in a way that cannot be followed, or changes what is simulated")]
    Mesh,
    /// A linear system could not be solved, or the film is at a limit.
    #[error(transparent)]
    Film(#[from] NoFilm),
}

/// How far the unknowns around a film and the coefficients of its wall [m] have moved.
#[derive(Debug, Clone, Default)]
struct MovedUnknowns {
    around: AroundFilm,
    wall: Vec<f64>,
}

impl MovedUnknowns {
    /// The difference of two moves over `width`.
    fn slope([low, high]: [&Self; 2], width: f64) -> Self {
        let slope = |(low, high): (&f64, &f64)| (high - low) / width;
        let mut around = AroundFilm::default();
        (around.iter_mut().zip(low.around.iter().zip(&high.around))).for_each(|(slot, pair)| *slot = slope(pair));
        Self { around, wall: low.wall.iter().zip(&high.wall).map(slope).collect() }
    }

    /// Adds a part of another move of the wall.
    fn add_wall(&mut self, part: f64, more: &[f64]) {
        self.wall.iter_mut().zip(more).for_each(|(d, more)| *d += part * more);
    }

    fn times(&self, step: f64) -> Self {
        Self { around: self.around.map(|x| step * x), wall: self.wall.iter().map(|d| step * d).collect() }
    }
}

/// The tangent of a solved film with all that is balanced around it.
pub struct FilmTangent<'a> {
    solved: &'a Solved,
    neighbourhood: Neighbourhood<'a>,
    coordinates: Coordinates,
    /// Which of [`AroundFilm`] are unknown.
    unknown: Vec<usize>,
    /// `dG/dy` of each of them, and how the wall follows it.
    columns: Vec<MovedUnknowns>,
    /// The quantities of the film, measured as those beside it.
    own: Vec<Quantity>,
}

impl<'a> FilmTangent<'a> {
    /// The tangent of a film; `None` where its temperatures are found across it.
    ///
    /// # Errors
    /// [`NoFilm`]: a linear system could not be solved.
    pub fn of(solved: &'a Solved) -> Result<Option<Self>, NoTangent> {
        let film = &solved.film;
        if film.problem.viscosity_across.is_some() {
            return Ok(None);
        }
        let free = solved.balance.filter(|_| film.load().is_some()).map(|balance| balance.coordinates);
        let coordinates = free.unwrap_or(Coordinates { order: 0, arm: 0.5 * film.problem.bearing.length });
        let temperature = film.model.sockets.thermal.map(|_| MOST - 1);
        let mut tangent = Self {
            solved,
            neighbourhood: Neighbourhood::of(&solved.primary)
                .map_err(oilwedge_fem::newton::NewtonFailure::from)
                .map_err(NoFilm::from)?,
            coordinates,
            unknown: (0..coordinates.order).chain(temperature).collect(),
            columns: Vec::new(),
            own: Vec::new(),
        };
        tangent.own = tangent.quantities(film, &MovedUnknowns::default())?;
        let thinnest = Gap::of(&film.problem, &film.system).thinnest_film(&film.problem, &film.system).thickness;
        let shift = OF_FILM * thinnest.max(LEAST_FILM * film.problem.bearing.clearance);
        for &k in &tangent.unknown {
            let step = if k == MOST - 1 { KELVIN } else { shift };
            let mut around = AroundFilm::default();
            around[k] = step;
            let [low, high] = [-1.0, 1.0].map(|sign| tangent.left(film, around.map(|x| sign * x)));
            tangent.columns.push(MovedUnknowns::slope([&low?, &high?], 2.0 * step));
        }
        Ok(Some(tangent))
    }

    /// The derivatives of all quantities but those that change stepwise, by name, by a number of the scene that makes
    /// these two models where it is so much more than that of the film.
    ///
    /// # Errors
    /// [`NoTangent`]: the mesh cannot move with that number, or a linear system could not be solved.
    pub fn derivatives(
        &self,
        [low, high]: [(&Arc<Model>, f64); 2],
    ) -> Result<HashMap<Cow<'static, str>, Slope>, NoTangent> {
        let width = high.1 - low.1;
        let [below, above] = [low, high].map(|(model, _)| self.placed(&self.solved.film, model, AroundFilm::default()));
        let (film_below, film_above) = (below?, above?);
        let [below, above] = [&film_below, &film_above].map(|film| self.left(film, AroundFilm::default()));
        let followed = self.followed(MovedUnknowns::slope([&below?, &above?], width));
        let ends = [(&film_below, low.1), (&film_above, high.1)];
        let [below, above] = ends.map(|(film, more)| self.quantities(film, &followed.times(more)));
        let (below, above) = (below?, above?);
        let smooth = above.iter().filter(|quantity| !STEPWISE.contains(&quantity.row));
        let slope = |above: &Quantity| {
            let (name, slope) = Slope::between(&below, above, width)?;
            Some((name, Slope { bend: self.bend(&below, above, [low.1, high.1]).unwrap_or(0.0), ..slope }))
        };
        Ok(smooth.filter_map(slope).collect())
    }

    /// The derivative of a quantity from its own number to that `above`, less that from the one below; `None` at an end
    /// of a range.
    fn bend(&self, below: &[Quantity], above: &Quantity, [less, more]: [f64; 2]) -> Option<f64> {
        let named = |all: &[Quantity]| all.iter().find(|it| it.name == above.name).map(|it| it.value);
        let (low, middle) = (named(below)?, named(&self.own)?);
        let change = |high: f64, low: f64| above.row.difference(high, low);
        (less < 0.0 && more > 0.0).then(|| change(above.value, middle) / more - change(middle, low) / -less)
    }

    /// How the unknowns follow a number that upsets their balance so, and how the wall follows both.
    fn followed(&self, by_number: MovedUnknowns) -> MovedUnknowns {
        // What is given stays.
        let mut rows = [0, 1, 2, 3, 4].map(|row| [0, 1, 2, 3, 4].map(|k| if k == row { 1.0 } else { 0.0 }));
        let mut wanted = AroundFilm::default();
        for &row in &self.unknown {
            wanted[row] = -by_number.around[row];
            self.unknown.iter().zip(&self.columns).for_each(|(&k, column)| rows[row][k] = column.around[row]);
        }
        let mut followed = MovedUnknowns { around: eliminate(rows, wanted), wall: by_number.wall };
        for (&k, column) in self.unknown.iter().zip(&self.columns) {
            followed.add_wall(followed.around[k], &column.wall);
        }
        followed
    }

    /// What a film on the mesh of `on` leaves of the balances where the unknowns have moved and the wall has followed,
    /// and how it has.
    fn left(&self, on: &Film, around: AroundFilm) -> Result<MovedUnknowns, NoTangent> {
        let mut at = MovedUnknowns { around, wall: Vec::new() };
        let (mut film, mut solved) = self.film(on, &at)?;
        at.wall = self.neighbourhood.followed(&solved)?;
        if !at.wall.is_empty() {
            (film, solved) = self.film(on, &at)?;
        }
        let carried = load(&solved).total.resultant();
        let excess =
            film.load().map_or([0.0; 4], |load| load.excess(&self.coordinates, &film.problem.journal, &carried));
        let surplus = || {
            let (thermal, temperature) = (film.model.sockets.thermal?, film.oil.temperature?);
            Some(thermal.balance.surplus(temperature, &thermal_flows_of(&thermal, &solved)))
        };
        let [x, y, z_x, z_y] = excess;
        Ok(MovedUnknowns { around: [x, y, z_x, z_y, surplus().unwrap_or(0.0)], wall: at.wall })
    }

    /// The film on the mesh of `on` where unknowns and wall have moved from those of the solved film.
    fn film(&self, on: &Film, at: &MovedUnknowns) -> Result<(Film, SolvedFilm), NoTangent> {
        let mut film = self.placed(on, &on.model, at.around)?;
        let solved = self.neighbourhood.film(film.problem.clone(), &film.system, &at.wall)?.ok_or(NoTangent::Mesh)?;
        film.problem = solved.problem.clone();
        Ok((film, solved))
    }

    /// The film of a model on the mesh of `on`, or on that as it moves with the model, where the unknowns have moved.
    fn placed(&self, on: &Film, model: &Arc<Model>, around: AroundFilm) -> Result<Film, NoTangent> {
        let base = &self.solved.primary.problem;
        let [x, y, z_x, z_y, kelvin] = around;
        let wider = model.mesh.bearing.clearance / base.bearing.clearance;
        let place = moved([x, y, z_x, z_y], wider, self.coordinates.at(&base.journal));
        let position = match model.placed {
            Placed::Load { .. } => model.position_at(&self.coordinates, place),
            Placed::Given { .. } | Placed::Cycle => Position::start(model),
        };
        let found = self.solved.film.oil.temperature.filter(|_| model.sockets.thermal.is_some());
        let oil = model.oil_at(found.map(|temperature| temperature + kelvin));
        on.beside(model, &FilmState { position, oil }).ok_or(NoTangent::Mesh)
    }

    /// The quantities of such a film.
    fn quantities(&self, on: &Film, at: &MovedUnknowns) -> Result<Vec<Quantity>, NoTangent> {
        let (film, solved) = self.film(on, at)?;
        let mut numbers = measure(&solved);
        if film.model.sockets.dynamics.is_some() {
            // Small motions have the tangent of their own film.
            let own = film.problem.solve_from(&film.system, Neighbour::Start(&self.solved.primary))?;
            numbers = numbers.with_dynamics(&film, &own, None);
        }
        Ok(measured(&View::new(&film, &film.problem, &numbers)))
    }
}
