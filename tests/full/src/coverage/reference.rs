//! The numbers of a bearing on a mesh refined for all of them: what its bars are compared with.
//!
//! Refined where any goal's error is (components of the load, flows): at the edge of a cavity and at corners that is
//! much better than everywhere. How well a number is known is told by its own bar or, where that is less, by what the
//! last refinement changed.

use oilwedge_fem::marking::doerfler;
use oilwedge_mesh::refine;
use oilwedge_reynolds::ReferenceFilm;
use oilwedge_reynolds::error_bar::film_error;
use oilwedge_study::quantities::Quantity;

use super::bearings::{Bearing, Family};
use super::meshes::{Kind, Solve, graded_film, sized};

/// Unknowns of the first mesh.
const FIRST: f64 = 5000.0;
/// Share of the indicator that the triangles divided carry.
const SHARE: f64 = 0.85;
/// What the last refinement changed may be nothing by chance: then this part of the bar counts.
const LEAST: f64 = 0.1;
/// Shares of a goal below this part of its size are rounding.
const ROUNDING: f64 = 1e-9;

/// A number and how well it is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Known {
    /// Name of the quantity.
    pub name: String,
    /// Value in the unit of the report.
    pub value: f64,
    /// How far it may be from the true one.
    pub bar: f64,
}

/// What is known of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Unknowns of the finest mesh.
    pub unknowns: usize,
    /// The numbers.
    pub known: Vec<Known>,
}

/// The numbers of a bearing on meshes of at most some `most` unknowns.
///
/// # Errors
/// The reason why there are none.
pub fn reference(bearing: &Bearing, most: usize) -> Result<Reference, String> {
    let scene = sized(bearing, FIRST);
    let study = graded_film(&scene).map_err(|error| error.to_string())?;
    let mut before: Vec<Quantity> = Vec::new();
    let mut last = Solve::new(&study, Kind::Drawn)?;
    while last.unknowns < most {
        let cells = last.mesh().triangles().len();
        let marked = match indicator(&last) {
            Some(indicator) if bearing.family != Family::Conserving => doerfler(&indicator, SHARE),
            _ => vec![true; cells],
        };
        let Ok(refined) = refine::local(last.mesh(), &marked) else {
            break;
        };
        let next = last.on(&scene, refined.mesh)?;
        before = last.judged.quantities;
        last = Solve { judged: next.judged, ..next };
    }
    let known = last.judged.quantities.iter().map(|quantity| {
        let earlier = before.iter().find(|earlier| earlier.name == quantity.name);
        let change =
            earlier.map_or(f64::INFINITY, |earlier| quantity.row.difference(quantity.value, earlier.value).abs());
        let bar = quantity.error().unwrap_or(f64::INFINITY);
        Known {
            name: quantity.name.to_string(),
            value: quantity.value,
            bar: bar.min(change.max(if bar.is_finite() { LEAST * bar } else { 0.0 })),
        }
    });
    Ok(Reference { unknowns: last.unknowns, known: known.collect() })
}

/// Greatest share of each triangle in the error of any goal, relative to that goal's shares together.
fn indicator(solve: &Solve) -> Option<Vec<f64>> {
    let Some(ReferenceFilm::Cubic(cubic)) = &solve.solved.reference else {
        return None;
    };
    let error = film_error(&solve.solved.primary, cubic, &solve.judged.measured.load.total, None).ok()?;
    let force = error.force[0].hypot(error.force[1]);
    let flows = &solve.judged.measured.flows;
    let goals = error.goals[..2].iter().map(|goal| (goal, force));
    let flows = error.flows.iter().map(|(_, goal)| (goal, flows.throughput));
    let mut indicator = vec![0.0; solve.mesh().triangles().len()];
    for (goal, size) in goals.chain(flows) {
        let all: f64 = goal.shares.iter().map(|share| share.abs()).sum();
        if all > ROUNDING * size {
            for (greatest, share) in indicator.iter_mut().zip(&goal.shares) {
                *greatest = f64::max(*greatest, share.abs() / all);
            }
        }
    }
    Some(indicator)
}
