//! A crankshaft bearing of B/D 0.345 (eccentricity 0.8, centre at rest or closing), as a short bearing and with its real length.
//!
//! Short: closed form of Ocvirk's film with squeeze and half of it dropped, integrals by quadrature. Of finite length: finite differences,
//! 1440 x 64 points, whose So moves by 2.5e-4 when the grid is halved; Guembel there is the full periodic film with low pressures set to
//! zero, Reynolds a complementarity without feeds. Oil flow is what leaves at both ends where it leaves; power is kN1 + kN2 + kN3: shear of
//! the whole gap, pressure and squeeze.

use oilwedge_scene::scene::Scene;
use oilwedge_tests::journal_bearings::each;
use oilwedge_tests::scenes::{Solved, solve, written};

struct Row {
    model: &'static str,
    /// `2 dchi/dtau`, tau in turns of 3200 rpm in radians.
    squeeze: f64,
    speed: f64,
    /// p_max [MPa], load [N], attitude [deg], flow [ml/s], power [W].
    wanted: [f64; 5],
}

const fn row(model: &'static str, squeeze: f64, speed: f64, wanted: [f64; 5]) -> Row {
    Row {
        model,
        squeeze,
        speed,
        wanted,
    }
}

const FINITE: [Row; 20] = [
    row("guembel", 0.0, 1100.0, [1.77454, 825.743, 34.4328, 3.92709, 25.4665]),
    row("reynolds", 0.0, 1100.0, [1.8515, 901.503, 31.8504, 3.98553, 25.4851]),
    row("guembel", 0.0, 1500.0, [2.41983, 1126.01, 34.4328, 5.35513, 47.355]),
    row("reynolds", 0.0, 1500.0, [2.52478, 1229.32, 31.8504, 5.43481, 47.3897]),
    row(
        "guembel",
        0.0,
        1900.0,
        [3.06512, 1426.28, 34.4328, 6.7831600000000005, 75.9784],
    ),
    row("reynolds", 0.0, 1900.0, [3.19805, 1557.14, 31.8504, 6.8841, 76.0342]),
    row("guembel", 0.0, 2500.0, [4.03306, 1876.69, 34.4328, 8.92521, 131.542]),
    row("reynolds", 0.0, 2500.0, [4.20796, 2048.87, 31.8504, 9.05802, 131.638]),
    row("guembel", 0.0, 3200.0, [5.16231, 2402.16, 34.4328, 11.4243, 215.518]),
    row("reynolds", 0.0, 3200.0, [5.38619, 2622.56, 31.8504, 11.5943, 215.676]),
    row("guembel", 0.4, 1100.0, [15.9214, 8310.19, 5.96736, 6.82887, 51.789]),
    row("reynolds", 0.4, 1100.0, [15.9223, 8316.49, 5.90821, 6.90844, 51.7944]),
    row("guembel", 0.4, 1500.0, [16.1115, 8354.32, 7.9603, 7.72924, 74.3665]),
    row("reynolds", 0.4, 1500.0, [16.1139, 8367.45, 7.86019, 7.81886, 74.3761]),
    row("guembel", 0.4, 1900.0, [16.3525, 8416.7, 9.81282, 8.77159, 103.846]),
    row("reynolds", 0.4, 1900.0, [16.3578, 8440.38, 9.65898, 8.87321, 103.863]),
    row("guembel", 0.4, 2500.0, [16.7986, 8547.36, 12.3057, 10.5085, 160.951]),
    row("reynolds", 0.4, 2500.0, [16.8122, 8594.18, 12.0513, 10.6308, 160.985]),
    row("guembel", 0.4, 3200.0, [17.4273, 8756.0, 14.7881, 12.6945, 247.023]),
    row("reynolds", 0.4, 3200.0, [17.4577, 8839.39, 14.3979, 12.8441, 247.091]),
];

const SHORT: [Row; 10] = [
    row(
        "guembel",
        0.0,
        1100.0,
        [2.9730702, 1203.4177, 30.500153, 4.058154, 25.771403],
    ),
    row(
        "guembel",
        0.0,
        1500.0,
        [4.0541866, 1641.0241, 30.500153, 5.5338463, 47.92203],
    ),
    row(
        "guembel",
        0.0,
        1900.0,
        [5.135303, 2078.6306, 30.500153, 7.0095387, 76.888236],
    ),
    row(
        "guembel",
        0.0,
        2500.0,
        [6.7569777, 2735.0402, 30.500153, 9.2230772, 133.11675],
    ),
    row(
        "guembel",
        0.0,
        3200.0,
        [8.6489314, 3500.8515, 30.500153, 11.805539, 218.09849],
    ),
    row(
        "guembel",
        0.4,
        1100.0,
        [24.352675, 11277.171, 5.7406775, 7.1631907, 61.46027],
    ),
    row(
        "guembel",
        0.4,
        1500.0,
        [24.704582, 11343.517, 7.6344426, 8.091115, 84.531928],
    ),
    row(
        "guembel",
        0.4,
        1900.0,
        [25.147669, 11439.228, 9.3757431, 9.1638594, 114.6438],
    ),
    row(
        "guembel",
        0.4,
        2500.0,
        [25.960321, 11642.56, 11.683513, 10.950244, 172.93688],
    ),
    row(
        "guembel",
        0.4,
        3200.0,
        [27.092385, 11968.476, 13.936722, 13.198994, 260.72865],
    ),
];

const CLEARANCE: f64 = 46e-6;
/// 3200 rpm [rad/s].
const SCALE: f64 = 335.103_216_382_911_3;

impl Row {
    fn scene(&self, theory: &str, size: f64) -> Scene {
        let squeeze = match self.squeeze > 0.0 {
            true => format!(
                "squeeze = {{ radial = \"{} m/s\" }}",
                0.5 * self.squeeze * SCALE * CLEARANCE
            ),
            false => String::new(),
        };
        let (model, speed) = (self.model, self.speed);
        written(&format!(
            r#"
title = "Crankshaft bearing"
[bearing]
diameter = "74.5 mm"
length = "25.7 mm"
clearance = "46 um"
theory = "{theory}"
[mesh]
size = "{size} mm"
[journal]
speed = "{speed} rpm"
eccentricity = 0.8
min_film_angle = "180 deg"
{squeeze}
[oil]
viscosity = "6.1 mPa.s"
[cavitation]
model = "{model}"
pressure = "0 bar"
"#
        ))
    }

    fn solve(&self, theory: &str, size: f64) -> Found {
        let film = solve(&self.scene(theory, size)).unwrap_or_else(|reason| panic!("{reason}"));
        Found { film }
    }

    /// Each number against its tolerance, relative but for the angle [deg].
    fn compare(&self, found: [f64; 5], tolerances: [f64; 5]) -> Result<(), String> {
        let names = ["p_max", "load", "attitude", "flow", "power"];
        for (k, name) in names.iter().enumerate() {
            let off = match k {
                2 => found[k] - self.wanted[k],
                _ => found[k] / self.wanted[k] - 1.0,
            };
            if off.abs() > tolerances[k] {
                let Row {
                    model, squeeze, speed, ..
                } = self;
                return Err(format!(
                    "{model} E {squeeze} {speed} rpm: {name} {} is {off:.2e} off {}",
                    found[k], self.wanted[k]
                ));
            }
        }
        Ok(())
    }
}

struct Found {
    film: Solved,
}

impl Found {
    fn numbers(&self) -> [f64; 5] {
        let film = &self.film;
        let list = oilwedge_scene::measure::quantities(&film.study, &film.measured);
        let squeeze = list
            .iter()
            .find(|it| it.name == "squeeze_power")
            .map_or(0.0, |it| it.value);
        let ends = film
            .measured
            .flows
            .regions
            .iter()
            .filter(|region| region.name.starts_with("end"));
        [
            1e-6 * film.quantity("pressure_max"),
            film.quantity("load"),
            film.quantity("attitude_angle"),
            1e6 * ends.map(|region| region.outward).sum::<f64>(),
            film.quantity("friction_power") + squeeze,
        ]
    }
}

/// The differences of the grid are left: 0.3 % of the load, its parts along and across the line of centres and power, 0.5 % of p_max and flow,
/// 0.1 degrees.
#[test]
fn finite_length() {
    each(&FINITE, |row| {
        let found = row.solve("full", 2.0);
        row.compare(found.numbers(), [5e-3, 3e-3, 0.1, 5e-3, 3e-3])?;
        let [_, load, attitude, ..] = row.wanted;
        let (sin, cos) = attitude.to_radians().sin_cos();
        // Along: towards the thinnest film, at 180 degrees.
        let [x, y] = ["load_x", "load_y"].map(|name| found.film.quantity(name));
        let parts = [-x / (load * cos), y.abs() / (load * sin)];
        match parts.iter().all(|part| (part - 1.0).abs() < 3e-3) {
            true => Ok(()),
            false => Err(format!("{} E {} {} rpm: {parts:?}", row.model, row.squeeze, row.speed)),
        }
    });
}

/// The elements of a short film against its closed form, to a thousandth: the half film is cut at lines that the mesh does not know. What the
/// drag of pressure and the moving centre put in drives oil along the axis: kN2 = chi G V/2 (V the load across the line of centres), and
/// kN2 + kN3 is the heat of that flow.
#[test]
fn short() {
    each(&SHORT, |row| {
        let found = row.solve("short", 2.0);
        row.compare(found.numbers(), [1e-3, 1e-3, 0.06, 5e-3, 1e-3])?;
        let film = found.film;
        let power = &film.measured.power;
        let speed = film.study.problem.journal.speed;
        let across = film.quantity("load") * film.quantity("attitude_angle").to_radians().sin();
        let of_pressure = 0.5 * speed * 0.8 * CLEARANCE * across;
        let off = [
            power.pressure / of_pressure - 1.0,
            (power.pressure + power.squeeze) / power.driven - 1.0,
            power.imbalance,
        ];
        match off[0].abs() < 1e-3 && off[1].abs() < 1e-9 && off[2] < 1e-9 {
            true => Ok(()),
            false => Err(format!("E {} {} rpm: {off:?}", row.squeeze, row.speed)),
        }
    });
}

/// And the error of the load falls as the mesh is refined.
#[test]
fn short_converges() {
    for row in [&SHORT[0], &SHORT[9]] {
        let errors = [4.0, 2.0, 1.0].map(|size| (row.solve("short", size).numbers()[1] / row.wanted[1] - 1.0).abs());
        assert!(errors[2] < 0.25 * errors[0] && errors[2] < 2e-4, "{errors:?}");
    }
}
