//! Where the journal is, and where a computation begins.

use std::f64::consts::FRAC_PI_4;

use oilwedge_bearing::first_position;
use oilwedge_reynolds::JournalState;
use oilwedge_scene::{self as scene, CavitationModel, Scene};

use crate::oil::Oil;

/// Eccentricity ratio at which the search for the position under a load begins where nothing is known.
const START_ECCENTRICITY: f64 = 0.5;
/// Angle [rad] from the load to the thinnest film, against the rotation, at which it begins.
const START_ATTITUDE: f64 = FRAC_PI_4;

/// Position of the journal's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// Offset over the clearance [1].
    pub eccentricity: f64,
    /// Angle of the thinnest film [rad].
    pub min_film_angle: f64,
}

impl Position {
    /// That of a journal in a bearing with this clearance [m].
    pub fn of(journal: &JournalState, clearance: f64) -> Self {
        Self {
            eccentricity: journal.eccentricity() / clearance,
            min_film_angle: journal.min_film_angle(),
        }
    }

    /// The position at which a computation begins: the one given, or the one that a closed estimate finds for the load; [`Self::middle`]
    /// where nothing turns.
    pub fn start(scene: &Scene) -> Self {
        let (bearing, speed) = (&scene.bearing, scene.journal.speed);
        let scene::Position::Load { force, angle } = scene.journal.position else {
            return Self::middle(scene);
        };
        let psi = bearing.clearance / bearing.radius();
        let drag = Oil::of(scene).viscosity * speed.abs() / (psi * psi);
        let number = force / (drag * bearing.diameter * bearing.length);
        let full = scene.cavitation.is_none_or(|it| it.model == CavitationModel::None);
        match first_position(number, bearing.length / bearing.diameter, full) {
            Some((eccentricity, attitude)) => Self {
                eccentricity,
                min_film_angle: angle + speed.signum() * attitude,
            },
            None => Self::middle(scene),
        }
    }

    /// The position at which a computation begins where nothing else is known: the one given, or for a load eps = 0.5 at 45 degrees from
    /// the load in the sense of the rotation.
    pub fn middle(scene: &Scene) -> Self {
        match scene.journal.position {
            scene::Position::Given {
                eccentricity,
                min_film_angle,
            } => Self {
                eccentricity,
                min_film_angle,
            },
            scene::Position::Load { angle, .. } => {
                let sense = if scene.journal.speed < 0.0 { -1.0 } else { 1.0 };
                Self {
                    eccentricity: START_ECCENTRICITY,
                    min_film_angle: angle + sense * START_ATTITUDE,
                }
            }
        }
    }
}

impl From<(f64, f64)> for Position {
    /// From the eccentricity ratio and the angle [rad] of the thinnest film.
    fn from((eccentricity, min_film_angle): (f64, f64)) -> Self {
        Self {
            eccentricity,
            min_film_angle,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn scene(keys: &str) -> Scene {
        let text = format!(
            "bearing = {{ diameter = \"75 mm\", length = \"37.5 mm\", clearance = \"37.5 um\" }}\n{keys}\n\
             oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"reynolds\" }}\n"
        );
        crate::parse(&text, Path::new("a.toml")).expect("a scene")
    }

    fn loaded(force: &str, speed: &str) -> Scene {
        scene(&format!(
            "journal = {{ speed = \"{speed}\" }}\nload = {{ force = \"{force}\", angle = \"0 deg\" }}"
        ))
    }

    fn at(eccentricity: f64, min_film_angle: f64) -> Position {
        Position {
            eccentricity,
            min_film_angle,
        }
    }

    #[test]
    fn the_middle_is_the_position_or_lies_behind_the_load() {
        let given = scene("journal = { speed = \"1 rpm\", eccentricity = 0.6, min_film_angle = \"3 rad\" }");
        assert_eq!(
            (Position::middle(&given), Position::start(&given)),
            (at(0.6, 3.0), at(0.6, 3.0))
        );
        for (speed, sense) in [("10 rpm", 1.0), ("-10 rpm", -1.0), ("0 rpm", 1.0)] {
            assert_eq!(Position::middle(&loaded("5 kN", speed)), at(0.5, sense * FRAC_PI_4));
        }
    }

    #[test]
    fn heavy_loads_begin_near_contact_and_turn_with_the_speed() {
        let start = |force, speed| Position::start(&loaded(force, speed));
        let (light, heavy) = (start("1 kN", "1000 rpm"), start("1 MN", "1000 rpm"));
        assert!(
            light.eccentricity < 0.5 && heavy.eccentricity > 0.98 && heavy.eccentricity < 0.9999,
            "{light:?} {heavy:?}"
        );
        assert!(light.min_film_angle > heavy.min_film_angle && heavy.min_film_angle > 0.0);
        assert_eq!(
            start("1 kN", "-1000 rpm"),
            at(light.eccentricity, -light.min_film_angle)
        );
        assert_eq!(start("1 kN", "0 rpm"), at(0.5, FRAC_PI_4));
    }
}
