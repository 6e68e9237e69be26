//! The error bars of all quantities of a solved film.
//!
//! Under a load what is uncertain is the position: its bar comes from that of the load through the stiffness, and the bars of all other
//! numbers from the film moved that far along its tangent.

use std::time::Instant;

use oilwedge_reynolds::error_bar::conserving::conserving_error;
use oilwedge_reynolds::error_bar::{Bar, Value, film_error};
use oilwedge_reynolds::{FilmSolution, ReferenceFilm};

use super::Estimate;
use super::coarse::CoarseComparison;
use super::cubic::CubicPair;
use super::position_sensitivity::position_bars;
use crate::analysis::Solved;
use crate::compile::Study;
use crate::measure::{Measured, measure};
use crate::quantities::{Quantity, Subject, View, measured};

/// A film, measured, with the errors of what was measured.
#[derive(Debug)]
pub struct Estimated {
    /// What was measured on the film whose numbers are reported.
    pub measured: Measured,
    /// The quantities, with their errors where bars were asked for and can be trusted.
    pub quantities: Vec<Quantity>,
    /// Share of each triangle in the error of the load [N]; none without bars.
    pub indicator: Option<Vec<f64>>,
    /// True if triangles should be divided where the error comes from, rather than all of them.
    pub is_local: bool,
    /// Part of every bar, over its number, for oil that triangles spread across the flow; zero on rows along it.
    pub spread: f64,
    /// Seconds that measuring and estimating took.
    pub seconds: f64,
}

impl Estimated {
    /// A film without error bars.
    pub fn without_bars(study: &Study, measured: Measured) -> Self {
        Self {
            quantities: numbers(study, &measured),
            measured,
            indicator: None,
            is_local: false,
            spread: 0.0,
            seconds: 0.0,
        }
    }
}

/// Measures a solved film and estimates its errors.
pub fn estimate_errors(study: &Study, solved: &Solved) -> Estimated {
    let clock = Instant::now();
    let mut estimated = match &solved.reference {
        None => Estimated::without_bars(study, measure(&study.problem, &study.system, &solved.film)),
        Some(ReferenceFilm::Cubic(cubic)) => by_cubic(study, solved, cubic),
        Some(ReferenceFilm::Coarse(coarse)) => by_coarse(study, solved, coarse),
    };
    if let Some(heat) = &solved.heat {
        heat.widen(study, &estimated.measured, &mut estimated.quantities);
    }
    Estimated {
        seconds: clock.elapsed().as_secs_f64(),
        ..estimated
    }
}

fn by_cubic(study: &Study, solved: &Solved, cubic: &FilmSolution) -> Estimated {
    let reported = measure(&study.problem, &study.system.cubic().system, cubic);
    let Ok(error) = film_error(&study.problem, &study.system, &solved.film, cubic, &reported.load.total) else {
        return Estimated::without_bars(study, reported);
    };
    let quadratic = measure(&study.problem, &study.system, &solved.film);
    let pair = CubicPair {
        study,
        film: &solved.film,
        cubic,
        error: &error,
        measured: [&quadratic, &reported],
        value: Value::Cubic,
    };
    let load = [error.load(Value::Cubic), error.across(Value::Cubic)].map(|bar| of_few(study, bar));
    Estimated {
        quantities: with_bars(study, solved, &pair, &reported, &numbers(study, &quadratic), load),
        measured: reported,
        is_local: load[0].front > load[0].discretisation,
        spread: 0.0,
        indicator: Some(error.indicator()),
        seconds: 0.0,
    }
}

fn by_coarse(study: &Study, solved: &Solved, coarse: &FilmSolution) -> Estimated {
    let measured = measure(&study.problem, &study.system, &solved.film);
    let plain = Estimated::without_bars(study, measured);
    let Some(error) = conserving_error(&study.problem, &study.system, &solved.film, coarse) else {
        return plain;
    };
    let pair = CoarseComparison {
        study,
        error: &error,
        measured: &plain.measured,
    };
    let load = [error.load, error.across].map(|bar| of_few(study, bar));
    Estimated {
        quantities: with_bars(study, solved, &pair, &plain.measured, &plain.quantities, load),
        spread: error.spread,
        indicator: Some(error.indicator),
        ..plain
    }
}

/// The numbers of the quadratic film of a solved study with their bars: what would be reported without the cubic film.
/// `None` where there is no cubic film, and under a load, where the position is that of the cubic film.
pub fn quadratic_errors(study: &Study, solved: &Solved) -> Option<Vec<Quantity>> {
    let (Some(ReferenceFilm::Cubic(cubic)), None) = (&solved.reference, &solved.balance) else {
        return None;
    };
    let better = measure(&study.problem, &study.system.cubic().system, cubic);
    let error = film_error(&study.problem, &study.system, &solved.film, cubic, &better.load.total).ok()?;
    let quadratic = measure(&study.problem, &study.system, &solved.film);
    let pair = CubicPair {
        study,
        film: &solved.film,
        cubic,
        error: &error,
        measured: [&quadratic, &better],
        value: Value::Quadratic,
    };
    let load = [Bar::default(); 2];
    Some(with_bars(
        study,
        solved,
        &pair,
        &quadratic,
        &numbers(study, &better),
        load,
    ))
}

fn numbers(study: &Study, film: &Measured) -> Vec<Quantity> {
    measured(&View::new(study, &study.problem, film))
}

/// The numbers of a film with their bars. `others` are those of the other film of a pair, or the numbers themselves; `load` bars of the load
/// along and across it.
fn with_bars(
    study: &Study,
    solved: &Solved,
    estimate: &dyn Estimate,
    film: &Measured,
    others: &[Quantity],
    load: [Bar; 2],
) -> Vec<Quantity> {
    let view = View::new(study, &study.problem, film);
    let mut list = measured(&view);
    let balance = solved.balance.as_ref();
    let moved = balance.map(|balance| position_bars(study, &solved.film, balance, load.map(|bar| bar.total()), others));
    for quantity in &mut list {
        let other = others.iter().find(|other| other.name == quantity.name);
        let subject = Subject {
            view: &view,
            region: quantity.region(),
            value: quantity.value,
            change: other.map_or(f64::NAN, |other| quantity.value - other.value),
        };
        let rule = &quantity.row.error;
        let fixed = balance.and_then(|balance| rule.balanced(balance, &subject));
        let bar = fixed.or_else(|| {
            let bar = other.and_then(|_| rule.bar(estimate, &subject))?;
            let position = match &moved {
                Some(moved) => *moved.get(&quantity.name)?,
                None => 0.0,
            };
            Some(Bar {
                position,
                ..of_few(study, bar)
            })
        });
        quantity.set_bar(bar);
    }
    list
}

/// Triangles of a mesh whose bars are twice those of the rules, which were found on meshes of hundreds and more.
const FEW: f64 = 100.0;

/// A bar on the mesh of a study: wider where triangles are few, and two degrees know little of the shape of a cavity.
fn of_few(study: &Study, bar: Bar) -> Bar {
    let triangles = study.system.space().mesh().triangles().len() as f64;
    let wider = 1.0 + FEW / triangles;
    Bar {
        discretisation: wider * bar.discretisation,
        front: wider * bar.front,
        transport: wider * bar.transport,
        ..bar
    }
}
