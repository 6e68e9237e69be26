//! Films whose balance is found together: that of one journal under its load, or those of all journals of a shaft.
//!
//! What they leave is one residual. Each film, its wall following, answers to its own journal ([`JournalResponse`]);
//! the shaft joins the journals by a stiffness ([`ShaftBalance`]).

use std::borrow::Cow;

use oilwedge_reynolds::{FilmProblem, MixedChange, NoFilm};
use rayon::prelude::*;

use crate::coordinates::{Vector, length, moved, unit};
use crate::coupled::{FilmSolve, Tangents, counted};
use crate::deflection::{Moves, WallResidual, resting};
use crate::search::{Search, Trial};
use crate::shaft::joined::{ShaftBalance, all_moved, magnitude};
use crate::stiffness::Stiffness;
use crate::work::Work;

/// Films whose balance is found together.
pub(crate) struct Coupled<'s, 'a> {
    /// The search of each journal.
    pub(crate) searches: &'s [Search<'a>],
    /// The shaft that joins the journals; `None`: one journal under the load of its search.
    pub(crate) shaft: Option<&'s ShaftBalance<'s>>,
}

/// How a film, its wall following, answers to its journal.
pub(crate) struct JournalResponse {
    /// Change of the forces by each coordinate [N/m].
    pub(crate) stiffness: Stiffness,
    /// Moves of wall and film by each coordinate.
    by_place: Vec<Moves>,
    /// Moves of wall and film where the journal is held.
    closing: Moves,
    /// What the film carries more where the journal is held and its wall moves so [N].
    pub(crate) carried: Vector,
}

/// Moves of a trial, the problem to which they lead, and the coordinates there.
type Led = (FilmProblem, Vector);

impl Coupled<'_, '_> {
    /// Forces that are left of the balance [N].
    pub(crate) fn excess(&self, trials: &[Trial]) -> Vec<Vector> {
        let films = self.searches.iter().zip(trials);
        match self.shaft {
            None => films.map(|(search, trial)| search.excess(trial)).collect(),
            Some(shaft) => {
                let carried: Vec<Vector> =
                    films.clone().map(|(search, trial)| search.coordinates.forces(&trial.carried)).collect();
                let at: Vec<Vector> = films.map(|(search, trial)| search.place(trial)).collect();
                shaft.left(&at, &carried)
            }
        }
    }

    /// Forces that are left of the balance, over the load [1].
    pub(crate) fn residual(&self, trials: &[Trial]) -> f64 {
        magnitude(&self.excess(trials)) / self.searches[0].scale
    }

    /// What trials leave of load and deflections, as parts of them [1].
    pub(crate) fn left(&self, trials: &[Trial]) -> f64 {
        let walls = trials.iter().filter_map(|trial| trial.left.as_ref().map(|left| left.residual));
        self.residual(trials).hypot(greatest(walls)).hypot(self.part_left_over(trials))
    }

    /// Heat that trials leave over, as a part of their friction [1]; zero where temperatures are given.
    pub(crate) fn part_left_over(&self, trials: &[Trial]) -> f64 {
        greatest(self.searches.iter().zip(trials).map(|(search, trial)| search.part_left_over(trial)))
    }

    /// Corrects the rows of the heat by what they missed in the step from trials to others.
    pub(crate) fn correct_rows(&self, before: &[Trial], after: &[Trial]) {
        let left = self.left(before);
        for (search, (before, after)) in self.searches.iter().zip(before.iter().zip(after)) {
            search.correct_row((before, left), after);
        }
    }

    /// What trials leave of the balances of their walls.
    pub(crate) fn left_of_walls<'t>(&self, trials: &'t [Trial]) -> Vec<Cow<'t, WallResidual>> {
        self.searches.iter().zip(trials).map(|(search, trial)| search.left_of_wall(trial)).collect()
    }

    /// The least film over its clearance [1].
    pub(crate) fn least_film(&self, trials: &[Trial]) -> f64 {
        let films = self.searches.iter().zip(trials);
        films
            .map(|(search, trial)| search.least_film(trial) / search.gap.bearing().clearance)
            .fold(f64::INFINITY, f64::min)
    }

    /// The longest way of a journal between trials, over its least film [1].
    pub(crate) fn way(&self, from: &[Trial], to: &[Trial]) -> f64 {
        let journals = self.searches.iter().zip(from.iter().zip(to));
        greatest(journals.map(|(search, (from, to))| {
            length(moved(search.place(to), -1.0, search.place(from))) / search.least_film(from)
        }))
    }

    /// The moves that meet the balance by the tangent of these trials, in which walls and journals rest in pseudo-time
    /// of this rate, over that of the motion; `None` where the tangent is singular.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn moves(
        &self,
        here: &[Trial],
        walls: &[Cow<'_, WallResidual>],
        (accuracy, rate): (f64, f64),
    ) -> Result<Option<Vec<Moves>>, NoFilm> {
        let excess = self.excess(here);
        let Some(shaft) = self.shaft else {
            let (search, trial) = (&self.searches[0], &here[0]);
            let rate = rate * search.reference_rate;
            let film = resting(&trial.film, rate);
            let tangents = search.tangents(trial, &film, &walls[0], (accuracy, rate))?;
            let moves = tangents.solve(excess[0].map(|excess| -excess), Some(&walls[0].wall))?;
            let moves = search.with_warming(trial, &tangents, moves)?;
            search.count(moves.products);
            return Ok(length(moves.place).is_finite().then(|| vec![moves]));
        };
        let respond = |((search, trial), left): ((&Search, &Trial), &Cow<'_, WallResidual>)| {
            let rate = rate * search.reference_rate;
            let film = resting(&trial.film, rate);
            let tangents = search.tangents(trial, &film, left, (accuracy, rate))?;
            let response = JournalResponse::of(&tangents, search.coordinates.order, &left.wall)?;
            search.count(response.closing.products);
            Ok(response)
        };
        let films = self.searches.par_iter().zip(here).zip(walls);
        let responses: Vec<JournalResponse> = films.map(respond).collect::<Result<_, NoFilm>>()?;
        let slopes: Vec<Stiffness> = responses.iter().map(|response| response.stiffness).collect();
        let closing: Vec<Vector> = responses.iter().map(|response| response.carried).collect();
        let left = all_moved(&excess, 1.0, &shaft.by_films(&closing));
        let wanted: Vec<Vector> = left.into_iter().map(|left| left.map(|left| -left)).collect();
        let places = shaft.solve(&slopes, &wanted);
        Ok(places.map(|places| responses.iter().zip(places).map(|(response, place)| response.moves(place)).collect()))
    }

    /// The problems and coordinates to which a part of moves leads. None where a film along the tangent is thinner than
    /// the part `shrink` of what it is here.
    pub(crate) fn led_on(&self, here: &[Trial], moves: &[Moves], part: f64, shrink: f64) -> Option<Vec<Led>> {
        let films = self.searches.iter().zip(here.iter().zip(moves));
        films
            .map(|(search, (trial, moves))| search.led_on(trial, moves, part, shrink * search.least_film(trial)))
            .collect()
    }

    /// The trials to which a part of moves has led.
    ///
    /// # Errors
    /// [`NoFilm`]: there is no film at one of them.
    pub(crate) fn opened(
        &self,
        here: &[Trial],
        led: Vec<Led>,
        (moves, part): (&[Moves], f64),
        closed: f64,
    ) -> Result<Vec<Trial>, NoFilm> {
        let open = |((search, trial), ((bent, at), moves)): ((&Search, &Trial), (Led, &Moves))| {
            let bent = search.warmed(counted(bent, (0, moves.products), f64::INFINITY), part * moves.kelvin);
            match &trial.cubic {
                Some(cubic) => search.open_cubic(&bent, at, (&trial.film, Some(cubic))),
                None => {
                    let start = trial.film.start_after(&MixedChange::sum([(part, &moves.film)]));
                    search.open(&bent, at, FilmSolve::Step(start), closed)
                }
            }
        };
        let films = self.searches.par_iter().zip(here).zip(led.into_par_iter().zip(moves));
        films.map(open).collect()
    }
}

impl Search<'_> {
    /// Counts what moves have cost that took so many products with the tangent.
    fn count(&self, products: usize) {
        let by_temperature = usize::from(self.options.warming.is_some());
        let linear_solves = self.coordinates.order + by_temperature + products;
        self.spend(Work { linear_solves, ..Work::default() });
    }
}

impl JournalResponse {
    /// By the tangents of a film with so many coordinates whose wall is to be bent by `wall` [m] more.
    ///
    /// # Errors
    /// The linear systems could not be solved.
    pub(crate) fn of(tangents: &Tangents, order: usize, wall: &[f64]) -> Result<Self, NoFilm> {
        if let Tangents::Rigid(rigid) = tangents {
            let (stiffness, by_place) = rigid.by_place();
            return Ok(Self { stiffness, by_place, closing: Moves::default(), carried: [0.0; 4] });
        }
        let by_force = (0..order).map(|k| tangents.solve(unit(k), None)).collect::<Result<Vec<Moves>, NoFilm>>()?;
        let free = tangents.solve([0.0; 4], Some(wall))?;
        let compliance = Stiffness::by_columns(order, |k| Ok::<_, NoFilm>(by_force[k].place))?;
        let stiffness = Stiffness::by_columns(order, |k| Ok::<_, NoFilm>(compliance.solve(unit(k))))?;
        let joined = |first: &Moves, forces: Vector| {
            let moves = by_force.iter().zip(forces);
            moves.fold(first.clone(), |sum, (moves, force)| sum.plus(force, moves))
        };
        let none = free.plus(-1.0, &free);
        let by_place = (0..order).map(|k| joined(&none, stiffness.times(unit(k)))).collect();
        let carried = stiffness.times(free.place.map(|part| -part));
        Ok(Self { stiffness, by_place, closing: joined(&free, carried), carried })
    }

    /// Moves of a film whose journal moves by this [m].
    pub(crate) fn moves(&self, place: Vector) -> Moves {
        let moves = self.by_place.iter().zip(place);
        let moves = moves.fold(self.closing.clone(), |sum, (moves, part)| sum.plus(part, moves));
        Moves { place, products: self.closing.products, ..moves }
    }
}

/// The greatest of numbers that are not negative; zero of none.
pub(crate) fn greatest(numbers: impl Iterator<Item = f64>) -> f64 {
    numbers.fold(0.0, f64::max)
}
