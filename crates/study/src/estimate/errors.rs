//! The error bars of all quantities of a solved film.
//!
//! Under a load what is uncertain is the position: its bar comes from that of the load through the stiffness, and the
//! bars of all other numbers from the film moved that far along its tangent.

use std::time::Instant;

use oilwedge_bearing::deflection::following_wall;
use oilwedge_bearing::dynamics::edge_parts;
use oilwedge_bearing::{Coefficients, Dynamics, Vector};
use oilwedge_reynolds::error_bar::conserving::{ConservingError, ErrorDirection};
use oilwedge_reynolds::error_bar::sharp::{ReportedFilm, sharpen};
use oilwedge_reynolds::error_bar::{Bar, Value, film_error};
use oilwedge_reynolds::sharp::SharpFilm;
use oilwedge_reynolds::{ReferenceFilm, SolvedFilm};

use super::Estimate;
use super::coarse::CoarseComparison;
use super::cubic::{CubicPair, LoadErrors, SharedBars};
use super::linked::link;
use super::position_sensitivity::position_bars;
use super::wall::wall_bars;
use crate::film::Film;
use crate::measure::{Measured, measure};
use crate::quantities::{LOAD, PRESSURE_MAX, Quantity, Subject, View, measured};
use crate::solved::{BalanceFacts, Solved};
use oilwedge_reynolds::quantities::cavity::hidden_share;

/// A film, measured, with the errors of what was measured.
#[derive(Debug, Clone)]
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
    /// Names of the quantities that are those of the sharp hill of a mass-conserving film, and all that follows from
    /// them; of the others none is.
    pub of_hill: Vec<String>,
    /// Half widths [N] of what the film carries in its place, in independent directions of force and moment; none
    /// without bars, or where the mesh does not resolve the film.
    pub carried: Option<Vec<(Vector, f64)>>,
    /// The bar that the load would have without its hill over that which it has; one where there is none.
    pub narrowed: f64,
    /// Seconds that measuring and estimating took.
    pub seconds: f64,
}

impl Estimated {
    /// A film without error bars.
    pub fn without_bars(film: &Film, measured: Measured) -> Self {
        Self {
            quantities: numbers(film, &measured),
            measured,
            indicator: None,
            is_local: false,
            spread: 0.0,
            of_hill: Vec::new(),
            carried: None,
            narrowed: 1.0,
            seconds: 0.0,
        }
    }
}

/// Measures a solved film and estimates its errors.
pub fn estimate_errors(solved: &Solved) -> Estimated {
    let (clock, film) = (Instant::now(), &solved.film);
    let mut estimated = match &solved.reference {
        None => Estimated::without_bars(film, of_quadratic(solved, None)),
        Some(ReferenceFilm::Cubic(cubic)) => by_cubic(solved, cubic),
        Some(ReferenceFilm::Coarse { film, error, hill }) => by_coarse(solved, film, error.as_deref(), hill.as_deref()),
    };
    if let Some(found) = &solved.temperature {
        found.widen(film, &estimated.measured, &mut estimated.quantities);
    }
    for quantity in &mut estimated.quantities {
        let Some(bar) = quantity.bar.as_mut().filter(|_| film.heat.is_some()) else { continue };
        // Without films beside it nothing is known of what its temperatures leave open.
        match solved.heat_bars.get(&quantity.name) {
            Some(open) => bar.discretisation += open,
            None => quantity.bar = None,
        }
    }
    Estimated { seconds: clock.elapsed().as_secs_f64(), ..estimated }
}

fn by_cubic(solved: &Solved, cubic: &SolvedFilm) -> Estimated {
    let film = &solved.film;
    let reported = of_cubic(film, cubic);
    let Ok(following) = following_wall(&solved.primary) else {
        return Estimated::without_bars(film, reported);
    };
    let Ok(error) = film_error(&solved.primary, cubic, &reported.load.total, following.as_ref()) else {
        return Estimated::without_bars(film, reported);
    };
    let quadratic = of_quadratic(solved, Some(&reported));
    let pair = CubicPair {
        film,
        quadratic: &solved.primary,
        cubic,
        error: &error,
        measured: [&quadratic, &reported],
        value: Value::Cubic,
        edge: edge_of(film, cubic),
        of_load: LoadErrors::of(&error, Value::Cubic),
        shared: SharedBars::default(),
    };
    let LoadErrors { bars, is_resolved } = pair.of_load;
    let load = bars_of_balance(film, &reported, bars, pair.moment());
    Estimated {
        of_hill: Vec::new(),
        carried: is_resolved.then(|| load.iter().map(|(direction, bar)| (*direction, bar.total())).collect()),
        narrowed: 1.0,
        quantities: with_bars(solved, &pair, &reported, &numbers(film, &quadratic), &load),
        measured: reported,
        is_local: bars[0].front > bars[0].discretisation,
        spread: 0.0,
        indicator: Some(error.indicator()),
        seconds: 0.0,
    }
}

fn by_coarse(
    solved: &Solved,
    coarse: &SolvedFilm,
    error: Option<&ConservingError>,
    hill: Option<&SharpFilm>,
) -> Estimated {
    let film = &solved.film;
    let mut measured = of_quadratic(solved, None);
    let Some(mut error) = error.cloned() else {
        return Estimated::without_bars(film, measured);
    };
    let of_film = numbers(film, &measured);
    let (mut of_hill, by_film) = (Vec::new(), error.load.total());
    if let Some(hill) = hill {
        let sharpened = sharpen(&mut error, &measured.as_hill(), hill, reported(solved));
        measured.sharpen(&film.problem, &sharpened);
        of_hill.extend(sharpened.load.map(|_| LOAD.name.to_owned()));
        of_hill.extend(sharpened.greatest.map(|_| PRESSURE_MAX.name.to_owned()));
    }
    let plain = Estimated::without_bars(film, measured);
    let pair = CoarseComparison {
        film,
        error: &error,
        measured: &plain.measured,
        dynamics: plain.measured.dynamics().and_then(|dynamics| Dynamics::beside(coarse, dynamics).ok()),
        hidden: hidden_share(&solved.primary, error.pressure),
    };
    let is_free = film.load().is_some_and(|load| load.tilting.is_some());
    let load: Vec<(Vector, Bar)> = match is_free {
        true => {
            (error.directions.iter()).map(|&ErrorDirection { direction, bar }| (direction, of_few(film, bar))).collect()
        }
        false => bars_of_balance(film, &plain.measured, [error.load, error.across], None),
    };
    Estimated {
        quantities: with_bars(solved, &pair, &plain.measured, &of_film, &load),
        spread: error.spread,
        indicator: Some(error.indicator),
        of_hill,
        narrowed: (by_film / error.load.total()).max(1.0),
        ..plain
    }
}

/// The film that is reported where there is a hill.
fn reported(solved: &Solved) -> ReportedFilm {
    match solved.balance {
        _ if solved.temperature.is_some() => ReportedFilm::FiniteVolumes,
        None => ReportedFilm::Narrower,
        Some(BalanceFacts { is_of_hill: true, .. }) => ReportedFilm::LoadOfHill,
        Some(BalanceFacts { is_of_hill: false, .. }) => ReportedFilm::FiniteVolumes,
    }
}

/// The numbers of the quadratic film of a solved film with their bars: what would be reported without the cubic film.
/// `None` where there is no cubic film, and under a load, where the position is that of the cubic film.
pub fn quadratic_errors(solved: &Solved) -> Option<Vec<Quantity>> {
    let (Some(ReferenceFilm::Cubic(cubic)), None) = (&solved.reference, &solved.balance) else {
        return None;
    };
    let film = &solved.film;
    let better = of_cubic(film, cubic);
    let error = film_error(&solved.primary, cubic, &better.load.total, None).ok()?;
    let quadratic = of_quadratic(solved, Some(&better));
    let pair = CubicPair {
        film,
        quadratic: &solved.primary,
        cubic,
        error: &error,
        measured: [&quadratic, &better],
        value: Value::Quadratic,
        edge: edge_of(film, cubic),
        of_load: LoadErrors::of(&error, Value::Quadratic),
        shared: SharedBars::default(),
    };
    Some(with_bars(solved, &pair, &quadratic, &numbers(film, &better), &[]))
}

/// What is measured on the film in cubic elements.
fn of_cubic(film: &Film, cubic: &SolvedFilm) -> Measured {
    measure(cubic).with_dynamics(film, cubic, None)
}

/// What is measured on the film itself, beside that in cubic elements if there is one.
fn of_quadratic(solved: &Solved, beside: Option<&Measured>) -> Measured {
    measure(&solved.primary).with_dynamics(&solved.film, &solved.primary, beside)
}

/// What the edge of the cavity of the film in cubic elements leaves open of stiffness and damping.
fn edge_of(film: &Film, cubic: &SolvedFilm) -> Option<Vec<Coefficients>> {
    film.model.sockets.dynamics.as_ref()?;
    match film.problem.cavitation.has_free_boundary() {
        true => edge_parts(cubic).ok(),
        false => Some(Vec::new()),
    }
}

fn numbers(film: &Film, of: &Measured) -> Vec<Quantity> {
    measured(&View::new(film, &film.problem, of))
}

/// Bars of what a balance fixes [N], in directions of force and moment: along the load and across it and, where the
/// journal can tilt, of the `moment` [N m] towards x and y.
fn bars_of_balance(
    film: &Film,
    measured: &Measured,
    [along, across]: [Bar; 2],
    moment: Option<[Bar; 2]>,
) -> Vec<(Vector, Bar)> {
    let [x, y] = film.load().map_or(measured.load.total.force, |load| load.force);
    let size = x.hypot(y);
    let [x, y] = if size > 0.0 { [x / size, y / size] } else { [1.0, 0.0] };
    let per_arm = 2.0 / film.problem.bearing.length;
    let of_force = [([x, y, 0.0, 0.0], along), ([-y, x, 0.0, 0.0], across)];
    let of_moment = moment
        .map(|[m_x, m_y]| [([0.0, 0.0, 1.0, 0.0], m_x.scaled(per_arm)), ([0.0, 0.0, 0.0, 1.0], m_y.scaled(per_arm))]);
    let bars = of_force.into_iter().chain(of_moment.into_iter().flatten());
    bars.map(|(direction, bar)| (direction, of_few(film, bar))).collect()
}

/// The numbers of a film with their bars. `others` are those of the other film of a pair, or the numbers themselves;
/// `load` bars [N] of what a balance fixes, by direction.
fn with_bars(
    solved: &Solved,
    estimate: &dyn Estimate,
    reported: &Measured,
    others: &[Quantity],
    load: &[(Vector, Bar)],
) -> Vec<Quantity> {
    let film = &solved.film;
    let view = View::new(film, &film.problem, reported);
    let mut list = measured(&view);
    let balance = solved.balance.as_ref();
    let by_wall = wall_bars(solved, others, reported);
    let moved = balance.map(|balance| {
        let arm = balance.coordinates.arm;
        let total = |(direction, bar): &(Vector, Bar)| (*direction, bar.total() + by_wall.towards(*direction, arm));
        let totals: Vec<(Vector, f64)> = load.iter().take(balance.coordinates.order).map(total).collect();
        position_bars(solved, balance, &totals, others, reported)
    });
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
            Some(Bar { position, wall: by_wall.of(&quantity.name), ..of_few(film, bar) })
        });
        quantity.set_bar(bar);
    }
    link(&mut list, &view, balance);
    list
}

/// Triangles of a mesh whose bars are twice those of the rules, which were found on meshes of hundreds and more.
const FEW: f64 = 100.0;

/// A bar on the mesh of a film: wider where triangles are few, and two degrees know little of the shape of a cavity.
fn of_few(film: &Film, bar: Bar) -> Bar {
    let triangles = film.system.space().mesh().triangles().len() as f64;
    let wider = 1.0 + FEW / triangles;
    Bar {
        discretisation: wider * bar.discretisation,
        front: wider * bar.front,
        transport: wider * bar.transport,
        ..bar
    }
}
