//! The page `docs/theory/notation.md`: the symbols of all pages. Those of quantities and fields are rows of their catalogues; here stand the others, and
//! the keys of scenes that give them.

use std::collections::BTreeSet;

use oilwedge_scene::catalogue::keys;
use oilwedge_study::fields::FILE_FIELDS;
use oilwedge_study::quantities::{CATALOGUE, Table};

use crate::tables::{replace, row};

/// Symbol, unit, meaning, names.
type Entry = (&'static str, &'static str, &'static str, &'static [&'static str]);

/// Symbols of the theory that are in no catalogue, or have a key of a scene.
const SYMBOLS: [Entry; 76] = [
    ("D", "m", "diameter of the bearing", &["bearing.diameter"]),
    (
        "R",
        "m",
        "radius of the bearing, D/2, which stands for that of the journal too",
        &[],
    ),
    ("B", "m", "length of the bearing", &["bearing.length"]),
    ("c", "m", "radial clearance", &["bearing.clearance"]),
    ("psi", "1", "relative clearance, c/R", &[]),
    ("x", "m", "distance around the bearing, R phi", &[]),
    ("n", "1", "direction (cos phi, sin phi)", &[]),
    ("A", "m2", "area of the unrolled liner", &[]),
    ("A", "", "matrix of the tangent of a discrete film", &[]),
    (
        "omega",
        "rad/s",
        "speed of the journal against the bearing",
        &["journal.speed"],
    ),
    ("U", "m/s", "speed of the journal's surface, R omega", &[]),
    (
        "e",
        "m",
        "offset of the journal's centre at mid-length, (e_x, e_y)",
        &[],
    ),
    ("eps", "1", "eccentricity, e/c", &["journal.eccentricity"]),
    ("phi_min", "deg", "direction of the offset", &["journal.min_film_angle"]),
    ("g", "rad", "slope of the journal's axis, (g_x, g_y)", &[]),
    (
        "g_x",
        "rad",
        "slope of the journal's axis towards x",
        &["journal.tilt.x"],
    ),
    (
        "g_y",
        "rad",
        "slope of the journal's axis towards y",
        &["journal.tilt.y"],
    ),
    ("e'", "m/s", "velocity of the journal's centre", &["journal.squeeze"]),
    (
        "g'",
        "rad/s",
        "rate of the slope of the journal's axis",
        &["journal.tilt_rate"],
    ),
    ("d", "m", "depth of a pocket", &["feed.depth"]),
    ("t", "s", "time", &[]),
    ("t", "degC", "temperature of the oil", &[]),
    ("J", "m2/s", "flow of oil across a line, for each length of it", &[]),
    ("p_e", "Pa", "pressure at the ends", &["ends.pressure"]),
    ("p_s", "Pa", "pressure of a feed", &["feed.pressure"]),
    ("p_c", "Pa", "pressure in a cavity", &["cavitation.pressure"]),
    (
        "mu0",
        "Pa.s",
        "viscosity of the oil at no pressure and at the temperature of the film",
        &["oil.viscosity"],
    ),
    (
        "alpha",
        "1/Pa",
        "pressure coefficient of the viscosity (Barus, Roelands)",
        &["oil.barus.alpha", "oil.roelands.alpha"],
    ),
    ("q", "Pa", "reduced pressure, Int mu0/mu dp from 0 to p", &[]),
    (
        "nu",
        "m2/s",
        "kinematic viscosity, mu/rho",
        &["oil.walther.nu40", "oil.walther.nu100"],
    ),
    ("rho", "kg/m3", "density of the oil", &["oil.density"]),
    (
        "rho c",
        "J/(m3 K)",
        "heat capacity of the oil for each volume",
        &["heat.heat_capacity"],
    ),
    ("t_0", "degC", "temperature of the oil that is fed", &["heat.inlet"]),
    ("G", "W/K", "conductance of the housing", &["heat.housing.conductance"]),
    (
        "t_a",
        "degC",
        "temperature around the housing",
        &["heat.housing.ambient"],
    ),
    (
        "F",
        "N",
        "load that the film must carry; in equilibrium W = F",
        &["load.force"],
    ),
    ("z_F", "m", "place along the axis at which the load acts", &["load.at"]),
    ("M", "N.m", "moment beside the load, (M_x, M_y)", &["load.moment"]),
    (
        "k",
        "N.m/rad",
        "stiffness of the shaft's support against tilt",
        &["support.tilt_stiffness"],
    ),
    (
        "g_0",
        "rad",
        "slope at which the support carries no moment",
        &["support.tilt"],
    ),
    ("m", "N.m", "moment of the film, (m_x, m_y)", &[]),
    (
        "m",
        "kg",
        "mass that the journal carries along its orbit",
        &["orbit.mass"],
    ),
    ("theta", "deg", "crank angle, omega t", &[]),
    (
        "K",
        "N/m",
        "stiffness of the film, dW/de; of moments and slopes N/rad and N.m/rad",
        &["stiffness_xx", "stiffness_xy", "..."],
    ),
    (
        "C",
        "N.s/m",
        "damping of the film, dW/de'; of moments and slopes N.s/rad and N.m.s/rad",
        &["damping_xx", "damping_xy", "..."],
    ),
    (
        "nu",
        "1",
        "frequency of a small motion over the speed",
        &["dynamics.whirl"],
    ),
    ("M", "kg", "mass of a rigid rotor for each bearing", &["dynamics.mass"]),
    (
        "sigma",
        "m",
        "roughness of journal and liner together, root mean square",
        &["bearing.roughness"],
    ),
    ("h_T", "m", "mean gap of rough surfaces", &[]),
    ("E'", "Pa", "modulus of both surfaces that touch", &["contact.modulus"]),
    ("H", "Pa", "hardness of the softer surface", &["contact.hardness"]),
    (
        "r",
        "m",
        "gap at which the profiles of a bearing curve touch",
        &["contact.depth"],
    ),
    (
        "mu_b",
        "1",
        "friction coefficient of surfaces that touch",
        &["contact.friction"],
    ),
    (
        "nu",
        "1",
        "Poisson's ratio of a wall (liners that give way)",
        &["liner.wall.poisson", "liner.winkler.poisson"],
    ),
    (
        "t",
        "m",
        "thickness of a wall or a layer (liners that give way)",
        &["liner.wall.thickness", "liner.winkler.thickness"],
    ),
    (
        "E",
        "Pa",
        "Young's modulus of a wall (liners that give way), of the shaft (crankshafts)",
        &[
            "liner.wall.modulus",
            "liner.winkler.modulus",
            "crankshaft.youngs_modulus",
        ],
    ),
    (
        "d",
        "m",
        "deflection of a wall outwards, delta of the results (liners that give way)",
        &[],
    ),
    (
        "k",
        "m/Pa",
        "compliance of a layer, displacement for each pressure (liners that give way)",
        &["liner.winkler"],
    ),
    (
        "C",
        "m/Pa",
        "compliance of a wall: C p the deflection by a pressure, C_n for a wave of it (liners that give way)",
        &[],
    ),
    (
        "a",
        "m",
        "radius of the bore (liners that give way); arm of a load on a throw (crankshafts)",
        &[],
    ),
    (
        "C",
        "m/N",
        "compliance of what holds a shell (crankshafts)",
        &["crankshaft.bearing.support.stiffness"],
    ),
    ("K", "N/m", "stiffness of the shaft at its journals (crankshafts)", &[]),
    ("k", "1", "shear factor of the section of a beam (crankshafts)", &[]),
    (
        "G",
        "Pa",
        "shear modulus of the shaft (crankshafts)",
        &["crankshaft.shear_modulus"],
    ),
    (
        "l",
        "m",
        "half of a bearing's length (crankshafts); length of the rod (loads)",
        &["crank.rod_length"],
    ),
    ("r", "m", "radius of the crank (loads, crankshafts)", &["crank.radius"]),
    (
        "lambda",
        "1",
        "radius of the crank over the length of the rod (loads)",
        &[],
    ),
    ("beta", "rad", "inclination of the rod (loads)", &[]),
    (
        "a",
        "m",
        "distance of the rod's centre of mass from one eye, b from the other (loads)",
        &[],
    ),
    ("b", "m", "half of the bearing's length, B/2 (shapes)", &[]),
    ("b", "1", "B/D (characteristics)", &[]),
    (
        "gamma",
        "1",
        "slope of the journal's axis times R/c (characteristics)",
        &[],
    ),
    (
        "gamma",
        "1",
        "part of a step in time that a stage takes (orbits, liners that give way, crankshafts)",
        &[],
    ),
    ("s", "1/s", "rate of the eccentricity, eps' (characteristics)", &[]),
    ("eta", "1/m2", "asperities for each area of a surface (contact)", &[]),
    ("beta", "m", "radius of the tips of asperities (contact)", &[]),
];

/// A row of the table.
struct Line {
    symbol: &'static str,
    unit: &'static str,
    what: &'static str,
    names: Vec<String>,
}

/// The page with its table made anew.
pub fn page(text: &str) -> String {
    let head = row(["symbol", "meaning", "unit", "name in scenes, results and files"]);
    let rows = lines().into_iter().map(|line| {
        let names: Vec<String> = line.names.iter().map(|name| format!("`{name}`")).collect();
        row([&format!("`{}`", line.symbol), line.what, line.unit, &names.join(", ")])
    });
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(rows).collect();
    replace(text, "notation", &rows)
}

/// One line for each meaning: fields and quantities whose symbol and unit are those of a line before stand with it.
fn lines() -> Vec<Line> {
    let own = SYMBOLS.iter().map(|&(symbol, unit, what, names)| Line {
        symbol,
        unit,
        what,
        names: names.iter().map(|name| (*name).to_owned()).collect(),
    });
    let fields = FILE_FIELDS.iter().map(|field| Line {
        symbol: field.symbol,
        unit: field.unit,
        what: field.what,
        names: vec![field.name.to_owned()],
    });
    // Of several quantities with one symbol the one with the shortest name comes first: the others are its parts, or its greatest over a cycle.
    let mut rows: Vec<_> = CATALOGUE.iter().filter(|row| !is_coefficient(row.name)).collect();
    rows.sort_by_key(|row| (row.table != Table::Film, row.name.len()));
    let quantities = rows.into_iter().map(|row| Line {
        symbol: row.symbol,
        unit: row.unit.name(),
        what: row.what,
        names: vec![format!("{}{}", row.name, if row.is_family() { "GROUP" } else { "" })],
    });
    let mut lines: Vec<Line> = own.collect();
    for line in fields.chain(quantities) {
        let known = lines
            .iter_mut()
            .find(|known| (known.symbol, known.unit) == (line.symbol, line.unit));
        match known {
            Some(known) => known.names.extend(line.names),
            None => lines.push(line),
        }
    }
    lines
}

/// Whether a quantity is an entry of the matrices of stiffness and damping, which have one line each.
fn is_coefficient(name: &str) -> bool {
    name.starts_with("stiffness_") || name.starts_with("damping_")
}

/// Names of the table that neither a scene nor a result nor a file has.
pub fn unknown_names() -> Vec<String> {
    let mut known: BTreeSet<String> = keys().map(|key| key.path.to_owned()).collect();
    known.extend(CATALOGUE.iter().map(|row| row.name.to_owned()));
    known.insert("...".to_owned());
    let names = SYMBOLS.iter().flat_map(|(.., names)| names.iter());
    names
        .map(|name| (*name).to_owned())
        .filter(|name| !known.contains(name))
        .collect()
}
