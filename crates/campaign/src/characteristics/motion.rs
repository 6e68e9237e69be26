//! How the journal moves, in the four motions that a film knows, and scenes with one of them.

use oilwedge_reynolds::CentreVelocity;
use oilwedge_scene::{PositionTable, Scene};
use oilwedge_study::effects::Sockets;

/// One motion of the journal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PartMotion {
    /// The journal turns.
    Rotation,
    /// The centre of the journal moves along the line of centres.
    Squeeze,
    /// The axis of the journal tilts along the line of centres.
    TiltAlong,
    /// The axis of the journal tilts across the line of centres.
    TiltAcross,
}

/// All motions, in the order of reports.
pub(super) const PARTS: [PartMotion; 4] =
    [PartMotion::Rotation, PartMotion::Squeeze, PartMotion::TiltAlong, PartMotion::TiltAcross];

impl PartMotion {
    /// Place of the motion among [`PARTS`].
    pub(super) fn index(self) -> usize {
        self as usize
    }

    /// Name of the motion in reports.
    pub(super) fn name(self) -> &'static str {
        ["rotation", "squeeze", "tilt_along", "tilt_across"][self.index()]
    }

    /// Symbol and definition of its rate.
    pub(super) fn symbol(self) -> &'static str {
        ["u = omega - 2 beta'", "s = eps'", "g_x = gamma_x'", "g_y = gamma_y'"][self.index()]
    }

    /// Makes it the only motion of a scene, at a rate [1/s].
    pub(super) fn alone(self, scene: &mut Scene, motion: &JournalMotion, rate: f64) {
        let clearance = scene.bearing.clearance;
        let slope = rate * clearance / scene.bearing.radius();
        let journal = &mut scene.journal;
        let tilting = |direction: [f64; 2]| Some(direction.map(|part| slope * part));
        journal.tilt.get_or_insert_default();
        let only = |motion: Self, rate: f64| if motion == self { rate } else { 0.0 };
        journal.speed = only(Self::Rotation, rate);
        journal.squeeze_along(only(Self::Squeeze, rate * clearance));
        journal.tilt_rate = match self {
            Self::TiltAlong => tilting(motion.along),
            Self::TiltAcross => tilting(motion.across()),
            _ => None,
        };
    }
}

/// How a journal stands and moves, in the frame of its line of centres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct JournalMotion {
    /// Offset over the clearance [1].
    pub(super) eccentricity: f64,
    /// Direction of the line of centres [rad].
    pub(super) angle: f64,
    /// Unit vector there.
    pub(super) along: [f64; 2],
    /// Tilt along and across the line of centres, times R/c [1].
    pub(super) gamma: [f64; 2],
    /// Rates of the four motions [1/s]: u, eps', gamma_x', gamma_y', the last two in the frame that turns with the line
    /// of centres.
    pub(super) rates: [f64; 4],
}

impl JournalMotion {
    /// The motion of a scene at a given position.
    pub(super) fn of(scene: &Scene) -> Self {
        let (eccentricity, angle) = match scene.journal.position {
            PositionTable::Given { eccentricity, min_film_angle } => (eccentricity, min_film_angle),
            PositionTable::Load { .. } | PositionTable::Cycle => (0.0, 0.0),
        };
        let (sin, cos) = angle.sin_cos();
        let clearance = scene.bearing.clearance;
        let per_slope = scene.bearing.radius() / clearance;
        let turned = |[x, y]: [f64; 2]| [cos * x + sin * y, cos * y - sin * x].map(|part| per_slope * part);
        let gamma = turned(scene.journal.tilt.unwrap_or_default());
        let CentreVelocity { radial, tangential } = Sockets::of(scene).centre_velocity;
        // Of a centred journal the line of centres does not turn.
        let turning = match eccentricity > 0.0 {
            true => tangential / (eccentricity * clearance),
            false => 0.0,
        };
        let [along, across] = turned(scene.journal.tilt_rate.unwrap_or_default());
        Self {
            eccentricity,
            angle,
            along: [cos, sin],
            gamma,
            rates: [
                scene.journal.speed - 2.0 * turning,
                radial / clearance,
                along + turning * gamma[1],
                across - turning * gamma[0],
            ],
        }
    }

    /// Unit vector across the line of centres, towards growing angles.
    pub(super) fn across(&self) -> [f64; 2] {
        let [cos, sin] = self.along;
        [-sin, cos]
    }

    /// True if the gap is the same everywhere.
    pub(super) fn is_concentric(&self) -> bool {
        self.eccentricity == 0.0 && self.gamma == [0.0; 2]
    }

    /// The rate [1/s] at which the film of a part is solved: that of the scene or, where it is zero, the greatest of
    /// the others.
    pub(super) fn used(&self, part: PartMotion) -> f64 {
        let own = self.rates[part.index()];
        let greatest = self.rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
        match (own == 0.0, greatest == 0.0) {
            (false, _) => own,
            (true, false) => greatest,
            (true, true) => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn motion(journal: &str) -> JournalMotion {
        let text = format!(
            "bearing = {{ diameter = \"100 mm\", length = \"50 mm\", clearance = \"50 um\" }}\noil.viscosity = \"20 mPa.s\"\n\
             [journal]\nspeed = \"30 rad/s\"\n{journal}"
        );
        let scene = oilwedge_study::parse(&text, Path::new("a.toml")).unwrap_or_else(|error| panic!("{error}"));
        JournalMotion::of(&scene)
    }

    /// Offset and tilt that turn together are a rotation the other way, twice as fast.
    #[test]
    fn turning_is_rotation() {
        // eps 0.6 towards 90 degrees, gamma = 0.2 along it; both turn at 5 rad/s.
        let turning = motion(
            "eccentricity = 0.6\nmin_film_angle = \"90 deg\"\ntilt = { y = \"0.2 mrad\" }\n\
             squeeze = { radial = \"0.1 mm/s\", tangential = \"0.15 mm/s\" }\ntilt_rate = { x = \"-0.001 rad/s\" }",
        );
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}: {turning:?}");
        close(turning.gamma[0], 0.2);
        close(turning.rates[0], 30.0 - 2.0 * 5.0);
        close(turning.rates[1], 2.0);
        close(turning.rates[2], 0.0);
        close(turning.rates[3], 0.0);
    }

    #[test]
    fn a_part_without_a_rate_is_solved_at_another() {
        let rotating = motion("eccentricity = 0.6\nmin_film_angle = \"0 deg\"");
        assert_eq!(PARTS.map(|part| rotating.used(part)), [30.0; 4]);
        let sinking = motion("eccentricity = 0.6\nmin_film_angle = \"0 deg\"\nsqueeze = { radial = \"-5 mm/s\" }");
        for (used, wanted) in PARTS.map(|part| sinking.used(part)).into_iter().zip([30.0, -100.0, 100.0, 100.0]) {
            assert!((used - wanted).abs() < 1e-9, "{used} {wanted}");
        }
    }
}
