//! Which symmetries a film has by its geometry, and which numbers of a part they make zero.
//!
//! | symmetry | film | rotation | squeeze | tilt along | tilt across |
//! |---|---|---|---|---|---|
//! | ends swapped, z to -z | no tilt | even | even | odd | odd |
//! | mirrored about the line of centres | no tilt across it | odd | even | even | odd |
//! | both | no tilt along it | odd | even | odd | even |
//!
//! An even source makes an even pressure, and the integral of an even pressure with an odd weight is zero. An odd
//! source makes an odd pressure only where the film bears tension.

use std::f64::consts::TAU;

use oilwedge_scene::{CavitationModel, Feed, Scene};

use super::motion::{JournalMotion, PartMotion};

/// Differences of angles [rad] and of lengths, over those lengths, that are rounding.
const SAME: f64 = 1e-9;
/// Part of a tilt below which its other part is rounding.
const NO_TILT: f64 = 1e-12;

/// The sign that each symmetry gives to the source of a motion: ends swapped, mirrored, both.
const OF_MOTIONS: [[i8; 3]; 4] = [[1, -1, -1], [1, 1, 1], [-1, 1, -1], [-1, -1, 1]];
/// The sign that each symmetry gives to a weight: `cos`, `sin`, `z cos`, `z sin`.
const OF_WEIGHTS: [[i8; 3]; 4] = [[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]];

/// The symmetries of a film.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Symmetry {
    /// Ends swapped, mirrored about the line of centres, both.
    has: [bool; 3],
    /// The film bears tension, so that pressures add up.
    is_linear: bool,
}

impl Symmetry {
    /// The symmetries of a scene. Nothing is known of the liner of a mesh file.
    pub(super) fn of(scene: &Scene, motion: &JournalMotion) -> Self {
        let [along, across] = motion.gamma;
        let rounding = NO_TILT * along.hypot(across);
        let [no_along, no_across] = [along, across].map(|part| part.abs() <= rounding);
        let of_journal = [no_along && no_across, no_across, no_along];
        let angle = motion.angle;
        let of_liner = |[ends, mirrored]: [f64; 2]| is_symmetric(scene, SymmetryMap { ends, mirrored, angle });
        let liner = [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]].map(|map| scene.mesh.path().is_none() && of_liner(map));
        Self {
            has: [0, 1, 2].map(|k| of_journal[k] && liner[k]),
            is_linear: scene.cavitation.is_none_or(|it| it.model == CavitationModel::None),
        }
    }
}

/// Which of the four numbers of a film with these motions are zero.
pub(super) fn zeros(symmetry: &Symmetry, motions: &[PartMotion]) -> [bool; 4] {
    let sign = |motion: &PartMotion, k: usize| OF_MOTIONS[motion.index()][k];
    let vanishes = |motions: &[PartMotion], weight: usize| {
        (0..3).filter(|&k| symmetry.has[k]).any(|k| {
            let all = |wanted: i8| motions.iter().all(|motion| sign(motion, k) == wanted);
            let of_weight = OF_WEIGHTS[weight][k];
            (all(1) && of_weight == -1) || (symmetry.is_linear && all(-1) && of_weight == 1)
        })
    };
    [0, 1, 2, 3].map(|weight| {
        let each = || motions.iter().all(|&motion| vanishes(&[motion], weight));
        vanishes(motions, weight) || (symmetry.is_linear && each())
    })
}

/// Maps the liner to itself: z to `ends` times z, angles to `mirrored` times themselves, from the line of centres at
/// `angle`.
#[derive(Clone, Copy)]
struct SymmetryMap {
    ends: f64,
    mirrored: f64,
    angle: f64,
}

impl SymmetryMap {
    fn angle(&self, angle: f64) -> f64 {
        self.angle + self.mirrored * (angle - self.angle)
    }
}

fn same_angle(a: f64, b: f64) -> bool {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() * TAU < SAME
}

fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= SAME * a.abs().max(b.abs())
}

fn is_symmetric(scene: &Scene, map: SymmetryMap) -> bool {
    let is_mirrored = map.mirrored < 0.0;
    let arc = scene.bearing.arc.is_none_or(|arc| {
        let middle = 0.5 * (arc.from + arc.to);
        !is_mirrored || same_angle(map.angle(middle), middle)
    });
    let line = scene.bearing.film_start.is_none_or(|start| same_angle(map.angle(start), start));
    let feeds = || scene.feeds.iter().all(|feed| scene.feeds.iter().any(|other| is_image(feed, other, map)));
    arc && line && feeds()
}

/// True if the map turns one feed into the other.
fn is_image(feed: &Feed, other: &Feed, map: SymmetryMap) -> bool {
    let lengths = |a: [f64; 2], b: [f64; 2]| same(a[0], b[0]) && same(a[1], b[1]);
    let shape = match (feed.hole, other.hole, feed.groove, other.groove) {
        (Some(a), Some(b), None, None) => {
            lengths([a.diameter, map.ends * a.z], [b.diameter, b.z]) && same_angle(map.angle(a.angle), b.angle)
        }
        (None, None, Some(a), Some(b)) => {
            let arcs = match (a.arc, b.arc) {
                (None, None) => true,
                (Some(a), Some(b)) => {
                    let middle = |arc: oilwedge_scene::Arc| 0.5 * (arc.from + arc.to);
                    let length = |arc: oilwedge_scene::Arc| arc.to - arc.from;
                    same_angle(map.angle(middle(a)), middle(b)) && (length(a) - length(b)).abs() < SAME
                }
                _ => false,
            };
            arcs && lengths([a.width, map.ends * a.z], [b.width, b.z]) && same(a.corner, b.corner)
        }
        _ => false,
    };
    shape && feed.pressure == other.pressure && feed.depth == other.depth
}

#[cfg(test)]
mod tests {
    use super::super::motion::PARTS;
    use super::*;
    use std::path::Path;

    fn symmetry(bearing: &str, keys: &str) -> Symmetry {
        let text = format!(
            "bearing = {{ diameter = \"100 mm\", length = \"50 mm\", clearance = \"50 um\"{bearing} }}\noil.viscosity = \"20 mPa.s\"\n\
             cavitation.model = \"reynolds\"\njournal.speed = \"30 rad/s\"\njournal.eccentricity = 0.6\njournal.min_film_angle = \"30 deg\"\n{keys}"
        );
        let scene = oilwedge_study::parse(&text, Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
        Symmetry::of(&scene, &JournalMotion::of(&scene))
    }

    fn has(bearing: &str, keys: &str) -> [bool; 3] {
        symmetry(bearing, keys).has
    }

    #[test]
    fn a_tilt_takes_symmetries_away() {
        assert_eq!(has("", ""), [true; 3]);
        // 30 degrees: along (cos, sin), across (-sin, cos).
        let along = "journal.tilt = { x = \"0.08660254037844387 mrad\", y = \"0.05 mrad\" }";
        let across = "journal.tilt = { x = \"-0.05 mrad\", y = \"0.08660254037844387 mrad\" }";
        assert_eq!(has("", along), [false, true, false]);
        assert_eq!(has("", across), [false, false, true]);
        assert_eq!(has("", "journal.tilt = { x = \"0.1 mrad\" }"), [false; 3]);
    }

    #[test]
    fn the_liner_takes_symmetries_away() {
        let only_ends = [true, false, false];
        assert_eq!(has(", film_start = \"210 deg\"", ""), [true; 3]);
        assert_eq!(has(", film_start = \"200 deg\"", ""), only_ends);
        assert_eq!(has(", arc = { from = \"-50 deg\", to = \"110 deg\" }", ""), [true; 3]);
        assert_eq!(has(", arc = { from = \"0 deg\", to = \"110 deg\" }", ""), only_ends);
        let hole = |angle: f64, z: f64| {
            format!(
                "[[feed]]\ngroup = \"h{angle}{z}\"\nhole = {{ diameter = \"5 mm\", angle = \"{angle} deg\", z = \"{z} mm\" }}\npressure = \"0 bar\"\n"
            )
        };
        assert_eq!(has("", &hole(210.0, 0.0)), [true; 3]);
        assert_eq!(has("", &hole(200.0, 0.0)), only_ends);
        assert_eq!(has("", &hole(210.0, 5.0)), [false, true, false]);
        assert_eq!(has("", &(hole(200.0, 5.0) + &hole(220.0, -5.0))), [false, false, true]);
        let groove = "[[feed]]\ngroup = \"g\"\ngroove = { from = \"200 deg\", to = \"220 deg\", width = \"10 mm\" }\npressure = \"0 bar\"\n";
        assert_eq!(has("", groove), [true; 3]);
    }

    /// A parallel journal in a plain ring has seven numbers that are not zero.
    #[test]
    fn nine_of_sixteen_are_zero_in_a_plain_ring() {
        let plain = symmetry("", "");
        let zero = PARTS.map(|part| zeros(&plain, &[part]));
        let wanted = [
            [false, false, true, true],
            [false, true, true, true],
            [false, true, false, true],
            [false, true, true, false],
        ];
        assert_eq!(zero, wanted);
        // Rotation and squeeze together have no moment, but a force across.
        assert_eq!(zeros(&plain, &PARTS[..2]), [false, false, true, true]);
        assert_eq!(zeros(&plain, &PARTS), [false; 4]);
        // Without a cavity the force of a tilt and the force of rotation along the line of centres vanish too.
        let full = Symmetry { is_linear: true, ..plain };
        assert_eq!(zeros(&full, &PARTS[..1]), [true, false, true, true]);
        assert_eq!(zeros(&full, &PARTS[2..3]), [true, true, false, true]);
        assert_eq!(zeros(&full, &PARTS[3..]), [true, true, true, false]);
    }
}
