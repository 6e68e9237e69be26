//! The crankshaft bearing with its real length (and, to compare, as a short one) in finite elements: scenes 21 and 22
//! with one speed and model each.

use oilwedge_fem::Field;
use oilwedge_mesh::Locator;
use oilwedge_scene::Scene;
use oilwedge_study::quantities::{View, measured};

use super::{DIAMETER, LENGTH, SPEED_SCALE, Scales, VISCOSITY_SCALE};
use crate::scenes::{Solved, solve, table, variant};

/// The scene of that E and n [1/min], by a model of cavitation, a theory, and on a mesh of that size [mm].
pub fn scene(model: &str, theory: &str, [squeeze, speed]: [f64; 2], size: f64) -> Scene {
    let name = match squeeze > 0.0 {
        true => "22_squeezed_crankshaft_bearing",
        false => "21_short_crankshaft_bearing",
    };
    variant(name, |scene| {
        table(scene, "bearing").insert("theory".into(), theory.into());
        table(scene, "journal").insert("speed".into(), format!("{speed} rpm").into());
        table(scene, "mesh").insert("size".into(), format!("{size} mm").into());
        let cavitation = table(scene, "cavitation");
        cavitation.insert("model".into(), model.into());
        cavitation.insert("pressure".into(), "0 bar".into());
    })
}

/// A solved film of it.
pub struct Film {
    /// The film.
    pub solved: Solved,
}

impl Film {
    /// Solves [`scene`].
    ///
    /// # Panics
    /// If there is no film.
    pub fn new(model: &str, theory: &str, case: [f64; 2], size: f64) -> Self {
        let solved = solve(&scene(model, theory, case, size)).unwrap_or_else(|reason| panic!("{reason}"));
        Self { solved }
    }

    /// Pi over the right scale at phi [rad] from the narrowest film and zeta = 2 z/B; below zero there is none.
    ///
    /// # Panics
    /// If there is no such place.
    pub fn pressure(&self, phi: f64, zeta: f64) -> f64 {
        let (study, film) = (&self.solved.study, &self.solved.film);
        let space = study.system.space();
        let angle = phi + study.problem.journal.min_film_angle();
        let place = [0.5 * DIAMETER * angle, 0.5 * LENGTH * zeta];
        let (triangle, point) = Locator::new(space.mesh()).nearest(place).expect("a place of the ring");
        let values = &film.solution.unknown;
        let unknown = Field { space, values }.value(triangle, point);
        study.problem.pressure_at(unknown).max(0.0) / Scales::right().pressure
    }

    /// Angle phi [deg] at which the pressure is greatest.
    fn summit(&self) -> f64 {
        let space = self.solved.study.system.space();
        let values = &self.solved.film.solution.unknown;
        let top = Field { space, values }.maximum();
        let [a, b, c] = space.mesh().corners(top.triangle);
        let x = a[0] + top.point[0] * (b[0] - a[0]) + top.point[1] * (c[0] - a[0]);
        let phi = x / (0.5 * DIAMETER) - self.solved.study.problem.journal.min_film_angle();
        phi.to_degrees().rem_euclid(360.0)
    }

    /// What leaves at both ends [m3/s].
    pub fn side_flow(&self) -> f64 {
        let regions = &self.solved.measured.flows.regions;
        let ends = regions.iter().filter(|region| region.name.starts_with("end"));
        ends.map(|region| -region.net).sum()
    }

    /// Shear, pressure and squeeze [W].
    pub fn powers(&self) -> [f64; 3] {
        let list = measured(&View::new(&self.solved.study, &self.solved.study.problem, &self.solved.measured));
        ["friction_shear_power", "friction_pressure_power", "squeeze_power"]
            .map(|name| list.iter().find(|it| it.name == name).map_or(0.0, |it| it.value))
    }

    /// The value of a column of the document over the right scales; none of what only closed forms have. Flow is that
    /// of both ends.
    pub fn value(&self, column: &str) -> Option<f64> {
        let scales = Scales::right();
        let area = LENGTH * DIAMETER;
        let quantity = |name: &str| self.solved.quantity(name);
        let mean = quantity("load") / area;
        let volume = 0.5 * LENGTH * DIAMETER * DIAMETER;
        let power = volume * VISCOSITY_SCALE * SPEED_SCALE.powi(2) / scales.clearance;
        let powers = self.powers();
        Some(match column {
            "maxPi[-]" => quantity("pressure_max") / scales.pressure,
            "phi_max[deg]" => self.summit(),
            "maxP[Pa]" => quantity("pressure_max"),
            // The narrowest film is at 180 degrees.
            "W[-]" => -quantity("load_x") / area / scales.pressure,
            "V[-]" => -quantity("load_y") / area / scales.pressure,
            "So[-]" => mean / scales.pressure,
            "S1[-]" => mean / scales.pressure / scales.clearance.powi(2),
            "P_mean[Pa]" => mean,
            "R[N]" => quantity("load"),
            "theta[rad]" => quantity("attitude_angle").to_radians(),
            "theta[deg]" => quantity("attitude_angle"),
            "kP[-]" => quantity("pressure_max") / mean,
            "q[-]" => self.side_flow() / (volume * scales.clearance * SPEED_SCALE),
            "Q[m3/s]" => self.side_flow(),
            "kN1[-]" => powers[0] / power,
            "kN2[-]" => powers[1] / power,
            "kN3[-]" => powers[2] / power,
            "kN[-]" => powers.iter().sum::<f64>() / power,
            "N[W]" => powers.iter().sum(),
            _ => return None,
        })
    }
}
