//! Position of the journal, from which computations begin.

use std::f64::consts::FRAC_PI_4;

use oilwedge_bearing::{Coordinates, OperatingPoint, Vector, Visited, first_contact, first_position, predicted};
use oilwedge_reynolds::{Bearing, Cavitation, JournalState};
use oilwedge_scene::PositionTable as Placed;

use crate::model::Model;
use crate::oil::Oil;

/// Eccentricity ratio at which the search for the position under a load begins where nothing is known.
const START_ECCENTRICITY: f64 = 0.5;
/// Angle [rad] from the load to the journal's offset, against the rotation, at which it begins.
const START_ATTITUDE: f64 = FRAC_PI_4;

/// A journal that would leave less of the film than this part of what its tilt leaves of the clearance is moved towards
/// the middle.
const ROOM: f64 = 0.1;

/// Position of the journal: where its centre is at mid-length, and how its axis is inclined.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Position {
    /// Offset over the clearance [1].
    pub eccentricity: f64,
    /// Angle of the offset at mid-length [rad].
    pub min_film_angle: f64,
    /// Slope of the axis towards x and y [rad].
    pub tilt: [f64; 2],
}

impl Position {
    /// The position of a journal in a bearing with this clearance [m].
    pub fn of(journal: &JournalState, clearance: f64) -> Self {
        Self {
            eccentricity: journal.eccentricity() / clearance,
            min_film_angle: journal.min_film_angle(),
            tilt: journal.tilt,
        }
    }

    /// What this position is at the axial position `z` [m] of a bearing with this clearance [m].
    pub fn at(self, z: f64, clearance: f64) -> Self {
        if self.tilt == [0.0; 2] {
            return self;
        }
        let journal = JournalState {
            tilt: self.tilt,
            ..JournalState::at_eccentricity(self.eccentricity, self.min_film_angle, clearance, 0.0)
        };
        let offset = journal.offset_at(z);
        Self::of(&JournalState { offset, ..journal }, clearance)
    }

    /// Where the journal of a model under a load will be, predicted from positions visited before; `None` where there
    /// are none.
    pub fn predicted(model: &Model, visited: &[Visited], point: OperatingPoint) -> Option<Self> {
        let predicted = predicted(visited, point)?;
        let position = Self {
            eccentricity: predicted.eccentricity,
            min_film_angle: predicted.angle,
            tilt: match model.sockets.tilting {
                Some(_) => predicted.tilt,
                None => model.tilt,
            },
        };
        Some(position.clear_of_the_ends(&model.mesh.bearing))
    }

    /// This position as one that a search visited at an operating point.
    pub fn visited(&self, point: OperatingPoint) -> Visited {
        Visited { point, eccentricity: self.eccentricity, angle: self.min_film_angle, tilt: self.tilt }
    }

    /// This position or, where its tilt makes the journal touch an end or nearly so, one nearer the middle.
    fn clear_of_the_ends(self, bearing: &Bearing) -> Self {
        if self.tilt == [0.0; 2] {
            return self;
        }
        let journal = JournalState { tilt: self.tilt, ..JournalState::default() };
        let reach = bearing.reach(&journal, self.min_film_angle) / bearing.clearance;
        Self { eccentricity: self.eccentricity.min((1.0 - ROOM) * reach), ..self }
    }

    /// The position at which a computation begins: the one given, or the one that a closed estimate finds for the load;
    /// [`Self::middle`] where nothing turns.
    pub fn start(model: &Model) -> Self {
        let (bearing, speed) = (&model.mesh.bearing, model.scope.speed);
        let Placed::Load { force, angle } = model.placed else {
            return Self::middle(model);
        };
        let diameter = 2.0 * bearing.radius;
        let psi = bearing.clearance / bearing.radius;
        let drag = model.oil.viscosity * speed.abs() / (psi * psi);
        let number = force / (drag * diameter * bearing.length);
        let full = matches!(model.sockets.cavitation, Cavitation::None);
        let by_film = first_position(number, bearing.length / diameter, full);
        // Both together carry more than each of them.
        let by_contact = (model.sockets.contact.as_ref()).map(|contact| first_contact(&*contact.law, bearing, force));
        let (eccentricity, attitude) = match (by_film, by_contact) {
            (Some((film, attitude)), Some(contact)) => (film.min(contact), attitude),
            (Some(found), None) => found,
            (None, Some(contact)) => (contact, 0.0),
            (None, None) => return Self::middle(model),
        };
        let position = Self { eccentricity, min_film_angle: angle + speed.signum() * attitude, tilt: model.tilt };
        position.clear_of_the_ends(bearing)
    }

    /// The position at which a computation begins where nothing else is known: the one given, for a load eps = 0.5 at
    /// 45 degrees from the load in the sense of the rotation, and under a load that changes the middle of the bearing.
    pub fn middle(model: &Model) -> Self {
        let tilt = model.tilt;
        match model.placed {
            Placed::Given { eccentricity, min_film_angle } => Self { eccentricity, min_film_angle, tilt },
            // The orbit is not known yet: a mesh is graded as for a journal in the middle.
            Placed::Cycle => Self { eccentricity: 0.0, min_film_angle: 0.0, tilt },
            Placed::Load { angle, .. } => {
                let sense = if model.scope.speed < 0.0 { -1.0 } else { 1.0 };
                let position =
                    Self { eccentricity: START_ECCENTRICITY, min_film_angle: angle + sense * START_ATTITUDE, tilt };
                position.clear_of_the_ends(&model.mesh.bearing)
            }
        }
    }
}

/// The state of a film for which a mesh is graded, and from which its search begins.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmState {
    /// Position of the journal.
    pub position: Position,
    /// The oil at the temperature of the film.
    pub oil: Oil,
}

impl Model {
    /// The state in which a computation begins.
    pub fn start(&self) -> FilmState {
        self.state_at(Position::start(self))
    }

    /// The position of a journal at these coordinates; a tilt that is given stays.
    pub(crate) fn position_at(&self, coordinates: &Coordinates, place: Vector) -> Position {
        let parallel = JournalState { tilt: self.tilt, ..JournalState::default() };
        Position::of(&coordinates.placed(&parallel, place), self.mesh.bearing.clearance)
    }

    /// The state with the journal at `position`.
    pub fn state_at(&self, position: Position) -> FilmState {
        FilmState { position, oil: self.oil.clone() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;
    use std::sync::Arc;

    fn model(keys: &str) -> Arc<Model> {
        let text = format!(
            "bearing = {{ diameter = \"75 mm\", length = \"37.5 mm\", clearance = \"37.5 um\" }}\n{keys}\n\
             oil = {{ viscosity = \"20 mPa.s\" }}\ncavitation = {{ model = \"reynolds\" }}\n"
        );
        crate::compile::compile(&crate::parse(&text, Path::new("a.toml")).expect("a scene")).expect("a model")
    }

    fn loaded(force: &str, speed: &str) -> Arc<Model> {
        model(&format!("journal = {{ speed = \"{speed}\" }}\nload = {{ force = \"{force}\", angle = \"0 deg\" }}"))
    }

    fn at(eccentricity: f64, min_film_angle: f64) -> Position {
        Position { eccentricity, min_film_angle, tilt: [0.0; 2] }
    }

    #[test]
    fn the_middle_is_the_position_or_lies_behind_the_load() {
        let given = model("journal = { speed = \"1 rpm\", eccentricity = 0.6, min_film_angle = \"3 rad\" }");
        assert_eq!((Position::middle(&given), Position::start(&given)), (at(0.6, 3.0), at(0.6, 3.0)));
        for (speed, sense) in [("10 rpm", 1.0), ("-10 rpm", -1.0), ("0 rpm", 1.0)] {
            assert_eq!(Position::middle(&loaded("5 kN", speed)), at(0.5, sense * FRAC_PI_4));
        }
    }

    #[test]
    fn a_tilted_journal_begins_clear_of_the_ends() {
        let tilted = model(
            "journal = { speed = \"1000 rpm\", tilt = { x = \"1.5 mrad\" } }\nload = { force = \"1 MN\", angle = \"0 deg\" }",
        );
        let start = Position::start(&tilted);
        // Half of the length times the tilt is 0.75 of the clearance.
        assert!((start.tilt, start.eccentricity < 0.6) == ([1.5e-3, 0.0], true), "{start:?}");
        let end = start.at(0.01875, 37.5e-6);
        assert!(end.eccentricity < 0.98 && end.eccentricity > 0.7, "{end:?}");
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
        assert_eq!(start("1 kN", "-1000 rpm"), at(light.eccentricity, -light.min_film_angle));
        assert_eq!(start("1 kN", "0 rpm"), at(0.5, FRAC_PI_4));
    }
}
