//! A run for people: what was simulated, the numbers, the balances and the time.

use crate::add_ons::add_on;
use crate::quantities::{bars, quantities};
use crate::readable::{readable_unit, significant};
use crate::temperature;
use crate::terminal::{effects, heading, mesh, status, time};
use oilwedge_campaign::AddOn;
use oilwedge_study::quantities::{CAVITY_FLOW, CAVITY_SHARE, Table};
use oilwedge_study::result::{Balances, Counts, LinearSolver, RunResult};
use std::path::Path;

/// Everything about a run: what was simulated, the numbers, the balances and where the time went.
pub(crate) fn run_report(result: &RunResult, add_ons: &[AddOn], folder: &Path, picture: bool) -> String {
    let mut parts = vec![heading(&result.title, status(result.status))];
    if let Some(reason) = &result.reason {
        parts.push(format!("reason: {reason}"));
    }
    parts.push(effects(&result.effects));
    if !result.quantities.is_empty() {
        let (of_cap, of_film): (Vec<_>, Vec<_>) = (result.quantities.iter())
            .filter(|quantity| !temperature::shows(result, quantity))
            .partition(|quantity| quantity.row.table == Table::Cap);
        parts.push(quantities(of_film, result.bars));
        if !of_cap.is_empty() {
            parts.push(format!("joint of the cap\n{}", quantities(of_cap, result.bars)));
        }
    }
    parts.extend(temperature::balance(result));
    parts.extend(add_ons.iter().map(add_on));
    let mut lines = Vec::new();
    if !result.quantities.is_empty() {
        lines.extend(bars(result));
        lines.push(balances(result.balances));
    }
    lines.extend(cavity(result));
    lines.push(format!("mesh      {}", mesh(&result.mesh)));
    lines.extend(work(result.counts, result.linear_solver));
    lines.push(format!("time      {}", timing(&result.timing_s)));
    let mut files = vec!["result.json"];
    files.extend(picture.then_some("film.vtu"));
    files.extend(temperature::files(result));
    lines.push(format!("written   {}: {}", folder.display(), files.join(", ")));
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

/// Relative imbalances; those of force and temperature only where they are solved for.
fn balances(balances: Balances) -> String {
    let part = |value: f64| significant(value, 2);
    let mut line = format!(
        "balance   oil in and oil out differ by {} of the oil that passes, power and dissipation by {} of the power",
        part(balances.mass),
        part(balances.power)
    );
    if balances.moment != 0.0 {
        line += &format!(
            ", moments of friction and load by {} of the friction",
            part(balances.moment)
        );
    }
    if balances.force != 0.0 {
        line += &format!(", load and film force by {} of the load", part(balances.force));
    }
    line + &temperature::imbalance(balances)
}

/// How large the cavity is, and the oil that it makes where its model conserves none.
fn cavity(result: &RunResult) -> Option<String> {
    let share = significant(100.0 * result.quantity(&CAVITY_SHARE)?.value, 2);
    let made = result
        .quantity(&CAVITY_FLOW)
        .filter(|made| made.value > 0.0)
        .map(|made| {
            let (unit, size) = readable_unit(made.value, made.unit());
            format!(
                "; it makes {} {unit} of oil, since this cavitation model does not conserve oil",
                significant(made.value / size, 2)
            )
        });
    Some(format!("cavity    {share} % of the film{}", made.unwrap_or_default()))
}

/// How often the expensive operations ran; nothing where nothing was counted.
fn work(counts: Counts, solver: Option<LinearSolver>) -> Option<String> {
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
        Some(("multigrid", steps)) => counted.push(format!("multigrid in {steps} steps of conjugate gradients")),
        Some(("switched", _)) => counted.push("by a factor, since multigrid was slow".to_owned()),
        _ => {}
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
fn timing(parts: &[(String, f64)]) -> String {
    let (total, parts): (Vec<_>, Vec<_>) = parts.iter().partition(|(part, _)| part == "total");
    let total = total
        .first()
        .map_or(String::new(), |(_, seconds)| format!("{}: ", time(*seconds)));
    let parts: Vec<_> = parts
        .iter()
        .map(|(part, seconds)| format!("{part} {}", time(*seconds)))
        .collect();
    total + &parts.join(", ")
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use oilwedge_study::effects::{EFFECTS, Effects};
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, BOLT_TORQUE, LOAD, Quantity, SIDE_FLOW};
    use oilwedge_study::result::{MeshFacts, RESULT_FORMAT, Status};

    pub(crate) fn result() -> RunResult {
        RunResult {
            format: RESULT_FORMAT.into(),
            title: "Hole-fed shell".into(),
            version: "0.1.0".into(),
            scene_sha256: String::new(),
            mesh_sha256: String::new(),
            status: Status::Converged,
            reason: None,
            effects: Effects {
                simulated: EFFECTS[2..4].to_vec(),
                not_simulated: vec!["squeeze"],
            },
            mesh: MeshFacts {
                cells: 592,
                nodes: 1245,
                order: 2,
                min_angle_deg: 31.04,
            },
            quantities: vec![Quantity::new(&LOAD, 12_910.0), Quantity::new(&ATTITUDE_ANGLE, 49.29)],
            bars: false,
            levels: vec![],
            balances: Balances {
                mass: 1.2e-12,
                power: 2.5e-15,
                moment: 0.0,
                force: 0.0,
                thermal: 0.0,
            },
            regime: None,
            temperature: None,
            history: vec![],
            counts: Counts {
                nonlinear_iterations: 1,
                factorisations: 1,
                linear_solves: 1,
                ..Counts::default()
            },
            linear_solver: None,
            timing_s: vec![("read".into(), 0.0123), ("total".into(), 1.5)],
            warnings: vec![],
        }
    }

    #[test]
    fn a_run_is_shown_in_readable_units() {
        let text = run_report(&result(), &[], Path::new("out/shell"), true);
        let parts = [
            "Hole-fed shell: converged",
            "not simulated",
            "12.9100",
            "kN",
            "49.2900",
            "simulated      poiseuille  oil driven by the pressure gradient\n               couette     oil dragged",
            "force on the journal that the film carries",
            "differ by 1.2e-12 of",
            "592 triangles, 1245 nodes for a pressure of degree 2, smallest angle 31.0 deg",
            "1 linear solve, 1 factorisation, 1 nonlinear iteration",
            "1.50 s: read 12.3 ms",
            "out/shell: result.json, film.vtu",
        ];
        for part in parts {
            assert!(text.contains(part), "{part}:\n{text}");
        }
    }

    #[test]
    fn a_cavity_and_coarser_meshes_are_shown() {
        let mut result = result();
        result.quantities.push(Quantity::new(&CAVITY_SHARE, 0.4237));
        result.counts.nonlinear_iterations = 12;
        for (levels, words) in [(1, "1 coarser mesh"), (3, "3 coarser meshes")] {
            result.counts.levels = levels;
            let text = run_report(&result, &[], Path::new("out"), true);
            let work = format!("12 nonlinear iterations, started from {words}\n");
            assert!(
                text.contains(&work) && text.contains("cavity    42 % of the film\n"),
                "{text}"
            );
        }
        assert!(!run_report(&self::result(), &[], Path::new("out"), true).contains("cavity "));
    }

    #[test]
    fn the_joint_of_a_cap_has_a_table_of_its_own() {
        let mut result = result();
        result.quantities.insert(1, Quantity::new(&BOLT_TORQUE, 55.6));
        let text = run_report(&result, &[], Path::new("out"), true);
        let place = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part} in\n{text}"));
        assert!(place("attitude_angle") < place("joint of the cap\n") && place("joint of the cap") < place("55.6000"));
        assert!(!run_report(&self::result(), &[], Path::new("out"), true).contains("cap"));
    }

    #[test]
    fn without_a_solution_there_is_a_reason_and_no_number() {
        let mut result = result();
        result.status = Status::NoSolution;
        result.reason = Some("no steady film above ...".into());
        result.quantities.clear();
        let text = run_report(&result, &[], Path::new("out/shell"), false);
        assert!(
            text.contains("there is no solution") && text.contains("reason: no steady film"),
            "{text}"
        );
        assert!(!text.contains("balance") && !text.contains("film.vtu"), "{text}");
    }

    #[test]
    fn rounding_is_shown_as_zero_and_control_characters_not_at_all() {
        let mut result = result();
        result.title = "a\u{1b}[31m".into();
        result.quantities = vec![Quantity::new(&SIDE_FLOW, -7e-22)];
        result.counts = Counts::default();
        let text = run_report(&result, &[], Path::new("out"), true);
        assert!(text.contains("\u{2506}     0 \u{2506} ml/s"), "{text}");
        assert!(!text.contains('\u{1b}') && !text.contains("work"), "{text}");
    }
}
