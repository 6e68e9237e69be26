//! Turbulent films: the laminar limit, closed quadratures of long and short bearings, tangents against differences,
//! balances and symmetries.

use std::f64::consts::PI;
use std::sync::Arc;

use oilwedge_bearing::Coefficients;
use oilwedge_reynolds::flow_factors::{FlowFactor, PatirCheng, TurbulenceModel};
use oilwedge_reynolds::quantities::flow::flows;
use oilwedge_reynolds::quantities::heat_network::EddySources;
use oilwedge_reynolds::quantities::load::{load, load_change};
use oilwedge_reynolds::quantities::power::power;
use oilwedge_reynolds::quantities::turbulence::turbulent_film;
use oilwedge_reynolds::solve::Neighbour;
use oilwedge_reynolds::supply::BoundaryKind;
use oilwedge_reynolds::terms::squeeze::Squeeze;
use oilwedge_reynolds::{
    AcrossFilm, Cavitation, EddyFactors, FilmChange, FilmProblem, FilmSystem, SolvedFilm, Theory, ViscosityAcross,
};
use oilwedge_study::{RunOptions, run};
use oilwedge_tests::scenes::{parsed, path, table, variant};
use oilwedge_tests::tilted_bearings::{slope, tilted};
use oilwedge_tests::*;

const LENGTH: f64 = 0.06;
const ECCENTRICITY: f64 = 0.6;
const MODELS: [TurbulenceModel; 2] = [TurbulenceModel::NgPan, TurbulenceModel::Constantinescu];
const CLOSURES: [Cavitation; 4] = [
    Cavitation::None,
    Cavitation::Guembel { pressure: 0.0 },
    Cavitation::Reynolds { pressure: 0.0 },
    Cavitation::Jfo { pressure: 0.0 },
];

/// A film whose oil is so dense that the clearance has this Reynolds number.
fn turbulent(model: TurbulenceModel, reynolds_number: f64, problem: FilmProblem) -> FilmProblem {
    let mut problem = FilmProblem { flow_factors: vec![Arc::new(model)], ..problem };
    problem.lubricant.density = reynolds_number * VISCOSITY / (SPEED * RADIUS * CLEARANCE);
    problem
}

fn solved(problem: &FilmProblem, system: &Arc<FilmSystem>) -> SolvedFilm {
    problem.solve(system).unwrap_or_else(|reason| panic!("{:?}: {reason}", problem.cavitation))
}

fn force(film: &SolvedFilm) -> [f64; 2] {
    load(film).total.force
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1]) / b[0].hypot(b[1])
}

/// Re = 0: the factors are one, and the film of two conductances that of one to round-off.
#[test]
fn a_film_without_inertia_is_laminar() {
    let system = ring_system(48, 8, LENGTH, Some(0.0));
    for cavitation in CLOSURES {
        let laminar = FilmProblem { cavitation, ..plain_film(LENGTH, ECCENTRICITY, 2.6, SPEED) };
        let plain = solved(&laminar, &system);
        for model in MODELS {
            let film = solved(&turbulent(model, 0.0, laminar.clone()), &system);
            assert!(apart(force(&film), force(&plain)) < 1e-12, "{cavitation:?}");
            let (a, b) = (power(&film), power(&plain));
            assert!((a.shear / b.shear - 1.0).abs() < 1e-12 && (a.pressure / b.pressure - 1.0).abs() < 1e-11);
            // It nears the laminar film like Re^0.741 at least.
            let near = solved(&turbulent(model, 1e-3, laminar.clone()), &system);
            assert!((1e-12..1e-4).contains(&apart(force(&near), force(&plain))), "{cavitation:?}");
        }
    }
}

/// Angle from the widest film, gap and its derivative by the angle, and the resistances there.
struct Station {
    angle: f64,
    gap: f64,
    slope: f64,
    resistance: [f64; 2],
}

/// Stations around a film whose widest gap lies at the angle 0.
fn stations(model: TurbulenceModel, reynolds_number: f64) -> Vec<Station> {
    const NUMBER: u32 = 4000;
    let station = |k: u32| {
        let angle = 2.0 * PI * f64::from(k) / f64::from(NUMBER);
        let wide = 1.0 + ECCENTRICITY * angle.cos();
        Station {
            angle,
            gap: CLEARANCE * wide,
            slope: -CLEARANCE * ECCENTRICITY * angle.sin(),
            resistance: model.resistance(reynolds_number * wide),
        }
    };
    (0..NUMBER).map(station).collect()
}

/// Mean over the turn times it: the trapezoidal rule, exact for what is periodic.
fn around(stations: &[Station], of: impl Fn(&Station) -> f64) -> f64 {
    stations.iter().map(of).sum::<f64>() * 2.0 * PI / stations.len() as f64
}

/// Force [N] of a long film, `dp/dx = mu k_x (U h/2 - q)/h^3` with the q that closes the turn: by parts, so that no
/// pressure is needed.
fn long_force(model: TurbulenceModel, reynolds_number: f64) -> [f64; 2] {
    let stations = stations(model, reynolds_number);
    let speed = SPEED * RADIUS;
    let resistance = |at: &Station| VISCOSITY * at.resistance[0] / at.gap.powi(3);
    let dragged = around(&stations, |at| resistance(at) * 0.5 * speed * at.gap);
    let flow = dragged / around(&stations, resistance);
    let rise = |at: &Station| RADIUS * resistance(at) * (0.5 * speed * at.gap - flow);
    let along = RADIUS * LENGTH;
    [
        -along * around(&stations, |at| at.angle.sin() * rise(at)),
        along * around(&stations, |at| at.angle.cos() * rise(at)),
    ]
}

/// Force [N] of a short film, `p = mu k_z U h'/(4 h^3) (z^2 - B^2/4)`.
fn short_force(model: TurbulenceModel, reynolds_number: f64, length: f64) -> [f64; 2] {
    let stations = stations(model, reynolds_number);
    let line = |at: &Station| {
        let bend = VISCOSITY * at.resistance[1] * SPEED * at.slope / (4.0 * at.gap.powi(3));
        -bend * length.powi(3) / 6.0 * RADIUS
    };
    [around(&stations, |at| at.angle.cos() * line(at)), around(&stations, |at| at.angle.sin() * line(at))]
}

/// Sealed ends make a long film of any length: the quadrature at an order above 3.
#[test]
fn a_long_film_is_that_of_the_quadrature() {
    for model in MODELS {
        let wanted = long_force(model, 5e3);
        let errors = [96, 192].map(|columns| {
            let mesh = ring(columns, 4, LENGTH, 0.0);
            let mut regions = ends(&mesh, LENGTH, Some(0.0));
            for region in regions.iter_mut().filter(|region| region.kind == BoundaryKind::End) {
                region.kind = BoundaryKind::Sealed;
            }
            let system = Arc::new(FilmSystem::new(Arc::new(mesh), 2, regions).expect("a line of given pressure"));
            apart(force(&solved(&turbulent(model, 5e3, plain_film(LENGTH, ECCENTRICITY, PI, SPEED)), &system)), wanted)
        });
        assert!(errors[1] < 1e-6 && order(&errors) > 3.0, "{model:?}: {errors:?}");
    }
}

/// The film of the theory of short bearings is the closed one; that of both flows nears it like the square of B/D.
#[test]
fn a_short_film_is_the_closed_one() {
    for model in MODELS {
        let at = |length: f64, theory: Theory, columns: u32| {
            let system = ring_system(columns, columns / 24, length, None);
            let problem = FilmProblem { theory, ..plain_film(length, ECCENTRICITY, PI, SPEED) };
            apart(force(&solved(&turbulent(model, 5e3, problem), &system)), short_force(model, 5e3, length))
        };
        let errors = [96, 192].map(|columns| at(0.1 * RADIUS, Theory::Short, columns));
        assert!(errors[1] < 3e-6 && order(&errors) > 3.0, "{model:?}: {errors:?}");
        let [wide, narrow] = [0.1, 0.05].map(|part| at(part * RADIUS, Theory::Full, 384));
        assert!((3.8..4.2).contains(&(wide / narrow)) && narrow < 3e-3, "{model:?}: {wide:e} {narrow:e}");
    }
}

/// Stiffness, damping, and what a thicker oil does, against central differences of the same discrete film, with tilt;
/// the viscosity under rough surfaces, too.
#[test]
fn tangents_are_differences() {
    let system = ring_system(72, 12, LENGTH, Some(2.8));
    for cavitation in CLOSURES {
        for model in MODELS {
            let plain = tilted(plain_film(LENGTH, ECCENTRICITY, 0.3, SPEED), slope([0.1, -0.08]));
            let mut problem = turbulent(model, 5e3, FilmProblem { cavitation, ..plain });
            problem.terms.push(Arc::new(Squeeze));
            if cavitation == Cavitation::None {
                problem.flow_factors.push(Arc::new(PatirCheng { roughness: 4e-6 }));
            }
            let film = solved(&problem, &system);
            stiffness_and_damping_are_differences(&film);
            let at = |change: &dyn Fn(&mut FilmProblem)| force_beside(&film, change);
            let change = FilmChange::Viscosity(1.0);
            let unknown = film.unknown_change(change).expect("a tangent");
            let column = load_change(&film, &[change], &unknown).force;
            let thicker = [1e-6, -1e-6].map(|part| at(&|problem| problem.lubricant.viscosity *= 1.0 + part));
            close(&film, "viscosity", column, thicker, 1e-6);
        }
        // Eddies across the film: powers of the gap about that of each node, which vary from node to node.
        let mut problem = turbulent(TurbulenceModel::Reichardt, 5e3, plain_film(LENGTH, ECCENTRICITY, 0.3, SPEED));
        problem.cavitation = cavitation;
        problem.terms.push(Arc::new(Squeeze));
        let sources = EddySources::of(&solved(&problem, &system)).expect("gaps");
        let node = |(dof, &gap): (usize, &f64)| {
            let uneven = 1.0 + 0.1 * (dof as f64).sin();
            let eddies = EddyFactors {
                gap,
                conductance: [0.3 * uneven, 0.5],
                conductance_growth: [-0.7 * uneven, -0.5],
                shear: 4.0,
                shear_growth: 0.8,
            };
            AcrossFilm { viscosity: VISCOSITY * uneven, shear_viscosity: VISCOSITY, drag: 0.52, eddies: Some(eddies) }
        };
        let nodes = sources.gaps.iter().enumerate().map(node).collect();
        problem.viscosity_across = Some(Arc::new(ViscosityAcross::new(system.space(), nodes)));
        stiffness_and_damping_are_differences(&solved(&problem, &system));
    }
}

/// The force of a film that differs a little from another one.
fn force_beside(film: &SolvedFilm, change: &dyn Fn(&mut FilmProblem)) -> [f64; 2] {
    let mut problem = film.problem.clone();
    change(&mut problem);
    force(&problem.solve_from(&film.system, Neighbour::Start(film)).expect("a film"))
}

fn close(film: &SolvedFilm, what: &str, column: [f64; 2], [ahead, behind]: [[f64; 2]; 2], step: f64) {
    let cavitation = film.problem.cavitation;
    let difference = [0, 1].map(|d| (ahead[d] - behind[d]) / (2.0 * step));
    let off = apart(column, difference);
    // Where Guembel cuts the pressure, differences have a kink.
    let tolerance = if matches!(cavitation, Cavitation::Guembel { .. }) { 1e-5 } else { 2e-6 };
    let factors = &film.problem.flow_factors;
    assert!(off < tolerance, "{cavitation:?} {factors:?}: {what}: {off:e} {column:?} {difference:?}");
}

fn stiffness_and_damping_are_differences(film: &SolvedFilm) {
    let coefficients = Coefficients::of(film, 0.0).expect("a tangent");
    let at = |change: &dyn Fn(&mut FilmProblem)| force_beside(film, change);
    for k in 0..2 {
        let (by, rate) = (1e-6 * CLEARANCE, 1e-6 * CLEARANCE * SPEED);
        let placed = [by, -by].map(|by| at(&|problem| problem.journal.offset[k] += by));
        close(film, "K", [0, 1].map(|row| coefficients.stiffness[row][k]), placed, by);
        // Where oil is conserved, a journal that moves on is not one that moves to and fro.
        if !film.problem.cavitation.conserves_oil() {
            let moved = [rate, -rate].map(|rate| at(&|problem| problem.journal.velocity[k] += rate));
            close(film, "C", [0, 1].map(|row| coefficients.damping[row][k]), moved, rate);
        }
    }
}

/// What is put in becomes heat and oil that enters leaves, as in laminar films; the shear is so many times the laminar
/// one as a centred journal's.
#[test]
fn oil_and_power_balance() {
    let system = ring_system(60, 12, LENGTH, Some(0.0));
    for model in MODELS {
        for cavitation in CLOSURES {
            let problem = FilmProblem { cavitation, ..plain_film(LENGTH, ECCENTRICITY, PI, SPEED) };
            let film = solved(&turbulent(model, 1e4, problem), &system);
            assert!(power(&film).imbalance < 1e-10, "{cavitation:?}: {:?}", power(&film));
            if cavitation.conserves_oil() || cavitation == Cavitation::None {
                assert!(flows(&film).imbalance < 1e-10, "{cavitation:?}");
            }
        }
        let centred = solved(&turbulent(model, 1e4, plain_film(LENGTH, 0.0, 0.0, SPEED)), &system);
        let found = turbulent_film(&centred).expect("a turbulent film");
        assert!((found.greatest / 1e4 - 1.0).abs() < 1e-12 && found.unsure < 1e-8);
        assert!((found.shear.expect("a turning journal") / model.shear_at(1e4) - 1.0).abs() < 1e-12);
        assert_eq!(model.name(), if model == TurbulenceModel::NgPan { "ng-pan" } else { "constantinescu" });
    }
    assert_eq!(turbulent_film(&solved(&plain_film(LENGTH, 0.3, 0.0, SPEED), &system)), None);
}

/// A mirrored film with reversed speed carries the mirrored load, and a turned one the turned load.
#[test]
fn mirrored_and_turned() {
    for cavitation in CLOSURES {
        let at = |start: f64, angle: f64, speed: f64| {
            let problem = FilmProblem { cavitation, ..plain_film(LENGTH, ECCENTRICITY, angle, speed) };
            let system = ring_system(48, 8, LENGTH, Some(start));
            force(&solved(&turbulent(TurbulenceModel::NgPan, 5e3, problem), &system))
        };
        let [x, y] = at(0.0, 2.8, SPEED);
        assert!(apart(at(0.0, -2.8, -SPEED), [x, -y]) < 1e-9, "{cavitation:?}");
        let (sin, cos) = 0.7f64.sin_cos();
        assert!(apart(at(0.7, 3.5, SPEED), [x * cos - y * sin, x * sin + y * cos]) < 1e-9, "{cavitation:?}");
    }
}

/// What turbulence has no theory for is refused, with the key and the way out.
#[test]
fn scenes_without_a_theory_are_refused() {
    let text = std::fs::read_to_string(path("39_turbine_turbulent")).expect("the scene");
    let refused = |from: &str, to: &str, wanted: &str| {
        let error = parsed(&text.replacen(from, to, 1)).expect_err(wanted);
        assert!(error.contains(wanted), "{wanted}: {error}");
    };
    refused(
        "[bearing]",
        "[bearing]\ntheory = \"long\"",
        "bearing.theory: leaves out one of the flows that turbulence resists",
    );
    refused("[oil]", "[oil]\nbarus = { alpha = \"2e-8 1/Pa\" }", "oil.barus: changes the Reynolds number");
    refused(
        "[bearing]",
        "[roughness]\nmodel = \"patir-cheng\"\n\n[bearing]\nroughness = \"1 um\"",
        "roughness.model: is of laminar",
    );
    let heated = "temperature = \"65 C\"\n\n[heat]\ninlet = \"45 C\"\nfield = true\n";
    refused("temperature = \"65 C\"", heated, "turbulence.model: has no eddies across the film");
    refused("\"ng-pan\"", "\"reichardt\"", "turbulence.model: finds eddies by the temperatures across the film");
    let text = std::fs::read_to_string(path("41_thermal_turbulent")).expect("the scene");
    let cycle = text.replacen("[oil]", "[orbit]\n\n[oil]", 1);
    let error = parsed(&cycle).expect_err("a cycle");
    assert!(error.contains("turbulence.model: finds eddies for a gap that stands still"), "{error}");
}

/// Eddies at each place across the film: heat balances, the film of one temperature with Ng and Pan's fits of the same
/// eddies is near, fewer layers and a finer mesh have the same numbers within the bars.
#[test]
fn eddies_across_the_film_carry_its_heat() {
    let film = |change: &dyn Fn(&mut toml::Table)| {
        let scene = variant("41_thermal_turbulent", |scene| {
            table(scene, "mesh").insert("size".into(), "64 mm".into());
            change(scene);
        });
        run(&scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}")).result
    };
    let found = film(&|_| {});
    let of = |name: &str| found.by_name(name).expect("a quantity");
    let shares = ["heat_carried", "heat_bush"].map(|name| of(name).value);
    assert!((shares.iter().sum::<f64>() / of("heat_power").value - 1.0).abs() < 1e-9);
    for change in [
        &(|scene: &mut toml::Table| {
            table(scene, "heat").insert("layers".into(), 6.into());
        }) as &dyn Fn(&mut toml::Table),
        &|scene| {
            table(scene, "mesh").insert("size".into(), "48 mm".into());
        },
    ] {
        let other = film(change);
        for name in ["eccentricity", "film_thickness_min", "temperature_max", "temperature_journal", "friction_power"] {
            let [a, b] = [&found, &other].map(|result| result.by_name(name).expect("a quantity"));
            let bar = a.error().expect("a bar") + b.error().expect("a bar");
            assert!((a.value - b.value).abs() < bar, "{name}: {} {} {bar}", a.value, b.value);
        }
    }
    let even = film(&|scene| {
        let mean = format!("{} C", of("temperature_effective").value);
        scene.remove("heat");
        table(scene, "oil").insert("temperature".into(), mean.into());
        table(scene, "turbulence").insert("model".into(), "ng-pan".into());
    });
    for name in ["friction_power", "eccentricity"] {
        let fits = even.by_name(name).expect("a quantity").value;
        assert!((fits / of(name).value - 1.0).abs() < 0.15, "{name}: {fits} {}", of(name).value);
    }
}

/// With one temperature of the film its balance of heat closes: the turbulent film is hotter.
#[test]
fn the_temperature_of_a_turbulent_film_is_found() {
    let film = |is_turbulent: bool| {
        let scene = variant("39_turbine_turbulent", |scene| {
            table(scene, "oil").remove("temperature");
            scene.insert("heat".to_owned(), toml::Value::Table(toml::toml! { inlet = "45 C" }));
            if !is_turbulent {
                scene.remove("turbulence");
            }
        });
        let result = run(&scene, &RunOptions::default()).unwrap_or_else(|error| panic!("{error}")).result;
        move |name: &str| result.by_name(name).expect("a quantity").value
    };
    let (of, of_laminar) = (film(true), film(false));
    assert!((of("heat_carried") / of("friction_power") - 1.0).abs() < 1e-6);
    assert!(of("temperature_effective") > of_laminar("temperature_effective") + 3.0);
    assert!(of("turbulent_shear") > 2.0 && of("reynolds_number_max") > 2000.0);
}
