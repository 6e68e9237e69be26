//! One scene by three theories side by side: the film of its length, and what short and long bearings take it for.
//!
//! The scene is run again with the theories that are not its own. What one of them has no meaning for (an arc, a feed, an oil that is conserved,
//! a mesh without the line that it needs) is told in its place. What all of the others lack, feeds and an oil that is conserved, is left out of all
//! three where the liner is drawn here: how far a theory is off is a matter of B/D and eccentricity first.

use std::f64::consts::{PI, TAU};

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use serde::Serialize;

use oilwedge_scene::{Position, Scene, Theory};
use oilwedge_study::complaints;
use oilwedge_study::effects::{Socket, present, without_conservation};
use oilwedge_study::oil::at_temperature;
use oilwedge_study::quantities::{
    ATTITUDE_ANGLE, ECCENTRICITY, FILM_THICKNESS_MIN, FRICTION_POWER, FRICTION_TORQUE, LOAD, PRESSURE_MAX, Quantity,
    Row, SIDE_FLOW, TEMPERATURE_EFFECTIVE,
};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::run::{RunOptions, run};

/// The numbers that are compared, those of a position under a load included.
const COMPARED: [&Row; 8] = [
    &LOAD,
    &ECCENTRICITY,
    &ATTITUDE_ANGLE,
    &FILM_THICKNESS_MIN,
    &PRESSURE_MAX,
    &SIDE_FLOW,
    &FRICTION_TORQUE,
    &FRICTION_POWER,
];
/// Those that the scene gives, where it gives a position and where it gives a load.
const GIVEN: [&[&Row]; 2] = [&[&ECCENTRICITY, &FILM_THICKNESS_MIN], &[&LOAD]];

/// A film by three theories.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Theories {
    /// B/D [1].
    pub slenderness: f64,
    /// What of the scene is left out of all three films, in words.
    pub without: Vec<&'static str>,
    /// `short`, `full` and `long`, in that order.
    pub films: Vec<TheoryFilm>,
}

/// What one theory makes of the film.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TheoryFilm {
    /// `short`, `full` or `long`.
    pub theory: String,
    /// How its run ended.
    pub status: Status,
    /// Why there is no film by this theory, or why it was not reached.
    pub reason: Option<String>,
    /// Angle [deg] of the film start that a long ring was given, where the scene has none.
    pub film_start_deg: Option<f64>,
    /// The main quantities; an object keyed by name in JSON. Empty where there is no film.
    #[serde(serialize_with = "by_name")]
    pub quantities: Vec<TheoryNumber>,
}

/// A quantity by one theory.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TheoryNumber {
    /// Name of the quantity.
    #[serde(skip)]
    pub quantity: String,
    /// Its symbol.
    pub symbol: String,
    /// Its unit, that of all numbers here.
    pub unit: String,
    /// Its value.
    pub value: f64,
    /// Half width of its error bar; `None` where there is none.
    pub error: Option<f64>,
    /// The value less that of the full film, of angles the lesser way round; `None` where the full film has none.
    pub difference: Option<f64>,
}

/// Runs `scene` by the theories that are not its own; `result` is that of the scene itself, with the same options. A theory without an answer
/// has its reason.
pub fn theories(scene: &Scene, options: &RunOptions, result: &RunResult) -> Theories {
    let (scene, without) = bare(scene, result);
    let is_own = |theory: Theory| theory == scene.bearing.theory && without.is_empty();
    let mut films = [Theory::Short, Theory::Full, Theory::Long].map(|theory| match is_own(theory) {
        true => film(&scene, theory, result),
        false => other(&scene, theory, options),
    });
    let full = films[1].quantities.clone();
    for number in films.iter_mut().flat_map(|film| &mut film.quantities) {
        let of_full = full.iter().find(|it| it.quantity == number.quantity);
        number.difference = of_full.map(|of_full| difference(number.value, of_full.value, &number.unit));
    }
    Theories {
        slenderness: scene.bearing.length / scene.bearing.diameter,
        without,
        films: films.into(),
    }
}

/// The scene without what only the full film has, and what that is. Its oil keeps the temperature of the `result`.
fn bare(scene: &Scene, result: &RunResult) -> (Scene, Vec<&'static str>) {
    let mut bare = scene.clone();
    let mut without = Vec::new();
    let has_film = result.quantity(&LOAD).is_some();
    if !(scene.mesh.path().is_none() && scene.bearing.arc.is_none() && has_film) {
        return (bare, without);
    }
    if !bare.feeds.is_empty() {
        bare.feeds.clear();
        without.push("feeds");
    }
    if let Some(simpler) = without_conservation(&bare) {
        bare = simpler;
        without.push("conservation of oil in the cavity (Reynolds' model in its place)");
    }
    let temperature = result.quantity(&TEMPERATURE_EFFECTIVE);
    let given =
        present(&bare).find_map(|effect| (effect.remove)(&bare).filter(|_| effect.socket == Socket::Temperature));
    if let (false, Some(given), Some(celsius)) = (without.is_empty(), given, temperature) {
        bare = at_temperature(&given, celsius.value + ZERO_CELSIUS);
        without.push("balance of temperature (the oil as warm as found)");
    }
    (bare, without)
}

impl Theories {
    /// What a theory makes of the film.
    pub fn film(&self, theory: &str) -> Option<&TheoryFilm> {
        self.films.iter().find(|film| film.theory == theory)
    }
}

impl TheoryFilm {
    /// A number of it.
    pub fn quantity(&self, name: &str) -> Option<&TheoryNumber> {
        self.quantities.iter().find(|it| it.quantity == name)
    }
}

/// The scene by a theory that is not its own.
fn other(scene: &Scene, theory: Theory, options: &RunOptions) -> TheoryFilm {
    let (scene, film_start) = by(scene, theory);
    let without = |reason: String| TheoryFilm {
        theory: theory.name().to_owned(),
        status: Status::NoSolution,
        reason: Some(reason),
        film_start_deg: None,
        quantities: Vec::new(),
    };
    if let Some(complaint) = complaints(&scene).first() {
        return without(complaint.to_string());
    }
    match run(&scene, options) {
        Ok(found) => TheoryFilm {
            film_start_deg: film_start.map(f64::to_degrees),
            ..film(&scene, theory, &found.result)
        },
        Err(error) => without(error.to_string()),
    }
}

/// The scene by another theory, and the film start [rad] that it was given: a long ring at a given position begins where it is widest. A theory
/// that lets no oil out at the ends has no tolerance of that flow.
fn by(scene: &Scene, theory: Theory) -> (Scene, Option<f64>) {
    let mut scene = scene.clone();
    scene.bearing.theory = theory;
    if theory != Theory::Long {
        return (scene, None);
    }
    scene.remove_tolerance(SIDE_FLOW.name);
    let is_open = scene.bearing.arc.is_none() && scene.bearing.film_start.is_none();
    let start = match scene.journal.position {
        Position::Given { min_film_angle, .. } if is_open => Some((min_film_angle + PI).rem_euclid(TAU)),
        _ => None,
    };
    scene.bearing.film_start = scene.bearing.film_start.or(start);
    (scene, start)
}

/// The numbers of a run that are compared.
fn film(scene: &Scene, theory: Theory, result: &RunResult) -> TheoryFilm {
    let given = GIVEN[usize::from(scene.journal.load().is_some())];
    let wanted = COMPARED.iter().filter(|row| !given.contains(row));
    TheoryFilm {
        theory: theory.name().to_owned(),
        status: result.status,
        reason: result.reason.clone(),
        film_start_deg: None,
        quantities: wanted
            .filter_map(|row| result.quantity(row))
            .map(TheoryNumber::of)
            .collect(),
    }
}

impl TheoryNumber {
    fn of(quantity: &Quantity) -> Self {
        Self {
            quantity: quantity.name.to_string(),
            symbol: quantity.row.symbol.to_owned(),
            unit: quantity.unit().to_owned(),
            value: quantity.value,
            error: quantity.error(),
            difference: None,
        }
    }
}

fn difference(value: f64, full: f64, unit: &str) -> f64 {
    match unit {
        "deg" => 180.0 - (180.0 - (value - full)).rem_euclid(360.0),
        _ => value - full,
    }
}

fn by_name<S: serde::Serializer>(numbers: &[TheoryNumber], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(numbers.iter().map(|it| (&it.quantity, it)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    const RING: &str = r#"
bearing = { diameter = "75 mm", length = "15 mm", clearance = "37.5 um" }
mesh = { size = "3 mm" }
journal = { speed = "100 rad/s", eccentricity = 0.6, min_film_angle = "200 deg" }
oil = { viscosity = "0.02 Pa.s" }
cavitation = { model = "guembel" }
"#;

    fn found(text: &str) -> Theories {
        let scene = oilwedge_study::parse(text, Path::new("ring.toml")).unwrap_or_else(|error| panic!("{error}"));
        let options = RunOptions {
            bars: false,
            ..RunOptions::default()
        };
        let result = run(&scene, &options).unwrap_or_else(|error| panic!("{error}")).result;
        let theories = theories(&scene, &options, &result);
        let own = theories.film(scene.bearing.theory.name()).expect("its own theory");
        for it in own.quantities.iter().filter(|_| theories.without.is_empty()) {
            assert_eq!(result.by_name(&it.quantity).map(|of_run| of_run.value), Some(it.value));
        }
        assert_eq!(theories.films.len(), 3);
        theories
    }

    fn value(theories: &Theories, theory: &str, name: &str) -> f64 {
        let number = theories.film(theory).and_then(|film| film.quantity(name));
        number
            .unwrap_or_else(|| panic!("no {name}, {theory}: {theories:?}"))
            .value
    }

    /// Short: Ocvirk's load. Long: its half film, from the widest film on, is that of Sommerfeld without its other half.
    #[test]
    fn a_ring_has_all_three_whatever_its_own() {
        let all = found(RING);
        assert!((all.slenderness - 0.2).abs() < 1e-12);
        let short = RING.replacen("\"37.5 um\"", "\"37.5 um\", theory = \"short\"", 1);
        let again = found(&short);
        for theory in ["short", "full", "long"] {
            let both = [&all, &again].map(|it| value(it, theory, "load"));
            assert_eq!(both[0], both[1], "{theory}");
        }
        let scale = 0.02 * 100.0 / 1e-6 * 0.075 * 0.015;
        let ocvirk = 0.2f64.powi(2)
            * oilwedge_reynolds::analytical::ocvirk::ShortFilm::steady(0.6)
                .half_film()
                .magnitude();
        assert!((value(&all, "short", "load") / (scale * ocvirk) - 1.0).abs() < 5e-3);
        assert!(value(&all, "short", "load") > value(&all, "full", "load"));
        assert!(value(&all, "long", "load") > 10.0 * value(&all, "full", "load"));
        let long = all
            .film("long")
            .and_then(|film| film.film_start_deg)
            .expect("a film start");
        assert!((long - 20.0).abs() < 1e-9, "{long}");
        assert_eq!(
            all.film("full").and_then(|film| film.quantity("load")?.difference),
            Some(0.0)
        );
        for number in &all.films[0].quantities {
            let full = value(&all, "full", &number.quantity);
            assert!(
                number
                    .difference
                    .is_some_and(|it| (it - (number.value - full)).abs() < 1e-12 * full.abs())
            );
        }
    }

    /// What a theory has no meaning for is told, and the others are there.
    #[test]
    fn what_a_theory_cannot_do_is_told_in_its_place() {
        let with = |from: &str, to: &str| RING.replacen(from, to, 1);
        let arc = with(
            "\"37.5 um\"",
            "\"37.5 um\", arc = { from = \"60 deg\", to = \"240 deg\" }",
        );
        let feed =
            "feed = [{ group = \"hole\", hole = { diameter = \"4 mm\", angle = \"20 deg\" }, pressure = \"1 bar\" }]\n";
        let loaded = with(
            "eccentricity = 0.6, min_film_angle = \"200 deg\" }",
            "}\nload = { force = \"500 N\", angle = \"270 deg\" }",
        );
        let cases = [
            (arc.clone(), [Some("bearing.arc is given"), None, None]),
            (
                feed.replacen("20 deg", "150 deg", 1) + &arc,
                [Some("bearing.arc is given"), None, Some("there is a feed")],
            ),
            (loaded, [None, None, Some("no line of the bearing has a pressure")]),
        ];
        for (text, wanted) in cases {
            let found = found(&text);
            for (film, wanted) in found.films.iter().zip(wanted) {
                match wanted {
                    Some(words) => {
                        assert!(film.quantities.is_empty() && film.status == Status::NoSolution);
                        assert!(film.reason.as_ref().is_some_and(|it| it.contains(words)), "{film:?}");
                    }
                    None => assert!(!film.quantities.is_empty() && film.reason.is_none(), "{text}{film:?}"),
                }
            }
        }
    }

    /// A fed ring of a conserved oil is compared as a bare one that Reynolds' cavity closes.
    #[test]
    fn what_only_the_full_film_has_is_left_out_of_all() {
        let feed =
            "feed = [{ group = \"hole\", hole = { diameter = \"4 mm\", angle = \"20 deg\" }, pressure = \"1 bar\" }]\n";
        let with = |model: &str| RING.replacen("guembel", model, 1);
        let (fed, bare) = (found(&(feed.to_owned() + &with("jfo"))), found(&with("reynolds")));
        assert_eq!((fed.without.len(), bare.without.len()), (2, 0));
        assert_eq!(fed.films, bare.films);
    }

    /// Under a load it is the position that differs.
    #[test]
    fn under_a_load_positions_are_compared() {
        let text = RING.replacen(
            "eccentricity = 0.6, min_film_angle = \"200 deg\" }",
            "}\nload = { force = \"500 N\", angle = \"270 deg\" }",
            1,
        );
        let found = found(&text);
        assert!(value(&found, "short", "eccentricity") < value(&found, "full", "eccentricity"));
        assert!(value(&found, "short", "film_thickness_min") > value(&found, "full", "film_thickness_min"));
        assert!(found.films[1].quantity("load").is_none());
    }
}
