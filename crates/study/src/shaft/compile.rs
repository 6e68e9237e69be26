//! The scene of a shaft and those of its bearings become films, a shaft and its loads.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use oilwedge_bearing::Coordinates;
use oilwedge_bearing::coordinates::Vector;
use oilwedge_bearing::shaft::{
    self, CrankThrow, Crankshaft, Engine, Films, Material, NodeForce, Piece, Place, Round, Shaft,
};
use oilwedge_scene::{self as scene, Journal, OrbitTable, Scene, ShaftPiece, ShaftScene, ShaftTilt, Statics, Support};

use super::error::ShaftError;
use crate::compile::compile;
use crate::compile::duty::{NoDuty, crank_of};
use crate::compile_error::CompileError;
use crate::film::Film;
use crate::orbit::on_mesh_for;

/// Number of angles of a period at which it is checked that loads are finite.
const CHECKED: u32 = 1440;

/// A bearing of a shaft.
#[derive(Debug, Clone)]
pub struct CompiledBearing {
    /// How results call it.
    pub name: String,
    /// The file of its scene.
    pub path: PathBuf,
    /// Axial position of its middle [m].
    pub at: f64,
    /// Stiffness of what holds the shell against force [N/m] and moment [N m/rad], infinite for a rigid one.
    pub support: [f64; 2],
    /// Film of the bearing, with the journal in the middle.
    pub film: Film,
}

/// A shaft on films, ready to be solved.
#[derive(Debug)]
pub struct Compiled {
    /// Bearings of the shaft along the axis.
    pub bearings: Vec<CompiledBearing>,
    /// The shaft as its journals see it.
    pub shaft: Shaft,
    /// Loads that do not change, on the nodes of the shaft.
    pub loads: Vec<NodeForce>,
    /// Axial positions of those nodes [m].
    pub loaded_at: Vec<f64>,
    /// Axial positions of first web, pin and second web of each throw [m].
    pub throws: Vec<[f64; 3]>,
}

/// Compiles a shaft whose films are meshed for this greatest eccentricity [1].
///
/// # Errors
/// [`ShaftError`]: a scene of a bearing cannot be used, or the bearings do not hold the shaft.
pub fn compile_shaft(scene: &ShaftScene, eccentricity: f64) -> Result<Compiled, ShaftError> {
    let bearings = bearings(scene, eccentricity)?;
    let crankshaft = crankshaft(scene);
    let places: Vec<f64> =
        (bearings.iter().map(|bearing| bearing.at)).chain(scene.crankshaft.loads.iter().map(|load| load.at)).collect();
    let laid = crankshaft.laid(&places);
    let (journals, loads) = laid.places.split_at(bearings.len());
    let journals: Vec<Place> = (journals.iter().zip(&bearings))
        .map(|(&node, bearing)| Place { node, coordinates: coordinates(&bearing.film) })
        .collect();
    let pins = laid.throws.iter().map(|throw| throw.pin);
    let webs = laid.throws.iter().flat_map(|throw| throw.webs);
    let loaded: Vec<usize> = match scene.crank {
        Some(_) => pins.chain(webs).collect(),
        None => loads.to_vec(),
    };
    let given = (0..).zip(&scene.crankshaft.loads);
    let loaded_at: Vec<f64> = loaded.iter().map(|&node| laid.frame.nodes[node][2]).collect();
    let shaft = match scene.crankshaft.statics {
        Statics::Elastic => laid.frame.on(&journals, &loaded)?,
        Statics::Cut => Shaft::cut(&bearings.iter().map(|bearing| bearing.at).collect::<Vec<_>>(), &loaded_at)?,
    };
    Ok(Compiled {
        shaft,
        loads: given.map(|(place, load)| NodeForce { place, force: load.force }).collect(),
        loaded_at,
        throws: crankshaft.throws(),
        bearings,
    })
}

/// Coordinates of its journal that a film on a shaft sees.
fn coordinates(film: &Film) -> Coordinates {
    Coordinates { order: if film.model.has_support { 4 } else { 2 }, arm: 0.5 * film.problem.bearing.length }
}

impl CompiledBearing {
    /// Coordinates of its journal that the film sees.
    pub fn coordinates(&self) -> Coordinates {
        coordinates(&self.film)
    }
}

impl Compiled {
    /// The films, as the balance of the shaft has them.
    pub fn films(&self) -> Films<'_> {
        let compliance = |bearing: &CompiledBearing| shaft::compliance_of_shell(bearing.coordinates(), bearing.support);
        Films {
            shaft: &self.shaft,
            films: self.bearings.iter().map(film).collect(),
            compliance: self.bearings.iter().map(compliance).collect(),
        }
    }

    /// This shaft on films of the vertices of their meshes alone.
    pub(super) fn on_vertices(&self) -> Self {
        self.with_films(|_, CompiledBearing { film, .. }| film.on_vertices())
    }

    /// This shaft on films that are meshed for another greatest eccentricity [1].
    ///
    /// # Errors
    /// [`ShaftError::Film`]: a bearing cannot be meshed for it.
    pub(super) fn meshed_for(&self, eccentricity: f64) -> Result<Self, ShaftError> {
        let mut films: Vec<Film> = Vec::new();
        for (number, CompiledBearing { path, film, .. }) in self.bearings.iter().enumerate() {
            let first = self.bearings[..number].iter().position(|other| other.path == *path);
            films.push(match first {
                Some(first) => films[first].clone(),
                None => on_mesh_for(&film.model, &film.model.oil, eccentricity).map_err(failed(path))?,
            });
        }
        Ok(self.with_films(|number, _| films[number].clone()))
    }

    /// This shaft with another film of each bearing, by its number.
    pub(super) fn with_films(&self, film: impl Fn(usize, &CompiledBearing) -> Film) -> Self {
        let bearings = self.bearings.iter().enumerate();
        Self {
            bearings: bearings
                .map(|(number, bearing)| CompiledBearing { film: film(number, bearing), ..bearing.clone() })
                .collect(),
            shaft: self.shaft.clone(),
            loads: self.loads.clone(),
            loaded_at: self.loaded_at.clone(),
            throws: self.throws.clone(),
        }
    }

    /// Loads that do not change, as forces on the journals [N].
    pub fn steady_load(&self) -> Vec<Vector> {
        self.shaft.loads(&self.loads, 0.0)
    }
}

fn film(bearing: &CompiledBearing) -> shaft::ShaftFilm<'_> {
    shaft::ShaftFilm::new(&bearing.film.problem, &bearing.film.system, bearing.coordinates())
}

/// The bearings with their films; bearings of one scene share its mesh.
fn bearings(scene: &ShaftScene, eccentricity: f64) -> Result<Vec<CompiledBearing>, ShaftError> {
    let mut films: Vec<(PathBuf, Film)> = Vec::new();
    let is_followed_alone = scene.crankshaft.statics == Statics::Cut && scene.crank.is_some();
    let mut bearings = Vec::new();
    for bearing in &scene.crankshaft.bearings {
        let path = &bearing.scene;
        let film = match films.iter().find(|(other, _)| other == path) {
            Some((_, film)) => film.clone(),
            None => {
                let mut model = compile(&on_shaft(path, scene)?).map_err(failed(path))?;
                if model.sockets.heat_field.is_some() && !is_followed_alone {
                    return Err(ShaftError::Refused {
                        path: path.clone(),
                        reason: "heat.field finds the temperatures of one film, but those of this shaft share its loads",
                        help: "give the shaft statics = \"cut\" and its films a cycle, or remove field: each has one temperature then",
                    });
                }
                if scene.crank.is_none() {
                    // The loads do not change: the journal moves on the way to its place alone.
                    Arc::make_mut(&mut model).scope.orbit = None;
                }
                let film = on_mesh_for(&model, &model.oil, eccentricity).map_err(failed(path))?;
                films.push((path.clone(), film.clone()));
                film
            }
        };
        bearings.push(CompiledBearing {
            name: bearing.name.clone(),
            path: path.clone(),
            at: bearing.at,
            support: [bearing.support.stiffness, bearing.support.tilt_stiffness],
            film,
        });
    }
    Ok(bearings)
}

fn failed(path: &Path) -> impl Fn(CompileError) -> ShaftError {
    let path = path.to_owned();
    move |source| ShaftError::Film { path: path.clone(), source }
}

/// The scenes of all bearings of a shaft as far as the numbers of each film depend on them: with what the shaft gives
/// it.
///
/// # Errors
/// [`ShaftError`]: the scene of a bearing cannot be used.
pub fn bearing_scenes(scene: &ShaftScene) -> Result<Vec<Scene>, ShaftError> {
    let bearings = scene.crankshaft.bearings.iter();
    let scenes = bearings.map(|bearing| on_shaft(&bearing.scene, scene));
    let measured = |own: Scene| match scene.crank {
        Some(_) => own,
        // The loads do not change: the journal moves on the way to its place alone.
        None => Scene { orbit: None, ..own },
    };
    scenes.map(|own| own.map(measured)).collect()
}

/// The scene of a bearing with what the shaft gives it: speed, moving journal, and tilt.
///
/// # Errors
/// [`ShaftError`]: it cannot be used.
fn on_shaft(path: &Path, scene: &ShaftScene) -> Result<Scene, ShaftError> {
    let shaft = &scene.crankshaft;
    let resists_tilt = shaft.tilt == ShaftTilt::Free && shaft.statics == Statics::Elastic;
    let mut changed = crate::read(path)?;
    // No load: that of the shaft acts.
    changed.journal = Journal::without_load(shaft.speed);
    (changed.load_at, changed.load_moment, changed.load_cycle, changed.crank) = (None, None, None, None);
    changed.support = resists_tilt.then_some(Support { tilt_stiffness: 0.0, tilt: [0.0; 2] });
    changed.orbit = Some(scene.orbit.unwrap_or_else(OrbitTable::usual));
    changed.tolerance = None;
    (changed.dynamics, changed.sweep) = (None, None);
    Ok(changed)
}

fn crankshaft(scene: &ShaftScene) -> Crankshaft {
    let shaft = &scene.crankshaft;
    let radius = scene.crank.as_ref().map_or(0.0, |crank| crank.radius);
    let piece = |piece: &ShaftPiece| match (piece, &shaft.throw) {
        (ShaftPiece::Straight { length, diameter, bore }, _) => {
            Piece::Straight(Round { length: *length, diameter: *diameter, bore: *bore })
        }
        (ShaftPiece::Throw { fires_at }, shape) => {
            let shape = shape.unwrap_or_else(scene::ThrowShape::none);
            Piece::Throw(CrankThrow {
                angle: -fires_at,
                radius,
                pin: Round { length: shape.pin_length, diameter: shape.pin_diameter, bore: shape.pin_bore },
                web_thickness: shape.web_thickness,
                web_width: shape.web_width,
            })
        }
    };
    Crankshaft {
        material: Material { youngs_modulus: shaft.youngs_modulus, shear_modulus: shaft.shear_modulus },
        pieces: shaft.pieces.iter().map(piece).collect(),
    }
}

/// The cylinders of a scene with a crank; `None`: the loads do not change.
///
/// # Errors
/// [`ShaftError::Load`]: the gas pressure cannot be used, or the loads are no numbers.
pub fn engine(scene: &ShaftScene) -> Result<Option<Engine>, ShaftError> {
    let shaft = &scene.crankshaft;
    let Some(crank) = &scene.crank else { return Ok(None) };
    let drive = crank_of(crank, shaft.period).map_err(|reason| ShaftError::Load(reason.to_string()))?;
    let web_mass = shaft.throw.map_or(0.0, |throw| throw.web_mass);
    let fires_at = shaft.fires_at();
    let of_web = |angle: f64, moment: f64| [moment * angle.cos(), moment * angle.sin()];
    let mut unbalances: Vec<[[f64; 2]; 2]> =
        (fires_at.iter()).map(|angle| [of_web(-angle, 0.5 * web_mass * crank.radius); 2]).collect();
    for weight in &shaft.counterweights {
        let [x, y] = of_web(weight.angle - fires_at[weight.throw], weight.moment);
        let web = &mut unbalances[weight.throw][weight.web];
        *web = [web[0] + x, web[1] + y];
    }
    let engine = Engine { crank: drive, fires_at, unbalances, speed: shaft.speed };
    let angles = (0..CHECKED).map(|k| shaft.period * f64::from(k) / f64::from(CHECKED));
    let is_finite = |angle: f64| engine.loads(angle).iter().flat_map(|load| load.force).all(f64::is_finite);
    match angles.into_iter().find(|&angle| !is_finite(angle)) {
        Some(angle) => Err(ShaftError::Load(NoDuty::NotFinite { angle }.to_string())),
        None => Ok(Some(engine)),
    }
}
