//! A crankshaft bearing as a document has it that prints seven tables and thirteen figures of it, in the document's own
//! arithmetic, by the right short bearing, and with its real length.
//!
//! "Qualitative analysis of the bearings of an engine's crankshaft", task 1, South Ural State University, 2023 (in
//! Russian). D = 74.5 mm, B = 25.7 mm, **diametral** clearance 0.092 mm, eps = 0.8, mu = 6.1 mPa s; phi from the
//! narrowest film; at rest (E = 0) and squeezed (E = 0.4), at five speeds. [`Document`] is the arithmetic of the print,
//! slips and all; nothing else may use it.

pub mod finite;

use std::f64::consts::PI;

use oilwedge_reynolds::analytical::ocvirk::{ShortFilm, shear_power};

use crate::printed::Row;

/// D [m].
pub const DIAMETER: f64 = 0.0745;
/// B [m].
pub const LENGTH: f64 = 0.0257;
/// The document's "clearance" [m]: twice the radial one.
pub const DIAMETRAL_CLEARANCE: f64 = 92e-6;
/// Eccentricity chi.
pub const ECCENTRICITY: f64 = 0.8;
/// Viscosity mu [Pa s].
pub const VISCOSITY: f64 = 0.0061;
/// Viscosity of the scales mu_0 [Pa s]; it cancels.
pub const VISCOSITY_SCALE: f64 = 0.0069;
/// Speed of the scales omega_0 [rad/s]; it cancels too.
pub const SPEED_SCALE: f64 = PI * 3200.0 / 30.0;
/// The speeds n [1/min].
pub const SPEEDS: [f64; 5] = [1100.0, 1500.0, 1900.0, 2500.0, 3200.0];
/// E of the two cases.
pub const SQUEEZES: [f64; 2] = [0.0, 0.4];
/// Relative viscosity mu_1.
pub const RELATIVE_VISCOSITY: f64 = VISCOSITY / VISCOSITY_SCALE;

/// Cells that are slips of the pen: table, E, n, row of the case, column, and what the document's own arithmetic gives
/// there.
pub const SLIPS: [(&str, f64, f64, usize, &str, f64); 8] = [
    ("table1", 0.0, 2500.0, 6, "phi[rad]", 4.188790),
    ("table1", 0.0, 3200.0, 6, "phi[rad]", 4.188790),
    ("table3", 0.4, 1100.0, 0, "phi_max[deg]", 355.4915),
    ("table3", 0.4, 1500.0, 0, "phi_max[deg]", 356.8476),
    ("table3", 0.4, 1900.0, 0, "phi_max[deg]", 350.1009),
    ("table3", 0.4, 2500.0, 0, "phi_max[deg]", 352.6192),
    ("table3", 0.4, 3200.0, 0, "phi_max[deg]", 356.5651),
    ("table8", 0.0, 3200.0, 0, "q[-]", 0.1),
];

/// The film of E and n [1/min].
pub fn film_at(squeeze: f64, speed: f64) -> ShortFilm {
    ShortFilm { eccentricity: ECCENTRICITY, rotation: speed / 3200.0, closing: squeeze }
}

/// The film of a row, by its E and n.
pub fn film(row: &Row) -> ShortFilm {
    film_at(row.number("E"), row.number("n"))
}

/// Half-width over radius, relative clearance and scale of pressure [Pa].
#[derive(Clone, Copy)]
pub struct Scales {
    /// Half-width over radius.
    pub width: f64,
    /// Relative clearance psi.
    pub clearance: f64,
    /// Pressure scale p* [Pa].
    pub pressure: f64,
}

impl Scales {
    fn new(width: f64, clearance: f64) -> Self {
        Self { width, clearance, pressure: VISCOSITY_SCALE * SPEED_SCALE / (clearance * clearance) }
    }

    /// The scales that the bearing has.
    pub fn right() -> Self {
        Self::new(LENGTH / DIAMETER, DIAMETRAL_CLEARANCE / DIAMETER)
    }

    /// Diameter for radius, diametral for radial clearance.
    pub fn printed() -> Self {
        Self::new(LENGTH / (2.0 * DIAMETER), DIAMETRAL_CLEARANCE / (0.5 * DIAMETER))
    }

    /// What turns the library's numbers, which are over `(B/D)^2` and at mu, into the document's.
    pub fn factor(self) -> f64 {
        self.width * self.width * RELATIVE_VISCOSITY
    }
}

/// The arithmetic of the document's spreadsheet.
pub struct Document {
    /// The film.
    pub film: ShortFilm,
    /// Diameter for radius, diametral for radial clearance.
    pub scales: Scales,
}

impl Document {
    /// The document of a film.
    pub fn new(film: ShortFilm) -> Self {
        Self { film, scales: Scales::printed() }
    }

    /// The document of a row, by its E and n.
    pub fn of(row: &Row) -> Self {
        Self::new(film(row))
    }

    /// Pi(phi, 0).
    pub fn pressure(&self, phi: f64) -> f64 {
        self.scales.factor() * self.film.pressure(phi, 0.0)
    }

    /// Angle phi [rad] of the points of tables 1 and 2.
    pub fn angle(&self, k: usize) -> f64 {
        self.film.loaded_from() + (10.0 * k as f64).to_radians()
    }

    /// Greatest Pi of those points, and its phi [rad].
    fn greatest(&self) -> (f64, f64) {
        let points = (0..19).map(|k| self.angle(k)).map(|phi| (self.pressure(phi), phi));
        points.max_by(|a, b| a.0.total_cmp(&b.0)).expect("points")
    }

    /// A3_11, A1_00, A2_00, A3_00, A3_02, A3_20 of the spreadsheet: `+` for `-` in A2_00, `q` for `q^2` in A3_00.
    fn integrals(&self) -> [f64; 6] {
        let chi = ECCENTRICITY;
        let (s, c) = self.film.loaded_from().sin_cos();
        let (rest, q) = (1.0 - chi * chi, 1.0 - chi * chi * c * c);
        let a1 = 2.0 / rest.sqrt() * (PI / 2.0 - (chi * s / rest.sqrt()).atan());
        let a2 = (a1 + 2.0 * chi * s / q) / rest;
        let a3 = (3.0 * a2 - a1 - 2.0 * chi * s * (1.0 + chi * chi * c * c) / q) / (2.0 * rest);
        let a3_02 = (a1 - 2.0 * a2 + a3) / (chi * chi);
        [2.0 * chi * c.powi(3) / (q * q), a1, a2, a3, a3_02, a3 - a3_02]
    }

    /// V and W.
    fn load(&self) -> [f64; 2] {
        let [a3_11, .., a3_02, a3_20] = self.integrals();
        let (g, e) = (self.film.rotation, self.film.closing);
        let factor = -ECCENTRICITY * self.scales.factor();
        [factor * (a3_20 * g - e / ECCENTRICITY * a3_11), factor * (a3_11 * g - e / ECCENTRICITY * a3_02)]
    }

    fn sommerfeld_number(&self) -> f64 {
        let [v, w] = self.load();
        v.hypot(w)
    }

    /// Attitude angle theta [rad].
    fn attitude(&self) -> f64 {
        let [v, w] = self.load();
        -(v / w).atan() + PI / 2.0 * (1.0 - w.signum())
    }

    fn side_flow(&self) -> f64 {
        -self.film.rotation * ECCENTRICITY / (8.0 * self.film.loaded_from().cos())
    }

    /// Powers kN1, kN2, kN3.
    fn power(&self) -> [f64; 3] {
        let [v, w] = self.load();
        [
            RELATIVE_VISCOSITY * shear_power(ECCENTRICITY, self.film.rotation),
            -0.5 * ECCENTRICITY * self.film.rotation * v,
            0.5 * self.film.closing * w,
        ]
    }

    /// Pi(phi*, z) of table 4, zeta = z/a: phi* is that of the first column of its case in all five.
    pub fn pressure_along(&self, zeta: f64) -> f64 {
        let first = film_at(self.film.closing, SPEEDS[0]);
        self.scales.factor() * self.film.pressure(first.loaded_from() + PI / 2.0, zeta)
    }

    /// The value of a column that does not depend on the row within a case.
    ///
    /// # Panics
    /// If there is no such column.
    pub fn value(&self, column: &str) -> f64 {
        let [a3_11, a1_00, a2_00, a3_00, a3_02, a3_20] = self.integrals();
        let so = self.sommerfeld_number();
        let mean = self.scales.pressure * so;
        let [kn1, kn2, kn3] = self.power();
        let volume = 0.5 * LENGTH * DIAMETER * DIAMETER;
        let Scales { clearance, pressure, .. } = self.scales;
        match column {
            "maxPi[-]" => self.greatest().0,
            "phi_max[deg]" => self.greatest().1.to_degrees(),
            "maxP[Pa]" => pressure * self.greatest().0,
            "A3_11" => a3_11,
            "A1_00" => a1_00,
            "A2_00" => a2_00,
            "A3_00" => a3_00,
            "A3_02" => a3_02,
            "A3_20" => a3_20,
            "V[-]" => self.load()[0],
            "W[-]" => self.load()[1],
            "So[-]" => so,
            "S1[-]" => so / (clearance * clearance),
            "P_mean[Pa]" => mean,
            "R[N]" => mean * LENGTH * DIAMETER,
            "theta[rad]" => self.attitude(),
            "theta[deg]" => self.attitude().to_degrees(),
            "kP[-]" => self.greatest().0 / so,
            "q[-]" => self.side_flow(),
            "kN1" | "kN1[-]" => kn1,
            "kN2" | "kN2[-]" => kn2,
            "kN3" | "kN3[-]" => kn3,
            "kN" | "kN[-]" => kn1 + kn2 + kn3,
            "Q[m3/s]" => volume * clearance * SPEED_SCALE * self.side_flow(),
            "N[W]" => volume * VISCOSITY_SCALE * SPEED_SCALE.powi(2) / clearance * (kn1 + kn2 + kn3),
            _ => panic!("no column {column}"),
        }
    }
}

/// Pi(phi, zeta) of the right short bearing.
pub fn right_pressure(film: &ShortFilm, phi: f64, zeta: f64) -> f64 {
    Scales::right().factor() * film.pressure(phi, zeta)
}

/// Where the pressure of the loaded half is greatest: phi [rad], by bisection of its slope.
pub fn summit(film: &ShortFilm) -> f64 {
    let slope = |phi: f64| {
        let (s, c) = phi.sin_cos();
        let (drive, thick) = (ECCENTRICITY * film.rotation * s - film.closing * c, 1.0 - ECCENTRICITY * c);
        3.0 * ECCENTRICITY * s * drive - (ECCENTRICITY * film.rotation * c + film.closing * s) * thick
    };
    let (mut low, mut high) = (film.loaded_from(), film.loaded_from() + PI);
    assert!(slope(low) > 0.0 && slope(high) < 0.0);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        *(if slope(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    0.5 * (low + high)
}

/// The right value of a column, from the closed form of the library. Flow is that of both ends.
///
/// # Panics
/// If there is no such column.
pub fn right(film: &ShortFilm, column: &str) -> f64 {
    let scales = Scales::right();
    let (a, load, factor) = (film.half_integrals(), film.half_film(), scales.factor());
    let greatest = factor * film.pressure(summit(film), 0.0);
    let so = factor * load.magnitude();
    let power = RELATIVE_VISCOSITY * shear_power(ECCENTRICITY, film.rotation)
        + factor * film.pumping_power().iter().sum::<f64>();
    let volume = 0.5 * LENGTH * DIAMETER * DIAMETER;
    match column {
        "maxPi[-]" => greatest,
        "phi_max[deg]" => summit(film).to_degrees(),
        "maxP[Pa]" => scales.pressure * greatest,
        "V[-]" => factor * load.across,
        "W[-]" => factor * load.along,
        "So[-]" => so,
        "S1[-]" => so / (scales.clearance * scales.clearance),
        "P_mean[Pa]" => scales.pressure * so,
        "R[N]" => scales.pressure * so * LENGTH * DIAMETER,
        "theta[rad]" => load.attitude(),
        "theta[deg]" => load.attitude().to_degrees(),
        "kP[-]" => greatest / so,
        "q[-]" => film.side_flow(),
        "kN1[-]" => RELATIVE_VISCOSITY * shear_power(ECCENTRICITY, film.rotation),
        "kN2[-]" => factor * film.pumping_power()[0],
        "kN3[-]" => factor * film.pumping_power()[1],
        "kN[-]" => power,
        "Q[m3/s]" => volume * scales.clearance * SPEED_SCALE * film.side_flow(),
        "N[W]" => volume * VISCOSITY_SCALE * SPEED_SCALE.powi(2) / scales.clearance * power,
        "G" => film.rotation,
        "phiH_deg" => film.loaded_from().to_degrees(),
        "A3_11" => a.a3_11,
        "A1_00" => a.a1_00,
        "A2_00" => a.a2_00,
        "A3_00" => a.a3_00,
        "A3_02" => a.a3_02,
        "A3_20" => a.a3_20,
        "V" => factor * load.across,
        "W" => factor * load.along,
        "So" => so,
        "theta_deg" => load.attitude().to_degrees(),
        "maxPi" => greatest,
        "phi_max_deg" => summit(film).to_degrees(),
        "p_max_MPa" => 1e-6 * scales.pressure * greatest,
        "p_mean_MPa" => 1e-6 * scales.pressure * so,
        "R_N" => scales.pressure * so * LENGTH * DIAMETER,
        "So_DIN" => so / (RELATIVE_VISCOSITY * film.rotation),
        "kP" => greatest / so,
        "q_total" => film.side_flow(),
        "Q_total_m3s" => volume * scales.clearance * SPEED_SCALE * film.side_flow(),
        "kN" => power,
        "N_W" => volume * VISCOSITY_SCALE * SPEED_SCALE.powi(2) / scales.clearance * power,
        _ => panic!("no column {column}"),
    }
}
