//! How far columns and rows of a mesh along the flow are apart: by what the film needs around and along the axis.
//!
//! **Equation.** Columns are as dense as the thinnest film along the axis needs around. Rows have as many nodes as
//! equilateral triangles; they are denser beside edges through which oil enters, and where the film of a tilted journal
//! changes along the axis. So a film that is thin at one end only has thin cells there, and no more columns than its
//! width around asks for. **Verified by** `tests/full/tests/random_tilted.rs` and the convergence of all films that
//! conserve oil.

use oilwedge_mesh::developed::LinerDomain;

use crate::film_scale::{FilmScale, LONGEST};
use crate::mesh_plan::MeshPlan;
use crate::position::FilmState;

/// Distance [m] of columns of a mesh in rows.
pub(crate) fn column(longest: f64, scale: &FilmScale, x: f64) -> f64 {
    longest * scale.around_all_along(x) / LONGEST
}

/// How far rows along the flow are apart.
pub(crate) struct RowDistances {
    /// Distance of the rows far from all layers [m].
    far: f64,
    /// Distance of the rows of a mesh without a wanted size [m].
    usual: f64,
    /// Places along the axis [m] near which the film changes within a length [m].
    layers: Vec<(f64, f64)>,
    /// What the film of a tilted journal needs at even distances from one end to the other [m]; empty for other films.
    by_tilt: Vec<f64>,
    /// Half of the bearing's length [m].
    half: f64,
    /// True of an orbit.
    is_orbit: bool,
}

impl RowDistances {
    /// The distances for a film that conserves its oil, none for other films.
    pub(crate) fn of(plan: &MeshPlan, state: &FilmState, longest: f64, scale: &FilmScale) -> Option<Self> {
        let (cavity, liner) = (plan.carrying?, &plan.outline.liner);
        let usual = |x: f64| plan.needed / longest * column(longest, scale, x);
        Some(Self {
            far: spacing(liner, &|x| column(longest, scale, x)),
            usual: spacing(liner, &usual),
            layers: layers(plan, state.oil.viscosity, cavity),
            by_tilt: by_tilt(liner, longest, scale),
            half: 0.5 * liner.length,
            is_orbit: plan.is_of_orbit,
        })
    }

    /// Distance of the rows at the axial position `z` [m].
    pub(crate) fn at(&self, z: f64) -> f64 {
        if self.is_orbit {
            return ROWS_ON_ORBIT * self.far;
        }
        // Cells keep their shape where the mesh is drawn finer.
        let towards = |(edge, thickness): &(f64, f64)| {
            let at_edge = self.far * (IN_LAYER * thickness / self.usual).clamp(FINEST, 1.0);
            at_edge + TOWARDS_EDGE * (z - edge).abs()
        };
        self.layers.iter().map(towards).fold(self.far, f64::min).min(self.by_tilt(z))
    }

    /// What the film of a tilted journal needs at the axial position `z` [m].
    fn by_tilt(&self, z: f64) -> f64 {
        let Some(last) = self.by_tilt.len().checked_sub(1) else {
            return f64::INFINITY;
        };
        let place = 0.5 * (1.0 + z / self.half).clamp(0.0, 2.0) * last as f64;
        let k = (place as usize).min(last - 1);
        let part = place - k as f64;
        (1.0 - part) * self.by_tilt[k] + part * self.by_tilt[k + 1]
    }
}

/// What the film of a tilted journal needs along the axis, where it changes fastest around: distances of rows [m] at
/// even places from end to end.
fn by_tilt(liner: &LinerDomain, longest: f64, scale: &FilmScale) -> Vec<f64> {
    const AROUND: u32 = 360;
    const ALONG: u32 = 64;
    let (from, to) = liner.arc.unwrap_or((0.0, std::f64::consts::TAU));
    let at = |z: f64| {
        let angles = (0..AROUND).map(|k| from + (to - from) * (f64::from(k) + 0.5) / f64::from(AROUND));
        let scales = angles.map(|angle| scale.along_by_tilt([liner.radius * angle, z]));
        longest * scales.fold(LONGEST, f64::min) / LONGEST
    };
    let places = (0..=ALONG).map(|k| liner.length * (f64::from(k) / f64::from(ALONG) - 0.5));
    match scale.has_two_scales() {
        true => places.map(at).collect(),
        false => Vec::new(),
    }
}

/// Distance [m] of rows along the flow that have as many nodes as equilateral triangles of `size` [m] at x.
fn spacing(liner: &LinerDomain, size: &dyn Fn(f64) -> f64) -> f64 {
    const SAMPLES: u32 = 720;
    let (from, to) = liner.arc.unwrap_or((0.0, std::f64::consts::TAU));
    let (mut columns, mut triangles) = (0.0, 0.0);
    for k in 0..SAMPLES {
        let angle = from + (to - from) * (f64::from(k) + 0.5) / f64::from(SAMPLES);
        let edge = size(liner.radius * angle);
        columns += 1.0 / edge;
        triangles += 1.0 / (edge * edge);
    }
    0.75f64.sqrt() * columns / triangles
}

/// Rows beside an edge through which oil enters a cavity, over the thickness of the layer that it makes, and over rows
/// far from it at least; how fast they grow with the distance.
const IN_LAYER: f64 = 0.25;
const FINEST: f64 = 0.1;
const TOWARDS_EDGE: f64 = 0.2;

/// Edges [m] all around through which oil enters the cavity, and the thickness [m] of the layer that the excess of
/// pressure `P` presses in over one radian of the circumference: `c sqrt(P R/(3 mu U))`, from
/// `U h/2 d(thickness)/dx = h^3/(12 mu) P/thickness`.
fn layers(plan: &MeshPlan, viscosity: f64, cavity: f64) -> Vec<(f64, f64)> {
    let drag = 3.0 * viscosity * plan.speed.abs();
    let thickness = |pressure: f64| plan.bearing.clearance * ((pressure - cavity) / drag).sqrt();
    let outline = &plan.outline;
    let half = 0.5 * outline.liner.length;
    let at_ends = [-half, half].map(|z| (z, plan.bearing.end_pressure));
    let at_grooves = outline.feeds.iter().flat_map(|feed| {
        let shape = outline.shape(feed).filter(|shape| shape.is_full_turn());
        let edges = shape.map(|shape| [-1.0, 1.0].map(|side| shape.centre[1] + side * shape.half[1]));
        edges.into_iter().flatten().filter_map(|z| Some((z, feed.pressure?)))
    });
    let all = at_ends.into_iter().chain(at_grooves);
    all.filter(|(_, pressure)| *pressure > cavity && drag > 0.0).map(|(z, pressure)| (z, thickness(pressure))).collect()
}

/// Distance of the rows of an orbit's mesh, over that of as many equal cells: the peak of pressure that runs around is
/// steep along the flow. One land of the big end of scene 28 on 48 x 4, 48 x 8, 64 x 4 and 96 x 4 cells, whose rows are
/// 1.1, 0.5, 1.4 and 2.1 times as far apart as the columns: least film 1.4, 1.4, 0.9 and 0.2 % off. Layers of oil that
/// enters beside a groove come and go with the cavity, and finer rows there do not show in it.
const ROWS_ON_ORBIT: f64 = 1.7;
