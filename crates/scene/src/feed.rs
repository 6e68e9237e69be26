//! `[[feed]]`: holes, grooves and pockets, regions of given pressure or of a deeper film.

pub(crate) mod groove;
pub(crate) mod hole;

pub use groove::Groove;
pub use hole::Hole;

use crate::reader::TableReader;
use crate::{Complaints, MeshSource, Scene};

keys! {
    "feed" = Tables; "", "no feeds", "",
        "holes, grooves and pockets, any number";
    "feed.group" = Text; "feed_hole", "required", "a group of the mesh, each once",
        "name of the region. A curve of the mesh: the region is cut out; a surface: it is meshed";
    "feed.pressure" = Quantity(Pressure); "1.96 bar", "required unless `depth` or a `heat.preset`", "",
        "pressure p_s of the oil in the region";
    "feed.depth" = Quantity(Length); "20 um", "no pocket", ">= 0",
        "instead of `pressure`, a pocket: how much deeper the film is there; its pressure is found";
}

/// Names of a mesh's groups that have a meaning of their own, so that no feed may have them.
const RESERVED_GROUPS: [&str; 8] =
    ["film", "film_start", "end_low", "end_high", "arc_from", "arc_to", "seam_low", "seam_high"];

/// A hole, groove or pocket: a region of given pressure, or one where the film is deeper.
#[derive(Debug, Clone, PartialEq)]
pub struct Feed {
    /// Physical group of the mesh that is the region: a curve (cut out) or a surface (meshed).
    pub group: String,
    /// The round hole that the region is, where the scene gives one.
    pub hole: Option<Hole>,
    /// The groove that the region is, where the scene gives one.
    pub groove: Option<Groove>,
    /// Gauge pressure p_s [Pa]; `None` in a pocket.
    pub pressure: Option<f64>,
    /// How much deeper the film is in a pocket [m], whose pressure is found; `None` where pressure is given.
    pub depth: Option<f64>,
}

/// Reads one table; `usual_pressure` [Pa] counts where neither a pressure nor a depth is written.
pub(crate) fn read(mut table: TableReader<'_>, usual_pressure: Option<f64>) -> Feed {
    let group = table.text("group");
    let hole = table.table_if_given("hole").map(hole::read);
    let groove = table.table_if_given("groove").map(groove::read);
    let pressure = table.given("pressure");
    let depth = table.number("depth").within("is negative", "give how much deeper the film is");
    let depth = depth.given();
    table.refuse_if(
        RESERVED_GROUPS.contains(&group.as_str()),
        "group",
        format!("\"{group}\" is a name that meshes use for a part of the liner"),
        format!("name the feed region otherwise; taken: {}", RESERVED_GROUPS.join(", ")),
    );
    table.refuse_if(
        hole.is_some() && groove.is_some(),
        "groove",
        "stands beside a hole",
        "give each region a [[feed]] of its own",
    );
    table.refuse_if(
        pressure.is_some() && depth.is_some(),
        "depth",
        "stands beside a pressure",
        "remove the depth (where the pressure is given it has no effect) or the pressure (it is found)",
    );
    let pressure = pressure.or(usual_pressure.filter(|_| depth.is_none()));
    table.refuse_if(
        pressure.is_none() && depth.is_none() && table.is_readable(),
        "group",
        "has neither a pressure nor a depth",
        "give pressure = \"1.96 bar\", or depth = \"20 um\" for a pocket whose pressure is found",
    );
    Feed { group, hole, groove, pressure, depth }
}

/// Shapes that fit the liner and each other, and one table a region.
pub(crate) fn check(scene: &Scene, complaints: &mut Complaints) {
    let is_drawn = matches!(scene.mesh, MeshSource::Drawing { .. });
    for (index, feed) in scene.feeds.iter().enumerate() {
        let (before, key) = (&scene.feeds[..index], format!("feed[{index}]"));
        complaints.refuse_if(
            !feed.group.is_empty() && before.iter().any(|other| other.group == feed.group),
            &format!("{key}.group"),
            format!("\"{}\" is fed already by a [[feed]] above", feed.group),
            "give each region one [[feed]] and one pressure",
        );
        complaints.refuse_if(
            is_drawn && feed.hole.is_none() && feed.groove.is_none(),
            &format!("{key}.group"),
            "has no shape, and there is no mesh file to show it",
            "give hole = { diameter = \"17 mm\", angle = \"130 deg\" } or groove = { from = \"80 deg\", to = \"100 deg\", width = \"20 mm\" }, or [mesh] file",
        );
        if let Some(groove) = feed.groove {
            groove.check(&scene.bearing, &format!("{key}.groove"), complaints);
        }
        if let Some(hole) = feed.hole {
            hole.check(&scene.bearing, &format!("{key}.hole"), complaints);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::tests::{STUDY, read, told_one};

    #[test]
    fn grooves_are_read() {
        let hole = "hole = { diameter = \"17 mm\", angle = \"130 deg\" }";
        let groove = "groove = { from = \"80 deg\", to = \"100 deg\", width = \"20 mm\", corner = \"2 mm\" }";
        let scene = read(&STUDY.replacen(hole, groove, 1)).expect("a scene");
        let read_back = scene.feeds[0].groove.expect("a groove");
        assert_eq!((read_back.width, read_back.z, read_back.corner), (0.02, 0.0, 0.002));
        for (broken, wanted) in [
            ("groove = { from = \"80 deg\", width = \"20 mm\" }", "feed \"feed_hole\".groove.from: stands without to"),
            (
                "groove = { from = \"80 deg\", to = \"70 deg\", width = \"20 mm\" }",
                "feed \"feed_hole\".groove.to: is not behind",
            ),
            (
                "groove = { from = \"80 deg\", to = \"90 deg\", width = \"80 mm\" }",
                "feed \"feed_hole\".groove.width: is more",
            ),
            (
                "groove = { from = \"80 deg\", to = \"90 deg\", width = \"20 mm\" }, depth = \"1 mm\"",
                "feed \"feed_hole\".depth: stands beside",
            ),
            ("groove = { width = \"20 mm\" }", "feed \"feed_hole\".groove.width: belongs to a groove all around"),
        ] {
            told_one(hole, broken, wanted);
        }
    }
}
