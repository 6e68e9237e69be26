//! Derivatives of quantities by numbers of a scene, found by the tangent, against dimensional analysis and films solved
//! again.

use std::path::Path;

use oilwedge_campaign::sweep::{CaseOutcome, chain_of};
use oilwedge_campaign::with_derivatives;
use oilwedge_scene::unit::Dimension;
use oilwedge_scene::{KeyTolerance, Scene};
use oilwedge_study::quantities::Quantity;
use oilwedge_study::{CHECKS, RunOptions, run};
use oilwedge_tests::program::repository;
use oilwedge_tests::scenes::DIFFERENTIATED;

/// Films of each kind: what follows the tables of bearing and oil.
const FILMS: [(&str, &str); 8] = [
    (
        "at a position",
        "[journal]\nspeed = \"300 rad/s\"\neccentricity = 0.6\nmin_film_angle = \"270 deg\"\n[cavitation]\nmodel = \"guembel\"\n",
    ),
    (
        "reynolds",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"reynolds\"\n",
    ),
    (
        "jfo",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"jfo\"\n[[feed]]\ngroup = \"inlet\"\nhole = { angle = \"90 deg\", diameter = \"6 mm\" }\npressure = \"3 bar\"\n",
    ),
    (
        "grooved",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"guembel\"\n[[feed]]\ngroup = \"inlet\"\ngroove = { from = \"60 deg\", to = \"120 deg\", width = \"4 mm\", z = \"1 mm\", corner = \"1 mm\" }\npressure = \"3 bar\"\n",
    ),
    (
        "tilted",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\nat = \"2 mm\"\n[cavitation]\nmodel = \"reynolds\"\n",
    ),
    (
        "small motions",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"2 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"reynolds\"\n[dynamics]\n",
    ),
    (
        "on a liner",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"reynolds\"\n[liner]\nwall = { thickness = \"5 mm\", modulus = \"20 GPa\", poisson = 0.3 }\n",
    ),
    (
        "heated",
        "[journal]\nspeed = \"300 rad/s\"\n[load]\nforce = \"4 kN\"\nangle = \"270 deg\"\n[cavitation]\nmodel = \"reynolds\"\n[heat]\ninlet = \"60 C\"\n",
    ),
];

fn scene(kind: &str) -> Scene {
    let (_, film) = FILMS.iter().find(|(name, _)| *name == kind).expect("a film");
    let oil = match kind {
        "heated" => "[oil]\ngrade = \"ISO VG 46\"\n",
        _ => "[oil]\nviscosity = \"20 mPa.s\"\nbarus = { alpha = \"1.5e-8 1/Pa\" }\n",
    };
    let bearing =
        "[bearing]\ndiameter = \"60 mm\"\nlength = \"24 mm\"\nclearance = \"30 um\"\n[mesh]\nsize = \"3 mm\"\n";
    oilwedge_study::parse(&format!("{bearing}{oil}{film}"), Path::new("a.toml"))
        .unwrap_or_else(|e| panic!("{kind}: {e}"))
}

fn options() -> RunOptions {
    RunOptions { bars: false, ..RunOptions::default() }
}

/// The inputs that leave the mesh as it is, and the quantities with their derivatives by these.
fn derivatives(scene: &Scene) -> (Vec<KeyTolerance>, Vec<Quantity>) {
    let moves = |input: &KeyTolerance| {
        ["bearing.diameter", "bearing.length"].contains(&&*input.key)
            || [".hole.", ".groove."].iter().any(|table| input.key.contains(table))
    };
    let inputs: Vec<KeyTolerance> = scene.inputs.iter().filter(|input| !moves(input)).cloned().collect();
    let quantities = derivatives_by(scene, &inputs);
    (inputs, quantities)
}

/// The quantities with their derivatives by these inputs.
fn derivatives_by(scene: &Scene, inputs: &[KeyTolerance]) -> Vec<Quantity> {
    let found = run(scene, &options()).expect("a mesh");
    let (result, reasons) = with_derivatives(scene, &found, inputs, &options());
    assert!(reasons.is_empty(), "{reasons:?}");
    result.quantities
}

#[test]
fn films_solved_again_on_the_mesh_have_the_derivatives_of_the_tangent() {
    let part = 2e-4;
    let mut apart: Vec<(f64, String)> = Vec::new();
    for (kind, _) in FILMS {
        let scene = scene(kind);
        let (inputs, quantities) = derivatives(&scene);
        let unit = |input: &KeyTolerance| match input.dimension {
            Some(Dimension::Angle) => 1.0,
            _ => input.nominal,
        };
        let beside = |(input, sign): (&KeyTolerance, f64)| {
            let values = [(input, input.nominal + sign * part * unit(input))];
            scene.with_values(&values, &CHECKS).expect("a scene")
        };
        let ends = inputs.iter().flat_map(|input| [(input, -1.0), (input, 1.0)]);
        let scenes: Vec<Scene> = std::iter::once(scene.clone()).chain(ends.map(beside)).collect();
        let films = chain_of(&scenes, &options());
        for (input, ends) in inputs.iter().zip(films[1..].chunks(2)) {
            for quantity in quantities.iter().filter(|quantity| DIFFERENTIATED.contains(&&*quantity.name)) {
                let Some(found) = quantity.sensitivity.get(&input.key) else { continue };
                assert!(!found.is_by_films, "{kind} {}", input.key);
                let value =
                    |film: &CaseOutcome| film.quantities.iter().find(|it| it.name == quantity.name).map(|it| it.value);
                let [low, high] = [0, 1].map(|end| value(&ends[end]).expect("a film"));
                let change = quantity.row.difference(high, low) / (2.0 * part);
                let told = found.value / input.unit_size() * unit(input);
                let size = quantity.value.abs().max(change.abs());
                apart.push((
                    (change - told).abs() / size,
                    format!("{kind} {} {}: {change} {told}", quantity.name, input.key),
                ));
            }
        }
    }
    apart.sort_by(|a, b| a.0.total_cmp(&b.0));
    // Side flows beside a cavity that makes oil jump a little: points of a rule lie on either side of its edge.
    let (jump, smooth): (Vec<_>, Vec<_>) = apart.into_iter().partition(|(_, told)| told.contains("side_flow"));
    let at = |share: f64| &smooth[(share * (smooth.len() - 1) as f64) as usize];
    let worst = jump.last().expect("flows");
    assert!(smooth.len() > 250 && at(0.5).0 < 1e-5 && at(0.95).0 < 1e-3, "{:?} {:?}", at(0.5), at(0.95));
    assert!(at(1.0).0 < 5e-3 && worst.0 < 2e-2, "{:?} {worst:?}", at(1.0));
    println!("{} {:?} {:?} {:?} {worst:?}", smooth.len(), at(0.5), at(0.95), at(1.0));
}

/// Exponents of mass, time and clearance in a number. A clearance that is wider by a factor, and a viscosity by its
/// square, leave pressures as they are.
type Exponents = [f64; 3];

#[test]
fn derivatives_keep_dimensions() {
    let of_inputs: [(&str, Exponents); 6] = [
        ("bearing.clearance", [0.0, 0.0, 1.0]),
        ("oil.viscosity", [1.0, -1.0, 2.0]),
        ("oil.barus.alpha", [-1.0, 2.0, 0.0]),
        ("journal.speed", [0.0, -1.0, 0.0]),
        ("load.force", [1.0, -2.0, 0.0]),
        ("feed.inlet.pressure", [1.0, -2.0, 0.0]),
    ];
    let of_quantities: [(&str, Exponents); 7] = [
        ("eccentricity", [0.0; 3]),
        ("film_thickness_min", [0.0, 0.0, 1.0]),
        ("pressure_max", [1.0, -2.0, 0.0]),
        ("side_flow", [0.0, -1.0, 1.0]),
        ("friction_torque", [1.0, -2.0, 1.0]),
        ("friction_power", [1.0, -3.0, 1.0]),
        ("sommerfeld_number", [0.0; 3]),
    ];
    for kind in ["at a position", "reynolds", "jfo", "on a liner"] {
        let (_, quantities) = derivatives(&scene(kind));
        for (name, wanted) in of_quantities {
            let quantity = quantities.iter().find(|quantity| quantity.name == name);
            // Points of a rule lie on either side of the edge of this cavity.
            let jumps = name == "side_flow" && kind == "on a liner";
            let Some(quantity) = quantity.filter(|_| !jumps) else { continue };
            for (k, wanted) in wanted.into_iter().enumerate() {
                // The wall of a liner has a modulus, too.
                let is_rigid = kind != "on a liner";
                let exponent =
                    |(key, exponents): &(&str, Exponents)| Some(exponents[k] * quantity.sensitivity.get(*key)?.log?);
                let wall = quantity.sensitivity.get("liner.wall.modulus").and_then(|it| it.log);
                let of_wall = [1.0, -2.0, -1.0][k] * wall.unwrap_or(0.0);
                let sum: f64 = of_inputs.iter().filter_map(exponent).sum::<f64>() + of_wall;
                let off = (sum - wanted).abs();
                assert!(off < 1e-6 && (is_rigid || wall.is_some()), "{kind} {name} {k}: {sum} is not {wanted}");
            }
        }
    }
}

/// Exponent of length in a dimension of the scene.
fn of_length(dimension: Option<Dimension>) -> f64 {
    match dimension {
        Some(Dimension::Length | Dimension::InversePressure | Dimension::Force) => 1.0,
        Some(Dimension::Pressure | Dimension::Viscosity) => -1.0,
        _ => 0.0,
    }
}

/// Numbers that move the mesh, as the liner and its feeds do, keep the dimension of length beside all others.
#[test]
fn derivatives_keep_lengths_where_the_mesh_moves() {
    let of_quantities = [
        ("load", 1.0),
        ("eccentricity", 0.0),
        ("film_thickness_min", 1.0),
        ("pressure_max", -1.0),
        ("friction_power", 2.0),
    ];
    for kind in ["at a position", "reynolds", "jfo", "grooved", "on a liner"] {
        let scene = scene(kind);
        let quantities = derivatives_by(&scene, &scene.inputs);
        for (name, wanted) in of_quantities {
            let quantity = quantities.iter().find(|quantity| quantity.name == name).expect("a quantity");
            let log = |input: &KeyTolerance| {
                let found = &quantity.sensitivity[&input.key];
                assert!(!found.is_by_films, "{kind} {}", input.key);
                of_length(input.dimension) * found.log.unwrap_or(0.0)
            };
            let sum: f64 = scene.inputs.iter().map(log).sum();
            // Edges along the flow turn a little, and what passes them changes its side: a kink. The half film is cut.
            let close = if kind == "jfo" { 1e-3 } else { 1e-5 };
            assert!((sum - wanted).abs() < close, "{kind} {name}: {sum} is not {wanted}");
        }
    }
}

/// Films of a finer mesh have the derivatives of the mesh that moves, up to what meshes of their own change.
#[test]
fn films_of_fine_meshes_have_the_derivatives_of_a_mesh_that_moves() {
    for (kind, keys) in [
        ("grooved", &["bearing.length", "feed.inlet.groove.width", "feed.inlet.groove.to"][..]),
        ("jfo", &["bearing.diameter", "feed.inlet.hole.diameter"][..]),
    ] {
        let scene = scene(kind);
        let inputs: Vec<KeyTolerance> =
            scene.inputs.iter().filter(|input| keys.contains(&&*input.key)).cloned().collect();
        let quantities = derivatives_by(&scene, &inputs);
        let fine = scene.text.replace("size = \"3 mm\"", "size = \"1.2 mm\"");
        let fine = oilwedge_study::parse(&fine, Path::new("a.toml")).expect("a scene");
        for input in &inputs {
            let width = 0.02 * input.nominal;
            let films = [-1.0, 1.0]
                .map(|sign| fine.with_values(&[(input, input.nominal + sign * width)], &CHECKS).expect("a scene"));
            let films = chain_of(&films, &options());
            for name in ["eccentricity", "pressure_max", "friction_power"] {
                let own = quantities.iter().find(|quantity| quantity.name == name).expect("a quantity");
                let value = |film: &CaseOutcome| film.quantities.iter().find(|it| it.name == name).expect("it").value;
                let change = (value(&films[1]) - value(&films[0])) / (2.0 * width) * input.nominal / own.value;
                let told = own.sensitivity[&input.key].value / input.unit_size() * input.nominal / own.value;
                println!("{kind} {name} {}: {change} {told}", input.key);
                assert!(
                    (change - told).abs() < f64::max(0.02 * change.abs(), 0.01),
                    "{kind} {name} {}: {change} {told}",
                    input.key
                );
            }
        }
    }
}

/// A number without a film beside leaves the films of the others to them.
#[test]
fn each_number_has_the_reason_of_its_own_films() {
    let scene = oilwedge_study::read(&repository().join("scenes/01_plain_ring.toml")).expect("a scene");
    let found = run(&scene, &options()).expect("a run");
    let named = |key: &str| scene.inputs.iter().find(|input| input.key == key).expect("a key").clone();
    let inputs = [named("bearing.diameter"), named("bearing.length")];
    let (_, reasons) = with_derivatives(&scene, &found, &inputs, &options());
    assert!(reasons[0].contains("bearing.diameter") && reasons[0].contains("the circumference"), "{reasons:?}");
    assert!(reasons[1].contains("bearing.length") && !reasons[1].contains("the circumference"), "{reasons:?}");
}
