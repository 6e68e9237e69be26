//! The drawing of a mesh: imported geometry, to be meshed anew.
//!
//! Round rims are known by their circles; a rim of straight edges along the axes is a rectangle.

use super::{Blueprint, DrawingError, Feature, RoundedRectangle};
use crate::developed::{LinerDomain, shorter_way};
use crate::topology::NO_TRIANGLE;
use crate::{Mesh, Region};

/// Points within this part of the greatest extent lie on a line.
const ON_LINE: f64 = 1e-9;

impl Blueprint {
    /// The drawing of `mesh`, a mesh of `liner`, whose regions `names` are holes and grooves.
    ///
    /// # Errors
    /// Every region that is neither a disc, a rectangle along the axes, nor a band all around.
    pub fn of_mesh(mesh: &Mesh, liner: LinerDomain, names: &[&str]) -> Result<Self, Vec<DrawingError>> {
        let mut features = Vec::new();
        let mut faults = Vec::new();
        for &name in names {
            let region = mesh.region(name);
            match region.and_then(|region| Some((region, shape_of(mesh, region, liner.length)?))) {
                Some((region, shape)) => {
                    features.push(Feature { name: name.to_owned(), shape, meshed: !region.cells.is_empty() })
                }
                None => faults.push(DrawingError::Unrecognised { name: name.to_owned() }),
            }
        }
        if faults.is_empty() { Ok(Self { liner, features, line: None }) } else { Err(faults) }
    }
}

/// Edges between a region and the rest.
fn rim(mesh: &Mesh, region: &Region) -> Vec<u32> {
    if region.cells.is_empty() {
        return region.edges.clone();
    }
    let inside = |t: u32| t != NO_TRIANGLE && region.cells.binary_search(&t).is_ok();
    let sides = mesh.topology().edge_triangles.iter();
    (0u32..).zip(sides).filter(|(_, sides)| inside(sides[0]) != inside(sides[1])).map(|(edge, _)| edge).collect()
}

/// The shape of a region of a liner of this length [m].
fn shape_of(mesh: &Mesh, region: &Region, length: f64) -> Option<RoundedRectangle> {
    let rim = rim(mesh, region);
    let first = *rim.first()?;
    if let Some(circle) = mesh.circle(first) {
        let same = |edge: &u32| {
            mesh.circle(*edge).is_some_and(|other| {
                let along = other.centre[0] - circle.centre[0];
                let along = mesh.period().map_or(along, |period| shorter_way(along, period));
                let off = along.hypot(other.centre[1] - circle.centre[1]);
                off.max((other.radius - circle.radius).abs()) < ON_LINE * circle.radius
            })
        };
        return rim.iter().all(same).then(|| RoundedRectangle::disc(circle.centre, circle.radius));
    }
    rectangle(mesh, &rim, region.cells.is_empty().then_some(length))
}

/// The rectangle or band that edges along the axes bound. The rim of one that is cut out has no edges on the ends of a
/// liner, whose length [m] is given for it.
fn rectangle(mesh: &Mesh, rim: &[u32], cut_out_of: Option<f64>) -> Option<RoundedRectangle> {
    let origin = mesh.edge_nodes(*rim.first()?)[0];
    // Corners of every edge near the first one: the shorter way around.
    let near = |edge: &u32| {
        let [a, b, m] = mesh.edge_nodes(*edge);
        let shift = match mesh.period() {
            Some(period) => origin[0] + shorter_way(m[0] - origin[0], period) - m[0],
            None => 0.0,
        };
        [[a[0] + shift, a[1]], [b[0] + shift, b[1]]]
    };
    let edges: Vec<[[f64; 2]; 2]> = rim.iter().map(near).collect();
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for point in edges.iter().flatten() {
        for k in 0..2 {
            low[k] = low[k].min(point[k]);
            high[k] = high[k].max(point[k]);
        }
    }
    let extent = (high[0] - low[0]).max(high[1] - low[1]);
    let at = |x: f64, y: f64| (x - y).abs() < ON_LINE * extent;
    let along = |axis: usize, [a, b]: &[[f64; 2]; 2]| {
        let across = 1 - axis;
        at(a[across], b[across]) && (at(a[across], low[across]) || at(a[across], high[across]))
    };
    let straight = rim.iter().all(|&edge| mesh.bulge(edge) == [0.0; 2]);
    let horizontal = edges.iter().filter(|edge| along(0, edge));
    let length: f64 = horizontal.clone().map(|[a, b]| (b[0] - a[0]).abs()).sum();
    let half = [0.5 * (high[0] - low[0]), 0.5 * (high[1] - low[1])];
    let centre = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
    if straight && horizontal.count() == edges.len() {
        let turn = mesh.period()?;
        let band = RoundedRectangle { centre, half: [f64::INFINITY, half[1]], corner: 0.0 };
        return ((length - 2.0 * turn).abs() < 1e-6 * turn).then_some(band);
    }
    let on_sides = edges.iter().all(|edge| along(0, edge) || along(1, edge));
    let is_open = |z: &f64| cut_out_of.is_some_and(|length| at(z.abs(), 0.5 * length));
    let closed = 2 - [low[1], high[1]].iter().filter(|z| is_open(z)).count();
    (straight && on_sides && at(length, closed as f64 * (high[0] - low[0]))).then_some(RoundedRectangle {
        centre,
        half,
        corner: 0.0,
    })
}
