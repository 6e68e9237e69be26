//! What each effect of a scene changes and costs: the scene is run again without it.
//!
//! The drag of a journal counts as an effect only where feeds drive the oil too. A load is none: it is an input.

use oilwedge_scene::Scene;
use oilwedge_study::CompileError;
use oilwedge_study::effects::{Effect, present};
use oilwedge_study::quantities::{
    ATTITUDE_ANGLE, FILM_THICKNESS_MIN, PRESSURE_MAX, Row, SIDE_FLOW, main_quantity, row,
};
use oilwedge_study::result::RunResult;
use oilwedge_study::run::run;
use oilwedge_study::run_options::RunOptions;
use oilwedge_study::scope::Scope;

use crate::comparison::{Alternative, Comparison, QuantityPair, answer, pairs};
use crate::records::{CostRecord, read_back, recorded};

/// Runs of one scene at most, of which the median time is reported.
const RUNS: usize = 9;
/// Time [s] after which a scene is not run again.
const ENOUGH: f64 = 1.0;

/// The runs of `scene` without each of its effects; `result` is that of the scene itself, with the same options.
///
/// # Errors
/// As [`run`] of the scene itself. That there is no film without an effect is no error.
pub(crate) fn records(
    scene: &Scene,
    options: &RunOptions,
    result: &RunResult,
) -> Result<Vec<CostRecord>, CompileError> {
    let variants: Vec<_> = without_each(scene).collect();
    let seconds = match variants.is_empty() {
        true => 0.0,
        false => median_seconds(scene, options, result)?,
    };
    let cost = |(effect, without): (_, Scene)| CostRecord {
        seconds_with: seconds,
        ..cost(effect, &without, options, (main_quantity(&Scope::of(scene)), result))
    };
    Ok(variants.into_iter().map(cost).collect())
}

/// The run `without` an effect beside the result with all, which is judged by its `main` quantity.
fn cost(
    effect: &'static Effect,
    without: &Scene,
    options: &RunOptions,
    (main, with): (&'static Row, &RunResult),
) -> CostRecord {
    let found = answer(without, options);
    let time =
        |result: &RunResult| median_seconds(without, options, result).unwrap_or_else(|_| result.tail.seconds("total"));
    let compared = match found.result.as_ref().filter(|found| !found.quantities.is_empty()) {
        Some(found) => {
            let rows = [main, &ATTITUDE_ANGLE, &PRESSURE_MAX, &FILM_THICKNESS_MIN, &SIDE_FLOW];
            pairs(&rows, &with.quantities, &found.quantities)
        }
        None => Vec::new(),
    };
    CostRecord {
        effect: effect.name.to_owned(),
        instead: effect.instead.to_owned(),
        status: found.status,
        reason: found.reason,
        changes: recorded(&compared),
        could_be_left_out: could_be_left_out(&compared),
        seconds_with: 0.0,
        seconds_without: found.result.as_ref().map_or(0.0, time),
    }
}

/// The table of what effects change.
pub(crate) fn comparison(costs: &[CostRecord], result: &RunResult) -> Comparison {
    let alternative = |cost: &CostRecord| {
        let rows: Vec<_> = cost.changes.iter().filter_map(|(name, _)| row(name)).collect();
        Alternative {
            name: format!("without {}", cost.effect),
            pairs: pairs(&rows, &result.quantities, &read_back(&cost.changes, &result.quantities)),
            seconds: Some([cost.seconds_with, cost.seconds_without]),
        }
    };
    Comparison {
        title: match costs.is_empty() {
            true => "effects   none can be left out",
            false => "the film without each effect, and in brackets its difference from the film with all of them",
        }
        .to_owned(),
        film: "all effects".to_owned(),
        alternatives: costs.iter().map(alternative).collect(),
        lists: Vec::new(),
        notes: notes(costs, result.bars),
    }
}

/// Whether nothing changes beyond the error bars; `None` where bars that could decide are missing.
fn could_be_left_out(changes: &[QuantityPair]) -> Option<bool> {
    let exceeds = |it: &QuantityPair| it.difference().map_or(Some(true), |_| it.exceeds_bars());
    let answers: Vec<_> = changes.iter().map(exceeds).collect();
    match answers.contains(&Some(true)) || answers.is_empty() {
        true => Some(false),
        false => (!answers.contains(&None)).then_some(true),
    }
}

/// Why there is no film without an effect, and which effects make no difference.
fn notes(costs: &[CostRecord], bars: bool) -> Vec<String> {
    let named = |answer: Option<bool>| {
        let named = costs.iter().filter(|cost| cost.could_be_left_out == answer);
        let names: Vec<&str> = named.map(|cost| cost.effect.as_str()).collect();
        (!names.is_empty()).then(|| names.join(", "))
    };
    let reason = |cost: &CostRecord| {
        let reason = cost.reason.as_ref()?;
        Some(format!("without {} ({}): {reason}", cost.effect, cost.instead))
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

/// The median time [s] of this run and of others like it.
fn median_seconds(scene: &Scene, options: &RunOptions, result: &RunResult) -> Result<f64, CompileError> {
    let mut seconds: Vec<f64> = vec![result.tail.seconds("total")];
    while seconds.len() < RUNS && seconds.iter().sum::<f64>() < ENOUGH {
        seconds.push(run(scene, options)?.result.tail.seconds("total"));
    }
    seconds.sort_unstable_by(f64::total_cmp);
    Ok(seconds[seconds.len() / 2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::complaints;
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::quantities::{Bar, LOAD, Quantity};
    use oilwedge_study::result::Status;

    fn compared(changes: &[(f64, Option<f64>)]) -> Vec<QuantityPair> {
        let load = |value: f64, error: Option<f64>| Quantity { bar: error.map(Bar::of), ..Quantity::new(&LOAD, value) };
        let change = |&(change, error): &(f64, _)| {
            QuantityPair::between(Some(&load(10.0 + change, error)), Some(&load(10.0, Some(0.0))))
        };
        changes.iter().filter_map(change).collect()
    }

    fn cost(changes: &[(f64, Option<f64>)]) -> CostRecord {
        let barus = EFFECTS.iter().find(|effect| effect.name == "barus").expect("a row");
        let compared = compared(changes);
        CostRecord {
            effect: barus.name.to_owned(),
            instead: barus.instead.to_owned(),
            status: Status::Converged,
            reason: None,
            changes: recorded(&compared),
            could_be_left_out: could_be_left_out(&compared),
            seconds_with: 0.03,
            seconds_without: 0.012,
        }
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
        let names: Vec<_> =
            variants.iter().map(|(effect, without)| (effect.name, complaints(without).is_empty())).collect();
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
            assert!(variants.len() == 1 && complaints(&variants[0].1).is_empty());
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
            assert_eq!(cost(changes).could_be_left_out, wanted, "{changes:?}");
        }
        let mut lost = compared(&[(0.0, Some(9.0))]);
        lost[0].other = None;
        assert_eq!(could_be_left_out(&lost), Some(false));
    }

    #[test]
    fn notes_name_reasons_and_what_could_be_left_out() {
        let mut hopeless = cost(&[]);
        hopeless.reason = Some("nothing carries the oil".into());
        let found = notes(&[cost(&[(0.0, Some(0.0))]), cost(&[(1.0, Some(0.0))]), hopeless], true);
        assert_eq!(found.len(), 2);
        assert!(found[0].contains("without barus (constant viscosity): nothing carries the oil"));
        assert!(found[1].starts_with("could be left out: barus ("));
        let open = |bars: bool| notes(&[cost(&[(0.0, None)])], bars).remove(0);
        assert!(open(true).starts_with("not decided: barus") && open(false).contains("no error bars"));
    }
}
