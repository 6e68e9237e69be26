//! The page `docs/validation/flexpde_study.md`: films of the FlexPDE study beside their independent recomputation.

use oilwedge_tests::flexpde_study::{SUPPLY_PRESSURE, limits, rows};
use oilwedge_tests::scenes::{Solved, solve, variant};

use crate::tables::{head, replace, row};

/// The page `docs/validation/flexpde_study.md` with its tables computed anew.
pub fn page(page: &str) -> String {
    let page = replace(page, "results", &results_table());
    let page = replace(&page, "limits", &limits_table());
    replace(&page, "mesh", &mesh_table())
}

fn results_table() -> Vec<Vec<String>> {
    let mut table = vec![head(
        "film | viscosity | cavitation | C_w | reference | attitude | reference | p_max | p_min | \
         mu_max/mu0 | feed flow [ml/s] | in - out",
    )];
    for case in rows().iter().filter(|case| case.reference("digits") == Some(8.0)) {
        let Ok(solved) = solve(&case.scene()) else { continue };
        let at_rest = if case.omega == 0.0 { " at rest" } else { "" };
        let reference = |key: &str, digits: usize| {
            let value = case.reference(key);
            value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
        };
        table.push(vec![
            format!("{}{at_rest}", case.liner),
            case.viscosity.clone(),
            case.cavitation.clone(),
            format!("{:.4}", solved.quantity("load_coefficient")),
            reference("C_w", 4),
            format!("{:.3}", solved.quantity("attitude_angle")),
            reference("attitude_deg", 3),
            format!("{:.3}", solved.quantity("pressure_max") / SUPPLY_PRESSURE),
            format!("{:.3}", solved.quantity("pressure_min") / SUPPLY_PRESSURE),
            format!("{:.4}", solved.quantity("viscosity_max") / case.mu0),
            format!("{:.4}", 1e6 * solved.quantity("feed_flow.feed_hole")),
            imbalance(&solved),
        ]);
    }
    table
}

/// Oil that the equation or a cavity makes. Rounding is not worth digits that differ between machines.
fn imbalance(solved: &Solved) -> String {
    let flows = &solved.measured.flows;
    let net: f64 = flows.regions.iter().map(|region| region.net).sum();
    match (net - flows.taken_up).abs() / flows.throughput {
        small if small < 1e-10 => "< 1e-10".to_owned(),
        part => format!("{:.2} %", 100.0 * part),
    }
}

fn limits_table() -> Vec<Vec<String>> {
    let mut table =
        vec![head("film | eccentricity | greatest speed, conservative [rad/s] | reference | as printed | reference")];
    for limit in limits() {
        let ([conservative, found], [as_printed, fold]) = (limit.conservative, limit.as_printed);
        table.push(vec![
            limit.liner.clone(),
            limit.eccentricity.to_string(),
            format!("{found:.1}"),
            format!("{conservative:.1}"),
            format!("{fold:.1}"),
            format!("{as_printed:.1}"),
        ]);
    }
    table
}

fn mesh_table() -> Vec<Vec<String>> {
    let mut table = vec![row(["mesh", "cells", "nodes", "C_w", "off the reference 20.8795", "attitude"])];
    for name in ["08_flexpde_study_size", "02_flexpde_shell"] {
        let solved = match solve(&variant(name, |_| ())) {
            Ok(solved) => solved,
            Err(reason) => panic!("{name}: {reason}"),
        };
        let mesh = solved.study.system.space().mesh();
        let c_w = solved.quantity("load_coefficient");
        table.push(vec![
            format!("scene {name}"),
            mesh.triangles().len().to_string(),
            mesh.quadratic_nodes().to_string(),
            format!("{c_w:.4}"),
            format!("{:.4} %", 100.0 * (c_w / 20.8795 - 1.0)),
            format!("{:.3}", solved.quantity("attitude_angle")),
        ]);
    }
    table
}
