//! The key `tolerance` of `[mesh]`: a ratio, or a table of ratios by name of quantity.

use crate::Scene;
use crate::reader::TableReader;
use crate::wording::percent;

const KEY: &str = "tolerance";

/// Which error bars must become how small by refinement of the mesh.
#[derive(Debug, Clone, PartialEq)]
pub enum Tolerance {
    /// The scene gives neither a mesh nor a tolerance: the usual bar of the main quantity, where bars are wanted.
    Usual,
    /// Tolerance of the main quantity relative to its value [1].
    Main(f64),
    /// One for each of these quantities, in the order of the text; never empty.
    ByName(Vec<Target>),
}

/// How small one error bar must become.
#[derive(Debug, Clone, PartialEq)]
pub struct Target {
    /// Name of a quantity of the result; that of a region with its group, as `feed_flow.feed_hole`.
    pub quantity: String,
    /// Half width of its bar relative to its value; to 1 rad for angles.
    pub relative: f64,
}

impl Scene {
    /// Removes the tolerance of a quantity that the scene no longer has.
    pub fn remove_tolerance(&mut self, quantity: &str) {
        if let Some(Tolerance::ByName(targets)) = &mut self.tolerance {
            targets.retain(|target| target.quantity != quantity);
            if targets.is_empty() {
                self.tolerance = None;
            }
        }
    }
}

/// Reads the key of `[mesh]`, if it is written.
pub(crate) fn read(mesh: &mut TableReader<'_>) -> Option<Tolerance> {
    if !mesh.holds_table(KEY) {
        return ratio(mesh, KEY).map(Tolerance::Main);
    }
    let table = mesh.table_if_given(KEY)?;
    if table.keys().is_empty() {
        let help = "write tolerance = { load = \"0.1 %\", pressure_max = \"1 %\" }, or tolerance = \"0.1 %\"";
        table.complain_here("names no quantity", help);
    }
    let mut targets = Vec::new();
    by_name(table, "", &mut targets);
    Some(Tolerance::ByName(targets))
}

fn ratio<'a>(table: &mut TableReader<'a>, key: &'a str) -> Option<f64> {
    let message = |ratio: f64, [least, _]: [f64; 2]| match ratio < least {
        // Round-off hides smaller errors, and a longer bar has no meaning.
        true => format!("is {}, but round-off hides errors below {}", percent(ratio), percent(least)),
        false => format!("is {}, and a number with such an error tells nothing", percent(ratio)),
    };
    let help = "give a tolerance within 1e-8 % and 50 %, for example \"0.1 %\"";
    table.number(key).within_or(message, help).given()
}

/// Reads a table of quantities whose names begin with `prefix`: TOML reads `feed_flow.GROUP` as a table unless it is
/// quoted.
fn by_name(mut table: TableReader<'_>, prefix: &str, targets: &mut Vec<Target>) {
    for key in table.keys() {
        let quantity = format!("{prefix}{key}");
        if table.holds_table(key) {
            if let Some(inner) = table.table_if_given(key) {
                by_name(inner, &format!("{quantity}."), targets);
            }
            continue;
        }
        let Some(relative) = ratio(&mut table, key) else {
            continue;
        };
        let twice = targets.iter().any(|target| target.quantity == quantity);
        table.refuse_if(twice, key, "is given twice", "give each quantity one tolerance");
        targets.push(Target { quantity, relative });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::tests::good;

    const FILE: &str = "file = \"liner.msh\"";

    fn with(tolerance: &str) -> String {
        format!("{FILE}\ntolerance = {tolerance}")
    }

    #[test]
    fn bounds_are_checked() {
        for good in ["\"50 %\"", "\"1e-8 %\"", "{ load = \"0.1 %\", side_flow = \"1 %\" }"] {
            assert!(good::told(FILE, &with(good)).is_empty(), "{good}");
        }
        good::told_one(FILE, &with("\"51 %\""), "mesh.tolerance: is 51 %, and a number with such an error");
        good::told_one(FILE, &with("\"0 %\""), "mesh.tolerance: is 0 %, but round-off hides errors below 1e-8 %");
        good::told_one(FILE, &with("\"-1 %\""), "mesh.tolerance: is -1 %");
        good::told_one(FILE, &with("{ side_flow = \"60 %\" }"), "mesh.tolerance.side_flow: is 60 %");
        let twice = "{ feed_flow.feed_hole = \"1 %\", \"feed_flow.feed_hole\" = \"1 %\" }";
        good::told_one(FILE, &with(twice), "mesh.tolerance.feed_flow.feed_hole: is given twice");
    }

    #[test]
    fn a_tolerance_is_a_ratio_or_goes_by_name() {
        let tolerance = |mesh: &str| good::with(&[(FILE, mesh)]).expect("a scene").tolerance;
        let by_name = |list: &[(&str, f64)]| {
            let target = |(name, relative): &(&str, f64)| Target { quantity: (*name).to_owned(), relative: *relative };
            Some(Tolerance::ByName(list.iter().map(target).collect()))
        };
        assert_eq!(tolerance("size = \"3 mm\"\ntolerance = \"1 %\""), Some(Tolerance::Main(0.01)));
        assert_eq!(tolerance(&with("\"20 ppm\"")), Some(Tolerance::Main(20.0 * 1e-6)));
        assert_eq!(tolerance(""), Some(Tolerance::Usual));
        assert_eq!((tolerance("size = \"3 mm\""), tolerance(FILE)), (None, None));
        let several = tolerance(&with("{ pressure_max = \"1 %\", load = \"2 %\" }"));
        assert_eq!(several, by_name(&[("pressure_max", 0.01), ("load", 0.02)]));
        for flow in ["feed_flow.feed_hole = \"2 %\"", "\"feed_flow.feed_hole\" = \"2 %\""] {
            assert_eq!(tolerance(&with(&format!("{{ {flow} }}"))), by_name(&[("feed_flow.feed_hole", 0.02)]));
        }
        let mut scene = good::with(&[(FILE, &with("{ load = \"2 %\" }"))]).expect("a scene");
        scene.remove_tolerance("load");
        assert_eq!(scene.tolerance, None);
    }

    #[test]
    fn what_is_no_tolerance_is_refused() {
        let one = |tolerance: &str, wanted: &str| good::told_one(FILE, &with(tolerance), wanted);
        one("0.001", "mesh.tolerance: a bare number has no unit; a ratio is wanted");
        one("\"0.001\"", "mesh.tolerance: \"0.001\" has no unit; a ratio is wanted");
        one("{}", "mesh.tolerance: names no quantity");
        one("{ load = 0.1 }", "mesh.tolerance.load: a bare number has no unit");
    }
}
