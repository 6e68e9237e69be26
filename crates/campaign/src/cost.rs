//! What each effect of a scene changes and costs: the scene is run again without it.
//!
//! The drag of a journal counts as an effect only where feeds drive the oil too. A load is none: it is an input.

use oilwedge_scene::Scene;
use oilwedge_study::CompileError;
use oilwedge_study::effects::{Effect, present};
use oilwedge_study::quantities::{ATTITUDE_ANGLE, FILM_THICKNESS_MIN, PRESSURE_MAX, SIDE_FLOW, main_quantity};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::run::run;
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::scope::Scope;

use crate::add_on::{AddOn, Alternative, Comparison, by_name};
use crate::records::{Change, CostRecord, Records};

/// Runs of one scene at most, of which the median time is reported.
const RUNS: usize = 9;
/// Time [s] after which a scene is not run again.
const ENOUGH: f64 = 1.0;

/// The run without one effect, beside that with all.
struct EffectCost {
    record: CostRecord,
    comparisons: Vec<Comparison>,
}

/// Runs `scene` without each of its effects; `result` is that of the scene itself, with the same options.
///
/// # Errors
/// As [`run`] of the scene itself. That there is no film without an effect is no error.
pub fn effect_costs(scene: &Scene, options: &RunOptions, result: &RunResult) -> Result<AddOn, CompileError> {
    let variants: Vec<_> = without_each(scene).collect();
    let seconds = match variants.is_empty() {
        true => 0.0,
        false => median_seconds(scene, options, result)?,
    };
    let run_with = (options, result, seconds);
    let costs = variants.into_iter().map(|(effect, without)| cost(effect, &without, scene, run_with));
    let costs: Vec<EffectCost> = costs.collect();
    Ok(AddOn {
        title: match costs.is_empty() {
            true => "effects   none can be left out",
            false => "the film without each effect, and in brackets its difference from the film with all of them",
        }
        .to_owned(),
        film: "all effects",
        alternatives: costs.iter().map(EffectCost::alternative).collect(),
        lists: Vec::new(),
        notes: notes(&costs, result.bars),
        record: Records { cost: Some(costs.into_iter().map(|cost| cost.record).collect()), ..Records::default() },
    })
}

/// The run of a scene `without` an effect; `run_with` are the options, the result and the time [s] of that with all.
fn cost(
    effect: &'static Effect,
    without: &Scene,
    scene: &Scene,
    run_with: (&RunOptions, &RunResult, f64),
) -> EffectCost {
    let (options, with, seconds) = run_with;
    let mut record = CostRecord {
        effect: effect.name.to_owned(),
        instead: effect.instead.to_owned(),
        status: Status::NoSolution,
        reason: unfit(without),
        changes: Vec::new(),
        could_be_left_out: Some(false),
        seconds_with: seconds,
        seconds_without: 0.0,
    };
    if record.reason.is_some() {
        return EffectCost { record, comparisons: Vec::new() };
    }
    let found = run(without, options).and_then(|found| {
        record.seconds_without = median_seconds(without, options, &found.result)?;
        Ok(found.result)
    });
    let comparisons = found.as_ref().map_or_else(|_| Vec::new(), |found| changes(scene, with, found));
    (record.status, record.reason) = match found {
        Ok(found) => (found.head.status, found.head.reason),
        Err(error) => (record.status, Some(error.to_string())),
    };
    EffectCost::of(record, comparisons)
}

impl EffectCost {
    /// Fills the comparisons into the record.
    fn of(record: CostRecord, comparisons: Vec<Comparison>) -> Self {
        let change = |it: &Comparison| {
            Some(Change {
                with: it.film.map(|film| film.value),
                without: it.other.map(|other| other.value),
                change: it.surplus(),
                error: it.error(),
            })
        };
        let changes = by_name(&comparisons, change);
        let record = CostRecord { changes, could_be_left_out: could_be_left_out(&comparisons), ..record };
        Self { record, comparisons }
    }

    fn alternative(&self) -> Alternative {
        Alternative {
            name: format!("without {}", self.record.effect),
            comparisons: self.comparisons.clone(),
            seconds: Some([self.record.seconds_with, self.record.seconds_without]),
        }
    }
}

/// Whether nothing changes beyond the error bars; `None` where bars that could decide are missing.
fn could_be_left_out(changes: &[Comparison]) -> Option<bool> {
    let stays = |it: &Comparison| match (it.surplus(), it.error()) {
        (None, _) => Some(false),
        (Some(change), error) => error.map(|error| change.abs() <= error),
    };
    let answers: Vec<_> = changes.iter().map(stays).collect();
    match answers.contains(&Some(false)) || answers.is_empty() {
        true => Some(false),
        false => answers.into_iter().collect::<Option<Vec<_>>>().map(|_| true),
    }
}

/// Why there is no film without an effect, and which effects make no difference.
fn notes(costs: &[EffectCost], bars: bool) -> Vec<String> {
    let named = |answer: Option<bool>| {
        let named = costs.iter().filter(|cost| cost.record.could_be_left_out == answer);
        let names: Vec<&str> = named.map(|cost| cost.record.effect.as_str()).collect();
        (!names.is_empty()).then(|| names.join(", "))
    };
    let reason = |EffectCost { record, .. }: &EffectCost| {
        let reason = record.reason.as_ref()?;
        Some(format!("without {} ({}): {reason}", record.effect, record.instead))
    };
    let negligible =
        named(Some(true)).map(|names| format!("could be left out: {names} (no change exceeds the error bars)"));
    let open = named(None).map(|names| match bars {
        true => format!("not decided: {names} (the error bars needed are not resolved)"),
        false => "no error bars were estimated: changes may be discretisation error".to_owned(),
    });
    costs.iter().filter_map(reason).chain(negligible).chain(open).collect()
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
        parts.filter(|(part, _)| part == "total").map(|(_, seconds)| *seconds).sum()
    };
    let mut seconds: Vec<f64> = vec![total(result)];
    while seconds.len() < RUNS && seconds.iter().sum::<f64>() < ENOUGH {
        seconds.push(total(&run(scene, options)?.result));
    }
    seconds.sort_unstable_by(f64::total_cmp);
    Ok(seconds[seconds.len() / 2])
}

/// The main quantities with and without an effect; none where there is no film without it.
fn changes(scene: &Scene, with: &RunResult, without: &RunResult) -> Vec<Comparison> {
    if without.quantities.is_empty() {
        return Vec::new();
    }
    let main = main_quantity(&Scope::of(scene));
    let rows = [main, &ATTITUDE_ANGLE, &PRESSURE_MAX, &FILM_THICKNESS_MIN, &SIDE_FLOW];
    let pairs = rows.map(|row| Comparison::between(with.quantity(row), without.quantity(row)));
    pairs.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::quantities::{Bar, LOAD, Quantity};

    fn cost(changes: &[(f64, Option<f64>)]) -> EffectCost {
        let load = |value: f64, error: Option<f64>| Quantity { bar: error.map(Bar::of), ..Quantity::new(&LOAD, value) };
        let change = |&(change, error): &(f64, _)| {
            Comparison::between(Some(&load(10.0 + change, error)), Some(&load(10.0, Some(0.0))))
        };
        let barus = EFFECTS.iter().find(|effect| effect.name == "barus").expect("a row");
        let record = CostRecord {
            effect: barus.name.to_owned(),
            instead: barus.instead.to_owned(),
            status: Status::Converged,
            reason: None,
            changes: Vec::new(),
            could_be_left_out: None,
            seconds_with: 0.03,
            seconds_without: 0.012,
        };
        EffectCost::of(record, changes.iter().filter_map(change).collect())
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
        let names: Vec<_> = variants.iter().map(|(effect, without)| (effect.name, unfit(without).is_none())).collect();
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
    fn an_effect_is_negligible_where_all_bars_say_so() {
        for (changes, wanted) in [
            (&[(0.25, Some(0.25)), (0.0, Some(0.0))][..], Some(true)),
            (&[(0.25, Some(0.25)), (0.5, Some(0.25))], Some(false)),
            (&[(0.25, Some(0.25)), (0.0, None)], None),
            (&[(0.5, Some(0.25)), (0.0, None)], Some(false)),
            (&[], Some(false)),
        ] {
            assert_eq!(cost(changes).record.could_be_left_out, wanted, "{changes:?}");
        }
        let mut lost = cost(&[(0.0, Some(9.0))]).comparisons;
        lost[0].other = None;
        assert_eq!(could_be_left_out(&lost), Some(false));
    }

    #[test]
    fn notes_name_reasons_and_what_could_be_left_out() {
        let mut hopeless = cost(&[]);
        hopeless.record.reason = Some("nothing carries the oil".into());
        let found = notes(&[cost(&[(0.0, Some(0.0))]), cost(&[(1.0, Some(0.0))]), hopeless], true);
        assert_eq!(found.len(), 2);
        assert!(found[0].contains("without barus (constant viscosity): nothing carries the oil"));
        assert!(found[1].starts_with("could be left out: barus ("));
        let open = |bars: bool| notes(&[cost(&[(0.0, None)])], bars).remove(0);
        assert!(open(true).starts_with("not decided: barus") && open(false).contains("no error bars"));
    }
}
