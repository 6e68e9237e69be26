//! Numbers for people: the significant digits that are known.

/// A value with this many significant digits, as a decimal where that is short and with an exponent elsewhere.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return format!("{value}");
    }
    let decimals = digits.saturating_sub(1);
    let scientific = format!("{value:.decimals$e}");
    let exponent = exponent(&scientific);
    match exponent {
        -4..=8 => {
            let decimals = (decimals as i32 - exponent).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => scientific,
    }
}

/// The exponent of ten at the end of a number in scientific form.
fn exponent(scientific: &str) -> i32 {
    let behind = scientific.rsplit('e').next();
    behind.and_then(|text| text.parse().ok()).unwrap_or(0)
}

/// Most digits of a value with a bar.
const MOST_DIGITS: i32 = 7;

/// A value to the place of its bar's second digit, seven digits at most: those that the next finer mesh would keep.
fn supported(value: f64, bar: f64) -> String {
    let place = |number: f64| exponent(&format!("{number:e}"));
    let digits = place(value) - place(bar) + 2;
    significant(value, digits.clamp(1, MOST_DIGITS) as usize)
}

/// A number below this in its smallest unit is zero: 1e-9 N, um, ml/s or deg.
const ROUNDING: f64 = 1e-9;

/// Digits of a value whose error is estimated and not known.
const UNRESOLVED: usize = 2;

/// A value whose error is estimated and not known: its first digits, of which none is sure.
pub fn unresolved(value: f64) -> String {
    quantity_value(value, None, UNRESOLVED)
}

/// A value with the digits that its error bar supports, else with this many.
pub fn quantity_value(value: f64, error: Option<f64>, digits: usize) -> String {
    match error {
        _ if value.abs() < ROUNDING => "0".to_owned(),
        Some(error) if error > 0.0 => supported(value, error),
        _ => significant(value, digits),
    }
}

/// Half the width of a bar, rounded up to two digits; no zero at its end.
pub fn bar(half_width: f64) -> String {
    if half_width == 0.0 || !half_width.is_finite() {
        return format!("{half_width}");
    }
    let place = exponent(&format!("{half_width:e}"));
    // Rounding of the conversion is not rounded up.
    let steps = (half_width / 10f64.powi(place - 1) * (1.0 - 1e-12)).ceil();
    let rounded: f64 = format!("{steps}e{}", place - 1).parse().unwrap_or(half_width);
    match place {
        -4..=8 => format!("{rounded}"),
        _ => format!("{rounded:e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_are_significant() {
        assert_eq!(significant(12.91, 6), "12.9100");
        assert_eq!(significant(-0.001_234_567_8, 6), "-0.00123457");
        assert_eq!(significant(9.999_999_9, 6), "10.0000");
        assert_eq!(significant(123_456_789.0, 6), "123456789");
        assert_eq!(significant(1.5e-12, 2), "1.5e-12");
        assert_eq!(significant(0.0, 6), "0");
    }

    #[test]
    fn a_bar_tells_how_many_digits_a_value_has() {
        assert_eq!(supported(46.23, 3.6), "46.2");
        assert_eq!(supported(12.911_234, 0.001), "12.9112");
        assert_eq!(supported(12.911_234, 0.009_9), "12.9112");
        assert_eq!(supported(12.911_234, 0.012), "12.911");
        assert_eq!(supported(12.911_234, 25.0), "13");
        assert_eq!(supported(12.911_234, 1e-12), "12.91123");
        assert_eq!(supported(-0.003, 0.2), "-0.003");
        assert_eq!(supported(123_456.0, 2e3), "123456");
    }

    #[test]
    fn bars_are_rounded_up() {
        let bars = [0.001, 0.00123, 0.0101, 0.3, 0.999, 12.34, 20.0, 123.4, 2.5e-7, 9.99e-5, 4.2e12].map(bar);
        let wanted = ["0.001", "0.0013", "0.011", "0.3", "1", "13", "20", "130", "2.5e-7", "1e-4", "4.2e12"];
        assert_eq!(bars, wanted);
        assert_eq!(bar(0.0), "0");
    }
}
