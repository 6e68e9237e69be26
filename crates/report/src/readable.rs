//! Units that people read.

use oilwedge_study::quantities::Unit;
use oilwedge_study::symbol::Symbol;

/// The units in which people read a quantity, from small to large, with their size in its own unit. Pressures have one,
/// that of all messages, so that no two numbers of a run are in different units of pressure.
fn readable_units(unit: Unit) -> &'static [(&'static str, f64)] {
    match unit {
        Unit::One => &[("", 1.0)],
        Unit::Degree => &[("deg", 1.0)],
        Unit::Radian => &[("mrad", 1e-3), ("rad", 1.0)],
        Unit::Celsius => &[("degC", 1.0)],
        Unit::Pascal => &[("bar", 1e5)],
        Unit::PascalOfStress => &[("MPa", 1e6)],
        Unit::PascalSecond => &[("mPa.s", 1e-3), ("Pa.s", 1.0)],
        Unit::Metre => &[("um", 1e-6), ("mm", 1e-3), ("m", 1.0)],
        Unit::CubicMetrePerSecond => &[("ml/s", 1e-6), ("l/s", 1e-3)],
        Unit::Newton => &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)],
        Unit::NewtonMetre => &[("mN.m", 1e-3), ("N.m", 1.0), ("kN.m", 1e3)],
        Unit::Watt => &[("mW", 1e-3), ("W", 1.0), ("kW", 1e3)],
        Unit::Kilogram => &[("kg", 1.0), ("t", 1e3)],
        Unit::NewtonPerMetre => &[("N/m", 1.0), ("kN/m", 1e3), ("MN/m", 1e6)],
        Unit::NewtonPerRadian => &[("N/rad", 1.0), ("kN/rad", 1e3), ("MN/rad", 1e6)],
        Unit::NewtonMetrePerRadian => &[("N.m/rad", 1.0), ("kN.m/rad", 1e3), ("MN.m/rad", 1e6)],
        Unit::NewtonSecondPerMetre => &[("N.s/m", 1.0), ("kN.s/m", 1e3), ("MN.s/m", 1e6)],
        Unit::NewtonSecondPerRadian => &[("N.s/rad", 1.0), ("kN.s/rad", 1e3)],
        Unit::NewtonMetreSecondPerRadian => &[("N.m.s/rad", 1.0), ("kN.m.s/rad", 1e3)],
    }
}

/// The unit in which to show a value, and its size: the largest in which the value is not below one.
pub fn readable_unit(value: f64, unit: Unit) -> (&'static str, f64) {
    let units = readable_units(unit);
    let fitting = units.iter().rev().find(|(_, size)| value.abs() >= *size);
    let own = || units.iter().find(|(_, size)| *size == 1.0);
    let chosen = match value == 0.0 {
        true => own(),
        false => fitting,
    };
    chosen.or(units.first()).copied().unwrap_or((unit.name(), 1.0))
}

/// [`readable_unit`] of a unit by its name in results; a unit that results do not have stays as it is.
pub fn readable_unit_of(value: f64, unit: &str) -> (&str, f64) {
    match Unit::named(unit) {
        Some(unit) => readable_unit(value, unit),
        None => (unit, 1.0),
    }
}

/// The name of a quantity or key in words.
pub(crate) fn plain_words(name: &str) -> String {
    name.replace(['_', '.'], " ")
}

/// Digits as powers.
const SUPERSCRIPTS: [char; 10] =
    ['\u{2070}', '\u{b9}', '\u{b2}', '\u{b3}', '\u{2074}', '\u{2075}', '\u{2076}', '\u{2077}', '\u{2078}', '\u{2079}'];
/// A number with a true minus, and a power of ten in place of an exponent.
pub(crate) fn with_minus(number: String) -> String {
    let (mantissa, exponent) = number.split_once('e').unwrap_or((&number, ""));
    let power = |letter: char| match letter {
        '-' => '\u{207b}',
        digit => digit.to_digit(10).map_or(digit, |digit| SUPERSCRIPTS[digit as usize]),
    };
    let power: String = exponent.chars().map(power).collect();
    let ten = if power.is_empty() { "" } else { "\u{b7}10" };
    format!("{}{ten}{power}", mantissa.replace('-', "\u{2212}"))
}

/// A unit as it is printed, with its true letters; nothing for a pure number.
pub fn printed_unit(unit: &str) -> String {
    match unit {
        "1" => String::new(),
        "deg" => "\u{b0}".to_owned(),
        "degC" => "\u{b0}C".to_owned(),
        "um" => "\u{b5}m".to_owned(),
        "m3/s" => "m\u{b3}/s".to_owned(),
        unit => unit.replace('.', "\u{b7}"),
    }
}

/// Names of Greek letters in symbols.
const GREEK: [(&str, &str); 14] = [
    ("alpha", "\u{3b1}"),
    ("beta", "\u{3b2}"),
    ("delta", "\u{3b4}"),
    ("Delta", "\u{394}"),
    ("eps", "\u{3b5}"),
    ("eta", "\u{3b7}"),
    ("mu", "\u{3bc}"),
    ("nu", "\u{3bd}"),
    ("omega", "\u{3c9}"),
    ("phi", "\u{3c6}"),
    ("rho", "\u{3c1}"),
    ("sigma", "\u{3c3}"),
    ("tau", "\u{3c4}"),
    ("theta", "\u{3b8}"),
];

/// A symbol as the marks of a label: its letter italic, its index lowered.
pub fn printed_symbol(symbol: &str) -> String {
    if symbol.contains([' ', '(']) {
        return symbol.replace("Int ", "\u{222b} ");
    }
    let parts: Vec<_> = symbol.split('/').map(|part| printed_part(Symbol::of(part))).collect();
    parts.join("/")
}

fn printed_part(symbol: Symbol<'_>) -> String {
    let greek = |text: &str| {
        let known = GREEK.iter().find(|(name, _)| *name == text);
        known.map_or(text.to_owned(), |(_, letter)| (*letter).to_owned())
    };
    let index = match symbol.index {
        "" => String::new(),
        index => format!("_{{{}}}", greek(index)),
    };
    let mark = symbol.mark.replace('*', "\u{2217}");
    format!("*{}*{index}{mark}", greek(symbol.letter))
}

/// The marks of a label `name symbol, unit`.
pub fn axis_label(name: &str, symbol: &str, unit: &str) -> String {
    let unit = printed_unit(unit);
    let unit = if unit.is_empty() { unit } else { format!(", {unit}") };
    format!("{name} {}{unit}", printed_symbol(symbol)).trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_suits_the_size() {
        assert_eq!(readable_unit(12_910.0, Unit::Newton), ("kN", 1e3));
        assert_eq!(readable_unit(15e-6, Unit::Metre), ("um", 1e-6));
        assert_eq!(readable_unit(1e-9, Unit::Metre), ("um", 1e-6));
        assert_eq!(readable_unit(0.0, Unit::Metre), ("m", 1.0));
        assert_eq!(readable_unit(0.0, Unit::CubicMetrePerSecond), ("ml/s", 1e-6));
        assert_eq!(readable_unit(49.0, Unit::Degree), ("deg", 1.0));
        assert_eq!(readable_unit(2.0, Unit::One), ("", 1.0));
    }

    #[test]
    fn all_pressures_are_in_one_unit() {
        for pressure in [0.0, 3.0, -2.5e6, 4e11] {
            assert_eq!(readable_unit(pressure, Unit::Pascal), ("bar", 1e5));
        }
        assert_eq!(readable_unit(4e8, Unit::PascalOfStress), ("MPa", 1e6));
    }

    #[test]
    fn symbols_and_units_have_their_letters() {
        assert_eq!(printed_symbol("phi_W"), "*\u{3c6}*_{W}");
        assert_eq!(printed_symbol("Q_s*"), "*Q*_{s}\u{2217}");
        assert_eq!(printed_symbol("mu0"), "*\u{3bc}*_{0}");
        assert_eq!(printed_symbol("W_c/P_o"), "*W*_{c}/*P*_{o}");
        assert_eq!(axis_label("friction power", "P", "W"), "friction power *P*, W");
        assert_eq!(axis_label("eccentricity", "eps", ""), "eccentricity *\u{3b5}*");
        assert_eq!(printed_unit("mPa.s"), "mPa\u{b7}s");
    }
}
