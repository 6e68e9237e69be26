//! The table of quantities with their error bars, and what the bars are made of.

use super::pieces::time;
use crate::digits::bar;
use crate::readable::readable_unit;
use crate::sheet::{Sheet, bar_in_words, numeral, text, value_in_words};
use oilwedge_study::effects::Socket;
use oilwedge_study::quantities::{CYCLE_FILM_THICKNESS_MIN, ECCENTRICITY, LOAD, Quantity};
use oilwedge_study::result::{LevelFacts, Refinement, RunResult};

/// All quantities, with their error bars where these were estimated.
pub(crate) fn quantities<'a>(quantities: impl IntoIterator<Item = &'a Quantity>, bars: bool) -> String {
    let cells = |it: &Quantity| {
        let (unit, size) = readable_unit(it.value, it.row.unit);
        let value = numeral(value_in_words(it.value, it.error(), bars, size));
        let error = numeral(bar_in_words(it.error(), bars, size));
        vec![text(&*it.name), text(it.row.symbol), value, error, text(unit), text(it.row.what)]
    };
    let rows = quantities.into_iter().map(cells).collect();
    let sheet = Sheet::new("", ["quantity", "symbol", "value", "± error", "unit", "what it is"], rows);
    Sheet { page_only: if bars { Vec::new() } else { vec![3] }, ..sheet }.terminal()
}

/// What the bar of the load or, where that is given, of the eccentricity is made of; and the meshes that led to it.
pub(crate) fn bars(result: &RunResult) -> Vec<String> {
    let is_loaded = result.effects.fill(Socket::Position);
    let main = (result.quantity(&CYCLE_FILM_THICKNESS_MIN))
        .or_else(|| result.quantity(if is_loaded { &ECCENTRICITY } else { &LOAD }));
    let parts = main.and_then(parts);
    let levels = (0..).zip(&result.levels).map(|(number, facts)| {
        let label = if number == 0 { "levels" } else { "" };
        format!("{label:10}{}", level(facts, main))
    });
    parts.into_iter().chain(levels).collect()
}

fn parts(main: &Quantity) -> Option<String> {
    let bar = main.bar?;
    let parts = bar.parts().into_iter().filter(|(_, _, part)| *part > 0.0);
    let parts: Vec<_> = parts.map(|(_, words, part)| format!("{words} {}", in_unit_of(main, part))).collect();
    let total = in_unit_of(main, bar.total());
    (!parts.is_empty()).then(|| format!("bar       of the {}, ± {total}: {}", main.name, parts.join(", ")))
}

fn level(facts: &LevelFacts, main: Option<&Quantity>) -> String {
    let mesh = match facts.refinement {
        Refinement::Given => "first mesh",
        Refinement::Uniform => "all triangles divided",
        Refinement::Drawn => "meshed again with shorter edges",
        Refinement::Local => "divided where the error comes from",
    };
    let error = main.and_then(|main| {
        let (_, error) = facts.errors.iter().find(|(name, _)| *name == main.name)?;
        Some(format!(", {} ± {}", main.row.symbol, in_unit_of(main, *error)))
    });
    format!("{} unknowns{}, {} ({mesh})", facts.unknowns, error.unwrap_or_default(), time(facts.seconds))
}

/// An error in a unit that suits it, and not the value.
fn in_unit_of(main: &Quantity, error: f64) -> String {
    let (unit, size) = readable_unit(error, main.row.unit);
    format!("{} {unit}", bar(error / size)).trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tables::run::run_report;
    use crate::tables::run::tests::{result, written};
    use crate::tables::shown::ShownQuantities;
    use oilwedge_campaign::Records;
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::quantities::Bar;

    /// A load with a bar, an angle whose bar is not resolved, an eccentricity that is given.
    fn with_bars() -> RunResult {
        let mut result = result();
        let parts = Bar { discretisation: 0.9, front: 0.1, ..Bar::default() };
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
        for row in ["12.9112 ┆        0.001 ┆ kN", "49 ┆ not resolved ┆ deg", "0.600000 ┆        exact ┆"] {
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
        let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
        let wanted = "\
bar       of the load, ± 1 N: triangles 0.9 N, edge of the cavity 0.1 N
levels    2000 unknowns, W ± 36 N, 15.0 ms (first mesh)
          9000 unknowns, W ± 8 N, 50.0 ms (all triangles divided)
          12000 unknowns, W ± 1 N, 1.20 s (divided where the error comes from)
balance";
        assert!(text.contains(wanted), "{text}");
        let position = EFFECTS.iter().copied().filter(|effect| effect.socket == Socket::Position);
        result.effects.simulated.extend(position);
        assert!(
            !run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written())).contains("bar  ")
        );
        result.quantities[2].bar = Some(Bar { position: 2e-5, ..Bar::default() });
        let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
        let wanted = "bar       of the eccentricity, ± 2e-5: position under the load 2e-5\n";
        assert!(text.contains(wanted), "{text}");
    }
}
