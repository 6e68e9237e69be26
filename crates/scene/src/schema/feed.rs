//! The keys of `[[feed]]`: holes, grooves and pockets.

use crate::reader::TableReader;
use crate::scene::{Arc, Engine, Feed, Groove, Hole};
use crate::unit::Dimension;
use std::f64::consts::TAU;

/// An engine has a usual pressure, where neither that nor a depth is written.
pub(super) fn read(mut table: TableReader<'_>, engine: Option<Engine>) -> Feed {
    let usual = engine.filter(|_| !table.has("pressure") && !table.has("depth"));
    let feed = Feed {
        group: table.text("group", "feed_hole"),
        hole: table.table_if_given("hole").map(|mut hole| {
            let diameter = hole.quantity("diameter", Dimension::Length, "17 mm");
            let angle = hole.quantity("angle", Dimension::Angle, "130 deg");
            let z = hole.quantity_if_given("z", Dimension::Length, "0 mm").unwrap_or(0.0);
            hole.finish();
            Hole { diameter, angle, z }
        }),
        groove: table.table_if_given("groove").map(groove),
        pressure: table
            .quantity_if_given("pressure", Dimension::Pressure, "1.96 bar")
            .or(usual.map(|engine| Engine::middle(engine.feed_pressure()))),
        depth: table.quantity_if_given("depth", Dimension::Length, "20 um"),
    };
    table.finish();
    feed
}

fn groove(mut table: TableReader<'_>) -> Groove {
    let from = table.quantity_if_given("from", Dimension::Angle, "80 deg");
    let to = table.quantity_if_given("to", Dimension::Angle, "100 deg");
    if from.is_some() != to.is_some() {
        let (has, lacks) = if from.is_some() { ("from", "to") } else { ("to", "from") };
        let help = format!("give {lacks} too, or remove {has} for a groove all around");
        table.complain(has, format!("stands without {lacks}"), help);
    }
    let groove = Groove {
        arc: (from.is_some() || to.is_some())
            .then(|| Arc {
                from: from.unwrap_or(f64::NAN),
                to: to.unwrap_or(f64::NAN),
            })
            .filter(|arc| !is_all_around(arc)),
        width: table.quantity("width", Dimension::Length, "20 mm"),
        z: table.quantity_if_given("z", Dimension::Length, "0 mm").unwrap_or(0.0),
        corner: table
            .quantity_if_given("corner", Dimension::Length, "2 mm")
            .unwrap_or(0.0),
    };
    table.finish();
    groove
}

/// From 0 to 360 degrees is all around.
fn is_all_around(arc: &Arc) -> bool {
    (arc.to - arc.from - TAU).abs() < 1e-9
}

#[cfg(test)]
mod tests {
    use crate::schema::tests::{STUDY, read, told_one};

    #[test]
    fn grooves_are_read() {
        let hole = "hole = { diameter = \"17 mm\", angle = \"130 deg\" }";
        let groove = "groove = { from = \"80 deg\", to = \"100 deg\", width = \"20 mm\", corner = \"2 mm\" }";
        let scene = read(&STUDY.replacen(hole, groove, 1)).expect("a scene");
        let read_back = scene.feeds[0].groove.expect("a groove");
        assert_eq!((read_back.width, read_back.z, read_back.corner), (0.02, 0.0, 0.002));
        for (broken, wanted) in [
            (
                "groove = { from = \"80 deg\", width = \"20 mm\" }",
                "feed[0].groove.from: stands without to",
            ),
            (
                "groove = { from = \"80 deg\", to = \"70 deg\", width = \"20 mm\" }",
                "feed[0].groove.to: is not behind",
            ),
            (
                "groove = { from = \"80 deg\", to = \"90 deg\", width = \"80 mm\" }",
                "feed[0].groove.width: is more",
            ),
            (
                "groove = { from = \"80 deg\", to = \"90 deg\", width = \"20 mm\" }, depth = \"1 mm\"",
                "feed[0].depth: stands beside",
            ),
            (
                "groove = { width = \"20 mm\" }",
                "feed[0].groove.width: belongs to a groove all around",
            ),
        ] {
            told_one(hole, broken, wanted);
        }
    }
}
