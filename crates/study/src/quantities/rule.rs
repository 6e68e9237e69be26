//! How the error of a quantity is estimated: rules in the terms of what an [`Estimate`] knows, for any film.

use oilwedge_reynolds::error_bar::Bar;
use oilwedge_reynolds::quantities::load::rim_error;

use super::view::View;
use super::warming::Warming;
use crate::estimate::{Estimate, Scaled};
use crate::film::Film;
use crate::solved::BalanceFacts;

/// A number whose error is estimated.
pub struct Subject<'a> {
    /// The film.
    pub view: &'a View<'a>,
    /// Region of a member of a family, else empty.
    pub region: &'a str,
    /// The number.
    pub value: f64,
    /// The number less that of the other film of a pair, where there is one.
    pub change: f64,
}

impl Subject<'_> {
    /// How it is made of a number that an estimate knows, which is `unit` times it.
    pub fn per(&self, unit: f64) -> Scaled {
        let change = self.change;
        Scaled { unit, change }
    }
}

/// How the error of a quantity is estimated.
#[derive(Clone, Copy)]
pub enum ErrorRule {
    /// The number follows from given numbers: no error.
    Exact,
    /// The number follows from given numbers and from the shape of the rim of a region, which the mesh has roughly
    /// unless it is one hole or has straight sides.
    Rim,
    /// The number follows from the journal's position: no error where that is given.
    Position,
    /// The place of the least film, which follows from the position likewise; between surfaces that are no circles it
    /// is found by values, which leave open this much.
    LeastFilmPlace(fn(&View) -> f64),
    /// Magnitude of the load.
    Load,
    /// A constant times the magnitude of the load.
    PerLoad,
    /// Angle of the load.
    LoadAngle,
    /// Product of the load with a vector that is given; none where there is no such vector.
    Component(fn(&View) -> Option<[f64; 2]>),
    /// Moment towards x (0) or y (1).
    Moment(usize),
    /// Axial position at which the load acts: moment over load.
    LoadPlace,
    /// A rule of its own, in words and as it is computed.
    Of(&'static str, fn(&dyn Estimate, &Subject) -> Option<Bar>),
    /// A number of a cycle, measured with its bar; the rule is given in words.
    OverCycle(&'static str),
    /// The number follows from given numbers and from the temperature of the film: by how much for each kelvin.
    Temperature(fn(&Warming) -> Option<f64>),
    /// The number is a part of the balance of heat: its bar at the temperature of the film, and how it changes for each
    /// kelvin.
    Balance(fn(&Warming) -> Option<f64>, fn(&Warming) -> Option<f64>),
}

impl ErrorRule {
    /// Bar of a number at the position and the temperature of the film; none where it cannot be trusted.
    pub fn bar(&self, estimate: &dyn Estimate, subject: &Subject) -> Option<Bar> {
        match self {
            Self::Exact | Self::Temperature(_) | Self::Balance(..) => Some(Bar::default()),
            Self::Rim => Some(rim(subject)),
            Self::Position if subject.view.base.load().is_none() => Some(Bar::default()),
            Self::LeastFilmPlace(rounding) if subject.view.base.load().is_none() => {
                Some(place(subject.view, *rounding))
            }
            _ if !estimate.is_resolved() => None,
            Self::Position => Some(Bar::default()),
            Self::LeastFilmPlace(rounding) => Some(place(subject.view, *rounding)),
            Self::Load => Some(estimate.load()),
            // Without a force there is no quotient.
            Self::PerLoad if estimate.force() == 0.0 => Some(Bar::default()),
            Self::PerLoad => Some(estimate.load().scaled(subject.value / estimate.force())),
            Self::LoadAngle => Some(direction(estimate)),
            Self::Component(vector) => Some(estimate.product(vector(subject.view)?)),
            Self::Moment(axis) => Some(estimate.moment()?[*axis]),
            Self::LoadPlace => load_place(estimate, subject),
            Self::Of(_, bar) => bar(estimate, subject),
            Self::OverCycle(_) => None,
        }
    }

    /// Bar of what a given load fixes: how far it is from balanced. None of what it does not fix.
    pub fn balanced(&self, balance: &BalanceFacts, subject: &Subject) -> Option<Bar> {
        let algebra = match self {
            Self::Load => balance.unbalanced,
            Self::PerLoad => balance.unbalanced / subject.view.force.max(f64::MIN_POSITIVE) * subject.value.abs(),
            // The force is within a circle around the load.
            Self::LoadAngle if balance.residual < 1.0 => balance.residual.asin().to_degrees(),
            Self::LoadAngle => 180.0,
            Self::Component(vector) => balance.unbalanced * vector(subject.view).map(|[x, y]| x.hypot(y))?,
            Self::Moment(_) => balance.unbalanced_moment?,
            Self::LoadPlace => {
                (balance.unbalanced_moment? + subject.value.abs() * balance.unbalanced) / subject.view.force
            }
            _ => return None,
        };
        Some(Bar { algebra, ..Bar::default() })
    }

    /// True if it is that of force and moment alone, which know of a wall that follows.
    pub fn is_of_load(&self) -> bool {
        matches!(
            self,
            Self::Load | Self::PerLoad | Self::LoadAngle | Self::Component(_) | Self::Moment(_) | Self::LoadPlace
        )
    }

    /// The rule in words.
    pub fn sentence(&self) -> &'static str {
        match self {
            Self::Exact => "exact: it follows from given numbers",
            Self::Rim => {
                "exact for one round hole and for straight sides; else the area between arcs of the rim and the parabolas of the mesh"
            }
            Self::Position => "exact at a given position; under a load that of the position",
            Self::LeastFilmPlace(_) => {
                "exact at a given position between circles, else the rounding of the search; under a load that of the position"
            }
            Self::Load => "dual-weighted, along the load; under a load what is left unbalanced",
            Self::PerLoad => "that of the load, in proportion; under a load what is left unbalanced",
            Self::LoadAngle => {
                "dual-weighted, across the load, over its magnitude; under a load what is left unbalanced"
            }
            Self::Component(_) => {
                "dual-weighted, along and across the load in this direction; under a load what is left unbalanced"
            }
            Self::Moment(_) => "dual-weighted; under a given moment what is left unbalanced",
            Self::LoadPlace => "those of moment and load, over the load; under a given moment what is left unbalanced",
            Self::Of(words, _) | Self::OverCycle(words) => words,
            Self::Temperature(_) => "exact at a given temperature; with `[heat]` that of the temperature",
            Self::Balance(..) => "those of friction and flow, by the balance of heat",
        }
    }
}

/// Bar [m] of the axial position at which the load acts.
fn load_place(estimate: &dyn Estimate, at: &Subject) -> Option<Bar> {
    let [x, y] = estimate.moment()?;
    let (force, along) = (at.view.force, at.view.measured.load.total.force);
    let bar = x.scaled(along[0] / force) + y.scaled(along[1] / force) + estimate.load().scaled(at.value);
    // The direction of the load turns the moment across it into its place.
    let [m_x, m_y] = at.view.measured.load.total.moment;
    let across = (m_y * along[0] - m_x * along[1]) / force;
    let turn = estimate.across()?.scaled(across / force);
    Some((bar + turn).scaled(1.0 / force))
}

/// Bar [N] of the share of a region in the load.
fn rim(subject: &Subject) -> Bar {
    let Film { problem, system, .. } = subject.view.base;
    let mut regions = system.supply.regions().iter();
    let region = regions.find(|region| region.name == subject.region);
    Bar { geometry: region.map_or(0.0, |region| rim_error(problem, system.space().mesh(), region)), ..Bar::default() }
}

/// Bar [deg] of the angle of the load; any direction may be that of a load smaller than its own bar.
pub(super) fn direction(estimate: &dyn Estimate) -> Bar {
    match estimate.across() {
        Some(across) => across.scaled(1f64.to_degrees() / estimate.force()),
        None => Bar::of(180.0),
    }
}

/// The bar of the place of the least film.
fn place(film: &View, rounding: fn(&View) -> f64) -> Bar {
    match film.base.model.scope.is_circular {
        true => Bar::default(),
        false => Bar::of(rounding(film)),
    }
}
