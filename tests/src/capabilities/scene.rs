//! The scene of a row, put together from the parts that its values are.

use std::path::Path;

use oilwedge_mesh::gmsh;

use super::Row;
use crate::ring_of_radius;

/// Size and direction in which the scene of a row is written.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// Factor of all lengths.
    pub(super) size: f64,
    /// Angle by which everything is turned [deg].
    pub(super) turn: f64,
}

/// Error that a step of an orbit may make.
pub(super) const ORBIT_TOLERANCE: f64 = 0.1;
/// Eccentricity of the rows at a given position.
pub(super) const ECCENTRICITY: f64 = 0.8;
/// Load of the rows under one [N].
pub(super) const LOAD: f64 = 12e3;

/// Flow through the least film at the speed of the journal, some [m3/s].
pub(super) const FLOW: f64 = 1e-6;

const RADIUS: f64 = 0.032;
/// Cells around and along the liner.
const CELLS: [u32; 2] = [24, 4];
const MESH: &str = "ring.msh";
const BEARING: &str = "bearing.toml";

impl Frame {
    /// The scene as it is.
    pub(super) const OWN: Self = Self { size: 1.0, turn: 0.0 };
    /// Twice the size, and turned by a quarter.
    pub(super) const TWIN: Self = Self { size: 2.0, turn: 90.0 };

    /// A value with a unit that grows with this power of the size.
    fn of(self, value: f64, power: i32, unit: &str) -> String {
        format!("\"{} {unit}\"", value * self.size.powi(power))
    }

    fn angle(self, degrees: f64) -> String {
        format!("\"{} deg\"", degrees + self.turn)
    }

    /// Both parts of a vector towards an angle [deg].
    fn parts(self, value: f64, power: i32, unit: &str, towards: f64) -> String {
        // Quarter turns are exact.
        let (sin, cos) = towards.to_radians().sin_cos();
        let [x, y] = if self.turn == 90.0 { [-sin, cos] } else { [cos, sin] };
        format!("{{ x = {}, y = {} }}", self.of(value * x, power, unit), self.of(value * y, power, unit))
    }
}

/// Writes mesh and scenes of a row into a folder; the text of the scene to be solved.
///
/// # Panics
/// A file cannot be written.
pub(super) fn written(row: &Row, frame: Frame, folder: &Path) -> String {
    let radius = frame.size * RADIUS;
    let mesh = ring_of_radius(radius, CELLS[0], CELLS[1], radius, 0.0);
    gmsh::write(&mesh, folder.join(MESH)).expect("a mesh");
    let bearing = bearing(row, frame);
    let shaft = match row[1] {
        "shaft" => at_rest(frame),
        "crankshaft" => with_a_throw(frame),
        _ => return bearing,
    };
    std::fs::write(folder.join(BEARING), bearing).expect("a scene");
    shaft
}

fn bearing(row: &Row, frame: Frame) -> String {
    let [cavitation, analysis, wall, surfaces, temperature] = *row;
    let parts = [
        format!(
            "bearing = {{ diameter = {}, length = {}, clearance = {}, roughness = {} }}\nmesh.file = \"{MESH}\"",
            frame.of(64.0, 1, "mm"),
            frame.of(32.0, 1, "mm"),
            frame.of(32.0, 1, "um"),
            frame.of(2.4, 1, "um"),
        ),
        // A film that conserves its oil takes it in at its ends.
        format!("ends.pressure = \"1 bar\"\ncavitation.model = \"{cavitation}\""),
        self::analysis(analysis, cavitation, frame),
        match wall {
            "layer" => format!("liner.winkler = {}", frame.of(0.05, 1, "um/MPa")),
            "ring" => format!(
                "liner.wall = {{ thickness = {}, modulus = \"70 GPa\", poisson = 0.3 }}",
                frame.of(6.0, 1, "mm")
            ),
            _ => String::new(),
        },
        match surfaces {
            "contact" => "contact = { model = \"greenwood-tripp\", eta_beta_sigma = 0.05, sigma_over_beta = 0.01, \
                          modulus = \"115 GPa\", hardness = \"900 MPa\", friction = 0.1 }"
                .to_owned(),
            _ => String::new(),
        },
        match temperature {
            "heat" => format!(
                "oil.grade = \"ISO VG 46\"\nheat = {{ inlet = \"50 C\", housing = {{ conductance = {}, ambient = \"30 C\" }} }}",
                frame.of(5.0, 3, "W/K")
            ),
            _ => "oil.viscosity = \"16 mPa.s\"".to_owned(),
        },
    ];
    parts.join("\n") + "\n"
}

fn analysis(analysis: &str, cavitation: &str, frame: Frame) -> String {
    let moving = "journal.speed = \"300 rad/s\"";
    let load = |keys: String| {
        format!("{moving}\nload = {{ force = {}, angle = {}{keys} }}", frame.of(LOAD, 2, "N"), frame.angle(270.0))
    };
    match analysis {
        "load" => load(String::new()),
        "moment" => {
            let moment = frame.parts(10.0, 3, "N.m", 60.0);
            let support = frame.of(20e3, 3, "N.m/rad");
            load(format!(", at = {}, moment = {moment}", frame.of(1.0, 1, "mm")))
                + &format!("\nsupport.tilt_stiffness = {support}")
        }
        "orbit" => {
            // A full film damps nothing: under a steady load its orbits do not close.
            let steady = if cavitation == "none" { 0.0 } else { LOAD };
            let [steady, cos, sin] = [(steady, 0.0), (0.4 * LOAD, 0.0), (0.4 * LOAD, 60.0)]
                .map(|(force, at)| frame.parts(force, 2, "N", at));
            format!(
                "{moving}\nload = {{ frame = \"shell\", period = \"720 deg\", harmonics = [{{ order = 0, cos = {steady} }}, \
                 {{ order = 2, cos = {cos}, sin = {sin} }}] }}\n\
                 orbit = {{ tolerance = {ORBIT_TOLERANCE}, closure = 0.1, cycles = 4 }}"
            )
        }
        // A shaft gives its bearings their loads.
        _ => format!(
            "journal = {{ speed = \"300 rad/s\", eccentricity = {ECCENTRICITY}, min_film_angle = {} }}",
            frame.angle(40.0)
        ),
    }
}

const STEEL: &str = "[crankshaft]\nspeed = \"300 rad/s\"\nyoungs_modulus = \"206 GPa\"\nshear_modulus = \"80 GPa\"\n";

fn bearings_at(places: [f64; 2], frame: Frame) -> String {
    let places = places.map(|at| format!("{{ scene = \"{BEARING}\", at = {} }}", frame.of(at, 1, "mm")));
    format!("bearing = [{}]\n", places.join(", "))
}

fn straight(length: f64, frame: Frame) -> String {
    format!("{{ length = {}, diameter = {} }}", frame.of(length, 1, "mm"), frame.of(64.0, 1, "mm"))
}

/// A straight shaft under a load off its middle.
fn at_rest(frame: Frame) -> String {
    format!(
        "{STEEL}piece = [{}]\n{}load = [{{ at = {}, force = {}, angle = {} }}]\n",
        straight(300.0, frame),
        bearings_at([40.0, 260.0], frame),
        frame.of(120.0, 1, "mm"),
        frame.of(20e3, 2, "N"),
        frame.angle(270.0),
    )
}

/// A shaft of one throw, whose journals stay parallel to their shells. Its cylinder lies where it does, so that it is
/// not turned.
fn with_a_throw(frame: Frame) -> String {
    let mm = |length: f64| frame.of(length, 1, "mm");
    let kg = |mass: f64| frame.of(mass, 1, "kg");
    let end = straight(60.0, frame);
    format!(
        "{STEEL}tilt = \"none\"\npiece = [{end}, {{ fires_at = \"0 deg\" }}, {end}]\n\
         throw = {{ pin_length = {}, pin_diameter = {}, web_thickness = {}, web_mass = {} }}\n{}\
         [crank]\nradius = {}\nrod_length = {}\nreciprocating_mass = {}\nrotating_mass = {}\nbore = {}\n\
         gas = {{ peak = \"4 MPa\", angle = \"12 deg\", sharpness = 14 }}\n\
         [orbit]\ntolerance = {ORBIT_TOLERANCE}\nclosure = 0.1\ncycles = 4\n",
        mm(40.0),
        mm(60.0),
        mm(20.0),
        kg(2.0),
        bearings_at([30.0, 170.0], frame),
        mm(40.0),
        mm(140.0),
        kg(1.0),
        kg(1.0),
        mm(80.0),
    )
}
