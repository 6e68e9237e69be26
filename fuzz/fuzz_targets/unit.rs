//! Bytes as a kind of quantity and a text: it is refused with a way out, or it is a finite number that is read back
//! from its own digits.

#![no_main]

use libfuzzer_sys::fuzz_target;
use oilwedge_scene::unit::{self, Dimension};

const DIMENSIONS: [Dimension; 9] = [
    Dimension::Length,
    Dimension::Angle,
    Dimension::Pressure,
    Dimension::Viscosity,
    Dimension::Speed,
    Dimension::InversePressure,
    Dimension::Force,
    Dimension::Velocity,
    Dimension::Ratio,
];

// The first byte chooses the kind that is asked for.
fuzz_target!(|bytes: &[u8]| {
    if let Some((kind, rest)) = bytes.split_first()
        && let Ok(text) = std::str::from_utf8(rest)
    {
        let dimension = DIMENSIONS[usize::from(*kind) % DIMENSIONS.len()];
        match unit::parse(text, dimension) {
            Ok(value) => {
                assert!(value.is_finite());
                let (name, size) = dimension.units()[0];
                let again = unit::parse(&format!("{:e} {name}", value / size), dimension);
                let again = again.unwrap_or_else(|error| panic!("{text}: {error}"));
                assert!(
                    (again - value).abs() <= 1e-15 * value.abs(),
                    "{text}: {again} is not {value}"
                );
            }
            Err(error) => {
                assert!(!error.to_string().is_empty());
                assert!(!error.help(dimension.example()).is_empty());
            }
        }
    }
});
