//! What each effect of a scene changes and costs: the scene is run again without it.
//!
//! The drag of a journal counts as an effect only where feeds drive the oil too. A load is none: it is what is asked.

use serde::Serialize;

use oilwedge_scene::Scene;
use oilwedge_study::CompileError;
use oilwedge_study::effects::{Effect, present};
use oilwedge_study::quantities::{
    ATTITUDE_ANGLE, FILM_THICKNESS_MIN, PRESSURE_MAX, Quantity, SIDE_FLOW, Unit, main_quantity,
};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::run::{RunOptions, run};

/// Runs of one scene at most, of which the median time is told.
const RUNS: usize = 9;
/// After this time [s] a scene is not run again.
const ENOUGH: f64 = 1.0;

/// One effect of a scene: what it changes, and what it costs.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct EffectCost {
    /// Its name among the effects simulated, as `cavitation: reynolds`.
    pub effect: &'static Effect,
    /// What stands in its place, as `constant viscosity`.
    pub instead: &'static str,
    /// How the run without it ended.
    pub status: Status,
    /// Why there is no solution without it, or why it was not reached.
    pub reason: Option<String>,
    /// The main quantities with and without it; an object keyed by name in JSON.
    #[serde(serialize_with = "by_name")]
    pub changes: Vec<Change>,
    /// Whether nothing changes beyond the error bars; `None` where bars are missing that could tell.
    pub could_be_left_out: Option<bool>,
    /// Wall time of a run with all effects [s], the median of several where it is short.
    pub seconds_with: f64,
    /// The same without this one.
    pub seconds_without: f64,
}

/// What an effect does to one quantity.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    /// Name of the quantity.
    #[serde(skip)]
    pub quantity: String,
    /// Its symbol.
    pub symbol: String,
    /// Its unit, that of all numbers here.
    pub unit: String,
    /// Its value with all effects; `None` where it has no meaning or there is no solution.
    pub with: Option<f64>,
    /// Its value without this one.
    pub without: Option<f64>,
    /// What the effect adds: the former less the latter; of angles the lesser way round.
    pub change: Option<f64>,
    /// Half width of the bar of the change, the sum of both; `None` where one is missing.
    pub error: Option<f64>,
}

/// Runs `scene` without each of its effects; `result` is that of the scene itself, with the same options.
///
/// # Errors
/// As [`run`] of the scene itself. That there is no film without an effect is no error.
pub fn effect_costs(scene: &Scene, options: &RunOptions, result: &RunResult) -> Result<Vec<EffectCost>, CompileError> {
    let variants: Vec<_> = without_each(scene).collect();
    if variants.is_empty() {
        return Ok(Vec::new());
    }
    let seconds_with = median_seconds(scene, options, result)?;
    let costs = variants.into_iter().map(|(effect, without)| {
        let mut cost = EffectCost {
            effect,
            instead: effect.instead,
            status: Status::NoSolution,
            reason: unfit(&without),
            changes: Vec::new(),
            could_be_left_out: Some(false),
            seconds_with,
            seconds_without: 0.0,
        };
        if cost.reason.is_some() {
            return cost;
        }
        let found = run(&without, options).and_then(|found| {
            cost.seconds_without = median_seconds(&without, options, &found.result)?;
            Ok(found.result)
        });
        match found {
            Ok(without) => {
                cost.changes = changes(scene, result, &without);
                cost.could_be_left_out = is_idle(&cost.changes);
                cost.status = without.status;
                cost.reason = without.reason;
            }
            Err(error) => cost.reason = Some(error.to_string()),
        }
        cost
    });
    Ok(costs.collect())
}

/// Each effect of a scene that can be left out, and the scene without it.
fn without_each(scene: &Scene) -> impl Iterator<Item = (&'static Effect, Scene)> + '_ {
    present(scene).filter_map(|effect| Some((effect, (effect.remove)(scene)?)))
}

/// Why a scene without an effect cannot be computed: a journal at rest carries no oil into a cavity that conserves it.
fn unfit(scene: &Scene) -> Option<String> {
    oilwedge_study::complaints(scene).first().map(ToString::to_string)
}

/// The median time [s] of this run and of others like it.
fn median_seconds(scene: &Scene, options: &RunOptions, result: &RunResult) -> Result<f64, CompileError> {
    let total = |result: &RunResult| {
        let parts = result.timing_s.iter();
        parts
            .filter(|(part, _)| part == "total")
            .map(|(_, seconds)| *seconds)
            .sum()
    };
    let mut seconds: Vec<f64> = vec![total(result)];
    while seconds.len() < RUNS && seconds.iter().sum::<f64>() < ENOUGH {
        seconds.push(total(&run(scene, options)?.result));
    }
    seconds.sort_unstable_by(f64::total_cmp);
    Ok(seconds[seconds.len() / 2])
}

/// The main quantities with and without an effect; none where there is no film without it.
fn changes(scene: &Scene, with: &RunResult, without: &RunResult) -> Vec<Change> {
    if without.quantities.is_empty() {
        return Vec::new();
    }
    let rows = [
        main_quantity(scene),
        &ATTITUDE_ANGLE,
        &PRESSURE_MAX,
        &FILM_THICKNESS_MIN,
        &SIDE_FLOW,
    ];
    let pairs = rows.map(|row| (with.quantity(row), without.quantity(row)));
    pairs
        .into_iter()
        .filter_map(|(with, without)| change(with, without))
        .collect()
}

fn change(with: Option<&Quantity>, without: Option<&Quantity>) -> Option<Change> {
    let any = with.or(without)?;
    let both = with.zip(without);
    let difference = |(with, without): (&Quantity, &Quantity)| match any.row.unit {
        Unit::Degree => 180.0 - (180.0 - (with.value - without.value)).rem_euclid(360.0),
        _ => with.value - without.value,
    };
    Some(Change {
        quantity: any.name.to_string(),
        symbol: any.row.symbol.to_owned(),
        unit: any.unit().to_owned(),
        with: with.map(|quantity| quantity.value),
        without: without.map(|quantity| quantity.value),
        change: both.map(difference),
        error: both.and_then(|(with, without)| Some(with.error()? + without.error()?)),
    })
}

/// Whether nothing changes beyond the bars; `None` where bars are missing that could tell.
fn is_idle(changes: &[Change]) -> Option<bool> {
    let stays = |it: &Change| match (it.change, it.error) {
        (None, _) => Some(false),
        (Some(change), error) => error.map(|error| change.abs() <= error),
    };
    let answers: Vec<_> = changes.iter().map(stays).collect();
    match answers.contains(&Some(false)) || answers.is_empty() {
        true => Some(false),
        false => answers.into_iter().collect::<Option<Vec<_>>>().map(|_| true),
    }
}

fn by_name<S: serde::Serializer>(changes: &[Change], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(changes.iter().map(|change| (&change.quantity, change)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_reynolds::error_bar::Bar;
    use oilwedge_study::quantities::{LOAD, Row};

    fn quantity(row: &'static Row, value: f64, error: Option<f64>) -> Quantity {
        Quantity {
            bar: error.map(Bar::of),
            ..Quantity::new(row, value)
        }
    }

    fn between(with: Option<Quantity>, without: Option<Quantity>) -> Change {
        change(with.as_ref(), without.as_ref()).expect("one of two")
    }

    #[test]
    fn every_effect_is_left_out_once_and_alone() {
        let text = r#"
bearing = { diameter = "75 mm", length = "75 mm", clearance = "37.5 um", arc = { from = "40 deg", to = "220 deg", inlet_fraction = 0.6 } }
feed = [{ group = "pocket", hole = { diameter = "9 mm", angle = "90 deg" }, depth = "20 um" },
        { group = "hole", hole = { diameter = "9 mm", angle = "150 deg" }, pressure = "1 bar" }]
journal = { speed = "10 rad/s", eccentricity = 0.6, min_film_angle = "180 deg", squeeze = { radial = "1 um/s" } }
oil = { viscosity = "0.4 Pa.s", roelands = { z = 0.6 } }
cavitation = { model = "jfo" }
"#;
        let scene =
            oilwedge_study::parse(text, std::path::Path::new("all.toml")).unwrap_or_else(|error| panic!("{error}"));
        let variants: Vec<_> = without_each(&scene).collect();
        let names: Vec<_> = variants
            .iter()
            .map(|(effect, without)| (effect.name, unfit(without).is_none()))
            .collect();
        let wanted = [
            ("couette", false),
            ("squeeze", true),
            ("roelands", true),
            ("groove depth", true),
            ("starved inlet", true),
            ("cavitation: jfo", true),
        ];
        assert_eq!(names, wanted);
        for (effect, without) in &variants[1..] {
            let left = without_each(without).count();
            let fewer = match effect.name {
                "cavitation: jfo" => 2,
                // The pocket stays, without a depth.
                "groove depth" => 0,
                _ => 1,
            };
            assert_eq!(left + fewer, variants.len(), "{}", effect.name);
        }
    }

    #[test]
    fn a_journal_at_rest_has_no_tolerance_of_its_sommerfeld_number() {
        let text = r#"
bearing = { diameter = "75 mm", length = "75 mm", clearance = "37.5 um" }
mesh = { tolerance = { sommerfeld_number = "1 %" } }
feed = [{ group = "hole", hole = { diameter = "9 mm", angle = "150 deg" }, pressure = "1 bar" }]
journal = { speed = "10 rad/s", eccentricity = 0.6, min_film_angle = "180 deg" }
oil = { viscosity = "0.4 Pa.s" }
"#;
        let left = |text: &str| {
            let scene = oilwedge_study::parse(text, std::path::Path::new("rest.toml"))
                .unwrap_or_else(|error| panic!("{error}"));
            let variants: Vec<_> = without_each(&scene).collect();
            assert!(variants.len() == 1 && unfit(&variants[0].1).is_none());
            variants[0].1.tolerance.as_ref().map(|_| ())
        };
        assert_eq!(left(text), None);
        assert_eq!(left(&text.replace("{ sommer", "{ load = \"1 %\", sommer")), Some(()));
    }

    #[test]
    fn a_change_has_the_sum_of_both_bars() {
        let load = |value, error| Some(quantity(&LOAD, value, error));
        let it = between(load(12.0, Some(0.5)), load(10.0, Some(0.25)));
        assert_eq!((it.with, it.without), (Some(12.0), Some(10.0)));
        assert_eq!((it.change, it.error), (Some(2.0), Some(0.75)));
        assert_eq!(between(load(12.0, None), load(10.0, Some(0.25))).error, None);
        let lost = between(load(12.0, Some(0.5)), None);
        assert_eq!((lost.without, lost.change, lost.error), (None, None, None));
        assert_eq!(change(None, None), None);
    }

    #[test]
    fn angles_change_the_lesser_way_round() {
        let angle = |value| Some(quantity(&ATTITUDE_ANGLE, value, None));
        for (with, without, wanted) in [
            (170.0, -170.0, -20.0),
            (-170.0, 170.0, 20.0),
            (50.0, 40.0, 10.0),
            (90.0, -90.0, 180.0),
        ] {
            assert_eq!(between(angle(with), angle(without)).change, Some(wanted));
        }
    }

    #[test]
    fn an_effect_is_idle_where_all_bars_say_so() {
        let one = |change: f64, error| {
            let value = quantity(&LOAD, 10.0 + change, error);
            between(Some(value), Some(quantity(&LOAD, 10.0, Some(0.0))))
        };
        assert_eq!(is_idle(&[one(0.25, Some(0.25)), one(0.0, Some(0.0))]), Some(true));
        assert_eq!(is_idle(&[one(0.25, Some(0.25)), one(0.5, Some(0.25))]), Some(false));
        assert_eq!(is_idle(&[one(0.25, Some(0.25)), one(0.0, None)]), None);
        assert_eq!(is_idle(&[one(0.5, Some(0.25)), one(0.0, None)]), Some(false));
        let lost = between(Some(quantity(&ATTITUDE_ANGLE, 5.0, Some(9.0))), None);
        assert_eq!(is_idle(&[lost]), Some(false));
        assert_eq!(is_idle(&[]), Some(false));
    }
}
