//! The distributions of a sweep's quantities over its draws, and their table for people.

use oilwedge_campaign::statistics::{PERCENTILES, Statistics, share};
use oilwedge_scene::sweep::DrawLaw;
use oilwedge_study::result::Verdict;

use super::distribution::{Distribution, SampledNumber, SampledQuantity, ToleranceRecord};
use super::report::{CaseRecord, SweepResult};
use crate::digits::significant;
use crate::readable::plain_words;
use crate::sheet::{Sheet, none, number_as, of_axis, text, with_bar};

/// Digits of a number without a sampling error.
const DIGITS: usize = 4;

/// Name of a percentile.
fn name(percent: f64) -> String {
    format!("p{percent}")
}

/// The distributions at all points of a sweep with draws, in the order of its cases.
pub(super) fn distributions(sweep: &SweepResult) -> Vec<Distribution> {
    let Some(draws) = sweep.identity.draws else { return Vec::new() };
    let names = sweep.names(&[]);
    let first = |row: &CaseRecord| (row.case - 1) / draws.count;
    sweep.rows.chunk_by(|a, b| first(a) == first(b)).map(|rows| distribution(sweep, &names, rows)).collect()
}

fn distribution(sweep: &SweepResult, names: &[String], rows: &[CaseRecord]) -> Distribution {
    let axes = sweep.axes.iter().rev().skip(1);
    let inputs = axes.filter_map(|axis| Some((axis.name.clone(), rows[0].inputs.get(&axis.name)?.clone())));
    let of_name = |name: &String| {
        let found: Vec<_> = rows.iter().filter_map(|row| row.quantities.get(name)).collect();
        let values: Vec<f64> = found.iter().map(|it| it.value).collect();
        let statistics = Statistics::of(&values)?;
        let percentiles = PERCENTILES.iter().zip(statistics.percentiles);
        Some((
            name.clone(),
            SampledQuantity {
                unit: found.first()?.unit.clone(),
                mean: statistics.mean.into(),
                deviation: statistics.deviation.into(),
                percentiles: percentiles.map(|(percent, it)| (self::name(*percent), it.into())).collect(),
            },
        ))
    };
    let is_judged = rows.iter().any(|row| row.verdict.is_some());
    let hits = rows.iter().filter(|row| row.verdict == Some(Verdict::Pass)).count();
    Distribution {
        inputs: inputs.collect(),
        draws: rows.len(),
        answered: rows.iter().filter(|row| !row.quantities.is_empty()).count(),
        meet_criteria: share(hits, rows.len()).filter(|_| is_judged).map(SampledNumber::from),
        quantities: names.iter().filter(|name| sweep.varies(name)).filter_map(of_name).collect(),
    }
}

impl SweepResult {
    /// The distributions of the quantities over the draws; `None` of a sweep without draws.
    pub fn distribution_sheet(&self) -> Option<Sheet> {
        let draws = self.identity.draws?;
        let points: Vec<&str> = self.axes.iter().rev().skip(1).rev().map(|axis| axis.name.as_str()).collect();
        let mut header: Vec<String> =
            self.axes[..points.len()].iter().map(|axis| plain_words(&axis.heading())).collect();
        header.extend(["quantity", "mean", "standard deviation"].map(str::to_owned));
        header.extend(PERCENTILES.map(|percent| format!("{percent} %")));
        let names = self.names(&[]);
        let rows = self.distributions.iter().flat_map(|at| {
            let of_name = |name: &String| {
                let found = at.quantities.get(name)?;
                let (unit, size) = self.unit_of(name)?;
                let heading = match unit {
                    "" | "1" => self.heading(name),
                    unit => format!("{}, {unit}", self.heading(name)),
                };
                let inputs = points.iter().map(|axis| at.inputs.get(*axis).map_or_else(none, of_axis));
                let numbers = [Some(&found.mean), Some(&found.deviation)].into_iter();
                let numbers = numbers.chain(PERCENTILES.iter().map(|it| found.percentiles.get(&self::name(*it))));
                let cell = |it: Option<&SampledNumber>| it.map_or_else(none, |it| number_as(it.value, told(*it, size)));
                Some(inputs.chain([text(heading)]).chain(numbers.map(cell)).collect::<Vec<_>>())
            };
            names.iter().filter_map(of_name).collect::<Vec<_>>()
        });
        let law = match draws.law {
            DrawLaw::Uniform => "uniform within the widths",
            DrawLaw::Normal => "normal, the half widths three deviations",
        };
        let drawn: Vec<String> = self.tolerances.iter().map(ToleranceRecord::told).collect();
        let what = format!(
            "{} draws of seed {}, {law}: {}. Bars are sampling errors at 95 %.",
            draws.count,
            draws.seed,
            drawn.join(", ")
        );
        let met = self.distributions.iter().filter_map(|at| {
            let met = at.meet_criteria?;
            let inputs: Vec<String> = points
                .iter()
                .filter_map(|axis| Some(format!("{axis} = {}", of_axis(at.inputs.get(*axis)?).text)))
                .collect();
            let place = if inputs.is_empty() { String::new() } else { format!("{}: ", inputs.join(", ")) };
            Some(format!("{place}{} % of the draws meet all criteria.", told(met, 1e-2)))
        });
        let failed = self.distributions.iter().map(|at| at.draws - at.answered).sum::<usize>();
        let failed = (failed > 0).then(|| format!("{failed} draws have no answer, and count in no mean."));
        Some(Sheet {
            title: "Spread by draws".to_owned(),
            header,
            rows: rows.collect(),
            notes: [what].into_iter().chain(met).chain(failed).collect(),
            ..Sheet::default()
        })
    }
}

/// A number with its sampling error, in a unit of this size.
fn told(it: SampledNumber, size: f64) -> String {
    match it.error {
        Some(_) => with_bar(it.value, it.error, size),
        None => significant(it.value / size, DIGITS),
    }
}
