//! # Error bars of the sharp hill, and the film that a number is taken from
//!
//! **Equation.** With J2, J3 a number of the hill in quadratic and in cubic elements, and J3' that with as much more
//! oil as its cavities lose
//! ```text
//! bar of J3 = 2.5 |J3 - J2| + 2 |J3' - J3| + 2e-4 |J3|
//! ```
//! Where the position was sought over cavities found near it, that which J3 changes by over those of the position is
//! added.
//!
//! A hill sees what the finite volumes do not resolve, and they see what its smeared front does to thin streaks and to
//! edges of the film along the flow. A number is taken from the hill where its bar is the narrower one and the number
//! lies inside the bar of the finite volumes. Where it lies outside, one of the two bars is wrong: the number of the
//! finite volumes stands, and its bar reaches to that of the hill.
//!
//! | symbol | code |
//! |---|---|
//! | J3, J3 - J2, J3' - J3 | `cubic`, `by_degree`, `by_oil` |
//!
//! **Source.** The constants: measured on random bearings, `docs/theory/error_estimation_jfo.md`. **Range.** As of
//! [`crate::sharp`]. **Verified by** `cavitation/sharp`.

use super::Bar;
use super::conserving::ConservingError;
use crate::SolvedFilm;
use crate::quantities::load::{Share, load};
use crate::sharp::{HillNumbers, SharpFilm};

/// Weight in the bar of the difference of the two degrees.
const OF_DEGREES: f64 = 2.5;
/// Weight in the bar of the change by the oil that the cavities of a hill lose.
const OF_OIL: f64 = 2.0;
/// Weight in the bar of the number itself.
const OF_NUMBER: f64 = 2e-4;
/// Bars of finite volumes below this part of their numbers leave a hill little to do: its own are a fifth of that at
/// least.
const NARROW: f64 = 1e-3;

/// Numbers of the hill that take the place of those of the finite volumes; none where these stand.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sharpened {
    /// The load, and all that follows from it.
    pub load: Option<Share>,
    /// The greatest pressure [Pa].
    pub greatest: Option<f64>,
}

/// The film that is reported.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ReportedFilm {
    /// The finite volumes: position or temperature are those of their force and heat.
    FiniteVolumes,
    /// The load of the hill: its force balances what the journal bears. Else the narrower bar.
    LoadOfHill,
    /// Each number by the film with the narrower bar.
    Narrower,
}

/// Gives the numbers in `error` of a film with the numbers `film` the bars that they have beside its hill; the numbers
/// that are those of the hill.
pub fn sharpen(
    error: &mut ConservingError,
    film: &HillNumbers,
    sharp: &SharpFilm,
    reported: ReportedFilm,
) -> Sharpened {
    let mut sharpened = Sharpened::default();
    if !error.is_resolved {
        return sharpened;
    }
    let bars = LoadBars::new(error, sharp);
    match bars.verdict(error, &film.load, &sharp.cubic.load) {
        HillVerdict::Better if reported == ReportedFilm::Narrower => sharpened.load = Some(sharp.cubic.load),
        _ if reported == ReportedFilm::LoadOfHill => sharpened.load = Some(sharp.cubic.load),
        HillVerdict::Apart => reach(error, &film.load, &sharp.cubic.load),
        HillVerdict::Better | HillVerdict::Wider => {}
    }
    if sharpened.load.is_some() {
        bars.replace(error);
    }
    let greatest = bar(sharp, |hill| hill.greatest);
    match HillVerdict::of(greatest, error.greatest_pressure, sharp.cubic.greatest - film.greatest) {
        HillVerdict::Better if reported != ReportedFilm::FiniteVolumes => {
            error.greatest_pressure = greatest;
            sharpened.greatest = Some(sharp.cubic.greatest);
        }
        HillVerdict::Apart => error.greatest_pressure = (sharp.cubic.greatest - film.greatest).abs(),
        HillVerdict::Better | HillVerdict::Wider => {}
    }
    sharpened
}

/// What a number of the hill is beside that of the film.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum HillVerdict {
    /// The hill's bar is narrower, and its number lies inside the bar of the film.
    Better,
    /// The hill's bar is narrower, and its number lies outside the bar of the film.
    Apart,
    /// The hill's bar is not narrower.
    Wider,
}

impl HillVerdict {
    /// The verdict on a number with the bar `hill` that differs by `apart` from that of the film, whose bar is `film`.
    /// Where that has no end the film may not exist.
    fn of(hill: f64, film: f64, apart: f64) -> Self {
        match hill < film && film.is_finite() {
            false => Self::Wider,
            true if apart.abs() <= film => Self::Better,
            true => Self::Apart,
        }
    }
}

/// Lets bars of the load of a film reach to that of its hill.
fn reach(error: &mut ConservingError, film: &Share, hill: &Share) {
    let apart = [0, 1].map(|d| (hill.force[d] - film.force[d]).abs());
    let widened = |bar: Bar, to: f64| Bar { discretisation: bar.discretisation + (to - bar.total()).max(0.0), ..bar };
    let [along, across] = along_and_across(film, hill);
    error.load = widened(error.load, along.abs());
    error.across = widened(error.across, across.abs());
    error.force = [0, 1].map(|d| widened(error.force[d], apart[d]));
    error.pressure_integral = widened(error.pressure_integral, (hill.pressure - film.pressure).abs());
}

/// Force of a hill less that of its film [N], along that of the hill and across it.
fn along_and_across(film: &Share, hill: &Share) -> [f64; 2] {
    let ([x, y], force) = (hill.force, length(hill));
    let apart = [0, 1].map(|d| hill.force[d] - film.force[d]);
    [(apart[0] * x + apart[1] * y) / force, (apart[1] * x - apart[0] * y) / force]
}

/// True if a hill may narrow the bars of a film with this `error` by much.
pub fn is_of_use(error: &ConservingError, film: &SolvedFilm) -> bool {
    let force = load(film).magnitude();
    let greatest = film.problem.pressure_at(film.greatest_unknown().value);
    let load = error.load.total().max(error.across.total());
    error.is_resolved && (load > NARROW * force || error.greatest_pressure > NARROW * greatest)
}

/// True if the load of a film with this `error` is taken from its hill.
pub fn takes_load_of_hill(error: &ConservingError, film: &SolvedFilm, sharp: &SharpFilm) -> bool {
    let load = || load(film).total;
    let verdict = || LoadBars::new(error, sharp).verdict(error, &load(), &sharp.cubic.load);
    error.is_resolved && verdict() == HillVerdict::Better
}

/// Bars [N] of the load of a hill: as a whole it is that of one film, and so is the power that follows from it.
struct LoadBars {
    along: Bar,
    across: Bar,
    force: [Bar; 2],
    pressure_integral: Bar,
}

impl LoadBars {
    /// Oil that triangles spread across the flow is in the hill as it is in the film.
    fn new(film: &ConservingError, sharp: &SharpFilm) -> Self {
        let load = sharp.cubic.load;
        let ([x, y], force) = (load.force, length(&load));
        let of_force = |[u, w]: [f64; 2], film: Bar| {
            let differences = differences(sharp, &|hill| u * hill.load.force[0] + w * hill.load.force[1]);
            with_oil(differences + OF_NUMBER * force, film)
        };
        Self {
            along: of_force([x / force, y / force], film.load),
            across: of_force([-y / force, x / force], film.across),
            force: [of_force([1.0, 0.0], film.force[0]), of_force([0.0, 1.0], film.force[1])],
            pressure_integral: with_oil(bar(sharp, |hill| hill.load.pressure), film.pressure_integral),
        }
    }

    /// What the load of a `hill` is beside that of the `film`: as a whole, with its direction.
    fn verdict(&self, error: &ConservingError, film: &Share, hill: &Share) -> HillVerdict {
        let [along, across] = along_and_across(film, hill);
        let bars = [error.load.total(), error.across.total()];
        match self.along.total() + self.across.total() < bars[0] + bars[1] {
            false => HillVerdict::Wider,
            true if along.abs() <= bars[0] && across.abs() <= bars[1] => HillVerdict::Better,
            true => HillVerdict::Apart,
        }
    }

    fn replace(&self, error: &mut ConservingError) {
        [error.load, error.across] = [self.along, self.across];
        error.force = self.force;
        error.pressure_integral = self.pressure_integral;
    }
}

/// The bar of a number of the hill, with what oil that is spread makes in that of the `film`.
fn with_oil(bar: f64, film: Bar) -> Bar {
    Bar { transport: film.transport, ..Bar::of(bar) }
}

fn length(share: &Share) -> f64 {
    share.force[0].hypot(share.force[1])
}

fn bar(sharp: &SharpFilm, number: impl Fn(&HillNumbers) -> f64) -> f64 {
    differences(sharp, &number) + OF_NUMBER * number(&sharp.cubic).abs()
}

fn differences(sharp: &SharpFilm, number: &dyn Fn(&HillNumbers) -> f64) -> f64 {
    OF_DEGREES * number(&sharp.by_degree).abs()
        + OF_OIL * number(&sharp.by_oil).abs()
        + number(&sharp.by_cavities).abs()
}
