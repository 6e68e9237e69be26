//! The standard's twin: what ISO 7902 and DIN 31652 give for the bearing of a scene, beside its own film.
//!
//! Both are given the same: the load where the scene has one, else the eccentricity; and the viscosity of the film. A groove all around
//! makes two bearings of the lands beside it, each with half of the load. The fits and their range: [`iso7902`].

use oilwedge_reynolds::analytical::iso7902;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use serde::Serialize;

use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::{CentreVelocity, Theory};
use oilwedge_scene::Scene;
use oilwedge_study::effects::Sockets;
use oilwedge_study::oil::Oil;
use oilwedge_study::quantities::{self, Row};
use oilwedge_study::result::RunResult;

mod feed;
mod twin;

use feed::{fed, told};
pub use twin::StandardHeat;
use twin::{Given, Twin, own_heat};

/// B/D for which the fits were made.
const SLENDERNESS: [f64; 2] = [0.25, 1.5];
/// Eccentricities for which they were made.
const ECCENTRICITY: [f64; 2] = [0.1, 0.95];
/// What the standard says, and the film.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Standard {
    /// What both were given: `load` or `eccentricity`; `null` where the standard has no such bearing.
    pub given: Option<&'static str>,
    /// Viscosity [Pa.s] with which the standard was asked.
    pub viscosity: f64,
    /// The feed in the words of the standard; `null` where it has none like that, or the scene has none.
    pub feed: Option<String>,
    /// Q_3 [m3/s], what the narrowing film presses out at the ends; `null` without a twin.
    pub squeezed_flow: Option<f64>,
    /// Q_p [m3/s], what the pressure of the feed presses through; `null` where there is no such feed.
    pub pressed_flow: Option<f64>,
    /// The numbers, in the order of the report.
    pub numbers: Vec<Beside>,
    /// The standard's own balance of heat; `null` without `[heat]`, and where it has no such flow or no balance.
    pub heat: Option<StandardHeat>,
    /// What keeps the two apart, in sentences; or why there is no twin.
    pub notes: Vec<String>,
}

/// A number of the standard and that of the film.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Beside {
    /// Name of the quantity in the result.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: String,
    /// What the standard gives, in that unit.
    pub standard: f64,
    /// What the film gives.
    pub film: f64,
    /// Error bar of the film's number; `null` where there is none.
    pub error: Option<f64>,
    /// The standard's number less that of the film.
    pub difference: f64,
}

impl Beside {
    /// The difference over the film's number; none of an angle, or where that is zero.
    pub fn relative(&self) -> Option<f64> {
        (self.unit != "deg" && self.film != 0.0).then(|| self.difference / self.film.abs())
    }
}

impl Standard {
    fn none(viscosity: f64, reason: &str) -> Self {
        Self {
            given: None,
            viscosity,
            feed: None,
            squeezed_flow: None,
            pressed_flow: None,
            numbers: Vec::new(),
            heat: None,
            notes: vec![format!("the standard has no such bearing: {reason}")],
        }
    }
}

/// The twin of a scene whose run ended with this result.
pub fn standard(scene: &Scene, result: &RunResult) -> Standard {
    let value = |row: &Row| result.quantity(row).map(|quantity| quantity.value);
    let oil = Oil::of(scene);
    let viscosity = match (&scene.heat, value(&quantities::TEMPERATURE_EFFECTIVE)) {
        (Some(_), Some(celsius)) => oil.at(celsius + ZERO_CELSIUS).viscosity,
        _ => oil.viscosity,
    };
    let none = |reason: &str| Standard::none(viscosity, reason);
    if scene.bearing.arc.is_some() {
        return none("its fits are those of full bearings, but this one is an arc");
    }
    if scene.journal.speed == 0.0 {
        return none("the journal is at rest");
    }
    let (Some(load), Some(eccentricity)) = (value(&quantities::LOAD), value(&quantities::ECCENTRICITY)) else {
        return none("there is no film");
    };
    let given = match scene.journal.load().is_some() {
        true => Given::Load(load),
        false => Given::Eccentricity(eccentricity),
    };
    let feed = fed(scene, value(&quantities::LOAD_ANGLE).unwrap_or_default());
    let Some(twin) = Twin::of(scene, viscosity, given, &feed) else {
        return none("the film carries no load");
    };
    let mut notes = notes(scene, &twin);
    notes.extend(feed.as_ref().err().cloned());
    Standard {
        given: Some(given.name()),
        viscosity,
        feed: (feed.as_ref().ok())
            .and_then(|feed| feed.as_ref())
            .map(|(kind, _)| told(*kind).to_owned()),
        squeezed_flow: Some(twin.squeezed),
        pressed_flow: twin.pressed,
        numbers: beside(scene, result, &twin, given),
        heat: own_heat(scene, given, &feed),
        notes,
    }
}

/// The numbers of the twin beside those of the film.
fn beside(scene: &Scene, result: &RunResult, twin: &Twin, given: Given) -> Vec<Beside> {
    let of_load = matches!(given, Given::Load(_));
    let under = |number: f64| of_load.then_some(number);
    let at = |number: f64| (!of_load).then_some(number);
    let standard = [
        (&quantities::LOAD, at(twin.load)),
        (&quantities::ECCENTRICITY, under(twin.eccentricity)),
        (&quantities::FILM_THICKNESS_MIN, under(twin.least_film(scene))),
        (
            &quantities::SOMMERFELD_NUMBER,
            at(twin.number).filter(|_| twin.lands.count == 1.0),
        ),
        (
            &quantities::ATTITUDE_ANGLE,
            Some(iso7902::attitude(twin.eccentricity, twin.lands.slenderness).to_degrees()),
        ),
        (&quantities::FRICTION_COEFFICIENT, Some(twin.coefficient)),
        (&quantities::FRICTION_POWER, Some(twin.power)),
        (&quantities::SIDE_FLOW, twin.flow),
    ];
    let beside = standard.into_iter().filter_map(|(row, standard): (&Row, _)| {
        let film = result.quantity(row)?;
        Some(Beside {
            quantity: row.name,
            unit: film.unit().to_owned(),
            standard: standard?,
            film: film.value,
            error: film.error(),
            difference: standard? - film.value,
        })
    });
    beside.collect()
}

/// What keeps the film of the scene and that of the standard apart.
fn notes(scene: &Scene, twin: &Twin) -> Vec<String> {
    let outside = |what: &str, value: f64, [low, high]: [f64; 2]| {
        (value < low || value > high).then(|| {
            format!("{what} {value:.3} is outside of {low} to {high}, for which the standard's fits were made")
        })
    };
    let sockets = Sockets::of(scene);
    let edge = match sockets.cavitation {
        closure if closure.bears_tension() => Some("this film bears tension"),
        closure if !closure.has_free_boundary() => Some("low pressures of this film are dropped"),
        _ => None,
    };
    let notes = [
        outside("B/D", twin.lands.slenderness, SLENDERNESS),
        outside("eccentricity", twin.eccentricity, ECCENTRICITY),
        edge.map(|edge| format!("{edge}; that of the standard ends where Swift and Stieber's does")),
        (!matches!(sockets.pressure_law, PressureLaw::Constant))
            .then(|| "the standard knows no viscosity that grows with pressure".to_owned()),
        (sockets.centre_velocity != CentreVelocity::default())
            .then(|| "the standard's load is steady: its centre rests".to_owned()),
        (sockets.theory != Theory::Full)
            .then(|| "the standard's film is that of full theory, this one's is not".to_owned()),
    ];
    notes.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::run::{RunOptions, run};
    use std::path::Path;

    /// The twin of a ring, eccentricity 0.7, B/D 0.6, with further lines of the scene.
    fn twin(journal: &str, more: &str) -> Standard {
        let text = format!(
            r#"
bearing = {{ diameter = "50 mm", length = "30 mm", clearance = "25 um" }}
oil = {{ viscosity = "10 mPa.s" }}
cavitation = {{ model = "reynolds" }}
journal = {{ speed = "3000 rpm"{journal} }}
{more}"#
        );
        let scene = oilwedge_study::parse(&text, Path::new("ring.toml")).expect("a scene");
        let found = run(&scene, &RunOptions::default()).expect("a film");
        standard(&scene, &found.result)
    }

    const AT: &str = r#", eccentricity = 0.7, min_film_angle = "300 deg""#;

    fn off(twin: &Standard, name: &str) -> f64 {
        let number = twin.numbers.iter().find(|it| it.quantity == name);
        let number = number.unwrap_or_else(|| panic!("no {name} in {twin:?}"));
        number.relative().unwrap_or(number.difference)
    }

    #[test]
    fn a_ring_is_near_its_twin_at_its_eccentricity_and_under_its_load() {
        let at = twin(AT, "");
        assert_eq!(
            (at.given, &at.feed, &at.notes[..]),
            (Some("eccentricity"), &None, &[][..])
        );
        assert!(
            off(&at, "load").abs() < 0.03 && off(&at, "attitude_angle").abs() < 2.0,
            "{at:?}"
        );
        assert!(
            off(&at, "friction_power").abs() < 0.03 && off(&at, "side_flow").abs() < 0.05,
            "{at:?}"
        );
        let load = at.numbers[0].film;
        let under = twin("", &format!("load = {{ force = \"{load} N\", angle = \"270 deg\" }}"));
        assert_eq!(under.given, Some("load"));
        assert!(off(&under, "eccentricity").abs() < 0.02, "{under:?}");
        let thickness = under.numbers.iter().find(|it| it.quantity == "film_thickness_min");
        assert!(thickness.is_some_and(|it| (it.standard - 7.5e-6).abs() < 5e-7));
    }

    #[test]
    fn feeds_are_named_as_the_standard_does() {
        // The load points to some 260 degrees.
        let hole = |angle: f64| {
            format!(
                "{{ group = \"hole{angle}\", hole = {{ angle = \"{angle} deg\", diameter = \"5 mm\" }}, pressure = \"2 bar\" }}"
            )
        };
        let groove = |extent: &str| {
            format!("feed = [{{ group = \"g\", groove = {{ {extent}width = \"4 mm\" }}, pressure = \"2 bar\" }}]")
        };
        let feeds = |list: &[f64]| {
            format!(
                "feed = [{}]",
                list.iter().map(|at| hole(*at)).collect::<Vec<_>>().join(", ")
            )
        };
        for (more, wanted) in [
            (feeds(&[80.0]), Some("a hole opposite to the load")),
            (feeds(&[170.0]), Some("a hole at 90 degrees to the load")),
            (feeds(&[170.0, 350.0]), Some("two holes at 90 degrees to the load")),
            (feeds(&[260.0]), None),
            (groove(""), Some("a groove all around")),
            (
                groove("from = \"70 deg\", to = \"90 deg\", "),
                Some("a pocket opposite to the load"),
            ),
            (
                groove("from = \"-10 deg\", to = \"170 deg\", "),
                Some("a groove along the half opposite to the load"),
            ),
            (groove("from = \"20 deg\", to = \"140 deg\", "), None),
        ] {
            let twin = twin(AT, &more);
            assert_eq!(twin.feed.as_deref(), wanted, "{more}: {twin:?}");
            let has_flow = twin.numbers.iter().any(|it| it.quantity == "side_flow");
            assert_eq!(
                (has_flow, twin.notes.is_empty()),
                (wanted.is_some(), wanted.is_some()),
                "{more}: {twin:?}"
            );
        }
    }

    #[test]
    fn what_the_standard_has_not_is_told() {
        let text = r#"
bearing = { diameter = "50 mm", length = "30 mm", clearance = "25 um", arc = { from = "180 deg", to = "360 deg" } }
oil = { viscosity = "10 mPa.s" }
journal = { speed = "3000 rpm", eccentricity = 0.7, min_film_angle = "270 deg" }
"#;
        let scene = oilwedge_study::parse(text, Path::new("arc.toml")).expect("a scene");
        let found = run(&scene, &RunOptions::default()).expect("a film");
        let twin = standard(&scene, &found.result);
        assert!(
            twin.given.is_none() && twin.numbers.is_empty() && twin.notes[0].contains("arc"),
            "{twin:?}"
        );
    }
}
