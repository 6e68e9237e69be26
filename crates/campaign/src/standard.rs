//! The standard's twin: what ISO 7902 and DIN 31652 give for the bearing of a scene, beside its own film.
//!
//! Both have the same input: the load where the scene has one, else the eccentricity; and the viscosity of the film. A
//! groove all around makes two bearings of the lands beside it, each with half of the load. `twin.rs` evaluates the
//! fits, `feed.rs` finds the standard's feed.

use oilwedge_reynolds::lubricant::PressureLaw;
use oilwedge_reynolds::lubricant::density::ZERO_CELSIUS;
use oilwedge_reynolds::{CentreVelocity, Theory};
use oilwedge_scene::Scene;
use oilwedge_study::effects::{PressureRule, Socket, Sockets};
use oilwedge_study::oil::Oil;
use oilwedge_study::quantities::{self, Bar, Quantity, Row, VISCOSITY_EFFECTIVE};
use oilwedge_study::result::RunResult;

use crate::comparison::{Alternative, Comparison, QuantityPair, pairs};
use crate::records::{OwnBalance, StandardNumber, StandardRecord, named};

mod feed;
mod twin;

use feed::{fed, words};
use twin::{Given, NAME, Twin, own_balance};

/// B/D for which the fits were made.
const SLENDERNESS: [f64; 2] = [0.25, 1.5];
/// Eccentricities for which they were made.
const ECCENTRICITY: [f64; 2] = [0.1, 0.95];
/// Name of the effective viscosity in the record of the standard's own balance.
const VISCOSITY: &str = "viscosity";

/// The bearing of a scene by the standard, beside the film of its `result`.
pub(crate) fn record(scene: &Scene, result: &RunResult) -> StandardRecord {
    let oil = Oil::of(scene);
    let is_found = result.effects.fill(Socket::Temperature);
    let temperature = result.quantity(&quantities::TEMPERATURE_EFFECTIVE).filter(|_| is_found);
    let viscosity = temperature.map_or(oil.viscosity, |celsius| oil.at(celsius.value + ZERO_CELSIUS).viscosity);
    answer(scene, result, viscosity).unwrap_or_else(|reason| StandardRecord {
        viscosity,
        notes: vec![format!("the standard has no such bearing: {reason}")],
        ..StandardRecord::default()
    })
}

/// What the standard gives, or why it has no such bearing.
fn answer(scene: &Scene, result: &RunResult, viscosity: f64) -> Result<StandardRecord, &'static str> {
    let value = |row: &Row| result.quantity(row).map(|quantity| quantity.value);
    if scene.bearing.arc.is_some() {
        return Err("its fits are those of full bearings, but this one is an arc");
    }
    if scene.orbit.is_some() {
        return Err("its loads are steady, but this journal runs on an orbit");
    }
    if scene.journal.speed == 0.0 {
        return Err("the journal is at rest");
    }
    if scene.turbulence.is_some() {
        return Err("its films are laminar, but this one is turbulent; remove [turbulence] to compare a laminar film");
    }
    let (Some(load), Some(eccentricity)) = (value(&quantities::LOAD), value(&quantities::ECCENTRICITY)) else {
        return Err("there is no film");
    };
    let given = match scene.journal.load().is_some() {
        true => Given::Load(load),
        false => Given::Eccentricity(eccentricity),
    };
    let feed = fed(scene, value(&quantities::LOAD_ANGLE).unwrap_or_default());
    let twin = Twin::of(scene, viscosity, given, &feed).ok_or("the film carries no load")?;
    let mut notes = notes(scene, &twin);
    notes.extend(feed.as_ref().err().cloned());
    let balance = own_balance(scene, given, &feed).into_iter().map(|it| match it.row == &VISCOSITY_EFFECTIVE {
        true => (VISCOSITY.to_owned(), it.value),
        false => (it.name.into_owned(), it.value),
    });
    let balance: Vec<_> = balance.collect();
    let standard = numbers(scene, &twin, given);
    let rows: Vec<_> = standard.iter().map(|it| it.row).collect();
    let pairs = pairs(&rows, &result.quantities, &standard);
    Ok(StandardRecord {
        given: Some(given.name().to_owned()),
        viscosity,
        feed: feed.as_ref().ok().and_then(|feed| Some(words(feed.as_ref()?.0).to_owned())),
        squeezed_flow: Some(twin.by_film),
        pressed_flow: twin.by_feed,
        numbers: pairs.iter().filter_map(StandardNumber::of).collect(),
        balance: (!balance.is_empty()).then_some(OwnBalance(balance)),
        notes,
    })
}

impl StandardNumber {
    fn of(pair: &QuantityPair) -> Option<Self> {
        let film = pair.film.as_ref()?;
        Some(Self {
            quantity: pair.name.clone(),
            unit: pair.row.unit.name().to_owned(),
            standard: pair.other.as_ref()?.value,
            film: film.value,
            error: film.error(),
            difference: pair.other.as_ref()?.value - film.value,
        })
    }

    /// The number of the standard beside that of the film.
    fn pair(&self) -> Option<QuantityPair> {
        let film = named(&self.quantity, self.film)?;
        let film = Quantity { bar: self.error.map(Bar::of), ..film };
        QuantityPair::between(Some(&film), named(&self.quantity, self.standard).as_ref())
    }
}

/// The table of the standard beside the film.
pub(crate) fn comparison(record: &StandardRecord) -> Comparison {
    let feed = record.feed.as_ref().map_or(String::new(), |feed| format!(", fed through {feed}"));
    let title = record.given.as_ref().map_or(NAME.to_owned(), |given| {
        format!("{NAME} at the same {given}{feed}, and in brackets its difference from this film")
    });
    let flow = |value: f64| vec![Quantity::new(&quantities::SIDE_FLOW, value)];
    let viscosity = || vec![Quantity::new(&VISCOSITY_EFFECTIVE, record.viscosity)];
    let flows = record.squeezed_flow.zip(record.pressed_flow);
    let own = |(name, value): &(String, f64)| match name == VISCOSITY {
        true => Some(Quantity::new(&VISCOSITY_EFFECTIVE, *value)),
        false => named(name, *value),
    };
    let balance = record.balance.as_ref().map(|OwnBalance(numbers)| numbers.iter().filter_map(own).collect());
    let lists = [
        record.given.as_ref().map(|_| ("viscosity of both", viscosity())),
        flows.map(|(squeezed, _)| ("its side_flow by the narrowing film, Q_3", flow(squeezed))),
        flows.map(|(_, pressed)| ("its side_flow by the feed pressure, Q_p", flow(pressed))),
        balance.map(|balance| ("with its own temperature", balance)),
    ];
    let pairs = record.numbers.iter().filter_map(StandardNumber::pair).collect();
    Comparison {
        title,
        film: "this film".to_owned(),
        alternatives: vec![Alternative { name: NAME.to_owned(), pairs, seconds: None }],
        lists: lists.into_iter().flatten().collect(),
        notes: record.notes.clone(),
    }
}

/// The numbers of the twin, but for those that the scene gives.
fn numbers(scene: &Scene, twin: &Twin, given: Given) -> Vec<Quantity> {
    let of_load = matches!(given, Given::Load(_));
    let under = |number: f64| of_load.then_some(number);
    let at = |number: f64| (!of_load).then_some(number);
    let standard = [
        (&quantities::LOAD, at(twin.load)),
        (&quantities::ECCENTRICITY, under(twin.eccentricity)),
        (&quantities::FILM_THICKNESS_MIN, under(twin.least_film(scene))),
        (&quantities::SOMMERFELD_NUMBER, at(twin.number).filter(|_| twin.lands.count == 1.0)),
        (&quantities::ATTITUDE_ANGLE, Some(twin.attitude().to_degrees())),
        (&quantities::FRICTION_COEFFICIENT, Some(twin.coefficient)),
        (&quantities::FRICTION_POWER, Some(twin.power)),
        (&quantities::SIDE_FLOW, twin.flow),
    ];
    standard.into_iter().filter_map(|(row, value): (&Row, _)| Some(Quantity::new(row, value?))).collect()
}

/// What keeps the film of the scene and that of the standard apart.
fn notes(scene: &Scene, twin: &Twin) -> Vec<String> {
    let outside = |what: &str, value: f64, [low, high]: [f64; 2]| {
        (value < low || value > high)
            .then(|| format!("{what} {value:.3} is outside the range {low} to {high} of the standard's fits"))
    };
    let sockets = Sockets::of(scene);
    let edge = match sockets.cavitation {
        closure if closure.bears_tension() => Some("this film bears tension"),
        closure if !closure.has_free_boundary() => Some("this film drops pressures below that of the cavity"),
        _ => None,
    };
    let notes = [
        outside("B/D", twin.lands.slenderness, SLENDERNESS),
        outside(quantities::ECCENTRICITY.name, twin.eccentricity, ECCENTRICITY),
        edge.map(|edge| format!("{edge}; that of the standard has the Swift-Stieber boundary")),
        (sockets.pressure_rule != PressureRule::Fixed(PressureLaw::Constant))
            .then(|| "the standard has no viscosity that grows with pressure".to_owned()),
        (sockets.centre_velocity != CentreVelocity::default())
            .then(|| "the standard's load is steady: the centre of its journal is at rest".to_owned()),
        (sockets.theory != Theory::Full)
            .then(|| "the standard's film is that of full theory, this one's is not".to_owned()),
    ];
    notes.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use oilwedge_study::quantities::Unit;
    use oilwedge_study::run::run;
    use oilwedge_study::run_options::RunOptions;
    use std::path::Path;

    /// The twin of a ring, eccentricity 0.7, B/D 0.6, with further lines of the scene.
    fn twin(journal: &str, more: &str) -> StandardRecord {
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
        answer(&scene, &found.result, 0.01).expect("a twin")
    }

    const AT: &str = r#", eccentricity = 0.7, min_film_angle = "300 deg""#;

    fn number<'a>(twin: &'a StandardRecord, row: &Row) -> &'a StandardNumber {
        let number = twin.numbers.iter().find(|it| it.quantity == row.name);
        number.unwrap_or_else(|| panic!("no {row:?} in {twin:?}"))
    }

    /// The difference, of angles in degrees, else relative.
    fn off(twin: &StandardRecord, row: &Row) -> f64 {
        let it = number(twin, row);
        it.difference / if row.unit == Unit::Degree { 1.0 } else { it.film.abs() }
    }

    #[test]
    fn a_ring_is_near_its_twin_at_its_eccentricity_and_under_its_load() {
        let at = twin(AT, "");
        assert_eq!((at.given.as_deref(), &at.feed, &at.notes[..]), (Some("eccentricity"), &None, &[][..]));
        assert!(
            off(&at, &quantities::LOAD).abs() < 0.03 && off(&at, &quantities::ATTITUDE_ANGLE).abs() < 2.0,
            "{at:?}"
        );
        assert!(
            off(&at, &quantities::FRICTION_POWER).abs() < 0.03 && off(&at, &quantities::SIDE_FLOW).abs() < 0.05,
            "{at:?}"
        );
        let load = number(&at, &quantities::LOAD).film;
        let under = twin("", &format!("load = {{ force = \"{load} N\", angle = \"270 deg\" }}"));
        assert_eq!(under.given.as_deref(), Some("load"));
        assert!(off(&under, &quantities::ECCENTRICITY).abs() < 0.02, "{under:?}");
        let thickness = number(&under, &quantities::FILM_THICKNESS_MIN).standard;
        assert!((thickness - 7.5e-6).abs() < 5e-7);
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
        let feeds =
            |list: &[f64]| format!("feed = [{}]", list.iter().map(|at| hole(*at)).collect::<Vec<_>>().join(", "));
        for (more, wanted) in [
            (feeds(&[80.0]), Some("a hole opposite to the load")),
            (feeds(&[170.0]), Some("a hole at 90 degrees to the load")),
            (feeds(&[170.0, 350.0]), Some("two holes at 90 degrees to the load")),
            (feeds(&[260.0]), None),
            (groove(""), Some("a groove all around")),
            (groove("from = \"70 deg\", to = \"90 deg\", "), Some("a pocket opposite to the load")),
            (groove("from = \"-10 deg\", to = \"170 deg\", "), Some("a groove along the half opposite to the load")),
            (groove("from = \"20 deg\", to = \"140 deg\", "), None),
        ] {
            let twin = twin(AT, &more);
            assert_eq!(twin.feed.as_deref(), wanted, "{more}: {twin:?}");
            let has_flow = twin.numbers.iter().any(|it| it.quantity == quantities::SIDE_FLOW.name);
            assert_eq!((has_flow, twin.notes.is_empty()), (wanted.is_some(), wanted.is_some()), "{more}: {twin:?}");
        }
    }

    #[test]
    fn an_arc_has_no_twin() {
        let text = r#"
bearing = { diameter = "50 mm", length = "30 mm", clearance = "25 um", arc = { from = "180 deg", to = "360 deg" } }
oil = { viscosity = "10 mPa.s" }
journal = { speed = "3000 rpm", eccentricity = 0.7, min_film_angle = "270 deg" }
"#;
        let scene = oilwedge_study::parse(text, Path::new("arc.toml")).expect("a scene");
        let found = run(&scene, &RunOptions::default()).expect("a film");
        let reason = answer(&scene, &found.result, 0.01).expect_err("an arc");
        assert!(reason.contains("arc"), "{reason}");
        let table = comparison(&record(&scene, &found.result));
        assert!(table.alternatives[0].pairs.is_empty() && table.notes[0].ends_with(reason));
    }
}
