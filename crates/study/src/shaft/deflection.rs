//! The shaft as it is bent: its centre line in the housing, and the shells in which its journals lie.

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::orbit::Orbits;
use oilwedge_bearing::shaft::{Engine, Films, NodeForce};
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
    /// [N]; `None` where the shaft is cut.
    pub(super) fn at_rest(compiled: &Compiled, at: &[Vector], carried: &[Vector]) -> Option<Self> {
        Self::turned(compiled, (at, carried), &compiled.loads, 0.0)
    }

    /// The line at the step with the least film of all bearings.
    pub(super) fn of_cycle(compiled: &Compiled, engine: &Engine, orbits: &Orbits) -> Option<Self> {
        let films = compiled.films();
        let steps = orbits.steps.iter().map(|step| {
            let at: Vec<Vector> = step.iter().map(|step| step.at).collect();
            (step[0].time, at, step.iter().map(|step| step.excess).collect::<Vec<_>>())
        });
        let gaps = steps.map(|(time, at, carried)| (least(&films, &at), (time, at, carried)));
        let (_, (time, at, carried)) = gaps.min_by(|((a, _), _), ((b, _), _)| a.total_cmp(b))?;
        let angle = engine.speed * time;
        let line = Self::turned(compiled, (&at, &carried), &engine.loads(angle), angle)?;
        Some(Self { crank_angle_deg: Some(angle.to_degrees()), ..line })
    }

    fn turned(
        compiled: &Compiled,
        (at, carried): (&[Vector], &[Vector]),
        loads: &[NodeForce],
        angle: f64,
    ) -> Option<Self> {
        let films = compiled.films();
        let joined = films.joined(&[], angle);
        let line = films.shaft.bent(&joined.displaced(at, carried), loads, angle)?;
        let (_, bearing) = least(&films, at);
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

/// Least film of all bearings [m], and the number of its bearing.
fn least(films: &Films, at: &[Vector]) -> (f64, usize) {
    let gaps = films.films.iter().zip(at).map(|(film, at)| film.least_gap(*at)).zip(0..);
    gaps.fold((f64::INFINITY, 0), |least, it| if it.0 < least.0 { it } else { least })
}
