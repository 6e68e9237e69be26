//! A cavity that conserves oil: coefficients that depend on the frequency.

use std::path::Path;

use oilwedge_bearing::dynamics::{Coefficients, stability};
use oilwedge_bearing::{Dynamics, Stability};
use oilwedge_reynolds::Cavitation;
use oilwedge_study::result::{Pair, RunResult};
use oilwedge_study::run_options::RunOptions;
use oilwedge_tests::journal_bearings::each;
use oilwedge_tests::tilted_bearings::{block, numbers, rows};
use oilwedge_tests::*;

/// The groove of the reference on a mesh of this size [mm].
fn grooved(size: f64) -> RunResult {
    let text = format!(
        "bearing = {{ diameter = \"100 mm\", length = \"80 mm\", clearance = \"150 um\" }}\nmesh.size = \"{size} mm\"\n\
         oil.viscosity = \"10 mPa.s\"\ncavitation.model = \"jfo\"\ndynamics.whirl = [0.001, 0.1, 0.25, 0.5, 1, 2]\n\
         journal = {{ speed = \"3000 rpm\", eccentricity = 0.5, min_film_angle = \"0 deg\" }}\n\
         [[feed]]\ngroup = \"groove\"\npressure = \"0.7 bar\"\n\
         groove = {{ from = \"82.5 deg\", to = \"97.5 deg\", width = \"60 mm\", z = \"0 mm\" }}\n"
    );
    let scene = oilwedge_study::parse(&text, Path::new("grooved.toml")).unwrap_or_else(|error| panic!("{error}"));
    let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
    oilwedge_study::run(&scene, &options).expect("a film").result
}

/// A second code with a scheme of first order: 3 % of the greatest of a row at each frequency.
#[test]
fn coefficients_follow_the_frequency() {
    let block = block("jfo_frequency_dependence");
    let result = grooved(3.0);
    let report = result.dynamics.expect("coefficients");
    let speed = result.geometry.speed;
    let unit = 0.01 * speed * (0.05f64 / 150e-6).powi(2) * 0.05 * 0.04 / 150e-6;
    let [stiffness, damping] = ["K", "C"].map(|key| rows(&block[key]));
    let whirls = numbers(&block["nu_over_omega"]);
    assert!(report.depends_on_whirl && report.coefficients.len() == whirls.len());
    each(&(0..whirls.len()).map(|place| serde_json::json!(place)).collect::<Vec<_>>(), |place| {
        let place = place.as_u64().expect("a number") as usize;
        let Pair { stiffness: k, damping: c } = &report.coefficients[place].in_bearing;
        for (found, wanted, unit) in [(k, &stiffness[place], unit), (c, &damping[place], unit / speed)] {
            let wanted = numbers(wanted);
            for entry in 0..4 {
                let value = found[entry / 2][entry % 2] / unit;
                let greatest = wanted[entry - entry % 2].abs().max(wanted[entry - entry % 2 + 1].abs());
                if (value - wanted[entry]).abs() > 0.03 * greatest {
                    return Err(format!("nu {}, entry {entry}: {value}, not {}", whirls[place], wanted[entry]));
                }
            }
        }
        Ok(())
    });
}

/// The coefficients of slow motions are the limit of those at a frequency; the whirl at which a rotor is judged is its
/// own.
#[test]
fn slow_motions_are_the_limit_and_the_whirl_is_its_own() {
    let system = ring_system(60, 8, 0.06, Some(100f64.to_radians()));
    let mut problem = plain_film(0.06, 0.5, 0.0, SPEED);
    problem.cavitation = Cavitation::Jfo { pressure: 0.0 };
    let film = problem.solve(&system).unwrap_or_else(|reason| panic!("{reason}"));
    let of = |whirl: f64| Coefficients::of(&film, whirl * SPEED).expect("coefficients");
    let (slow, limit) = (of(0.0), of(1e-5));
    let off = |a: &Coefficients, b: &Coefficients| {
        let mut most = 0.0f64;
        for i in 0..2 {
            for j in 0..2 {
                most = most.max((a.stiffness[i][j] - b.stiffness[i][j]).abs() / slow.stiffness[0][0].abs());
                most = most.max((a.damping[i][j] - b.damping[i][j]).abs() / slow.damping[0][0].abs());
            }
        }
        most
    };
    assert!(off(&slow, &limit) < 1e-6, "{:e}", off(&slow, &limit));
    assert!(off(&slow, &of(1.0)) > 1e-4, "the cavity takes no part: {:e}", off(&slow, &of(1.0)));
    let dynamics = Dynamics::of(&film, &[0.0]).expect("coefficients");
    let Stability::Below(threshold) = stability(&dynamics.judged.coefficients) else {
        panic!("{:?}", dynamics.stability);
    };
    let ratio = threshold.frequency / SPEED;
    assert!((ratio - dynamics.judged.whirl).abs() < 1e-8, "{ratio} {}", dynamics.judged.whirl);
}
