//! The table of quantities with their error bars, and what the bars are made of.

use crate::complain::printable;
use crate::readable::{bar, readable_unit, significant, supported};
use crate::terminal::{align_right, table, time};
use oilwedge_study::effects::Socket;
use oilwedge_study::quantities::{ECCENTRICITY, LOAD, Quantity};
use oilwedge_study::result::{LevelFacts, Refinement, RunResult};

/// A quantity below this in its smallest unit is nothing: 1e-9 N, um, ml/s or deg.
const ROUNDING: f64 = 1e-9;
/// Digits of a value without a bar.
const DIGITS: usize = 6;

/// All quantities; with bars where they were asked for.
pub(crate) fn quantities<'a>(quantities: impl IntoIterator<Item = &'a Quantity>, bars: bool) -> String {
    let mut table = match bars {
        true => table(["quantity", "symbol", "value", "± error", "unit", "what it is"]),
        false => table(["quantity", "symbol", "value", "unit", "what it is"]),
    };
    for quantity in quantities {
        let (unit, size) = readable_unit(quantity.value, quantity.unit());
        let value = match (quantity.value / size, quantity.error()) {
            (nothing, _) if nothing.abs() < ROUNDING => "0".to_owned(),
            (value, Some(error)) if error > 0.0 => supported(value, error / size),
            (value, _) => significant(value, DIGITS),
        };
        let error = match quantity.error() {
            None => "not resolved".to_owned(),
            Some(0.0) => "exact".to_owned(),
            Some(error) => bar(error / size),
        };
        let (name, symbol, unit) = (
            printable(&quantity.name),
            quantity.row.symbol.to_owned(),
            unit.to_string(),
        );
        let words = quantity.row.what.to_owned();
        match bars {
            true => table.add_row([name, symbol, value, error, unit, words]),
            false => table.add_row([name, symbol, value, unit, words]),
        };
    }
    align_right(&mut table, 2);
    if bars {
        align_right(&mut table, 3);
    }
    table.to_string()
}

/// What the bar of the load or, where that is given, of the eccentricity is made of; and the meshes that led to it.
pub(crate) fn bars(result: &RunResult) -> Vec<String> {
    let is_loaded = result.effects.fill(Socket::Position);
    let main = result.quantity(if is_loaded { &ECCENTRICITY } else { &LOAD });
    let parts = main.and_then(parts);
    let levels = (0..).zip(&result.levels).map(|(number, facts)| {
        let label = if number == 0 { "levels" } else { "" };
        format!("{label:10}{}", level(facts, main))
    });
    parts.into_iter().chain(levels).collect()
}

fn parts(main: &Quantity) -> Option<String> {
    let (name, bar) = (&main.name, main.bar?);
    let shown = |error: f64| in_unit_of(main, error);
    let parts: Vec<_> = (bar.parts().into_iter())
        .filter(|(_, _, part)| *part > 0.0)
        .map(|(_, words, part)| format!("{words} {}", shown(part)))
        .collect();
    (!parts.is_empty()).then(|| {
        format!(
            "bar       of the {name}, ± {}: {}",
            shown(bar.total()),
            parts.join(", ")
        )
    })
}

fn level(facts: &LevelFacts, main: Option<&Quantity>) -> String {
    let mesh = match facts.refinement {
        Refinement::Given => "first mesh",
        Refinement::Uniform => "all triangles divided",
        Refinement::Local => "divided where the error comes from",
    };
    let error = main.and_then(|main| {
        let (_, error) = facts.errors.iter().find(|(name, _)| *name == main.name)?;
        Some(format!(", {} ± {}", main.row.symbol, in_unit_of(main, *error)))
    });
    format!(
        "{} unknowns{}, {} ({mesh})",
        facts.unknowns,
        error.unwrap_or_default(),
        time(facts.seconds)
    )
}

/// An error in a unit that suits it, and not the value.
fn in_unit_of(main: &Quantity, error: f64) -> String {
    let (unit, size) = readable_unit(error, main.unit());
    format!("{} {unit}", bar(error / size)).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terminal::run_report;
    use crate::terminal::tests::result;
    use oilwedge_campaign::AddOns;
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::quantities::Bar;
    use std::path::Path;

    /// A load with a bar, an angle whose bar is not resolved, an eccentricity that is given.
    fn with_bars() -> RunResult {
        let mut result = result();
        let parts = Bar {
            discretisation: 0.9,
            front: 0.1,
            ..Bar::default()
        };
        let mut eccentricity = Quantity::new(&ECCENTRICITY, 0.6);
        eccentricity.bar = Some(Bar::default());
        result.quantities.push(eccentricity);
        result.quantities[0].value = 12_911.234;
        result.quantities[0].bar = Some(parts);
        result.bars = true;
        result
    }

    #[test]
    fn a_value_has_the_digits_that_its_bar_supports() {
        let text = quantities(&with_bars().quantities, true);
        for row in [
            "12.911 ┆        0.001 ┆ kN",
            "49.2900 ┆ not resolved ┆ deg",
            "0.600000 ┆        exact ┆",
        ] {
            assert!(text.contains(row), "no {row} in\n{text}");
        }
        assert!(!quantities(&with_bars().quantities, false).contains("not resolved"));
    }

    #[test]
    fn the_bar_and_the_meshes_are_explained() {
        let mut result = with_bars();
        let level = |unknowns, refinement, error: f64, seconds| LevelFacts {
            unknowns,
            cells: 1000,
            refinement,
            errors: vec![("load".into(), error)],
            seconds,
        };
        result.levels = vec![
            level(2000, Refinement::Given, 35.2, 0.015),
            level(9000, Refinement::Uniform, 8.0, 0.05),
            level(12_000, Refinement::Local, 1.0, 1.2),
        ];
        let text = run_report(&result, &AddOns::default(), Path::new("out"), true);
        let wanted = "\
bar       of the load, ± 1 N: triangles 0.9 N, edge of the cavity 0.1 N
levels    2000 unknowns, W ± 36 N, 15.0 ms (first mesh)
          9000 unknowns, W ± 8 N, 50.0 ms (all triangles divided)
          12000 unknowns, W ± 1 N, 1.20 s (divided where the error comes from)
balance";
        assert!(text.contains(wanted), "{text}");
        result.effects.simulated.extend(
            EFFECTS
                .iter()
                .filter(|effect| effect.socket == Socket::Position)
                .copied(),
        );
        assert!(!run_report(&result, &AddOns::default(), Path::new("out"), true).contains("bar  "));
        result.quantities[2].bar = Some(Bar {
            position: 2e-5,
            ..Bar::default()
        });
        let text = run_report(&result, &AddOns::default(), Path::new("out"), true);
        let wanted = "bar       of the eccentricity, ± 2e-5: position under the load 2e-5\n";
        assert!(text.contains(wanted), "{text}");
    }
}
