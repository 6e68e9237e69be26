//! The shaft as it is bent: its centre line in the housing, and the shells in which its journals lie.

use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::shaft::{Engine, Films, NodeForce, ShaftStep};
use serde::Serialize;

/// The centre line of a shaft under its loads.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ShaftDeflection {
    /// Crank angle [deg] of the step with the least film of all bearings; `null` at rest.
    pub crank_angle_deg: Option<f64>,
    /// Sum of all loads then, towards x and y [N].
    pub load: [f64; 2],
    /// Axial positions [m], from z = 0 on; twice the same where a web stands.
    pub z: Vec<f64>,
    /// Displacement of the centre line in the housing towards x there [m].
    pub x: Vec<f64>,
    /// As `x`, towards y.
    pub y: Vec<f64>,
    /// Displacement of the shell of each bearing towards x and y [m].
    pub shells: Vec<[f64; 2]>,
}

impl ShaftDeflection {
    /// The line of a shaft whose journals have these offsets in their shells [m], and whose films carry that [N];
    /// `None` where the shaft is cut.
    pub(super) fn at_rest(films: &Films, at: &[Vector], carried: &[Vector], loads: &[NodeForce]) -> Option<Self> {
        Self::turned(films, at, carried, (loads, 0.0))
    }

    /// The line at the step with the least film of all bearings.
    pub(super) fn of_cycle(films: &Films, engine: &Engine, steps: &[ShaftStep]) -> Option<Self> {
        let least = |step: &ShaftStep| {
            let gaps = films.films.iter().zip(&step.train.at).map(|(film, at)| film.least_gap(*at));
            gaps.fold(f64::INFINITY, f64::min)
        };
        let gaps = steps.iter().map(|step| (least(step), step));
        let (_, step) = gaps.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
        let angle = engine.speed * step.time;
        let line = Self::turned(films, &step.train.at, &step.carried, (&engine.loads(angle), angle))?;
        Some(Self { crank_angle_deg: Some(angle.to_degrees()), ..line })
    }

    fn turned(films: &Films, at: &[Vector], carried: &[Vector], (loads, angle): (&[NodeForce], f64)) -> Option<Self> {
        let line = films.shaft.bent(&films.displaced(at, carried), loads, angle)?;
        let yields = films.films.iter().zip(carried).map(|(film, carried)| film.yields(*carried));
        Some(Self {
            crank_angle_deg: None,
            load: loads.iter().fold([0.0; 2], |[x, y], load| [x + load.force[0], y + load.force[1]]),
            z: line.iter().map(|point| point.z).collect(),
            x: line.iter().map(|point| point.by[0]).collect(),
            y: line.iter().map(|point| point.by[1]).collect(),
            shells: yields.map(|[x, y, ..]| [x, y]).collect(),
        })
    }
}
