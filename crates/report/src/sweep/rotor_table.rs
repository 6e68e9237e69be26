//! Stiffness and damping over the speed, as programs for rotors read them: one row a speed, the columns named like the parameters of `ross.BearingElement`.
//!
//! ```python
//! bearing = ross.BearingElement(n=0, **pandas.read_csv("rotor_bearing.csv").to_dict("list"))
//! ```

use oilwedge_scene::sweep::{Axis, AxisValue};
use oilwedge_scene::unit::{Dimension, unit_size};
use oilwedge_study::quantities::{
    DAMPING_XX, DAMPING_XY, DAMPING_YX, DAMPING_YY, Row as Quantity, STIFFNESS_XX, STIFFNESS_XY, STIFFNESS_YX,
    STIFFNESS_YY,
};

use super::report::SweepReport;
use super::table::{Row, status_name, to_csv};
use oilwedge_campaign::sweep::CaseStatus;
use oilwedge_study::result::Status;

/// The table.
pub const ROTOR_FILE: &str = "rotor_bearing.csv";
/// Where the speed stands in a scene.
const SPEED: &str = "journal.speed";
/// The columns behind the frequency [rad/s], in SI.
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

/// The table of a sweep over positive speeds alone whose rows have all coefficients; `None` of any other one, and of a part. Cases without an answer are
/// left out.
pub(super) fn rotor_table(report: &SweepReport) -> Option<Vec<u8>> {
    let [axis] = &report.plan.axes[..] else { return None };
    if report.identity.part.is_some() {
        return None;
    }
    let unit = (axis.path == SPEED).then(|| unit_size(&axis.unit, Dimension::Speed).ok())??;
    let places: Vec<usize> = COLUMNS
        .iter()
        .map(|(_, row)| report.columns.quantities.iter().position(|column| column.row == *row))
        .collect::<Option<_>>()?;
    let mut rows: Vec<(f64, Row)> = Vec::new();
    for row in &report.rows {
        let speed = unit * speed(axis, row)?;
        if speed <= 0.0 {
            return None;
        }
        let values = places.iter().map(|&place| {
            let value = report.value(row, place)?;
            Some(format!("{:?}", report.columns.quantities[place].own(value)))
        });
        let is_converged = row[report.columns.status()] == status_name(CaseStatus::Run(Status::Converged));
        if let Some(values) = values.collect::<Option<Vec<String>>>().filter(|_| is_converged) {
            rows.push((speed, std::iter::once(format!("{speed:?}")).chain(values).collect()));
        }
    }
    rows.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    rows.dedup_by(|(a, _), (b, _)| a == b);
    let headings = std::iter::once("frequency").chain(COLUMNS.iter().map(|(name, _)| *name));
    let headings: Row = headings.map(str::to_owned).collect();
    (!rows.is_empty()).then(|| to_csv(std::iter::once(&headings).chain(rows.iter().map(|(_, row)| row))))
}

/// The speed of a row, in the unit of its axis.
fn speed(axis: &Axis, row: &Row) -> Option<f64> {
    let case: usize = row.first()?.parse().ok()?;
    match axis.values.get(case.checked_sub(1)?)? {
        AxisValue::Number(speed) => Some(*speed),
        AxisValue::Word(_) => None,
    }
}
