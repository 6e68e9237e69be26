//! Quantities as people write them (`"25 mm"`, `"3000 rpm"`) become SI numbers here, once.
//!
//! Inside the program everything is SI: m, rad, Pa, Pa.s, rad/s, 1/Pa, N, m/s, kg, m2, K. A quantity is a number and a
//! unit, with or without a space; `µ` and `u`, `Pa.s`, `Pa s` and `Pa·s`, `mm²` and `mm2` mean the same. Letter case
//! matters, since mPa is not MPa. Turns are counted in `rpm` or `Hz`; `1/s` is refused for a speed, for it may be a
//! radian or a turn a second. Other units are composed of symbols (`daN`, `kgf/cm2`). Temperatures count from the
//! absolute zero; only a temperature has units with a zero of their own (`C`, `F`), a difference is in `K`.

mod composed;

use self::composed::{composed, told};
pub use crate::dimension::{Dimension, ZERO_CELSIUS};
use crate::spelling::nearest;

/// Why a text is not the quantity that was asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitError {
    /// The text, or the unit in it, as written.
    pub text: String,
    /// What was asked for.
    pub expected: Dimension,
    /// What is wrong.
    pub fault: UnitFault,
}

/// What is wrong with a text that is not the quantity that was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitFault {
    /// The text does not begin with a number.
    NotANumber,
    /// The number is written with a decimal comma.
    DecimalComma,
    /// The number has no unit.
    NoUnit,
    /// The unit measures something else.
    OtherDimension(Dimension),
    /// No such unit is known; the known one that looks most like it.
    UnknownUnit(Option<&'static str>),
    /// The unit has no one size; what to write for it.
    Told(&'static str),
    /// An angular speed in `1/s`: radians in SI, turns in ISO 7902.
    RadiansOrTurns,
    /// The quantity is larger or smaller than any of its kind.
    OutOfRange,
}

impl std::error::Error for UnitError {}

impl std::fmt::Display for UnitError {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let (text, wanted) = (&self.text, self.expected.name());
        match self.fault {
            UnitFault::NotANumber => write!(formatter, "\"{text}\" does not begin with a number; {wanted} is wanted"),
            UnitFault::DecimalComma => write!(formatter, "\"{text}\" has a decimal comma"),
            UnitFault::NoUnit => write!(formatter, "\"{text}\" has no unit; {wanted} is wanted"),
            UnitFault::OtherDimension(found) => {
                let found = bare(found.name());
                write!(formatter, "\"{text}\" is a unit of {found}, but {wanted} is wanted")
            }
            UnitFault::UnknownUnit(_) | UnitFault::Told(_) => {
                write!(formatter, "\"{text}\" is not a unit of {}", bare(wanted))
            }
            UnitFault::RadiansOrTurns => {
                write!(formatter, "\"{text}\" may mean radians or turns in a second, which differ by 2 pi")
            }
            UnitFault::OutOfRange => {
                let ([least, most], (unit, _)) = (self.expected.range(), self.expected.units()[0]);
                write!(
                    formatter,
                    "\"{text}\" is out of range: {wanted} is zero, or from {least:.0e} to {most:.0e} {unit}"
                )
            }
        }
    }
}

/// A name without its article.
fn bare(name: &str) -> &str {
    name.trim_start_matches("an ").trim_start_matches("a ")
}

impl UnitError {
    /// What to write instead; `example` is what one would write at this place.
    pub fn help(&self, example: &str) -> String {
        let units = self.expected.unit_names();
        match self.fault {
            UnitFault::NotANumber | UnitFault::NoUnit => {
                format!("write a number and a unit, for example \"{example}\"; units: {units}")
            }
            UnitFault::DecimalComma => {
                format!("write a decimal point and no thousands separators, for example \"{example}\"")
            }
            UnitFault::UnknownUnit(Some(name)) => format!("did you mean \"{name}\"? Units: {units}"),
            UnitFault::OtherDimension(_) | UnitFault::UnknownUnit(None) => {
                format!("write for example \"{example}\"; units: {units}")
            }
            UnitFault::RadiansOrTurns => {
                "write rad/s, or Hz for turns in a second (ISO 7902 writes these in 1/s)".to_owned()
            }
            UnitFault::Told(words) => words.to_owned(),
            UnitFault::OutOfRange => format!("check the exponent and the unit, and write for example \"{example}\""),
        }
    }
}

/// Names of at most so many letters have too many neighbours of another size: `ft`, `in`, `nm`.
const LONG: usize = 3;

/// The quantity `text` of the kind `expected`, in SI. The value is finite.
///
/// # Errors
/// [`UnitError`] where the text is no number and unit of this kind.
pub fn parse(text: &str, expected: Dimension) -> Result<f64, UnitError> {
    let trimmed = text.trim();
    let fail = |fault| UnitError { text: trimmed.to_owned(), expected, fault };
    let (number, rest) = trimmed.split_at(number_length(trimmed));
    let Ok(number) = number.parse::<f64>() else {
        return Err(fail(UnitFault::NotANumber));
    };
    let unit = rest.trim();
    if unit.starts_with(',') && unit[1..].starts_with(|c: char| c.is_ascii_digit()) {
        return Err(fail(UnitFault::DecimalComma));
    }
    if unit.is_empty() {
        return Err(fail(UnitFault::NoUnit));
    }
    let value = number * unit_size(unit, expected)? + expected.zero(&canonical(unit));
    match expected.holds(value) {
        true => Ok(value),
        false => Err(fail(UnitFault::OutOfRange)),
    }
}

/// The number and the unit of a quantity as they are written; `None` where the text does not begin with a finite number
/// or has no unit behind it.
pub(crate) fn split(text: &str) -> Option<(f64, &str)> {
    let trimmed = text.trim();
    let (number, unit) = trimmed.split_at(number_length(trimmed));
    let number: f64 = number.parse().ok()?;
    let unit = unit.trim();
    (number.is_finite() && !unit.is_empty()).then_some((number, unit))
}

/// The size of one `unit` of the kind `expected` in SI: `unit_size("mm", Dimension::Length)` is 1e-3.
///
/// # Errors
/// [`UnitError`] where no such unit of this kind is known; it names the nearest one.
pub fn unit_size(unit: &str, expected: Dimension) -> Result<f64, UnitError> {
    let canonical = canonical(unit);
    let find = |dimension: Dimension| dimension.units().iter().find(|(name, _)| *name == canonical);
    if let Some((_, size)) = find(expected) {
        return Ok(*size);
    }
    let is_bare_rate = expected == Dimension::Speed && canonical == "1/s";
    let told = told(&canonical);
    let own = composed(&canonical).filter(|_| told.is_none());
    let powers =
        |dimension: Dimension| dimension.units().iter().find_map(|(name, _)| composed(name)).map(|unit| unit.powers);
    if let Some(own) = own.filter(|own| powers(expected) == Some(own.powers)) {
        return Ok(own.size);
    }
    let is_of = |other: &Dimension| find(*other).is_some() || own.is_some_and(|own| powers(*other) == Some(own.powers));
    let fault = match (told, Dimension::all().find(is_of)) {
        _ if is_bare_rate => UnitFault::RadiansOrTurns,
        (Some(words), _) => UnitFault::Told(words),
        (None, Some(found)) => UnitFault::OtherDimension(found),
        (None, None) => UnitFault::UnknownUnit(alike(&canonical, expected).filter(|_| own.is_none())),
    };
    Err(UnitError { text: unit.to_owned(), expected, fault })
}

/// All symbols of the kind of a unit, with the prefixes that they may have: `N`, `kN`, `kgf` of `N`. None of a text
/// that is no unit.
pub fn symbols_like(unit: &str) -> Vec<String> {
    composed::alike(unit)
}

/// Whether a unit of this kind, in its own spelling, is composed of symbols, so that others of their kinds may stand
/// for them.
pub fn is_composed(unit: &str, expected: Dimension) -> bool {
    let mut others = expected.units().iter().filter_map(|(name, _)| composed(name));
    let powers = others.next().map(|unit| unit.powers);
    composed(unit).is_some_and(|unit| Some(unit.powers) == powers)
}

/// The unit of this kind that is meant by a misspelt one. A short word is meant only where it differs by letter case or
/// by repeated letters, and not where case tells two units apart: `mN` and `MN`.
fn alike(unit: &str, expected: Dimension) -> Option<&'static str> {
    let names = || expected.units().iter().map(|(name, _)| *name);
    let plain = |name: &str| {
        let mut letters: Vec<char> = name.to_lowercase().chars().collect();
        letters.dedup();
        letters
    };
    let is_alike = |name: &&str| unit.chars().count() > LONG || plain(name) == plain(unit);
    let near = nearest(unit, names().filter(is_alike))?;
    let alike_by_case = names().filter(|name| name.eq_ignore_ascii_case(near)).count();
    (alike_by_case == 1 || near.eq_ignore_ascii_case("rpm")).then_some(near)
}

/// How many bytes of the front of `text` make a decimal number: sign, digits, point, exponent.
fn number_length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits = |from: usize| bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    end += digits(end);
    if bytes.get(end) == Some(&b'.') {
        end += 1 + digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    end
}

/// One spelling for each unit: `µ` is `u`, products have a point, powers are plain digits, `°` is `deg`.
fn canonical(unit: &str) -> String {
    let mut plain = String::with_capacity(unit.len());
    for letter in unit.chars() {
        match letter {
            '\u{b5}' | '\u{3bc}' => plain.push('u'),
            '*' | '.' | '\u{b7}' | '\u{22c5}' => plain.push(' '),
            '\u{b2}' => plain.push('2'),
            '\u{b3}' => plain.push('3'),
            '\u{b9}' => plain.push('1'),
            '\u{207b}' => plain.push('-'),
            '\u{b0}' => plain.push_str("deg"),
            '^' => {}
            other => plain.push(other),
        }
    }
    let joined = plain.split_whitespace().collect::<Vec<_>>().join(".").replace("./", "/").replace("/.", "/");
    match joined.strip_suffix("-1") {
        Some(base) if base.contains('.') => {
            let (front, last) = base.rsplit_once('.').unwrap_or(("1", base));
            format!("{front}/{last}")
        }
        Some(base) => format!("1/{base}"),
        None => joined,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Dimension::*;
    use std::f64::consts::PI;

    fn close(text: &str, dimension: Dimension, value: f64) {
        let got = parse(text, dimension).unwrap_or_else(|error| panic!("{text}: {error}"));
        assert!((got - value).abs() <= 1e-14 * value.abs(), "{text}: {got} is not {value}");
    }

    #[test]
    fn quantities_become_si() {
        close("25 mm", Length, 0.025);
        close("37.5um", Length, 37.5e-6);
        close("37.5 \u{b5}m", Length, 37.5e-6);
        close("37.5 \u{3bc}m", Length, 37.5e-6);
        close("1 in", Length, 0.0254);
        close("40 deg", Angle, 40.0 * PI / 180.0);
        close("-40\u{b0}", Angle, -40.0 * PI / 180.0);
        close("0.98 bar", Pressure, 98_000.0);
        close("1 atm", Pressure, 101_325.0);
        close("1 psi", Pressure, 6_894.757_293_168_361);
        close("40 mPa.s", Viscosity, 0.04);
        close("40 cP", Viscosity, 0.04);
        close("0.4 Pa s", Viscosity, 0.4);
        close("0.4 Pa\u{b7}s", Viscosity, 0.4);
        close("10 rad/s", Speed, 10.0);
        close("10 rad s^-1", Speed, 10.0);
        close("3000 rpm", Speed, 100.0 * PI);
        close("50 Hz", Speed, 100.0 * PI);
        close("+2.5e-8 1/Pa", InversePressure, 2.5e-8);
        close("2.5e-8 Pa^-1", InversePressure, 2.5e-8);
        close("2.5e-2 mm2/N", InversePressure, 2.5e-8);
        close("2.5e-2 mm\u{b2} / N", InversePressure, 2.5e-8);
        close("25 1/GPa", InversePressure, 2.5e-8);
        close("5 kN", Force, 5_000.0);
        close("5 MN", Force, 5e6);
        close("5 mN", Force, 5e-3);
        close("-1 lbf", Force, -4.448_221_615_260_5);
        close("2 m/s", Velocity, 2.0);
        close("2 mm/s", Velocity, 2e-3);
        close("-2 mm s^-1", Velocity, -2e-3);
        close("30 \u{b5}m/s", Velocity, 30e-6);
        close("36 km/h", Velocity, 10.0);
        close("1 in/s", Velocity, 0.0254);
        close("405 g", Mass, 0.405);
        close("1 lb", Mass, 0.453_592_37);
        close("1.32 cm\u{b2}", Area, 1.32e-4);
        close("0.1 %", Ratio, 1e-3);
        close("50 ppm", Ratio, 5e-5);
        close("80 C", Temperature, 353.15);
        close("80 \u{b0}C", Temperature, 353.15);
        close("-40degC", Temperature, 233.15);
        close("353.15 K", Temperature, 353.15);
        close("212 F", Temperature, 373.15);
        close("1000 K", TemperatureDifference, 1000.0);
        close("68.8e-5 1/K", InverseTemperature, 68.8e-5);
        close("68.8e-5 K^-1", InverseTemperature, 68.8e-5);
        close("14.3 mm\u{b2}/s", KinematicViscosity, 14.3e-6);
        close("14.3 cSt", KinematicViscosity, 14.3e-6);
        close("0.885 kg/l", Density, 885.0);
        close("1.8 MJ/(m\u{b3} K)", HeatCapacity, 1.8e6);
        close("1800 kJ/(m3 K)", HeatCapacity, 1.8e6);
        close("17 W/(m2 K)", HeatTransfer, 17.0);
        close("5 W/K", Conductance, 5.0);
        close("0.885 g / cm3", Density, 885.0);
    }

    #[test]
    fn composed_units_become_si() {
        close("16.7 rps", Speed, 16.7 * 2.0 * PI);
        close("1000 rev/min", Speed, 100.0 * PI / 3.0);
        close("1 kHz", Speed, 2e3 * PI);
        close("1000 kp", Force, 9_806.65);
        close("1 daN", Force, 10.0);
        close("1 kip", Force, 4_448.221_615_260_5);
        close("1 kgf/cm2", Pressure, 98_066.5);
        close("1 at", Pressure, 98_066.5);
        close("10 ksi", Pressure, 68_947_572.931_683_61);
        close("1 kbar", Pressure, 1e8);
        close("1 thou", Length, 25.4e-6);
        close("1 dm", Length, 0.1);
        close("1 lbf s/in\u{b2}", Viscosity, 6_894.757_293_168_361);
        close("1 ureyn", Viscosity, 6_894.757_293_168_361e-6);
        close("6 m3/h", VolumeFlow, 6.0 / 3600.0);
        close("1 L/min", VolumeFlow, 1e-3 / 60.0);
        close("1 PS", Power, 735.498_75);
        close("1 N/cm", Stiffness, 100.0);
        close("1 Nm", Torque, 1.0);
    }

    /// No hint changes the quantity: what looks like a unit but is another one is told with its conversion, or with the
    /// list of units.
    #[test]
    fn hints_keep_the_quantity() {
        for (text, dimension, words) in [
            ("1 hp", Power, "745.7 W"),
            ("1 gpm", VolumeFlow, "3.785 l/min"),
            ("1 ton", Mass, "907.2 kg"),
            ("1 mPa", Pressure, "1 mPa is 0.001 Pa"),
            ("100 SUS", KinematicViscosity, "ASTM D2161"),
            ("1 psia", Pressure, "subtract"),
            ("1 mn", Force, "for example \"5 kN\""),
            ("1 kq", Mass, "for example \"0.7 kg\""),
        ] {
            let error = parse(text, dimension).expect_err(text);
            let help = error.help(dimension.example());
            assert!(help.contains(words) && !help.contains("did you mean"), "{text}: {help}");
        }
        let error = parse("50 cSt", Viscosity).expect_err("another kind");
        assert_eq!(error.fault, UnitFault::OtherDimension(KinematicViscosity));
    }

    #[test]
    fn every_unit_is_read_by_its_own_name() {
        for dimension in Dimension::all() {
            assert!(parse(dimension.example(), dimension).is_ok());
            for (name, size) in dimension.units() {
                assert_eq!(unit_size(name, dimension), Ok(*size), "{name}");
            }
        }
    }

    #[test]
    fn the_wrong_texts_are_refused_with_a_way_out() {
        let refused = |text: &str, dimension: Dimension| parse(text, dimension).expect_err(text);
        assert!(matches!(refused("25", Length).fault, UnitFault::NoUnit));
        assert!(matches!(refused("0.001", Ratio).fault, UnitFault::NoUnit));
        for text in ["", "mm", "nan mm", "inf mm", "- 5 mm", "- mm", ". mm"] {
            assert!(matches!(refused(text, Length).fault, UnitFault::NotANumber), "{text}");
        }
        assert!(matches!(refused("37,5 um", Length).fault, UnitFault::DecimalComma));
        for text in ["1e400 mm", "1e305 km", "1e-305 m", "-1e-300 um"] {
            assert_eq!(refused(text, Length).fault, UnitFault::OutOfRange);
        }
        assert_eq!(
            refused("1e305 kN", Force).to_string(),
            "\"1e305 kN\" is out of range: a force is zero, or from 5e-22 to 5e18 N"
        );
        let other = refused("25 mm", Pressure);
        assert_eq!(other.to_string(), "\"mm\" is a unit of length, but a pressure is wanted");
        assert!(other.help("0.98 bar").contains("0.98 bar"));
        let help = |text: &str, dimension: Dimension| refused(text, dimension).help(dimension.example());
        assert!(help("25 mmm", Length).contains("did you mean \"mm\""));
        assert!(help("1 Bar", Pressure).contains("did you mean \"bar\""));
        assert!(help("1 furlong", Length).contains("for example \"25 mm\""));
        assert!(matches!(refused("20 C", TemperatureDifference).fault, UnitFault::OtherDimension(_)));
        assert!(help("80 Celsius", Temperature).contains("\"80 C\""));
        assert!(help("1 mpa", Pressure).contains("did you mean"));
    }
}
