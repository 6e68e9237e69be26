//! # All films of a shaft at once
//!
//! **Equation.** The journals of the shaft are displaced by `u = e + C W`, with the offsets e of the films and the
//! compliance C of what holds the shells; the slopes likewise, with moments. The film pushes the journal with -W and
//! the shell with W:
//! ```text
//! K (e + C W) + W = F,        W = W(e, e')
//! ```
//! with the stiffness K of the shaft by its journals and the loads F moved to them. Its tangent is
//! `K + (1 + K C) (K_film + C_film/gamma)`, where the films stand in blocks.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | e, and slopes times arms | m | `at` |
//! | W, F, moments over arms | N | `forces`, `asked` |
//! | C | m/N | [`Film::compliance`] |
//! | 1/gamma | 1/s | `per_time` |
//!
//! **Source.** Definition. **Range.** Quasi-static shafts: their mass acts by the loads only. **Verified by**
//! `tests/tests/shaft/statics.rs`.

use std::sync::Arc;

use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap, NoFilm};
use rayon::prelude::*;

use super::frame::Shaft;
use super::matrix::Matrix;
use crate::coordinates::{Coordinates, Vector, length, moved};
use crate::duty_cycle::{Duty, DutyCycle};
use crate::orbit::{Instant, Motion, Moving, TiltSupport};
use crate::stiffness::Stiffness;

/// Eccentricity at which journals begin.
const FIRST: f64 = 0.3;

/// The film of one journal.
#[derive(Debug, Clone)]
pub struct Film<'a> {
    /// Its physics.
    pub problem: FilmProblem,
    /// Its mesh and supply.
    pub system: &'a Arc<FilmSystem>,
    /// Where it is least on that mesh.
    pub gap: Gap,
    /// Its coordinates: with two of them it resists no tilt, and its journal stays parallel to the shell.
    pub coordinates: Coordinates,
    /// How much what holds the shell gives way in each coordinate [m/N].
    pub compliance: Vector,
    /// What a more accurate film in its place carries more [N]: it is that one which is balanced.
    pub more: Vector,
    /// No load, at the speed of the journal.
    turning: DutyCycle,
}

/// A shaft on films.
#[derive(Debug)]
pub struct Films<'a> {
    /// The shaft.
    pub shaft: &'a Shaft,
    /// The films in the order of its journals.
    pub films: Vec<Film<'a>>,
}

/// The journals at one time.
#[derive(Debug, Clone, PartialEq)]
pub struct Train {
    /// Offsets [m].
    pub at: Vec<Vector>,
    /// Their rates [m/s].
    pub velocity: Vec<Vector>,
}

/// A bearing, by its number from 0, that has no film, and why.
#[derive(Debug, thiserror::Error)]
#[error("{reason}")]
pub struct NoFilmAt {
    /// The bearing.
    pub bearing: usize,
    /// Why.
    pub reason: NoFilm,
}

impl<'a> Film<'a> {
    /// The film of a journal that turns with the speed of its problem; `support` [N/m, N m/rad] holds the shell,
    /// infinite for a rigid one.
    pub fn new(
        problem: &FilmProblem,
        system: &'a Arc<FilmSystem>,
        coordinates: Coordinates,
        support: [f64; 2],
    ) -> Self {
        let [stiffness, of_tilt] = support;
        let (offset, tilt) = (1.0 / stiffness, coordinates.arm.powi(2) / of_tilt);
        let speed = problem.journal.speed;
        let duty = Duty { force: [0.0; 2], moment: [0.0; 2], speed };
        let compliance = match coordinates.order {
            2 => [offset, offset, 0.0, 0.0],
            _ => [offset, offset, tilt, tilt],
        };
        Self {
            problem: problem.clone(),
            system,
            gap: Gap::of(problem, system),
            coordinates,
            compliance,
            more: [0.0; 4],
            turning: DutyCycle::constant(duty, 2.0 * std::f64::consts::TAU, speed.abs()),
        }
    }

    /// This film on the next coarser mesh.
    fn coarser(&self) -> Option<Self> {
        let coarser = self.system.coarser.as_ref()?;
        let problem = coarser.problem(&self.problem);
        Some(Self { gap: Gap::of(&problem, &coarser.system), problem, system: &coarser.system, ..self.clone() })
    }

    /// Its equation of motion, under no load.
    pub fn motion(&self) -> Motion<'_> {
        Motion {
            problem: &self.problem,
            system: self.system,
            gap: self.gap.clone(),
            cycle: &self.turning,
            support: (self.coordinates.order == 4).then_some(TiltSupport { stiffness: 0.0, slope: [0.0; 2] }),
            mass: 0.0,
        }
    }

    /// Forces that its journal is balanced by [N].
    pub fn carried(&self, here: &Instant) -> Vector {
        moved(here.excess, 1.0, self.more)
    }

    /// How far its shell gives way [m] to what it carries [N].
    pub fn yields(&self, carried: Vector) -> Vector {
        [0, 1, 2, 3].map(|k| self.compliance[k] * carried[k])
    }

    /// Least gap [m] of its journal at these coordinates.
    pub fn least_gap(&self, at: Vector) -> f64 {
        self.gap.least(&self.coordinates.placed(&self.problem.journal, at))
    }
}

impl<'a> Films<'a> {
    /// The shaft on films of the next coarser meshes, where all have one.
    pub fn coarser(&self) -> Option<Self> {
        let films: Option<Vec<_>> = self.films.iter().map(Film::coarser).collect();
        Some(Self { shaft: self.shaft, films: films? })
    }
}

impl Films<'_> {
    /// The films of journals that move so, each started from one nearby.
    ///
    /// # Errors
    /// [`NoFilmAt`]: a journal has none.
    pub fn solved(&self, time: f64, train: &Train, near: Option<&[Instant]>) -> Result<Vec<Instant>, NoFilmAt> {
        let solve = |(bearing, film): (usize, &Film)| {
            let moving = Moving { time, at: train.at[bearing], velocity: train.velocity[bearing] };
            let near = near.map_or(Neighbour::None, |near| Neighbour::Start(&near[bearing].film));
            film.motion()
                .film(moving, crate::orbit::Held::default(), near)
                .map_err(|reason| NoFilmAt { bearing, reason })
        };
        self.films.par_iter().enumerate().map(solve).collect()
    }

    /// What is left of the balance of the shaft [N], turned by `angle` [rad], under these loads on its journals.
    pub fn residual(&self, instants: &[Instant], asked: &[Vector], angle: f64) -> Vec<Vector> {
        let at: Vec<Vector> = instants.iter().map(|here| here.at).collect();
        let carried: Vec<Vector> = self.films.iter().zip(instants).map(|(film, here)| film.carried(here)).collect();
        let by_shaft = self.shaft.forces(&self.displaced(&at, &carried), angle);
        let forces = carried.iter().zip(by_shaft).zip(asked);
        forces.map(|((carried, shaft), asked)| [0, 1, 2, 3].map(|k| shaft[k] + carried[k] - asked[k])).collect()
    }

    /// How the journals are displaced [m], with these offsets in shells that give way to what the films carry [N].
    pub fn displaced(&self, at: &[Vector], carried: &[Vector]) -> Vec<Vector> {
        let journals = self.films.iter().zip(at.iter().zip(carried));
        journals.map(|(film, (at, carried))| moved(*at, 1.0, film.yields(*carried))).collect()
    }

    /// How the force of each film changes where its offset changes by `per_offset` and the rate of that by `per_rate`
    /// [1/s].
    ///
    /// # Errors
    /// [`NoFilmAt`]: the linear systems of a film could not be solved.
    pub fn slopes(&self, instants: &[Instant], (per_offset, per_rate): (f64, f64)) -> Result<Vec<Stiffness>, NoFilmAt> {
        (self.films.par_iter().zip(instants).enumerate())
            .map(|(bearing, (film, here))| {
                let slope = film.motion().tangent(here, per_offset, per_rate);
                slope.map_err(|reason| NoFilmAt { bearing, reason })
            })
            .collect()
    }

    /// The tangent of that balance, where each offset changes by `per_offset` [1] and the forces of the films by these
    /// `slopes`.
    pub fn tangent(&self, slopes: &[Stiffness], per_offset: f64, angle: f64) -> Matrix {
        let mut tangent = self.shaft.stiffness(angle).scaled(per_offset);
        for (column, &(bearing, coordinate)) in self.shaft.rows().iter().enumerate() {
            let by_film: Vector = [0, 1, 2, 3].map(|row| slopes[bearing][row][coordinate]);
            let mut displaced = vec![[0.0; 4]; self.films.len()];
            displaced[bearing] = self.films[bearing].yields(by_film);
            let mut forces = self.shaft.forces(&displaced, angle);
            forces[bearing] = moved(forces[bearing], 1.0, by_film);
            (0..).zip(self.shaft.gathered(&forces)).for_each(|(row, force)| tangent.add(row, column, force));
        }
        tangent
    }

    /// Where journals under these loads [N] may begin: all moved as much the way that the loads pull, so that the shaft
    /// stays straight and each film has a wedge.
    pub fn first_places(&self, asked: &[Vector]) -> Vec<Vector> {
        let [x, y] = asked.iter().fold([0.0; 2], |[x, y], load| [x + load[0], y + load[1]]);
        let (sin, cos) = y.atan2(x).sin_cos();
        let clearances = self.films.iter().map(|film| film.problem.bearing.clearance);
        let offset = FIRST * clearances.fold(f64::INFINITY, f64::min);
        vec![[offset * cos, offset * sin, 0.0, 0.0]; self.films.len()]
    }

    /// The greatest part of `way` from these places that leaves `shrink` of each least gap.
    pub(super) fn inside(&self, at: &[Vector], way: &[Vector], shrink: f64) -> f64 {
        let mut part = 1.0;
        let leaves = |part: f64| {
            let mut journals = self.films.iter().zip(at.iter().zip(way));
            journals.all(|(film, (at, way))| film.least_gap(moved(*at, part, *way)) >= shrink * film.least_gap(*at))
        };
        while part > 0.0 && !leaves(part) {
            part *= 0.8;
        }
        part
    }

    /// The bearing whose journal is nearest to its shell, and its least gap over the clearance.
    pub fn thinnest(&self, at: &[Vector]) -> (usize, f64) {
        let gaps = self.films.iter().zip(at).map(|(film, at)| film.least_gap(*at) / film.problem.bearing.clearance);
        (0..).zip(gaps).fold((0, f64::INFINITY), |best, it| if it.1 < best.1 { it } else { best })
    }

    /// The greatest change over the least gap of its journal.
    pub(super) fn change(&self, at: &[Vector], way: &[Vector]) -> f64 {
        let journals = self.films.iter().zip(at.iter().zip(way));
        journals.map(|(film, (at, way))| length(*way) / film.least_gap(*at)).fold(0.0, f64::max)
    }
}

/// Magnitude of a list of vectors.
pub(super) fn magnitude(vectors: &[Vector]) -> f64 {
    vectors.iter().map(|&vector| length(vector).powi(2)).sum::<f64>().sqrt()
}

/// `a + part b`.
pub(super) fn all_moved(a: &[Vector], part: f64, b: &[Vector]) -> Vec<Vector> {
    a.iter().zip(b).map(|(a, b)| moved(*a, part, *b)).collect()
}
