//! The fields of a film: their symbols, units and sentences, as pictures name them.

/// How a field is interpolated between its values.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interpolation {
    /// By the quadratic of each triangle.
    Quadratic,
    /// Linearly on the four parts of each triangle, as the scheme has it whose oil is conserved: a quadratic would overshoot where the film breaks.
    Linear,
    /// One value for each triangle.
    Constant,
}

/// One field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldRow {
    /// Name in files.
    pub name: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// Symbol.
    pub symbol: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// What it is, in a sentence.
    pub what: &'static str,
    /// How it is interpolated.
    pub interpolation: Interpolation,
}

/// Pressure.
pub static PRESSURE: FieldRow = FieldRow {
    name: "pressure",
    label: "pressure",
    symbol: "p",
    unit: "Pa",
    what: "gauge pressure of the oil, nowhere below that of a cavity",
    interpolation: Interpolation::Quadratic,
};
/// Film thickness.
pub static FILM_THICKNESS: FieldRow = FieldRow {
    name: "film_thickness",
    label: "film thickness",
    symbol: "h",
    unit: "m",
    what: "gap between journal and liner",
    interpolation: Interpolation::Quadratic,
};
/// Film fraction.
pub static FILM_FRACTION: FieldRow = FieldRow {
    name: "film_fraction",
    label: "film fraction",
    symbol: "theta",
    unit: "1",
    what: "share of the gap that oil fills; one where the film is full",
    interpolation: Interpolation::Linear,
};
/// Viscosity.
pub static VISCOSITY: FieldRow = FieldRow {
    name: "viscosity",
    label: "viscosity",
    symbol: "mu",
    unit: "Pa.s",
    what: "dynamic viscosity at the local pressure",
    interpolation: Interpolation::Quadratic,
};
/// Error indicator.
pub static ERROR_INDICATOR: FieldRow = FieldRow {
    name: "error_indicator",
    label: "error indicator",
    symbol: "eta",
    unit: "1",
    what: "contribution of each triangle to the error",
    interpolation: Interpolation::Constant,
};

/// The fields that are drawn, in the order of pictures.
pub static FIELDS: [&FieldRow; 5] = [&PRESSURE, &FILM_THICKNESS, &FILM_FRACTION, &VISCOSITY, &ERROR_INDICATOR];

/// The row of a field.
pub fn field(name: &str) -> Option<&'static FieldRow> {
    FIELDS.into_iter().find(|row| row.name == name)
}
