//! The key `tolerance` of `[mesh]`: a percentage, or a table of percentages by name of quantity.

use crate::reader::TableReader;
use crate::scene::{Target, Tolerance};
use crate::unit::Dimension;

/// Quantities that can have a tolerance, but for the flows of feeds.
const QUANTITIES: [&str; 16] = [
    "load",
    "load_x",
    "load_y",
    "load_angle",
    "load_coefficient",
    "sommerfeld_number",
    "attitude_angle",
    "eccentricity",
    "min_film_angle",
    "pressure_max",
    "film_thickness_min",
    "side_flow",
    "inlet_flow",
    "friction_torque",
    "friction_coefficient",
    "friction_power",
];
/// Below the flows of feeds in the report.
const LAST: &str = "pressure_integral";
/// The flow of the feed GROUP is `feed_flow.GROUP`, which TOML reads as a table unless it is quoted.
const FEEDS: &str = "feed_flow";
const QUOTED_FEED: &str = "feed_flow.";

const KEY: &str = "tolerance";
const EXAMPLE: &str = "0.1 %";

/// Reads the key of `[mesh]`, if it is written.
pub(super) fn read(mesh: &mut TableReader<'_>, under_load: bool) -> Option<Tolerance> {
    if !mesh.has(KEY) {
        return None;
    }
    if !mesh.holds_table(KEY) {
        let relative = mesh.quantity_if_given(KEY, Dimension::Ratio, EXAMPLE)?;
        return Some(Tolerance::of_main_quantity(relative, under_load, true));
    }
    let table = mesh.table_if_given(KEY)?;
    if table.keys().is_empty() {
        let help = "write tolerance = { load = \"0.1 %\", pressure_max = \"1 %\" }, or tolerance = \"0.1 %\"";
        mesh.complain(KEY, "names no quantity", help);
    }
    Some(Tolerance {
        targets: by_name(table),
        is_given: true,
    })
}

fn by_name<'a>(mut table: TableReader<'a>) -> Vec<Target> {
    let mut targets = Vec::new();
    let mut add = |table: &mut TableReader<'a>, key: &'a str, quantity: String| {
        let relative = table.quantity_if_given(key, Dimension::Ratio, EXAMPLE);
        targets.extend(relative.map(|relative| Target { quantity, relative }));
    };
    for name in QUANTITIES {
        add(&mut table, name, name.to_owned());
    }
    if let Some(mut feeds) = table.table_if_given(FEEDS) {
        for group in feeds.keys() {
            add(&mut feeds, group, format!("{QUOTED_FEED}{group}"));
        }
        feeds.finish();
    }
    let quoted = table.keys().into_iter().filter(|key| key.starts_with(QUOTED_FEED));
    for name in quoted {
        add(&mut table, name, name.to_owned());
    }
    add(&mut table, LAST, LAST.to_owned());
    table.finish();
    targets
}

#[cfg(test)]
mod tests {
    use crate::scene::MeshSource;
    use crate::schema::tests::{STUDY, read, told, told_one};

    const FILE: &str = "file = \"../meshes/shell.msh\", unit = \"mm\"";
    const POSITION: &str = ", eccentricity = 0.6, min_film_angle = \"180 deg\"";

    /// Targets of the study with these keys in `[mesh]`, and whether the scene gives them.
    fn targets(mesh: &str, loaded: bool) -> Option<(Vec<(String, f64)>, bool)> {
        let mut text = STUDY.replacen(FILE, mesh, 1);
        if loaded {
            text = format!(
                "load = {{ force = \"5 kN\", angle = \"270 deg\" }}{}",
                text.replacen(POSITION, "", 1)
            );
        }
        let scene = read(&text).unwrap_or_else(|error| panic!("{error}"));
        let tolerance = scene.tolerance?;
        let targets = tolerance.targets.into_iter().map(|it| (it.quantity, it.relative));
        Some((targets.collect(), tolerance.is_given))
    }

    #[test]
    fn a_percentage_is_that_of_the_load_or_of_the_eccentricity() {
        let one = |name: &str, relative: f64, is_given| Some((vec![(name.to_owned(), relative)], is_given));
        assert_eq!(targets("tolerance = \"0.1 %\"", false), one("load", 0.1 * 0.01, true));
        assert_eq!(
            targets("tolerance = \"20 ppm\"", true),
            one("eccentricity", 20.0 * 1e-6, true)
        );
        assert_eq!(targets("", false), one("load", 0.005, false));
        assert_eq!(targets("", true), one("eccentricity", 0.005, false));
        assert_eq!(targets("size = \"3 mm\"", false), None);
        assert_eq!(targets(FILE, true), None);
        let beside = "size = \"3 mm\", tolerance = \"1 %\"";
        assert_eq!(targets(beside, false), one("load", 0.01, true));
        let scene = read(&STUDY.replacen(FILE, beside, 1)).expect("a scene");
        assert_eq!(scene.mesh, MeshSource::Drawing { size: Some(0.003) });
        let beside = format!("{FILE}, tolerance = \"1 %\"");
        assert_eq!(targets(&beside, false), one("load", 0.01, true));
    }

    #[test]
    fn a_table_goes_by_name() {
        let names = |table: &str| {
            let (targets, _) = targets(&format!("tolerance = {{ {table} }}"), false).expect("a tolerance");
            targets
        };
        let several = names("pressure_max = \"1 %\", load = \"0.1 %\", attitude_angle = \"0.01 %\"");
        let wanted = [
            ("load", 0.1 * 0.01),
            ("attitude_angle", 0.01 * 0.01),
            ("pressure_max", 0.01),
        ];
        assert_eq!(several, wanted.map(|(name, relative)| (name.to_owned(), relative)));
        for flow in ["feed_flow.feed_hole = \"2 %\"", "\"feed_flow.feed_hole\" = \"2 %\""] {
            assert_eq!(names(flow), [("feed_flow.feed_hole".to_owned(), 0.02)]);
        }
    }

    #[test]
    fn what_is_no_tolerance_is_refused() {
        let one = |tolerance: &str, wanted: &str| told_one(FILE, &format!("tolerance = {tolerance}"), wanted);
        one("0.001", "mesh.tolerance: a bare number has no unit; a ratio is wanted");
        one("\"0.001\"", "mesh.tolerance: \"0.001\" has no unit; a ratio is wanted");
        one("{}", "mesh.tolerance: names no quantity");
        one("{ load = 0.1 }", "mesh.tolerance.load: a bare number has no unit");
        one("{ laod = \"1 %\" }", "mesh.tolerance.laod: this key is not known");
        one("{ feed_flow = \"1 %\" }", "mesh.tolerance.feed_flow: a table is wanted");
        one(
            "{ pressure_min = \"1 %\" }",
            "mesh.tolerance.pressure_min: this key is not known",
        );
        let help = |name: &str| {
            told(FILE, &format!("tolerance = {{ {name} = \"1 %\" }}"))[0]
                .help
                .clone()
        };
        assert_eq!(help("laod"), "did you mean \"load\"?");
        assert!(help("friction").starts_with("known here: attitude_angle, eccentricity, feed_flow, film_"));
    }
}
