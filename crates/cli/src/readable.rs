//! Numbers for people: a unit that suits the size, and six significant digits.

/// For each SI unit of a result, the units people read, from small to large, with their size in the SI unit.
const READABLE: [(&str, &[(&str, f64)]); 7] = [
    ("Pa", &[("Pa", 1.0), ("kPa", 1e3), ("MPa", 1e6), ("GPa", 1e9)]),
    ("Pa.s", &[("mPa.s", 1e-3), ("Pa.s", 1.0)]),
    ("m", &[("um", 1e-6), ("mm", 1e-3), ("m", 1.0)]),
    ("m3/s", &[("ml/s", 1e-6), ("l/s", 1e-3)]),
    ("N", &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)]),
    ("N.m", &[("mN.m", 1e-3), ("N.m", 1.0), ("kN.m", 1e3)]),
    ("W", &[("mW", 1e-3), ("W", 1.0), ("kW", 1e3)]),
];

/// The unit in which to show a value, and its size: the largest in which the value is not below one.
pub(crate) fn readable_unit(value: f64, unit: &str) -> (&str, f64) {
    let Some((_, units)) = READABLE.iter().find(|(si, _)| *si == unit) else {
        return (if unit == "1" { "" } else { unit }, 1.0);
    };
    let fitting = units.iter().rev().find(|(_, size)| value.abs() >= *size);
    let own = || units.iter().find(|(name, _)| *name == unit);
    let chosen = if value == 0.0 {
        own().or(units.first())
    } else {
        fitting.or(units.first())
    };
    chosen.copied().unwrap_or((unit, 1.0))
}

/// A value with this many significant digits, as a decimal where that is short and with an exponent elsewhere.
pub(crate) fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let decimals = digits.saturating_sub(1);
    let scientific = format!("{value:.decimals$e}");
    let exponent: i32 = scientific
        .rsplit('e')
        .next()
        .and_then(|text| text.parse().ok())
        .unwrap_or(0);
    match exponent {
        -4..=8 => {
            let decimals = (decimals as i32 - exponent).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_unit_suits_the_size() {
        assert_eq!(readable_unit(12_910.0, "N"), ("kN", 1e3));
        assert_eq!(readable_unit(-2.5e6, "Pa"), ("MPa", 1e6));
        assert_eq!(readable_unit(15e-6, "m"), ("um", 1e-6));
        assert_eq!(readable_unit(1e-9, "m"), ("um", 1e-6));
        assert_eq!(readable_unit(0.0, "m"), ("m", 1.0));
        assert_eq!(readable_unit(0.0, "m3/s"), ("ml/s", 1e-6));
        assert_eq!(readable_unit(49.0, "deg"), ("deg", 1.0));
        assert_eq!(readable_unit(2.0, "1"), ("", 1.0));
    }

    #[test]
    fn digits_are_significant() {
        assert_eq!(significant(12.91, 6), "12.9100");
        assert_eq!(significant(-0.001_234_567_8, 6), "-0.00123457");
        assert_eq!(significant(9.999_999_9, 6), "10.0000");
        assert_eq!(significant(123_456_789.0, 6), "123456789");
        assert_eq!(significant(1.5e-12, 2), "1.5e-12");
        assert_eq!(significant(0.0, 6), "0");
    }
}
