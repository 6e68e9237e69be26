//! The developed surface: a gmsh mesh, unrolled or on the cylinder, becomes the liner of a scene.
//!
//! Developed coordinates are `x = R phi` [m] around and `z` [m] along the axis, with `z = 0`
//! midway between the ends. On a cylinder the angle counts from the coordinate direction after its
//! axis to the one after that (axis z: from x to y). The sides of a mid-side node are unrolled
//! with it, so a triangle that stands across `phi = 0` needs no care.

mod alone;
mod cylinder;
mod place;
mod seam;

use std::f64::consts::TAU;
use std::path::Path;

pub use alone::{alone, read_alone};

use crate::gmsh::{self, MshFile};
use crate::{Error, Mesh, RawMesh, rim};

/// Relative agreement asked of a mesh and its scene. Coordinates typed with six digits pass.
pub(crate) const AGREEMENT: f64 = 1e-5;
/// A mid-side node within this fraction of the edge length from the middle makes no bulge.
const STRAIGHT: f64 = 1e-9;

/// The liner that a mesh should cover.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinerDomain {
    /// Radius R of the bore [m].
    pub radius: f64,
    /// Length B along the axis [m].
    pub length: f64,
    /// Start and end of the film [rad]; none for a full ring.
    pub arc: Option<(f64, f64)>,
}

impl LinerDomain {
    /// Circumference 2 pi R [m] of the full circle.
    pub fn circumference(&self) -> f64 {
        TAU * self.radius
    }

    fn check(&self, unit: f64) -> Result<(), Error> {
        let positive = "a finite value above zero";
        let (from, to) = self.arc.unwrap_or((0.0, TAU));
        let conditions = [
            ("the radius of the liner [m]", self.radius, positive, self.radius > 0.0),
            ("the length of the liner [m]", self.length, positive, self.length > 0.0),
            ("the unit of the mesh [m]", unit, positive, unit > 0.0),
            ("the start of the arc [rad]", from, "a finite angle", true),
            (
                "the arc [rad]",
                to - from,
                "an angle above zero, at most one turn",
                to > from && to - from <= TAU * (1.0 + f64::EPSILON * 8.0),
            ),
        ];
        let wrong = conditions.into_iter().find(|c| !c.1.is_finite() || !c.3);
        wrong.map_or(Ok(()), |(what, value, needed, _)| Err(Error::Impossible { what, value, needed }))
    }
}

/// Reads a gmsh file as the mesh of `liner`; `unit` is the length of one file unit [m].
///
/// # Errors
/// Those of [`gmsh::read`], of [`unroll`] and of [`Mesh::build`], with the path.
pub fn read(path: impl AsRef<Path>, liner: &LinerDomain, unit: f64) -> Result<Mesh, Error> {
    let path = path.as_ref();
    let file = gmsh::read(path)?;
    let raw = unroll(&file, liner, unit).map_err(|error| error.in_file(path))?;
    Mesh::build(raw).map_err(|defects| Error::from(defects).in_file(path))
}

/// Unrolls the triangles of a file onto the developed surface of `liner` and, on a ring, glues the
/// seam; `unit` is the length of one file unit [m].
///
/// Rims whose curved edges lie on a circle are recognised ([`rim::recognise`]).
/// All triangles belong to the film. An unrolled ring may be cut anywhere; an unrolled arc starts
/// at `x = R from`, or a whole number of turns from there.
///
/// # Errors
/// The nodes lie neither in a plane z = constant nor on a cylinder; radius, length or arc are not
/// those of the liner; groups are missing or lie elsewhere; the seam does not fit.
pub fn unroll(file: &MshFile, liner: &LinerDomain, unit: f64) -> Result<RawMesh, Error> {
    liner.check(unit)?;
    let mut used = vec![false; file.nodes.len()];
    for &vertex in file.triangles.iter().flatten() {
        used[vertex as usize] = true;
    }
    let shape = cylinder::FileSurface::find(file, &used, liner.radius / unit)?;
    require_groups(file, liner, shape)?;
    let points = place::place(file, &used, shape, liner, unit)?;
    let on_cylinder = shape != cylinder::FileSurface::Plane;
    let bulges = bulges(file, &points, on_cylinder.then(|| liner.circumference()));
    let mut raw = RawMesh {
        points,
        labels: file.tags.clone(),
        triangles: file.triangles.clone(),
        bulges,
        circles: Vec::new(),
        curves: file.curves.clone(),
        surfaces: file.surfaces.clone(),
        period: liner.arc.is_none().then(|| liner.circumference()),
    };
    seam::glue(&mut raw, &file.periodic, liner.length)?;
    if raw.period.is_some() && on_cylinder {
        place::require_closed(&raw)?;
    }
    rim::recognise(&mut raw);
    Ok(raw)
}

/// Names every group that is missing.
fn require_groups(file: &MshFile, liner: &LinerDomain, shape: cylinder::FileSurface) -> Result<(), Error> {
    let mut curves = vec!["end_low", "end_high"];
    if liner.arc.is_some() {
        curves.extend(["arc_from", "arc_to"]);
    } else if shape == cylinder::FileSurface::Plane {
        curves.extend(seam::SIDES);
    }
    let mut missing = Vec::new();
    if file.surface("film").is_none() {
        missing.push("surface \"film\"".to_owned());
    }
    let curves = curves.iter().filter(|name| file.curve(name).is_none());
    missing.extend(curves.map(|name| format!("curve \"{name}\"")));
    if missing.is_empty() {
        return Ok(());
    }
    let has = |names: [&str; 2]| names.iter().all(|name| file.curve(name).is_some());
    let remedy = match liner.arc {
        None if has(["arc_from", "arc_to"]) => "it is an arc: give [bearing] arc in the scene",
        Some(_) if has(seam::SIDES) => "it is a full ring: leave [bearing] arc out of the scene",
        _ => "name physical groups so in gmsh",
    };
    Err(Error::MissingGroups { missing, present: file.groups(), remedy })
}

/// Vectors from the middle of the straight edges to the mid-side nodes, of edges that bulge.
fn bulges(file: &MshFile, points: &[[f64; 2]], period: Option<f64>) -> Vec<(u32, u8, [f64; 2])> {
    let Some(mid_nodes) = &file.mid_nodes else {
        return Vec::new();
    };
    let along = |from: f64, to: f64| period.map_or(to - from, |period| shorter_way(to - from, period));
    // Positions are rounded, and so is the middle of an edge.
    let reach = points.iter().flatten().fold(0.0, |reach: f64, x| reach.max(x.abs()));
    let rounding = 16.0 * f64::EPSILON * reach;
    let mut bulges = Vec::new();
    for ((t, triangle), mids) in (0..).zip(&file.triangles).zip(mid_nodes) {
        for k in 0..3 {
            let [a, b, mid] = [triangle[k], triangle[(k + 1) % 3], mids[k]].map(|v| points[v as usize]);
            let edge = [along(a[0], b[0]), b[1] - a[1]];
            let bulge = [along(a[0], mid[0]) - 0.5 * edge[0], mid[1] - a[1] - 0.5 * edge[1]];
            let length = edge[0].hypot(edge[1]);
            if bulge[0].hypot(bulge[1]) > (STRAIGHT * length).max(rounding) {
                bulges.push((t, k as u8, bulge));
            }
        }
    }
    bulges
}

/// A distance around the circle, the shorter way: in [-period/2, period/2].
pub(crate) fn shorter_way(distance: f64, period: f64) -> f64 {
    distance - period * (distance / period).round()
}

#[cfg(test)]
mod tests;
