use super::compile;
use crate::effects::Effects;
use crate::film::Film;
use oilwedge_reynolds::Cavitation;
use std::path::Path;

const RING: &str = r#"
bearing = { diameter = "75 mm", length = "75 mm", clearance = "37.5 um" }
mesh = { size = "20 mm" }
oil = { viscosity = "0.4 Pa.s" }
"#;

fn study(tables: &str) -> Film {
    let scene = crate::parse(&(RING.to_owned() + tables), Path::new("ring.toml"));
    let model = compile(&scene.unwrap_or_else(|error| panic!("{error}")));
    model.and_then(|model| model.film()).unwrap_or_else(|error| panic!("{error}"))
}

/// A ring with these keys of its journal.
fn journal(keys: &str) -> Film {
    study(&format!("journal = {{ {keys} }}"))
}

fn is_near(found: [f64; 2], wanted: [f64; 2]) -> bool {
    (0..2).all(|k| (found[k] - wanted[k]).abs() < 1e-12 * wanted[0].hypot(wanted[1]))
}

#[test]
fn a_centre_that_rests_squeezes_nothing() {
    let plain = "speed = \"10 rad/s\", eccentricity = 0.6, min_film_angle = \"90 deg\"";
    for squeeze in ["", ", squeeze = {}", ", squeeze = { radial = \"0 m/s\", tangential = \"-0 m/s\" }"] {
        let study = journal(&format!("{plain}{squeeze}"));
        assert_eq!(Effects::of(&study.model.effects).simulated, ["poiseuille", "couette"]);
        assert!(Effects::of(&study.model.effects).not_simulated.iter().any(|kind| kind == "squeeze"));
        assert_eq!((study.problem.journal.velocity, study.load()), ([0.0; 2], None));
    }
}

#[test]
fn a_centre_that_moves_adds_its_term() {
    let moving =
        "eccentricity = 0.6, min_film_angle = \"90 deg\", squeeze = { radial = \"2 mm/s\", tangential = \"1 mm/s\" }";
    let turning = journal(&format!("speed = \"10 rad/s\", {moving}"));
    assert_eq!(Effects::of(&turning.model.effects).simulated, ["poiseuille", "couette", "squeeze"]);
    assert!(!Effects::of(&turning.model.effects).not_simulated.iter().any(|kind| kind == "squeeze"));
    // The line of centres points to +y: radial is +y, and towards growing angles is -x.
    assert!(is_near(turning.problem.journal.velocity, [-1e-3, 2e-3]));
    let at_rest = journal(&format!("speed = \"0 rpm\", {moving}"));
    assert_eq!(Effects::of(&at_rest.model.effects).simulated, ["poiseuille", "squeeze"]);
    let centred = moving.replace("= 0.6", "= 0");
    let centred = journal(&format!("speed = \"0 rpm\", {centred}"));
    assert!(is_near(centred.problem.journal.velocity, [-1e-3, 2e-3]));
}

#[test]
fn under_a_load_the_search_begins_behind_it() {
    for (speed, sense) in [("10 rad/s", 1.0), ("-10 rad/s", -1.0)] {
        let tables = format!("journal.speed = \"{speed}\"\nload = {{ force = \"5 kN\", angle = \"270 deg\" }}");
        let study = study(&tables);
        assert!(is_near(study.load().expect("a load").force, [0.0, -5e3]), "{:?}", study.load());
        assert_eq!(Effects::of(&study.model.effects).simulated, ["poiseuille", "couette", "equilibrium"]);
        // A full film: at right angles to the load, as far out as a closed estimate says.
        let [x, y] = study.problem.journal.offset;
        assert!(sense * x > 0.0 && x.abs() < 37.5e-6 && y.abs() < 1e-3 * x.abs(), "{x:e} {y:e}");
    }
}

#[test]
fn each_model_of_cavitation_is_compiled() {
    let journal = "journal = { speed = \"10 rad/s\", eccentricity = 0.6, min_film_angle = \"90 deg\" }\n";
    let closure = |model: &str, pressure: &str, ends: &str| {
        let tables = format!(
            "{journal}ends.pressure = \"{ends}\"\ncavitation = {{ model = \"{model}\", pressure = \"{pressure}\" }}"
        );
        study(&tables).problem.cavitation
    };
    let pressure = -0.5e5;
    let models = [
        ("none", Cavitation::None),
        ("guembel", Cavitation::Guembel { pressure }),
        ("reynolds", Cavitation::Reynolds { pressure }),
        ("jfo", Cavitation::Jfo { pressure }),
    ];
    for (model, wanted) in models {
        assert_eq!(closure(model, "-0.5 bar", "0 bar"), wanted);
    }
    // 0.07 bar is read one bit above 7 kPa.
    let Cavitation::Jfo { pressure } = closure("jfo", "0.07 bar", "7 kPa") else { panic!("another model") };
    assert_eq!(pressure, 7e3);
    let effects = Effects::of(&study(&format!("{journal}cavitation.model = \"jfo\"")).model.effects);
    assert_eq!(effects.simulated, ["poiseuille", "couette", "cavitation: jfo"]);
}
