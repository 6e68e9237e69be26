//! A run for people: the main numbers first, what was simulated, the balances and the time, and last the verdict.

use super::criteria::judged;
use super::dynamics;
use super::pieces::{effects, mesh, time, whole_run};
use super::quantities::{bars, quantities};
use super::shown::ShownQuantities;
use super::temperature;
use super::verdict::verdict;
use crate::balances;
use crate::comparison::sheet;
use crate::design_sheet::design_sheets;
use crate::digits::significant;
use crate::readable::readable_unit;
use crate::sheet::Sheet;
use crate::spread_sheet::{sensitivity_sheet, spread_sheet};
use oilwedge_campaign::{Records, comparisons};
use oilwedge_study::orbit::OrbitFacts;
use oilwedge_study::quantities::{CAVITY_FLOW, CAVITY_SHARE, Quantity, Table};
use oilwedge_study::result::{Counts, LinearRoute, LinearSolverFacts, ResultTail, RunResult, headlines};
use std::path::Path;

/// What a run has written.
#[derive(Clone, Copy)]
pub struct Written<'a> {
    /// The folder of the results.
    pub folder: &'a Path,
    /// The files in it.
    pub files: &'a [String],
    /// The lines about pictures; empty where none were drawn.
    pub pictures: &'a str,
}

impl Written<'_> {
    /// The files and where they are.
    pub(super) fn lines(self) -> impl Iterator<Item = String> {
        let written = format!("written   {}: {}", self.folder.display(), self.files.join(", "));
        std::iter::once(written).chain(self.pictures.lines().map(str::to_owned))
    }
}

/// Everything about a run: the main numbers, what was simulated, the balances, where the time went, what was written if
/// anything was, and last the verdict.
pub fn run_report(result: &RunResult, shown: ShownQuantities, records: &Records, written: Option<Written>) -> String {
    let mut parts = tables(result, shown);
    parts.extend(temperature::balance(result, shown));
    parts.extend(judged(result));
    parts.extend([spread_sheet(result), sensitivity_sheet(result)].iter().flatten().map(Sheet::terminal));
    parts.extend(dynamics::dynamics(result, shown));
    parts.push(effects(&result.effects));
    parts.extend(design_sheets(records).iter().map(|sheet| sheet.terminal()));
    parts.extend(comparisons(records, result).iter().map(|it| sheet(it).terminal()));
    let mut lines = Vec::new();
    if !result.quantities.is_empty() {
        lines.extend(bars(result));
        lines.extend(balances::lines(&balances::of_film(result)));
    }
    lines.extend(cavity(result));
    lines.extend(result.orbit.as_ref().map(orbit));
    lines.push(format!("mesh      {}", mesh(&result.mesh)));
    lines.extend(work(result.counts, result.linear_solver));
    lines.push(format!("time      {}", timing(&result.tail)));
    if let Some(written) = written {
        lines.extend(written.lines());
        lines.extend(left_out(result, shown));
    }
    lines.push(verdict(result));
    whole_run(&result.head, parts, &lines)
}

/// The tables of quantities: headlines first, then the joint of a cap, then all others of the film if they are asked
/// for.
fn tables(result: &RunResult, shown: ShownQuantities) -> Vec<String> {
    if result.quantities.is_empty() {
        return Vec::new();
    }
    let first = headlines(&result.quantities, |quantity| quantity.row, &result.effects);
    let is_first = |quantity: &&Quantity| first.iter().any(|other| other.name == quantity.name);
    let mut parts = vec![quantities(first.iter().copied(), result.bars)];
    let of = |table: Table| result.quantities.iter().filter(move |quantity| quantity.row.table == table);
    if of(Table::Cap).next().is_some() {
        parts.push(format!("joint of the cap\n{}", quantities(of(Table::Cap), result.bars)));
    }
    if shown == ShownQuantities::All {
        let others = of(Table::Film).filter(|quantity| !is_first(quantity));
        parts.push(format!("further quantities\n{}", quantities(others, result.bars)));
    }
    parts
}

/// A sentence on the quantities that are not shown, with the way to see them.
fn left_out(result: &RunResult, shown: ShownQuantities) -> Option<String> {
    (shown == ShownQuantities::Headlines && !result.quantities.is_empty()).then(|| {
        let count = result.quantities.len();
        format!("more      --all shows all {count} quantities; result.json has them too")
    })
}

/// How the orbit closed, and the steps of its last cycle.
fn orbit(facts: &OrbitFacts) -> String {
    let last = facts.cycles.last();
    let [closure, steps, films] =
        last.map_or([0.0; 3], |cycle| [cycle.closure, cycle.steps as f64, cycle.films as f64]);
    let earlier = match facts.earlier_cycles {
        0 => String::new(),
        count => format!(", {count} of them in earlier runs"),
    };
    let oil = last
        .and_then(|cycle| cycle.oil_closure)
        .map_or(String::new(), |oil| format!(" with {} of the oil elsewhere", significant(oil, 2)));
    format!(
        "orbit     cycle {}{earlier} ended {} of the clearance from where it began{oil}; {steps} steps and {films} films in it",
        facts.earlier_cycles + facts.cycles.len(),
        significant(closure, 2)
    )
}

/// How large the cavity is, and the oil that it makes where its model conserves none.
fn cavity(result: &RunResult) -> Option<String> {
    let share = significant(100.0 * result.quantity(&CAVITY_SHARE)?.value, 2);
    let made = result.quantity(&CAVITY_FLOW).filter(|made| made.value > 0.0).map(|made| {
        let (unit, size) = readable_unit(made.value, made.row.unit);
        format!(
            "; it makes {} {unit} of oil, since this cavitation model does not conserve oil",
            significant(made.value / size, 2)
        )
    });
    let names = result.of_hill.iter().map(|name| name.replace('_', " "));
    let of_hill = match names.collect::<Vec<_>>().join(" and ") {
        names if names.is_empty() => names,
        names => format!("; {names}: by the sharp hill over it"),
    };
    Some(format!("cavity    {share} % of the film{}{of_hill}", made.unwrap_or_default()))
}

/// How often the expensive operations ran; nothing where nothing was counted.
fn work(counts: Counts, solver: Option<LinearSolverFacts>) -> Option<String> {
    let work = [
        (counts.linear_solves, "linear solve"),
        (counts.factorisations, "factorisation"),
        (counts.nonlinear_iterations, "nonlinear iteration"),
    ];
    let plural = |count: usize, one: &str, many: &str| format!("{count} {}", if count == 1 { one } else { many });
    let mut counted: Vec<_> = (work.iter())
        .filter(|(count, _)| *count > 0)
        .map(|(count, what)| plural(*count, what, &format!("{what}s")))
        .collect();
    match solver.map(|solver| (solver.route, solver.steps)) {
        Some((LinearRoute::Multigrid, steps)) => {
            counted.push(format!("multigrid in {steps} steps of conjugate gradients"));
        }
        Some((LinearRoute::Switched, _)) => counted.push("by a factor, since multigrid was slow".to_owned()),
        _ => {}
    }
    if let (Some(films), Some(products)) = (counts.deflection_steps, counts.deflection_products) {
        let products = plural(products, "product", "products");
        counted.push(format!("{} and {products} with the tangent for the deflection", plural(films, "film", "films")));
    }
    if counts.levels > 0 {
        let meshes = plural(counts.levels, "coarser mesh", "coarser meshes");
        counted.push(format!("started from {meshes}"));
    }
    let mut tried = Vec::new();
    if counts.position_steps > 0 {
        let positions = plural(counts.position_steps, "position", "positions");
        tried.push(format!("{positions} of the journal"));
    }
    if counts.temperature_steps > 0 {
        tried.push(plural(counts.temperature_steps, "temperature", "temperatures"));
    }
    let counted = match tried.is_empty() {
        true => counted.join(", "),
        false => format!("{} tried; last film: {}", tried.join(" and "), counted.join(", ")),
    };
    (!counted.is_empty()).then(|| format!("work      {counted}"))
}

/// The total time, then its parts.
pub(super) fn timing(tail: &ResultTail) -> String {
    let (total, parts): (Vec<_>, Vec<_>) = tail.timing_s.iter().partition(|(part, _)| part == "total");
    let total = total.first().map_or(String::new(), |(_, seconds)| format!("{}: ", time(*seconds)));
    let parts: Vec<_> = parts.iter().map(|(part, seconds)| format!("{part} {}", time(*seconds))).collect();
    total + &parts.join(", ")
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use oilwedge_study::effects::{EFFECTS, Effects};
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, BOLT_TORQUE, LOAD, LOAD_X, Quantity, SIDE_FLOW};
    use oilwedge_study::result::{Balances, MeshFacts, RESULT_FORMAT, ResultHead, Status};

    pub(crate) fn written() -> Written<'static> {
        Written { folder: Path::new("out/shell"), files: &[], pictures: "" }
    }

    pub(crate) fn result() -> RunResult {
        RunResult {
            head: ResultHead {
                mesh_sha256: Some(String::new()),
                ..ResultHead::of(RESULT_FORMAT, ["Hole-fed shell", "", ""])
            },
            effects: Effects { simulated: EFFECTS[2..4].to_vec(), not_simulated: vec!["squeeze".into()] },
            mesh: MeshFacts { cells: 592, nodes: 1245, order: 2, min_angle_deg: 31.04 },
            quantities: vec![Quantity::new(&LOAD, 12_910.0), Quantity::new(&ATTITUDE_ANGLE, 49.29)],
            balances: Balances { mass: 1.2e-12, power: 2.5e-15, ..Balances::default() },
            counts: Counts { nonlinear_iterations: 1, factorisations: 1, linear_solves: 1, ..Counts::default() },
            tail: ResultTail { timing_s: vec![("read".into(), 0.0123), ("total".into(), 1.5)], warnings: Vec::new() },
            ..RunResult::default()
        }
    }

    #[test]
    fn a_run_is_shown_in_readable_units() {
        let text = run_report(&result(), ShownQuantities::Headlines, &Records::default(), Some(written()));
        let parts = [
            "Hole-fed shell: converged",
            "not simulated",
            "12.9100",
            "kN",
            "49.2900",
            "simulated      poiseuille  oil driven by the pressure gradient\n               couette     oil dragged",
            "force on the journal that the film carries",
            "balance   1.2e-12   oil that enters less oil that leaves",
            "592 triangles, 1245 nodes for a pressure of degree 2, smallest angle 31.0 deg",
            "1 linear solve, 1 factorisation, 1 nonlinear iteration",
            "1.50 s: read 12.3 ms",
            "out/shell: ",
        ];
        for part in parts {
            assert!(text.contains(part), "{part}:\n{text}");
        }
    }

    #[test]
    fn the_rest_is_shown_when_asked_for_and_the_verdict_is_last() {
        let mut result = result();
        result.quantities.push(Quantity::new(&LOAD_X, 12.0));
        let [short, all] = [ShownQuantities::Headlines, ShownQuantities::All]
            .map(|shown| run_report(&result, shown, &Records::default(), Some(written())));
        assert!(!short.contains("load_x") && short.contains("--all shows all 3 quantities"), "{short}");
        assert!(all.find("attitude_angle") < all.find("load_x") && all.find("load_x").is_some(), "{all}");
        for text in [short, all] {
            assert!(text.ends_with("\nverdict   converged; no warnings\n"), "{text}");
        }
    }

    #[test]
    fn a_cavity_and_coarser_meshes_are_shown() {
        let mut result = result();
        result.quantities.push(Quantity::new(&CAVITY_SHARE, 0.4237));
        result.counts.nonlinear_iterations = 12;
        for (levels, words) in [(1, "1 coarser mesh"), (3, "3 coarser meshes")] {
            result.counts.levels = levels;
            let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
            let work = format!("12 nonlinear iterations, started from {words}\n");
            assert!(text.contains(&work) && text.contains("cavity    42 % of the film\n"), "{text}");
        }
        assert!(
            !run_report(&self::result(), ShownQuantities::Headlines, &Records::default(), Some(written()))
                .contains("cavity ")
        );
    }

    #[test]
    fn the_joint_of_a_cap_has_a_table_of_its_own() {
        let mut result = result();
        result.quantities.insert(1, Quantity::new(&BOLT_TORQUE, 55.6));
        let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
        let place = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part} in\n{text}"));
        assert!(place("attitude_angle") < place("joint of the cap\n") && place("joint of the cap") < place("55.6000"));
        assert!(
            !run_report(&self::result(), ShownQuantities::Headlines, &Records::default(), Some(written()))
                .contains("cap")
        );
    }

    #[test]
    fn without_a_solution_there_is_a_reason_and_no_number() {
        let mut result = result();
        result.head.status = Status::NoSolution;
        result.head.reason = Some("no steady film above ...".into());
        result.quantities.clear();
        let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
        assert!(text.contains("there is no solution") && text.contains("reason: no steady film"), "{text}");
        assert!(!text.contains("balance"), "{text}");
    }

    #[test]
    fn rounding_is_shown_as_zero_and_control_characters_not_at_all() {
        let mut result = result();
        result.head.title = "a\u{1b}[31m".into();
        result.quantities = vec![Quantity::new(&SIDE_FLOW, -7e-22)];
        result.counts = Counts::default();
        let text = run_report(&result, ShownQuantities::Headlines, &Records::default(), Some(written()));
        assert!(text.contains("\u{2506}     0 \u{2506} ml/s"), "{text}");
        assert!(!text.contains('\u{1b}') && !text.contains("work"), "{text}");
    }
}
