//! The load of a journal over a cycle: extremes, means, and the values by crank angle.

use std::f64::consts::TAU;

use oilwedge_scene::Scene;
use oilwedge_study::duty::{DutyCycle, RowsSummary, Summary};
use serde::Serialize;

/// Name and version of the form of `load.json`.
pub const LOAD_FORMAT: &str = "oilwedge-load/1";
/// Rows of a sheet in a turn of the crank.
const ROWS_OF_A_TURN: f64 = 360.0;
/// Steps by which the work of the gas is integrated: the error of a smooth curve is round-off.
const STEPS: u32 = 7200;

/// The load of a journal over a cycle. Forces are external ones on the journal, which the film carries, in the frame of
/// the shell.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LoadSheet {
    /// [`LOAD_FORMAT`].
    pub format: &'static str,
    /// Title of the scene.
    pub title: String,
    /// Period of the crank angle.
    pub period_deg: f64,
    /// Angular speed of the crank; of a load with a frequency of its own, that of the load.
    pub crank_speed_rad_s: f64,
    /// How often a load with a frequency of its own repeats; `None`: it goes by the crank angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frequency_hz: Option<f64>,
    /// Greatest magnitude of the force.
    pub peak: LoadAt,
    /// Least magnitude of the force.
    pub least: LoadAt,
    /// Mean force.
    pub mean_force_n: [f64; 2],
    /// Mean magnitude of the force.
    pub mean_magnitude_n: f64,
    /// Greatest magnitude of the force over length times diameter of the bearing.
    pub specific_load_pa: f64,
    /// Greatest magnitude of the moment.
    pub greatest_moment_n_m: f64,
    /// Least and greatest angular speed of the journal against the shell.
    pub journal_speed_rad_s: [f64; 2],
    /// Part of the force that turns at half the speed of the journal, over the mean magnitude: where it is most of it,
    /// a film collapses.
    pub half_speed_share: f64,
    /// Work of the gas on the piston in a period; `None`: the load is not that of a big end computed from its crank.
    pub gas_work_j: Option<f64>,
    /// Extremes and means of the rows of the table, beside those of the curve through them; `None`: the load is not
    /// given by a table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub table: Option<TableLoad>,
    /// The load at growing crank angles.
    pub rows: Vec<DutyRow>,
}

/// The rows of a table of loads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct TableLoad {
    /// Number of rows of a period.
    pub rows: usize,
    /// Greatest magnitude of the force in a row.
    pub peak: LoadAt,
    /// Mean force of straight lines from row to row.
    pub mean_force_n: [f64; 2],
    /// Mean of the magnitude that is linear from row to row.
    pub mean_magnitude_n: f64,
}

impl TableLoad {
    fn of(rows: RowsSummary) -> Self {
        Self {
            rows: rows.count,
            peak: LoadAt::of(rows.peak),
            mean_force_n: rows.mean,
            mean_magnitude_n: rows.mean_magnitude,
        }
    }
}

/// A force at a crank angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadAt {
    /// Crank angle.
    pub angle_deg: f64,
    /// Magnitude.
    pub magnitude_n: f64,
    /// Direction, from x towards y.
    pub direction_deg: f64,
}

/// What acts on the journal at a crank angle.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct DutyRow {
    /// Crank angle.
    pub angle_deg: f64,
    /// Force.
    pub force_n: [f64; 2],
    /// Moment.
    pub moment_n_m: [f64; 2],
    /// Angular speed of the journal against the shell.
    pub journal_speed_rad_s: f64,
}

impl LoadAt {
    fn of((angle, [x, y]): (f64, [f64; 2])) -> Self {
        Self { angle_deg: angle.to_degrees(), magnitude_n: x.hypot(y), direction_deg: y.atan2(x).to_degrees() }
    }
}

impl LoadSheet {
    /// The load of a scene.
    pub fn of(scene: &Scene, cycle: &DutyCycle) -> Self {
        let Summary { peak, least, mean, mean_magnitude, greatest_moment, speeds, half_speed_share } = cycle.summary();
        let peak = LoadAt::of(peak);
        let period = cycle.period().to_degrees();
        let count = (period / 360.0 * ROWS_OF_A_TURN).round() as u32;
        let row = |k: u32| {
            let angle = cycle.period() * f64::from(k) / f64::from(count);
            let duty = cycle.at(angle);
            DutyRow {
                angle_deg: period * f64::from(k) / f64::from(count),
                force_n: duty.force,
                moment_n_m: duty.moment,
                journal_speed_rad_s: duty.speed,
            }
        };
        Self {
            format: LOAD_FORMAT,
            title: scene.title.clone(),
            period_deg: period,
            crank_speed_rad_s: cycle.angular_speed(),
            frequency_hz: (scene.load_cycle.as_ref())
                .and_then(|cycle| cycle.frequency)
                .map(|frequency| frequency / TAU),
            peak,
            least: LoadAt::of(least),
            mean_force_n: mean,
            mean_magnitude_n: mean_magnitude,
            specific_load_pa: peak.magnitude_n / (scene.bearing.length * scene.bearing.diameter),
            greatest_moment_n_m: greatest_moment,
            journal_speed_rad_s: speeds,
            half_speed_share,
            gas_work_j: cycle.crank().map(|crank| crank.gas_work(STEPS)),
            table: cycle.rows_summary().map(TableLoad::of),
            rows: (0..count).map(row).collect(),
        }
    }
}
