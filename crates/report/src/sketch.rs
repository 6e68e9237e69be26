//! A liner and its load in words, and drawn in letters: what `oilwedge check` understood.

use oilwedge_mesh::{Locator, Mesh, Region};
use oilwedge_reynolds::supply::{BoundaryKind, Supply};
use oilwedge_scene::wording::{bars, degrees, millimetres, newtons};
use oilwedge_scene::{Feed, Journal, PositionTable, Scene};

/// Letters along the circumference and lines along the axis.
const COLUMNS: usize = 72;
const LINES: usize = 17;

/// The liner of a scene, its feeds and its load in words, a line each.
pub(crate) fn words(scene: &Scene) -> Vec<String> {
    let bearing = &scene.bearing;
    let extent = match bearing.arc {
        Some(arc) => format!("arc from {} to {}", degrees(arc.from), degrees(arc.to)),
        None => match bearing.film_start {
            Some(angle) => format!("full ring, film start at {}", degrees(angle)),
            None => "full ring, periodic".to_owned(),
        },
    };
    let size = format!(
        "{extent}; diameter {}, length {}, radial clearance {}",
        millimetres(bearing.diameter),
        millimetres(bearing.length),
        millimetres(bearing.clearance)
    );
    [size]
        .into_iter()
        .chain(inlet_in_words(scene))
        .chain(scene.feeds.iter().map(feed_in_words))
        .chain(load_in_words(&scene.journal))
        .collect()
}

fn inlet_in_words(scene: &Scene) -> Option<String> {
    let (arc, fraction) = (scene.bearing.arc?, scene.bearing.inlet_fraction?);
    let edge = if scene.journal.speed > 0.0 { arc.from } else { arc.to };
    Some(format!("starved inlet: the oil brought in at {} fills {fraction} of the gap", degrees(edge)))
}

fn load_in_words(journal: &Journal) -> Option<String> {
    let PositionTable::Load { force, angle } = journal.position else {
        return None;
    };
    Some(format!("load of {} at {}; the position of the journal is found", newtons(force), degrees(angle)))
}

fn feed_in_words(feed: &Feed) -> String {
    let shape = match (feed.hole, feed.groove) {
        (Some(hole), _) => {
            let place = format!("at {}, z = {}", degrees(hole.angle), millimetres(hole.z));
            format!("hole of {} {place}", millimetres(hole.diameter))
        }
        (None, Some(groove)) => {
            let arc = groove
                .arc
                .map_or("all around".to_owned(), |arc| format!("from {} to {}", degrees(arc.from), degrees(arc.to)));
            let corner = match groove.corner > 0.0 {
                true => format!(", corners of radius {}", millimetres(groove.corner)),
                false => String::new(),
            };
            format!("groove {arc}, {} wide at z = {}{corner}", millimetres(groove.width), millimetres(groove.z))
        }
        (None, None) => "region of the mesh".to_owned(),
    };
    let given = match (feed.pressure, feed.depth) {
        (Some(pressure), _) => format!("at {}", bars(pressure)),
        (None, Some(depth)) => format!("deeper by {}, its pressure is found", millimetres(depth)),
        (None, None) => String::new(),
    };
    format!("\"{}\": {shape}, {given}", feed.group)
}

/// The unrolled liner, `z` upwards and the angle to the right, one letter for each feed, with a legend.
///
/// `marked` are regions that are no feeds but worth a letter (pockets). `radius` is R [m].
pub(crate) fn sketch(mesh: &Mesh, supply: &Supply, marked: &[&Region], radius: f64) -> String {
    let feeds: Vec<&Region> = (supply.regions().iter())
        .filter(|region| region.kind == BoundaryKind::Feed)
        .filter_map(|region| mesh.region(&region.name))
        .chain(marked.iter().copied())
        .collect();
    let letters: Vec<char> = ('A'..='Z').chain('a'..='z').cycle().take(feeds.len()).collect();
    let bounds = SketchArea::of(mesh);
    let locator = Locator::new(mesh);
    let letter_at = |point: [f64; 2]| match locator.find(point) {
        Some((cell, _)) => {
            let holds = |region: &&Region| region.cells.binary_search(&(cell as u32)).is_ok();
            feeds.iter().position(holds).map_or('.', |index| letters[index])
        }
        None => {
            let distances = feeds.iter().map(|region| from_rim(mesh, region, point));
            let nearest = distances.enumerate().min_by(|(_, a), (_, b)| a.total_cmp(b));
            let nearest = nearest.filter(|(_, distance)| distance.is_finite());
            nearest.map_or(' ', |(index, _)| letters[index])
        }
    };
    let mut text = String::new();
    for line in 0..LINES {
        let z = bounds.at(1, 1.0 - (line as f64 + 0.5) / LINES as f64);
        let label = match line {
            0 => format!("z = {}", millimetres(bounds.high[1])),
            _ if line == LINES - 1 => format!("z = {}", millimetres(bounds.low[1])),
            _ => String::new(),
        };
        let row: String =
            (0..COLUMNS).map(|k| letter_at([bounds.at(0, (k as f64 + 0.5) / COLUMNS as f64), z])).collect();
        text += &format!("{label:>18} |{row}|\n");
    }
    let (from, to) = (degrees(bounds.low[0] / radius), degrees(bounds.high[0] / radius));
    text += &format!("{:>18}  {from}{to:>width$}\n", "phi =", width = COLUMNS - from.len());
    let legend: Vec<String> =
        feeds.iter().zip(&letters).map(|(region, letter)| format!("{letter} {}", region.name)).collect();
    if !legend.is_empty() {
        text += &format!("{:>18}  {}\n", "", legend.join(", "));
    }
    text
}

/// The rectangle that is drawn.
struct SketchArea {
    low: [f64; 2],
    high: [f64; 2],
}

impl SketchArea {
    fn of(mesh: &Mesh) -> Self {
        let mut bounds = Self { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
        for point in mesh.points() {
            for k in 0..2 {
                bounds.low[k] = bounds.low[k].min(point[k]);
                bounds.high[k] = bounds.high[k].max(point[k]);
            }
        }
        if let Some(period) = mesh.period() {
            bounds.high[0] = bounds.low[0] + period;
        }
        bounds
    }

    fn at(&self, axis: usize, part: f64) -> f64 {
        self.low[axis] + part * (self.high[axis] - self.low[axis])
    }
}

/// Distance [m] of a point from the nearest node on the rim of a region: a point outside of the film lies in the
/// cut-out whose rim is nearest.
fn from_rim(mesh: &Mesh, region: &Region, [x, z]: [f64; 2]) -> f64 {
    let nodes = region.edges.iter().flat_map(|&edge| mesh.edge_nodes(edge));
    let apart = |along: f64| mesh.period().map_or(along, |period| along - period * (along / period).round());
    nodes.map(|node| apart(node[0] - x).hypot(node[1] - z)).fold(f64::INFINITY, f64::min)
}
