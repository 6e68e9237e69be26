//! The shaft as it is bent: its centre line in the housing, and the shells in which its journals lie.

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::orbit::{Orbits, PathStep};
use oilwedge_bearing::shaft::{Engine, NodeForce};
use serde::{Deserialize, Serialize};

use super::compile::Compiled;

/// The centre line of a shaft under its loads.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ShaftDeflection {
    /// Crank angle [deg] of the step with the least film of all bearings; `null` at rest.
    pub crank_angle_deg: Option<f64>,
    /// The bearing with the least film.
    pub bearing: String,
    /// Force on the film of `bearing` towards x and y [N].
    pub force: [f64; 2],
    /// Axial positions [m], from z = 0 on; twice the same where a web stands.
    pub z: Vec<f64>,
    /// Displacement of the centre line in the housing towards x there [m].
    pub x: Vec<f64>,
    /// Displacement towards y [m].
    pub y: Vec<f64>,
    /// Displacement of the shell of each bearing towards x and y [m].
    pub shells: Vec<[f64; 2]>,
}

impl ShaftDeflection {
    /// The line of a shaft at rest whose journals have these offsets in their shells [m], and whose films carry that
    /// [N], with these least gaps [m]; `None` where the shaft is cut.
    pub(super) fn at_rest(compiled: &Compiled, (at, carried): (&[Vector], &[Vector]), gaps: &[f64]) -> Option<Self> {
        Self::turned(compiled, (at, carried), (least(gaps).0, &compiled.loads), 0.0)
    }

    /// The line at the step with the least film of all bearings.
    pub(super) fn of_cycle(compiled: &Compiled, engine: &Engine, orbits: &Orbits) -> Option<Self> {
        let films = compiled.films();
        let gaps = orbits.steps.iter().map(|step| films.gaps(step.iter().map(PathStep::under_wall)));
        let least = orbits.steps.iter().zip(gaps.map(|gaps| least(&gaps)));
        let (step, (bearing, _)) = least.min_by(|(_, (_, a)), (_, (_, b))| a.total_cmp(b))?;
        let angle = engine.speed * step[0].time;
        let [at, carried] = [|step: &PathStep| step.at, |step: &PathStep| step.excess]
            .map(|of| step.iter().map(of).collect::<Vec<Vector>>());
        let line = Self::turned(compiled, (&at, &carried), (bearing, &engine.loads(angle)), angle)?;
        Some(Self { crank_angle_deg: Some(angle.to_degrees()), ..line })
    }

    fn turned(
        compiled: &Compiled,
        (at, carried): (&[Vector], &[Vector]),
        (bearing, loads): (usize, &[NodeForce]),
        angle: f64,
    ) -> Option<Self> {
        let films = compiled.films();
        let joined = films.joined(&[], angle);
        let line = films.shaft.bent(&joined.displaced(at, carried), loads, angle)?;
        let [x, y, ..] = carried[bearing];
        Some(Self {
            crank_angle_deg: None,
            bearing: compiled.bearings[bearing].name.clone(),
            force: [x, y],
            z: line.iter().map(|point| point.z).collect(),
            x: line.iter().map(|point| point.by[0]).collect(),
            y: line.iter().map(|point| point.by[1]).collect(),
            shells: joined.yields(carried).iter().map(|[x, y, ..]| [*x, *y]).collect(),
        })
    }
}

/// The number of the least gap, and that gap [m].
fn least(gaps: &[f64]) -> (usize, f64) {
    let numbered = gaps.iter().copied().enumerate();
    numbered.fold((0, f64::INFINITY), |least, it| if it.1 < least.1 { it } else { least })
}
