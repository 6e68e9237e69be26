//! Tables for people, on stdout.

use crate::complain::Failure;
use crate::complain::printable;
use crate::cost::cost;
use crate::heat;
use crate::quantities::{bars, quantities};
use crate::readable::{readable_unit, significant};
use crate::standard::standard;
use crate::theories::theories;
use comfy_table::{CellAlignment, ContentArrangement, Table, presets};
use oilwedge_campaign::AddOns;
use oilwedge_report::check::CheckReport;
use oilwedge_study::effects::Effects;
use oilwedge_study::quantities::{self, CAVITY_FLOW, CAVITY_SHARE};
use oilwedge_study::result::{Balances, Counts, LinearSolver, MeshFacts, RunResult, Status};
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Prints a text to stdout, after the results were `written` if there are any; that the reader has gone away already
/// (`| head`) is no fault.
///
/// # Errors
/// [`Failure::Output`] where stdout cannot be written to.
pub(crate) fn print(text: &str, written: Option<&Path>) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Failure::Output {
            error,
            written: written.map(Path::to_owned),
        }),
        _ => Ok(()),
    }
}

/// Everything about a run: what was simulated, the numbers, the balances and where the time went.
pub(crate) fn run_report(result: &RunResult, add_ons: &AddOns, folder: &Path, picture: bool) -> String {
    let mut parts = vec![heading(&result.title, status(result.status))];
    if let Some(reason) = &result.reason {
        parts.push(format!("reason: {reason}"));
    }
    parts.push(effects(&result.effects));
    if !result.quantities.is_empty() {
        let (of_cap, of_film): (Vec<_>, Vec<_>) = (result.quantities.iter())
            .filter(|quantity| result.heat.is_none() || quantity.row.table != quantities::Table::Heat)
            .partition(|quantity| quantity.row.table == quantities::Table::Cap);
        parts.push(quantities(of_film, result.bars));
        if !of_cap.is_empty() {
            parts.push(format!("joint of the cap\n{}", quantities(of_cap, result.bars)));
        }
    }
    parts.extend(heat::heat(result));
    parts.extend(cost(result, add_ons));
    parts.extend(standard(add_ons));
    parts.extend(theories(add_ons));
    let mut lines = Vec::new();
    if !result.quantities.is_empty() {
        lines.extend(bars(result));
        lines.push(balances(result.balances));
    }
    lines.extend(cavity(result));
    lines.push(format!("mesh      {}", mesh(&result.mesh)));
    lines.extend(work(result.counts, result.linear_solver));
    lines.push(format!("time      {}", timing(&result.timing_s)));
    let film = if picture { ", film.vtu" } else { "" };
    let heat = if result.heat.is_some() {
        ", heat.svg, heat.png"
    } else {
        ""
    };
    lines.push(format!("written   {}: result.json{film}{heat}", folder.display()));
    parts.push(lines.join("\n"));
    parts.join("\n\n") + "\n"
}

/// How far the balances are open. A force balance is asked for only where a position is sought.
fn balances(balances: Balances) -> String {
    let mut line = format!(
        "balance   oil in and oil out differ by {} of the oil that passes",
        significant(balances.mass, 2)
    );
    line += &format!(", power and heat by {} of the power", significant(balances.power, 2));
    if balances.force != 0.0 {
        let force = significant(balances.force, 2);
        line += &format!(", load and film force by {force} of the load");
    }
    if balances.heat != 0.0 {
        let heat = significant(balances.heat, 2);
        line += &format!(", friction and heat carried off by {heat} of the friction");
    }
    line
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
                "; it makes {} {unit} of oil, for this model conserves none there",
                significant(made.value / size, 2)
            )
        });
    Some(format!("cavity    {share} % of the film{}", made.unwrap_or_default()))
}

/// What was done; nothing where nothing was counted.
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
    match solver {
        Some(LinearSolver {
            route: "multigrid",
            steps,
        }) => {
            counted.push(format!("multigrid in {steps} steps of conjugate gradients"));
        }
        Some(LinearSolver { route: "switched", .. }) => {
            counted.push("by a factor, since multigrid was slow".to_owned());
        }
        _ => {}
    }
    if counts.levels > 0 {
        let meshes = plural(counts.levels, "coarser mesh", "coarser meshes");
        counted.push(format!("started from {meshes}"));
    }
    if counts.position_steps > 0 {
        let positions = plural(counts.position_steps, "position", "positions");
        counted.push(format!("{positions} of the journal tried"));
    }
    (!counted.is_empty()).then(|| format!("work      {}", counted.join(", ")))
}

/// The whole first, then its parts.
fn timing(parts: &[(String, f64)]) -> String {
    let told: Vec<_> = (parts.iter())
        .filter(|(part, _)| part != "total")
        .map(|(part, seconds)| format!("{part} {}", time(*seconds)))
        .collect();
    let total = parts.iter().find(|(part, _)| part == "total");
    let total = total.map_or(String::new(), |(_, seconds)| format!("{}: ", time(*seconds)));
    total + &told.join(", ")
}

/// Everything about a scene or mesh that can be used.
pub(crate) fn check_report(found: &CheckReport) -> String {
    let mut parts = vec![heading(
        found.title.as_deref().unwrap_or(&found.mesh_file),
        "can be used",
    )];
    parts.extend(found.effects.as_ref().map(effects));
    if !found.liner.is_empty() {
        parts.push(printable(&found.liner.join("\n")));
        parts.push(printable(found.sketch.trim_end()));
    }
    if !found.regions.is_empty() {
        let mut table = table(["group", "kind", "size"]);
        for region in &found.regions {
            let parts = if region.kind == "curve" { "edges" } else { "triangles" };
            let size = format!("{} {parts}", region.parts);
            table.add_row([printable(&region.name), region.kind.clone(), size]);
        }
        align_right(&mut table, 2);
        parts.push(table.to_string());
    }
    parts.push(facts(found));
    parts.join("\n\n") + "\n"
}

fn facts(found: &CheckReport) -> String {
    let quality = &found.quality;
    let mut lines = vec![
        format!("mesh      {}: {}", found.mesh_file, mesh(&found.mesh)),
        format!(
            "shape     smallest angles: median {} deg; longest edge over height: worst {}, ideal 1.15; {} curved triangles; edges {} to {} mm",
            significant(quality.median_angle, 3),
            significant(quality.worst_aspect, 3),
            quality.curved_cells,
            significant(1e3 * quality.shortest_edge, 3),
            significant(1e3 * quality.longest_edge, 3),
        ),
        format!(
            "film      area {} mm2, bounded by {} closed curves",
            significant(1e6 * quality.area, 6),
            quality.boundary_loops
        ),
    ];
    lines.extend(tolerance(&found.tolerance));
    lines.extend(sweep(&found.sweep));
    lines.extend(found.cost.map(|cost| {
        let factor = significant(8e-6 * cost.factor_entries as f64, 3);
        format!(
            "cost      {} unknown pressures, {factor} MB for the factorised matrix",
            cost.unknowns
        )
    }));
    lines.join("\n")
}

/// How small error bars shall become; nothing without a tolerance.
fn tolerance(targets: &[(String, f64)]) -> Option<String> {
    let told: Vec<_> = (targets.iter())
        .map(|(name, relative)| {
            let percent = 100.0 * relative;
            match name.contains("angle") {
                true => format!("{} to {percent} % of 1 rad", printable(name)),
                false => format!("{} to {percent} %", printable(name)),
            }
        })
        .collect();
    (!told.is_empty()).then(|| format!("tolerance {}", told.join(", ")))
}

/// The cases of a sweep; nothing without one.
fn sweep(axes: &[(String, usize)]) -> Option<String> {
    let cases: usize = axes.iter().map(|(_, values)| values).product();
    let told: Vec<_> = (axes.iter())
        .map(|(name, values)| format!("{values} of {}", printable(name)))
        .collect();
    (!axes.is_empty()).then(|| format!("sweep     {cases} cases: {}", told.join(" by ")))
}

pub(crate) fn heading(title: &str, status: &str) -> String {
    format!("{}: {status}", printable(title))
}

pub(crate) fn status(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::NoSolution => "there is no solution",
        Status::NotConverged => "not converged",
    }
}

fn mesh(facts: &MeshFacts) -> String {
    let MeshFacts {
        cells,
        nodes,
        order,
        min_angle_deg,
    } = facts;
    format!(
        "{cells} triangles, {nodes} nodes for a pressure of degree {order}, smallest angle {} deg",
        significant(*min_angle_deg, 3)
    )
}

pub(crate) fn effects(effects: &Effects) -> String {
    let width = effects.simulated.iter().map(|effect| effect.name.len()).max();
    let width = width.unwrap_or(0);
    let simulated: Vec<_> = (effects.simulated.iter())
        .map(|effect| format!("{:width$}  {}", effect.name, effect.sentence))
        .collect();
    format!(
        "simulated      {}\nnot simulated  {}",
        simulated.join("\n               "),
        effects.not_simulated.join(", ")
    )
}

/// An empty table with this header.
pub(crate) fn table<const N: usize>(header: [&str; N]) -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::UTF8_FULL_CONDENSED)
        .set_content_arrangement(ContentArrangement::Dynamic);
    table.set_header(header);
    table
}

/// Numbers stand under each other.
pub(crate) fn align_right(table: &mut Table, column: usize) {
    if let Some(column) = table.column_mut(column) {
        column.set_cell_alignment(CellAlignment::Right);
    }
}

/// Seconds, or milliseconds where they are few.
pub(crate) fn time(seconds: f64) -> String {
    match seconds < 1.0 {
        true => format!("{} ms", significant(1e3 * seconds, 3)),
        false => format!("{} s", significant(seconds, 3)),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use oilwedge_report::check::{CHECK_FORMAT, RegionFacts};
    use oilwedge_study::effects::EFFECTS;
    use oilwedge_study::quantities::{ATTITUDE_ANGLE, BOLT_TORQUE, LOAD, Quantity, SIDE_FLOW};
    use oilwedge_study::result::RESULT_FORMAT;

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
                force: 0.0,
                heat: 0.0,
            },
            regime: None,
            heat: None,
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
    fn a_run_is_told_in_readable_units() {
        let text = run_report(&result(), &AddOns::default(), Path::new("out/shell"), true);
        let parts = [
            "Hole-fed shell: converged",
            "not simulated",
            "12.9100",
            "kN",
            "49.2900",
            "simulated      poiseuille  oil driven by the pressure gradient\n               couette     oil dragged",
            "force that the film carries",
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
    fn a_cavity_and_coarser_meshes_are_told() {
        let mut result = result();
        result.quantities.push(Quantity::new(&CAVITY_SHARE, 0.4237));
        result.counts.nonlinear_iterations = 12;
        for (levels, told) in [(1, "1 coarser mesh"), (3, "3 coarser meshes")] {
            result.counts.levels = levels;
            let text = run_report(&result, &AddOns::default(), Path::new("out"), true);
            let work = format!("12 nonlinear iterations, started from {told}\n");
            assert!(
                text.contains(&work) && text.contains("cavity    42 % of the film\n"),
                "{text}"
            );
        }
        assert!(!run_report(&self::result(), &AddOns::default(), Path::new("out"), true).contains("cavity "));
    }

    #[test]
    fn the_joint_of_a_cap_has_a_table_of_its_own() {
        let mut result = result();
        result.quantities.insert(1, Quantity::new(&BOLT_TORQUE, 55.6));
        let text = run_report(&result, &AddOns::default(), Path::new("out"), true);
        let place = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part} in\n{text}"));
        assert!(place("attitude_angle") < place("joint of the cap\n") && place("joint of the cap") < place("55.6000"));
        assert!(!run_report(&self::result(), &AddOns::default(), Path::new("out"), true).contains("cap"));
    }

    #[test]
    fn without_a_solution_there_is_a_reason_and_no_number() {
        let mut result = result();
        result.status = Status::NoSolution;
        result.reason = Some("no steady film above ...".into());
        result.quantities.clear();
        let text = run_report(&result, &AddOns::default(), Path::new("out/shell"), false);
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
        let text = run_report(&result, &AddOns::default(), Path::new("out"), true);
        assert!(text.contains("\u{2506}     0 \u{2506} ml/s"), "{text}");
        assert!(!text.contains('\u{1b}') && !text.contains("work"), "{text}");
    }

    #[test]
    fn a_mesh_is_told_by_its_regions() {
        let regions = vec![RegionFacts {
            name: "end_low".into(),
            kind: "curve".into(),
            parts: 24,
        }];
        let found = CheckReport {
            format: CHECK_FORMAT.into(),
            title: None,
            mesh_file: "liner.msh".into(),
            effects: None,
            mesh: MeshFacts::default(),
            tolerance: vec![("load".into(), 0.001), ("attitude_angle".into(), 1e-4)],
            sweep: vec![("speed [rpm]".into(), 5), ("eccentricity".into(), 18)],
            liner: Vec::new(),
            sketch: String::new(),
            quality: Default::default(),
            regions,
            cost: None,
            warnings: vec![],
        };
        let text = check_report(&found);
        assert!(
            text.contains("liner.msh: can be used") && text.contains("end_low"),
            "{text}"
        );
        let tolerance = "tolerance load to 0.1 %, attitude_angle to 0.01 % of 1 rad\n";
        assert!(text.contains(tolerance), "{text}");
        let sweep = "sweep     90 cases: 5 of speed [rpm] by 18 of eccentricity\n";
        assert!(text.contains(sweep), "{text}");
    }
}
