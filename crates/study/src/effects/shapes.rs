//! Surfaces that are no circles: a crowned, oval, worn or measured bore, a crowned or measured journal.

use std::f64::consts::TAU;
use std::path::Path;

use oilwedge_reynolds::Thinnest;
use oilwedge_reynolds::existence::readable;
use oilwedge_scene::surface_table::{SurfacePoints, read_bore, read_shaft};
use oilwedge_scene::wording::{degrees, micrometres};
use oilwedge_scene::{Bore, JournalShape};

use super::{BLANK, Effect, ShapedSurface, Socket, changed};
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
        let bores = scene.bores.iter().cloned().map(ShapedSurface::Bore);
        sockets.surfaces.extend(bores.chain(scene.shaft.iter().cloned().map(ShapedSurface::Shaft)));
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
        let by_points = measurements(film).flat_map(of_points);
        limits(film).into_iter().chain(by_points).collect()
    },
    ..BLANK
};

/// Measured surfaces of a film with their points; a file that cannot be read any more has been told when the film was
/// compiled.
fn measurements(film: &Film) -> impl Iterator<Item = (&Path, SurfacePoints)> {
    let covered = film.model.covered;
    film.model.sockets.surfaces.iter().filter_map(move |surface| match surface {
        ShapedSurface::Bore(Bore::Measured(path)) => Some((path.as_path(), read_bore(path, covered).ok()?)),
        ShapedSurface::Shaft(JournalShape::Measured(path)) => Some((path.as_path(), read_shaft(path, covered).ok()?)),
        _ => None,
    })
}

/// Depth and slopes of all surfaces together, in the worst places.
struct Worst {
    depth: f64,
    slope: f64,
}

fn worst(film: &Film) -> Worst {
    let bearing = &film.problem.bearing;
    let profiles = &film.model.mesh.profiles;
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
