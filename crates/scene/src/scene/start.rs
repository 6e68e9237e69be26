//! Where a computation begins.

use oilwedge_bearing::first_position;

use super::{CavitationModel, Position, Scene};

impl Scene {
    /// Eccentricity ratio and angle of the thinnest film [rad] that a computation begins with: those given, or those that a closed
    /// estimate finds for the load; [`super::Journal::middle`] where nothing turns.
    pub fn start(&self) -> (f64, f64) {
        let Position::Load { force, angle } = self.journal.position else {
            return self.journal.middle();
        };
        let (bearing, speed) = (&self.bearing, self.journal.speed);
        let psi = bearing.clearance / bearing.radius();
        let drag = self.oil.viscosity * speed.abs() / (psi * psi);
        let number = force / (drag * bearing.diameter * bearing.length);
        let full = self.cavitation.is_none_or(|it| it.model == CavitationModel::None);
        match first_position(number, bearing.length / bearing.diameter, full) {
            Some((eccentricity, attitude)) => (eccentricity, angle + speed.signum() * attitude),
            None => self.journal.middle(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use crate::Scene;

    #[test]
    fn heavy_loads_begin_near_contact_and_turn_with_the_speed() {
        let start = |force: &str, speed: &str| {
            let text = format!(
                "bearing = {{ diameter = \"75 mm\", length = \"37.5 mm\", clearance = \"37.5 um\" }}\n\
                 journal = {{ speed = \"{speed}\" }}\nload = {{ force = \"{force}\", angle = \"0 deg\" }}\n\
                 oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"reynolds\" }}\n"
            );
            Scene::parse(&text, Path::new("a.toml")).expect("a scene").start()
        };
        let (light, heavy) = (start("1 kN", "1000 rpm"), start("1 MN", "1000 rpm"));
        assert!(
            light.0 < 0.5 && heavy.0 > 0.98 && heavy.0 < 0.9999,
            "{light:?} {heavy:?}"
        );
        assert!(light.1 > heavy.1 && heavy.1 > 0.0);
        assert_eq!(start("1 kN", "-1000 rpm"), (light.0, -light.1));
        assert_eq!(start("1 kN", "0 rpm"), (0.5, std::f64::consts::FRAC_PI_4));
    }
}
