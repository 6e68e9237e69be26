//! A film on fewer triangles, for a page that would be too large with all of them. Rims, the edges of pockets,
//! everything curved, and places where a field is steep stay as they are; between them vertices are removed evenly
//! (`thinning.rs`), and the new middles of sides take the values of the film.

use std::collections::HashMap;

use oilwedge_drawing::least_and_greatest;
use oilwedge_study::fields::FieldRow;
use oilwedge_study::picture::{FieldValues, FilmPicture, PictureField};

use super::thinning::thinned;
use crate::Error;
use crate::digits::significant;
use crate::plot::{DrawnFilm, Finder, InTriangle, drawn_fields};

/// Middles of sides that are as far from the line between their ends as this part of its length are on a curve.
const STRAIGHT: f64 = 1e-7;
/// A field that changes by more than this part of its range within a triangle is steep there, as the film fraction
/// where the film breaks.
const STEEP: f64 = 0.03;
/// A field whose range is less than this part of its size is the same everywhere.
const SAME: f64 = 1e-6;
/// A vertex that goes takes three sides and two triangles with it.
const GONE: usize = 4;

/// A film on fewer triangles.
#[derive(Debug)]
pub(super) struct CoarserFilm {
    pub(super) film: DrawnFilm,
    pub(super) picture: FilmPicture,
    /// The fields, and the greatest difference from the film at its own nodes over the range of the field.
    pub(super) differences: Vec<(&'static str, f64)>,
}

/// A side by its ends, the lesser first.
fn side(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// The ends of the side whose middle is node 3, 4 or 5 of a triangle.
const ENDS: [[usize; 2]; 3] = [[0, 1], [1, 2], [2, 0]];

/// The fields on nodes with their ends, but for those that are the same everywhere, whose range is round-off.
fn varying(picture: &FilmPicture) -> impl Iterator<Item = (&'static FieldRow, &Vec<f64>, [f64; 2])> {
    drawn_fields(&picture.point_data).filter_map(|(row, values)| {
        let [low, high] = least_and_greatest(values.iter().copied());
        (high - low > SAME * low.abs().max(high.abs())).then_some((row, values, [low, high]))
    })
}

/// Sides of a mesh.
struct Sides {
    /// Middles of the sides.
    middle: HashMap<[u32; 2], u32>,
    /// Which vertices are at a rim, at something curved, or where a field is steep.
    must_stay: Vec<bool>,
}

impl Sides {
    fn of(film: &DrawnFilm, picture: &FilmPicture) -> Self {
        let mut triangles_at: HashMap<[u32; 2], (u32, u32)> = HashMap::new();
        let mut must_stay = vec![false; picture.points.len()];
        for (cell, nodes) in picture.cells.iter().zip(film.cells()) {
            let mut is_curved = false;
            for (k, [a, b]) in (3..).zip(ENDS) {
                triangles_at.entry(side(cell[a], cell[b])).or_insert((cell[k], 0)).1 += 1;
                let off = [0, 1].map(|d| nodes[k][d] - 0.5 * (nodes[a][d] + nodes[b][d]));
                let along = [0, 1].map(|d| nodes[b][d] - nodes[a][d]);
                is_curved |= off[0].hypot(off[1]) > STRAIGHT * along[0].hypot(along[1]);
            }
            if is_curved {
                cell[..3].iter().for_each(|node| must_stay[*node as usize] = true);
            }
        }
        for (side, (_, count)) in &triangles_at {
            if *count == 1 {
                side.iter().for_each(|node| must_stay[*node as usize] = true);
            }
        }
        for (_, values, [low, high]) in varying(picture) {
            for cell in &picture.cells {
                let [from, to] = least_and_greatest(cell.map(|node| values[node as usize]));
                if to - from > STEEP * (high - low) {
                    cell[..3].iter().for_each(|node| must_stay[*node as usize] = true);
                }
            }
        }
        let middle = triangles_at.into_iter().map(|(ends, (node, _))| (ends, node)).collect();
        Self { middle, must_stay }
    }
}

/// Origin of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum NodeOrigin {
    /// A node of the film.
    Node(u32),
    /// The middle of a side that the film does not have.
    Middle([u32; 2]),
}

/// Nodes in the order in which they are met.
#[derive(Debug, Default)]
struct NodeOrder {
    numbers: HashMap<NodeOrigin, u32>,
    sources: Vec<NodeOrigin>,
}

impl NodeOrder {
    fn number(&mut self, source: NodeOrigin) -> u32 {
        *self.numbers.entry(source).or_insert_with(|| {
            self.sources.push(source);
            self.sources.len() as u32 - 1
        })
    }

    /// Numbers the nodes of triangles with these corners.
    fn cells(&mut self, triangles: &[[u32; 3]], sides: &Sides) -> Vec<[u32; 6]> {
        let mut cell = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|vertex| self.number(NodeOrigin::Node(vertex)));
            let [d, e, f] = ENDS.map(|[k, l]| {
                let ends = side(corners[k], corners[l]);
                let old = sides.middle.get(&ends).map(|node| NodeOrigin::Node(*node));
                self.number(old.unwrap_or(NodeOrigin::Middle(ends)))
            });
            [a, b, c, d, e, f]
        };
        triangles.iter().map(&mut cell).collect()
    }
}

/// The film on so many nodes, or on as few as its rims leave.
///
/// # Errors
/// [`Error::Format`]: triangles of the picture do not cover what is between them.
pub(super) fn coarser(film: &DrawnFilm, picture: &FilmPicture, most: usize) -> Result<CoarserFilm, Error> {
    let sides = Sides::of(film, picture);
    let places = film.places(picture);
    let corners = film.cells().iter().zip(&picture.cells).map(|(nodes, &[a, b, c, ..])| {
        let [u, v] = [1, 2].map(|k| [0, 1].map(|d| nodes[k][d] - nodes[0][d]));
        if u[0] * v[1] > u[1] * v[0] { [a, b, c] } else { [a, c, b] }
    });
    let corners: Vec<[u32; 3]> = corners.collect();
    let wanted = picture.points.len().saturating_sub(most).div_ceil(GONE);
    let triangles = thinned(&places, &corners, &sides.must_stay, (film.circumference(), wanted));
    let mut nodes = NodeOrder::default();
    let cells = nodes.cells(&triangles, &sides);
    let middle = |[a, b]: [u32; 2]| film.between(places[a as usize], places[b as usize]);
    let point = |source: &NodeOrigin| match source {
        NodeOrigin::Node(node) => picture.points[*node as usize],
        NodeOrigin::Middle(ends) => film.point(middle(*ends)),
    };
    let mut coarse = FilmPicture {
        points: nodes.sources.iter().map(point).collect(),
        cells,
        lines: picture.lines.clone(),
        ..FilmPicture::default()
    };
    let finder = Finder::new(film);
    let found = nodes.sources.iter().map(|source| match source {
        NodeOrigin::Node(_) => Some(None),
        NodeOrigin::Middle(ends) => finder.find(middle(*ends)).map(Some),
    });
    let found: Option<Vec<_>> = found.collect();
    let found =
        found.ok_or_else(|| Error::format("page")("the triangles of film.vtu leave gaps; solve the scene again"))?;
    for (row, values) in drawn_fields(&picture.point_data) {
        let value = |(source, place): (&NodeOrigin, &Option<InTriangle>)| match (source, place) {
            (NodeOrigin::Node(node), _) => values[*node as usize],
            (_, place) => place.and_then(|place| finder.value(row, place)).unwrap_or(f64::NAN),
        };
        let values = nodes.sources.iter().zip(&found).map(value).collect();
        coarse.point_data.push(scalars(row, values));
    }
    let drawn = DrawnFilm::new(film.result().clone(), &coarse)?;
    let differences = differences(&drawn, picture, &places, &nodes);
    coarse.cell_data = summed(&drawn, film, picture);
    Ok(CoarserFilm { film: DrawnFilm::new(film.result().clone(), &coarse)?, picture: coarse, differences })
}

fn scalars(row: &FieldRow, values: Vec<f64>) -> PictureField {
    PictureField { name: row.name.into(), unit: row.unit.into(), values: FieldValues::Scalars(values) }
}

/// How far the coarser film is off at the nodes that it does not have.
fn differences(
    coarse: &DrawnFilm,
    picture: &FilmPicture,
    places: &[[f64; 2]],
    nodes: &NodeOrder,
) -> Vec<(&'static str, f64)> {
    let finder = Finder::new(coarse);
    let gone = (0..places.len()).filter(|node| !nodes.numbers.contains_key(&NodeOrigin::Node(*node as u32)));
    let gone: Vec<_> = gone.filter_map(|node| Some((node, finder.find(places[node])?))).collect();
    let difference = |(row, values, [low, high]): (&'static FieldRow, &Vec<f64>, [f64; 2])| {
        let off = |(node, place): &(usize, InTriangle)| Some((finder.value(row, *place)? - values[*node]).abs());
        let most = gone.iter().filter_map(off).fold(0.0, f64::max);
        (row.label, most / (high - low))
    };
    varying(picture).map(difference).collect()
}

/// Fields on triangles are parts of a sum: each is given to the triangle that covers its centroid.
fn summed(coarse: &DrawnFilm, film: &DrawnFilm, picture: &FilmPicture) -> Vec<PictureField> {
    let finder = Finder::new(coarse);
    let centroid = |nodes: &[[f64; 2]; 6]| [0, 1].map(|d| (nodes[0][d] + nodes[1][d] + nodes[2][d]) / 3.0);
    let owners: Vec<Option<usize>> = match picture.cell_data.is_empty() {
        true => Vec::new(),
        false => film.cells().iter().map(|nodes| Some(finder.find(centroid(nodes))?.cell)).collect(),
    };
    let sum = |(row, values): (&'static FieldRow, &Vec<f64>)| {
        let mut sums = vec![0.0; coarse.cells().len()];
        for (owner, value) in owners.iter().zip(values) {
            owner.iter().for_each(|owner| sums[*owner] += value);
        }
        scalars(row, sums)
    };
    drawn_fields(&picture.cell_data).map(sum).collect()
}

/// What the page says of it.
impl CoarserFilm {
    pub(super) fn note(&self, nodes: usize) -> String {
        let each = |(label, off): &(&str, f64)| format!("{label} {} %", significant(100.0 * off, 1));
        let differences: Vec<String> = self.differences.iter().map(each).collect();
        format!(
            "The film has {nodes} nodes. The page carries it on a coarser mesh of {}; at the nodes left out the two differ by at most these parts of the range: {}; film.vtu has all values.",
            self.picture.points.len(),
            differences.join(", ")
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_scene::Scene;
    use oilwedge_study::picture::{PictureOptions, Surface};
    use oilwedge_study::{RunOptions, run};
    use std::path::Path;

    /// A ring with a hole whose film conserves oil.
    const SCENE: &str = r#"
title = "ring"
[bearing]
diameter = "50 mm"
length = "25 mm"
clearance = "30 um"
[mesh]
size = "1.5 mm"
[[feed]]
group = "hole"
hole = { diameter = "5 mm", angle = "60 deg", z = "2 mm" }
pressure = "2 bar"
[journal]
speed = "2000 rpm"
eccentricity = 0.7
min_film_angle = "180 deg"
[oil]
viscosity = "10 mPa.s"
[cavitation]
model = "jfo"
pressure = "0 bar"
"#;

    #[test]
    fn a_coarser_film_has_the_rims_the_sums_and_nearly_the_values() {
        let scene = Scene::parse(SCENE, Path::new("ring.toml"), &[]).expect("a scene");
        for surface in [Surface::Cylinder, Surface::Developed] {
            let options = RunOptions {
                picture: PictureOptions { surface, ..PictureOptions::default() },
                ..RunOptions::default()
            };
            let found = run(&scene, &options).expect("a film");
            let picture = found.picture.expect("a picture");
            let film = DrawnFilm::new(found.result, &picture).expect("a film");
            let nodes = picture.points.len();
            let coarse = coarser(&film, &picture, nodes * 7 / 10).expect("a coarser film");
            let count = coarse.picture.points.len();
            assert!(count <= nodes * 7 / 10 && count > nodes * 7 / 10 - 8, "{count} of {nodes}");
            let area = |film: &DrawnFilm| -> f64 { film.cells().iter().map(area).sum() };
            let ratio = area(&coarse.film) / area(&film);
            assert!((ratio - 1.0).abs() < 1e-12, "{ratio}");
            for (name, off) in &coarse.differences {
                let most = if *name == "film fraction" { 0.03 } else { 0.01 };
                assert!(*off < most && *off >= 0.0, "{name}: {off}");
            }
            assert!(coarse.differences.iter().any(|(_, off)| *off > 1e-6), "nothing measured");
            let sum = |picture: &FilmPicture| -> f64 {
                let (_, values) = drawn_fields(&picture.cell_data).next().expect("an indicator");
                values.iter().sum()
            };
            assert!((sum(&coarse.picture) / sum(&picture) - 1.0).abs() < 1e-9);
            let again = coarser(&film, &picture, nodes * 7 / 10).expect("a coarser film");
            assert_eq!(again.picture, coarse.picture);
            assert!(coarse.note(nodes).contains(&format!("coarser mesh of {count}")));
        }
    }

    /// Area of a triangle with curved sides: that of its corners and four thirds of those between sides and middles.
    fn area(nodes: &[[f64; 2]; 6]) -> f64 {
        let cross = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        };
        let bulge = |[a, b]: [usize; 2], middle: usize| 4.0 / 3.0 * cross(nodes[a], nodes[middle], nodes[b]);
        let bulges: f64 = (3..).zip(ENDS).map(|(middle, ends)| bulge(ends, middle)).sum();
        (cross(nodes[0], nodes[1], nodes[2]) + bulges).abs()
    }
}
