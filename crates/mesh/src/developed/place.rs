//! Developed positions of all nodes, and whether they are those of the scene's liner.

use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

use super::cylinder::{FileSurface, across};
use super::{AGREEMENT, LinerDomain, shorter_way};
use crate::gmsh::MshFile;
use crate::{Error, RawMesh};

/// Positions `(x = R phi, z)` [m] of all nodes of a file. On a ring `x` starts anywhere (plane) or
/// at zero (cylinder); on an arc it runs from `R from` to `R to`.
pub(super) fn place(
    file: &MshFile,
    used: &[bool],
    shape: FileSurface,
    liner: &LinerDomain,
    unit: f64,
) -> Result<Vec<[f64; 2]>, Error> {
    let mut points: Vec<[f64; 2]> = match shape {
        FileSurface::Plane => file.nodes.iter().map(|node| [node[0] * unit, node[1] * unit]).collect(),
        FileSurface::Cylinder { axis, section } => {
            require(
                "the radius (half of bearing.diameter)",
                section.radius * unit,
                liner.radius,
                "m",
                unit_hint(section.radius * unit, liner.radius, unit),
            )?;
            let [a, b] = section.centre;
            let unrolled = file.nodes.iter().map(|&node| {
                let [u, v] = across(node, axis);
                [liner.radius * (v - b).atan2(u - a), node[axis] * unit]
            });
            unrolled.collect()
        }
    };
    let (low, high) = extent(&points, used, 1);
    require("the length (bearing.length)", high - low, liner.length, "m", unit_hint(high - low, liner.length, unit))?;
    let middle = 0.5 * (low + high);
    if middle.abs() > 1e-12 * liner.length {
        points.iter_mut().for_each(|point| point[1] -= middle);
    }
    let half = 0.5 * (high - low);
    let mut lines = vec![("end_low", 1, -half), ("end_high", 1, half)];
    match (liner.arc, shape) {
        (Some((from, to)), FileSurface::Plane) => shift_arc(&mut points, used, liner, [from, to], unit)?,
        (Some((from, to)), FileSurface::Cylinder { .. }) => turn_arc(file, &mut points, used, liner, [from, to])?,
        (None, FileSurface::Plane) => require_circumference(file, &points, liner, unit)?,
        (None, FileSurface::Cylinder { .. }) => {
            let period = liner.circumference();
            for point in &mut points {
                let x = point[0].rem_euclid(period);
                point[0] = if period - x < 1e-12 * period { 0.0 } else { x };
            }
        }
    }
    if let Some((from, to)) = liner.arc {
        lines.extend([("arc_from", 0, liner.radius * from), ("arc_to", 0, liner.radius * to)]);
    }
    for (group, direction, expected) in lines {
        require_line(file, &points, group, direction, expected, liner)?;
    }
    Ok(points)
}

fn require(quantity: &'static str, file: f64, scene: f64, unit: &'static str, hint: String) -> Result<(), Error> {
    if (file - scene).abs() <= AGREEMENT * scene {
        return Ok(());
    }
    Err(Error::Disagrees { quantity, file, scene, unit, hint })
}

/// A remark if the file seems to be in another unit than `unit` [m], by which its lengths were made metres.
fn unit_hint(file: f64, scene: f64, unit: f64) -> String {
    let units = [("m", 1.0), ("mm", 1e-3), ("cm", 1e-2), ("in", 0.0254)];
    let meant = scene / file * unit;
    let guess = units.iter().find(|(_, size)| (meant / size - 1.0).abs() < 1e-3);
    guess.map_or(String::new(), |(name, _)| {
        format!(", as if the file were in {name}: give [mesh] unit = \"{name}\" in the scene")
    })
}

/// The sides of the seam of an unrolled ring lie one circumference apart. Sides that are not even alike are left to
/// [`super::seam`].
fn require_circumference(file: &MshFile, points: &[[f64; 2]], liner: &LinerDomain, unit: f64) -> Result<(), Error> {
    let [low, high] = super::seam::SIDES.map(|group| {
        let mut on_side = vec![false; points.len()];
        let ends = file.curve(group).unwrap_or(&[]).iter().flatten();
        ends.for_each(|&vertex| on_side[vertex as usize] = true);
        extent(points, &on_side, 0)
    });
    let (found, wanted) = ((high.0 - low.0).abs(), liner.circumference());
    if ((high.1 - low.1).abs() - found).abs() > AGREEMENT * wanted {
        return Ok(());
    }
    require("the circumference (pi times bearing.diameter)", found, wanted, "m", unit_hint(found, wanted, unit))
}

/// Least and greatest coordinate of the used points.
fn extent(points: &[[f64; 2]], used: &[bool], direction: usize) -> (f64, f64) {
    let values = used.iter().zip(points).filter(|(used, _)| **used).map(|(_, p)| p[direction]);
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
}

/// An unrolled arc: moves it by whole turns.
fn shift_arc(
    points: &mut [[f64; 2]],
    used: &[bool],
    liner: &LinerDomain,
    arc: [f64; 2],
    unit: f64,
) -> Result<(), Error> {
    let (low, high) = extent(points, used, 0);
    let [from, to] = arc.map(|angle| angle * liner.radius);
    require(
        "the length of the arc (half of bearing.diameter times the angle of bearing.arc)",
        high - low,
        to - from,
        "m",
        unit_hint(high - low, to - from, unit),
    )?;
    let period = liner.circumference();
    let turns = ((from - low) / period).round() * period;
    if (low + turns - from).abs() > AGREEMENT * period {
        return Err(Error::Shifted {
            file: low,
            file_end: high,
            scene: from,
            scene_end: to,
            shift: shorter_way(from - low, period),
            unit: "m",
        });
    }
    points.iter_mut().for_each(|point| point[0] += turns);
    Ok(())
}

/// An arc on a cylinder: takes each angle in the turn around the middle of the arc; nodes of the
/// arc's edges, which may lie half a turn from there, in the turn around that edge.
fn turn_arc(
    file: &MshFile,
    points: &mut [[f64; 2]],
    used: &[bool],
    liner: &LinerDomain,
    arc: [f64; 2],
) -> Result<(), Error> {
    let period = liner.circumference();
    let [from, to] = arc.map(|angle| angle * liner.radius);
    let found = film_interval(points, used, period);
    let near = |x: f64, centre: f64| centre + shorter_way(x - centre, period);
    for point in points.iter_mut() {
        point[0] = near(point[0], 0.5 * (from + to));
    }
    for (group, edge) in [("arc_from", from), ("arc_to", to)] {
        for &vertex in file.curve(group).unwrap_or(&[]).iter().flatten() {
            let x = &mut points[vertex as usize][0];
            *x = near(*x, edge);
        }
    }
    let (low, high) = extent(points, used, 0);
    let off = (low - from).abs().max((high - to).abs());
    if off <= AGREEMENT * period {
        return Ok(());
    }
    let degrees = |x: f64| x / liner.radius * 180.0 / PI;
    let (start, end) = found;
    if ((end - start) - (to - from)).abs() > AGREEMENT * period {
        return Err(Error::Disagrees {
            quantity: "the angle of the arc (bearing.arc)",
            file: degrees(end - start),
            scene: degrees(to - from),
            unit: "deg",
            hint: format!(", the film of the mesh starts at {:.6} deg", degrees(start)),
        });
    }
    Err(Error::Shifted {
        file: degrees(start),
        file_end: degrees(end),
        scene: degrees(from),
        scene_end: degrees(to),
        shift: degrees(shorter_way(from - start, period)),
        unit: "deg",
    })
}

/// Start and end of the film on the circle: it starts after the widest gap between nodes.
pub(super) fn film_interval(points: &[[f64; 2]], used: &[bool], period: f64) -> (f64, f64) {
    let used = used.iter().zip(points).filter(|(used, _)| **used);
    let mut xs: Vec<f64> = used.map(|(_, point)| point[0]).collect();
    xs.sort_unstable_by(f64::total_cmp);
    let (Some(&first), Some(&last)) = (xs.first(), xs.last()) else {
        return (0.0, 0.0);
    };
    let widest = xs.windows(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
    match widest {
        Some(gap) if gap[1] - gap[0] > first + period - last => (gap[1] - period, gap[0]),
        _ => (first, last),
    }
}

/// All nodes of a group at an edge of the liner must lie there.
fn require_line(
    file: &MshFile,
    points: &[[f64; 2]],
    group: &'static str,
    direction: usize,
    expected: f64,
    liner: &LinerDomain,
) -> Result<(), Error> {
    let tolerance = AGREEMENT * if direction == 1 { liner.length } else { liner.circumference() };
    for &vertex in file.curve(group).unwrap_or(&[]).iter().flatten() {
        let found = points[vertex as usize][direction];
        if (found - expected).abs() > tolerance {
            return Err(Error::Misplaced {
                group,
                direction: if direction == 1 { 'z' } else { 'x' },
                expected,
                found,
                node: file.tags[vertex as usize],
            });
        }
    }
    Ok(())
}

/// Refuses a "ring" that leaves part of the circle bare, unless groups lie along the opening (an
/// axial groove may cut the film).
pub(super) fn require_closed(raw: &RawMesh) -> Result<(), Error> {
    const SECTORS: usize = 720;
    let Some(period) = raw.period else { return Ok(()) };
    let mut covered = [false; SECTORS];
    for t in 0..raw.triangles.len() {
        let xs = raw.corners(t).map(|corner| corner[0] / period * SECTORS as f64);
        let low = xs[0].min(xs[1]).min(xs[2]).floor() as i64;
        let high = xs[0].max(xs[1]).max(xs[2]).ceil() as i64;
        for sector in low..high.min(low + SECTORS as i64) {
            covered[sector.rem_euclid(SECTORS as i64) as usize] = true;
        }
    }
    let is_start = |k: usize| !covered[k] && covered[(k + SECTORS - 1) % SECTORS];
    let Some(start) = (0..SECTORS).find(|&k| is_start(k)) else {
        return Ok(());
    };
    let width = (0..SECTORS).take_while(|k| !covered[(start + k) % SECTORS]).count();
    if named_boundary(raw) {
        return Ok(());
    }
    let degrees = |sector: usize| sector as f64 / SECTORS as f64 * TAU.to_degrees();
    Err(Error::OpenRing { from: degrees(start), to: degrees(start + width) })
}

/// True if all edges of the boundary belong to groups.
fn named_boundary(raw: &RawMesh) -> bool {
    let sorted = |a: u32, b: u32| [a.min(b), a.max(b)];
    let mut sides: HashMap<[u32; 2], u32> = HashMap::new();
    for &[a, b, c] in &raw.triangles {
        for edge in [sorted(a, b), sorted(b, c), sorted(c, a)] {
            *sides.entry(edge).or_default() += 1;
        }
    }
    // The edges of an arc do not belong to a ring.
    let groups = raw.curves.iter().filter(|(name, _)| !name.starts_with("arc_"));
    for &[a, b] in groups.flat_map(|(_, edges)| edges) {
        sides.remove(&sorted(a, b));
    }
    sides.values().all(|&count| count != 1)
}
