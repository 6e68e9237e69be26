//! # Error bars: the error of the load, estimated by the film in cubic elements
//!
//! **Equation.** For a goal J (a component of the load, the integral of the pressure)
//! ```text
//! eta = J(p3) - J(p2) = sum over K of eta_K
//! bar of J(p2) = 1.25 |eta| + 0.4 F + 0.7 C + 0.05 S + G + A
//! bar of J(p3) = 0.3 |eta| (0.4 for the angle) + 0.45 F + 0.7 C + 0.05 S + G + A
//! where there is no cavity and viscosity does not depend on pressure, if that is less:
//! bar of J(p3) = (|eta| + 0.5 S') sqrt(S'/|J|) + 0.7 (B + C) + G + A
//! ```
//! with `S = sum of |eta_K|`, of which F is the part of the triangles at the edge of a cavity, C that of the triangles
//! at re-entrant corners and jumps of the film thickness, B that at other corners, and S' the rest, none of them deep
//! in a cavity; the geometry part `G` of round rims ([`geometry`]); and the algebra part `A = |r . z|` of an equation
//! solved to the residual r, z the dual, no less than three times the root of the sum of squares. F is there because at
//! a free edge errors of either sign cancel by chance and both films have some; C because at a corner both films have a
//! part of the same error; S because where much cancels in eta, what the pieces leave need not.
//!
//! | symbol | unit | code |
//! |---|---|---|
//! | eta_K | unit of J | [`GoalError::shares`] |
//! | G | unit of J | [`GoalError::geometry`] |
//! | A | unit of J | [`GoalError::algebra`], [`GoalError::scatter`] |
//! | W, beta | N, rad | [`FilmError::load`], [`FilmError::across`] |
//!
//! **Source.** Bank and Smith, SIAM J. Numer. Anal. 30 (1993) 921 (two degrees); Becker and Rannacher, Acta Numerica 10
//! (2001) 1 (duals); constants: measured, `docs/theory/error_estimation.md`. **Range.** Pressure films; a
//! mass-conserving film is judged otherwise ([`conserving`]). No bar where `|eta|` exceeds a twentieth of the load: the
//! mesh does not resolve the film.
//! **Verified by** `tests/tests/error_bars`: shares sum to eta, coverage of true errors, a straight rim.

pub mod conserving;
mod drag;
pub mod edge_products;
pub mod following;
pub mod geometry;
pub mod places;
mod shares;
pub mod sharp;

use self::following::FollowingWall;
use crate::SolvedFilm;
use crate::quantities::load::Share;

/// A load of which this part is in question is not resolved.
pub const UNRESOLVED: f64 = 0.05;
/// A load below this part of what its pressures could carry is one of parts that cancel: it is these that are resolved
/// or not.
const CANCELLING: f64 = 0.01;

/// At a re-entrant corner of angle a both films err by a part of the same term: with functions of degree p by
/// `p^(-4 pi/a)` of the energy (Babuska and Suri, SIAM J. Numer. Anal. 24 (1987) 750). So `J(p3)` is left with 0.51 of
/// their difference where the film takes up 270 degrees; a bit more is found, for the triangles that touch the corner
/// do not hold all of it.
const PER_CORNER: f64 = 0.7;

/// Both films book alike where the edge of a cavity crosses an end, so their difference does not show it; the edge may
/// lie in the next triangle, and more be booked wrongly than the triangles that it crosses hold. Measured: up to 1.4
/// times that.
const PER_UNSURE: f64 = 2.0;

/// What the pieces of a difference leave where they cancel.
const PER_SUM: f64 = 0.05;

/// Multiple of the scatter of residuals in the algebra part.
const DEVIATIONS: f64 = 3.0;

/// What the cubic film leaves of a difference `eta` whose shares have magnitudes of this `sum`, where the solution is
/// smooth: the error of the quadratic film decreases like h^4, that of the cubic one like h^6, so that the latter is
/// `c |eta| sqrt(|eta| / size)` for a goal of this `size`. Measured: c = 0.3 to 0.7; where the shares cancel, the sum
/// counts too.
fn smooth_law(eta: f64, sum: f64, size: f64) -> f64 {
    const PER_CANCELLED: f64 = 0.5;
    let eta = eta.abs().min(sum) + PER_CANCELLED * sum;
    eta * (sum / size.max(f64::MIN_POSITIVE)).sqrt()
}

/// Parts of an error bar, in the unit of what they are the bar of.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Bar {
    /// What the elements do not resolve.
    pub discretisation: f64,
    /// The edge of the cavity.
    pub front: f64,
    /// Oil that is carried across the flow.
    pub transport: f64,
    /// Round rims that are not quite round.
    pub geometry: f64,
    /// Nonlinear equations that are not quite solved.
    pub nonlinear: f64,
    /// Linear equations that are not quite solved.
    pub algebra: f64,
    /// The position of a journal under a load that is not quite known.
    pub position: f64,
    /// The deflection of a wall that is not quite known.
    pub wall: f64,
    /// The temperature of a film that is not quite known.
    pub temperature: f64,
    /// Steps in time that are not short enough.
    pub time: f64,
}

impl Bar {
    /// A bar of the discretisation alone.
    pub fn of(discretisation: f64) -> Self {
        Self { discretisation, ..Self::default() }
    }

    /// The parts by the names of their fields.
    pub fn by_name(&self) -> [(&'static str, f64); 10] {
        self.parts().map(|(name, _, part)| (name, part))
    }

    /// Name of each part, in words where it comes from, and the part.
    pub fn parts(&self) -> [(&'static str, &'static str, f64); 10] {
        [
            ("discretisation", "triangles", self.discretisation),
            ("front", "edge of the cavity", self.front),
            ("transport", "oil spread across the flow", self.transport),
            ("geometry", "shape of the liner", self.geometry),
            ("nonlinear", "nonlinear iteration", self.nonlinear),
            ("algebra", "rounding", self.algebra),
            ("position", "position under the load", self.position),
            ("wall", "deflection of the wall", self.wall),
            ("temperature", "temperature of the film", self.temperature),
            ("time", "steps in time", self.time),
        ]
    }

    /// The whole bar.
    pub fn total(&self) -> f64 {
        self.parts().iter().map(|(_, _, part)| part).sum()
    }

    /// The bar of `factor` times as much.
    pub fn scaled(self, factor: f64) -> Self {
        let factor = factor.abs();
        self.each(Self::default(), |part, _| factor * part)
    }

    fn each(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            discretisation: of(self.discretisation, other.discretisation),
            front: of(self.front, other.front),
            transport: of(self.transport, other.transport),
            geometry: of(self.geometry, other.geometry),
            nonlinear: of(self.nonlinear, other.nonlinear),
            algebra: of(self.algebra, other.algebra),
            position: of(self.position, other.position),
            wall: of(self.wall, other.wall),
            temperature: of(self.temperature, other.temperature),
            time: of(self.time, other.time),
        }
    }
}

impl std::ops::Add for Bar {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.each(other, |a, b| a + b)
    }
}

/// The film whose value is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// The value of the quadratic film.
    Quadratic,
    /// The value of the cubic film.
    Cubic,
}

/// What is known of the error of one goal.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct GoalError {
    /// Share of each triangle in `J(p3) - J(p2)`.
    pub shares: Vec<f64>,
    /// Error of the round rims: exact less computed.
    pub geometry: f64,
    /// Error of the equation solved: exact less computed.
    pub algebra: f64,
    /// Root of the sum of the squares of its parts, one for each residual, which have either sign: their sum may be
    /// small by chance.
    pub scatter: f64,
}

impl GoalError {
    /// The error of this goal and `factor` times another one; a goal without shares is none.
    pub(crate) fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.shares.resize(other.shares.len(), 0.0);
        for (share, other) in self.shares.iter_mut().zip(&other.shares) {
            *share += factor * other;
        }
        self.geometry += factor * other.geometry;
        self.algebra += factor * other.algebra;
        self.scatter += factor.abs() * other.scatter;
        self
    }
}

/// What is known of the errors of a film.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmError {
    /// Load `(W_x, W_y)` [N] of the cubic film.
    pub force: [f64; 2],
    /// Moment `(m_x, m_y)` [N m] of the cubic film.
    pub moment: [f64; 2],
    /// Load [N] that its pressures could carry, all on one side.
    pub possible: f64,
    /// Errors of `W_x`, `W_y` and `Int p dA` [N].
    pub goals: [GoalError; 3],
    /// Errors of the moment towards x and y [N m]; none where the journal cannot tilt.
    pub moments: Option<[GoalError; 2]>,
    /// Errors of the power [W] that the turning journal puts in against shear, and against pressure.
    pub drag: [GoalError; 2],
    /// What the rules of integration of the two degrees differ by in the power of shear [W], in each triangle and
    /// without sign.
    pub shear_rules: f64,
    /// Errors of the flow into the film [m3/s] through both ends together, and through each region that gives a
    /// pressure.
    pub flows: Vec<(FlowGoal, GoalError)>,
    /// Triangles in the cavity and at its edge.
    pub front: Vec<bool>,
    /// Triangles in the cavity, away from its edge.
    pub deep: Vec<bool>,
    /// Triangles at corners where the film takes up more than half a turn by far, or its thickness jumps.
    pub corner: Vec<bool>,
    /// Triangles where the edge of the film bends otherwise.
    pub bend: Vec<bool>,
    /// True if the pressure is as smooth as the film thickness away from these: there is no cavity, and viscosity is
    /// constant.
    pub is_smooth: bool,
    /// True if the equation is nonlinear, so that the algebra part is one of the nonlinear iteration.
    pub nonlinear: bool,
}

/// Boundary at which a flow is asked for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FlowGoal {
    /// Both ends together.
    Ends,
    /// The region of this name: an end, an edge of an arc, the line of a film start, or a feed.
    Region(String),
}

/// Judges `film` by the `cubic` film of `system.cubic()`, which carries `carried`, where a wall that gives way is
/// `following`, or held where there is none.
///
/// # Errors
/// The linear systems of the duals could not be solved.
pub fn film_error(
    film: &SolvedFilm,
    cubic: &SolvedFilm,
    carried: &Share,
    following: Option<&FollowingWall>,
) -> Result<FilmError, oilwedge_fem::Error> {
    shares::film_error(film, cubic, carried, following)
}

impl FilmError {
    /// Unit vectors along and across the load, as weights of the goals.
    fn directions(&self) -> [[f64; 3]; 2] {
        let [x, y] = self.force;
        let size = x.hypot(y).max(f64::MIN_POSITIVE);
        [[x / size, y / size, 0.0], [-y / size, x / size, 0.0]]
    }

    /// Bar of a goal, which follows the law of smooth films if it has a `size`. `per_eta` is the part of `|eta|` that
    /// counts for a cubic value.
    fn bar(&self, goal: &GoalError, size: Option<f64>, value: Value, per_eta: f64) -> Bar {
        let (mut eta, mut all, mut front, mut corner, mut bend) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (k, &share) in goal.shares.iter().enumerate() {
            // Deep in the cavity the cubic film is exact, and only the quadratic one is off: it wavers about it.
            if self.deep[k] {
                eta += if value == Value::Quadratic { share } else { 0.0 };
                continue;
            }
            eta += share;
            all += share.abs();
            front += if self.front[k] { share.abs() } else { 0.0 };
            corner += if self.corner[k] { share.abs() } else { 0.0 };
            bend += if self.bend[k] { share.abs() } else { 0.0 };
        }
        let (per_eta, per_front) = match value {
            Value::Quadratic => (1.25, 0.4),
            Value::Cubic => (per_eta, 0.45),
        };
        let plain = per_eta * eta.abs() + PER_SUM * all;
        let size = size.filter(|_| self.is_smooth && value == Value::Cubic);
        let triangles =
            size.map_or(plain, |size| plain.min(smooth_law(eta, all - corner - bend, size) + PER_CORNER * bend));
        let algebra = goal.algebra.abs().max(DEVIATIONS * goal.scatter);
        Bar {
            discretisation: triangles + PER_CORNER * corner,
            front: per_front * front,
            geometry: goal.geometry.abs(),
            nonlinear: if self.nonlinear { algebra } else { 0.0 },
            algebra: if self.nonlinear { 0.0 } else { algebra },
            ..Bar::default()
        }
    }

    /// Magnitude of the load [N].
    fn size(&self) -> f64 {
        self.force[0].hypot(self.force[1])
    }

    /// Bar of the magnitude of the load [N].
    pub fn load(&self, value: Value) -> Bar {
        self.bar(&self.along(0), Some(self.size()), value, 0.3)
    }

    /// Bar of the load across its direction [N]: over the magnitude, that of its angle [rad].
    pub fn across(&self, value: Value) -> Bar {
        self.bar(&self.along(1), Some(self.size()), value, 0.4)
    }

    /// Bar of `Int p dA` [N].
    pub fn pressure_integral(&self, value: Value) -> Bar {
        self.bar(&self.goals[2], Some(self.size()), value, 0.3)
    }

    /// Bars of the moment towards x and y [N m]; none where the journal cannot tilt.
    pub fn moment(&self, value: Value) -> Option<[Bar; 2]> {
        let (moments, [x, y]) = (self.moments.as_ref()?, self.moment);
        let size = Some(x.hypot(y));
        Some(moments.each_ref().map(|goal| self.bar(goal, size, value, 0.4)))
    }

    /// Bar of `shear` times the power of shear and `pressure` times that of pressure [W], which changes by `change`
    /// between the two films: what the rules of integration add to the change is all error, and so is what they differ
    /// by where that cancels in the change.
    pub fn drag(&self, [shear, pressure]: [f64; 2], change: f64, value: Value) -> Bar {
        let goal = GoalError::default().plus(shear, &self.drag[0]).plus(pressure, &self.drag[1]);
        let bar = self.bar(&goal, None, value, 0.4);
        let integration = (change - goal.shares.iter().sum::<f64>()).abs();
        Bar { discretisation: bar.discretisation + integration.max(shear.abs() * self.shear_rules), ..bar }
    }

    /// Bar of a flow [m3/s], which follows the law of smooth films if it has a `size` [m3/s]; `unsure` [m3/s] is booked
    /// by where the edge of a cavity runs within a triangle, or at nodes of two regions.
    pub fn flow(&self, goal: &GoalError, size: Option<f64>, unsure: f64, value: Value) -> Bar {
        let bar = self.bar(goal, size, value, 1.0);
        Bar { front: bar.front + PER_UNSURE * unsure, ..bar }
    }

    /// The goal along the load (0) or across it (1).
    fn along(&self, direction: usize) -> GoalError {
        let [x, y, _] = self.directions()[direction];
        let [along_x, along_y, _] = &self.goals;
        GoalError::default().plus(x, along_x).plus(y, along_y)
    }

    /// `J(p3) - J(p2)` [N] along and across the load.
    pub fn eta(&self) -> [f64; 2] {
        [0, 1].map(|direction| self.along(direction).shares.iter().sum())
    }

    /// False where the mesh does not resolve the film, and no bar can be trusted.
    pub fn is_resolved(&self) -> bool {
        let [along, across] = self.eta();
        let force = self.force[0].hypot(self.force[1]).max(CANCELLING * self.possible);
        along.abs() <= UNRESOLVED * force && across.abs() <= UNRESOLVED * force
    }

    /// Share of each triangle in the error of the load and its angle [N]: what refinement should look at.
    pub fn indicator(&self) -> Vec<f64> {
        let [along, across] = [0, 1].map(|direction| self.along(direction).shares);
        // Deep in the cavity quadratics waver about its pressure, for they are held amid edges only: nothing to refine
        // for.
        let parts = along.iter().zip(&across).zip(&self.deep);
        parts.map(|((a, b), &deep)| if deep { 0.0 } else { a.abs().max(b.abs()) }).collect()
    }
}
