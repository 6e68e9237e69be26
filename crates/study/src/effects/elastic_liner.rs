//! The elastic liner: the wall gives way to the pressure of the film.

use std::path::PathBuf;
use std::sync::Arc;

use oilwedge_reynolds::Bearing;
use oilwedge_reynolds::analytical::elastic_ring::{ElasticRing, RingSupport};
use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::film_thickness::Deflection;
use oilwedge_reynolds::wall::{Dense, Wall};
use oilwedge_scene::compliance_table::read_compliance;
use oilwedge_scene::{Layer, Liner, OuterSurface, WallMaterial};

use super::sockets::WallModel;
use super::{Effect, Socket, changed};
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::measure::Measured;
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
    install: |scene, sockets| sockets.wall = scene.liner.as_ref().map(model),
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
    let (Some(model), Some(deflection)) = (&film.model.sockets.wall, film.problem.deflection()) else {
        return Vec::new();
    };
    let is_large = measured.deflection.is_some_and(|most| most > film.problem.bearing.clearance);
    let large = is_large.then(|| {
        warning::SOFT.says("the elastic liner deflects by more than the clearance: check its stiffness and its unit; strains are small in its model")
    });
    model.warning(&film.problem.bearing, deflection).into_iter().chain(large).collect()
}

fn model(liner: &Liner) -> Arc<dyn WallModel> {
    match liner {
        Liner::Winkler(layer) => Arc::new(*layer),
        Liner::Wall { of, outer } => Arc::new(RingWall { of: *of, outer: *outer }),
        Liner::Compliance { file } => Arc::new(CondensedWall { file: file.clone() }),
    }
}

/// A wall of slices that give way to waves of pressure as rings do.
fn wall_of_slices(bearing: &Bearing, compliance: impl Fn(usize) -> f64) -> Result<Wall, CompileError> {
    Wall::of_slices(bearing, compliance).ok_or_else(not_interpolated)
}

fn not_interpolated() -> CompileError {
    CompileError::Wall("liner.compliance.file: between points along the axis that are so unevenly spaced nothing is interpolated; space them by about equal steps from end to end".to_owned())
}

/// A ring of a material around the bore of a bearing.
fn ring(of: &WallMaterial, outer: OuterSurface, bearing: &Bearing) -> ElasticRing {
    ElasticRing {
        radius: bearing.radius,
        thickness: of.thickness,
        modulus: of.modulus,
        poisson: of.poisson,
        outer: match outer {
            OuterSurface::Clamped => RingSupport::Clamped,
            OuterSurface::Free => RingSupport::Free,
        },
    }
}

impl WallModel for Layer {
    fn wall(&self, bearing: &Bearing) -> Result<Wall, CompileError> {
        let per_pressure = match self {
            Self::Given(per_pressure) => *per_pressure,
            Self::Of(material) => ring(material, OuterSurface::Clamped, bearing).thin_layer(),
        };
        wall_of_slices(bearing, |_| per_pressure)
    }

    fn warning(&self, bearing: &Bearing, deflection: &Deflection) -> Option<Warning> {
        match self {
            Self::Given(_) => None,
            Self::Of(material) => no_layer(material, deflection, bearing),
        }
    }
}

/// A ring of one material; each slice moves by itself.
#[derive(Debug)]
struct RingWall {
    of: WallMaterial,
    outer: OuterSurface,
}

impl WallModel for RingWall {
    fn wall(&self, bearing: &Bearing) -> Result<Wall, CompileError> {
        let ring = ring(&self.of, self.outer, bearing);
        wall_of_slices(bearing, |n| ring.compliance(n))
    }

    /// Slices of a thick wall hold one another.
    fn warning(&self, bearing: &Bearing, _: &Deflection) -> Option<Warning> {
        let ratio = self.of.thickness / bearing.length;
        let joint = match self.outer {
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
}

/// A wall by the matrix of a structural program.
#[derive(Debug)]
struct CondensedWall {
    file: PathBuf,
}

impl WallModel for CondensedWall {
    fn wall(&self, bearing: &Bearing) -> Result<Wall, CompileError> {
        let table = read_compliance(&self.file, bearing.length)
            .map_err(|error| CompileError::Wall(format!("liner.compliance.file: {error}")))?;
        let points = table.angles * table.axial.len();
        let displacements = Dense::from_row_slice(points, points, &table.displacements);
        let wall = Wall::of_matrix(bearing, (table.first_angle, table.angles), &table.axial, displacements);
        wall.ok_or_else(not_interpolated)
    }

    fn has_slices(&self) -> bool {
        false
    }
}

/// Where a layer is no model of the wall that it is made of: the ring of that wall under the same pressure.
fn no_layer(material: &WallMaterial, deflection: &Deflection, bearing: &Bearing) -> Option<Warning> {
    let of_ring = RingWall { of: *material, outer: OuterSurface::Clamped };
    let ring_wall = of_ring.wall(bearing).ok()?;
    let layer = Layer::Of(*material).wall(bearing).ok()?;
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
