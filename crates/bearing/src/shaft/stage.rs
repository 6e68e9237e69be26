//! One implicit stage of all films of a shaft: Newton's method for their balance at `e' = (e - e_0)/gamma`, or at rest.

use super::films::{Films, NoFilmAt, Train, all_moved, magnitude};
use crate::coordinates::{Vector, moved};
use crate::orbit::Instant;
use crate::stiffness::Stiffness;

/// Most films of one journal in a stage.
const MOST_FILMS: usize = 30;
/// No iteration leaves less than this part of a least gap.
const LEAST_SHRINK: f64 = 0.4;
/// Shortest part of an iteration that is tried.
const SHORTEST: f64 = 0.01;
/// A stage is solved, too, below this part of the load where no shorter change brings the residual down.
const NEARLY_BALANCED: f64 = 1e-8;

/// What is known of a stage before it is solved.
#[derive(Debug, Clone)]
pub(super) struct Known {
    /// Its time [s].
    pub(super) time: f64,
    /// Angle by which the shaft is turned [rad].
    pub(super) angle: f64,
    /// `1/gamma` [1/s]; zero: the journals are at rest.
    pub(super) per_time: f64,
    /// `e_0` [m].
    pub(super) offset: Vec<Vector>,
    /// Loads on the journals [N].
    pub(super) asked: Vec<Vector>,
    /// `1/gamma` of the damping that the tangent has beside that of the motion, where the residual is as large as the
    /// load [1/s]; it falls with the residual.
    pub(super) shift: f64,
    /// How the forces of the films change with the offsets nearby, and with the rates that go with them; `None`: that
    /// is not known.
    pub(super) slopes: Option<Vec<Stiffness>>,
}

/// When a stage is solved.
#[derive(Debug, Clone, Copy)]
pub(super) struct Accuracy {
    /// Residual over `scale` [1].
    pub(super) balanced: f64,
    /// Next change over the least gap [1]; `None`: the residual decides alone.
    pub(super) settled: Option<f64>,
    /// A force [N].
    pub(super) scale: f64,
    /// The tangent is corrected by what it missed, not made anew, where it has reduced the residual to less than this
    /// part [1]; zero: it is made anew always.
    pub(super) steep: f64,
}

/// A stage that is solved.
#[derive(Debug)]
pub(super) struct Staged {
    /// The films.
    pub(super) instants: Vec<Instant>,
    /// Residual over the scale [1].
    pub(super) residual: f64,
    /// How the forces of the films change, as [`Known::slopes`]; `None`: that is not known.
    pub(super) slopes: Option<Vec<Stiffness>>,
}

/// Why a stage has no solution.
#[derive(Debug)]
pub(super) enum NoStage {
    /// A journal has no film.
    Film(NoFilmAt),
    /// The iteration does not converge; the residual over the scale, and where it has got to.
    Diverged(f64, Vec<Vector>),
}

impl From<NoFilmAt> for NoStage {
    fn from(reason: NoFilmAt) -> Self {
        Self::Film(reason)
    }
}

impl Known {
    fn train(&self, at: Vec<Vector>) -> Train {
        let velocity = all_moved(&at, -1.0, &self.offset);
        let rate = |way: Vector| way.map(|part| part * self.per_time);
        Train { velocity: velocity.into_iter().map(rate).collect(), at }
    }
}

/// Where the iteration is.
struct Iterate {
    instants: Vec<Instant>,
    residual: Vec<Vector>,
    /// What the tangent is made of; `None`: it is made anew.
    slopes: Option<Vec<Stiffness>>,
}

impl Films<'_> {
    /// Solves a stage from a `start`; `films` counts those solved.
    pub(super) fn stage(
        &self,
        known: &Known,
        start: Vec<Vector>,
        near: Option<&[Instant]>,
        accuracy: Accuracy,
        films: &mut usize,
    ) -> Result<Staged, NoStage> {
        let mut here = self.iterate(known, start, near, films)?;
        here.slopes = known.slopes.clone();
        for _ in 1..MOST_FILMS {
            let balance = magnitude(&here.residual) / accuracy.scale;
            if balance < accuracy.balanced && accuracy.settled.is_none() {
                return Ok(here.staged(balance));
            }
            let at = here.places();
            let is_exact = here.slopes.is_none();
            let slopes = match here.slopes.take() {
                Some(slopes) => slopes,
                None => self.slopes(&here.instants, (1.0, known.per_time + known.shift * balance.min(1.0)))?,
            };
            let Some(step) = self.newton_step(&slopes, &here.residual, known.angle) else {
                return Err(NoStage::Diverged(balance, at));
            };
            let is_settled = |settled: f64| self.change(&at, &step) < settled;
            if balance < accuracy.balanced && accuracy.settled.is_none_or(is_settled) {
                return Ok(here.staged(balance));
            }
            // The tangent of another place is not followed slowly: that of this one is made instead.
            let shortest = match is_exact && balance >= NEARLY_BALANCED {
                true => SHORTEST,
                false => f64::INFINITY,
            };
            match self.nearer(known, &here, &step, shortest, films)? {
                Some(mut next) => {
                    let is_steep = magnitude(&next.residual) < accuracy.steep * magnitude(&here.residual);
                    next.slopes = is_steep.then(|| corrected(slopes, &here.instants, &next.instants));
                    here = next;
                }
                None if balance < NEARLY_BALANCED => return Ok(here.staged(balance)),
                None if is_exact => return Err(NoStage::Diverged(balance, at)),
                None => {}
            }
        }
        let balance = magnitude(&here.residual) / accuracy.scale;
        Err(NoStage::Diverged(balance, here.places()))
    }

    /// The films of journals at these places, and what they leave of the balance.
    fn iterate(
        &self,
        known: &Known,
        at: Vec<Vector>,
        near: Option<&[Instant]>,
        films: &mut usize,
    ) -> Result<Iterate, NoFilmAt> {
        *films += self.films.len();
        let instants = self.solved(known.time, &known.train(at), near)?;
        Ok(Iterate { residual: self.residual(&instants, &known.asked, known.angle), instants, slopes: None })
    }

    /// The change of all places by which the balance would be met; `None` where the tangent is singular.
    pub(super) fn newton_step(&self, slopes: &[Stiffness], residual: &[Vector], angle: f64) -> Option<Vec<Vector>> {
        let wanted: Vec<f64> = self.shaft.gathered(residual).iter().map(|part| -part).collect();
        let factors = self.tangent(slopes, 1.0, angle).factors()?;
        let step = self.shaft.spread(&factors.solve(&wanted));
        magnitude(&step).is_finite().then_some(step)
    }

    /// A place on the way of a step that leaves less of the balance: its end, or half of the way and so on, down to the
    /// `shortest` part; `None` where there is none.
    fn nearer(
        &self,
        known: &Known,
        here: &Iterate,
        step: &[Vector],
        shortest: f64,
        films: &mut usize,
    ) -> Result<Option<Iterate>, NoFilmAt> {
        let at = here.places();
        let mut part = self.inside(&at, step, LEAST_SHRINK);
        loop {
            let next = self.iterate(known, all_moved(&at, part, step), Some(&here.instants), films)?;
            if magnitude(&next.residual) < magnitude(&here.residual) {
                return Ok(Some(next));
            }
            if part < shortest {
                return Ok(None);
            }
            part *= 0.5;
        }
    }
}

impl Iterate {
    fn places(&self) -> Vec<Vector> {
        self.instants.iter().map(|here| here.at).collect()
    }

    fn staged(self, residual: f64) -> Staged {
        Staged { instants: self.instants, residual, slopes: self.slopes }
    }
}

/// The slopes of the films, each corrected by what it missed of the way from one place to the next (Broyden, Math.
/// Comp. 19 (1965) 577).
fn corrected(slopes: Vec<Stiffness>, from: &[Instant], to: &[Instant]) -> Vec<Stiffness> {
    let ways = from.iter().zip(to);
    (slopes.into_iter().zip(ways))
        .map(|(slope, (from, to))| {
            let made = moved(to.at, -1.0, from.at);
            let missed = moved(moved(to.excess, -1.0, from.excess), -1.0, slope.times(made));
            slope.corrected(made, missed)
        })
        .collect()
}
