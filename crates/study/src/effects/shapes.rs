//! Surfaces that are no circles: a crowned, oval, worn or measured bore, a crowned or measured journal.

use std::f64::consts::TAU;
use std::path::Path;
use std::sync::Arc;

use oilwedge_reynolds::existence::readable;
use oilwedge_reynolds::film_thickness::{Crown, Envelope, Measured, Oval, Profile, SurfaceGrid, Wearing, Worn};
use oilwedge_reynolds::{Bearing, Thinnest};
use oilwedge_scene::periodic_table::TableError;
use oilwedge_scene::surface_table::{Covered, SurfacePoints, WearingPosition, read_bore, read_positions, read_shaft};
use oilwedge_scene::wording::{degrees, micrometres};
use oilwedge_scene::{Bore, Scene, Shaft};

use super::{BLANK, Effect, Socket, Sockets, changed};
use crate::dimensions::bearing;
use crate::film::Film;
use crate::warning::{self, Warning};

/// How reports call what is left out without it.
pub(super) const KIND: &str = "shapes of bore and shaft";

/// Slopes of a surface from which on Reynolds' equation is in doubt.
const STEEP: f64 = 0.02;
/// A measurement whose noise is more than this part of the least film shows in the film.
const NOISY: f64 = 0.1;
/// Points further apart than this part of the length over which the film changes do not resolve it.
const COARSE: f64 = 0.5;
/// Places around and along at which surfaces are looked at for their limits.
const PLACES: [u32; 2] = [720, 21];

pub(super) const ROW: Effect = Effect {
    name: "shapes",
    sentence: "bore and journal are crowned, oval, worn or as measured",
    socket: Socket::FilmThickness,
    kind: KIND,
    is_in: |scene| !scene.is_circular(),
    install: |scene, sockets| {
        let bores = scene.bores.iter().map(|bore| Surface::Bore(bore.clone()));
        let shaft = scene.shaft.iter().map(|shaft| Surface::Shaft(shaft.clone()));
        let (bearing, covered) = (bearing(scene), covered(scene));
        for surface in bores.chain(shaft) {
            sockets.profiles.push(Box::new(move || surface.profile(&bearing, covered)));
        }
    },
    instead: "circular bore, cylindrical journal",
    remove: |scene| {
        changed(scene, |scene| {
            scene.bores.clear();
            scene.shaft = None;
        })
    },
    warnings: |film, measured| {
        let of_points = |(path, points): (&Path, SurfacePoints)| of_points(film, &measured.thinnest, path, &points);
        let by_points = measurements(&film.scene).flat_map(of_points);
        limits(film).into_iter().chain(by_points).collect()
    },
    ..BLANK
};

/// A surface of a scene.
enum Surface {
    Bore(Bore),
    Shaft(Shaft),
}

/// What a measured surface has to cover.
fn covered(scene: &Scene) -> Covered {
    Covered { length: scene.bearing.length, arc: scene.bearing.arc }
}

impl Surface {
    /// Shape of the surface.
    fn profile(&self, bearing: &Bearing, covered: Covered) -> Result<Arc<dyn Profile>, TableError> {
        let radius = bearing.radius;
        let crown = |depth: f64| Crown { depth, half_length: 0.5 * bearing.length };
        let measured = |SurfacePoints { angles, zs, depths }: SurfacePoints| {
            let points = SurfaceGrid { angles, zs, depths };
            Measured::new(&points, radius, bearing.length, covered.arc.is_none())
        };
        Ok(match self {
            &Self::Bore(Bore::Crown(depth)) | &Self::Shaft(Shaft::Crown(depth)) => Arc::new(crown(depth)),
            &Self::Bore(Bore::Oval { depth, angle }) => Arc::new(Oval { radius, depth, angle }),
            &Self::Bore(Bore::Worn { depth, angle, half_width }) => Arc::new(Worn { radius, depth, angle, half_width }),
            Self::Bore(Bore::Envelope { path, film }) => {
                let positions = read_positions(path, bearing.clearance)?.into_iter();
                let positions: Vec<Wearing> =
                    positions.map(|WearingPosition { offset, tilt }| Wearing { offset, tilt }).collect();
                Arc::new(Envelope::new(bearing, *film, &positions))
            }
            Self::Bore(Bore::Measured(path)) => Arc::new(measured(read_bore(path, covered)?)),
            Self::Shaft(Shaft::Measured(path)) => Arc::new(measured(read_shaft(path, covered)?)),
        })
    }
}

/// Measured surfaces of a film with their points; a file that cannot be read any more has been told when the film was
/// compiled.
fn measurements(scene: &Scene) -> impl Iterator<Item = (&Path, SurfacePoints)> {
    let covered = covered(scene);
    let bores = scene.bores.iter().filter_map(move |bore| match bore {
        Bore::Measured(path) => Some((path.as_path(), read_bore(path, covered).ok()?)),
        _ => None,
    });
    let shaft = scene.shaft.iter().filter_map(move |shaft| match shaft {
        Shaft::Measured(path) => Some((path.as_path(), read_shaft(path, covered).ok()?)),
        Shaft::Crown(_) => None,
    });
    bores.chain(shaft)
}

/// Depth and slopes of all surfaces together, in the worst places.
struct Worst {
    depth: f64,
    slope: f64,
}

fn worst(film: &Film) -> Worst {
    let bearing = &film.problem.bearing;
    let profiles = Sockets::of(&film.scene).profiles().unwrap_or_default();
    let [around, along] = PLACES;
    let places = (0..around).flat_map(|i| (0..along).map(move |j| [i, j]));
    let mut worst = Worst { depth: 0.0, slope: 0.0 };
    for [i, j] in places {
        let position = [
            TAU * bearing.radius * f64::from(i) / f64::from(around),
            bearing.length * (f64::from(j) / f64::from(along - 1) - 0.5),
        ];
        let (mut depth, mut slope) = (0.0, [0.0; 2]);
        for relief in profiles.iter().map(|profile| profile.at(position)) {
            depth += relief.depth;
            (0..2).for_each(|d| slope[d] += relief.slope[d]);
        }
        worst.depth = worst.depth.max(depth);
        worst.slope = worst.slope.max(slope[0].hypot(slope[1]));
    }
    worst
}

/// Pits as deep as the clearance, and steep walls.
fn limits(film: &Film) -> Vec<Warning> {
    let (Worst { depth, slope }, clearance) = (worst(film), film.problem.bearing.clearance);
    let deep = (depth >= clearance).then(|| {
        warning::DEEP.says(format!(
            "shapes of bore and shaft as small as the clearance: they are up to {} deep, and the clearance is {}; where the oil film is so much thicker its inertia counts, and the journal may have more than one position of rest",
            micrometres(depth),
            micrometres(clearance)
        ))
    });
    let steep = (slope > STEEP).then(|| {
        warning::STEEP.says(format!(
            "slopes of the surfaces far below one: bore and shaft have slopes up to {}, and Reynolds' equation holds below some {STEEP}; is the unit of a depth right?",
            readable(slope)
        ))
    });
    deep.into_iter().chain(steep).collect()
}

/// Points too far apart for the film, and noise that shows in it.
fn of_points(film: &Film, least: &Thinnest, path: &Path, points: &SurfacePoints) -> Vec<Warning> {
    let bearing = &film.problem.bearing;
    let film_length = (2.0 * least.thickness.max(0.0) / bearing.clearance).sqrt();
    let steps = points.angles.array_windows().map(|[a, b]| b - a);
    let step = steps.fold(0.0, f64::max);
    let coarse = (step > COARSE * film_length).then(|| {
        warning::COARSE_POINTS.says(format!(
            "points closer than the film changes: those of {} are up to {} apart, and the film changes over {} where it is thinnest; measure at more angles",
            path.display(),
            degrees(step),
            degrees(film_length)
        ))
    });
    let noise = points.noise();
    let noisy = (noise > NOISY * least.thickness).then(|| {
        warning::NOISY_POINTS.says(format!(
            "a measured surface without noise: neighbouring points of {} scatter by some {} (root mean square), and the least film is {}; smooth the measurement over the lengths that the film feels",
            path.display(),
            micrometres(noise),
            micrometres(least.thickness)
        ))
    });
    coarse.into_iter().chain(noisy).collect()
}
