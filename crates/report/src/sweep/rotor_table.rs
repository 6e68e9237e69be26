//! Stiffness and damping over the speed, as programs for rotors read them: one row a speed, the columns named like the
//! parameters of `ross.BearingElement`.
//!
//! In version 2 of ROSS the speed of a table is called `frequency`; from version 3 on it is `speed`, and `frequency` is
//! that of the whirl. So there is a table for each version, and one over speed and whirl for version 3 alone.

use oilwedge_scene::sweep::AxisValue;
use oilwedge_scene::unit::{Dimension, unit_size};
use oilwedge_study::quantities::{
    DAMPING_XX, DAMPING_XY, DAMPING_YX, DAMPING_YY, Row as Quantity, STIFFNESS_XX, STIFFNESS_XY, STIFFNESS_YX,
    STIFFNESS_YY,
};

use super::report::SweepReport;
use super::table::{TextRow, status_name, to_csv};
use oilwedge_campaign::sweep::CaseStatus;
use oilwedge_study::result::Status;

/// The tables for version 2 and version 3 of ROSS.
pub const ROTOR_FILES: [&str; 2] = ["rotor_bearing.csv", "rotor_bearing_3.csv"];
/// Key of the speed in a scene.
const SPEED: &str = "journal.speed";
/// Where the frequency of the whirl over the speed stands in a scene.
const WHIRL: &str = "dynamics.whirl";
/// The columns behind speed and frequency [rad/s], in SI.
const COLUMNS: [(&str, &Quantity); 8] = [
    ("kxx", &STIFFNESS_XX),
    ("kxy", &STIFFNESS_XY),
    ("kyx", &STIFFNESS_YX),
    ("kyy", &STIFFNESS_YY),
    ("cxx", &DAMPING_XX),
    ("cxy", &DAMPING_XY),
    ("cyx", &DAMPING_YX),
    ("cyy", &DAMPING_YY),
];

/// The tables of a sweep over positive speeds, or over these and the whirl, whose rows have all coefficients; none of
/// any other one, and of a part. Cases without an answer are left out.
pub(super) fn rotor_tables(report: &SweepReport) -> [Option<Vec<u8>>; 2] {
    let Some(rows) = points(report).filter(|rows| !rows.is_empty()) else {
        return [None, None];
    };
    let table = |keys: &[&str]| {
        let coefficients = COLUMNS.iter().map(|(name, _)| *name);
        let headings: TextRow = keys.iter().copied().chain(coefficients).map(str::to_owned).collect();
        let line = |point: &RotorRow| -> TextRow {
            let keys = point.keys[..keys.len()].iter().map(|number| format!("{number:?}"));
            keys.chain(point.coefficients.iter().cloned()).collect()
        };
        let rows: Vec<TextRow> = rows.iter().map(line).collect();
        to_csv(std::iter::once(&headings).chain(&rows))
    };
    match report.plan.axes.len() {
        1 => [Some(table(&["frequency"])), Some(table(&["speed"]))],
        _ => [None, Some(table(&["speed", "frequency"]))],
    }
}

/// A row of a table.
struct RotorRow {
    /// Speed and frequency of the whirl [rad/s].
    keys: [f64; 2],
    coefficients: TextRow,
}

/// The rows, by ascending speed and frequency.
fn points(report: &SweepReport) -> Option<Vec<RotorRow>> {
    let axes = &report.plan.axes;
    let place = |path: &str| axes.iter().position(|axis| axis.path == path);
    let (speeds, whirls) = (place(SPEED)?, place(WHIRL));
    if report.identity.part.is_some() || axes.len() != 1 + usize::from(whirls.is_some()) {
        return None;
    }
    let unit = unit_size(&axes[speeds].unit, Dimension::Speed).ok()?;
    let places: Vec<usize> = COLUMNS
        .iter()
        .map(|(_, row)| report.columns.quantities.iter().position(|column| column.row == *row))
        .collect::<Option<_>>()?;
    let mut points: Vec<RotorRow> = Vec::new();
    for row in &report.rows {
        let number = |axis: usize| of_axis(report, axis, row);
        let speed = unit * number(speeds)?;
        let ratio = whirls.map_or(Some(0.0), number)?;
        if speed <= 0.0 {
            return None;
        }
        let values = places.iter().map(|&place| {
            let value = report.value(row, place)?;
            Some(format!("{:?}", report.columns.quantities[place].own(value)))
        });
        let is_converged = row[report.columns.status()] == status_name(CaseStatus::Run(Status::Converged));
        if let Some(coefficients) = values.collect::<Option<TextRow>>().filter(|_| is_converged) {
            let keys = [speed, ratio * speed];
            points.push(RotorRow { keys, coefficients });
        }
    }
    points.sort_by(|a, b| a.keys[0].total_cmp(&b.keys[0]).then(a.keys[1].total_cmp(&b.keys[1])));
    points.dedup_by(|a, b| a.keys == b.keys);
    Some(points)
}

/// The number of a row on an axis, in the unit of the axis.
fn of_axis(report: &SweepReport, axis: usize, row: &TextRow) -> Option<f64> {
    let case: usize = row.first()?.parse().ok()?;
    let index = *report.plan.indices(case.checked_sub(1)?).get(axis)?;
    match report.plan.axes.get(axis)?.values.get(index)? {
        AxisValue::Number(number) => Some(*number),
        AxisValue::Word(_) => None,
    }
}
