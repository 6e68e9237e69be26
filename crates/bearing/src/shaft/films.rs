//! The films of all journals of a shaft.

use std::sync::Arc;

use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::{FilmProblem, FilmSystem, Gap};

use super::frame::Shaft;
use super::joined::ShaftBalance;
use crate::coordinates::{Coordinates, Vector};
use crate::duty_cycle::{Duty, DutyCycle};
use crate::orbit::{Drive, Journals, Motion, TiltSupport};

/// Eccentricity at which journals begin.
const FIRST: f64 = 0.3;

/// The film of one journal.
#[derive(Debug, Clone)]
pub struct ShaftFilm<'a> {
    /// Physics of the film.
    pub problem: FilmProblem,
    /// Mesh and supply of the film.
    pub system: &'a Arc<FilmSystem>,
    /// Where it is least on that mesh.
    pub gap: Gap,
    /// Coordinates of the journal: with two of them the film resists no tilt, and the journal stays parallel.
    pub coordinates: Coordinates,
    /// No load, at the speed of the journal.
    turning: DutyCycle,
}

/// A shaft on films.
#[derive(Debug)]
pub struct Films<'a> {
    /// The shaft.
    pub shaft: &'a Shaft,
    /// The films in the order of its journals.
    pub films: Vec<ShaftFilm<'a>>,
    /// How much what holds each shell gives way in each coordinate [m/N].
    pub compliance: Vec<Vector>,
}

impl<'a> ShaftFilm<'a> {
    /// The film of a journal that turns with the speed of its problem.
    pub fn new(problem: &FilmProblem, system: &'a Arc<FilmSystem>, coordinates: Coordinates) -> Self {
        let speed = problem.journal.speed;
        let duty = Duty { force: [0.0; 2], moment: [0.0; 2], speed };
        Self {
            problem: problem.clone(),
            system,
            gap: Gap::of(&problem.clone().with_wall_at_rest(), system),
            coordinates,
            turning: DutyCycle::constant(duty, 2.0 * std::f64::consts::TAU, speed.abs()),
        }
    }

    /// This film on the next coarser mesh.
    fn coarser(&self) -> Option<Self> {
        let coarser = self.system.coarser.as_ref()?;
        let problem = coarser.problem(&self.problem);
        let gap = Gap::of(&problem.clone().with_wall_at_rest(), &coarser.system);
        Some(Self { gap, problem, system: &coarser.system, ..self.clone() })
    }

    /// The equation of motion of the journal, under no load.
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
}

/// How much a shell on a support of this stiffness [N/m, N m/rad], infinite for a rigid one, gives way in each
/// coordinate [m/N].
pub fn compliance_of_shell(coordinates: Coordinates, [stiffness, of_tilt]: [f64; 2]) -> Vector {
    let (offset, tilt) = (1.0 / stiffness, coordinates.arm.powi(2) / of_tilt);
    match coordinates.order {
        2 => [offset, offset, 0.0, 0.0],
        _ => [offset, offset, tilt, tilt],
    }
}

impl<'a> Films<'a> {
    /// The shaft on films of the next coarser meshes, where all have one.
    pub fn coarser(&self) -> Option<Self> {
        let films: Option<Vec<_>> = self.films.iter().map(ShaftFilm::coarser).collect();
        Some(Self { shaft: self.shaft, films: films?, compliance: self.compliance.clone() })
    }
}

impl Films<'_> {
    /// The equations of motion of all journals.
    pub fn motions(&self) -> Vec<Motion<'_>> {
        self.films.iter().map(ShaftFilm::motion).collect()
    }

    /// What drives the shaft under loads on its journals [N] over a crank angle of this period [rad], at a speed
    /// [rad/s].
    pub fn drive<'s>(&'s self, loads: &'s (dyn Fn(f64) -> Vec<Vector> + Sync), [period, speed]: [f64; 2]) -> Drive<'s> {
        Drive { shaft: self.shaft, compliance: &self.compliance, loads, period, speed }
    }

    /// The balance of the shaft, turned by `angle` [rad], under these loads on its journals [N].
    pub fn joined(&self, asked: &[Vector], angle: f64) -> ShaftBalance<'_> {
        ShaftBalance { shaft: self.shaft, compliance: &self.compliance, angle, asked: asked.to_vec() }
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

    /// Least gaps [m] of all journals at these places [m] under these walls.
    pub fn gaps<'w>(&self, at: impl IntoIterator<Item = (Vector, Option<&'w Deflection>)>) -> Vec<f64> {
        Journals { motions: &self.motions(), shaft: None }.gaps(at)
    }

    /// The bearing whose journal is nearest to its shell at these places [m] under these walls, and its least gap over
    /// the clearance [1].
    pub fn thinnest<'w>(&self, at: impl IntoIterator<Item = (Vector, Option<&'w Deflection>)>) -> (usize, f64) {
        Journals { motions: &self.motions(), shaft: None }.thinnest(at)
    }
}
