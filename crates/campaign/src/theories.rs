//! A scene by three theories: the film of finite length beside those of short and of long bearings.
//!
//! The scene is run again with the theories that are not its own. Where a theory does not apply (an arc, a feed, a
//! conserved oil, a mesh without a line of given pressure) its reason stands in place of numbers. Feeds and the
//! conservation of oil, which neither a short nor a long bearing has, are left out of all three where the liner is
//! drawn here: the error of a theory is a matter of B/D and eccentricity first.

use std::f64::consts::{PI, TAU};

use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;

use oilwedge_scene::{PositionTable, Scene, TheoryKey};
use oilwedge_study::effects::bearing_theory::{LONG_FROM, SHORT_TO};
use oilwedge_study::effects::{Socket, present, without_conservation};
use oilwedge_study::quantities::{
    ATTITUDE_ANGLE, CYCLE_FILM_THICKNESS_MIN, CYCLE_POWER_LOSS, CYCLE_PRESSURE_MAX, ECCENTRICITY, FILM_THICKNESS_MIN,
    FRICTION_POWER, FRICTION_TORQUE, LOAD, PRESSURE_MAX, Quantity, Row, SIDE_FLOW, TEMPERATURE_EFFECTIVE,
};
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::run_options::RunOptions;

use crate::comparison::{Alternative, Comparison, answer, pairs};
use crate::records::{FilmRecord, TheoriesRecord, read_back, recorded};

/// The numbers that are compared, those of a position under a load and of an orbit included.
const COMPARED: [&Row; 11] = [
    &LOAD,
    &ECCENTRICITY,
    &ATTITUDE_ANGLE,
    &FILM_THICKNESS_MIN,
    &PRESSURE_MAX,
    &SIDE_FLOW,
    &FRICTION_TORQUE,
    &FRICTION_POWER,
    &CYCLE_FILM_THICKNESS_MIN,
    &CYCLE_PRESSURE_MAX,
    &CYCLE_POWER_LOSS,
];
/// Rows that a scene gives: where it gives a position, and where it gives a load.
const GIVEN: [&[&Row]; 2] = [&[&ECCENTRICITY, &FILM_THICKNESS_MIN], &[&LOAD]];

/// The film by one theory.
#[derive(Debug, PartialEq)]
struct TheoryFilm {
    theory: TheoryKey,
    status: Status,
    reason: Option<String>,
    /// Film start [rad] that a long ring was given.
    film_start: Option<f64>,
    /// The numbers that are compared; none where there is no film.
    quantities: Vec<Quantity>,
}

/// The films of `scene` by the theories that are not its own; `result` is that of the scene itself, with the same
/// options. A theory without an answer has its reason.
pub(crate) fn record(scene: &Scene, options: &RunOptions, result: &RunResult) -> TheoriesRecord {
    let (films, without) = films(scene, options, result);
    TheoriesRecord {
        slenderness: scene.bearing.length / scene.bearing.diameter,
        without: without.into_iter().map(str::to_owned).collect(),
        films: films.iter().map(|film| film.record(&films[1])).collect(),
    }
}

/// The table of the short and the long film beside the full one.
pub(crate) fn comparison(record: &TheoriesRecord) -> Comparison {
    let full = record.films.iter().find(|film| film.theory == TheoryKey::Full.name());
    let full = full.map_or(Vec::new(), |film| read_back(&film.quantities, &[]));
    let others = record.films.iter().filter(|film| film.theory != TheoryKey::Full.name());
    let alternative = |film: &FilmRecord| Alternative {
        name: film.theory.clone(),
        pairs: pairs(&COMPARED, &full, &read_back(&film.quantities, &[])),
        seconds: None,
    };
    Comparison {
        title: "short and long bearing theory (pressure flow along the axis only, around only), and in brackets the difference from the full film"
            .to_owned(),
        film: TheoryKey::Full.name().to_owned(),
        alternatives: others.map(alternative).collect(),
        lists: Vec::new(),
        notes: notes(record),
    }
}

/// The short, the full and the long film, and what of the scene is left out of all three.
fn films(scene: &Scene, options: &RunOptions, result: &RunResult) -> ([TheoryFilm; 3], Vec<&'static str>) {
    let (scene, without) = bare(scene, result);
    let is_own = |theory: TheoryKey| theory == scene.bearing.theory && without.is_empty();
    let films = [TheoryKey::Short, TheoryKey::Full, TheoryKey::Long].map(|theory| match is_own(theory) {
        true => film(&scene, theory, result),
        false => other(&scene, theory, options),
    });
    (films, without)
}

impl TheoryFilm {
    fn record(&self, full: &Self) -> FilmRecord {
        FilmRecord {
            theory: self.theory.name().to_owned(),
            status: self.status,
            reason: self.reason.clone(),
            film_start_deg: self.film_start.map(f64::to_degrees),
            quantities: recorded(&pairs(&COMPARED, &full.quantities, &self.quantities)),
        }
    }
}

/// What was changed of the scene, why a theory has no film, and what B/D says.
fn notes(TheoriesRecord { slenderness, without, films }: &TheoriesRecord) -> Vec<String> {
    let mut notes = Vec::new();
    if !without.is_empty() {
        notes.push(format!("all three: without {}", without.join(", without ")));
    }
    for film in films {
        let label = match film.quantities.is_empty() {
            true => format!("no {} film", film.theory),
            false => film.theory.clone(),
        };
        notes.extend(film.reason.iter().map(|reason| format!("{label}: {reason}")));
        let start = |start| format!("{label}: the ring was given a film start at its widest gap, {start:.1} deg");
        notes.extend(film.film_start_deg.map(start));
    }
    let kind = match *slenderness {
        low if low <= SHORT_TO => format!("a short bearing (B/D up to {SHORT_TO})"),
        high if high >= LONG_FROM => format!("a long bearing (B/D from {LONG_FROM})"),
        _ => format!("neither short (B/D up to {SHORT_TO}) nor long (from {LONG_FROM})"),
    };
    notes.push(format!("B/D       {slenderness:.3}: {kind}"));
    notes
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
        bare = given;
        bare.oil.temperature = Some(celsius.value + ZERO_CELSIUS);
        without.push("balance of temperature (the oil as warm as found)");
    }
    (bare, without)
}

/// The scene by a theory that is not its own.
fn other(scene: &Scene, theory: TheoryKey, options: &RunOptions) -> TheoryFilm {
    let (scene, film_start) = by(scene, theory);
    let found = answer(&scene, options);
    match &found.result {
        Some(result) => TheoryFilm { film_start, ..film(&scene, theory, result) },
        None => {
            TheoryFilm { theory, status: found.status, reason: found.reason, film_start: None, quantities: Vec::new() }
        }
    }
}

/// The scene by another theory, and the film start [rad] that it was given: a long ring at a given position begins
/// where it is widest. A theory that lets no oil out at the ends has no tolerance of that flow.
fn by(scene: &Scene, theory: TheoryKey) -> (Scene, Option<f64>) {
    let mut scene = scene.clone();
    scene.bearing.theory = theory;
    if theory != TheoryKey::Long {
        return (scene, None);
    }
    scene.remove_tolerance(SIDE_FLOW.name);
    let is_open = scene.bearing.arc.is_none() && scene.bearing.film_start.is_none();
    let start = match scene.journal.position {
        PositionTable::Given { min_film_angle, .. } if is_open => Some((min_film_angle + PI).rem_euclid(TAU)),
        _ => None,
    };
    scene.bearing.film_start = scene.bearing.film_start.or(start);
    (scene, start)
}

/// The numbers of a run that are compared.
fn film(scene: &Scene, theory: TheoryKey, result: &RunResult) -> TheoryFilm {
    let given = GIVEN[usize::from(scene.journal.load().is_some())];
    let wanted = COMPARED.iter().filter(|row| !given.contains(row));
    TheoryFilm {
        theory,
        status: result.head.status,
        reason: result.head.reason.clone(),
        film_start: None,
        quantities: wanted.filter_map(|row| result.quantity(row)).cloned().collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::run::run;
    use std::path::Path;

    const RING: &str = r#"
bearing = { diameter = "75 mm", length = "15 mm", clearance = "37.5 um" }
mesh = { size = "3 mm" }
journal = { speed = "100 rad/s", eccentricity = 0.6, min_film_angle = "200 deg" }
oil = { viscosity = "0.02 Pa.s" }
cavitation = { model = "guembel" }
"#;

    fn found(text: &str) -> ([TheoryFilm; 3], Vec<&'static str>) {
        let scene = oilwedge_study::parse(text, Path::new("ring.toml")).unwrap_or_else(|error| panic!("{error}"));
        let options = RunOptions { bars: false, ..RunOptions::default() };
        let result = run(&scene, &options).unwrap_or_else(|error| panic!("{error}")).result;
        let (films, without) = films(&scene, &options, &result);
        let own = films.iter().find(|film| film.theory == scene.bearing.theory);
        for it in own.expect("its own").quantities.iter().filter(|_| without.is_empty()) {
            assert_eq!(result.quantity(it.row), Some(it));
        }
        (films, without)
    }

    fn quantity<'a>(film: &'a TheoryFilm, row: &Row) -> Option<&'a Quantity> {
        film.quantities.iter().find(|it| it.row == row)
    }

    fn value(film: &TheoryFilm, row: &Row) -> f64 {
        quantity(film, row).unwrap_or_else(|| panic!("no {row:?}: {film:?}")).value
    }

    /// Short: Ocvirk's load. Long: its half film, from the widest film on, is that of Sommerfeld without its other
    /// half.
    #[test]
    fn a_ring_has_all_three_whatever_its_own() {
        let (all, _) = found(RING);
        let (again, _) = found(&RING.replacen("\"37.5 um\"", "\"37.5 um\", theory = \"short\"", 1));
        for (one, other) in all.iter().zip(&again) {
            assert_eq!(value(one, &LOAD), value(other, &LOAD), "{}", one.theory.name());
        }
        let scale = 0.02 * 100.0 / 1e-6 * 0.075 * 0.015;
        let ocvirk =
            0.2f64.powi(2) * oilwedge_reynolds::analytical::ocvirk::ShortFilm::steady(0.6).half_film().magnitude();
        let [short, full, long] = &all;
        assert!((value(short, &LOAD) / (scale * ocvirk) - 1.0).abs() < 5e-3);
        assert!(value(short, &LOAD) > value(full, &LOAD));
        assert!(value(long, &LOAD) > 10.0 * value(full, &LOAD));
        let start = long.film_start.expect("a film start").to_degrees();
        assert!((start - 20.0).abs() < 1e-9, "{start}");
        let record = TheoriesRecord {
            slenderness: 0.2,
            without: vec!["feeds".into(), "this".into()],
            films: all.iter().map(|film| film.record(full)).collect(),
        };
        let own = record.films[1].quantities.iter();
        assert!(own.map(|(_, it)| it.numbers.difference).all(|difference| difference == Some(0.0)));
        let notes = comparison(&record).notes;
        for part in ["without feeds, without this", "long: the ring was given a film start", "a short bearing"] {
            assert!(notes.iter().any(|note| note.contains(part)), "no {part} in {notes:?}");
        }
    }

    #[test]
    fn a_theory_that_does_not_apply_has_a_reason() {
        let with = |from: &str, to: &str| RING.replacen(from, to, 1);
        let arc = with("\"37.5 um\"", "\"37.5 um\", arc = { from = \"60 deg\", to = \"240 deg\" }");
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
            for (film, wanted) in found(&text).0.iter().zip(wanted) {
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
        assert_eq!((fed.1.len(), bare.1.len()), (2, 0));
        assert_eq!(fed.0, bare.0);
    }

    /// Theories are compared at one load by the positions that carry it.
    #[test]
    fn under_a_load_positions_are_compared() {
        let text = RING.replacen(
            "eccentricity = 0.6, min_film_angle = \"200 deg\" }",
            "}\nload = { force = \"500 N\", angle = \"270 deg\" }",
            1,
        );
        let ([short, full, _], _) = found(&text);
        assert!(value(&short, &ECCENTRICITY) < value(&full, &ECCENTRICITY));
        assert!(value(&short, &FILM_THICKNESS_MIN) > value(&full, &FILM_THICKNESS_MIN));
        assert!(quantity(&full, &LOAD).is_none());
    }
}
