//! The elastic liner: the wall gives way to the pressure of the film.

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::wall::Wall;
use oilwedge_scene::{Layer, Liner, OuterSurface, WallMaterial};

use super::{Effect, Socket, changed};
use crate::film::Film;
use crate::measure::Measured;
use crate::wall::{ring, wall};
use crate::warning::{self, Warning};

/// How reports call what is left out without it.
pub(super) const KIND: &str = "elastic liner";

/// A layer is no model of its wall where the two deflect by more than this part apart.
const APART: f64 = 0.05;
/// Slices hold one another where the wall is thicker than this part of the bearing's length.
const THICK: f64 = 0.2;

pub(super) const ROW: Effect = Effect {
    name: KIND,
    sentence: "the wall gives way to the pressure of the film",
    socket: Socket::Deflection,
    kind: KIND,
    is_in: |scene| scene.liner.is_some(),
    install: |scene, sockets| sockets.liner.clone_from(&scene.liner),
    instead: "a rigid liner",
    remove: |scene| changed(scene, |scene| scene.liner = None),
    no_proportion: Some([
        "liner",
        "gives way to the pressure, which depends on all motions together",
        "remove [liner]",
    ]),
    warnings,
};

fn warnings(film: &Film, measured: &Measured) -> Vec<Warning> {
    let (Some(liner), Some(deflection)) = (&film.model.sockets.liner, film.problem.deflection()) else {
        return Vec::new();
    };
    let by_liner = match liner {
        Liner::Winkler(Layer::Of(material)) => no_layer(material, deflection, film),
        Liner::Wall { of, outer } => slices(of, *outer, film),
        Liner::Winkler(Layer::Given(_)) | Liner::Compliance { .. } => None,
    };
    let is_large = measured.deflection.is_some_and(|most| most > film.problem.bearing.clearance);
    let large = is_large.then(|| {
        warning::SOFT.says("the elastic liner deflects by more than the clearance: check its stiffness and its unit; strains are small in its model")
    });
    by_liner.into_iter().chain(large).collect()
}

/// Where a layer is no model of the wall that it is made of: the ring of that wall under the same pressure.
fn no_layer(material: &WallMaterial, deflection: &Deflection, film: &Film) -> Option<Warning> {
    let bearing = &film.problem.bearing;
    let of_ring = Liner::Wall { of: *material, outer: OuterSurface::Clamped };
    let ring_wall = wall(&of_ring, bearing).ok()?;
    let per_pressure = ring(material, OuterSurface::Clamped, bearing).thin_layer();
    let layer = Wall::of_slices(bearing, |_| per_pressure)?;
    // The pressure that bends the layer, from its deflection: the ring makes of it what it is in proportion wave by
    // wave.
    let as_ring = ring_wall.deflected_as(&layer, &deflection.coefficients)?;
    let greatest = |values: &[f64]| values.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let off: Vec<f64> = as_ring.iter().zip(&*deflection.coefficients).map(|(ring, layer)| ring - layer).collect();
    let part = greatest(&off) / greatest(&deflection.coefficients);
    (part > APART).then(|| {
        warning::NO_LAYER.says(format!(
            "an assumption does not hold: a Winkler layer as model of its wall: under this pressure a ring of the same material, clamped outside, deflects otherwise by up to {:.0} % of the greatest deflection (t/R = {}, nu = {}); give liner.wall instead of liner.winkler",
            100.0 * part,
            readable(material.thickness / bearing.radius),
            readable(material.poisson)
        ))
    })
}

/// Slices of a thick wall hold one another.
fn slices(of: &WallMaterial, outer: OuterSurface, film: &Film) -> Option<Warning> {
    let ratio = of.thickness / film.problem.bearing.length;
    let joint = match outer {
        OuterSurface::Free => ", an eye is held by its rod, and a cap by its joint",
        OuterSurface::Clamped => "",
    };
    (ratio > THICK).then(|| {
        warning::SLICES.says(format!(
            "an assumption does not hold: slices of the wall that move by themselves: the wall is {} of the bearing's length thick, so that neighbours hold one another, most of all near the ends{joint}; a structural program condenses such a wall to liner.compliance",
            readable((1e3 * ratio).round() / 1e3)
        ))
    })
}
