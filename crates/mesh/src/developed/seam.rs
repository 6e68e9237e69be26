//! Glues the two sides of the seam of a ring.

use std::collections::{HashMap, HashSet};

use super::AGREEMENT;
use crate::defect::MOST_DEFECTS;
use crate::{Defect, Error, RawMesh};

/// The groups of the two sides.
pub(super) const SIDES: [&str; 2] = ["seam_low", "seam_high"];

/// Most nodes of one side at one z that are compared.
const MOST_AT_ONE_Z: usize = 1000;

/// Merges the vertices of group `seam_high` with those of `seam_low`, which lie at the same place
/// modulo the period of `raw`. Pairs in `periodic` are taken first, the rest is found by `z`.
/// Vertices end up with `x` in one period from the low seam on. Without the two groups, or where
/// the seam is closed already, nothing is done.
pub(super) fn glue(raw: &mut RawMesh, periodic: &[[u32; 2]], length: f64) -> Result<(), Error> {
    let Some(period) = raw.period else { return Ok(()) };
    let [mut low, mut high] = SIDES.map(|name| vertices(raw, name));
    if low.is_empty() || high.is_empty() {
        return Ok(());
    }
    let shared: HashSet<u32> = low.iter().filter(|v| high.binary_search(v).is_ok()).copied().collect();
    low.retain(|v| !shared.contains(v));
    high.retain(|v| !shared.contains(v));

    let partners = match_sides(raw, periodic, &low, &high, [period, length]);
    let taken: HashSet<u32> = partners.values().copied().collect();
    let lone_high = high.iter().filter(|v| !partners.contains_key(v)).map(|&v| (v, 1));
    let lone_low = low.iter().filter(|v| !taken.contains(v)).map(|&v| (v, 0));
    let lone: Vec<(u32, usize)> = lone_low.chain(lone_high).collect();
    if let Some(&(v, side)) = lone.first() {
        let [x, z] = raw.points[v as usize];
        return Err(Error::Seam {
            count: lone.len(),
            node: raw.label(v),
            group: SIDES[side],
            x,
            z,
            nearest: nearest(raw, z, if side == 0 { &high } else { &low }),
        });
    }

    let mut merged: Vec<u32> = (0..raw.points.len() as u32).collect();
    for (&upper, &lower) in &partners {
        merged[upper as usize] = lower;
    }
    let spanning = spanning(raw, &merged, period);
    if !spanning.is_empty() {
        return Err(spanning.into());
    }
    let merge = |v: &mut u32| *v = merged[*v as usize];
    raw.triangles.iter_mut().flatten().for_each(merge);
    raw.curves.iter_mut().flat_map(|(_, edges)| edges).flatten().for_each(merge);
    let start = low.iter().map(|&v| raw.points[v as usize][0]).fold(f64::INFINITY, f64::min);
    if start.is_finite() {
        for point in &mut raw.points {
            if point[0] < start || point[0] >= start + period {
                point[0] = start + (point[0] - start).rem_euclid(period);
            }
        }
    }
    Ok(())
}

/// Triangles that reach from one side of the seam to the other: `merged` nodes make two corners of each one.
fn spanning(raw: &RawMesh, merged: &[u32], period: f64) -> Vec<Defect> {
    let is_one = |[a, b]: [u32; 2]| a != b && merged[a as usize] == merged[b as usize];
    let spans = |&&[a, b, c]: &&[u32; 3]| is_one([a, b]) || is_one([b, c]) || is_one([c, a]);
    let spanning = raw.triangles.iter().filter(spans).take(MOST_DEFECTS);
    let defect = |triangle: &[u32; 3]| {
        let xs = triangle.map(|v| raw.points[v as usize][0]);
        let span = xs.iter().copied().fold(f64::MIN, f64::max) - xs.iter().copied().fold(f64::MAX, f64::min);
        Defect::SpansRing { nodes: triangle.map(|v| raw.label(v)), degrees: 360.0 * span / period }
    };
    spanning.map(defect).collect()
}

/// Vertices of a curve group, ascending.
fn vertices(raw: &RawMesh, name: &str) -> Vec<u32> {
    let curves = raw.curves.iter().filter(|(group, _)| group == name);
    let mut vertices: Vec<u32> = curves.flat_map(|(_, edges)| edges).flatten().copied().collect();
    vertices.sort_unstable();
    vertices.dedup();
    vertices
}

/// The low vertex of each high one, for those that have one.
fn match_sides(
    raw: &RawMesh,
    periodic: &[[u32; 2]],
    low: &[u32],
    high: &[u32],
    [period, length]: [f64; 2],
) -> HashMap<u32, u32> {
    let z = |v: u32| raw.points[v as usize][1];
    let meet = |a: u32, b: u32| {
        let along = (raw.points[a as usize][0] - raw.points[b as usize][0]) / period;
        (along - along.round()).abs() <= AGREEMENT && (z(a) - z(b)).abs() <= AGREEMENT * length
    };
    let mut partners = HashMap::new();
    let mut taken = HashSet::new();
    for &[a, b] in periodic {
        for (upper, lower) in [(a, b), (b, a)] {
            let across = high.binary_search(&upper).is_ok() && low.binary_search(&lower).is_ok();
            if across && meet(upper, lower) && !partners.contains_key(&upper) && taken.insert(lower) {
                partners.insert(upper, lower);
            }
        }
    }
    let mut by_z = low.to_vec();
    by_z.sort_unstable_by(|&a, &b| z(a).total_cmp(&z(b)));
    for &upper in high {
        if partners.contains_key(&upper) {
            continue;
        }
        let from = by_z.partition_point(|&v| z(v) < z(upper) - AGREEMENT * length);
        let near = by_z[from..].iter().take_while(|&&v| z(v) <= z(upper) + AGREEMENT * length).take(MOST_AT_ONE_Z);
        if let Some(&lower) = near.filter(|&&v| meet(upper, v)).find(|v| !taken.contains(v)) {
            taken.insert(lower);
            partners.insert(upper, lower);
        }
    }
    partners
}

/// The vertex nearest in `z`, in words.
fn nearest(raw: &RawMesh, z: f64, side: &[u32]) -> String {
    let off = |v: u32| (raw.points[v as usize][1] - z).abs();
    let nearest = side.iter().copied().min_by(|&a, &b| off(a).total_cmp(&off(b)));
    nearest.map_or("no node".to_owned(), |v| {
        let [x, z] = raw.points[v as usize];
        format!("node {} at ({x:.9}, {z:.9}) m", raw.label(v))
    })
}
