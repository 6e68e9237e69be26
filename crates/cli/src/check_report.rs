//! A scene or mesh that can be used, for people.

use crate::readable::significant;
use oilwedge_report::check::CheckReport;
use oilwedge_report::sheet::{Sheet, numeral, text};
use oilwedge_report::sweep::ToleranceRecord;
use oilwedge_report::tables::{duration, effects, heading, mesh, printable};

/// Everything about a scene or mesh that can be used.
pub(crate) fn check_report(found: &CheckReport) -> String {
    let mut parts = vec![heading(found.title.as_deref().unwrap_or(&found.mesh_file), "can be used")];
    parts.extend(found.effects.as_ref().map(effects));
    if !found.liner.is_empty() {
        parts.push(printable(&found.liner.join("\n")));
        parts.push(printable(found.sketch.trim_end()));
    }
    if !found.regions.is_empty() {
        let rows = found.regions.iter().map(|region| {
            let parts = if region.kind == "curve" { "edges" } else { "triangles" };
            vec![text(&region.name), text(&region.kind), numeral(format!("{} {parts}", region.parts))]
        });
        parts.push(Sheet::new("", ["group", "kind", "size"], rows.collect()).terminal());
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
    lines.extend(key_tolerances(&found.key_tolerances));
    lines.extend(sweep(&found.sweep));
    lines.extend((!found.design.is_empty()).then(|| format!("design    {}", printable(&found.design.join("; ")))));
    lines.extend(found.cost.map(|cost| {
        let factor = significant(8e-6 * cost.factor_entries as f64, 3);
        format!("cost      {} unknown pressures, {factor} MB for the factorised matrix", cost.unknowns)
            + &orbit_words(cost.orbit_seconds)
    }));
    lines.join("\n")
}

/// The processor time of an orbit, of which the order of magnitude is known; nothing without one.
fn orbit_words(seconds: Option<f64>) -> String {
    seconds.map_or(String::new(), |seconds| format!("; the orbit takes some {} of processor time", duration(seconds)))
}

/// The error bars wanted; nothing without a tolerance.
fn tolerance(targets: &[(String, f64)]) -> Option<String> {
    let parts: Vec<_> = (targets.iter())
        .map(|(name, relative)| {
            let percent = 100.0 * relative;
            match name.contains("angle") {
                true => format!("{} to {percent} % of 1 rad", printable(name)),
                false => format!("{} to {percent} %", printable(name)),
            }
        })
        .collect();
    (!parts.is_empty()).then(|| format!("tolerance {}", parts.join(", ")))
}

/// The tolerances of numbers of the scene; nothing without one.
fn key_tolerances(tolerances: &[ToleranceRecord]) -> Option<String> {
    let parts: Vec<_> = tolerances.iter().map(|it| printable(&it.told())).collect();
    (!parts.is_empty()).then(|| format!("widths    {}", parts.join(", ")))
}

/// The cases of a sweep; nothing without one.
fn sweep(axes: &[(String, usize)]) -> Option<String> {
    let cases: usize = axes.iter().map(|(_, values)| values).product();
    let parts: Vec<_> = (axes.iter()).map(|(name, values)| format!("{values} of {}", printable(name))).collect();
    (!axes.is_empty()).then(|| format!("sweep     {cases} cases: {}", parts.join(" by ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_report::check::{CHECK_FORMAT, RegionFacts};
    use oilwedge_study::result::MeshFacts;

    #[test]
    fn a_mesh_is_shown_with_its_regions() {
        let regions = vec![RegionFacts { name: "end_low".into(), kind: "curve".into(), parts: 24 }];
        let found = CheckReport {
            format: CHECK_FORMAT.into(),
            title: None,
            mesh_file: "liner.msh".into(),
            effects: None,
            mesh: MeshFacts::default(),
            tolerance: vec![("load".into(), 0.001), ("attitude_angle".into(), 1e-4)],
            key_tolerances: vec![ToleranceRecord {
                key: "bearing.clearance".into(),
                nominal: 27.000000000000004,
                half_width: 3.0,
                unit: "um".into(),
            }],
            sweep: vec![("speed [rpm]".into(), 5), ("eccentricity".into(), 18)],
            design: Vec::new(),
            liner: Vec::new(),
            sketch: String::new(),
            quality: Default::default(),
            regions,
            cost: None,
            warnings: vec![],
        };
        let text = check_report(&found);
        assert!(text.contains("liner.msh: can be used") && text.contains("end_low"), "{text}");
        let tolerance = "tolerance load to 0.1 %, attitude_angle to 0.01 % of 1 rad\n";
        assert!(text.contains(tolerance), "{text}");
        assert!(text.contains("widths    bearing.clearance 27 +- 3 um\n"), "{text}");
        let sweep = "sweep     90 cases: 5 of speed [rpm] by 18 of eccentricity\n";
        assert!(text.contains(sweep), "{text}");
    }
}
