//! Journals that do not turn, under loads with a frequency of their own: carried by squeeze alone.

use oilwedge_study::quantities::*;
use oilwedge_study::result::{RunResult, Status};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::path;

use oilwedge_tests::scenes::parsed;

fn solved(text: &str, bars: bool) -> (RunResult, Option<[f64; 4]>) {
    let scene = parsed(text).unwrap_or_else(|reason| panic!("{reason}"));
    let options = RunOptions { bars, ..RunOptions::of(&scene) };
    let found = run(&scene, &options).expect("an answer");
    (found.result, found.orbit.and_then(|orbit| orbit.place(359.9999)))
}

/// A full short film at rest: `d/dt eps/(1 - eps^2)^(3/2) = F c^2/(pi mu L^3 R)`, a Sommerfeld film without its wedge.
#[test]
fn a_journal_under_a_constant_load_sinks_in_the_time_of_the_closed_film() {
    let text = r#"
        bearing = { diameter = "50 mm", length = "25 mm", clearance = "30 um", theory = "short" }
        mesh.size = "3 mm"
        journal.speed = "0 rpm"
        oil.viscosity = "10 mPa.s"
        load = { harmonics = [{ order = 0, cos = { x = "500 N" } }], frame = "shell", frequency = "50 Hz" }
        orbit = { cycles = 1, tolerance = 1e-6, start = { eccentricity = 0, angle = "0 deg" } }
        cavitation.model = "none"
    "#;
    let (result, place) = solved(text, false);
    assert_eq!(result.head.status, Status::NotConverged);
    let reason = result.head.reason.as_deref().unwrap_or_default();
    assert!(reason.starts_with("sinking: the journal does not turn, 100 % of the load"), "{reason}");
    assert!(result.tail.warnings.iter().any(|warning| warning.kind.code == "half_speed"));
    let [force, clearance, time, viscosity, length, radius] = [500.0, 30e-6, 0.02_f64, 10e-3, 25e-3_f64, 25e-3];
    let wanted = force * clearance * clearance * time / (std::f64::consts::PI * viscosity * length.powi(3) * radius);
    let [x, y, ..] = place.expect("a place");
    let eps = x / clearance;
    let found = eps / (1.0 - eps * eps).powf(1.5);
    assert!((found / wanted - 1.0).abs() < 1e-4, "{found} {wanted}");
    assert!(y.abs() < 1e-6 * clearance, "{y}");
}

/// What turns round a bearing at rest with omega sees the film of a journal that turns with 2 omega under a load at
/// rest: the damper of an unbalance whirls at the eccentricity of that journal.
#[test]
fn a_damper_whirls_at_the_eccentricity_of_a_journal_that_turns_twice_as_fast() {
    let damper = std::fs::read_to_string(path("35_squeeze_film_damper")).expect("a scene");
    let twice_as_fast = |damper: &str| {
        let [load, oil] = ["harmonics", "[orbit]"].map(|key| damper.find(key).expect(key));
        let turning = damper[..load].replace("0 rpm", "24000 rpm");
        let force = if damper.contains("2 kN") { "2 kN" } else { "1 kN" };
        format!("{turning}force = \"{force}\"\nangle = \"0 deg\"\n{}", damper[oil..].replace("[orbit]", ""))
    };
    let film = |text: &str, row: &Row| {
        let (result, _) = solved(text, true);
        assert_eq!(result.head.status, Status::Converged, "{:?}", result.head.reason);
        if text.contains("[orbit]") {
            // Nothing turns the ring: the load alone does work, and the film turns it into heat.
            // A circle may be thinnest anywhere.
            let place = result.quantity(&CYCLE_FILM_THICKNESS_MIN_ANGLE).expect("a place");
            assert!(place.error().is_some_and(|bar| bar > 10.0), "{:?}", place.error());
            let power = result.quantity(&CYCLE_POWER_LOSS).expect("a power").value;
            assert!(power > 1.0 && result.quantity(&CYCLE_FRICTION_POWER).is_none(), "{power}");
        }
        let quantity = result.quantity(row).expect("a film");
        (quantity.value, quantity.error().expect("a bar"))
    };
    let both = |damper: &str| {
        let whirling = film(damper, &CYCLE_FILM_THICKNESS_MIN);
        (whirling, film(&twice_as_fast(damper), &FILM_THICKNESS_MIN))
    };
    assert!(damper.contains("frequency = \"200 Hz\""));
    let ((whirling, _), (still, _)) = both(&damper);
    assert!((whirling / still - 1.0).abs() < 1e-4, "{whirling} {still}");
    // Both lands, which a groove feeds.
    let fed = damper
        .replace("\"reynolds\"", "\"jfo\"")
        .replace("\"18 mm\"", "\"42 mm\"")
        .replace("1 kN", "2 kN")
        .replace("[orbit]", "[mesh]\nsize = \"6 mm\"\n[orbit]")
        .replace(
            "[journal]",
            "[[feed]]\ngroup = \"groove\"\ngroove = { width = \"6 mm\" }\npressure = \"2 bar\"\n[journal]",
        );
    let ((whirling, bar), (still, other)) = both(&fed);
    assert!((whirling - still).abs() < bar + other, "{whirling} {bar}, {still} {other}");
}
