//! The table of a sweep: one row a case, and which columns there are.

use crate::json::ReportError;
use oilwedge_campaign::sweep::{CaseStatus, Found};
use oilwedge_scene::sweep::{AxisValue, Plan};
use oilwedge_scene::{CavitationModel, Scene, Viscosity};
use oilwedge_study::joint;
use oilwedge_study::result::Status;
use oilwedge_study::thermal;

/// The columns of a sweep, known before its first case is computed.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Headings of the inputs.
    pub inputs: Vec<String>,
    /// Names and units of the quantities, in the order of the report.
    pub quantities: Vec<(String, String)>,
    /// Whether each quantity has a column for its error.
    pub bars: bool,
}

/// A row: one text a column, empty where there is nothing to tell.
pub type Row = Vec<String>;

impl Columns {
    /// The columns of all cases of a sweep; an input that is a quantity of the report too has one column only.
    pub(crate) fn new(plan: &Plan, scenes: &[Scene], bars: bool) -> Self {
        let mut quantities: Vec<(String, String)> = Vec::new();
        let mut add = |name: &str, unit: &str| {
            let is_new = !plan.axes.iter().any(|axis| axis.name == name);
            if is_new && !quantities.iter().any(|(other, _)| other == name) {
                quantities.push((name.to_owned(), unit.to_owned()));
            }
        };
        let any = |wanted: &[CavitationModel]| {
            let model = |scene: &Scene| scene.cavitation.map(|cavitation| cavitation.model);
            scenes
                .iter()
                .any(|scene| model(scene).is_some_and(|model| wanted.contains(&model)))
        };
        let drops = |scene: &Scene| (scene.cavitation).is_some_and(|it| it.model.drops_pressures());
        let mut fed: Vec<&str> = Vec::new();
        for feed in scenes.iter().flat_map(|scene| &scene.feeds) {
            if feed.pressure.is_some() && !fed.contains(&feed.group.as_str()) {
                fed.push(&feed.group);
            }
        }
        for (name, unit) in [("load", "N"), ("load_x", "N"), ("load_y", "N"), ("load_angle", "deg")] {
            add(name, unit);
        }
        if !fed.is_empty() {
            add("load_coefficient", "1");
        }
        for (name, unit) in [
            ("sommerfeld_number", "1"),
            ("attitude_angle", "deg"),
            ("eccentricity", "1"),
            ("min_film_angle", "deg"),
            ("pressure_max", "Pa"),
            ("pressure_min", "Pa"),
            ("film_thickness_min", "m"),
        ] {
            add(name, unit);
        }
        if scenes
            .iter()
            .any(|scene| matches!(scene.oil.viscosity, Viscosity::ByTemperature(_)))
        {
            add("temperature_effective", "degC");
            add("viscosity_effective", "Pa.s");
        }
        add("viscosity_max", "Pa.s");
        if any(&[CavitationModel::Reynolds, CavitationModel::Jfo]) {
            add("cavity_share", "1");
        }
        if any(&[CavitationModel::Jfo]) {
            add("film_fraction_min", "1");
        }
        for (name, unit) in [
            ("side_flow", "m3/s"),
            ("side_flow_low", "m3/s"),
            ("side_flow_high", "m3/s"),
            ("inlet_flow", "m3/s"),
            ("side_flow_number", "1"),
            ("inlet_flow_number", "1"),
        ] {
            add(name, unit);
        }
        for group in &fed {
            add(&format!("feed_flow.{group}"), "m3/s");
        }
        if scenes.iter().any(drops) {
            add("cavity_flow", "m3/s");
        }
        for (name, unit) in [
            ("friction_torque", "N.m"),
            ("friction_torque_bearing", "N.m"),
            ("friction_coefficient", "1"),
            ("friction_power", "W"),
            ("friction_shear_power", "W"),
            ("friction_pressure_power", "W"),
        ] {
            add(name, unit);
        }
        if scenes.iter().any(drops) {
            add("friction_cavity_power", "W");
        }
        if scenes.iter().any(|scene| scene.journal.motion().is_some()) {
            add("squeeze_power", "W");
        }
        for (name, unit) in thermal::columns(scenes) {
            add(name, unit);
        }
        add("pressure_integral", "N");
        for group in &fed {
            add(&format!("load_x.{group}"), "N");
            add(&format!("load_y.{group}"), "N");
        }
        for (cap, speed) in scenes
            .iter()
            .filter_map(|scene| Some((scene.cap?, scene.journal.speed)))
        {
            for quantity in joint::quantities(&cap, speed, [0.0; 2]) {
                add(&quantity.name, &quantity.unit);
            }
        }
        Self {
            inputs: plan.axes.iter().map(|axis| axis.heading()).collect(),
            quantities,
            bars,
        }
    }

    /// The headings.
    pub fn headings(&self) -> Row {
        let mut row = vec!["case".to_owned()];
        row.extend(self.inputs.iter().cloned());
        row.push("status".to_owned());
        for (name, unit) in &self.quantities {
            row.push(format!("{name} [{unit}]"));
            if self.bars {
                row.push(format!("{name} error [{unit}]"));
            }
        }
        row.extend(["unknowns", "reason", "seconds"].map(str::to_owned));
        row
    }

    /// The row of case `number` (from 0).
    ///
    /// # Errors
    /// A number is not finite.
    pub(crate) fn row(&self, plan: &Plan, number: usize, found: &Found) -> Result<Row, ReportError> {
        let mut row = vec![(number + 1).to_string()];
        for (axis, index) in plan.axes.iter().zip(plan.indices(number)) {
            row.push(match &axis.values[index] {
                AxisValue::Number(number) => format!("{number:?}"),
                AxisValue::Word(word) => word.clone(),
            });
        }
        row.push(status_name(found.status).to_owned());
        for (name, _) in &self.quantities {
            let quantity = found.quantities.iter().find(|quantity| quantity.name == *name);
            let text = |value: Option<f64>| match value {
                None => Ok(String::new()),
                Some(value) if value.is_finite() => Ok(format!("{value:?}")),
                Some(value) => Err(ReportError::NotFinite {
                    name: format!("case {}, {name}", number + 1),
                    value,
                }),
            };
            row.push(text(quantity.map(|quantity| quantity.value))?);
            if self.bars {
                row.push(text(quantity.and_then(|quantity| quantity.error))?);
            }
        }
        row.push(found.unknowns.map_or(String::new(), |unknowns| unknowns.to_string()));
        let reason = found.reason.as_deref().unwrap_or_default();
        // One line a row.
        row.push(reason.split_whitespace().collect::<Vec<_>>().join(" "));
        row.push(format!("{:.6}", found.seconds));
        Ok(row)
    }

    /// Column of the status.
    pub(crate) fn status(&self) -> usize {
        1 + self.inputs.len()
    }

    /// Column of a quantity.
    pub fn quantity(&self, name: &str) -> Option<usize> {
        let place = self.quantities.iter().position(|(other, _)| other == name)?;
        Some(self.status() + 1 + place * if self.bars { 2 } else { 1 })
    }
}

/// How a case ended, as it is written.
pub(crate) fn status_name(status: CaseStatus) -> &'static str {
    match status {
        CaseStatus::Run(Status::Converged) => "converged",
        CaseStatus::Run(Status::NoSolution) => "no_solution",
        CaseStatus::Run(Status::NotConverged) => "not_converged",
        CaseStatus::BadScene => "bad_scene",
    }
}

/// Rows as lines of CSV.
pub(crate) fn to_csv<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        // Writing into memory cannot fail.
        let _ = writer.write_record(row);
    }
    writer.into_inner().unwrap_or_default()
}

/// The rows of a table whose writer may have been killed: whole ones, up to the first that is not. `None` where the table has other
/// headings.
pub(crate) fn whole_rows(bytes: &[u8], headings: &Row) -> Option<Vec<Row>> {
    let end = bytes
        .iter()
        .rposition(|byte| *byte == b'\n')
        .map_or(0, |place| place + 1);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .from_reader(&bytes[..end]);
    let mut records = reader.records();
    let row = |record: csv::StringRecord| -> Row { record.iter().map(str::to_owned).collect() };
    match records.next() {
        // Killed while the headings were written.
        None => return to_csv([headings]).starts_with(bytes).then(Vec::new),
        Some(first) if first.as_ref().ok().cloned().map(row).as_ref() != Some(headings) => return None,
        Some(_) => {}
    }
    let whole = records.map_while(Result::ok).map(row);
    Some(whole.take_while(|row| row.len() == headings.len()).collect())
}
