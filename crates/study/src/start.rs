//! Where the search for a position begins.

use std::f64::consts::FRAC_PI_4;

use oilwedge_bearing::first_position;
use oilwedge_scene::{CavitationModel, Journal, Position, Scene};

use crate::oil::Oil;

/// Eccentricity ratio at which the search for the position under a load begins where nothing is known.
const START_ECCENTRICITY: f64 = 0.5;
/// Angle [rad] from the load to the thinnest film, against the rotation, at which it begins.
const START_ATTITUDE: f64 = FRAC_PI_4;

/// Eccentricity ratio and angle of the thinnest film [rad] at which a computation begins: those given, or those that a closed
/// estimate finds for the load; [`middle`] where nothing turns.
pub fn start(scene: &Scene) -> (f64, f64) {
    let (bearing, speed) = (&scene.bearing, scene.journal.speed);
    let Position::Load { force, angle } = scene.journal.position else {
        return middle(&scene.journal);
    };
    let psi = bearing.clearance / bearing.radius();
    let drag = Oil::of(scene).viscosity * speed.abs() / (psi * psi);
    let number = force / (drag * bearing.diameter * bearing.length);
    let full = scene.cavitation.is_none_or(|it| it.model == CavitationModel::None);
    match first_position(number, bearing.length / bearing.diameter, full) {
        Some((eccentricity, attitude)) => (eccentricity, angle + speed.signum() * attitude),
        None => middle(&scene.journal),
    }
}

/// Eccentricity ratio and angle of the thinnest film [rad] at which a computation begins where nothing else is known: those
/// given, or for a load eps = 0.5 at 45 degrees from the load in the sense of the rotation.
pub fn middle(journal: &Journal) -> (f64, f64) {
    match journal.position {
        Position::Given {
            eccentricity,
            min_film_angle,
        } => (eccentricity, min_film_angle),
        Position::Load { angle, .. } => {
            let sense = if journal.speed < 0.0 { -1.0 } else { 1.0 };
            (START_ECCENTRICITY, angle + sense * START_ATTITUDE)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    #[test]
    fn the_middle_is_the_position_or_lies_behind_the_load() {
        let at = |speed, position| {
            middle(&Journal {
                speed,
                position,
                squeeze: None,
            })
        };
        let given = Position::Given {
            eccentricity: 0.6,
            min_film_angle: 3.0,
        };
        assert_eq!(at(10.0, given), (0.6, 3.0));
        let load = Position::Load { force: 5e3, angle: 1.5 };
        for (speed, sense) in [(10.0, 1.0), (-10.0, -1.0), (0.0, 1.0), (-0.0, 1.0)] {
            assert_eq!(at(speed, load), (0.5, 1.5 + sense * FRAC_PI_4));
        }
    }

    #[test]
    fn heavy_loads_begin_near_contact_and_turn_with_the_speed() {
        let start = |force: &str, speed: &str| {
            let text = format!(
                "bearing = {{ diameter = \"75 mm\", length = \"37.5 mm\", clearance = \"37.5 um\" }}\n\
                 journal = {{ speed = \"{speed}\" }}\nload = {{ force = \"{force}\", angle = \"0 deg\" }}\n\
                 oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"reynolds\" }}\n"
            );
            start(&crate::parse(&text, Path::new("a.toml")).expect("a scene"))
        };
        let (light, heavy) = (start("1 kN", "1000 rpm"), start("1 MN", "1000 rpm"));
        assert!(
            light.0 < 0.5 && heavy.0 > 0.98 && heavy.0 < 0.9999,
            "{light:?} {heavy:?}"
        );
        assert!(light.1 > heavy.1 && heavy.1 > 0.0);
        assert_eq!(start("1 kN", "-1000 rpm"), (light.0, -light.1));
        assert_eq!(start("1 kN", "0 rpm"), (0.5, FRAC_PI_4));
    }
}
