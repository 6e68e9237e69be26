//! One implicit stage of all films of a shaft: Newton's method for their balance at `e' = (e - e_0)/gamma`, or at rest.

use super::films::{Films, NoFilmAt, Train, all_moved, magnitude};
use crate::coordinates::Vector;
use crate::orbit::Instant;

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
    /// `1/gamma` of the damping that the tangent has beside that of the motion, where the residual is as large as the load [1/s]; it falls with the residual.
    pub(super) shift: f64,
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
}

/// A stage that is solved.
#[derive(Debug)]
pub(super) struct Staged {
    /// The films.
    pub(super) instants: Vec<Instant>,
    /// Residual over the scale [1].
    pub(super) residual: f64,
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
        Train {
            velocity: velocity.into_iter().map(rate).collect(),
            at,
        }
    }
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
        let solved = |at: Vec<Vector>, near: Option<&[Instant]>, films: &mut usize| {
            *films += self.films.len();
            self.solved(known.time, &known.train(at), near)
        };
        let mut here = solved(start, near, films)?;
        let mut residual = self.residual(&here, &known.asked, known.angle);
        for _ in 1..MOST_FILMS {
            let balance = magnitude(&residual) / accuracy.scale;
            if balance < accuracy.balanced && accuracy.settled.is_none() {
                return Ok(Staged {
                    instants: here,
                    residual: balance,
                });
            }
            let at: Vec<Vector> = here.iter().map(|here| here.at).collect();
            let per_rate = known.per_time + known.shift * balance.min(1.0);
            let tangent = self.tangent(&here, (1.0, per_rate), known.angle)?;
            let wanted: Vec<f64> = self.shaft.gathered(&residual).iter().map(|part| -part).collect();
            let step = tangent
                .factors()
                .map(|factors| self.shaft.spread(&factors.solve(&wanted)));
            let step = step.filter(|step| magnitude(step).is_finite());
            let Some(step) = step else {
                return Err(NoStage::Diverged(balance, at));
            };
            let is_settled = |settled: f64| self.change(&at, &step) < settled;
            if balance < accuracy.balanced && accuracy.settled.is_none_or(is_settled) {
                return Ok(Staged {
                    instants: here,
                    residual: balance,
                });
            }
            let mut part = self.inside(&at, &step, LEAST_SHRINK);
            loop {
                let next = solved(all_moved(&at, part, &step), Some(&here), films)?;
                let left = self.residual(&next, &known.asked, known.angle);
                if magnitude(&left) < magnitude(&residual) {
                    (here, residual) = (next, left);
                    break;
                }
                if balance < NEARLY_BALANCED {
                    return Ok(Staged {
                        instants: here,
                        residual: balance,
                    });
                }
                if part < SHORTEST {
                    return Err(NoStage::Diverged(balance, at));
                }
                part *= 0.5;
            }
        }
        let balance = magnitude(&residual) / accuracy.scale;
        Err(NoStage::Diverged(balance, here.iter().map(|here| here.at).collect()))
    }
}
