//! The characteristics of a film: what it carries for each motion of the journal by itself, with the cavity of that
//! motion.
//!
//! ```text
//! div(H^3 grad P) = 6 u H_phi - 12 (s cos + g_x z cos + g_y z sin),   H = 1 - eps cos - z (gamma_x cos + gamma_y sin)
//! S = Int P {cos, sin, z cos, z sin} dphi dz,   W = S mu R^2/psi^2 rate,   m = S mu R^3/psi^2 rate
//! ```
//! with phi from the line of centres, z in radii from mid-length, gamma = g R/c, psi = c/R, and one unit rate at a
//! time: rotation u, squeeze s = eps', and the rates g_x, g_y of the tilt along the line of centres and across it. A
//! journal that turns at omega while its line of centres turns at beta' makes the film of one that turns at
//! `u = omega - 2 beta'` about a line of centres that rests. Sixteen numbers. Where the cavity bears no tension, the
//! pressures of the parts together are nowhere below that of the film that has all motions at once: their sum is too
//! strong.
//!
//! **Source.** Zharov, dissertation (1996): the notation, the superposition, and the form of [`mod@fit`].
//! `docs/theory/characteristics.md`.

mod check;
pub mod fit;
mod minimax;
mod motion;
mod report;
mod symmetry;

pub use check::check;
pub use fit::{Fit, fit};
pub use report::{
    CHARACTERISTICS_FORMAT, Characteristics, ForceAndMoment, JournalFacts, MotionPart, NumberWithBar, Units,
};

use oilwedge_scene::{PositionTable, Scene, Target, Tolerance};
use oilwedge_study::checks::targets;
use oilwedge_study::quantities::{
    ECCENTRICITY, LOAD, LOAD_X, LOAD_Y, MIN_FILM_ANGLE, MOMENT_X, MOMENT_Y, Row, TILT_X, TILT_Y,
};
use oilwedge_study::result::RunResult;
use oilwedge_study::{CompileError, RunOptions, run};

use check::has_pockets;
use motion::{JournalMotion, PARTS, PartMotion};
use symmetry::{Symmetry, zeros};

/// Characteristics of the film of `scene`, at its position or at that under its load, by runs with these options. Where
/// a film is not found the report has the reason.
///
/// # Errors
/// The mesh is unreadable, defective, or not that of the scene.
pub fn characteristics(scene: &Scene, options: &RunOptions) -> Result<Characteristics, CompileError> {
    let mut report = Characteristics::of(scene);
    let placed = match scene.journal.load() {
        None => scene.clone(),
        Some(_) => {
            let found = run(scene, options)?.result;
            report.note("position", &found);
            match at_position(scene, &found) {
                Some(placed) => placed,
                None => return Ok(report),
            }
        }
    };
    let films = SharedFilms::of(&placed, options);
    (report.journal, report.units) = (Some(JournalFacts::of(&placed, &films.motion)), Some(films.units));
    for part in PARTS {
        let part = films.part(part, &mut report)?;
        report.parts.push(part);
    }
    report.sum = ForceAndMoment::sum(report.parts.iter().map(|part| part.share));
    report.film = films.whole(&mut report)?;
    Ok(report)
}

/// The scene with the journal where a run found it; none where it found no place.
fn at_position(scene: &Scene, found: &RunResult) -> Option<Scene> {
    let value = |row| found.quantity(row).map(|it| it.value);
    let tilt = value(&TILT_X).zip(value(&TILT_Y)).map(|(x, y)| [x, y]);
    let mut placed = scene.clone();
    placed.journal.position = PositionTable::Given {
        eccentricity: value(&ECCENTRICITY)?,
        min_film_angle: value(&MIN_FILM_ANGLE)?.to_radians(),
    };
    placed.journal.tilt = tilt.or(scene.journal.tilt);
    (placed.load_at, placed.load_moment, placed.support) = (None, None, None);
    Some(placed)
}

/// What the films of all parts have in common.
struct SharedFilms<'a> {
    placed: &'a Scene,
    options: &'a RunOptions,
    motion: JournalMotion,
    symmetry: Symmetry,
    units: Units,
}

impl<'a> SharedFilms<'a> {
    /// The films of a scene with a given position.
    fn of(placed: &'a Scene, options: &'a RunOptions) -> Self {
        let motion = JournalMotion::of(placed);
        Self { placed, options, symmetry: Symmetry::of(placed, &motion), units: Units::of(placed), motion }
    }

    /// One part by itself.
    fn part(&self, part: PartMotion, report: &mut Characteristics) -> Result<MotionPart, CompileError> {
        let (rate, used) = (self.motion.rates[part.index()], self.motion.used(part));
        let carried = match self.is_still(part) {
            true => Some(ForceAndMoment::ZERO),
            false => {
                let result = run(&self.scene_of(part, used), self.options)?.result;
                report.note(part.name(), &result);
                self.carried(&result, &[part])
            }
        };
        let times = |factors: [f64; 2]| carried.map(|it| it.scaled(factors));
        Ok(MotionPart {
            part: part.name(),
            rate_symbol: part.symbol(),
            rate,
            characteristics: times([self.units.force, self.units.moment].map(|unit| 1.0 / (unit * used.abs()))),
            share: times([(rate / used).abs(); 2]),
        })
    }

    /// The film with all motions.
    fn whole(&self, report: &mut Characteristics) -> Result<Option<ForceAndMoment>, CompileError> {
        let is_moving = |part: &PartMotion| self.motion.rates[part.index()] != 0.0;
        let moving: Vec<PartMotion> = PARTS.into_iter().filter(is_moving).collect();
        if moving.iter().all(|part| self.is_still(*part)) {
            return Ok(Some(ForceAndMoment::ZERO));
        }
        let mut scene = self.placed.clone();
        scene.journal.tilt.get_or_insert_default();
        let result = run(&scene, self.options)?.result;
        report.note("film", &result);
        report.warnings.clone_from(&result.tail.warnings);
        Ok(self.carried(&result, &moving))
    }

    /// True of the rotation of a journal without offset and tilt in a liner of one depth: it makes no pressure.
    fn is_still(&self, part: PartMotion) -> bool {
        part == PartMotion::Rotation && self.motion.is_concentric() && !has_pockets(self.placed)
    }

    /// The scene with one motion, at this rate [1/s], and with its tolerance on the number that the motion does work
    /// on.
    fn scene_of(&self, part: PartMotion, rate: f64) -> Scene {
        let mut scene = self.placed.clone();
        part.alone(&mut scene, &self.motion, rate);
        if let Some(targets) = targets(self.placed) {
            let ratios = targets.required.iter().map(|target| target.relative);
            scene.tolerance = Some(Tolerance::ByName(vec![Target {
                quantity: self.worked_on(part).name.to_owned(),
                relative: ratios.fold(f64::INFINITY, f64::min),
            }]));
        }
        scene
    }

    /// The number that a motion does work on, and which is therefore not zero; of a tilt the greater of its two parts.
    fn worked_on(&self, part: PartMotion) -> &'static Row {
        let [x, y] = match part {
            PartMotion::TiltAlong => self.motion.along,
            PartMotion::TiltAcross => self.motion.across(),
            _ => return &LOAD,
        };
        if x.abs() >= y.abs() { &MOMENT_X } else { &MOMENT_Y }
    }

    /// Force [N] and moment [N m] of a run with these motions, along and across the line of centres; none where there
    /// is no film.
    fn carried(&self, result: &RunResult, motions: &[PartMotion]) -> Option<ForceAndMoment> {
        let pair = |rows: [&Row; 2]| {
            let [x, y] = rows.map(|row| result.quantity(row));
            let (x, y) = x.zip(y)?;
            Some([self.motion.along, self.motion.across()].map(|[by_x, by_y]| NumberWithBar {
                value: by_x * x.value + by_y * y.value,
                error: x.error().zip(y.error()).map(|(x, y)| by_x.abs() * x + by_y.abs() * y),
                zero_by_symmetry: false,
            }))
        };
        let carried = ForceAndMoment::new(pair([&LOAD_X, &LOAD_Y])?, pair([&MOMENT_X, &MOMENT_Y])?);
        Some(carried.marked(zeros(&self.symmetry, motions)))
    }
}
