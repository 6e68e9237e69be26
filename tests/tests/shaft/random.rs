//! Random shafts and firing orders: each closes or says why not, and no number is lost.

use oilwedge_scene::ShaftScene;
use oilwedge_study::RunOptions;
use oilwedge_study::quantities::CYCLE_FILM_THICKNESS_MIN;
use oilwedge_study::result::Status;
use oilwedge_study::shaft::run_shaft;

use super::{changed, engines, text};

/// Numbers from 0 to 1 (Knuth's linear congruential generator).
struct Dice(u64);

impl Dice {
    fn roll(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.roll()
    }
}

/// A shaft of one to four throws, each between mains, of random sizes, stiffness, firing angles and loads.
fn shaft(dice: &mut Dice, bearing: &str) -> String {
    let throws = 1 + (4.0 * dice.roll()) as usize;
    let (journal, web, pin) = (
        dice.between(22.0, 40.0),
        dice.between(16.0, 30.0),
        dice.between(20.0, 40.0),
    );
    let diameter = dice.between(50.0, 56.0);
    let mut pieces = String::new();
    let mut bearings = String::new();
    let mut z = 0.0;
    for number in 0..=throws {
        pieces += &format!("{{ length = \"{journal} mm\", diameter = \"{diameter} mm\" }},");
        let support = match dice.roll() < 0.3 {
            true => format!(
                ", support = {{ stiffness = \"{} MN/m\", tilt_stiffness = \"20 kN.m/rad\" }}",
                dice.between(200.0, 2e3)
            ),
            false => String::new(),
        };
        bearings += &format!(
            "{{ scene = \"{bearing}\", at = \"{} mm\"{support} }},",
            z + 0.5 * journal
        );
        z += journal + pin + 2.0 * web;
        if number < throws {
            pieces += &format!("{{ fires_at = \"{:.0} deg\" }},", 720.0 * dice.roll());
        }
    }
    let width = match dice.roll() < 0.2 {
        true => format!("web_width = \"{} mm\"", dice.between(70.0, 120.0)),
        false => String::new(),
    };
    format!(
        r#"
[crankshaft]
speed = "{speed} rpm"
youngs_modulus = "{modulus} GPa"
shear_modulus = "80 GPa"
piece = [{pieces}]
bearing = [{bearings}]
[crankshaft.throw]
pin_length = "{pin} mm"
pin_diameter = "{pin_diameter} mm"
web_thickness = "{web} mm"
web_mass = "{web_mass} kg"
{width}
[crank]
radius = "43 mm"
rod_length = "144 mm"
reciprocating_mass = "{mass} kg"
rotating_mass = "0.45 kg"
bore = "86 mm"
gas = {{ peak = "{peak} MPa", angle = "12 deg", sharpness = 14 }}
[orbit]
tolerance = 1e-2
cycles = 5
closure = 1e-2
"#,
        speed = dice.between(800.0, 7000.0),
        modulus = dice.between(150.0, 220.0),
        pin_diameter = 0.9 * diameter,
        web_mass = dice.between(0.0, 2.0),
        mass = dice.between(0.2, 1.0),
        peak = dice.between(0.5, 6.0),
    )
}

/// Six shafts; `OILWEDGE_SHAFTS` asks for another number.
#[test]
fn random_shafts_close_or_say_why_not() {
    let folder = tempfile::tempdir().expect("a folder");
    let bearing = changed(
        &text("bearings/main_56.toml"),
        "[journal]",
        "[mesh]\nsize = \"9 mm\"\n\n[journal]",
    );
    let path = folder.path().join("main.toml");
    std::fs::write(&path, bearing).expect("a file");
    let count = std::env::var("OILWEDGE_SHAFTS")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(6);
    let mut dice = Dice(7);
    let mut closed = 0;
    for number in 0..count {
        let scene = shaft(&mut dice, path.to_str().expect("a path"));
        let read =
            ShaftScene::parse(&scene, &engines("random.toml")).unwrap_or_else(|error| panic!("{error}\n{scene}"));
        let options = RunOptions {
            bars: false,
            max_seconds: 120.0,
            ..RunOptions::default()
        };
        let run = run_shaft(&read, &options).unwrap_or_else(|error| panic!("{error}\n{scene}"));
        let result = &run.result;
        println!(
            "{number}: {:?} {:?} {:?}",
            result.status,
            result.reason,
            run.least_film()
        );
        match result.status {
            Status::Converged => {
                closed += 1;
                assert!(
                    result.balances.force < 1e-8 && result.balances.moment < 1e-8,
                    "{:?}\n{scene}",
                    result.balances
                );
                for bearing in &result.bearings {
                    let film = bearing.quantity(&CYCLE_FILM_THICKNESS_MIN).expect("a film").value;
                    assert!(film > 0.0 && film < 28e-6, "{film}\n{scene}");
                }
            }
            _ => assert!(
                result.reason.as_ref().is_some_and(|reason| reason.len() > 20),
                "{scene}"
            ),
        }
        for quantity in result.bearings.iter().flat_map(|bearing| &bearing.quantities) {
            assert!(quantity.value.is_finite(), "{}\n{scene}", quantity.name);
        }
    }
    assert!(closed * 2 > count, "{closed} of {count}");
}
