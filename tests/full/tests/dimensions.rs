//! The derivatives of each shipped scene keep dimensions: a unit of mass, length or time that is a little greater makes
//! all numbers of the scene smaller, and each quantity as its own unit asks.

use oilwedge_campaign::with_derivatives;
use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{MeshSource, Scene};
use oilwedge_study::quantities::{Quantity, Unit};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::program::repository;

/// Exponents of mass, length and time.
type Exponents = [f64; 3];

/// Exponents of a dimension of scenes; `None` of those with temperatures.
fn of_dimension(dimension: Option<Dimension>) -> Option<Exponents> {
    Some(match dimension {
        None | Some(Dimension::Angle | Dimension::Ratio) => [0.0; 3],
        Some(Dimension::Length) => [0.0, 1.0, 0.0],
        Some(Dimension::Area) => [0.0, 2.0, 0.0],
        Some(Dimension::Pressure) => [1.0, -1.0, -2.0],
        Some(Dimension::Viscosity) => [1.0, -1.0, -1.0],
        Some(Dimension::Speed) => [0.0, 0.0, -1.0],
        Some(Dimension::InversePressure) => [-1.0, 1.0, 2.0],
        Some(Dimension::Force) => [1.0, 1.0, -2.0],
        Some(Dimension::Velocity) => [0.0, 1.0, -1.0],
        Some(Dimension::Mass) => [1.0, 0.0, 0.0],
        Some(Dimension::Density) => [1.0, -3.0, 0.0],
        Some(Dimension::KinematicViscosity) => [0.0, 2.0, -1.0],
        Some(Dimension::VolumeFlow) => [0.0, 3.0, -1.0],
        Some(Dimension::Torque | Dimension::RotationalStiffness) => [1.0, 2.0, -2.0],
        Some(Dimension::Stiffness) => [1.0, 0.0, -2.0],
        Some(Dimension::LayerCompliance) => [-1.0, 2.0, 2.0],
        Some(_) => return None,
    })
}

/// Exponents of the unit of a quantity.
fn of_unit(unit: Unit) -> Option<Exponents> {
    Some(match unit {
        Unit::One => [0.0; 3],
        Unit::Newton => [1.0, 1.0, -2.0],
        Unit::Pascal | Unit::PascalOfStress => [1.0, -1.0, -2.0],
        Unit::Metre => [0.0, 1.0, 0.0],
        Unit::PascalSecond => [1.0, -1.0, -1.0],
        Unit::CubicMetrePerSecond => [0.0, 3.0, -1.0],
        Unit::NewtonMetre => [1.0, 2.0, -2.0],
        Unit::Watt => [1.0, 2.0, -3.0],
        Unit::Kilogram => [1.0, 0.0, 0.0],
        Unit::NewtonPerMetre => [1.0, 0.0, -2.0],
        Unit::NewtonSecondPerMetre => [1.0, 0.0, -1.0],
        _ => return None,
    })
}

/// Whether all that has a dimension stands in the scene as a number, on a mesh that moves with its liner.
fn is_closed(scene: &Scene) -> bool {
    matches!(scene.mesh, MeshSource::Drawing { .. })
        && scene.inputs.iter().all(|input| of_dimension(input.dimension).is_some())
}

/// By how much the exponents of a quantity depart from those of its unit.
fn departure(scene: &Scene, quantity: &Quantity) -> Option<f64> {
    let wanted = of_unit(quantity.row.unit)?;
    let mut sums = [0.0; 3];
    for input in &scene.inputs {
        let log = quantity.sensitivity.get(&input.key)?.log.unwrap_or(0.0);
        let exponents = of_dimension(input.dimension)?;
        sums.iter_mut().zip(exponents).for_each(|(sum, exponent)| *sum += exponent * log);
    }
    Some(sums.iter().zip(wanted).map(|(sum, wanted)| (sum - wanted).abs()).fold(0.0, f64::max))
}

/// The quantities that are judged: they change smoothly, and are zero in no scene.
const JUDGED: [&str; 8] = [
    "load",
    "eccentricity",
    "film_thickness_min",
    "pressure_max",
    "friction_power",
    "friction_torque",
    "stiffness_xx",
    "critical_mass",
];

#[test]
fn shipped_scenes_keep_dimensions() {
    let mut departures = Vec::new();
    for entry in std::fs::read_dir(repository().join("scenes")).expect("scenes").flatten() {
        let path = entry.path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let scene = oilwedge_study::read(&path).unwrap_or_else(|error| panic!("{error}"));
        if scene.orbit.is_some() || !is_closed(&scene) {
            continue;
        }
        let options = RunOptions { bars: false, ..RunOptions::of(&scene) };
        let found = run(&scene, &options).unwrap_or_else(|error| panic!("{error}"));
        let (result, reasons) = with_derivatives(&scene, &found, &scene.inputs, &options);
        assert!(reasons.is_empty(), "{}: {reasons:?}", path.display());
        let judged = result.quantities.iter().filter(|quantity| JUDGED.contains(&&*quantity.name));
        let worst = judged.filter_map(|quantity| departure(&scene, quantity)).fold(0.0, f64::max);
        // Edges of cavities pass points of rules, and upstream sides change with triangles that turn.
        assert!(worst < 2e-4, "{}: {worst:e}", path.display());
        departures.push(worst);
    }
    let exact = departures.iter().filter(|departure| **departure < 1e-6).count();
    assert!(departures.len() >= 20 && exact >= 14, "{departures:?}");
}
