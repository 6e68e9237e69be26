//! A crankshaft bearing of B/D 0.345 (eccentricity 0.8, centre at rest or closing), as a short bearing and with its
//! real length.
//!
//! Short: closed form of Ocvirk's film with squeeze and half of it dropped, integrals by quadrature. Of finite length:
//! finite differences, 1440 x 64 points, whose So moves by 2.5e-4 when the grid is halved; Guembel there is the full
//! periodic film with low pressures set to zero, Reynolds a complementarity without feeds. Oil flow is what leaves at
//! both ends where it leaves; power is kN1 + kN2 + kN3: shear of the whole gap, pressure and squeeze. The numbers are
//! `tests/data/source000/finite_length.csv`.

use oilwedge_tests::journal_bearings::each;
use oilwedge_tests::printed::{Row, rows};
use oilwedge_tests::short_crankshaft::finite::Film;

/// A film of the table, and what is wanted of it.
struct Case {
    theory: &'static str,
    model: &'static str,
    /// `2 dchi/dtau`, tau in turns of 3200 rpm in radians.
    squeeze: f64,
    speed: f64,
    /// Expected p_max [MPa], load [N], attitude [deg], flow [ml/s], power [W].
    wanted: [f64; 5],
}

/// The films of that kind in the table of finite differences, which has the closed form too.
fn cases(theory: &'static str) -> Vec<Case> {
    let of = |row: &Row| {
        let (kind, model) = match row.text("model") {
            "short_GUM" => ("short", "guembel"),
            "finite_GUM" => ("full", "guembel"),
            "finite_REY" => ("full", "reynolds"),
            other => panic!("what is {other}?"),
        };
        let flow = 1e6 * row.number("Q_both_ends");
        let wanted = ["p_max", "R", "theta"].map(|column| row.number(column));
        let [pressure, load, attitude] = wanted;
        (kind == theory).then(|| Case {
            theory,
            model,
            squeeze: row.number("E"),
            speed: row.number("n"),
            wanted: [pressure, load, attitude, flow, row.number("N")],
        })
    };
    rows("source000/finite_length.csv").iter().filter_map(of).collect()
}

const CLEARANCE: f64 = 46e-6;

impl Case {
    fn solve(&self, size: f64) -> Film {
        Film::new(self.model, self.theory, [self.squeeze, self.speed], size)
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
                let Case { model, squeeze, speed, .. } = self;
                return Err(format!(
                    "{model} E {squeeze} {speed} rpm: {name} {} is {off:.2e} off {}",
                    found[k], self.wanted[k]
                ));
            }
        }
        Ok(())
    }
}

/// Computed p_max [MPa], load [N], attitude [deg], flow [ml/s], power [W].
fn numbers(film: &Film) -> [f64; 5] {
    let of_film = |name: &str| film.solved.quantity(name);
    [
        1e-6 * of_film("pressure_max"),
        of_film("load"),
        of_film("attitude_angle"),
        1e6 * film.side_flow(),
        film.powers().iter().sum(),
    ]
}

/// The differences of the grid are left: 0.3 % of the load, its parts along and across the line of centres and power,
/// 0.5 % of p_max and flow, 0.1 degrees.
#[test]
fn finite_length() {
    let all = cases("full");
    assert_eq!(all.len(), 20);
    each(&all, |row| {
        let found = row.solve(2.0);
        row.compare(numbers(&found), [5e-3, 3e-3, 0.1, 5e-3, 3e-3])?;
        let [_, load, attitude, ..] = row.wanted;
        let (sin, cos) = attitude.to_radians().sin_cos();
        // Along: towards the thinnest film, at 180 degrees.
        let [x, y] = ["load_x", "load_y"].map(|name| found.solved.quantity(name));
        let parts = [-x / (load * cos), y.abs() / (load * sin)];
        match parts.iter().all(|part| (part - 1.0).abs() < 3e-3) {
            true => Ok(()),
            false => Err(format!("{} E {} {} rpm: {parts:?}", row.model, row.squeeze, row.speed)),
        }
    });
}

/// The elements of a short film against its closed form, to a thousandth: the half film is cut at lines that the mesh
/// does not know. What the drag of pressure and the moving centre put in drives oil along the axis: kN2 = chi G V/2 (V
/// the load across the line of centres), and kN2 + kN3 is the heat of that flow.
#[test]
fn short() {
    let all = cases("short");
    assert_eq!(all.len(), 10);
    each(&all, |row| {
        let found = row.solve(2.0);
        row.compare(numbers(&found), [1e-3, 1e-3, 0.06, 5e-3, 1e-3])?;
        let film = found.solved;
        let power = &film.measured.power;
        let speed = film.study.problem.journal.speed;
        let across = film.quantity("load") * film.quantity("attitude_angle").to_radians().sin();
        let of_pressure = 0.5 * speed * 0.8 * CLEARANCE * across;
        let off =
            [power.pressure / of_pressure - 1.0, (power.pressure + power.motion) / power.driven - 1.0, power.imbalance];
        match off[0].abs() < 1e-3 && off[1].abs() < 1e-9 && off[2] < 1e-9 {
            true => Ok(()),
            false => Err(format!("E {} {} rpm: {off:?}", row.squeeze, row.speed)),
        }
    });
}

/// The error of the load falls as the mesh is refined.
#[test]
fn short_converges() {
    let all = cases("short");
    for row in [&all[0], &all[9]] {
        let errors = [4.0, 2.0, 1.0].map(|size| (numbers(&row.solve(size))[1] / row.wanted[1] - 1.0).abs());
        assert!(errors[2] < 0.25 * errors[0] && errors[2] < 2e-4, "{errors:?}");
    }
}
