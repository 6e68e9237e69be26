//! Units that no table lists are composed of symbols: `daN`, `kgf/cm2`, `lbf.s/in2`.
//!
//! A unit is a product of symbols with powers, some behind a slash; a symbol of the SI may have a prefix. Symbols that
//! mean more than one size (`ton`, `hp`) or that are no multiple of one (`SUS`) are told with their conversion instead.

use std::f64::consts::{PI, TAU};

use crate::dimension::{ATMOSPHERE, BAR, GRAVITY, INCH, POUND, POUND_FORCE, PSI, TECHNICAL_ATMOSPHERE};

/// A unit as its size in SI and its powers of kg, m, s, K, and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Composed {
    pub(super) size: f64,
    pub(super) powers: [i32; 5],
}

const MASS: [i32; 5] = [1, 0, 0, 0, 0];
const LENGTH: [i32; 5] = [0, 1, 0, 0, 0];
const TIME: [i32; 5] = [0, 0, 1, 0, 0];
const KELVIN: [i32; 5] = [0, 0, 0, 1, 0];
const ANGLE: [i32; 5] = [0, 0, 0, 0, 1];
const RATE: [i32; 5] = [0, 0, -1, 0, 1];
const VOLUME: [i32; 5] = [0, 3, 0, 0, 0];
const FORCE: [i32; 5] = [1, 1, -2, 0, 0];
const PRESSURE: [i32; 5] = [1, -1, -2, 0, 0];
const ENERGY: [i32; 5] = [1, 2, -2, 0, 0];
const POWER: [i32; 5] = [1, 2, -3, 0, 0];
const VISCOSITY: [i32; 5] = [1, -1, -1, 0, 0];
const DIFFUSION: [i32; 5] = [0, 2, -1, 0, 0];

/// Symbols that may have a prefix.
const PREFIXED: [(&str, f64, [i32; 5]); 18] = [
    ("m", 1.0, LENGTH),
    ("g", 1e-3, MASS),
    ("s", 1.0, TIME),
    ("K", 1.0, KELVIN),
    ("rad", 1.0, ANGLE),
    ("N", 1.0, FORCE),
    ("Pa", 1.0, PRESSURE),
    ("bar", BAR, PRESSURE),
    ("J", 1.0, ENERGY),
    ("cal", 4.184, ENERGY),
    ("W", 1.0, POWER),
    ("l", 1e-3, VOLUME),
    ("L", 1e-3, VOLUME),
    ("P", 0.1, VISCOSITY),
    ("reyn", PSI, VISCOSITY),
    ("St", 1e-4, DIFFUSION),
    ("Hz", TAU, RATE),
    ("rpm", PI / 30.0, RATE),
];

/// Symbols that have no prefix.
const PLAIN: [(&str, f64, [i32; 5]); 45] = [
    ("in", INCH, LENGTH),
    ("inch", INCH, LENGTH),
    ("ft", 12.0 * INCH, LENGTH),
    ("mil", 1e-3 * INCH, LENGTH),
    ("thou", 1e-3 * INCH, LENGTH),
    ("uin", 1e-6 * INCH, LENGTH),
    ("micron", 1e-6, LENGTH),
    ("t", 1e3, MASS),
    ("lb", POUND, MASS),
    ("oz", POUND / 16.0, MASS),
    ("slug", POUND_FORCE / (12.0 * INCH), MASS),
    ("min", 60.0, TIME),
    ("h", 3600.0, TIME),
    ("deg", PI / 180.0, ANGLE),
    ("gon", PI / 200.0, ANGLE),
    ("arcmin", PI / 10_800.0, ANGLE),
    ("arcsec", PI / 648_000.0, ANGLE),
    ("rev", TAU, ANGLE),
    ("r", TAU, ANGLE),
    ("U", TAU, ANGLE),
    ("turn", TAU, ANGLE),
    ("rps", TAU, RATE),
    ("cc", 1e-6, VOLUME),
    ("kgf", GRAVITY, FORCE),
    ("gf", 1e-3 * GRAVITY, FORCE),
    ("tf", 1e3 * GRAVITY, FORCE),
    ("kp", GRAVITY, FORCE),
    ("lbf", POUND_FORCE, FORCE),
    ("ozf", POUND_FORCE / 16.0, FORCE),
    ("kip", 1e3 * POUND_FORCE, FORCE),
    ("dyn", 1e-5, FORCE),
    ("psi", PSI, PRESSURE),
    ("ksi", 1e3 * PSI, PRESSURE),
    ("at", TECHNICAL_ATMOSPHERE, PRESSURE),
    ("atm", ATMOSPHERE, PRESSURE),
    ("Torr", ATMOSPHERE / 760.0, PRESSURE),
    ("mmHg", 133.322_387_415, PRESSURE),
    ("inHg", 3_386.388_640_341, PRESSURE),
    ("mmH2O", GRAVITY, PRESSURE),
    ("PS", 75.0 * GRAVITY, POWER),
    ("Nm", 1.0, ENERGY),
    ("kNm", 1e3, ENERGY),
    ("Nmm", 1e-3, ENERGY),
    ("Pas", 1.0, VISCOSITY),
    ("mPas", 1e-3, VISCOSITY),
];

const PREFIXES: [(&str, f64); 10] = [
    ("da", 10.0),
    ("h", 1e2),
    ("k", 1e3),
    ("M", 1e6),
    ("G", 1e9),
    ("d", 0.1),
    ("c", 1e-2),
    ("m", 1e-3),
    ("u", 1e-6),
    ("n", 1e-9),
];

/// Names that are no unit of one size, and what to write for them.
const TOLD: [(&str, &str); 24] = [
    ("mPa", "1 mPa is 0.001 Pa, and 1 MPa is 1e6 Pa; write the one that is meant in Pa or MPa"),
    ("hp", "a horsepower is 745.7 W (mechanical) or 735.5 W (metric, PS); write W or kW"),
    ("HP", "a horsepower is 745.7 W (mechanical) or 735.5 W (metric, PS); write W or kW"),
    ("bhp", "a brake horsepower is 745.7 W; write W or kW"),
    ("gpm", "a gallon a minute is 3.785 l/min (US) or 4.546 l/min (imperial); write l/min"),
    ("GPM", "a gallon a minute is 3.785 l/min (US) or 4.546 l/min (imperial); write l/min"),
    ("cfm", "a cubic foot a minute is 28.32 l/min; write l/min"),
    ("ton", "a ton is 1000 kg (metric), 907.2 kg (US) or 1016 kg (imperial); its weight is 9.807, 8.896 or 9.964 kN"),
    ("tons", "a ton is 1000 kg (metric), 907.2 kg (US) or 1016 kg (imperial); its weight is 9.807, 8.896 or 9.964 kN"),
    ("SUS", "Saybolt seconds are no multiple of a viscosity; convert them by ASTM D2161 and write mm2/s"),
    ("SSU", "Saybolt seconds are no multiple of a viscosity; convert them by ASTM D2161 and write mm2/s"),
    ("E", "degrees Engler are no multiple of a viscosity; convert them by a table and write mm2/s"),
    ("barg", "the pressures of a scene count from that of the surroundings, as barg does; write bar"),
    ("psig", "the pressures of a scene count from that of the surroundings, as psig does; write psi"),
    ("bara", "the pressures of a scene count from that of the surroundings; subtract it (1.01325 bar) and write bar"),
    ("psia", "the pressures of a scene count from that of the surroundings; subtract it (14.696 psi) and write psi"),
    ("ata", "the pressures of a scene count from that of the surroundings; subtract it and write at (98066.5 Pa)"),
    ("atu", "1 atu is 1 at above the surroundings; write at (98066.5 Pa)"),
    ("mph", "a mile an hour is 0.44704 m/s; write m/s or km/h"),
    ("kn", "a knot is 0.5144 m/s, and kN is a force; write the one that is meant"),
    ("kt", "a knot is 0.5144 m/s; write m/s or km/h"),
    ("yd", "a yard is 0.9144 m; write m"),
    ("BTU/h", "1 BTU/h is 0.29307 W; write W"),
    ("gr", "gr is a grain (64.8 mg) or a gram; write g"),
];

/// What to write for a name that is no unit of one size.
pub(super) fn told(unit: &str) -> Option<&'static str> {
    TOLD.iter().find(|(known, _)| *known == unit).map(|(_, words)| *words)
}

/// All symbols of the kind of a unit, with the prefixes that they may have; none of a text that is no unit.
pub(super) fn alike(unit: &str) -> Vec<String> {
    let Some(own) = composed(unit) else { return Vec::new() };
    let is_alike = |(_, _, powers): &&(&str, f64, [i32; 5])| *powers == own.powers;
    let plain = PLAIN.iter().chain(&PREFIXED).filter(is_alike).map(|(name, ..)| (*name).to_owned());
    let with_prefixes = PREFIXED
        .iter()
        .filter(is_alike)
        .flat_map(|(name, ..)| PREFIXES.iter().map(move |(prefix, _)| format!("{prefix}{name}")));
    plain.chain(with_prefixes).filter(|name| told(name).is_none()).collect()
}

/// The unit that a text in canonical spelling is composed to; `None` where a symbol is not known.
pub(super) fn composed(unit: &str) -> Option<Composed> {
    let mut whole = Composed { size: 1.0, powers: [0; 5] };
    for (place, part) in unit.split('/').enumerate() {
        let factors = part.strip_prefix('(').and_then(|part| part.strip_suffix(')')).unwrap_or(part);
        if factors == "1" && place == 0 {
            continue;
        }
        for factor in factors.split('.') {
            let letters = factor.trim_end_matches(|c: char| c.is_ascii_digit() || c == '-');
            let power: i32 = match &factor[letters.len()..] {
                "" => 1,
                digits => digits.parse().ok().filter(|power| (-4..=4).contains(power))?,
            };
            // "mmH2O" has a digit of its own.
            let (symbol, power) = symbol(factor).map(|symbol| (symbol, 1)).or(Some((symbol(letters)?, power)))?;
            let power = if place == 0 { power } else { -power };
            whole.size *= symbol.size.powi(power);
            (0..5).for_each(|k| whole.powers[k] += power * symbol.powers[k]);
        }
    }
    Some(whole)
}

/// A symbol with its prefix, if it has one.
fn symbol(letters: &str) -> Option<Composed> {
    let of = |table: &[(&str, f64, [i32; 5])], name: &str| {
        let found = table.iter().find(|(known, ..)| *known == name);
        found.map(|&(_, size, powers)| Composed { size, powers })
    };
    let prefixed = |&(prefix, factor): &(&str, f64)| {
        let Composed { size, powers } = of(&PREFIXED, letters.strip_prefix(prefix)?)?;
        let size = factor * size;
        Some(Composed { size, powers })
    };
    of(&PLAIN, letters).or_else(|| of(&PREFIXED, letters)).or_else(|| PREFIXES.iter().find_map(prefixed))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::Dimension;

    #[test]
    fn listed_units_are_composed_to_their_own_size() {
        let has_no_symbol = |name: &str| ["%", "ppm", "C", "degC", "F", "degF", "RPM", "1/min"].contains(&name);
        for dimension in Dimension::all() {
            let powers = dimension.units().iter().find_map(|(name, _)| composed(name)).map(|unit| unit.powers);
            for (name, size) in dimension.units().iter().filter(|(name, _)| !has_no_symbol(name)) {
                let unit = composed(name).unwrap_or_else(|| panic!("{name}"));
                assert!((unit.size / size - 1.0).abs() < 1e-14, "{name}: {} {size}", unit.size);
                assert_eq!(Some(unit.powers), powers, "{name}");
            }
        }
    }
}
